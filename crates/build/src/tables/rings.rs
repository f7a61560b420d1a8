//! Annuli of (u, v), and the wavelengths that each of them asks for.

use std::f64::consts::SQRT_2;

use super::input::BuildInput;
use diffraction_brdf::chebyshev;
use diffraction_brdf::direction::max_abs_w;
use diffraction_brdf::error::Result;
use diffraction_brdf::spectrum::{Illuminant, Lags, SpectralQuadrature};

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

/// Share of the tolerance that the wavelength step may take.
const STEP_SHARE: f64 = 0.5;

/// How many wavelengths directions at this radius need for a tolerance, whose `|w|` is at most `abs_w`: see [`Lags`].
pub(super) fn wavelengths_needed(input: &BuildInput, radius: f64, abs_w: f64, tolerance: f64) -> usize {
    let BuildInput { optics, half_height_range_nm, .. } = *input;
    let lags = Lags { sigma_nm: optics.sigma_nm, half_height_range_nm };
    lags.wavelengths(&optics.illuminant, optics.wavelength_nm, [radius, abs_w], STEP_SHARE * tolerance)
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

/// The wavelength of tables that hold one alone, with the weight 1.
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
