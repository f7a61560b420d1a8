// Values of a square table to the coefficients of the cubic B-spline through them: what four linear fetches of the shader want in
// place of values. The same filter as the program's.

/** The pole of the filter, and on how many texels it starts. */
const POLE = Math.sqrt(3) - 2;
const REACH = 28;

/** Texels beyond the rim of the disc from which on values are held: the step to zero there must not ring into the disc. */
const HELD_TEXELS = 2;

/** For each texel the one whose value stands there: itself, or beyond the rim of the disc one at it. */
export function heldTexels(size: number): Uint32Array {
  const middle = 0.5 * (size - 1);
  const limit = middle + HELD_TEXELS;
  const out = new Uint32Array(size * size);
  for (let row = 0, i = 0; row < size; row++) {
    for (let column = 0; column < size; column++, i++) {
      const [y, x] = [row - middle, column - middle];
      out[i] = i;
      if (x * x + y * y <= limit * limit) continue;
      const radius = Math.hypot(x, y);
      const at = (v: number) => Math.min(size - 1, Math.max(0, Math.round(middle + (v * limit) / radius)));
      out[i] = at(y) * size + at(x);
    }
  }
  return out;
}

/** In place: the coefficients of a square table of values. */
export function toCoefficients(table: Float64Array, size: number): void {
  const mirrored = mirrors(size);
  for (let row = 0; row < size; row++) filter(table, row * size, 1, size, mirrored);
  for (let column = 0; column < size; column++) filter(table, column, size, size, mirrored);
}

/** Texels at which the filter starts, and what they count: those of a line that goes on mirrored at its ends. */
function mirrors(count: number): { texel: number; share: number }[] {
  const period = Math.max(1, 2 * (count - 1));
  return Array.from({ length: 2 * REACH + 1 }, (_, k) => {
    const folded = k % period;
    return { texel: Math.min(folded, period - folded), share: POLE ** k };
  });
}

function filter(line: Float64Array, start: number, step: number, count: number, mirrored: { texel: number; share: number }[]): void {
  if (count < 2) return;
  let first = 0;
  for (const { texel, share } of mirrored) first += share * line[start + texel * step];
  line[start] = first;
  const last = start + (count - 1) * step;
  for (let at = start + step; at <= last; at += step) line[at] += POLE * line[at - step];
  line[last] = (POLE / (POLE * POLE - 1)) * (line[last] + POLE * line[last - step]);
  for (let at = last - step; at >= start; at -= step) line[at] = POLE * (line[at + step] - line[at]);
  for (let at = start; at <= last; at += step) line[at] *= 6;
}
