//! The BRDF straight from the transforms, at full spectral resolution: the fast reference.
//!
//! Between the direct sum (`reference`), a thousand times slower, and the tables: no grid in (u, v), no
//! expansion in `w`, no coarse wavelengths; only the interpolation in phase scale and frequency is shared with
//! the tables. It is itself held against the direct sum.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use rayon::prelude::*;

use super::config::OpticsConfig;
use super::factors::PairFactors;
use super::lines::{Buffers, Part, Point};
use super::reference::{FULL_STEP, WavenumberStep, resolving_count};
use super::spectra::{self, Spectra, SpectraConfig};
use super::window::placements;
use crate::height::HeightField;
use diffraction_brdf::direction::{Vec3, Xyz};
use diffraction_brdf::error::Result;
use diffraction_brdf::spectrum::{SpectralQuadrature, uniform_wavenumbers};

/// XYZ of the BRDF in 1/sr for many pairs of directions, averaged over scans and windows.
///
/// # Errors
/// A scan too small for the window, an invisible light, or transforms beyond the allowed memory.
pub fn brdf_xyz_batch(
    fields: &[HeightField],
    optics: &OpticsConfig,
    config: &SpectraConfig,
    pairs: &[(Vec3, Vec3)],
) -> Result<Vec<Xyz>> {
    let mut sums = vec![[0.0; 3]; pairs.len()];
    let mut windows = 0;
    for field in fields {
        for placement in placements(field, optics)? {
            let spectra = spectra::transform(field, placement, optics, config)?;
            add_window(&spectra, optics, pairs, FULL_STEP, &mut sums)?;
            windows += 1;
        }
    }
    let share = 1.0 / f64::from(windows.max(1));
    Ok(sums.into_iter().map(|sum| sum.map(|s| s * share)).collect())
}

/// The BRDF in 1/sr at each of some wavelengths for many pairs of directions, averaged over scans and windows.
///
/// # Errors
/// As [`brdf_xyz_batch`], and a wavelength at which the material is not known.
pub fn brdf_spectrum_batch(
    fields: &[HeightField],
    optics: &OpticsConfig,
    config: &SpectraConfig,
    pairs: &[(Vec3, Vec3)],
    wavelengths_nm: &[f64],
) -> Result<Vec<Vec<f64>>> {
    optics.check_material_at(wavelengths_nm)?;
    let mut sums = vec![vec![0.0; wavelengths_nm.len()]; pairs.len()];
    let mut windows = 0;
    for field in fields {
        for placement in placements(field, optics)? {
            let spectra = spectra::transform(field, placement, optics, config)?;
            sums.par_iter_mut().zip(pairs).for_each_init(Buffers::default, |buffers, (sum, &(wi, wo))| {
                let Some(factors) = PairFactors::of(optics, wi, wo) else { return };
                brdf_of_window(&spectra, &factors, wavelengths_nm, buffers, |j, brdf| sum[j] += brdf);
            });
            windows += 1;
        }
    }
    let share = 1.0 / f64::from(windows.max(1));
    sums.iter_mut().flatten().for_each(|value| *value *= share);
    Ok(sums)
}

/// Adds one window's BRDF to each pair's sum; `step` as in [`resolving_count`].
///
/// # Errors
/// An invisible light.
pub fn add_window(
    spectra: &Spectra,
    optics: &OpticsConfig,
    pairs: &[(Vec3, Vec3)],
    step: WavenumberStep,
    sums: &mut [Xyz],
) -> Result<()> {
    add_window_with(spectra, optics, pairs, step, PairFactors::of, sums)
}

/// [`add_window`] with other factors of a pair than the exact ones.
///
/// # Errors
/// As [`add_window`].
pub fn add_window_with<'a>(
    spectra: &Spectra,
    optics: &'a OpticsConfig,
    pairs: &[(Vec3, Vec3)],
    step: WavenumberStep,
    factors: impl Fn(&'a OpticsConfig, Vec3, Vec3) -> Option<PairFactors<'a>>,
    sums: &mut [Xyz],
) -> Result<()> {
    // Directions with equally many wavelengths share them; one set is held at a time.
    let mut by_count: BTreeMap<usize, Vec<(&mut Xyz, PairFactors)>> = BTreeMap::new();
    for (sum, &(wi, wo)) in sums.iter_mut().zip(pairs) {
        let Some(factors) = factors(optics, wi, wo) else { continue };
        let count = resolving_count(optics, factors.q, spectra.half_range_nm, step);
        by_count.entry(count).or_default().push((sum, factors));
    }
    for (count, group) in by_count {
        let quadrature = uniform_wavenumbers(&optics.illuminant, optics.wavelength_nm, count)?;
        let SpectralQuadrature { wavelengths_nm, weights } = &quadrature;
        group.into_par_iter().for_each_init(Buffers::default, |buffers, (sum, factors)| {
            brdf_of_window(spectra, &factors, wavelengths_nm, buffers, |j, brdf| add(sum, weights[j], brdf));
        });
    }
    Ok(())
}

/// Calls `found` with the index of each wavelength and the BRDF of one window there in 1/sr.
pub fn brdf_of_window(
    spectra: &Spectra,
    factors: &PairFactors,
    wavelengths_nm: &[f64],
    buffers: &mut Buffers,
    mut found: impl FnMut(usize, f64),
) {
    let [u, v, w] = factors.q;
    let at = |j: usize| point([u, v], w.abs(), wavelengths_nm[j]);
    spectra.powers(Part::Total, wavelengths_nm.len(), at, buffers, |j, power| {
        let nm = wavelengths_nm[j];
        let image = factors.image_radius.map_or(0.0, |radius| spectra.lobe_power_nm2(radius / nm, at(j).s, nm));
        found(j, factors.brdf(nm, power.rest, power.coherent + image));
    });
}

/// `∫ S x̄ k² |E|² / (λ² A) dλ` of one window: the diffuse part alone, for several values of `w`.
pub(crate) fn diffuse_power(spectra: &Spectra, quadrature: &SpectralQuadrature, uv: [f64; 2], w: &[f64]) -> Vec<Xyz> {
    let SpectralQuadrature { wavelengths_nm, weights } = quadrature;
    let mut sums = vec![[0.0; 3]; w.len()];
    let places = |index: usize| (index / w.len(), index % w.len());
    let point = |index: usize| point(uv, w[places(index).1], wavelengths_nm[places(index).0]);
    let count = wavelengths_nm.len() * w.len();
    spectra.powers(Part::Diffuse, count, point, &mut Buffers::default(), |index, power| {
        let (j, which) = places(index);
        add(&mut sums[which], weights[j], (TAU / wavelengths_nm[j].powi(2)).powi(2) * power.rest);
    });
    sums
}

fn point(uv: [f64; 2], w: f64, wavelength_nm: f64) -> Point {
    Point { frequency: uv.map(|u| u / wavelength_nm), s: TAU / wavelength_nm * w, wavelength_nm }
}

fn add(sum: &mut Xyz, weight: Xyz, power: f64) {
    sum.iter_mut().zip(weight).for_each(|(sum, weight)| *sum += weight * power);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::config::{Edge, Windows};
    use diffraction_brdf::direction::wave_vector_change;

    use diffraction_brdf::spectrum::Illuminant;
    use ndarray::Array2;

    /// Transforms that hold a pair's own frequencies, and no others, give the value that those of all frequencies give.
    #[test]
    fn values_do_not_depend_on_the_frequencies_held() {
        let height = |(row, column): (usize, usize)| ((row * 37 + column * 101 + row * column * 13) % 64) as f64 * 2.0;
        let field = HeightField { heights_nm: Array2::from_shape_fn((160, 160), height), pitch_nm: [100.0; 2] };
        let (wi, wo) = ([0.6, 0.0, 0.8], [0.1, -0.3, 0.9f64.sqrt()]);
        let q = wave_vector_change(wi, wo);
        for (edge, windows, sigma_nm) in [
            (Edge::Tile, Windows::Grid, 1_500.0),
            (Edge::Tile, Windows::Centre, 1_500.0),
            (Edge::Fade, Windows::Grid, 800.0),
            // A scan four times as wide as the window, whose lines lie farther apart than the scan's.
            (Edge::Fade, Windows::Centre, 400.0),
        ] {
            let optics = OpticsConfig::ideal(Illuminant::D65, sigma_nm, edge, windows);
            let [low_nm, high_nm] = optics.illuminant.reach_nm(optics.wavelength_nm);
            let own = |axis: usize| {
                let [a, b] = [q[axis] / low_nm, q[axis] / high_nm];
                [a.min(b), a.max(b)]
            };
            let wide = SpectraConfig {
                phase_scale_per_nm: [0.0, 2.0 * TAU / low_nm],
                frequency: [[-2.0 / low_nm, 2.0 / low_nm]; 2],
                tolerance: 1e-6,
                memory_bytes: 1 << 30,
            };
            let narrow = SpectraConfig { frequency: [own(0), own(1)], ..wide };
            assert!(narrow.holds(&optics, q) && !narrow.holds(&optics, q.map(|x| 1.01 * x)));
            let fields = std::slice::from_ref(&field);
            let value = |config: &SpectraConfig| brdf_xyz_batch(fields, &optics, config, &[(wi, wo)]).unwrap()[0];
            assert_eq!(value(&narrow).map(f64::to_bits), value(&wide).map(f64::to_bits), "{edge:?} {windows:?}");
            // One that lacks a line or two of what it reads gives another.
            let [x, y] = narrow.frequency;
            let less = SpectraConfig { frequency: [[x[0] + 0.4 * (x[1] - x[0]), x[1]], y], ..wide };
            assert_ne!(value(&less), value(&wide));
        }
    }
}
