// The evaluation between three's pieces of shaders.

/** Most look-ups over a light's disc. */
export const LIGHT_SAMPLES_MAX = 64;

/** three's own vertex shader of matt surfaces, with the structure's direction added. */
export const VERTEX = (lambert: string): string =>
  lambert
    .replace(
      'varying vec3 vViewPosition;',
      `varying vec3 vViewPosition;
#ifndef USE_TANGENT
attribute vec4 tangent;
#endif
varying vec2 v_uv;
varying vec4 v_structure;`,
    )
    .replace(
      'vViewPosition = - mvPosition.xyz;',
      `vViewPosition = - mvPosition.xyz;
v_uv = uv;
// A mirrored object mirrors the structure.
v_structure = vec4((modelViewMatrix * vec4(tangent.xyz, 0.0)).xyz, tangent.w * sign(determinant(mat3(modelMatrix))));`,
    );

/** Follows three's names: \`RE_Direct\` is called for each light that reaches the point, with its shadow in its colour. */
export const FRAGMENT = (evaluation: string): string => `
#define LAMBERT
${evaluation}
#include <common>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <shadowmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec3 vViewPosition;
varying vec2 v_uv;
varying vec4 v_structure;
uniform mat3 u_rgb_from_xyz;
uniform vec2 u_turn;
uniform int u_samples;
uniform vec3 u_disc[${LIGHT_SAMPLES_MAX}];
uniform float u_share;

// Axes of the structure: x, y, and the normal.
mat3 structure;

mat3 structure_at(vec3 normal) {
  vec3 along = v_structure.xyz - normal * dot(normal, v_structure.xyz);
  float side = v_structure.w < 0.0 ? -1.0 : 1.0;
  if (dot(along, along) < 1e-12) {
    // No tangents: those of this triangle.
    vec3 px = dFdx(-vViewPosition);
    vec3 py = dFdy(-vViewPosition);
    vec2 ux = dFdx(v_uv);
    vec2 uy = dFdy(v_uv);
    float area = ux.x * uy.y - ux.y * uy.x;
    along = (px * uy.y - py * ux.y) * sign(area);
    vec3 across = (py * ux.x - px * uy.x) * sign(area);
    side = dot(cross(along, across), normal) < 0.0 ? -1.0 : 1.0;
    along -= normal * dot(normal, along);
    if (!(dot(along, along) > 0.0)) {
      // Texture coordinates on a line give no direction: there is no answer.
      answered = false;
      along = cross(normal, abs(normal.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0));
    }
  }
  vec3 x = normalize(along);
  vec3 y = cross(normal, x) * side;
  return mat3(u_turn.x * x + u_turn.y * y, u_turn.x * y - u_turn.y * x, normal);
}

// The shortest turn that takes +z to a unit vector, applied to another.
vec3 about(vec3 axis, vec3 v) {
  if (axis.z < -0.9999999) return vec3(v.x, -v.yz);
  float s = 1.0 / (1.0 + axis.z);
  vec3 a = vec3(1.0 - axis.x * axis.x * s, -axis.x * axis.y * s, -axis.x);
  vec3 b = vec3(-axis.x * axis.y * s, 1.0 - axis.y * axis.y * s, -axis.y);
  return v.x * a + v.y * b + v.z * axis;
}

struct DiffractingMaterial { float unused; };

void RE_Direct_Diffraction(const in IncidentLight light, const in vec3 position, const in vec3 normal, const in vec3 to_viewer, const in vec3 clearcoat, const in DiffractingMaterial material, inout ReflectedLight reflectedLight) {
  if (light.color == vec3(0.0)) return;
  vec3 wo = normalize(to_viewer * structure);
  if (!(wo.z > 0.0)) return;
  vec3 xyz = vec3(0.0);
  for (int i = 0; i < u_samples; i++) {
    vec3 wi = normalize(about(light.direction, u_disc[i]) * structure);
    if (wi.z > 0.0) xyz += reflected(wi, wo) * wi.z;
  }
  reflectedLight.directDiffuse += u_rgb_from_xyz * xyz * u_share * light.color;
}
#define RE_Direct RE_Direct_Diffraction

void main() {
  #include <clipping_planes_fragment>
  ReflectedLight reflectedLight = ReflectedLight(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
  DiffractingMaterial material;
  #include <logdepthbuf_fragment>
  #include <normal_fragment_begin>
  structure = structure_at(normal);
  #include <lights_fragment_begin>
  vec3 outgoingLight = answered ? reflectedLight.directDiffuse : vec3(1.0, 0.0, 1.0);
  gl_FragColor = vec4(outgoingLight, 1.0);
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
}
`;
