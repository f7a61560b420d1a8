//! Other models of diffraction on the same scans: closed forms from before there was data, and wave methods that tables
//! were measured against.
//!
//! - [`rough::RoughSurface`]: Stam's closed form for a Gaussian random surface (1999);
//! - [`regular::RegularSurface`]: closed form of one or two sinusoids, the strongest of the scan, for Stam's
//!   regular bumps and gratings;
//! - [`harmonics::HarmonicFit`]: a low-order fit of spherical harmonics to the BRDF (Lindsay and Agu 2006);
//! - [`wigner`]: the Wigner distribution of a phase screen along the plane of incidence, projected (WBSDF, Cuypers et al.
//!   2012) or at some positions and angles (augmented light field, Oh et al. 2010);
//! - [`paths::OpticalPaths`]: phases of sampled paths over the coherence area (Ziegler et al. 2008).
//!
//! The last two are written from what is known of these papers, not from their code; each file says what is theirs and
//! what was chosen here.

pub mod harmonics;
pub mod paths;
pub mod regular;
pub mod rough;
pub mod statistics;
pub(crate) mod wigner;

mod screen;

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use diffraction_brdf::direction::{Vec3, Xyz, wave_vector_change};
use diffraction_brdf::error::Result;
use diffraction_brdf::spectrum::SpectralQuadrature;
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::optics::reference::{FULL_STEP, resolving_count};

/// Adds to XYZ the BRDF in 1/sr of each pair from a closed form of `⟨|P|²⟩ / A` in nm², given `q` and a wavelength in
/// nm.
///
/// # Errors
/// `Error::Call` for an invisible light.
pub fn integrate(
    optics: &OpticsConfig,
    pairs: &[Pair],
    power_nm2: impl Fn(Vec3, f64) -> f64,
    xyz: &mut [Xyz],
) -> Result<()> {
    let spectrum = |&(wi, wo): &Pair, wavelengths_nm: &[f64]| {
        let q = wave_vector_change(wi, wo);
        wavelengths_nm.iter().map(|&nm| power_nm2(q, nm)).collect()
    };
    integrate_spectra(optics, 0.0, pairs, spectrum, xyz)
}

/// Adds to XYZ the BRDF in 1/sr of each pair from `⟨|P|²⟩ / A` in nm² at the wavelengths that it is given, which resolve
/// what a surface of this half range of heights shows and lie at equal steps of wavenumber. Pairs with equally many
/// wavelengths share them.
///
/// # Errors
/// `Error::Call` for an invisible light.
pub(crate) fn integrate_spectra(
    optics: &OpticsConfig,
    half_range_nm: f64,
    pairs: &[Pair],
    power_nm2: impl Fn(&Pair, &[f64]) -> Vec<f64>,
    xyz: &mut [Xyz],
) -> Result<()> {
    let mut by_count: BTreeMap<usize, SpectralQuadrature> = BTreeMap::new();
    for (pair, xyz) in pairs.iter().zip(xyz) {
        let q = wave_vector_change(pair.0, pair.1);
        let front = optics.front_factor().diffuse(pair.0, pair.1);
        if front == 0.0 {
            continue;
        }
        let count = resolving_count(optics, q, half_range_nm, FULL_STEP);
        let quadrature = match by_count.entry(count) {
            Entry::Occupied(found) => found.into_mut(),
            Entry::Vacant(free) => free.insert(optics.tables_quadrature(count)?),
        };
        let powers = power_nm2(pair, &quadrature.wavelengths_nm);
        for ((&nm, weight), power) in quadrature.wavelengths_nm.iter().zip(&quadrature.weights).zip(powers) {
            let f = front * power / (nm * nm * q[2] * q[2]);
            xyz.iter_mut().zip(weight).for_each(|(sum, weight)| *sum += weight * f);
        }
    }
    Ok(())
}

/// A pair of directions, to the light and to the viewer.
type Pair = (Vec3, Vec3);

#[cfg(test)]
mod tests {
    use diffraction_build::height::HeightField;
    use std::f64::consts::TAU;

    /// A grating along x of 1600 nm with the given profile over a period; 20 by 16.25 µm.
    fn grating(height_nm: impl Fn(f64) -> f64) -> HeightField {
        let heights_nm = ndarray::Array2::from_shape_fn((65, 1_001), |(_, column)| {
            height_nm((column as f64 - 500.0) * 20.0 / 1_600.0)
        });
        HeightField { heights_nm, pitch_nm: [20.0, 250.0] }
    }

    pub fn sinusoid(amplitude_nm: f64) -> HeightField {
        grating(|turns| amplitude_nm * (TAU * turns).sin())
    }

    /// A profile that is not its own mirror image.
    pub fn uneven() -> HeightField {
        grating(|turns| 50.0 * (TAU * turns).sin() + 25.0 * (TAU * 2.0 * turns + 0.4).sin())
    }
}
