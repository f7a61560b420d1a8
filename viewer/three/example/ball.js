// A ball of the atlas's first specimen that turns under one lamp.
//
// ?atlas=ADDRESS of an atlas, or of one version of it; ?specimen=NAME
import { ACESFilmicToneMapping, DirectionalLight, Mesh, PerspectiveCamera, Scene, SphereGeometry, WebGLRenderer } from 'three';
import { layStructure, openAtlas } from 'diffraction-atlas-three';

const asked = new URLSearchParams(location.search);
const renderer = new WebGLRenderer({ antialias: true });
renderer.toneMapping = ACESFilmicToneMapping;
document.body.append(renderer.domElement);

const camera = new PerspectiveCamera(30, 1, 0.1, 10);
camera.position.z = 4.2;
const scene = new Scene();
const lamp = new DirectionalLight('white', 30);
lamp.position.set(1, 1, 2);
scene.add(lamp);

function resize() {
  renderer.setSize(innerWidth, innerHeight);
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
}

try {
  const atlas = await openAtlas(asked.get('atlas') ?? 'atlas');
  const material = await atlas.material(asked.get('specimen') ?? atlas.specimens[0], { lightDiameterDeg: 0.53, lightSamples: 8 });
  const ball = new Mesh(layStructure(new SphereGeometry(1, 128, 64)), material);
  scene.add(ball);
  addEventListener('resize', resize);
  resize();
  renderer.setAnimationLoop((ms) => {
    ball.rotation.y = 2e-4 * ms;
    renderer.render(scene, camera);
  });
} catch (error) {
  document.getElementById('said').textContent = error.message;
}
