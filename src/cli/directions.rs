//! Lists of directions as CSV: read from a file, and written with values beside them.

use std::fmt::Write;
use std::path::Path;

use crate::ground::direction::{Vec3, from_angles_deg};
use crate::ground::error::{Error, Result};
use crate::ground::files;

/// The columns of a direction, in degrees.
pub const COLUMNS: [&str; 4] = ["theta_i_deg", "phi_i_deg", "theta_r_deg", "phi_r_deg"];

const FIX: &str = "The first line names the columns theta_i_deg, phi_i_deg, theta_r_deg, phi_r_deg; each other line holds \
                   one number for each, in degrees.";

/// One pair of directions, as written.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The four cells, word for word.
    pub cells: [String; 4],
    /// Their numbers in degrees.
    pub angles_deg: [f64; 4],
}

impl Row {
    /// Unit vectors to the light and to the viewer.
    pub fn pair(&self) -> (Vec3, Vec3) {
        let [theta_i, phi_i, theta_r, phi_r] = self.angles_deg;
        (from_angles_deg(theta_i, phi_i), from_angles_deg(theta_r, phi_r))
    }
}

/// Reads a list of directions; further columns are ignored.
///
/// # Errors
/// An unreadable file, a missing column, or a cell that is no number, with its line.
pub fn read(path: &Path) -> Result<Vec<Row>> {
    let text = files::read_text(path)?;
    let mut lines = text.lines().enumerate();
    let header: Vec<&str> = lines.next().map_or(Vec::new(), |(_, line)| line.split(',').map(str::trim).collect());
    let mut positions = [0; 4];
    for (position, name) in positions.iter_mut().zip(COLUMNS) {
        *position = header
            .iter()
            .position(|column| column.trim_start_matches('\u{feff}') == name)
            .ok_or_else(|| Error::bad_file(path, format!("the column `{name}` is missing"), FIX))?;
    }
    lines
        .filter(|(_, line)| !line.trim().is_empty())
        .map(|(index, line)| row(path, index + 1, line, &positions))
        .collect()
}

fn row(path: &Path, line_number: usize, line: &str, positions: &[usize; 4]) -> Result<Row> {
    let cells: Vec<&str> = line.split(',').map(str::trim).collect();
    let mut row = Row { cells: Default::default(), angles_deg: [0.0; 4] };
    for (index, &position) in positions.iter().enumerate() {
        let cell = cells.get(position).copied().unwrap_or("");
        let angle = cell.parse().ok().filter(|angle: &f64| angle.is_finite()).ok_or_else(|| {
            let what = format!("line {line_number}: `{cell}` in `{}` is not an angle in degrees", COLUMNS[index]);
            Error::bad_file(path, what, FIX)
        })?;
        row.cells[index] = cell.to_owned();
        row.angles_deg[index] = angle;
    }
    Ok(row)
}

/// The directions as they were read, with further columns: ten significant digits.
pub fn write(rows: &[Row], columns: &[String], values: &[Vec<f64>]) -> String {
    let mut text = format!("{},{}\n", COLUMNS.join(","), columns.join(","));
    for (row, values) in rows.iter().zip(values) {
        text.push_str(&row.cells.join(","));
        for value in values {
            // Writing to a string cannot fail.
            let _ = write!(text, ",{value:.9e}");
        }
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(text: &str) -> (tempfile::TempDir, std::path::PathBuf) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("d.csv");
        std::fs::write(&path, text).unwrap();
        (folder, path)
    }

    #[test]
    fn columns_may_stand_in_any_order() {
        let (_folder, path) = file("Y,phi_i_deg,theta_i_deg,phi_r_deg,theta_r_deg\n9,20,10,40,30.50\n\n");
        let rows = read(&path).unwrap();
        assert_eq!(rows[0].angles_deg, [10.0, 20.0, 30.5, 40.0]);
        let text = write(&rows, &["X".into()], &[vec![0.25]]);
        assert_eq!(text, "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,X\n10,20,30.50,40,2.500000000e-1\n");
    }

    #[test]
    fn faults_are_named_with_their_line() {
        for (text, expected) in [
            ("", "`theta_i_deg` is missing"),
            ("theta_i_deg,phi_i_deg,theta_r_deg\n", "`phi_r_deg` is missing"),
            ("theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg\n1,2,3,4\n1,2,x,4\n", "line 3: `x` in `theta_r_deg`"),
            ("theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg\n1,2,3\n", "line 2: `` in `phi_r_deg`"),
            ("theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg\n1,2,3,nan\n", "line 2: `nan`"),
        ] {
            let (_folder, path) = file(text);
            let message = read(&path).unwrap_err().to_string();
            assert!(message.contains(expected), "{message}");
        }
    }
}
