import { describe, expect, it } from 'vitest';
import { functionsOf, withLookups } from '../src/gl/library';
import spectral from '../src/generated/spectral.glsl';
import tables from '../src/generated/tables.glsl';

describe.each([['tables', tables, 'TableParams'], ['spectral', spectral, 'SpectralParams']])('the translated shader of %s', (name, text, block) => {
  const functions = functionsOf(text);

  it('keeps its functions and loses its entry point and block', () => {
    expect(functions).not.toMatch(/void main|#version|layout\(/);
    expect(functions).toContain(`uniform ${block} _group_0_binding_0_fs;`);
    expect(functions).toContain(name === 'tables' ? 'vec3 surface_xyz(' : 'float brdf_spectral_with(');
  });

  it('looks up cubically where tables are summed, and nowhere else', () => {
    const cubic = withLookups(functions, 'cubic');
    expect(withLookups(functions, 'bilinear')).toBe(functions);
    // The linear look-up, and the four of splines, which the page does not ask for.
    expect(cubic.match(/= cubic_lookup\(_group_0_binding_1_fs/g)).toHaveLength(5);
    // Ranges, where there are some, and the cross term stay bilinear.
    expect(cubic.match(/textureLod\(_group_0_binding_1_fs/g) ?? []).toHaveLength(name === 'tables' ? 1 : 0);
    expect(cubic.match(/textureLod\(_group_0_binding_2_fs/g)).toHaveLength(1);
  });
});
