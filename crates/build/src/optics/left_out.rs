//! What the references leave out in the dark, where the windows' kernels end.
//!
//! Under the mean over all window positions each line of the repeated scan is a Gaussian in frequency, and both references,
//! the one from the transforms and the direct sum, read the lines within 5.5 of its deviations along each axis: beyond, a
//! line has less than `exp(-5.5²/2)` = 2.7e-7 of its peak left. So between the orders of a grating they return less than the
//! surface sends there, and where no line is in reach nothing. How much that is has a bound without any line in it:
//!
//! 1. A line of the diffuse part has the peak `4πσ² |E|²`, in nm² over `s²`, `s = 2π|w|/λ`.
//! 2. All lines together have `Σ |E|² <= Var(h)`: by Parseval's theorem `s² Σ |E|²` is the mean of `|exp(ish) - c|²`, that is
//!    `1 - |c|²`, and `1 - cos(x) <= x²/2` over all pairs of heights makes that at most `s² Var(h)`.
//! 3. So the lines out of reach add at most `2.7e-7 · 4πσ² s² Var(h)`, whatever their number.
//!
//! The coherent lobe ends where 1e-9 of its peak `4πσ²` is left, of the lobe and of its image each. For windows that stand
//! on the scan amplitudes are cut, and powers are off by the square of 3e-6: nothing beside this.

use std::f64::consts::{PI, TAU};

use rayon::prelude::*;

use super::config::{Edge, OpticsConfig, Windows};
use super::factors::PairFactors;
use super::kernel::gaussian_end;
use super::spectra::LOBE_LEAST;
use crate::height::HeightField;
use diffraction_brdf::direction::Vec3;
use diffraction_brdf::error::Result;
use diffraction_brdf::spectrum::uniform_wavenumbers;

/// Wavelengths over which the bound, a smooth function, is summed.
const WAVELENGTHS: usize = 32;

/// Most of the luminous BRDF in 1/sr that the references leave out at any of these pairs of directions; `None` where windows
/// stand on the scan.
///
/// # Errors
/// `Error::Call` if the light is invisible.
pub fn left_out_per_sr(fields: &[HeightField], optics: &OpticsConfig, pairs: &[(Vec3, Vec3)]) -> Result<Option<f64>> {
    if optics.edge == Edge::Fade || optics.windows == Windows::Centre {
        return Ok(None);
    }
    let variance_nm2 = fields.iter().map(variance_nm2).fold(0.0, f64::max);
    let quadrature = uniform_wavenumbers(&optics.illuminant, optics.wavelength_nm, WAVELENGTHS)?;
    let of_pair = |&(wi, wo): &(Vec3, Vec3)| {
        let Some(factors) = PairFactors::of(optics, wi, wo) else { return 0.0 };
        let at = |nm: f64| {
            let peak_nm2 = |sigma_nm: f64| 4.0 * PI * sigma_nm * sigma_nm;
            let s = TAU * factors.q[2] / nm;
            let rest = gaussian_end() * peak_nm2(optics.body_coherence().sigma_nm_at(nm)) * s * s * variance_nm2;
            let lobes = if factors.image_radius.is_some() { 2.0 } else { 1.0 };
            let lobe = lobes * LOBE_LEAST * peak_nm2(optics.lobe_coherence().sigma_nm_at(nm));
            factors.brdf(nm, rest, lobe)
        };
        quadrature.wavelengths_nm.iter().zip(&quadrature.weights).map(|(nm, weight)| weight[1] * at(*nm)).sum::<f64>()
    };
    Ok(pairs.par_iter().map(of_pair).reduce_with(f64::max))
}

/// Mean square of the heights about their mean.
fn variance_nm2(field: &HeightField) -> f64 {
    let count = field.heights_nm.len().max(1) as f64;
    let mean = field.heights_nm.sum() / count;
    field.heights_nm.iter().map(|h| (h - mean).powi(2)).sum::<f64>() / count
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::spectra::SpectraConfig;
    use crate::optics::{reference, spectral};
    use diffraction_brdf::direction::from_angles_deg;
    use diffraction_brdf::spectrum::{Illuminant, Line};
    use ndarray::Array2;

    const NM: f64 = 550.0;
    const PERIOD_NM: f64 = 1_600.0;
    const AMPLITUDE_NM: f64 = 12.0;
    const SIGMA_NM: f64 = 3_000.0;

    /// A shallow grating under a laser: two lines have nearly all of what is not in the lobe.
    fn grating() -> (HeightField, OpticsConfig) {
        let height = |(_, column)| AMPLITUDE_NM * (TAU * column as f64 / 32.0).cos();
        let field =
            HeightField { heights_nm: Array2::from_shape_fn((1, 32), height), pitch_nm: [PERIOD_NM / 32.0, 1_000.0] };
        let light = Illuminant::Lines(vec![Line { wavelength_nm: NM, power: 1.0 }]);
        (field, OpticsConfig::ideal(light, SIGMA_NM, Edge::Tile, Windows::Grid))
    }

    /// `J_m(x)` by its integral.
    fn bessel(m: i32, x: f64) -> f64 {
        let at = |i: i32| (f64::from(m) * (f64::from(i) + 0.5) * PI / 200.0, (f64::from(i) + 0.5) * PI / 200.0);
        (0..200).map(|i| (at(i).0 - x * at(i).1.sin()).cos()).sum::<f64>() / 200.0
    }

    /// The BRDF with every Gaussian of every order, wherever it ends.
    fn closed_form(optics: &OpticsConfig, (wi, wo): (Vec3, Vec3)) -> f64 {
        let factors = PairFactors::of(optics, wi, wo).unwrap();
        let [u, v, w] = factors.q;
        let of_order = |m: i32| {
            let distance2 = (u - f64::from(m) * NM / PERIOD_NM).powi(2) + v * v;
            let shape = (-(TAU * SIGMA_NM / NM).powi(2) * distance2).exp();
            4.0 * PI * SIGMA_NM * SIGMA_NM * shape * bessel(m, TAU / NM * w * AMPLITUDE_NM).powi(2)
        };
        let rest: f64 = [-2, -1, 1, 2].map(of_order).iter().sum();
        factors.brdf(NM, rest, of_order(0))
    }

    #[test]
    fn between_orders_both_references_miss_no_more_than_the_bound() {
        let (field, optics) = grating();
        let deviation = NM / (TAU * std::f64::consts::SQRT_2 * SIGMA_NM);
        let config = SpectraConfig {
            phase_scale_per_nm: [0.0, 2.0 * TAU / NM],
            frequency: [[-2.0 / NM, 2.0 / NM]; 2],
            tolerance: 1e-9,
            memory_bytes: 1 << 30,
        };
        let fields = std::slice::from_ref(&field);
        for theta_i_deg in [0.0, 40.0, 75.0] {
            let wi = from_angles_deg(theta_i_deg, 0.0);
            let mut shares = [0.0f64; 2];
            for step in 0..60 {
                // Across the first order, past where its kernel ends.
                let v = deviation * (4.5 + 0.05 * f64::from(step));
                let [x, y] = [NM / PERIOD_NM - wi[0], -v];
                let pair = (wi, [x, y, (1.0 - x * x - y * y).sqrt()]);
                let truth = closed_form(&optics, pair);
                let fast = spectral::brdf_xyz_batch(fields, &optics, &config, &[pair]).unwrap()[0][1];
                let direct = reference::brdf_xyz(fields, &optics, pair.0, pair.1).unwrap()[1];
                let bound = left_out_per_sr(fields, &optics, &[pair]).unwrap().unwrap();
                for (share, found) in shares.iter_mut().zip([fast, direct]) {
                    // What rounding to 32 bits of a value that is not left out errs by is no part of the bound.
                    let missed = (truth - found - 1e-5 * truth) / bound;
                    *share = share.max(missed);
                }
            }
            println!("{theta_i_deg} degrees: {shares:?} of the bound are missed");
            // Half of the power is in that order, its kernel ends at the bound, and nothing is read beyond.
            assert!(shares.iter().all(|share| (0.2..1.0).contains(share)), "{theta_i_deg}: {shares:?}");
        }
    }

    #[test]
    fn windows_on_the_scan_have_no_such_end() {
        let (field, optics) = grating();
        let fields = std::slice::from_ref(&field);
        let pair = [([0.0, 0.0, 1.0], [0.0, 0.6, 0.8])];
        let centre = OpticsConfig { windows: Windows::Centre, ..optics.clone() };
        assert_eq!(left_out_per_sr(fields, &centre, &pair).unwrap(), None);
        let known = left_out_per_sr(fields, &optics, &pair).unwrap().unwrap();
        // As the height's variance; what the lobe leaves out stays.
        let double = HeightField { heights_nm: 2.0 * &field.heights_nm, ..field.clone() };
        let lobe =
            left_out_per_sr(&[HeightField { heights_nm: 0.0 * &field.heights_nm, ..field.clone() }], &optics, &pair);
        let lobe = lobe.unwrap().unwrap();
        let of_double = left_out_per_sr(&[double], &optics, &pair).unwrap().unwrap();
        assert!(lobe > 0.0 && ((of_double - lobe) / (known - lobe) - 4.0).abs() < 1e-9, "{known} {of_double} {lobe}");
    }
}
