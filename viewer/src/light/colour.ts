// Small colour sums of the page: patches, chromaticities, dominant wavelengths. Pictures are coloured in shaders.

import { observer, type Xyz } from './illuminants';

/** Linear sRGB of XYZ (IEC 61966-2-1); components may be negative. */
export function linearSrgb([x, y, z]: Xyz): [number, number, number] {
  return [
    3.2404542 * x - 1.5371385 * y - 0.4985314 * z,
    -0.969266 * x + 1.8760108 * y + 0.041556 * z,
    0.0556434 * x - 0.2040259 * y + 1.0572252 * z,
  ];
}

/** The transfer function of sRGB, for [0, 1]. */
export const encodeSrgb = (linear: number): number =>
  linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;

/** A patch's colour for CSS: as bright as the display allows, paled until it fits. */
export function patchCss(xyz: Xyz): string {
  if (!(xyz[1] > 0)) return 'rgb(0, 0, 0)';
  const rgb = linearSrgb(xyz.map((c) => c / xyz[1]) as Xyz);
  const least = Math.min(...rgb);
  const inside = least < 0 ? rgb.map((c) => (c - least) / (1 - least)) : rgb;
  const peak = Math.max(...inside);
  const [r, g, b] = inside.map((c) => Math.round(255 * encodeSrgb(c / peak)));
  return `rgb(${r}, ${g}, ${b})`;
}

/** x and y of a colour; null for black. */
export function chromaticity([x, y, z]: Xyz): [number, number] | null {
  const sum = x + y + z;
  return sum > 0 ? [x / sum, y / sum] : null;
}

/** The dominant wavelength in nm seen from a white, with the purity; `complementary` where the colour is a purple. */
export interface Dominant {
  nm: number;
  purity: number;
  complementary: boolean;
}

/** Null for colours that are the white itself, or black. */
export function dominantWavelength(xyz: Xyz, white: Xyz): Dominant | null {
  const [at, from] = [chromaticity(xyz), chromaticity(white)];
  if (!at || !from) return null;
  const towards = [at[0] - from[0], at[1] - from[1]];
  const distance = Math.hypot(...towards);
  if (distance < 1e-4) return null;
  const found = meetLocus(from, towards) ?? meetLocus(from, [-towards[0], -towards[1]]);
  if (!found) return null;
  const complementary = meetLocus(from, towards) === null;
  return { nm: found.nm, purity: complementary ? NaN : Math.min(1, 1 / found.factor), complementary };
}

/** Where a ray from the white meets the line of pure colours, as a factor on the ray's length. */
function meetLocus(from: [number, number], [dx, dy]: number[]): { nm: number; factor: number } | null {
  for (let nm = 380; nm < 700; nm++) {
    const [a, b] = [chromaticity(observer(nm)), chromaticity(observer(nm + 1))];
    if (!a || !b) continue;
    const [ex, ey] = [b[0] - a[0], b[1] - a[1]];
    const determinant = dx * -ey + ex * dy;
    if (Math.abs(determinant) < 1e-12) continue;
    const [fx, fy] = [a[0] - from[0], a[1] - from[1]];
    const factor = (fx * -ey + ex * fy) / determinant;
    const share = (dx * fy - dy * fx) / determinant;
    if (factor > 0 && share >= 0 && share < 1) return { nm: nm + share, factor };
  }
  return null;
}

/** sRGB of a wavelength for drawing axes, dimmed towards the ends of sight. */
export function wavelengthCss(nm: number): string {
  const xyz = observer(nm);
  const dim = Math.min(1, Math.max(0.15, xyz[0] + xyz[1] + xyz[2]));
  const rgb = linearSrgb(xyz);
  const least = Math.min(0, ...rgb);
  const inside = rgb.map((c) => c - least);
  const peak = Math.max(...inside);
  const [r, g, b] = inside.map((c) => Math.round(255 * encodeSrgb((c / peak) * dim)));
  return `rgb(${r}, ${g}, ${b})`;
}
