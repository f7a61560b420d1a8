import { describe, expect, it } from 'vitest';
import { cieFromRust } from '../scripts/cie.mjs';
import cie from '../src/generated/cie.json';
import { dominantWavelength, linearSrgb, patchCss } from '../src/light/colour';
import { illuminant, observer, quadrature, toXyz, type Xyz } from '../src/light/illuminants';

/** The white as the CIE publishes it: a plain sum every 5 nm. */
const white = (name: Parameters<typeof illuminant>[0]): Xyz => {
  const power = illuminant(name, 633, 45).power ?? (() => NaN);
  const sum: Xyz = [0, 0, 0];
  for (let nm = 380; nm <= 780; nm += 5) observer(nm).forEach((c, i) => (sum[i] += (nm === 380 || nm === 780 ? 0.5 : 1) * power(nm) * c));
  return sum.map((c) => c / sum[1]) as Xyz;
};

describe('lights', () => {
  it('have the CIE numbers of the Rust source', async () => {
    expect(cie).toEqual(await cieFromRust());
  });

  it.each([
    ['D65', 0.95047, 1.08883],
    ['A', 1.0985, 0.35585],
    ['E', 1, 1],
    ['F11', 1.00962, 0.6435],
  ] as const)('%s has the published white', (name, x, z) => {
    // CIE 15:2018; published whites are sums over 360 to 830 nm, of which 3e-4 is left out here.
    const found = white(name);
    expect(Math.abs(found[0] - x)).toBeLessThan(3e-4);
    expect(Math.abs(found[2] - z)).toBeLessThan(3e-4);
    expect(found[1]).toBeCloseTo(1, 12);
  });

  it.each(['D65', 'A', 'F11', 'LED'] as const)('weights of %s sum to its white, whatever their number', (name) => {
    const sum = (count: number) => {
      const q = quadrature(illuminant(name, 633, 45), [380, 780], count);
      return toXyz(q, q.nm.map(() => 1));
    };
    const [few, many] = [sum(50), sum(800)];
    few.forEach((c, i) => expect(c).toBeCloseTo(many[i], 12));
    // Lines of a lamp fall between the 5 nm of the published sum.
    few.forEach((c, i) => expect(Math.abs(c - white(name)[i])).toBeLessThan(1e-3));
  });

  it('weights integrate a narrow order as a fine sum does, and one node too few does not', () => {
    const pulse = (nm: number) => Math.exp(-0.5 * ((1 / nm - 1 / 540) / 2e-5) ** 2);
    const sum = (count: number) => {
      const q = quadrature(illuminant('D65', 633, 45), [380, 780], count);
      return toXyz(q, q.nm.map(pulse))[1];
    };
    const exact = sum(4001);
    expect(Math.abs(sum(150) / exact - 1)).toBeLessThan(1e-3);
    expect(Math.abs(sum(20) / exact - 1)).toBeGreaterThan(1e-2);
  });

  it('a laser is its line', () => {
    const q = quadrature(illuminant('laser', 555, 45), [380, 780], 99);
    expect(q.nm).toEqual([555]);
    expect(q.weights[0][1]).toBeCloseTo(1, 15);
  });

  it('a low sun is redder than a high one', () => {
    const ratio = (height: number) => {
      const light = illuminant('sun', 0, height);
      return (light.power?.(650) ?? 0) / (light.power?.(450) ?? 1);
    };
    expect(ratio(5)).toBeGreaterThan(2 * ratio(60));
  });
});

describe('colours', () => {
  it('of single wavelengths have themselves as the dominant one', () => {
    for (const nm of [450, 480, 520, 580, 610]) {
      const found = dominantWavelength(observer(nm), [0.95047, 1, 1.08883]);
      expect(found?.nm).toBeCloseTo(nm, 3);
      expect(found?.purity).toBeCloseTo(1, 6);
      expect(found?.complementary).toBe(false);
    }
  });

  it('of purples have a complementary one, and white has none', () => {
    const purple = observer(440).map((c, i) => c + observer(640)[i]) as Xyz;
    expect(dominantWavelength(purple, [0.95047, 1, 1.08883])?.complementary).toBe(true);
    expect(dominantWavelength([0.95047, 1, 1.08883], [0.95047, 1, 1.08883])).toBeNull();
  });

  it('of D65 are grey', () => {
    for (const channel of linearSrgb([0.95047, 1, 1.08883])) expect(channel).toBeCloseTo(1, 4);
    expect(patchCss([0.95047, 1, 1.08883])).toBe('rgb(255, 255, 255)');
  });
});
