// Light from all around: an image in longitude and latitude.

import { EXRLoader } from 'three/examples/jsm/loaders/EXRLoader.js';
import { HDRLoader } from 'three/examples/jsm/loaders/HDRLoader.js';
import { DataUtils, HalfFloatType, type DataTexture } from 'three';
import { floatTexture } from '../gl/upload';

/**
 * Radiance of each texel, row by row. The middle column is world +z, where the camera is; seen from the object, columns to the
 * right lie to the right, towards -x. The top row is +y.
 */
export interface Environment {
  width: number;
  height: number;
  radiance: Float32Array;
  /** Light up to the end of each row, as the integral of the radiance over directions. */
  rows: Float64Array;
}

/** An image that lights nothing, or is none. */
export class EnvironmentError extends Error {}

export function environment(width: number, height: number, radiance: Float32Array): Environment {
  if (width !== 2 * height) {
    throw new EnvironmentError(`It has ${width} x ${height} pixels, which is not all directions: twice as wide as high.`);
  }
  const rows = new Float64Array(height);
  let total = 0;
  for (let row = 0; row < height; row++) {
    let sum = 0;
    for (let x = 0; x < width; x++) {
      const value = radiance[row * width + x];
      if (!(value >= 0 && Number.isFinite(value))) throw new EnvironmentError('It holds values that are negative or not finite.');
      sum += value;
    }
    total += texelSolidAngle(row, height, width) * sum;
    rows[row] = total;
  }
  if (!(total > 0)) throw new EnvironmentError('It is black and lights nothing.');
  return { width, height, radiance, rows };
}

function texelSolidAngle(row: number, height: number, width: number): number {
  const edge = (at: number) => Math.cos((Math.PI * at) / height);
  return ((edge(row) - edge(row + 1)) * 2 * Math.PI) / width;
}

/** The integral of the radiance over all directions. */
export const scalarIrradiance = (sky: Environment): number => sky.rows[sky.height - 1];

/** An environment as the shader reads it: radiance with the share of its row's light up to each texel's end, and the rows. */
export interface SkyTextures {
  total: number;
  map: DataTexture;
  rows: DataTexture;
}

export function skyTextures(sky: Environment): SkyTextures {
  const { width, height, radiance, rows } = sky;
  const texels = new Float32Array(4 * width * height);
  for (let row = 0; row < height; row++) {
    const values = radiance.subarray(row * width, (row + 1) * width);
    const sum = values.reduce((s, v) => s + v, 0);
    let running = 0;
    values.forEach((value, x) => {
      running += value;
      texels.set([value, sum > 0 ? running / sum : 1], 4 * (row * width + x));
    });
  }
  const rowTexels = new Float32Array(4 * height);
  rows.forEach((value, row) => (rowTexels[4 * row] = value));
  return {
    total: scalarIrradiance(sky),
    map: floatTexture({ width, height, texels }),
    rows: floatTexture({ width: height, height: 1, texels: rowTexels }),
  };
}

export type BuiltIn = 'overcast' | 'window';

/** Two small skies that need no file. */
export function builtIn(name: BuiltIn): Environment {
  const [width, height] = [128, 64];
  const radiance = new Float32Array(width * height);
  for (let row = 0; row < height; row++) {
    const elevation = Math.PI * (0.5 - (row + 0.5) / height);
    for (let column = 0; column < width; column++) {
      const longitude = 2 * Math.PI * ((column + 0.5) / width - 0.5);
      radiance[row * width + column] = name === 'overcast' ? overcast(elevation) : windows(elevation, longitude);
    }
  }
  return scaled(environment(width, height, radiance));
}

/** The CIE's overcast sky above a dark ground. */
const overcast = (elevation: number): number => (elevation > 0 ? (1 + 2 * Math.sin(elevation)) / 3 : 0.06);

/** A dim room with a high window to the left and a low one to the right of the camera. */
function windows(elevation: number, longitude: number): number {
  const inside = (at: number, width: number, low: number, high: number) =>
    Math.abs(longitude - at) < width && elevation > low && elevation < high;
  if (inside(0.9, 0.28, 0.25, 0.85)) return 1;
  if (inside(-1.3, 0.14, 0, 0.4)) return 0.5;
  return 0.004;
}

/** As bright as one light of irradiance 1 on a ball: an integral of 1. */
function scaled(sky: Environment): Environment {
  const factor = 1 / scalarIrradiance(sky);
  return environment(sky.width, sky.height, sky.radiance.map((value) => value * factor));
}

/** Reads an image by its name's end. */
export async function readEnvironment(file: File): Promise<Environment> {
  const buffer = await file.arrayBuffer();
  const loader = /\.exr$/i.test(file.name) ? new EXRLoader() : new HDRLoader();
  const image = loader.setDataType(HalfFloatType).parse(buffer);
  if (!image || !image.data || !image.width || !image.height) throw new EnvironmentError('It cannot be read.');
  const { data, width, height } = image as { data: Uint16Array; width: number; height: number };
  const channels = data.length / (width * height);
  const luminance = new Float32Array(width * height);
  // The loader of EXR images gives the bottom row first, that of HDR images the top row.
  const upsideDown = loader instanceof EXRLoader;
  for (let row = 0; row < height; row++) {
    const from = upsideDown ? height - 1 - row : row;
    for (let x = 0; x < width; x++) {
      const at = channels * (from * width + x);
      const rgb = [0, 1, 2].map((c) => DataUtils.fromHalfFloat(data[at + Math.min(c, channels - 1)]));
      luminance[row * width + x] = Math.max(0, 0.2126729 * rgb[0] + 0.7151522 * rgb[1] + 0.072175 * rgb[2]);
    }
  }
  return scaled(environment(width, height, luminance));
}
