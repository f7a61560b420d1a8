//! What a specimen's measured reflectance is compared with: its file, and the instrument.

use std::path::PathBuf;

/// The file, and what the instrument averaged over.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct MeasuredConfig {
    /// CSV file; see [`super::read()`].
    pub file: PathBuf,
    /// Full angle of the cone that the detector collects, uniformly; 0 for a single direction.
    pub acceptance_deg: f64,
    /// Full width at half maximum of the triangular slit function; 0 for a single wavelength.
    pub bandwidth_nm: f64,
}
