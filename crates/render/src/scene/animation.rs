//! Animations: the still's scene, frame by frame with the object or the lights turned.

use std::f64::consts::TAU;

use super::model::{Animation, Moving, Scene};
use super::turn::{Turn, turned};

/// The turn of a frame; frame 0 of a whole turn, and of a swing, is the still.
pub(crate) fn turn_of_frame(animation: &Animation, frame: usize) -> Turn {
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
    use crate::scene::turn::Axis;

    fn animation(degrees: f64) -> Animation {
        Animation { kind: Moving::Light, axis: Axis::Vertical, frames: 8, degrees, fps: 12, size_px: 16 }
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
