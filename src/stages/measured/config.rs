//! What a specimen's measured reflectance is compared with: its file, and the instrument.

use std::path::PathBuf;

use super::kind::Kind;

/// The file, and what the instrument averaged over.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct MeasuredConfig {
    /// The file; see [`super::read()`].
    pub file: PathBuf,
    /// Full angle of the cone that the detector collects, uniformly; 0 for a single direction.
    pub acceptance_deg: f64,
    /// Full width at half maximum of the triangular slit function; 0 for a single wavelength.
    pub bandwidth_nm: f64,
    /// What a spectrometer's own file does not say; `None` for a CSV file that says it all.
    pub export: Option<ExportConfig>,
}

/// What the values of a spectrometer's export are: one spectrum in one geometry.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct ExportConfig {
    /// theta_i, phi_i, theta_r, phi_r in degrees.
    pub angles_deg: [f64; 4],
    /// What its values are.
    pub kind: Kind,
    /// Whether they are in per cent.
    pub percent: bool,
    /// Reflectance of the white that they are relative to, by which they are multiplied.
    pub white_reflectance: f64,
    /// The column of values, by its name or its number from 1, where there are several.
    pub column: Option<String>,
}
