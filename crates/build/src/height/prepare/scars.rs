//! Scars: streaks of one scan line's height along the fast axis, where the tip lost the surface for a moment.

use std::ops::Range;

use ndarray::{Array2, ArrayView1};

use super::robust::sigma_about;

/// Least height of a scar over both neighbouring lines, in root mean square heights of the levelled scan. On eight real scans
/// and the generated ones, streaks of this height have at most 5 samples.
const HEIGHT_MIN_RMS: f64 = 0.4;

/// The same in robust standard deviations of a sample from the mean of those above and below it, so that lines that are
/// offset throughout, hum and noise are no scars: of normal deviates one in 5e8 exceeds it, so twelve in a row never do.
const HEIGHT_MIN_SIGMAS: f64 = 6.0;

/// Fewest samples in a row.
const SAMPLES_MIN: usize = 12;

/// A streak.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Scar {
    /// Its line.
    pub row: usize,
    /// Its samples.
    pub columns: Range<usize>,
    /// Mean height in nm over the nearer of the neighbouring lines, signed.
    pub height_nm: f64,
}

/// The scars of a scan whose levelled heights have this root mean square.
pub(crate) fn scars(heights: &Array2<f64>, rms_nm: f64) -> Vec<Scar> {
    let rows = heights.nrows();
    if rows < 3 || heights.ncols() < SAMPLES_MIN || rms_nm <= 0.0 {
        return Vec::new();
    }
    let bends: Vec<f64> = (1..rows - 1)
        .flat_map(|row| {
            (0..heights.ncols()).map(move |i| heights[[row, i]] - 0.5 * (heights[[row - 1, i]] + heights[[row + 1, i]]))
        })
        .collect();
    let least_nm = (HEIGHT_MIN_RMS * rms_nm).max(HEIGHT_MIN_SIGMAS * sigma_about(0.0, &bends));
    (1..rows - 1).flat_map(|row| of_row(heights, row, least_nm)).collect()
}

fn of_row(heights: &Array2<f64>, row: usize, least_nm: f64) -> Vec<Scar> {
    let [above, line, below] = [row - 1, row, row + 1].map(|row| heights.row(row));
    let rises: Vec<f64> = (0..line.len()).map(|i| rise(&above, &line, &below, i)).collect();
    let side = |rise: &f64| if rise.abs() < least_nm { 0 } else { rise.signum() as i32 };
    let mut first = 0;
    let mut found = Vec::new();
    for run in rises.chunk_by(|a, b| side(a) == side(b)) {
        if side(&run[0]) != 0 && run.len() >= SAMPLES_MIN {
            let height_nm = run.iter().sum::<f64>() / run.len() as f64;
            found.push(Scar { row, columns: first..first + run.len(), height_nm });
        }
        first += run.len();
    }
    found
}

/// By how much a sample rises over both lines beside it, or falls below both; 0 where it lies between.
fn rise(above: &ArrayView1<f64>, line: &ArrayView1<f64>, below: &ArrayView1<f64>, i: usize) -> f64 {
    let (up, down) = (line[i] - above[i], line[i] - below[i]);
    if up * down <= 0.0 { 0.0 } else { up.signum() * up.abs().min(down.abs()) }
}
