//! Names of atlases, specimens, and scenes: they become folders and files on any system.

use super::reader::Item;
use crate::error::{Error, Result};
use diffraction_brdf::files;

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
fn made_safe(text: &str) -> String {
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

/// Digits of a digest that tell names apart of which less than all can be kept.
const DIGEST_DIGITS: usize = 8;

/// A name for a file's: itself with `_` for what no name may hold, where that is all that is wrong with it. One that is of another
/// script, too long, begins with a sign or is a device's keeps what can be read of it and takes some digits of its digest, so that
/// the same file has the same name always, and another has another.
pub(crate) fn for_file(text: &str) -> String {
    let name = made_safe(text);
    if text.is_ascii() && fault(&name).is_none() {
        return name;
    }
    let digest = files::sha256_hex(text.as_bytes());
    let readable: String = name.trim_matches(['_', '-']).chars().take(CHARACTERS_MAX - DIGEST_DIGITS - 1).collect();
    let readable = if readable.is_empty() { "scan" } else { &readable };
    format!("{readable}_{}", &digest[..DIGEST_DIGITS])
}

/// A name that `item` leads to, if it can be one.
pub fn checked(item: &Item, name: &str) -> Result<String> {
    match fault(name) {
        None => Ok(name.to_owned()),
        Some(fault) => Err(item.error(fault)),
    }
}

/// What keeps a text from being a name.
fn fault(name: &str) -> Option<String> {
    let begins_well = name.starts_with(|c: char| c.is_ascii_alphanumeric());
    // No dots: a specimen's folder lies beside files such as `atlas.json`.
    if !begins_well || !name.chars().all(safe) || name.len() > CHARACTERS_MAX {
        return Some(format!(
            "becomes a folder's or file's name: it must be 1 to {CHARACTERS_MAX} of the characters \
             a-z, A-Z, 0-9, `_`, and `-`, and begin with a letter or digit; found {:?}",
            name.chars().take(CHARACTERS_MAX).collect::<String>()
        ));
    }
    let lower = name.to_ascii_lowercase();
    let numbered = |device: &str| {
        lower.strip_prefix(device).is_some_and(|rest| rest.len() == 1 && rest.starts_with(|c: char| c.is_ascii_digit()))
    };
    let is_device = RESERVED.contains(&lower.as_str()) || numbered("com") || numbered("lpt");
    is_device.then(|| format!("\"{name}\" is a device's name on some systems; choose another"))
}

/// Refuses a name that is taken, or differs from a taken one in case alone.
pub(crate) fn refuse_repetition<'n>(item: &Item, name: &str, mut taken: impl Iterator<Item = &'n str>) -> Result<()> {
    match taken.find(|other| other.eq_ignore_ascii_case(name)) {
        None => Ok(()),
        Some(other) => Err(repetition(item, name, other, "")),
    }
}

/// Of a name that is another, or differs from it in case alone; `of` says whose names they are.
pub(crate) fn repetition(item: &Item, name: &str, other: &str, of: &str) -> Error {
    item.error(match other == name {
        true => format!("repeats the name \"{name}\"{of}; names must differ"),
        false => format!("\"{name}\" differs from \"{other}\" in case alone{of}, which some systems do not tell apart"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_has_a_name_and_the_same_one_always() {
        for (text, name) in [
            ("Boa 2", "Boa_2"),
            ("scale_017", "scale_017"),
            ("Kölner Dom", "K_lner_Dom_"),
            ("蛇", "scan_"),
            ("-x", "x_"),
            ("", "scan_"),
            ("nul", "nul_"),
            (&"a".repeat(200), "aaaa"),
        ] {
            let made = for_file(text);
            assert!(fault(&made).is_none() && made.starts_with(&name[..name.len().min(12)]), "{text:?} {made}");
            assert_eq!(made, for_file(text));
        }
        // What looks the same stays apart.
        assert_ne!(for_file("Kölner Dom"), for_file("Kålner Dom"));
        assert_ne!(for_file("蛇"), for_file("龍"));
    }
}
