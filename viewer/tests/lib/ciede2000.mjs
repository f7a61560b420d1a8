// Differences of colours as people see them: CIEDE2000 of sRGB pictures.

const linear = (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
const LINEAR = Array.from({ length: 256 }, (_, i) => linear(i / 255));
const WHITE = [0.95047, 1, 1.08883];

/** CIE L*a*b* under D65 of 8-bit sRGB. */
export function lab(r, g, b) {
  const [R, G, B] = [LINEAR[r], LINEAR[g], LINEAR[b]];
  const xyz = [
    0.4124564 * R + 0.3575761 * G + 0.1804375 * B,
    0.2126729 * R + 0.7151522 * G + 0.072175 * B,
    0.0193339 * R + 0.119192 * G + 0.9503041 * B,
  ];
  const f = xyz.map((c, i) => {
    const t = c / WHITE[i];
    return t > 216 / 24389 ? Math.cbrt(t) : (24389 / 27 * t + 16) / 116;
  });
  return [116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])];
}

const rad = (deg) => (deg * Math.PI) / 180;
const hue = (b, a) => (a === 0 && b === 0 ? 0 : ((Math.atan2(b, a) * 180) / Math.PI + 360) % 360);

/** CIEDE2000 of two colours in L*a*b*. */
export function ciede2000([L1, a1, b1], [L2, a2, b2]) {
  const mean7 = ((Math.hypot(a1, b1) + Math.hypot(a2, b2)) / 2) ** 7;
  const g = 0.5 * (1 - Math.sqrt(mean7 / (mean7 + 25 ** 7)));
  const [p1, p2] = [a1 * (1 + g), a2 * (1 + g)];
  const [C1, C2] = [Math.hypot(p1, b1), Math.hypot(p2, b2)];
  const [h1, h2] = [hue(b1, p1), hue(b2, p2)];
  let dh = C1 * C2 === 0 ? 0 : h2 - h1;
  if (dh > 180) dh -= 360;
  if (dh < -180) dh += 360;
  const dH = 2 * Math.sqrt(C1 * C2) * Math.sin(rad(dh) / 2);
  const [L, C] = [(L1 + L2) / 2, (C1 + C2) / 2];
  let h = h1 + h2;
  if (C1 * C2 !== 0) {
    if (Math.abs(h1 - h2) > 180) h += h < 360 ? 360 : -360;
    h /= 2;
  }
  const T = 1 - 0.17 * Math.cos(rad(h - 30)) + 0.24 * Math.cos(rad(2 * h)) + 0.32 * Math.cos(rad(3 * h + 6)) - 0.2 * Math.cos(rad(4 * h - 63));
  const C7 = C ** 7;
  const RT = -2 * Math.sqrt(C7 / (C7 + 25 ** 7)) * Math.sin(rad(60 * Math.exp(-(((h - 275) / 25) ** 2))));
  const SL = 1 + (0.015 * (L - 50) ** 2) / Math.sqrt(20 + (L - 50) ** 2);
  const [l, c, k] = [(L2 - L1) / SL, (C2 - C1) / (1 + 0.045 * C), dH / (1 + 0.015 * C * T)];
  return Math.sqrt(l * l + c * c + k * k + RT * c * k);
}

/** Mean and worst difference of two pictures of one size, `{ width, height, rgb }`. */
export function difference(a, b) {
  if (a.width !== b.width || a.height !== b.height) throw new Error(`sizes ${a.width} x ${a.height} and ${b.width} x ${b.height}`);
  const [count, at] = [a.width * a.height, 3];
  let [sum, worst] = [0, 0];
  for (let i = 0; i < count * at; i += at) {
    const one = ciede2000(lab(a.rgb[i], a.rgb[i + 1], a.rgb[i + 2]), lab(b.rgb[i], b.rgb[i + 1], b.rgb[i + 2]));
    sum += one;
    worst = Math.max(worst, one);
  }
  return { mean: sum / count, worst };
}
