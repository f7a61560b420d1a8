// The choice of coherence: offered where an atlas holds a scan under several, and the pictures are those specimens' own.
//
//   node --test viewer/tests/coherence.test.mjs
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { ROOT, browse, call, open, picture, serve } from './lib/at_work.mjs';
import { difference } from './lib/ciede2000.mjs';

let browser, served;

before(async () => {
  call('--quiet', 'run', join(ROOT, 'viewer/tests/coherence.toml'));
  [browser, served] = [await browse(), await serve(join(ROOT, 'out/atlas/viewer_coherence'))];
});
after(async () => {
  await browser?.close();
  await served?.stop();
});

test('a scan under two coherences has a choice, another has none', async () => {
  const { page, complaints, close } = await open(browser, served.url);
  const choice = page.getByLabel('Coherence', { exact: true });
  await choice.waitFor();
  assert.deepEqual(await choice.locator('option').allTextContents(), ['σ = 2 µm', 'σ = 4 µm']);
  const state = { shape: 'map', size_px: 64, exposure: 3 };
  const wide = await picture(page, state);
  await choice.selectOption('corn_narrow_light');
  const narrow = await picture(page, state);
  assert.equal(await page.evaluate(() => window.atlasViewer.state().specimen), 'corn_narrow_light');
  assert.equal(await page.getByRole('radio', { name: 'corn narrow light' }).isChecked(), true, 'the card follows');
  assert.ok(difference(wide, narrow).mean > 0.5, 'another picture');
  assert.equal(difference(await picture(page, { specimen: 'corn_wide_light' }), wide).worst, 0);
  await picture(page, { specimen: 'sunbeam' });
  await choice.waitFor({ state: 'hidden' });
  assert.deepEqual(complaints, []);
  await close();
});
