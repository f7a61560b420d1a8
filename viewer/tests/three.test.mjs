// The package for three.js in a browser against the program: what its material shows is what `eval` says.
//
//   diffraction-atlas run viewer/tests/pictures.toml && node viewer/three/build.mjs && node --test viewer/tests/three.test.mjs
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { extname, join, normalize } from 'node:path';
import { after, before, test } from 'node:test';
import { ATLAS, ROOT, browse, call } from './lib/at_work.mjs';

const SPECIMEN = 'corn_snake_like';
const SIDE = 24;
/** Camera above a square of side 2, whose pixels then see it from up to 60 degrees. */
const HEIGHT = 0.8;
const folder = mkdtempSync(join(tmpdir(), 'three-'));
const PLACES = [
  ['/atlas/', ATLAS],
  ['/node_modules/diffraction-atlas-three/', join(ROOT, 'viewer/three')],
  ['/node_modules/three/', join(ROOT, 'viewer/node_modules/three')],
  ['/', join(ROOT, 'viewer/three/example')],
];
const TYPES = { '.html': 'text/html', '.js': 'text/javascript' };
// The example's import map without its ball, which would turn on while others are measured.
const BARE = readFileSync(join(ROOT, 'viewer/three/example/index.html'), 'utf8').replace(/<script type="module".*?<\/script>/s, '');
let browser, server, page, complaints;
const home = () => `http://127.0.0.1:${server.address().port}`;

before(async () => {
  server = createServer((request, answer) => {
    const path = normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname));
    const [from, to] = PLACES.find(([from]) => path.startsWith(from));
    try {
      const bytes = path === '/bare.html' ? BARE : readFileSync(join(to, path.slice(from.length)));
      answer.writeHead(200, { 'Content-Type': TYPES[extname(path)] ?? 'application/octet-stream' }).end(bytes);
    } catch {
      answer.writeHead(404).end();
    }
  });
  await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
  browser = await browse();
  page = await (await browser.newContext({ viewport: { width: 320, height: 320 } })).newPage();
  complaints = [];
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && complaints.push(message.text()));
  page.on('pageerror', (error) => complaints.push(String(error)));
  await page.goto(`${home()}/bare.html`);
});
after(async () => {
  await browser?.close();
  server?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** Linear sRGB of a square from above under a light of unit intensity, row by row from below. */
function drawn(light, options = {}, mirrored = false, tangents = true, uvs = true) {
  return page.evaluate(
    async ([light, options, mirrored, tangents, uvs, side, height, specimen]) => {
      const three = await import('three');
      const { layStructure, openAtlas } = await import('diffraction-atlas-three');
      window.atlas ??= await openAtlas('atlas');
      const material = await window.atlas.material(specimen, options);
      const renderer = new three.WebGLRenderer();
      const target = new three.WebGLRenderTarget(side, side, { type: three.FloatType });
      const scene = new three.Scene();
      const lamp = new three.DirectionalLight('white', 1);
      lamp.position.set(...light);
      const geometry = new three.PlaneGeometry(2, 2);
      if (!uvs) geometry.getAttribute('uv').array.fill(0.5);
      const square = new three.Mesh(tangents ? layStructure(geometry) : geometry, material);
      if (mirrored) square.scale.x = -1;
      scene.add(lamp, square);
      const camera = new three.PerspectiveCamera((360 / Math.PI) * Math.atan(1 / height), 1, 0.1, 10);
      camera.position.z = height;
      renderer.setRenderTarget(target);
      renderer.render(scene, camera);
      const out = new Float32Array(4 * side * side);
      renderer.readRenderTargetPixels(target, 0, 0, side, side, out);
      material.dispose();
      renderer.dispose();
      return [...out];
    },
    [light, options, mirrored, tangents, uvs, SIDE, HEIGHT, SPECIMEN],
  );
}

/** What `eval` says of the same, with more words for it. */
function said(light, words = [], mirrored = false) {
  const side = mirrored ? -1 : 1;
  const angles = ([x, y, z]) => [Math.acos(z / Math.hypot(x, y, z)), Math.atan2(y, side * x)].map((angle) => (angle * 180) / Math.PI);
  const place = (i) => (2 * (i + 0.5)) / SIDE - 1;
  const rows = [];
  for (let y = 0; y < SIDE; y++) for (let x = 0; x < SIDE; x++) rows.push([...angles(light), ...angles([-place(x), -place(y), HEIGHT])]);
  const csv = join(folder, 'directions.csv');
  writeFileSync(csv, ['theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg', ...rows.map(String), ''].join('\n'));
  const lines = call('eval', '--directions', csv, '--atlas', ATLAS, '--specimen', SPECIMEN, ...words).trim().split('\n').slice(1);
  const cosine = light[2] / Math.hypot(...light);
  return lines.flatMap((line) => {
    const [X, Y, Z] = line.split(',').slice(4).map((value) => Number(value) * cosine);
    return [3.2404542 * X - 1.5371385 * Y - 0.4985314 * Z, -0.969266 * X + 1.8760108 * Y + 0.041556 * Z, 0.0556434 * X - 0.2040259 * Y + 1.0572252 * Z, 1];
  });
}

/** Root of the mean square of the differences, relative to that of the values. */
function apart(found, wanted) {
  const square = (values) => values.reduce((sum, value) => sum + value * value, 0);
  const light = (values) => values.filter((_, i) => i % 4 < 3);
  return Math.sqrt(square(light(found.map((value, i) => value - wanted[i]))) / square(light(wanted)));
}

// Cubic look-ups fetch texels, so that single precision is all that is lost. Linear ones are placed by hardware: the software driver has 16 bits
// for a texture's whole width, a hundredth of a texel here, over which values change by a few times that.
const ALLOWED = { cubic: 2e-3, bilinear: 2e-2 };

for (const [what, light, options, words, mirrored, tangents] of [
  ['linear look-ups', [0.3, 0.2, 1], { interpolation: 'bilinear' }, [], false, true],
  ['cubic look-ups', [-0.5, 0.1, 0.6], {}, [], false, true],
  ['a mirrored object', [0.3, 0.2, 1], {}, [], true, true],
  ['a geometry without tangents', [0.1, -0.4, 1], {}, [], false, false],
  ['a lamp from spectral tables', [0.3, 0.2, 1], { illuminant: 'A' }, ['--illuminant', 'A'], false, true],
]) {
  test(`three.js shows what eval says: ${what}`, async (t) => {
    const { interpolation = 'cubic' } = options;
    const [found, wanted] = [await drawn(light, { ...options, interpolation }, mirrored, tangents), said(light, [...words, '--interpolation', interpolation], mirrored)];
    t.diagnostic(`${apart(found, wanted).toExponential(1)} of the values`);
    assert.ok(apart(found, wanted) < ALLOWED[interpolation], `${apart(found, wanted)}`);
    const turned = await drawn(light, { ...options, interpolation, turnDeg: 5 }, mirrored, tangents);
    assert.ok(apart(turned, wanted) > 5 * ALLOWED[interpolation], 'a structure turned by 5 degrees goes unseen');
  });
}

test('a light with a size is the mean over its disc', async () => {
  const light = [0.3, 0.2, 1];
  const point = await drawn(light);
  const wide = await drawn(light, { lightDiameterDeg: 4, lightSamples: 64 });
  const sum = (values) => values.reduce((sum, value) => sum + value, 0);
  // The square's light is spread, not lost: what leaves at its rim is small.
  assert.ok(apart(wide, point) > 0.02 && Math.abs(sum(wide) / sum(point) - 1) < 0.02, `${apart(wide, point)} ${sum(wide) / sum(point)}`);
});

test('texture coordinates that give no direction are magenta, not noise', async () => {
  const found = await drawn([0.3, 0.2, 1], {}, false, true, false);
  assert.deepEqual([...new Set(found)].sort(), [0, 1]);
  assert.ok(found.every((value, i) => value === [1, 0, 1, 1][i % 4]));
});

test('a specimen that is not there, and a file that is missing, are told', async () => {
  const told = (name) => page.evaluate(async (name) => (await import('diffraction-atlas-three')).openAtlas('atlas').then((atlas) => atlas.material(name)).catch((error) => error.message), name);
  assert.match(await told('none'), /no specimen none; it has corn_snake_like/);
  assert.match(await page.evaluate(async () => (await import('diffraction-atlas-three')).openAtlas('nowhere').catch((error) => error.message)), /atlas.json is missing/);
});

test('the example shows a ball, and nothing complains', async () => {
  complaints.length = 0;
  await page.goto(`${home()}/index.html`);
  await page.waitForSelector('canvas');
  await page.waitForTimeout(1500);
  if (process.env.SCREENSHOT) await page.screenshot({ path: process.env.SCREENSHOT });
  assert.equal(await page.textContent('#said'), '');
  assert.deepEqual(complaints.filter((text) => !/GL Driver Message|GPU stall/.test(text)), []);
});
