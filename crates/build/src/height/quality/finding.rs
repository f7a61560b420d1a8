//! Faults of a scan, and the settings that mend them.

use serde::{Deserialize, Serialize};

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
    /// Pixels much longer than wide.
    Pixels,
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

impl Fault {
    /// Whether it is no part of the surface, so that other checks speak of the scan once it is mended.
    pub fn hides_others(self) -> bool {
        matches!(self, Self::LostLines | Self::NoData | Self::Blobs)
    }
}

impl Finding {
    /// Whether it limits what the scan is good for, rather than spoils it.
    pub fn is_limit(&self) -> bool {
        matches!(self.fault, Fault::Tilt | Fault::Pixels)
    }
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
