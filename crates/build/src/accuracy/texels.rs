//! Whether tables that were built have texels enough for their tolerance, told from two kinds of look-ups between them.
//!
//! Where texels resolve what tables hold, Lagrange's cubic errs nine times as much as the spline through the same values
//! (`3/128` and `1/384` of the fourth derivative): so what the two differ by is eight times the spline's error, and no reference
//! is needed to tell it.

use rayon::prelude::*;

use super::directions::{ErrorDirections, ErrorGroup};
use crate::ground::metrics::colour_error_quantiles;
use crate::tables::model::TableSet;
use diffraction_brdf::Splines;
use diffraction_brdf::direction::Xyz;
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz, brdf_xyz_by_splines};

/// What cubic look-ups differ from splines by, in errors of the spline.
pub(super) const CUBIC_OVER_SPLINE: f64 = 8.0;

/// Share of the tolerance that look-ups may take: what the basis with a half and storage with 0.7 of it leave, errors adding as squares.
const SHARE: f64 = 0.5;

/// Whether spline look-ups keep the tolerance, with room for the other causes of error.
pub fn suffice(spline_error: f64, tolerance: f64) -> bool {
    spline_error <= SHARE * tolerance
}

/// What spline look-ups in tables for every direction err by in 95 of 100 lit directions, the largest of the regions; 0 where
/// nothing is lit.
pub fn spline_error(set: &TableSet) -> f64 {
    let ErrorDirections { groups, pairs } = ErrorDirections::of_regions(set);
    let splines = Splines::new(&set.tables);
    let values: Vec<[Xyz; 2]> = pairs
        .par_iter()
        .map(|&(wi, wo)| [brdf_xyz_by_splines(set, &splines, wi, wo), brdf_xyz(set, Interpolation::Cubic, wi, wo)])
        .collect();
    largest_of(&groups, &values)
}

/// The largest of the groups' errors, whose `[spline, cubic]` values stand one group after the other.
pub(super) fn largest_of(groups: &[ErrorGroup], values: &[[Xyz; 2]]) -> f64 {
    let mut start = 0;
    let of_group = |group: &ErrorGroup| {
        let range = start..start + group.len();
        start = range.end;
        let [spline, cubic] =
            [0, 1].map(|kind| values[range.clone()].iter().map(|pair| pair[kind]).collect::<Vec<_>>());
        let found = colour_error_quantiles(&spline, &cubic, group.floor_per_sr);
        if found.count == 0 { 0.0 } else { found.p95 / CUBIC_OVER_SPLINE }
    };
    groups.iter().map(of_group).fold(0.0, |largest, error| if error.is_nan() { f64::NAN } else { largest.max(error) })
}
