//! Messages of the program as markup: code between backticks, short numbers, real minus signs.

use crate::report::numbers;
use crate::report::svg::escape;

/// Most digits after the point that a number in running text keeps; longer ones are how a computer writes a fraction.
const DECIMALS_MAX: usize = 6;

/// A message as HTML: what stands between backticks is code and stays as it is, numbers elsewhere are shortened.
pub(crate) fn prose(text: &str) -> String {
    let parts: Vec<&str> = text.split('`').collect();
    // A backtick without a partner is one of the text's own.
    let is_paired = parts.len() % 2 == 1;
    if !is_paired {
        return escape(&short_numbers(text));
    }
    let part = |(index, part): (usize, &&str)| match index % 2 {
        0 => escape(&short_numbers(part)),
        _ => format!("<code>{}</code>", escape(part)),
    };
    parts.iter().enumerate().map(part).collect()
}

/// The text with every number in it as people write it: `2.1e-3` becomes 0.0021, `48.798798798798806` becomes 48.8.
fn short_numbers(text: &str) -> String {
    let mut short = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        let (before, from) = rest.split_at(start);
        short += before;
        // A digit within a name or a path is none of a number.
        let is_word = before.chars().next_back().is_some_and(|c| c.is_alphanumeric() || matches!(c, '_' | '.' | '/'));
        let end = number_end(from);
        let (number, after) = from.split_at(end);
        let goes_on = after.chars().next().is_some_and(|c| c.is_alphanumeric() || c == '_');
        short += &match is_word || goes_on {
            true => number.to_owned(),
            false => shortened(number).unwrap_or_else(|| number.to_owned()),
        };
        rest = after;
    }
    short + rest
}

/// Where a number ends that begins the text: digits, a fraction, an exponent.
fn number_end(text: &str) -> usize {
    let digits = |from: usize| from + text[from..].bytes().take_while(u8::is_ascii_digit).count();
    let mut end = digits(0);
    if text[end..].starts_with('.') && digits(end + 1) > end + 1 {
        end = digits(end + 1);
    }
    let exponent = text[end..].strip_prefix('e').map(|after| usize::from(after.starts_with('-')) + 1);
    match exponent {
        Some(sign) if digits(end + sign) > end + sign => digits(end + sign),
        _ => end,
    }
}

/// A number with an exponent, or with more decimals than anybody reads, in fewer; `None` for one that is short.
fn shortened(number: &str) -> Option<String> {
    let decimals = number.split_once('.').map_or(0, |(_, fraction)| fraction.len());
    let has_exponent = number.contains('e');
    if !has_exponent && decimals <= DECIMALS_MAX {
        return None;
    }
    let value: f64 = number.parse().ok()?;
    let digits = if has_exponent { 2 } else { 4 };
    Some(numbers::round_number(value, digits))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn code_is_code_and_markup_is_harmless() {
        assert_eq!(prose("add `pitch_nm = N` <here>"), "add <code>pitch_nm = N</code> &lt;here&gt;");
        assert_eq!(prose("one ` alone & 1"), "one ` alone &amp; 1");
        assert_eq!(prose("`1e-3` and 1e-3"), "<code>1e-3</code> and 0.001");
    }

    #[test]
    fn numbers_are_as_people_write_them() {
        for (text, short) in [
            ("shift one in twenty by 2.1e-3 or more", "shift one in twenty by 0.0021 or more"),
            ("0.0e0", "0"),
            ("48.798798798798806 nm", "48.8 nm"),
            ("3.132 µm at 60, 75.5.", "3.132 µm at 60, 75.5."),
            ("3.0e-9", "3.0 × 10⁻⁹"),
            ("scan_1e-3.tif, a/2.00000000001, v0001, 16-bit", "scan_1e-3.tif, a/2.00000000001, v0001, 16-bit"),
            ("f32 1e", "f32 1e"),
        ] {
            assert_eq!(short_numbers(text), short);
        }
    }
}
