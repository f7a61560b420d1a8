// A mesh of the reader's own: glTF or OBJ, dropped on the page. The structure's x axis runs along the texture coordinate u and y
// at a right angle to it, on the side to which v grows.

import { BufferAttribute, BufferGeometry, Group, Mesh, Vector3 } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { OBJLoader } from 'three/examples/jsm/loaders/OBJLoader.js';
import { mergeGeometries, mergeVertices } from 'three/examples/jsm/utils/BufferGeometryUtils.js';
import type { Vec3 } from '../light/samples';
import type { Body } from './body';
import type { View } from './frames';
import { OCCLUSION, occlusion } from './occlusion';
import { SHADOWS, ShadowMaps } from './shadows';
import { tangents } from './tangents';

/** A file that is no mesh to lay the structure on, and what to do about it. */
export class ModelError extends Error {}

const FOV_DEG = 25;
const MARGIN = 1.04;

export async function readModel(file: File): Promise<Body> {
  const obj = /\.obj$/i.test(file.name);
  let group: Group;
  try {
    group = obj ? new OBJLoader().parse(await file.text()) : (await new GLTFLoader().parseAsync(await file.arrayBuffer(), '')).scene;
  } catch (error) {
    throw new ModelError(`${file.name} cannot be read: ${String(error)} A glTF file must hold everything itself (.glb).`);
  }
  return modelBody(joined(group, file.name), !obj);
}

/** All triangles of a scene in the world, with indices. */
function joined(group: Group, name: string): BufferGeometry {
  const parts: BufferGeometry[] = [];
  group.updateMatrixWorld(true);
  group.traverse((node) => {
    if (!(node instanceof Mesh)) return;
    const source = (node.geometry as BufferGeometry).clone().applyMatrix4(node.matrixWorld);
    if (!source.getAttribute('uv')) throw new ModelError(`${name} has no texture coordinates, so the structure has no direction on it. Unwrap the mesh and save it again.`);
    const part = new BufferGeometry();
    part.setIndex(source.index);
    for (const key of ['position', 'normal', 'uv']) {
      const attribute = source.getAttribute(key);
      if (attribute) part.setAttribute(key, new BufferAttribute(Float32Array.from({ length: attribute.count * attribute.itemSize }, (_, i) => attribute.getComponent(Math.floor(i / attribute.itemSize), i % attribute.itemSize)), attribute.itemSize));
    }
    if (!part.getAttribute('normal')) part.computeVertexNormals();
    parts.push(part.index ? part.toNonIndexed() : part);
  });
  if (!parts.length) throw new ModelError(`${name} holds no triangles.`);
  return mergeVertices(mergeGeometries(parts), 1e-7);
}

const VERTEX = `
in vec3 position;
in vec3 normal;
in vec4 tangent;
uniform mat4 u_to_clip;
out vec3 v_place;
out vec3 v_normal;
out vec4 v_tangent;
void main() {
  v_place = position;
  v_normal = normal;
  v_tangent = tangent;
  gl_Position = u_to_clip * vec4(position, 1.0);
}
`;

const FRAGMENT = `
${SHADOWS}
${OCCLUSION}
in vec3 v_normal;
in vec4 v_tangent;
uniform mat4 u_from_clip;
uniform vec2 u_size;
void main() {
  vec3 normal = normalize(v_normal);
  vec2 clip = 2.0 * gl_FragCoord.xy / u_size - 1.0;
  vec4 near = u_from_clip * vec4(clip, -1.0, 1.0);
  vec3 to_viewer = normalize(near.xyz / near.w - v_place);
  shadow_place(v_place, normal);
  vec3 t = v_tangent.xyz - normal * dot(normal, v_tangent.xyz);
  bool has_direction = dot(t, t) > 1e-12;
  t = normalize(has_direction ? t : vec3(1.0, 0.0, 0.0));
  shade(Point(t, cross(normal, t) * (v_tangent.w < 0.0 ? -1.0 : 1.0), normal, to_viewer), has_direction);
  seen = true;
  finish();
}
`;

export function modelBody(geometry: BufferGeometry, vDown: boolean): Body {
  geometry.setAttribute('tangent', new BufferAttribute(tangents(geometry, vDown), 4));
  geometry.computeBoundingBox();
  const box = geometry.boundingBox;
  if (!box) throw new ModelError('The mesh has no size.');
  const middle = box.getCenter(new Vector3());
  const half = box.getSize(new Vector3()).multiplyScalar(0.5);
  const radius = half.length();
  if (!(radius > 0 && Number.isFinite(radius))) throw new ModelError('The mesh has no size, or places that are not finite.');
  const shadows = new ShadowMaps(geometry, { centre: middle.toArray() as Vec3, radius: 1.05 * radius });
  return {
    geometry,
    view: automaticView(middle, half),
    vertex: VERTEX,
    fragment: FRAGMENT,
    uniforms: shadows.uniforms,
    occlusion: occlusion(geometry),
    forgetShadows: () => shadows.forget(),
    drawShadows: (renderer, lights) => shadows.draw(renderer, lights),
  };
}

/** A camera on the +z side that just holds the box. */
function automaticView(middle: Vector3, half: Vector3): View {
  const tangent = Math.tan((0.5 * FOV_DEG * Math.PI) / 180);
  const side = MARGIN * Math.max(half.x, half.y, 0.05 * half.z);
  const distance = side / tangent + half.z;
  const reach = half.length();
  return {
    position: [middle.x, middle.y, middle.z + distance],
    target: middle.toArray() as Vec3,
    parallel: false,
    half: tangent,
    near: Math.max(0.02 * distance, distance - 1.2 * reach),
    far: distance + 1.2 * reach,
  };
}
