//! The `illuminant` key: a CIE name, a CSV file of samples, or laser lines.

use std::path::Path;

use super::keys;
use super::reader::Item;
use super::spectrum_csv;
use crate::error::Result;
use diffraction_brdf::spectrum::{Illuminant, Line};

/// Shortest and longest wavelength that a manifest may name.
pub const WAVELENGTH_NM: [f64; 2] = [200.0, 2500.0];

/// The range that colour is computed from: light wholly outside it has no XYZ.
pub(crate) const VISIBLE_NM: [f64; 2] = [380.0, 780.0];

/// Names of the CIE illuminants.
const NAMES: &[&str] = &["D65", "A", "E", "F1", "F2", "F3", "F4", "F5", "F6", "F7", "F8", "F9", "F10", "F11", "F12"];

/// Most laser lines.
const LINES_MAX: usize = 1000;

/// Reads the key; paths start at `base`.
pub fn read(item: &Item, base: &Path) -> Result<Illuminant> {
    if item.is_table() {
        return lines(item);
    }
    let Some(text) = item.as_text() else {
        return Err(item.error(
            "must be a name (\"D65\", \"A\", \"E\", \"F1\" to \"F12\"), a CSV file, or lines: { lines_nm = [633] }",
        ));
    };
    named_or_csv(text, base, "{ lines_nm = [633] }").map_err(|why| item.error(why))
}

/// A light by its name, or by a CSV file whose path starts at `base`; `lines` is how laser lines would be written here.
fn named_or_csv(text: &str, base: &Path, lines: &str) -> std::result::Result<Illuminant, String> {
    if let Some(illuminant) = named(text) {
        return Ok(illuminant);
    }
    if text.contains(['.', '/', '\\']) {
        let path = base.join(text);
        return csv(&path).map_err(|why| format!("{}: {why}", path.display()));
    }
    let hint = keys::nearest(text, NAMES).map_or(String::new(), |name| format!("; did you mean \"{name}\"?"));
    Err(format!(
        "names no known illuminant: \"{text}\"{hint} Expected \"D65\", \"A\", \"E\", \"F1\" to \"F12\", \
         a CSV file (its name holds a dot), or lines: {lines}"
    ))
}

/// A light as the command line names it: a name, a CSV file, or the wavelengths in nm of laser lines of equal power.
pub(crate) fn from_argument(text: &str) -> std::result::Result<Illuminant, String> {
    let numbers: Vec<_> = text.split(',').map(|part| part.trim().parse::<f64>()).collect();
    if numbers.iter().any(|number| number.is_err()) {
        return named_or_csv(text, Path::new(""), "632.8, or several as 450,532");
    }
    let mut lines = Vec::new();
    for wavelength_nm in numbers.into_iter().flatten() {
        if !(WAVELENGTH_NM[0]..=WAVELENGTH_NM[1]).contains(&wavelength_nm) {
            let [low, high] = WAVELENGTH_NM;
            return Err(format!("{wavelength_nm} nm is no line between {low} and {high} nm"));
        }
        lines.push(Line { wavelength_nm, power: 1.0 });
    }
    lines.sort_by(|a, b| a.wavelength_nm.total_cmp(&b.wavelength_nm));
    Ok(Illuminant::Lines(lines))
}

fn named(text: &str) -> Option<Illuminant> {
    let index = NAMES.iter().position(|name| *name == text)?;
    Some(match index {
        0 => Illuminant::D65,
        1 => Illuminant::A,
        2 => Illuminant::E,
        f => Illuminant::F(f as u8 - 2),
    })
}

/// Laser lines; sorted by wavelength, so that their order in the manifest changes nothing.
fn lines(item: &Item) -> Result<Illuminant> {
    let section = item.section(&keys::LINES, "{ lines_nm = [633] }")?;
    let given = section.require("lines_nm", "lines_nm = [633]")?;
    let items = given.list()?;
    if items.is_empty() || items.len() > LINES_MAX {
        return Err(given.error(format!("must hold 1 to {LINES_MAX} wavelengths")));
    }
    let powers = section.get("power").map(|power| power.list().map(|list| (list, power)));
    let powers = powers.transpose()?;
    if let Some((list, power)) = &powers
        && list.len() != items.len()
    {
        let (lines, found) = (items.len(), list.len());
        return Err(power.error(format!("must hold one number for each of the {lines} lines; found {found}")));
    }
    let mut lines = Vec::with_capacity(items.len());
    for (index, item) in items.iter().enumerate() {
        let wavelength_nm = item.number_within(WAVELENGTH_NM[0], WAVELENGTH_NM[1], "nm")?;
        let power = match &powers {
            Some((list, _)) => list[index].number_above(0.0, 1e12, "")?,
            None => 1.0,
        };
        if lines.iter().any(|line: &Line| line.wavelength_nm == wavelength_nm) {
            return Err(item.error(format!("repeats the line at {wavelength_nm} nm")));
        }
        lines.push(Line { wavelength_nm, power });
    }
    lines.sort_by(|a, b| a.wavelength_nm.total_cmp(&b.wavelength_nm));
    Ok(Illuminant::Lines(lines))
}

fn csv(path: &Path) -> std::result::Result<Illuminant, String> {
    parse_csv(&spectrum_csv::text_of(path)?.0)
}

/// Reads `wavelength_nm,power` rows.
fn parse_csv(text: &str) -> std::result::Result<Illuminant, String> {
    let (mut wavelength_nm, mut power) = (Vec::new(), Vec::new());
    for (line, [w, p], shown) in spectrum_csv::rows(text, ["wavelength_nm", "power"], "two numbers")? {
        if !(w.is_finite() && w > 0.0 && p.is_finite() && p >= 0.0) {
            return Err(format!(
                "line {line}: expected a wavelength above 0 and a power of at least 0; found `{shown}`"
            ));
        }
        if wavelength_nm.last().is_some_and(|last| *last >= w) {
            return Err(format!("line {line}: wavelengths must increase; {w} nm does not"));
        }
        wavelength_nm.push(w);
        power.push(p);
    }
    if wavelength_nm.len() < 2 {
        return Err("holds fewer than two samples".to_owned());
    }
    Ok(Illuminant::Tabulated { wavelength_nm, power })
}

/// Whether some light falls on the visible part of a range, so that XYZ exists.
pub(crate) fn is_visible(illuminant: &Illuminant, range_nm: [f64; 2]) -> bool {
    let low = range_nm[0].max(VISIBLE_NM[0]);
    let high = range_nm[1].min(VISIBLE_NM[1]);
    match illuminant {
        Illuminant::Lines(lines) => {
            lines.iter().any(|line| (VISIBLE_NM[0]..=VISIBLE_NM[1]).contains(&line.wavelength_nm))
        }
        Illuminant::Tabulated { wavelength_nm, power } => {
            // A linear piece with one positive end is positive wherever it has some length.
            wavelength_nm
                .windows(2)
                .zip(power.windows(2))
                .any(|(w, p)| w[0].max(low) < w[1].min(high) && (p[0] > 0.0 || p[1] > 0.0))
        }
        _ => low < high,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_its_illuminant() {
        assert_eq!(named("D65"), Some(Illuminant::D65));
        assert_eq!(named("A"), Some(Illuminant::A));
        assert_eq!(named("E"), Some(Illuminant::E));
        for f in 1..=12 {
            assert_eq!(named(&format!("F{f}")), Some(Illuminant::F(f)));
        }
        assert_eq!(named("F13"), None);
        assert_eq!(named("d65"), None);
    }

    #[test]
    fn csv_faults_name_their_line() {
        let good = "# lamp\nWavelength_nm, power\n400, 1\n\n500,2.5\n";
        let Ok(Illuminant::Tabulated { wavelength_nm, power }) = parse_csv(good) else { panic!("good CSV refused") };
        assert_eq!((wavelength_nm, power), (vec![400.0, 500.0], vec![1.0, 2.5]));
        for (text, expected) in [
            ("", "first line"),
            ("nm,power\n1,2\n", "first line"),
            ("wavelength_nm,power\n400,1\n", "fewer than two"),
            ("wavelength_nm,power\n400,1\n400,1\n", "line 3: wavelengths must increase"),
            ("wavelength_nm,power\n400,1\n500\n", "line 3: expected two numbers"),
            ("wavelength_nm,power\n400,-1\n500,1\n", "line 2: expected a wavelength above 0"),
            ("wavelength_nm,power\n400,NaN\n500,1\n", "line 2"),
            ("wavelength_nm,power\n400,x\n500,1\n", "line 2"),
        ] {
            let message = parse_csv(text).unwrap_err();
            assert!(message.contains(expected), "{text:?}: {message}");
        }
    }

    #[test]
    fn light_outside_the_visible_range_is_recognised() {
        let range = [380.0, 780.0];
        assert!(is_visible(&Illuminant::D65, range));
        assert!(!is_visible(&Illuminant::D65, [900.0, 1000.0]));
        let line = |wavelength_nm| Illuminant::Lines(vec![Line { wavelength_nm, power: 1.0 }]);
        assert!(is_visible(&line(633.0), range));
        assert!(!is_visible(&line(1064.0), range));
        let table =
            |power: [f64; 3]| Illuminant::Tabulated { wavelength_nm: vec![300.0, 400.0, 500.0], power: power.to_vec() };
        assert!(is_visible(&table([0.0, 1.0, 0.0]), range));
        assert!(!is_visible(&table([0.0, 0.0, 0.0]), range));
        assert!(is_visible(&table([1.0, 0.0, 0.0]), range));
        assert!(!is_visible(&table([1.0, 0.0, 0.0]), [400.0, 500.0]));
    }
}
