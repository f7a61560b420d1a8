//! All checks, in the order in which faults hide each other.

use super::finding::{Fault, Finding};
use super::prepared::Prepared;
use super::{blobs, hum, lines, lost, marks, pixels, saturation, scars, shape, steps};
use crate::height::HeightField;
use crate::height::prepare::lost_lines::lost_lines;
use crate::height::prepare::range_nm;
use crate::height::prepare::repair::{levelled, rms_nm};
use crate::height::statistics::spectrum::Spectrum;

/// What is wrong with a scan as it was read and with the same after preparing.
///
/// Lost lines, marks for missing samples and cut-off heights are told by equal numbers, which preparing changes, so they are looked for in
/// `read`; where the first two are found, nothing else is looked for, since they would be mistaken for other faults, and likewise with dust.
pub fn findings(read: &HeightField, prepared: &HeightField) -> Vec<Finding> {
    let lost = lost_lines(&read.heights_nm);
    let mut found: Vec<Finding> = lost::check(read, &lost).into_iter().chain(marks::check(read)).collect();
    found.extend(saturation::check(read, &lost));
    found.extend(pixels::check(read));
    // Lines that were filled in are lost no more.
    let is_hidden = found.iter().any(|finding| finding.fault == Fault::NoData)
        || lost_lines(&prepared.heights_nm).iter().any(|lost| *lost);
    let levelled = levelled(prepared);
    let rms_nm = rms_nm(&levelled);
    let size_nm =
        [read, prepared].into_iter().map(range_nm).map(|(low, high)| low.abs().max(high.abs())).fold(0.0, f64::max);
    // Below 1e-12 of the heights' size, as they were before levelling too, there is rounding only.
    if is_hidden || rms_nm <= 1e-12 * size_nm {
        return found;
    }
    if let Some(finding) = blobs::check(&levelled) {
        found.push(finding);
        return found;
    }
    let prepared = Prepared { field: prepared, spectrum: Spectrum::new(&levelled), levelled, rms_nm };
    // Where lines are lost, their end is a step, and what was filled in looks like a scar.
    let has_lost = lost.iter().any(|lost| *lost);
    let step = if has_lost { None } else { steps::check(&prepared) };
    found.extend(shape::tilt(read, prepared.field));
    // Two levels bend the surface through them.
    if step.is_none() {
        found.extend(shape::bow(&prepared));
    }
    found.extend(lines::check(&prepared));
    if !has_lost {
        found.extend(scars::check(&prepared));
    }
    found.extend(step);
    found.extend(hum::check(&prepared));
    found
}
