import { describe, expect, it } from 'vitest';
import { builtIn, environment, EnvironmentError, readEnvironment, scalarIrradiance } from '../src/scene/environment';
import { exr } from './support/write_exr';

describe('surroundings', () => {
  it('of a uniform sky hold 4 pi of its radiance', () => {
    const sky = environment(64, 32, new Float32Array(64 * 32).fill(2));
    expect(scalarIrradiance(sky)).toBeCloseTo(8 * Math.PI, 10);
  });

  it('that are built in are as bright as one light', () => {
    for (const name of ['overcast', 'window'] as const) expect(scalarIrradiance(builtIn(name))).toBeCloseTo(1, 5);
  });

  it('come from an EXR image with its top row first', async () => {
    const bright = (row: number, column: number) => (row === 1 && column === 5 ? 8 : 0);
    const planes = ['B', 'G', 'R'].map((name) => ({ name, half: true, value: bright }));
    const file = new File([exr(16, 8, planes, { zip: true }) as Uint8Array<ArrayBuffer>], 'sky.exr');
    const sky = await readEnvironment(file);
    expect([...sky.radiance].findIndex((value) => value > 0)).toBe(16 + 5);
    expect(scalarIrradiance(sky)).toBeCloseTo(1, 5);
  });

  it('that are no sphere of directions, black or broken are refused', () => {
    expect(() => environment(10, 10, new Float32Array(100).fill(1))).toThrow(EnvironmentError);
    expect(() => environment(8, 4, new Float32Array(32))).toThrow('black');
    expect(() => environment(8, 4, new Float32Array(32).fill(NaN))).toThrow('not finite');
  });
});
