// What every picture's shader has in common: lights on a point of a surface, and what becomes of the sum.

/** Most lights at once. */
export const LIGHTS_MAX = 4;

/** Vertex shader of a shape that fills the picture and casts its own rays. */
export const FILL_VERTEX = `
in vec3 position;
out vec2 v_clip;
void main() {
  v_clip = position.xy;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
`;

/**
 * Two directions of the surroundings in each pass: one where they are bright, one about the mirror direction, each weighted
 * as what both ways together would draw there, where nothing of the body stands in the way. The densities are those of the program's
 * pictures.
 */
const SKY = `
#ifdef SURROUNDED
uniform highp sampler2D u_sky_map;
uniform highp sampler2D u_sky_rows;
// The integral of the radiance over directions; 0 without surroundings.
uniform float u_sky;
uniform vec2 u_spin;
uniform float u_index;
float open_towards(vec3 direction);
const float SKY_LEVEL = 3e-3;
const float SKY_REACH = 2.0;

vec2 even_point(float index) {
  vec2 pixel = gl_FragCoord.xy;
  vec2 own = fract(sin(vec2(dot(pixel, vec2(12.9898, 78.233)), dot(pixel, vec2(39.346, 11.135)))) * 43758.5453);
  return fract(own + index * vec2(0.7548776662, 0.5698402910));
}

float row_edge(int row) { return cos(3.14159265 * float(row) / float(textureSize(u_sky_map, 0).y)); }

vec3 direction_by_light(vec2 point) {
  ivec2 size = textureSize(u_sky_map, 0);
  float target = point.y * u_sky;
  int low = 0;
  int high = size.y - 1;
  while (low < high) {
    int middle = (low + high) / 2;
    if (texelFetch(u_sky_rows, ivec2(middle, 0), 0).r <= target) low = middle + 1;
    else high = middle;
  }
  int row = low;
  float below = row == 0 ? 0.0 : texelFetch(u_sky_rows, ivec2(row - 1, 0), 0).r;
  float down = clamp((target - below) / (texelFetch(u_sky_rows, ivec2(row, 0), 0).r - below), 0.0, 1.0);
  low = 0;
  high = size.x - 1;
  while (low < high) {
    int middle = (low + high) / 2;
    if (texelFetch(u_sky_map, ivec2(middle, row), 0).g <= point.x) low = middle + 1;
    else high = middle;
  }
  float before = low == 0 ? 0.0 : texelFetch(u_sky_map, ivec2(low - 1, row), 0).g;
  float share = clamp((point.x - before) / max(texelFetch(u_sky_map, ivec2(low, row), 0).g - before, 1e-12), 0.0, 1.0);
  float y = mix(row_edge(row), row_edge(row + 1), down);
  float turn = 6.28318531 * ((float(low) + share) / float(size.x) - 0.5);
  float side = sqrt(max(0.0, 1.0 - y * y));
  return vec3(-side * sin(turn), y, side * cos(turn));
}

float sky_radiance(vec3 d) {
  ivec2 size = textureSize(u_sky_map, 0);
  int row = int(acos(clamp(d.y, -1.0, 1.0)) / 3.14159265 * float(size.y));
  float turns = atan(-d.x, d.z) / 6.28318531 + 0.5;
  return texelFetch(u_sky_map, ivec2(min(int(fract(turns) * float(size.x)), size.x - 1), min(row, size.y - 1)), 0).r;
}

// The object may have been turned about the vertical: the surroundings stay.
vec3 from_sky(vec3 d) { return vec3(u_spin.x * d.x - u_spin.y * d.z, d.y, u_spin.x * d.z + u_spin.y * d.x); }
vec3 to_sky(vec3 d) { return vec3(u_spin.x * d.x + u_spin.y * d.z, d.y, u_spin.x * d.z - u_spin.y * d.x); }

void add_sky(vec3 t, vec3 b, vec3 n, vec3 wo) {
  float ratio = 1.0 + SKY_REACH * SKY_REACH / (SKY_LEVEL * SKY_LEVEL);
  for (int k = 0; k < 2; k++) {
    vec2 point = even_point(2.0 * u_index + float(k));
    vec3 wi;
    if (k == 0) {
      vec3 d = from_sky(direction_by_light(point));
      wi = vec3(dot(t, d), dot(b, d), dot(n, d));
    } else {
      float distance = SKY_LEVEL * sqrt(pow(ratio, point.x) - 1.0);
      vec2 xy = distance * vec2(cos(6.28318531 * point.y), sin(6.28318531 * point.y)) - wo.xy;
      wi = vec3(xy, sqrt(max(0.0, 1.0 - dot(xy, xy))));
    }
    if (!(wi.z > 0.0)) continue;
    float radiance = sky_radiance(to_sky(wi.x * t + wi.y * b + wi.z * n));
    vec2 off = wi.xy + wo.xy;
    float by_lobe = wi.z / (3.14159265 * log(ratio) * (dot(off, off) + SKY_LEVEL * SKY_LEVEL));
    float irradiance = radiance / (radiance / u_sky + by_lobe);
    if (radiance > 0.0 && open_towards(wi.x * t + wi.y * b + wi.z * n) > 0.0) sum += reflected(wi, wo) * irradiance * wi.z;
  }
}
#endif
`;

/**
 * Follows the evaluation. \`add\` collects one light; \`shade\` does so for all lights on a point of a surface.
 *
 * Output 0 is XYZ, with 1 in the fourth channel where directions are unanswered and -1 where there is no surface; output 1 the two directions of the chosen
 * light: x, y of wi and of wo, 9 where there is none.
 */
export const SHADE = `
layout(location = 0) out highp vec4 out_value;
uniform int u_output;
uniform int u_active;
uniform int u_lights;
uniform vec4 u_light[${LIGHTS_MAX}];
// The angular radius in radians of the directions for which each light's stands: filtered look-ups take their mean.
uniform float u_light_radius[${LIGHTS_MAX}];
// Which part of a pixel a look-up stands for; 0 where it is a point.
uniform float u_pixel_share;
uniform vec2 u_turn;
struct Point {
  vec3 tangent;
  vec3 bitangent;
  vec3 normal;
  vec3 to_viewer;
};

vec3 sum = vec3(0.0);
vec4 directions = vec4(9.0);
// Whether there is anything here to be seen, lit or not.
bool seen = false;

float lit(int light);

#ifdef FILTERED
// The pixel's share of (u, v): the covariance of what changes evenly across it.
vec3 pixel_footprint(vec2 across, vec2 down) {
  return u_pixel_share / 12.0 * vec3(across.x * across.x + down.x * down.x, across.x * across.y + down.x * down.y, across.y * across.y + down.y * down.y);
}
#endif

void add(int light, vec3 wi, vec3 wo, float weight, vec3 pixel) {
  if (!(wi.z > 0.0 && wo.z > 0.0)) return;
  if (u_output == 1) {
    if (light == u_active) directions = vec4(wi.xy, wo.xy);
    return;
  }
#ifdef FILTERED
  sum += reflected_over(wi, wo, footprint_of_light(wi, u_light_radius[light]) + pixel) * weight;
#else
  sum += reflected(wi, wo) * weight;
#endif
}

void finish() {
  out_value = u_output == 1 ? directions : vec4(sum, !seen ? -1.0 : answered ? 0.0 : 1.0);
}

${SKY}
// Called for every pixel, for the sake of derivatives; \`hit\` tells whether the surface is there.
void shade(Point p, bool hit) {
  seen = hit;
  vec3 t = u_turn.x * p.tangent + u_turn.y * p.bitangent;
  vec3 b = u_turn.x * p.bitangent - u_turn.y * p.tangent;
  vec3 wo = vec3(dot(t, p.to_viewer), dot(b, p.to_viewer), dot(p.normal, p.to_viewer));
#ifdef FILTERED
  // Not across an edge: there pixels are sampled.
  bool smooth_pixel = 0.2887 * (length(dFdx(p.normal)) + length(dFdy(p.normal))) < 0.348;
#endif
  for (int i = 0; i < ${LIGHTS_MAX}; i++) {
    if (i >= u_lights) break;
    vec3 direction = u_light[i].xyz;
    vec3 wi = vec3(dot(t, direction), dot(b, direction), dot(p.normal, direction));
    vec3 pixel = vec3(0.0);
#ifdef FILTERED
    vec2 change = wi.xy + wo.xy;
    pixel = pixel_footprint(dFdx(change), dFdy(change));
    if (!smooth_pixel) pixel = vec3(0.0);
#endif
    if (hit && wi.z > 0.0 && wo.z > 0.0) {
      float open = lit(i);
      if (open > 0.0) add(i, wi, wo, u_light[i].w * wi.z * open, pixel);
    }
  }
#ifdef SURROUNDED
  if (hit && u_sky > 0.0 && u_output == 0 && wo.z > 0.0) add_sky(t, b, p.normal, wo);
#endif
}
`;

/** Lights reach every point of a convex shape. */
export const ALWAYS_LIT = `
float lit(int light) { return 1.0; }
float open_towards(vec3 direction) { return 1.0; }
`;

/** Rays of the camera for shapes that cast their own. */
export const RAY = `
in vec2 v_clip;
uniform mat4 u_from_clip;
void camera_ray(out vec3 origin, out vec3 direction) {
  vec4 near = u_from_clip * vec4(v_clip, -1.0, 1.0);
  vec4 far = u_from_clip * vec4(v_clip, 1.0, 1.0);
  origin = near.xyz / near.w;
  direction = normalize(far.xyz / far.w - origin);
}
`;
