//! Cases of many megabytes: a scan of 8192² samples, a table of 4001² texels.

use std::f64::consts::TAU;

use ndarray::Array2;
use rustfft::num_complex::Complex;

use super::case::StabilityCase;
use super::support::{BOUND, Comparison, case, config, laser, on_row, on_texels, refused, relief, tables};
use diffraction_build::height::HeightField;
use diffraction_build::tables::model::{Basis, TablesConfig};

/// Wavelength of the laser in nm.
const GREEN_NM: f64 = 532.0;

/// Samples along each side.
const SAMPLES: usize = 8_192;

/// A wave along x of 8192² samples 1 nm apart. It does not depend on y, so the direct sum over one row, as tall as the
/// whole scan, is the same surface. Guard: sums of rows first, in doubles; a single float stops growing at 2²⁴ samples, a
/// quarter of these.
pub(crate) fn scan_of_8192() -> StabilityCase {
    let name = "scan of 8192 x 8192, pitch 1 nm";
    let height = |column: usize| 60.0 * (TAU * 6.0 * column as f64 / SAMPLES as f64).sin();
    let field = HeightField {
        heights_nm: Array2::from_shape_fn((SAMPLES, SAMPLES), |(_, column)| height(column)),
        pitch_nm: [1.0; 2],
    };
    let row = HeightField {
        heights_nm: Array2::from_shape_fn((1, SAMPLES), |(_, column)| height(column)),
        pitch_nm: [1.0, SAMPLES as f64],
    };
    let Ok(set) = tables(&field, &laser(GREEN_NM, 1_500.0), &config(Basis::Chebyshev)) else {
        return refused(name);
    };
    drop(field);
    let found = Comparison::new(&set, &row, &laser(GREEN_NM, 1_500.0), on_row(&set, [0.1, 1.0]));
    case(name, "95 % error of Y on the row of texels that has light", found.error(), BOUND)
        .guarded("sums of rows in doubles; one float, mirror direction", float_sum(&row))
}

/// Relative error of the mirror direction's power, both angles 60°, from one sum in floats over every sample.
fn float_sum(row: &HeightField) -> f64 {
    let s = TAU / GREEN_NM;
    let phasors: Vec<Complex<f64>> = row.heights_nm.iter().map(|h| Complex::cis(-s * h)).collect();
    let exact = phasors.iter().sum::<Complex<f64>>() * SAMPLES as f64;
    let mut sum = Complex::new(0.0f32, 0.0);
    for _ in 0..SAMPLES {
        for phasor in &phasors {
            sum += Complex::new(phasor.re as f32, phasor.im as f32);
        }
    }
    (f64::from(sum.norm_sqr()) / exact.norm_sqr() - 1.0).abs()
}

/// Tables of 4001² texels. Guard: two tables hold the power over `w²` of so shallow a relief, not the power.
pub(crate) fn table_of_4001() -> StabilityCase {
    let name = "table of 4001 x 4001 texels";
    // So shallow that two polynomials reach the tolerance.
    let field = relief([32, 32], [125.0; 2], 5.0);
    let config = TablesConfig { size: Some(4_001), count: Some(2), memory_mib: 2_048, ..config(Basis::Chebyshev) };
    let Ok(set) = tables(&field, &laser(GREEN_NM, 800.0), &config) else {
        return refused(name);
    };
    let found = Comparison::new(&set, &field, &laser(GREEN_NM, 800.0), on_texels(&set, [0.05, 1.0]));
    case(name, "95 % error of Y on texels", found.error(), BOUND).guarded("tables of the power over w²", found.whole(2))
}
