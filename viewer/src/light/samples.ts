// Points of disc-shaped lights and of a pixel: the same fixed sets as in the program's pictures, so that both see the same.

export type Vec3 = [number, number, number];

const RECURRENCE = [0.8566748838545029, 0.733891856627126, 0.6287067210378086, 0.5385972572236101];
const GOLDEN = 0.38196601125010515;

const fraction = (x: number): number => x - Math.floor(x);

export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

export function normalise(v: Vec3): Vec3 {
  const length = Math.hypot(...v);
  return [v[0] / length, v[1] / length, v[2] / length];
}

/** A point of [0, 1)^4; index 0 is the middle. */
export const sequencePoint = (index: number): number[] => RECURRENCE.map((step) => fraction(0.5 + step * index));

/** Radius squared and angle of point `index` of `count` on the unit disc; a single one is the centre. */
export function sunflower(index: number, count: number): [number, number] {
  if (count <= 1) return [0, 0];
  return [(index + 0.5) / count, 2 * Math.PI * fraction(GOLDEN * index)];
}

/** Position within the pixel of a sample: x to the right, y up, in [-0.5, 0.5). */
export function pixelOffset(index: number, count: number): [number, number] {
  if (count <= 1) return [0, 0];
  const [x, y] = sequencePoint(index);
  return [x - 0.5, y - 0.5];
}

/** The shortest turn that takes +z to a unit vector, applied to a vector. */
function aboutAxis([x, y, z]: Vec3, v: Vec3): Vec3 {
  if (z < -1 + 1e-12) return [v[0], -v[1], -v[2]];
  const s = 1 / (1 + z);
  const tangent: Vec3 = [1 - x * x * s, -x * y * s, -x];
  const bitangent: Vec3 = [-x * y * s, 1 - y * y * s, -y];
  return [0, 1, 2].map((i) => v[0] * tangent[i] + v[1] * bitangent[i] + v[2] * [x, y, z][i]) as Vec3;
}

/** The direction to a point of a light's disc: equal areas of the disc are equal solid angles. */
export function directionTo(axis: Vec3, diameter_deg: number, [radiusSquared, angle]: [number, number]): Vec3 {
  const halfAngle = (0.5 * diameter_deg * Math.PI) / 180;
  const versine = radiusSquared * 2 * Math.sin(0.5 * halfAngle) ** 2;
  const sine = Math.sqrt(versine * (2 - versine));
  return aboutAxis(normalise(axis), [sine * Math.cos(angle), sine * Math.sin(angle), 1 - versine]);
}

/**
 * Irradiance on a surface that faces the sample, for each of `count` samples of a light of unit irradiance: its mean over
 * them, times their cosines, is 1.
 */
export function sampleIrradiance(axis: Vec3, diameter_deg: number, count: number): number {
  const unit = normalise(axis);
  let facing = 0;
  for (let i = 0; i < count; i++) facing += dot(directionTo(unit, diameter_deg, sunflower(i, count)), unit);
  return count / facing;
}
