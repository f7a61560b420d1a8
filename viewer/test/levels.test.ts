import { describe, expect, it } from 'vitest';
import { coarser } from '../src/atlas/mips';
import { heldTexels, toCoefficients } from '../src/atlas/splines';
import { GAUSSIANS, lobeGaussians } from '../src/atlas/gaussians';

describe('coarser levels', () => {
  it.each([[64, 64], [61, 97], [8, 31]])('keep a plane where it is: %i by %i', (height, width) => {
    const at = (rows: number, columns: number) => Float64Array.from({ length: rows * columns }, (_, i) => 3 + ((i % columns) + 0.5) / columns - (2 * (Math.floor(i / columns) + 0.5)) / rows);
    const levels = coarser({ width, height, values: at(height, width) });
    expect(levels.length).toBeGreaterThan(0);
    for (const { width: columns, height: rows, values } of levels) {
      expect(Math.min(rows, columns)).toBeGreaterThanOrEqual(4);
      const wanted = at(rows, columns);
      const off = Math.max(...values.map((value, i) => Math.abs(value - wanted[i])));
      expect(off).toBeLessThan(0.03);
      expect(Math.max(...values.map((value, i) => Math.abs(value - wanted[values.length - 1 - i])))).toBeGreaterThan(0.5);
    }
  });
});

describe('coefficients', () => {
  it('make a spline through the values', () => {
    const size = 21;
    const values = Float64Array.from({ length: size * size }, (_, i) => Math.cos(0.4 * (i % size)) + Math.sin(0.3 * Math.floor(i / size)));
    const found = values.slice();
    toCoefficients(found, size);
    // At a texel the spline takes 1/6, 4/6 and 1/6 of three coefficients along each axis.
    const share = [1 / 6, 4 / 6, 1 / 6];
    let spline = 0;
    for (let dy = 0; dy < 3; dy++) for (let dx = 0; dx < 3; dx++) spline += share[dy] * share[dx] * found[(9 + dy) * size + 7 + dx];
    expect(spline).toBeCloseTo(values[10 * size + 8], 9);
    expect(found[10 * size + 8]).not.toBeCloseTo(values[10 * size + 8], 3);
  });

  it('hold values beyond the rim of the disc', () => {
    const held = heldTexels(21);
    expect(held[10 * 21 + 10]).toBe(10 * 21 + 10);
    expect(held[0]).not.toBe(0);
  });
});

describe('Gaussians', () => {
  it('sum to a profile that is one of them', () => {
    const [width, over] = [90, 4.55];
    const texels = new Float32Array(4 * width);
    for (let i = 0; i < width; i++) texels[4 * i] = Math.exp(-(((over * i) / (width - 1)) ** 2));
    const { texels: factors, height } = lobeGaussians({ width, height: 1, texels });
    expect([height, factors.length]).toEqual([1, 4 * GAUSSIANS]);
    expect(factors[0]).toBeCloseTo(1, 3);
    for (let k = 1; k < GAUSSIANS; k++) expect(Math.abs(factors[4 * k])).toBeLessThan(1e-2);
    // A channel without light has none.
    expect(factors[1]).toBe(0);
  });
});
