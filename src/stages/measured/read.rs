//! CSV files of measured reflectance: angles, wavelength, and values whose column says their kind.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use super::config::MeasuredConfig;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::files;
use diffraction_build::ground::csv::{self, Cell};

/// Largest file that is read.
const BYTES_MAX: u64 = 64 << 20;

/// Most rows: a hundred directions at a nanometre's step over the visible range, five times over.
const ROWS_MAX: usize = 200_000;

/// Most columns of values.
const COLUMNS_MAX: usize = 16;

/// The columns of a geometry, in degrees, and of the wavelength.
const PLACE: [&str; 5] = ["theta_i_deg", "phi_i_deg", "theta_r_deg", "phi_r_deg", "wavelength_nm"];

/// Steepest direction: at the horizon nothing is lit or seen.
const THETA_MAX_DEG: f64 = 89.9;

/// Shortest and longest wavelength, those of the manifest.
const WAVELENGTH_NM: [f64; 2] = [200.0, 2500.0];

/// What a value is, by what it is compared with. `f` is the BRDF, `⟨·⟩` the mean over cone and slit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// `⟨f cos_theta⟩ / cos_theta_r` in 1/sr.
    Brdf,
    /// `⟨f cos_theta⟩` in 1/sr: power per solid angle relative to the incident power.
    Scatter,
    /// `π ⟨f cos_theta⟩ / ⟨cos_theta⟩`: relative to a white Lambertian seen in the same cone.
    RadianceFactor,
    /// `Ω ⟨f cos_theta⟩`, `Ω` being the cone's solid angle: the share of the incident power that is caught.
    ConeReflectance,
    /// `⟨f cos_theta⟩ / cos_theta_r` times a factor that is fitted.
    RelativeRadiance,
    /// `⟨f cos_theta⟩` times a factor that is fitted.
    RelativePower,
}

/// Names of the kinds as columns.
const KINDS: [(&str, Kind); 7] = [
    ("brdf_per_sr", Kind::Brdf),
    ("scatter_per_sr", Kind::Scatter),
    ("radiance_factor", Kind::RadianceFactor),
    ("reflectance_factor", Kind::RadianceFactor),
    ("cone_reflectance", Kind::ConeReflectance),
    ("relative_radiance", Kind::RelativeRadiance),
    ("relative_power", Kind::RelativePower),
];

impl Kind {
    /// Whether a factor between model and measurement is fitted.
    pub(crate) fn is_relative(self) -> bool {
        matches!(self, Self::RelativeRadiance | Self::RelativePower)
    }

    /// Whether a hundredth part may be its unit.
    fn is_share(self) -> bool {
        matches!(self, Self::RadianceFactor | Self::ConeReflectance)
    }
}

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

/// Reads a file of measured reflectance.
///
/// The first line that is neither empty nor a comment (`#`) names the columns, in any order: the four angles in
/// degrees, `wavelength_nm`, and one or more kinds of value, each as it is, with `_percent` behind it (shares
/// only), or with `:` and a label. Columns of other names are not used, which is noted. Separated by commas,
/// semicolons or tabs; beside the latter two a comma may be the decimal mark. Rows may stand in any order.
///
/// # Errors
/// [`Error::BadFile`] with line and column for whatever cannot be taken as it is; [`Error::Disk`].
pub fn read(config: &MeasuredConfig) -> Result<Measurement> {
    let (text, sha256) = text(&config.file)?;
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
    for (number, line) in lines {
        if measurement.wavelength_nm.len() == ROWS_MAX {
            return Err(table.error(number, 1, &format!("the file holds more than {ROWS_MAX} rows of values")));
        }
        table.row(number, line, &layout, &mut measurement)?;
    }
    if measurement.wavelength_nm.is_empty() {
        return Err(table.error(number, 1, "no rows of values follow the column names"));
    }
    note_values(&table, number, &mut measurement)?;
    Ok(measurement)
}

/// The bytes within bounds, as text without a byte-order mark, and their digest.
fn text(path: &Path) -> Result<(String, String)> {
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(|e| Error::disk(path, "read", e))?;
    file.take(BYTES_MAX + 1).read_to_end(&mut bytes).map_err(|e| Error::disk(path, "read", e))?;
    if bytes.len() as u64 > BYTES_MAX {
        return Err(Error::bad_file(
            path,
            format!("a file of measured reflectance may have {} MiB, this one is larger", BYTES_MAX >> 20),
            FIX,
        ));
    }
    let sha256 = files::sha256_hex(&bytes);
    let text = String::from_utf8(bytes)
        .map_err(|_| Error::bad_file(path, "this is not UTF-8 text", "Save it as CSV in UTF-8."))?;
    Ok((text, sha256))
}

const FIX: &str = "The first line names the columns theta_i_deg, phi_i_deg, theta_r_deg, phi_r_deg, wavelength_nm and one or \
                   more kinds of value (docs/manifest.md, `measured`); each other line holds a number for each.";

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
    place: [usize; 5],
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
        let mut place = [0; 5];
        for (slot, wanted) in place.iter_mut().zip(PLACE) {
            *slot = names.iter().position(|name| name == wanted).ok_or_else(|| {
                let (at, hint) = alike(&cells, &names, wanted);
                self.error(number, at, &format!("the column `{wanted}` is missing{hint}"))
            })?;
        }
        let mut layout = Layout { place, values: Vec::new(), cells: cells.len(), notes: Vec::new() };
        for (index, &(at, name)) in cells.iter().enumerate().filter(|(index, _)| !place.contains(index)) {
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
            let known: Vec<String> = KINDS.iter().map(|(name, _)| format!("`{name}`")).collect();
            let what = format!("no column says what kind of value it holds; expected one of {}", known.join(", "));
            return Err(self.error(number, 1, &what));
        }
        if layout.values.len() > COLUMNS_MAX {
            return Err(self.error(number, 1, &format!("there are more than {COLUMNS_MAX} columns of values")));
        }
        Ok(layout)
    }

    fn row(&self, number: usize, line: &str, layout: &Layout, out: &mut Measurement) -> Result<()> {
        let cells = csv::row_cells(line, self.separator, layout.cells).map_err(|what| self.error(number, 1, &what))?;
        let mut place = [0.0; 5];
        for (index, &cell) in layout.place.iter().enumerate() {
            place[index] = self.place(number, cells[cell], index)?;
        }
        let [theta_i, phi_i, theta_r, phi_r, wavelength_nm] = place;
        out.angles_deg.push([theta_i, phi_i, theta_r, phi_r]);
        out.wavelength_nm.push(wavelength_nm);
        for (value_place, column) in layout.values.iter().zip(&mut out.columns) {
            let cell = cells[value_place.cell];
            let value = if cell.1.is_empty() { f64::NAN } else { self.number(number, cell, &column.name)? };
            column.values.push(if value_place.percent { 0.01 * value } else { value });
        }
        Ok(())
    }

    /// An angle or a wavelength.
    fn place(&self, number: usize, cell: Cell, index: usize) -> Result<f64> {
        let value = self.number(number, cell, PLACE[index])?;
        let [low, high] = match index {
            0 | 2 => [-THETA_MAX_DEG, THETA_MAX_DEG],
            1 | 3 => [-360.0, 360.0],
            _ => WAVELENGTH_NM,
        };
        if !(low..=high).contains(&value) {
            let what = format!("`{}` must lie between {low} and {high}; found {value}", PLACE[index]);
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

/// The kind that a column's name in lower case says, and whether it is in per cent; `None` for other columns.
fn value_kind(name: &str) -> std::result::Result<Option<(Kind, bool)>, String> {
    let word = name.split(':').next().unwrap_or(name).trim();
    let of = |word: &str| KINDS.iter().find(|(known, _)| *known == word).map(|(_, kind)| *kind);
    if let Some(kind) = of(word) {
        return Ok(Some((kind, false)));
    }
    if let Some(kind) = word.strip_suffix("_percent").and_then(of) {
        return if kind.is_share() { Ok(Some((kind, true))) } else { Err(format!("`{word}` cannot be in per cent")) };
    }
    // Half a name would be a guess at what was measured.
    let started = ["brdf", "scatter", "radiance", "reflectance", "relative", "cone", "btdf", "bsdf"];
    if started.iter().any(|start| word.starts_with(start)) {
        let known: Vec<String> = KINDS.iter().map(|(name, _)| format!("`{name}`")).collect();
        return Err(format!("`{word}` does not say its kind and unit; expected one of {}", known.join(", ")));
    }
    Ok(None)
}

/// Where a column stands that may be meant, and what to say of it.
fn alike(cells: &[Cell], names: &[String], wanted: &str) -> (usize, String) {
    let stem = wanted.rsplit_once('_').map_or(wanted, |(stem, _)| stem);
    let found = names.iter().position(|name| name.rsplit_once('_').map_or(name.as_str(), |(stem, _)| stem) == stem);
    found.map_or((1, String::new()), |index| {
        (cells[index].0, format!("; found `{}`: the unit is the last word of the name", cells[index].1))
    })
}

/// Notes on empty and negative values; a column must have something to compare with.
fn note_values(table: &Table, header_line: usize, measurement: &mut Measurement) -> Result<()> {
    for column in &measurement.columns {
        let present = || column.values.iter().filter(|value| !value.is_nan());
        if !present().any(|&value| value > 0.0) {
            let what = format!("the column `{}` holds no value above 0", column.name);
            return Err(table.error(header_line, 1, &what));
        }
        let negative = present().filter(|&&value| value < 0.0).count();
        if negative > 0 {
            let all = present().count();
            let name = &column.name;
            measurement
                .notes
                .push(format!("{negative} of {all} values of `{name}` are negative, as a dark reading leaves them"));
        }
        let empty = column.values.len() - present().count();
        if empty > 0 {
            measurement.notes.push(format!("{empty} cells of `{}` are empty", column.name));
        }
    }
    Ok(())
}

#[cfg(test)]
#[path = "read_tests.rs"]
mod tests;
