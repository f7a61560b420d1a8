//! Whether tables that were built have texels enough for their tolerance, told from two kinds of look-ups between them.
//!
//! Where texels resolve what tables hold, Lagrange's cubic errs nine times as much as the spline through the same values
//! (`3/128` and `1/384` of the fourth derivative): so what the two differ by is eight times the spline's error, and no reference
//! is needed to tell it.

use rayon::prelude::*;

use super::directions::{ErrorDirections, ErrorGroup};
use crate::ground::metrics::colour_error_quantiles;
use crate::tables::look_ups::LookUp;
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

/// Texels a side that keep the tolerance, given what splines err by on so many.
pub fn wanted(spline_error: f64, tolerance: f64, size: usize) -> usize {
    LookUp::Spline.size_for(SHARE * tolerance, size, ROOM * spline_error)
}

/// Room for an error that is told from two look-ups, and not measured.
const ROOM: f64 = 1.5;

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tables::model::Basis;
    use diffraction_brdf::direction::{Vec3, wave_vector_change};
    use diffraction_brdf::{Factor, FrontFactor, Material};
    use ndarray::Array3;

    /// Lines of the deviation 0.05 in (u, v) that stand apart, over a faint ground.
    fn power([u, v, _]: Vec3) -> f64 {
        let line = |k: i32| {
            let [x, y] = [u - 0.45 * f64::from(k), v - 0.2 * f64::from(k)].map(|x| x / 0.05);
            (-0.5 * (x * x + y * y)).exp()
        };
        1e-4 + (-4..=4).map(line).sum::<f64>()
    }

    fn set(size: usize) -> TableSet {
        let at = |index: usize| 4.0 * index as f64 / (size - 1) as f64 - 2.0;
        let table =
            Array3::from_shape_fn((size, size, 3), |(row, column, _)| power([at(column), -at(row), 0.0]) as f32);
        TableSet {
            basis: Basis::Chebyshev,
            tables: vec![table],
            lobe: None,
            prefilter_width: 0.0,
            front_factor: FrontFactor { material: Material::Ideal, shadowing: false, factor: Factor::Scalar },
            restriction: None,
            usable_radius: 2.0,
        }
    }

    /// What splines err by, known from the lines themselves.
    fn exact_error(set: &TableSet) -> f64 {
        let ErrorDirections { groups, pairs } = ErrorDirections::of_regions(set);
        let values: Vec<[Xyz; 2]> = pairs
            .iter()
            .map(|&(wi, wo)| {
                let exact = set.front_factor.diffuse(wi, wo) * power(wave_vector_change(wi, wo));
                [[exact; 3], brdf_xyz(set, Interpolation::Spline, wi, wo)]
            })
            .collect();
        CUBIC_OVER_SPLINE * largest_of(&groups, &values)
    }

    #[test]
    fn two_look_ups_tell_what_one_errs_by() {
        for size in [161, 241] {
            let set = set(size);
            let (told, exact) = (spline_error(&set), exact_error(&set));
            assert!((0.4..2.5).contains(&(told / exact)), "{size}: {told:e} for {exact:e}");
        }
        let [few, many] = [121, 341].map(|size| spline_error(&set(size)));
        assert!(!suffice(few, 1e-3) && suffice(many, 1e-3), "{few:e} {many:e}");
    }
}
