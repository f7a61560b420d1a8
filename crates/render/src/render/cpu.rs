//! Shading on the CPU, in parallel over rows; the same bytes on any number of threads.

use std::ops::Range;

use ndarray::{Array3, Axis};
use rayon::prelude::*;

use crate::scene::filtered::{FilteredSamples, filtered_per_pixel, filtered_samples_of};
use crate::scene::model::{Scene, check};
use crate::scene::samples::{ShadingSamples, pixel_range, samples_of, samples_per_pixel};
use diffraction_brdf::Footprint;
use diffraction_brdf::direction::{Vec3, Xyz};
use diffraction_brdf::error::Result;

use super::Brdf;

/// Samples gathered at a time: 29 MB, twice that of filtered look-ups.
const BAND_SAMPLES: usize = 1 << 20;

/// XYZ image `[rows, columns, 3]` of gathered samples: `Σ weight f(wi, wo)` in each pixel, summed
/// in double precision in the samples' order.
pub fn shade(samples: &ShadingSamples, brdf: &Brdf) -> Array3<f32> {
    let mut image = Array3::zeros((samples.rows, samples.columns, 3));
    image.axis_iter_mut(Axis(0)).into_par_iter().enumerate().for_each(|(r, mut row)| {
        for (c, mut pixel) in row.outer_iter_mut().enumerate() {
            let xyz = shade_pixel(samples, brdf, r, c);
            for (channel, value) in pixel.iter_mut().zip(xyz) {
                *channel = value as f32;
            }
        }
    });
    image
}

fn shade_pixel(samples: &ShadingSamples, brdf: &Brdf, row: usize, column: usize) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for index in pixel_range(samples, row, column) {
        let f = brdf(samples.wi[index].map(f64::from), samples.wo[index].map(f64::from));
        let weight = f64::from(samples.weight[index]);
        for (total, value) in sum.iter_mut().zip(f) {
            *total += weight * value;
        }
    }
    sum
}

/// A mean of a BRDF over footprints to shade with, as `diffraction_brdf::Brdf::eval_filtered`: local `wi` and `wo` to XYZ in 1/sr.
pub type MeanBrdf<'a> = dyn Fn(Vec3, Vec3, Footprint) -> Xyz + Sync + 'a;

/// As [`shade`], of samples that stand for a piece of a light and of a pixel each.
pub fn shade_filtered(filtered: &FilteredSamples, mean: &MeanBrdf) -> Array3<f32> {
    let samples = &filtered.samples;
    let mut image = Array3::zeros((samples.rows, samples.columns, 3));
    image.axis_iter_mut(Axis(0)).into_par_iter().enumerate().for_each(|(r, mut row)| {
        for (c, mut pixel) in row.outer_iter_mut().enumerate() {
            let mut sum = [0.0; 3];
            for index in pixel_range(samples, r, c) {
                let [wi, wo] = [samples.wi[index], samples.wo[index]].map(|v| v.map(f64::from));
                let f = mean(wi, wo, filtered.footprints[index]);
                let weight = f64::from(samples.weight[index]);
                sum.iter_mut().zip(f).for_each(|(sum, value)| *sum += weight * value);
            }
            pixel.iter_mut().zip(sum).for_each(|(channel, value)| *channel = value as f32);
        }
    });
    image
}

/// Picture of a scene with one look-up for each light that is small enough for it to keep the tolerance, and for each pixel
/// that shows one smooth piece of surface; larger lights and surroundings are sampled. Gathered and shaded band by band.
///
/// # Errors
/// Those of [`filtered_samples_of`].
pub fn render_filtered(scene: &Scene, tolerance: f64, mean: &MeanBrdf) -> Result<Array3<f32>> {
    check(scene)?;
    in_bands(scene.size_px, filtered_per_pixel(scene), |rows| {
        Ok(shade_filtered(&filtered_samples_of(scene, tolerance, rows, 1)?, mean))
    })
}

/// Picture of a scene, gathered and shaded band by band, so that memory stays bounded however
/// many samples a pixel has. The same values as [`shade`] of all samples.
pub fn render(scene: &Scene, brdf: &Brdf) -> Result<Array3<f32>> {
    check(scene)?;
    in_bands(scene.size_px, samples_per_pixel(scene), |rows| Ok(shade(&samples_of(scene, rows, 1)?, brdf)))
}

/// A square picture put together of bands of rows that hold about [`BAND_SAMPLES`] samples.
fn in_bands(
    side: usize,
    samples_per_pixel: usize,
    shade: impl Fn(Range<usize>) -> Result<Array3<f32>>,
) -> Result<Array3<f32>> {
    let band_rows = (BAND_SAMPLES / (samples_per_pixel * side)).clamp(1, side);
    let mut image = Array3::zeros((side, side, 3));
    for (index, mut band) in image.axis_chunks_iter_mut(Axis(0), band_rows).enumerate() {
        let start = index * band_rows;
        band.assign(&shade(start..side.min(start + band_rows))?);
    }
    Ok(image)
}
