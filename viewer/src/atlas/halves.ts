// Tables in the one file that works from the disk: the half floats that the GPU takes, packed closer than EXR packs them.

import { ExrError, inflate, type ExrImage } from './exr';

const MAGIC = 0x48414444;
const HEAD_BYTES = 28;
const CHANNELS = ['R', 'G', 'B'];

/** Reads what `halves.rs` of the program writes: magic, width, height, channels, three scales, and deflated residuals. */
export async function readHalves(bytes: Uint8Array): Promise<ExrImage> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < HEAD_BYTES || view.getUint32(0, true) !== MAGIC) throw new ExrError('it holds no table');
  const [width, height, channels] = [4, 8, 12].map((at) => view.getUint32(at, true));
  const texels = width * height;
  if (channels !== CHANNELS.length || !(texels > 0 && texels <= 1 << 26)) throw new ExrError('its size is not that of a table');
  let raw: Uint8Array;
  try {
    raw = await inflate(bytes.subarray(HEAD_BYTES), 2 * texels * channels);
  } catch (error) {
    throw error instanceof ExrError ? error : new ExrError('it is damaged');
  }
  const planes = CHANNELS.map((_, c) => plane(raw, c * texels, channels * texels, width, height));
  return { width, height, channels: CHANNELS, half: true, planes, scales: CHANNELS.map((_, c) => view.getFloat32(16 + 4 * c, true)) };
}

/** Each number is what a plane through its left, upper and upper left neighbours leaves of it: low bytes first, high ones behind all. */
function plane(raw: Uint8Array, first: number, high: number, width: number, height: number): Uint16Array {
  const whole = new Int16Array(width * height);
  const out = new Uint16Array(width * height);
  for (let row = 0, i = 0; row < height; row++) {
    for (let column = 0; column < width; column++, i++) {
      const folded = raw[first + i] | (raw[high + first + i] << 8);
      const residual = (folded >> 1) ^ -(folded & 1);
      const left = column ? whole[i - 1] : 0;
      const above = row ? whole[i - width] : 0;
      const corner = row && column ? whole[i - width - 1] : 0;
      whole[i] = residual + left + above - corner;
      // In the order of the numbers' values, the sign apart.
      out[i] = whole[i] < 0 ? 0x8000 | (-1 - whole[i]) : whole[i];
    }
  }
  return out;
}
