// The page in a browser against the program: the same pictures, the same numbers, and nothing from elsewhere.
//
//   diffraction-atlas run viewer/tests/pictures.toml && node --test viewer/tests/page.test.mjs
import assert from 'node:assert/strict';
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { ATLAS, browse, call, open, picture, serve } from './lib/at_work.mjs';
import { ciede2000, difference } from './lib/ciede2000.mjs';
import { mirrored, readPng } from './lib/png.mjs';

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
  assert.equal(await served?.stop(), 0, 'Ctrl-C ends the program in good order');
  rmSync(folder, { recursive: true, force: true });
});

const sun = (direction, diameter_deg = 0.53) => [{ direction, diameter_deg, irradiance: 1 }];
// The scenes of pictures.toml as states of the page.
const STATES = {
  map: { shape: 'map', lights: sun([0, 0, 1]) },
  ball: { shape: 'ball', lights: sun([0.3, 0.2, 1]) },
  dragged: { shape: 'ball', lights: sun([-0.5, 0.4, 1]) },
  flat: { shape: 'patch', lights: sun([0.35, 0.866, 0.5]), patch: { width_mm: 20, distance_mm: 60, tilt_deg: 30 } },
  screen: { shape: 'screen', screen: { distance_mm: 100, width_mm: 200, beam_mm: 2, incidence_deg: 0 } },
  snake: { shape: 'snake', lights: sun([0.3, 0.2, 1], 3) },
};
const MEAN_MAX = 0.5;

/** The state that shows a scene as the program published it. */
function stateOf(name) {
  const { exposure } = scenes.find((scene) => scene.name === name);
  // The program's pictures are of linear look-ups at points.
  const samples = { light_samples: 16, pixel_samples: 1, interpolation: 'spline', look_ups: 'points' };
  return { specimen: SPECIMEN, size_px: 256, tone: 'atlas', tables: null, ...samples, exposure: Math.log2(exposure / Math.PI), ...STATES[name] };
}
const published = (name) => readPng(readFileSync(join(version, SPECIMEN, 'scenes', `${name}.png`)));

test('differences of colours are those of the published pairs', () => {
  // Sharma, Wu, Dalal 2005, rows 1, 4, 17 and 25.
  for (const [a, b, expected] of [
    [[50, 2.6772, -79.7751], [50, 0, -82.7485], 2.0425],
    [[50, -1.3802, -84.2814], [50, 0, -82.7485], 1.0],
    [[50, 2.5, 0], [73, 25, -18], 27.1492],
    [[60.2574, -34.0099, 36.2677], [60.4626, -34.1751, 39.4387], 1.2644],
  ]) {
    assert.ok(Math.abs(ciede2000(a, b) - expected) < 1e-4, `${ciede2000(a, b)} for ${expected}`);
  }
});

for (const name of Object.keys(STATES)) {
  test(`the page's ${name} is the program's`, async (t) => {
    const found = difference(await picture(shown.page, stateOf(name)), published(name));
    t.diagnostic(`${name}: CIEDE2000 mean ${found.mean.toFixed(4)}, worst pixel ${found.worst.toFixed(2)}`);
    assert.ok(found.mean <= MEAN_MAX, `mean CIEDE2000 ${found.mean}`);
  });
}

test('a mirrored picture, a missing table and another light are found', async (t) => {
  const ball = await picture(shown.page, stateOf('ball'));
  const wrong = {
    'left for right': mirrored(ball),
    'top for bottom': mirrored(ball, true),
    'one table alone': await picture(shown.page, { ...stateOf('ball'), tables: 1 }),
    'the structure turned': await picture(shown.page, { ...stateOf('ball'), turn_deg: 10 }),
    'the light elsewhere': await picture(shown.page, { ...stateOf('dragged'), exposure: stateOf('ball').exposure }),
  };
  await picture(shown.page, { ...stateOf('ball'), turn_deg: 0 });
  for (const [what, spoilt] of Object.entries(wrong)) {
    const { mean } = difference(spoilt, published('ball'));
    t.diagnostic(`${what}: ${mean.toFixed(2)}`);
    assert.ok(mean > MEAN_MAX, `${what} goes unseen: ${mean}`);
  }
});

for (const interpolation of ['bilinear', 'cubic', 'spline']) {
  test(`spectra in three directions are those of eval, ${interpolation}`, async (t) => {
    const directions = [[0, 0, 20, 0], [30, 40, 25, 200], [55, 180, 10, 90]];
    const wavelengths = [400, 450, 500, 550, 600, 650, 700];
    const csv = join(folder, 'directions.csv');
    writeFileSync(csv, ['theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg', ...directions.map(String), ''].join('\n'));
    const words = ['--atlas', ATLAS, '--specimen', SPECIMEN, '--wavelengths-nm', String(wavelengths), '--interpolation', interpolation];
    const said = call('eval', '--directions', csv, ...words);
    const rows = said.trim().split('\n').slice(1).map((line) => line.split(',').slice(4).map(Number));
    await picture(shown.page, { ...stateOf('ball'), interpolation });
    for (const [i, direction] of directions.entries()) {
      const { values } = await shown.page.evaluate(([d, nm]) => window.atlasViewer.spectrumAt(...d, nm), [direction, wavelengths]);
      const peak = Math.max(...rows[i]);
      assert.ok(peak > 0 && values.length === wavelengths.length);
      const apart = (one) => Math.max(...one.map((value, n) => Math.abs(value - rows[i][n]))) / peak;
      t.diagnostic(`${direction}: ${apart(values).toExponential(1)} of the largest value`);
      // Hardware may place a look-up in steps of 1/256 of a texel.
      assert.ok(apart(values) < 5e-3, `${direction}: ${values} for ${rows[i]}`);
      const next = [...values.slice(1), values[0]];
      assert.ok(apart(next) > 5e-3, 'a spectrum moved by one wavelength goes unseen');
    }
    await picture(shown.page, { interpolation: 'bilinear' });
  });
}

test('a light dragged by the mouse moves the picture, and the keyboard does the same', async () => {
  const { page } = shown;
  const direction = () => page.evaluate(() => window.atlasViewer.state().lights[0].direction);
  await picture(page, stateOf('ball'));
  const start = await direction();
  const pad = page.locator('.pad').first();
  await pad.focus();
  await page.keyboard.press('ArrowRight');
  const nudged = await direction();
  assert.ok(nudged[0] / nudged[2] > start[0] / start[2], `${start} to ${nudged}`);
  const box = await pad.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.3 * box.width, box.y + 0.3 * box.height, { steps: 4 });
  await page.mouse.up();
  const dragged = await direction();
  assert.ok(dragged[0] < 0 && dragged[1] > 0, `to the upper left: ${dragged}`);
});

test('the keyboard alone reaches everything', async (t) => {
  const { page, close } = await open(browser, served.url);
  // Small pictures: the processor draws them, and each key waits for one.
  await page.evaluate(() => window.atlasViewer.set({ size_px: 32 }));
  const wanted = await page.evaluate(() => {
    const all = [...document.querySelectorAll('a[href], button, input, select, textarea, summary, [tabindex]')];
    const there = all.filter((one) => one.tabIndex >= 0 && !one.disabled && one.checkVisibility({ visibilityProperty: true }));
    // Of a group of radio buttons Tab reaches one, arrow keys the rest.
    there.forEach((one, i) => (one.dataset.asked = one.type === 'radio' ? `group ${one.name}` : String(i)));
    return [...new Set(there.map((one) => one.dataset.asked))];
  });
  const reached = new Set();
  for (let i = 0; i < wanted.length + 20; i++) {
    await page.keyboard.press('Tab');
    const at = await page.evaluate(() => {
      const one = document.activeElement;
      const looks = getComputedStyle(one);
      const seen = looks.outlineStyle !== 'none' || looks.boxShadow !== 'none' || one.matches('input');
      return { asked: one.dataset.asked, seen, what: one.outerHTML.slice(0, 120) };
    });
    if (at.asked) {
      assert.ok(at.seen, `no mark where the focus is: ${at.what}`);
      reached.add(at.asked);
    }
  }
  t.diagnostic(`${reached.size} controls`);
  assert.ok(wanted.length > 15, `only ${wanted.length} controls`);
  assert.deepEqual(wanted.filter((one) => !reached.has(one)), []);
  await close();
});

for (const [what, options] of [['wide and dark', { colorScheme: 'dark' }], ['narrow and light', { colorScheme: 'light', viewport: { width: 390, height: 844 } }]]) {
  test(`axe finds no serious fault, ${what}`, async () => {
    const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
    const { page, close } = await open(browser, served.url, options);
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => window.axe.run());
    const serious = violations.filter(({ impact }) => impact === 'serious' || impact === 'critical');
    const told = serious.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 160)).join(' | ')}`);
    assert.deepEqual(told, []);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(wide <= 0, `the page is ${wide} px wider than the window`);
    await close();
  });
}

test('one file works from the disk, alone, and shows the same', async (t) => {
  const file = join(folder, 'snake.html');
  t.diagnostic(call('export', ATLAS, '--form', 'viewer', '--single-file', '--out', file).trim());
  const { page, complaints, requests, close } = await open(browser, pathToFileURL(file).href);
  const found = difference(await picture(page, stateOf('ball')), published('ball'));
  assert.ok(found.mean <= MEAN_MAX, `mean CIEDE2000 ${found.mean}`);
  const outside = requests.filter((address) => !/^(data|blob):/.test(address));
  assert.deepEqual(outside, [pathToFileURL(file).href]);
  assert.deepEqual(complaints, []);
  await close();
});

test('a damaged atlas gets a message', async () => {
  const copy = join(folder, 'damaged');
  cpSync(ATLAS, copy, { recursive: true });
  const table = join(copy, readFileSync(join(copy, 'latest'), 'utf8').trim(), SPECIMEN, 'table.000.exr');
  const bytes = readFileSync(table);
  const spoilt = await serve(copy);
  bytes[bytes.length >> 1] ^= 1;
  writeFileSync(table, bytes);
  const { page, close } = await open(browser, spoilt.url, { ready: false });
  const message = page.getByRole('alert');
  await message.waitFor();
  assert.match(await message.textContent(), /table\.000\.exr/);
  await close();
  await spoilt.stop();
});

test('nothing was asked from elsewhere and nothing complained of', () => {
  const outside = shown.requests.filter((address) => !address.startsWith(served.url) && !/^(data|blob):/.test(address));
  assert.deepEqual(outside, []);
  assert.deepEqual(shown.complaints, []);
});
