// Tables as the shader reads them: layers of half floats and the numbers of its uniform block. The same packing as that of
// the program's export of shaders; nothing is evaluated here.

import type { AtlasFiles } from './files';
import { AtlasError } from './files';
import { ExrError, readExr, type ExrImage } from './exr';
import { readHalves } from './halves';
import { fromHalf, toHalf } from './half';
import type { Specimen, StoredArray, StoredMaterial } from './specimen';

/** Most layers that the shader's list of scales has room for. */
export const LAYERS_MAX = 256;

/** Layers of RGBA half floats, row by row, layer after layer. */
export interface Layers {
  width: number;
  height: number;
  count: number;
  texels: Uint16Array;
  /** Value = texel times scale. */
  scales: Float32Array;
}

/** Rows of RGBA 32-bit floats. */
export interface FloatImage {
  width: number;
  height: number;
  texels: Float32Array;
}

/** The uniform of tables of XYZ, field by field. */
export interface TableParams {
  basis: number;
  table_count: number;
  cross_count: number;
  material: number;
  shadowing: number;
  radius_max: number;
  index_n: number;
  index_k: number;
  restricted: number;
  grid_last: number;
  first_column: number;
  first_row: number;
  factor: number;
  /** 0: values, looked up linearly. */
  look_up: number;
  permittivity: [number, number];
  pigment: [number, number, number, number];
  table_scales: Float32Array;
  cross_scales: Float32Array;
}

export interface PackedTables {
  params: TableParams;
  tables: Layers;
  cross: Layers;
  lobe: FloatImage;
}

/** Tables as they are uploaded: values for linear look-ups, or with what others want. */
export type Packed = PackedTables | PackedSpectral;

export const isSpectral = (packed: Packed): packed is PackedSpectral => 'table_layers' in packed.params;

/** Whether such tables are promised for look-ups by splines, which FORMAT.md describes: those of powers, and those for scenes alone, are not. */
export const hasSplines = (packed: Packed): boolean => isSpectral(packed) || (packed.params.basis === 0 && packed.params.restricted === 0);

/** Whether they have means: texels of tables for scenes alone each have a range of their own. */
export const hasMeans = (packed: Packed): boolean => isSpectral(packed) || packed.params.restricted === 0;

/** The uniform of spectral tables, field by field. */
export interface SpectralParams {
  table_layers: number;
  cross_layers: number;
  lobe_count: number;
  material: number;
  factor: number;
  shadowing: number;
  index_n: number;
  index_k: number;
  permittivity: [number, number];
  shortest_nm: number;
  lobe_sigma_nm: number;
  cross_radius: number;
  of_source: number;
  /** 0: values, looked up linearly. */
  look_up: number;
  table_scales: Float32Array;
  cross_scales: Float32Array;
}

export interface PackedSpectral {
  params: SpectralParams;
  tables: Layers;
  /** Tables and patches, four to a layer. */
  count: number;
  patches: number;
  cross: Layers;
  /** The power in the first channel. */
  lobe: FloatImage;
}

/** Called with the share of the work that is done, 0 to 1. */
export type Progress = (share: number) => void;

const PEAK_EXPONENT = 12;

/** The power of two at which a table is stored as half floats. */
export function halfScale(peak: number): number {
  if (peak === 0 || !Number.isFinite(peak)) return 1;
  return 2 ** Math.min(127, Math.max(-126, Math.ceil(Math.log2(peak)) - PEAK_EXPONENT));
}

/** Kind of material, index and permittivity, as the uniforms hold them. */
export function materialFields(material: StoredMaterial) {
  const [kind, n, k] =
    material === 'ideal'
      ? [0, 1, 0]
      : 'dielectric' in material
        ? [material.dielectric.n < 1 ? 2 : 1, material.dielectric.n, 0]
        : [2, material.conductor.n, material.conductor.k];
  return { material: kind, index_n: n, index_k: k, permittivity: [n * n - k * k, 2 * n * k] as [number, number] };
}

const factorField = (factor: 'vector' | 'scalar'): number => (factor === 'vector' ? 1 : 0);

async function image(files: AtlasFiles, folder: string, stored: StoredArray, size: [number, number]): Promise<ExrImage> {
  const path = `${folder}/${stored.file}`;
  const halves = await files.halves(path);
  const bytes = halves ?? (await files.bytes(path));
  try {
    const found = await (halves ? readHalves(bytes) : readExr(bytes));
    for (const channel of ['R', 'G', 'B']) {
      if (!found.channels.includes(channel)) throw new ExrError(`it has no channel ${channel}`);
    }
    if (found.width !== size[0] || found.height !== size[1]) {
      throw new ExrError(`it is ${found.width} x ${found.height} and not ${size[0]} x ${size[1]} texels large`);
    }
    return found;
  } catch (error) {
    const why = error instanceof ExrError ? error.message : String(error);
    throw new AtlasError(`The atlas's file ${path} is damaged: ${why}. Copy the atlas again, or make it anew.`);
  }
}

const scaleOf = (exr: ExrImage, channel: string): number => exr.scales?.[exr.channels.indexOf(channel)] ?? 1;
const plane = (exr: ExrImage, channel: string) => exr.planes[exr.channels.indexOf(channel)];

/** Channels as half floats with one scale. Halves pass as they are; other numbers are scaled by their peak. */
function asHalves(planes: (Uint16Array | Float32Array)[], stored: number) {
  if (planes.every((values) => values instanceof Uint16Array)) {
    return { scale: stored, bits: planes as Uint16Array[] };
  }
  const values = planes.map((plane) => (plane instanceof Uint16Array ? Float32Array.from(plane, fromHalf) : plane));
  let peak = 0;
  for (const plane of values) for (const value of plane) peak = Math.max(peak, Math.abs(value));
  const scale = halfScale(peak * stored);
  const factor = stored / scale;
  return { scale, bits: values.map((plane) => Uint16Array.from(plane, (value) => toHalf(value * factor))) };
}

const oneBlackTexel = (): Layers => ({
  width: 1,
  height: 1,
  count: 1,
  texels: new Uint16Array(4),
  scales: new Float32Array(LAYERS_MAX),
});

function emptyLayers(width: number, height: number, count: number, scales: number): Layers {
  if (count > LAYERS_MAX) {
    throw new AtlasError(`The atlas has ${count} tables for a specimen; the page takes ${LAYERS_MAX}.`);
  }
  const texels = new Uint16Array(4 * width * height * count);
  return { width, height, count, texels, scales: new Float32Array(Math.max(scales, LAYERS_MAX)) };
}

/** Three channels to a layer, a layer per image; `more` layers stay free. */
async function layersOfXyz(
  files: AtlasFiles,
  folder: string,
  stored: StoredArray[],
  size: [number, number],
  more: number,
  done: () => void,
): Promise<Layers> {
  const [width, height] = size;
  const layers = emptyLayers(width, height, stored.length + more, stored.length);
  await Promise.all(
    stored.map(async (array, n) => {
      const exr = await image(files, folder, array, size);
      const { scale, bits } = asHalves([plane(exr, 'R'), plane(exr, 'G'), plane(exr, 'B')], array.scale * scaleOf(exr, 'R'));
      interleave(layers, n, bits, [0, 1, 2]);
      layers.scales[n] = scale;
      done();
    }),
  );
  return layers;
}

/** Puts planes into the channels of a layer. */
function interleave(layers: Layers, layer: number, planes: Uint16Array[], channels: number[]): void {
  const texels = layers.width * layers.height;
  const start = 4 * texels * layer;
  planes.forEach((bits, p) => {
    for (let i = 0, at = start + channels[p]; i < texels; i++, at += 4) layers.texels[at] = bits[i];
  });
}

/** One channel to a table, three to an image as stored, four to a layer as read. */
async function layersOfSpectral(
  files: AtlasFiles,
  folder: string,
  stored: StoredArray[],
  count: number,
  size: [number, number],
  done: () => void,
): Promise<Layers> {
  const layers = emptyLayers(size[0], size[1], Math.ceil(count / 4), count);
  await Promise.all(
    stored.map(async (array, index) => {
      const exr = await image(files, folder, array, size);
      ['R', 'G', 'B'].forEach((channel, c) => {
        const n = 3 * index + c;
        if (n >= count) return;
        const { scale, bits } = asHalves([plane(exr, channel)], array.scale * scaleOf(exr, channel));
        interleave(layers, Math.floor(n / 4), bits, [n % 4]);
        layers.scales[n] = scale;
      });
      done();
    }),
  );
  return layers;
}

const floats = (exr: ExrImage, channel: string): Float32Array => {
  const values = plane(exr, channel);
  return values instanceof Float32Array ? values : Float32Array.from(values, fromHalf);
};

async function lobeImage(files: AtlasFiles, folder: string, stored: StoredArray, size: [number, number]): Promise<FloatImage> {
  const exr = await image(files, folder, stored, size);
  const texels = new Float32Array(4 * size[0] * size[1]);
  ['R', 'G', 'B'].forEach((channel, c) => {
    floats(exr, channel).forEach((value, i) => (texels[4 * i + c] = value * stored.scale));
  });
  return { width: size[0], height: size[1], texels };
}

/** The tables of XYZ of a specimen, ready for upload; null where it has spectral ones alone. */
export async function packTables(files: AtlasFiles, specimen: Specimen, progress: Progress): Promise<PackedTables | null> {
  const { tables: stored, optics, pigment } = specimen;
  const { lobe, served } = stored;
  const folder = specimen.name;
  if (stored.tables.length === 0) return null;
  const steps = stored.tables.length + (lobe ? 1 + (lobe.cross?.patches.length ?? 0) : 0);
  let finished = 0;
  const done = () => progress(++finished / steps);
  const size: [number, number] = [stored.u.samples, stored.v.samples];
  const [tables, cross, coherent] = await Promise.all([
    layersOfXyz(files, folder, stored.tables, size, served ? 1 : 0, done),
    lobe?.cross
      ? layersOfXyz(files, folder, lobe.cross.patches, [lobe.cross.u.samples, lobe.cross.v.samples], 0, done)
      : oneBlackTexel(),
    lobe
      ? lobeImage(files, folder, lobe.coherent, [lobe.radius.samples, lobe.t.samples])
      : { width: 1, height: 1, texels: new Float32Array(4) },
  ]);
  if (served) {
    const range = await image(files, folder, served.range, size);
    const scale = served.range.scale;
    const bits = ['R', 'G', 'B'].map((channel) =>
      Uint16Array.from(floats(range, channel), (value) => toHalf(value * scale)),
    );
    interleave(tables, stored.tables.length, bits, [0, 1, 2]);
  }
  const params: TableParams = {
    basis: stored.basis === 'taylor' ? 1 : 0,
    table_count: stored.tables.length,
    cross_count: lobe?.cross?.patches.length ?? 0,
    ...materialFields(optics.material),
    shadowing: optics.shadowing ? 1 : 0,
    radius_max: lobe?.radius_max ?? 0,
    restricted: served ? 1 : 0,
    grid_last: (served?.size ?? size[0]) - 1,
    first_column: served?.first[1] ?? 0,
    first_row: served?.first[0] ?? 0,
    factor: factorField(optics.factor),
    look_up: 0,
    pigment: pigment ? [...pigment.xyz_per_sr, 1] : [0, 0, 0, 0],
    table_scales: tables.scales,
    cross_scales: cross.scales,
  };
  return { params, tables, cross, lobe: coherent };
}

/** The spectral tables of a specimen, ready for upload; null where it has none. */
export async function packSpectral(files: AtlasFiles, specimen: Specimen, progress: Progress): Promise<PackedSpectral | null> {
  const { spectral, optics } = specimen;
  if (!spectral) return null;
  const side = Math.round((4 / spectral.shortest_nm / (spectral.xi_per_nm.last - spectral.xi_per_nm.first)) * (spectral.xi_per_nm.samples - 1)) + 1;
  if (side !== spectral.xi_per_nm.samples) {
    throw new AtlasError(`The spectral tables of ${specimen.name} do not reach as far as their wavelengths ask for.`);
  }
  const cross = spectral.lobe?.cross ?? null;
  const steps = spectral.images.length + (spectral.lobe ? 1 : 0) + (cross?.images.length ?? 0);
  let finished = 0;
  const done = () => progress(++finished / steps);
  const folder = specimen.name;
  const [tables, patches, lobe] = await Promise.all([
    layersOfSpectral(files, folder, spectral.images, spectral.tables, [side, spectral.eta_per_nm.samples], done),
    cross
      ? layersOfSpectral(files, folder, cross.images, cross.patches, [cross.xi_per_nm.samples, cross.eta_per_nm.samples], done)
      : oneBlackTexel(),
    spectral.lobe
      ? lobeImage(files, folder, spectral.lobe.power, [spectral.lobe.half_abs_w.samples, 1])
      : { width: 1, height: 1, texels: new Float32Array(4) },
  ]);
  const params: SpectralParams = {
    table_layers: tables.count,
    cross_layers: cross ? patches.count : 0,
    lobe_count: spectral.lobe?.half_abs_w.samples ?? 0,
    ...materialFields(optics.material),
    factor: factorField(optics.factor),
    shadowing: optics.shadowing ? 1 : 0,
    shortest_nm: spectral.shortest_nm,
    lobe_sigma_nm: spectral.lobe?.sigma_nm ?? 0,
    cross_radius: cross ? cross.xi_per_nm.last * spectral.shortest_nm : 0,
    of_source: spectral.lobe?.sigma_grows ? 1 : 0,
    look_up: 0,
    table_scales: tables.scales,
    cross_scales: patches.scales,
  };
  return { params, tables, count: spectral.tables, cross: patches, patches: cross?.patches ?? 0, lobe };
}
