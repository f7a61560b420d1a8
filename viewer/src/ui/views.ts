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
