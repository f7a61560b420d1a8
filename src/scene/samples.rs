//! Shading samples: the geometry pass of a picture, as plain arrays a CPU or a GPU can shade.
//!
//! A pixel's value is `Σ weight f(wi, wo)` over its samples; everything about cameras, lights,
//! cosines and distances is in the weights. Directions at or below the surface have no sample.

use std::ops::Range;

use rayon::prelude::*;

use crate::ground::direction::Vec3;
use crate::ground::error::{Error, Result};

use super::animation::{Turn, back, carried, turned};
use super::frame::{Frame, to_local};
use super::light::{LightSample, light_samples};
use super::model::{Scene, Shape, check};
use super::{hemisphere, mesh, patch, screen, snake, sphere};

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

/// Samples of one pixel row while it is being gathered.
#[derive(Debug, Default)]
pub struct RowSamples {
    counts: Vec<u32>,
    wi: Vec<[f32; 3]>,
    wo: Vec<[f32; 3]>,
    weight: Vec<f32>,
}

/// What a camera ray meets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Frame of the surface there.
    pub frame: Frame,
    /// Unit vector to the viewer in the world.
    pub to_viewer: Vec3,
}

/// What a camera ray meets on a body that may stand in its own light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LitHit {
    /// Frame and viewer.
    pub hit: Hit,
    /// Where rays to lights start.
    pub lifted: Vec3,
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
    Ok(match &scene.shape {
        Shape::Hemisphere => {
            let lights = light_samples(scene);
            gather(scene, &rows, &columns, |xy, out| {
                hemisphere::gather_pixel(&lights, pixel_width(scene), xy, out);
            })
        }
        Shape::Sphere => {
            let lights = light_samples(scene);
            gather(scene, &rows, &columns, |xy, out| {
                gather_surface(&lights, pixel_width(scene), xy, |xy| in_picture(scene.turn, xy, sphere::hit), out);
            })
        }
        Shape::Snake => {
            let lights = light_samples(scene);
            let snake = snake::snake();
            gather(scene, &rows, &columns, |xy, out| {
                let hit = |xy| turned_in_picture(scene.turn, xy, |xy| snake::hit(snake, xy));
                let is_lit = |from, direction| {
                    let [from, direction] = [from, direction].map(|v| turned(v, back(scene.turn)));
                    snake::is_lit(snake, from, direction)
                };
                gather_body(&lights, pixel_width(scene), xy, hit, is_lit, out);
            })
        }
        Shape::Mesh(shape) => {
            let lights = light_samples(scene);
            let view = mesh::view(shape, scene.turn);
            gather(scene, &rows, &columns, |xy, out| {
                let hit = |xy| mesh::hit(&view, xy);
                let is_lit = |from, direction| mesh::is_lit(&view, from, direction);
                gather_body(&lights, pixel_width(scene), xy, hit, is_lit, out);
            })
        }
        Shape::Patch { .. } => {
            let lights = light_samples(scene);
            let view = patch::turned(&patch::view(&scene.shape), scene.turn);
            gather(scene, &rows, &columns, |xy, out| {
                let hit = |xy| patch::hit(&view, xy);
                gather_surface(&lights, pixel_width(scene), xy, hit, out);
            })
        }
        Shape::Screen { .. } => {
            let setup = screen::setup(scene);
            gather(scene, &rows, &columns, |xy, out| {
                screen::gather_pixel(&setup, pixel_width(scene), xy, out);
            })
        }
    })
}

/// Most samples that a pixel can have.
pub fn samples_per_pixel(scene: &Scene) -> usize {
    match &scene.shape {
        Shape::Screen { .. } => screen::sample_count(scene),
        _ => light_samples(scene).len(),
    }
}

/// Centre of a pixel in picture coordinates: x right, y up, the picture being [-1, 1]².
pub fn pixel_centre(scene: &Scene, row: usize, column: usize) -> [f64; 2] {
    let width = pixel_width(scene);
    [(column as f64 + 0.5) * width - 1.0, 1.0 - (row as f64 + 0.5) * width]
}

/// Width of a pixel in picture coordinates.
pub fn pixel_width(scene: &Scene) -> f64 {
    2.0 / scene.size_px as f64
}

/// Adds a sample to the pixel being gathered, unless a direction is at or below the surface or the
/// weight vanishes.
pub fn push(out: &mut RowSamples, wi: Vec3, wo: Vec3, weight: f64) {
    // Tested after rounding: what is stored is what is shaded.
    let (wi, wo) = (wi.map(|c| c as f32), wo.map(|c| c as f32));
    let weight = weight as f32;
    if wi[2] > 0.0 && wo[2] > 0.0 && weight > 0.0 {
        out.wi.push(wi);
        out.wo.push(wo);
        out.weight.push(weight);
    }
}

/// Reflected radiance of a surface seen by a camera: the weight is irradiance times `cos_theta_i`.
fn gather_surface(
    lights: &[LightSample],
    pixel_width: f64,
    [x, y]: [f64; 2],
    hit: impl Fn([f64; 2]) -> Option<Hit>,
    out: &mut RowSamples,
) {
    for light in lights {
        let [dx, dy] = light.pixel_offset;
        let Some(hit) = hit([x + dx * pixel_width, y + dy * pixel_width]) else {
            continue;
        };
        let wi = to_local(&hit.frame, light.direction);
        let wo = to_local(&hit.frame, hit.to_viewer);
        push(out, wi, wo, light.irradiance * wi[2]);
    }
}

/// What a camera ray meets of an object turned about the viewing axis: what the ray through the point turned
/// back meets of the object as it is.
fn in_picture(turn: Turn, xy: [f64; 2], hit: impl Fn([f64; 2]) -> Option<Hit>) -> Option<Hit> {
    let lifted = [0.0; 3];
    Some(turned_in_picture(turn, xy, |xy| Some(LitHit { hit: hit(xy)?, lifted }))?.hit)
}

/// The same for a body that casts shadows on itself.
fn turned_in_picture(turn: Turn, [x, y]: [f64; 2], hit: impl Fn([f64; 2]) -> Option<LitHit>) -> Option<LitHit> {
    let [x, y, _] = turned([x, y, 0.0], back(turn));
    let LitHit { hit: Hit { frame, to_viewer }, lifted } = hit([x, y])?;
    let hit = Hit { frame: carried(&frame, turn), to_viewer: turned(to_viewer, turn) };
    Some(LitHit { hit, lifted: turned(lifted, turn) })
}

/// As [`gather_surface`], for a body that casts shadows on itself.
fn gather_body(
    lights: &[LightSample],
    pixel_width: f64,
    [x, y]: [f64; 2],
    hit: impl Fn([f64; 2]) -> Option<LitHit>,
    is_lit: impl Fn(Vec3, Vec3) -> bool,
    out: &mut RowSamples,
) {
    // Samples of a light often look through one point of the pixel: what they see is found once.
    let mut last: Option<([f64; 2], Option<LitHit>)> = None;
    for light in lights {
        let at = [x + light.pixel_offset[0] * pixel_width, y + light.pixel_offset[1] * pixel_width];
        let seen = match last {
            Some((before, seen)) if before == at => seen,
            _ => hit(at),
        };
        last = Some((at, seen));
        let Some(LitHit { hit, lifted }) = seen else {
            continue;
        };
        let wi = to_local(&hit.frame, light.direction);
        let wo = to_local(&hit.frame, hit.to_viewer);
        if wi[2] > 0.0 && wo[2] > 0.0 && is_lit(lifted, light.direction) {
            push(out, wi, wo, light.irradiance * wi[2]);
        }
    }
}

/// Runs the pixel function over the rows in parallel and joins the results in order.
fn gather(
    scene: &Scene,
    rows: &[usize],
    columns: &[usize],
    pixel: impl Fn([f64; 2], &mut RowSamples) + Sync,
) -> ShadingSamples {
    let gathered: Vec<RowSamples> = rows
        .par_iter()
        .map(|&row| {
            let mut out = RowSamples::default();
            for &column in columns {
                let before = out.weight.len();
                pixel(pixel_centre(scene, row, column), &mut out);
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
