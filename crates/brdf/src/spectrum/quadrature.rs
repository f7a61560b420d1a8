//! Quadratures over wavelengths that turn a spectrum into XYZ.

use super::illuminant::{Illuminant, Line, observer_2deg};
use crate::direction::Xyz;
use crate::error::{Error, Result};

/// A quadrature for XYZ: `XYZ = Σ weights[j] f(wavelengths_nm[j])`, normalised so that `f = 1` has
/// `Y = 1`.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectralQuadrature {
    /// Wavelengths in nm.
    pub wavelengths_nm: Vec<f64>,
    /// Weights for X, Y, Z at each wavelength.
    pub weights: Vec<Xyz>,
}

/// Trapezoid rule on a uniform wavelength grid: plain, for the reference. Lines stay themselves.
///
/// # Errors
/// `Error::Call` if the light has no luminous power within the range.
pub fn uniform_wavelengths(illuminant: &Illuminant, range_nm: [f64; 2], step_nm: f64) -> Result<SpectralQuadrature> {
    if let Illuminant::Lines(lines) = illuminant {
        return lines_quadrature(lines);
    }
    let [first, last] = range_nm;
    let intervals = ((last - first) / step_nm).ceil().max(1.0) as usize;
    let step = (last - first) / intervals as f64;
    let wavelengths_nm: Vec<f64> = (0..=intervals).map(|i| first + i as f64 * step).collect();
    let weights = wavelengths_nm
        .iter()
        .enumerate()
        .map(|(i, &nm)| {
            let end = if i == 0 || i == intervals { 0.5 } else { 1.0 };
            observer_2deg(nm).map(|c| end * step * illuminant.power(nm) * c)
        })
        .collect();
    normalised(wavelengths_nm, weights)
}

pub(super) fn lines_quadrature(lines: &[Line]) -> Result<SpectralQuadrature> {
    let weights = lines.iter().map(|l| observer_2deg(l.wavelength_nm).map(|c| c * l.power)).collect();
    normalised(lines.iter().map(|l| l.wavelength_nm).collect(), weights)
}

pub(super) fn normalised(wavelengths_nm: Vec<f64>, mut weights: Vec<Xyz>) -> Result<SpectralQuadrature> {
    let luminous: f64 = weights.iter().map(|w| w[1]).sum();
    if !(luminous.is_finite() && luminous > 0.0) {
        return Err(Error::Call(
            "the illuminant has no luminous power within `wavelength_nm`: XYZ cannot be normalised \
             (the observer sees 360 to 830 nm)"
                .into(),
        ));
    }
    for weight in &mut weights {
        *weight = weight.map(|w| w / luminous);
    }
    Ok(SpectralQuadrature { wavelengths_nm, weights })
}
