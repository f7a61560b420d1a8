// Writes EXR images by the format's own description, independent of the reader.

import { deflateSync } from 'node:zlib';
import { toHalf } from '../../src/atlas/half';

export type Plane = { name: string; half: boolean; value: (row: number, column: number) => number };

/** Scan lines, ZIP or uncompressed. */
export function exr(width: number, height: number, planes: Plane[], options: { zip: boolean; flags?: number; compression?: number }): Uint8Array {
  const lines = options.zip ? 16 : 1;
  const parts: Buffer[] = [];
  const text = (s: string) => Buffer.from(`${s}\0`, 'latin1');
  const int = (v: number) => {
    const b = Buffer.alloc(4);
    b.writeInt32LE(v);
    return b;
  };
  const attribute = (name: string, type: string, value: Buffer) => parts.push(text(name), text(type), int(value.length), value);
  parts.push(int(20000630), int(2 | (options.flags ?? 0)));
  const channels = planes.map(({ name, half }) => Buffer.concat([text(name), int(half ? 1 : 2), int(0), int(1), int(1)]));
  attribute('channels', 'chlist', Buffer.concat([...channels, Buffer.from([0])]));
  attribute('compression', 'compression', Buffer.from([options.compression ?? (options.zip ? 3 : 0)]));
  attribute('dataWindow', 'box2i', Buffer.concat([int(5), int(-3), int(5 + width - 1), int(-3 + height - 1)]));
  parts.push(Buffer.from([0]));
  const chunks: Buffer[] = [];
  for (let top = 0; top < height; top += lines) {
    const rows: Buffer[] = [];
    for (let y = top; y < Math.min(height, top + lines); y++) {
      for (const { half, value } of planes) {
        const row = Buffer.alloc(width * (half ? 2 : 4));
        for (let x = 0; x < width; x++) half ? row.writeUInt16LE(toHalf(value(y, x)), 2 * x) : row.writeFloatLE(value(y, x), 4 * x);
        rows.push(row);
      }
    }
    const raw = Buffer.concat(rows);
    let data = raw;
    if (options.zip) {
      const even = raw.filter((_, i) => i % 2 === 0);
      const odd = raw.filter((_, i) => i % 2 === 1);
      const mixed = Buffer.concat([even, odd]);
      const predicted = Buffer.from(mixed.map((byte, i) => (i ? (byte - mixed[i - 1] + 128 + 256) & 255 : byte)));
      const packed = deflateSync(predicted);
      data = packed.length < raw.length ? packed : raw;
    }
    chunks.push(Buffer.concat([int(top - 3), int(data.length), data]));
  }
  const head = Buffer.concat(parts);
  let at = head.length + 8 * chunks.length;
  const offsets = chunks.map((chunk) => {
    const b = Buffer.alloc(8);
    b.writeBigUInt64LE(BigInt(at));
    at += chunk.length;
    return b;
  });
  return new Uint8Array(Buffer.concat([head, ...offsets, ...chunks]));
}
