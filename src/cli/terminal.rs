//! The one way out to the terminal: what files and folders put into a text cannot steer it.
//!
//! Names and comments in files may hold escape sequences, bells, or marks that turn the direction of writing; shown raw they move
//! the cursor, rename windows, or make one name look like another. `tests/architecture.rs` holds that nothing else writes.

use std::borrow::Cow;
use std::fmt::Write as _;
use std::io::{self, Write};

/// Writes a remark to stderr. Where that is closed nobody listens, and the exit status still tells.
pub(crate) fn say(text: &str) {
    let _ = io::stderr().lock().write_all(clean(text).as_bytes());
}

/// Writes a result to stdout.
///
/// # Errors
/// The system's, a closed pipe included.
pub(crate) fn print(text: &str) -> io::Result<()> {
    put(clean(text).as_bytes())
}

/// Writes JSON to stdout: what could steer a terminal stands there as `\uXXXX`, which means the same.
///
/// # Errors
/// As [`print()`].
pub(crate) fn print_json(text: &str) -> io::Result<()> {
    put(escaped(text, |out, unit| write!(out, "\\u{unit:04x}")).as_bytes())
}

/// A text in which whatever could steer a terminal is written out, as `\u{1b}`.
pub(crate) fn clean(text: &str) -> Cow<'_, str> {
    escaped(text, |out, unit| write!(out, "\\u{{{unit:x}}}"))
}

fn put(bytes: &[u8]) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    stdout.write_all(bytes)?;
    stdout.flush()
}

/// All of these characters lie below U+10000, so that each is one unit in JSON too.
fn escaped(text: &str, escape: impl Fn(&mut String, u32) -> std::fmt::Result) -> Cow<'_, str> {
    if !text.contains(steers) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len() + 16);
    for character in text.chars() {
        if steers(character) {
            // Writing to a string cannot fail.
            let _ = escape(&mut out, character.into());
        } else {
            out.push(character);
        }
    }
    Cow::Owned(out)
}

/// Whether a character does something to a terminal other than showing a glyph: controls but for new lines and tabs, separators of
/// lines, and marks of direction.
fn steers(character: char) -> bool {
    (character.is_control() && !matches!(character, '\n' | '\t'))
        || matches!(character, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_steers_a_terminal_is_written_out() {
        let hostile = "a\u{1b}]0;owned\u{7}\u{202e}fit.\u{9b}31mx\r\u{2028}y\u{7f}";
        let shown = clean(hostile);
        assert_eq!(shown, "a\\u{1b}]0;owned\\u{7}\\u{202e}fit.\\u{9b}31mx\\u{d}\\u{2028}y\\u{7f}");
        assert!(!shown.contains(steers));
        // Names in any script, tables and units stay as they are.
        let plain = "Schöne Käfer\t蛇 12 µm²\nثعبان\n";
        assert!(matches!(clean(plain), Cow::Borrowed(_)));
    }

    #[test]
    fn json_means_the_same_afterwards() {
        let value = serde_json::json!({ "name": "x\u{202e}\u{9b}\u{7f}\u{1b}y" });
        let text = serde_json::to_string_pretty(&value).unwrap();
        let shown = escaped(&text, |out, unit| write!(out, "\\u{unit:04x}"));
        assert!(!shown.contains(steers) && shown.contains("\\u202e"));
        assert_eq!(serde_json::from_str::<serde_json::Value>(&shown).unwrap(), value);
    }
}
