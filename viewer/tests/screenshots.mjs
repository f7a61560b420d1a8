// Pictures of the page for the README, from the bundled atlas: node viewer/tests/screenshots.mjs FOLDER
import { join } from 'node:path';
import { ROOT, browse, open, serve } from './lib/at_work.mjs';

const folder = process.argv[2] ?? '.';
const SNAKE = {
  specimen: 'sunbeam_snake_like',
  shape: 'snake',
  lights: [{ direction: [0.3, 0.2, 1], diameter_deg: 2, irradiance: 1 }],
  pointer: { x: 0.14, y: -0.12 },
};
const SIZES = {
  viewer: { viewport: { width: 1400, height: 900 }, colorScheme: 'dark' },
  viewer_narrow: { viewport: { width: 390, height: 844 }, colorScheme: 'light' },
  viewer_wide: { viewport: { width: 2560, height: 1440 }, colorScheme: 'dark' },
};

const [browser, served] = [await browse(), await serve(process.env.ATLAS ?? join(ROOT, 'out/atlas/bundled'))];
for (const name of process.argv.length > 3 ? process.argv.slice(3) : Object.keys(SIZES)) {
  const { page, close } = await open(browser, `${served.url}#${encodeURIComponent(JSON.stringify(SNAKE))}`, SIZES[name]);
  await page.waitForFunction(() => /\b(\d+) \/ \1 samples/.test(document.body.innerText) && !document.body.innerText.includes('1 / 1 samples'), null, { timeout: 600_000 });
  await page.screenshot({ path: join(folder, `${name}.png`), timeout: 120_000 });
  await close();
}
await browser.close();
await served.stop();
