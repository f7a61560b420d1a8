//! Small pieces of SVG: escaped text, coordinates, ticks.

/// Text that is safe in XML content and attributes. Characters XML cannot hold become U+FFFD.
pub(crate) fn escape(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            _ => safe.push(printable(character)),
        }
    }
    safe
}

/// The character itself, or U+FFFD where neither XML nor HTML has a place for it.
pub(crate) fn printable(character: char) -> char {
    let forbidden = (character.is_control() && !matches!(character, '\n' | '\t'))
        || matches!(character as u32 & 0xffff, 0xfffe | 0xffff)
        || ('\u{fdd0}'..='\u{fdef}').contains(&character);
    if forbidden { '\u{fffd}' } else { character }
}

/// A coordinate with at most two decimals, so that the same picture gives the same bytes everywhere.
pub fn at(value: f64) -> String {
    let text = format!("{:.2}", if value.is_finite() { value } else { 0.0 });
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".into() } else { short.into() }
}

/// The largest of 1, 2, 5 times a power of ten that does not exceed `value` (which is positive).
pub(crate) fn round_step(value: f64) -> f64 {
    if !(value.is_finite() && value > 0.0) {
        return 1.0;
    }
    let exponent = value.log10().floor() as i32;
    // A grain of tolerance: 0.5 must not become 0.2 because its logarithm was rounded.
    let reach = value * (1.0 + 1e-9);
    [exponent + 1, exponent, exponent - 1]
        .iter()
        .flat_map(|&power| [5.0, 2.0, 1.0].map(|digit| power_of_ten(digit, power)))
        .find(|&step| step <= reach)
        .unwrap_or(value)
}

/// Round numbers within `[low, high]`, at most `wanted` steps apart, with the decimals they need.
pub(crate) fn ticks(low: f64, high: f64, wanted: usize) -> Vec<(f64, String)> {
    let span = high - low;
    if !(span.is_finite() && span > 0.0) {
        return Vec::new();
    }
    // The next round number above: within a factor of 2.5 there always is one.
    let least = span / wanted.max(1) as f64;
    let step = [1.0, 2.0, 2.5]
        .map(|factor| round_step(factor * least))
        .into_iter()
        .find(|&step| step >= least * (1.0 - 1e-9))
        .unwrap_or(least);
    let decimals = (-step.log10().floor()).max(0.0) as usize;
    let first = (low / step - 1e-6).ceil() as i64;
    let last = (high / step + 1e-6).floor() as i64;
    (first..=last)
        .map(|index| {
            let value = index as f64 * step;
            let text = format!("{value:.decimals$}").replace('-', "−");
            (value, text)
        })
        .collect()
}

/// `digit · 10^power`, dividing for negative powers so that 0.1 is the nearest number to 0.1.
fn power_of_ten(digit: f64, power: i32) -> f64 {
    if power < 0 { digit / 10f64.powi(-power) } else { digit * 10f64.powi(power) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_and_control_characters_are_harmless() {
        assert_eq!(escape("a<b & \"c\"'"), "a&lt;b &amp; &quot;c&quot;&#39;");
        assert_eq!(escape("bell\u{7} nul\u{0}"), "bell\u{fffd} nul\u{fffd}");
        assert_eq!(escape("line\nµ"), "line\nµ");
    }

    #[test]
    fn steps_are_round_and_never_larger() {
        for (value, step) in [(8.0, 5.0), (5.0, 5.0), (0.5, 0.5), (0.1, 0.1), (1.99, 1.0), (30.0, 20.0)] {
            assert_eq!(round_step(value), step, "{value}");
        }
    }

    #[test]
    fn ticks_cover_the_range() {
        let found: Vec<String> = ticks(-0.4, 0.4, 4).into_iter().map(|tick| tick.1).collect();
        assert_eq!(found, ["−0.4", "−0.2", "0.0", "0.2", "0.4"]);
        assert!(ticks(1.0, 1.0, 4).is_empty());
        assert!(ticks(f64::NAN, 1.0, 4).is_empty());
    }

    #[test]
    fn coordinates_are_short() {
        assert_eq!(at(12.0), "12");
        assert_eq!(at(-0.001), "0");
        assert_eq!(at(3.456), "3.46");
    }
}
