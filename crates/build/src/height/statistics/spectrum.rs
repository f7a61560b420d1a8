//! Power spectrum of heights under a Hann window.

use std::f64::consts::TAU;

use ndarray::Array2;
use rustfft::num_complex::Complex;

use crate::ground::fft::fft2;
use crate::height::HeightField;

/// Transform of windowed heights, and what its lines are.
pub(crate) struct Spectrum {
    /// Transform; index 0 is frequency 0, rows first.
    values: Array2<Complex<f64>>,
    /// Distance of the lines in 1/nm along x and y.
    pub(crate) line_per_nm: [f64; 2],
}

impl Spectrum {
    /// Of heights about their mean plane; their mean under the window is taken away.
    pub(crate) fn new(field: &HeightField) -> Self {
        let [nx, ny] = field.size();
        let single = |count: usize| if count == 1 { vec![1.0] } else { hann(count) };
        let (wx, wy) = (single(nx), single(ny));
        let weighted = || field.heights_nm.indexed_iter().map(|((j, i), height)| wy[j] * wx[i] * height);
        let mean: f64 = weighted().sum::<f64>() / (wx.iter().sum::<f64>() * wy.iter().sum::<f64>());
        let mut values =
            Array2::from_shape_fn((ny, nx), |(j, i)| Complex::from(wy[j] * wx[i] * (field.heights_nm[[j, i]] - mean)));
        fft2(&mut values);
        let [x, y] = field.extent_nm();
        Self { values, line_per_nm: [1.0 / x, 1.0 / y] }
    }

    /// Number of lines.
    pub(crate) fn count(&self) -> usize {
        self.values.len()
    }

    /// Powers of all lines.
    pub(crate) fn powers(&self) -> impl Iterator<Item = f64> + '_ {
        self.values.iter().map(|value| value.norm_sqr())
    }

    /// Signed line numbers of a bin, along x and along the rows.
    fn line(&self, [row, column]: [usize; 2]) -> [i64; 2] {
        let signed =
            |index: usize, count: usize| if 2 * index > count { index as i64 - count as i64 } else { index as i64 };
        [signed(column, self.values.ncols()), signed(row, self.values.nrows())]
    }

    /// The value at a line, repeated beyond the ends.
    fn at(&self, [x, y]: [i64; 2]) -> Complex<f64> {
        let wrapped = |line: i64, count: usize| line.rem_euclid(count as i64) as usize;
        self.values[[wrapped(y, self.values.nrows()), wrapped(x, self.values.ncols())]]
    }

    /// Whether a line is within the spectrum, not its repetition; an axis of one sample has line 0 only.
    pub(crate) fn has(&self, [x, y]: [i64; 2]) -> bool {
        2 * x.unsigned_abs() <= self.values.ncols() as u64 && 2 * y.unsigned_abs() <= self.values.nrows() as u64
    }

    /// Power of a line, repeated beyond the ends.
    pub(crate) fn power(&self, line: [i64; 2]) -> f64 {
        self.at(line).norm_sqr()
    }

    /// Distance of a line from the origin, in the coarser of the two lines.
    pub(crate) fn ring(&self, [x, y]: [f64; 2]) -> usize {
        let coarse = self.line_per_nm[0].max(self.line_per_nm[1]);
        (x * self.line_per_nm[0] / coarse).hypot(y * self.line_per_nm[1] / coarse).round() as usize
    }

    /// Bins of the half plane that stands for all, with their lines.
    pub(crate) fn half_plane(&self) -> impl Iterator<Item = [i64; 2]> + '_ {
        let (rows, columns) = self.values.dim();
        (0..rows)
            .flat_map(move |row| (0..columns).map(move |column| self.line([row, column])))
            .filter(|&[x, y]| x > 0 || (x == 0 && y > 0))
    }
}

/// Hann window with zeros just outside the samples, its sum 1; 1 for a single sample.
fn hann(count: usize) -> Vec<f64> {
    (0..count).map(|i| (1.0 - (TAU * (i as f64 + 0.5) / count as f64).cos()) / count as f64).collect()
}
