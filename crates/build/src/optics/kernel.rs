//! Interpolation kernels in frequency: how a spectrum between its grid lines follows from the lines.

use std::f64::consts::{PI, SQRT_2};

/// Oversampling of the frequency grid for windows inside a scan.
pub(crate) const OVERSAMPLING: f64 = 1.5;

/// Width of the interpolation kernel for windows inside a scan, in grid lines. The aliasing error of
/// this kernel is about `exp(-π w sqrt(1 - 1/oversampling))` = 3e-6 of the local amplitude (Barnett,
/// Magland, af Klinteberg 2019, eq. 4.7).
pub const SEMICIRCLE_TAPS: usize = 7;

/// Half width of the Gaussian kernels in their own standard deviations; they fall to 2.7e-7 there.
const GAUSSIAN_REACH: f64 = 5.5;

/// Share of a Gaussian power kernel's peak beyond which it reads no lines: 2.7e-7.
pub(super) fn gaussian_end() -> f64 {
    (-0.5 * GAUSSIAN_REACH * GAUSSIAN_REACH).exp()
}

/// A kernel in one frequency axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kernel {
    /// `exp(β(sqrt(1 - z²) - 1))`: interpolates the spectrum of a compact window (NUFFT of type 2).
    Semicircle,
    /// Amplitude of a Gaussian window of this σ in nm, divided by the root of its norm: turns the lines
    /// of a periodic surface into the spectrum seen through one window.
    GaussianAmplitude {
        /// Standard deviation of the window in nm.
        sigma_nm: f64,
    },
    /// Power spectrum of that window, of unit integral: turns the line powers into the mean over all
    /// window positions.
    GaussianPower {
        /// Standard deviation of the window in nm.
        sigma_nm: f64,
    },
}

/// The taps that interpolate a list of frequencies along one axis.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Taps {
    /// Taps per frequency.
    pub count: usize,
    /// Grid line of the first tap of each frequency.
    pub first: Vec<i32>,
    /// Weights, `count` for each frequency.
    pub weight: Vec<f32>,
}

/// Shape parameter of the semicircle kernel (Barnett et al. 2019, with their safety factor of 0.97).
fn semicircle_beta() -> f64 {
    0.97 * PI * SEMICIRCLE_TAPS as f64 * (1.0 - 0.5 / OVERSAMPLING)
}

fn semicircle(z_lines: f64) -> f64 {
    let z = 2.0 * z_lines / SEMICIRCLE_TAPS as f64;
    if z.abs() >= 1.0 {
        return 0.0;
    }
    (semicircle_beta() * ((1.0 - z * z).sqrt() - 1.0)).exp()
}

/// What samples at `position_nm` are divided by so that the semicircle kernel on lines `step` (1/nm)
/// apart gives their transform: the kernel's own transform there, by the midpoint rule.
pub(crate) fn semicircle_transform(position_nm: f64, step: f64) -> f64 {
    const NODES: usize = 200;
    let width = SEMICIRCLE_TAPS as f64 / NODES as f64;
    (0..NODES)
        .map(|i| {
            let z = (i as f64 + 0.5) * width - 0.5 * SEMICIRCLE_TAPS as f64;
            semicircle(z) * (2.0 * PI * z * step * position_nm).cos() * width
        })
        .sum()
}

impl Kernel {
    /// Half width in 1/nm on lines `step` apart, with the frequencies averaged over a box.
    pub(crate) fn half_width(&self, step: f64, box_width: f64) -> f64 {
        match *self {
            Self::Semicircle => 0.5 * SEMICIRCLE_TAPS as f64 * step,
            Self::GaussianAmplitude { sigma_nm } => GAUSSIAN_REACH / (2.0 * PI * sigma_nm),
            Self::GaussianPower { sigma_nm } => GAUSSIAN_REACH / (2.0 * PI * SQRT_2 * sigma_nm) + 0.5 * box_width,
        }
    }

    /// Value at a distance (1/nm) from a line. `box_width` (1/nm) averages the power kernel over a box
    /// and must be 0 for the amplitude kernels, whose square is what would have to be averaged.
    pub fn value(&self, distance: f64, step: f64, box_width: f64) -> f64 {
        match *self {
            Self::Semicircle => semicircle(distance / step),
            Self::GaussianAmplitude { sigma_nm } => {
                (2.0 * PI.sqrt() * sigma_nm).sqrt() * (-2.0 * (PI * sigma_nm * distance).powi(2)).exp()
            }
            Self::GaussianPower { sigma_nm } => {
                if box_width == 0.0 {
                    return 2.0 * PI.sqrt() * sigma_nm * (-(2.0 * PI * sigma_nm * distance).powi(2)).exp();
                }
                // Differences of complementary error functions keep their digits in the tails.
                let reach = 2.0 * PI * sigma_nm;
                let (near, far) = (distance.abs() - 0.5 * box_width, distance.abs() + 0.5 * box_width);
                0.5 * (libm::erfc(reach * near) - libm::erfc(reach * far)) / box_width
            }
        }
    }

    /// Weights for `L` frequencies (1/nm), each with a kernel of its own, of all the lines that any of them reads, in double
    /// precision, zero where one does not read, and the first line's index. Lines are `step` (1/nm) apart.
    ///
    /// Along lines a Gaussian changes by a factor that itself changes by a constant factor: three exponentials give them
    /// all, and after `n` lines rounding is at most about `n²` times 1e-16.
    pub(super) fn line_weights<const L: usize>(
        kernels: [Self; L],
        frequency: [f64; L],
        step: f64,
        weights: &mut Vec<[f64; L]>,
    ) -> i64 {
        let halves = kernels.map(|kernel| kernel.half_width(step, 0.0) / step);
        let counts = halves.map(|half| (2.0 * half).ceil().max(1.0) as usize);
        let firsts: [i64; L] = std::array::from_fn(|i| (frequency[i] / step - halves[i]).ceil() as i64);
        let low = firsts.into_iter().min().unwrap_or(0);
        let end = firsts.into_iter().zip(counts).map(|(first, count)| first + count as i64).max().unwrap_or(low);
        weights.clear();
        weights.resize((end - low) as usize, [0.0; L]);
        for (i, (first, kernel)) in firsts.into_iter().zip(kernels).enumerate() {
            // Lines from the first one to the frequency.
            let distance = frequency[i] / step - first as f64;
            let own = weights[(first - low) as usize..].iter_mut().take(counts[i]).map(|weights| &mut weights[i]);
            let value = |lines: f64| kernel.value(lines * step, step, 0.0);
            let rate = match kernel {
                Self::Semicircle => {
                    own.enumerate().for_each(|(tap, weight)| *weight = value(distance - tap as f64));
                    continue;
                }
                Self::GaussianAmplitude { sigma_nm } => 2.0 * (PI * sigma_nm * step).powi(2),
                Self::GaussianPower { sigma_nm } => (2.0 * PI * sigma_nm * step).powi(2),
            };
            let (mut here, mut factor) = (value(distance), (rate * (2.0 * distance - 1.0)).exp());
            let change = (-2.0 * rate).exp();
            for weight in own {
                *weight = here;
                here *= factor;
                factor *= change;
            }
        }
        low
    }

    /// Taps for a list of frequencies (1/nm) on lines `step` apart.
    pub(crate) fn taps(&self, frequencies: &[f64], step: f64, box_width: f64) -> Taps {
        let half = self.half_width(step, box_width) / step;
        // Half-open: at most this many lines lie within one kernel width.
        let count = (2.0 * half).ceil().max(1.0) as usize;
        let mut taps = Taps {
            count,
            first: Vec::with_capacity(frequencies.len()),
            weight: Vec::with_capacity(frequencies.len() * count),
        };
        for &frequency in frequencies {
            let first = (frequency / step - half).ceil() as i32;
            taps.first.push(first);
            taps.weight.extend((0..count).map(|tap| {
                let distance = frequency - f64::from(first + tap as i32) * step;
                self.value(distance, step, box_width) as f32
            }));
        }
        taps
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn power_kernel_has_unit_integral_and_is_the_square_of_the_amplitude() {
        let sigma_nm = 4_000.0;
        let (power, amplitude) = (Kernel::GaussianPower { sigma_nm }, Kernel::GaussianAmplitude { sigma_nm });
        let step = 1e-7;
        for box_width in [0.0, 5e-5] {
            let sum: f64 = (-3000..=3000).map(|i| power.value(f64::from(i) * step, step, box_width) * step).sum();
            assert!((sum - 1.0).abs() < 1e-7, "{sum}");
        }
        let ratio = amplitude.value(3e-5, 1.0, 0.0).powi(2) / power.value(3e-5, 1.0, 0.0);
        assert!((ratio - 1.0).abs() < 1e-12);
    }

    #[test]
    fn boxed_power_kernel_is_the_mean_of_the_plain_one() {
        let kernel = Kernel::GaussianPower { sigma_nm: 5_000.0 };
        let (at, width) = (4e-5, 6e-5);
        let mean: f64 =
            (0..1000).map(|i| kernel.value(at + (f64::from(i) / 999.5 - 0.49975) * width, 1.0, 0.0)).sum::<f64>() / 1e3;
        assert!((kernel.value(at, 1.0, width) / mean - 1.0).abs() < 1e-3);
    }

    #[test]
    fn weights_of_lines_are_the_kernel_at_their_distances() {
        let sigma_nm = 4_000.0;
        let kernels = [Kernel::GaussianPower { sigma_nm }, Kernel::GaussianAmplitude { sigma_nm }, Kernel::Semicircle];
        // Lines wider apart than the kernel, about as wide as it, and a thousand of them under it.
        for step in [1e-3, 3e-5, 2e-7] {
            for kernel in kernels {
                let frequencies = [0.0, 1.234e-4, 1.3e-4, -7.7e-5];
                let mut found = Vec::new();
                let first = Kernel::line_weights([kernel; 4], frequencies, step, &mut found);
                let half = kernel.half_width(step, 0.0);
                for (i, frequency) in frequencies.into_iter().enumerate() {
                    let mut lines = 0;
                    for (line, weights) in (first..).zip(&found) {
                        let distance = frequency - line as f64 * step;
                        let expected = kernel.value(distance, step, 0.0);
                        let is_read = weights[i] != 0.0;
                        lines += usize::from(is_read);
                        assert!(is_read || distance.abs() > half * (1.0 - 1e-9), "{kernel:?} {step} {distance}");
                        // The square of a thousand lines times the rounding of one.
                        let error = (weights[i] / expected - 1.0).abs();
                        assert!(!is_read || error < 1e-10, "{kernel:?} {step} {frequency} {line}: {error:e}");
                    }
                    let most = (2.0 * half / step).ceil().max(1.0) as usize;
                    assert!(lines <= most && lines + 1 >= most, "{kernel:?} {step}: {lines} of {most}");
                }
            }
        }
    }

    #[test]
    fn semicircle_taps_interpolate_a_plane_wave_within_the_stated_error() {
        // A sample at x contributes exp(2πi ξ x): lines at `step`, x within half the padded period.
        let step = 1e-5;
        for share in [0.0, 0.4, 0.8, 1.0] {
            let x = share * 0.5 / (step * OVERSAMPLING);
            let factor = semicircle_transform(x, step);
            for frequency in [0.0, 3.3e-6, 7.77e-5] {
                let taps = Kernel::Semicircle.taps(&[frequency], step, 0.0);
                let (mut re, mut im) = (0.0, 0.0);
                for (tap, weight) in taps.weight.iter().enumerate() {
                    let angle = 2.0 * PI * f64::from(taps.first[0] + tap as i32) * step * x;
                    re += f64::from(*weight) * angle.cos() / factor;
                    im += f64::from(*weight) * angle.sin() / factor;
                }
                let exact = 2.0 * PI * frequency * x;
                let error = ((re - exact.cos()).powi(2) + (im - exact.sin()).powi(2)).sqrt();
                // Ten times the asymptotic estimate: its constant is not given, and weights are f32.
                assert!(error < 3e-5, "share {share}, frequency {frequency}: {error:e}");
            }
        }
    }
}
