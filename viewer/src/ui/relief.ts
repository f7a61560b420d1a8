// The height map, and its power spectrum with the frequencies that the geometry at the spot selects.

import type { Engine } from '../engine';
import { wavelengthCss } from '../light/colour';
import type { Specimen } from '../atlas/specimen';
import type { State } from '../state';
import { h, shown, svg } from './dom';
import type { Answer, View } from './views';

export function reliefView(): View {
  const heights = h('img', { alt: '', className: 'heights' });
  const heightsWords = h('p', { className: 'caption' });
  const image = h('img', { alt: '' });
  const marks = svg('svg', { viewBox: '-1 -1 2 2', 'aria-hidden': 'true' });
  const spectrum = h('div', { className: 'square' }, image, marks);
  const words = h('p', { className: 'caption' });
  const element = h(
    'div',
    { className: 'relief' },
    h('figure', { title: 'The scanned surface, seen from above.' }, heights, heightsWords),
    h('figure', { title: 'Spatial frequencies of the relief. The coloured line are those that send each wavelength from this light to this viewer: the grating equation. Bright spots under it are orders that are seen.' }, spectrum, words),
  );
  let shownName = '';
  let halfRange: number | null = null;

  const load = async (engine: Engine, specimen: Specimen): Promise<void> => {
    const { name } = specimen;
    const given = (await engine.viewerFile())?.heights?.[name];
    const listed = (path: string) => engine.index.files.some((file) => file.path === path);
    const path = given ?? (listed(`${name}/heights.png`) ? `${name}/heights.png` : null);
    const spectrumPath = listed(`${name}/spectrum.png`) ? `${name}/spectrum.png` : null;
    if (shownName !== name) return;
    halfRange = halfRangePerUm(specimen);
    await show(engine, heights, path, 'height map', heightsWords, sizes(specimen));
    heights.alt = `Height map of ${name}`;
    await show(engine, image, spectrumPath, 'power spectrum', words, '');
    image.alt = `Power spectrum of the heights of ${name}`;
    spectrum.hidden = image.hidden;
  };

  return {
    element,
    update: (_state: State, engine: Engine, answer: Answer | null) => {
      const specimen = engine.loaded?.specimen;
      if (specimen && specimen.name !== shownName) {
        shownName = specimen.name;
        halfRange = null;
        void load(engine, specimen);
      }
      if (image.hidden) return;
      marks.replaceChildren(...(answer && halfRange ? selected(answer, halfRange) : []));
      words.textContent = caption(answer, halfRange);
    },
  };
}

async function show(engine: Engine, image: HTMLImageElement, path: string | null, what: string, words: HTMLElement, text: string): Promise<void> {
  image.hidden = true;
  words.textContent = `This atlas holds no ${what} of the specimen.`;
  if (!path) return;
  try {
    image.src = await engine.files.url(path);
    await image.decode();
    image.hidden = false;
    words.textContent = text;
  } catch {
    words.textContent = `The atlas's picture ${path} cannot be read.`;
  }
}

function sizes({ provenance, statistics }: Specimen): string {
  const scan = provenance?.[0];
  const range = statistics?.[0]?.peak_to_valley_nm;
  const across = scan ? `${shown((scan.size[0] * scan.pitch_nm[0]) / 1000)} µm across` : '';
  return [across, range ? `${range.toFixed(0)} nm from lowest to highest` : ''].filter(Boolean).join(' · ');
}

/** How far the picture of the spectrum reaches in cycles per um: the rule that it was drawn by. */
export function halfRangePerUm({ provenance, statistics }: Specimen): number | null {
  const scan = provenance?.[0];
  if (!scan) return null;
  const periods = (statistics?.[0]?.dominant_periods ?? []).map(({ period_nm }) => period_nm).filter((nm) => nm > 0);
  const highest = Math.max(0, ...periods.map((nm) => 1e3 / nm));
  const limit = 500 / Math.max(...scan.pitch_nm);
  const shortest = Math.min(scan.size[0] * scan.pitch_nm[0], scan.size[1] * scan.pitch_nm[1]);
  return Math.min(limit, Math.max(8e3 / shortest, highest > 0 ? 3 * highest : limit / 2));
}

function caption(answer: Answer | null, halfRange: number | null): string {
  if (!halfRange) return 'This atlas does not say how large its scan is, so nothing is drawn over the spectrum.';
  const edge = `edge ${halfRange.toPrecision(3)} /µm`;
  if (!answer) return edge;
  const rho = Math.hypot(answer.wi[0] + answer.wo[0], answer.wi[1] + answer.wo[1]);
  if (rho < 0.02) return `${edge} · mirror direction: no frequency selected`;
  return `${edge} · selected: periods of ${(380 / rho).toFixed(0)} nm (violet) to ${(780 / rho).toFixed(0)} nm (red)`;
}

/** The line of frequencies (u, v) / wavelength, and circles at its ends. */
function selected({ wi, wo }: Answer, halfRange: number): SVGElement[] {
  const [u, v] = [-(wi[0] + wo[0]), -(wi[1] + wo[1])];
  const rho = Math.hypot(u, v);
  const place = (nm: number): [number, number] => [(1000 * u) / nm / halfRange, (-1000 * v) / nm / halfRange];
  const circles = [420, 550, 680].map((nm) => svg('circle', { r: (1000 * rho) / nm / halfRange, stroke: wavelengthCss(nm), className: 'selected' }));
  const dots: SVGElement[] = [];
  for (const side of [1, -1]) {
    for (let nm = 400; nm < 700; nm += 10) {
      const [[x1, y1], [x2, y2]] = [place(nm), place(nm + 10)];
      dots.push(svg('line', { x1: side * x1, y1: side * y1, x2: side * x2, y2: side * y2, stroke: wavelengthCss(nm), className: 'bright' }));
    }
  }
  return [...circles, ...dots];
}
