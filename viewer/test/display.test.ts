import { Matrix3, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { P3, SRGB } from '../src/gl/display';

const D65 = new Vector3(0.95047, 1, 1.08883);

describe.each([['sRGB', SRGB], ['display-P3', P3]] as const)('the primaries of %s', (_, primaries) => {
  it('show D65 as white', () => {
    for (const channel of D65.clone().applyMatrix3(primaries.rgb_from_xyz).toArray()) expect(channel).toBeCloseTo(1, 3);
  });

  it('have the luminance of their matrix', () => {
    const back = primaries.rgb_from_xyz.clone().invert().elements;
    [back[1], back[4], back[7]].forEach((y, i) => expect(y).toBeCloseTo(primaries.luminance.toArray()[i], 4));
  });

  it('go to cones and back', () => {
    const there = primaries.rgb_from_lms.clone().multiply(primaries.lms_from_rgb);
    there.elements.forEach((value, i) => expect(value).toBeCloseTo(new Matrix3().elements[i], 5));
  });

  it('see the same cones of one colour', () => {
    const xyz = new Vector3(0.3, 0.2, 0.4);
    const cones = (p: typeof SRGB) => xyz.clone().applyMatrix3(p.rgb_from_xyz).applyMatrix3(p.lms_from_rgb);
    expect(cones(primaries).distanceTo(cones(SRGB))).toBeLessThan(1e-4);
  });
});
