//! CSV files of measured reflectance: angles, wavelength, and values whose column says their kind.

use std::path::{Path, PathBuf};

use super::config::MeasuredConfig;
use super::export;
use super::kind::{self, Kind, value_kind};
use super::measurement::{Column, Measurement, ROWS_MAX, WAVELENGTH_NM, all_beyond, note_beyond, note_values};
use diffraction_brdf::direction::angles_deg;
use diffraction_brdf::error::{Error, Result};
use diffraction_build::ground::csv::{self, Cell};

/// Largest file that is read.
const BYTES_MAX: u64 = 64 << 20;

/// Most columns of values.
const COLUMNS_MAX: usize = 16;

/// The columns of a geometry, in degrees, and of the wavelength.
const PLACE: [&str; 5] = ["theta_i_deg", "phi_i_deg", "theta_r_deg", "phi_r_deg", "wavelength_nm"];
/// The same with vectors of any length to the light and to the detector, as `eval` writes where it read such.
const PLACE_VECTORS: [&str; 7] = ["wi_x", "wi_y", "wi_z", "wo_x", "wo_y", "wo_z", "wavelength_nm"];

/// Steepest direction: at the horizon nothing is lit or seen.
pub(crate) const THETA_MAX_DEG: f64 = 89.9;

/// Reads a file of measured reflectance.
///
/// The first line that is neither empty nor a comment (`#`) names the columns, in any order: the four angles in
/// degrees or six components of vectors, `wavelength_nm`, and one or more kinds of value, each as it is, with `_percent` behind it (shares
/// only), or with `:` and a label. Columns of other names are not used, which is noted. Separated by commas,
/// semicolons or tabs; beside the latter two a comma may be the decimal mark. Rows may stand in any order.
///
/// # Errors
/// [`Error::BadFile`] with line and column for whatever cannot be taken as it is; [`Error::Disk`].
pub fn read(config: &MeasuredConfig) -> Result<Measurement> {
    let (text, sha256) = csv::read(&config.file, BYTES_MAX)?;
    if let Some(export) = &config.export {
        return export::measurement(config, export, &text, sha256);
    }
    let mut lines = csv::lines(&text);
    let Some((number, header)) = lines.next() else {
        return Err(Table { path: &config.file, separator: ',' }.error(1, 1, "the file holds no line of column names"));
    };
    let table = Table { path: &config.file, separator: csv::separator(header) };
    let layout = table.layout(number, header, config)?;
    let mut measurement = Measurement {
        config: config.clone(),
        sha256,
        angles_deg: Vec::new(),
        wavelength_nm: Vec::new(),
        columns: layout.values.iter().map(|place| place.column.clone()).collect(),
        notes: layout.notes.clone(),
    };
    let mut beyond = 0;
    for (number, line) in lines {
        if measurement.wavelength_nm.len() == ROWS_MAX {
            return Err(table.error(number, 1, &format!("the file holds more than {ROWS_MAX} rows of values")));
        }
        beyond += usize::from(!table.row(number, line, &layout, &mut measurement)?);
    }
    if measurement.wavelength_nm.is_empty() {
        let what = if beyond > 0 { all_beyond() } else { "no rows of values follow the column names".into() };
        return Err(table.error(number, 1, &what));
    }
    measurement.notes.extend(note_beyond(beyond));
    note_values(&mut measurement).map_err(|what| table.error(number, 1, &what))?;
    Ok(measurement)
}

const FIX: &str = "The first line names the columns theta_i_deg, phi_i_deg, theta_r_deg, phi_r_deg (or wi_x, wi_y, wi_z, wo_x, \
                   wo_y, wo_z), wavelength_nm and one or more kinds of value; each other line holds a number for each. For a spectrometer's own export say the geometry \
                   and the kind in the manifest (docs/manifest.md, `measured`).";

/// A file being read.
struct Table<'a> {
    path: &'a Path,
    separator: char,
}

/// A column of values and its place.
struct ValuePlace {
    cell: usize,
    column: Column,
    percent: bool,
}

/// Which cell holds what.
struct Layout {
    /// Names of the columns of geometry and wavelength, and their cells.
    names: &'static [&'static str],
    place: Vec<usize>,
    values: Vec<ValuePlace>,
    cells: usize,
    notes: Vec<String>,
}

impl Table<'_> {
    /// An error at a place that editors can jump to.
    fn error(&self, line: usize, column: usize, what: &str) -> Error {
        let place = format!("{}:{line}:{column}", self.path.display());
        Error::bad_file(&PathBuf::from(place), what, FIX)
    }

    fn layout(&self, number: usize, header: &str, config: &MeasuredConfig) -> Result<Layout> {
        let cells = csv::cells(header, self.separator);
        let names: Vec<String> = cells.iter().map(|(_, name)| name.to_lowercase()).collect();
        if let Some(index) = (1..names.len()).find(|&i| !names[i].is_empty() && names[..i].contains(&names[i])) {
            return Err(self.error(number, cells[index].0, &format!("the column `{}` stands twice", names[index])));
        }
        let is_there = |wanted: &&str| names.iter().any(|name| name == wanted);
        let is_vectors = PLACE_VECTORS[..6].iter().any(is_there) && !PLACE[..4].iter().any(is_there);
        let wanted: &[&str] = if is_vectors { &PLACE_VECTORS } else { &PLACE };
        let cell_of = |wanted: &&str| {
            names.iter().position(|name| name == wanted).ok_or_else(|| {
                let (at, hint) = alike(&cells, &names, wanted);
                self.error(number, at, &format!("the column `{wanted}` is missing{hint}"))
            })
        };
        let place: Vec<usize> = wanted.iter().map(cell_of).collect::<Result<_>>()?;
        let is_place = |index: &usize| place.contains(index);
        let others: Vec<usize> = (0..cells.len()).filter(|index| !is_place(index)).collect();
        let mut layout = Layout { names: wanted, place, values: Vec::new(), cells: cells.len(), notes: Vec::new() };
        for (index, (at, name)) in others.into_iter().map(|index| (index, cells[index])) {
            match value_kind(&names[index]).map_err(|what| self.error(number, at, &what))? {
                Some((Kind::ConeReflectance, _)) if config.acceptance_deg <= 0.0 => {
                    let what = "`cone_reflectance` is the power within the detector's cone: give its full angle as \
                                `acceptance_deg` beside `file`";
                    return Err(self.error(number, at, what));
                }
                Some((kind, percent)) => {
                    let column = Column { name: name.to_owned(), kind, values: Vec::new() };
                    layout.values.push(ValuePlace { cell: index, column, percent });
                }
                None if name.is_empty() => {}
                None => layout.notes.push(format!("the column `{name}` is of no known kind and not used")),
            }
        }
        if layout.values.is_empty() {
            let what =
                format!("no column says what kind of value it holds; expected one of {}", kind::names().join(", "));
            return Err(self.error(number, 1, &what));
        }
        if layout.values.len() > COLUMNS_MAX {
            return Err(self.error(number, 1, &format!("there are more than {COLUMNS_MAX} columns of values")));
        }
        Ok(layout)
    }

    /// Takes a row over, unless its wavelength lies outside of what is compared; whether it did.
    fn row(&self, number: usize, line: &str, layout: &Layout, out: &mut Measurement) -> Result<bool> {
        let cells = csv::row_cells(line, self.separator, layout.cells).map_err(|what| self.error(number, 1, &what))?;
        let place = layout.place.iter().zip(layout.names).map(|(&cell, name)| self.place(number, cells[cell], name));
        let place: Vec<f64> = place.collect::<Result<_>>()?;
        let (angles, wavelength_nm) = match place[..] {
            [theta_i, phi_i, theta_r, phi_r, wavelength_nm] => ([theta_i, phi_i, theta_r, phi_r], wavelength_nm),
            [wi_x, wi_y, wi_z, wo_x, wo_y, wo_z, wavelength_nm] => {
                let [theta_i, phi_i] = self.angles_of(number, [wi_x, wi_y, wi_z])?;
                let [theta_r, phi_r] = self.angles_of(number, [wo_x, wo_y, wo_z])?;
                ([theta_i, phi_i, theta_r, phi_r], wavelength_nm)
            }
            _ => unreachable!("a layout has the columns of angles or of vectors"),
        };
        if !(WAVELENGTH_NM[0]..=WAVELENGTH_NM[1]).contains(&wavelength_nm) {
            return Ok(false);
        }
        out.angles_deg.push(angles);
        out.wavelength_nm.push(wavelength_nm);
        for (value_place, column) in layout.values.iter().zip(&mut out.columns) {
            let cell = cells[value_place.cell];
            let value = match csv::number_or_missing(cell.1, self.separator) {
                Some(value) => value,
                None => self.number(number, cell, &column.name)?,
            };
            column.values.push(if value_place.percent { 0.01 * value } else { value });
        }
        Ok(true)
    }

    /// Polar angles in degrees of a vector of any length.
    fn angles_of(&self, number: usize, vector: [f64; 3]) -> Result<[f64; 2]> {
        let angles = angles_deg(vector);
        if vector[2] > 0.0 && angles[0] <= THETA_MAX_DEG {
            return Ok(angles);
        }
        let what = format!("the vector {vector:?} does not lie within {THETA_MAX_DEG} degrees of the normal");
        Err(self.error(number, 1, &what))
    }

    /// An angle, a component of a vector, or a wavelength.
    fn place(&self, number: usize, cell: Cell, name: &str) -> Result<f64> {
        let value = self.number(number, cell, name)?;
        let [low, high] = match name {
            "theta_i_deg" | "theta_r_deg" => [-THETA_MAX_DEG, THETA_MAX_DEG],
            "phi_i_deg" | "phi_r_deg" => [-360.0, 360.0],
            // Whether a wavelength is compared at all is seen to later, as are vectors as a whole.
            _ => [f64::MIN, f64::MAX],
        };
        if !(low..=high).contains(&value) {
            let what = format!("`{name}` must lie between {low} and {high}; found {value}");
            return Err(self.error(number, cell.0, &what));
        }
        // Adding zero makes -0 and 0 the same geometry.
        Ok(value + 0.0)
    }

    fn number(&self, number: usize, (at, text): Cell, name: &str) -> Result<f64> {
        csv::number(text, self.separator).ok_or_else(|| {
            let shown: String = text.chars().take(40).collect();
            self.error(number, at, &format!("`{shown}` in the column `{name}` is not a finite number"))
        })
    }
}

/// Where a column stands that may be meant, and what to say of it.
fn alike(cells: &[Cell], names: &[String], wanted: &str) -> (usize, String) {
    let stem = wanted.rsplit_once('_').map_or(wanted, |(stem, _)| stem);
    let found = names.iter().position(|name| name.rsplit_once('_').map_or(name.as_str(), |(stem, _)| stem) == stem);
    found.map_or((1, String::new()), |index| {
        (cells[index].0, format!("; found `{}`: the unit is the last word of the name", cells[index].1))
    })
}

#[cfg(test)]
#[path = "read_tests.rs"]
mod tests;
