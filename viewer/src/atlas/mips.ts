// Coarser levels of tables for filtered look-ups: as the program makes them, so that a place in normalised coordinates is the same
// on every level, odd sides included.

/** Fewest texels a side of a level below the finest. */
const SIDE_MIN = 4;

/** A channel, row by row. */
export interface Plane {
  width: number;
  height: number;
  values: Float64Array;
}

/** The levels below an image, from the finer to the coarser. */
export function coarser(image: Plane): Plane[] {
  const levels: Plane[] = [];
  for (let finer = image; Math.min(finer.width, finer.height) >= 2 * SIDE_MIN; ) {
    finer = halved(finer);
    levels.push(finer);
  }
  return levels;
}

function halved({ width, height, values }: Plane): Plane {
  const [across, down] = [shares(width), shares(height)];
  const narrow = new Float64Array(height * across.length);
  for (let row = 0, out = 0; row < height; row++) {
    for (const { first, weights } of across) {
      const at = row * width + first;
      let sum = 0;
      for (let k = 0; k < 3; k++) if (weights[k] > 0) sum += weights[k] * values[at + k];
      narrow[out++] = sum;
    }
  }
  const line = across.length;
  const out = new Float64Array(down.length * line);
  down.forEach(({ first, weights }, row) => {
    for (let k = 0; k < 3; k++) {
      if (weights[k] > 0) for (let i = 0; i < line; i++) out[row * line + i] += weights[k] * narrow[(first + k) * line + i];
    }
  });
  // Levels are made from each other in single precision.
  for (let i = 0; i < out.length; i++) out[i] = Math.fround(out[i]);
  return { width: line, height: down.length, values: out };
}

/** For each texel along a side of half as many: the first of the texels that it covers, and how much it covers of three. */
function shares(count: number): { first: number; weights: [number, number, number] }[] {
  const half = Math.floor(count / 2);
  const step = count / half;
  return Array.from({ length: half }, (_, n) => {
    const [low, high] = [n * step, (n + 1) * step];
    const first = Math.floor(low);
    // What rounding leaves beyond the side belongs to no texel.
    const covered = (k: number) => (first + k < count ? Math.max(0, Math.min(high, first + k + 1) - Math.max(low, first + k)) : 0);
    const [a, b, c] = [covered(0), covered(1), covered(2)];
    const sum = a + b + c;
    return { first, weights: [a / sum, b / sum, c / sum] };
  });
}
