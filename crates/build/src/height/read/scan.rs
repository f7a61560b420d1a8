//! A calibrated scan: its heights, and where they come from.

use serde::{Deserialize, Serialize};

use crate::height::HeightField;

/// Where a height field comes from and how its numbers were understood.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Provenance {
    /// The file's name without its folder.
    pub file_name: String,
    /// SHA-256 of the whole file, hexadecimal.
    pub sha256: String,
    /// The format's name, such as "ImageJ TIFF", "JPK TIFF", "Gwyddion" or "Nanoscope".
    pub format: String,
    /// The page read, counted from 0.
    pub page: usize,
    /// Type of the stored samples: "u8" to "u32", "i8" to "i32", "f16", "f32", "f64".
    pub sample_format: String,
    /// Samples along x and y.
    pub size: [usize; 2],
    /// Sample spacing in nm along x and y.
    pub pitch_nm: [f64; 2],
    /// Who said so: "file: ...", or the caller: "manifest: pitch_nm".
    pub pitch_from: String,
    /// Who gave the numbers their meaning: "file: ...", or the caller: "manifest: height".
    pub height_from: String,
    /// Samples that were missing and have been filled in.
    pub missing_samples: usize,
    /// The channel's name, where the file gives one.
    pub channel: Option<String>,
    /// By how much the fast scan axis was turned against the instrument's x, counterclockwise in degrees, where the file says. The
    /// heights are in the scan's own axes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angle_deg: Option<f64>,
    /// What a careful user wants to know: overruled or contradictory statements, filled samples.
    pub warnings: Vec<String>,
}

/// A calibrated scan.
#[derive(Debug, Clone, PartialEq)]
pub struct Scan {
    /// Heights in nm, none missing.
    pub field: HeightField,
    /// Where they come from.
    pub provenance: Provenance,
}
