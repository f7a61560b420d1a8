//! The white that a surface's colours are seen against.

use diffraction_brdf::direction::Xyz;
use diffraction_brdf::error::Result;
use diffraction_brdf::spectrum::{Illuminant, uniform_wavelengths};

use crate::ground::hue::Hue;

/// Step of the white's sum over wavelengths in nm, and the purity from which a light has no white of its own.
const STEP_NM: f64 = 1.0;
const COLOURED_LIGHT: f64 = 0.5;

/// XYZ of what reflects all of a light; of equal energy under a light of a single colour, since a laser's colours are all alike and
/// against equal energy they at least have a name.
///
/// # Errors
/// A light without power in the range of wavelengths, in nm.
pub fn white(illuminant: &Illuminant, wavelength_nm: [f64; 2]) -> Result<Xyz> {
    let quadrature = uniform_wavelengths(illuminant, wavelength_nm, STEP_NM)?;
    let own: Xyz = std::array::from_fn(|c| quadrature.weights.iter().map(|weight| weight[c]).sum());
    let even = [1.0; 3];
    let is_coloured = Hue::of(own, even).is_none_or(|hue| hue.purity > COLOURED_LIGHT);
    Ok(if is_coloured { even } else { own })
}
