// Numbers of 16 bits: IEEE 754 binary16.

const scratch = new DataView(new ArrayBuffer(4));

/** The nearest half float of a number, ties to even; infinite beyond 65504. */
export function toHalf(value: number): number {
  scratch.setFloat32(0, value);
  const bits = scratch.getUint32(0);
  const sign = (bits >>> 16) & 0x8000;
  const exponent = (bits >>> 23) & 0xff;
  const fraction = bits & 0x7fffff;
  if (exponent === 0xff) return sign | 0x7c00 | (fraction ? 0x200 : 0);
  const unbiased = exponent - 127;
  if (unbiased > 15) return sign | 0x7c00;
  if (unbiased < -25) return sign;
  // The fraction with its leading one, and how many of its bits are dropped: more where the half is subnormal.
  const whole = fraction | 0x800000;
  const dropped = unbiased >= -14 ? 13 : 13 + (-14 - unbiased);
  const kept = Math.floor(whole / 2 ** dropped);
  const rest = whole - kept * 2 ** dropped;
  const middle = 2 ** (dropped - 1);
  const up = rest > middle || (rest === middle && kept % 2 === 1) ? 1 : 0;
  const base = unbiased >= -14 ? (unbiased + 15 - 1) * 1024 : 0;
  // A carry out of the fraction raises the exponent, up to infinity, as it should.
  return sign | (base + kept + up);
}

/** The value of a half float. */
export function fromHalf(half: number): number {
  const sign = half & 0x8000 ? -1 : 1;
  const exponent = (half >>> 10) & 0x1f;
  const fraction = half & 0x3ff;
  if (exponent === 0x1f) return fraction ? NaN : sign * Infinity;
  if (exponent === 0) return sign * fraction * 2 ** -24;
  return sign * (1024 + fraction) * 2 ** (exponent - 25);
}
