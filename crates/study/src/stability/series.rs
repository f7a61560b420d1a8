//! Where the published power series fails: its tables rounded to halves, floats and doubles at rising depth.

use std::f64::consts::TAU;

use half::f16;
use rustfft::num_complex::Complex;
use serde::{Deserialize, Serialize};

use super::support::{WAVE_SIGMA_NM, relief};
use diffraction_build::ground::metrics::relative_error_quantiles;
use diffraction_build::height::HeightField;
use diffraction_build::optics::powers::{PowersConfig, transform_powers};
use diffraction_build::optics::spectra::half_height_range_nm;
use diffraction_build::optics::window::Placement;
use diffraction_build::tables::taylor::forecast;

/// Peak-to-valley depths in nm.
const DEPTHS_NM: [f64; 12] =
    [50.0, 100.0, 150.0, 200.0, 300.0, 400.0, 600.0, 800.0, 1_000.0, 1_500.0, 2_000.0, 3_000.0];

/// Wavelength in nm.
const NM: f64 = 400.0;

/// Remainder that the terms leave: far below what is to be seen.
const REMAINDER: f64 = 1e-14;

/// Most terms.
const TERMS_MAX: usize = 400;

/// The largest `|w|`, for which the forecast is made.
const W: f64 = 2.0;

/// One depth.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SeriesRow {
    /// Peak to valley in nm.
    pub depth_nm: f64,
    /// Terms summed.
    pub terms: usize,
    /// Decimal digits that the program forecasts to cancel at `|w|` = 2.
    pub digits_lost: f64,
    /// 95th percentile of the relative error at `|w|` = 2 over the lines that carry 1 % of the mean power, with
    /// coefficients in halves, floats and doubles.
    pub errors: [f64; 3],
    /// What the forecast predicts for each: unit roundoff times the cancellation.
    pub predicted: [f64; 3],
}

/// Every depth.
pub fn rows() -> Vec<SeriesRow> {
    DEPTHS_NM.into_iter().map(row).collect()
}

/// Sums the series of `|P|²` on the lines of a periodic relief and compares with the sum of phasors.
pub fn row(depth_nm: f64) -> SeriesRow {
    let field = relief([32, 32], [125.0; 2], depth_nm);
    let k = TAU / NM;
    let predicted = forecast(std::slice::from_ref(&field), 2.0 * k, REMAINDER);
    let terms = predicted.terms.min(TERMS_MAX);
    let config = PowersConfig {
        orders: terms,
        scale_nm: half_height_range_nm(&field),
        frequency: [[-1.0 / NM, 1.0 / NM]; 2],
        memory_bytes: 1 << 30,
    };
    let roundoffs = [2f64.powi(-11), 2f64.powi(-24), 2f64.powi(-53)];
    let mut row = SeriesRow {
        depth_nm,
        terms,
        digits_lost: predicted.digits_lost,
        errors: [f64::NAN; 3],
        predicted: roundoffs.map(|unit| unit * 10f64.powf(predicted.digits_lost)),
    };
    let Ok(series) = transform_powers(&field, Placement::TileMean, WAVE_SIGMA_NM, &config) else { return row };
    let lines: Vec<[i32; 2]> = (0..series.lines[0] * series.lines[1])
        .map(|index| {
            [0, 1].map(|axis| series.first[axis] + [index % series.lines[0], index / series.lines[0]][axis] as i32)
        })
        .collect();
    // Coefficients as tables hold them: powers of w times constants, each table over its peak.
    let mut tables = series.data.clone();
    for (index, value) in tables.iter_mut().enumerate() {
        *value *= (k * config.scale_nm).powi((index % terms) as i32);
    }
    let exact: Vec<f64> = lines.iter().map(|&line| line_power(&field, line, k * W)).collect();
    let floor = 1e-2 * exact.iter().sum::<f64>() / exact.len() as f64;
    for (format, slot) in [Format::Half, Format::Float, Format::Double].into_iter().zip(&mut row.errors) {
        let rounded = format.rounded(&tables, terms);
        let value = |coefficients: &[f64]| coefficients.iter().enumerate().map(|(p, c)| c * W.powi(p as i32)).sum();
        let found: Vec<f64> = rounded.chunks_exact(terms).map(value).collect();
        *slot = relative_error_quantiles(&exact, &found, floor).p95;
    }
    row
}

/// `|Σ exp(-i s h) exp(2πi(ξx + ηy))|² / N²` on one line, summed over the samples.
fn line_power(field: &HeightField, line: [i32; 2], s: f64) -> f64 {
    let (rows, columns) = field.heights_nm.dim();
    let mut sum = Complex::new(0.0, 0.0);
    for ((row, column), h) in field.heights_nm.indexed_iter() {
        let turns = f64::from(line[0]) * column as f64 / columns as f64 - f64::from(line[1]) * row as f64 / rows as f64;
        sum += Complex::cis(TAU * turns - s * h);
    }
    (sum / (rows * columns) as f64).norm_sqr()
}

/// A number format of coefficients.
#[derive(Clone, Copy)]
enum Format {
    Half,
    Float,
    Double,
}

impl Format {
    /// Coefficients `[line][term]`, each term's over its peak and rounded.
    fn rounded(self, tables: &[f64], terms: usize) -> Vec<f64> {
        let mut peaks = vec![0.0f64; terms];
        for line in tables.chunks_exact(terms) {
            peaks.iter_mut().zip(line).for_each(|(peak, value)| *peak = peak.max(value.abs()));
        }
        let round = |value: f64, peak: f64| match self {
            _ if peak == 0.0 => 0.0,
            // Halves keep their precision from 2^-14 up.
            Self::Half => f64::from(f16::from_f64(value / peak * 4096.0)) * peak / 4096.0,
            Self::Float => f64::from((value / peak) as f32) * peak,
            Self::Double => value,
        };
        tables
            .chunks_exact(terms)
            .flat_map(|line| line.iter().zip(&peaks).map(move |(&value, &peak)| round(value, peak)))
            .collect()
    }
}
