// What the page shows, as one plain object: all views follow from it, and the address of the page holds it.

import type { IlluminantName } from './light/illuminants';
import type { Vec3 } from './light/samples';

export type Shape = 'ball' | 'snake' | 'patch' | 'screen' | 'map' | 'model';
export type Surroundings = 'none' | 'overcast' | 'window' | 'own';
export type Motion = 'none' | 'light' | 'turntable';

export interface Light {
  /** Direction to the light in the world; any length but zero. */
  direction: Vec3;
  /** Full angle of its disc in degrees; 0 for a point. */
  diameter_deg: number;
  /** Relative irradiance on a surface that faces it. */
  irradiance: number;
}

export interface State {
  /** Name of the specimen; the atlas's first where empty. */
  specimen: string;
  shape: Shape;
  lights: Light[];
  /** Which light is dragged and asked for. */
  active: number;
  /** The camera's turn about the vertical and the horizontal in degrees, and its nearness as a factor. */
  view: { azimuth_deg: number; elevation_deg: number; zoom: number };
  /** Stops: 0 shows a white wall that faces a light of irradiance 1 as white. Null asks for the automatic one. */
  exposure: number | null;
  /** "atlas" paints as the atlas's pictures do; "clip" cuts channels at 0 and 1. */
  tone: 'atlas' | 'clip';
  illuminant: IlluminantName;
  /** Wavelength of the laser. */
  laser_nm: number;
  /** The sun's height above the horizon. */
  sun_deg: number;
  /** Turns the structure on the surface. */
  turn_deg: number;
  /** Turns the object about the vertical; lights and camera stay. */
  spin_deg: number;
  /** Shrinks the structure; needs spectral tables. */
  scale: number;
  /** How many tables are used; null for all. */
  tables: number | null;
  /** Shows the difference from all tables, in place of the picture. */
  difference: boolean;
  /** Look-ups between texels: "spline" is what the atlas is promised for, linear where it is not promised for splines. */
  interpolation: 'spline' | 'bilinear' | 'cubic';
  /** One look-up for a whole light and pixel, or points of them; cubic look-ups take points. */
  look_ups: 'filtered' | 'points';
  pigment: boolean;
  patch: { width_mm: number; distance_mm: number; tilt_deg: number };
  screen: { distance_mm: number; width_mm: number; beam_mm: number; incidence_deg: number };
  /** Samples of each light that has a size, and positions within a pixel, once the picture stands still. */
  light_samples: number;
  pixel_samples: number;
  /** Light from all around, besides the lights. */
  environment: Surroundings;
  environment_samples: number;
  /** The place that is asked, in picture coordinates: x to the right, y up, the square [-1, 1] in the middle. */
  pointer: { x: number; y: number };
  polar_log: boolean;
  motion: Motion;
  /** Side of a square picture in pixels; null fills the page. */
  size_px: number | null;
}

export const DEFAULTS: State = {
  specimen: '',
  shape: 'snake',
  lights: [{ direction: [0.3, 0.2, 1], diameter_deg: 0.53, irradiance: 1 }],
  active: 0,
  view: { azimuth_deg: 0, elevation_deg: 0, zoom: 1 },
  exposure: null,
  tone: 'atlas',
  illuminant: 'tables',
  laser_nm: 633,
  sun_deg: 45,
  turn_deg: 0,
  spin_deg: 0,
  scale: 1,
  tables: null,
  difference: false,
  interpolation: 'spline',
  look_ups: 'filtered',
  pigment: true,
  patch: { width_mm: 20, distance_mm: 60, tilt_deg: 30 },
  screen: { distance_mm: 100, width_mm: 200, beam_mm: 2, incidence_deg: 0 },
  light_samples: 16,
  pixel_samples: 16,
  environment: 'none',
  environment_samples: 64,
  pointer: { x: -0.72, y: 0 },
  polar_log: true,
  motion: 'none',
  size_px: null,
};

const copy = <T>(value: T): T => structuredClone(value);

/** The state of an address's fragment; whatever it lacks or spoils is that of the defaults. */
export function fromFragment(fragment: string): State {
  const state = copy(DEFAULTS);
  const text = fragment.replace(/^#/, '');
  if (!text) return state;
  try {
    return merged(state, JSON.parse(decodeURIComponent(text)) as Partial<State>);
  } catch {
    return state;
  }
}

/** What differs from the defaults, as a fragment. */
export function toFragment(state: State): string {
  const different = Object.fromEntries(
    Object.entries(state).filter(([key, value]) => JSON.stringify(value) !== JSON.stringify(DEFAULTS[key as keyof State])),
  );
  return Object.keys(different).length ? `#${encodeURIComponent(JSON.stringify(different))}` : '';
}

const CHOICES: Partial<Record<keyof State, readonly string[]>> = {
  shape: ['ball', 'snake', 'patch', 'screen', 'map', 'model'],
  tone: ['atlas', 'clip'],
  illuminant: ['tables', 'D65', 'A', 'E', 'F11', 'LED', 'laser', 'sun'],
  interpolation: ['spline', 'bilinear', 'cubic'],
  look_ups: ['filtered', 'points'],
  motion: ['none', 'light', 'turntable'],
  environment: ['none', 'overcast', 'window', 'own'],
};

const RANGES: Partial<Record<keyof State, readonly [number, number]>> = {
  exposure: [-20, 30],
  laser_nm: [380, 780],
  sun_deg: [1, 90],
  turn_deg: [-360, 360],
  spin_deg: [-3600, 3600],
  scale: [0.25, 1],
  tables: [1, 256],
  light_samples: [1, 1024],
  pixel_samples: [1, 1024],
  environment_samples: [1, 4096],
  size_px: [1, 4096],
  active: [0, 3],
};

/** A state with some of its fields replaced; those that make no sense are left as they were. */
export function merged(state: State, change: Partial<State>): State {
  const next = copy(state) as unknown as Record<string, unknown>;
  for (const [key, value] of Object.entries(change)) {
    if (!(key in DEFAULTS)) continue;
    const now = next[key];
    const plain = typeof now === 'object' && now !== null && !Array.isArray(now);
    const wanted = plain && typeof value === 'object' ? { ...now, ...value } : value;
    if (sound(key as keyof State, wanted)) next[key] = copy(wanted);
  }
  const out = next as unknown as State;
  out.active = Math.min(out.active, out.lights.length - 1);
  return out;
}

function sound(key: keyof State, value: unknown): boolean {
  if (key === 'lights') return soundLights(value);
  if (value === null) return key === 'exposure' || key === 'tables' || key === 'size_px';
  const choices = CHOICES[key];
  if (choices) return choices.includes(value as string);
  const range = RANGES[key];
  if (range) return typeof value === 'number' && value >= range[0] && value <= range[1];
  const given = DEFAULTS[key];
  if (typeof value !== typeof given) return false;
  if (typeof value !== 'object') return true;
  return Object.keys(given as object).every((name) => Number.isFinite((value as Record<string, unknown>)[name]));
}

function soundLights(value: unknown): boolean {
  if (!Array.isArray(value) || value.length < 1 || value.length > 4) return false;
  return value.every((light: Light) => {
    const { direction, diameter_deg, irradiance } = light ?? {};
    return (
      Array.isArray(direction) &&
      direction.length === 3 &&
      direction.every(Number.isFinite) &&
      Math.hypot(...direction) > 0 &&
      diameter_deg >= 0 &&
      diameter_deg <= 90 &&
      irradiance >= 0 &&
      Number.isFinite(irradiance)
    );
  });
}
