//! Small CSV files of numbers by wavelength that a manifest names.

use std::path::Path;

use diffraction_brdf::files;

/// Largest file read: a spectrum at 0.01 nm is a tenth of it.
const BYTES_MAX: u64 = 16 << 20;

/// The text of a file, and the SHA-256 of its bytes in hexadecimal digits.
///
/// # Errors
/// What keeps it from being read, in words.
pub(super) fn text_of(path: &Path) -> Result<(String, String), String> {
    let about = std::fs::metadata(path).map_err(|error| format!("cannot read the file: {error}"))?;
    if !about.is_file() {
        return Err("is not a file".to_owned());
    }
    if about.len() > BYTES_MAX {
        return Err(format!("has {} bytes; at most {BYTES_MAX} are read", about.len()));
    }
    let text = std::fs::read_to_string(path).map_err(|error| format!("cannot read the file: {error}"))?;
    let sha256 = files::sha256_hex(text.as_bytes());
    Ok((text, sha256))
}

/// The rows below a first line that names these columns, with the numbers of their lines; `#` starts a comment line. What is no
/// number is NaN. `numbers` says in words how many there must be.
///
/// # Errors
/// The line at fault, in words.
pub(super) fn rows<const N: usize>(
    text: &str,
    columns: [&str; N],
    numbers: &str,
) -> Result<Vec<(usize, [f64; N], String)>, String> {
    let mut rows = text
        .trim_start_matches('\u{feff}')
        .lines()
        .enumerate()
        .map(|(index, row)| (index + 1, row.trim()))
        .filter(|(_, row)| !row.is_empty() && !row.starts_with('#'));
    let header: Vec<String> =
        rows.next().map(|(_, row)| row.split(',').map(|cell| cell.trim().to_lowercase()).collect()).unwrap_or_default();
    if header != columns {
        return Err(format!("the first line must be `{}`", columns.join(",")));
    }
    let read = |(line, row): (usize, &str)| {
        let cells: Vec<f64> = row.split(',').map(|cell| cell.trim().parse().unwrap_or(f64::NAN)).collect();
        let shown: String = row.chars().take(SHOWN).collect();
        match <[f64; N]>::try_from(cells) {
            Ok(cells) => Ok((line, cells, shown)),
            Err(_) => Err(format!("line {line}: expected {numbers}; found `{shown}`")),
        }
    };
    rows.map(read).collect()
}

/// Characters of a row that messages show.
const SHOWN: usize = 40;
