//! Numbers and pairs of numbers on the command line, checked as they are parsed.

use std::str::FromStr;

use diffraction_build::height::PITCH_NM;

/// Sample spacing along x and y in nm, written as one number or as `X,Y`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PitchNm(pub [f64; 2]);

/// Samples along x and y, written as one number or as `X,Y`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct SizePx(pub [usize; 2]);

/// Largest number of samples along one axis.
const SIZE_MAX: usize = 1 << 16;

impl FromStr for PitchNm {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let [low, high] = PITCH_NM;
        let one = |text: &str| match finite(text) {
            Ok(pitch) if (low..=high).contains(&pitch) => Ok(pitch),
            _ => Err(format!("expected nm between {low} and {high}, with a decimal point")),
        };
        pair(text, one).map(Self)
    }
}

impl FromStr for SizePx {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let one = |text: &str| match text.parse() {
            Ok(size) if (1..=SIZE_MAX).contains(&size) => Ok(size),
            _ => Err(format!("expected a whole number from 1 to {SIZE_MAX}")),
        };
        pair(text, one).map(Self)
    }
}

fn pair<T: Copy>(text: &str, one: impl Fn(&str) -> Result<T, String>) -> Result<[T; 2], String> {
    let parts: Vec<&str> = text.split(',').map(str::trim).collect();
    match parts[..] {
        [both] => one(both).map(|value| [value; 2]),
        [x, y] => Ok([one(x)?, one(y)?]),
        _ => Err("expected one number, or two separated by a comma".to_owned()),
    }
}

/// A finite number.
pub(crate) fn finite(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(number) if f64::is_finite(number) => Ok(number),
        _ => Err("expected a finite number".to_owned()),
    }
}

/// A finite number above 0.
pub(crate) fn positive(text: &str) -> Result<f64, String> {
    match finite(text) {
        Ok(number) if number > 0.0 => Ok(number),
        _ => Err("expected a number above 0".to_owned()),
    }
}

/// A number between 0 and 1, neither included.
pub(crate) fn share(text: &str) -> Result<f64, String> {
    match positive(text) {
        Ok(number) if number < 1.0 => Ok(number),
        _ => Err("expected a number between 0 and 1, neither included".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_number_stands_for_both_axes() {
        assert_eq!("48.8".parse(), Ok(PitchNm([48.8, 48.8])));
        assert_eq!("84, 74.5".parse(), Ok(PitchNm([84.0, 74.5])));
        assert_eq!("512,64".parse(), Ok(SizePx([512, 64])));
    }

    #[test]
    fn nonsense_is_refused() {
        for text in ["", "0", "-1", "1e-300", "48;8", "nan", "inf", "1,2,3", "1;2", "1,"] {
            assert!(text.parse::<PitchNm>().is_err(), "{text}");
            assert!(text.parse::<SizePx>().is_err(), "{text}");
        }
        assert!("65537".parse::<SizePx>().is_err());
        assert!("1.5".parse::<SizePx>().is_err());
        assert!(share("1").is_err() && share("0").is_err() && share("0.5").is_ok());
        assert!(finite("-3").is_ok() && finite("NaN").is_err());
    }
}
