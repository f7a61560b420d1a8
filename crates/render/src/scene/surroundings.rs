//! Samples of an environment at a point of a surface: some where the environment is bright, some where the surface shines.
//!
//! Half of the directions are drawn from the image, half around the mirror direction, and each counts by the balance
//! heuristic: as what both ways together would draw there (Veach and Guibas 1995). So neither a small bright window nor a
//! narrow lobe is missed. Around the mirror direction the density falls with the square of the distance in (u, v): every
//! scale, from the narrowest lobe to the whole hemisphere, gets about as many directions as the next, whatever the
//! specimen.
//!
//! Pixels take successive points of one even sequence in Morton's order, so that neighbours complement each other (Ahmed
//! and Wonka 2020): what is left of the error is fine grain, and the same in every renderer that is compared.

use std::f64::consts::TAU;

use diffraction_brdf::direction::Vec3;
use diffraction_build::ground::sampling::plane_far;

use super::environment::{Environment, direction_by_light, radiance, scalar_irradiance};
use super::frame::{to_local, to_world};
use super::hit::Hit;

/// Distance in (u, v) within which the density around the mirror direction is level: less than the deviation of a lobe
/// through a coherence window of 16 µm.
const LEVEL: f64 = 3e-3;
/// Largest distance in (u, v).
const REACH: f64 = 2.0;

/// Position of a pixel along the curve that visits blocks of 2 x 2, 4 x 4, ... pixels one after the other.
pub(crate) fn morton(row: usize, column: usize) -> u64 {
    let spread = |n: usize| (0..32).fold(0u64, |sum, bit| sum | ((n as u64 >> bit & 1) << (2 * bit)));
    spread(row) << 1 | spread(column)
}

/// Sample `index` of `count` for the pixel at `place` along the curve: the direction to the light in the world, and the
/// irradiance from there on a surface that faces it. `None` where nothing comes from there.
pub(crate) fn sample(
    environment: &Environment,
    hit: &Hit,
    place: u64,
    index: usize,
    count: usize,
) -> Option<(Vec3, f64)> {
    let of_lobe = count / 2;
    let of_light = count - of_lobe;
    let wo = to_local(&hit.frame, hit.to_viewer);
    let point = |counted: usize| plane_far(place * counted as u64 + index as u64 / 2);
    let direction = if index.is_multiple_of(2) {
        direction_by_light(environment, point(of_light))
    } else {
        to_world(&hit.frame, around_mirror(wo, point(of_lobe))?)
    };
    let radiance = radiance(environment, direction);
    let by_light = radiance / scalar_irradiance(environment);
    let by_lobe = density_around_mirror(to_local(&hit.frame, direction), wo);
    let irradiance = radiance / (of_light as f64 * by_light + of_lobe as f64 * by_lobe);
    (radiance > 0.0).then_some((direction, irradiance))
}

/// The direction that belongs to a point of the unit square; `None` where that lies beyond the horizon.
fn around_mirror(wo: Vec3, [a, b]: [f64; 2]) -> Option<Vec3> {
    let ratio = 1.0 + (REACH / LEVEL).powi(2);
    let distance = LEVEL * (ratio.powf(a) - 1.0).sqrt();
    let (sin, cos) = (TAU * b).sin_cos();
    let [x, y] = [distance * cos - wo[0], distance * sin - wo[1]];
    let z_squared = 1.0 - x * x - y * y;
    (z_squared > 0.0).then(|| [x, y, z_squared.sqrt()])
}

/// Density of such directions per solid angle: that in (u, v), where a solid angle is foreshortened by the cosine.
fn density_around_mirror(wi: Vec3, wo: Vec3) -> f64 {
    let squared = (wi[0] + wo[0]).powi(2) + (wi[1] + wo[1]).powi(2);
    let whole = 0.5 * TAU * (1.0 + (REACH / LEVEL).powi(2)).ln();
    wi[2].max(0.0) / (whole * (squared + LEVEL * LEVEL))
}

#[cfg(test)]
mod tests {
    use super::*;
    use diffraction_brdf::direction::from_angles_deg;
    use diffraction_build::ground::sampling::plane;

    #[test]
    fn the_density_is_that_of_the_directions() {
        let wo = from_angles_deg(40.0, 70.0);
        let count = 40_000;
        let directions: Vec<Vec3> = (0..count).filter_map(|index| around_mirror(wo, plane(index))).collect();
        assert!(directions.iter().all(|&[x, y, z]| (x * x + y * y + z * z - 1.0).abs() < 1e-12));
        // A sum over the directions of g / density is the integral of g: the hemisphere's projected area, and a narrow lobe's.
        for width in [0.02f64, 1e9] {
            let lobe = |wi: Vec3| (-((wi[0] + wo[0]).powi(2) + (wi[1] + wo[1]).powi(2)) / (width * width)).exp();
            let mean: f64 = directions.iter().map(|&wi| wi[2] * lobe(wi) / density_around_mirror(wi, wo)).sum::<f64>()
                / count as f64;
            let expected = if width > 1.0 { 0.5 * TAU } else { 0.5 * TAU * width * width };
            // An even set's error, 2 ln(n) / n times a variation of some tens.
            assert!((mean / expected - 1.0).abs() < 0.01, "{width}: {mean} for {expected}");
        }
    }

    #[test]
    fn blocks_of_pixels_are_neighbours_on_the_curve() {
        for block in 0..16u64 {
            let at =
                |row: usize, column: usize| morton(2 * (block / 4) as usize + row, 2 * (block % 4) as usize + column);
            assert_eq!([at(0, 0), at(0, 1), at(1, 0), at(1, 1)].map(|m| m - at(0, 0)), [0, 1, 2, 3]);
        }
        assert_eq!(morton(3, 5), 0b011011);
    }
}
