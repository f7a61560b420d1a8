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

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use diffraction_brdf::direction::{Vec3, Xyz, wave_vector_change};
use diffraction_brdf::error::Result;
use diffraction_build::ground::spectrum::{SpectralQuadrature, uniform_wavenumbers};
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::optics::reference::{FULL_STEP, resolving_count};

/// Adds to XYZ the BRDF in 1/sr of each pair from a closed form of `⟨|P|²⟩ / A` in nm², given `q` and a wavelength in
/// nm. Pairs with equally many wavelengths share them.
///
/// # Errors
/// `Error::Call` for an invisible light.
pub fn integrate(
    optics: &OpticsConfig,
    pairs: &[(Vec3, Vec3)],
    power_nm2: impl Fn(Vec3, f64) -> f64,
    xyz: &mut [Xyz],
) -> Result<()> {
    let mut by_count: BTreeMap<usize, SpectralQuadrature> = BTreeMap::new();
    for (&(wi, wo), xyz) in pairs.iter().zip(xyz) {
        let q = wave_vector_change(wi, wo);
        let front = optics.front_factor().value(wi, wo);
        if front == 0.0 {
            continue;
        }
        let count = resolving_count(optics, q, 0.0, FULL_STEP);
        let quadrature = match by_count.entry(count) {
            Entry::Occupied(found) => found.into_mut(),
            Entry::Vacant(free) => free.insert(uniform_wavenumbers(&optics.illuminant, optics.wavelength_nm, count)?),
        };
        for (&nm, weight) in quadrature.wavelengths_nm.iter().zip(&quadrature.weights) {
            let f = front * power_nm2(q, nm) / (nm * nm * q[2] * q[2]);
            xyz.iter_mut().zip(weight).for_each(|(sum, weight)| *sum += weight * f);
        }
    }
    Ok(())
}

/// [`integrate`] for one pair.
fn integrated(optics: &OpticsConfig, wi: Vec3, wo: Vec3, power_nm2: impl Fn(Vec3, f64) -> f64) -> Result<Xyz> {
    let mut xyz = [[0.0; 3]];
    integrate(optics, &[(wi, wo)], power_nm2, &mut xyz)?;
    Ok(xyz[0])
}
