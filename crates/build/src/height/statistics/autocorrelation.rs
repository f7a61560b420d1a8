//! Distance over which heights are correlated.

use ndarray::Array2;
use rustfft::num_complex::Complex;

use crate::ground::fft::fft2;
use crate::height::HeightField;

/// Distances at which an autocorrelation falls to some share of its value at 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Decay {
    /// Shortest over all directions in nm; NaN where it does not fall so far within half of the scan.
    pub shortest_nm: f64,
    /// Longest in nm, within which it stays above in that direction; NaN where it does not fall within half of the scan in some direction.
    pub longest_nm: f64,
}

/// [`decays`] to one share.
#[cfg(test)]
pub fn decay(field: &HeightField, share: f64) -> Decay {
    let [decay] = decays(field, [share]);
    decay
}

/// Falls to shares of the value at 0, of heights with mean 0: the shortest is `Sal` of ISO 25178-2 with the share as its `s`, the
/// ratio of shortest to longest `Str`.
pub fn decays<const N: usize>(field: &HeightField, shares: [f64; N]) -> [Decay; N] {
    let correlation = autocorrelation(&field.heights_nm);
    shares.map(|share| fall(&correlation, field.pitch_nm, share))
}

fn fall(correlation: &Array2<f64>, [dx, dy]: [f64; 2], share: f64) -> Decay {
    let (rows, columns) = correlation.dim();
    let middle = columns / 2;
    let level = share * correlation[[0, middle]];
    let region = region_above(correlation, level);
    let mut decay = Decay { shortest_nm: f64::INFINITY, longest_nm: 0.0 };
    // Where the contour cuts the grid's lines, by linear interpolation.
    let mut cut = |from: [usize; 2], to: [usize; 2]| {
        let (a, b) = (correlation[from] - level, correlation[to] - level);
        if (a > 0.0) != (b > 0.0) {
            let t = a / (a - b);
            let at = |axis: usize| from[axis] as f64 + t * (to[axis] as f64 - from[axis] as f64);
            let distance_nm = ((at(1) - middle as f64) * dx).hypot(at(0) * dy);
            decay.shortest_nm = decay.shortest_nm.min(distance_nm);
            if region[from] || region[to] {
                decay.longest_nm = decay.longest_nm.max(distance_nm);
            }
        }
    };
    for row in 0..rows {
        for column in 0..columns {
            if column + 1 < columns {
                cut([row, column], [row, column + 1]);
            }
            if row + 1 < rows {
                cut([row, column], [row + 1, column]);
            }
        }
    }
    let is_border = |(row, column): (usize, usize)| row + 1 == rows || column == 0 || column + 1 == columns;
    if region.indexed_iter().any(|(place, inside)| *inside && is_border(place)) {
        decay.longest_nm = f64::NAN;
    }
    if !decay.shortest_nm.is_finite() {
        decay.shortest_nm = f64::NAN;
    }
    decay
}

/// The lags that hang together with 0 and at which the autocorrelation is above a level.
fn region_above(correlation: &Array2<f64>, level: f64) -> Array2<bool> {
    let (rows, columns) = correlation.dim();
    let mut region = Array2::from_elem((rows, columns), false);
    let mut next = vec![[0, columns / 2]];
    while let Some([row, column]) = next.pop() {
        if region[[row, column]] || correlation[[row, column]] <= level {
            continue;
        }
        region[[row, column]] = true;
        if row > 0 {
            next.push([row - 1, column]);
        }
        if column > 0 {
            next.push([row, column - 1]);
        }
        if row + 1 < rows {
            next.push([row + 1, column]);
        }
        if column + 1 < columns {
            next.push([row, column + 1]);
        }
    }
    region
}

/// Mean product of heights a lag apart, over all pairs there are, for lags up to half of the field:
/// 0 to `rows/2` along the rows and `-columns/2` to `columns/2` along the columns (the other half is its mirror image).
fn autocorrelation(heights: &Array2<f64>) -> Array2<f64> {
    let (rows, columns) = heights.dim();
    let reach = [rows / 2, columns / 2];
    // Zeros to a lag's length keep what wraps around out of the lags wanted.
    let mut spectrum = Array2::from_elem((rows + reach[0], columns + reach[1]), Complex::<f64>::default());
    for (mut line, heights) in spectrum.rows_mut().into_iter().zip(heights.rows()) {
        line.iter_mut().zip(heights).for_each(|(value, height)| value.re = *height);
    }
    fft2(&mut spectrum);
    // The power spectrum is real and even, so the forward transform is its own inverse.
    spectrum.mapv_inplace(|value| Complex::from(value.norm_sqr()));
    fft2(&mut spectrum);
    let (padded_columns, size) = (spectrum.ncols(), spectrum.len() as f64);
    Array2::from_shape_fn((reach[0] + 1, 2 * reach[1] + 1), |(row, column)| {
        let lag = column.abs_diff(reach[1]);
        let wrapped = (column + padded_columns - reach[1]) % padded_columns;
        spectrum[[row, wrapped]].re / size / ((rows - row) * (columns - lag)) as f64
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equals_the_sum_over_pairs() {
        let mut random = fastrand::Rng::with_seed(3);
        let heights = Array2::from_shape_simple_fn((7, 10), || random.f64() - 0.5);
        let found = autocorrelation(&heights);
        assert_eq!(found.dim(), (4, 11));
        for ((row, column), value) in found.indexed_iter() {
            let lag = column as isize - 5;
            let pairs: Vec<f64> = heights
                .indexed_iter()
                .filter_map(|((j, i), height)| {
                    let other = heights.get([j + row, i.checked_add_signed(lag)?])?;
                    Some(height * other)
                })
                .collect();
            let mean = pairs.iter().sum::<f64>() / pairs.len() as f64;
            assert!((value - mean).abs() < 1e-14, "{row} {lag}: {value} {mean}");
        }
    }
}
