//! The screen set-up: light diffracted by a flat sample falls back on the screen it came through.
//!
//! World: the sample's centre is the origin, the beam comes along -z through the middle of the screen,
//! the plane `z = distance`. The picture shows the screen as seen along the beam (from the
//! source), x to the right and y up.
//!
//! With the radiance `f E cos_i` that a sample point `p` sends to the screen point `s`, at
//! `r = |s - p|`, the irradiance on the screen is
//!
//! ```text
//! E_s = ∫_spot f E cos_i cos_o cos_s / r² dA,    cos_s = (distance - p_z) / r.
//! ```
//!
//! The spot is sampled by points spread evenly over the beam's cross-section, of area `A`; the
//! tilted sample holds `dA = dA_beam / cos(incidence)`. Unit: that of the light's irradiance.

use std::f64::consts::{PI, TAU};

use diffraction_brdf::direction::{Vec3, dot};

use super::frame::{Frame, to_local};
use super::light::{direction_to, disc_parts, disc_xy, pixel_offset, sequence_point, sunflower};
use super::model::{Light, Scene, Shape};
use super::row::{RowSamples, push};

/// One ray of the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
struct BeamSample {
    /// Where it meets the sample, in the world.
    point_mm: Vec3,
    /// Unit vector against the ray, local.
    wi: Vec3,
    pixel_offset: [f64; 2],
    /// `E cos_i dA` in mm².
    power_mm2: f64,
}

/// The set-up, ready for gathering pixels.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ScreenSetup {
    sample: Frame,
    distance_mm: f64,
    half_width_mm: f64,
    hole_radius_mm: f64,
    beam: Vec<BeamSample>,
}

/// Number of samples per pixel.
pub fn sample_count(scene: &Scene) -> usize {
    scene.light_samples.max(scene.pixel_samples)
}

/// The beam's rays and the geometry.
///
/// # Panics
/// On another shape.
pub(crate) fn setup(scene: &Scene) -> ScreenSetup {
    let Shape::Screen { distance_mm, width_mm, beam_diameter_mm, hole_diameter_mm, incidence_deg } = scene.shape else {
        panic!("a screen set-up needs a screen, not {:?}", scene.shape);
    };
    let (sin, cos) = incidence_deg.to_radians().sin_cos();
    let sample = Frame { tangent: [cos, 0.0, -sin], bitangent: [0.0, 1.0, 0.0], normal: [sin, 0.0, cos] };
    ScreenSetup {
        sample,
        distance_mm,
        half_width_mm: 0.5 * width_mm,
        hole_radius_mm: 0.5 * hole_diameter_mm.unwrap_or(beam_diameter_mm),
        beam: beam_samples(scene, &sample, 0.5 * beam_diameter_mm),
    }
}

fn beam_samples(scene: &Scene, sample: &Frame, radius_mm: f64) -> Vec<BeamSample> {
    let count = sample_count(scene);
    let first = scene.lights.first();
    let light = Light {
        direction: [0.0, 0.0, 1.0],
        angular_diameter_deg: first.map_or(0.0, |light| light.angular_diameter_deg),
        irradiance: first.map_or(1.0, |light| light.irradiance),
    };
    let area_mm2 = PI * radius_mm * radius_mm / count as f64 / sample.normal[2];
    (0..count)
        .map(|index| {
            let [x, y] = disc_xy(sunflower(index, count)).map(|c| c * radius_mm);
            // The divergence has its own dimensions, independent of the position in the beam.
            let [_, _, radius_squared, turn] = sequence_point(index);
            let wi = to_local(sample, direction_to(&light, [radius_squared, TAU * turn]));
            BeamSample {
                point_mm: [x, y, -x * sample.normal[0] / sample.normal[2]],
                wi,
                pixel_offset: pixel_offset(scene, index),
                power_mm2: light.irradiance * wi[2] * area_mm2,
            }
        })
        .collect()
}

/// Samples of the screen point at picture point `(x, y)`; none in the hole.
pub(crate) fn gather_pixel(setup: &ScreenSetup, pixel_width: f64, [x, y]: [f64; 2], out: &mut RowSamples) {
    for ray in &setup.beam {
        let [dx, dy] = ray.pixel_offset;
        if let Some((wo, geometry)) = setup.seen([x + dx * pixel_width, y + dy * pixel_width], ray.point_mm) {
            push(out, ray.wi, wo, ray.power_mm2 * geometry);
        }
    }
}

impl ScreenSetup {
    /// Local direction from a point of the sample to a picture point, and `cos_o cos_s / r²` in 1/mm²; `None` in the hole.
    fn seen(&self, at: [f64; 2], point_mm: Vec3) -> Option<(Vec3, f64)> {
        let [x_mm, y_mm] = at.map(|c| c * self.half_width_mm);
        if x_mm.hypot(y_mm) < self.hole_radius_mm {
            return None;
        }
        let path = [x_mm - point_mm[0], y_mm - point_mm[1], self.distance_mm - point_mm[2]];
        let r_squared = dot(path, path);
        let to_screen = path.map(|c| c / r_squared.sqrt());
        let wo = to_local(&self.sample, to_screen);
        // cos_s is the z component: the screen faces -z.
        Some((wo, wo[2] * to_screen[2] / r_squared))
    }
}

/// A part of the beam that one look-up stands for.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BeamPiece {
    ray: BeamSample,
    /// Radius of its cross-section.
    radius_mm: f64,
    /// Angular radius of the directions that it brings.
    pub divergence: f64,
}

/// Divergence in degrees up to which each piece of a beam brings all its directions: measured to err less than sixteen pieces that share
/// them out (docs/accuracy.md, "Lights with a size").
const WHOLE_DIVERGENCE_MAX_DEG: f64 = 10.0;

/// The beam as one piece where its spot, as seen from the screen's middle, is no wider than `diameter_max_deg`; else, and where its directions
/// are shared out, as `light_samples` even ones.
pub(crate) fn beam_pieces(scene: &Scene, setup: &ScreenSetup, diameter_max_deg: f64) -> Vec<BeamPiece> {
    let Shape::Screen { distance_mm, beam_diameter_mm, .. } = scene.shape else { return Vec::new() };
    let diverging_deg = scene.lights.first().map_or(0.0, |light| light.angular_diameter_deg);
    let is_narrow = (beam_diameter_mm / distance_mm).to_degrees() <= diameter_max_deg;
    let is_shared = diverging_deg > WHOLE_DIVERGENCE_MAX_DEG;
    let count = if is_narrow && !is_shared { 1 } else { scene.light_samples };
    let share = |diameter: f64| 0.5 * diameter / (count as f64).sqrt();
    let divergence = if is_shared { share(diverging_deg.to_radians()) } else { 0.5 * diverging_deg.to_radians() };
    let axis = to_local(&setup.sample, [0.0, 0.0, 1.0]);
    let of = Scene { light_samples: count, pixel_samples: 1, ..scene.clone() };
    let rays = beam_samples(&of, &setup.sample, 0.5 * beam_diameter_mm);
    let tilt = setup.sample.normal[0] / setup.sample.normal[2];
    let pieces = rays.into_iter().zip(disc_parts(count)).map(|(ray, part)| {
        let [x, y] = part.map(|c| 0.5 * c * beam_diameter_mm);
        let ray = BeamSample { point_mm: [x, y, -x * tilt], ..ray };
        let straight = BeamSample { wi: axis, power_mm2: ray.power_mm2 / ray.wi[2] * axis[2], ..ray };
        BeamPiece { ray: if is_shared { ray } else { straight }, radius_mm: share(beam_diameter_mm), divergence }
    });
    pieces.collect()
}

/// Directions, weight and the covariance `[uu, uv, vv]` of (u, v) over a piece's spot and a pixel's square, at picture point `(x, y)`.
pub(crate) fn seen_of_piece(
    setup: &ScreenSetup,
    piece: &BeamPiece,
    pixel_width: f64,
    [x, y]: [f64; 2],
) -> Option<(Vec3, Vec3, f64, [f64; 3])> {
    let ray = &piece.ray;
    let (wo, geometry) = setup.seen([x, y], ray.point_mm)?;
    // Of first order: half the difference between two places that lie a standard deviation to either side.
    let on_screen = pixel_width / 12f64.sqrt();
    let by_pixel = [[on_screen, 0.0], [0.0, on_screen]].map(|[dx, dy]| {
        let ends = [1.0, -1.0].map(|side| setup.seen([x + side * dx, y + side * dy], ray.point_mm));
        half_apart(ends)
    });
    let in_beam = 0.5 * piece.radius_mm;
    let tilt = setup.sample.normal[0] / setup.sample.normal[2];
    let by_spot = [[in_beam, 0.0, -in_beam * tilt], [0.0, in_beam, 0.0]].map(|step| {
        let ends =
            [1.0, -1.0].map(|side| setup.seen([x, y], std::array::from_fn(|k| ray.point_mm[k] + side * step[k])));
        half_apart(ends)
    });
    let changes = [by_pixel, by_spot].concat();
    let sum = |of: fn(&[f64; 2]) -> f64| changes.iter().map(of).sum();
    let covariance = [sum(|c| c[0] * c[0]), sum(|c| c[0] * c[1]), sum(|c| c[1] * c[1])];
    Some((ray.wi, wo, ray.power_mm2 * geometry, covariance))
}

/// Half the lateral difference of two directions; none at the rim of the hole.
fn half_apart(ends: [Option<(Vec3, f64)>; 2]) -> [f64; 2] {
    match ends {
        [Some((a, _)), Some((b, _))] => [0, 1].map(|k| 0.5 * (a[k] - b[k])),
        _ => [0.0; 2],
    }
}
