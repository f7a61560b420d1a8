// Packed tables as textures and uniforms.

import {
  ClampToEdgeWrapping,
  DataArrayTexture,
  DataTexture,
  FloatType,
  HalfFloatType,
  LinearFilter,
  NearestFilter,
  RGBAFormat,
  Vector2,
  Vector4,
  type IUniform,
} from 'three';
import type { FloatImage, Layers, PackedSpectral, PackedTables, SpectralParams, TableParams } from '../atlas/pack';
import { BINDING } from './library';

export type Uniforms = Record<string, IUniform>;

export function halfLayers({ width, height, count, texels }: Layers): DataArrayTexture {
  const texture = new DataArrayTexture(texels, width, height, count);
  texture.format = RGBAFormat;
  texture.type = HalfFloatType;
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.wrapS = texture.wrapT = ClampToEdgeWrapping;
  texture.generateMipmaps = false;
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

export function upload(packed: PackedTables | PackedSpectral): Uploaded {
  const textures = [halfLayers(packed.tables), halfLayers(packed.cross), floatTexture(packed.lobe)];
  const values = [blockOf(packed.params), ...textures];
  return {
    uniforms: Object.fromEntries(BINDING.map((name, i) => [name, { value: values[i] }])),
    dispose: () => textures.forEach((texture) => texture.dispose()),
  };
}
