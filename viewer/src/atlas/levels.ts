// What look-ups by splines and filtered look-ups want of tables besides their values: coefficients on the finest level, means on
// coarser ones.

import { halfValues, toHalf } from './half';
import { coarser } from './mips';
import { halfScale, LAYERS_MAX, type Layers } from './pack';
import { heldTexels, toCoefficients } from './splines';

/** A level of a mip chain, layer after layer as the finest one. */
export interface Level {
  width: number;
  height: number;
  texels: Uint16Array;
}

/** Layers with the levels below them, from the finer to the coarser. */
export interface Levelled extends Layers {
  coarser: Level[];
}

interface Wanted {
  /** Coefficients of splines on the finest level; only of square tables. */
  splines: boolean;
  /** Channels of a layer that are tables: three that share a scale, or four that have their own. */
  channels: 3 | 4;
  /** Tables, where layers have four: the last layer may not be full. */
  count?: number;
}

/** Lets the page do something else. */
const pause = (): Promise<void> => new Promise((resume) => setTimeout(resume));

/** Layers made ready, one after another with pauses in between. */
export async function levelled(layers: Layers, { splines, channels, count = Infinity }: Wanted): Promise<Levelled> {
  const { width, height, count: all } = layers;
  const texels = width * height;
  const held = splines ? heldTexels(width) : null;
  const out: Levelled = { ...layers, texels: new Uint16Array(layers.texels.length), scales: new Float32Array(LAYERS_MAX), coarser: [] };
  for (let layer = 0; layer < all; layer++) {
    const planes = Array.from({ length: Math.min(channels, count - channels * layer) }, (_, c) => plane(layers, layer, c, channels));
    const finest = planes.map((values) => (held ? coefficients(values, held, width) : values));
    const scales = planes.map((values, c) => halfScale(Math.max(peak(values), peak(finest[c]))));
    if (channels === 3) scales.fill(Math.max(...scales));
    scales.forEach((scale, c) => (out.scales[channels === 3 ? layer : channels * layer + c] = scale));
    finest.forEach((values, c) => put(out.texels, 4 * texels * layer + c, values, scales[c]));
    planes.forEach((values, c) =>
      coarser({ width, height, values }).forEach((level, n) => {
        out.coarser[n] ??= { width: level.width, height: level.height, texels: new Uint16Array(4 * level.width * level.height * all) };
        put(out.coarser[n].texels, 4 * level.width * level.height * layer + c, level.values, scales[c]);
      }),
    );
    await pause();
  }
  return out;
}

function plane({ width, height, texels, scales }: Layers, layer: number, channel: number, channels: 3 | 4): Float64Array {
  const values = halfValues();
  const scale = scales[channels === 3 ? layer : channels * layer + channel];
  const out = new Float64Array(width * height);
  for (let i = 0, at = 4 * width * height * layer + channel; i < out.length; i++, at += 4) out[i] = values[texels[at]] * scale;
  return out;
}

function coefficients(values: Float64Array, held: Uint32Array, size: number): Float64Array {
  const out = new Float64Array(values.length);
  for (let i = 0; i < out.length; i++) out[i] = values[held[i]];
  toCoefficients(out, size);
  for (let i = 0; i < out.length; i++) out[i] = Math.fround(out[i]);
  return out;
}

function peak(values: Float64Array): number {
  let most = 0;
  for (let i = 0; i < values.length; i++) most = Math.max(most, Math.abs(values[i]));
  return most;
}

function put(texels: Uint16Array, first: number, values: Float64Array, scale: number): void {
  for (let i = 0, at = first; i < values.length; i++, at += 4) texels[at] = toHalf(values[i] / scale);
}
