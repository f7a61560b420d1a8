//! Periods that stand out of the power spectrum.

use std::f64::consts::{LN_2, PI, TAU};

use ndarray::Array2;
use rustfft::num_complex::Complex;

use super::Period;
use crate::ground::fft::fft2;
use crate::height::HeightField;

/// Most periods reported.
const PERIODS_MAX: usize = 3;

/// Weakest period reported, relative to the strongest: twice the highest side lobe of a Hann window, 7e-4.
const POWER_MIN: f64 = 1.5e-3;

/// Shortest distance of two peaks in lines of the spectrum: a Hann window's main lobe ends at 2.
const DISTANCE_MIN: f64 = 4.0;

/// Lowest frequency of a peak in lines: below, its lobe overlaps that of the negative frequency.
const LINES_MIN: f64 = 2.0;

/// Chance that the highest of the bins of a random surface passes for a period.
const FALSE_ALARM: f64 = 1e-3;

/// Fewest bins that tell the background around a peak.
const BACKGROUND_BINS_MIN: usize = 24;

/// Power spectrum of the windowed heights, and what its lines are.
struct Spectrum {
    /// Transform; index 0 is frequency 0, rows first.
    values: Array2<Complex<f64>>,
    /// Distance of the lines in 1/nm along x and y.
    line_per_nm: [f64; 2],
}

/// A local maximum of the power.
#[derive(Clone, Copy)]
struct Peak {
    /// Position in lines along x and along the rows (downwards), signed.
    line: [f64; 2],
    power: f64,
}

/// The strongest peaks of the power spectrum that rise above its background, of heights about their mean plane.
///
/// The heights are weighted with a Hann window. The lines next to a peak tell its place
/// between the lines, exactly so for one sinusoid that runs through many periods. A peak counts as a period
/// if a random surface with the mean power found at that distance from the origin would reach its height
/// anywhere in the spectrum with a probability of 1e-3 only.
pub fn dominant(field: &HeightField) -> Vec<Period> {
    let spectrum = spectrum(field);
    let mut maxima = local_maxima(&spectrum);
    maxima.sort_by(|a, b| {
        b.power.total_cmp(&a.power).then(a.line[0].total_cmp(&b.line[0])).then(a.line[1].total_cmp(&b.line[1]))
    });
    let background = Background::new(&spectrum);
    // Powers of a random surface's lines are distributed exponentially about their mean.
    let threshold = (0.5 * spectrum.values.len() as f64 / FALSE_ALARM).ln();
    let mut peaks: Vec<Peak> = Vec::new();
    for maximum in maxima {
        let strongest = peaks.first().map_or(0.0, |peak| peak.power);
        if peaks.len() == PERIODS_MAX || maximum.power < 0.5 * POWER_MIN * strongest {
            break;
        }
        let peak = refine(&spectrum, maximum.line);
        let free = peaks.iter().all(|other| {
            let distance = |sign: f64| (peak.line[0] - sign * other.line[0]).hypot(peak.line[1] - sign * other.line[1]);
            // The negative frequency is the same wave.
            distance(1.0).min(distance(-1.0)) >= DISTANCE_MIN
        });
        if free
            && peak.power >= POWER_MIN * strongest
            && maximum.power > threshold * background.around(&spectrum, maximum.line)
        {
            peaks.push(peak);
        }
    }
    peaks.sort_by(|a, b| b.power.total_cmp(&a.power));
    let strongest = peaks.first().map_or(1.0, |peak| peak.power);
    peaks.iter().map(|peak| period(peak, &spectrum, strongest)).collect()
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

/// Bins that none of their eight neighbours exceeds.
fn local_maxima(spectrum: &Spectrum) -> Vec<Peak> {
    spectrum
        .half_plane()
        .filter(|&[x, y]| (x as f64).hypot(y as f64) >= LINES_MIN)
        .filter_map(|[x, y]| {
            let power = spectrum.power([x, y]);
            let highest = (-1..=1)
                .flat_map(|dy| (-1..=1).map(move |dx| [x + dx, y + dy]))
                .all(|line| spectrum.power(line) <= power);
            (highest && power > 0.0).then_some(Peak { line: [x as f64, y as f64], power })
        })
        .collect()
}

/// The peak's place between the lines and its height there.
fn refine(spectrum: &Spectrum, line: [f64; 2]) -> Peak {
    let line = line.map(|line| line as i64);
    let centre = spectrum.at(line).norm();
    let mut peak = Peak { line: [0.0; 2], power: centre * centre };
    let counts = [spectrum.values.ncols(), spectrum.values.nrows()];
    for axis in 0..2 {
        let beside = |step: i64| {
            let mut line = line;
            line[axis] += step;
            spectrum.at(line).norm()
        };
        // Fewer than four samples have no three lines apart.
        let offset = if counts[axis] < 4 { 0.0 } else { hann_offset(beside(-1), centre, beside(1)) };
        peak.line[axis] = line[axis] as f64 + offset;
        peak.power /= hann_response(offset).powi(2);
    }
    peak
}

/// Place of a sinusoid between the lines from the moduli at three lines, the middle one the highest: the
/// window's response `sinc(δ) / (1 - δ²)` makes the ratio of two neighbours `(1 + δ) / (2 - δ)`.
fn hann_offset(before: f64, centre: f64, after: f64) -> f64 {
    let from = |beside: f64| {
        let ratio = beside / centre;
        ((2.0 * ratio - 1.0) / (ratio + 1.0)).clamp(0.0, 0.5)
    };
    if after >= before { from(after) } else { -from(before) }
}

/// A Hann window's response to a sinusoid `offset` lines away, `|offset| <= 1/2`.
fn hann_response(offset: f64) -> f64 {
    let angle = PI * offset;
    let sinc = if angle.abs() < 1e-4 { 1.0 - angle * angle / 6.0 } else { angle.sin() / angle };
    sinc / (1.0 - offset * offset)
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
    fn around(&self, spectrum: &Spectrum, line: [f64; 2]) -> f64 {
        let ring = spectrum.ring(line);
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
