// The report in a browser: nothing wider than the page, no text cut off, readable to everyone, and whole without its script.
//
//   diffraction-atlas && node --test viewer/tests/report.test.mjs
//
// REPORT names another report than that of the bundled atlas, or of viewer/tests/pictures.toml where there is none; SHOTS a folder that pictures of it go to.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { ATLAS, ROOT, browse, open } from './lib/at_work.mjs';

const BUNDLED = join(ROOT, 'out/atlas/bundled');
const atlas = existsSync(join(BUNDLED, 'latest')) ? BUNDLED : ATLAS;
const latest = () => join(atlas, readFileSync(join(atlas, 'latest'), 'utf8').trim(), 'report.html');
const report = process.env.REPORT ? resolve(process.env.REPORT) : latest();
const address = pathToFileURL(report).href;
const AXE = createRequire(import.meta.url).resolve('axe-core/axe.min.js');
const WIDTHS = [400, 1080, 1400, 2560];
let browser;

before(async () => {
  browser = await browse();
});
after(() => browser?.close());

const opened = (options = {}) => open(browser, address, { ready: false, ...options });
/** What is folded is part of the page too. */
const unfold = (page) => page.evaluate(() => document.querySelectorAll('details').forEach((fold) => (fold.open = true)));

/** Whatever does not fit: the page itself, elements beyond its edges, text beyond its box. */
const misfits = (page) =>
  page.evaluate(() => {
    const width = document.documentElement.clientWidth;
    const named = (element) => `${element.tagName.toLowerCase()}.${element.getAttribute('class') ?? ''} "${element.textContent.trim().slice(0, 40)}"`;
    const found = [];
    if (document.documentElement.scrollWidth > width) found.push(`the page is ${document.documentElement.scrollWidth} px wide`);
    for (const element of document.querySelectorAll('main *')) {
      const box = element.getBoundingClientRect();
      if (box.width === 0 || element.closest('[hidden]')) continue;
      const svg = element.closest('svg');
      const frame = svg?.getBoundingClientRect();
      // What scrolls within the page may be wider than it; what is drawn may not leave its picture.
      const scrolls = element.parentElement.closest('.scroll, pre');
      if (!scrolls && (box.right > width + 1 || box.left < -1)) found.push(`beyond the page: ${named(element)}`);
      if (element.tagName === 'text' && (box.left < frame.left - 2 || box.right > frame.right + 2)) found.push(`beyond its picture: ${named(element)}`);
      const style = svg ? null : getComputedStyle(element);
      const isCut = style && style.overflowX !== 'visible' && style.overflowX !== 'auto' && element.scrollWidth > element.clientWidth + 1;
      if (isCut && !element.classList.contains('hidden')) found.push(`cut off: ${named(element)}`);
    }
    return found;
  });

for (const width of WIDTHS) {
  test(`nothing is cut or too wide at ${width} px`, async (t) => {
    const { page, close } = await opened({ viewport: { width, height: 900 } });
    if (process.env.SHOTS) await page.screenshot({ path: join(process.env.SHOTS, `report_${width}.png`) });
    await unfold(page);
    const found = await misfits(page);
    t.diagnostic(`${await page.evaluate(() => document.querySelectorAll('main *').length)} elements`);
    assert.deepEqual(found.slice(0, 8), []);
    await close();
  });
}

test('a planted overflow and a planted cut are found', async () => {
  const { page, close } = await opened({ viewport: { width: 1080, height: 900 } });
  const found = async (html) => {
    await page.evaluate((html) => (document.querySelector('main header').insertAdjacentHTML('beforeend', html)), html);
    const all = await misfits(page);
    await page.evaluate(() => document.querySelector('main header').lastElementChild.remove());
    return all.join('\n');
  };
  assert.match(await found('<div style="width:3000px">wide</div>'), /beyond the page/);
  assert.match(await found('<div style="width:20px;overflow:hidden;white-space:nowrap">far too long</div>'), /cut off/);
  assert.match(await found('<svg class="plot" width="50" height="20"><text x="-40" y="10">outside</text></svg>'), /beyond its picture/);
  assert.equal(await found('<div>fits</div>'), '');
  await close();
});

for (const colorScheme of ['light', 'dark']) {
  test(`axe finds nothing serious, ${colorScheme}`, async () => {
    const { page, close } = await opened({ viewport: { width: 1080, height: 900 }, colorScheme });
    await page.addScriptTag({ path: AXE });
    const serious = await page.evaluate(async () => {
      const { violations } = await window.axe.run(document, { resultTypes: ['violations'] });
      const bad = violations.filter(({ impact }) => impact === 'serious' || impact === 'critical');
      return bad.map(({ id, nodes }) => `${id}: ${nodes.length} times, such as ${nodes[0].html.slice(0, 200)} ${nodes[0].failureSummary ?? ''}`);
    });
    assert.deepEqual(serious, []);
    await close();
  });
}

test('the overview is searched, filtered and sorted, and is whole without the script', async () => {
  const { page, complaints, requests, close } = await opened();
  const shown = () => page.evaluate(() => [...document.querySelectorAll('#overview tbody tr')].filter((row) => !row.hidden).map((row) => row.querySelector('a').textContent));
  const all = await shown();
  await page.fill('#search', all.at(-1).toUpperCase());
  assert.deepEqual(await shown(), [all.at(-1)]);
  await page.fill('#search', '');
  await page.selectOption('#state', '2');
  assert.deepEqual(await shown(), await page.evaluate(() => [...document.querySelectorAll('tr[data-state="2"] a')].map((link) => link.textContent)));
  await page.selectOption('#state', '');
  await page.click('#overview th:nth-child(2) button');
  assert.deepEqual(await shown(), all.toSorted((a, b) => a.localeCompare(b)));
  await page.click('#overview th:nth-child(2) button');
  assert.deepEqual(await shown(), all.toSorted((a, b) => b.localeCompare(a)));
  assert.deepEqual(complaints, []);
  assert.ok(requests.every((url) => url.startsWith('file:') || url.startsWith('data:')), 'nothing is asked of the network');
  await close();
  const plain = await opened({ javaScriptEnabled: false });
  assert.equal(await plain.page.locator('#overview tbody tr').count(), all.length);
  assert.equal(await plain.page.locator('#finder').isVisible(), false);
  await plain.close();
});
