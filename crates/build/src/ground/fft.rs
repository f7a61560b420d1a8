//! Two-dimensional discrete Fourier transform of an array in place.

use ndarray::parallel::prelude::*;
use ndarray::{Array2, Axis};
use rustfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};

/// Columns gathered at a time: 8 complex numbers are two cache lines of each row.
const BLOCK: usize = 8;

/// Forward transform, not normalised:
/// `F[m][n] = Σ_j Σ_i f[j][i] exp(-2πi (m j / rows + n i / columns))`, for any size.
///
/// The result does not depend on the number of threads: each line is transformed by itself.
pub(crate) fn fft2(data: &mut Array2<Complex<f64>>) {
    if data.is_empty() {
        return;
    }
    let mut planner = FftPlanner::new();
    let along_rows = planner.plan_fft_forward(data.ncols());
    let along_columns = planner.plan_fft_forward(data.nrows());
    // Rows one by one, for they are contiguous in most arrays; columns never are.
    transform(data, Axis(0), 1, &*along_rows);
    transform(data, Axis(1), BLOCK, &*along_columns);
}

/// Transforms every line of the array; lines are counted along `across` and gathered by `block`.
fn transform(data: &mut Array2<Complex<f64>>, across: Axis, block: usize, fft: &dyn Fft<f64>) {
    let scratch = || (Vec::new(), vec![Complex::default(); fft.get_inplace_scratch_len()]);
    data.axis_chunks_iter_mut(across, block).into_par_iter().for_each_init(scratch, |(lines, scratch), mut chunk| {
        lines.clear();
        lines.resize(chunk.len(), Complex::default());
        // Row by row through the array's memory, whichever way its lines run.
        let count = chunk.len_of(across);
        let length = fft.len();
        let place = |line: usize, at: usize| if across == Axis(0) { [line, at] } else { [at, line] };
        for at in 0..length {
            for line in 0..count {
                lines[line * length + at] = chunk[place(line, at)];
            }
        }
        fft.process_with_scratch(lines, scratch);
        for at in 0..length {
            for line in 0..count {
                chunk[place(line, at)] = lines[line * length + at];
            }
        }
    });
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use proptest::prelude::*;

    use super::*;

    /// The sum as textbooks write it, with the angle reduced exactly in integers.
    fn textbook(data: &Array2<Complex<f64>>) -> Array2<Complex<f64>> {
        let (rows, columns) = data.dim();
        Array2::from_shape_fn((rows, columns), |(m, n)| {
            data.indexed_iter()
                .map(|((j, i), value)| {
                    let turns = (m * j % rows) as f64 / rows as f64 + (n * i % columns) as f64 / columns as f64;
                    value * Complex::cis(-TAU * turns)
                })
                .sum()
        })
    }

    fn random(rows: usize, columns: usize, seed: u64) -> Array2<Complex<f64>> {
        let mut random = fastrand::Rng::with_seed(seed);
        Array2::from_shape_simple_fn((rows, columns), || Complex::new(random.f64() - 0.5, random.f64() - 0.5))
    }

    fn distance(a: &Array2<Complex<f64>>, b: &Array2<Complex<f64>>) -> f64 {
        a.iter().zip(b).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max)
    }

    proptest! {
        #[test]
        fn equals_the_textbook_sum(rows in 1usize..20, columns in 1usize..20, seed in any::<u64>()) {
            let mut data = random(rows, columns, seed);
            let expected = textbook(&data);
            fft2(&mut data);
            // At most 400 terms of modulus below 1; each sum loses less than one ulp per term.
            prop_assert!(distance(&data, &expected) < 400.0 * 400.0 * f64::EPSILON);
        }
    }

    #[test]
    fn the_other_sign_would_be_seen() {
        let data = random(5, 17, 1);
        let mut wrong = data.mapv(|value| value.conj());
        fft2(&mut wrong);
        assert!(distance(&wrong.mapv(|value| value.conj()), &textbook(&data)) > 0.1);
    }

    #[test]
    fn column_major_and_empty_arrays_are_fine() {
        let data = random(6, 11, 2);
        let mut turned = data.t().as_standard_layout().into_owned().reversed_axes();
        assert!(!turned.is_standard_layout());
        let expected = textbook(&data);
        fft2(&mut turned);
        assert!(distance(&turned, &expected) < 1e-12);
        fft2(&mut Array2::zeros((0, 4)));
        fft2(&mut Array2::zeros((4, 0)));
    }
}
