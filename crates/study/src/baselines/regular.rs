//! Closed form of a regular surface: the sum of one or two sinusoids, after Stam's gratings and bumps.

use std::f64::consts::{PI, TAU};

use super::statistics::SurfaceStatistics;
use diffraction_brdf::direction::Vec3;

/// Half width of an order's lobe in its standard deviations; it is 5e-9 of its peak there.
const REACH: f64 = 6.2;

/// One wave of the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wave {
    /// Frequency along x and y in 1/nm.
    pub frequency: [f64; 2],
    /// Half the peak-to-valley height in nm.
    pub amplitude_nm: f64,
}

/// A sum of at most two waves.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RegularSurface {
    /// The waves; none is a mirror.
    pub waves: Vec<Wave>,
}

impl RegularSurface {
    /// The strongest waves of a surface, with the amplitudes that give its rms height.
    pub fn fitted(statistics: &SurfaceStatistics) -> Self {
        let wave = |&(frequency, share): &([f64; 2], f64)| Wave {
            frequency,
            amplitude_nm: statistics.rms_nm * (2.0 * share).sqrt(),
        };
        Self { waves: statistics.waves.iter().map(wave).collect() }
    }

    /// `⟨|P|²⟩ / A` in nm²: order (m, n) carries `J_m²(k w a) J_n²(k w b)` in the window's lobe around
    /// `m ξ_a + n ξ_b` (Jacobi-Anger; relative phases average out over window positions).
    pub fn power_nm2(&self, sigma_nm: f64, q: Vec3, wavelength_nm: f64) -> f64 {
        let k = TAU / wavelength_nm;
        let at = [q[0] / wavelength_nm, q[1] / wavelength_nm];
        let reach = REACH / (TAU * sigma_nm * std::f64::consts::SQRT_2);
        let (mut first, mut second) =
            (Orders::new(self.waves.first(), k * q[2]), Orders::new(self.waves.get(1), k * q[2]));
        let mut sum = 0.0;
        for m in -first.last..=first.last {
            let from = [0, 1].map(|axis| at[axis] - f64::from(m) * first.frequency[axis]);
            for n in second.near(from, reach) {
                let d2: f64 = (0..2).map(|axis| (from[axis] - f64::from(n) * second.frequency[axis]).powi(2)).sum();
                if d2 < reach * reach {
                    sum += first.power(m) * second.power(n) * (-(TAU * sigma_nm).powi(2) * d2).exp();
                }
            }
        }
        4.0 * PI * sigma_nm * sigma_nm * sum
    }
}

/// The orders of one wave at one phase scale `k w`: `J_m²(z)` at multiples of its frequency.
struct Orders {
    frequency: [f64; 2],
    z: f64,
    last: i32,
    /// Powers by `|m|`, as far as they have been asked for.
    powers: Vec<Option<f64>>,
}

impl Orders {
    fn new(wave: Option<&Wave>, kw: f64) -> Self {
        let z = wave.map_or(0.0, |wave| (kw * wave.amplitude_nm).abs());
        // J_m falls faster than exponentially past m = z; without a wave there is the order 0 alone.
        let last = if wave.is_some() { (z + 6.0 * z.cbrt() + 6.0) as i32 } else { 0 };
        Self { frequency: wave.map_or([0.0; 2], |wave| wave.frequency), z, last, powers: vec![None; last as usize + 1] }
    }

    fn power(&mut self, m: i32) -> f64 {
        let z = self.z;
        *self.powers[m.unsigned_abs() as usize].get_or_insert_with(|| libm::jn(m.abs(), z).powi(2))
    }

    /// Orders whose frequency may lie within `reach` of a point.
    fn near(&self, at: [f64; 2], reach: f64) -> std::ops::RangeInclusive<i32> {
        let length2 = self.frequency[0].powi(2) + self.frequency[1].powi(2);
        if length2 == 0.0 {
            return 0..=0;
        }
        let middle = (at[0] * self.frequency[0] + at[1] * self.frequency[1]) / length2;
        let slack = reach / length2.sqrt();
        let last = f64::from(self.last);
        let [low, high] = [(middle - slack).ceil(), (middle + slack).floor()].map(|n| n.clamp(-last, last));
        low as i32..=high as i32
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::baselines::integrate;
    use crate::baselines::statistics::surface_statistics;
    use diffraction_brdf::direction::from_angles_deg;
    use diffraction_brdf::spectrum::{Illuminant, Line};
    use diffraction_build::height::HeightField;
    use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
    use diffraction_build::optics::reference;

    #[test]
    fn a_scan_of_one_sinusoid_is_met_by_the_direct_sum() {
        let heights_nm =
            ndarray::Array2::from_shape_fn((16, 128), |(_, x)| 60.0 * (TAU * 8.0 * x as f64 / 128.0).sin());
        let field = HeightField { heights_nm, pitch_nm: [100.0, 800.0] };
        let optics = OpticsConfig::ideal(
            Illuminant::Lines(vec![Line { wavelength_nm: 532.0, power: 1.0 }]),
            3_000.0,
            Edge::Tile,
            Windows::Grid,
        );
        let model = RegularSurface::fitted(&surface_statistics(std::slice::from_ref(&field)));
        let brdf = |surface: &RegularSurface, wi, wo| {
            let mut xyz = [[0.0; 3]];
            let power_nm2 = |q, nm| surface.power_nm2(optics.sigma_nm, q, nm);
            integrate(&optics, &[(wi, wo)], power_nm2, &mut xyz).unwrap();
            xyz[0][1]
        };
        for order in -2..=2 {
            let sin_o = f64::from(order) * 532.0 / 1_600.0 - 0.2;
            let wi = from_angles_deg(0.2f64.asin().to_degrees(), 0.0);
            let wo = [sin_o + 0.005, 0.0, (1.0 - (sin_o + 0.005).powi(2)).sqrt()];
            let exact = reference::brdf_xyz(std::slice::from_ref(&field), &optics, wi, wo).unwrap()[1];
            let found = brdf(&model, wi, wo);
            // Both are sums of the same orders; the kernels are cut at 3e-7.
            assert!((found / exact - 1.0).abs() < 1e-5, "order {order}: {found:e} {exact:e}");
            let wrong = RegularSurface { waves: vec![Wave { amplitude_nm: 61.0, ..model.waves[0] }] };
            assert!((brdf(&wrong, wi, wo) / exact - 1.0).abs() > 1e-4);
        }
    }
}
