// Look-ups of the page by splines and over lights and pixels, against the program: its numbers, its bytes, its pictures of many samples.
//
//   diffraction-atlas run viewer/tests/pictures.toml && node --test viewer/tests/look_ups.test.mjs
import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import { ATLAS, ROOT, browse, call, open, picture, serve } from './lib/at_work.mjs';
import { difference } from './lib/ciede2000.mjs';
import { readPng } from './lib/png.mjs';

const SPECIMEN = 'corn_snake_like';
const version = join(ATLAS, readFileSync(join(ATLAS, 'latest'), 'utf8').trim());
const scenes = JSON.parse(readFileSync(join(version, 'report.json'), 'utf8')).specimens[0].scenes;
const folder = mkdtempSync(join(tmpdir(), 'viewer-'));
let browser, served, shown;

before(async () => {
  [browser, served] = [await browse(), await serve(ATLAS)];
  shown = await open(browser, served.url);
});
after(async () => {
  await browser?.close();
  await served?.stop();
  rmSync(folder, { recursive: true, force: true });
});

const sun = (direction, diameter_deg = 0.53) => [{ direction, diameter_deg, irradiance: 1 }];
const patch = { width_mm: 20, distance_mm: 60, tilt_deg: 30 };
const STATES = {
  fine_ball: { shape: 'ball', lights: sun([0.3, 0.2, 1]) },
  fine_lamp: { shape: 'ball', lights: sun([-0.5, 0.4, 1], 2) },
  fine_flat: { shape: 'patch', lights: sun([0.35, 0.866, 0.5]), patch },
};
const published = (name) => readPng(readFileSync(join(version, SPECIMEN, 'scenes', `${name}.png`)));
const exposed = (name) => Math.log2(scenes.find((scene) => scene.name === name).exposure / Math.PI);
const stateOf = (name) => ({ specimen: SPECIMEN, size_px: 96, tone: 'atlas', tables: null, environment: 'none', exposure: exposed(name), interpolation: 'spline', look_ups: 'filtered', ...STATES[name] });

for (const name of Object.keys(STATES)) {
  test(`one look-up for light and pixel is the mean of the program's 256 samples, ${name}`, async (t) => {
    const off = async (change) => {
      const found = difference(await picture(shown.page, { ...stateOf(name), ...change }), published(name));
      return found.mean;
    };
    const filtered = await off({ pixel_samples: 16 });
    const wrong = {
      'points at the centres': await off({ look_ups: 'points', light_samples: 1, pixel_samples: 1 }),
      'a light of twice the size': await off({ pixel_samples: 16, lights: sun(STATES[name].lights[0].direction, 2 * STATES[name].lights[0].diameter_deg) }),
      'the structure turned': await off({ pixel_samples: 16, turn_deg: 5 }),
    };
    await picture(shown.page, { turn_deg: 0 });
    t.diagnostic(`${name}: CIEDE2000 ${filtered.toFixed(3)}; ${Object.entries(wrong).map(([what, mean]) => `${what} ${mean.toFixed(3)}`).join(', ')}`);
    assert.ok(filtered <= 0.2, `mean CIEDE2000 ${filtered}`);
    for (const [what, mean] of Object.entries(wrong)) assert.ok(mean > 1.5 * filtered, `${what} goes unseen: ${mean} where ${filtered} is right`);
  });
}

test('under another light, from spectral tables, filtered look-ups are the mean of many points', async (t) => {
  const state = { ...stateOf('fine_ball'), size_px: 24, illuminant: 'laser', laser_nm: 550, interpolation: 'spline' };
  const many = await picture(shown.page, { ...state, look_ups: 'points', light_samples: 256, pixel_samples: 256 });
  const few = difference(await picture(shown.page, { ...state, look_ups: 'points', light_samples: 1, pixel_samples: 1 }), many).mean;
  const filtered = difference(await picture(shown.page, { ...state, pixel_samples: 16 }), many).mean;
  await picture(shown.page, { illuminant: 'tables' });
  t.diagnostic(`CIEDE2000 ${filtered.toFixed(3)}; a point at the centre ${few.toFixed(3)}`);
  assert.ok(filtered <= 0.2 && few > 3 * filtered, `${filtered}, ${few}`);
});

test("the program's preview, made of filtered look-ups, is the page's picture", async (t) => {
  const preview = readPng(readFileSync(join(version, SPECIMEN, 'preview.png')));
  const state = { ...stateOf('fine_ball'), size_px: preview.width, lights: sun([0.5, 0.5, 1]), pixel_samples: 16 };
  await picture(shown.page, state);
  // The exposure that the program takes: the brightest half percent of what is lit comes to white.
  const exposure = await shown.page.evaluate(() => {
    const { data } = window.atlasViewer.xyz();
    const lit = Array.from(data.filter((_, i) => i % 4 === 1)).filter((y) => y > 0).sort((a, b) => a - b);
    return Math.log2(1 / lit[Math.ceil(0.995 * lit.length) - 1] / Math.PI);
  });
  const found = difference(await picture(shown.page, { ...state, exposure }), preview);
  const turned = difference(await picture(shown.page, { ...state, exposure, lights: sun([0.5, 0.45, 1]) }), preview);
  t.diagnostic(`CIEDE2000 mean ${found.mean.toFixed(3)}, worst ${found.worst.toFixed(1)}; a light elsewhere ${turned.mean.toFixed(2)}`);
  assert.ok(found.mean <= 0.5, `mean CIEDE2000 ${found.mean}`);
  assert.ok(turned.mean > 3 * found.mean, `a light elsewhere goes unseen: ${turned.mean}`);
});

test('X, Y, Z by splines are those of eval, which takes splines where nothing is said', async (t) => {
  const directions = [[0, 0, 20, 0], [30, 40, 25, 200], [55, 180, 10, 90], [10, 0, 10, 180.4]];
  const csv = join(folder, 'directions.csv');
  writeFileSync(csv, ['theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg', ...directions.map(String), ''].join('\n'));
  const rows = call('eval', '--directions', csv, '--atlas', ATLAS, '--specimen', SPECIMEN).trim().split('\n').slice(1).map((line) => line.split(',').slice(4, 7).map(Number));
  const worst = async (interpolation) => {
    await picture(shown.page, { ...stateOf('fine_ball'), size_px: 16, interpolation, pigment: true });
    let most = 0;
    for (const [i, direction] of directions.entries()) {
      const found = await shown.page.evaluate((d) => window.atlasViewer.brdfXyz(...d), direction);
      most = Math.max(most, ...found.map((value, c) => Math.abs(value - rows[i][c]) / Math.max(...rows[i])));
    }
    return most;
  };
  const [spline, bilinear] = [await worst('spline'), await worst('bilinear')];
  t.diagnostic(`splines ${spline.toExponential(1)}, linear look-ups ${bilinear.toExponential(1)} of the largest value`);
  // Hardware may place each of the four fetches in steps of 1/256 of a texel; coefficients are halves.
  assert.ok(spline < 3e-3, `${spline}`);
  assert.ok(bilinear > 2 * spline, 'linear look-ups go unseen');
});

test('coefficients, coarser levels and Gaussians are the bytes that the program exports', async () => {
  const bundle = join(folder, 'atlas.mjs');
  const entry = `export * from './levels'; export * from './gaussians'; export * from './pack'; export * from './specimen'; export * from './files';`;
  await build({ stdin: { contents: entry, resolveDir: join(ROOT, 'viewer/src/atlas'), loader: 'ts' }, bundle: true, format: 'esm', platform: 'node', outfile: bundle, logLevel: 'error' });
  const { levelled, lobeGaussians, packTables, packSpectral, readSpecimen, filesFrom } = await import(pathToFileURL(bundle).href);
  const files = filesFrom(async (path) => (existsSync(join(version, path)) ? new Uint8Array(readFileSync(join(version, path))) : null), async (path) => path);
  const specimen = await readSpecimen(files, SPECIMEN);
  const out = join(folder, 'shaders');
  call('export', ATLAS, '--form', 'shaders', '--specimen', SPECIMEN, '--out', out);
  const bytes = (name) => readFileSync(join(out, SPECIMEN, name));
  const same = (typed, name) => {
    const [mine, theirs] = [Buffer.from(typed.buffer, typed.byteOffset, typed.byteLength), bytes(name)];
    assert.equal(mine.length, theirs.length, name);
    // Sums in another order may round a last bit.
    let off = 0;
    for (let i = 0; i < mine.length; i += 2) {
      const [a, b] = [mine.readUInt16LE(i), theirs.readUInt16LE(i)];
      if (a === b) continue;
      off += 1;
      assert.ok(Math.abs(a - b) === 1, `${name}: ${a} for ${b} at byte ${i}`);
    }
    assert.ok(off < 1e-3 * mine.length, `${name}: ${off} numbers differ in the last bit`);
  };
  const joined = (levels) => Uint16Array.from(levels.flatMap(({ texels }) => [...texels]));
  const xyz = await packTables(files, specimen, () => undefined);
  const tables = await levelled(xyz.tables, { splines: true, channels: 3 });
  same(tables.texels, 'tables.rgba16f');
  same(joined(tables.coarser), 'tables.coarser.rgba16f');
  const spectral = await packSpectral(files, specimen, () => undefined);
  const wavelengths = await levelled(spectral.tables, { splines: true, channels: 4, count: spectral.count });
  same(wavelengths.texels, 'spectral_tables.rgba16f');
  const factors = bytes('lobe_gaussians.rgba32f');
  const found = lobeGaussians(xyz.lobe).texels;
  for (let i = 0; i < found.length; i++) {
    const wanted = factors.readFloatLE(4 * i);
    assert.ok(Math.abs(found[i] - wanted) <= 1e-3 * Math.abs(wanted) + 1e-12, `factor ${i}: ${found[i]} for ${wanted}`);
  }
});
