//! What a comparison with measured reflectance found, as plain data.

use serde::{Deserialize, Serialize};

use super::kind::Kind;
use diffraction_build::ground::null_for_nan;

/// One specimen's comparison.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MeasuredResult {
    /// The file, relative to the manifest where it lies below it.
    pub file: String,
    /// Rows of the file.
    pub rows: usize,
    /// Full angle of the detector's cone.
    pub acceptance_deg: f64,
    /// Full width at half maximum of the slit.
    pub bandwidth_nm: f64,
    /// Most directions and wavelengths that one row is averaged over.
    pub samples: [usize; 2],
    /// What a reader must know.
    pub notes: Vec<String>,
    /// One entry per column of values.
    pub columns: Vec<MeasuredColumn>,
}

/// One column of values against the model.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MeasuredColumn {
    /// Its name in the file.
    pub name: String,
    /// What its values are.
    pub kind: Kind,
    /// Values compared.
    pub values: usize,
    /// `|model - measured| / |measured|` over all values, the model times `scale`.
    #[serde(with = "null_for_nan")]
    pub relative_l2: f64,
    /// Pearson's correlation.
    #[serde(with = "null_for_nan")]
    pub correlation: f64,
    /// What the model is multiplied by: 1 unless the kind is relative.
    #[serde(with = "null_for_nan")]
    pub scale: f64,
    /// `Σ model measured / Σ model²`: the factor on the model that would fit best.
    #[serde(with = "null_for_nan")]
    pub best_scale: f64,
    /// Spectra and angular scans that the rows form.
    pub curves: Vec<CurveResult>,
}

/// Values along one coordinate, everything else fixed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CurveResult {
    /// The coordinate: `wavelength_nm` or an angle's column.
    pub along: String,
    /// theta_i, phi_i, theta_r, phi_r in degrees; the one that varies has its first value.
    pub angles_deg: [f64; 4],
    /// Wavelength in nm; the first one of a spectrum.
    pub wavelength_nm: f64,
    /// The coordinate, ascending; repeated measurements are averaged.
    pub at: Vec<f64>,
    /// Measured values.
    pub measured: Vec<f64>,
    /// The model's, scaled.
    pub model: Vec<f64>,
    /// As for the column.
    #[serde(with = "null_for_nan")]
    pub relative_l2: f64,
    /// As for the column.
    #[serde(with = "null_for_nan")]
    pub correlation: f64,
    /// Full width at half maximum of the Gaussian that both were smoothed with for their peaks, in the curve's coordinate.
    #[serde(default)]
    pub smoothing: f64,
    /// Number of peaks, measured and model.
    pub peak_counts: [usize; 2],
    /// Peaks that belong together.
    pub peaks: Vec<PeakPair>,
}

/// A peak in both curves.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PeakPair {
    /// Where it is in the measurement, in the curve's coordinate.
    pub measured: f64,
    /// Where it is in the model.
    pub model: f64,
    /// How far it stands out in both, as shares of the curves' ranges.
    #[serde(default)]
    pub prominence: [f64; 2],
}
