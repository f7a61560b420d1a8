//! What the wave methods share: heights between samples, and sums of phasors over a spectrum.

use std::f64::consts::TAU;

use rustfft::num_complex::Complex;

use diffraction_build::height::HeightField;

/// Height in nm at a place in nm from the middle of a scan, y up, linear between samples; `None` beyond the outermost
/// samples.
pub(super) fn height_at(field: &HeightField, place_nm: [f64; 2]) -> Option<f64> {
    let size = field.size();
    let at: [f64; 2] = std::array::from_fn(|axis| {
        let sign = if axis == 0 { 1.0 } else { -1.0 };
        sign * place_nm[axis] / field.pitch_nm[axis] + 0.5 * (size[axis] - 1) as f64
    });
    // A single sample has no structure along its axis, however far.
    let cell = |axis: usize| -> Option<(usize, usize, f64)> {
        let last = size[axis] - 1;
        if last == 0 {
            return Some((0, 0, 0.0));
        }
        // Half a rounding beyond is still the outermost sample.
        let x = (-1e-9..=last as f64 + 1e-9).contains(&at[axis]).then(|| at[axis].clamp(0.0, last as f64))?;
        let first = (x as usize).min(last - 1);
        Some((first, first + 1, x - first as f64))
    };
    let ((left, right, across), (top, bottom, down)) = (cell(0)?, cell(1)?);
    let row = |row: usize| {
        let [a, b] = [left, right].map(|column| field.heights_nm[[row, column]]);
        a + across * (b - a)
    };
    Some(row(top) + down * (row(bottom) - row(top)))
}

/// `Σ a_j exp(i k l_j)` at each wavelength, which lie at equal steps of wavenumber: from one to the next each phasor is
/// multiplied by a constant.
pub(super) fn phasor_sums(lengths_nm: &[f64], amplitudes: &[f64], wavelengths_nm: &[f64]) -> Vec<Complex<f64>> {
    let (Some(first), Some(last)) = (wavelengths_nm.first(), wavelengths_nm.last()) else { return Vec::new() };
    let step = (1.0 / last - 1.0 / first) / wavelengths_nm.len().saturating_sub(1).max(1) as f64;
    let phasors = lengths_nm.iter().zip(amplitudes).map(|(l, a)| Complex::from_polar(*a, TAU / first * l));
    let mut phasors: Vec<Complex<f64>> = phasors.collect();
    let steps: Vec<Complex<f64>> = lengths_nm.iter().map(|l| Complex::cis(TAU * step * l)).collect();
    let sum_and_advance = |_: &f64| {
        let mut sum = Complex::default();
        for (phasor, step) in phasors.iter_mut().zip(&steps) {
            sum += *phasor;
            *phasor *= step;
        }
        sum
    };
    wavelengths_nm.iter().map(sum_and_advance).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_between_samples_are_linear_and_y_points_up() {
        let heights_nm = ndarray::Array2::from_shape_fn((5, 8), |(row, column)| 3.0 * column as f64 - 7.0 * row as f64);
        let field = HeightField { heights_nm, pitch_nm: [10.0, 20.0] };
        // The middle lies between columns 3 and 4, on row 2.
        for place in [[0.0, 0.0], [13.0, -9.0], [-35.0, 40.0], [35.0, -40.0]] {
            let expected = 3.0 * (3.5 + place[0] / 10.0) - 7.0 * (2.0 - place[1] / 20.0);
            assert!((height_at(&field, place).unwrap() - expected).abs() < 1e-9, "{place:?}");
        }
        assert!(height_at(&field, [35.1, 0.0]).is_none() && height_at(&field, [0.0, 40.1]).is_none());
    }

    #[test]
    fn sums_of_phasors_are_those_of_their_phases() {
        let lengths: Vec<f64> = (0..40).map(|i| f64::from(i * i % 23) * 171.0 - 900.0).collect();
        let amplitudes: Vec<f64> = (0..40).map(|i| 1.0 / f64::from(1 + i)).collect();
        let wavelengths: Vec<f64> = (0..300).map(|i| 1.0 / (1.0 / 380.0 - f64::from(i) * 4e-6)).collect();
        let found = phasor_sums(&lengths, &amplitudes, &wavelengths);
        for (sum, nm) in found.iter().zip(&wavelengths) {
            let terms = lengths.iter().zip(&amplitudes).map(|(l, a)| Complex::from_polar(*a, TAU / nm * l));
            assert!((sum - terms.sum::<Complex<f64>>()).norm() < 1e-11);
        }
    }
}
