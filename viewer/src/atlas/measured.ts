// Measured spectra that lie beside the model's in the atlas's report.

/** A spectrum measured at one pair of directions. */
export interface MeasuredSpectrum {
  /** theta and phi of the light, theta and phi of the viewer. */
  angles_deg: [number, number, number, number];
  nm: number[];
  /** f in 1/sr. */
  values: number[];
}

interface Curve {
  along: string;
  angles_deg: [number, number, number, number];
  at: number[];
  measured: number[];
}

/** What was measured in one way, as the report has it. */
export interface MeasuredColumn {
  kind: string;
  scale: number;
  curves: Curve[];
}

/** Every BRDF spectrum among what was measured of a specimen. */
export function measuredSpectra(columns: MeasuredColumn[]): MeasuredSpectrum[] {
  return columns
    .filter(({ kind }) => kind === 'brdf')
    .flatMap(({ curves, scale }) => curves.map((curve) => ({ curve, scale })))
    .filter(({ curve }) => curve.along === 'wavelength_nm')
    .map(({ curve, scale }) => ({ angles_deg: curve.angles_deg, nm: curve.at, values: curve.measured.map((value) => value * scale) }));
}
