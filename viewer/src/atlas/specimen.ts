// What atlas.json and specimen.json say, as far as the page reads them.

import type { AtlasFiles } from './files';
import type { MeasuredColumn } from './measured';

export interface AtlasIndex {
  name: string;
  program_version: string;
  specimens: { name: string; species?: string }[];
  files: { path: string; sha256?: string }[];
}

export interface StoredArray {
  file: string;
  /** Value = stored number times scale. */
  scale: number;
}

export interface Axis {
  first: number;
  last: number;
  samples: number;
}

export interface StoredLobe {
  radius_max: number;
  radius: Axis;
  t: Axis;
  coherent: StoredArray;
  cross: { u: Axis; v: Axis; patches: StoredArray[] } | null;
}

export interface StoredTables {
  basis: 'chebyshev' | 'taylor';
  storage: 'half' | 'float';
  u: Axis;
  v: Axis;
  usable_radius: number;
  /** None where those of XYZ follow from spectral ones under this light. */
  tables: StoredArray[];
  derived_under?: { illuminant: StoredIlluminant } | null;
  served?: { size: number; first: [number, number]; range: StoredArray };
  lobe: StoredLobe | null;
}

export interface Dispersion {
  name: string;
  wavelength_nm: number[];
  n: number[];
  k: number[];
}

export interface StoredSpectral {
  shortest_nm: number;
  longest_nm: number;
  sigma_nm: number;
  half_height_range_nm: number;
  usable_radius: number;
  xi_per_nm: Axis;
  eta_per_nm: Axis;
  /** How many tables, three to an image. */
  tables: number;
  images: StoredArray[];
  dispersion?: Dispersion | null;
  lobe: {
    /** At the shortest wavelength. */
    sigma_nm: number;
    /** Whether it grows in proportion to the wavelength. */
    sigma_grows?: boolean;
    half_abs_w: Axis;
    power: StoredArray;
    cross?: { patches: number; xi_per_nm: Axis; eta_per_nm: Axis; images: StoredArray[] } | null;
  } | null;
}

export type StoredMaterial =
  | 'ideal'
  | { dielectric: { n: number } }
  | { conductor: { n: number; k: number } };

export type StoredIlluminant =
  | string
  | { f: number }
  | { lines: { wavelength_nm: number; power: number }[] }
  | { tabulated: { wavelength_nm: number[]; power: number[] } };

export interface Specimen {
  schema: number;
  name: string;
  species?: string;
  provenance?: { file_name: string; sha256?: string; size: [number, number]; pitch_nm: [number, number] }[];
  statistics?: {
    rms_height_nm: number;
    peak_to_valley_nm: number;
    dominant_periods?: { period_nm: number; direction_deg: number; relative_power: number }[];
  }[];
  optics: {
    illuminant: StoredIlluminant;
    wavelength_nm: [number, number];
    sigma_nm: number;
    lobe_sigma_nm?: number;
    source_deg?: number;
    material: StoredMaterial;
    factor: 'vector' | 'scalar';
    shadowing: boolean;
  };
  pigment?: { xyz_per_sr: [number, number, number] } | null;
  tables: StoredTables;
  spectral?: StoredSpectral | null;
  warnings?: string[];
  errors?: { what: string; region: string; p95: number | null }[];
}

/** What lies in the atlas only for this page. */
export interface ViewerFile {
  schema: 1;
  /** Those that the page shows. */
  specimens?: string[];
  heights?: Record<string, string | null>;
  /** What was measured of a specimen. */
  measured?: Record<string, MeasuredColumn[]>;
}

export const readIndex = (files: AtlasFiles): Promise<AtlasIndex> => files.json<AtlasIndex>('atlas.json');
export const readSpecimen = (files: AtlasFiles, name: string): Promise<Specimen> =>
  files.json<Specimen>(`${name}/specimen.json`);
