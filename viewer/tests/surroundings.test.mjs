// The page's snake in a room: its own body stands in the light's way, as in the program's picture.
//
//   diffraction-atlas run viewer/tests/pictures.toml && node --test viewer/tests/surroundings.test.mjs
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { ATLAS, ROOT, browse, drop, open, picture, serve } from './lib/at_work.mjs';
import { readPng } from './lib/png.mjs';

const SPECIMEN = 'corn_snake_like';
const version = join(ATLAS, readFileSync(join(ATLAS, 'latest'), 'utf8').trim());
const scene = JSON.parse(readFileSync(join(version, 'report.json'), 'utf8')).specimens[0].scenes.find(({ name }) => name === 'room');
const published = readPng(readFileSync(join(version, SPECIMEN, 'scenes/room.png')));
const BLOCK = 6;
let browser, served;

before(async () => {
  [browser, served] = [await browse(), await serve(ATLAS)];
});
after(async () => {
  await browser?.close();
  await served?.stop();
});

/** Means over blocks of pixels, in which the grain of random directions averages out. */
function blocks({ width, height, rgb }) {
  const out = [];
  for (let y = 0; y < height; y += BLOCK) {
    for (let x = 0; x < width; x += BLOCK) {
      let sum = 0;
      for (let i = 0; i < BLOCK * BLOCK; i++) {
        const at = 3 * ((y + Math.floor(i / BLOCK)) * width + x + (i % BLOCK));
        sum += rgb[at] + rgb[at + 1] + rgb[at + 2];
      }
      out.push(sum);
    }
  }
  return out;
}

/** How far a picture is from the program's, as a share of the latter. */
function apart(found) {
  const [mine, theirs] = [blocks(found), blocks(published)];
  const sum = (values) => values.reduce((total, value) => total + value, 0);
  return sum(mine.map((value, i) => Math.abs(value - theirs[i]))) / sum(theirs);
}

async function room(change = {}, spoil = () => undefined) {
  const { page, complaints, close } = await open(browser, 'about:blank', { ready: false });
  await page.addInitScript(spoil);
  await page.goto(served.url);
  await page.evaluate(() => window.atlasViewer.ready);
  await page.evaluate(() => window.atlasViewer.set({ shape: 'snake', size_px: 8 }));
  await drop(page, join(ROOT, 'viewer/tests/room.exr'));
  await page.waitForFunction(() => window.atlasViewer.state().environment === 'own');
  const lights = [{ direction: [0, 0, 1], diameter_deg: 0, irradiance: 0 }];
  const exposure = Math.log2(scene.exposure / Math.PI);
  const found = await picture(page, { specimen: SPECIMEN, size_px: published.width, environment_samples: 128, pixel_samples: 1, light_samples: 1, lights, interpolation: 'bilinear', look_ups: 'points', exposure, ...change });
  assert.deepEqual(complaints, []);
  await close();
  return apart(found);
}

test('the snake in a room is the program’s, shadows and all', async (t) => {
  const right = await room();
  const open = await room({}, () => {
    // Lets every ray of the surroundings through.
    const { shaderSource } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.shaderSource = function (shader, text) {
      shaderSource.call(this, shader, text.replace('face_normal, corners, side, distance) ? 0.0 : 1.0', 'face_normal, corners, side, distance) ? 1.0 : 1.0'));
    };
  });
  t.diagnostic(`off by ${(100 * right).toFixed(1)} % of the light; without shadows ${(100 * open).toFixed(0)} %`);
  assert.ok(right < 0.08, `${right}`);
  assert.ok(open > 3 * right, `shadows that are missing go unseen: ${open}`);
});
