//! Removal of single outliers, such as glitches of the tip.

use ndarray::Array2;
use rayon::prelude::*;

use super::robust::{SIGMA_PER_MAD, median};

/// Samples on each side of the one in question that make up its surroundings.
const REACH: usize = 2;

/// A group of outliers takes at most this share of its surroundings: 4 of 25 samples. The corner of a
/// square pit takes 9 and a line one sample wide takes 5; those are structure.
const GROUP_SHARE: f64 = 1.0 / 6.0;

/// Ratio of standard deviation to mean absolute deviation of a normal distribution, `sqrt(π/2)`.
const SIGMA_PER_MEAN_DEVIATION: f64 = 1.253_314_137_315_500_3;

/// A sample and its surroundings.
#[derive(Clone, Copy)]
struct Residual {
    /// Median of the surroundings.
    median: f64,
    /// Sample minus median.
    value: f64,
    /// Whether few others share the sample's deviation.
    alone: bool,
}

/// Replaces outliers by the median of the 5 x 5 samples around them (fewer at the edges); returns
/// their number. `threshold` is in robust standard deviations.
pub fn despike(heights: &mut Array2<f64>, threshold: f64) -> usize {
    let (rows, columns) = heights.dim();
    let residuals: Vec<Residual> = (0..rows)
        .into_par_iter()
        .flat_map_iter(|row| {
            let heights = &*heights;
            let mut around = Vec::with_capacity((2 * REACH + 1).pow(2));
            (0..columns).map(move |column| residual(heights, row, column, &mut around))
        })
        .collect();
    let limit = threshold * robust_sigma(&residuals);
    let mut count = 0;
    for (height, residual) in heights.iter_mut().zip(&residuals) {
        if residual.alone && residual.value.abs() > limit {
            *height = residual.median;
            count += 1;
        }
    }
    count
}

fn residual(heights: &Array2<f64>, row: usize, column: usize, around: &mut Vec<f64>) -> Residual {
    let (rows, columns) = heights.dim();
    around.clear();
    for j in row.saturating_sub(REACH)..(row + REACH + 1).min(rows) {
        for i in column.saturating_sub(REACH)..(column + REACH + 1).min(columns) {
            around.push(heights[[j, i]]);
        }
    }
    let median = median(around);
    let value = heights[[row, column]] - median;
    // Those on the sample's side of half-way share its deviation, itself included.
    let companions = around.iter().filter(|&&height| (height - median) * value.signum() > 0.5 * value.abs()).count();
    let alone = companions <= ((around.len() as f64 * GROUP_SHARE) as usize).max(1);
    Residual { median, value, alone }
}

/// Standard deviation of the residuals that a few outliers do not change.
fn robust_sigma(residuals: &[Residual]) -> f64 {
    let mut deviations: Vec<f64> = residuals.iter().map(|residual| residual.value.abs()).collect();
    let mad = median(&mut deviations);
    if mad > 0.0 {
        return SIGMA_PER_MAD * mad;
    }
    // More than half of the samples equal their surroundings, as on coarsely quantised flat ground;
    // the mean still tells whether there is anything to measure outliers against.
    SIGMA_PER_MEAN_DEVIATION * deviations.iter().sum::<f64>() / deviations.len() as f64
}
