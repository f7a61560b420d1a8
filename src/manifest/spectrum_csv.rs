//! Small CSV files of numbers by wavelength that a manifest names.

use std::path::Path;

use diffraction_build::ground::csv;

/// Largest file read: a spectrum at 0.01 nm is a tenth of it.
const BYTES_MAX: u64 = 16 << 20;

/// The text of a file, and the SHA-256 of its bytes in hexadecimal digits.
///
/// # Errors
/// What keeps it from being read, in words.
pub(super) fn text_of(path: &Path) -> Result<(String, String), String> {
    let lines = |error: diffraction_brdf::Error| match error {
        // The caller names the file.
        diffraction_brdf::Error::BadFile { what, fix, .. } => format!("{what}. {fix}"),
        diffraction_brdf::Error::Disk { source, .. } => format!("cannot read the file: {source}"),
        other => other.to_string(),
    };
    csv::read(path, BYTES_MAX).map_err(lines)
}

/// The rows below a first line that names these columns, in any order, by ascending wavelength, which is the first of them; with the
/// numbers of their lines. In the file wavelengths may ascend or descend. What is no number is NaN. `numbers` says in words how many
/// there must be.
///
/// # Errors
/// The line at fault, in words.
pub(super) fn rows<const N: usize>(
    text: &str,
    columns: [&str; N],
    numbers: &str,
) -> Result<Vec<(usize, [f64; N], String)>, String> {
    let mut lines = csv::lines(text);
    let header = lines.next().map_or("", |(_, line)| line);
    let separator = csv::separator(header);
    let names: Vec<String> = csv::cells(header, separator).iter().map(|(_, name)| name.to_lowercase()).collect();
    let place = |column: &str| names.iter().position(|name| name == column);
    let places: Option<Vec<usize>> = columns.iter().map(|column| place(column)).collect();
    let Some(places) = places.filter(|_| names.len() == N) else {
        return Err(format!("the first line must be `{}`", columns.join(",")));
    };
    let read = |(line, row): (usize, &str)| {
        let shown: String = row.trim().chars().take(SHOWN).collect();
        let cells = csv::cells(row, separator);
        if cells.len() != N {
            return Err(format!("line {line}: expected {numbers}; found `{shown}`"));
        }
        let number = |index: usize| csv::with_point(cells[places[index]].1, separator).parse().unwrap_or(f64::NAN);
        Ok((line, std::array::from_fn(number), shown))
    };
    let mut rows = lines.map(read).collect::<Result<Vec<_>, _>>()?;
    if rows.len() > 1 && rows.windows(2).all(|pair| pair[0].1[0] > pair[1].1[0]) {
        rows.reverse();
    }
    Ok(rows)
}

/// Characters of a row that messages show.
const SHOWN: usize = 40;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dialects_and_orders_mean_the_same() {
        let columns = ["wavelength_nm", "power"];
        let expected = vec![[400.0, 1.5], [500.0, 2.0]];
        for text in [
            "wavelength_nm,power\n400,1.5\n500,2\n",
            "\u{feff}# lamp\r\nPower;Wavelength_nm\r\n2;500\r\n1,5;400\r\n",
            "wavelength_nm\tpower\n500\t2,0\n400\t1,5\n",
            "\"wavelength_nm\",\"power\"\n\"400\",\"1.5\"\n\"500\",\"2\"\n",
        ] {
            let rows = rows(text, columns, "two numbers").unwrap();
            assert_eq!(rows.into_iter().map(|(_, row, _)| row).collect::<Vec<_>>(), expected, "{text}");
        }
    }
}
