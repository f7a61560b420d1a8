// Wavelengths over which spectral tables are summed under a light, as the shader reads them.

import { DataTexture, FloatType, NearestFilter, RGBAFormat } from 'three';
import { materialAt } from '../atlas/dispersion';
import type { Specimen } from '../atlas/specimen';
import { quadrature, wavelengthsNeeded, type Illuminant, type Quadrature } from '../light/illuminants';
import type { Uniforms } from './upload';

/** A wavelength that is asked for, and the material there. */
export interface Ask {
  nm: number;
  material: number;
  index_n: number;
  index_k: number;
  /** False outside of the material's table: there is no answer then. */
  known: boolean;
}

/** Wavelengths with the material's index at each. */
export function asksOf(specimen: Specimen | null, nm: number[]): Ask[] {
  return nm.map((at) => {
    const index = specimen ? materialAt(specimen, at) : null;
    return { nm: at, material: index?.material ?? 0, index_n: index?.index_n ?? 1, index_k: index?.index_k ?? 0, known: index !== null };
  });
}

/** As many wavelengths as the specimen's orders ask for; null where it has no spectral tables. */
export function quadratureOf({ spectral }: Specimen, light: Illuminant): Quadrature | null {
  if (!spectral) return null;
  return quadrature(light, [spectral.shortest_nm, spectral.longest_nm], wavelengthsNeeded(spectral, spectral.usable_radius));
}

/** Row 0 of the texture holds wavelengths and weights, row 1 the material's n, k and kind. */
export function quadratureUniforms(specimen: Specimen, { nm, weights }: Quadrature, structureScale: number): Uniforms {
  const asks = asksOf(specimen, nm);
  const data = new Float32Array(8 * nm.length);
  nm.forEach((at, i) => {
    data.set([at, ...(asks[i].known ? weights[i] : [0, 0, 0])], 4 * i);
    data.set([asks[i].index_n, asks[i].index_k, asks[i].material, 0], 4 * (nm.length + i));
  });
  const texture = new DataTexture(data, nm.length, 2, RGBAFormat, FloatType);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return { u_quadrature: { value: texture }, u_wavelengths: { value: nm.length }, u_structure_scale: { value: structureScale } };
}
