// Shapes that the shader meets with rays: the ball and the flat square.

import { ALWAYS_LIT, RAY } from '../gl/shade';
import { BALL_RADIUS } from './frames';

/** A ball seen from anywhere; the structure's x axis follows the circles of latitude eastwards, y points to the pole at +y. */
export const BALL = `
${RAY}
${ALWAYS_LIT}
void main() {
  vec3 origin, direction;
  camera_ray(origin, direction);
  float along = dot(origin, direction);
  vec3 nearest = origin - along * direction;
  float apart2 = dot(nearest, nearest);
  float radius2 = ${(BALL_RADIUS * BALL_RADIUS).toFixed(8)};
  vec3 place = nearest - sqrt(max(0.0, radius2 - apart2)) * direction;
  vec3 normal = normalize(place);
  vec3 east = vec3(normal.z, 0.0, -normal.x);
  float size = length(east);
  vec3 tangent = size > 1e-9 ? east / size : vec3(1.0, 0.0, 0.0);
  shade(Point(tangent, cross(normal, tangent), normal, -direction), apart2 < radius2);
  finish();
}
`;

/** A flat square. */
export const PATCH = `
${RAY}
${ALWAYS_LIT}
uniform vec3 u_tangent;
uniform vec3 u_bitangent;
uniform vec3 u_normal;
uniform float u_half_width;
void main() {
  vec3 origin, direction;
  camera_ray(origin, direction);
  float approach = -dot(u_normal, direction);
  vec3 place = origin + direction * (dot(u_normal, origin) / max(approach, 1e-9));
  bool hit = approach > 0.0 && max(abs(dot(u_tangent, place)), abs(dot(u_bitangent, place))) <= u_half_width;
  shade(Point(u_tangent, u_bitangent, u_normal, -direction), hit);
  finish();
}
`;
