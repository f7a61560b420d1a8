//! The `material` key: an index, one of the built-in metals and substances, or a CSV file of an index by wavelength.

use std::path::Path;

use super::keys;
use super::reader::{Item, Section};
use super::spectrum_csv;
use crate::error::{Error, Result};
use diffraction_brdf::dispersion::{self, Dispersion, Origin};
use diffraction_build::optics::config::{Material, OpticsConfig};

/// Ways to give a material, as messages show them.
const FORMS: &str = "\"ideal\", { n = 1.56 }, { n = 0.2, k = 3.4 }, { metal = \"gold\" }, { substance = \"chitin\" }, or \
                     { file = \"nk.csv\" }";

/// Columns of a file.
const COLUMNS: [&str; 3] = ["wavelength_nm", "n", "k"];

/// Reads the key into optics whose light is known; paths start at `base`.
pub(super) fn read(item: &Item, base: &Path, optics: &mut OpticsConfig) -> Result<()> {
    if !item.is_table() {
        if item.as_text() == Some("ideal") {
            optics.set_material(Material::Ideal);
            return Ok(());
        }
        return Err(item.error(format!("must be {FORMS}")));
    }
    let section = item.section(&keys::MATERIAL, "{ n = 1.56 }")?;
    let given: Vec<&str> = ["metal", "substance", "file"].into_iter().filter(|key| section.has(key)).collect();
    let Some(&key) = given.first() else {
        optics.set_material(constant(&section)?);
        return Ok(());
    };
    if let Some(other) =
        ["metal", "substance", "file", "n", "k"].into_iter().find(|other| *other != key && section.has(other))
    {
        return Err(
            section.error_at_key(other, format!("`{}.{other}` does not go with `{key}`: one says it all", item.path()))
        );
    }
    let value = section.require(key, "metal = \"gold\"")?;
    let table = match key {
        "file" => file(&value, base)?,
        "metal" => metal(&value)?,
        _ => substance(&value)?,
    };
    optics.set_dispersion(table).map_err(|error| {
        value.error(format!("does not do for this light: {error}; change `wavelength_nm` or the material"))
    })
}

fn constant(section: &Section) -> Result<Material> {
    let n = section.require("n", "{ n = 1.56 }")?;
    match section.get("k") {
        None => Ok(Material::Dielectric {
            n: n.number_within(1.0, dispersion::INDEX_MAX, "for a transparent material (a metal needs `k` too)")?,
        }),
        Some(k) => Ok(Material::Conductor {
            n: n.number_above(0.0, dispersion::INDEX_MAX, "")?,
            k: k.number_above(0.0, dispersion::INDEX_MAX, "(leave `k` out for a transparent material)")?,
        }),
    }
}

fn metal(item: &Item) -> Result<Dispersion> {
    let name = item.text()?;
    Dispersion::metal(name).ok_or_else(|| match Dispersion::substance(name) {
        Some(_) => item.error(format!("names no metal; write `{{ substance = \"{name}\" }}`")),
        None => unknown(item, "metal", name, &dispersion::metals()),
    })
}

fn substance(item: &Item) -> Result<Dispersion> {
    let name = item.text()?;
    Dispersion::substance(name).ok_or_else(|| match name.to_lowercase().contains("keratin") {
        true => item.error(format!(
            "names no known substance: \"{name}\". \"beta_keratin\" is that of feathers and reptiles' scales; how the index of \
             alpha keratin depends on the wavelength is not known here, for hair and wool {{ n = 1.55 }} is usual"
        )),
        false => unknown(item, "substance", name, &dispersion::substances()),
    })
}

fn unknown(item: &Item, kind: &str, name: &str, known: &[&str]) -> Error {
    let hint = keys::nearest(name, known).map_or(String::new(), |near| format!("; did you mean \"{near}\"?"));
    let known: Vec<String> = known.iter().map(|name| format!("\"{name}\"")).collect();
    item.error(format!("names no known {kind}: \"{name}\"{hint} Known are {}", known.join(", ")))
}

/// An index from a file, by its path in the manifest.
fn file(item: &Item, base: &Path) -> Result<Dispersion> {
    let text = item.text_not_empty()?;
    let path = base.join(text);
    let fault = |why: String| item.error(format!("{}: {why}", path.display()));
    let (content, sha256) = spectrum_csv::text_of(&path).map_err(fault)?;
    let rows = checked(&content).map_err(fault)?;
    let name = path.file_name().map_or(text.into(), |name| name.to_string_lossy());
    Dispersion::new(&name, Origin::File { path: text.to_owned(), sha256 }, &rows)
        .map_err(|error| fault(error.to_string()))
}

/// The rows of a file, or the line at fault.
fn checked(text: &str) -> std::result::Result<Vec<[f64; 3]>, String> {
    let mut rows: Vec<[f64; 3]> = Vec::new();
    for (line, row, shown) in spectrum_csv::rows(text, COLUMNS, "three numbers")? {
        if row.iter().any(|cell| cell.is_nan()) {
            return Err(format!("line {line}: expected three numbers; found `{shown}`"));
        }
        if let Some(why) = dispersion::row_fault(rows.last().copied(), row) {
            return Err(format!("line {line}: {why}"));
        }
        rows.push(row);
    }
    if rows.len() < 2 { Err("holds fewer than two wavelengths".to_owned()) } else { Ok(rows) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_of_a_file_name_their_line() {
        let good = "\u{feff}# gilt\nWavelength_nm, n, K\n400, 1.5, 2\n\n500,0.2,3.5\n";
        assert_eq!(checked(good), Ok(vec![[400.0, 1.5, 2.0], [500.0, 0.2, 3.5]]));
        for (text, expected) in [
            ("", "first line must be `wavelength_nm,n,k`"),
            ("wavelength_nm,n\n400,1\n", "first line"),
            ("wavelength_nm,n,k\n400,1,0\n", "fewer than two"),
            ("wavelength_nm,n,k\n400,1,0\n400,1,0\n", "line 3: wavelengths must increase"),
            ("wavelength_nm,n,k\n400,1\n500,1,0\n", "line 2: expected three numbers"),
            ("wavelength_nm,n,k\n400,one,0\n500,1,0\n", "line 2: expected three numbers; found `400,one,0`"),
            ("wavelength_nm,n,k\n# worn\n400,0,3\n500,1,0\n", "line 3: n = 0"),
            ("wavelength_nm,n,k\n400,1,-3\n500,1,0\n", "line 2: k = -3"),
            ("wavelength_nm,n,k\n400,1,3\n500,inf,0\n", "line 3: n = inf"),
            ("wavelength_nm,n,k\n0,1,3\n500,1,0\n", "line 2: the wavelength 0 nm"),
            ("wavelength_nm,n,k\n400,0.7,0\n500,1,0\n", "line 2: n = 0.7 is below 1"),
        ] {
            let message = checked(text).unwrap_err();
            assert!(message.contains(expected), "{text:?}: {message}");
        }
    }
}
