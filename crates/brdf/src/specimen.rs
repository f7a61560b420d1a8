//! The file `specimen.json` of an atlas: how to read a specimen's tables, and values to test a reader with.

use std::path::Path;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::direction::{Vec3, Xyz};
use crate::energy::EnergyLimit;
use crate::error::{Error, Result};
use crate::front_factor::FrontFactor;
use crate::json;
use crate::spectral::SpectralTables;
use crate::spectral_storage::{StoredSpectral, read_spectral};
use crate::storage::{self, StoredTables};
use crate::table_set::TableSet;

/// Version of the layout of the atlas and its files that is written: 2 since `optics.factor`, 3 since `spectral`.
pub const SCHEMA: u32 = 3;
/// Oldest version that is read. In version 1 every factor is the scalar one; 1 and 2 have no spectral
/// tables.
pub const OLDEST_SCHEMA: u32 = 1;
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
    /// The BRDF in 1/sr, evaluated from the stored (rounded) tables by linear look-ups.
    pub xyz: Xyz,
    /// The same by splines; absent where these are not what `FORMAT.md` describes, and in older atlases.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub xyz_spline: Option<Xyz>,
}

/// What a reader needs of `specimen.json`; the file holds more, which is passed over.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct SpecimenRecord {
    /// Name in the manifest, and of the folder.
    pub name: String,
    /// Scientific name.
    pub species: String,
    /// What stands in front of the tables' values.
    #[serde(rename = "optics")]
    pub front_factor: FrontFactor,
    /// The tables' files, axes, scales and formula.
    pub tables: StoredTables,
    /// The files of its spectral tables; absent where the atlas holds none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spectral: Option<StoredSpectral>,
    /// What keeps the surface from reflecting more than arrives, where it would.
    #[serde(default)]
    pub energy_limit: Option<EnergyLimit>,
    /// Directions with values, for testing a reader.
    pub check_values: Vec<CheckValue>,
    /// Doubts in whole sentences.
    pub warnings: Vec<String>,
}

/// Reads `specimen.json` from the specimen's folder, as a [`SpecimenRecord`] or as any type that knows more of its fields.
///
/// # Errors
/// A file that is missing, of another schema, or without one of the fields.
pub fn read<T: DeserializeOwned>(folder: &Path) -> Result<T> {
    let path = folder.join(FILE);
    let fix = "Restore the file, or run the pipeline again to publish a new version of the atlas.";
    let value: Value = json::read(&path, fix)?;
    check_schema(&path, &value)?;
    serde_json::from_value(value).map_err(|e| Error::bad_file(&path, format!("a field is wrong: {e}"), fix))
}

/// Reads a specimen with its tables of X, Y, Z.
///
/// # Errors
/// As [`read`], and for files of tables that are missing or damaged.
pub fn load(folder: &Path) -> Result<(SpecimenRecord, TableSet)> {
    let record: SpecimenRecord = read(folder)?;
    let (tables, _) = read_both(folder, &record.tables, record.spectral.as_ref(), record.front_factor)?;
    Ok((record, tables))
}

/// Reads tables of X, Y, Z, and the spectral ones where there are any. Where these alone are stored, the others are derived from
/// them.
///
/// # Errors
/// Files that are missing or damaged.
pub fn read_both(
    folder: &Path,
    stored: &StoredTables,
    spectral: Option<&StoredSpectral>,
    front_factor: FrontFactor,
) -> Result<(TableSet, Option<SpectralTables>)> {
    let spectral = spectral.map(|stored| read_spectral(folder, stored, front_factor)).transpose()?;
    let tables = match (&stored.derived_under, &spectral) {
        (None, _) => storage::read_tables(folder, stored, front_factor)?,
        (Some(light), Some(spectral)) => spectral.xyz_tables(light)?,
        (Some(_), None) => {
            let what = "its tables are to be derived from spectral ones, and it names none";
            return Err(Error::bad_file(&folder.join(FILE), what, storage::FIX));
        }
    };
    Ok((tables, spectral))
}

/// Refuses layouts of other versions before any other field is looked at.
///
/// # Errors
/// `Error::BadFile` for a file at `path` with another schema, or none.
pub fn check_schema(path: &Path, value: &Value) -> Result<()> {
    let schema = value.get("schema").and_then(Value::as_u64);
    if schema.is_some_and(|schema| (u64::from(OLDEST_SCHEMA)..=u64::from(SCHEMA)).contains(&schema)) {
        return Ok(());
    }
    let found = schema.map_or("none".to_owned(), |schema| schema.to_string());
    Err(Error::bad_file(
        path,
        format!("its schema is {found}, this program reads {OLDEST_SCHEMA} to {SCHEMA}"),
        "Use the version of the program that wrote it, or run the pipeline again.",
    ))
}
