import { describe, expect, it } from 'vitest';
import { directionTo, dot, normalise, pixelOffset, sampleIrradiance, sunflower, type Vec3 } from '../src/light/samples';

describe('samples of lights', () => {
  const axis = normalise([0.6, -1, 2]);

  it('fill the cone of the disc and no more', () => {
    const cosines = Array.from({ length: 500 }, (_, i) => dot(directionTo(axis, 20, sunflower(i, 500)), axis));
    const rim = Math.cos((10 * Math.PI) / 180);
    expect(Math.min(...cosines)).toBeGreaterThan(rim - 1e-12);
    expect((1 - Math.min(...cosines)) / (1 - rim)).toBeCloseTo(0.999, 9);
  });

  it('keep the irradiance', () => {
    const count = 16;
    const each = sampleIrradiance(axis, 40, count) / count;
    let sum = 0;
    for (let i = 0; i < count; i++) sum += each * dot(directionTo(axis, 40, sunflower(i, count)), axis);
    expect(sum).toBeCloseTo(1, 12);
  });

  it('of a point are its direction', () => {
    const direction = directionTo([0, 0, -3] as Vec3, 0, sunflower(0, 1));
    expect(direction[2]).toBeCloseTo(-1, 15);
    expect(sampleIrradiance([0, 0, -3], 0, 1)).toBeCloseTo(1, 15);
  });

  it('of a pixel stay in it, and one alone is its middle', () => {
    expect(pixelOffset(0, 1)).toEqual([0, 0]);
    for (let i = 0; i < 64; i++) for (const c of pixelOffset(i, 64)) expect(Math.abs(c)).toBeLessThanOrEqual(0.5);
  });
});
