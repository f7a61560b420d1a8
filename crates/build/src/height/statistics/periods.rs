//! Periods that stand out of the power spectrum.

use std::f64::consts::LN_2;

use serde::{Deserialize, Serialize};

use super::spectrum::Spectrum;
use crate::height::HeightField;
use crate::height::prepare::robust::median;

/// Most periods reported.
const PERIODS_MAX: usize = 3;

/// Weakest period reported, relative to the strongest: ten times the side lobes of a Hann window that lie
/// outside the range of a peak (-41 dB).
const POWER_MIN: f64 = 1e-3;

/// Least power of the strongest peak, relative to the highest line of all: fainter regularities (of the
/// instrument, mostly) do not characterise a surface that is rough all over.
const FIRST_POWER_MIN: f64 = 0.02;

/// Least power of the strongest peak, relative to the highest line at any frequency: 3e-5 of its amplitude. What is left of a surface that
/// is one slow wave is rounding, and a Hann window's far side lobes.
const LEAST_POWER_MIN: f64 = 1e-9;

/// Least share of the mean square height that lies in the strongest peak. Peaks that stand out of nothing, as rounding leaves it, are no
/// property of a surface.
const SHARE_MIN: f64 = 2.5e-3;

/// Half width of a peak in lines: of a sinusoid, a Hann window makes a lobe that ends at 2.
const RANGE_LINES: f64 = 2.5;

/// Half width of a peak as share of its frequency: natural gratings vary by some per cent over a scan.
const RANGE_SHARE: f64 = 0.05;

/// Fewest waves that make a period: of fewer a scan cannot tell that they repeat.
pub const WAVES_MIN: f64 = 2.5;

/// Lowest frequency of a peak in lines: so many times a period must be seen, and its lobe clears the origin.
const LINES_MIN: f64 = WAVES_MIN;

/// Chance that the highest line of a random surface passes for a period; small, for real surfaces are rougher in
/// some directions than in others.
const FALSE_ALARM: f64 = 1e-6;

/// Fewest bins that tell the background around a peak.
const BACKGROUND_BINS_MIN: usize = 24;

/// Least ratio of a peak of what is constant along the lines of a scan to what lies beside it there: offsets between lines, which an
/// instrument makes and no surface has, are such a pattern too, and their highest line is on average five times their mean. Of random
/// and wandering offsets one scan in a hundred exceeds it.
const LINES_RATIO_MIN: f64 = 20.0;

/// Frequencies beside a peak, relative to its own, where offsets between lines are looked for.
const BESIDE: [[f64; 2]; 2] = [[0.5, 0.8], [1.25, 2.0]];

/// Most steps towards a peak's centre, and the step in lines that ends them.
const STEPS_MAX: usize = 20;
const STEP_MIN: f64 = 1e-3;

/// A period that stands out of the power spectrum.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Period {
    /// Period in nm.
    pub period_nm: f64,
    /// Direction of the grating vector in degrees from +x, counterclockwise with y up, in `[0, 180)`.
    pub direction_deg: f64,
    /// Highest line of its peak in the power spectrum (Hann window), relative to the strongest period's.
    pub relative_power: f64,
}

/// A peak of the power.
#[derive(Clone, Copy)]
struct Peak {
    /// Centre in lines along x and along the rows (downwards), signed.
    line: [f64; 2],
    /// Half width in lines.
    range: [f64; 2],
    /// Power of its highest line.
    power: f64,
}

/// The strongest peaks of the power spectrum that rise above its background, of heights about their mean plane.
///
/// The heights are weighted with a Hann window. A peak counts if a random surface with the mean power found
/// at that distance from the origin would reach its height anywhere in the spectrum with a probability of
/// 1e-6 only, and if the strongest has its share of the mean square height.
///
/// Its place is the centre of the power around it, which lies between the lines: exactly so
/// for a sinusoid, whose power a Hann window spreads over five lines, and in the middle of the many lines of a grating
/// that is not quite regular. One that varies more has several peaks.
pub(crate) fn dominant(field: &HeightField) -> Vec<Period> {
    let spectrum = Spectrum::new(field);
    let maxima = local_maxima(&spectrum);
    let Some(highest) = maxima.first().map(|&line| spectrum.power(line)) else { return Vec::new() };
    let slowest_too = spectrum.powers().fold(0.0, f64::max);
    let first_least = (FIRST_POWER_MIN * highest).max(LEAST_POWER_MIN * slowest_too);
    let background = Background::new(&spectrum);
    // Powers of a random surface's lines are distributed exponentially about their mean.
    let threshold = (0.5 * spectrum.count() as f64 / FALSE_ALARM).ln();
    let is_first = |line: [i64; 2]| 2.0 * around(&spectrum, line) > SHARE_MIN * background.total;
    let mut peaks: Vec<Peak> = Vec::new();
    for line in maxima {
        let power = spectrum.power(line);
        let least = peaks.first().map_or(first_least, |first| POWER_MIN * first.power);
        if peaks.len() == PERIODS_MAX || power < least {
            break;
        }
        let place = line.map(|line| line as f64);
        if peaks.iter().any(|peak| peak.holds(place)) {
            continue;
        }
        if power > threshold * background.around(spectrum.ring(place))
            && power > LINES_RATIO_MIN * offsets_around(&spectrum, line)
            && (!peaks.is_empty() || is_first(line))
        {
            let peak = centred(&spectrum, line, power);
            // A wave between the lines may be longer than its highest one says.
            let is_told = peak.line[0].hypot(peak.line[1]) >= LINES_MIN;
            if is_told && !peaks.iter().any(|other| other.holds(peak.line)) {
                peaks.push(peak);
            }
        }
    }
    let strongest = peaks.first().map_or(0.0, |peak| peak.power);
    peaks.iter().map(|peak| period(peak, &spectrum, strongest)).collect()
}

/// Mean power that random offsets between scan lines would have at this line: from the medians below and above it, the larger of which is
/// that of offsets that wander; 0 of lines that are not constant along the scan's own.
fn offsets_around(spectrum: &Spectrum, [x, y]: [i64; 2]) -> f64 {
    if x != 0 {
        return 0.0;
    }
    let place = y.unsigned_abs() as f64;
    let of_side = |[low, high]: [f64; 2]| {
        let lines = (low * place).floor().max(1.0) as i64..=(high * place).floor() as i64;
        // A Hann window's lobe reaches two lines.
        let beside = lines.filter(|line| (*line as f64 - place).abs() >= 2.0 && spectrum.has([0, *line]));
        let mut powers: Vec<f64> = beside.map(|line| spectrum.power([0, line])).collect();
        if powers.is_empty() { 0.0 } else { median(&mut powers) / LN_2 }
    };
    BESIDE.map(of_side).into_iter().fold(0.0, f64::max)
}

/// Power of a line and the eight around it: nearly all that a Hann window leaves of a sinusoid, wherever between the lines it lies.
fn around(spectrum: &Spectrum, [x, y]: [i64; 2]) -> f64 {
    (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| [x + dx, y + dy])).map(|line| spectrum.power(line)).sum()
}

impl Peak {
    /// Whether another peak there would overlap this one or its negative frequency, which is the same wave.
    fn holds(&self, line: [f64; 2]) -> bool {
        let overlaps = |sign: f64| {
            let apart = |axis: usize| (line[axis] - sign * self.line[axis]) / self.range[axis];
            apart(0).hypot(apart(1)) < 2.0
        };
        overlaps(1.0) || overlaps(-1.0)
    }
}

/// The peak at a highest line, its range moved until its own centre of power is its middle. Where stronger power beside the peak draws that
/// away, the peak lies between the line and its neighbours as a sinusoid would.
fn centred(spectrum: &Spectrum, highest: [i64; 2], power: f64) -> Peak {
    let start = highest.map(|line| line as f64);
    let [fx, fy] = [start[0] * spectrum.line_per_nm[0], start[1] * spectrum.line_per_nm[1]];
    let width = RANGE_SHARE * fx.hypot(fy);
    let range = spectrum.line_per_nm.map(|line| (width / line).max(RANGE_LINES));
    let mut peak = Peak { line: start, range, power };
    for _ in 0..STEPS_MAX {
        let mut sums = [0.0; 3];
        let bounds = [0, 1].map(|axis| {
            [(peak.line[axis] - range[axis]).ceil() as i64, (peak.line[axis] + range[axis]).floor() as i64]
        });
        for y in bounds[1][0]..=bounds[1][1] {
            for x in bounds[0][0]..=bounds[0][1] {
                let [dx, dy] = [x as f64 - peak.line[0], y as f64 - peak.line[1]];
                if (dx / range[0]).hypot(dy / range[1]) <= 1.0 && spectrum.has([x, y]) {
                    let power = spectrum.power([x, y]);
                    sums = [sums[0] + power, sums[1] + power * dx, sums[2] + power * dy];
                }
            }
        }
        let step = [sums[1] / sums[0], sums[2] / sums[0]];
        peak.line = [peak.line[0] + step[0], peak.line[1] + step[1]];
        if step[0].hypot(step[1]) < STEP_MIN {
            break;
        }
    }
    let drift = |axis: usize| (peak.line[axis] - start[axis]).abs() / (range[axis] / RANGE_LINES);
    if drift(0).max(drift(1)) > 1.0 {
        peak.line = between_lines(spectrum, highest);
    }
    peak
}

/// Place of a sinusoid of which a Hann window leaves most in this line, from how much it leaves in the stronger neighbour: of amplitudes
/// `A(δ)` that lie `δ` lines from its centre, `A(1 - δ)/A(δ) = (1 + δ)/(2 - δ)`.
fn between_lines(spectrum: &Spectrum, highest: [i64; 2]) -> [f64; 2] {
    [0, 1].map(|axis| {
        let amplitude = |step: i64| {
            let mut line = highest;
            line[axis] += step;
            spectrum.power(line).sqrt()
        };
        let sign = if amplitude(1) > amplitude(-1) { 1 } else { -1 };
        let ratio = amplitude(sign) / amplitude(0);
        let shift = ((2.0 * ratio - 1.0) / (1.0 + ratio)).clamp(0.0, 0.5);
        highest[axis] as f64 + sign as f64 * shift
    })
}

fn period(peak: &Peak, spectrum: &Spectrum, strongest: f64) -> Period {
    let [fx, fy] = [peak.line[0] * spectrum.line_per_nm[0], -peak.line[1] * spectrum.line_per_nm[1]];
    let turned = fy.atan2(fx).to_degrees().rem_euclid(180.0);
    Period {
        period_nm: 1.0 / fx.hypot(fy),
        // A tiny negative angle rounds to 180 itself.
        direction_deg: if turned < 180.0 { turned } else { 0.0 },
        relative_power: peak.power / strongest,
    }
}

/// Bins that none of their eight neighbours exceeds, highest first.
fn local_maxima(spectrum: &Spectrum) -> Vec<[i64; 2]> {
    let mut maxima: Vec<[i64; 2]> = spectrum
        .half_plane()
        .filter(|&[x, y]| (x as f64).hypot(y as f64) >= LINES_MIN)
        .filter(|&[x, y]| {
            let power = spectrum.power([x, y]);
            let mut around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| [x + dx, y + dy]));
            power > 0.0 && around.all(|line| spectrum.power(line) <= power)
        })
        .collect();
    // Equal heights keep their order, so the result is the same each time.
    maxima.sort_by(|&a, &b| spectrum.power(b).total_cmp(&spectrum.power(a)));
    maxima
}

/// Powers by distance from the origin, and sums.
struct Background {
    rings: Vec<Vec<f64>>,
    /// Of all lines.
    total: f64,
}

impl Background {
    fn new(spectrum: &Spectrum) -> Self {
        let mut rings: Vec<Vec<f64>> = Vec::new();
        for [x, y] in spectrum.half_plane() {
            let ring = spectrum.ring([x as f64, y as f64]);
            if rings.len() <= ring {
                rings.resize(ring + 1, Vec::new());
            }
            rings[ring].push(spectrum.power([x, y]));
        }
        Self { rings, total: spectrum.powers().sum() }
    }

    /// Mean power that a random surface would have at this distance from the origin: from the median, which a
    /// few peaks do not change, and which is ln 2 of the mean of an exponential distribution.
    fn around(&self, ring: usize) -> f64 {
        let mut powers = Vec::new();
        for reach in 0..self.rings.len() {
            let (low, high) = (ring.checked_sub(reach), Some(ring + reach).filter(|_| reach > 0));
            for ring in [low, high].into_iter().flatten() {
                powers.extend(self.rings.get(ring).into_iter().flatten());
            }
            if powers.len() >= BACKGROUND_BINS_MIN {
                break;
            }
        }
        let middle = powers.len() / 2;
        *powers.select_nth_unstable_by(middle, f64::total_cmp).1 / LN_2
    }
}
