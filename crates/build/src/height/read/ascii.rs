//! Matrices of numbers as text, with or without Gwyddion's comment lines about size and unit.

use super::config::ReadConfig;
use super::refusal::{Parsed, Refusal};
use super::stored::{Found, RawScan, SampleKind, Sourced, Stored};
use super::text;
use super::unit::LengthUnit;

/// Whether a file is text that begins with comments or numbers.
pub(super) fn is_matrix(bytes: &[u8]) -> bool {
    let head = &bytes[..bytes.len().min(1 << 12)];
    let is_text = head.iter().all(|&byte| byte >= b' ' || matches!(byte, b'\t' | b'\n' | b'\r'));
    let text = text::decode(head);
    let mut rows = text.lines().filter(|line| !is_comment(line) && !line.trim().is_empty());
    is_text && rows.next().is_some_and(|row| cells(row).is_some_and(|cells| !cells.is_empty()))
}

fn is_comment(line: &str) -> bool {
    line.trim_start().starts_with(['#', '%', ';'])
}

/// Reads the matrix, its first line at +y.
pub(super) fn read(bytes: &[u8], config: &ReadConfig) -> Parsed<RawScan> {
    let text = text::decode(bytes);
    let (mut values, mut columns, mut rows) = (Vec::new(), 0, 0usize);
    for (number, line) in text.lines().enumerate() {
        if is_comment(line) || line.trim().is_empty() {
            continue;
        }
        let cells = cells(line).ok_or_else(|| {
            let line: String = line.trim().chars().take(40).collect();
            Refusal::new(
                format!("line {} ({line:?}) is not a row of numbers", number + 1),
                "export the height map as .gsf or TIFF",
            )
        })?;
        if rows > 0 && cells.len() != columns {
            return Err(Refusal::damaged(format!(
                "line {} has {} numbers, those above it {columns}",
                number + 1,
                cells.len()
            )));
        }
        columns = cells.len();
        rows += 1;
        values.extend(cells);
        if values.len() > config.max_samples {
            return Err(Refusal::too_large([columns as u64, rows as u64], config.max_samples));
        }
    }
    if columns < 2 || rows < 2 || (columns <= 3 && rows > 100 * columns) {
        return Err(Refusal::new(
            format!(
                "this text has {rows} rows of {columns} numbers: a list of points or a profile, not a matrix of heights"
            ),
            "export the height map as a matrix, as .gsf or as TIFF",
        ));
    }
    let comment = |key: &str| {
        text.lines().filter(|line| is_comment(line)).find_map(|line| {
            let (name, value) = line.trim_start_matches(['#', '%', ';', ' ']).split_once(':')?;
            name.trim().eq_ignore_ascii_case(key).then_some(value.trim())
        })
    };
    let stored = Stored { size: [columns, rows], kind: SampleKind::F64, values };
    Ok(RawScan {
        channel: comment("Channel").map(str::to_owned),
        unit_nm: match comment("Value units") {
            Some(unit) => length(unit),
            None => Err("no comment in the text gives a height unit".to_owned()),
        },
        pitch_nm: pitch(comment("Width"), comment("Height"), [columns, rows]),
        ..RawScan::of("text matrix", stored)
    })
}

/// The numbers of a row. Tabs or semicolons separate, else blanks, else commas; a comma is a decimal mark where it does not separate.
/// An empty cell between separators, and `nan`, is a missing sample.
fn cells(row: &str) -> Option<Vec<f64>> {
    let number = |cell: &str| match cell.trim() {
        "" => Some(f64::NAN),
        cell if cell.contains('.') => cell.parse().ok(),
        cell => cell.replace(',', ".").parse().ok(),
    };
    let row = row.trim_matches([' ', '\r']);
    if let Some(separator) = ['\t', ';'].into_iter().find(|&separator| row.contains(separator)) {
        let row = row.strip_suffix(separator).unwrap_or(row);
        return row.split(separator).map(number).collect();
    }
    if row.contains(' ') && !row.contains(", ") {
        return row.split_whitespace().map(number).collect();
    }
    let row = row.strip_suffix(',').unwrap_or(row);
    row.split(',').map(|cell| if cell.trim().is_empty() { Some(f64::NAN) } else { cell.trim().parse().ok() }).collect()
}

fn length(unit: &str) -> Found<f64> {
    match LengthUnit::parse(unit) {
        Some(unit) => Ok(Sourced::new(unit.to_nm(), "comment lines")),
        None => Err(format!("its comments give the height unit {unit:?}, not a length")),
    }
}

/// `3.00 µm` over the samples.
fn pitch(width: Option<&str>, height: Option<&str>, size: [usize; 2]) -> Found<[f64; 2]> {
    let mut pitch = [0.0; 2];
    for (axis, text) in [width, height].into_iter().enumerate() {
        let text = text.ok_or("no comment in the text gives its width and height")?;
        let (number, unit) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
        let number: f64 =
            number.replace(',', ".").parse().map_err(|_| format!("its comments give the size {text:?}"))?;
        pitch[axis] = number * length(unit)?.value / size[axis] as f64;
    }
    Ok(Sourced::new(pitch, "comment lines"))
}
