//! Annuli of (u, v), and the wavelengths that each of them asks for.

use std::f64::consts::{SQRT_2, TAU};

use super::input::BuildInput;
use diffraction_brdf::chebyshev;
use diffraction_brdf::direction::max_abs_w;
use diffraction_brdf::error::Result;
use diffraction_brdf::spectrum::{Illuminant, SpectralQuadrature, wavenumbers_for_pulses};

/// An annulus of (u, v) whose texels share their wavelengths.
#[derive(Debug, Clone, PartialEq)]
pub struct Ring {
    /// Inner (included) and outer radius of the annulus.
    pub radius: [f64; 2],
    /// Lowest and highest `|w|` that its texels are asked for.
    pub abs_w: [f64; 2],
    /// Wavelengths with XYZ weights.
    pub quadrature: SpectralQuadrature,
}

impl Ring {
    /// Whether directions at a distance from the centre of (u, v) belong to it.
    pub fn holds(&self, radius: f64) -> bool {
        (self.radius[0]..self.radius[1]).contains(&radius)
    }

    /// Number of its wavelengths.
    pub fn wavelengths(&self) -> usize {
        self.quadrature.wavelengths_nm.len()
    }
}

/// The nodes of a ring in `|w|`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RingNodes {
    /// The interval that they span.
    pub abs_w: [f64; 2],
    /// How many there are.
    pub count: usize,
}

impl RingNodes {
    /// Where they lie.
    pub fn positions(&self) -> Vec<f64> {
        chebyshev::gauss_nodes(self.count, self.abs_w[0], self.abs_w[1])
    }
}

/// Fewest wavelengths of a continuous spectrum over what the eye sees: enough for whatever is smooth in it.
const WAVELENGTHS_MIN: usize = 24;

/// Share of the tolerance that the wavelength step may take.
const STEP_SHARE: f64 = 0.5;

/// How many wavelengths directions at this radius need for a tolerance, whose `|w|` is at most `abs_w`.
///
/// Along a direction, `|P|²` as a function of `1/λ` is a sum over pairs of surface points of waves at the lag
/// `ρ Δx + |w| Δh`. The window weights `Δx` by `exp(-Δx²/4σ²)`: whatever the surface, its spectrum is made of Gaussian
/// pulses with the standard deviation `1/(2√2 π σ ρ)`, one for each line of a periodic surface. A grating shows a direction
/// one of them, where no errors average out, and so each is integrated to the tolerance:
/// [`wavenumbers_for_pulses`] derives how many wavelengths that takes. Relief modulates pulses by lags up to
/// `L = 2 |w|` times the half range of the heights. These have at most the variance `L²`; that of waves, of which the
/// outermost heights meet the outermost seldom, is `L²/4`, and variances of lags add: the pulses are taken to be
/// narrower by as much.
pub(super) fn wavelengths_needed(input: &BuildInput, radius: f64, abs_w: f64, tolerance: f64) -> usize {
    let BuildInput { optics, wavelength_range_nm: [low_nm, high_nm], .. } = *input;
    // Deviations of lag times 2π.
    let (window, relief) = (SQRT_2 * TAU * optics.sigma_nm * radius, TAU * input.half_height_range_nm * abs_w);
    // A range wider than the eye's spreads the same nodes thinner over what it sees.
    let widening = ((1.0 / low_nm - 1.0 / high_nm) / (1.0 / 380.0 - 1.0 / 780.0)).max(1.0);
    let fewest = (widening * WAVELENGTHS_MIN as f64) as usize;
    let deviation = 1.0 / window.hypot(relief);
    wavenumbers_for_pulses(&optics.illuminant, optics.wavelength_nm, deviation, STEP_SHARE * tolerance, fewest)
}

/// Wavelengths for a ring of these radii: as many as the tolerance asks for, or those of a given step.
pub(super) fn wavelengths_of(input: &BuildInput, [inner, outer]: [f64; 2]) -> usize {
    let [low_nm, high_nm] = input.wavelength_range_nm;
    match input.tables.wavelength_step_nm {
        Some(step) => ((high_nm - low_nm) / step).ceil() as usize + 1,
        None => wavelengths_needed(input, outer, max_abs_w(inner), input.tables.tolerance),
    }
}

/// So many wavelengths, evenly spaced in wavenumber, with their XYZ weights, which hold the material's colour where it has one.
///
/// # Errors
/// `Error::Call` for an invisible light.
pub(super) fn quadrature(input: &BuildInput, count: usize) -> Result<SpectralQuadrature> {
    grey(input).map_or_else(|| input.optics.tables_quadrature(count), Ok)
}

/// The same without the material's colour.
///
/// # Errors
/// As [`quadrature`].
pub(super) fn light_quadrature(input: &BuildInput, count: usize) -> Result<SpectralQuadrature> {
    grey(input).map_or_else(|| input.optics.quadrature(count), Ok)
}

/// The wavelength of tables that hold one alone, with equal weights.
fn grey(input: &BuildInput) -> Option<SpectralQuadrature> {
    let Illuminant::Lines(lines) = &input.optics.illuminant else { return None };
    input.is_grey.then(|| SpectralQuadrature {
        wavelengths_nm: lines.iter().map(|line| line.wavelength_nm).collect(),
        weights: vec![[1.0; 3]; lines.len()],
    })
}

/// Rings for every direction from the outside in, each narrower by the root of two, until the fewest wavelengths suffice.
///
/// # Errors
/// `Error::Call` for an invisible light.
pub(super) fn rings(input: &BuildInput, radius_max: f64) -> Result<Vec<Ring>> {
    let mut rings = Vec::new();
    let mut outer = radius_max;
    let fewest = wavelengths_of(input, [0.0; 2]);
    loop {
        let inner = outer / SQRT_2;
        let count = wavelengths_of(input, [inner, outer]).max(fewest);
        let settled = count == fewest;
        // The interpolation in `w` profits from a small reach even where the wavelengths do not.
        let last = settled && max_abs_w(inner) > 0.9 * max_abs_w(0.0) || inner < 0.02;
        let inner_edge = if last { 0.0 } else { inner };
        rings.push(Ring {
            radius: [inner_edge, outer],
            // The whole reach of the texels nearest to the middle.
            abs_w: [0.0, max_abs_w(inner_edge)],
            quadrature: quadrature(input, count)?,
        });
        if last {
            return Ok(rings);
        }
        outer = inner;
    }
}
