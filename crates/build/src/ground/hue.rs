//! Colours in words: chromaticity, dominant wavelength, purity and the name of the hue.

use serde::{Deserialize, Serialize};

use diffraction_brdf::direction::Xyz;
use diffraction_brdf::spectrum::observer_2deg;

/// Ends of the spectral locus in nm; beyond them the chromaticity no longer moves.
const LOCUS_NM: [u32; 2] = [390, 700];

/// Excitation purity below which a colour passes for white, and below which it is called pale.
const WHITE_BELOW: f64 = 0.1;
const PALE_BELOW: f64 = 0.35;

/// Upper ends of the hues in nm of dominant wavelength, after K. L. Kelly, "Color designations for lights" (J. Opt. Soc. Am.
/// 33, 1943, 627), neighbours in his finer division put together.
const HUES: [(f64, &str); 7] = [
    (450.0, "violet"),
    (482.0, "blue"),
    (498.0, "blue-green"),
    (558.0, "green"),
    (570.0, "yellow-green"),
    (582.0, "yellow"),
    (597.0, "orange"),
];

/// A colour in words and in the numbers behind them (CIE 15:2004, appendix on dominant wavelength).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Hue {
    /// CIE 1931 chromaticity.
    pub xy: [f64; 2],
    /// Dominant wavelength in nm; of a purple the complementary one, negative. `None` for the white itself.
    pub dominant_nm: Option<f64>,
    /// Distance from white as share of the way to the spectral locus, or to the purples' line.
    pub purity: f64,
}

impl Hue {
    /// The hue of a colour beside a white, both XYZ; `None` for what is dark or no colour: sums that are not positive.
    pub fn of(xyz: Xyz, white: Xyz) -> Option<Self> {
        let (xy, white) = (chromaticity(xyz)?, chromaticity(white)?);
        let direction = [xy[0] - white[0], xy[1] - white[1]];
        if direction[0].hypot(direction[1]) < 1e-9 {
            return Some(Self { xy, dominant_nm: None, purity: 0.0 });
        }
        let (distance, dominant_nm) = match on_locus(white, direction) {
            Some((distance, nm)) => (distance, nm),
            // Towards the purples: the other way lies a spectral colour.
            None => {
                let (_, nm) = on_locus(white, direction.map(|part| -part))?;
                (on_purples(white, direction)?, -nm)
            }
        };
        Some(Self { xy, dominant_nm: Some(dominant_nm), purity: 1.0 / distance })
    }

    /// Its name: white, or a hue, pale where it is not far from white.
    pub fn name(&self) -> String {
        match (self.dominant_nm, self.purity) {
            (None, _) => "white".into(),
            (_, purity) if purity < WHITE_BELOW => "white".into(),
            (Some(nm), purity) if purity < PALE_BELOW => format!("pale {}", spectral_name(nm)),
            (Some(nm), _) => spectral_name(nm).into(),
        }
    }
}

fn spectral_name(dominant_nm: f64) -> &'static str {
    if dominant_nm < 0.0 {
        return "purple";
    }
    HUES.iter().find(|(end_nm, _)| dominant_nm < *end_nm).map_or("red", |(_, name)| name)
}

/// `(x, y)`; `None` where there is no light or a number is none.
fn chromaticity(xyz: Xyz) -> Option<[f64; 2]> {
    let sum: f64 = xyz.iter().sum();
    (sum.is_finite() && sum > 0.0).then(|| [xyz[0] / sum, xyz[1] / sum])
}

fn locus(nm: u32) -> [f64; 2] {
    chromaticity(observer_2deg(f64::from(nm))).expect("the observer sees every wavelength of the locus")
}

/// Where a ray from white meets the spectral locus: its length in directions, and the wavelength in nm.
fn on_locus(white: [f64; 2], direction: [f64; 2]) -> Option<(f64, f64)> {
    (LOCUS_NM[0]..LOCUS_NM[1]).find_map(|nm| {
        let (distance, share) = crossing(white, direction, locus(nm), locus(nm + 1))?;
        Some((distance, f64::from(nm) + share))
    })
}

/// How far along a ray from white the line of purples lies.
fn on_purples(white: [f64; 2], direction: [f64; 2]) -> Option<f64> {
    crossing(white, direction, locus(LOCUS_NM[0]), locus(LOCUS_NM[1])).map(|(distance, _)| distance)
}

/// Where the ray `from + a direction` crosses a segment: `a`, positive, and the share of the segment.
fn crossing(from: [f64; 2], direction: [f64; 2], start: [f64; 2], end: [f64; 2]) -> Option<(f64, f64)> {
    let along = [end[0] - start[0], end[1] - start[1]];
    let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    let determinant = cross(direction, along);
    let offset = [start[0] - from[0], start[1] - from[1]];
    let (distance, share) = (cross(offset, along) / determinant, cross(offset, direction) / determinant);
    (distance > 0.0 && (0.0..=1.0).contains(&share)).then_some((distance, share))
}

#[cfg(test)]
mod tests {
    use super::*;

    const D65: Xyz = [0.950_47, 1.0, 1.088_83];

    #[test]
    fn spectral_lines_are_their_own_dominant_wavelength() {
        for nm in [420.0, 455.0, 480.5, 510.0, 550.0, 589.0, 632.8] {
            let mixed: Xyz = std::array::from_fn(|c| observer_2deg(nm)[c] + 0.05 * D65[c]);
            for xyz in [observer_2deg(nm), mixed] {
                let hue = Hue::of(xyz, D65).unwrap();
                assert!((hue.dominant_nm.unwrap() - nm).abs() < 0.3, "{nm}: {hue:?}");
                assert!(hue.purity <= 1.0 + 1e-3);
            }
            assert!(Hue::of(observer_2deg(nm), D65).unwrap().purity > 0.999);
        }
    }

    /// The sRGB primaries' dominant wavelengths under D65 are well known: 611.4, 549.1 and 464.3 nm.
    #[test]
    fn primaries_of_displays() {
        let [red, green, blue] =
            [[0.412_456, 0.212_673, 0.019_334], [0.357_576, 0.715_152, 0.119_192], [0.180_438, 0.072_175, 0.950_304]];
        for (xyz, nm, name) in [(red, 611.4, "red"), (green, 549.1, "green"), (blue, 464.2, "blue")] {
            let hue = Hue::of(xyz, D65).unwrap();
            assert!((hue.dominant_nm.unwrap() - nm).abs() < 0.3, "{hue:?}");
            assert_eq!(hue.name(), name);
        }
        let magenta = Hue::of(std::array::from_fn(|c| red[c] + blue[c]), D65).unwrap();
        assert!((magenta.dominant_nm.unwrap() + 549.1).abs() < 0.3, "opposite green: {magenta:?}");
        assert_eq!(magenta.name(), "purple");
    }

    #[test]
    fn names_follow_the_wavelength_and_whites_have_none() {
        for (nm, name) in
            [(430.0, "violet"), (470.0, "blue"), (490.0, "blue-green"), (520.0, "green"), (565.0, "yellow-green")]
        {
            assert_eq!(Hue::of(observer_2deg(nm), D65).unwrap().name(), name);
        }
        for (nm, name) in [(577.0, "yellow"), (590.0, "orange"), (650.0, "red")] {
            assert_eq!(Hue::of(observer_2deg(nm), D65).unwrap().name(), name);
        }
        assert_eq!(Hue::of(D65, D65).unwrap().name(), "white");
        let mixed = |share: f64| std::array::from_fn(|c| share * observer_2deg(520.0)[c] + D65[c]);
        assert_eq!(Hue::of(mixed(0.05), D65).unwrap().name(), "white");
        assert_eq!(Hue::of(mixed(0.5), D65).unwrap().name(), "pale green");
        assert_eq!(Hue::of([0.0; 3], D65), None);
        assert_eq!(Hue::of([f64::NAN, 1.0, 1.0], D65), None);
    }
}
