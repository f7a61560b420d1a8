//! Numbers that stand for missing samples without being declared.

use super::finding::{Fault, Finding, Remedy};
use crate::height::HeightField;
use crate::height::prepare::range_nm;

/// Numbers that programs write where there is no measurement.
const CUSTOMARY: [f64; 8] = [-9999.0, -99999.0, -999.0, -32768.0, -32767.0, 32767.0, 65535.0, -1e6];

/// Nanometres in the units that files are written in: pm, Å, nm, µm, mm, m.
const UNITS_NM: [f64; 6] = [1e-3, 0.1, 1.0, 1e3, 1e6, 1e9];

/// Largest share in percent that is filled in by default.
const SHARE_MAX: f64 = 5.0;

/// Fewest samples that share a number which is no customary one.
const COPIES_MIN: usize = 4;

/// A mark lies farther from all other heights than these reach, and is a customary number, or the same in several samples. No
/// surface has four samples with equal heights above its own range.
pub(super) fn check(read: &HeightField) -> Option<Finding> {
    let (low, high) = range_nm(read);
    [low, high].into_iter().find_map(|extreme_nm| {
        let copies = read.heights_nm.iter().filter(|height| **height == extreme_nm).count();
        let others = read.heights_nm.iter().filter(|height| **height != extreme_nm);
        let (rest_low, rest_high) = others.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)));
        let gap_nm = (extreme_nm - rest_high).max(rest_low - extreme_nm);
        let customary = customary(extreme_nm);
        let is_mark = gap_nm > rest_high - rest_low && (customary.is_some() || copies >= COPIES_MIN);
        // Of a surface of two levels neither is a mark.
        (is_mark && rest_high > rest_low).then(|| finding(extreme_nm, copies, customary, read))
    })
}

fn finding(extreme_nm: f64, copies: usize, customary: Option<f64>, read: &HeightField) -> Finding {
    let share = 100.0 * copies as f64 / read.heights_nm.len() as f64;
    let what = format!(
        "{copies} sample{} ({share:.2} %) hold {} {extreme_nm} nm, far from all other heights: probably a mark for missing samples.",
        if copies == 1 { "" } else { "s" },
        if copies == 1 { "the number" } else { "the same number" },
    );
    let fix = match customary {
        Some(value) => format!("`missing_value = {value}` has them filled in from their surroundings."),
        None => {
            "`missing_value = N`, N being the number in the file, has them filled in from their surroundings.".into()
        }
    };
    Finding {
        fault: Fault::NoData,
        in_short: format!("{copies} samples hold a mark for missing ones"),
        sentence: format!("{what} {fix}"),
        remedy: customary.filter(|_| share <= SHARE_MAX).map(Remedy::MissingValue),
    }
}

/// The customary number that a height is in some unit.
pub(super) fn customary(height_nm: f64) -> Option<f64> {
    // Single precision rounds to 6e-8.
    let is = |value: f64| UNITS_NM.iter().any(|unit_nm| (height_nm / (value * unit_nm) - 1.0).abs() < 1e-6);
    CUSTOMARY.into_iter().find(|value| is(*value))
}
