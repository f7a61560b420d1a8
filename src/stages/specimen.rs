//! The file `specimen.json`: where a specimen's tables come from, how to read them, and how good they are.

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::ground::direction::{Vec3, Xyz};
use crate::ground::error::{Error, Result};
use crate::ground::json;
use crate::optics::config::OpticsConfig;
use crate::optics::pigment::Pigment;
use crate::tables::model::{BuildRecord, TableSet};
use crate::tables::storage::{self, StoredTables};

/// Version of the layout of the atlas and its files that this program writes and reads.
pub const SCHEMA: u32 = 1;
/// Name of the file in the specimen's folder.
pub const FILE: &str = "specimen.json";

/// A pair of directions and the BRDF that the stored tables give there: a test for other programs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct CheckValue {
    /// Polar angle of the light in degrees.
    pub theta_i_deg: f64,
    /// Azimuth of the light in degrees.
    pub phi_i_deg: f64,
    /// Polar angle of the viewer in degrees.
    pub theta_r_deg: f64,
    /// Azimuth of the viewer in degrees.
    pub phi_r_deg: f64,
    /// Unit vector to the light.
    pub wi: Vec3,
    /// Unit vector to the viewer.
    pub wo: Vec3,
    /// The BRDF in 1/sr, evaluated from the stored (rounded) tables.
    pub xyz: Xyz,
}

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
    /// The tables' files, axes, scales and formula.
    pub tables: StoredTables,
    /// Measured errors, by cause.
    pub errors: Value,
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
    let path = folder.join(FILE);
    let fix = "Restore the file, or run the pipeline again to publish a new version of the atlas.";
    let value: Value = json::read(&path, fix)?;
    check_schema(&path, &value)?;
    serde_json::from_value(value).map_err(|e| Error::bad_file(&path, format!("a field is wrong: {e}"), fix))
}

/// Reads a specimen with its tables.
pub fn load(folder: &Path) -> Result<(SpecimenFile, TableSet)> {
    let specimen = read(folder)?;
    let mut tables = storage::read_tables(folder, &specimen.tables, &specimen.optics)?;
    tables.pigment = specimen.pigment;
    Ok((specimen, tables))
}

/// Refuses layouts of other versions before any other field is looked at.
pub fn check_schema(path: &Path, value: &Value) -> Result<()> {
    let schema = value.get("schema").and_then(Value::as_u64);
    if schema == Some(u64::from(SCHEMA)) {
        return Ok(());
    }
    let found = schema.map_or("none".to_owned(), |schema| schema.to_string());
    Err(Error::bad_file(
        path,
        format!("its schema is {found}, this program reads {SCHEMA}"),
        "Use the version of the program that wrote it, or run the pipeline again.",
    ))
}
