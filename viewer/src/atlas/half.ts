// Numbers of 16 bits: IEEE 754 binary16. Tables hold millions of them, so what can be looked up is.

const single = new Float32Array(1);
const bits = new Uint32Array(single.buffer);

/** The nearest half float of a number, ties to even; infinite beyond 65504. */
export function toHalf(value: number): number {
  single[0] = value;
  const all = bits[0];
  const sign = (all >>> 16) & 0x8000;
  const exponent = (all >>> 23) & 0xff;
  const fraction = all & 0x7fffff;
  if (exponent === 0xff) return sign | 0x7c00 | (fraction ? 0x200 : 0);
  const unbiased = exponent - 127;
  if (unbiased > 15) return sign | 0x7c00;
  if (unbiased < -25) return sign;
  // The fraction with its leading one, and how many of its bits are dropped: more where the half is subnormal.
  const whole = fraction | 0x800000;
  const dropped = unbiased >= -14 ? 13 : -1 - unbiased;
  const kept = whole >>> dropped;
  const rest = whole & ((1 << dropped) - 1);
  const middle = 1 << (dropped - 1);
  const up = rest > middle || (rest === middle && (kept & 1) === 1) ? 1 : 0;
  const base = unbiased >= -14 ? (unbiased + 14) << 10 : 0;
  // A carry out of the fraction raises the exponent, up to infinity, as it should.
  return sign | (base + kept + up);
}

let values: Float32Array | null = null;

/** The value of every half float, by its bits. */
export function halfValues(): Float32Array {
  return (values ??= Float32Array.from({ length: 0x10000 }, (_, half) => valueOf(half)));
}

/** The value of a half float. */
export const fromHalf = (half: number): number => halfValues()[half];

function valueOf(half: number): number {
  const sign = half & 0x8000 ? -1 : 1;
  const exponent = (half >>> 10) & 0x1f;
  const fraction = half & 0x3ff;
  if (exponent === 0x1f) return fraction ? NaN : sign * Infinity;
  if (exponent === 0) return sign * fraction * 2 ** -24;
  return sign * (1024 + fraction) * 2 ** (exponent - 25);
}
