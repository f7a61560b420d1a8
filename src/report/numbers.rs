//! Numbers as people read them: sensible digits, never NaN.

/// What stands for a number that is missing.
pub(crate) const MISSING: &str = "–";

/// `value` to `digits` significant digits: plain between 0.0001 and a million, else with a power of
/// ten. Trailing zeros stay, for they are significant; zero is "0".
pub fn number(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return MISSING.into();
    }
    if value == 0.0 {
        return "0".into();
    }
    let digits = digits.max(1);
    // The exponent comes from the rounded number: 9.99 to two digits is 10, not 10.0.
    let scientific = format!("{:.*e}", digits - 1, value);
    let Some((mantissa, exponent)) = scientific.split_once('e') else {
        return MISSING.into();
    };
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let text = if (-4..6).contains(&exponent) {
        let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
        let plain = format!("{value:.decimals$}");
        group(&plain)
    } else {
        format!("{mantissa} × 10{}", superscript(exponent))
    };
    text.replace('-', "−")
}

/// Like [`number`], without zeros at the end of a decimal fraction: for round numbers.
pub(crate) fn round_number(value: f64, digits: usize) -> String {
    let text = number(value, digits);
    if !text.contains('.') || text.contains('×') {
        return text;
    }
    let short = text.trim_end_matches('0').trim_end_matches('.');
    short.into()
}

/// A relative quantity in per cent: "0.12 %".
pub(crate) fn percent(value: f64) -> String {
    with_unit(value * 100.0, 2, "%")
}

/// A relative quantity that was chosen, in per cent without needless zeros: "0.1 %".
pub(crate) fn round_percent(value: f64) -> String {
    if !value.is_finite() {
        return MISSING.into();
    }
    format!("{}\u{a0}%", round_number(value * 100.0, 3))
}

/// A number and its unit, or a dash alone.
pub(crate) fn with_unit(value: f64, digits: usize, unit: &str) -> String {
    if !value.is_finite() {
        return MISSING.into();
    }
    format!("{}\u{a0}{unit}", number(value, digits))
}

/// A length: nm below 1 µm, then µm, then mm.
pub(crate) fn length_nm(value: f64) -> String {
    match value.abs() {
        size if size >= 999_500.0 => with_unit(value * 1e-6, 3, "mm"),
        size if size >= 999.5 => with_unit(value * 1e-3, 3, "µm"),
        _ => with_unit(value, 3, "nm"),
    }
}

/// A whole number with thin spaces between groups of three digits from five digits on.
pub fn count(value: u64) -> String {
    group(&value.to_string())
}

/// A size in bytes, in binary multiples.
pub fn bytes(value: u64) -> String {
    const UNITS: [&str; 4] = ["KiB", "MiB", "GiB", "TiB"];
    if value < 1024 {
        return format!("{value}\u{a0}bytes");
    }
    let mut size = value as f64;
    let mut unit = 0;
    size /= 1024.0;
    while size >= 999.5 && unit + 1 < UNITS.len() {
        size /= 1024.0;
        unit += 1;
    }
    with_unit(size, 3, UNITS[unit])
}

/// A duration: seconds, then minutes and seconds, then hours and minutes.
pub fn seconds(value: f64) -> String {
    if !value.is_finite() {
        return MISSING.into();
    }
    if value < 0.0005 {
        return "<\u{a0}1\u{a0}ms".into();
    }
    if value < 0.0995 {
        return with_unit(value * 1e3, 2, "ms");
    }
    if value < 99.5 {
        return with_unit(value, 2, "s");
    }
    let whole = value.round() as u64;
    if whole < 3600 {
        return format!("{}\u{a0}min {:02}\u{a0}s", whole / 60, whole % 60);
    }
    let minutes = (value / 60.0).round() as u64;
    format!("{}\u{a0}h {:02}\u{a0}min", minutes / 60, minutes % 60)
}

/// An exponent in raised digits.
pub(crate) fn superscript(exponent: i32) -> String {
    exponent
        .to_string()
        .chars()
        .map(|character| match character.to_digit(10) {
            Some(digit) => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize],
            None => '⁻',
        })
        .collect()
}

fn group(plain: &str) -> String {
    let (sign, unsigned) = match plain.strip_prefix('-') {
        Some(rest) => ("-", rest),
        None => ("", plain),
    };
    let (whole, fraction) =
        unsigned.split_once('.').map_or((unsigned, String::new()), |(whole, rest)| (whole, format!(".{rest}")));
    if whole.len() < 5 {
        return plain.into();
    }
    let mut grouped = String::from(sign);
    for (index, digit) in whole.chars().enumerate() {
        if index > 0 && (whole.len() - index).is_multiple_of(3) {
            grouped.push('\u{202f}');
        }
        grouped.push(digit);
    }
    grouped + &fraction
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn significant_digits() {
        for (value, digits, text) in [
            (0.0, 3, "0"),
            (1.0, 3, "1.00"),
            (9.996, 3, "10.0"),
            (-0.25, 2, "−0.25"),
            (1234.4, 3, "1234"),
            (12_345.6, 3, "12\u{202f}346"),
            (0.001234, 2, "0.0012"),
            (0.000_123_4, 2, "0.00012"),
            (0.000_012_34, 2, "1.2 × 10⁻⁵"),
            (9.99e-4, 2, "0.0010"),
            (6.5e9, 2, "6.5 × 10⁹"),
        ] {
            assert_eq!(number(value, digits), text, "{value} to {digits}");
        }
    }

    #[test]
    fn round_numbers_lose_zeros_of_the_fraction_only() {
        for (value, text) in
            [(20.0, "20"), (100.0, "100"), (0.5, "0.5"), (2.25, "2.25"), (0.0, "0"), (1e-5, "1.00 × 10⁻⁵")]
        {
            assert_eq!(round_number(value, 3), text);
        }
    }

    #[test]
    fn nothing_prints_as_nan() {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(number(value, 3), MISSING);
            assert_eq!(percent(value), MISSING);
            assert_eq!(round_percent(value), MISSING);
            assert_eq!(length_nm(value), MISSING);
            assert_eq!(seconds(value), MISSING);
        }
    }

    #[test]
    fn units_change_where_they_should() {
        assert_eq!(length_nm(314.0), "314\u{a0}nm");
        assert_eq!(length_nm(1141.0), "1.14\u{a0}µm");
        assert_eq!(length_nm(999.7), "1.00\u{a0}µm");
        assert_eq!(bytes(512), "512\u{a0}bytes");
        assert_eq!(bytes(9_646_899), "9.20\u{a0}MiB");
        assert_eq!(bytes(1_048_400), "1.00\u{a0}MiB");
        assert_eq!(seconds(0.0042), "4.2\u{a0}ms");
        assert_eq!(seconds(12.34), "12\u{a0}s");
        assert_eq!(seconds(99.6), "1\u{a0}min 40\u{a0}s");
        assert_eq!(seconds(7260.0), "2\u{a0}h 01\u{a0}min");
        assert_eq!(percent(0.0012), "0.12\u{a0}%");
        assert_eq!(round_percent(1e-3), "0.1\u{a0}%");
        assert_eq!(count(61_000_000), "61\u{202f}000\u{202f}000");
        assert_eq!(count(6100), "6100");
    }
}
