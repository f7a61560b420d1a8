//! What spectrometers export: a column of wavelengths, one or more of values, and text around them.
//!
//! Ocean Optics and OceanView, Avantes, CRAIC and plain text differ in what separates cells, the decimal mark and the lines before
//! and after; numbers are found by what they are. JCAMP-DX has a format of its own.

use super::config::{ExportConfig, MeasuredConfig};
use super::jcamp;
use super::measurement::{Column, Measurement, ROWS_MAX, Series, WAVELENGTH_NM, all_beyond, note_beyond, note_values};
use diffraction_brdf::error::{Error, Result};
use diffraction_build::ground::csv;

const FIX: &str = "Export the spectrum as text with one column of wavelengths in nm and one of values, or as JCAMP-DX.";

/// Reads an export; geometry, kind and white are those of the manifest.
///
/// # Errors
/// [`Error::BadFile`] for what holds no spectrum, or several without a choice.
pub(super) fn measurement(
    config: &MeasuredConfig,
    export: &ExportConfig,
    text: &str,
    sha256: String,
) -> Result<Measurement> {
    let bad = |what: String| Error::bad_file(&config.file, what, FIX);
    let series = match jcamp::is_jcamp(text) {
        true => jcamp::series(text),
        false => series(text, export.column.as_deref()),
    };
    let Series { wavelength_nm, values, name } = series.map_err(bad)?;
    if wavelength_nm.len() > ROWS_MAX {
        return Err(bad(format!("the file holds more than {ROWS_MAX} rows of values")));
    }
    let factor = export.white_reflectance * if export.percent { 0.01 } else { 1.0 };
    let [low, high] = WAVELENGTH_NM;
    let rows: Vec<(f64, f64)> =
        wavelength_nm.iter().copied().zip(values).filter(|(nm, _)| (low..=high).contains(nm)).collect();
    if rows.is_empty() {
        return Err(bad(all_beyond()));
    }
    let column = Column {
        name: if name.is_empty() { "spectrum".into() } else { name },
        kind: export.kind,
        values: rows.iter().map(|(_, value)| factor * value).collect(),
    };
    let mut measurement = Measurement {
        config: config.clone(),
        sha256,
        // Adding zero makes -0 and 0 the same geometry.
        angles_deg: vec![export.angles_deg.map(|angle| angle + 0.0); rows.len()],
        notes: note_beyond(wavelength_nm.len() - rows.len()).into_iter().collect(),
        wavelength_nm: rows.into_iter().map(|(nm, _)| nm).collect(),
        columns: vec![column],
    };
    note_values(&mut measurement).map_err(bad)?;
    Ok(measurement)
}

/// What separates cells, in the order in which it is tried.
const SEPARATORS: [char; 4] = ['\t', ';', ',', ' '];

/// The numbers of a line of data: a wavelength, and values that may be missing; `None` for any other line.
fn numbers(line: &str, separator: char) -> Option<Vec<f64>> {
    let mut cells: Vec<&str> = csv::cells(line, separator).into_iter().map(|(_, text)| text).collect();
    // Some end each line in a separator.
    if cells.len() > 2 && cells.last().is_some_and(|last| last.is_empty()) {
        cells.pop();
    }
    let first = csv::number(cells.first()?, separator)?;
    let rest: Option<Vec<f64>> = cells[1..].iter().map(|cell| csv::number_or_missing(cell, separator)).collect();
    rest.filter(|rest| !rest.is_empty()).map(|rest| [vec![first], rest].concat())
}

/// The spectrum in lines of text, among lines of other kinds.
fn series(text: &str, column: Option<&str>) -> std::result::Result<Series, String> {
    let lines: Vec<(usize, &str)> = csv::lines(text).collect();
    let count = |separator: char| lines.iter().filter(|(_, line)| numbers(line, separator).is_some()).count();
    // Of equal ones the first.
    let separator = SEPARATORS.into_iter().rev().max_by_key(|&separator| count(separator)).unwrap_or(',');
    let rows: Vec<(usize, Vec<f64>)> =
        lines.iter().enumerate().filter_map(|(at, (_, line))| numbers(line, separator).map(|row| (at, row))).collect();
    // A number alone among the text before is no data: most lines of data have as many cells.
    let Some(cells) = most_common(rows.iter().map(|(_, row)| row.len())) else {
        return Err("it holds no lines of two or more numbers".into());
    };
    let rows: Vec<(usize, Vec<f64>)> = rows.into_iter().filter(|(_, row)| row.len() == cells).collect();
    let names = names(&lines[..rows[0].0], separator, cells);
    let chosen = chosen(column, &names, cells)?;
    Ok(Series {
        wavelength_nm: rows.iter().map(|(_, row)| row[0]).collect(),
        values: rows.iter().map(|(_, row)| row[chosen]).collect(),
        name: names.get(chosen).cloned().unwrap_or_default(),
    })
}

/// The largest of those that come most often.
fn most_common(counts: impl Iterator<Item = usize>) -> Option<usize> {
    let mut seen: Vec<usize> = counts.collect();
    seen.sort_unstable();
    seen.chunk_by(|a, b| a == b).max_by_key(|equal| equal.len()).map(|equal| equal[0])
}

/// Names of the columns: the last line before the data with as many cells that is no line of units in brackets; empty where there
/// is none.
fn names(before: &[(usize, &str)], separator: char, cells: usize) -> Vec<String> {
    let of = |line: &str| -> Vec<String> {
        csv::cells(line, separator).into_iter().map(|(_, name)| name.to_owned()).take(cells).collect()
    };
    let are_units = |names: &[String]| names.iter().all(|name| name.is_empty() || name.starts_with(['[', '(']));
    let found = before.iter().rev().map(|(_, line)| of(line));
    found.take(3).find(|names| names.len() == cells && !are_units(names)).unwrap_or_default()
}

/// Which column of a row holds the values.
fn chosen(column: Option<&str>, names: &[String], cells: usize) -> std::result::Result<usize, String> {
    let listed = || match names.is_empty() {
        true => format!("{} columns of values", cells - 1),
        false => format!(
            "the columns {}",
            names[1..].iter().map(|name| format!("\"{name}\"")).collect::<Vec<_>>().join(", ")
        ),
    };
    match column {
        None if cells == 2 => Ok(1),
        None => Err(format!("it holds {}; say which in the manifest: `column = 2`, or its name", listed())),
        Some(column) => {
            let named = names.iter().position(|name| name.to_lowercase() == column.to_lowercase());
            let counted = || column.parse().ok().and_then(|number: usize| number.checked_sub(1));
            named.or_else(counted).filter(|index| (1..cells).contains(index)).ok_or_else(|| {
                format!(
                    "it has no column of values \"{column}\"; it holds {} (numbers count from 1, the wavelength)",
                    listed()
                )
            })
        }
    }
}

#[cfg(test)]
#[path = "export_tests.rs"]
mod tests;
