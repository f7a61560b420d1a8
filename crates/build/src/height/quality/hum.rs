//! A regular disturbance in time, such as the mains', which runs on from line to line.

use super::finding::{Fault, Finding};
use super::prepared::Prepared;
use crate::height::prepare::robust::median;

/// Longest period across the lines that is taken for a disturbance, in lines. Of a mains whose phase from line to line is anything, a third lies
/// beyond; that looks like any grating.
const LINES_MAX: f64 = 6.0;

/// Fewest waves in a line: one less is within the Hann window's reach of what is constant along the lines.
const WAVES_MIN: i64 = 2;

/// Largest frequency along the line relative to that across the lines, both per sample: a disturbance turns by most of a wave from line to line.
const OBLIQUE_MAX: f64 = 0.75;

/// Least amplitude that is told, in rms heights.
const AMPLITUDE_MIN: f64 = 0.05;

/// Share of the mean square height from which on the wave is the surface itself.
const SHARE_MAX: f64 = 0.5;

/// Least ratio of the wave's highest line to the mean around it. The highest of a million lines of a random surface has a chance of
/// 1e-6 of 28.
const RATIO_MIN: f64 = 100.0;

/// Lines around the wave that tell the background, to each side; and those of the wave itself.
const AROUND: i64 = 12;
const WAVE: i64 = 2;

/// Least share of what rises above the background around that lies in the wave's own lines.
const NARROW_MIN: f64 = 0.8;

/// Highest multiple of a coarser wave that a wave is held to be.
const HARMONICS: i64 = 12;

/// Tells a wave of at least 5 % of the rms height that repeats within six lines, and has no coarser wave of which it were a harmonic.
pub(super) fn check(prepared: &Prepared) -> Option<Finding> {
    let [nx, ny] = prepared.field.size().map(|count| count as i64);
    let spectrum = &prepared.spectrum;
    let least_y = (ny as f64 / LINES_MAX).ceil() as i64;
    let reach = |y: i64| ((OBLIQUE_MAX * y as f64 * nx as f64 / ny as f64) as i64).min(nx / 2);
    let candidates = (least_y..=ny / 2).flat_map(|y| (WAVES_MIN..=reach(y)).flat_map(move |x| [[x, y], [-x, y]]));
    let wave = candidates.max_by(|a, b| spectrum.power(*a).total_cmp(&spectrum.power(*b)))?;
    let power = spectrum.power(wave);
    let sum = |reach: i64| block(wave, reach).map(|line| spectrum.power(line)).sum::<f64>();
    let background = background(prepared, wave);
    let above = |reach: i64| sum(reach) - background * (2 * reach + 1).pow(2) as f64;
    // A Hann window spreads a sinusoid's power over lines whose sum is 1.5² times that of the highest.
    let amplitude_nm = 2.0 * (sum(WAVE) / 2.25).sqrt();
    let share = 0.5 * (amplitude_nm / prepared.rms_nm).powi(2);
    let is_told = power > RATIO_MIN * background
        && amplitude_nm > AMPLITUDE_MIN * prepared.rms_nm
        && share < SHARE_MAX
        && above(WAVE) > NARROW_MIN * above(2 * WAVE + 1)
        && !is_harmonic(prepared, wave, power);
    is_told.then(|| {
        let [x_nm, y_nm] = prepared.field.extent_nm();
        let period_nm = 1.0 / (wave[0] as f64 / x_nm).hypot(wave[1] as f64 / y_nm);
        Finding {
            fault: Fault::Hum,
            in_short: format!("hum of {amplitude_nm:.1} nm"),
            sentence: format!(
                "A wave of {amplitude_nm:.1} nm runs on from line to line, {} times in each and once in {:.1} lines: hum of the mains or a vibration, which \
                 looks like a grating of {period_nm:.0} nm that the surface does not have. No setting takes it away: find its source and \
                 scan again, at another speed to see it move.",
                wave[0].abs(),
                ny as f64 / wave[1] as f64
            ),
            remedy: None,
        }
    })
}

/// Whether a coarser, stronger wave has this as its multiple: one that stands out of what is around it itself, as the lines of a random surface
/// do not.
fn is_harmonic(prepared: &Prepared, wave: [i64; 2], power: f64) -> bool {
    (2..=HARMONICS).any(|order| {
        let near = wave.map(|line| (line as f64 / order as f64).round() as i64);
        let mut stronger = block(near, 1).filter(|line| prepared.spectrum.power(*line) > power);
        stronger.any(|line| prepared.spectrum.power(line) > RATIO_MIN * background(prepared, line))
    })
}

/// Mean power of a random surface's lines around one, from their median.
fn background(prepared: &Prepared, line: [i64; 2]) -> f64 {
    let mut around: Vec<f64> = block(line, AROUND).map(|line| prepared.spectrum.power(line)).collect();
    median(&mut around) / std::f64::consts::LN_2
}

/// Lines up to so many away along either axis.
fn block([x, y]: [i64; 2], reach: i64) -> impl Iterator<Item = [i64; 2]> {
    (-reach..=reach).flat_map(move |dy| (-reach..=reach).map(move |dx| [x + dx, y + dy]))
}
