//! Turns of the object, the lights or the surroundings about an axis of the world.

use serde::{Deserialize, Serialize};

use super::frame::Frame;
use diffraction_brdf::direction::Vec3;

/// What is turned about.
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
pub(crate) fn carried(frame: &Frame, turn: Turn) -> Frame {
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

#[cfg(test)]
mod tests {
    use super::*;

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
}
