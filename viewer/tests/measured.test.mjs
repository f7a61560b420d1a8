// Measured spectra beside the model's: offered where a specimen has some, at the directions and values of its file, served and as one file.
//
//   node --test viewer/tests/measured.test.mjs
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { ROOT, browse, call, open, picture, serve } from './lib/at_work.mjs';

const ATLAS = join(ROOT, 'out/atlas/viewer_coherence');
const FILE = join(ROOT, 'specimens/sinusoid_1600nm.closed_form.csv');
/** Rows of the file: four angles in degrees, a wavelength in nm, f in 1/sr. */
const ROWS = readFileSync(FILE, 'utf8').trim().split('\n').slice(2).map((line) => line.split(',').map(Number));
const folder = mkdtempSync(join(tmpdir(), 'measured-'));
let browser, served;

before(async () => {
  call('--quiet', 'run', join(ROOT, 'viewer/tests/coherence.toml'));
  [browser, served] = [await browse(), await serve(ATLAS)];
});
after(async () => {
  await browser?.close();
  await served?.stop();
  rmSync(folder, { recursive: true });
});

/** Every pair of directions with a spectrum, in the file's order. */
const pairs = [...new Map(ROWS.map((row) => [String(row.slice(0, 4)), row.slice(0, 4)]))]
  .filter(([words]) => ROWS.filter((row) => String(row.slice(0, 4)) === words).length > 1)
  .map(([, pair]) => pair);

for (const kind of ['served', 'as one file']) {
  test(`a measured spectrum lies over the model's, ${kind}`, async (t) => {
    const file = join(folder, 'one.html');
    if (kind === 'as one file') call('export', ATLAS, '--form', 'viewer', '--single-file', '--specimen', 'sinusoid', '--out', file);
    const { page, complaints, close } = await open(browser, kind === 'served' ? served.url : pathToFileURL(file).href);
    await picture(page, { specimen: 'sinusoid', shape: 'sphere', size_px: 64, light_samples: 1, pixel_samples: 1 });
    const choice = page.getByLabel('Measured spectra');
    await choice.waitFor();
    assert.equal(await choice.locator('option').count(), 1 + pairs.length);
    for (const [i, pair] of pairs.entries()) {
      await choice.selectOption(String(i));
      await page.waitForFunction(async () => (await window.atlasViewer.spot())?.spectrum?.measured.some((value) => value !== null));
      const { wi, wo, chosen, spectrum } = await page.evaluate(() => window.atlasViewer.spot());
      assert.equal(chosen, true);
      for (const [vector, theta, phi] of [[wi, pair[0], pair[1]], [wo, pair[2], pair[3]]]) {
        const [sin, turn] = [Math.sin((theta * Math.PI) / 180), (phi * Math.PI) / 180];
        assert.ok(Math.hypot(vector[0] - sin * Math.cos(turn), vector[1] - sin * Math.sin(turn)) < 1e-6, `${vector} for ${pair}`);
      }
      const wanted = new Map(ROWS.filter((row) => String(row.slice(0, 4)) === String(pair)).map((row) => [row[4], row[5]]));
      const shown = spectrum.nm.flatMap((nm, k) => (spectrum.measured[k] === null ? [] : [[nm, spectrum.measured[k], spectrum.values[k]]]));
      assert.ok(shown.length > 10 && shown.every(([nm, value]) => Math.abs(value / wanted.get(nm) - 1) < 1e-5), `${shown[0]}`);
      // The file is the closed form, and coarse tables find its brightest wavelength.
      const brightest = (column) => shown.reduce((best, row) => (row[column] > best[column] ? row : best))[0];
      t.diagnostic(`${pair}: brightest at ${brightest(1)} nm in the file, ${brightest(2)} nm in the tables`);
      assert.ok(Math.abs(brightest(1) - brightest(2)) <= 20, `${brightest(1)} and ${brightest(2)} nm`);
    }
    await choice.selectOption('');
    assert.equal((await page.evaluate(() => window.atlasViewer.spot()))?.chosen ?? false, false);
    if (kind === 'served') {
      await picture(page, { specimen: 'sunbeam' });
      await choice.waitFor({ state: 'hidden' });
    }
    assert.deepEqual(complaints, []);
    await close();
  });
}
