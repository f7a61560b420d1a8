//! The reference: Eq. 1 of Dhillon et al. 2014 summed directly over every sample, in double precision.
//!
//! No Fourier transform, no table, no interpolation in `s`: for one pair of directions and every
//! wavelength, `P = ΣΣ g exp(i k w h) exp(2πi(ξx + ηy))` over the scan. Slow and obvious on purpose; the
//! only economy is that from one wavenumber to the next each sample's phasor is multiplied by a
//! constant instead of being computed from its phase.

use std::f64::consts::TAU;

use rayon::prelude::*;
use rustfft::num_complex::Complex;

use super::axis_lines::{Along, AxisLines, KnownLines, axis_lines, held_bytes_at};
use super::coherence::Coherence;
use super::config::OpticsConfig;
use super::factors::PairFactors;
use super::spectra::half_height_range_nm;
use super::window::{Placement, WindowAxis, placements, window_axis};
use crate::height::HeightField;
use diffraction_brdf::direction::{Vec3, Xyz, wave_vector_change};
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::spectrum::{Illuminant, SpectralQuadrature, uniform_wavenumbers};

/// The step of the reference in wavenumber.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WavenumberStep {
    /// Largest step, in units of the window's frequency width divided by `|(u, v)|`: 1.41 standard deviations of what one
    /// line of a periodic surface shows (see [`diffraction_brdf::spectrum::Lags`]).
    of_width: f64,
    /// Fewest wavelengths under a smooth light: where the window asks for fewer, the observer's curves do not. A lamp of
    /// lines or an arbitrary table has three times as many.
    fewest: usize,
}

/// Where errors are measured: 0.57 deviations, of which one line's luminance under daylight errs by 2e-6.
pub const FULL_STEP: WavenumberStep = WavenumberStep { of_width: 0.4, fewest: 200 };

/// For the reference pictures: one deviation, of which one line errs by 3e-5, and no fewer wavelengths than leave 1e-4 at
/// small `|(u, v)|`; under a lamp of lines 4e-4.
pub const PICTURE_STEP: WavenumberStep = WavenumberStep { of_width: 0.7, fewest: 44 };

/// The wavelengths that resolve every spectral feature of a window in a direction, with XYZ weights;
/// `half_range_nm` is half the surface's range of heights.
///
/// # Errors
/// `Error::Call` if the light is invisible.
pub(crate) fn resolving_wavelengths(
    optics: &OpticsConfig,
    q: Vec3,
    half_range_nm: f64,
    step: WavenumberStep,
) -> Result<SpectralQuadrature> {
    uniform_wavenumbers(&optics.illuminant, optics.wavelength_nm, resolving_count(optics, q, half_range_nm, step))
}

/// How many wavelengths, evenly spread in `1/λ`, resolve the spectrum of a pair of directions. Rounded up to five binary digits: directions share
/// few numbers then, and with them the quadratures, whose weights cost more than the sums they weigh.
///
/// As a function of `1/λ`, `|P|²` consists of waves at the lags `ρ Δx + |w| Δh` between two points of the surface. The
/// window spreads the former with a standard deviation of `√2 ρσ`; the latter are at most twice the half range, and
/// spread by `√2 |w|` times it where only the highest and the lowest heights occur. Variances add.
pub fn resolving_count(optics: &OpticsConfig, q: Vec3, half_range_nm: f64, step: WavenumberStep) -> usize {
    let [low_nm, high_nm] = optics.wavelength_nm;
    let span = 1.0 / low_nm - 1.0 / high_nm;
    let radius = q[0].hypot(q[1]);
    // In the lobe it is the light's own window that shapes the pulses.
    let in_lobe = TAU * optics.lobe_sigma_nm() * radius / high_nm < LOBE_REACH;
    let sigma_nm = if in_lobe { optics.lobe_sigma_nm() } else { optics.sigma_nm };
    let needed = span * TAU * (radius * sigma_nm).hypot(q[2] * half_range_nm) / step.of_width;
    let fewest = match optics.illuminant {
        // Spiky or arbitrary spectra: weights integrate them exactly, but times polynomials through the wavelengths, which
        // then have to follow the surface's spectrum at each spike by itself.
        Illuminant::F(_) | Illuminant::Tabulated { .. } => 3 * step.fewest,
        _ => step.fewest,
    };
    let count = (needed.ceil() as usize).max(fewest);
    count.next_multiple_of(1 << count.max(1).ilog2().saturating_sub(4))
}

/// XYZ of the BRDF in 1/sr, averaged over a specimen's prepared scans and their windows.
///
/// # Errors
/// A scan too small for the window, or an invisible light.
pub fn brdf_xyz(fields: &[HeightField], optics: &OpticsConfig, wi: Vec3, wo: Vec3) -> Result<Xyz> {
    let quadrature = quadrature_of(fields, optics, wi, wo)?;
    let spectrum = brdf_spectrum(fields, optics, wi, wo, &quadrature.wavelengths_nm)?;
    Ok(weighed(&quadrature, &spectrum))
}

/// XYZ of the BRDF in 1/sr by polarisation: ss, sp, ps, pp, the incident one first; half their sum is [`brdf_xyz`].
///
/// # Errors
/// As [`brdf_xyz`], and a factor that does not know polarisation.
pub fn brdf_xyz_polarised(fields: &[HeightField], optics: &OpticsConfig, wi: Vec3, wo: Vec3) -> Result<[Xyz; 4]> {
    let quadrature = quadrature_of(fields, optics, wi, wo)?;
    let spectra = brdf_spectrum_polarised(fields, optics, wi, wo, &quadrature.wavelengths_nm)?;
    Ok(std::array::from_fn(|kind| weighed(&quadrature, &spectra.iter().map(|f| f[kind]).collect::<Vec<_>>())))
}

fn quadrature_of(fields: &[HeightField], optics: &OpticsConfig, wi: Vec3, wo: Vec3) -> Result<SpectralQuadrature> {
    let half_range_nm = fields.iter().map(half_height_range_nm).fold(0.0, f64::max);
    resolving_wavelengths(optics, wave_vector_change(wi, wo), half_range_nm, FULL_STEP)
}

fn weighed(quadrature: &SpectralQuadrature, spectrum: &[f64]) -> Xyz {
    let mut xyz = [0.0; 3];
    for (f, weight) in spectrum.iter().zip(&quadrature.weights) {
        for c in 0..3 {
            xyz[c] += weight[c] * f;
        }
    }
    xyz
}

/// Bytes that what pairs hold that are evaluated at once may take together: each has the weights of all its lines, a quarter of a gigabyte for a
/// scan of 8192 samples a side.
const HELD_BYTES: usize = 512 << 20;

/// XYZ of the BRDF for many pairs of directions, in parallel, as many at once as what they hold leaves room for.
///
/// # Errors
/// As [`brdf_xyz`].
pub fn brdf_xyz_batch(fields: &[HeightField], optics: &OpticsConfig, pairs: &[(Vec3, Vec3)]) -> Result<Vec<Xyz>> {
    let at_once = (HELD_BYTES / held_bytes(fields, optics, pairs)?.max(1)).max(1);
    let mut xyz = Vec::with_capacity(pairs.len());
    for pairs in pairs.chunks(at_once) {
        let some: Result<Vec<Xyz>> = pairs.par_iter().map(|&(wi, wo)| brdf_xyz(fields, optics, wi, wo)).collect();
        xyz.extend(some?);
    }
    Ok(xyz)
}

/// Most bytes that one of some pairs of directions holds while it is summed: the weights of the lines that it reaches along both axes, and a
/// sum for each two of them at each wavelength. No two windows are held at a time.
///
/// # Errors
/// A scan too small for the window.
pub fn held_bytes(fields: &[HeightField], optics: &OpticsConfig, pairs: &[(Vec3, Vec3)]) -> Result<usize> {
    let half_range_nm = fields.iter().map(half_height_range_nm).fold(0.0, f64::max);
    let qs: Vec<Vec3> = pairs.iter().map(|&(wi, wo)| wave_vector_change(wi, wo)).collect();
    let mut most = 0;
    for field in fields {
        let Some(&placement) = placements(field, optics)?.first() else { continue };
        let of = |q: &Vec3| {
            held_bytes_at(field, placement, optics, *q, resolving_count(optics, *q, half_range_nm, FULL_STEP))
        };
        most = qs.iter().map(of).fold(most, usize::max);
    }
    Ok(most)
}

/// The BRDF in 1/sr at each wavelength.
///
/// # Errors
/// A scan too small for the window, and a wavelength at which the material is not known.
pub fn brdf_spectrum(
    fields: &[HeightField],
    optics: &OpticsConfig,
    wi: Vec3,
    wo: Vec3,
    wavelengths_nm: &[f64],
) -> Result<Vec<f64>> {
    optics.check_material_at(wavelengths_nm)?;
    let Some(factors) = PairFactors::of(optics, wi, wo) else { return Ok(vec![0.0; wavelengths_nm.len()]) };
    let spectrum = spectra_of(fields, optics, [factors], wavelengths_nm)?;
    Ok(spectrum.into_iter().map(|[f]| f).collect())
}

/// The BRDF in 1/sr at each wavelength by polarisation: ss, sp, ps, pp, the incident one first.
///
/// # Errors
/// As [`brdf_spectrum`], and a factor that does not know polarisation.
pub fn brdf_spectrum_polarised(
    fields: &[HeightField],
    optics: &OpticsConfig,
    wi: Vec3,
    wo: Vec3,
    wavelengths_nm: &[f64],
) -> Result<Vec<[f64; 4]>> {
    optics.check_material_at(wavelengths_nm)?;
    if optics.front_factor().polarised(wi, wo).is_none() {
        return Err(Error::Call("the scalar factor and ideal reflectors know no polarisation".into()));
    }
    let Some(factors) = PairFactors::polarised(optics, wi, wo) else { return Ok(vec![[0.0; 4]; wavelengths_nm.len()]) };
    spectra_of(fields, optics, factors, wavelengths_nm)
}

/// The BRDF in 1/sr at each wavelength for each of several factors of one pair of directions.
fn spectra_of<const N: usize>(
    fields: &[HeightField],
    optics: &OpticsConfig,
    factors: [PairFactors; N],
    wavelengths_nm: &[f64],
) -> Result<Vec<[f64; N]>> {
    let mut sums = vec![[0.0; N]; wavelengths_nm.len()];
    let windows = fields.iter().map(|field| placements(field, optics)).collect::<Result<Vec<_>>>()?;
    // Every window counts the same, on whatever scan it lies.
    let share = 1.0 / windows.iter().map(Vec::len).sum::<usize>() as f64;
    for (field, windows) in fields.iter().zip(windows) {
        for placement in windows {
            let powers = window_powers(field, placement, optics, &factors[0], wavelengths_nm);
            for ((sums, [rest_nm2, coherent_nm2]), nm) in sums.iter_mut().zip(powers).zip(wavelengths_nm) {
                for (sum, factors) in sums.iter_mut().zip(&factors) {
                    *sum += share * factors.brdf(*nm, rest_nm2, coherent_nm2);
                }
            }
        }
    }
    Ok(sums)
}

/// `(|P|² - |c G̃|²) / A` and `|c|² |G̃|² / A` in nm² at each wavelength for one window, the lobe's image in the horizon among
/// the second.
fn window_powers(
    field: &HeightField,
    placement: Placement,
    optics: &OpticsConfig,
    factors: &PairFactors,
    wavelengths_nm: &[f64],
) -> Vec<[f64; 2]> {
    let lobe = Lobe::new(field, placement, optics);
    let rest_and_lines = line_powers(field, placement, optics, factors.q, wavelengths_nm);
    let phasors2 = lobe.mean_phasors2(field, factors, wavelengths_nm);
    let parts = rest_and_lines.into_iter().zip(phasors2).zip(wavelengths_nm);
    parts
        .map(|((lines, phasor2), nm)| {
            // All lines of a repeated scan end where their kernel does, the one in the middle too.
            let ends = placement == Placement::TileMean && !lines.reads_middle;
            let form_nm2 = if ends { 0.0 } else { lobe.power_nm2([factors.q[0] / nm, factors.q[1] / nm], *nm) };
            let coherent = phasor2 * form_nm2;
            // The mean over all positions adds powers: the line in the middle is the coherent part, whatever blurs it.
            let rest = if placement == Placement::TileMean { lines.others } else { lines.all - coherent };
            let image = factors.image_radius.map_or(0.0, |radius| phasor2 * lobe.closed_form_nm2(radius / nm, *nm));
            [rest, coherent + image]
        })
        .collect()
}

/// Powers of a window's lines in nm²: all together, and all but the one of frequency 0.
struct LinePowers {
    all: f64,
    others: f64,
    /// Whether the window's power reaches the line of frequency 0.
    reads_middle: bool,
}

/// The powers at each wavelength for one window.
fn line_powers(
    field: &HeightField,
    placement: Placement,
    optics: &OpticsConfig,
    q: Vec3,
    wavelengths_nm: &[f64],
) -> Vec<LinePowers> {
    let size = field.size();
    let coherence = optics.body_coherence();
    let axes: [WindowAxis; 2] =
        std::array::from_fn(|axis| window_axis(placement, axis, size[axis], field.pitch_nm[axis], optics.sigma_nm));
    let weights: [Vec<AxisLines>; 2] = std::array::from_fn(|axis| {
        let (axis_samples, count, pitch_nm) = (&axes[axis], size[axis], field.pitch_nm[axis]);
        let along = |nm: f64| Along { axis: axis_samples, count, pitch_nm, sigma_nm: coherence.sigma_nm_at(nm) };
        let mut known = KnownLines::new();
        wavelengths_nm.iter().map(|nm| axis_lines(placement, &along(*nm), q[axis] / nm, &mut known)).collect()
    });
    let amplitudes = phasor_sums(field, &axes, &weights, q[2], wavelengths_nm);
    let of_lines = |lines: &Vec<Complex<f64>>, x: &AxisLines, y: &AxisLines| {
        let mut powers = LinePowers { all: 0.0, others: 0.0, reads_middle: x.middle.is_some() && y.middle.is_some() };
        for (i, amplitude) in lines.iter().enumerate() {
            let (column, row) = (i % x.power.len(), i / x.power.len());
            let power = x.power[column] * y.power[row] * amplitude.norm_sqr();
            powers.all += power;
            powers.others += if x.middle == Some(column) && y.middle == Some(row) { 0.0 } else { power };
        }
        powers
    };
    amplitudes.iter().zip(weights[0].iter().zip(&weights[1])).map(|(lines, (x, y))| of_lines(lines, x, y)).collect()
}

/// The coherent lobe of one window: its mean phasor, and its form.
struct Lobe {
    axes: [WindowAxis; 2],
    /// The light's standard deviation in nm where the form is its Gaussian; `None` for the samples of a window inside the scan.
    gaussian_nm: Option<f64>,
    /// That of the axes.
    sigma_nm: f64,
    coherence: Coherence,
}

impl Lobe {
    fn new(field: &HeightField, placement: Placement, optics: &OpticsConfig) -> Self {
        let sigma_nm = optics.lobe_sigma_nm();
        let axes = [0, 1].map(|axis| window_axis(placement, axis, field.size()[axis], field.pitch_nm[axis], sigma_nm));
        let inside = matches!(placement, Placement::Inside { .. });
        Self { axes, gaussian_nm: (!inside).then_some(sigma_nm), sigma_nm, coherence: optics.lobe_coherence() }
    }

    /// `|c|²` at each wavelength, 0 where neither the lobe nor its image reaches the direction.
    fn mean_phasors2(&self, field: &HeightField, factors: &PairFactors, wavelengths_nm: &[f64]) -> Vec<f64> {
        let [u, v, w] = factors.q;
        let reach = |nm: f64| (-(TAU * self.coherence.sigma_nm_at(nm) * u.hypot(v) / nm).powi(2)).exp() > LOBE_LEAST;
        let [x, y] = &self.axes;
        let of = |nm: &f64| {
            if !reach(*nm) {
                return 0.0;
            }
            let (mut sum, mut norm) = (Complex::default(), 0.0);
            for (row, gy) in field.heights_nm.outer_iter().skip(y.first).zip(&y.amplitude) {
                for (h, gx) in row.iter().skip(x.first).zip(&x.amplitude) {
                    sum += Complex::from_polar(gx * gy, TAU * w / nm * h);
                    norm += gx * gy;
                }
            }
            (sum / norm).norm_sqr()
        };
        wavelengths_nm.iter().map(of).collect()
    }

    /// `|G̃|² / A` in nm² at a frequency in 1/nm.
    fn power_nm2(&self, frequency: [f64; 2], wavelength_nm: f64) -> f64 {
        match self.gaussian_nm {
            Some(_) => self.closed_form_nm2(frequency[0].hypot(frequency[1]), wavelength_nm),
            None => (0..2).map(|axis| self.axes[axis].transforms([frequency[axis]])[0].powi(2)).product(),
        }
    }

    /// `(∬ g)²/A exp(-(2πσκ)²)` in nm² at a distance `κ` from the mirror direction in 1/nm.
    fn closed_form_nm2(&self, distance_per_nm: f64, wavelength_nm: f64) -> f64 {
        let peak: f64 = self.axes.iter().map(|axis| axis.integral_nm.powi(2) / axis.norm_nm).product();
        let sigma_nm = self.coherence.sigma_nm_at(wavelength_nm);
        peak * (sigma_nm / self.sigma_nm).powi(2) * (-(TAU * sigma_nm * distance_per_nm).powi(2)).exp()
    }
}

/// Where the lobe's power is `exp(-5.5²)` of its peak, as a multiple of `λ/2πσ`.
const LOBE_REACH: f64 = 5.5;

/// Share of its peak at which the lobe ends: the kernels of the transforms end at `exp(-5.5²)` of it.
const LOBE_LEAST: f64 = 7e-14;

/// Rows handled together: their phasors stay in cache while all wavelengths pass.
const ROW_BLOCK: usize = 4;

/// `ΣΣ W_x W_y exp(i k w h)` for every pair of lines at every wavelength; `[wavelength][y line · x line]`.
fn phasor_sums(
    field: &HeightField,
    axes: &[WindowAxis; 2],
    weights: &[Vec<AxisLines>; 2],
    w: f64,
    wavelengths_nm: &[f64],
) -> Vec<Vec<Complex<f64>>> {
    let [x, y] = axes;
    let columns = x.position_nm.len();
    let mut sums: Vec<Vec<Complex<f64>>> = weights[0]
        .iter()
        .zip(&weights[1])
        .map(|(x, y)| vec![Complex::default(); x.power.len() * y.power.len()])
        .collect();
    let steps = wavelengths_nm.len().saturating_sub(1).max(1) as f64;
    let first = 1.0 / wavelengths_nm[0];
    let step = (1.0 / wavelengths_nm[wavelengths_nm.len() - 1] - first) / steps;
    let uniform =
        wavelengths_nm.iter().enumerate().all(|(i, nm)| (1.0 / nm - first - i as f64 * step).abs() < 1e-9 * first);
    for block in (0..y.position_nm.len()).step_by(ROW_BLOCK) {
        let rows: Vec<usize> = (block..(block + ROW_BLOCK).min(y.position_nm.len())).collect();
        let heights: Vec<f64> = rows
            .iter()
            .flat_map(|row| (0..columns).map(move |column| field.heights_nm[[y.first + row, x.first + column]]))
            .collect();
        let mut phasors = Phasors::new(&heights, TAU * w * first, TAU * w * step);
        for (index, sums) in sums.iter_mut().enumerate() {
            if index > 0 && uniform {
                phasors.advance();
            } else if index > 0 {
                phasors = Phasors::new(&heights, TAU * w / wavelengths_nm[index], 0.0);
            }
            let (wx, wy) = (&weights[0][index], &weights[1][index]);
            for (local, &row) in rows.iter().enumerate() {
                for lx in 0..wx.power.len() {
                    let sum = phasors.dot(local * columns, &wx.lines[lx].re, &wx.lines[lx].im);
                    for (ly, line) in wy.lines.iter().enumerate() {
                        sums[ly * wx.power.len() + lx] += sum * Complex::new(line.re[row], line.im[row]);
                    }
                }
            }
        }
    }
    sums
}

/// `exp(i phase h)` of a run of heights, and the factor that advances each by one step of phase.
struct Phasors {
    re: Vec<f64>,
    im: Vec<f64>,
    step_re: Vec<f64>,
    step_im: Vec<f64>,
}

impl Phasors {
    fn new(heights_nm: &[f64], phase: f64, phase_step: f64) -> Self {
        let (im, re) = heights_nm.iter().map(|h| (phase * h).sin_cos()).unzip();
        let (step_im, step_re) = heights_nm.iter().map(|h| (phase_step * h).sin_cos()).unzip();
        Self { re, im, step_re, step_im }
    }

    /// One complex product per sample; after a thousand the rounding is about 1e-13.
    fn advance(&mut self) {
        let steps = self.step_re.iter().zip(&self.step_im);
        for ((re, im), (step_re, step_im)) in self.re.iter_mut().zip(&mut self.im).zip(steps) {
            (*re, *im) = (*re * step_re - *im * step_im, *re * step_im + *im * step_re);
        }
    }

    /// `Σ (wr + i wi) p` over the samples from `start`; four partial sums let the loop use vectors.
    fn dot(&self, start: usize, wr: &[f64], wi: &[f64]) -> Complex<f64> {
        let (re, im) = (&self.re[start..start + wr.len()], &self.im[start..start + wr.len()]);
        let (mut sum_re, mut sum_im) = ([0.0; 4], [0.0; 4]);
        let quads = wr.len() / 4 * 4;
        for i in (0..quads).step_by(4) {
            let (re, im, wr, wi) = (&re[i..i + 4], &im[i..i + 4], &wr[i..i + 4], &wi[i..i + 4]);
            for lane in 0..4 {
                sum_re[lane] += wr[lane] * re[lane] - wi[lane] * im[lane];
                sum_im[lane] += wr[lane] * im[lane] + wi[lane] * re[lane];
            }
        }
        let mut sum = Complex::new(sum_re.iter().sum(), sum_im.iter().sum());
        for i in quads..wr.len() {
            sum += Complex::new(wr[i], wi[i]) * Complex::new(re[i], im[i]);
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::config::{Edge, Windows};

    use diffraction_brdf::spectrum::{SpectralQuadrature, uniform_wavelengths};
    use std::f64::consts::SQRT_2;

    /// Relative errors of the luminance of one line, wherever in the spectrum it shows, ascending; places darker than a
    /// hundredth of the brightest are left out.
    fn errors(optics: &OpticsConfig, radius: f64, count: usize) -> Vec<f64> {
        let [low_nm, high_nm] = optics.wavelength_nm;
        let deviation = 1.0 / (TAU * SQRT_2 * radius * optics.sigma_nm);
        let exact = uniform_wavelengths(&optics.illuminant, optics.wavelength_nm, 0.005).unwrap();
        let coarse = uniform_wavenumbers(&optics.illuminant, optics.wavelength_nm, count).unwrap();
        let luminance = |quadrature: &SpectralQuadrature, centre: f64| -> f64 {
            let pulse = |nm: f64| {
                let z = (1.0 / nm - centre) / deviation;
                // Beyond, it is 2e-11.
                if z.abs() < 7.0 { (-0.5 * z * z).exp() } else { 0.0 }
            };
            quadrature.wavelengths_nm.iter().zip(&quadrature.weights).map(|(&nm, weight)| weight[1] * pulse(nm)).sum()
        };
        let centres = (0..200).map(|i| 1.0 / (low_nm + (f64::from(i) + 0.5) / 200.0 * (high_nm - low_nm)));
        let pairs: Vec<[f64; 2]> = centres.map(|c| [&exact, &coarse].map(|q| luminance(q, c))).collect();
        let brightest = pairs.iter().map(|pair| pair[0]).fold(0.0, f64::max);
        let bright = pairs.into_iter().filter(|pair| pair[0] > 1e-2 * brightest);
        let mut errors: Vec<f64> = bright.map(|[exact, coarse]| (coarse / exact - 1.0).abs()).collect();
        errors.sort_by(f64::total_cmp);
        errors
    }

    #[test]
    fn one_line_errs_by_no_more_than_the_steps_say() {
        for illuminant in [Illuminant::D65, Illuminant::F(11)] {
            let optics = OpticsConfig::ideal(illuminant, 8_000.0, Edge::Tile, Windows::Grid);
            // The kinks of a lamp are sharper than daylight's.
            let in_pictures = if optics.illuminant == Illuminant::D65 { 1e-4 } else { 4e-4 };
            for (step, most) in [(FULL_STEP, 2e-6), (PICTURE_STEP, in_pictures)] {
                for radius in [0.1, 0.4, 0.8, 1.2, 1.9] {
                    let count = resolving_count(&optics, [radius, 0.0, -0.5], 0.0, step);
                    let [found, with_fewer] = [count, count / 2].map(|count| {
                        let errors = errors(&optics, radius, count);
                        errors[errors.len() * 95 / 100]
                    });
                    assert!(found < most, "{:?} {step:?} {radius}: {count}: {found:e}", optics.illuminant);
                    // Where the window decides.
                    let is_fewest = radius < 1.9 || optics.illuminant == Illuminant::F(11);
                    assert!(
                        is_fewest || with_fewer > 2.0 * most,
                        "{step:?} {radius}: {with_fewer:e} with half as many"
                    );
                }
            }
        }
    }

    #[test]
    fn what_the_direct_sum_of_a_large_scan_holds_is_told() {
        let optics = OpticsConfig::ideal(Illuminant::D65, 4_000.0, Edge::Tile, Windows::Grid);
        let bytes = |side: usize| {
            let flat = HeightField { heights_nm: ndarray::Array2::zeros((side, side)), pitch_nm: [60.0; 2] };
            held_bytes(&[flat], &optics, &[([0.0, 0.0, 1.0], [0.6, 0.0, 0.8])]).unwrap()
        };
        // Samples and lines both grow with the side, and so do the lines along the other axis, of which each two have a sum.
        assert!((bytes(1024) / bytes(256)).abs_diff(16) < 4, "{} {}", bytes(1024), bytes(256));
        // By hand: over 61 µm some 30 lines at a wavelength, 80 at all of them, of 1024 complex numbers each along x and 30 along y; and 30² sums at
        // some 60 wavelengths. Eight times the side has eight times the lines, of eight times the samples.
        let by_hand = |times: usize| (16 * times * times * (1024 * (80 + 30) + 30 * 30 * 60)) as f64;
        for (side, times) in [(1024, 1), (8192, 8)] {
            assert!((bytes(side) as f64 / by_hand(times) - 1.0).abs() < 0.1, "{} for {}", bytes(side), by_hand(times));
        }
    }
}
