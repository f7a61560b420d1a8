//! The samples of a generated field, and steps that several structures share.

use ndarray::Array2;
use rayon::prelude::*;

use diffraction_brdf::error::{Error, Result};

/// Largest number of samples generated: as many as the reader accepts by default.
const SAMPLES_MAX: usize = 1 << 26;

/// Where the samples lie: at the centres of their cells, x to the right and y up from the lower left
/// corner of the tile.
pub(super) struct Grid {
    pub(super) size: [usize; 2],
    pub(super) pitch_nm: [f64; 2],
}

impl Grid {
    pub(super) fn new(size: [usize; 2], pitch_nm: [f64; 2]) -> Result<Self> {
        if !pitch_nm.iter().all(|pitch| (1e-3..=1e6).contains(pitch)) {
            return Err(Error::Call(format!("the pitch {pitch_nm:?} nm is not between 0.001 nm and 1 mm")));
        }
        let samples = size[0].saturating_mul(size[1]);
        if samples == 0 {
            return Err(Error::Call(format!("a field of {} x {} samples is empty", size[0], size[1])));
        }
        if samples > SAMPLES_MAX {
            return Err(Error::limit(
                format!("a field of {} x {} samples; the limit is {SAMPLES_MAX} samples", size[0], size[1]),
                "lower the size",
            ));
        }
        Ok(Self { size, pitch_nm })
    }

    /// Extent of the tile along x and y in nm.
    pub(super) fn extent_nm(&self) -> [f64; 2] {
        [self.size[0] as f64 * self.pitch_nm[0], self.size[1] as f64 * self.pitch_nm[1]]
    }

    pub(super) fn x_nm(&self, column: usize) -> f64 {
        (column as f64 + 0.5) * self.pitch_nm[0]
    }

    pub(super) fn y_nm(&self, row: usize) -> f64 {
        ((self.size[1] - 1 - row) as f64 + 0.5) * self.pitch_nm[1]
    }

    /// Evaluates a height at every sample. Each depends on its place alone, so threads do not matter.
    pub(super) fn sample(&self, height_nm: impl Fn(f64, f64) -> f64 + Sync) -> Array2<f64> {
        let mut heights = Array2::zeros([self.size[1], self.size[0]]);
        heights.outer_iter_mut().into_par_iter().enumerate().for_each(|(row, mut line)| {
            let y = self.y_nm(row);
            for (column, height) in line.iter_mut().enumerate() {
                *height = height_nm(self.x_nm(column), y);
            }
        });
        heights
    }

    /// Whole number of pieces `spacing_nm` wide along an axis, at least `min`.
    pub(super) fn count(&self, axis: usize, spacing_nm: f64, min: usize, what: &str) -> Result<usize> {
        let extent = self.extent_nm()[axis];
        let count = (extent / spacing_nm).round() as usize;
        if count < min {
            return Err(Error::Call(format!(
                "the tile is {extent} nm {}; {what} needs {} nm at least",
                ["wide", "high"][axis],
                min as f64 * spacing_nm
            )));
        }
        Ok(count)
    }

    /// Refuses a pitch that cannot resolve details of a given size.
    pub(super) fn check_pitch(&self, pitch_max_nm: f64, what: &str) -> Result<()> {
        if self.pitch_nm.iter().all(|pitch| *pitch <= pitch_max_nm) {
            return Ok(());
        }
        Err(Error::Call(format!(
            "a pitch of {:?} nm is too coarse for {what}: {pitch_max_nm} nm at most",
            self.pitch_nm
        )))
    }
}

/// Smooth step from 0 below -1 to 1 above 1, with continuous slope.
pub(super) fn step(x: f64) -> f64 {
    let t = (0.5 * (x + 1.0)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Length of a vector. Square roots have the same bits everywhere, `f64::hypot` need not.
pub(super) fn length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

/// Rounds heights to 1/8 nm, about the noise of a good microscope: files of irregular structures then compress
/// to less than half the size.
pub(super) fn round_heights(heights: &mut Array2<f64>) {
    heights.mapv_inplace(|height| (height * 8.0).round() / 8.0);
}
