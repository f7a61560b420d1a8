//! What a scene's pictures look up: directions pixel by pixel, for tables that are restricted to them.

use std::ops::Range;

use super::animation;
use super::model::{Exposure, Light, Scene, Shape};
use super::samples::{ShadingSamples, pixel_range, samples_of, samples_per_pixel};
use diffraction_brdf::direction::normalised_abs_w;
use diffraction_brdf::direction::{dot, wave_vector_change};
use diffraction_brdf::error::Result;
use diffraction_build::tables::coverage::find::LookUps;
use diffraction_build::tables::coverage::ranges::Directions;

/// Texels by which the directions of neighbouring pixels may lie apart and still belong to one piece of surface: what
/// lies between them is then looked up too. Farther apart they are on two sides of an edge.
const JUMP_TEXELS: f64 = 16.0;

/// Positions within each pixel that are looked at, if the picture has fewer.
const PIXEL_SAMPLES: usize = 16;

/// Share of what `|q|²` ranges over, by which a pixel's range is widened at both ends: sixteen points evenly over a
/// light's disc leave its rim, and a thirty-second of its radius before it, to other renderers.
const MARGIN_Q_SQUARED: f64 = 1.0 / 16.0;

/// Samples gathered at a time.
const BAND_SAMPLES: usize = 1 << 18;

/// Whatever the pictures of a scene look up, light by light.
///
/// Directions are those of the very samples that a picture is made of. To hold for other renderers too, which put
/// their samples elsewhere within the same pixels and lights, more samples are spread over each pixel, and everything
/// between a pixel's samples of one light and between those of neighbouring pixels counts as looked up.
pub struct SceneLookUps<'a> {
    scene: &'a Scene,
    /// Bands of rows of the still and of each frame, under one light each.
    parts: Vec<(Lit, Range<usize>)>,
}

/// What a part shows.
#[derive(Clone, Copy)]
struct Lit {
    /// The frame of the animation; `None` for the still.
    frame: Option<usize>,
    /// The light; `None` for what comes from all around.
    light: Option<usize>,
    /// Whether more samples are spread over each pixel than the picture has.
    is_dense: bool,
}

impl<'a> SceneLookUps<'a> {
    /// Of the still and all frames.
    pub fn new(scene: &'a Scene) -> Self {
        let frames = scene.animation.iter().flat_map(|animation| (0..animation.frames).map(Some));
        let lights = match scene.shape {
            Shape::Hemisphere | Shape::Screen { .. } => 1,
            _ => scene.lights.len().max(1),
        };
        let around = scene.environment.is_some();
        // Without any light a screen has its beam, and an environment lights alone.
        let lights = (0..lights).filter(|&light| light < scene.lights.len() || !around).map(Some);
        let lights: Vec<Option<usize>> = lights.chain(around.then_some(None)).collect();
        let densities: &[bool] = if scene.pixel_samples < PIXEL_SAMPLES { &[false, true] } else { &[false] };
        let mut parts = Vec::new();
        for frame in [None].into_iter().chain(frames) {
            for &light in &lights {
                for &is_dense in densities {
                    let lit = Lit { frame, light, is_dense };
                    parts.extend(bands(&lit.scene(scene)).into_iter().map(|rows| (lit, rows)));
                }
            }
        }
        Self { scene, parts }
    }
}

impl LookUps for SceneLookUps<'_> {
    fn name(&self) -> &str {
        &self.scene.name
    }

    fn is_exposed_by_content(&self) -> bool {
        self.scene.exposure == Exposure::Auto
    }

    fn parts(&self) -> usize {
        self.parts.len()
    }

    fn visit(&self, part: usize, texel: f64, mark: &mut dyn FnMut(&Directions)) -> Result<()> {
        let (lit, rows) = &self.parts[part];
        let samples = samples_of(&lit.scene(self.scene), rows.clone(), 1)?;
        visit_pixels(&samples, JUMP_TEXELS * texel, mark);
        Ok(())
    }
}

impl Lit {
    /// The part of a scene that it is.
    fn scene(self, whole: &Scene) -> Scene {
        let still = match (self.frame, &whole.animation) {
            (Some(index), Some(animation)) => animation::frame(whole, animation, index),
            _ => whole.clone(),
        };
        let lights: Vec<Light> = self.light.and_then(|light| still.lights.get(light)).copied().into_iter().collect();
        Scene {
            lights,
            // Light from all around: everything between its directions is lit as well.
            environment: still.environment.filter(|_| self.light.is_none()),
            pixel_samples: if self.is_dense { PIXEL_SAMPLES } else { still.pixel_samples },
            ..still
        }
    }
}

/// Rows of a picture whose samples are gathered at a time.
fn bands(scene: &Scene) -> Vec<Range<usize>> {
    let side = scene.size_px;
    let band = (BAND_SAMPLES / (samples_per_pixel(scene) * side).max(1)).clamp(1, side.max(1));
    // One row more, so that the last row has a neighbour. A picture without rows has one part, which is refused.
    (0..side.max(1)).step_by(band).map(|start| start..(start + band + 1).min(side)).collect()
}

/// Calls `mark` with the directions of every pixel, and of all between it and its neighbours but those that lie farther
/// away than `jump` in (u, v).
fn visit_pixels(samples: &ShadingSamples, jump: f64, mark: &mut dyn FnMut(&Directions)) {
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
            mark(&directions);
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
