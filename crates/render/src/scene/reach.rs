//! What of (u, v, w) a scene's picture reaches: the texels and depths that its tables must hold.

use rayon::prelude::*;

use super::animation;
use super::model::{Light, Scene, Shape};
use super::samples::{ShadingSamples, pixel_range, samples_of, samples_per_pixel};
use diffraction_brdf::direction::normalised_abs_w;
use diffraction_brdf::direction::{dot, wave_vector_change};
use diffraction_brdf::error::Result;
use diffraction_build::tables::domain::{Directions, Domain};
use diffraction_build::tables::plan::Grid;

/// Texels by which the directions of neighbouring pixels may lie apart and still belong to one piece of surface: what
/// lies between them is then reached too. Farther apart they are on two sides of an edge.
const JUMP_TEXELS: f64 = 16.0;

/// Positions within each pixel that are looked at, if the picture has fewer.
const PIXEL_SAMPLES: usize = 16;

/// Texels beside everything seen that are reached as well.
const MARGIN_TEXELS: f64 = 1.0;

/// Share of what `|q|²` ranges over, by which a pixel's range is widened at both ends: sixteen points evenly over a
/// light's disc leave its rim, and a thirty-second of its radius before it, to other renderers.
const MARGIN_Q_SQUARED: f64 = 1.0 / 16.0;

/// Samples gathered at a time.
const BAND_SAMPLES: usize = 1 << 18;

/// Marks on a grid whatever a picture of the scene looks up, light by light.
///
/// Directions are those of the very samples that the picture is made of. To hold for other renderers too, which put
/// their samples elsewhere within the same pixels and lights, more samples are spread over each pixel, everything between
/// a pixel's samples of one light and between those of neighbouring pixels counts as reached, and so do the texels
/// around all that.
///
/// At most `parts` copies of the grid are filled at once.
///
/// # Errors
/// A scene that cannot be rendered.
pub fn reach(scene: &Scene, grid: Grid, parts: usize) -> Result<Domain> {
    let mut reached = reach_of_still(scene, grid, parts)?;
    if let Some(animation) = &scene.animation {
        for index in 0..animation.frames {
            reached = reached.merge(&reach_of_still(&animation::frame(scene, animation, index), grid, parts)?);
        }
    }
    Ok(reached)
}

fn reach_of_still(scene: &Scene, grid: Grid, parts: usize) -> Result<Domain> {
    let mut reached = Domain::new(grid);
    let lights = match scene.shape {
        Shape::Hemisphere | Shape::Screen { .. } => 1,
        _ => scene.lights.len().max(1),
    };
    for light in 0..lights {
        let lights: Vec<Light> = scene.lights.get(light).copied().into_iter().collect();
        if lights.is_empty() && scene.environment.is_some() {
            continue;
        }
        reached = reached.merge(&reach_of_light(&Scene { lights, environment: None, ..scene.clone() }, grid, parts)?);
    }
    if scene.environment.is_some() {
        // Light from all around: everything between its directions is lit as well.
        reached = reached.merge(&reach_of_light(&Scene { lights: Vec::new(), ..scene.clone() }, grid, parts)?);
    }
    Ok(reached)
}

fn reach_of_light(scene: &Scene, grid: Grid, parts: usize) -> Result<Domain> {
    let reached = reach_of_samples(scene, grid, parts)?;
    if scene.pixel_samples >= PIXEL_SAMPLES {
        return Ok(reached);
    }
    Ok(reached.merge(&reach_of_samples(&Scene { pixel_samples: PIXEL_SAMPLES, ..scene.clone() }, grid, parts)?))
}

fn reach_of_samples(scene: &Scene, grid: Grid, parts: usize) -> Result<Domain> {
    let side = scene.size_px;
    let band = (BAND_SAMPLES / (samples_per_pixel(scene) * side).max(1)).clamp(1, side);
    let starts: Vec<usize> = (0..side).step_by(band).collect();
    let of_part = |part: usize| {
        let mut domain = Domain::new(grid);
        // Bands in turn: what takes long in a picture lies together.
        for start in starts.iter().skip(part).step_by(parts) {
            // One row more, so that the last row has a neighbour.
            let samples = samples_of(scene, *start..(start + band + 1).min(side), 1)?;
            mark_pixels(&mut domain, &samples);
        }
        Ok(domain)
    };
    let marked = (0..parts.min(starts.len())).into_par_iter().map(of_part).collect::<Result<Vec<Domain>>>()?;
    Ok(marked.into_iter().reduce(|a, b| a.merge(&b)).unwrap_or_else(|| Domain::new(grid)))
}

fn mark_pixels(domain: &mut Domain, samples: &ShadingSamples) {
    let jump = JUMP_TEXELS * domain.grid.texel();
    let pixels = 0..samples.rows * samples.columns;
    let seen: Vec<Option<Directions>> = pixels.map(|pixel| pixel_directions(samples, pixel)).collect();
    for row in 0..samples.rows {
        for column in 0..samples.columns {
            let at = |r: usize, c: usize| {
                let there = r < samples.rows && c < samples.columns;
                there.then(|| seen[r * samples.columns + c]).flatten()
            };
            let block = [at(row, column), at(row, column + 1), at(row + 1, column), at(row + 1, column + 1)];
            let Some(own) = block[0] else { continue };
            let parts = || block.iter().flatten();
            let widest = parts().map(extent).fold(0.0, f64::max);
            let whole = parts().fold(own, |whole, part| whole.joined(part));
            let mut directions = if extent(&whole) <= widest + jump { whole } else { own };
            let [low, high] = directions.q_squared;
            let margin = MARGIN_Q_SQUARED * (high - low);
            directions.q_squared = [low - margin, high + margin];
            domain.mark(&directions, MARGIN_TEXELS);
        }
    }
}

fn pixel_directions(samples: &ShadingSamples, pixel: usize) -> Option<Directions> {
    let range = pixel_range(samples, pixel / samples.columns, pixel % samples.columns);
    range
        .map(|index| {
            let [wi, wo] = [samples.wi[index], samples.wo[index]].map(|d| d.map(f64::from));
            let q = wave_vector_change(wi, wo);
            Directions { u: [q[0]; 2], v: [q[1]; 2], t: [normalised_abs_w(q); 2], q_squared: [dot(q, q); 2] }
        })
        .reduce(|a, b| a.joined(&b))
}

/// Larger side in (u, v).
fn extent(directions: &Directions) -> f64 {
    let Directions { u, v, .. } = directions;
    (u[1] - u[0]).max(v[1] - v[0])
}
