//! A measurement as it was read: rows of geometry, wavelength and values, and what to know of them.

use super::config::MeasuredConfig;
use super::kind::Kind;

/// Most rows: a hundred directions at a nanometre's step over the visible range, five times over.
pub(super) const ROWS_MAX: usize = 200_000;

/// Shortest and longest wavelength, those of the manifest.
pub(super) const WAVELENGTH_NM: [f64; 2] = [200.0, 2500.0];

/// One column of values.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Its name in the file.
    pub name: String,
    /// What its values are.
    pub kind: Kind,
    /// A value per row, per cent divided by 100; NaN where the cell is empty.
    pub values: Vec<f64>,
}

/// A measurement, row by row in the order of the file.
#[derive(Debug, Clone, PartialEq)]
pub struct Measurement {
    /// The file and the instrument.
    pub config: MeasuredConfig,
    /// SHA-256 of the file, hexadecimal.
    pub sha256: String,
    /// theta_i, phi_i, theta_r, phi_r of each row in degrees.
    pub angles_deg: Vec<[f64; 4]>,
    /// Wavelength of each row in nm.
    pub wavelength_nm: Vec<f64>,
    /// The columns of values, at least one.
    pub columns: Vec<Column>,
    /// What a reader of the figures must know about the file.
    pub notes: Vec<String>,
}

/// A spectrum as it stands in a file.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Series {
    /// Wavelengths in nm.
    pub(super) wavelength_nm: Vec<f64>,
    /// The values, NaN where there is none.
    pub(super) values: Vec<f64>,
    /// What the file calls the values; empty where it does not.
    pub(super) name: String,
}

/// What is wrong with a file whose wavelengths all lie outside.
pub(super) fn all_beyond() -> String {
    let [low, high] = WAVELENGTH_NM;
    format!("no wavelength lies between {low} and {high} nm: are they in nm?")
}

/// A note on rows that were left out.
pub(super) fn note_beyond(count: usize) -> Option<String> {
    let [low, high] = WAVELENGTH_NM;
    (count > 0).then(|| format!("{count} rows with wavelengths outside of {low} to {high} nm are left out"))
}

/// Notes on missing and negative values; a column must have something to compare with.
///
/// # Errors
/// The column that has not, in words.
pub(super) fn note_values(measurement: &mut Measurement) -> std::result::Result<(), String> {
    for column in &measurement.columns {
        let present = || column.values.iter().filter(|value| !value.is_nan());
        if !present().any(|&value| value > 0.0) {
            return Err(format!("the column `{}` holds no value above 0", column.name));
        }
        let negative = present().filter(|&&value| value < 0.0).count();
        if negative > 0 {
            let all = present().count();
            let name = &column.name;
            measurement
                .notes
                .push(format!("{negative} of {all} values of `{name}` are negative, as a dark reading leaves them"));
        }
        let missing = column.values.len() - present().count();
        if missing > 0 {
            measurement.notes.push(format!("{missing} cells of `{}` hold no number", column.name));
        }
    }
    Ok(())
}
