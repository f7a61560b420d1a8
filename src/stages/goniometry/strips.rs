//! Strips of colour over the angle of the set-ups that laboratories use, in the two planes of the scan's axes.

use serde::{Deserialize, Serialize};

use super::instrument::Instrument;
use diffraction_brdf::direction::{Vec3, from_angles_deg};
use diffraction_brdf::error::Result;

/// Largest angle of a strip in degrees, and the angle between the arms that stay fixed.
const ANGLE_MAX_DEG: i32 = 85;
const ARMS_DEG: i32 = 45;

/// How light and detector stand to each other while the angle changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SetUp {
    /// Light from straight above, detector at the angle.
    NormalIncidence,
    /// Light at the angle on one side, detector at the same angle on the other.
    Mirror,
    /// Light and detector 45 degrees apart, the specimen turned by the angle below them.
    FixedArms,
    /// Light and detector at the angle, both on the same side.
    BackScattering,
}

/// The plane that light and detector lie in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Plane {
    /// That of the scan's x axis and the normal.
    Xz,
    /// That of the scan's y axis and the normal.
    Yz,
}

/// Colours over the angle of a set-up.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Strip {
    /// The set-up.
    pub set_up: SetUp,
    /// The plane.
    pub plane: Plane,
    /// First angle in degrees; the others follow one degree apart.
    pub first_deg: i32,
    /// XYZ of the radiance factor at each angle.
    pub xyz: Vec<[f32; 3]>,
}

impl Strip {
    /// Angles in degrees, as many as values.
    pub fn angles_deg(&self) -> impl Iterator<Item = f64> {
        (self.first_deg..).take(self.xyz.len()).map(f64::from)
    }
}

impl SetUp {
    /// In the order of the report.
    pub(crate) const ALL: [Self; 4] = [Self::NormalIncidence, Self::Mirror, Self::FixedArms, Self::BackScattering];

    /// First and last angle in degrees.
    fn range_deg(self) -> [i32; 2] {
        match self {
            // Exchanging light and detector changes nothing.
            Self::Mirror => [0, ANGLE_MAX_DEG],
            Self::FixedArms => [(ARMS_DEG + 1) / 2 - ANGLE_MAX_DEG, ANGLE_MAX_DEG - (ARMS_DEG + 1) / 2],
            Self::NormalIncidence | Self::BackScattering => [-ANGLE_MAX_DEG, ANGLE_MAX_DEG],
        }
    }

    /// Polar angles of light and detector in degrees, in the plane, positive towards +x or +y.
    fn arms_deg(self, angle_deg: f64) -> [f64; 2] {
        let half = 0.5 * f64::from(ARMS_DEG);
        match self {
            Self::NormalIncidence => [0.0, angle_deg],
            Self::Mirror => [-angle_deg, angle_deg],
            Self::FixedArms => [angle_deg - half, angle_deg + half],
            Self::BackScattering => [angle_deg, angle_deg],
        }
    }
}

impl Plane {
    /// In the order of the report.
    pub(crate) const ALL: [Self; 2] = [Self::Xz, Self::Yz];

    /// The direction at a polar angle in degrees, positive towards +x or +y.
    fn direction(self, theta_deg: f64) -> Vec3 {
        let [along, _, z] = from_angles_deg(theta_deg, 0.0);
        match self {
            Self::Xz => [along, 0.0, z],
            Self::Yz => [0.0, along, z],
        }
    }
}

/// All set-ups in both planes.
pub(super) fn strips(instrument: &Instrument) -> Result<Vec<Strip>> {
    let kinds = SetUp::ALL.into_iter().flat_map(|set_up| Plane::ALL.map(|plane| (set_up, plane)));
    kinds
        .map(|(set_up, plane)| {
            let [first_deg, last_deg] = set_up.range_deg();
            let value = |angle: i32| {
                let [wi, wo] = set_up.arms_deg(f64::from(angle)).map(|theta| plane.direction(theta));
                Ok(instrument.radiance_factor(wi, wo)?.map(|value| value as f32))
            };
            let xyz = (first_deg..=last_deg).map(value).collect::<Result<_>>()?;
            Ok(Strip { set_up, plane, first_deg, xyz })
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_angle_of_every_set_up_is_above_the_surface() {
        for set_up in SetUp::ALL {
            for end in set_up.range_deg() {
                for arm in set_up.arms_deg(f64::from(end)) {
                    assert!(arm.abs() <= f64::from(ANGLE_MAX_DEG), "{set_up:?} {end}: {arm}");
                }
            }
        }
        let [light, detector] = SetUp::FixedArms.arms_deg(10.0);
        assert_eq!(detector - light, f64::from(ARMS_DEG));
    }
}
