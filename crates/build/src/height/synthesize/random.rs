//! Seeded random surfaces that repeat exactly on their tile.

use std::f64::consts::PI;

use fastrand::Rng;
use ndarray::{Array2, Axis, Zip};

use super::grid::Grid;
use diffraction_brdf::error::{Error, Result};

/// One standard normal number, by Box and Muller.
pub(super) fn normal(rng: &mut Rng) -> f64 {
    // 1 - f64() lies in (0, 1], where the logarithm is finite.
    let radius = (-2.0 * libm::log(1.0 - rng.f64())).sqrt();
    radius * libm::cos(2.0 * PI * rng.f64())
}

/// A normal number cut off at `limit` standard deviations.
pub(super) fn bounded_normal(rng: &mut Rng, limit: f64) -> f64 {
    normal(rng).clamp(-limit, limit)
}

/// A Gaussian rough surface, after checking its parameters against the grid.
pub(super) fn rough_checked(grid: &Grid, rms_nm: f64, correlation_length_nm: f64, seed: u64) -> Result<Array2<f64>> {
    if !(1e-6..=1e9).contains(&rms_nm) {
        return Err(Error::Call(format!("the rms height must lie between 1e-6 nm and 1 m, not be {rms_nm} nm")));
    }
    if grid.size == [1, 1] {
        return Err(Error::Call("one sample alone has no rms height".to_owned()));
    }
    for axis in (0..2).filter(|axis| grid.size[*axis] > 1) {
        // At the highest frequency of two samples per correlation length the spectrum exp(-(pi f L)^2) has
        // fallen to 5e-5; on fewer than four correlation lengths the repetition shows in the autocorrelation.
        let (shortest, longest) = (2.0 * grid.pitch_nm[axis], 0.25 * grid.extent_nm()[axis]);
        if !(shortest..=longest).contains(&correlation_length_nm) {
            return Err(Error::Call(format!(
                "the correlation length must lie between two samples and a quarter of the tile, here {shortest} nm and \
                 {longest} nm, not be {correlation_length_nm} nm"
            )));
        }
    }
    Ok(rough(grid, rms_nm, [correlation_length_nm; 2], &mut Rng::with_seed(seed)))
}

/// White noise smoothed by a Gaussian around the tile, then shifted and scaled to mean 0 and the rms exactly.
pub(super) fn rough(grid: &Grid, rms_nm: f64, correlation_length_nm: [f64; 2], rng: &mut Rng) -> Array2<f64> {
    let mut heights = Array2::from_shape_simple_fn([grid.size[1], grid.size[0]], || normal(rng));
    for (axis, length_nm) in correlation_length_nm.into_iter().enumerate() {
        let kernel = kernel(grid.size[axis], length_nm / grid.pitch_nm[axis]);
        smooth_around(&mut heights, Axis(1 - axis), &kernel);
    }
    let mean = heights.sum() / heights.len() as f64;
    heights -= mean;
    let rms = (heights.iter().map(|height| height * height).sum::<f64>() / heights.len() as f64).sqrt();
    heights *= rms_nm / rms;
    heights
}

/// Offsets in samples and weights of the smoothing kernel. A kernel `exp(-2 (x/L)^2)` gives white noise the
/// autocorrelation `exp(-(x/L)^2)`. At 2.5 L it has fallen to 4e-6.
fn kernel(size: usize, length_samples: f64) -> Vec<(usize, f64)> {
    let reach = (2.5 * length_samples).ceil() as i64;
    (-reach..=reach)
        .map(|offset| {
            let x = offset as f64 / length_samples;
            (offset.rem_euclid(size as i64) as usize, libm::exp(-2.0 * x * x))
        })
        .collect()
}

/// Convolves every line along an axis with the kernel, around the tile's edge.
fn smooth_around(heights: &mut Array2<f64>, axis: Axis, kernel: &[(usize, f64)]) {
    Zip::from(heights.lanes_mut(axis)).par_for_each(|mut lane| {
        let line = lane.to_vec();
        for (index, height) in lane.iter_mut().enumerate() {
            *height = kernel.iter().map(|(offset, weight)| weight * line[(index + offset) % line.len()]).sum();
        }
    });
}

/// A slow undulation: a few sine waves that fit the tile.
pub(super) struct Waves {
    /// Wave numbers in radians per nm, and the cosine and sine amplitudes.
    modes: Vec<([f64; 2], [f64; 2])>,
}

impl Waves {
    /// Waves with up to `most` waves per tile along x and y, and the given rms. Amplitudes fall as one over the wave
    /// number, and smoothly to nothing on an ellipse just beyond `most`: cut on a rectangle, they would diffract into
    /// a rectangle.
    pub(super) fn new(extent_nm: [f64; 2], most: [i32; 2], rms: f64, rng: &mut Rng) -> Self {
        let mut modes = Vec::new();
        for kx in 0..=most[0] {
            for ky in -most[1]..=most[1] {
                // One of each pair (k, -k), and no constant.
                if kx == 0 && ky <= 0 {
                    continue;
                }
                let share =
                    [(kx, most[0]), (ky, most[1])].map(|(k, most)| (f64::from(k) / f64::from(most + 1)).powi(2));
                let inside = 1.0 - share[0] - share[1];
                if inside <= 0.0 {
                    continue;
                }
                let weight = inside / f64::from(kx * kx + ky * ky).sqrt();
                let amplitudes = [weight * normal(rng), weight * normal(rng)];
                let wave = [(kx, extent_nm[0]), (ky, extent_nm[1])].map(|(k, extent)| 2.0 * PI * f64::from(k) / extent);
                modes.push((wave, amplitudes));
            }
        }
        let power: f64 = modes.iter().map(|(_, [a, b])| 0.5 * (a * a + b * b)).sum();
        let scale = if power > 0.0 { rms / power.sqrt() } else { 0.0 };
        for (_, amplitudes) in &mut modes {
            *amplitudes = amplitudes.map(|amplitude| scale * amplitude);
        }
        Self { modes }
    }

    pub(super) fn at(&self, x_nm: f64, y_nm: f64) -> f64 {
        self.modes
            .iter()
            .map(|([kx, ky], [a, b])| {
                let (sine, cosine) = libm::sincos(kx * x_nm + ky * y_nm);
                a * cosine + b * sine
            })
            .sum()
    }
}
