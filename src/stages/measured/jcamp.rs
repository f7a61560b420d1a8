//! Spectra in JCAMP-DX, as McDonald and Wilks define it (Applied Spectroscopy 42, 1988, 151): plain numbers, not the packed forms.

use super::measurement::Series;

/// Whether a text is JCAMP-DX: such files begin with a title.
pub(super) fn is_jcamp(text: &str) -> bool {
    let start: String = text.trim_start().chars().take(8).collect();
    start.to_uppercase().starts_with("##TITLE")
}

/// The first block of data in a file.
///
/// # Errors
/// What is missing or of an unknown kind, in words.
pub(super) fn series(text: &str) -> Result<Series, String> {
    let records = records(text);
    let labelled = |label: &str| records.iter().find(|(known, _)| known == label).map(|(_, value)| value.trim());
    let number = |label: &str, default: f64| match labelled(label) {
        None => Ok(default),
        Some(value) => value.parse::<f64>().map_err(|_| format!("its {label} is no number: `{value}`")),
    };
    let (x_factor, y_factor) = (number("XFACTOR", 1.0)?, number("YFACTOR", 1.0)?);
    let (x, y) = match (labelled("XYDATA"), labelled("XYPOINTS")) {
        (Some(data), _) => {
            let [first, last, points] =
                [number("FIRSTX", f64::NAN)?, number("LASTX", f64::NAN)?, number("NPOINTS", f64::NAN)?];
            let y = ordinates(body(data, "(X++(Y..Y))")?)?;
            if y.len() < 2 || y.len() as f64 != points || !(first.is_finite() && last.is_finite()) {
                return Err(format!("its FIRSTX, LASTX and NPOINTS do not describe the {} values of XYDATA", y.len()));
            }
            let step = (last - first) / (points - 1.0);
            ((0..y.len()).map(|index| first + step * index as f64).collect(), y)
        }
        (None, Some(points)) => {
            let pairs = pairs(body(points, "(XY..XY)")?)?;
            (
                pairs.iter().map(|pair| x_factor * pair[0]).collect::<Vec<_>>(),
                pairs.iter().map(|pair| pair[1]).collect(),
            )
        }
        (None, None) => return Err("it is JCAMP-DX and holds neither XYDATA nor XYPOINTS".into()),
    };
    let to_nm = in_nm(labelled("XUNITS").unwrap_or("NANOMETERS"))?;
    Ok(Series {
        wavelength_nm: x.into_iter().map(to_nm).collect(),
        values: y.into_iter().map(|value| y_factor * value).collect(),
        name: labelled("YUNITS").unwrap_or_default().to_lowercase(),
    })
}

/// Labels without blanks and signs in upper case, and what follows each up to the next; comments (`$$`) left out.
fn records(text: &str) -> Vec<(String, String)> {
    let mut records: Vec<(String, String)> = Vec::new();
    for line in text.lines() {
        let line = line.split("$$").next().unwrap_or("");
        match line.trim_start().strip_prefix("##").and_then(|rest| rest.split_once('=')) {
            Some((label, value)) => {
                let label = label.chars().filter(|c| c.is_alphanumeric()).collect::<String>().to_uppercase();
                records.push((label, format!("{value}\n")));
            }
            None => records.iter_mut().next_back().into_iter().for_each(|(_, value)| {
                value.push_str(line);
                value.push('\n');
            }),
        }
    }
    records
}

/// The lines of data after the words that say their form.
fn body<'a>(data: &'a str, form: &str) -> Result<&'a str, String> {
    let (words, body) = data.split_once('\n').unwrap_or((data, ""));
    match words.split_whitespace().collect::<String>().to_uppercase() == form {
        true => Ok(body),
        false => Err(format!("its data have the form `{}`; {form} is read", words.trim())),
    }
}

/// What turns the abscissa into nm.
fn in_nm(unit: &str) -> Result<fn(f64) -> f64, String> {
    let unit: String = unit.chars().filter(|c| !c.is_whitespace()).collect::<String>().to_uppercase();
    match unit.as_str() {
        "NANOMETERS" | "NANOMETRES" | "NM" => Ok(|nm| nm),
        "MICROMETERS" | "MICROMETRES" | "UM" => Ok(|um| 1e3 * um),
        "1/CM" | "CM-1" => Ok(|per_cm| 1e7 / per_cm),
        other => Err(format!("its XUNITS are `{other}`; nanometers, micrometers and 1/cm are read")),
    }
}

/// Lines of an abscissa and ordinates: blanks separate numbers, or their signs do.
fn ordinates(body: &str) -> Result<Vec<f64>, String> {
    let mut values = Vec::new();
    for line in body.lines() {
        values.extend(plain_numbers(line)?.into_iter().skip(1));
    }
    Ok(values)
}

fn pairs(body: &str) -> Result<Vec<[f64; 2]>, String> {
    let mut numbers = Vec::new();
    for line in body.lines() {
        numbers.extend(plain_numbers(&line.replace([',', ';'], " "))?);
    }
    if !numbers.len().is_multiple_of(2) {
        return Err("its XYPOINTS hold an odd number of numbers".into());
    }
    Ok(numbers.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect())
}

/// Numbers of a line; `?` stands for one that was not measured. Letters in place of digits are those of the packed forms.
fn plain_numbers(line: &str) -> Result<Vec<f64>, String> {
    let mut separated = String::with_capacity(line.len() + 8);
    let mut before = ' ';
    for character in line.chars() {
        // A sign begins a number, but for that of an exponent.
        if matches!(character, '+' | '-') && !matches!(before, 'E' | 'e') {
            separated.push(' ');
        }
        separated.push(character);
        before = character;
    }
    let number = |word: &str| match word {
        "?" => Ok(f64::NAN),
        word => word.parse::<f64>().ok().filter(|value| value.is_finite()).ok_or_else(|| {
            format!("`{word}` is no plain number: its data are packed (SQZ, DIF or DUP); export it as (XY..XY)")
        }),
    };
    separated.split_whitespace().map(number).collect()
}
