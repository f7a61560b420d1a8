//! Periods that stand out of the power spectrum.

use std::f64::consts::{LN_2, TAU};

use ndarray::Array2;
use rustfft::num_complex::Complex;
use serde::{Deserialize, Serialize};

use crate::ground::fft::fft2;
use crate::height::HeightField;

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

/// Power spectrum of the windowed heights, and what its lines are.
struct Spectrum {
    /// Transform; index 0 is frequency 0, rows first.
    values: Array2<Complex<f64>>,
    /// Distance of the lines in 1/nm along x and y.
    line_per_nm: [f64; 2],
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
/// 1e-6 only. Its place is the centre of the power around it, which lies between the lines: exactly so
/// for a sinusoid, whose power a Hann window spreads over five lines, and in the middle of the many lines of a grating
/// that is not quite regular. One that varies more has several peaks.
pub(crate) fn dominant(field: &HeightField) -> Vec<Period> {
    let spectrum = spectrum(field);
    let maxima = local_maxima(&spectrum);
    let Some(highest) = maxima.first().map(|&line| spectrum.power(line)) else { return Vec::new() };
    let slowest_too = spectrum.values.iter().map(|value| value.norm_sqr()).fold(0.0, f64::max);
    let first_least = (FIRST_POWER_MIN * highest).max(LEAST_POWER_MIN * slowest_too);
    let background = Background::new(&spectrum);
    // Powers of a random surface's lines are distributed exponentially about their mean.
    let threshold = (0.5 * spectrum.values.len() as f64 / FALSE_ALARM).ln();
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
        if power > threshold * background.around(spectrum.ring(place)) {
            let peak = centred(&spectrum, place, power);
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

/// The peak near a line, its range moved until its own centre of power is its middle.
fn centred(spectrum: &Spectrum, start: [f64; 2], power: f64) -> Peak {
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
    peak
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

/// Hann window with zeros just outside the samples, its sum 1; 1 for a single sample.
fn hann(count: usize) -> Vec<f64> {
    (0..count).map(|i| (1.0 - (TAU * (i as f64 + 0.5) / count as f64).cos()) / count as f64).collect()
}

fn spectrum(field: &HeightField) -> Spectrum {
    let [nx, ny] = field.size();
    let single = |count: usize| if count == 1 { vec![1.0] } else { hann(count) };
    let (wx, wy) = (single(nx), single(ny));
    let weighted = || field.heights_nm.indexed_iter().map(|((j, i), height)| wy[j] * wx[i] * height);
    let mean: f64 = weighted().sum::<f64>() / (wx.iter().sum::<f64>() * wy.iter().sum::<f64>());
    let mut values =
        Array2::from_shape_fn((ny, nx), |(j, i)| Complex::from(wy[j] * wx[i] * (field.heights_nm[[j, i]] - mean)));
    fft2(&mut values);
    let [x, y] = field.extent_nm();
    Spectrum { values, line_per_nm: [1.0 / x, 1.0 / y] }
}

impl Spectrum {
    /// Signed line numbers of a bin, along x and along the rows.
    fn line(&self, [row, column]: [usize; 2]) -> [i64; 2] {
        let signed =
            |index: usize, count: usize| if 2 * index > count { index as i64 - count as i64 } else { index as i64 };
        [signed(column, self.values.ncols()), signed(row, self.values.nrows())]
    }

    /// The value at a line, repeated beyond the ends.
    fn at(&self, [x, y]: [i64; 2]) -> Complex<f64> {
        let wrapped = |line: i64, count: usize| line.rem_euclid(count as i64) as usize;
        self.values[[wrapped(y, self.values.nrows()), wrapped(x, self.values.ncols())]]
    }

    /// Whether a line is within the spectrum, not its repetition; an axis of one sample has line 0 only.
    fn has(&self, [x, y]: [i64; 2]) -> bool {
        2 * x.unsigned_abs() <= self.values.ncols() as u64 && 2 * y.unsigned_abs() <= self.values.nrows() as u64
    }

    fn power(&self, line: [i64; 2]) -> f64 {
        self.at(line).norm_sqr()
    }

    /// Distance of a line from the origin, in the coarser of the two lines.
    fn ring(&self, [x, y]: [f64; 2]) -> usize {
        let coarse = self.line_per_nm[0].max(self.line_per_nm[1]);
        (x * self.line_per_nm[0] / coarse).hypot(y * self.line_per_nm[1] / coarse).round() as usize
    }

    /// Bins of the half plane that stands for all, with their lines.
    fn half_plane(&self) -> impl Iterator<Item = [i64; 2]> + '_ {
        let (rows, columns) = self.values.dim();
        (0..rows)
            .flat_map(move |row| (0..columns).map(move |column| self.line([row, column])))
            .filter(|&[x, y]| x > 0 || (x == 0 && y > 0))
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

/// Powers by distance from the origin.
struct Background {
    rings: Vec<Vec<f64>>,
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
        Self { rings }
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
