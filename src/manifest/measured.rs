//! The `measured` key of a specimen: a CSV file that says it all, or a spectrometer's export with what it does not say.

use std::path::{Path, PathBuf};

use super::defaults;
use super::files;
use super::keys;
use super::reader::{Item, Section};
use crate::error::Result;
use crate::stages::measured::kind::{self, Kind};
use crate::stages::measured::read::THETA_MAX_DEG;
use crate::stages::measured::{ExportConfig, MeasuredConfig};

/// Widest cone of a detector.
const ACCEPTANCE_MAX_DEG: f64 = 60.0;

/// Widest slit: half of the shortest wavelength remains at its foot.
const BANDWIDTH_MAX_NM: f64 = 100.0;

/// Largest azimuth, either way.
const PHI_MAX_DEG: f64 = 360.0;

/// Largest reflectance of a white: pressed powders pass 1 a little in some geometries.
const WHITE_MAX: f64 = 2.0;

/// Keys that a spectrometer's export needs; one of them says that the file is one.
const EXPORT: [&str; 7] =
    ["theta_i_deg", "phi_i_deg", "theta_r_deg", "phi_r_deg", "kind", "white_reflectance", "column"];

const EXAMPLE: &str = "{ file = \"reflectance.csv\", acceptance_deg = 1.0 }";

/// Reads the key; paths start at `base`.
pub(super) fn read(item: &Item, base: &Path) -> Result<MeasuredConfig> {
    let mut measured = MeasuredConfig {
        file: PathBuf::new(),
        acceptance_deg: defaults::ACCEPTANCE_DEG,
        bandwidth_nm: defaults::BANDWIDTH_NM,
        export: None,
    };
    if !item.is_table() {
        measured.file = existing(item, base)?;
        return Ok(measured);
    }
    let section = item.section(&keys::MEASURED, EXAMPLE)?;
    measured.file = existing(&section.require("file", EXAMPLE)?, base)?;
    if let Some(item) = section.get("acceptance_deg") {
        measured.acceptance_deg = item.number_within(0.0, ACCEPTANCE_MAX_DEG, "degrees")?;
    }
    if let Some(item) = section.get("bandwidth_nm") {
        measured.bandwidth_nm = item.number_within(0.0, BANDWIDTH_MAX_NM, "nm")?;
    }
    if EXPORT.iter().any(|key| section.has(key)) {
        measured.export = Some(export(&section, measured.acceptance_deg)?);
    }
    Ok(measured)
}

/// Geometry, kind and white of a spectrometer's export.
fn export(section: &Section, acceptance_deg: f64) -> Result<ExportConfig> {
    let theta = |key: &str, example: &str| {
        section.require(key, example)?.number_within(-THETA_MAX_DEG, THETA_MAX_DEG, "degrees")
    };
    let phi = |key: &str| match section.get(key) {
        Some(item) => item.number_within(-PHI_MAX_DEG, PHI_MAX_DEG, "degrees"),
        None => Ok(0.0),
    };
    let (kind, percent) = kind(&section.require("kind", "kind = \"reflectance_factor_percent\"")?, acceptance_deg)?;
    Ok(ExportConfig {
        angles_deg: [
            theta("theta_i_deg", "theta_i_deg = 0")?,
            phi("phi_i_deg")?,
            theta("theta_r_deg", "theta_r_deg = 30")?,
            phi("phi_r_deg")?,
        ],
        kind,
        percent,
        white_reflectance: match section.get("white_reflectance") {
            Some(item) => item.number_above(0.0, WHITE_MAX, "")?,
            None => defaults::WHITE_REFLECTANCE,
        },
        column: section.get("column").map(|item| column(&item)).transpose()?,
    })
}

fn kind(item: &Item, acceptance_deg: f64) -> Result<(Kind, bool)> {
    let text = item.text_not_empty()?;
    let known = kind::value_kind(text).ok().flatten().filter(|_| !text.contains(':'));
    let Some((kind, percent)) = known else {
        return Err(item.error(format!(
            "must be one of {}, shares with `_percent` behind them where they are in per cent; found \"{text}\"",
            keys::quoted(&kind::names())
        )));
    };
    if kind == Kind::ConeReflectance && acceptance_deg <= 0.0 {
        return Err(item.error("is the power within the detector's cone: give its full angle as `acceptance_deg`"));
    }
    Ok((kind, percent))
}

/// A name, or a number from 1.
fn column(item: &Item) -> Result<String> {
    match item.as_text() {
        Some(text) => Ok(text.trim().to_owned()),
        None => Ok(item.integer_within(1, COLUMNS_MAX, "")?.to_string()),
    }
}

/// Largest number of a column.
const COLUMNS_MAX: usize = 10_000;

/// A file that is there.
fn existing(item: &Item, base: &Path) -> Result<PathBuf> {
    let path = base.join(item.text_not_empty()?);
    if !path.is_file() {
        return Err(item.error(files::no_file(&path)));
    }
    Ok(path)
}
