// XYZ to the display: exposure, colours brought into the gamut, highlights rolled off, sRGB's transfer function. The same
// steps as those of the program's pictures.

import { Matrix3, Vector3 } from 'three';

/** What the colours of a display are made of, as uniforms. */
export interface Primaries {
  rgb_from_xyz: Matrix3;
  luminance: Vector3;
  lms_from_rgb: Matrix3;
  rgb_from_lms: Matrix3;
}

const SRGB_FROM_XYZ = new Matrix3(3.2404542, -1.5371385, -0.4985314, -0.969266, 1.8760108, 0.041556, 0.0556434, -0.2040259, 1.0572252);
const SRGB_LUMINANCE = new Vector3(0.2126729, 0.7151522, 0.072175);
const LMS_FROM_SRGB = new Matrix3(0.4122214708, 0.5363325363, 0.0514459929, 0.2119034982, 0.6806995451, 0.1073969566, 0.0883024619, 0.2817188376, 0.6299787005);
const SRGB_FROM_LMS = new Matrix3(4.0767416621, -3.3077115913, 0.2309699292, -1.2684380046, 2.6097574011, -0.3413193965, -0.0041960863, -0.7034186147, 1.707614701);
/** Linear display-P3 to XYZ of the same white (SMPTE EG 432-1, D65). */
const XYZ_FROM_P3 = new Matrix3(0.4865709, 0.2656677, 0.1982173, 0.2289746, 0.6917385, 0.0792869, 0, 0.0451134, 1.0439444);

export const SRGB: Primaries = { rgb_from_xyz: SRGB_FROM_XYZ, luminance: SRGB_LUMINANCE, lms_from_rgb: LMS_FROM_SRGB, rgb_from_lms: SRGB_FROM_LMS };

const srgbFromP3 = SRGB_FROM_XYZ.clone().multiply(XYZ_FROM_P3);
export const P3: Primaries = {
  rgb_from_xyz: XYZ_FROM_P3.clone().invert(),
  luminance: new Vector3(0.2289746, 0.6917385, 0.0792869),
  lms_from_rgb: LMS_FROM_SRGB.clone().multiply(srgbFromP3),
  rgb_from_lms: srgbFromP3.clone().invert().multiply(SRGB_FROM_LMS),
};

/** u_mode 0: as the atlas's pictures; 1: channels cut at 0 and 1; 2: the difference of two pictures as a heat map. */
export const DISPLAY = /* glsl */ `
uniform sampler2D u_xyz;
uniform sampler2D u_other;
uniform float u_exposure;
uniform int u_mode;
uniform float u_backdrop;
layout(location = 0) out highp vec4 out_value;

// The display's primaries: those of sRGB, or the wider ones of display-P3.
uniform mat3 u_rgb_from_xyz;
uniform vec3 u_luminance;
uniform mat3 u_lms_from_rgb;
uniform mat3 u_rgb_from_lms;
const mat3 LAB_FROM_ROOTS = mat3(0.2104542553, 1.9779984951, 0.0259040371, 0.7936177850, -2.4285922050, 0.7827717662, -0.0040720468, 0.4505937099, -0.8086757660);
const float HIGHLIGHT_START = 0.8;

float cube_root(float x) { return sign(x) * pow(abs(x), 1.0 / 3.0); }

// A colour's hue as the change of each cone's root with the saturation, and its saturation; none where negative.
vec4 hue_ray(vec3 rgb) {
  vec3 lms = u_lms_from_rgb * rgb;
  vec3 lab = LAB_FROM_ROOTS * vec3(cube_root(lms.x), cube_root(lms.y), cube_root(lms.z));
  float chroma = length(lab.yz);
  if (lab.x <= 0.0 || chroma <= 0.0) return vec4(-1.0);
  vec2 ab = lab.yz / chroma;
  vec3 slope = vec3(0.3963377774 * ab.x + 0.2158037573 * ab.y, -0.1055613458 * ab.x - 0.0638541728 * ab.y, -0.0894841775 * ab.x - 1.2914855480 * ab.y);
  return vec4(slope, chroma / lab.x);
}

vec3 on_ray(vec3 slope, float saturation) {
  vec3 root = 1.0 + saturation * slope;
  return u_rgb_from_lms * (root * root * root);
}

float least(vec3 v) { return min(v.x, min(v.y, v.z)); }
float most(vec3 v) { return max(v.x, max(v.y, v.z)); }

vec3 into_gamut(vec3 rgb) {
  if (least(rgb) >= 0.0) return rgb;
  float target = dot(u_luminance, rgb);
  if (target <= 0.0) return vec3(0.0);
  vec4 ray = hue_ray(rgb / most(abs(rgb)));
  if (ray.w < 0.0) return vec3(target);
  float inside = 0.0;
  float outside = ray.w;
  for (int i = 0; i < 22; i++) {
    float middle = 0.5 * (inside + outside);
    if (least(on_ray(ray.xyz, middle)) >= 0.0) inside = middle;
    else outside = middle;
  }
  vec3 found = max(on_ray(ray.xyz, inside), 0.0);
  return found * (target / dot(u_luminance, found));
}

vec3 roll_off(vec3 rgb) {
  float peak = most(rgb);
  if (peak <= HIGHLIGHT_START) return rgb;
  float d = 1.0 - HIGHLIGHT_START;
  float rolled = 1.0 - d * d / (peak + d - HIGHLIGHT_START);
  float kept = 1.0 / (1.0 + 0.15 * (peak - rolled));
  vec4 ray = hue_ray(rgb / peak);
  vec3 paled = ray.w < 0.0 ? rgb : on_ray(ray.xyz, ray.w * kept);
  return clamp(paled * (rolled / most(paled)), 0.0, 1.0);
}

vec3 encode(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(12.92 * c, 1.055 * pow(max(c, vec3(1e-9)), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

vec3 heat(float x) {
  const vec3 stops[5] = vec3[5](vec3(0.0, 0.0, 0.016), vec3(0.333, 0.059, 0.427), vec3(0.729, 0.212, 0.333), vec3(0.976, 0.549, 0.039), vec3(0.988, 1.0, 0.643));
  float at = clamp(x, 0.0, 1.0) * 4.0;
  int first = min(int(at), 3);
  return mix(stops[first], stops[first + 1], at - float(first));
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 value = texelFetch(u_xyz, at, 0);
  if (u_mode == 2) {
    vec4 other = texelFetch(u_other, at, 0);
    out_value = vec4(heat(abs(value.y - other.y) * u_exposure * 10.0), 1.0);
    return;
  }
  vec3 rgb = u_rgb_from_xyz * (value.xyz * u_exposure);
  vec3 shown = u_mode == 1 ? encode(rgb) : encode(roll_off(into_gamut(rgb)));
  // Directions that the tables do not cover: a grey hatch.
  float hatch = step(3.0, mod(gl_FragCoord.x + gl_FragCoord.y, 6.0));
  shown = mix(shown, vec3(0.35 + 0.15 * hatch), clamp(value.a, 0.0, 1.0));
  // Beside the surface: a dim backdrop, so that dark surfaces stand out.
  vec2 size = vec2(textureSize(u_xyz, 0));
  float away = length((gl_FragCoord.xy - 0.5 * size) / max(size.x, size.y));
  vec3 backdrop = u_backdrop * mix(vec3(0.115, 0.12, 0.135), vec3(0.035, 0.038, 0.046), smoothstep(0.1, 0.75, away));
  out_value = vec4(mix(shown, backdrop, clamp(-value.a, 0.0, 1.0)), 1.0);
}
`;
