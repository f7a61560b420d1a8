// A snake: a coiled, tapering body of rings around a centre line, covered with scales. The same body as in the program's
// pictures, ring by ring.

import { BufferAttribute, BufferGeometry } from 'three';
import { dot, normalise, type Vec3 } from '../light/samples';
import type { Body } from './body';
import { SNAKE_VIEW } from './frames';
import { chanceTexture, SCALES } from './scales';
import { OCCLUSION, occlusion } from './occlusion';
import { SHADOWS, ShadowMaps } from './shadows';

const ELEVATION_DEG = 52;
export const BODY_RADIUS = 0.13;
/** Scales around the body. */
export const COLUMNS = 15;
const SCALE_ASPECT = 1.5;
const RINGS = 1400;
const SIDES = 60;
const TAU = 2 * Math.PI;

const plus = (a: Vec3, b: Vec3, s: number): Vec3 => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
const cross = (a: Vec3, b: Vec3): Vec3 => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

interface Ring {
  centre: Vec3;
  /** Unit vector towards the tail. */
  along: Vec3;
  radius: number;
  /** Half height over half width. */
  height: number;
  /** Rings of scales since the head. */
  scales: number;
}

/** Points that pull the centre line, tail to head; X to the right, Y away from the viewer, Z up. */
function controls(): Vec3[] {
  const points: Vec3[] = [];
  for (let step = 0; step <= 46; step++) {
    const turns = (2.3 * step) / 46;
    const angle = TAU * turns - 2.2;
    const radius = 0.83 - 0.215 * turns;
    points.push([radius * Math.cos(angle), 0.95 * radius * Math.sin(angle), BODY_RADIUS + 0.17 * Math.max(turns - 0.55, 0)]);
  }
  const top = points[points.length - 1][2];
  points.push([0.3, 0.18, top + 0.08], [0.17, 0.3, top + 0.15], [-0.02, 0.29, top + 0.18], [-0.18, 0.19, top + 0.17], [-0.3, 0.06, top + 0.14]);
  return points;
}

function spline(points: Vec3[], t: number): Vec3 {
  const at = Math.min(t * (points.length - 3), points.length - 3 - 1e-9);
  const first = Math.floor(at);
  const f = at - first;
  const g = 1 - f;
  const weights = [g ** 3, 3 * f ** 3 - 6 * f * f + 4, -3 * f ** 3 + 3 * f * f + 3 * f + 1, f ** 3];
  return weights.reduce((sum, weight, k) => plus(sum, points[first + k], weight / 6), [0, 0, 0] as Vec3);
}

/** Radius and flattening at a share of the length from the head (0) to the tail (1). */
function thickness(share: number): [number, number] {
  const smooth = (low: number, high: number) => {
    const x = Math.min(1, Math.max(0, (share - low) / (high - low)));
    return x * x * (3 - 2 * x);
  };
  const head = 0.052;
  const trunk = 0.7 + 0.3 * smooth(0.05, 0.3);
  const skull = 0.16 * (1 - smooth(0.022, head));
  const snout = Math.sqrt(Math.max(0, 1 - (1 - Math.min(share / 0.03, 1)) ** 2));
  const thin = Math.min((1 - share) / 0.33, 1);
  const tail = (thin * (2 - thin)) ** 0.85;
  return [BODY_RADIUS * (trunk + skull) * snout * tail, 0.92 - 0.22 * (1 - smooth(0.015, head))];
}

/** Rings from head to tail. */
export function rings(): Ring[] {
  const points = controls();
  const centres = Array.from({ length: RINGS + 1 }, (_, k) => spline(points, 1 - k / RINGS));
  const lengths = [0];
  for (let k = 1; k <= RINGS; k++) {
    const step = plus(centres[k], centres[k - 1], -1);
    lengths.push(lengths[k - 1] + Math.hypot(...step));
  }
  let scales = 0;
  return centres.map((centre, k) => {
    const [before, after] = [Math.max(k - 1, 0), Math.min(k + 1, RINGS)];
    const [radius, height] = thickness(lengths[k] / lengths[RINGS]);
    const ringLength = (0.5 * SCALE_ASPECT * TAU * Math.max(radius, 0.3 * BODY_RADIUS)) / COLUMNS;
    scales += (lengths[k] - lengths[before]) / ringLength;
    return { centre, along: normalise(plus(centres[after], centres[before], -1)), radius, height, scales };
  });
}

/** Place on a ring at an angle from its ridge. */
function skin(ring: Ring, angle: number): Vec3 {
  const up = normalise(plus([0, 0, 1], ring.along, -ring.along[2]));
  const side = cross(up, ring.along);
  const out = plus(ring.centre, up, ring.radius * ring.height * Math.cos(angle));
  return plus(out, side, ring.radius * Math.sin(angle));
}

/** From the ground to the picture's world. */
function toWorld([x, y, z]: Vec3): Vec3 {
  const angle = (ELEVATION_DEG * Math.PI) / 180;
  const [sin, cos] = [Math.sin(angle), Math.cos(angle)];
  return [x, y * sin + z * cos, -y * cos + z * sin];
}

/** The body: places, normals, directions along it, and coordinates of scales. */
export function snakeGeometry(): { geometry: BufferGeometry; scaleRings: number } {
  const all = rings();
  const count = (RINGS + 1) * (SIDES + 1);
  const arrays = { position: new Float32Array(3 * count), normal: new Float32Array(3 * count), tangent: new Float32Array(3 * count), uv: new Float32Array(2 * count) };
  all.forEach((ring, k) => {
    const [before, after] = [all[Math.max(k - 1, 0)], all[Math.min(k + 1, RINGS)]];
    for (let side = 0; side <= SIDES; side++) {
      const a = (TAU * side) / SIDES - Math.PI;
      const along = plus(skin(after, a), skin(before, a), -1);
      const around = plus(skin(ring, a + 1e-4), skin(ring, a - 1e-4), -1);
      const raw = cross(along, around);
      const tip: Vec3 = k === 0 ? [-ring.along[0], -ring.along[1], -ring.along[2]] : ring.along;
      const normal = normalise(toWorld(dot(raw, raw) > 0 ? raw : tip));
      const flat = toWorld(along);
      const tangent = plus(flat, normal, -dot(flat, normal));
      const at = k * (SIDES + 1) + side;
      arrays.position.set(toWorld(skin(ring, a)), 3 * at);
      arrays.normal.set(normal, 3 * at);
      arrays.tangent.set(dot(tangent, tangent) > 0 ? normalise(tangent) : [0, 0, 0], 3 * at);
      arrays.uv.set([ring.scales, (COLUMNS * a) / TAU], 2 * at);
    }
  });
  const index = new Uint32Array(6 * RINGS * SIDES);
  let next = 0;
  for (let k = 0; k < RINGS; k++) {
    for (let side = 0; side < SIDES; side++) {
      const [a, b] = [k * (SIDES + 1) + side, (k + 1) * (SIDES + 1) + side];
      index.set([a, b, b + 1, a, b + 1, a + 1], next);
      next += 6;
    }
  }
  const geometry = new BufferGeometry();
  geometry.setIndex(new BufferAttribute(index, 1));
  for (const [name, array] of Object.entries(arrays)) geometry.setAttribute(name, new BufferAttribute(array, name === 'uv' ? 2 : 3));
  return { geometry, scaleRings: Math.ceil(all[RINGS].scales) + 2 };
}

const VERTEX = `
in vec3 position;
in vec3 normal;
in vec3 tangent;
in vec2 uv;
uniform mat4 u_to_clip;
out vec3 v_place;
out vec3 v_normal;
out vec3 v_tangent;
out vec2 v_uv;
void main() {
  v_place = position;
  v_normal = normal;
  v_tangent = tangent;
  v_uv = uv;
  gl_Position = u_to_clip * vec4(position, 1.0);
}
`;

const FRAGMENT = `
${SHADOWS}
${OCCLUSION}
${SCALES}
in vec3 v_normal;
in vec3 v_tangent;
in vec2 v_uv;
uniform mat4 u_from_clip;
uniform vec2 u_size;
void main() {
  vec3 smooth_normal = normalize(v_normal);
  shadow_place(v_place, smooth_normal);
  vec3 t = normalize(v_tangent - smooth_normal * dot(smooth_normal, v_tangent));
  vec3 b = cross(smooth_normal, t);
  vec2 rise;
  bool on_scale = scale_slopes(v_uv, rise);
  vec3 normal = normalize(smooth_normal - rise.x * t - rise.y * b);
  vec3 tangent = normalize(t - normal * dot(normal, t));
  vec2 clip = 2.0 * gl_FragCoord.xy / u_size - 1.0;
  vec4 near = u_from_clip * vec4(clip, -1.0, 1.0);
  vec3 to_viewer = normalize(near.xyz / near.w - v_place);
  shade(Point(tangent, cross(normal, tangent), normal, to_viewer), on_scale);
  seen = true;
  finish();
}
`;

export function snakeBody(): Body {
  const { geometry, scaleRings } = snakeGeometry();
  const shadows = new ShadowMaps(geometry, { centre: [0, 0.1, 0], radius: 1.25 });
  return {
    geometry,
    view: SNAKE_VIEW,
    vertex: VERTEX,
    fragment: FRAGMENT,
    uniforms: { ...shadows.uniforms, u_chance: { value: chanceTexture(scaleRings, COLUMNS) } },
    occlusion: occlusion(geometry),
    forgetShadows: () => shadows.forget(),
    drawShadows: (renderer, lights) => shadows.draw(renderer, lights),
  };
}
