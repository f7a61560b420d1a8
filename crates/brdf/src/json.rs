//! JSON files and texts whose bytes depend on nothing but their content.

use std::path::Path;

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

use crate::error::{Error, Result};
use crate::files;

/// One line of pure ASCII with sorted keys: the same text for equal values.
pub fn canonical(value: &Value) -> String {
    ascii(&sorted(value).to_string())
}

/// The value with the keys of every object sorted by their bytes.
fn sorted(value: &Value) -> Value {
    match value {
        Value::Array(items) => Value::Array(items.iter().map(sorted).collect()),
        Value::Object(map) => {
            let mut entries: Vec<_> = map.iter().collect();
            entries.sort_unstable_by_key(|(key, _)| key.as_bytes());
            Value::Object(entries.into_iter().map(|(key, item)| (key.clone(), sorted(item))).collect())
        }
        other => other.clone(),
    }
}

/// Characters beyond ASCII as `\uXXXX`: outside strings JSON has none, so the value stays the same.
fn ascii(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        if character.is_ascii() {
            out.push(character);
        } else {
            for unit in character.encode_utf16(&mut [0; 2]) {
                out.push_str(&format!("\\u{unit:04x}"));
            }
        }
    }
    out
}

/// Indented JSON, fields in the order of the type, numbers in their shortest exact form, a newline at the end.
pub fn pretty<T: Serialize>(value: &T) -> std::result::Result<String, serde_json::Error> {
    serde_json::to_string_pretty(value).map(|text| text + "\n")
}

/// Writes [`pretty`] JSON. A value that would not be read back (a number that is not finite becomes `null`) is
/// refused before anything is written.
pub fn write<T: Serialize + DeserializeOwned>(path: &Path, value: &T) -> Result<()> {
    let text = pretty(value).map_err(|e| unwritable(path, &e))?;
    serde_json::from_str::<T>(&text).map_err(|e| unwritable(path, &e))?;
    files::replace(path, text.as_bytes())
}

fn unwritable(path: &Path, error: &serde_json::Error) -> Error {
    Error::limit(
        format!("{}: a value cannot be written as JSON: {error}", path.display()),
        "A number is not finite: look for extreme values among the specimen's settings.",
    )
}

/// Reads a JSON file; `fix` says what to do where it is damaged.
pub fn read<T: DeserializeOwned>(path: &Path, fix: &str) -> Result<T> {
    let text = files::read_text(path)?;
    serde_json::from_str(&text).map_err(|e| Error::bad_file(path, format!("this is not the JSON expected: {e}"), fix))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn canonical_text_ignores_the_order_of_keys() {
        let a = json!({"b": [1, {"y": 0.1, "x": "µ𝄞\""}], "a": null});
        let b = json!({"a": null, "b": [1, {"x": "µ𝄞\"", "y": 0.1}]});
        assert_eq!(canonical(&a), canonical(&b));
        assert_eq!(canonical(&a), r#"{"a":null,"b":[1,{"x":"\u00b5\ud834\udd1e\"","y":0.1}]}"#);
        assert_eq!(serde_json::from_str::<Value>(&canonical(&a)).unwrap(), a);
        assert_ne!(canonical(&a), canonical(&json!({"a": null, "b": [1, {"x": "m𝄞\"", "y": 0.1}]})));
    }

    #[test]
    fn numbers_come_back_exactly() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("numbers.json");
        let mut random = fastrand::Rng::with_seed(7);
        let numbers: Vec<f64> =
            (0..20_000).map(|_| f64::from_bits(random.u64(..))).filter(|number| number.is_finite()).collect();
        write(&path, &numbers).unwrap();
        assert_eq!(read::<Vec<f64>>(&path, "").unwrap(), numbers);
    }

    #[test]
    fn a_number_that_is_not_finite_is_refused_and_nothing_written() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("numbers.json");
        assert!(write(&path, &vec![1.0, f64::NAN]).is_err());
        assert!(!path.exists());
    }
}
