//! Stam's closed form for a Gaussian random surface: a coherent lobe and a diffuse series.

use std::f64::consts::{PI, TAU};

use diffraction_brdf::direction::Vec3;

/// A surface of normally distributed heights with the autocorrelation `exp(-r²/T²)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RoughSurface {
    /// Root mean square height in nm.
    pub rms_nm: f64,
    /// Correlation length `T` in nm.
    pub correlation_nm: f64,
}

impl RoughSurface {
    /// `⟨|P|²⟩ / A` in nm². With `g = (k w h_rms)²` the mean of the phasors of two points is
    /// `exp(-g (1 - C)) = exp(-g) Σ g^m C^m / m!`; each `C^m` times the window's own correlation
    /// `exp(-r²/4σ²)` is a Gaussian, and so is its transform. `m = 0` is the coherent lobe.
    pub fn power_nm2(&self, sigma_nm: f64, q: Vec3, wavelength_nm: f64) -> f64 {
        let g = (TAU / wavelength_nm * q[2] * self.rms_nm).powi(2);
        let xi2 = (q[0] * q[0] + q[1] * q[1]) / (wavelength_nm * wavelength_nm);
        let term = |m: usize| {
            let a2 = 1.0 / (m as f64 / self.correlation_nm.powi(2) + 0.25 / sigma_nm.powi(2));
            let poisson = if m == 0 { -g } else { m as f64 * g.ln() - g - libm::lgamma(m as f64 + 1.0) };
            (poisson - PI * PI * a2 * xi2).exp() * PI * a2
        };
        // The Poisson weights outside ten standard deviations are below rounding. Where the frequency is high the
        // terms grow with m at first, so the lower end is cut by the weights alone.
        let reach = 10.0 * g.sqrt() + 30.0;
        let first = (g - reach).max(0.0) as usize;
        let last = if g > 0.0 { (g + reach) as usize } else { 0 };
        (first..=last).map(term).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SURFACE: RoughSurface = RoughSurface { rms_nm: 90.0, correlation_nm: 700.0 };

    #[test]
    fn series_equals_the_integral_over_the_correlation() {
        // ∫ exp(-g (1 - C(r))) exp(-r²/4σ²) J0(2π ξ r) 2π r dr by the midpoint rule.
        let (sigma, nm) = (3_000.0, 500.0);
        for (u, w) in [(0.0, 1.2), (0.2, 1.9), (0.9, 0.7)] {
            let g: f64 = (TAU / nm * w * SURFACE.rms_nm).powi(2);
            let step: f64 = 2.0;
            let integral: f64 = (0..12_000)
                .map(|i| {
                    let r = (f64::from(i) + 0.5) * step;
                    let c = (-(r / SURFACE.correlation_nm).powi(2)).exp();
                    (-g * (1.0 - c) - 0.25 * (r / sigma).powi(2)).exp() * libm::j0(TAU * u / nm * r) * TAU * r * step
                })
                .sum();
            let series = SURFACE.power_nm2(sigma, [u, 0.0, w], nm);
            // The midpoint rule errs by (step²/24) f'' ~ 1e-6 of the whole, 4πσ² at most.
            assert!(
                (series - integral).abs() < 1e-4 * integral + 1e-6 * 4.0 * PI * sigma * sigma,
                "{series} {integral}"
            );
            let rougher = RoughSurface { rms_nm: 91.0, ..SURFACE };
            assert!((rougher.power_nm2(sigma, [u, 0.0, w], nm) / series - 1.0).abs() > 1e-3);
        }
    }

    #[test]
    fn a_flat_surface_is_the_mirror_lobe_and_deep_ones_stay_finite() {
        let flat = RoughSurface { rms_nm: 0.0, correlation_nm: 500.0 };
        let peak = flat.power_nm2(4_000.0, [0.0, 0.0, 2.0], 500.0);
        assert!((peak / (4.0 * PI * 4_000.0f64.powi(2)) - 1.0).abs() < 1e-12);
        let deep = RoughSurface { rms_nm: 5_000.0, correlation_nm: 5_000.0 };
        // Far above the wavelength the series is the slopes' normal distribution: π T²/g exp(-π²T²ξ²/g).
        let (g, xi) = ((TAU / 500.0 * 2.0 * 5_000.0f64).powi(2), 0.4 / 500.0);
        let slopes = PI * 5_000.0f64.powi(2) / g * (-(PI * 5_000.0 * xi).powi(2) / g).exp();
        let found = deep.power_nm2(50_000.0, [0.4, 0.0, 2.0], 500.0);
        assert!((found / slopes - 1.0).abs() < 1e-3, "{found} {slopes}");
    }
}
