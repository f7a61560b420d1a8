// Packed tables as textures and uniforms.

import {
  ClampToEdgeWrapping,
  CompressedArrayTexture,
  DataTexture,
  FloatType,
  HalfFloatType,
  LinearFilter,
  LinearMipmapNearestFilter,
  NearestFilter,
  RGBAFormat,
  Vector2,
  Vector4,
  type CompressedPixelFormat,
  type IUniform,
} from 'three';
import { lobeGaussians } from '../atlas/gaussians';
import { levelled, type Level } from '../atlas/levels';
import { hasMeans, hasSplines, isSpectral, type FloatImage, type Layers, type Packed, type SpectralParams, type TableParams } from '../atlas/pack';
import { BINDING, GAUSSIANS_BINDING } from './library';

export type Uniforms = Record<string, IUniform>;

/** What the tables of a specimen were made ready for. */
export type Readiness = 'plain' | 'filtered' | 'splines';

/** Layers with their levels. A texture of several levels is, to three, one that came compressed. */
function layersTexture({ width, height, count, texels, coarser = [] }: Layers & { coarser?: Level[] }): CompressedArrayTexture {
  const levels = [{ width, height, texels }, ...coarser].map((level) => ({ data: level.texels, width: level.width, height: level.height }));
  // Its format says that it is not.
  const texture = new CompressedArrayTexture(levels as never, width, height, count, RGBAFormat as unknown as CompressedPixelFormat, HalfFloatType);
  texture.magFilter = LinearFilter;
  // The shader names a level, and reads it linearly.
  texture.minFilter = coarser.length ? LinearMipmapNearestFilter : LinearFilter;
  texture.wrapS = texture.wrapT = ClampToEdgeWrapping;
  texture.needsUpdate = true;
  return texture;
}

export function floatTexture({ width, height, texels }: FloatImage): DataTexture {
  const texture = new DataTexture(texels, width, height, RGBAFormat, FloatType);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.generateMipmaps = false;
  texture.needsUpdate = true;
  return texture;
}

/** The uniforms of a specimen, and what they hold on the GPU. */
export interface Uploaded {
  uniforms: Uniforms;
  /** Takes the textures off the GPU. */
  dispose(): void;
}

const quads = (scales: Float32Array): Vector4[] =>
  Array.from({ length: scales.length / 4 }, (_, i) => new Vector4(...scales.subarray(4 * i, 4 * i + 4)));

function blockOf(params: TableParams | SpectralParams): Record<string, unknown> {
  return {
    ...params,
    permittivity: new Vector2(...params.permittivity),
    ...('pigment' in params ? { pigment: new Vector4(...params.pigment) } : {}),
    table_scales: quads(params.table_scales),
    cross_scales: quads(params.cross_scales),
  };
}

/** Tables for linear look-ups at points. */
export const upload = (packed: Packed): Uploaded => uploaded(packed, packed.tables, packed.cross, 0);

/** Tables for filtered look-ups too, and for those by splines where they are promised for these and these are asked for. */
export async function uploadReady(packed: Packed, readiness: Readiness): Promise<Uploaded> {
  if (readiness === 'plain' || !hasMeans(packed)) return upload(packed);
  const splines = readiness === 'splines' && hasSplines(packed);
  const [channels, count, patches] = isSpectral(packed) ? ([4, packed.count, packed.patches] as const) : ([3, undefined, undefined] as const);
  const tables = await levelled(packed.tables, { splines, channels, count });
  const cross = await levelled(packed.cross, { splines: false, channels, count: patches });
  return uploaded(packed, tables, cross, splines ? 1 : 0);
}

function uploaded(packed: Packed, tables: Layers, cross: Layers, look_up: number): Uploaded {
  const block = blockOf({ ...packed.params, look_up, table_scales: tables.scales, cross_scales: cross.scales });
  const textures = [layersTexture(tables), layersTexture(cross), floatTexture(packed.lobe)];
  const values: unknown[] = [block, ...textures];
  const uniforms: Uniforms = Object.fromEntries(BINDING.map((name, i) => [name, { value: values[i] }]));
  const gaussians = isSpectral(packed) ? null : floatTexture(lobeGaussians(packed.lobe));
  if (gaussians) uniforms[GAUSSIANS_BINDING] = { value: gaussians };
  return {
    uniforms,
    dispose: () => [...textures, ...(gaussians ? [gaussians] : [])].forEach((texture) => texture.dispose()),
  };
}
