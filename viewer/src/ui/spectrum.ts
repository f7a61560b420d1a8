// The spectrum at the spot: f by wavelength, with its colour.

import uPlot from 'uplot';
import type { MeasuredSpectrum } from '../atlas/measured';
import type { Engine } from '../engine';
import { chromaticity, patchCss, wavelengthCss } from '../light/colour';
import type { State } from '../state';
import { h, shown } from './dom';
import type { Answer, View } from './views';

/** Wavelengths of the plot, in nm. */
export function plotWavelengths(shortest: number, longest: number): number[] {
  return Array.from({ length: 201 }, (_, i) => shortest + (i / 200) * (longest - shortest));
}

export interface SpectrumView extends View {
  /** Offers measured spectra; none hides the choice. */
  offer(measured: MeasuredSpectrum[]): void;
  /** Called with the spectrum that was chosen, or null for the spot. */
  onChoose: (measured: MeasuredSpectrum | null) => void;
}

export function spectrumView(): SpectrumView {
  const plotBox = h('div', { className: 'plot', role: 'img' });
  const patch = h('div', { className: 'patch' });
  const facts = h('dl', { className: 'facts' });
  const words = h('p', { className: 'caption' });
  const choice = h('select', { 'aria-label': 'Measured spectra', title: 'Measured spectra of the specimen: the page then asks the directions that they were measured at.' });
  choice.hidden = true;
  let offered: MeasuredSpectrum[] = [];
  const element = h('div', { className: 'spectrum' }, choice, plotBox, h('div', { className: 'colour' }, patch, facts), words);
  let plot: uPlot | null = null;
  let theme = '';

  const makePlot = (): uPlot => {
    const style = getComputedStyle(element);
    const [text, line, accent, strong] = ['--muted', '--line', '--accent', '--text'].map((name) => style.getPropertyValue(name).trim());
    const axis = { stroke: text, grid: { stroke: line, width: 1 }, ticks: { stroke: line, width: 1 }, font: '11px system-ui, sans-serif' };
    return new uPlot(
      {
        width: plotBox.clientWidth || 340,
        height: plotBox.clientHeight || 168,
        legend: { show: false },
        cursor: { y: false, points: { size: 6 } },
        scales: { x: { time: false }, y: { range: (_, low, high) => [Math.min(0, low), high > 0 ? high * 1.08 : 1] } },
        axes: [
          { ...axis, size: 34, values: (_, ticks) => ticks.map((tick) => `${tick}`), label: 'wavelength, nm', labelSize: 16, labelFont: '11px system-ui, sans-serif' },
          { ...axis, size: 52, values: (_, ticks) => ticks.map((tick) => shown(tick, 2)) },
        ],
        series: [
          {},
          { stroke: accent, width: 1.5, fill: rainbow, points: { show: false } },
          { width: 0, points: { show: true, size: 6, width: 1.5, stroke: strong, fill: 'transparent' } },
        ],
      },
      [[], [], []],
      plotBox,
    );
  };
  new ResizeObserver(() => plot?.setSize({ width: plotBox.clientWidth, height: plotBox.clientHeight })).observe(plotBox);

  const view: SpectrumView = {
    element,
    onChoose: () => undefined,
    offer: (measured) => {
      offered = measured;
      choice.hidden = measured.length === 0;
      const words = ({ angles_deg: [ti, pi, tr, pr] }: MeasuredSpectrum) => `measured: light ${ti}°, ${pi}° · viewer ${tr}°, ${pr}°`;
      choice.replaceChildren(h('option', { value: '' }, 'at the spot'), ...measured.map((one, i) => h('option', { value: String(i) }, words(one))));
    },
    update: (state: State, engine: Engine, answer: Answer | null) => {
      const now = document.documentElement.dataset.theme ?? '';
      if (plot && now !== theme) {
        plot.destroy();
        plot = null;
      }
      theme = now;
      plot ??= makePlot();
      const spectrum = answer?.spectrum;
      plotBox.hidden = !spectrum;
      if (spectrum) plot.setData([spectrum.nm, Array.from(spectrum.values, (v) => (Number.isNaN(v) ? null : v)), spectrum.measured] as uPlot.AlignedData);
      if (answer && !answer.chosen) choice.value = '';
      words.textContent = reason(state, engine, answer);
      words.hidden = words.textContent === '';
      patch.style.background = answer?.xyz ? patchCss(answer.xyz) : 'transparent';
      facts.replaceChildren(...facts_of(answer).flatMap(([term, value, title]) => [h('dt', { title }, term), h('dd', {}, value)]));
      plotBox.setAttribute('aria-label', `Spectrum at the spot. ${facts.textContent ?? ''}`);
    },
  };
  choice.addEventListener('change', () => view.onChoose(choice.value === '' ? null : offered[Number(choice.value)]));
  return view;
}

function reason(state: State, engine: Engine, answer: Answer | null): string {
  if (!engine.floats) return 'This browser cannot draw to 32-bit floats, so numbers are not to be had.';
  if (!answer) return 'Point at the surface to ask it for its spectrum.';
  if (!engine.loaded?.specimen.spectral) return 'This specimen has no spectral tables; its colour comes from those of XYZ.';
  if (!answer.spectrum) return 'Reading the spectral tables …';
  void state;
  return '';
}

function facts_of(answer: Answer | null): [string, string, string][] {
  const xyz = answer?.xyz;
  if (!answer || !xyz) return [['f', '–', 'The BRDF in 1/sr.']];
  const xy = chromaticity(xyz);
  const { dominant } = answer;
  const wave = dominant
    ? `${dominant.complementary ? 'c ' : ''}${dominant.nm.toFixed(0)} nm${dominant.complementary ? '' : `, ${(100 * dominant.purity).toFixed(0)} %`}`
    : '–';
  return [
    ['X Y Z', xyz.map((c) => shown(c, 3)).join('  '), 'The BRDF as CIE XYZ in 1/sr, under the light of the picture.'],
    ['x y', xy ? xy.map((c) => c.toFixed(3)).join('  ') : '–', 'Chromaticity, CIE 1931.'],
    ['dominant', wave, 'The pure wavelength of the same hue, and the excitation purity. "c" is the complementary wavelength of a purple.'],
  ];
}

/** The colours of the wavelengths below the curve. */
function rainbow(plot: uPlot): CanvasGradient {
  const { left, width } = plot.bbox;
  const gradient = plot.ctx.createLinearGradient(left, 0, left + width, 0);
  const [low, high] = [plot.scales.x.min ?? 380, plot.scales.x.max ?? 780];
  for (let i = 0; i <= 40; i++) {
    gradient.addColorStop(i / 40, wavelengthCss(low + (i / 40) * (high - low)).replace('rgb', 'rgba').replace(')', ', 0.75)'));
  }
  return gradient;
}
