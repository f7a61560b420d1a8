// The coherent lobe's profiles as sums of Gaussians, whose means over an ellipse the shader knows in closed form. The same fit as the
// program's: least squares relative to the profile.

import type { FloatImage } from './pack';

/** As many as the shader sums. */
export const GAUSSIANS = 8;
/** The outer radius in widths of the widest one, and the widest over the narrowest. */
const REACH = 4.55;
const WIDTHS_RATIO = 2;
/** Share of a profile's peak from which on differences count absolutely. */
const FLOOR = 1e-8;

/** Factors of the Gaussians for each row of the lobe. */
export function lobeGaussians({ width, height, texels }: FloatImage): FloatImage {
  const shapes = Array.from({ length: GAUSSIANS }, (_, k) => {
    const over = REACH * WIDTHS_RATIO ** (k / (GAUSSIANS - 1));
    return Float64Array.from({ length: width }, (_, column) => Math.exp(-(((over * column) / Math.max(1, width - 1)) ** 2)));
  });
  const out = new Float32Array(4 * GAUSSIANS * height);
  for (let row = 0; row < height; row++) {
    for (let c = 0; c < 3; c++) {
      const profile = Float64Array.from({ length: width }, (_, column) => texels[4 * (row * width + column) + c]);
      fitted(shapes, profile).forEach((factor, k) => (out[4 * (row * GAUSSIANS + k) + c] = factor));
    }
  }
  return { width: GAUSSIANS, height, texels: out };
}

const dot = (a: Float64Array, b: Float64Array): number => a.reduce((sum, value, i) => sum + value * b[i], 0);

/** By orthogonalising twice. */
function fitted(shapes: Float64Array[], profile: Float64Array): number[] {
  const peak = profile.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  if (peak === 0) return shapes.map(() => 0);
  const weights = profile.map((value) => 1 / (Math.abs(value) + FLOOR * peak));
  const columns: Float64Array[] = [];
  const triangle = shapes.map(() => shapes.map(() => 0));
  shapes.forEach((shape, k) => {
    const column = shape.map((value, i) => weights[i] * value);
    for (let pass = 0; pass < 2; pass++) {
      columns.forEach((other, j) => {
        const share = dot(other, column);
        triangle[j][k] += share;
        for (let i = 0; i < column.length; i++) column[i] -= share * other[i];
      });
    }
    const length = Math.sqrt(dot(column, column));
    triangle[k][k] = length;
    // Of a profile with fewer texels than Gaussians some add nothing.
    columns.push(column.map((value) => (length > 1e-12 ? value / length : 0)));
  });
  const weighed = profile.map((value, i) => value * weights[i]);
  const found = shapes.map(() => 0);
  for (let k = GAUSSIANS - 1; k >= 0; k--) {
    if (!(triangle[k][k] > 1e-12)) continue;
    let known = 0;
    for (let j = k + 1; j < GAUSSIANS; j++) known += triangle[k][j] * found[j];
    found[k] = (dot(columns[k], weighed) - known) / triangle[k][k];
  }
  return found;
}
