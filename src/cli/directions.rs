//! Lists of directions as CSV: read from a file, and written with values beside them.

use std::fs::File;
use std::path::Path;

use diffraction_brdf::direction::{Vec3, from_angles_deg, normalise};
use diffraction_brdf::error::{Error, Result};
use diffraction_build::ground::csv;

/// The columns of a pair of directions, in degrees.
const ANGLES: [&str; 4] = ["theta_i_deg", "phi_i_deg", "theta_r_deg", "phi_r_deg"];
/// Or as vectors to the light and to the viewer, of any length.
const VECTORS: [&str; 6] = ["wi_x", "wi_y", "wi_z", "wo_x", "wo_y", "wo_z"];

/// What stands for standard input in a path's place.
const STANDARD_INPUT: &str = "-";

const FIX: &str = "The first line names the columns theta_i_deg, phi_i_deg, theta_r_deg, phi_r_deg, in degrees, or wi_x, wi_y, \
                   wi_z, wo_x, wo_y, wo_z, vectors of any length; each other line holds one number for each.";

/// One pair of directions, as written.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Row {
    /// The cells of its columns, word for word but for decimal commas.
    pub cells: Vec<String>,
    /// Their numbers: four angles in degrees, or the components of two vectors.
    pub numbers: Vec<f64>,
}

impl Row {
    /// Unit vectors to the light and to the viewer.
    pub(crate) fn pair(&self) -> (Vec3, Vec3) {
        match self.numbers[..] {
            [theta_i, phi_i, theta_r, phi_r] => (from_angles_deg(theta_i, phi_i), from_angles_deg(theta_r, phi_r)),
            [ref wi @ .., x, y, z] => (unit([wi[0], wi[1], wi[2]]), unit([x, y, z])),
            _ => unreachable!("a row has as many numbers as its list has columns"),
        }
    }
}

/// Largest azimuth, either way.
const PHI_MAX_DEG: f64 = 360.0;

/// Largest list that is read: some million directions.
const BYTES_MAX: u64 = 64 << 20;

/// A vector's direction; its largest component is brought to 1 first, so that no square overflows.
fn unit(vector: Vec3) -> Vec3 {
    let largest = vector.iter().fold(0f64, |largest, component| largest.max(component.abs()));
    normalise(vector.map(|component| component / largest))
}

/// A list of directions.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Directions {
    /// Names of the columns that hold them.
    pub columns: &'static [&'static str],
    /// The pairs, in the order of the list.
    pub rows: Vec<Row>,
    /// Names of the columns that are not used.
    pub ignored: Vec<String>,
}

/// Reads a list of directions in any of the forms that measured reflectance may have: separated by commas, semicolons or
/// tabs, with comments. Further columns are not used. The path `-` is standard input.
///
/// # Errors
/// An unreadable file, a missing column, or a cell that is no angle above the surface, with its line.
pub(crate) fn read(path: &Path) -> Result<Directions> {
    let standard_input = path == Path::new(STANDARD_INPUT);
    let path = if standard_input { Path::new("standard input") } else { path };
    // A pipe is as good as a file where its end is.
    let text = if standard_input {
        csv::read_stream(path, std::io::stdin().lock(), BYTES_MAX)?
    } else {
        let file = File::open(path).map_err(|error| Error::disk(path, "read", error))?;
        csv::read_stream(path, file, BYTES_MAX)?
    };
    let mut lines = csv::lines(&text);
    let header = lines.next().map_or("", |(_, line)| line);
    let table = Table::new(path, header)?;
    let rows = lines.map(|(number, line)| table.row(number, line)).collect::<Result<_>>()?;
    let names = csv::cells(header, table.separator).into_iter().enumerate();
    let ignored = names.filter(|(index, (_, name))| !name.is_empty() && !table.positions.contains(index));
    Ok(Directions {
        columns: table.columns,
        rows,
        ignored: ignored.map(|(_, (_, name))| format!("`{name}`")).collect(),
    })
}

/// A file being read.
struct Table<'a> {
    path: &'a Path,
    separator: char,
    /// Cells in a line, the columns that are read, and where these lie.
    cells: usize,
    columns: &'static [&'static str],
    positions: Vec<usize>,
}

impl<'a> Table<'a> {
    fn new(path: &'a Path, header: &str) -> Result<Self> {
        let separator = csv::separator(header);
        let names: Vec<String> =
            csv::cells(header, separator).into_iter().map(|(_, name)| name.to_lowercase()).collect();
        // Angles where both are there: the vectors beside them are then one more column each.
        let is_there = |name: &&str| names.iter().any(|column| column == name);
        let columns: &[&str] =
            if VECTORS.iter().any(is_there) && !ANGLES.iter().all(is_there) { &VECTORS } else { &ANGLES };
        let position = |name: &&str| {
            let found = names.iter().position(|column| column == name);
            found.ok_or_else(|| Error::bad_file(path, format!("the column `{name}` is missing"), FIX))
        };
        let positions = columns.iter().map(position).collect::<Result<_>>()?;
        Ok(Self { path, separator, cells: names.len(), columns, positions })
    }

    fn row(&self, number: usize, line: &str) -> Result<Row> {
        let wrong = |what: String| Error::bad_file(self.path, format!("line {number}: {what}"), FIX);
        let cells = csv::row_cells(line, self.separator, self.cells).map_err(wrong)?;
        let is_vectors = self.columns.len() == VECTORS.len();
        let what = if is_vectors { "a number" } else { "an angle in degrees" };
        let mut row = Row { cells: Vec::new(), numbers: Vec::new() };
        for (index, &position) in self.positions.iter().enumerate() {
            let (cell, name) = (cells[position].1, self.columns[index]);
            let number = csv::number(cell, self.separator)
                .ok_or_else(|| wrong(format!("`{cell}` in `{name}` is not {what}")))?;
            let allowed = if is_vectors { below(index, number) } else { beyond(index, number) };
            if let Some(allowed) = allowed {
                return Err(wrong(format!("`{name}` must {allowed}; found {cell}")));
            }
            row.cells.push(csv::with_point(cell, self.separator));
            row.numbers.push(number);
        }
        let (wi, wo) = row.pair();
        if !(wi[2] > 0.0 && wo[2] > 0.0) {
            return Err(wrong("a direction lies so near the horizon that it is on it".into()));
        }
        Ok(row)
    }
}

/// What a component of this column must be, where it is not: directions point above the horizon.
fn below(column: usize, component: f64) -> Option<String> {
    if !component.is_finite() {
        return Some("be finite".into());
    }
    (column % 3 == 2 && component <= 0.0).then(|| "be above 0, so that the direction lies above the horizon".into())
}

/// What an angle of this column must be, where it is not: thetas lie above the horizon, where nothing is lit or seen.
fn beyond(column: usize, angle_deg: f64) -> Option<String> {
    if column % 2 == 1 {
        return (angle_deg.abs() > PHI_MAX_DEG).then(|| format!("lie between -{PHI_MAX_DEG} and {PHI_MAX_DEG}"));
    }
    let above = angle_deg.abs() < 90.0 && from_angles_deg(angle_deg, 0.0)[2] > 0.0;
    (!above).then(|| "lie above the horizon, between -90 and 90 with neither included".into())
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
        let Directions { rows, ignored, .. } = read(&path).unwrap();
        assert_eq!(rows[0].numbers, [10.0, 20.0, 30.5, 40.0]);
        assert_eq!(rows[0].cells.join(","), "10,20,30.50,40");
        assert_eq!(ignored, ["`Y`"]);
    }

    #[test]
    fn vectors_of_any_length_are_directions() {
        let (_folder, path) = file("wo_z,wo_y,wo_x,wi_x,wi_y,wi_z,Y\n0.5,0,0,3e200,0,4e200,1\n");
        let Directions { columns, rows, ignored } = read(&path).unwrap();
        assert_eq!((columns, &ignored[..]), (&VECTORS[..], &["`Y`".to_owned()][..]));
        let (wi, wo) = rows[0].pair();
        assert!((wi[0] - 0.6).abs() < 1e-15 && (wi[2] - 0.8).abs() < 1e-15 && wo == [0.0, 0.0, 1.0], "{wi:?}");
        assert_eq!(rows[0].cells, ["3e200", "0", "4e200", "0", "0", "0.5"]);
        let (_folder, path) = file("wi_x,theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg\n9,1,2,3,4\n");
        assert_eq!(read(&path).unwrap().columns, ANGLES, "angles where all are there");
        for (row, expected) in [
            ("0,0,1,0,0,0", "`wo_z` must be above 0"),
            ("0,0,1,0,x,1", "`x` in `wo_y` is not a number"),
            ("1e300,0,1e-300,0,0,1", "on it"),
        ] {
            let (_folder, path) = file(&format!("wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\n{row}\n"));
            let message = read(&path).unwrap_err().to_string();
            assert!(message.contains("line 2: ") && message.contains(expected), "{message}");
        }
        let (_folder, path) = file("wi_x,wi_y,wi_z,wo_x,wo_y\n");
        assert!(read(&path).unwrap_err().to_string().contains("`wo_z` is missing"));
    }

    #[test]
    fn the_dialects_of_measured_files_are_taken() {
        let plain = "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg\n10,20,-30.5,40\n";
        let (_folder, path) = file(plain);
        let expected = read(&path).unwrap();
        for text in [
            "\u{feff}# lamp A\r\n\"theta_i_deg\", phi_i_deg,Theta_r_deg,phi_r_deg\r\n\r\n# first\r\n10,20,-30.5,40\r\n",
            "theta_i_deg;phi_i_deg;theta_r_deg;phi_r_deg\n10;20;-30,5;40\n",
            "theta_i_deg\tphi_i_deg\ttheta_r_deg\tphi_r_deg\n10\t20\t-30.5\t40\n",
        ] {
            let (_folder, path) = file(text);
            assert_eq!(read(&path).unwrap(), expected, "{text}");
        }
    }

    #[test]
    fn faults_are_named_with_their_line() {
        for (text, expected) in [
            ("", "`theta_i_deg` is missing"),
            ("theta_i_deg,phi_i_deg,theta_r_deg\n", "`phi_r_deg` is missing"),
            ("theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg\n1,2,3,4\n1,2,x,4\n", "line 3: `x` in `theta_r_deg`"),
            (
                "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg\n1,2,3\n",
                "line 2: expected 4 cells as in the line of names, found 3",
            ),
            ("theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg\n1,5,2,3,4\n", "where commas are decimal marks"),
            ("theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg\n1,2,,4\n", "line 2: `` in `theta_r_deg`"),
            (
                "# lab\ntheta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg\n1,2,3,4\n90,2,3,4\n",
                "line 4: `theta_i_deg` must lie above the horizon",
            ),
            (
                "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg\n1,2,-90,4\n",
                "line 2: `theta_r_deg` must lie above the horizon",
            ),
            ("theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg\n1,2,1e300,4\n", "neither included; found 1e300"),
            (
                "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg\n1,2,3,361\n",
                "`phi_r_deg` must lie between -360 and 360; found 361",
            ),
            ("theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg\n1,2,3,nan\n", "line 2: `nan`"),
        ] {
            let (_folder, path) = file(text);
            let message = read(&path).unwrap_err().to_string();
            assert!(message.contains(expected), "{message}");
        }
    }
}
