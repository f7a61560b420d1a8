//! Animations: the still's scene, frame by frame with the object or the lights turned.

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

use super::frame::Frame;
use super::model::Scene;
use diffraction_brdf::direction::Vec3;

/// What moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Moving {
    /// The object with its structure; camera and lights stay.
    Turntable,
    /// The lights and the environment; camera and object stay.
    Light,
}

/// What it turns about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Axis {
    /// World y, upwards; positive turns go from +z towards +x.
    #[default]
    Vertical,
    /// World z, towards the camera; positive turns go from +x towards +y, counter-clockwise in the picture.
    Viewing,
}

/// A turn about an axis through the world's origin.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Turn {
    /// The axis.
    pub axis: Axis,
    /// The angle in degrees.
    pub angle_deg: f64,
}

/// An animation of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Animation {
    /// What moves.
    pub kind: Moving,
    /// What it turns about.
    pub axis: Axis,
    /// Number of frames.
    pub frames: usize,
    /// 360 (or -360) goes round steadily; less swings to and fro like a pendulum, half of it to either side.
    pub degrees: f64,
    /// Frames per second.
    pub fps: u16,
    /// Side of the square picture.
    pub size_px: usize,
}

/// A vector turned.
pub fn turned(v: Vec3, turn: Turn) -> Vec3 {
    if turn.angle_deg == 0.0 {
        return v;
    }
    let (sin, cos) = turn.angle_deg.to_radians().sin_cos();
    let [x, y, z] = v;
    match turn.axis {
        Axis::Vertical => [x * cos + z * sin, y, z * cos - x * sin],
        Axis::Viewing => [x * cos - y * sin, x * sin + y * cos, z],
    }
}

/// A frame that a turn takes along.
pub fn carried(frame: &Frame, turn: Turn) -> Frame {
    Frame {
        tangent: turned(frame.tangent, turn),
        bitangent: turned(frame.bitangent, turn),
        normal: turned(frame.normal, turn),
    }
}

/// The opposite turn.
pub fn back(turn: Turn) -> Turn {
    Turn { angle_deg: -turn.angle_deg, ..turn }
}

/// The turn of a frame; frame 0 of a whole turn, and of a swing, is the still.
pub fn turn_of_frame(animation: &Animation, frame: usize) -> Turn {
    let share = frame as f64 / animation.frames as f64;
    let angle_deg = if animation.degrees.abs() >= 360.0 {
        animation.degrees * share
    } else {
        0.5 * animation.degrees * (TAU * share).sin()
    };
    Turn { axis: animation.axis, angle_deg }
}

/// The scene of one frame.
pub fn frame(scene: &Scene, animation: &Animation, frame: usize) -> Scene {
    let turn = turn_of_frame(animation, frame);
    let mut moved = Scene { size_px: animation.size_px, animation: None, ..scene.clone() };
    match animation.kind {
        Moving::Turntable => moved.turn = turn,
        Moving::Light => {
            moved.lights.iter_mut().for_each(|light| light.direction = turned(light.direction, turn));
            if let Some(environment) = &mut moved.environment {
                environment.turn = turn;
            }
        }
    }
    moved
}

#[cfg(test)]
mod tests {
    use super::*;

    fn animation(degrees: f64) -> Animation {
        Animation { kind: Moving::Light, axis: Axis::Vertical, frames: 8, degrees, fps: 12, size_px: 16 }
    }

    #[test]
    fn turns_go_the_way_they_say() {
        let near = |a: Vec3, b: Vec3| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-15);
        let quarter = |axis| Turn { axis, angle_deg: 90.0 };
        assert!(near(turned([0.0, 0.0, 1.0], quarter(Axis::Vertical)), [1.0, 0.0, 0.0]));
        assert!(near(turned([1.0, 0.0, 0.0], quarter(Axis::Viewing)), [0.0, 1.0, 0.0]));
        let v = [0.3, -0.5, 0.8];
        for axis in [Axis::Vertical, Axis::Viewing] {
            let turn = Turn { axis, angle_deg: 33.0 };
            assert!(near(turned(turned(v, turn), back(turn)), v));
        }
    }

    #[test]
    fn a_whole_turn_is_even_and_a_swing_comes_back() {
        let angles = |degrees| -> Vec<f64> {
            (0..=8).map(|frame| turn_of_frame(&animation(degrees), frame).angle_deg).collect()
        };
        assert_eq!(angles(360.0), [0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0, 360.0]);
        let swing = angles(60.0);
        assert_eq!((swing[0], swing[2], swing[6]), (0.0, 30.0, -30.0));
        assert!(swing[8].abs() < 1e-13 && swing[4].abs() < 1e-13);
    }
}
