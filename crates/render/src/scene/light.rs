//! Light samples: points of disc-shaped lights and of a pixel, the same for every pixel.
//!
//! Every pixel uses one fixed, evenly spread set, so pictures have no noise and renderers that
//! are compared integrate over the same directions. A lobe narrower than the spacing of the
//! points shows as separate images of itself: raise `light_samples` then.

use std::f64::consts::TAU;

use diffraction_brdf::direction::{Vec3, normalise};

use super::frame::{about, to_world};
use super::model::{Light, Scene, Shape};

/// One sample of a light together with the position within the pixel it is used for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightSample {
    /// Unit vector to the light in the world.
    pub direction: Vec3,
    /// This sample's share of the light's irradiance on a surface that faces the sample; over all
    /// samples of a light, `Σ irradiance (direction · axis)` is the light's irradiance.
    pub irradiance: f64,
    /// Position in the pixel, each coordinate in [-0.5, 0.5); x right, y up.
    pub pixel_offset: [f64; 2],
}

/// `1 / ρ^n` for the root `ρ` of `ρ⁵ = ρ + 1`: steps of an additive recurrence that fills four
/// dimensions evenly (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences").
const RECURRENCE: [f64; 4] =
    [0.856_674_883_854_502_9, 0.733_891_856_627_126, 0.628_706_721_037_808_6, 0.538_597_257_223_610_1];

/// Golden angle in turns.
const GOLDEN: f64 = 0.381_966_011_250_105;

/// A point of [0, 1)⁴; index 0 is the middle.
pub(crate) fn sequence_point(index: usize) -> [f64; 4] {
    RECURRENCE.map(|step| (0.5 + step * index as f64).fract())
}

/// Point `index` of `count` spread over the unit disc on Vogel's sunflower spiral: radius squared
/// and angle. A single one is the centre.
pub fn sunflower(index: usize, count: usize) -> [f64; 2] {
    if count <= 1 {
        return [0.0, 0.0];
    }
    let radius_squared = (index as f64 + 0.5) / count as f64;
    [radius_squared, TAU * (GOLDEN * index as f64).fract()]
}

/// Centres of `count` parts of the unit disc, each of which stands for a disc of the area that is its share. The parts have the disc's centre and
/// variance together: points of the spiral, moved to their mean, drawn in by what the parts' own size adds, and made round.
pub(crate) fn disc_parts(count: usize) -> Vec<[f64; 2]> {
    let mut parts: Vec<[f64; 2]> = (0..count).map(|index| disc_xy(sunflower(index, count))).collect();
    // Fewer lie on a line, or are all there is.
    if count < 3 {
        return parts;
    }
    let n = count as f64;
    let mean: [f64; 2] = [0, 1].map(|k| parts.iter().map(|part| part[k]).sum::<f64>() / n);
    parts.iter_mut().for_each(|part| *part = [part[0] - mean[0], part[1] - mean[1]]);
    let moment = |j: usize, k: usize| parts.iter().map(|part| part[j] * part[k]).sum::<f64>() / n;
    let [xx, xy, yy] = [moment(0, 0), moment(0, 1), moment(1, 1)];
    // A disc's variance along an axis is a quarter of its radius squared. The inverse root of a symmetric matrix M with the determinant d²:
    // (adj M + d) / (d sqrt(tr M + 2 d)).
    let d = (xx * yy - xy * xy).sqrt();
    let scale = (0.25 * (1.0 - 1.0 / n)).sqrt() / (d * (xx + yy + 2.0 * d).sqrt());
    let rounded = |[x, y]: [f64; 2]| [scale * ((yy + d) * x - xy * y), scale * ((xx + d) * y - xy * x)];
    parts.into_iter().map(rounded).collect()
}

/// Radius squared and angle of a point of the disc.
pub(crate) fn polar([x, y]: [f64; 2]) -> [f64; 2] {
    [x * x + y * y, y.atan2(x)]
}

/// Cartesian coordinates of a disc point given by radius squared and angle.
pub(crate) fn disc_xy([radius_squared, angle]: [f64; 2]) -> [f64; 2] {
    let radius = radius_squared.sqrt();
    [radius * angle.cos(), radius * angle.sin()]
}

/// Position within the pixel of a sample: the centre where one position suffices.
pub(crate) fn pixel_offset(scene: &Scene, index: usize) -> [f64; 2] {
    if scene.pixel_samples <= 1 {
        return [0.0, 0.0];
    }
    let [x, y, ..] = sequence_point(index);
    [x - 0.5, y - 0.5]
}

/// Number of samples of a light.
pub fn sample_count(scene: &Scene, light: &Light) -> usize {
    if light.angular_diameter_deg > 0.0 { scene.light_samples.max(scene.pixel_samples) } else { scene.pixel_samples }
}

/// The direction to a point of a light, given by radius squared and angle on the unit disc: equal
/// areas of the disc are equal solid angles.
pub fn direction_to(light: &Light, [radius_squared, angle]: [f64; 2]) -> Vec3 {
    let half_angle = (0.5 * light.angular_diameter_deg).to_radians();
    // 1 - cos written without cancellation.
    let versine = radius_squared * 2.0 * (0.5 * half_angle).sin().powi(2);
    let sine = (versine * (2.0 - versine)).sqrt();
    let local = [sine * angle.cos(), sine * angle.sin(), 1.0 - versine];
    to_world(&about(normalise(light.direction)), local)
}

/// Samples of every light of a scene, light after light; for a hemisphere of the first one only. Those of an environment
/// differ from pixel to pixel: see `surroundings`.
pub(crate) fn light_samples(scene: &Scene) -> Vec<LightSample> {
    let used = match scene.shape {
        Shape::Hemisphere => 1,
        _ => scene.lights.len(),
    };
    scene.lights.iter().take(used).flat_map(|light| samples_of(scene, light)).collect()
}

/// Number of samples of the environment in each pixel.
pub fn environment_count(scene: &Scene) -> usize {
    if scene.environment.is_some() { scene.light_samples.max(scene.pixel_samples) } else { 0 }
}

fn samples_of(scene: &Scene, light: &Light) -> Vec<LightSample> {
    let count = sample_count(scene, light);
    let axis = normalise(light.direction);
    let mut samples: Vec<LightSample> = (0..count)
        .map(|index| LightSample {
            direction: direction_to(light, sunflower(index, count)),
            irradiance: light.irradiance,
            pixel_offset: pixel_offset(scene, index),
        })
        .collect();
    let facing: f64 = samples.iter().map(|sample| diffraction_brdf::direction::dot(sample.direction, axis)).sum();
    for sample in &mut samples {
        sample.irradiance /= facing;
    }
    samples
}

#[cfg(test)]
mod tests {
    use super::*;
    use diffraction_brdf::direction::dot;

    fn scene(diameter_deg: f64, light_samples: usize, pixel_samples: usize) -> Scene {
        let light = Light { direction: [0.6, -1.0, 2.0], angular_diameter_deg: diameter_deg, irradiance: 3.0 };
        Scene { light_samples, pixel_samples, ..Scene::still("light", Shape::Sphere, vec![light], 4) }
    }

    #[test]
    fn recurrence_steps_belong_to_the_root() {
        let root = 1.0 / RECURRENCE[0];
        assert!((root.powi(5) - root - 1.0).abs() < 1e-13);
        for (power, step) in RECURRENCE.iter().enumerate() {
            assert!((root.powi(-(power as i32) - 1) - step).abs() < 1e-14);
        }
    }

    #[test]
    fn parts_of_a_disc_have_its_centre_and_variance() {
        for count in [3, 4, 7, 16, 64] {
            let parts = disc_parts(count);
            let n = count as f64;
            let sum = |of: &dyn Fn([f64; 2]) -> f64| parts.iter().map(|part| of(*part)).sum::<f64>() / n;
            let own = 0.25 / n;
            for (found, expected) in [
                (sum(&|[x, _]| x), 0.0),
                (sum(&|[_, y]| y), 0.0),
                (sum(&|[x, y]| x * y), 0.0),
                (sum(&|[x, _]| x * x) + own, 0.25),
                (sum(&|[_, y]| y * y) + own, 0.25),
            ] {
                assert!((found - expected).abs() < 1e-14, "{count}: {found} for {expected}");
            }
            assert!(parts.iter().all(|[x, y]| x.hypot(*y) < 1.0));
        }
    }

    #[test]
    fn a_point_light_has_one_sample_at_its_centre() {
        let scene = scene(0.0, 64, 1);
        let samples = light_samples(&scene);
        let axis = normalise(scene.lights[0].direction);
        assert_eq!(samples.len(), 1);
        assert!((dot(samples[0].direction, axis) - 1.0).abs() < 1e-15);
        assert!((samples[0].irradiance - 3.0).abs() < 1e-14);
        assert_eq!(samples[0].pixel_offset, [0.0, 0.0]);
    }

    #[test]
    fn a_disc_fills_its_cone_and_keeps_the_irradiance() {
        let scene = scene(20.0, 500, 1);
        let axis = normalise(scene.lights[0].direction);
        let samples = light_samples(&scene);
        let cosines: Vec<f64> = samples.iter().map(|s| dot(s.direction, axis)).collect();
        let rim = 10f64.to_radians().cos();
        assert!(cosines.iter().all(|&c| c >= rim - 1e-15));
        // The outermost of n points covers the area up to 1 - 1/(2n).
        let outermost = cosines.iter().copied().fold(1.0, f64::min);
        assert!(((1.0 - outermost) / (1.0 - rim) - 0.999).abs() < 1e-12);
        let facing: f64 = samples.iter().zip(&cosines).map(|(s, c)| s.irradiance * c).sum();
        assert!((facing - 3.0).abs() < 1e-12);
    }

    /// Mean of `cos² + cos⁴` over the cone against its integral.
    #[test]
    fn cone_averages_match_the_integral() {
        let scene = scene(60.0, 4000, 1);
        let axis = normalise(scene.lights[0].direction);
        let samples = light_samples(&scene);
        let mean =
            |f: fn(f64) -> f64| samples.iter().map(|s| f(dot(s.direction, axis))).sum::<f64>() / samples.len() as f64;
        // Midpoint rule in the solid angle: error about 1 / (24 n²).
        let rim = 30f64.to_radians().cos();
        let expected = (1.0 - rim.powi(3)) / (3.0 * (1.0 - rim));
        assert!((mean(|c| c * c) - expected).abs() < 1e-8);
        // Sideways the spiral balances itself to about 1 / n.
        let side: f64 = samples.iter().map(|s| s.direction[0]).sum::<f64>() / 4000.0;
        assert!((side - axis[0] * (1.0 + rim) / 2.0).abs() < 1e-3);
    }

    #[test]
    fn pixel_offsets_fill_the_pixel_evenly() {
        let scene = scene(0.0, 1, 256);
        let samples = light_samples(&scene);
        assert_eq!(samples.len(), 256);
        // An even set leaves each of 16 cells within a few points of its share of 16.
        let mut cells = [0usize; 16];
        for sample in &samples {
            let [x, y] = sample.pixel_offset.map(|c| ((c + 0.5) * 4.0) as usize);
            cells[4 * y + x] += 1;
        }
        assert!(cells.iter().all(|&n| (12..=20).contains(&n)), "{cells:?}");
    }
}
