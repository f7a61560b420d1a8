//! Whether a scan holds a whole number of a grating's periods, so that repeating it invents nothing.

use ndarray::Array2;
use rustfft::num_complex::Complex;

use super::periods::WAVES_MIN;
use crate::ground::fft::fft2;
use crate::height::HeightField;

/// Share of the heights' power that must lie in the harmonics of one line.
const GRATING_SHARE: f64 = 0.98;

/// Whether nearly all of a scan's power lies in the harmonics of its strongest line: then repeating the scan continues
/// the grating that it shows. Power between them would become lines of the repetition.
pub fn is_whole_grating(field: &HeightField) -> bool {
    let (rows, columns) = field.heights_nm.dim();
    let mean = field.heights_nm.mean().unwrap_or(0.0);
    let mut spectrum = field.heights_nm.mapv(|h| Complex::new(h - mean, 0.0));
    fft2(&mut spectrum);
    let power = spectrum.mapv(|value| value.norm_sqr());
    let total = power.sum();
    let strongest = power.indexed_iter().max_by(|a, b| a.1.total_cmp(b.1));
    let Some(((row, column), _)) = strongest.filter(|_| total > 0.0) else { return false };
    let signed =
        |index: usize, count: usize| if 2 * index > count { index as i64 - count as i64 } else { index as i64 };
    let line = [signed(row, rows), signed(column, columns)];
    let waves = (line[0] as f64).hypot(line[1] as f64);
    waves >= WAVES_MIN && harmonics(&power, line) >= GRATING_SHARE * total
}

/// Power of the multiples of a line that the sampling holds, both signs.
fn harmonics(power: &Array2<f64>, line: [i64; 2]) -> f64 {
    let (rows, columns) = power.dim();
    let holds = |m: i64| {
        (m * line[0]).unsigned_abs() as usize * 2 <= rows && (m * line[1]).unsigned_abs() as usize * 2 <= columns
    };
    let at = |m: i64| {
        let [row, column] = [(m * line[0]).rem_euclid(rows as i64), (m * line[1]).rem_euclid(columns as i64)];
        power[[row as usize, column as usize]]
    };
    (1..).take_while(|&m| holds(m)).map(|m| at(m) + at(-m)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scan(height: impl Fn(f64) -> f64) -> HeightField {
        HeightField {
            heights_nm: Array2::from_shape_fn((16, 128), |(_, column)| height(column as f64 / 128.0)),
            pitch_nm: [50.0; 2],
        }
    }

    #[test]
    fn whole_periods_are_told_from_parts_of_them_and_from_bumps() {
        let wave = |periods: f64| move |x: f64| 40.0 * (std::f64::consts::TAU * periods * x).sin();
        // Blazed: a sawtooth has many harmonics.
        let blaze = |periods: f64| move |x: f64| 100.0 * (periods * x).fract();
        for whole in [scan(wave(8.0)), scan(blaze(8.0)), scan(wave(3.0))] {
            assert!(is_whole_grating(&whole));
        }
        let bump = |x: f64| 50.0 * (-((x - 0.4) / 0.05).powi(2)).exp();
        for part in [scan(wave(8.4)), scan(blaze(7.5)), scan(wave(1.0)), scan(bump), scan(|_| 3.0)] {
            assert!(!is_whole_grating(&part));
        }
    }
}
