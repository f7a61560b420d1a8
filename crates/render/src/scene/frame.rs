//! Orthonormal frames: from world to the local frame of a point on a surface.

use diffraction_brdf::direction::{Vec3, dot, normalise};

/// A right-handed orthonormal frame; the structure's x axis runs along `tangent`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Local x in world coordinates.
    pub tangent: Vec3,
    /// Local y.
    pub bitangent: Vec3,
    /// Local z, the outward normal.
    pub normal: Vec3,
}

/// Vector product.
pub fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// `a + s b`.
pub fn add_scaled(a: Vec3, b: Vec3, s: f64) -> Vec3 {
    [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]]
}

/// World to local components.
pub fn to_local(frame: &Frame, v: Vec3) -> Vec3 {
    [dot(frame.tangent, v), dot(frame.bitangent, v), dot(frame.normal, v)]
}

/// Local to world components.
pub fn to_world(frame: &Frame, v: Vec3) -> Vec3 {
    let xy = add_scaled([0.0; 3], frame.tangent, v[0]);
    let xy = add_scaled(xy, frame.bitangent, v[1]);
    add_scaled(xy, frame.normal, v[2])
}

/// The frame turned about its normal, from tangent towards bitangent.
pub fn turned(frame: &Frame, angle_deg: f64) -> Frame {
    let (sin, cos) = angle_deg.to_radians().sin_cos();
    let zero = [0.0; 3];
    Frame {
        tangent: add_scaled(add_scaled(zero, frame.tangent, cos), frame.bitangent, sin),
        bitangent: add_scaled(add_scaled(zero, frame.bitangent, cos), frame.tangent, -sin),
        normal: frame.normal,
    }
}

/// The frame of a globe with poles at world +y and -y: the tangent runs along the circle of
/// latitude, the bitangent towards the +y pole. At the poles themselves, where latitude circles
/// have no direction, the tangent is world +x.
pub(crate) fn on_globe(normal: Vec3) -> Frame {
    let along = [normal[2], 0.0, -normal[0]];
    let tangent = if dot(along, along) > 1e-24 {
        normalise(along)
    } else {
        // +x made exactly perpendicular to a normal that is +-y but for rounding.
        normalise(add_scaled([1.0, 0.0, 0.0], normal, -normal[0]))
    };
    Frame { tangent, bitangent: cross(normal, tangent), normal }
}

/// Any frame about a normal: the shortest turn that takes world +z to it; a half turn about
/// world x for -z.
pub fn about(normal: Vec3) -> Frame {
    let [x, y, z] = normal;
    if z < -1.0 + 1e-12 {
        return Frame { tangent: [1.0, 0.0, 0.0], bitangent: [0.0, -1.0, 0.0], normal };
    }
    let s = 1.0 / (1.0 + z);
    Frame { tangent: [1.0 - x * x * s, -x * y * s, -x], bitangent: [-x * y * s, 1.0 - y * y * s, -y], normal }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The frame whose axes are the world's.
    const WORLD: Frame = Frame { tangent: [1.0, 0.0, 0.0], bitangent: [0.0, 1.0, 0.0], normal: [0.0, 0.0, 1.0] };

    /// Largest violation of orthonormality and right-handedness.
    fn defect(frame: &Frame) -> f64 {
        let Frame { tangent: t, bitangent: b, normal: n } = *frame;
        let triple = dot(cross(t, b), n);
        [dot(t, t) - 1.0, dot(b, b) - 1.0, dot(n, n) - 1.0, dot(t, b), dot(b, n), dot(n, t), triple - 1.0]
            .into_iter()
            .fold(0.0, |m, d| m.max(d.abs()))
    }

    #[test]
    fn a_left_handed_or_skewed_frame_is_noticed() {
        let mut frame = WORLD;
        frame.bitangent = [0.0, -1.0, 0.0];
        assert!(defect(&frame) > 1.0);
        frame.bitangent = [1e-6, 1.0, 0.0];
        assert!(defect(&frame) > 1e-7);
    }

    #[test]
    fn facing_the_camera_the_globe_frame_is_the_world() {
        assert_eq!(on_globe([0.0, 0.0, 1.0]), WORLD);
        assert_eq!(about([0.0, 0.0, 1.0]), WORLD);
    }

    #[test]
    fn poles_have_frames() {
        for y in [1.0, -1.0] {
            for x in [0.0, 1e-13, 1e-9] {
                let normal = normalise([x, y, -x]);
                assert!(defect(&on_globe(normal)) < 1e-12);
            }
        }
        assert!(defect(&about([0.0, 0.0, -1.0])) < 1e-15);
    }

    #[test]
    fn a_quarter_turn_takes_x_to_y() {
        let frame = turned(&WORLD, 90.0);
        assert!((frame.tangent[1] - 1.0).abs() < 1e-15 && defect(&frame) < 1e-15);
    }

    proptest! {
        #[test]
        fn frames_are_orthonormal_and_right_handed(
            v in proptest::array::uniform3(-1.0..1.0f64), angle_deg in -360.0..360.0f64,
        ) {
            prop_assume!(dot(v, v) > 1e-4);
            let normal = normalise(v);
            for frame in [on_globe(normal), about(normal), turned(&on_globe(normal), angle_deg)] {
                // Rounding only; near -z `about` divides by 1 + z, hence 1e-16 / (1 + z).
                prop_assert!(defect(&frame) < 1e-13 + 1e-15 / (1.0 + normal[2]).max(1e-12));
            }
        }

        #[test]
        fn local_and_world_are_inverse(
            n in proptest::array::uniform3(-1.0..1.0f64), v in proptest::array::uniform3(-9.0..9.0f64),
        ) {
            prop_assume!(dot(n, n) > 1e-4);
            let frame = on_globe(normalise(n));
            let back = to_world(&frame, to_local(&frame, v));
            for (b, given) in back.iter().zip(v) {
                prop_assert!((b - given).abs() < 1e-13);
            }
            prop_assert!((to_local(&frame, v)[2] - dot(frame.normal, v)).abs() < 1e-15);
        }
    }
}
