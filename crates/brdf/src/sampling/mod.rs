//! Importance sampling: directions to the light, given that to the viewer, by a mixture of three densities.
//!
//! - The **lobe** ([`lobe`]): over the part of the coherent lobe that lies above the horizon, in proportion to what it
//!   reflects, so that no sample is lost below the surface however grazing the viewer.
//! - The **tables** ([`tables`]): cells of the (u, v) grid in proportion to the tables, over the disc of (u, v) that is above
//!   the horizon for this viewer.
//! - The **remainder**: evenly over solid angle. The BRDF times the cosine is finite at the horizon of `wi`, and so
//!   is its ratio to an even density, where densities that are even in (u, v) fall to 0 with the cosine.
//!
//! How much lobe and tables reflect, and the tables' mean over azimuth and `|w|`, are prepared for [`NODES`] polar angles of
//! the viewer; the nearest one is used. Any choice of these leaves densities exact, only less alike the BRDF.
//!
//! # A bound on the weights
//!
//! A weight is `f cos_theta_i / p` with `p >= share_even / 2π + share_lobe p_lobe`. With `f = front (lobe + tables)`,
//! `front <= |q|⁴ / (4 cos_i cos_o)`, `|q|² = r² + w²` at the radius `r` in (u, v), and `|w| <= cos_o + sqrt(1 - (sin_o - r)²)`:
//!
//! - tables: at most `2π / share_even · max over r of |q|⁴ / (4 cos_o) · Σ_n |table_n|(r)`, since Chebyshev polynomials stay
//!   in [-1, 1] and look-ups between texels below the largest of them. The cross term likewise, over `|w| >= cos_o`;
//! - lobe: the same with `coherent(r) / w²`; or, where lower, what drawing from it gives. A strip at `y` is drawn with
//!   the density `P(y)`, and a cell in it in proportion to the larger value at its ends: the weight is at most the strip's
//!   integral over `share_lobe P(y)`, times [`WITHIN_CELL`] for what the lobe may rise between the ends.

mod lobe;
mod tables;

use std::f64::consts::TAU;

use crate::direction::Vec3;
use crate::front_factor::FrontFactor;
use crate::table_set::{Basis, TableSet};
use lobe::LobeDensity;
use tables::TableDensity;

/// Polar angles of the viewer for which densities are prepared: `cos = ((k + 1/2) / NODES)²`, dense at grazing ones.
const NODES: usize = 8;
/// Share of the samples that are even over solid angle.
const EVEN_SHARE: f64 = 0.1;
/// Lobe and tables get at least this share of the rest.
const SHARE_MIN: f64 = 0.05;
/// How far the lobe may rise above the larger value at the ends of a cell.
const WITHIN_CELL: f64 = 1.25;
/// Rings of radius in (u, v) for which largest values are kept.
const RINGS: usize = 256;

/// Shares of the samples at one polar angle of the viewer.
#[derive(Debug, Clone, Copy)]
struct Shares {
    even: f64,
    lobe: f64,
    tables: f64,
}

/// What sampling needs beside the tables.
#[derive(Debug, Clone)]
pub(crate) struct Sampler {
    lobe: Option<LobeDensity>,
    tables: TableDensity,
    shares: [Shares; NODES],
    largest: Largest,
}

/// Largest values within rings of the radius in (u, v), from 0 to 2; each ring knows its neighbours' too.
#[derive(Debug, Clone)]
struct Largest {
    tables: Vec<f64>,
    coherent: Vec<f64>,
    cross: f64,
    taylor: bool,
}

/// Cosine of the viewer's polar angle at a node.
fn node_cosine(node: usize) -> f64 {
    ((node as f64 + 0.5) / NODES as f64).powi(2)
}

/// The node for a viewer.
fn node_of(cos_o: f64) -> usize {
    ((NODES as f64 * cos_o.sqrt()) as usize).min(NODES - 1)
}

impl Sampler {
    pub fn new(set: &TableSet) -> Self {
        let lobe = set.lobe.as_ref().map(|lobe| LobeDensity::new(lobe, set.front_factor));
        let tables = TableDensity::new(set);
        let shares = std::array::from_fn(|node| {
            let reflected = lobe.as_ref().map_or(0.0, |lobe| lobe.reflected(node));
            shares(reflected, tables.reflected(node))
        });
        Self { lobe, tables, shares, largest: Largest::new(set) }
    }

    /// A direction to the light; `None` where the viewer is not above the surface, or nothing was found to draw.
    pub fn sample(&self, wo: Vec3, [choice, u1, u2]: [f64; 3]) -> Option<Vec3> {
        if !is_above(wo) {
            return None;
        }
        let node = node_of(wo[2]);
        let Shares { even, lobe, .. } = self.shares[node];
        let wi = if choice < even {
            let (sin, cos) = (TAU * u2).sin_cos();
            let radius = (1.0 - u1 * u1).sqrt();
            [radius * cos, radius * sin, u1]
        } else if choice < even + lobe {
            self.lobe.as_ref()?.sample(node, wo, [u1, u2])?
        } else {
            self.tables.sample(node, wo, [u1, u2])?
        };
        (wi[2] > 0.0).then_some(wi)
    }

    /// Density of [`Self::sample`] in 1/sr.
    pub fn pdf(&self, wi: Vec3, wo: Vec3) -> f64 {
        if !(is_above(wo) && is_above(wi)) {
            return 0.0;
        }
        let node = node_of(wo[2]);
        let shares = self.shares[node];
        let lobe = self.lobe.as_ref().map_or(0.0, |lobe| shares.lobe * lobe.pdf(node, wi, wo));
        shares.even / TAU + lobe + shares.tables * self.tables.pdf(node, wi, wo)
    }

    /// See the top of this file.
    pub fn weight_bound(&self, wo: Vec3) -> f64 {
        if !is_above(wo) {
            return 0.0;
        }
        let (cos_o, sin_o) = (wo[2], wo[0].hypot(wo[1]));
        let shares = self.shares[node_of(cos_o)];
        let (mut tables, mut coherent) = (0f64, 0f64);
        for ring in 0..RINGS {
            let width = 2.0 / RINGS as f64;
            let [inner, outer] = [ring as f64 * width, (ring + 1) as f64 * width];
            let nearest = (sin_o - sin_o.clamp(inner, outer)).abs();
            if nearest >= 1.0 {
                continue;
            }
            let w_max = cos_o + (1.0 - nearest * nearest).sqrt();
            let q4 = |w: f64| (outer * outer + w * w).min(4.0).powi(2) / (4.0 * cos_o);
            let power = if self.largest.taylor { 1.0 / (cos_o * cos_o) } else { 1.0 };
            tables = tables.max(q4(w_max) * (self.largest.tables[ring] * power + self.largest.cross / cos_o));
            // q⁴ / w² has no maximum between the ends of w.
            let ends = (q4(cos_o) / (cos_o * cos_o)).max(q4(w_max) / (w_max * w_max));
            coherent = coherent.max(ends * self.largest.coherent[ring]);
        }
        let even = TAU / shares.even;
        let drawn = self.lobe.as_ref().map_or(0.0, |lobe| lobe.largest_ratio(node_of(cos_o), wo) / shares.lobe);
        even * tables + (even * coherent).min(WITHIN_CELL * drawn)
    }
}

fn is_above(direction: Vec3) -> bool {
    direction[2] > 0.0 && direction.iter().all(|component| component.is_finite())
}

/// Shares in proportion to what lobe and tables reflect.
fn shares(lobe: f64, tables: f64) -> Shares {
    let rest = 1.0 - EVEN_SHARE;
    match (lobe > 0.0, tables > 0.0) {
        (false, false) => Shares { even: 1.0, lobe: 0.0, tables: 0.0 },
        (true, false) => Shares { even: EVEN_SHARE, lobe: rest, tables: 0.0 },
        (false, true) => Shares { even: EVEN_SHARE, lobe: 0.0, tables: rest },
        (true, true) => {
            let share = (lobe / (lobe + tables)).clamp(SHARE_MIN, 1.0 - SHARE_MIN);
            Shares { even: EVEN_SHARE, lobe: rest * share, tables: rest * (1.0 - share) }
        }
    }
}

impl Largest {
    fn new(set: &TableSet) -> Self {
        let mut largest = Self {
            tables: vec![0.0; RINGS],
            coherent: vec![0.0; RINGS],
            cross: 0.0,
            taylor: set.basis == Basis::Taylor,
        };
        let (rows, columns, _) = set.tables[0].dim();
        let size = set.size();
        let first = set.served.as_ref().map_or([0; 2], |served| served.first);
        let step = 4.0 / (size - 1) as f64;
        // A texel counts within the reach of its own look-ups.
        let mut note = |row: usize, column: usize| {
            let [u, v] = [-2.0 + step * (first[1] + column) as f64, 2.0 - step * (first[0] + row) as f64];
            let weight = |n: usize| if set.basis == Basis::Taylor { 2f64.powi(n as i32) } else { 1.0 };
            let sum = (0..3).map(|channel| {
                let tables = set.tables.iter().enumerate();
                tables.map(|(n, table)| weight(n) * f64::from(table[[row, column, channel]].abs())).sum::<f64>()
            });
            raise(&mut largest.tables, u.hypot(v), 1.5 * step, sum.fold(0.0, f64::max));
        };
        for row in 0..rows {
            for column in 0..columns {
                note(row, column);
            }
        }
        if let Some(lobe) = &set.lobe {
            let step = lobe.radius_max / (lobe.coherent.dim().1 - 1) as f64;
            for ((_, column, _), value) in lobe.coherent.indexed_iter() {
                raise(&mut largest.coherent, step * column as f64, step, f64::from(value.abs()));
            }
            let peak = |patch: &ndarray::Array3<f32>| patch.iter().fold(0f64, |peak, v| peak.max(f64::from(v.abs())));
            largest.cross = lobe.cross.iter().map(peak).sum();
        }
        largest
    }
}

/// Raises the rings that lie within `reach` of a radius.
fn raise(rings: &mut [f64], radius: f64, reach: f64, value: f64) {
    let ring = |radius: f64| ((radius.max(0.0) * 0.5 * RINGS as f64) as usize).min(RINGS - 1);
    for largest in &mut rings[ring(radius - reach)..=ring(radius + reach)] {
        *largest = largest.max(value);
    }
}

/// The front factor of a viewer at `cos_o`, times the light's cosine, as the lobe's shape sees it: `R |q|⁴ / (4 cos_o)` with
/// the reflectance taken from mirrored directions.
#[derive(Debug, Clone)]
struct Reflectance(Vec<f64>);

impl Reflectance {
    fn new(front_factor: FrontFactor) -> Self {
        let at = |k: usize| {
            let cos: f64 = (k as f64 / 64.0).max(0.01);
            let sin = (1.0 - cos * cos).sqrt();
            // 1 + wi.wo = 2 cos², so that the geometry factor is 4 cos².
            front_factor.diffuse([sin, 0.0, cos], [-sin, 0.0, cos]) / (4.0 * cos * cos)
        };
        Self((0..=64).map(at).collect())
    }

    /// `R |q|⁴ / (4 cos_o)`.
    fn times_geometry(&self, q2: f64, cos_o: f64) -> f64 {
        let at = (0.5 * q2.sqrt()).min(1.0) * 64.0;
        let first = (at as usize).min(63);
        let share = at - first as f64;
        ((1.0 - share) * self.0[first] + share * self.0[first + 1]) * q2 * q2 / (4.0 * cos_o)
    }
}

/// Chooses one of `range` with probabilities in proportion to `mass`, all alike where there is none: the index, its
/// probability, and what is left of the number `u` in [0, 1).
fn choose(range: std::ops::Range<usize>, u: f64, mass: impl Fn(usize) -> f64) -> (usize, f64, f64) {
    let total: f64 = range.clone().map(&mass).sum();
    if !(total > 0.0) {
        let at = u * range.len() as f64;
        let index = (at as usize).min(range.len() - 1);
        return (range.start + index, 1.0 / range.len() as f64, (at - index as f64).min(1.0));
    }
    let (target, mut below) = (u * total, 0.0);
    let mut last = (range.start, 0.0, 0.0);
    for index in range {
        let here = mass(index);
        if here > 0.0 {
            last = (index, here, below);
            if target < below + here {
                break;
            }
        }
        below += here;
    }
    let (index, here, below) = last;
    (index, here / total, ((target - below) / here).clamp(0.0, 1.0))
}

/// The probability with which [`choose`] takes `index`.
fn probability(range: std::ops::Range<usize>, index: usize, mass: impl Fn(usize) -> f64) -> f64 {
    let total: f64 = range.clone().map(&mass).sum();
    if total > 0.0 { mass(index) / total } else { 1.0 / range.len() as f64 }
}
