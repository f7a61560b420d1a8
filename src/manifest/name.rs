//! Names of atlases, specimens, and scenes: they become folders and files on any system.

use super::reader::Item;
use crate::error::Result;

/// Longest name.
const CHARACTERS_MAX: usize = 64;

/// Names that some systems keep for devices.
const RESERVED: &[&str] = &["con", "prn", "aux", "nul"];

/// Reads a name made of letters a-z, digits, `_`, and `-`, beginning with a letter or digit.
pub fn read(item: &Item) -> Result<String> {
    checked(item, item.text()?)
}

fn safe(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_' || c == '-'
}

/// A text with `_` in place of every run of characters that no name may hold.
pub(crate) fn made_safe(text: &str) -> String {
    let mut name = String::new();
    for c in text.chars() {
        match (safe(c), name.ends_with('_')) {
            (true, _) => name.push(c),
            (false, false) => name.push('_'),
            (false, true) => {}
        }
    }
    name
}

/// A name that `item` leads to, if it can be one.
pub fn checked(item: &Item, name: &str) -> Result<String> {
    let begins_well = name.starts_with(|c: char| c.is_ascii_alphanumeric());
    // No dots: a specimen's folder lies beside files such as `atlas.json`.
    if !begins_well || !name.chars().all(safe) || name.len() > CHARACTERS_MAX {
        return Err(item.error(format!(
            "becomes a folder's or file's name: it must be 1 to {CHARACTERS_MAX} of the characters \
             a-z, A-Z, 0-9, `_`, and `-`, and begin with a letter or digit; found {:?}",
            name.chars().take(CHARACTERS_MAX).collect::<String>()
        )));
    }
    let lower = name.to_ascii_lowercase();
    let numbered = |device: &str| {
        lower.strip_prefix(device).is_some_and(|rest| rest.len() == 1 && rest.starts_with(|c: char| c.is_ascii_digit()))
    };
    if RESERVED.contains(&lower.as_str()) || numbered("com") || numbered("lpt") {
        return Err(item.error(format!("\"{name}\" is a device's name on some systems; choose another")));
    }
    Ok(name.to_owned())
}

/// Refuses a name that is taken, or differs from a taken one in case alone.
pub(crate) fn refuse_repetition<'n>(item: &Item, name: &str, mut taken: impl Iterator<Item = &'n str>) -> Result<()> {
    match taken.find(|other| other.eq_ignore_ascii_case(name)) {
        None => Ok(()),
        Some(other) if other == name => Err(item.error(format!("repeats the name \"{name}\"; names must differ"))),
        Some(other) => Err(item
            .error(format!("\"{name}\" differs from \"{other}\" in case alone, which some systems do not tell apart"))),
    }
}
