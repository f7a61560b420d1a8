//! Specimens from a CSV file: a row each, a column for each key.
//!
//! Rows become what `[[specimen]]` would have been, with places in the CSV file in place of those in the manifest, and are then read by
//! the same code: so every key means the same in both, and whatever is wrong is shown in its cell.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::ops::Range;
use std::path::{Path, PathBuf};

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::files::{self, MATCHES_MAX};
use super::keys::{self, Keys};
use super::reader::{Item, Section};
use super::source::Source;
use crate::error::Result;
use diffraction_build::ground::csv;

/// Largest file read: far beyond as many rows as there may be.
const BYTES_MAX: u64 = 64 << 20;

/// Most rows.
const ROWS_MAX: usize = MATCHES_MAX;

/// Keys that are tables in a manifest, with their own keys: in a column's name both stand with a dot between.
const TABLES: [(&str, &Keys); 6] = [
    ("coherence", &keys::COHERENCE),
    ("despike", &keys::DESPIKE),
    ("height", &keys::HEIGHT),
    ("illuminant", &keys::LINES),
    ("material", &keys::MATERIAL),
    ("measured", &keys::MEASURED),
];

/// Keys whose values are text, even where it looks like a number, such as a file's name.
const TEXTS: [&str; 16] = [
    "channel",
    "column",
    "edge",
    "file",
    "illuminant",
    "kind",
    "level",
    "material",
    "measured",
    "metal",
    "name",
    "scans",
    "species",
    "substance",
    "unit",
    "windows",
];

/// Keys whose values are lists, even of a single number.
const LISTS: [&str; 4] = ["albedo", "crop", "lines_nm", "power"];

/// Text keys that may name a file besides the scans.
const FILES: [&str; 4] = ["file", "illuminant", "material", "measured"];

/// A CSV file of specimens.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Collection {
    /// The file.
    pub file: PathBuf,
    /// SHA-256 of what it held.
    pub sha256: String,
    /// Files that its cells name, besides scans.
    pub named: Vec<PathBuf>,
}

/// A column's name.
struct Column<'t> {
    /// The table that its key is in; empty for a specimen's own.
    table: &'t str,
    key: &'t str,
}

/// Reads a CSV file that `item` names, and gives every row to `each`: its section, and the name among its keys' values.
///
/// # Errors
/// What keeps the file from being read, at its name in the manifest; what is wrong in it, at its line and column.
pub(super) fn read(
    item: &Item,
    base: &Path,
    mut each: impl FnMut(&Section, &Item) -> Result<()>,
) -> Result<Collection> {
    let file = base.join(item.text_not_empty()?);
    if !file.is_file() {
        return Err(item.error(files::no_file(&file)));
    }
    let unreadable = |error: diffraction_brdf::Error| item.error(format!("cannot be read: {error}"));
    let (text, sha256) = csv::read(&file, BYTES_MAX).map_err(unreadable)?;
    // One way of ending lines, so that places are counted as an editor does.
    let text = text.replace("\r\n", "\n").replace('\r', "\n");
    let shown = file.display().to_string();
    let source = Source { text: &text, file: &shown };
    let mut lines = csv::lines(&text).map(|(_, line)| line);
    let Some(header) = lines.next() else {
        return Err(
            source.error(0..0, "holds nothing; its first line names the columns, such as `name,scans,pitch_nm`")
        );
    };
    let separator = csv::separator(header);
    let columns = columns(&source, header, separator)?;
    let mut named = BTreeSet::new();
    let mut count = 0;
    for line in lines {
        count += 1;
        if count > ROWS_MAX {
            return Err(source.error(place(&text, line), format!("holds more than {ROWS_MAX} specimens")));
        }
        let cells = cells(&source, line, separator, &columns)?;
        named.extend(cells.iter().filter(|cell| FILES.contains(&cell.column.key)).map(|cell| base.join(cell.text)));
        let table = row(&source, &cells)?;
        let section = Section::row(source, &table, place(&text, line), &keys::SPECIMEN)?;
        each(&section, &section.require("name", "a column `name`, with `{file}` or a name of its own in every row")?)?;
    }
    match count {
        0 => {
            Err(source
                .error(text.len()..text.len(), "holds no specimen: a row each is expected below the columns' names"))
        }
        _ => Ok(Collection { file, sha256, named: named.into_iter().filter(|path| path.is_file()).collect() }),
    }
}

/// Where a part of the text is in it.
fn place(text: &str, part: &str) -> Range<usize> {
    let start = part.as_ptr() as usize - text.as_ptr() as usize;
    start..start + part.len()
}

/// The columns' names, each of which must be a known key, once.
fn columns<'t>(source: &Source<'t>, header: &'t str, separator: char) -> Result<Vec<Column<'t>>> {
    let mut columns: Vec<Column> = Vec::new();
    for (_, name) in csv::cells(header, separator) {
        let error = |message: String| source.error(place(source.text, name), message);
        let (table, key) = name.split_once('.').unwrap_or(("", name));
        let keys = match table {
            "" => &keys::SPECIMEN,
            _ => TABLES.iter().find(|(known, _)| *known == table).map(|(_, keys)| *keys).ok_or_else(|| {
                let known: Vec<&str> = TABLES.iter().map(|(known, _)| *known).collect();
                error(format!("`{table}` is no table of a specimen's keys; there are {}", keys::quoted(&known)))
            })?,
        };
        if !keys.names.contains(&key) {
            return Err(error(keys::unknown_key(key, keys, None, None)));
        }
        if columns.iter().any(|other| other.table == table && other.key == key) {
            return Err(error(format!("there are two columns `{name}`")));
        }
        columns.push(Column { table, key });
    }
    Ok(columns)
}

/// A cell that says something.
struct Cell<'t> {
    column: &'t Column<'t>,
    text: &'t str,
    /// Its numbers as TOML writes them, each with its place in the cell; none for text.
    numbers: Vec<(Range<usize>, String)>,
}

/// The cells of a line that are not empty.
fn cells<'t>(source: &Source<'t>, line: &'t str, separator: char, columns: &'t [Column<'t>]) -> Result<Vec<Cell<'t>>> {
    let cells = csv::row_cells(line, separator, columns.len());
    let cells = cells.map_err(|why| source.error(place(source.text, line), why))?;
    let one = |(column, (_, text)): (&'t Column<'t>, csv::Cell<'t>)| {
        let numbers = if TEXTS.contains(&column.key) { Vec::new() } else { numbers(text, separator) };
        Cell { column, text, numbers }
    };
    Ok(columns.iter().zip(cells).filter(|(_, (_, text))| !text.is_empty()).map(one).collect())
}

/// The numbers of a cell, separated by blanks; none where something else is among them.
fn numbers(text: &str, separator: char) -> Vec<(Range<usize>, String)> {
    let one = |part: &str| {
        let number = csv::number(part, separator)?;
        // A whole number is one in TOML, too: sizes and pages must be.
        let written = part.parse::<i64>().map_or_else(|_| format!("{number:?}"), |whole| whole.to_string());
        Some((place(text, part), written))
    };
    text.split_whitespace().map(one).collect::<Option<_>>().unwrap_or_default()
}

/// What a row would be in a manifest.
fn row<'c>(source: &Source, cells: &'c [Cell<'c>]) -> Result<DeTable<'c>> {
    let mut row = DeTable::new();
    for cell in cells {
        let at = place(source.text, cell.text);
        let Column { table, key } = cell.column;
        let named = |name: &'c str| Spanned::new(at.clone(), Cow::Borrowed(name));
        let value = Spanned::new(at.clone(), value(cell, at.start));
        let clash = |name: &str| {
            source.error(at.clone(), format!("`{name}` is given as a whole and key by key; leave one empty"))
        };
        if table.is_empty() {
            if row.contains_key(*key) {
                return Err(clash(key));
            }
            row.insert(named(key), value);
            continue;
        }
        if !row.contains_key(*table) {
            row.insert(named(table), Spanned::new(at.clone(), DeValue::Table(DeTable::new())));
        }
        match row.get_mut(*table).map(Spanned::get_mut) {
            Some(DeValue::Table(inner)) => drop(inner.insert(named(key), value)),
            _ => return Err(clash(table)),
        }
    }
    Ok(row)
}

/// The value of a cell that begins at this byte.
fn value<'c>(cell: &'c Cell, start: usize) -> DeValue<'c> {
    // What was written as TOML writes it can be read.
    let number =
        |text: &'c str| DeValue::parse(text).map_or_else(|_| DeValue::String(text.into()), Spanned::into_inner);
    match &cell.numbers[..] {
        [] => DeValue::String(cell.text.into()),
        [(_, one)] if !LISTS.contains(&cell.column.key) => number(one),
        several => {
            let one =
                |(at, text): &'c (Range<usize>, String)| Spanned::new(start + at.start..start + at.end, number(text));
            DeValue::Array(several.iter().map(one).collect())
        }
    }
}
