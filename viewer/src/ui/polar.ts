// The BRDF in the plane of incidence: one wedge for each viewing angle, in its own colour.

import { patchCss } from '../light/colour';
import type { Xyz } from '../light/illuminants';
import type { State } from '../state';
import { h, shown } from './dom';
import { degrees, PLANE_DEG, type Answer, type View } from './views';

/** Decades of the logarithmic plot. */
const DECADES = 5;

export function polarView(change: (change: Partial<State>) => void): View {
  const canvas = h('canvas', { role: 'img' });
  const log = h('input', { type: 'checkbox', onchange: () => change({ polar_log: log.checked }) });
  const words = h('p', { className: 'caption' });
  const element = h(
    'div',
    { className: 'polar', title: 'f against the viewing angle in the plane of incidence: the line comes from the light, the dashes point to the mirror direction.' },
    canvas,
    h('label', { className: 'toggle' }, log, h('span', {}, 'logarithmic')),
    words,
  );
  return {
    element,
    update: (state, _engine, answer) => {
      log.checked = state.polar_log;
      draw(canvas, words, state, answer);
    },
  };
}

function draw(canvas: HTMLCanvasElement, words: HTMLElement, state: State, answer: Answer | null): void {
  const dpr = Math.min(2, devicePixelRatio || 1);
  const width = canvas.clientWidth || 340;
  const height = Math.round(width * 0.54);
  if (canvas.width !== Math.round(width * dpr)) canvas.width = Math.round(width * dpr);
  if (canvas.height !== Math.round(height * dpr)) canvas.height = Math.round(height * dpr);
  const context = canvas.getContext('2d');
  if (!context) return;
  context.setTransform(dpr, 0, 0, dpr, 0, 0);
  context.clearRect(0, 0, width, height);
  const style = getComputedStyle(canvas);
  const text = style.getPropertyValue('--muted').trim();
  const [line, accent] = ['#ffffff2b', '#8cc4ff'];
  const [cx, cy, radius] = [width / 2, height - 16, Math.min(width / 2 - 30, height - 26)];
  frame(context, { cx, cy, radius, line, text });
  if (!answer) {
    words.textContent = '';
    return;
  }
  const values = answer.plane;
  const peak = Math.max(...values.map((xyz) => xyz?.[1] ?? 0), 1e-30);
  const reach = (xyz: Xyz | null) => {
    const share = Math.max(0, xyz?.[1] ?? 0) / peak;
    return radius * (state.polar_log ? Math.max(0, 1 + Math.log10(Math.max(share, 1e-30)) / DECADES) : share);
  };
  PLANE_DEG.forEach((angle, i) => {
    const xyz = values[i];
    const r = reach(xyz);
    if (!xyz || !(r > 0)) return;
    context.fillStyle = patchCss(xyz);
    context.beginPath();
    context.moveTo(cx, cy);
    context.arc(cx, cy, r, (angle - 90.4) * degrees, (angle - 89.6) * degrees);
    context.fill();
  });
  const theta = Math.atan2(Math.hypot(answer.wi[0], answer.wi[1]), answer.wi[2]) / degrees;
  ray(context, { cx, cy, radius }, -theta, accent, []);
  ray(context, { cx, cy, radius }, theta, accent, [3, 4]);
  words.textContent = `rim: Y = ${shown(peak, 3)} /sr${state.polar_log ? `, rings one decade apart` : ''}`;
  canvas.setAttribute('aria-label', `Polar plot of the BRDF in the plane of incidence; light at ${theta.toFixed(0)} degrees, brightest Y ${shown(peak, 3)} per steradian`);
}

interface Frame {
  cx: number;
  cy: number;
  radius: number;
}

function frame(context: CanvasRenderingContext2D, { cx, cy, radius, line, text }: Frame & { line: string; text: string }): void {
  // Dark in every theme: wedges have the colours of light.
  context.fillStyle = '#0b0d11';
  context.beginPath();
  context.arc(cx, cy, radius, Math.PI, 2 * Math.PI);
  context.fill();
  context.strokeStyle = line;
  context.lineWidth = 1;
  for (let ring = 1; ring <= DECADES; ring++) {
    context.beginPath();
    context.arc(cx, cy, (radius * ring) / DECADES, Math.PI, 2 * Math.PI);
    context.stroke();
  }
  context.fillStyle = text;
  context.font = '11px system-ui, sans-serif';
  context.textAlign = 'center';
  for (const angle of [-60, -30, 0, 30, 60]) {
    ray(context, { cx, cy, radius }, angle, line, []);
    const [sin, cos] = [Math.sin(angle * degrees), Math.cos(angle * degrees)];
    context.fillText(`${Math.abs(angle)}°`, cx + (radius + 13) * sin, cy - (radius + 6) * cos + 3);
  }
  context.beginPath();
  context.moveTo(cx - radius, cy);
  context.lineTo(cx + radius, cy);
  context.stroke();
}

function ray(context: CanvasRenderingContext2D, { cx, cy, radius }: Frame, angle: number, colour: string, dashes: number[]): void {
  context.save();
  context.strokeStyle = colour;
  context.setLineDash(dashes);
  context.beginPath();
  context.moveTo(cx, cy);
  context.lineTo(cx + radius * Math.sin(angle * degrees), cy - radius * Math.cos(angle * degrees));
  context.stroke();
  context.restore();
}
