//! A pilot: how many tables a surface needs, found on a few texels before all are computed.

use std::f64::consts::TAU;

use rayon::prelude::*;

use super::build::BuildPlan;
use super::plan::w_reach;
use crate::ground::chebyshev;
use crate::ground::sampling;
use crate::optics::spectra::Spectra;

/// Texels spread over the disc, and half as many where there is light; the 95th percentiles then rest on
/// the forty and the twenty largest errors.
pub const TEXELS: usize = 160;

/// Values of `t` at which the interpolation in `w` is judged: between and beyond the nodes.
const T_TESTED: [f64; 5] = [0.02, 0.21, 0.47, 0.76, 1.0];

/// Share of the tolerance that the basis may take.
const BASIS_SHARE: f64 = 0.5;

/// The smallest number of nodes in `w` whose interpolation errs by at most half the tolerance of Y in
/// 95 % of the tested directions: of those spread over the whole disc, and again of those that get light. A
/// grating sends its light along one line, which the former miss.
pub fn nodes_for_tolerance(spectra: &Spectra, plan: &BuildPlan, tolerance: f64) -> usize {
    let fine = plan.nodes_bound.max(4);
    // Deep surfaces have many nodes and lines: fewer texels keep the pilot short beside the build.
    let texels = (TEXELS * 24 / fine.max(24)).max(24);
    let groups = [spread_texels(texels), lit_texels(spectra, plan, texels / 2)]
        .map(|texels| luminance_polynomials(spectra, plan, fine, &texels));
    let error = |count: usize| groups.iter().map(|group| basis_error(group, fine, count, 0.95)).fold(0.0, f64::max);
    (2..fine).find(|&count| error(count) <= BASIS_SHARE * tolerance).unwrap_or(fine)
}

/// Texels `(u, v)`: half of them even over the disc, half towards its centre, where directions crowd near
/// specular.
fn spread_texels(count: usize) -> Vec<[f64; 2]> {
    (0..count)
        .map(|index| {
            let [a, b] = sampling::plane(index);
            let (rho, phi) = (2.0 * if index % 2 == 0 { a.sqrt() } else { a * a }, TAU * b);
            [rho * phi.cos(), rho * phi.sin()]
        })
        .collect()
}

/// Share of the brightest line's power from which on a line counts as lit.
const LIT: f64 = 1e-4;

/// Texels drawn evenly from the lit lines at the middle node, each at one of the wavelengths.
fn lit_texels(spectra: &Spectra, plan: &BuildPlan, count: usize) -> Vec<[f64; 2]> {
    let power: Vec<f32> =
        spectra.data.iter().skip(spectra.nodes / 2).step_by(spectra.nodes).map(|e| e.norm_sqr()).collect();
    let floor = LIT * f64::from(power.iter().copied().fold(0.0, f32::max));
    let lit: Vec<usize> = (0..power.len()).filter(|&line| f64::from(power[line]) > floor).collect();
    let wavelengths = &plan.rings[0].quadrature.wavelengths_nm;
    let drawn = if lit.is_empty() { 0 } else { count };
    (0..drawn)
        .map(|index| {
            let [a, b] = sampling::plane(index);
            let line = lit[(a * lit.len() as f64) as usize];
            let nm = wavelengths[(b * wavelengths.len() as f64) as usize];
            let at = [line % spectra.lines[0], line / spectra.lines[0]];
            [0, 1].map(|axis| f64::from(spectra.first[axis] + at[axis] as i32) * spectra.step[axis] * nm)
        })
        .collect()
}

/// Luminance of a texel at the Gauss nodes of its ring's reach, and the texel's own share of that reach.
struct Polynomial {
    values: Vec<f64>,
    reach: f64,
}

/// Sums the luminance of the texels within the disc at `fine` nodes of `w`, in double precision.
fn luminance_polynomials(spectra: &Spectra, plan: &BuildPlan, fine: usize, texels: &[[f64; 2]]) -> Vec<Polynomial> {
    texels
        .par_iter()
        .filter_map(|&[u, v]| {
            let rho = u.hypot(v);
            let ring = plan.rings.iter().find(|r| rho < 2.0 && rho >= r.rho[0] && rho < r.rho[1])?;
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
