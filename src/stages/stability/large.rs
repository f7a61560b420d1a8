//! Cases of many megabytes: a scan of 8192² samples, a table of 4001² texels.

use std::f64::consts::TAU;

use ndarray::Array2;

use super::StabilityCase;
use super::support::{BOUND, case, config, error, laser, on_row, on_texels, relief, tables};
use crate::height::HeightField;
use crate::tables::model::{Basis, TablesConfig};

/// Wavelength of the laser in nm.
const GREEN_NM: f64 = 532.0;

/// Samples along each side.
const SAMPLES: usize = 8_192;

/// A wave along x of 8192² samples 1 nm apart. It does not depend on y, so the direct sum over one row, as tall as the
/// whole scan, is the same surface.
pub fn scan_of_8192() -> StabilityCase {
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
        return case(name, "refused", f64::NAN, BOUND);
    };
    drop(field);
    let pairs = on_row(&set, [0.1, 1.0]);
    case(name, "95 % error of Y on the row of texels that has light", error(&set, &row, &pairs), BOUND)
}

/// Tables of 4001² texels.
pub fn table_of_4001() -> StabilityCase {
    let name = "table of 4001 x 4001 texels";
    // So shallow that two polynomials reach the tolerance.
    let field = relief([32, 32], [125.0; 2], 5.0);
    let config = TablesConfig { size: Some(4_001), count: Some(2), memory_mib: 2_048, ..config(Basis::Chebyshev) };
    let Ok(set) = tables(&field, &laser(GREEN_NM, 800.0), &config) else {
        return case(name, "refused", f64::NAN, BOUND);
    };
    let pairs = on_texels(&set, [0.05, 1.0]);
    case(name, "95 % error of Y on texels", error(&set, &field, &pairs), BOUND)
}
