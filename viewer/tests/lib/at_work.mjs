// The program that serves the page, and the browser that opens it.
import { spawn, execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

export const ROOT = resolve(dirname(fileURLToPath(import.meta.url)), '../../..');
const target = process.env.CARGO_TARGET_DIR ?? join(ROOT, 'target');
export const PROGRAM = process.env.DIFFRACTION_ATLAS ?? join(target, 'release/diffraction-atlas');
/** The atlas of viewer/tests/pictures.toml. */
export const ATLAS = process.env.ATLAS ?? join(ROOT, 'out/atlas/viewer');

const CHROMIUM = process.env.CHROMIUM ?? ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(existsSync);
// WebGL 2 without a GPU, and nothing that asks the network for anything.
const FLAGS = [
  '--no-sandbox', '--disable-gpu', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync', '--disable-dev-shm-usage',
];

/** Calls the program; what it wrote to stdout. */
export const call = (...words) => execFileSync(PROGRAM, words, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit'] });

/** Starts `view`; its address, and how it is ended. */
export async function serve(atlas) {
  const child = spawn(PROGRAM, ['--quiet', 'view', atlas, '--no-open'], { stdio: ['ignore', 'pipe', 'inherit'] });
  const url = await new Promise((found, failed) => {
    let text = '';
    child.stdout.on('data', (data) => {
      text += data;
      if (text.includes('\n')) found(text.trim());
    });
    child.once('exit', (code) => failed(new Error(`view ended with ${code}: ${text}`)));
    child.once('error', failed);
  });
  const stop = () =>
    new Promise((ended) => {
      child.removeAllListeners('exit');
      child.once('exit', ended);
      child.kill('SIGINT');
    });
  return { url, stop };
}

export const browse = () => chromium.launch({ executablePath: CHROMIUM, headless: true, args: FLAGS });

/** Opens an address in a fresh page, once it is ready, and notes every complaint and every request. */
export async function open(browser, address, { ready = true, ...options } = {}) {
  const context = await browser.newContext({ viewport: { width: 1400, height: 900 }, ...options });
  const page = await context.newPage();
  const [complaints, requests] = [[], []];
  page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('request', (request) => requests.push(request.url()));
  await page.goto(address);
  if (ready) await page.evaluate(() => window.atlasViewer.ready);
  return { page, complaints, requests, close: () => context.close() };
}

/** The whole picture of a state as RGB. */
export async function picture(page, change) {
  const { width, height, text } = await page.evaluate(async (wanted) => {
    const { atlasViewer } = window;
    atlasViewer.set(wanted);
    await atlasViewer.frame();
    const { width, height, data } = atlasViewer.pixels();
    let text = '';
    for (let i = 0; i < data.length; i += 4096) text += String.fromCharCode(...data.subarray(i, i + 4096));
    return { width, height, text: btoa(text) };
  }, change);
  const rgba = Buffer.from(text, 'base64');
  const rgb = new Uint8Array(3 * width * height);
  for (let i = 0; i < width * height; i++) rgb.set(rgba.subarray(4 * i, 4 * i + 3), 3 * i);
  return { width, height, rgb };
}

/** Drops a file on the page. */
export const drop = (page, file) =>
  page.evaluate(
    ([name, text]) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))], name));
      document.getElementById('app').dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    },
    [basename(file), readFileSync(file).toString('base64')],
  );
