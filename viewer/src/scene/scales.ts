// Scales on a body: rows of overlapping rounded rhombs, each a little facet with an edge. The same pattern as in the program's
// pictures.

import { DataTexture, FloatType, NearestFilter, RGFormat } from 'three';

const MASK = (1n << 64n) - 1n;

/** Two numbers in [-1, 1) that belong to a scale: SplitMix64 of its place. */
export function chance(ring: number, column: number): [number, number] {
  let state = (BigInt(ring) * 0x1_0000n + BigInt(column)) & MASK;
  const next = (): number => {
    state = (state + 0x9e3779b97f4a7c15n) & MASK;
    let z = state;
    z = ((z ^ (z >> 30n)) * 0xbf58476d1ce4e5b9n) & MASK;
    z = ((z ^ (z >> 27n)) * 0x94d049bb133111ebn) & MASK;
    z ^= z >> 31n;
    return Number(z >> 11n) / 2 ** 52 - 1;
  };
  return [next(), next()];
}

/** The chance slopes of all scales: a column of the texture for each around the body, a row for each ring. */
export function chanceTexture(rings: number, columns: number): DataTexture {
  const data = new Float32Array(2 * rings * columns);
  for (let ring = 0; ring < rings; ring++) for (let column = 0; column < columns; column++) data.set(chance(ring, column), 2 * (ring * columns + column));
  const texture = new DataTexture(data, columns, rings, RGFormat, FloatType);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

/** `scale_slopes`: how fast the scale rises along and around the body; false on the skin between scales. */
export const SCALES = `
uniform highp sampler2D u_chance;
const float OUTLINE = 1.45;
const float RIM = 0.62;
const float RIM_SLOPE = 0.35;
const float SKIN = 0.93;
const float RISE = 0.05;
const float FLATNESS = 0.5;
const float UNEVEN = 0.02;

struct Scale {
  int ring;
  int column;
  vec2 place;
  float outline;
};

Scale on_ring(int ring, vec2 at) {
  int columns = textureSize(u_chance, 0).x;
  float shift = (ring & 1) == 1 ? 0.5 : 0.0;
  float column = floor(at.y - shift + 0.5);
  vec2 place = vec2(at.x - float(ring), 2.0 * (at.y - shift - column));
  vec2 powers = pow(max(abs(place), vec2(1e-12)), vec2(OUTLINE));
  int wrapped = int(column) - columns * int(floor(column / float(columns)));
  return Scale(ring, wrapped, place, pow(powers.x + powers.y, 1.0 / OUTLINE));
}

bool scale_slopes(vec2 at, out vec2 rise) {
  int ring = int(floor(at.x));
  Scale scale = on_ring(ring, at);
  if (scale.outline > 1.0) scale = on_ring(ring + 1, at);
  rise = vec2(0.0);
  if (scale.outline > SKIN) return false;
  ivec2 size = textureSize(u_chance, 0);
  float bend = clamp((scale.outline - RIM) / (SKIN - RIM), 0.0, 1.0);
  float fall = RIM_SLOPE * bend * bend;
  vec2 away = sign(scale.place) * pow(max(abs(scale.place), vec2(1e-12)), vec2(OUTLINE - 1.0));
  float roundness = 3.14159265 / float(size.x) * scale.place.y;
  vec2 uneven = texelFetch(u_chance, ivec2(scale.column, clamp(scale.ring, 0, size.y - 1)), 0).xy;
  rise = vec2(RISE, FLATNESS * tan(roundness)) - fall * away + UNEVEN * uneven;
  return true;
}
`;
