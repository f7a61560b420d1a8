//! A pilot: how many tables a surface needs, found on a few texels before all are computed.

use std::f64::consts::TAU;

use rayon::prelude::*;

use super::build::BuildPlan;
use super::plan::w_reach;
use crate::ground::chebyshev;
use crate::ground::sampling;
use crate::optics::spectra::Spectra;

/// Texels tried; the 95th percentile then rests on about ten errors per value of `t`.
const TEXELS: usize = 160;

/// Values of `t` at which the interpolation in `w` is judged: between and beyond the nodes.
const T_TESTED: [f64; 5] = [0.02, 0.21, 0.47, 0.76, 1.0];

/// Share of the tolerance that the basis may take.
const BASIS_SHARE: f64 = 0.5;

/// The smallest number of nodes in `w` whose interpolation errs by at most half the tolerance of Y in
/// 95 % of the tested directions.
pub fn nodes_for_tolerance(spectra: &Spectra, plan: &BuildPlan, tolerance: f64) -> usize {
    let fine = plan.nodes_bound.max(4);
    let polynomials = luminance_polynomials(spectra, plan, fine);
    (2..fine).find(|&count| basis_error(&polynomials, fine, count, 0.95) <= BASIS_SHARE * tolerance).unwrap_or(fine)
}

/// Luminance of a texel at the Gauss nodes of its ring's reach, and the texel's own share of that reach.
struct Polynomial {
    values: Vec<f64>,
    reach: f64,
}

/// Sums the luminance of the pilot's texels at `fine` nodes of `w`, in double precision.
fn luminance_polynomials(spectra: &Spectra, plan: &BuildPlan, fine: usize) -> Vec<Polynomial> {
    // Deep surfaces have many nodes and lines: fewer texels keep the pilot short beside the build.
    let texels = (TEXELS * 24 / fine.max(24)).max(24);
    (0..texels)
        .into_par_iter()
        .filter_map(|index| {
            let [a, b] = sampling::plane(index);
            // Half of them even over the disc, half towards its centre, where directions crowd near specular.
            let (rho, phi) = (2.0 * if index % 2 == 0 { a.sqrt() } else { a * a }, TAU * b);
            let ring = plan.rings.iter().find(|r| rho >= r.rho[0] && rho < r.rho[1])?;
            let (u, v) = (rho * phi.cos(), rho * phi.sin());
            let nodes = chebyshev::gauss_nodes(fine, 0.0, ring.w_max());
            let mut values = vec![0.0; fine];
            for (&nm, weight) in ring.quadrature.wavelengths_nm.iter().zip(&ring.quadrature.weights) {
                let k = TAU / nm;
                let node_weights: Vec<_> = nodes.iter().map(|w| spectra.node_weights(k * w)).collect();
                let power = spectra.power_at([u / nm, v / nm], &node_weights);
                let scale = weight[1] * (k / nm).powi(2);
                values.iter_mut().zip(power).for_each(|(sum, p)| *sum += scale * p);
            }
            Some(Polynomial { values, reach: w_reach(rho) / ring.w_max().max(f64::MIN_POSITIVE) })
        })
        .collect()
}

/// Quantile of the relative error of `count` nodes against the fine ones.
fn basis_error(polynomials: &[Polynomial], fine: usize, count: usize, quantile: f64) -> f64 {
    let to_coarse: Vec<Vec<f64>> = chebyshev::gauss_nodes(count, 0.0, 1.0)
        .into_iter()
        .map(|x| chebyshev::interpolation_weights(fine, 0.0, 1.0, x))
        .collect();
    let dot = |weights: &[f64], values: &[f64]| weights.iter().zip(values).map(|(w, v)| w * v).sum::<f64>();
    let mut errors: Vec<f64> = polynomials
        .iter()
        .flat_map(|p| {
            let coarse: Vec<f64> = to_coarse.iter().map(|w| dot(w, &p.values)).collect();
            let largest = p.values.iter().copied().fold(0.0, f64::max);
            T_TESTED.into_iter().filter_map(move |t| {
                let x = t * p.reach;
                let exact = dot(&chebyshev::interpolation_weights(fine, 0.0, 1.0, x), &p.values);
                let approximate = dot(&chebyshev::interpolation_weights(count, 0.0, 1.0, x), &coarse);
                // A flat surface has no diffuse part: nothing to be wrong about.
                (largest > 0.0).then(|| (approximate - exact).abs() / exact.abs().max(1e-9 * largest))
            })
        })
        .collect();
    if errors.is_empty() {
        return 0.0;
    }
    errors.sort_by(f64::total_cmp);
    errors[((errors.len() - 1) as f64 * quantile).ceil() as usize]
}
