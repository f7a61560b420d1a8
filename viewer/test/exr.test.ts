import { deflateSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';
import { ExrError, readExr } from '../src/atlas/exr';
import { fromHalf, toHalf } from '../src/atlas/half';

type Plane = { name: string; half: boolean; value: (row: number, column: number) => number };

/** An EXR image by the format's own description, independent of the reader. */
function exr(width: number, height: number, planes: Plane[], options: { zip: boolean; flags?: number; compression?: number }): Uint8Array {
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

const wave = (k: number) => (row: number, column: number) => Math.fround(Math.sin(0.3 * row + k) * 40 + column / 8);
const planes: Plane[] = [
  { name: 'B', half: true, value: wave(1) },
  { name: 'G', half: false, value: wave(2) },
  { name: 'R', half: true, value: (row, column) => (row * 7 + column) % 5 },
];

describe('EXR images', () => {
  it.each([{ zip: true }, { zip: false }])('are read as they were written, %o', async (options) => {
    const image = await readExr(exr(21, 37, planes, options));
    expect([image.width, image.height, image.channels, image.half]).toEqual([21, 37, ['B', 'G', 'R'], false]);
    planes.forEach(({ half, value }, p) => {
      for (let y = 0; y < 37; y++) {
        for (let x = 0; x < 21; x++) {
          const found = image.planes[p][y * 21 + x];
          expect(half ? fromHalf(found) : found).toBe(half ? fromHalf(toHalf(value(y, x))) : value(y, x));
        }
      }
    });
  });

  it('that are damaged say so', async () => {
    const good = exr(40, 40, planes, { zip: true });
    const cut = good.slice(0, good.length - 5);
    await expect(readExr(cut)).rejects.toThrow('ends too early');
    await expect(readExr(good.slice(0, 60))).rejects.toBeInstanceOf(ExrError);
    await expect(readExr(new Uint8Array(64))).rejects.toThrow('no EXR');
    const spoiled = good.slice();
    spoiled.fill(0x55, good.length - 900, good.length - 700);
    await expect(readExr(spoiled)).rejects.toBeInstanceOf(ExrError);
    await expect(readExr(exr(4, 4, planes, { zip: false, flags: 0x200 }))).rejects.toThrow('tiles');
    await expect(readExr(exr(4, 4, planes, { zip: false, compression: 4 }))).rejects.toThrow('compression (4)');
  });
});
