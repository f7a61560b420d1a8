//! A sphere seen from afar.

use super::frame::on_globe;
use super::hit::Hit;

/// The sphere's radius as a share of half the picture's side.
pub const RADIUS: f64 = 0.95;

/// Where the parallel camera ray (against world z) through picture point `(x, y)` meets the sphere.
///
/// The structure's x axis follows the circles of latitude eastwards and its y axis points to the
/// pole at world +y, so both lie along the picture's axes in the middle of the disc.
pub(crate) fn hit([x, y]: [f64; 2]) -> Option<Hit> {
    let (x, y) = (x / RADIUS, y / RADIUS);
    let z_squared = 1.0 - x * x - y * y;
    if z_squared <= 0.0 {
        return None;
    }
    Some(Hit { frame: on_globe([x, y, z_squared.sqrt()]), to_viewer: [0.0, 0.0, 1.0] })
}

#[cfg(test)]
mod tests {
    use super::*;
    use diffraction_brdf::direction::from_angles_deg;

    #[test]
    fn the_structure_follows_latitude_and_longitude() {
        for (longitude_deg, latitude_deg) in [(0.0, 50.0), (40.0, 30.0), (-75.0, -60.0)] {
            let (sin_b, cos_b) = f64::to_radians(latitude_deg).sin_cos();
            let (sin_l, cos_l) = f64::to_radians(longitude_deg).sin_cos();
            let at = hit([RADIUS * cos_b * sin_l, RADIUS * sin_b]).unwrap();
            let expected = [
                (at.frame.normal, [cos_b * sin_l, sin_b, cos_b * cos_l]),
                (at.frame.tangent, [cos_l, 0.0, -sin_l]),
                (at.frame.bitangent, [-sin_b * sin_l, cos_b, -sin_b * cos_l]),
            ];
            for (axis, expected) in expected {
                for (a, e) in axis.iter().zip(expected) {
                    assert!((a - e).abs() < 1e-12, "at {longitude_deg}, {latitude_deg}");
                }
            }
        }
    }

    #[test]
    fn rays_beside_the_sphere_miss() {
        let [x, y, _] = from_angles_deg(90.0, 33.0).map(|c| c * RADIUS);
        assert!(hit([0.9999 * x, 0.9999 * y]).is_some());
        assert!(hit([1.0001 * x, 1.0001 * y]).is_none());
    }
}
