// Pictures without a camera: the map of the BRDF over directions, and the screen on which a sample throws its light.

import { ALWAYS_LIT } from '../gl/shade';

/** Picture coordinates: x to the right, y up, the square [-1, 1] in the middle. */
const PLACE = `
in vec2 v_clip;
uniform vec2 u_extent;
uniform vec2 u_offset;
vec2 picture_place() { return v_clip * u_extent + u_offset; }
${ALWAYS_LIT}
`;

/** f in 1/sr over all viewing directions, for the direction of the light u_wi. */
export const MAP = `
${PLACE}
uniform vec3 u_wi;
void main() {
  vec2 at = picture_place();
  float cos2 = 1.0 - dot(at, at);
  vec3 pixel = vec3(0.0);
#ifdef FILTERED
  pixel = pixel_footprint(dFdx(at), dFdy(at));
#endif
  if (cos2 > 0.0) {
    seen = true;
    add(0, u_wi, vec3(at, sqrt(cos2)), 1.0, pixel);
  }
  finish();
}
`;

/** Irradiance on the screen from one ray of the beam. */
export const SCREEN = `
${PLACE}
uniform vec3 u_sample_normal;
uniform float u_distance;
uniform float u_half_width;
uniform float u_hole_radius;
uniform vec3 u_beam_point;
uniform vec3 u_beam_wi;
uniform float u_beam_power;
void main() {
  vec2 at = picture_place() * u_half_width;
  seen = max(abs(at.x), abs(at.y)) <= u_half_width;
  if (seen && length(at) >= u_hole_radius) {
    vec3 path = vec3(at, u_distance) - u_beam_point;
    float r2 = dot(path, path);
    vec3 to_screen = path / sqrt(r2);
    vec3 t = vec3(u_sample_normal.z, 0.0, -u_sample_normal.x);
    vec3 tt = u_turn.x * t + u_turn.y * vec3(0.0, 1.0, 0.0);
    vec3 bb = u_turn.x * vec3(0.0, 1.0, 0.0) - u_turn.y * t;
    vec3 wo = vec3(dot(tt, to_screen), dot(bb, to_screen), dot(u_sample_normal, to_screen));
    vec3 wi = vec3(u_turn.x * u_beam_wi.x + u_turn.y * u_beam_wi.y, u_turn.x * u_beam_wi.y - u_turn.y * u_beam_wi.x, u_beam_wi.z);
    add(0, wi, wo, u_beam_power * wo.z * to_screen.z / r2, vec3(0.0));
  }
  finish();
}
`;
