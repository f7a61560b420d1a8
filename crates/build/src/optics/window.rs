//! Coherence windows: where they stand on a scan, their samples, their norm.

use std::f64::consts::{PI, TAU};

use super::config::{Edge, OpticsConfig, Windows};
use crate::height::HeightField;
use diffraction_brdf::error::{Error, Result};

/// Half width, in σ, beyond which a window's samples are left out where the scan is larger: the
/// amplitude there is `exp(-5.5²/2) = 2.7e-7`.
pub const SUPPORT_SIGMAS: f64 = 5.5;

/// Half width, in σ, that must fit into a scan on each side under `Edge::Fade`.
pub const FADE_SIGMAS: f64 = 4.0;

/// Distance between the averaged windows of `Edge::Fade` in σ: intensities of two windows that far
/// apart are correlated by `exp(-d²/2σ²)` = 0.14.
const SPACING_SIGMAS: f64 = 2.0;

/// Most σ from one sample to the next: at four, a lobe's standard deviation `λ/(2√2 πσ)` is 0.9 of all that the sampling
/// answers for, `λ/2` over the pitch. Beyond, there is nothing to resolve, and every look-up would sum over every line.
pub const PITCH_SIGMAS_MAX: f64 = 4.0;

/// How the surface around a window continues.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Placement {
    /// A window within the scan, centred at `centre_nm` from the scan's middle, along x and y.
    Inside {
        /// Centre in nm from the middle of the scan.
        centre_nm: [f64; 2],
    },
    /// One window in the middle of the periodically repeated scan.
    TileCentre,
    /// The mean over every window position on the periodically repeated scan.
    TileMean,
}

/// The placements that a configuration averages over, for one scan.
///
/// # Errors
/// `Error::Limit` if the scan is smaller than `Edge::Fade` allows, or its samples lie further apart than
/// [`PITCH_SIGMAS_MAX`].
pub fn placements(field: &HeightField, optics: &OpticsConfig) -> Result<Vec<Placement>> {
    check_pitch(field, optics.least_sigma_nm())?;
    check_source(optics)?;
    if optics.edge == Edge::Auto && optics.windows == Windows::Centre {
        return Err(Error::limit(
            "edge = \"auto\" is a mean over all positions of the window, and windows = \"centre\" asks for one",
            "leave windows at \"grid\", or use coherence.edge = \"tile\" or \"fade\"",
        ));
    }
    if optics.edge != Edge::Fade {
        return Ok(vec![match optics.windows {
            Windows::Grid => Placement::TileMean,
            Windows::Centre => Placement::TileCentre,
        }]);
    }
    let extent = field.extent_nm();
    let smallest = extent[0].min(extent[1]);
    // One part in 1e9 of slack: 65 µm / 8 is meant to pass.
    if 2.0 * FADE_SIGMAS * optics.sigma_nm > smallest * (1.0 + 1e-9) {
        return Err(Error::limit(
            format!(
                "the scan is {:.4} x {:.4} µm: with edge = \"fade\" a coherence window of σ = {:.4} µm needs {:.4} µm",
                extent[0] * 1e-3,
                extent[1] * 1e-3,
                optics.sigma_nm * 1e-3,
                2.0 * FADE_SIGMAS * optics.sigma_nm * 1e-3
            ),
            format!("use coherence.edge = \"tile\", or sigma_um <= {:.4}", smallest * 1e-3 / (2.0 * FADE_SIGMAS)),
        ));
    }
    let along = |extent_nm: f64| -> Vec<f64> {
        if optics.windows == Windows::Centre {
            return vec![0.0];
        }
        let room = extent_nm - 2.0 * FADE_SIGMAS * optics.sigma_nm;
        let count = (room.max(0.0) / (SPACING_SIGMAS * optics.sigma_nm)).floor() as usize + 1;
        let spacing = if count > 1 { room / (count - 1) as f64 } else { 0.0 };
        (0..count).map(|i| (i as f64 - 0.5 * (count - 1) as f64) * spacing).collect()
    };
    let columns = along(extent[0]);
    Ok(along(extent[1])
        .iter()
        .flat_map(|&y| columns.iter().map(move |&x| Placement::Inside { centre_nm: [x, y] }))
        .collect())
}

/// Relative standard deviation of the mean over windows at one wavelength, from one piece of a rough surface to another;
/// windows by scan. 0 where the mean is over all positions of a scan that repeats: it is that surface's own.
///
/// Outside the coherent lobe, the amplitude of a window that holds many bumps is a sum of many phasors, a complex Gaussian
/// number: its power, speckle, deviates by its own mean. Amplitudes of two windows `d` apart are correlated by `∫ g(x) g(x
/// - d) / ∫ g² = exp(-d²/4σ²)`, powers by its square, and different scans not at all. The variance of the mean of `N` is then
/// `Σ exp(-d²/2σ²) / N²` over all pairs. A spectrum averages over wavelengths as well, and moves by less.
pub fn speckle_deviation(windows: &[(usize, Placement)], sigma_nm: f64) -> f64 {
    let correlation = |a: &(usize, Placement), b: &(usize, Placement)| match (a, b) {
        ((scan, _), (other, _)) if scan != other => 0.0,
        ((_, Placement::Inside { centre_nm: [x, y] }), (_, Placement::Inside { centre_nm: [u, v] })) => {
            (-0.5 * ((x - u).powi(2) + (y - v).powi(2)) / (sigma_nm * sigma_nm)).exp()
        }
        ((_, Placement::TileMean), _) | (_, (_, Placement::TileMean)) => 0.0,
        _ => 1.0,
    };
    let of_window = |a| windows.iter().map(|b| correlation(a, b)).sum::<f64>();
    windows.iter().map(of_window).sum::<f64>().sqrt() / windows.len().max(1) as f64
}

/// Refuses a window that changes with the wavelength where it stands somewhere on the scan: its samples would be others at
/// every wavelength, and with them the transforms.
fn check_source(optics: &OpticsConfig) -> Result<()> {
    let is_mean = optics.edge != Edge::Fade && optics.windows == Windows::Grid;
    if is_mean || optics.source_deg.is_none() {
        return Ok(());
    }
    Err(Error::limit(
        "a source of fixed size has another coherence window at each wavelength, which only the mean over all positions on a \
         repeated scan takes",
        "use coherence.edge = \"auto\" or \"tile\" with windows = \"grid\", or give coherence.sigma_um in place of source_deg",
    ))
}

/// Refuses a window that falls between samples.
fn check_pitch(field: &HeightField, sigma_nm: f64) -> Result<()> {
    let sampled = field.size().into_iter().zip(field.pitch_nm).filter(|(count, _)| *count > 1);
    let widest = sampled.map(|(_, pitch)| pitch).fold(0.0, f64::max);
    if widest <= PITCH_SIGMAS_MAX * sigma_nm {
        return Ok(());
    }
    Err(Error::limit(
        format!(
            "samples lie {:.4} µm apart, too far for a coherence window of σ = {:.4} µm to see any structure",
            widest * 1e-3,
            sigma_nm * 1e-3
        ),
        format!("check the pitch; use a finer scan, or coherence.sigma_um >= {:.4}", widest * 1e-3 / PITCH_SIGMAS_MAX),
    ))
}

/// Root mean square of the heights about their mean in nm, each sample weighted by its share `g²` of the window's power.
pub(crate) fn rms_within_nm(field: &HeightField, placement: Placement, sigma_nm: f64) -> f64 {
    let size = field.size();
    let [x, y] = [0, 1].map(|axis| window_axis(placement, axis, size[axis], field.pitch_nm[axis], sigma_nm));
    let mut sums = [0.0; 3];
    for (row, gy) in field.heights_nm.outer_iter().skip(y.first).zip(&y.amplitude) {
        for (h, gx) in row.iter().skip(x.first).zip(&x.amplitude) {
            let weight = (gx * gy).powi(2);
            [1.0, *h, h * h].into_iter().zip(&mut sums).for_each(|(moment, sum)| *sum += weight * moment);
        }
    }
    let [norm, mean, square] = sums;
    (square / norm - (mean / norm).powi(2)).max(0.0).sqrt()
}

/// One axis of a window: its samples' positions and amplitudes. The window is the product of two axes.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct WindowAxis {
    /// First sample of the scan that lies in the window.
    pub first: usize,
    /// Positions of the samples in nm from the window's centre, ascending for x, descending for y.
    pub position_nm: Vec<f64>,
    /// Amplitude `g` at each sample, for the window's mean phasor; periodised where the scan repeats.
    pub amplitude: Vec<f64>,
    /// `∫ g dx` in nm.
    pub integral_nm: f64,
    /// `∫ g² dx` in nm.
    pub norm_nm: f64,
}

impl WindowAxis {
    /// `∫ g cos(2πξx) dx`, over the samples, at frequencies `ξ` in 1/nm, divided by the root of the norm.
    ///
    /// Positions are evenly spaced: from one to the next each phasor is turned by the same angle. After `n` samples
    /// rounding has turned it by `n` times 1e-16 too much or too little.
    pub(super) fn transforms<const L: usize>(&self, frequency: [f64; L]) -> [f64; L] {
        let pitch_nm = match self.position_nm[..] {
            [first, second, ..] => second - first,
            _ => self.integral_nm,
        };
        let start = self.position_nm.first().copied().unwrap_or(0.0);
        let mut sums = [0.0; L];
        let [mut im, mut re] = parts(frequency.map(|f| (TAU * f * start).sin_cos()));
        let [step_im, step_re] = parts(frequency.map(|f| (TAU * f * pitch_nm).sin_cos()));
        for amplitude in &self.amplitude {
            for i in 0..L {
                sums[i] += amplitude * re[i];
                (re[i], im[i]) = (re[i] * step_re[i] - im[i] * step_im[i], re[i] * step_im[i] + im[i] * step_re[i]);
            }
        }
        sums.map(|sum| sum * pitch_nm.abs() / self.norm_nm.sqrt())
    }
}

fn parts<const L: usize>(pairs: [(f64, f64); L]) -> [[f64; L]; 2] {
    [pairs.map(|(first, _)| first), pairs.map(|(_, second)| second)]
}

/// The axis of a window over `count` samples of spacing `pitch_nm`; `axis` 0 is x, 1 is y (row 0 at +y).
pub(crate) fn window_axis(placement: Placement, axis: usize, count: usize, pitch_nm: f64, sigma_nm: f64) -> WindowAxis {
    let middle = 0.5 * (count - 1) as f64;
    let sign = if axis == 0 { 1.0 } else { -1.0 };
    let position = |i: usize, centre: f64| sign * (i as f64 - middle) * pitch_nm - centre;
    let gaussian = |x: f64| (-0.5 * (x / sigma_nm).powi(2)).exp();
    match placement {
        Placement::Inside { centre_nm } => {
            let inside: Vec<usize> =
                (0..count).filter(|&i| position(i, centre_nm[axis]).abs() <= SUPPORT_SIGMAS * sigma_nm).collect();
            let position_nm: Vec<f64> = inside.iter().map(|&i| position(i, centre_nm[axis])).collect();
            let amplitude: Vec<f64> = position_nm.iter().map(|&x| gaussian(x)).collect();
            WindowAxis {
                first: inside.first().copied().unwrap_or(0),
                integral_nm: amplitude.iter().sum::<f64>() * pitch_nm,
                norm_nm: amplitude.iter().map(|g| g * g).sum::<f64>() * pitch_nm,
                position_nm,
                amplitude,
            }
        }
        Placement::TileCentre | Placement::TileMean => {
            let period = count as f64 * pitch_nm;
            let position_nm: Vec<f64> = (0..count).map(|i| position(i, 0.0)).collect();
            let amplitude = match placement {
                Placement::TileMean => vec![1.0; count],
                _ => position_nm.iter().map(|&x| periodised(x, period, sigma_nm, gaussian)).collect(),
            };
            WindowAxis {
                first: 0,
                integral_nm: TAU.sqrt() * sigma_nm,
                norm_nm: PI.sqrt() * sigma_nm,
                position_nm,
                amplitude,
            }
        }
    }
}

/// `Σ_j g(x + j period)`, all terms above 1e-16.
fn periodised(x: f64, period: f64, sigma: f64, gaussian: impl Fn(f64) -> f64) -> f64 {
    let reach = (9.0 * sigma / period).ceil() as i64 + 1;
    (-reach..=reach).map(|j| gaussian(x + j as f64 * period)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    use diffraction_brdf::spectrum::Illuminant;
    use ndarray::Array2;

    fn optics(sigma_nm: f64, windows: Windows) -> OpticsConfig {
        OpticsConfig::ideal(Illuminant::E, sigma_nm, Edge::Fade, windows)
    }

    fn field(count: usize, pitch: f64) -> HeightField {
        HeightField { heights_nm: Array2::zeros((count, count)), pitch_nm: [pitch, pitch] }
    }

    #[test]
    fn fade_takes_an_eighth_and_no_more() {
        let scan = field(1332, 65_000.0 / 1332.0);
        assert_eq!(placements(&scan, &optics(8_125.0, Windows::Grid)).unwrap().len(), 1);
        let refused = placements(&scan, &optics(8_200.0, Windows::Grid)).unwrap_err().to_string();
        assert!(refused.contains("8.1250") && refused.contains("tile"), "{refused}");
        assert_eq!(placements(&scan, &optics(4_000.0, Windows::Grid)).unwrap().len(), 25);
        assert_eq!(placements(&scan, &optics(4_000.0, Windows::Centre)).unwrap().len(), 1);
    }

    #[test]
    fn windows_between_samples_are_refused() {
        let tiled = |sigma_nm| OpticsConfig { edge: Edge::Tile, ..optics(sigma_nm, Windows::Grid) };
        assert!(placements(&field(48, 8_000.0), &tiled(2_000.0)).is_ok());
        let refused = placements(&field(48, 8_000.0), &tiled(1_999.0)).unwrap_err().to_string();
        assert!(refused.contains("8.0000 µm apart") && refused.contains("sigma_um >= 2.0000"), "{refused}");
        // One sample along an axis is no sampling of it.
        let row = HeightField { heights_nm: Array2::zeros((1, 48)), pitch_nm: [100.0, 1e6] };
        assert!(placements(&row, &tiled(2_000.0)).is_ok());
    }

    #[test]
    fn norms_meet_the_gaussian_integrals() {
        let axis = window_axis(Placement::Inside { centre_nm: [0.0; 2] }, 1, 1001, 50.0, 3_000.0);
        assert!((axis.norm_nm / (PI.sqrt() * 3_000.0) - 1.0).abs() < 1e-12);
        assert!((axis.integral_nm / (TAU.sqrt() * 3_000.0) - 1.0).abs() < 1e-6);
        assert!(axis.position_nm[0] > axis.position_nm[1], "row 0 is the +y edge");
        let periodic = window_axis(Placement::TileCentre, 0, 100, 50.0, 3_000.0);
        let sum: f64 = periodic.amplitude.iter().sum::<f64>() * 50.0;
        assert!((sum / (TAU.sqrt() * 3_000.0) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn transforms_of_a_window_are_the_sums_of_cosines() {
        for axis in [0, 1] {
            let window = window_axis(Placement::Inside { centre_nm: [130.0, -77.0] }, axis, 1332, 48.8, 8_000.0);
            let frequencies = [0.0, 1.7e-6, -2.1e-5, 5.2e-3];
            let plain = |frequency: f64| {
                let samples = window.position_nm.iter().zip(&window.amplitude);
                samples.map(|(x, g)| g * (TAU * frequency * x).cos()).sum::<f64>() * 48.8 / window.norm_nm.sqrt()
            };
            let found = window.transforms(frequencies);
            for (found, frequency) in found.into_iter().zip(frequencies) {
                // A thousand turns, each rounded, of the largest value.
                let error = (found - plain(frequency)).abs() / plain(0.0);
                assert!(error < 1e-12, "{frequency}: {error:e}");
            }
            assert!((plain(1.7e-6) - plain(1.701e-6)).abs() > 1e-6 * plain(0.0), "a thousandth of a frequency shows");
        }
    }
}
