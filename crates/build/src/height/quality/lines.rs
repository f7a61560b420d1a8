//! Scan lines that are offset against each other.

use super::finding::{Fault, Finding, Remedy};
use super::prepared::Prepared;
use crate::height::prepare::robust::{median, sigma_about};

/// Least standard deviation of the offsets that is told, in rms heights: as its square, a thousandth of the scattered light lies in a streak. Good
/// scans by two instruments have 0.011 and 0.008.
const OFFSET_MIN: f64 = 0.03;

/// Least ratio of the power of what is constant along the lines to that of what nearly is. It is 1 of surfaces, with a chance of 1e-6 of 10
/// over eight frequencies.
const RATIO_MIN: f64 = 10.0;

/// Least ratio of geometric to arithmetic mean of the powers at high frequencies, which is 0.56 of independent offsets; of gratings
/// along the lines it is near 0.
const FLATNESS_MIN: f64 = 0.2;

/// Fewest lines and samples of each that tell.
const SIZE_MIN: usize = 32;

/// Frequencies along the line beside that of what is constant along it, beyond the reach of the Hann window.
const BESIDE: std::ops::Range<i64> = 3..12;

/// Tells offsets of 3 % of the rms height. Two estimates have to agree: the power at the highest frequencies across the lines, which a
/// band-limited structure leaves empty and a single step fills, and the median change between neighbours, which single steps do not
/// change.
pub(super) fn check(prepared: &Prepared) -> Option<Finding> {
    let [nx, ny] = prepared.field.size();
    if nx < SIZE_MIN || ny < SIZE_MIN {
        return None;
    }
    let (frequencies, spectrum) = ((3 * ny as i64 / 8)..=(ny as i64 / 2), &prepared.spectrum);
    let mut constant: Vec<f64> = frequencies.clone().map(|y| spectrum.power([0, y])).collect();
    let mut beside: Vec<f64> =
        frequencies.flat_map(|y| BESIDE.flat_map(move |x| [spectrum.power([x, y]), spectrum.power([-x, y])])).collect();
    let count = constant.len() as f64;
    let mean = constant.iter().sum::<f64>() / count;
    let flatness = (constant.iter().map(|power| power.max(f64::MIN_POSITIVE).ln()).sum::<f64>() / count).exp() / mean;
    // A Hann window's squares have a sum of 1.5 over the number of lines.
    let by_power_nm = (mean * ny as f64 / 1.5).sqrt();
    let offset_nm = by_power_nm.min(by_changes(prepared));
    let ratio = median(&mut constant) / median(&mut beside);
    let is_told = offset_nm > OFFSET_MIN * prepared.rms_nm && ratio > RATIO_MIN && flatness > FLATNESS_MIN;
    is_told.then(|| Finding {
        fault: Fault::LineOffsets,
        in_short: format!("lines offset by {offset_nm:.1} nm"),
        sentence: format!(
            "Scan lines are offset against each other by {offset_nm:.1} nm rms, {:.0} % of the rms height, which shows as a streak of light across \
             the lines. `level = \"rows\"` gives each line its own offset.",
            100.0 * offset_nm / prepared.rms_nm
        ),
        remedy: Some(Remedy::Rows),
    })
}

/// Standard deviation in nm of independent offsets, from how the median step from line to line changes: that has six times their
/// variance.
fn by_changes(prepared: &Prepared) -> f64 {
    let heights = &prepared.levelled.heights_nm;
    let steps: Vec<f64> = (1..heights.nrows())
        .map(|row| {
            let mut steps: Vec<f64> = heights.row(row).iter().zip(heights.row(row - 1)).map(|(a, b)| a - b).collect();
            median(&mut steps)
        })
        .collect();
    let changes: Vec<f64> = steps.windows(2).map(|pair| pair[1] - pair[0]).collect();
    sigma_about(0.0, &changes) / 6f64.sqrt()
}
