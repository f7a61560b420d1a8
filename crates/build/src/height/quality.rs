//! What is wrong with a scan, in the user's words, and which setting mends it.
//!
//! Each check says in its file from which size on it finds its fault, and why good surfaces do not raise it.

mod advice;
mod blobs;
mod hum;
mod lines;
mod lost;
mod marks;
mod saturation;
mod scars;
mod shape;
mod steps;
mod verdict;

use serde::{Deserialize, Serialize};

use super::prepare::lost_lines::lost_lines;
use super::prepare::repair::{levelled, rms_nm};
use super::statistics::spectrum::Spectrum;
use crate::height::HeightField;

pub use self::advice::{Advice, advise};
pub use self::verdict::{Grade, Verdict, scan_verdict};

/// A kind of fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Fault {
    /// Scan lines without a measurement.
    LostLines,
    /// A number that stands for missing samples.
    NoData,
    /// Heights cut off at the end of the range.
    Saturation,
    /// Spikes and pieces of dust.
    Blobs,
    /// A plane so steep that it matters.
    Tilt,
    /// A bowl that is the scanner's rather than the surface's.
    Bow,
    /// Lines that are offset against each other.
    LineOffsets,
    /// Streaks along the fast axis.
    Scars,
    /// A step from one side of the scan to the other.
    Step,
    /// A regular disturbance from line to line.
    Hum,
}

/// What mends a fault: keys of a specimen.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Remedy {
    /// `missing_value`: the number, in the file's own.
    MissingValue(f64),
    /// `crop`: columns and rows that are kept, as first column, first row, width, height.
    Crop([usize; 4]),
    /// `despike`.
    Despike,
    /// `level = "plane"`.
    Plane,
    /// `level = "rows"`.
    Rows,
    /// `level = "quadratic"`.
    Quadratic,
}

impl Remedy {
    /// As it is written in a manifest.
    pub fn toml(&self) -> String {
        match self {
            Self::MissingValue(value) => format!("missing_value = {value}"),
            Self::Crop([x, y, width, height]) => format!("crop = [{x}, {y}, {width}, {height}]"),
            Self::Despike => "despike = { threshold_rms = 8 }".into(),
            Self::Plane => "level = \"plane\"".into(),
            Self::Rows => "level = \"rows\"".into(),
            Self::Quadratic => "level = \"quadratic\"".into(),
        }
    }
}

/// A fault that was found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// What it is.
    pub fault: Fault,
    /// It in a few words, for a verdict: "dust: 1 piece".
    pub in_short: String,
    /// It in a whole sentence, with what to do.
    pub sentence: String,
    /// What mends it, if anything does short of scanning anew.
    pub remedy: Option<Remedy>,
}

/// What the checks share of a prepared scan, worked out once.
struct Prepared<'a> {
    /// The heights as they were prepared.
    field: &'a HeightField,
    /// The same about their best plane.
    levelled: HeightField,
    /// Root mean square in nm of the latter, above 0.
    rms_nm: f64,
    /// Their power spectrum under a Hann window.
    spectrum: Spectrum,
}

/// What is wrong with a scan as it was read and with the same after preparing.
///
/// Lost lines, marks for missing samples and cut-off heights are told by equal numbers, which preparing changes, so they are looked for in
/// `read`; where the first two are found, nothing else is looked for, since they would be mistaken for other faults, and likewise with dust.
pub fn findings(read: &HeightField, prepared: &HeightField) -> Vec<Finding> {
    let lost = lost_lines(&read.heights_nm);
    let mut found: Vec<Finding> = lost::check(read, &lost).into_iter().chain(marks::check(read)).collect();
    found.extend(saturation::check(read, &lost));
    // Lines that were filled in are lost no more.
    let is_hidden = found.iter().any(|finding| finding.fault == Fault::NoData)
        || lost_lines(&prepared.heights_nm).iter().any(|lost| *lost);
    let levelled = levelled(prepared);
    let rms_nm = rms_nm(&levelled);
    let (low, high) = super::prepare::range_nm(prepared);
    // Below 1e-12 of the heights' size there is rounding only.
    if is_hidden || rms_nm <= 1e-12 * low.abs().max(high.abs()) {
        return found;
    }
    if let Some(finding) = blobs::check(&levelled) {
        found.push(finding);
        return found;
    }
    let prepared = Prepared { field: prepared, spectrum: Spectrum::new(&levelled), levelled, rms_nm };
    let bow = shape::bow(&prepared);
    found.extend(shape::tilt(read, prepared.field));
    found.extend(bow);
    found.extend(lines::check(&prepared));
    found.extend(scars::check(&prepared));
    found.extend(steps::check(&prepared));
    found.extend(hum::check(&prepared));
    found
}

#[cfg(test)]
mod tests;
