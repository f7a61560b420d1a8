// Pictures of the program: PNG of 8-bit RGB, not interlaced, and reports of what they show.
import { inflateSync } from 'node:zlib';

/** Width, height and RGB, row by row from the top. */
export function readPng(bytes) {
  if (bytes.readUInt32BE(0) !== 0x89504e47) throw new Error('this is no PNG');
  const parts = [];
  let header = null;
  for (let at = 8; at < bytes.length; ) {
    const [size, kind] = [bytes.readUInt32BE(at), bytes.toString('latin1', at + 4, at + 8)];
    const data = bytes.subarray(at + 8, at + 8 + size);
    if (kind === 'IHDR') header = data;
    if (kind === 'IDAT') parts.push(data);
    at += 12 + size;
  }
  const [width, height] = [header.readUInt32BE(0), header.readUInt32BE(4)];
  if (header[8] !== 8 || header[9] !== 2 || header[12] !== 0) throw new Error('a PNG of another kind');
  return { width, height, rgb: unfiltered(inflateSync(Buffer.concat(parts)), width, height) };
}

function unfiltered(raw, width, height) {
  const line = 3 * width;
  const rgb = new Uint8Array(line * height);
  for (let y = 0; y < height; y++) {
    const filter = raw[y * (line + 1)];
    for (let x = 0; x < line; x++) {
      const left = x >= 3 ? rgb[y * line + x - 3] : 0;
      const above = y > 0 ? rgb[(y - 1) * line + x] : 0;
      const corner = x >= 3 && y > 0 ? rgb[(y - 1) * line + x - 3] : 0;
      const guess = [0, left, above, (left + above) >> 1, paeth(left, above, corner)][filter];
      rgb[y * line + x] = raw[y * (line + 1) + 1 + x] + guess;
    }
  }
  return rgb;
}

function paeth(a, b, c) {
  const [pa, pb, pc] = [Math.abs(b - c), Math.abs(a - c), Math.abs(a + b - 2 * c)];
  if (pa <= pb && pa <= pc) return a;
  return pb <= pc ? b : c;
}

/** The picture mirrored left to right, or top to bottom. */
export function mirrored({ width, height, rgb }, upsideDown = false) {
  const out = new Uint8Array(rgb.length);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const from = upsideDown ? (height - 1 - y) * width + x : y * width + width - 1 - x;
      out.set(rgb.subarray(3 * from, 3 * from + 3), 3 * (y * width + x));
    }
  }
  return { width, height, rgb: out };
}
