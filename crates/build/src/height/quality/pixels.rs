//! Pixels that are much longer than wide.

use super::finding::{Fault, Finding};
use crate::height::HeightField;

/// Ratio of the pitches from which on it is told: scans with a quarter of the lines are common, with fewer rare.
const RATIO_MIN: f64 = 5.0;

/// Tells pixels five times longer than wide, as a decimal comma makes them: `48,8` are two numbers.
pub(super) fn check(read: &HeightField) -> Option<Finding> {
    let [x, y] = read.pitch_nm;
    let ratio = (x / y).max(y / x);
    let is_plane = read.size().iter().all(|count| *count > 1);
    (is_plane && ratio >= RATIO_MIN).then(|| Finding {
        fault: Fault::Pixels,
        in_short: format!("pixels {ratio:.0} times longer than wide"),
        sentence: format!(
            "Samples are {x} nm apart along x and {y} nm along y, {ratio:.1} times as far. If that is not how it was scanned, correct `pitch_nm`; \
             decimals take a point, for a comma separates x from y."
        ),
        remedy: None,
    })
}
