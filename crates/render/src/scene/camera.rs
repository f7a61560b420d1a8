//! A camera anywhere in the world: picture points to rays.

use serde::{Deserialize, Serialize};

use diffraction_brdf::direction::{Vec3, dot, normalise};

use super::bvh::{Bounds, Ray, middle};
use super::frame::{add_scaled, cross};

/// Where the camera is and what it sees.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Camera {
    /// Its place.
    pub position: Vec3,
    /// What is in the middle of the picture.
    pub target: Vec3,
    /// What points up in the picture; not along the line of sight.
    pub up: Vec3,
    /// How much it sees.
    pub field: Field,
}

/// How much of the world fills the picture.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Field {
    /// A pinhole camera: the angle over the picture's side.
    FovDeg(f64),
    /// Parallel rays, as from afar: the side of the picture in the world's unit of length.
    Width(f64),
}

/// Angle of view of a camera that is placed automatically: little perspective, as of a portrait lens.
const AUTOMATIC_FOV_DEG: f64 = 25.0;
/// Space that it leaves around the body, as a factor.
const MARGIN: f64 = 1.04;
/// Largest share of the line of sight in `up`, as `1 - |cosine|`.
const UP_DEFECT_MIN: f64 = 1e-12;

/// A camera ready to make rays.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    position: Vec3,
    right: Vec3,
    up: Vec3,
    /// From the camera to the middle of the picture.
    forward: Vec3,
    /// Half the picture's side: in the plane one unit ahead, or in the world for parallel rays.
    half: f64,
    parallel: bool,
}

/// A camera on the +z side that looks along -z at the middle of a box and just holds it.
pub(crate) fn automatic(bounds: &Bounds) -> Camera {
    let middle = middle(bounds);
    let half: Vec3 = std::array::from_fn(|axis| 0.5 * (bounds.high[axis] - bounds.low[axis]));
    let tangent = (0.5 * AUTOMATIC_FOV_DEG).to_radians().tan();
    // The face of the box that is nearest fills the picture. A point has no size: any distance will do.
    let side = MARGIN * half[0].max(half[1]).max(0.05 * half[2]).max(f64::MIN_POSITIVE.sqrt());
    let distance = side / tangent + half[2];
    Camera {
        position: [middle[0], middle[1], middle[2] + distance],
        target: middle,
        up: [0.0, 1.0, 0.0],
        field: Field::FovDeg(AUTOMATIC_FOV_DEG),
    }
}

/// What a camera sees; `None` where it stands on its target or `up` lies along the line of sight.
pub fn view(camera: &Camera) -> Option<View> {
    let forward = normalise(add_scaled(camera.target, camera.position, -1.0));
    let up = normalise(camera.up);
    let sideways = cross(forward, up);
    // The cross product's square is 1 - cosine²; zero or not a number where a vector is.
    let defect = dot(sideways, sideways);
    if defect.is_nan() || defect <= UP_DEFECT_MIN {
        return None;
    }
    let right = normalise(sideways);
    let (half, parallel) = match camera.field {
        Field::FovDeg(fov_deg) => ((0.5 * fov_deg).to_radians().tan(), false),
        Field::Width(width) => (0.5 * width, true),
    };
    Some(View { position: camera.position, right, up: cross(right, forward), forward, half, parallel })
}

/// The ray through picture point `(x, y)`; its direction is a unit vector. Parallel rays start in the plane of the
/// camera's position.
pub(crate) fn ray(view: &View, [x, y]: [f64; 2]) -> Ray {
    let aside = add_scaled(add_scaled([0.0; 3], view.right, x * view.half), view.up, y * view.half);
    if view.parallel {
        return Ray { origin: add_scaled(view.position, aside, 1.0), direction: view.forward };
    }
    Ray { origin: view.position, direction: normalise(add_scaled(view.forward, aside, 1.0)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CAMERA: Camera =
        Camera { position: [0.0, 0.0, 10.0], target: [0.0; 3], up: [0.0, 1.0, 0.0], field: Field::FovDeg(90.0) };

    #[test]
    fn the_pictures_axes_are_right_and_up() {
        let view = view(&CAMERA).unwrap();
        assert_eq!(ray(&view, [0.0, 0.0]).direction, [0.0, 0.0, -1.0]);
        // At 90 degrees the edges are at 45.
        let corner = ray(&view, [1.0, 1.0]).direction;
        let third = 3f64.sqrt().recip();
        for (c, expected) in corner.iter().zip([third, third, -third]) {
            assert!((c - expected).abs() < 1e-15);
        }
    }

    #[test]
    fn parallel_rays_are_spread_over_the_width() {
        let view = view(&Camera { field: Field::Width(3.0), ..CAMERA }).unwrap();
        let ray = ray(&view, [-1.0, 0.5]);
        assert_eq!((ray.origin, ray.direction), ([-1.5, 0.75, 10.0], [0.0, 0.0, -1.0]));
    }

    #[test]
    fn a_camera_that_sees_nothing_is_refused() {
        assert!(view(&Camera { target: CAMERA.position, ..CAMERA }).is_none());
        assert!(view(&Camera { up: [0.0, 0.0, -2.0], ..CAMERA }).is_none());
        assert!(view(&Camera { up: [0.0; 3], ..CAMERA }).is_none());
        assert!(view(&Camera { up: [f64::NAN; 3], ..CAMERA }).is_none());
    }

    #[test]
    fn the_automatic_camera_just_holds_the_box() {
        let bounds = Bounds { low: [1.0, -3.0, 2.0], high: [2.0, 5.0, 4.0] };
        let camera = automatic(&bounds);
        let view = view(&camera).unwrap();
        // The upper edge of the front face: 4 above the middle, 1 / MARGIN of the half picture.
        let edge = ray(&view, [0.0, 1.0 / MARGIN]);
        let t = (4.0 - edge.origin[2]) / edge.direction[2];
        let y = edge.origin[1] + t * edge.direction[1];
        assert!((y - 5.0).abs() < 1e-12, "{y}");
    }
}
