// Cameras of the shapes: where each is seen from before anyone turns it, the same as in the program's pictures.

import type { Vec3 } from '../light/samples';

/** A camera: half the picture's side is `half` in the plane one unit ahead, or in the world for parallel rays. */
export interface View {
  position: Vec3;
  target: Vec3;
  parallel: boolean;
  half: number;
  near: number;
  far: number;
}

const degrees = Math.PI / 180;

/** The ball's radius as a share of half the picture's side. */
export const BALL_RADIUS = 0.95;

export const BALL_VIEW: View = { position: [0, 0, 5], target: [0, 0, 0], parallel: true, half: 1, near: 1, far: 9 };

/** A flat square: its sides, the camera's distance, and how far its upper edge leans away. */
export interface Patch {
  width_mm: number;
  distance_mm: number;
  tilt_deg: number;
}

/** Axes of the square: along its edges, and its normal. */
export function patchAxes({ tilt_deg }: Patch): { tangent: Vec3; bitangent: Vec3; normal: Vec3 } {
  const [sin, cos] = [Math.sin(tilt_deg * degrees), Math.cos(tilt_deg * degrees)];
  return { tangent: [1, 0, 0], bitangent: [0, cos, -sin], normal: [0, sin, cos] };
}

const PATCH_MARGIN = 1.04;

/** The view that just holds the square. */
export function patchView(patch: Patch): View {
  const { tangent, bitangent } = patchAxes(patch);
  const half = 0.5 * patch.width_mm;
  let largest = 0;
  for (const s of [-half, half]) {
    for (const t of [-half, half]) {
      const corner = tangent.map((c, i) => s * c + t * bitangent[i]);
      const scale = patch.distance_mm / (patch.distance_mm - corner[2]);
      largest = Math.max(largest, scale * Math.abs(corner[0]), scale * Math.abs(corner[1]));
    }
  }
  const { distance_mm } = patch;
  return {
    position: [0, 0, distance_mm],
    target: [0, 0, 0],
    parallel: false,
    half: (PATCH_MARGIN * largest) / distance_mm,
    near: 0.05 * distance_mm,
    far: 4 * distance_mm,
  };
}

export const SNAKE_VIEW: View = {
  position: [0.02, 0.08, 6],
  target: [0.02, 0.08, 0],
  parallel: false,
  half: Math.tan(0.5 * 17.4 * degrees),
  near: 3,
  far: 9,
};
