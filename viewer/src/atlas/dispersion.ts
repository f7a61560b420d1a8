// A material's index by wavelength: monotone cubics between the wavelengths of its table.

import type { Dispersion, Specimen } from './specimen';
import { materialFields } from './pack';

/** Kind of material and index at a wavelength in nm; null outside the material's table. */
export function materialAt(specimen: Specimen, nm: number): { material: number; index_n: number; index_k: number } | null {
  const dispersion = specimen.spectral?.dispersion;
  if (!dispersion) return materialFields(specimen.optics.material);
  const index = indexAt(dispersion, nm);
  if (!index) return null;
  const [n, k] = index;
  return materialFields(k === 0 ? { dielectric: { n } } : { conductor: { n, k } });
}

/** n and k at a wavelength in nm; null outside the table. */
export function indexAt({ wavelength_nm: at, n, k }: Dispersion, nm: number): [number, number] | null {
  const last = at.length - 1;
  if (!(nm >= at[0] && nm <= at[last])) return null;
  let first = 0;
  while (first < last - 1 && at[first + 1] <= nm) first++;
  return [monotoneCubic(at, n, first, nm), monotoneCubic(at, k, first, nm)];
}

function monotoneCubic(at: number[], values: number[], first: number, x: number): number {
  const width = at[first + 1] - at[first];
  const t = (x - at[first]) / width;
  const s = 1 - t;
  const [da, db] = [width * slope(at, values, first), width * slope(at, values, first + 1)];
  const [a, b] = [values[first], values[first + 1]];
  return a * (1 + 2 * t) * s * s + b * t * t * (3 - 2 * t) + da * t * s * s - db * t * t * s;
}

function slope(at: number[], values: number[], knot: number): number {
  const secant = (i: number) => (values[i + 1] - values[i]) / (at[i + 1] - at[i]);
  if (knot === 0) return secant(0);
  if (knot === at.length - 1) return secant(knot - 1);
  const [before, after] = [secant(knot - 1), secant(knot)];
  if (before * after <= 0) return 0;
  const [left, right] = [at[knot] - at[knot - 1], at[knot + 1] - at[knot]];
  const [p, q] = [2 * right + left, right + 2 * left];
  return (p + q) / (p / before + q / after);
}
