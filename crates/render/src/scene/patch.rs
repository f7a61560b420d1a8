//! A flat square seen in perspective.

use diffraction_brdf::direction::{Vec3, dot, normalise};

use super::frame::{self, Frame, add_scaled};
use super::hit::Hit;
use super::model::Shape;
use super::turn::{Turn, carried};

/// Space left around the square, as a factor on its largest picture coordinate.
const MARGIN: f64 = 1.04;

/// A square centred in the world's origin and a pinhole camera on the z axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PatchView {
    /// Axes along the square's edges, and its normal.
    edges: Frame,
    /// Axes of the structure.
    structure: Frame,
    half_width_mm: f64,
    distance_mm: f64,
    /// Half the side, in the plane through the origin, of what the picture shows.
    half_field_mm: f64,
}

/// The view of a patch; the picture just holds the square, whatever its tilt.
///
/// # Panics
/// On another shape.
pub(crate) fn view(shape: &Shape) -> PatchView {
    let Shape::Patch { width_mm, distance_mm, tilt_deg, turn_deg } = *shape else {
        panic!("a view of a patch needs a patch, not {shape:?}");
    };
    let (sin, cos) = tilt_deg.to_radians().sin_cos();
    let edges = Frame { tangent: [1.0, 0.0, 0.0], bitangent: [0.0, cos, -sin], normal: [0.0, sin, cos] };
    let half_width_mm = 0.5 * width_mm;
    let largest_mm = [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)]
        .map(|(s, t)| {
            let corner =
                add_scaled(add_scaled([0.0; 3], edges.tangent, s * half_width_mm), edges.bitangent, t * half_width_mm);
            let scale = distance_mm / (distance_mm - corner[2]);
            scale * corner[0].abs().max(corner[1].abs())
        })
        .into_iter()
        .fold(0.0, f64::max);
    PatchView {
        edges,
        structure: frame::turned(&edges, turn_deg),
        half_width_mm,
        distance_mm,
        half_field_mm: MARGIN * largest_mm,
    }
}

/// The square turned about an axis through its centre; the field of view stays.
pub(crate) fn turned(view: &PatchView, turn: Turn) -> PatchView {
    PatchView { edges: carried(&view.edges, turn), structure: carried(&view.structure, turn), ..*view }
}

/// Where the camera ray through picture point `(x, y)` meets the square.
pub(crate) fn hit(view: &PatchView, [x, y]: [f64; 2]) -> Option<Hit> {
    let camera: Vec3 = [0.0, 0.0, view.distance_mm];
    let ray = [x * view.half_field_mm, y * view.half_field_mm, -view.distance_mm];
    let approach = -dot(view.edges.normal, ray);
    if approach <= 0.0 {
        return None;
    }
    let point = add_scaled(camera, ray, dot(view.edges.normal, camera) / approach);
    let inside = |axis: Vec3| dot(axis, point).abs() <= view.half_width_mm;
    if !inside(view.edges.tangent) || !inside(view.edges.bitangent) {
        return None;
    }
    Some(Hit { frame: view.structure, to_viewer: normalise(ray.map(|c| -c)) })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn patch(tilt_deg: f64, turn_deg: f64) -> PatchView {
        view(&Shape::Patch { width_mm: 40.0, distance_mm: 100.0, tilt_deg, turn_deg })
    }

    #[test]
    fn an_untilted_square_fills_the_picture_but_for_the_margin() {
        let view = patch(0.0, 0.0);
        assert!(hit(&view, [0.999 / MARGIN, -0.999 / MARGIN]).is_some());
        assert!(hit(&view, [1.001 / MARGIN, 0.0]).is_none());
        let middle = hit(&view, [0.0, 0.0]).unwrap();
        assert_eq!(middle.to_viewer, [0.0, 0.0, 1.0]);
        // At the edge's middle the camera is 100 mm away and 20 mm to the side.
        let edge = hit(&view, [1.0 / MARGIN - 1e-12, 0.0]).unwrap();
        assert!((edge.to_viewer[0] / edge.to_viewer[2] + 0.2).abs() < 1e-9);
    }

    #[test]
    fn tilt_leans_the_upper_edge_away() {
        let view = patch(60.0, 0.0);
        // Edges at 20 mm: heights +-10 mm, depths -+17.32 mm; the lower edge is nearer and larger.
        let lower = 10.0 * 100.0 / (100.0 - 17.320_508_075_688_77);
        let upper = 10.0 * 100.0 / (100.0 + 17.320_508_075_688_77);
        let near_corner = 20.0 * 100.0 / (100.0 - 17.320_508_075_688_77);
        assert!((view.half_field_mm - MARGIN * near_corner).abs() < 1e-10);
        let at = |y_mm: f64| hit(&view, [0.0, y_mm / view.half_field_mm]);
        assert!(at(upper - 1e-6).is_some() && at(upper + 1e-6).is_none());
        assert!(at(-lower + 1e-6).is_some() && at(-lower - 1e-6).is_none());
        assert!((at(0.0).unwrap().frame.normal[1] - 60f64.to_radians().sin()).abs() < 1e-15);
    }

    #[test]
    fn a_turn_moves_the_structure_and_not_the_outline() {
        let (plain, turned) = (patch(30.0, 0.0), patch(30.0, 90.0));
        assert_eq!(plain.half_field_mm, turned.half_field_mm);
        let frame = hit(&turned, [0.0, 0.0]).unwrap().frame;
        for (a, b) in frame.tangent.iter().zip(plain.edges.bitangent) {
            assert!((a - b).abs() < 1e-15);
        }
    }
}
