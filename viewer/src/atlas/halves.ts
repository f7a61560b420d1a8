// Tables in the one file that works from the disk: the half floats that the GPU takes, packed closer than EXR packs them.

import { ExrError, inflate, type ExrImage } from './exr';
import { halfValues, toHalf } from './half';

const MAGIC = 0x54414444;
const HEAD_BYTES = 28;
const CHANNELS = ['R', 'G', 'B'];
/** Texels along a square's side. */
const SQUARE = 8;
/** What stands for a square's exponent where its numbers are counted in half floats. */
const BY_ORDER = 127;

/** Reads what `halves.rs` of the program writes: magic, width, height, channels, three scales, and deflated squares and counts. */
export async function readHalves(bytes: Uint8Array): Promise<ExrImage> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < HEAD_BYTES || view.getUint32(0, true) !== MAGIC) throw new ExrError('it holds no table');
  const [width, height, channels] = [4, 8, 12].map((at) => view.getUint32(at, true));
  const texels = width * height;
  if (channels !== CHANNELS.length || !(texels > 0 && texels <= 1 << 26)) throw new ExrError('its size is not that of a table');
  const squares = Math.ceil(width / SQUARE) * Math.ceil(height / SQUARE);
  let raw: Uint8Array;
  try {
    raw = await inflate(bytes.subarray(HEAD_BYTES), channels * (squares + 2 * texels));
  } catch (error) {
    throw error instanceof ExrError ? error : new ExrError('it is damaged');
  }
  const low = channels * squares;
  const of = (c: number) => ({ squares: c * squares, low: low + c * texels, high: low + (channels + c) * texels });
  const planes = CHANNELS.map((_, c) => plane(raw, of(c), width, height));
  return { width, height, channels: CHANNELS, half: true, planes, scales: CHANNELS.map((_, c) => view.getFloat32(16 + 4 * c, true)) };
}

/** Half floats as integers in the order of their values, and back. */
const order = (half: number): number => (half & 0x8000 ? -1 - (half & 0x7fff) : half);

/** Each number is what a plane through its left, upper and upper left neighbours leaves of it, counted as its square says. */
function plane(raw: Uint8Array, at: { squares: number; low: number; high: number }, width: number, height: number): Uint16Array {
  const out = new Uint16Array(width * height);
  const values = halfValues();
  const across = Math.ceil(width / SQUARE);
  const exponents = new Int8Array(raw.buffer, raw.byteOffset + at.squares, across * Math.ceil(height / SQUARE));
  for (let row = 0, i = 0; row < height; row++) {
    for (let column = 0; column < width; column++, i++) {
      const folded = raw[at.low + i] | (raw[at.high + i] << 8);
      const count = (folded >> 1) ^ -(folded & 1);
      const left = column ? out[i - 1] : 0;
      const above = row ? out[i - width] : 0;
      const corner = row && column ? out[i - width - 1] : 0;
      const exponent = exponents[(row >> 3) * across + (column >> 3)];
      if (exponent === BY_ORDER) {
        const whole = ((count + order(left) + order(above) - order(corner)) << 16) >> 16;
        out[i] = whole < 0 ? 0x8000 | (-1 - whole) : whole;
      } else {
        const unit = 2 ** exponent;
        out[i] = toHalf((Math.floor((values[left] + values[above] - values[corner]) / unit + 0.5) + count) * unit);
      }
    }
  }
  return out;
}
