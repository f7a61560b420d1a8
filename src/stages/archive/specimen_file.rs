//! The file `specimen.json`: where a specimen's tables come from, how to read them, and how good they are.

use std::path::Path;

use diffraction_brdf::energy::EnergyLimit;
use diffraction_brdf::error::Result;
use diffraction_brdf::json;
use diffraction_brdf::specimen::{self, CheckValue, FILE};
use diffraction_brdf::spectral_storage::StoredSpectral;
use diffraction_brdf::storage::StoredTables;
use diffraction_build::accuracy::power_sums::DirectionalAlbedo;
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::optics::pigment::Pigment;
use diffraction_build::tables::model::{BuildRecord, TableSet};
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// Everything about one specimen except the pixels.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SpecimenFile {
    /// Layout version.
    pub schema: u32,
    /// Name in the manifest, and of the folder.
    pub name: String,
    /// Scientific name.
    pub species: String,
    /// Scan files with digests, sizes, pitches, units, and where each was taken from.
    pub provenance: Value,
    /// Levelling, clipping and masking applied to the heights.
    pub preparation: Value,
    /// Height and slope statistics of the prepared scans.
    pub statistics: Value,
    /// The optics the tables were computed for.
    pub optics: OpticsConfig,
    /// What pictures show below the structure; not part of the tables.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pigment: Option<Pigment>,
    /// What was chosen while building.
    pub build: BuildRecord,
    /// The tables' files, axes, scales and formula; no files where spectral tables alone are stored.
    pub tables: StoredTables,
    /// The files of its spectral tables; absent where the atlas holds none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spectral: Option<StoredSpectral>,
    /// Measured errors, by cause.
    pub errors: Value,
    /// Share of the arriving light that is reflected, by angle of incidence; empty where the tables are restricted to scenes.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub albedo: Vec<DirectionalAlbedo>,
    /// Largest albedo over azimuths, by which path tracers divide; `None` where nothing reflects more than arrives.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub energy_limit: Option<EnergyLimit>,
    /// Directions with values, for testing a reader.
    pub check_values: Vec<CheckValue>,
    /// Doubts in whole sentences.
    pub warnings: Vec<String>,
}

/// Writes `specimen.json` into the specimen's folder.
pub fn write(folder: &Path, specimen: &SpecimenFile) -> Result<()> {
    json::write(&folder.join(FILE), specimen)
}

/// Reads `specimen.json` from the specimen's folder.
pub fn read(folder: &Path) -> Result<SpecimenFile> {
    specimen::read(folder)
}

/// Reads a specimen with its tables.
pub fn load(folder: &Path) -> Result<(SpecimenFile, TableSet)> {
    let specimen = read(folder)?;
    let (tables, _) =
        specimen::read_both(folder, &specimen.tables, specimen.spectral.as_ref(), specimen.optics.front_factor())?;
    Ok((specimen, tables))
}
