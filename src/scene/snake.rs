//! A snake's body: a round tube of constant thickness along a meander, seen from above.

use std::f64::consts::PI;

use crate::ground::direction::{Vec3, dot, normalise};

use super::frame::{Frame, about, add_scaled, cross};
use super::samples::Hit;

/// Half circles that the body's centre line is made of, bending up and down in turn.
const BENDS: usize = 3;
/// Radius of the bends, with the picture's half side as unit.
pub const BEND_RADIUS: f64 = 0.26;
/// Radius of the body; less than the bends', so that the inner side stays smooth.
pub const BODY_RADIUS: f64 = 0.17;

/// A point of the centre line and the unit tangent there, head (left) to tail.
#[derive(Debug, Clone, Copy, PartialEq)]
struct CentrePoint {
    position: [f64; 2],
    tangent: [f64; 2],
}

/// Where the parallel camera ray (against world z) through picture point `(x, y)` meets the body.
///
/// The body is the union of balls around the centre line, which lies in the picture plane; so the
/// ball around the nearest point of the line is the highest at `(x, y)`, and the ends are round. The
/// structure's x axis runs along the body.
pub fn hit([x, y]: [f64; 2]) -> Option<Hit> {
    let centre = nearest_on_line([x, y]);
    let across = [(x - centre.position[0]) / BODY_RADIUS, (y - centre.position[1]) / BODY_RADIUS];
    let z_squared = 1.0 - across[0] * across[0] - across[1] * across[1];
    if z_squared <= 0.0 {
        return None;
    }
    let normal = [across[0], across[1], z_squared.sqrt()];
    Some(Hit { frame: frame_along(normal, [centre.tangent[0], centre.tangent[1], 0.0]), to_viewer: [0.0, 0.0, 1.0] })
}

/// The frame about a normal whose tangent is nearest to a direction; any frame where the direction
/// is the normal itself (the very tips of the body).
fn frame_along(normal: Vec3, direction: Vec3) -> Frame {
    let along = add_scaled(direction, normal, -dot(normal, direction));
    if dot(along, along) < 1e-24 {
        return about(normal);
    }
    let tangent = normalise(along);
    Frame { tangent, bitangent: cross(normal, tangent), normal }
}

fn nearest_on_line(point: [f64; 2]) -> CentrePoint {
    let distance_squared = |centre: &CentrePoint| {
        let [dx, dy] = [point[0] - centre.position[0], point[1] - centre.position[1]];
        dx * dx + dy * dy
    };
    (0..BENDS)
        .map(|bend| nearest_on_bend(bend, point))
        .min_by(|a, b| distance_squared(a).total_cmp(&distance_squared(b)))
        .expect("a body has at least one bend")
}

/// The nearest point of one half circle: radially, or else the nearer end.
fn nearest_on_bend(bend: usize, [x, y]: [f64; 2]) -> CentrePoint {
    let centre_x = (2.0 * bend as f64 - (BENDS - 1) as f64) * BEND_RADIUS;
    // Even bends go over the top, odd ones below: mirrored in y.
    let side = if bend.is_multiple_of(2) { 1.0 } else { -1.0 };
    let angle = (side * y).atan2(x - centre_x);
    let angle = if angle >= 0.0 {
        angle
    } else if x < centre_x {
        PI
    } else {
        0.0
    };
    let (sin, cos) = angle.sin_cos();
    CentrePoint { position: [centre_x + BEND_RADIUS * cos, side * BEND_RADIUS * sin], tangent: [sin, -side * cos] }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn on_the_ridge_the_surface_faces_the_camera() {
        for (angle_deg, bend) in [(10.0, 0), (90.0, 0), (135.0, 1), (60.0, 2)] {
            let (sin, cos) = f64::to_radians(angle_deg).sin_cos();
            let side = [1.0, -1.0, 1.0][bend];
            let centre_x = (bend as f64 - 1.0) * 2.0 * BEND_RADIUS;
            let at = hit([centre_x + BEND_RADIUS * cos, side * BEND_RADIUS * sin]).unwrap();
            assert!((at.frame.normal[2] - 1.0).abs() < 1e-12);
            // Tangent of the circle, leading to the right.
            let expected = [sin, -side * cos, 0.0];
            assert!((dot(at.frame.tangent, expected) - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn the_outline_is_the_bodys_radius_away() {
        // Above the top of the first bend, and beyond the right end.
        let top = BEND_RADIUS + BODY_RADIUS;
        assert!(hit([-2.0 * BEND_RADIUS, top - 1e-9]).is_some());
        assert!(hit([-2.0 * BEND_RADIUS, top + 1e-9]).is_none());
        let end = 3.0 * BEND_RADIUS + BODY_RADIUS;
        assert!(end < 1.0);
        assert!(hit([end - 1e-9, 0.0]).is_some() && hit([end + 1e-9, 0.0]).is_none());
        assert!(hit([0.0, 0.4]).is_none());
    }

    #[test]
    fn frames_are_orthonormal_and_continuous_along_the_body() {
        let mut last: Option<Frame> = None;
        for step in 0..=3000 {
            // From head to tail, beside the ridge, through both joints of the bends.
            let (bend, angle) = (step / 1001, PI * (1.0 - f64::from(step % 1001) / 1000.0));
            let side = [1.0, -1.0, 1.0][bend as usize];
            let (sin, cos) = angle.sin_cos();
            let centre_x = (f64::from(bend) - 1.0) * 2.0 * BEND_RADIUS;
            let radius = BEND_RADIUS + side * 0.05;
            let at = hit([centre_x + radius * cos, side * radius * sin]).unwrap();
            let Frame { tangent: t, bitangent: b, normal: n } = at.frame;
            for unit in [t, b, n] {
                assert!((dot(unit, unit) - 1.0).abs() < 1e-12);
            }
            assert!(dot(t, n).abs() < 1e-12 && (dot(cross(t, b), n) - 1.0).abs() < 1e-12);
            // 0.05 from the ridge everywhere, and a step turns the line by π / 1000.
            let height = (1.0 - (0.05 / BODY_RADIUS).powi(2)).sqrt();
            assert!((n[2] - height).abs() < 1e-9, "step {step}");
            if let Some(before) = last {
                let turn = dot(before.tangent, t).min(1.0).acos();
                assert!(turn < 1.01 * PI / 1000.0, "step {step} turns by {turn}");
            }
            last = Some(at.frame);
        }
    }
}
