import { describe, expect, it } from 'vitest';
import { ExrError, readExr } from '../src/atlas/exr';
import { fromHalf, toHalf } from '../src/atlas/half';
import { exr, type Plane } from './support/write_exr';

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
