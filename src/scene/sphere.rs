//! A sphere seen from afar.

use super::frame::on_globe;
use super::samples::Hit;

/// The sphere's radius as a share of half the picture's side.
pub const RADIUS: f64 = 0.95;

/// Where the parallel camera ray (against world z) through picture point `(x, y)` meets the sphere.
///
/// The structure's x axis follows the circles of latitude eastwards and its y axis points to the
/// pole at world +y, so both lie along the picture's axes in the middle of the disc.
pub fn hit([x, y]: [f64; 2]) -> Option<Hit> {
    let (x, y) = (x / RADIUS, y / RADIUS);
    let z_squared = 1.0 - x * x - y * y;
    if z_squared <= 0.0 {
        return None;
    }
    Some(Hit {
        frame: on_globe([x, y, z_squared.sqrt()]),
        to_viewer: [0.0, 0.0, 1.0],
    })
}
