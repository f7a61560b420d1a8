//! Older models of diffraction, fitted to the same scans: what people used before there was data.
//!
//! - [`rough::RoughSurface`]: Stam's closed form for a Gaussian random surface (1999);
//! - [`regular::RegularSurface`]: closed form of one or two sinusoids, the strongest of the scan, for Stam's
//!   regular bumps and gratings;
//! - [`harmonics::HarmonicFit`]: a low-order fit of spherical harmonics to the BRDF (Lindsay and Agu 2006).

pub mod harmonics;
pub mod regular;
pub mod rough;
pub mod statistics;

use crate::ground::direction::{Vec3, Xyz, wave_vector_change};
use crate::ground::error::Result;
use crate::optics::config::OpticsConfig;
use crate::optics::reference::{FULL_STEP, prefactor, resolving_wavelengths};

/// XYZ of the BRDF in 1/sr from a closed form of `⟨|P|²⟩ / A` in nm², given `q` and a wavelength in nm.
///
/// # Errors
/// `Error::Call` for an invisible light.
pub fn integrated(optics: &OpticsConfig, wi: Vec3, wo: Vec3, power_nm2: impl Fn(Vec3, f64) -> f64) -> Result<Xyz> {
    let q = wave_vector_change(wi, wo);
    let front = prefactor(optics, wi, wo);
    let mut xyz = [0.0; 3];
    if front == 0.0 {
        return Ok(xyz);
    }
    let quadrature = resolving_wavelengths(optics, q, FULL_STEP)?;
    for (&nm, weight) in quadrature.wavelengths_nm.iter().zip(&quadrature.weights) {
        let f = front * power_nm2(q, nm) / (nm * nm * q[2] * q[2]);
        xyz.iter_mut().zip(weight).for_each(|(sum, weight)| *sum += weight * f);
    }
    Ok(xyz)
}
