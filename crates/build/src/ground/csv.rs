//! Text of CSV files: lines that say something, cells, and numbers with either decimal mark.

/// A cell's text without blanks and quotes, and the column its first character stands in, from 1.
pub type Cell<'a> = (usize, &'a str);

/// Lines that say something, numbered from 1: neither empty nor a comment (`#`), without a byte-order mark.
pub fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let text = text.trim_start_matches('\u{feff}');
    let said = |line: &&str| !line.trim().is_empty() && !line.trim_start().starts_with('#');
    text.lines().enumerate().map(|(index, line)| (index + 1, line)).filter(move |(_, line)| said(line))
}

/// What separates the cells: a tab or semicolon where the line of names has one, else a comma.
pub fn separator(header: &str) -> char {
    ['\t', ';'].into_iter().find(|&mark| header.contains(mark)).unwrap_or(',')
}

/// The cells of a line.
pub fn cells(line: &str, separator: char) -> Vec<Cell<'_>> {
    let mut column = 1;
    line.split(separator)
        .map(|cell| {
            let blank = cell.chars().count() - cell.trim_start().chars().count();
            let start = column + blank;
            column += cell.chars().count() + 1;
            (start, cell.trim().trim_matches('"').trim())
        })
        .collect()
}

/// The cells of a line that must have as many as the line of names.
///
/// # Errors
/// How many there are, in words.
pub fn row_cells(line: &str, separator: char, expected: usize) -> Result<Vec<Cell<'_>>, String> {
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
