//! Units of length as scan files spell them.

use serde::{Deserialize, Serialize};

/// A unit of length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum LengthUnit {
    /// Picometre.
    Pm,
    /// Nanometre.
    Nm,
    /// Micrometre.
    Um,
    /// Millimetre.
    Mm,
    /// Centimetre.
    Cm,
    /// Metre.
    M,
    /// Ångström, 0.1 nm.
    Angstrom,
    /// Inch, 25.4 mm.
    Inch,
}

impl LengthUnit {
    /// Length of the unit in nm.
    pub(crate) fn to_nm(self) -> f64 {
        match self {
            Self::Pm => 1e-3,
            Self::Angstrom => 0.1,
            Self::Nm => 1.0,
            Self::Um => 1e3,
            Self::Mm => 1e6,
            Self::Cm => 1e7,
            Self::M => 1e9,
            Self::Inch => 25.4e6,
        }
    }

    /// Reads a unit in its usual spellings, `\u00B5m` and the like included; `None` for anything else.
    /// Symbols are case-sensitive (`Mm` and `PM` are not lengths here), words are not.
    pub fn parse(text: &str) -> Option<Self> {
        let plain = unescape(text.trim());
        match plain.as_str() {
            "pm" => return Some(Self::Pm),
            "nm" => return Some(Self::Nm),
            "um" | "\u{b5}m" | "\u{3bc}m" | "\u{b5}" | "\u{3bc}" => return Some(Self::Um),
            "mm" => return Some(Self::Mm),
            "cm" => return Some(Self::Cm),
            "m" => return Some(Self::M),
            "\u{c5}" | "\u{212b}" | "A\u{30a}" | "Ang" => return Some(Self::Angstrom),
            "in" | "\"" => return Some(Self::Inch),
            _ => {}
        }
        let word = plain.to_lowercase();
        Some(match word.strip_suffix('s').unwrap_or(&word) {
            "picometer" | "picometre" => Self::Pm,
            "nanometer" | "nanometre" => Self::Nm,
            "micron" | "micrometer" | "micrometre" => Self::Um,
            "millimeter" | "millimetre" => Self::Mm,
            "centimeter" | "centimetre" => Self::Cm,
            "meter" | "metre" => Self::M,
            "angstrom" | "\u{e5}ngstr\u{f6}m" => Self::Angstrom,
            "inch" | "inche" => Self::Inch,
            _ => return None,
        })
    }
}

/// Replaces `\uXXXX` by the character it stands for; leaves everything else alone.
pub(super) fn unescape(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find("\\u") {
        plain.push_str(&rest[..at]);
        let code = rest
            .get(at + 2..at + 6)
            .filter(|digits| digits.bytes().all(|digit| digit.is_ascii_hexdigit()))
            .and_then(|digits| u32::from_str_radix(digits, 16).ok())
            .and_then(char::from_u32);
        if let Some(character) = code {
            plain.push(character);
            rest = &rest[at + 6..];
        } else {
            plain.push_str("\\u");
            rest = &rest[at + 2..];
        }
    }
    plain + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn usual_spellings() {
        let micrometre =
            ["um", " um ", "\u{b5}m", "\u{3bc}m", "\\u00B5m", "\\u03bcm", "micron", "Microns", "micrometre"];
        for text in micrometre {
            assert_eq!(LengthUnit::parse(text), Some(LengthUnit::Um), "{text}");
        }
        for (text, unit) in [
            ("pm", LengthUnit::Pm),
            ("nm", LengthUnit::Nm),
            ("nanometers", LengthUnit::Nm),
            ("mm", LengthUnit::Mm),
            ("cm", LengthUnit::Cm),
            ("m", LengthUnit::M),
            ("\\u00C5", LengthUnit::Angstrom),
            ("angstrom", LengthUnit::Angstrom),
            ("inch", LengthUnit::Inch),
            ("inches", LengthUnit::Inch),
        ] {
            assert_eq!(LengthUnit::parse(text), Some(unit), "{text}");
        }
        for text in ["", " ", "pixel", "Mm", "V", "deg", "\\u", "\\u00", "nm2", "NM"] {
            assert_eq!(LengthUnit::parse(text), None, "{text}");
        }
    }

    #[test]
    fn broken_escapes_stay_as_they_are() {
        assert_eq!(unescape("a\\u00B5b"), "a\u{b5}b");
        assert_eq!(unescape("\\uD800x\\u12"), "\\uD800x\\u12");
        assert_eq!(unescape("\\u\u{b5}\u{b5}\u{b5}"), "\\u\u{b5}\u{b5}\u{b5}");
        assert_eq!(unescape("\\u+0B5"), "\\u+0B5");
    }
}
