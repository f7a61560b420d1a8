//! Optical paths over the coherence area (Ziegler et al. 2008): a sum of phasors, one for each sampled path.
//!
//! From the paper: light from one coherent area adds by amplitudes, each path with the phase of its optical length, and
//! the intensity is the square of the sum. Chosen here: paths differ by `q · (x, y, h)`, the places are spread evenly
//! under the coherence window, heights are linear between samples, and of intensities nothing is subtracted: `N` paths of
//! unrelated phases leave `1/N` of the mirror's light in every direction.

use std::f64::consts::{PI, TAU};

use super::screen::{height_at, phasor_sums};
use diffraction_brdf::direction::Vec3;
use diffraction_build::ground::sampling::plane;
use diffraction_build::height::HeightField;

/// Sampled paths of one scan.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct OpticalPaths {
    /// Where each path meets the surface, in nm from the scan's middle.
    places_nm: Vec<Vec3>,
    sigma_nm: f64,
}

impl OpticalPaths {
    /// `count` places of normal distribution, that of the window's amplitude; those beyond the scan are left out.
    pub fn sampled(field: &HeightField, sigma_nm: f64, count: usize) -> Self {
        let place = |index: usize| {
            let [a, b] = plane(index);
            let radius = sigma_nm * (-2.0 * (1.0 - a).ln()).sqrt();
            let (sin, cos) = (TAU * b).sin_cos();
            let [x, y] = [radius * cos, radius * sin];
            Some([x, y, height_at(field, [x, y])?])
        };
        Self { places_nm: (0..count).filter_map(place).collect(), sigma_nm }
    }

    /// `|P|² / A` in nm² at each wavelength, which lie at equal steps of wavenumber: `∬ g = 2πσ²` times the mean phasor,
    /// squared, over `A = πσ²`.
    pub fn power_nm2(&self, q: Vec3, wavelengths_nm: &[f64]) -> Vec<f64> {
        let length = |place: &Vec3| (0..3).map(|axis| q[axis] * place[axis]).sum::<f64>();
        let lengths: Vec<f64> = self.places_nm.iter().map(length).collect();
        let share = 1.0 / lengths.len().max(1) as f64;
        let sums = phasor_sums(&lengths, &vec![share; lengths.len()], wavelengths_nm);
        sums.iter().map(|mean| 4.0 * PI * self.sigma_nm * self.sigma_nm * mean.norm_sqr()).collect()
    }

    /// Bytes of places and heights.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.places_nm[..])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::baselines::tests::{sinusoid, uneven};

    use diffraction_brdf::spectrum::{Illuminant, Line};
    use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
    use diffraction_build::optics::reference;

    /// Largest deviation from `4πσ² J_m²(k w a)` over the orders -2 to 2, as a share of the mirror's light.
    fn off_bessel(amplitude_nm: f64, count: usize) -> f64 {
        let (sigma_nm, nm, w) = (2_000.0, 500.0, -1.7);
        let paths = OpticalPaths::sampled(&sinusoid(60.0), sigma_nm, count);
        let off = |m: i32| {
            let exact = libm::jn(m.abs(), TAU / nm * w * amplitude_nm).powi(2);
            let found = paths.power_nm2([f64::from(m) * nm / 1_600.0, 0.0, w], &[nm])[0];
            (found / (4.0 * PI * sigma_nm * sigma_nm) - exact).abs()
        };
        (-2..=2).map(off).fold(0.0, f64::max)
    }

    #[test]
    fn orders_of_a_sinusoid_are_met_the_better_the_more_paths_there_are() {
        let [few, some, many] = [64, 1_024, 65_536].map(|count| off_bessel(60.0, count));
        println!("{few:e} {some:e} {many:e}");
        assert!(few > 3.0 * some && some > 3.0 * many && many < 1e-3, "{few:e} {some:e} {many:e}");
        assert!(off_bessel(62.0, 65_536) > 1e-2, "another depth shows");
    }

    #[test]
    fn an_uneven_profile_is_met_by_the_direct_sum_and_its_mirror_image_is_not() {
        let field = uneven();
        let optics = OpticsConfig::ideal(
            Illuminant::Lines(vec![Line { wavelength_nm: 532.0, power: 1.0 }]),
            2_000.0,
            Edge::Fade,
            Windows::Centre,
        );
        let paths = OpticalPaths::sampled(&field, optics.sigma_nm, 1 << 17);
        let (wi, wo) = ([-0.1, 0.0, 0.99f64.sqrt()], [-0.1995, 0.0, (1.0 - 0.1995f64.powi(2)).sqrt()]);
        let q: Vec3 = std::array::from_fn(|axis| -wi[axis] - wo[axis]);
        let exact = reference::brdf_spectrum(&[field], &optics, wi, wo, &[532.0]).unwrap()[0];
        let brdf =
            |q: Vec3| optics.front_factor().diffuse(wi, wo) * paths.power_nm2(q, &[532.0])[0] / (532.0 * q[2]).powi(2);
        let [found, mirrored] = [brdf(q), brdf([-q[0], q[1], q[2]])].map(|f| (f / exact - 1.0).abs());
        println!("{found:e} {mirrored:e}");
        assert!(found < 1e-2 && mirrored > 0.2, "{found:e} {mirrored:e}");
    }
}
