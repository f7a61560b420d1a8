import { describe, expect, it } from 'vitest';
import { decoded } from '../src/atlas/text';
import { encoded } from './encoded';

describe('bytes as text', () => {
  const noise = Uint8Array.from({ length: 997 }, (_, i) => (i * 7919 + ((i * i) >> 3)) & 255);

  it('come back, whatever they are', () => {
    for (let length = 0; length < 40; length++) {
      for (const bytes of [noise.subarray(0, length), new Uint8Array(length), new Uint8Array(length).fill(255)]) {
        expect(decoded(encoded(bytes), length)).toEqual(Uint8Array.from(bytes));
      }
    }
    expect(decoded(encoded(noise), noise.length)).toEqual(noise);
    // A byte of 60, shifted by no place, is what an element may not hold.
    expect(encoded(Uint8Array.of(0b01111000))).not.toContain('<');
  });

  it('that are cut short are told from whole ones', () => {
    expect(decoded(encoded(noise).slice(0, -2), noise.length)).toBeNull();
    expect(decoded('', 1)).toBeNull();
  });
});
