//! Measured reflectance against the model: the file, the model as the instrument sees it, the figures.
//!
//! The model is the BRDF at each wavelength from the spectral tables, or straight from the scan where there are none that answer.

mod compare;
mod config;
mod export;
mod figures;
mod jcamp;
pub mod kind;
mod measurement;
pub mod model;
mod peaks;
pub mod read;

pub use config::{ExportConfig, MeasuredConfig};
pub use figures::{CurveResult, MeasuredColumn, MeasuredResult, PeakPair};
pub use measurement::Measurement;
pub use read::read;

use diffraction_brdf::SpectralTables;
use diffraction_brdf::error::Result;
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::OpticsConfig;

/// Compares a specimen with its measurement, by its spectral tables where there are some; `file` is the name for the report.
///
/// # Errors
/// A scan too small for the window, or more transforms or evaluations than allowed.
pub fn compare(
    fields: &[HeightField],
    optics: &OpticsConfig,
    tables: Option<&SpectralTables>,
    measurement: &Measurement,
    file: String,
    memory_bytes: u64,
) -> Result<MeasuredResult> {
    let modelled = model::modelled(fields, optics, tables, measurement, memory_bytes)?;
    Ok(compare::figures(measurement, &modelled, file))
}
