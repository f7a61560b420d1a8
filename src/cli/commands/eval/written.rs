//! Directions with their values as CSV, JSON or NumPy's array, a column or a row for each wavelength.

use std::fmt::Write;

use serde_json::{Map, Value};

use super::values::Table;
use crate::cli::directions::{Directions, Row};

/// A whole table: the directions' columns first, word for word as they were read.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Whole<'a> {
    /// Names of all columns.
    columns: Vec<String>,
    /// The directions of each row, and the values behind them.
    rows: Vec<(&'a Row, Vec<f64>)>,
}

/// Directions with their values; with wavelengths, a row for each of them in place of a column.
pub(super) fn whole<'a>(directions: &'a Directions, table: Table, wavelengths_nm: &[f64]) -> Whole<'a> {
    let Directions { columns, rows, .. } = directions;
    let given = columns.iter().map(ToString::to_string);
    if wavelengths_nm.is_empty() {
        return Whole { columns: given.chain(table.columns).collect(), rows: rows.iter().zip(table.values).collect() };
    }
    // The names that `measured` reads.
    let names = ["wavelength_nm", "brdf_per_sr"].map(String::from);
    let of_pair = |(row, values): (&'a Row, Vec<f64>)| {
        let pairs: Vec<_> = wavelengths_nm.iter().zip(values).map(|(&nm, value)| (row, vec![nm, value])).collect();
        pairs
    };
    Whole { columns: given.chain(names).collect(), rows: rows.iter().zip(table.values).flat_map(of_pair).collect() }
}

impl Whole<'_> {
    /// A line of names, and a line for each row: values with ten significant digits, wavelengths as they were given.
    pub(super) fn to_csv(&self) -> String {
        let mut text = self.columns.join(",") + "\n";
        for (row, values) in &self.rows {
            text.push_str(&row.cells.join(","));
            for (value, column) in values.iter().zip(&self.columns[row.cells.len()..]) {
                // Writing to a string cannot fail.
                let _ = match column.as_str() {
                    "wavelength_nm" => write!(text, ",{value}"),
                    _ if value.is_nan() => write!(text, ",nan"),
                    _ => write!(text, ",{value:.9e}"),
                };
            }
            text.push('\n');
        }
        text
    }

    /// An object per row: angles and values as numbers under the names of the columns, `null` for what is none.
    pub(super) fn to_json(&self) -> Value {
        let object = |(row, values): &(&Row, Vec<f64>)| {
            let numbers = row.numbers.iter().chain(values).map(|&value| Value::from(value));
            Value::Object(self.columns.iter().cloned().zip(numbers).collect::<Map<_, _>>())
        };
        self.rows.iter().map(object).collect()
    }
}

/// NumPy's format, version 1.0 (NEP 1): a structured array with one 64-bit float per column.
pub(super) fn to_npy(whole: &Whole) -> Vec<u8> {
    const ALIGNED: usize = 64;
    let fields: Vec<String> = whole.columns.iter().map(|name| format!("('{name}', '<f8')")).collect();
    let header =
        format!("{{'descr': [{}], 'fortran_order': False, 'shape': ({},), }}", fields.join(", "), whole.rows.len());
    // Magic, version and the length come first; a newline ends the padding.
    let padded = (10 + header.len() + 1).next_multiple_of(ALIGNED) - 10;
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((padded as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.resize(10 + padded - 1, b' ');
    bytes.push(b'\n');
    for (row, values) in &whole.rows {
        row.numbers.iter().chain(values).for_each(|value| bytes.extend(value.to_le_bytes()));
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    fn directions() -> Directions {
        let cells = ["10", "20.0", "-30", "0"].map(String::from).to_vec();
        let rows = vec![Row { cells, numbers: vec![10.0, 20.0, -30.0, 0.0] }];
        Directions { columns: &["theta_i_deg", "phi_i_deg", "theta_r_deg", "phi_r_deg"], rows, ignored: Vec::new() }
    }

    #[test]
    fn angles_come_back_word_for_word_and_values_with_ten_digits() {
        let directions = directions();
        let table = Table { columns: vec!["X".into(), "x".into()], values: vec![vec![0.25, f64::NAN]] };
        let whole = whole(&directions, table, &[]);
        let names = "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg";
        assert_eq!(whole.to_csv(), format!("{names},X,x\n10,20.0,-30,0,2.500000000e-1,nan\n"));
        assert!(whole.to_json()[0]["x"].is_null() && whole.to_json()[0]["X"] == 0.25);
        let bytes = to_npy(&whole);
        assert_eq!((bytes.len() - 6 * 8) % 64, 0);
        assert!(bytes.starts_with(b"\x93NUMPY\x01\x00") && bytes[bytes.len() - 6 * 8 - 1] == b'\n');
        assert_eq!(bytes[bytes.len() - 16..bytes.len() - 8], 0.25f64.to_le_bytes());
    }

    #[test]
    fn the_long_form_has_the_columns_of_measured_files() {
        let directions = directions();
        let table = Table { columns: vec!["f_450_nm".into(), "f_550.5_nm".into()], values: vec![vec![1.0, 2.0]] };
        let text = whole(&directions, table, &[450.0, 550.5]).to_csv();
        assert!(text.starts_with("theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,wavelength_nm,brdf_per_sr\n"), "{text}");
        assert!(text.ends_with("10,20.0,-30,0,450,1.000000000e0\n10,20.0,-30,0,550.5,2.000000000e0\n"), "{text}");
    }
}
