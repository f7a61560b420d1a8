//! Distance over which heights are correlated.

use ndarray::Array2;
use rustfft::num_complex::Complex;

use crate::ground::fft::fft2;
use crate::height::HeightField;

/// Shortest distance in nm over all directions at which the autocorrelation falls to 1/e (the `Sal` of
/// ISO 25178-2 with `s = 1/e`), of heights with mean 0; NaN where it does not within half of the scan.
pub fn length_nm(field: &HeightField) -> f64 {
    let correlation = autocorrelation(&field.heights_nm);
    let (rows, columns) = correlation.dim();
    let level = (-1.0f64).exp() * correlation[[0, columns / 2]];
    let middle = columns / 2;
    let [dx, dy] = field.pitch_nm;
    let mut shortest = f64::INFINITY;
    // Where the contour cuts the grid's lines, by linear interpolation.
    let mut cut = |from: [usize; 2], to: [usize; 2]| {
        let (a, b) = (correlation[from] - level, correlation[to] - level);
        if (a > 0.0) != (b > 0.0) {
            let t = a / (a - b);
            let at = |axis: usize| from[axis] as f64 + t * (to[axis] as f64 - from[axis] as f64);
            shortest = shortest.min(((at(1) - middle as f64) * dx).hypot(at(0) * dy));
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
    if shortest.is_finite() { shortest } else { f64::NAN }
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
