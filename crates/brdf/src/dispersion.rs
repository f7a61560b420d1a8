//! Materials whose refractive index depends on the wavelength: tables of it, some from the literature.

use serde::{Deserialize, Serialize};

use crate::dispersion_data::{self, Numbers};
use crate::error::{Error, Result};
use crate::material::Material;

/// Largest refractive index, real or imaginary.
pub const INDEX_MAX: f64 = 100.0;

/// Where the numbers of a table come from.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Origin {
    /// A publication.
    Literature(String),
    /// A file.
    File {
        /// Its path as a manifest writes it.
        path: String,
        /// SHA-256 of its bytes, in hexadecimal digits.
        sha256: String,
    },
}

/// The complex refractive index `n + ik` of a material against air at some wavelengths.
///
/// Between them it follows monotone cubics, real and imaginary part each (Fritsch and Butland 1984): smooth, and never beyond the
/// values on either side.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Unchecked")]
pub struct Dispersion {
    name: String,
    origin: Origin,
    wavelength_nm: Vec<f64>,
    n: Vec<f64>,
    k: Vec<f64>,
}

/// A [`Dispersion`] as a file has it.
#[derive(Deserialize)]
struct Unchecked {
    name: String,
    origin: Origin,
    wavelength_nm: Vec<f64>,
    n: Vec<f64>,
    k: Vec<f64>,
}

impl TryFrom<Unchecked> for Dispersion {
    type Error = Error;

    fn try_from(found: Unchecked) -> Result<Self> {
        let Unchecked { name, origin, wavelength_nm, n, k } = found;
        if n.len() != wavelength_nm.len() || k.len() != wavelength_nm.len() {
            return Err(Error::Call(format!("the material {name} has columns of unequal length")));
        }
        let rows = wavelength_nm.into_iter().zip(n).zip(k).map(|((nm, n), k)| [nm, n, k]);
        Self::new(&name, origin, &rows.collect::<Vec<_>>())
    }
}

/// What is wrong with a row after another one, in words; `row` is `[wavelength_nm, n, k]`.
pub fn row_fault(before: Option<[f64; 3]>, row: [f64; 3]) -> Option<String> {
    let [nm, n, k] = row;
    if !(nm.is_finite() && nm > 0.0) {
        return Some(format!("the wavelength {nm} nm is not above 0"));
    }
    if before.is_some_and(|before| before[0] >= nm) {
        return Some(format!("wavelengths must increase; {nm} nm does not"));
    }
    if !(n > 0.0 && n <= INDEX_MAX) {
        return Some(format!("n = {n} is not above 0 and at most {INDEX_MAX}"));
    }
    if !(0.0..=INDEX_MAX).contains(&k) {
        return Some(format!("k = {k} is not between 0 and {INDEX_MAX}"));
    }
    (k == 0.0 && n < 1.0).then(|| format!("n = {n} is below 1 where k is 0"))
}

impl Dispersion {
    /// A table from rows `[wavelength_nm, n, k]`.
    ///
    /// # Errors
    /// [`Error::Call`] for fewer than two rows, wavelengths that do not increase, `n` not above 0, `k` below 0, either above
    /// [`INDEX_MAX`], or `n` below 1 where nothing is absorbed.
    pub fn new(name: &str, origin: Origin, rows: &[[f64; 3]]) -> Result<Self> {
        let fault = |why: String| Error::Call(format!("the material {name}: {why}"));
        if rows.len() < 2 {
            return Err(fault("fewer than two wavelengths".into()));
        }
        let mut before = None;
        for &row in rows {
            if let Some(why) = row_fault(before, row) {
                return Err(fault(why));
            }
            before = Some(row);
        }
        let column = |of: usize| rows.iter().map(|row| row[of]).collect();
        Ok(Self { name: name.into(), origin, wavelength_nm: column(0), n: column(1), k: column(2) })
    }

    /// A built-in metal by its name, one of [`metals`].
    pub fn metal(name: &str) -> Option<Self> {
        built_in(&dispersion_data::METALS, name)
    }

    /// A built-in substance by its name, one of [`substances`]; metals are among them.
    pub fn substance(name: &str) -> Option<Self> {
        built_in(&dispersion_data::OTHERS, name).or_else(|| Self::metal(name))
    }

    /// What it is called.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Where its numbers come from.
    pub fn origin(&self) -> &Origin {
        &self.origin
    }

    /// Shortest and longest wavelength in nm.
    pub fn range_nm(&self) -> [f64; 2] {
        [self.wavelength_nm[0], self.wavelength_nm[self.wavelength_nm.len() - 1]]
    }

    /// Real and imaginary part of the index at a wavelength in nm; `None` outside the table.
    pub fn index_at(&self, wavelength_nm: f64) -> Option<[f64; 2]> {
        let [low, high] = self.range_nm();
        if !(low..=high).contains(&wavelength_nm) {
            return None;
        }
        let above = self.wavelength_nm.partition_point(|&at| at <= wavelength_nm);
        let first = (above - 1).min(self.wavelength_nm.len() - 2);
        Some([&self.n, &self.k].map(|values| monotone_cubic(&self.wavelength_nm, values, first, wavelength_nm)))
    }

    /// The material at a wavelength in nm; transparent where `k` is 0. `None` outside the table.
    pub fn material_at(&self, wavelength_nm: f64) -> Option<Material> {
        let [n, k] = self.index_at(wavelength_nm)?;
        Some(if k == 0.0 { Material::Dielectric { n } } else { Material::Conductor { n, k } })
    }
}

/// Names of the built-in metals.
pub fn metals() -> Vec<&'static str> {
    dispersion_data::METALS.iter().map(|table| table.name).collect()
}

/// Names of all built-in substances, the metals last.
pub fn substances() -> Vec<&'static str> {
    dispersion_data::OTHERS.iter().chain(&dispersion_data::METALS).map(|table| table.name).collect()
}

fn built_in(tables: &[dispersion_data::BuiltIn], name: &str) -> Option<Dispersion> {
    let table = tables.iter().find(|table| table.name == name)?;
    let origin = Origin::Literature(table.citation.into());
    let made = match table.numbers {
        Numbers::Rows(rows) => Dispersion::new(name, origin, rows),
        Numbers::Formula { range_nm: [first, last], n } => {
            let steps = ((last - first) / FORMULA_STEP_NM).round() as usize;
            let at = |step: usize| first + step as f64 * FORMULA_STEP_NM;
            let rows: Vec<[f64; 3]> = (0..=steps).map(|step| [at(step), n(at(step)), 0.0]).collect();
            Dispersion::new(name, origin, &rows)
        }
    };
    // A test makes every one of them.
    made.ok()
}

/// Distance of the wavelengths at which formulas are tabulated, in nm: cubics between them err by less than 1e-5.
const FORMULA_STEP_NM: f64 = 5.0;

/// The cubic between the knots `first` and `first + 1` that has their values and slopes.
fn monotone_cubic(at: &[f64], values: &[f64], first: usize, x: f64) -> f64 {
    let width = at[first + 1] - at[first];
    let t = (x - at[first]) / width;
    let [a, b] = [values[first], values[first + 1]];
    let [da, db] = [first, first + 1].map(|knot| width * slope(at, values, knot));
    let [s, t2] = [1.0 - t, t * t];
    a * (1.0 + 2.0 * t) * s * s + b * t2 * (3.0 - 2.0 * t) + da * t * s * s - db * t2 * s
}

/// Slope at a knot: the weighted harmonic mean of those to both sides, 0 where they point different ways, that of the one side
/// at an end.
fn slope(at: &[f64], values: &[f64], knot: usize) -> f64 {
    let secant = |first: usize| (values[first + 1] - values[first]) / (at[first + 1] - at[first]);
    if knot == 0 {
        return secant(0);
    }
    if knot + 1 == at.len() {
        return secant(knot - 1);
    }
    let [before, after] = [secant(knot - 1), secant(knot)];
    if before * after <= 0.0 {
        return 0.0;
    }
    let [left, right] = [at[knot] - at[knot - 1], at[knot + 1] - at[knot]];
    let [p, q] = [left + 2.0 * right, 2.0 * left + right];
    (p + q) / (p / before + q / after)
}

#[cfg(test)]
#[path = "dispersion_tests.rs"]
mod tests;
