//! How far what is seen moved between two versions of a specimen: colour differences and values over the same directions.

use std::f64::consts::PI;

use ndarray::Array3;
use rayon::prelude::*;
use serde::Serialize;

use diffraction_brdf::direction::{Vec3, Xyz, angles_deg};
use diffraction_brdf::evaluate::{Interpolation, answers, brdf_xyz};
use diffraction_build::accuracy::directions::floor_per_sr;
use diffraction_build::ground::metrics;
use diffraction_build::ground::sampling::{Region, direction_pairs};
use diffraction_build::tables::model::TableSet;

/// Directions over the hemisphere, and again around the mirror direction.
const DIRECTIONS: usize = 2048;

/// How far colours and values moved.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ColourChange {
    /// Directions that both versions answer for.
    pub directions: usize,
    /// Median and largest CIEDE2000, beside a matt white in the same light; 0 where nothing is compared.
    pub delta_e: [f64; 2],
    /// Where it is largest: theta_i, phi_i, theta_r, phi_r in degrees.
    pub at_deg: [f64; 4],
    /// Median and largest change relative to the first version, where that is not dark: of Y over Y, of X and Z over their sum.
    pub relative: [f64; 2],
}

/// Compares two sets of tables at the same directions.
pub(super) fn colour_change(a: &TableSet, b: &TableSet) -> ColourChange {
    let look_up = Interpolation::Bilinear;
    let mut pairs = direction_pairs(Region::Hemisphere, DIRECTIONS);
    pairs.extend(direction_pairs(Region::NearSpecular, DIRECTIONS));
    pairs.retain(|&(wi, wo)| answers(a, look_up, wi, wo) && answers(b, look_up, wi, wo));
    let values =
        |set: &TableSet| -> Vec<Xyz> { pairs.par_iter().map(|&(wi, wo)| brdf_xyz(set, look_up, wi, wo)).collect() };
    let (a_values, b_values) = (values(a), values(b));
    // A matt white of albedo 1 has the BRDF 1/π.
    let map = metrics::ciede2000_map(&image(&a_values), &image(&b_values), 1.0 / PI);
    let largest = map.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)).map_or(0, |(index, _)| index);
    let delta_e = metrics::quantiles(map.iter().map(|&difference| f64::from(difference)).collect());
    let luminances: Vec<f64> = a_values.iter().map(|xyz| xyz[1]).collect();
    let floor = floor_per_sr(a.front_factor.material, &luminances);
    let relative = metrics::colour_error_quantiles(&a_values, &b_values, floor);
    ColourChange {
        directions: pairs.len(),
        delta_e: [delta_e.p50, delta_e.worst],
        at_deg: pairs.get(largest).map_or([0.0; 4], angles_of),
        relative: [relative.p50, relative.worst],
    }
}

fn angles_of(&(wi, wo): &(Vec3, Vec3)) -> [f64; 4] {
    let ([theta_i, phi_i], [theta_r, phi_r]) = (angles_deg(wi), angles_deg(wo));
    [theta_i, phi_i, theta_r, phi_r]
}

/// Values as the one row of an image.
fn image(values: &[Xyz]) -> Array3<f32> {
    Array3::from_shape_fn((1, values.len(), 3), |(_, index, channel)| values[index][channel] as f32)
}
