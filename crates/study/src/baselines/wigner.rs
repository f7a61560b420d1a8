//! Wigner distribution of a phase screen along the plane of incidence: whole and projected (WBSDF, Cuypers et al. 2012), or
//! at some positions and angles (augmented light field, Oh et al. 2010).
//!
//! From the papers: the surface is a thin phase screen `p(x)`; its Wigner distribution `W(x, ξ) = ∫ p(x + l/2) p*(x - l/2)
//! exp(2πi ξ l) dl` is what leaves the place `x` with the frequency `ξ`, negative where light interferes; far away the sum
//! over all places is seen. The light field keeps it at positions and angles of a grid and sums rays.
//!
//! Chosen here: the screen is the line of heights through the middle of the scan in the plane of incidence, or in the
//! viewer's plane where light comes along the normal; across that plane the surface is taken as even, so that only the
//! window's own lobe is left there. The phase is `k w h` with the `w` of both directions (the papers' is that of small
//! angles), and the window is the Gaussian of everything else. Of the WBSDF's projection the marginal `∫ W dx = |∫ p
//! exp(2πi ξ x) dx|²` is evaluated, the distribution itself only for light fields.

use std::f64::consts::{PI, TAU};

use rustfft::num_complex::Complex;

use super::screen::{height_at, phasor_sums};
use diffraction_brdf::direction::Vec3;
use diffraction_build::height::HeightField;
use diffraction_build::optics::window::SUPPORT_SIGMAS;

/// Sine of the angle of incidence up to which light comes along the normal.
const NORMAL_SIN: f64 = 1e-9;

/// Unit vector of the plane of incidence in the surface; the viewer's plane where light comes along the normal.
pub(crate) fn plane_of_incidence(wi: Vec3, wo: Vec3) -> [f64; 2] {
    let along = |[x, y, _]: Vec3| {
        let length = x.hypot(y);
        (length > NORMAL_SIN).then(|| [x / length, y / length])
    };
    along(wi).or_else(|| along(wo)).unwrap_or([1.0, 0.0])
}

/// A line of heights under the coherence window.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PhaseScreen {
    /// Heights in nm at half steps from one end to the other, an odd number.
    heights_nm: Vec<f64>,
    /// Amplitude of the window at each.
    window: Vec<f64>,
    /// A whole step in nm, the scan's finer pitch.
    step_nm: f64,
    sigma_nm: f64,
    /// Unit vector of the line.
    along: [f64; 2],
}

impl PhaseScreen {
    /// The line through the middle of a scan, as far as the window or the scan reaches.
    pub fn along(field: &HeightField, along: [f64; 2], sigma_nm: f64) -> Self {
        let sampled = field.size().into_iter().zip(field.pitch_nm).filter(|(count, _)| *count > 1);
        let step_nm = sampled.map(|(_, pitch)| pitch).fold(SUPPORT_SIGMAS * sigma_nm, f64::min);
        let place = |index: i64| 0.5 * step_nm * index as f64;
        let height = |index: i64| height_at(field, along.map(|e| e * place(index)));
        let reach = |index: &i64| {
            place(*index) <= SUPPORT_SIGMAS * sigma_nm && height(*index).is_some() && height(-index).is_some()
        };
        let last = (1..).take_while(reach).last().unwrap_or(0);
        let indices = -last..=last;
        Self {
            heights_nm: indices.clone().filter_map(height).collect(),
            window: indices.map(|index| (-0.5 * (place(index) / sigma_nm).powi(2)).exp()).collect(),
            step_nm,
            sigma_nm,
            along,
        }
    }

    /// Places at half steps.
    pub fn places(&self) -> usize {
        self.heights_nm.len()
    }

    fn place_nm(&self, index: usize) -> f64 {
        0.5 * self.step_nm * (index as f64 - (self.places() / 2) as f64)
    }

    /// `∫ g²` along the line, in nm.
    fn norm_nm(&self) -> f64 {
        PI.sqrt() * self.sigma_nm
    }

    /// `q` along the line and across it.
    fn in_plane(&self, q: Vec3) -> [f64; 2] {
        let [x, y] = self.along;
        [q[0] * x + q[1] * y, q[1] * x - q[0] * y]
    }

    /// The window's power across the line over its norm, in nm: the surface is even there.
    fn across_nm(&self, across: f64, wavelength_nm: f64) -> f64 {
        2.0 * self.norm_nm() * (-(TAU * self.sigma_nm * across / wavelength_nm).powi(2)).exp()
    }

    /// Whether the samples answer for a component of `q` along the line.
    fn resolves(&self, along: f64, wavelength_nm: f64) -> bool {
        along.abs() / wavelength_nm * self.step_nm <= 0.5
    }

    /// `|P|² / A` in nm² at each wavelength, which lie at equal steps of wavenumber: the Wigner distribution projected
    /// along all places.
    pub(crate) fn projected_nm2(&self, q: Vec3, wavelengths_nm: &[f64]) -> Vec<f64> {
        let [u, v] = self.in_plane(q);
        // Both ends of a lag move by half steps: ends that are an odd number of them apart never meet.
        let sums = [0, 1].map(|first| {
            let indices = || (first..self.places()).step_by(2);
            let lengths: Vec<f64> = indices().map(|i| u * self.place_nm(i) + q[2] * self.heights_nm[i]).collect();
            let amplitudes: Vec<f64> = indices().map(|i| self.step_nm * self.window[i]).collect();
            phasor_sums(&lengths, &amplitudes, wavelengths_nm)
        });
        let power = |(index, &nm): (usize, &f64)| match self.resolves(u, nm) {
            true => {
                let marginal = sums.each_ref().map(|sums| sums[index].norm_sqr());
                0.5 * (marginal[0] + marginal[1]) / self.norm_nm() * self.across_nm(v, nm)
            }
            false => 0.0,
        };
        wavelengths_nm.iter().enumerate().map(power).collect()
    }

    /// The screen's phasors under the window at one phase `s = k w` in 1/nm.
    fn phasors(&self, s_per_nm: f64) -> Vec<Complex<f64>> {
        self.heights_nm.iter().zip(&self.window).map(|(h, g)| Complex::from_polar(*g, s_per_nm * h)).collect()
    }
}

/// `W(x, ξ)` in nm at one place of a screen's phasors and at some frequencies in 1/nm: a sum over the lags `l` that reach
/// neither end, at whole steps, since both ends of a lag move by half of it.
fn distribution<const N: usize>(
    phasors: &[Complex<f64>],
    index: usize,
    step_nm: f64,
    frequencies: [f64; N],
) -> [f64; N] {
    let lags = index.min(phasors.len() - 1 - index);
    let turns = frequencies.map(|xi| Complex::cis(TAU * xi * step_nm));
    let mut turned = [Complex::new(1.0, 0.0); N];
    let mut sums = [0.5 * phasors[index].norm_sqr(); N];
    for lag in 1..=lags {
        let product = phasors[index + lag] * phasors[index - lag].conj();
        for ((sum, turned), turn) in sums.iter_mut().zip(&mut turned).zip(&turns) {
            *turned *= turn;
            *sum += product.re * turned.re - product.im * turned.im;
        }
    }
    // The lags of the other sign are the conjugates.
    sums.map(|sum| 2.0 * step_nm * sum)
}

/// How finely a light field is kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct LightField {
    /// Positions along the screen.
    pub positions: usize,
    /// Angles: sines of the viewer's angle in the plane of incidence at equal steps over [-1, 1].
    pub angles: usize,
}

impl LightField {
    /// `|P|² / A` in nm² at each wavelength: rays of the kept positions, linear between the two nearest angles. May be
    /// negative, as interference of rays that are missing.
    pub fn power_nm2(self, screen: &PhaseScreen, [wi, wo]: [Vec3; 2], wavelengths_nm: &[f64]) -> Vec<f64> {
        let q: Vec3 = std::array::from_fn(|axis| -wi[axis] - wo[axis]);
        let along = |d: Vec3| d[0] * screen.along[0] + d[1] * screen.along[1];
        let [_, across] = screen.in_plane(q);
        // Middles of the bins, of which the outermost stand for what lies beyond them.
        let bin = ((along(wo) + 1.0) * 0.5 * self.angles as f64 - 0.5).clamp(0.0, (self.angles - 1) as f64);
        let (low, share) = (bin.floor(), bin.fract());
        let sines =
            [low, (low + 1.0).min((self.angles - 1) as f64)].map(|bin| (bin + 0.5) * 2.0 / self.angles as f64 - 1.0);
        let each_nm = 0.5 * screen.step_nm * screen.places() as f64 / self.positions as f64;
        let power = |&nm: &f64| {
            let phasors = screen.phasors(TAU / nm * q[2]);
            let frequencies = sines.map(|sine| -(along(wi) + sine) / nm);
            let ray = |position: usize| {
                let index = (2 * position + 1) * screen.places() / (2 * self.positions);
                let [low, high] = distribution(&phasors, index, screen.step_nm, frequencies);
                low + share * (high - low)
            };
            let sum: f64 = (0..self.positions).map(ray).sum();
            match screen.resolves(-along(wi) - along(wo), nm) {
                true => sum * each_nm / screen.norm_nm() * screen.across_nm(across, nm),
                false => 0.0,
            }
        };
        wavelengths_nm.iter().map(power).collect()
    }

    /// Bytes of its rays in floats, for one wavelength and one direction of light.
    pub fn bytes(self) -> usize {
        self.positions * self.angles * size_of::<f32>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::baselines::tests::{sinusoid, uneven};

    use diffraction_brdf::spectrum::{Illuminant, Line};
    use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
    use diffraction_build::optics::reference;

    const SIGMA_NM: f64 = 2_000.0;
    const NM: f64 = 532.0;

    fn flat() -> HeightField {
        HeightField { heights_nm: ndarray::Array2::zeros((1, 401)), pitch_nm: [50.0, 20_000.0] }
    }

    #[test]
    fn the_distribution_of_a_window_is_its_closed_form() {
        // W = 2 √π σ exp(-x²/σ²) exp(-4π²σ²ξ²) for p = exp(-x²/2σ²).
        let screen = PhaseScreen::along(&flat(), [1.0, 0.0], SIGMA_NM);
        let phasors = screen.phasors(0.0);
        let middle = screen.places() / 2;
        for (offset, xi) in [(0, 0.0), (40, 0.0), (0, 1.0 / 15_000.0), (25, 1.0 / 20_000.0)] {
            let x = 25.0 * offset as f64;
            let exact = 2.0 * PI.sqrt() * SIGMA_NM * (-(x / SIGMA_NM).powi(2) - (TAU * SIGMA_NM * xi).powi(2)).exp();
            let [found] = distribution(&phasors, middle + offset, 50.0, [xi]);
            // The window is cut at 5.5 σ, 3e-7 of its peak.
            assert!((found / exact - 1.0).abs() < 1e-4, "{x} {xi}: {found} {exact}");
        }
    }

    #[test]
    fn a_tilted_plane_moves_the_distribution_to_its_own_frequency() {
        // h = x/10: exp(i s x/10) is at ξ = -s / (20π).
        let heights_nm = ndarray::Array2::from_shape_fn((1, 401), |(_, x)| 5.0 * (x as f64 - 200.0));
        let field = HeightField { heights_nm, pitch_nm: [50.0, 20_000.0] };
        let screen = PhaseScreen::along(&field, [1.0, 0.0], SIGMA_NM);
        let s = -TAU / NM * 1.8;
        let own = -s / (20.0 * PI);
        let [there, opposite] = distribution(&screen.phasors(s), screen.places() / 2, screen.step_nm, [own, -own]);
        let peak = 2.0 * PI.sqrt() * SIGMA_NM;
        assert!((there / peak - 1.0).abs() < 1e-4 && opposite.abs() < 1e-3 * peak, "{there} {opposite}");
    }

    #[test]
    fn orders_of_a_sinusoid_carry_squared_bessel_functions() {
        let screen = PhaseScreen::along(&sinusoid(60.0), [1.0, 0.0], SIGMA_NM);
        let w = -1.7;
        for m in -2i32..=2 {
            let exact = 4.0 * PI * SIGMA_NM * SIGMA_NM * libm::jn(m.abs(), TAU / NM * w * 60.0).powi(2);
            let found = |pitch: f64| screen.projected_nm2([f64::from(m) * NM / pitch, 0.0, w], &[NM])[0];
            // Midpoints of steps of d/80 lack cos(π/80) of the amplitude, of which order 2 carries the fourth power.
            assert!((found(1_600.0) / exact - 1.0).abs() < 5e-3, "{m}: {} {exact}", found(1_600.0));
            assert!(m == 0 || (found(1_700.0) / exact - 1.0).abs() > 1e-2, "elsewhere there is less");
        }
    }

    #[test]
    fn in_the_plane_of_a_grating_the_projection_is_the_direct_sum() {
        let field = uneven();
        let optics = OpticsConfig::ideal(
            Illuminant::Lines(vec![Line { wavelength_nm: NM, power: 1.0 }]),
            SIGMA_NM,
            Edge::Fade,
            Windows::Centre,
        );
        let screen = PhaseScreen::along(&field, [1.0, 0.0], SIGMA_NM);
        // Near the orders -2, -1 and 1.
        for sine in [0.57, 0.235, -0.43] {
            let (wi, wo) = ([0.1, 0.0, 0.99f64.sqrt()], [sine, 0.003, (1.0 - sine * sine - 9e-6f64).sqrt()]);
            assert_eq!(plane_of_incidence(wi, wo), [1.0, 0.0]);
            let exact = reference::brdf_spectrum(std::slice::from_ref(&field), &optics, wi, wo, &[NM]).unwrap()[0];
            let q: Vec3 = std::array::from_fn(|axis| -wi[axis] - wo[axis]);
            let brdf = |q: Vec3| {
                optics.front_factor().diffuse(wi, wo) * screen.projected_nm2(q, &[NM])[0] / (NM * q[2]).powi(2)
            };
            let [found, mirrored] = [brdf(q), brdf([-q[0], q[1], q[2]])].map(|f| (f / exact - 1.0).abs());
            // The scan ends at 4 σ, where the window's amplitude is 3e-4.
            assert!(found < 5e-3 && mirrored > 0.1, "{sine}: {found:e} {mirrored:e}");
        }
    }

    #[test]
    fn all_rays_of_a_light_field_are_the_projection_and_few_are_not() {
        let screen = PhaseScreen::along(&uneven(), [1.0, 0.0], SIGMA_NM);
        let (wi, wo) = ([0.1, 0.0, 0.99f64.sqrt()], [0.232, 0.0, (1.0 - 0.232f64 * 0.232).sqrt()]);
        let q: Vec3 = std::array::from_fn(|axis| -wi[axis] - wo[axis]);
        let exact = screen.projected_nm2(q, &[NM])[0];
        let off = |positions: usize, angles: usize| {
            let found = LightField { positions, angles }.power_nm2(&screen, [wi, wo], &[NM])[0];
            (found / exact - 1.0).abs()
        };
        let (all, many) = (screen.places(), 20_001);
        let [whole, few_places, few_angles] = [off(all, many), off(16, many), off(all, 25)];
        println!("{whole:e} {few_places:e} {few_angles:e}");
        // Linear between angles 1e-4 apart: (2πσ 1e-4 / λ)² / 8 of the lobe's peak.
        assert!(whole < 1e-5, "{whole:e}");
        // Orders interfere with their distance's period, 1600 nm and its parts, which places 1250 nm apart cannot follow.
        assert!(few_places > 0.05 && few_angles > 0.05, "{few_places:e} {few_angles:e}");
    }
}
