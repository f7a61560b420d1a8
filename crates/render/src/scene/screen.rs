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
use super::light::{direction_to, disc_xy, pixel_offset, sequence_point, sunflower};
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
        let x_mm = (x + dx * pixel_width) * setup.half_width_mm;
        let y_mm = (y + dy * pixel_width) * setup.half_width_mm;
        if x_mm.hypot(y_mm) < setup.hole_radius_mm {
            continue;
        }
        let path = [x_mm - ray.point_mm[0], y_mm - ray.point_mm[1], setup.distance_mm - ray.point_mm[2]];
        let r_squared = dot(path, path);
        let to_screen = path.map(|c| c / r_squared.sqrt());
        let wo = to_local(&setup.sample, to_screen);
        // cos_s is the z component: the screen faces -z.
        push(out, ray.wi, wo, ray.power_mm2 * wo[2] * to_screen[2] / r_squared);
    }
}
