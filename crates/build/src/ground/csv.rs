//! Text of CSV files and of instruments' exports, read in one way: encodings, lines that say something, cells, numbers with either
//! decimal mark.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::files;

/// A cell's text without blanks and quotes, and the column its first character stands in, from 1.
pub type Cell<'a> = (usize, &'a str);

/// What stands for a number that was not measured, in lower case.
const MISSING: [&str; 13] =
    ["", "nan", "-nan", "+nan", "inf", "-inf", "+inf", "infinity", "-infinity", "n/a", "na", "#n/a", "--"];

/// The text of a file of at most so many bytes, and the SHA-256 of its bytes in hexadecimal digits.
///
/// # Errors
/// [`Error::Disk`]; [`Error::BadFile`] for what is no plain file, is larger, or is no text.
pub fn read(path: &Path, bytes_max: u64) -> Result<(String, String)> {
    files::check_plain(path)?;
    let file = File::open(path).map_err(|e| Error::disk(path, "read", e))?;
    let bytes = read_at_most(path, file, bytes_max)?;
    Ok((text_of(path, &bytes)?, files::sha256_hex(&bytes)))
}

/// The text of a stream that may never end, such as standard input; `path` is for messages.
///
/// # Errors
/// As [`read()`].
pub fn read_stream(path: &Path, stream: impl Read, bytes_max: u64) -> Result<String> {
    text_of(path, &read_at_most(path, stream, bytes_max)?)
}

fn read_at_most(path: &Path, stream: impl Read, bytes_max: u64) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    stream.take(bytes_max + 1).read_to_end(&mut bytes).map_err(|e| Error::disk(path, "read", e))?;
    if bytes.len() as u64 > bytes_max {
        let what = format!("a file of numbers may have {} MiB, this one is larger", bytes_max >> 20);
        return Err(Error::bad_file(path, what, "Split it, or leave out what is not needed."));
    }
    Ok(bytes)
}

fn text_of(path: &Path, bytes: &[u8]) -> Result<String> {
    decode(bytes).ok_or_else(|| Error::bad_file(path, "this is no text", "Save it as text: CSV in UTF-8."))
}

/// Text in UTF-8, in UTF-16 with a byte-order mark, or in Latin-1, as instruments write degrees and micrometres; `None` for what
/// is no text.
fn decode(bytes: &[u8]) -> Option<String> {
    let utf16 = |of: fn([u8; 2]) -> u16| {
        let units: Vec<u16> = bytes[2..].chunks_exact(2).map(|pair| of([pair[0], pair[1]])).collect();
        String::from_utf16(&units).ok()
    };
    match bytes {
        [0xff, 0xfe, ..] => utf16(u16::from_le_bytes),
        [0xfe, 0xff, ..] => utf16(u16::from_be_bytes),
        _ if bytes.contains(&0) => None,
        _ => Some(match std::str::from_utf8(bytes) {
            Ok(text) => text.trim_start_matches('\u{feff}').to_owned(),
            // Its bytes are the first characters of Unicode.
            Err(_) => bytes.iter().map(|&byte| char::from(byte)).collect(),
        }),
    }
}

/// Lines that say something, numbered from 1: neither empty nor a comment (`#`), nor a spreadsheet's `sep=;`, without a byte-order
/// mark.
pub fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let text = text.trim_start_matches('\u{feff}');
    let said = |(index, line): &(usize, &str)| {
        let line = line.trim();
        let is_separator = *index == 0 && line.len() <= 5 && line.to_ascii_lowercase().starts_with("sep=");
        !line.is_empty() && !line.starts_with('#') && !is_separator
    };
    // A line may end as those of old instruments do, in a carriage return alone.
    text.split('\n')
        .flat_map(|line| line.strip_suffix('\r').unwrap_or(line).split('\r'))
        .enumerate()
        .filter(said)
        .map(|(index, line)| (index + 1, line))
}

/// What separates the cells: a tab or semicolon where the line of names has one, else a comma.
pub fn separator(header: &str) -> char {
    ['\t', ';'].into_iter().find(|&mark| header.contains(mark)).unwrap_or(',')
}

/// The cells of a line; between quotes the separator is a character like any other. Separated by a blank, cells are those between
/// any number of blanks and tabs.
pub fn cells(line: &str, separator: char) -> Vec<Cell<'_>> {
    let mut cells = Vec::new();
    let (mut start, mut start_column, mut quoted) = (0, 1, false);
    let mut cut = |from: usize, to: usize, column: usize| {
        let cell = &line[from..to];
        let blank = cell.chars().count() - cell.trim_start().chars().count();
        let text = cell.trim().trim_matches('"').trim();
        if separator != ' ' || !text.is_empty() {
            cells.push((column + blank, text));
        }
    };
    for (column, (index, character)) in line.char_indices().enumerate() {
        if character == '"' {
            // A quote opens a cell only where it begins it: inches are written so, too.
            quoted = !quoted && line[start..index].trim().is_empty();
        }
        let separates = character == separator || (separator == ' ' && character == '\t');
        if separates && !quoted {
            cut(start, index, start_column);
            (start, start_column) = (index + character.len_utf8(), column + 2);
        }
    }
    cut(start, line.len(), start_column);
    cells
}

/// The cells of a line that must have as many as the line of names.
///
/// # Errors
/// How many there are, in words.
pub fn row_cells(line: &str, separator: char, expected: usize) -> std::result::Result<Vec<Cell<'_>>, String> {
    let cells = cells(line, separator);
    if cells.len() == expected {
        return Ok(cells);
    }
    let hint = if separator == ',' && cells.len() > expected {
        "; where commas are decimal marks, separate cells by semicolons"
    } else {
        ""
    };
    Err(format!("expected {expected} cells as in the line of names, found {}{hint}", cells.len()))
}

/// A cell's text with a decimal point: beside other separators a comma may be the decimal mark.
pub fn with_point(text: &str, separator: char) -> String {
    if separator == ',' { text.to_owned() } else { text.replacen(',', ".", 1) }
}

/// The finite number in a cell.
pub fn number(text: &str, separator: char) -> Option<f64> {
    with_point(text, separator).parse().ok().filter(|value: &f64| value.is_finite())
}

/// The number in a cell, or NaN where it says that there is none; `None` for anything else.
pub fn number_or_missing(text: &str, separator: char) -> Option<f64> {
    number(text, separator).or_else(|| MISSING.contains(&text.to_lowercase().as_str()).then_some(f64::NAN))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn encodings_of_instruments_mean_the_same() {
        let text = "wavelength;\u{b5}W\n400;1,5\n";
        let utf16 = |order: fn(u16) -> [u8; 2]| -> Vec<u8> {
            std::iter::once(0xfeff).chain(text.encode_utf16()).flat_map(order).collect()
        };
        let latin1: Vec<u8> = text.chars().map(|c| u32::from(c) as u8).collect();
        for bytes in [
            text.as_bytes().to_vec(),
            [b"\xef\xbb\xbf", text.as_bytes()].concat(),
            utf16(u16::to_le_bytes),
            utf16(u16::to_be_bytes),
            latin1,
        ] {
            assert_eq!(decode(&bytes).as_deref(), Some(text), "{bytes:?}");
        }
        assert_eq!(decode(b"II*\0\x08\0\0\0"), None);
        assert_eq!(decode(&[0xff, 0xfe, 0x00, 0xd8]), None);
    }

    #[test]
    fn what_never_ends_is_read_to_the_bound() {
        let endless = std::io::repeat(b'1');
        let message = read_stream(Path::new("d.csv"), endless, 1 << 20).unwrap_err().to_string();
        assert!(message.contains("1 MiB"), "{message}");
    }

    #[test]
    fn lines_end_in_every_way_and_spreadsheets_say_what_separates() {
        let expected = [(2, "a;b"), (4, "1;2")];
        for text in ["sep=;\na;b\n\n1;2\n", "sep=;\r\na;b\r\n#\r\n1;2", "sep=;\ra;b\r\r1;2\r"] {
            assert_eq!(lines(text).collect::<Vec<_>>(), expected, "{text:?}");
        }
    }

    #[test]
    fn cells_keep_what_is_quoted_and_say_where_they_stand() {
        assert_eq!(cells("a, \"b,c\" ,d", ','), [(1, "a"), (4, "b,c"), (11, "d")]);
        assert_eq!(cells("5\",x", ','), [(1, "5"), (4, "x")]);
        assert_eq!(cells("  400.5 \t 1,5", ' '), [(3, "400.5"), (11, "1,5")]);
        assert_eq!(cells("µ;2", ';'), [(1, "µ"), (3, "2")]);
        assert_eq!((number("1,5", ';'), number("1,5", ','), number("inf", ';')), (Some(1.5), None, None));
        assert!(number_or_missing("NaN", ',').unwrap().is_nan() && number_or_missing("x", ',').is_none());
    }
}
