// The shader's evaluation as text to build programs from: translated from the one WGSL source, without its entry point.

import spectral from '../generated/spectral.glsl';
import spectralFiltered from '../generated/spectral_filtered.glsl';
import tables from '../generated/tables.glsl';
import tablesFiltered from '../generated/tables_filtered.glsl';

/** Names that the translation gives to bindings 0 to 3. */
export const BINDING = ['_group_0_binding_0_fs', '_group_0_binding_1_fs', '_group_0_binding_2_fs', '_group_0_binding_3_fs'];
/** And to that of the lobe's Gaussians, which filtered look-ups of tables of XYZ read. */
export const GAUSSIANS_BINDING = '_group_0_binding_5_fs';

/**
 * Functions of a translated shader. The uniform block becomes a plain uniform of the same structure, and the entry point with
 * its inputs and outputs goes.
 */
export function functionsOf(translated: string): string {
  const body = translated
    .replace(/^#version.*$/m, '')
    .replace(/layout\(std140\) uniform \w+ \{ (\w+) (\w+); \};/, 'uniform $1 $2;')
    .replace(/^(smooth|flat) in .*;$/gm, '')
    .replace(/^layout\(location = \d+\) out .*;$/gm, '');
  const entry = body.indexOf('void main()');
  if (entry < 0) throw new Error('the translated shader has no entry point');
  return body.slice(0, entry);
}

/** Evaluation of tables of XYZ: `reflected(wi, wo)` in 1/sr, and whether the tables answer there. */
const REFLECTED_TABLES = `
bool answered = true;
vec3 known(vec3 xyz) {
  if (has_answer(xyz)) return xyz;
  answered = false;
  return vec3(0.0);
}
vec3 reflected(vec3 wi, vec3 wo) { return known(surface_xyz(wi, wo)); }
`;

/** The mean over a footprint, in place of the value at a point. */
const OVER_TABLES = `
vec3 reflected_over(vec3 wi, vec3 wo, vec3 footprint) { return known(surface_xyz_filtered(wi, wo, footprint)); }
`;

/**
 * The same from spectral tables: a sum over wavelengths. Row 0 of the quadrature holds a wavelength and its weights, row 1 the
 * material's n, k and kind there. A structure scaled by a factor diffracts like the scanned one at the wavelength divided by it.
 */
const REFLECTED_SPECTRAL = `
uniform highp sampler2D u_quadrature;
uniform int u_wavelengths;
uniform float u_structure_scale;
bool answered = true;
Front front_at(vec3 material) {
  uint kind = uint(material.z + 0.5);
  return Front(kind, _group_0_binding_0_fs.factor, _group_0_binding_0_fs.shadowing, material.xy, complex_product(material.xy, material.xy));
}
${overWavelengths('reflected(vec3 wi, vec3 wo)', 'brdf_spectral_with(front_at(material), wi, wo, weight.x / u_structure_scale)')}
`;

const OVER_SPECTRAL = overWavelengths('reflected_over(vec3 wi, vec3 wo, vec3 footprint)', 'brdf_spectral_filtered_with(front_at(material), wi, wo, weight.x / u_structure_scale, footprint)');

function overWavelengths(declared: string, value: string): string {
  return `
vec3 ${declared} {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < u_wavelengths; i++) {
    vec4 weight = texelFetch(u_quadrature, ivec2(i, 0), 0);
    vec3 material = texelFetch(u_quadrature, ivec2(i, 1), 0).xyz;
    float f = ${value};
    if (has_answer(f)) sum += f * weight.yzw;
    else answered = false;
  }
  return sum;
}
`;
}

export type Source = 'tables' | 'spectral';
/** The cubic B-spline where the tables are promised for it, else linear; linear as the hardware does it; cubics through four texels. */
export type Interpolation = 'spline' | 'bilinear' | 'cubic';

/** Four by four texels, the cubic through each four, in place of the hardware's two by two. */
const CUBIC_LOOKUP = `
vec4 cubic_weights(float x) {
  return vec4(-(x - 1.0) * (x - 2.0) * (x - 3.0) / 6.0, x * (x - 2.0) * (x - 3.0) / 2.0, -x * (x - 1.0) * (x - 3.0) / 2.0, x * (x - 1.0) * (x - 2.0) / 6.0);
}
vec4 cubic_lookup(highp sampler2DArray layers, vec3 at, float lod) {
  ivec2 size = textureSize(layers, 0).xy;
  vec2 place = clamp(at.xy * vec2(size) - 0.5, vec2(0.0), vec2(size - 1));
  ivec2 first = clamp(ivec2(floor(place)) - 1, ivec2(0), max(size - 4, ivec2(0)));
  vec2 share = place - vec2(first);
  vec4 across = cubic_weights(share.x);
  vec4 down = cubic_weights(share.y);
  vec4 sum = vec4(0.0);
  for (int y = 0; y < 4; y++)
    for (int x = 0; x < 4; x++) sum += across[x] * down[y] * texelFetch(layers, ivec3(min(first + ivec2(x, y), size - 1), int(at.z)), 0);
  return sum;
}
`;

/** The evaluation with look-ups in tables of the given kind; a range of t is always looked up bilinearly. Splines are those of the uniform. */
export function withLookups(functions: string, interpolation: Interpolation): string {
  if (interpolation !== 'cubic') return functions;
  const lookup = `textureLod(${BINDING[1]},`;
  const range = functions.indexOf('float share_of_range(');
  const ends = range < 0 ? -1 : functions.indexOf('\n}\n', range);
  const cubic = (text: string) => text.replaceAll(lookup, `cubic_lookup(${BINDING[1]},`);
  const changed = cubic(functions.slice(0, Math.max(range, 0))) + functions.slice(Math.max(range, 0), Math.max(ends, 0)) + cubic(functions.slice(Math.max(ends, 0)));
  if (!changed.includes('cubic_lookup(')) throw new Error('the translated shader looks nothing up in tables');
  const first = 'precision highp int;\n';
  return changed.replace(first, first + CUBIC_LOOKUP);
}

const REFLECTED: Record<Source, string> = { tables: REFLECTED_TABLES, spectral: REFLECTED_SPECTRAL };

/** The text that defines `reflected`. */
export const evaluation = (source: Source, interpolation: Interpolation): string =>
  withLookups(functionsOf(source === 'tables' ? tables : spectral), interpolation) + REFLECTED[source];

/** The text that defines `reflected`, and `reflected_over`, the mean over a footprint. */
export const filteredEvaluation = (source: Source): string =>
  source === 'tables' ? functionsOf(tablesFiltered) + REFLECTED_TABLES + OVER_TABLES : functionsOf(spectralFiltered) + REFLECTED_SPECTRAL + OVER_SPECTRAL;
