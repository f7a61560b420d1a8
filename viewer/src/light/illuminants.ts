// Lights by their spectra, and the CIE 1931 2 degree observer: what turns a spectrum into XYZ.

import type { StoredIlluminant } from '../atlas/specimen';
import cie from '../generated/cie.json';

export type Xyz = [number, number, number];

/** A light: its relative power at a wavelength in nm, or lines. */
export interface Illuminant {
  label: string;
  power?: (nm: number) => number;
  lines?: { nm: number; power: number }[];
}

/** Wavelengths and what each adds to X, Y and Z; the Y sum to 1. */
export interface Quadrature {
  nm: number[];
  weights: Xyz[];
}

function table(values: number[], firstNm: number, stepNm: number, nm: number): number {
  const position = (nm - firstNm) / stepNm;
  if (!(position >= 0 && position <= values.length - 1)) return 0;
  const index = Math.min(Math.floor(position), values.length - 2);
  return values[index] + (position - index) * (values[index + 1] - values[index]);
}

/** The observer's X, Y and Z at a wavelength in nm. */
export function observer(nm: number): Xyz {
  const position = nm - cie.observerFirstNm;
  const last = cie.observer.length - 1;
  if (!(position >= 0 && position <= last)) return [0, 0, 0];
  const index = Math.min(Math.floor(position), last - 1);
  const share = position - index;
  const [low, high] = [cie.observer[index], cie.observer[index + 1]];
  return [0, 1, 2].map((c) => low[c] + share * (high[c] - low[c])) as Xyz;
}

/** Planck's law, relative. */
const planck = (nm: number, kelvin: number): number => nm ** -5 / Math.expm1(1.4387769e7 / (nm * kelvin));

const incandescent = (nm: number): number => {
  const exponential = (at: number) => Math.expm1(1.435e7 / (2848 * at));
  return (100 * (560 / nm) ** 5 * exponential(560)) / exponential(nm);
};

/**
 * A white LED in two bell curves: the blue chip at 450 nm and its phosphor about 560 nm. A plain model of the usual kind,
 * not a standard's table.
 */
const whiteLed = (nm: number): number => {
  const bell = (centre: number, below: number, above: number) =>
    Math.exp(-0.5 * ((nm - centre) / (nm < centre ? below : above)) ** 2);
  return bell(450, 9, 11) + 0.62 * bell(560, 42, 65);
};

/**
 * The sun at a height above the horizon: a black body of 5778 K behind air that scatters as the inverse fourth power of the
 * wavelength (Rayleigh, optical depth 0.0088 at 1 um) along the path of Kasten and Young.
 */
export const sunAt = (height_deg: number) => {
  const path = 1 / (Math.sin((height_deg * Math.PI) / 180) + 0.50572 * (height_deg + 6.07995) ** -1.6364);
  return (nm: number): number => {
    const um = nm / 1000;
    return planck(nm, 5778) * Math.exp(-path * 0.008735 * um ** -4.08) * 1e15;
  };
};

export type IlluminantName = 'tables' | 'D65' | 'A' | 'E' | 'F11' | 'LED' | 'laser' | 'sun';

/** A light by its name; `nm` is the laser's wavelength and `height_deg` the sun's height. */
export function illuminant(name: Exclude<IlluminantName, 'tables'>, nm: number, height_deg: number): Illuminant {
  switch (name) {
    case 'D65':
      return { label: 'D65, daylight', power: (at) => table(cie.d65, cie.d65FirstNm, cie.stepNm, at) };
    case 'A':
      return { label: 'A, incandescent lamp', power: incandescent };
    case 'E':
      return { label: 'E, equal power', power: () => 1 };
    case 'F11':
      return { label: 'F11, fluorescent lamp', power: (at) => table(cie.fluorescent[10], cie.fluorescentFirstNm, cie.stepNm, at) };
    case 'LED':
      return { label: 'white LED', power: whiteLed };
    case 'sun':
      return { label: `sun ${height_deg}° high`, power: sunAt(height_deg) };
    case 'laser':
      return { label: `laser, ${nm} nm`, lines: [{ nm, power: 1 }] };
  }
}

/** Wavelengths beside a place that share its light. */
const SHARERS = 6;

/**
 * `count` wavelengths evenly spaced in 1/λ, with weights: the light's spectrum times the observer's, taken every 0.25 nm and
 * dealt to the six wavelengths beside it, so that spectra are integrated as if a polynomial ran through their values.
 */
export function quadrature(light: Illuminant, [low, high]: [number, number], count: number): Quadrature {
  if (light.lines) {
    return normalised(
      light.lines.map((line) => line.nm),
      light.lines.map((line) => observer(line.nm).map((c) => c * line.power) as Xyz),
    );
  }
  const power = light.power ?? (() => 1);
  const [first, last] = [1 / high, 1 / low];
  const nm = Array.from({ length: count }, (_, j) => 1 / (first + (j / (count - 1)) * (last - first)));
  const weights: Xyz[] = nm.map(() => [0, 0, 0]);
  const sharers = Math.min(SHARERS, count);
  const steps = Math.ceil((high - low) / 0.25);
  const width = (high - low) / steps;
  for (let i = 0; i < steps; i++) {
    const at = low + (i + 0.5) * width;
    const position = ((1 / at - first) / (last - first)) * (count - 1);
    const start = Math.min(count - sharers, Math.max(0, Math.floor(position) - sharers / 2 + 1));
    const density = power(at) * width;
    const colour = observer(at).map((c) => c * density);
    cardinals(position - start, sharers).forEach((share, k) => {
      for (let channel = 0; channel < 3; channel++) weights[start + k][channel] += share * colour[channel];
    });
  }
  return normalised(nm, weights);
}

/** Values at x of the polynomials that are 1 at one of 0, 1, … count - 1 and 0 at the others. */
function cardinals(x: number, count: number): number[] {
  return Array.from({ length: count }, (_, k) => {
    let value = 1;
    for (let j = 0; j < count; j++) if (j !== k) value *= (x - j) / (k - j);
    return value;
  });
}

function normalised(nm: number[], weights: Xyz[]): Quadrature {
  const luminous = weights.reduce((sum, weight) => sum + weight[1], 0);
  return { nm, weights: weights.map((weight) => weight.map((c) => c / luminous) as Xyz) };
}

/** The light that an atlas's tables are made for, as specimen.json writes it. */
export function illuminantOf(stored: StoredIlluminant): Illuminant {
  if (typeof stored === 'string') {
    const name = stored.toUpperCase();
    if (name === 'D65' || name === 'A' || name === 'E') return illuminant(name, 0, 0);
    throw new Error(`the light ${stored} is not known to this page`);
  }
  if ('lines' in stored) {
    const lines = stored.lines.map(({ wavelength_nm, power }) => ({ nm: wavelength_nm, power }));
    return { label: `lines at ${lines.map(({ nm }) => nm).join(', ')} nm`, lines };
  }
  if ('f' in stored) {
    const values = cie.fluorescent[stored.f - 1];
    return { label: `F${stored.f}`, power: (at) => table(values, cie.fluorescentFirstNm, cie.stepNm, at) };
  }
  const { wavelength_nm: at, power } = stored.tabulated;
  return {
    label: `a light of ${at.length} wavelengths from ${at[0]} nm`,
    power: (nm) => {
      const above = at.findIndex((one) => one >= nm);
      if (above < 0 || nm < at[0]) return 0;
      if (at[above] === nm) return power[above];
      return power[above - 1] + ((nm - at[above - 1]) / (at[above] - at[above - 1])) * (power[above] - power[above - 1]);
    },
  };
}

/**
 * How many wavelengths resolve the orders: along a direction the power varies in 1/λ as fast as the coherence window and the
 * relief let it, as pulses of this deviation; four thirds of a wavelength fall on each.
 */
export function wavelengthsNeeded(
  { sigma_nm, half_height_range_nm, shortest_nm, longest_nm }: { sigma_nm: number; half_height_range_nm: number; shortest_nm: number; longest_nm: number },
  radius: number,
): number {
  const window = Math.SQRT2 * 2 * Math.PI * sigma_nm * radius;
  const relief = 2 * Math.PI * half_height_range_nm * 2;
  const span = 1 / shortest_nm - 1 / longest_nm;
  return Math.min(1024, Math.max(48, Math.ceil((4 / 3) * span * Math.hypot(window, relief))));
}

/** XYZ of a spectrum sampled at the quadrature's wavelengths. */
export function toXyz({ weights }: Quadrature, values: ArrayLike<number>): Xyz {
  const sum: Xyz = [0, 0, 0];
  weights.forEach((weight, i) => weight.forEach((w, c) => (sum[c] += w * values[i])));
  return sum;
}
