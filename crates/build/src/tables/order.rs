//! The order estimator: how many nodes in `w` a surface needs, found on a few texels before all are computed.

use std::f64::consts::TAU;
use std::iter::StepBy;
use std::ops::RangeInclusive;

use rayon::prelude::*;

use super::coverage::ranges::Coverage;
use super::coverage::shares;
use super::plan::BuildPlan;
use super::rings::Ring;
use crate::ground::sampling;
use crate::optics::spectra::Spectra;
use crate::optics::spectral::diffuse_power;
use diffraction_brdf::chebyshev::{self, Interpolant};
use diffraction_brdf::direction::max_abs_w;

/// Texels spread over the disc, half as many where there is light, and a quarter as many around the mirror direction;
/// the 95th percentiles then rest on the forty, twenty and ten largest errors.
pub(super) const TEXELS: usize = 160;

/// Places in a range of `w` at which the interpolation is judged: between and beyond the nodes.
pub(super) const PLACES_TESTED: [f64; 5] = [0.02, 0.21, 0.47, 0.76, 1.0];

/// Share of the tolerance that the basis may take where tables answer every direction.
const BASIS_SHARE: f64 = 0.5;

/// Share of what bright places show up to which a place is dark: between isolated orders, where their kernels are cut, no
/// relative error is worth a table. Far below what errors are measured down to: dim places keep the tolerance, too. Where
/// tables are restricted to scenes, bright is what the darkest of them shows: a picture of dark directions alone is exposed
/// for them.
const DARK_SHARE: f64 = 1e-7;

/// Bright is what one place in fifty exceeds.
const BRIGHT: f64 = 0.98;

/// Share of directions whose luminance must keep its share of the tolerance.
const QUANTILE: f64 = 0.95;

/// Numbers of nodes to try, one after the other.
pub(super) type Counts = StepBy<RangeInclusive<usize>>;

/// The luminance of the tried texels as functions of `w`.
pub(super) struct OrderEstimator {
    /// Texels spread evenly; those that get light, since a grating sends its light along one line, which the former miss;
    /// and those around the mirror direction, where pictures are brightest.
    groups: [Vec<Polynomial>; 3],
    tolerance: f64,
    /// Luminance in 1/sr, reflectance and geometry left out, up to which a place counts as dark.
    dark_per_sr: f64,
}

/// A texel to try, with the `|w|` that it is asked for.
type Asked = ([f64; 2], [f64; 2]);

/// Luminance of a texel at fine nodes over a range of `|w|`, and the part of that which it is itself asked for.
struct Polynomial {
    uv: [f64; 2],
    values: Vec<f64>,
    whole: [f64; 2],
    own: [f64; 2],
    /// Its ring, by the radii.
    ring_radius: [f64; 2],
}

impl OrderEstimator {
    /// Sums the luminance of a few texels in double precision.
    pub fn new(spectra: &Spectra, plan: &BuildPlan, tolerance: f64) -> Self {
        let fine = plan.nodes_bound.max(4);
        // Rough surfaces have many nodes and lines: fewer texels keep this short beside the build.
        let texels = (TEXELS * 24 / fine.max(24)).max(24);
        let asked = match &plan.coverage {
            None => texels_of_disc(spectra, plan, texels),
            Some(coverage) => texels_of_coverage(spectra, plan, coverage, texels),
        };
        let groups = asked.map(|texels| polynomials(spectra, plan, &texels));
        let bright_per_sr = match &plan.coverage {
            None => bright_per_sr(&groups, |_| true),
            Some(coverage) => {
                let of_scenes = coverage.exposed_at().map(|is_shown| bright_per_sr(&groups, |p| is_shown(p.uv)));
                of_scenes.reduce(f64::min).unwrap_or(0.0)
            }
        };
        Self { groups, tolerance, dark_per_sr: DARK_SHARE * bright_per_sr }
    }

    /// The smallest number of tables that errs by at most its share of the tolerance of Y in 95 % of the tested directions.
    ///
    /// Where every direction is answered, tables come from as many nodes over the ring's whole reach; else each texel's
    /// own range counts.
    pub fn tables(&self, most: usize, own_ranges: bool) -> usize {
        let over = |p: &Polynomial| if own_ranges { p.own } else { p.whole };
        let (first, share) = if own_ranges { (1, shares::BASIS_SHARE) } else { (2, BASIS_SHARE) };
        self.first_within((first..=most).step_by(1), share, &over, &|_| true)
    }

    /// The smallest number of patches of the cross term, which keep the whole reach whatever is covered: as many as tables
    /// of the lobe's texels would need for every direction.
    pub(crate) fn cross_patches(spectra: &Spectra, plan: &BuildPlan, tolerance: f64) -> usize {
        let whole = [0.0, max_abs_w(0.0)];
        let innermost = plan.rings.iter().min_by(|a, b| a.radius[0].total_cmp(&b.radius[0]));
        let of_texel = |uv: [f64; 2]| {
            let own = [0.0, max_abs_w(uv[0].hypot(uv[1]))];
            Some(polynomial(spectra, innermost?, uv, fine_nodes(plan, whole), whole, own))
        };
        let tried = middle_texels(plan, TEXELS / 4).into_iter().filter_map(of_texel).collect();
        let most = plan.nodes_over(whole);
        Self { groups: [tried, Vec::new(), Vec::new()], tolerance, dark_per_sr: 0.0 }.first_within(
            (2..=most).step_by(1),
            BASIS_SHARE,
            &|p| p.whole,
            &|_| true,
        )
    }

    /// The first of these numbers of nodes over an interval of `|w|` with which the ranges that texels of a ring have in it
    /// err by no more than a share of the tolerance; the last where none does.
    pub(crate) fn ring_nodes(&self, ring: &Ring, interval: [f64; 2], share: f64, counts: Counts) -> usize {
        let inside = |p: &Polynomial| p.ring_radius == ring.radius;
        // A ring without a tried texel is as the others are, each around its own range.
        let any = self.groups.iter().flatten().any(inside);
        let around_own = |p: &Polynomial| {
            let length = interval[1] - interval[0];
            let start = (0.5 * (p.own[0] + p.own[1] - length)).min(p.whole[1] - length).max(p.whole[0]);
            [start.min(p.own[0]), (start + length).min(p.whole[1]).max(p.own[1])]
        };
        let over = |p: &Polynomial| if any { interval } else { around_own(p) };
        self.first_within(counts, share, &over, &|p| !any || inside(p))
    }

    fn first_within(
        &self,
        counts: Counts,
        share: f64,
        over: &dyn Fn(&Polynomial) -> [f64; 2],
        counted: &dyn Fn(&Polynomial) -> bool,
    ) -> usize {
        let error = |nodes: usize| {
            let errors = self.groups.iter().map(|group| {
                let tried = group.iter().filter(|p| counted(p));
                quantile(tried.flat_map(|p| p.errors(nodes, over(p), self.dark_per_sr)).collect())
            });
            errors.fold(0.0, f64::max)
        };
        let last = counts.clone().last().unwrap_or(1);
        let mut counts = counts.filter(|&nodes| nodes != last);
        counts.find(|&nodes| error(nodes) <= share * self.tolerance).unwrap_or(last)
    }
}

impl Polynomial {
    /// Relative errors over the texel's own range of interpolation from `count` nodes over a range.
    /// Places darker than `dark_per_sr` are left out.
    fn errors(&self, count: usize, over: [f64; 2], dark_per_sr: f64) -> Vec<f64> {
        let fine = Interpolant::new(self.values.len(), self.whole[0], self.whole[1]);
        let at = |w: f64| dot(&fine.weights(w), &self.values);
        let coarse = Interpolant::new(count, over[0], over[1]);
        let nodes: Vec<f64> = coarse.nodes().iter().map(|&w| at(w)).collect();
        let largest = self.values.iter().copied().fold(0.0, f64::max);
        // A flat surface has no diffuse part: nothing to be wrong about.
        let places = PLACES_TESTED.into_iter().filter(|_| largest > 0.0);
        let error = |place: f64| {
            let w = self.own[0] + place * (self.own[1] - self.own[0]);
            let exact = at(w);
            let error = (dot(&coarse.weights(w), &nodes) - exact).abs() / exact.abs().max(1e-9 * largest);
            (exact >= dark_per_sr).then_some(error)
        };
        places.filter_map(error).collect()
    }
}

fn dot(weights: &[f64], values: &[f64]) -> f64 {
    weights.iter().zip(values).map(|(w, v)| w * v).sum()
}

pub(super) fn quantile(errors: Vec<f64>) -> f64 {
    quantile_at(errors, QUANTILE)
}

/// The value below which a share of them lies; 0 for none.
fn quantile_at(mut values: Vec<f64>, share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let last = values.len().saturating_sub(1);
    values.get((last as f64 * share).ceil() as usize).copied().unwrap_or(0.0)
}

/// What bright places show of those tried texels that count; 0 for none.
fn bright_per_sr(groups: &[Vec<Polynomial>], counts: impl Fn(&Polynomial) -> bool) -> f64 {
    let counted = groups.iter().flatten().filter(|texel| counts(texel));
    quantile_at(counted.flat_map(|texel| texel.values.iter().copied()).collect(), BRIGHT)
}

/// The texels to try where all directions count.
fn texels_of_disc(spectra: &Spectra, plan: &BuildPlan, count: usize) -> [Vec<Asked>; 3] {
    let asked = |uv: [f64; 2]| (uv, [0.0, max_abs_w(uv[0].hypot(uv[1]))]);
    let all = [spread_texels(count), bright_texels(spectra, plan, count / 2), middle_texels(plan, count / 4)];
    all.map(|texels| texels.into_iter().filter(|uv| uv[0].hypot(uv[1]) < 2.0).map(asked).collect())
}

/// The texels to try of a coverage.
fn texels_of_coverage(spectra: &Spectra, plan: &BuildPlan, coverage: &Coverage, count: usize) -> [Vec<Asked>; 3] {
    let grid = &coverage.grid;
    let at = |(row, column, t)| ([grid.u(column), grid.v(row)], coverage.abs_w_at(row, column, t));
    let covered: Vec<Asked> = coverage.iter().map(at).collect();
    let drawn = |index: usize| covered[(sampling::plane(index)[0] * covered.len() as f64) as usize];
    let asked = |uv: [f64; 2]| coverage.abs_w_near(uv).map(|abs_w| (uv, abs_w));
    let bright = bright_texels(spectra, plan, count * 4).into_iter().filter_map(asked).take(count / 2);
    let middle = middle_texels(plan, count / 4).into_iter().filter_map(asked);
    [(0..count.min(covered.len())).map(drawn).collect(), bright.collect(), middle.collect()]
}

/// Texels `(u, v)`: half of them even over the disc, half towards its centre, where directions crowd near
/// specular.
pub(super) fn spread_texels(count: usize) -> Vec<[f64; 2]> {
    (0..count)
        .map(|index| {
            let [a, b] = sampling::plane(index);
            let (radius, phi) = (2.0 * if index % 2 == 0 { a.sqrt() } else { a * a }, TAU * b);
            [radius * phi.cos(), radius * phi.sin()]
        })
        .collect()
}

/// Texels even over the inner half of the coherent lobe, as wide as it looks.
fn middle_texels(plan: &BuildPlan, count: usize) -> Vec<[f64; 2]> {
    let radius = 0.5 * plan.lobe_radius;
    let at = |[a, b]: [f64; 2]| [radius * a.sqrt() * (TAU * b).cos(), radius * a.sqrt() * (TAU * b).sin()];
    (0..count).map(|index| at(sampling::plane(index))).collect()
}

/// Share of the brightest line's power up to which a line is below the floor.
pub(super) const FLOOR_SHARE: f64 = 1e-4;

/// Texels drawn evenly from the lines above the floor at the middle node, each at one of the wavelengths.
fn bright_texels(spectra: &Spectra, plan: &BuildPlan, count: usize) -> Vec<[f64; 2]> {
    let power: Vec<f32> =
        spectra.data.iter().skip(spectra.nodes / 2).step_by(spectra.nodes).map(|e| e.norm_sqr()).collect();
    let floor = FLOOR_SHARE * f64::from(power.iter().copied().fold(0.0, f32::max));
    let bright: Vec<usize> = (0..power.len()).filter(|&line| f64::from(power[line]) > floor).collect();
    let wavelengths = &plan.rings[0].quadrature.wavelengths_nm;
    let drawn = if bright.is_empty() { 0 } else { count };
    (0..drawn)
        .map(|index| {
            let [a, b] = sampling::plane(index);
            let line = bright[(a * bright.len() as f64) as usize];
            let nm = wavelengths[(b * wavelengths.len() as f64) as usize];
            let at = [line % spectra.lines[0], line / spectra.lines[0]];
            [0, 1].map(|axis| f64::from(spectra.first[axis] + at[axis] as i32) * spectra.step[axis] * nm)
        })
        .collect()
}

/// Sums the luminance of texels, each given with its own range of `|w|`, at fine nodes over all that nodes of their rings
/// may span.
fn polynomials(spectra: &Spectra, plan: &BuildPlan, texels: &[Asked]) -> Vec<Polynomial> {
    texels
        .par_iter()
        .filter_map(|&([u, v], own)| {
            let ring = plan.ring_at(u.hypot(v))?;
            let whole = plan.abs_w_within(ring);
            let fine = match plan.coverage {
                None => plan.nodes_bound.max(4),
                Some(_) => fine_nodes(plan, whole),
            };
            Some(polynomial(spectra, ring, [u, v], fine, whole, own))
        })
        .collect()
}

/// Sums the luminance of a texel at fine nodes over a range of `|w|` that holds its own.
fn polynomial(spectra: &Spectra, ring: &Ring, uv: [f64; 2], fine: usize, whole: [f64; 2], own: [f64; 2]) -> Polynomial {
    let nodes = chebyshev::gauss_nodes(fine, whole[0], whole[1]);
    let xyz = diffuse_power(spectra, &ring.quadrature, uv, &nodes);
    let values = xyz.into_iter().map(|xyz| xyz[1]).collect();
    Polynomial { uv, values, whole, own: [own[0].max(whole[0]), own[1].min(whole[1])], ring_radius: ring.radius }
}

/// Nodes over a range of `|w|` that leave nothing to be seen between them.
fn fine_nodes(plan: &BuildPlan, abs_w: [f64; 2]) -> usize {
    plan.nodes_over(abs_w).max(4)
}
