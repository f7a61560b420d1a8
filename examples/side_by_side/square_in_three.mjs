// The part of three.js in side_by_side.py: a square under a light far away, seen in perspective, as 32-bit floats of linear sRGB, rows from the top.
//
//   node square_in_three.mjs ATLAS SPECIMEN PIXELS EYE LIGHT_X LIGHT_Y LIGHT_Z OUT.f32
import { readFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { ROOT, browse } from '../../viewer/tests/lib/at_work.mjs';

const [atlas, specimen, pixels, eye, x, y, z, out] = process.argv.slice(2);
const PLACES = [
  ['/atlas/', atlas],
  ['/node_modules/diffraction-atlas-three/', join(ROOT, 'viewer/three')],
  ['/node_modules/three/', join(ROOT, 'viewer/node_modules/three')],
];
// The example's import map without its ball.
const PAGE = readFileSync(join(ROOT, 'viewer/three/example/index.html'), 'utf8').replace(/<script type="module".*?<\/script>/s, '');

const server = createServer((request, answer) => {
  const path = normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname));
  try {
    const [from, to] = PLACES.find(([from]) => path.startsWith(from)) ?? [];
    const bytes = path === '/' ? PAGE : readFileSync(join(to, path.slice(from.length)));
    const type = path === '/' ? 'text/html' : { '.js': 'text/javascript' }[extname(path)];
    answer.writeHead(200, { 'Content-Type': type ?? 'application/octet-stream' }).end(bytes);
  } catch {
    answer.writeHead(404).end();
  }
});

async function drawn([specimen, side, height, light]) {
  const three = await import('three');
  const { layStructure, openAtlas } = await import('diffraction-atlas-three');
  const material = await (await openAtlas('atlas')).material(specimen, { interpolation: 'cubic', lightDiameterDeg: 0 });
  const renderer = new three.WebGLRenderer();
  const target = new three.WebGLRenderTarget(side, side, { type: three.FloatType });
  const lamp = new three.DirectionalLight('white', 1);
  lamp.position.set(...light);
  const camera = new three.PerspectiveCamera((360 / Math.PI) * Math.atan(1 / height), 1, 0.1, 10);
  camera.position.z = height;
  renderer.setRenderTarget(target);
  renderer.render(new three.Scene().add(lamp, new three.Mesh(layStructure(new three.PlaneGeometry(2, 2)), material)), camera);
  const texels = new Float32Array(4 * side * side);
  renderer.readRenderTargetPixels(target, 0, 0, side, side, texels);
  // As text: nothing else passes to the program that drives the browser as fast.
  const bytes = new Uint8Array(texels.buffer);
  let text = '';
  for (let at = 0; at < bytes.length; at += 32768) text += String.fromCharCode(...bytes.subarray(at, at + 32768));
  return btoa(text);
}

await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
const browser = await browse();
try {
  const page = await browser.newPage();
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
  const side = Number(pixels);
  const bytes = Buffer.from(await page.evaluate(drawn, [specimen, side, Number(eye), [x, y, z].map(Number)]), 'base64');
  const texels = new Float32Array(bytes.buffer, bytes.byteOffset, 4 * side * side);
  const rows = new Float32Array(3 * side * side);
  // The first row of a target is the lowest.
  for (let row = 0; row < side; row++)
    for (let column = 0; column < side; column++)
      for (let c = 0; c < 3; c++) rows[3 * (row * side + column) + c] = texels[4 * ((side - 1 - row) * side + column) + c];
  writeFileSync(out, rows);
} finally {
  await browser.close();
  server.close();
}
