//! Importance sampling: directions to the light, given that to the viewer, by a mixture of three densities.
//!
//! - The **lobe** ([`lobe`]): over the part of the coherent lobe that lies above the horizon, in proportion to what it
//!   reflects, so that no sample is lost below the surface however grazing the viewer.
//! - The **tables** ([`tables`]): cells of the (u, v) grid in proportion to the tables, over the disc of (u, v) that is above
//!   the horizon for this viewer.
//! - The **remainder**: evenly over solid angle, so that nothing the other two underrate has an unbounded weight.
//!
//! All three are densities over solid angle. The BRDF grows without bound as `wi` nears the horizon, but its product with the
//! cosine stays finite, and so does its ratio to such a density; one that is even in (u, v) would fall to 0 with the cosine.
//!
//! How much lobe and tables reflect, and the tables' mean over azimuth and `|w|`, are prepared for [`nodes::NODES`] polar angles of
//! the viewer; the nearest one is used. Any choice of these leaves densities exact, only less alike the BRDF.
//!
//! # A bound on the weights
//!
//! A weight is `f cos_theta_i / p` with `p >= share_even / 2π + share_lobe p_lobe`, and
//! `f = diffuse (tables + cross / |w|) + coherent lobe` with front factors that do not depend on the tables. Both
//! factors times `cos_theta_i` are finite; [`FRONT_SLACK`] is what they may rise between the directions at which they are
//! looked at. So, ring by ring of the radius in (u, v):
//!
//! - tables: at most `2π / share_even · diffuse cos_theta_i · Σ_n |table_n|`, since Chebyshev polynomials stay
//!   in [-1, 1] and look-ups between texels below the largest of them; the cross term likewise, with `|w| >= cos_o`;
//! - lobe: the same with its own factor and table; or, where lower, what drawing from it gives. A strip at `y` is drawn
//!   with the density `P(y)`, and a cell in it in proportion to the larger value at its ends: the weight is at most the
//!   strip's integral over `share_lobe P(y)`, times [`WITHIN_CELL`] for what the lobe may rise between the ends.
//!
//! It is loose where orders are sharp, whose largest value it takes for the whole hemisphere: weights of the bundled specimens stay
//! below 40 times the directional albedo at any angle.

mod choice;
mod image;
mod lobe;
mod nodes;
mod tables;

use std::f64::consts::{PI, TAU};

use crate::direction::Vec3;
use crate::front_factor::{Factor, FrontFactor};
use crate::table_set::{Basis, TableSet};
pub(crate) use image::NumbersForShaders;
use lobe::LobeDensity;
use nodes::{NODES, node_of};
use tables::TableDensity;

/// Share of the samples that are even over solid angle.
const EVEN_SHARE: f64 = 0.1;
/// Lobe and tables get at least this share of the rest.
const SHARE_MIN: f64 = 0.05;
/// How far the lobe may rise above the larger value at the ends of a cell.
const WITHIN_CELL: f64 = 1.25;
/// How far front factors may rise between the directions at which the bound looks at them.
const FRONT_SLACK: f64 = 1.25;
/// Azimuths at which it does, within half a circle.
const FRONT_AZIMUTHS: usize = 24;
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
    front_factor: FrontFactor,
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

impl Sampler {
    pub fn new(set: &TableSet) -> Self {
        Self::coarse(set, usize::MAX)
    }

    /// With no more than so many cells of tables side by side.
    pub fn coarse(set: &TableSet, cells_max: usize) -> Self {
        let lobe = set.lobe.as_ref().map(|lobe| LobeDensity::new(lobe, set.front_factor));
        let tables = TableDensity::new(set, cells_max);
        let shares = std::array::from_fn(|node| {
            let reflected = lobe.as_ref().map_or(0.0, |lobe| lobe.reflected(node));
            shares(reflected, tables.reflected(node))
        });
        Self { lobe, tables, shares, front_factor: set.front_factor, largest: Largest::new(set) }
    }

    /// What shaders draw by.
    pub fn numbers_for_shaders(&self) -> NumbersForShaders {
        let shares = self.shares.map(|Shares { even, lobe, tables }| [even, lobe, tables]);
        NumbersForShaders::new(self.lobe.as_ref(), &self.tables, &shares)
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
        let node = node_of(wo[2]);
        let shares = self.shares[node];
        let largest = &self.largest;
        let (mut tables, mut coherent) = (0f64, 0f64);
        for ring in 0..RINGS {
            let [diffuse, lobe] = self.front(ring, wo);
            let power = if largest.taylor { 1.0 / (wo[2] * wo[2]) } else { 1.0 };
            tables = tables.max(diffuse * (largest.tables[ring] * power + largest.cross / wo[2]));
            coherent = coherent.max(lobe * largest.coherent[ring]);
        }
        let even = FRONT_SLACK * TAU / shares.even;
        let drawn = self.lobe.as_ref().map_or(0.0, |lobe| lobe.largest_ratio(node, wo) / shares.lobe);
        even * tables + (even * coherent).min(WITHIN_CELL * drawn)
    }

    /// Largest front factors of tables and lobe times `cos_theta_i`, for directions at a ring of the radius in (u, v).
    fn front(&self, ring: usize, wo: Vec3) -> [f64; 2] {
        let mut largest = [0f64; 2];
        for radius in [ring, ring + 1].map(|edge| 2.0 * edge as f64 / RINGS as f64) {
            for azimuth in 0..2 * FRONT_AZIMUTHS {
                let (sin, cos) = (PI * azimuth as f64 / FRONT_AZIMUTHS as f64).sin_cos();
                // Azimuths are counted from the one towards the middle of the disc of `wi`, so that both its ends are met.
                let (along, _) = lobe::projection(wo);
                let [x, y] = [cos * along[0] - sin * along[1], cos * along[1] + sin * along[0]];
                let [x, y] = [radius * x - wo[0], radius * y - wo[1]];
                let wi = [x, y, (1.0 - x * x - y * y).max(1e-12).sqrt()];
                if x * x + y * y < 1.0 {
                    let factors = [self.front_factor.diffuse(wi, wo), self.front_factor.coherent(wi, wo)];
                    largest.iter_mut().zip(factors).for_each(|(most, factor)| *most = most.max(factor * wi[2]));
                }
            }
        }
        largest
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
        let first = set.restriction.as_ref().map_or([0; 2], |restriction| restriction.first);
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
            if set.front_factor.factor == Factor::Vector {
                // The lobe's image in the horizon comes on top, from the same radius or a larger one.
                let mut outside = 0f64;
                for value in largest.coherent.iter_mut().rev() {
                    outside = outside.max(*value);
                    *value += outside;
                }
            }
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
