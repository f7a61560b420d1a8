//! Turned objects and lights: what a turn must leave alike, and where it must lead.

use diffraction_brdf::direction::{Vec3, Xyz};
use diffraction_render::render::cpu;
use diffraction_render::scene::animation::frame;
use diffraction_render::scene::model::{Animation, Moving, Scene, Shape, check};
use diffraction_render::scene::turn::{Axis, Turn, back, turned};
use ndarray::Array3;

use super::scene;

const PATCH: Shape = Shape::Patch { width_mm: 20.0, distance_mm: 60.0, tilt_deg: 20.0, turn_deg: 15.0 };

/// Depends on every component of both directions, so that no turn of the structure goes unnoticed.
fn structured(wi: Vec3, wo: Vec3) -> Xyz {
    let q = [wi[0] + wo[0], wi[1] + wo[1]];
    [1.0 + (9.0 * q[0]).cos(), 1.0 + (5.0 * q[0] + 4.0 * q[1]).cos(), 1.0 + (7.0 * q[1]).sin()]
}

fn picture(scene: &Scene) -> Array3<f32> {
    cpu::render(scene, &structured).unwrap()
}

/// The picture turned by 90 degrees counter-clockwise: what was right is on top.
fn rotated(image: &Array3<f32>) -> Array3<f32> {
    let side = image.dim().0;
    Array3::from_shape_fn(image.dim(), |(row, column, channel)| image[[column, side - 1 - row, channel]])
}

fn worst(a: &Array3<f32>, b: &Array3<f32>) -> f32 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

#[test]
fn a_quarter_turn_in_the_picture_is_the_picture_turned() {
    // Frame and light turned together are the same scene seen by a turned camera.
    let quarter = Turn { axis: Axis::Viewing, angle_deg: 90.0 };
    for shape in [Shape::Sphere, Shape::Snake, PATCH] {
        let direction = [0.5, 0.3, 1.0];
        let turned_object = Scene { turn: quarter, ..scene(shape.clone(), direction, 33) };
        let still = scene(shape.clone(), turned(direction, back(quarter)), 33);
        // Directions are rounded to f32 before shading: 1e-7 times slopes of 9 and weights of 1.
        let error = worst(&picture(&turned_object), &rotated(&picture(&still)));
        assert!(error < 1e-5, "{shape:?}: {error}");
        // The other way round it is another picture.
        let wrong = Scene { turn: back(quarter), ..turned_object.clone() };
        assert!(worst(&picture(&wrong), &rotated(&picture(&still))) > 0.1, "{shape:?}");
        // And the structure has turned with the object.
        assert!(worst(&picture(&turned_object), &picture(&scene(shape.clone(), direction, 33))) > 0.1, "{shape:?}");
    }
}

#[test]
fn a_square_on_a_turntable_shows_its_side() {
    let square = Shape::Patch { width_mm: 20.0, distance_mm: 1000.0, tilt_deg: 0.0, turn_deg: 0.0 };
    let at = |angle_deg| Scene {
        turn: Turn { axis: Axis::Vertical, angle_deg },
        ..scene(square.clone(), [0.0, 0.0, 1.0], 33)
    };
    // In the middle the camera and the light look along +z: locally both are (-sin, 0, cos) of the turn.
    let image = cpu::render(&at(30.0), &|_, wo| wo.map(|c| c + 2.0)).unwrap();
    let cosine = 30f64.to_radians().cos();
    let found = [0, 1, 2].map(|channel| f64::from(image[[16, 16, channel]]) / cosine - 2.0);
    for (found, expected) in found.into_iter().zip([-0.5, 0.0, cosine]) {
        assert!((found - expected).abs() < 1e-6, "{found} {expected}");
    }
    // Edge-on and from behind nothing is left; after a whole turn everything is.
    for angle_deg in [90.0, 180.0] {
        assert_eq!(picture(&at(angle_deg)).iter().filter(|&&value| value > 1e-6).count(), 0);
    }
    assert!(worst(&picture(&at(360.0)), &picture(&at(0.0))) < 1e-5);
}

#[test]
fn frames_begin_at_the_still_and_lead_to_the_turned_scene() {
    let base = scene(PATCH, [0.5, 0.3, 1.0], 24);
    for (kind, axis) in [
        (Moving::Light, Axis::Vertical),
        (Moving::Light, Axis::Viewing),
        (Moving::Turntable, Axis::Vertical),
        (Moving::Turntable, Axis::Viewing),
    ] {
        let animation = Animation { kind, axis, frames: 8, degrees: 360.0, fps: 12, size_px: 24 };
        let animated = Scene { animation: Some(animation), ..base.clone() };
        check(&animated).unwrap();
        let frames: Vec<Array3<f32>> = (0..=8).map(|index| picture(&frame(&animated, &animation, index))).collect();
        assert_eq!(frames[0], picture(&base), "the first frame is the still");
        assert!(worst(&frames[8], &frames[0]) < 1e-5, "after the last comes the first");
        assert!(worst(&frames[1], &frames[0]) > 0.05, "{kind:?} {axis:?}");
        let mut quarter = base.clone();
        let turn = Turn { axis, angle_deg: 90.0 };
        match kind {
            Moving::Light => quarter.lights[0].direction = turned(quarter.lights[0].direction, turn),
            Moving::Turntable => quarter.turn = turn,
        }
        assert_eq!(frames[2], picture(&quarter));
    }
}

#[test]
fn what_cannot_turn_is_refused() {
    let animated = |shape, kind, axis, frames, size_px| Scene {
        animation: Some(Animation { kind, axis, frames, degrees: 360.0, fps: 12, size_px }),
        ..scene(shape, [0.5, 0.3, 1.0], 24)
    };
    let refused = |scene: Scene| check(&scene).unwrap_err().to_string();
    let (table, light) = (Moving::Turntable, Moving::Light);
    assert!(refused(animated(Shape::Sphere, table, Axis::Vertical, 8, 24)).contains("looks the same"));
    assert!(refused(animated(Shape::Snake, table, Axis::Vertical, 8, 24)).contains("from above"));
    assert!(refused(animated(Shape::Hemisphere, light, Axis::Vertical, 8, 24)).contains("would set"));
    assert!(refused(animated(Shape::Hemisphere, table, Axis::Viewing, 8, 24)).contains("no object"));
    assert!(refused(animated(PATCH, table, Axis::Vertical, 65, 1024)).contains("pixels together"));
    assert!(refused(animated(PATCH, table, Axis::Vertical, usize::MAX, 1 << 40)).contains("frames"));
    check(&animated(Shape::Hemisphere, light, Axis::Viewing, 64, 1024)).unwrap();
    let sideways =
        Scene { turn: Turn { axis: Axis::Vertical, angle_deg: 1.0 }, ..scene(Shape::Sphere, [0.0, 0.0, 1.0], 8) };
    assert!(refused(sideways).contains("looks the same"));
}
