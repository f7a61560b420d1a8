// What the linked views are given, all at once, whenever something moves.

import type { Engine } from '../engine';
import type { Dominant } from '../light/colour';
import type { Xyz } from '../light/illuminants';
import type { Vec3 } from '../light/samples';
import type { State } from '../state';

/** The spot that is asked, and its answers. */
export interface Answer {
  wi: Vec3;
  wo: Vec3;
  /** Whether the directions were chosen with a measured spectrum, and not by the spot. */
  chosen: boolean;
  /** f in 1/sr under the picture's light; null where the tables have no answer. */
  xyz: Xyz | null;
  /** The same over the plane of incidence, at `PLANE_DEG`. */
  plane: (Xyz | null)[];
  /** The light's own XYZ, of a perfect mirror's relative colour. */
  white: Xyz;
  dominant: Dominant | null;
  /** Wavelengths in nm and f in 1/sr, with what was measured there; null without spectral tables. */
  spectrum: { nm: number[]; values: Float64Array; measured: (number | null)[] } | null;
}

export interface View {
  element: HTMLElement;
  update(state: State, engine: Engine, answer: Answer | null): void;
}

export const degrees = Math.PI / 180;

/** Viewing angles from the normal in degrees; positive ones lie on the side of the mirror direction. */
export const PLANE_DEG = Array.from({ length: 357 }, (_, i) => (i - 178) / 2);

/** Directions to the viewer in the plane of the normal and the light. */
export function planeOfIncidence(wi: Vec3): Vec3[] {
  const side = Math.hypot(wi[0], wi[1]);
  const [x, y] = side > 1e-6 ? [-wi[0] / side, -wi[1] / side] : [1, 0];
  return PLANE_DEG.map((angle) => {
    const [sin, cos] = [Math.sin(angle * degrees), Math.cos(angle * degrees)];
    return [sin * x, sin * y, cos];
  });
}
