//! One line that says whether a scan is good, for what, and with which settings.

use serde::{Deserialize, Serialize};

use super::advice::Advice;
use super::finding::Remedy;
use crate::height::HeightField;
use crate::height::statistics::{WAVES_MIN, is_whole_grating};

/// How good.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Grade {
    /// For all that it is asked for.
    Green,
    /// With a limit that is named.
    Amber,
    /// Not.
    Red,
}

impl Grade {
    /// In a word.
    pub fn in_words(self) -> &'static str {
        match self {
            Self::Green => "good",
            Self::Amber => "good within limits",
            Self::Red => "not good",
        }
    }
}

/// What to think of a scan or a specimen.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Verdict {
    /// How good it is.
    pub grade: Grade,
    /// Why, in one sentence.
    pub sentence: String,
}

/// Of a scan and what was advised for it, at wavelengths in nm; `limits` are reasons for doubt that no setting takes away, in a few words,
/// and `blend_nm` the width that makes its edges fit, where they do not.
pub fn scan_verdict(advice: &Advice, wavelength_nm: [f64; 2], limits: &[String], blend_nm: Option<f64>) -> Verdict {
    if !advice.left.is_empty() {
        let reasons: Vec<&str> = advice.left.iter().map(|finding| finding.in_short.as_str()).collect();
        return Verdict { grade: Grade::Red, sentence: format!("not good because: {}.", reasons.join("; ")) };
    }
    if let Some(reason) = too_small(&advice.prepared, wavelength_nm[0]) {
        return Verdict { grade: Grade::Red, sentence: format!("not good because: {reason}.") };
    }
    let Reach { words, is_all } = reach(&advice.prepared, wavelength_nm);
    let blend = blend_nm.map(|width| format!("blend_nm = {width}"));
    let settings: Vec<String> = advice.settings.iter().map(Remedy::toml).chain(blend).collect();
    let mut sentence = match settings.is_empty() {
        true => format!("good for {words}"),
        false => format!("good with {}, for {words}", settings.join(", ")),
    };
    if !limits.is_empty() {
        sentence += &format!("; but {}", limits.join("; "));
    }
    let is_green = settings.is_empty() && limits.is_empty() && is_all;
    Verdict { grade: if is_green { Grade::Green } else { Grade::Amber }, sentence: sentence + "." }
}

/// What the sampling answers for.
struct Reach {
    words: String,
    /// Whether that is every direction at every wavelength.
    is_all: bool,
}

/// Why a scan tells of no period that diffracts visible light: the longest that fits often enough sends even grazing light nowhere.
fn too_small(field: &HeightField, shortest_nm: f64) -> Option<String> {
    let sampled = field.size().into_iter().zip(field.extent_nm()).filter(|(count, _)| *count > 1);
    let side_nm = sampled.map(|(_, extent_nm)| extent_nm).fold(f64::INFINITY, f64::min);
    let longest_nm = side_nm / WAVES_MIN;
    let is_too_small = longest_nm <= 0.5 * shortest_nm && !is_whole_grating(field);
    is_too_small.then(|| {
        format!(
            "it is {:.3} µm wide, so that periods of {longest_nm:.0} nm at most fit {WAVES_MIN} times, and those diffract no light of \
             {shortest_nm:.0} nm or more: scan a larger area",
            side_nm * 1e-3
        )
    })
}

/// A grating of two samples diffracts to `|(u, v)| = λ/(2 pitch)`: 2 is all there is, 1 all that is seen under light from straight above.
fn reach(field: &HeightField, [shortest_nm, longest_nm]: [f64; 2]) -> Reach {
    let axes = field.size().into_iter().zip(field.pitch_nm).zip(field.extent_nm());
    let axes: Vec<_> = axes.filter(|((count, _), _)| *count > 1).collect();
    let pitch_nm = axes.iter().map(|((_, pitch_nm), _)| *pitch_nm).fold(0.0, f64::max);
    let side_nm = axes.iter().map(|(_, extent_nm)| *extent_nm).fold(f64::INFINITY, f64::min);
    let periods = if side_nm.is_finite() {
        format!(" (periods of {:.0} nm to {:.2} µm)", 2.0 * pitch_nm, side_nm * 1e-3 / WAVES_MIN)
    } else {
        String::new()
    };
    let (all_nm, above_nm) = (4.0 * pitch_nm, 2.0 * pitch_nm);
    let up_to_deg = (shortest_nm / above_nm).min(1.0).asin().to_degrees();
    let above = match above_nm {
        _ if above_nm <= shortest_nm => format!("light from straight above at all angles from {shortest_nm:.0} nm on"),
        _ if above_nm <= longest_nm => format!(
            "light from straight above up to {up_to_deg:.0} degrees at {shortest_nm:.0} nm and at all angles from {above_nm:.0} nm on"
        ),
        _ => format!("light from straight above up to {up_to_deg:.0} degrees at {shortest_nm:.0} nm"),
    };
    let words = match all_nm {
        _ if all_nm <= shortest_nm => format!("all directions from {shortest_nm:.0} nm on{periods}"),
        _ if all_nm <= longest_nm => format!("{above}, and for all directions from {all_nm:.0} nm on{periods}"),
        _ => format!("{above}{periods}"),
    };
    Reach { words, is_all: all_nm <= shortest_nm }
}

#[cfg(test)]
mod tests {
    use ndarray::Array2;

    use super::*;
    use crate::height::quality::finding::{Fault, Finding};

    fn advice(pitch_nm: f64, settings: Vec<Remedy>, left: Vec<Finding>) -> Advice {
        let prepared = HeightField { heights_nm: Array2::zeros((100, 200)), pitch_nm: [pitch_nm; 2] };
        Advice { findings: left.clone(), settings, left, prepared }
    }

    #[test]
    fn the_pitch_decides_on_angles_and_wavelengths() {
        let of = |pitch_nm| scan_verdict(&advice(pitch_nm, Vec::new(), Vec::new()), [380.0, 780.0], &[], None);
        assert_eq!(of(95.0).grade, Grade::Green);
        assert_eq!(of(95.0).sentence, "good for all directions from 380 nm on (periods of 190 nm to 3.80 µm).");
        let coarser = of(150.0);
        assert_eq!(coarser.grade, Grade::Amber);
        assert!(
            coarser
                .sentence
                .contains("straight above at all angles from 380 nm on, and for all directions from 600 nm")
        );
        // 380/760: half of the sine.
        assert!(of(380.0).sentence.contains("up to 30 degrees at 380 nm and at all angles from 760 nm on"));
        assert!(of(500.0).sentence.contains("up to 22 degrees at 380 nm (periods"));
    }

    #[test]
    fn scans_that_hold_no_period_of_light_are_not_good() {
        // 100 rows of 4.7 nm: periods up to 188 nm, and of 4.8 nm up to 192 nm, beside half of 380 nm.
        let of = |pitch_nm: f64| {
            let mut advice = advice(pitch_nm, Vec::new(), Vec::new());
            advice
                .prepared
                .heights_nm
                .indexed_iter_mut()
                .for_each(|((row, column), height)| *height = (row * column) as f64);
            scan_verdict(&advice, [380.0, 780.0], &[], None)
        };
        let small = of(4.7);
        assert_eq!(small.grade, Grade::Red);
        assert!(small.sentence.contains("periods of 188 nm at most"), "{small:?}");
        assert_eq!(of(4.8).grade, Grade::Green);
    }

    #[test]
    fn settings_and_reasons_are_named() {
        let settings = vec![Remedy::Crop([0, 0, 100, 50]), Remedy::Rows];
        let mended = scan_verdict(&advice(50.0, settings, Vec::new()), [380.0, 780.0], &[], Some(500.0));
        assert_eq!(mended.grade, Grade::Amber);
        assert!(
            mended.sentence.starts_with("good with crop = [0, 0, 100, 50], level = \"rows\", blend_nm = 500, for all"),
            "{mended:?}"
        );
        let hum =
            Finding { fault: Fault::Hum, in_short: "hum of 20.0 nm".into(), sentence: String::new(), remedy: None };
        let bad = scan_verdict(&advice(50.0, Vec::new(), vec![hum]), [380.0, 780.0], &[], None);
        assert_eq!((bad.grade, bad.sentence.as_str()), (Grade::Red, "not good because: hum of 20.0 nm."));
    }
}
