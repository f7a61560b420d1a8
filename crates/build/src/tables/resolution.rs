//! What resolves a coherence lobe: widths, grids, samples, and numbers of nodes in `w`.

use std::f64::consts::{SQRT_2, TAU};

use crate::optics::config::OpticsConfig;
use diffraction_brdf::chebyshev::nodes_for_exponential;
use diffraction_brdf::direction::max_abs_w;

/// Standard deviation in (u, v) of a coherence lobe at a wavelength: `λ σ_f / √2`, `σ_f = 1/(2πσ)`.
pub fn lobe_width(sigma_nm: f64, wavelength_nm: f64) -> f64 {
    wavelength_nm / (TAU * sigma_nm * SQRT_2)
}

/// Standard deviation in (u, v) of what blurs a line where it is narrowest: at the shortest wavelength, whether the window
/// is the same everywhere or grows with the wavelength.
pub fn narrowest_blur(optics: &OpticsConfig) -> f64 {
    lobe_width(optics.least_sigma_nm(), optics.illuminant.reach_nm(optics.wavelength_nm)[0])
}

/// The same of the coherent lobe.
pub(super) fn narrowest_lobe(optics: &OpticsConfig) -> f64 {
    let low_nm = optics.illuminant.reach_nm(optics.wavelength_nm)[0];
    lobe_width(optics.lobe_coherence().sigma_nm_at(low_nm), low_nm)
}

/// Radius beyond which the coherent lobe is below 1e-9 of its peak at the longest wavelength.
pub fn lobe_radius(optics: &OpticsConfig) -> f64 {
    let high_nm = optics.illuminant.reach_nm(optics.wavelength_nm)[1];
    // exp(-r²/2) = 1e-9 at r = 6.44 standard deviations.
    (6.44 * lobe_width(optics.lobe_coherence().sigma_nm_at(high_nm), high_nm)).min(2.0)
}

/// Side of the table whose interpolation by cubics resolves the lobe of the shortest wavelength to the
/// tolerance: the local cubic errs by `3/128 (Δ/w)⁴` times a fourth derivative of at most 3.
pub fn resolving_size(optics: &OpticsConfig, tolerance: f64) -> usize {
    let texel = narrowest_blur(optics) * (tolerance * 128.0 / 9.0).powf(0.25);
    2 * (2.0 / texel).ceil().min(1e6) as usize + 1
}

/// Radius of the (u, v) disc for which the scan's sampling holds every frequency at every wavelength.
pub fn usable_radius(optics: &OpticsConfig, pitch_nm: [f64; 2]) -> f64 {
    let low_nm = optics.illuminant.reach_nm(optics.wavelength_nm)[0];
    (0.5 * low_nm / pitch_nm[0].max(pitch_nm[1])).min(2.0)
}

/// Samples per texel and axis that average a box of this width over a lobe of the shortest wavelength:
/// spaced 1.2 standard deviations, the midpoint rule errs by `2 exp(-2π²/1.2²)` = 2e-6.
pub(crate) fn box_samples(optics: &OpticsConfig, width: f64) -> usize {
    ((width / (1.2 * narrowest_blur(optics))).ceil() as usize).max(1)
}

/// Numbers of nodes in `w` that a surface can at most need: Chebyshev terms of a function of bandwidth
/// twice the half range of heights in `k w` over the whole reach.
pub fn nodes_bound(half_height_range_nm: f64, wavelength_min_nm: f64, tolerance: f64) -> usize {
    nodes_bound_over(half_height_range_nm, wavelength_min_nm, tolerance, max_abs_w(0.0))
}

/// The same over an interval of this length in `w`.
pub(crate) fn nodes_bound_over(
    half_height_range_nm: f64,
    wavelength_min_nm: f64,
    tolerance: f64,
    w_length: f64,
) -> usize {
    nodes_for_exponential(2.0 * half_height_range_nm, w_length * TAU / wavelength_min_nm, tolerance)
}

/// Nodes that an interval of this length in `w` will likely need: as for a surface of bandwidth 1.5 rms in each phasor.
pub(super) fn nodes_expected(rms_nm: f64, wavelength_min_nm: f64, w_length: f64, tolerance: f64) -> usize {
    nodes_for_exponential(1.5 * rms_nm, w_length * TAU / wavelength_min_nm, tolerance)
}
