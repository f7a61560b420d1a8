//! What a table set needs for a tolerance: its grid, the wavelengths each ring of (u, v) asks for.

use std::f64::consts::{SQRT_2, TAU};

use super::domain::Domain;
use crate::ground::spectrum::{SpectralQuadrature, uniform_wavenumbers, wavenumbers_for_pulses};
use crate::optics::config::OpticsConfig;
use diffraction_brdf::chebyshev::nodes_for_exponential;
use diffraction_brdf::direction::max_abs_w;
use diffraction_brdf::error::Result;

/// Texels beyond the rim of the disc that are filled, so that interpolation at the rim sees no zeros.
pub(super) const RIM_TEXELS: f64 = 3.0;

/// Texel positions over [-2, 2] in u and v.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// Texels along each axis; odd, so that one lies at (0, 0).
    pub size: usize,
    /// Half width of the square: 2 for a whole table, the lobe's radius for its patch.
    pub half_width: f64,
}

impl Grid {
    /// Distance between texels.
    pub fn texel(&self) -> f64 {
        2.0 * self.half_width / (self.size - 1) as f64
    }

    /// `u` of a column.
    pub fn u(&self, column: usize) -> f64 {
        -self.half_width + column as f64 * self.texel()
    }

    /// `v` of a row: row 0 is the +v edge.
    pub fn v(&self, row: usize) -> f64 {
        -self.u(row)
    }

    /// Index, row by row, of the texel nearest to `(u, v)`; `None` outside of the grid.
    pub fn nearest(&self, [u, v]: [f64; 2]) -> Option<usize> {
        let at = |x: f64| ((x + self.half_width) / self.texel()).round();
        let inside = |at: f64| at >= 0.0 && at < self.size as f64;
        let (row, column) = (at(-v), at(u));
        (inside(row) && inside(column)).then(|| row as usize * self.size + column as usize)
    }

    /// Columns with `|u| <= reach`, as a half-open range.
    pub fn columns_within(&self, reach: f64) -> std::ops::Range<usize> {
        let middle = (self.size - 1) / 2;
        if reach < 0.0 {
            return middle..middle;
        }
        let steps = ((reach / self.texel()) as usize).min(middle);
        middle - steps..middle + steps + 1
    }
}

/// A ring of (u, v) whose texels share their wavelengths.
#[derive(Debug, Clone, PartialEq)]
pub struct Ring {
    /// Inner (included) and outer radius.
    pub rho: [f64; 2],
    /// Lowest and highest `|w|` that its texels are asked for.
    pub w: [f64; 2],
    /// Wavelengths with XYZ weights.
    pub quadrature: SpectralQuadrature,
}

/// Fewest wavelengths of a continuous spectrum over what the eye sees: enough for whatever is smooth in it.
const WAVELENGTHS_MIN: usize = 24;

/// Share of the tolerance that the wavelength step may take.
const STEP_SHARE: f64 = 0.5;

/// How many wavelengths directions at the radius `rho` need for a tolerance, whose `|w|` is at most `w`.
///
/// Along a direction, `|P|²` as a function of `1/λ` is a sum over pairs of surface points of waves at the lag
/// `ρ Δx + |w| Δh`. The window weights `Δx` by `exp(-Δx²/4σ²)`: whatever the surface, its spectrum is made of Gaussian
/// pulses with the standard deviation `1/(2√2 π σ ρ)`, one for each line of a periodic surface. A grating shows a direction
/// one of them, where no errors average out, and so each is integrated to the tolerance:
/// [`wavenumbers_for_pulses`] derives how many wavelengths that takes. Depth modulates pulses by lags up to
/// `L = 2 |w|` times the half range of the heights. These have at most the variance `L²`; that of waves, of which the
/// outermost heights meet the outermost seldom, is `L²/4`, and variances of lags add: the pulses are taken to be
/// narrower by as much.
pub fn wavelengths_needed(optics: &OpticsConfig, bandwidth_nm: f64, rho: f64, w: f64, tolerance: f64) -> usize {
    let [low_nm, high_nm] = optics.illuminant.reach_nm(optics.wavelength_nm);
    // Deviations of lag times 2π.
    let (window, depth) = (SQRT_2 * TAU * optics.sigma_nm * rho, TAU * bandwidth_nm * w);
    // A range wider than the eye's spreads the same nodes thinner over what it sees.
    let widening = ((1.0 / low_nm - 1.0 / high_nm) / (1.0 / 380.0 - 1.0 / 780.0)).max(1.0);
    let fewest = (widening * WAVELENGTHS_MIN as f64) as usize;
    let deviation = 1.0 / window.hypot(depth);
    wavenumbers_for_pulses(&optics.illuminant, optics.wavelength_nm, deviation, STEP_SHARE * tolerance, fewest)
}

/// Rings from the outside in, each narrower by the root of two, until the fewest wavelengths suffice.
///
/// # Errors
/// `Error::Call` for an invisible light.
pub fn rings(
    optics: &OpticsConfig,
    bandwidth_nm: f64,
    rho_max: f64,
    tolerance: f64,
    step_nm: Option<f64>,
) -> Result<Vec<Ring>> {
    let mut rings = Vec::new();
    let mut outer = rho_max;
    let fewest = wavelengths_of(optics, bandwidth_nm, [0.0; 2], tolerance, step_nm);
    loop {
        let inner = outer / SQRT_2;
        let count = wavelengths_of(optics, bandwidth_nm, [inner, outer], tolerance, step_nm).max(fewest);
        let settled = count == fewest;
        // The interpolation in `w` profits from a small reach even where the wavelengths do not.
        let last = settled && max_abs_w(inner) > 0.9 * max_abs_w(0.0) || inner < 0.02;
        let inner_edge = if last { 0.0 } else { inner };
        rings.push(Ring {
            rho: [inner_edge, outer],
            // The whole reach of the texels nearest to the middle.
            w: [0.0, max_abs_w(inner_edge)],
            quadrature: uniform_wavenumbers(&optics.illuminant, optics.wavelength_nm, count)?,
        });
        if last {
            return Ok(rings);
        }
        outer = inner;
    }
}

/// Where `t` is nearly the same everywhere, `|w|` is not: rings are cut so that `max_abs_w` changes by no more than this,
/// nor their radii by more than this ratio, and with them the nodes of a ring stay few...
const FINE_STEP: f64 = 0.25;
const FINE_RATIO: f64 = 1.19;
/// ...but no narrower than this many widths of what blurs a line, since every ring interpolates all lines whose blur
/// reaches into it.
const FINE_LOBES: f64 = 20.0;

/// Rings for tables that serve scenes: finer than [`rings`], each with the `|w|` that one light and one camera can have in
/// it. They know nothing of the scenes, so that what a texel holds does not depend on which others are asked for.
///
/// # Errors
/// `Error::Call` for an invisible light.
pub fn fine_rings(
    optics: &OpticsConfig,
    bandwidth_nm: f64,
    rho_max: f64,
    tolerance: f64,
    step_nm: Option<f64>,
) -> Result<Vec<Ring>> {
    let narrowest = FINE_LOBES * lobe_width(optics.sigma_nm, optics.illuminant.reach_nm(optics.wavelength_nm)[0]);
    let mut rings = Vec::new();
    let mut outer = rho_max;
    while outer > 0.0 {
        let by_reach = (4.0 - (max_abs_w(outer) + FINE_STEP).powi(2)).max(0.0).sqrt();
        let inner = by_reach.max(outer / FINE_RATIO).min(outer - narrowest).max(0.0);
        let inner = if inner < narrowest { 0.0 } else { inner };
        let count = wavelengths_of(optics, bandwidth_nm, [inner, outer], tolerance, step_nm);
        let quadrature = uniform_wavenumbers(&optics.illuminant, optics.wavelength_nm, count)?;
        rings.push(Ring { rho: [inner, outer], w: [max_abs_w(outer), max_abs_w(inner)], quadrature });
        outer = inner;
    }
    Ok(rings)
}

/// The rings in which a domain has texels, with the `|w|` that these are asked for.
pub(super) fn reached_rings(rings: Vec<Ring>, domain: &Domain) -> Vec<Ring> {
    let outermost = rings.first().map(|ring| ring.rho[1]);
    let radii: Vec<f64> = outermost.into_iter().chain(rings.iter().map(|ring| ring.rho[0])).collect();
    let reached = rings.into_iter().zip(domain.w_of_rings(&radii));
    reached.filter_map(|(ring, w)| Some(Ring { w: w?, ..ring })).collect()
}

/// An interval widened to whole multiples of a step, within limits that hold it.
pub(super) fn widened([low, high]: [f64; 2], step: f64, limits: [f64; 2]) -> [f64; 2] {
    [((low / step).floor() * step).max(limits[0]), ((high / step).ceil() * step).min(limits[1])]
}

/// Wavelengths for a ring of these radii: as many as the tolerance asks for, or those of a given step.
pub(super) fn wavelengths_of(
    optics: &OpticsConfig,
    bandwidth_nm: f64,
    [inner, outer]: [f64; 2],
    tolerance: f64,
    step_nm: Option<f64>,
) -> usize {
    let [low_nm, high_nm] = optics.illuminant.reach_nm(optics.wavelength_nm);
    match step_nm {
        Some(step) => ((high_nm - low_nm) / step).ceil() as usize + 1,
        None => wavelengths_needed(optics, bandwidth_nm, outer, max_abs_w(inner), tolerance),
    }
}

/// Standard deviation in (u, v) of a coherence lobe at a wavelength: `λ σ_f / √2`, `σ_f = 1/(2πσ)`.
pub fn lobe_width(sigma_nm: f64, wavelength_nm: f64) -> f64 {
    wavelength_nm / (TAU * sigma_nm * SQRT_2)
}

/// Radius beyond which the coherent lobe is below 1e-9 of its peak at the longest wavelength.
pub fn lobe_radius(optics: &OpticsConfig) -> f64 {
    let high_nm = optics.illuminant.reach_nm(optics.wavelength_nm)[1];
    // exp(-r²/2) = 1e-9 at r = 6.44 standard deviations.
    (6.44 * lobe_width(optics.sigma_nm, high_nm)).min(2.0)
}

/// Side of the table whose interpolation by cubics resolves the lobe of the shortest wavelength to the
/// tolerance: the local cubic errs by `3/128 (Δ/w)⁴` times a fourth derivative of at most 3.
pub fn resolving_size(optics: &OpticsConfig, tolerance: f64) -> usize {
    let low_nm = optics.illuminant.reach_nm(optics.wavelength_nm)[0];
    let texel = lobe_width(optics.sigma_nm, low_nm) * (tolerance * 128.0 / 9.0).powf(0.25);
    2 * (2.0 / texel).ceil().min(1e6) as usize + 1
}

/// Radius of the (u, v) disc for which the scan's sampling holds every frequency at every wavelength.
pub fn usable_radius(optics: &OpticsConfig, pitch_nm: [f64; 2]) -> f64 {
    let low_nm = optics.illuminant.reach_nm(optics.wavelength_nm)[0];
    (0.5 * low_nm / pitch_nm[0].max(pitch_nm[1])).min(2.0)
}

/// Samples per texel and axis that average a box of this width over a lobe of the shortest wavelength:
/// spaced 1.2 standard deviations, the midpoint rule errs by `2 exp(-2π²/1.2²)` = 2e-6.
pub fn box_samples(optics: &OpticsConfig, width: f64) -> usize {
    let low_nm = optics.illuminant.reach_nm(optics.wavelength_nm)[0];
    ((width / (1.2 * lobe_width(optics.sigma_nm, low_nm))).ceil() as usize).max(1)
}

/// Numbers of nodes in `w` that a surface can at most need: Chebyshev terms of a function of bandwidth
/// `2 max|h|` in `k w` over the whole reach.
pub fn nodes_bound(bandwidth_nm: f64, wavelength_min_nm: f64, tolerance: f64) -> usize {
    nodes_bound_over(bandwidth_nm, wavelength_min_nm, tolerance, max_abs_w(0.0))
}

/// The same over an interval of this length in `w`.
pub fn nodes_bound_over(bandwidth_nm: f64, wavelength_min_nm: f64, tolerance: f64, w_length: f64) -> usize {
    nodes_for_exponential(2.0 * bandwidth_nm, w_length * TAU / wavelength_min_nm, tolerance)
}
