import { describe, expect, it } from 'vitest';
import { fromHalf, toHalf } from '../src/atlas/half';

describe('half floats', () => {
  it('come back from their values, every one', () => {
    const wrong: number[] = [];
    for (let bits = 0; bits < 0x10000; bits++) {
      const value = fromHalf(bits);
      const same = Number.isNaN(value) ? Number.isNaN(fromHalf(toHalf(value))) : toHalf(value) === bits;
      if (!same) wrong.push(bits);
    }
    expect(wrong).toEqual([]);
  });

  it('round to the nearest, ties to even', () => {
    // Between 2048 and 4096 they are two apart.
    expect(fromHalf(toHalf(2049))).toBe(2048);
    expect(fromHalf(toHalf(2051))).toBe(2052);
    expect(fromHalf(toHalf(2049.001))).toBe(2050);
    // The last one, and what lies beyond it.
    expect(fromHalf(toHalf(65519))).toBe(65504);
    expect(fromHalf(toHalf(65520))).toBe(Infinity);
    // Half of the smallest is a tie with zero.
    expect(toHalf(2 ** -25)).toBe(0);
    expect(toHalf(2 ** -25 * 1.001)).toBe(1);
    expect(toHalf(-(2 ** -24))).toBe(0x8001);
  });
});
