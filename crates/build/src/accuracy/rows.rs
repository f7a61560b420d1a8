//! Measured errors of a specimen's tables: in total, and each cause by itself.
//!
//! A number that could not be determined is NaN in memory and `null` in JSON.

use std::ops::Range;

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::directions::{ErrorGroup, Group};
use super::reference::Reference;
use crate::ground::metrics;
use crate::ground::null_for_nan;
use crate::tables::look_ups::LookUp;
use crate::tables::model::{Basis, TableSet};
use diffraction_brdf::direction::{Vec3, Xyz, wave_vector_change};
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz, diffuse_window_power};

/// Pairs at which the reference is held against the direct sum.
const DIRECT_PAIRS: usize = 2;

/// What an error comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Cause {
    /// Everything together, linear look-ups. Files say "total", as they always have.
    Total,
    /// Everything together, cubic look-ups.
    #[serde(rename = "total, cubic look-up")]
    TotalCubic,
    /// Everything together, look-ups by splines: what `FORMAT.md` describes, and what the tolerance bounds. Of tables for every
    /// direction alone.
    #[serde(rename = "total, spline look-up")]
    TotalSpline,
    /// Wavelengths summed at steps.
    #[serde(rename = "wavelength step")]
    WavelengthStep,
    /// As many basis functions in `w` as there are tables.
    Basis,
    /// Look-ups between texels: by splines where they are what `FORMAT.md` describes, else linear ones.
    Grid,
    /// Rounding of stored values.
    Storage,
    /// One front factor for all wavelengths, where the material's index depends on them; tables hold the colour at normal
    /// incidence, that of the lobe exactly.
    #[serde(rename = "front factor at one wavelength")]
    OneWavelength,
    /// None of the tables': the scan against every second sample of itself.
    #[serde(rename = "sampling of the scan")]
    Sampling,
    /// None of the tables': the reference itself, against the direct sum. Files say it as they always have.
    #[serde(rename = "yardstick against direct sum")]
    Reference,
}

impl Cause {
    /// Plain name for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::Total => "total, linear look-up",
            Self::TotalCubic => "total, cubic look-up",
            Self::TotalSpline => "total, spline look-up",
            Self::WavelengthStep => "wavelength step",
            Self::Basis => "basis",
            Self::Grid => "grid",
            Self::Storage => "storage",
            Self::OneWavelength => "front factor at one wavelength",
            Self::Sampling => "sampling of the scan",
            Self::Reference => "reference against direct sum",
        }
    }
}

impl std::fmt::Display for Cause {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(self.name())
    }
}

/// Errors of the stored tables against the reference, over directions of one region.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ErrorRow {
    /// Which error.
    #[serde(rename = "what")]
    pub cause: Cause,
    /// Which directions.
    #[serde(rename = "region")]
    pub group: Group,
    /// Directions compared pointwise: those that the reference has above the floor.
    pub directions: usize,
    /// Luminance in 1/sr up to which a direction does not count pointwise.
    #[serde(default = "floor_of_older_reports")]
    pub floor_per_sr: f64,
    /// Share of the group in which the tables show more than half of the floor.
    #[serde(default, rename = "lit_share", with = "null_for_nan")]
    pub share_above: f64,
    /// Directions evaluated in which they do not.
    #[serde(default, rename = "dark_directions")]
    pub directions_below: usize,
    /// Those of them that the reference has above the floor: light that the tables miss.
    #[serde(default)]
    pub missed_directions: usize,
    /// Most of luminance in 1/sr that the reference leaves out in any of the group's directions, since its windows' kernels end
    /// ([`left_out_per_sr`](crate::optics::left_out::left_out_per_sr)); `None` where that is not bounded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub left_out_per_sr: Option<f64>,
    /// Root of the summed squared differences of X, Y and Z over the root of the summed squares, over the whole group: directions
    /// above and below the floor count by the share of it that they stand for.
    #[serde(with = "null_for_nan")]
    pub relative_l2: f64,
    /// Median relative error: the largest of Y's over Y and of those of X and Z over X + Y + Z (see
    /// [`metrics::colour_error_quantiles`]).
    #[serde(with = "null_for_nan")]
    pub p50: f64,
    /// Its 95th percentile.
    #[serde(with = "null_for_nan")]
    pub p95: f64,
    /// Its 99th percentile.
    #[serde(with = "null_for_nan")]
    pub p99: f64,
    /// Its maximum.
    #[serde(with = "null_for_nan")]
    pub worst: f64,
}

impl ErrorRow {
    /// Whether it breaks the tolerance. Only the causes that the tolerance governs can: what a reader gets with the look-up that
    /// `FORMAT.md` describes, and the parts of it that no look-up changes.
    pub fn is_over(&self, tolerance: f64) -> bool {
        matches!(self.cause, Cause::TotalSpline | Cause::Basis | Cause::WavelengthStep) && self.p95 > tolerance
    }
}

/// The cause of rows that hold what a reader gets: with splines where there are such rows, else with linear look-ups, as older atlases
/// and tables restricted to scenes have them.
pub fn promised(rows: &[ErrorRow]) -> Cause {
    let has_splines = rows.iter().any(|row| row.cause == Cause::TotalSpline);
    if has_splines { Cause::TotalSpline } else { Cause::Total }
}

/// What reports had before they told: a few millionths of white.
fn floor_of_older_reports() -> f64 {
    1e-6
}

/// Error rows of the stored tables (as read back) and of the tables before rounding.
pub fn error_rows(reference: &Reference, stored: &TableSet, built: &TableSet) -> Vec<ErrorRow> {
    let mut start = 0;
    let of_group = |group: &ErrorGroup| {
        let range = start..start + group.len();
        start = range.end;
        rows_of(group, reference, range, [stored, built])
    };
    reference.groups.iter().flat_map(of_group).collect()
}

/// The rows of everything together alone, group by group, at the pairs of [`ErrorDirections`](super::directions::ErrorDirections)
/// and what the surface does there.
pub fn totals(groups: &[ErrorGroup], pairs: &[(Vec3, Vec3)], exact: &[Xyz], stored: &TableSet) -> Vec<ErrorRow> {
    let mut start = 0;
    let of_group = |group: &ErrorGroup| {
        let range = start..start + group.len();
        start = range.end;
        let shown =
            |look_up| pairs[range.clone()].par_iter().map(|&(wi, wo)| brdf_xyz(stored, look_up, wi, wo)).collect();
        total_rows(group, &exact[range.clone()], stored.look_up(), shown)
    };
    groups.iter().flat_map(of_group).collect()
}

/// The rows of one group, whose directions stand at `range` of the reference.
fn rows_of(
    group: &ErrorGroup,
    reference: &Reference,
    range: Range<usize>,
    [stored, built]: [&TableSet; 2],
) -> Vec<ErrorRow> {
    let pairs = &reference.pairs[range.clone()];
    let at_pairs = |xyz: &(dyn Fn(Vec3, Vec3) -> Xyz + Sync)| -> Vec<Xyz> {
        pairs.par_iter().map(|&(wi, wo)| xyz(wi, wo)).collect()
    };
    let exact = &reference.xyz[range.clone()];
    let promised = stored.look_up();
    let mut rows = total_rows(group, exact, promised, |look_up| at_pairs(&|wi, wo| brdf_xyz(stored, look_up, wi, wo)));
    // The shares below are those of the diffuse part under interpolation in `w`: a power series keeps neither apart.
    if stored.basis == Basis::Taylor {
        return rows;
    }
    if let Some(as_tables) = reference.as_tables.get(range.clone()).filter(|xyz| !xyz.is_empty()) {
        rows.push(row(Cause::OneWavelength, group, exact, as_tables));
    }
    let front: Vec<f64> = pairs.iter().map(|&(wi, wo)| stored.front_factor.diffuse(wi, wo)).collect();
    let [fine, stepped, interpolated] = [0, 1, 2].map(|i| seen(&reference.diffuse[i][range.clone()], &front));
    let [on_grid, rounded] = [built, stored].map(|set| {
        let power = |wi, wo| diffuse_window_power(set, promised, wave_vector_change(wi, wo));
        seen(&at_pairs(&power), &front)
    });
    let steps = [
        (Cause::WavelengthStep, stepped),
        (Cause::Basis, interpolated),
        (Cause::Grid, on_grid),
        (Cause::Storage, rounded),
    ];
    rows.extend(diffuse_rows(group, fine, steps));
    rows
}

/// Rows of everything together: for the look-up that is promised, where that is by splines, for linear and for cubic ones.
pub(super) fn total_rows(
    group: &ErrorGroup,
    exact: &[Xyz],
    promised: Interpolation,
    found: impl Fn(Interpolation) -> Vec<Xyz>,
) -> Vec<ErrorRow> {
    let kinds = [
        (Cause::TotalSpline, Interpolation::Spline),
        (Cause::Total, Interpolation::Bilinear),
        (Cause::TotalCubic, Interpolation::Cubic),
    ];
    let kinds = kinds.into_iter().filter(|(_, look_up)| *look_up != Interpolation::Spline || promised == *look_up);
    kinds.map(|(cause, look_up)| row(cause, group, exact, &found(look_up))).collect()
}

/// The diffuse part as bright as it is seen, so that one floor counts for all rows.
pub(super) fn seen(diffuse: &[Xyz], front: &[f64]) -> Vec<Xyz> {
    diffuse.iter().zip(front).map(|(xyz, front)| xyz.map(|value| value * front)).collect()
}

/// A row for each cause: the diffuse part with it, against the diffuse part before it came in.
pub(super) fn diffuse_rows(
    group: &ErrorGroup,
    exact: Vec<Xyz>,
    steps: impl IntoIterator<Item = (Cause, Vec<Xyz>)>,
) -> Vec<ErrorRow> {
    let mut before = exact;
    let with_cause = |(cause, values): (Cause, Vec<Xyz>)| {
        let row = row(cause, group, &before, &values);
        before = values;
        row
    };
    steps.into_iter().map(with_cause).collect()
}

/// Pointwise errors of the directions that the reference has above the floor; the norm of all, each with the share of the
/// group that it stands for. What nothing above the floor can tell is NaN.
pub(super) fn row(cause: Cause, group: &ErrorGroup, reference: &[Xyz], test: &[Xyz]) -> ErrorRow {
    let floor = group.floor_per_sr;
    let quantiles = metrics::colour_error_quantiles(reference, test, floor);
    let weights = group.weights();
    let weighed = |values: &[Xyz]| -> Vec<f64> {
        let of = |(xyz, weight): (&Xyz, &f64)| xyz.map(|value| value * weight.sqrt());
        values.iter().zip(&weights).flat_map(of).collect()
    };
    let [above, below] = group.counts;
    let is_above = |xyz: &Xyz| xyz[1].abs() > floor;
    let is_below = |values: &[Xyz]| !values.iter().any(|xyz| is_above(xyz) || xyz[1].is_nan());
    let known = |error: f64| if quantiles.count == 0 { f64::NAN } else { error };
    ErrorRow {
        cause,
        group: group.group.clone(),
        directions: quantiles.count,
        floor_per_sr: floor,
        share_above: group.share_above,
        directions_below: below,
        missed_directions: reference[above..].iter().filter(|xyz| is_above(xyz)).count(),
        left_out_per_sr: group.left_out_per_sr,
        relative_l2: match is_below(reference) && is_below(test) {
            true => f64::NAN,
            false => metrics::relative_l2(&weighed(reference), &weighed(test)),
        },
        p50: known(quantiles.p50),
        p95: known(quantiles.p95),
        p99: known(quantiles.p99),
        worst: known(quantiles.worst),
    }
}

/// The direct sum's XYZ at pairs of directions.
pub(crate) type DirectSum<'a> = &'a dyn Fn(&[(Vec3, Vec3)]) -> Result<Vec<Xyz>>;

/// The reference against the direct sum at the brightest directions of the first group: a grating is below the floor in most of
/// them, and nothing can be compared there. `direct` gives the direct sum's XYZ at pairs of directions.
///
/// # Errors
/// Those of the reference.
pub fn direct_row(reference: &Reference, direct: DirectSum) -> Result<ErrorRow> {
    let Some(group) = reference.groups.first() else {
        return Err(Error::Call("errors are counted on no directions".into()));
    };
    let mut brightest: Vec<usize> = (0..group.len()).collect();
    brightest.sort_by(|&a, &b| reference.xyz[b][1].total_cmp(&reference.xyz[a][1]));
    brightest.truncate(DIRECT_PAIRS);
    let pairs: Vec<(Vec3, Vec3)> = brightest.iter().map(|&index| reference.pairs[index]).collect();
    let direct = direct(&pairs)?;
    let fast: Vec<Xyz> = brightest.iter().map(|&index| reference.xyz[index]).collect();
    let group = ErrorGroup { counts: [brightest.len(), 0], ..group.clone() };
    Ok(row(Cause::Reference, &group, &direct, &fast))
}

/// Most that the reference may differ from the direct sum: beyond, it measures nothing.
const DISAGREEMENT_MAX: f64 = 1e-3;

/// What is wrong with the reference itself, if anything is.
pub fn disagreement(rows: &[ErrorRow]) -> Option<String> {
    let row = rows.iter().find(|row| row.cause == Cause::Reference)?;
    (row.worst > DISAGREEMENT_MAX).then(|| {
        format!(
            "the reference is off the direct sum by {:.1e}, so that measured errors and reference pictures mean nothing: \
             please report this surface",
            row.worst
        )
    })
}

/// A line for each error of tables of this size that breaks the tolerance.
pub fn broken_tolerances(rows: &[ErrorRow], tolerance: f64, size: usize) -> Vec<String> {
    let broken = rows.iter().filter(|row| row.is_over(tolerance));
    let of_grid = |group: &Group| rows.iter().find(|row| row.cause == Cause::Grid && row.group == *group);
    let line = |row: &ErrorRow| {
        let grid = of_grid(&row.group).map_or(0.0, |grid| grid.p95);
        let more = match row.cause == Cause::TotalSpline && grid > 0.5 * row.p95 {
            true => format!("; tables.size = {} would keep it", LookUp::Spline.size_for(tolerance, size, row.p95)),
            false => String::new(),
        };
        format!(
            "the tolerance of {tolerance:.0e} is not kept: {}, {}: one direction in twenty errs by {:.1e} or more{more}",
            row.cause, row.group, row.p95
        )
    };
    broken.map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ground::sampling::Region;

    fn row(worst: f64) -> ErrorRow {
        ErrorRow {
            cause: Cause::Total,
            group: Group::Region(Region::Grazing),
            directions: 3,
            floor_per_sr: 3e-5,
            share_above: 0.5,
            directions_below: 1,
            missed_directions: 0,
            left_out_per_sr: None,
            relative_l2: 1e-6,
            p50: 1e-7,
            p95: 1e-6,
            p99: 1e-6,
            worst,
        }
    }

    #[test]
    fn a_missing_measurement_is_null_and_comes_back_as_nan() {
        for missing in [f64::NAN, f64::INFINITY] {
            let text = serde_json::to_string(&row(missing)).unwrap();
            assert!(text.contains("\"worst\":null"), "{text}");
            let back: ErrorRow = serde_json::from_str(&text).unwrap();
            assert!(back.worst.is_nan());
        }
        let back: ErrorRow = serde_json::from_str(&serde_json::to_string(&row(2e-5)).unwrap()).unwrap();
        assert_eq!(back, row(2e-5));
    }

    #[test]
    fn the_tolerance_governs_the_promised_total_and_what_no_look_up_changes() {
        let over = |cause, p95| ErrorRow { cause, p95, ..row(0.0) };
        let rows = [
            over(Cause::Basis, 2e-3),
            over(Cause::Basis, 1e-3),
            over(Cause::Grid, 2e-3),
            over(Cause::Total, 2e-3),
            over(Cause::WavelengthStep, 0.5),
            over(Cause::TotalSpline, 2e-3),
        ];
        assert_eq!(rows.each_ref().map(|row| row.is_over(1e-3)), [true, false, false, false, true, true]);
        assert_eq!([promised(&rows), promised(&rows[..5])], [Cause::TotalSpline, Cause::Total]);
        let lines = broken_tolerances(&rows, 1e-3, 601);
        assert_eq!(lines.len(), 3);
        // Twice the tolerance, of which the grid is to blame.
        assert!(lines[2].ends_with("; tables.size = 699 would keep it"), "{}", lines[2]);
        assert!(lines[1].contains("1e-3 is not kept: wavelength step, grazing") && lines[1].contains("5.0e-1"));
    }

    #[test]
    fn a_reference_that_is_off_the_direct_sum_is_a_failure() {
        let direct = |worst| vec![ErrorRow { cause: Cause::Reference, ..row(worst) }];
        assert!(disagreement(&direct(1e-6)).is_none() && disagreement(&[]).is_none());
        assert!(disagreement(&direct(0.3)).unwrap().contains("off the direct sum by 3.0e-1"));
    }

    #[test]
    fn files_keep_their_words() {
        let words = |cause: Cause| serde_json::to_value(cause).unwrap();
        let causes =
            [Cause::TotalSpline, Cause::TotalCubic, Cause::WavelengthStep, Cause::Basis, Cause::Grid, Cause::Storage];
        for cause in causes.into_iter().chain([Cause::Sampling]) {
            assert_eq!(words(cause), cause.name());
        }
        assert_eq!([words(Cause::Reference), words(Cause::Total)], ["yardstick against direct sum", "total"]);
        let groups = [Region::Hemisphere, Region::NearSpecular, Region::Grazing].map(Group::Region);
        for (group, text) in groups.into_iter().chain([Group::Scene("a b".into())]).zip([
            "whole hemisphere",
            "near specular",
            "grazing",
            "scene a b",
        ]) {
            assert_eq!(serde_json::to_value(&group).unwrap(), text);
            assert_eq!(serde_json::from_value::<Group>(text.into()).unwrap(), group);
        }
        assert!(serde_json::from_value::<Group>("elsewhere".into()).is_err());
    }
}
