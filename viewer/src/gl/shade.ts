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
 * Follows the evaluation. \`add\` collects one light; \`shade\` does so for all lights on a point of a surface.
 *
 * Output 0 is XYZ, with the share of unanswered directions in the fourth channel; output 1 the two directions of the chosen
 * light: x, y of wi and of wo, 9 where there is none.
 */
export const SHADE = `
layout(location = 0) out highp vec4 out_value;
uniform int u_output;
uniform int u_active;
uniform int u_lights;
uniform vec4 u_light[${LIGHTS_MAX}];
uniform vec2 u_turn;

struct Point {
  vec3 tangent;
  vec3 bitangent;
  vec3 normal;
  vec3 to_viewer;
};

vec3 sum = vec3(0.0);
vec4 directions = vec4(9.0);

float lit(int light);

void add(int light, vec3 wi, vec3 wo, float weight) {
  if (!(wi.z > 0.0 && wo.z > 0.0)) return;
  if (u_output == 1) {
    if (light == u_active) directions = vec4(wi.xy, wo.xy);
    return;
  }
  sum += reflected(wi, wo) * weight;
}

void finish() {
  out_value = u_output == 1 ? directions : vec4(sum, answered ? 0.0 : 1.0);
}

void shade(Point p) {
  vec3 t = u_turn.x * p.tangent + u_turn.y * p.bitangent;
  vec3 b = u_turn.x * p.bitangent - u_turn.y * p.tangent;
  vec3 wo = vec3(dot(t, p.to_viewer), dot(b, p.to_viewer), dot(p.normal, p.to_viewer));
  for (int i = 0; i < ${LIGHTS_MAX}; i++) {
    if (i >= u_lights) break;
    vec3 direction = u_light[i].xyz;
    vec3 wi = vec3(dot(t, direction), dot(b, direction), dot(p.normal, direction));
    if (wi.z > 0.0 && wo.z > 0.0) {
      float open = lit(i);
      if (open > 0.0) add(i, wi, wo, u_light[i].w * wi.z * open);
    }
  }
}
`;

/** Lights reach every point of a convex shape. */
export const ALWAYS_LIT = `
float lit(int light) { return 1.0; }
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
