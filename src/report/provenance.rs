//! What the report says about where a scan comes from.

use crate::report::facts::{Fact, fact};
use crate::report::numbers;

/// Most characters of a number that is quoted as it is; a longer one is how a computer writes a fraction.
const QUOTED_MAX: usize = 9;

/// The provenance of one scan: every entry of the JSON object, in its order. Empty entries, and what holds of nearly every
/// file, are left out.
pub(crate) fn of_scan(scan: &serde_json::Value) -> Vec<Fact> {
    let Some(entries) = scan.as_object() else {
        return vec![fact("Provenance", value_text(scan))];
    };
    entries.iter().filter_map(|(name, value)| entry(name, value)).collect()
}

/// An entry in words; `None` for what need not be said.
fn entry(name: &str, value: &serde_json::Value) -> Option<Fact> {
    use serde_json::Value;
    let is_empty = match value {
        Value::Null => true,
        Value::Array(items) => items.is_empty(),
        _ => false,
    };
    // Warnings stand with the specimen's.
    if is_empty || name == "warnings" {
        return None;
    }
    let pair = |unit: &str| match value.as_array().map(Vec::as_slice) {
        Some([x, y]) if x == y => format!("{}{unit}", value_text(x)),
        Some([x, y]) => format!("{} × {}{unit}", value_text(x), value_text(y)),
        _ => value_text(value) + unit,
    };
    let count = value.as_u64();
    Some(match name {
        "file_name" => fact("File", value_text(value)),
        "sha256" => fact("SHA-256", value_text(value)),
        "format" => fact("Format", value_text(value)),
        "page" if count == Some(0) => return None,
        "page" => fact("Page", count.map_or_else(|| value_text(value), |page| (page + 1).to_string())),
        "sample_format" => fact("Numbers", samples(&value_text(value))),
        "size" => match value.as_array().map(Vec::as_slice) {
            Some([x, y]) => fact("Samples", format!("{} × {}", value_text(x), value_text(y))),
            _ => fact("Samples", value_text(value)),
        },
        "pitch_nm" => fact("Pitch", pair("\u{a0}nm")),
        "pitch_from" => fact("Pitch said by", said_by(&value_text(value))),
        "height_from" => fact("Heights said by", said_by(&value_text(value))),
        "missing_samples" if count == Some(0) => fact("Missing samples", "none".into()),
        "missing_samples" => fact("Missing samples", value_text(value)),
        "channel" => fact("Channel", value_text(value)),
        _ => fact(&plain(name), value_text(value)),
    })
}

/// A key as a name.
fn plain(key: &str) -> String {
    let words = key.replace('_', " ");
    let mut characters = words.chars();
    characters.next().map_or_else(String::new, |first| first.to_uppercase().chain(characters).collect())
}

/// "file: ImageJ description" as "the file (ImageJ description)".
fn said_by(text: &str) -> String {
    match text.split_once(": ") {
        Some((who @ ("file" | "manifest"), what)) => format!("the {who} ({})", what.replace('_', " ")),
        _ => text.to_owned(),
    }
}

/// The type of a file's numbers in words.
fn samples(word: &str) -> String {
    let kind = match word.as_bytes().first() {
        Some(b'f') => "floats",
        Some(b'u') => "whole numbers from 0",
        Some(b'i') => "whole numbers with a sign",
        _ => return word.to_owned(),
    };
    match word[1..].parse::<u32>() {
        Ok(bits) => format!("{bits}-bit {kind}"),
        Err(_) => word.to_owned(),
    }
}

fn value_text(value: &serde_json::Value) -> String {
    use serde_json::Value;
    match value {
        Value::Null => numbers::MISSING.into(),
        Value::Bool(true) => "yes".into(),
        Value::Bool(false) => "no".into(),
        Value::String(text) => text.clone(),
        Value::Number(number) => {
            let quoted = number.to_string();
            match number.as_f64() {
                Some(value) if quoted.len() > QUOTED_MAX && !number.is_u64() => numbers::round_number(value, 6),
                Some(value) if number.is_f64() && value.fract() == 0.0 => numbers::round_number(value, QUOTED_MAX),
                _ => quoted,
            }
        }
        Value::Array(items) => {
            let texts: Vec<String> = items.iter().map(value_text).collect();
            texts.join(", ")
        }
        Value::Object(entries) => {
            let texts: Vec<String> = entries
                .iter()
                .map(|(name, value)| format!("{}: {}", name.replace('_', " "), value_text(value)))
                .collect();
            texts.join("; ")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn provenance_is_in_words() {
        let scan = serde_json::json!({
            "file_name": "a.tif", "page": 0, "sample_format": "f32", "size": [512, 64], "pitch_nm": [48.828125, 50.0],
            "pitch_from": "manifest: pitch_nm", "height_from": "file: OME-XML", "missing_samples": 0,
            "channel": null, "warnings": ["x"], "tiled": false, "level": { "slope": 48.798798798798806 }
        });
        let facts: Vec<String> =
            of_scan(&scan).into_iter().map(|fact| format!("{}: {}", fact.name, fact.text)).collect();
        let expected = [
            "File: a.tif",
            "Numbers: 32-bit floats",
            "Samples: 512 × 64",
            "Pitch: 48.828125 × 50\u{a0}nm",
            "Pitch said by: the manifest (pitch nm)",
            "Heights said by: the file (OME-XML)",
            "Missing samples: none",
            "Tiled: no",
            "Level: slope: 48.7988",
        ];
        assert_eq!(facts, expected);
    }
}
