//! Directions with values, stored for testing other programs.

use diffraction_brdf::Xyz;
use diffraction_brdf::direction::{Vec3, angles_deg, from_angles_deg};
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_brdf::specimen::CheckValue;
use diffraction_build::ground::sampling;
use diffraction_build::tables::model::TableSet;

/// How many.
const CHECK_VALUES: usize = 20;
/// Luminance in 1/sr that a direction of the hemisphere should have, and how many are tried until one has: between the orders
/// of a grating a value of 0 says little. The first is kept as it falls.
const LIT_PER_SR: f64 = 1e-4;
const TRIES: usize = 256;

/// Half over the whole hemisphere, where there is light, half around the mirror direction; some of the directions `counted`
/// where tables are restricted to scenes.
pub(super) fn check_values(set: &TableSet, counted: &[(Vec3, Vec3)]) -> Vec<CheckValue> {
    if set.restriction.is_some() {
        let step = counted.len().div_ceil(CHECK_VALUES).max(1);
        return counted.iter().step_by(step).map(|&(wi, wo)| value_at(set, wi, wo)).collect();
    }
    let angle = |share: f64, range: f64| (share * range * 10.0).round() / 10.0;
    let value = |[theta_i_deg, phi_i_deg, theta_r_deg, phi_r_deg]: [f64; 4]| {
        let (wi, wo) = (from_angles_deg(theta_i_deg, phi_i_deg), from_angles_deg(theta_r_deg, phi_r_deg));
        let xyz = brdf_xyz(set, Interpolation::Bilinear, wi, wo);
        CheckValue { theta_i_deg, phi_i_deg, theta_r_deg, phi_r_deg, wi, wo, xyz, xyz_spline: by_splines(set, wi, wo) }
    };
    let anywhere = |index: usize| {
        let [a, b, c, d] = sampling::four(index);
        value([angle(a, 80.0), angle(b, 360.0), angle(c, 80.0), angle(d, 360.0)])
    };
    let mirrored = |index: usize| {
        let [a, b, c, d] = sampling::four(index);
        let (theta_deg, phi_deg) = (angle(a, 80.0), angle(b, 360.0));
        value([theta_deg, phi_deg, (theta_deg + angle(c, 2.0) - 1.0).abs(), (phi_deg + 179.0 + angle(d, 2.0)) % 360.0])
    };
    let lit = |index: usize| {
        let mut tried = (0..TRIES).map(|k| anywhere(index + k * CHECK_VALUES));
        tried.find(|check| index == 0 || check.xyz[1] > LIT_PER_SR).unwrap_or_else(|| anywhere(index))
    };
    (0..CHECK_VALUES).map(|index| if index % 2 == 0 { lit(index) } else { mirrored(index) }).collect()
}

fn value_at(set: &TableSet, wi: Vec3, wo: Vec3) -> CheckValue {
    let [[theta_i_deg, phi_i_deg], [theta_r_deg, phi_r_deg]] = [wi, wo].map(angles_deg);
    // Samples of a picture are 32-bit floats, not quite of unit length.
    let (wi, wo) = (from_angles_deg(theta_i_deg, phi_i_deg), from_angles_deg(theta_r_deg, phi_r_deg));
    CheckValue {
        theta_i_deg,
        phi_i_deg,
        theta_r_deg,
        phi_r_deg,
        wi,
        wo,
        xyz: brdf_xyz(set, Interpolation::Bilinear, wi, wo),
        xyz_spline: by_splines(set, wi, wo),
    }
}

/// The value by splines, where these are what tables of this kind are promised for.
fn by_splines(set: &TableSet, wi: Vec3, wo: Vec3) -> Option<Xyz> {
    (set.look_up() == Interpolation::Spline).then(|| brdf_xyz(set, Interpolation::Spline, wi, wo))
}
