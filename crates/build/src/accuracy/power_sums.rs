//! Share of the incident power that tables send back, by angle of incidence.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::ground::null_for_nan;
use crate::tables::model::TableSet;
use diffraction_brdf::direction::{Vec3, from_angles_deg, wave_vector_change};
use diffraction_brdf::evaluate::{Interpolation, diffuse_window_power, lobe_window_power};
use diffraction_brdf::front_factor::FrontFactor;
use diffraction_brdf::material::Material;

/// `∫ f cos_theta_o dω_o` for one incidence, relative to the incident power.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PowerSum {
    /// Angle of incidence in degrees.
    pub theta_i_deg: f64,
    /// Wavelength in nm; `None` for the luminous sum.
    pub wavelength_nm: Option<f64>,
    /// The sum.
    #[serde(with = "null_for_nan")]
    pub sum: f64,
}

/// Luminous sums `∫ f cos_theta_o dω_o` for unit reflectance, from the tables: the diffuse part on a grid
/// over the viewer's disc, the lobe on a fine patch around the mirror direction. Also the lobe's share at
/// normal incidence. Nothing where the tables do not serve the whole hemisphere.
pub fn power_sums(set: &TableSet) -> (Vec<PowerSum>, Option<f64>) {
    if set.served.is_some() {
        return (Vec::new(), None);
    }
    let unit = TableSet { front_factor: FrontFactor { material: Material::Ideal, ..set.front_factor }, ..set.clone() };
    // A step per texel at most, or narrow orders fall between them.
    let steps = (set.size() / 2).max(256);
    let mut sums = Vec::new();
    let mut lobe_share = None;
    for theta_i_deg in [0.0, 30.0, 60.0] {
        let wi = from_angles_deg(theta_i_deg, 0.0);
        let front = |wo: Vec3| unit.front_factor.diffuse(wi, wo);
        let diffuse = integrate([0.0, 0.0], 1.0, steps, |wo| {
            front(wo) * diffuse_window_power(&unit, Interpolation::Bilinear, wave_vector_change(wi, wo))[1]
        });
        let radius = unit.lobe.as_ref().map_or(0.0, |lobe| lobe.radius_max);
        let lobe = integrate([-wi[0], -wi[1]], radius, 192, |wo| {
            front(wo) * lobe_window_power(&unit, Interpolation::Bilinear, wave_vector_change(wi, wo))[1]
        });
        if theta_i_deg == 0.0 && unit.lobe.is_some() {
            lobe_share = Some(lobe / (lobe + diffuse));
        }
        sums.push(PowerSum { theta_i_deg, wavelength_nm: None, sum: lobe + diffuse });
    }
    (sums, lobe_share)
}

/// Midpoint rule over the square of half width `half` around a projected direction, inside the unit disc:
/// `cos_theta_o dω_o` is the area element there.
fn integrate(centre: [f64; 2], half: f64, steps: usize, f: impl Fn(Vec3) -> f64 + Sync) -> f64 {
    let cell = 2.0 * half / steps as f64;
    let rows: Vec<f64> = (0..steps)
        .into_par_iter()
        .map(|row| {
            let y = centre[1] - half + (row as f64 + 0.5) * cell;
            let line = (0..steps).map(|column| {
                let x = centre[0] - half + (column as f64 + 0.5) * cell;
                let z2 = 1.0 - x * x - y * y;
                if z2 > 0.0 { f([x, y, z2.sqrt()]) } else { 0.0 }
            });
            line.sum::<f64>()
        })
        .collect();
    rows.iter().sum::<f64>() * cell * cell
}
