//! Shading samples: the geometry pass of a picture, as plain arrays a CPU or a GPU can shade.
//!
//! A pixel's value is `Σ weight f(wi, wo)` over its samples; everything about cameras, lights,
//! cosines and distances is in the weights. Directions at or below the surface have no sample.

use std::ops::Range;

use rayon::prelude::*;

use diffraction_brdf::direction::Vec3;
use diffraction_brdf::error::{Error, Result};

use super::frame::to_local;
use super::hit::LitHit;
use super::light::{LightSample, environment_count, light_samples, pixel_offset};
use super::model::{Scene, Shape, check};
use super::row::{RowSamples, push};
use super::surface::{self, Surface};
use super::{hemisphere, screen, surroundings};

/// Most samples one [`ShadingSamples`] may hold: 1.9 GB.
pub const SAMPLES_TOTAL_MAX: usize = 1 << 26;

/// The samples of a picture, or of some rows of it, pixel after pixel.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ShadingSamples {
    /// Number of rows held.
    pub rows: usize,
    /// Number of columns held.
    pub columns: usize,
    /// Index of each pixel's first sample, and one past the last sample at the end:
    /// `rows * columns + 1` entries, row by row.
    pub first: Vec<u32>,
    /// Unit vectors to the light in the local frame, z > 0.
    pub wi: Vec<[f32; 3]>,
    /// Unit vectors to the viewer in the local frame, z > 0.
    pub wo: Vec<[f32; 3]>,
    /// What `f(wi, wo)` is multiplied by; positive. Unit: sr for pictures of surfaces, none for the
    /// hemisphere, sr times relative irradiance for the screen.
    pub weight: Vec<f32>,
}

/// The samples of a whole picture: 28 bytes each. Refuses scenes that fail `model::check` and
/// pictures beyond [`SAMPLES_TOTAL_MAX`]; `samples_of` takes those in parts.
pub fn samples(scene: &Scene) -> Result<ShadingSamples> {
    samples_of(scene, 0..scene.size_px, 1)
}

/// The samples of every `stride`-th pixel in both directions, starting with the first row of the
/// range and column 0.
pub fn samples_of(scene: &Scene, rows: Range<usize>, stride: usize) -> Result<ShadingSamples> {
    check(scene)?;
    let stride = stride.max(1);
    let rows: Vec<usize> = rows.step_by(stride).collect();
    let columns: Vec<usize> = (0..scene.size_px).step_by(stride).collect();
    let most = samples_per_pixel(scene) * rows.len() * columns.len();
    if most > SAMPLES_TOTAL_MAX {
        return Err(Error::limit(
            format!("scene \"{}\" needs up to {most} samples at once, more than {SAMPLES_TOTAL_MAX}", scene.name),
            "lower its size_px, light_samples or pixel_samples",
        ));
    }
    let width = pixel_width(scene);
    Ok(match (surface::surface(scene), &scene.shape) {
        (Some(surface), _) => {
            let lights = light_samples(scene);
            gather(&rows, &columns, |pixel, out| gather_surface(scene, &lights, pixel, &surface, out))
        }
        (None, Shape::Screen { .. }) => {
            let setup = screen::setup(scene);
            gather(&rows, &columns, |pixel, out| screen::gather_pixel(&setup, width, centre(scene, pixel), out))
        }
        (None, _) => {
            let lights = light_samples(scene);
            gather(&rows, &columns, |pixel, out| {
                hemisphere::gather_pixel(&lights, width, centre(scene, pixel), out);
            })
        }
    })
}

/// Most samples that a pixel can have.
pub fn samples_per_pixel(scene: &Scene) -> usize {
    match &scene.shape {
        Shape::Screen { .. } => screen::sample_count(scene),
        _ => light_samples(scene).len() + environment_count(scene),
    }
}

/// Centre of a pixel in picture coordinates: x right, y up, the picture being [-1, 1]².
pub fn pixel_centre(scene: &Scene, row: usize, column: usize) -> [f64; 2] {
    let width = pixel_width(scene);
    [(column as f64 + 0.5) * width - 1.0, 1.0 - (row as f64 + 0.5) * width]
}

/// Width of a pixel in picture coordinates.
pub(crate) fn pixel_width(scene: &Scene) -> f64 {
    2.0 / scene.size_px as f64
}

/// Reflected radiance of a surface seen by a camera: the weight is irradiance times `cos_theta_i`.
fn gather_surface(scene: &Scene, lights: &[LightSample], pixel: [usize; 2], surface: &Surface, out: &mut RowSamples) {
    let (middle, width) = (centre(scene, pixel), pixel_width(scene));
    // Samples of a light often look through one point of the pixel: what they see is found once.
    let mut last: Option<([f64; 2], Option<LitHit>)> = None;
    let mut seen = |offset| {
        let at = position(middle, offset, width);
        let found = match last {
            Some((before, found)) if before == at => found,
            _ => surface::hit(surface, at),
        };
        last = Some((at, found));
        found
    };
    let mut add = |seen: &LitHit, direction: Vec3, irradiance: f64| {
        let frame = &seen.hit.frame;
        let (wi, wo) = (to_local(frame, direction), to_local(frame, seen.hit.to_viewer));
        if wi[2] > 0.0 && wo[2] > 0.0 && surface::is_lit(surface, seen.lifted, direction) {
            push(out, wi, wo, irradiance * wi[2]);
        }
    };
    for light in lights {
        if let Some(seen) = seen(light.pixel_offset) {
            add(&seen, light.direction, light.irradiance);
        }
    }
    let Some(environment) = &scene.environment else { return };
    let (count, place) = (environment_count(scene), surroundings::morton(pixel[0], pixel[1]));
    for index in 0..count {
        let Some(seen) = seen(pixel_offset(scene, index)) else { continue };
        if let Some((direction, irradiance)) = surroundings::sample(environment, &seen.hit, place, index, count) {
            add(&seen, direction, irradiance);
        }
    }
}

/// Picture coordinates of the centre of the pixel at a row and a column.
fn centre(scene: &Scene, [row, column]: [usize; 2]) -> [f64; 2] {
    pixel_centre(scene, row, column)
}

/// Picture coordinates of a position in a pixel.
pub fn position([x, y]: [f64; 2], [dx, dy]: [f64; 2], pixel_width: f64) -> [f64; 2] {
    [x + dx * pixel_width, y + dy * pixel_width]
}

/// Runs the pixel function over the rows in parallel and joins the results in order.
fn gather(rows: &[usize], columns: &[usize], pixel: impl Fn([usize; 2], &mut RowSamples) + Sync) -> ShadingSamples {
    let gathered: Vec<RowSamples> = rows
        .par_iter()
        .map(|&row| {
            let mut out = RowSamples::default();
            for &column in columns {
                let before = out.weight.len();
                pixel([row, column], &mut out);
                out.counts.push((out.weight.len() - before) as u32);
            }
            out
        })
        .collect();
    join(rows.len(), columns.len(), gathered)
}

fn join(rows: usize, columns: usize, gathered: Vec<RowSamples>) -> ShadingSamples {
    let total = gathered.iter().map(|row| row.weight.len()).sum();
    let mut samples = ShadingSamples {
        rows,
        columns,
        first: Vec::with_capacity(rows * columns + 1),
        wi: Vec::with_capacity(total),
        wo: Vec::with_capacity(total),
        weight: Vec::with_capacity(total),
    };
    let mut next = 0;
    for row in gathered {
        for count in row.counts {
            samples.first.push(next);
            next += count;
        }
        samples.wi.extend(row.wi);
        samples.wo.extend(row.wo);
        samples.weight.extend(row.weight);
    }
    samples.first.push(next);
    samples
}

/// The range of a pixel's samples in the arrays.
pub fn pixel_range(samples: &ShadingSamples, row: usize, column: usize) -> Range<usize> {
    let pixel = row * samples.columns + column;
    samples.first[pixel] as usize..samples.first[pixel + 1] as usize
}
