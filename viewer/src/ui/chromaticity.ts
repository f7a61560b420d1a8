// The spot's colour among all colours: the CIE 1931 diagram with the line of pure wavelengths and the display's gamut.

import type { Engine } from '../engine';
import { chromaticity } from '../light/colour';
import { observer } from '../light/illuminants';
import type { State } from '../state';
import { h, svg } from './dom';
import { type Answer, type View } from './views';

const REC709 = [[0.64, 0.33], [0.3, 0.6], [0.15, 0.06]];
const W = 0.8;
const H = 0.9;

const place = (x: number, y: number): string => `${x.toFixed(4)} ${(H - y).toFixed(4)}`;

function locus(): string {
  const points: string[] = [];
  for (let nm = 390; nm <= 700; nm += 2) {
    const xy = chromaticity(observer(nm));
    if (xy) points.push(place(...xy));
  }
  return `M${points.join('L')}Z`;
}

export function chromaticityView(): View {
  const trail = svg('path', { className: 'trail' });
  const spot = svg('circle', { r: 0.014, className: 'marker' });
  const white = svg('circle', { r: 0.006, className: 'white' });
  const ticks = [480, 500, 520, 560, 600].map((nm) => {
    const [x, y] = chromaticity(observer(nm)) ?? [0, 0];
    return svg('text', { x: x + (nm < 520 ? -0.012 : 0.012), y: H - y + (nm === 520 ? -0.012 : 0.01), 'text-anchor': nm < 520 ? 'end' : 'start' }, String(nm));
  });
  const diagram = svg(
    'svg',
    { viewBox: `-0.06 -0.02 ${W + 0.1} ${H + 0.05}`, role: 'img' },
    svg('path', { d: `M0 0V${H}H${W}`, className: 'axis' }),
    svg('path', { d: locus(), className: 'locus' }),
    svg('path', { d: `M${REC709.map(([x, y]) => place(x, y)).join('L')}Z`, className: 'gamut' }),
    ...ticks,
    trail,
    white,
    spot,
  );
  const words = h('p', { className: 'caption' });
  const element = h('div', { className: 'chromaticity', title: 'Chromaticity x, y. The curve holds pure wavelengths, the triangle what an sRGB display shows, the thin line the colours over the plane of incidence.' }, diagram, words);
  return {
    element,
    update: (_state: State, _engine: Engine, answer: Answer | null) => {
      const xy = answer?.xyz ? chromaticity(answer.xyz) : null;
      spot.style.display = xy ? '' : 'none';
      if (xy) spot.setAttribute('transform', `translate(${xy[0]} ${H - xy[1]})`);
      const from = answer ? chromaticity(answer.white) : null;
      white.style.display = from ? '' : 'none';
      if (from) white.setAttribute('transform', `translate(${from[0]} ${H - from[1]})`);
      trail.setAttribute('d', answer ? path(answer) : '');
      words.textContent = xy ? `x ${xy[0].toFixed(3)}, y ${xy[1].toFixed(3)}` : '';
      diagram.setAttribute('aria-label', `Chromaticity diagram; the spot at ${words.textContent || 'no colour'}`);
    },
  };
}

/** Chromaticities over the plane of incidence, as one line. */
function path({ plane }: Answer): string {
  const points = plane.map((xyz) => (xyz ? chromaticity(xyz) : null)).filter((xy) => xy !== null);
  return points.length ? `M${points.map(([x, y]) => place(x, y)).join('L')}` : '';
}
