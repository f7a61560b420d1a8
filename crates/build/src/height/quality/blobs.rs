//! Spikes and pieces of dust.

use super::finding::{Fault, Finding, Remedy};
use crate::height::HeightField;
use crate::height::prepare::blobs::blobs;

/// Tells what rises beyond the middle 98 % of all heights by two and a half times their range, as long as it takes less than a hundredth
/// of the samples (`prepare::blobs`).
pub(super) fn check(levelled: &HeightField) -> Option<Finding> {
    let found = blobs(&levelled.heights_nm);
    if found.count == 0 {
        return None;
    }
    let pieces = format!("{} spike{} or dust", found.count, if found.count == 1 { "" } else { "s" });
    let [dx, dy] = levelled.pitch_nm;
    let size_nm = (found.largest as f64 * dx * dy).sqrt();
    let [row, column] = found.farthest;
    let share = 100.0 * (1.0 - found.rest_nm / found.range_nm);
    Some(Finding {
        fault: Fault::Blobs,
        in_short: pieces.clone(),
        sentence: format!(
            "{pieces}, the largest of {} sample{} ({size_nm:.0} nm wide), the farthest at column {column}, row {row}, take {share:.0} % of the range \
             of heights ({:.1} of {:.1} nm): computing takes as many times longer. `despike = {{ threshold_rms = 8 }}` masks them and \
             fills them in.",
            found.largest,
            if found.largest == 1 { "" } else { "s" },
            found.range_nm - found.rest_nm,
            found.range_nm,
        ),
        remedy: Some(Remedy::Despike),
    })
}
