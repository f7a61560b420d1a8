//! The sums of a build: how finely each ring resolves depth, and what is summed.

use std::f64::consts::SQRT_2;

use ndarray::Array3;

use super::accumulate::{BoxFilter, GROUP, PowerSums, Quantity, RingSum, add_ring};
use super::build::{Advance, BuildPlan, to_tables};
use super::domain::Texels;
use super::lobe::patch_grid;
use super::model::TablesConfig;
use super::pilot::{Pilot, RING_SHARE};
use super::plan::{self, Ring, nodes_bound_over};
use crate::ground::spectrum::uniform_wavenumbers;
use crate::optics::config::OpticsConfig;
use crate::optics::spectra::Spectra;
use diffraction_brdf::chebyshev;
use diffraction_brdf::direction::max_abs_w;
use diffraction_brdf::error::Result;

/// Steps, coarse to fine, of the numbers at which the nodes of a ring may begin and end in `|w|`.
const STEPS: [f64; 6] = [2.0, 1.0, 0.5, 0.25, 0.125, 0.0625];

/// The nodes of a ring in depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingNodes {
    /// The interval of `|w|` that they span.
    pub w: [f64; 2],
    /// How many there are.
    pub count: usize,
}

/// How finely `w` is resolved.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Nodes {
    /// Number of tables.
    pub tables: usize,
    /// Number of patches of the cross term, where there is one.
    pub cross: usize,
    /// Nodes of each ring.
    pub rings: Vec<RingNodes>,
}

impl Nodes {
    /// What the pilot finds necessary, or the configuration asks for.
    pub fn choose(spectra: &Spectra, plan: &BuildPlan, config: &TablesConfig) -> Self {
        let own_ranges = plan.domain.is_some();
        let alike = |count| plan.rings.iter().map(|ring| RingNodes { w: ring.w, count }).collect();
        if let (Some(tables), false) = (config.count, own_ranges) {
            return Self { tables, cross: tables, rings: alike(tables) };
        }
        let pilot = Pilot::new(spectra, plan, config.tolerance);
        let tables = config.count.unwrap_or_else(|| pilot.tables(plan.nodes_bound, own_ranges));
        if !own_ranges {
            return Self { tables, cross: tables, rings: alike(tables) };
        }
        let cross = match plan.crosses {
            true => Pilot::cross_patches(spectra, plan, config.tolerance, most_over(plan, [0.0, max_abs_w(0.0)])),
            false => tables,
        };
        let rings = plan.rings.iter().map(|ring| ring_nodes(&pilot, plan, ring, tables)).collect();
        Self { tables, cross, rings }
    }

    /// Most nodes of a ring.
    pub fn most(&self) -> usize {
        self.rings.iter().map(|nodes| nodes.count).max().unwrap_or(1)
    }
}

/// Share of the tolerance for nodes over an interval wider than need be: twice that of the ring's own range, so that where
/// as many suffice for that, it seldom hangs on the texels tried. Beside what steps in wavelength and texels' ranges are
/// given, half the tolerance each, it adds a fiftieth where errors add as squares.
const WIDE_SHARE: f64 = 2.0 * RING_SHARE;

/// Nodes over the coarsest interval of depths that takes no more groups of them than the ring's own range does: the
/// coarser it is, the more scenes share it.
fn ring_nodes(pilot: &Pilot, plan: &BuildPlan, ring: &Ring, tables: usize) -> RingNodes {
    let limits = plan.depths_within(ring);
    let over = |w: [f64; 2], share: f64| {
        // Fewer than the tables would leave their highest polynomials without information.
        let first = tables.next_multiple_of(GROUP);
        let last = most_over(plan, w).next_multiple_of(GROUP).max(first);
        RingNodes { w, count: pilot.ring_nodes(ring.rho, w, share, (first..=last).step_by(GROUP)) }
    };
    let enough = over(ring.w, RING_SHARE).count;
    let [coarse @ .., finest] = STEPS.map(|step| plan::widened(ring.w, step, limits));
    let wide = coarse.into_iter().map(|w| over(w, WIDE_SHARE)).find(|nodes| nodes.count <= enough);
    wide.unwrap_or_else(|| over(finest, WIDE_SHARE))
}

fn most_over(plan: &BuildPlan, w: [f64; 2]) -> usize {
    nodes_bound_over(plan.bandwidth_nm, plan.wavelength_min_nm, plan.fine_tolerance, w[1] - w[0])
}

/// The sums under way: the tables and, where windows are not averaged away, the cross term.
pub(super) struct Sums {
    pub nodes: Nodes,
    pub main: PowerSums,
    cross: Option<Cross>,
}

/// The cross term's sums: a square patch, and the ring without a hole that reaches past its corners.
struct Cross {
    sums: PowerSums,
    texels: Texels,
    ring: [Ring; 1],
    nodes: RingNodes,
}

impl Sums {
    /// Nothing summed yet.
    pub fn new(plan: &BuildPlan, optics: &OpticsConfig, nodes: Nodes) -> Result<Self> {
        let main = PowerSums::new(&plan.texels, nodes.most());
        let cross = plan.crosses.then(|| Cross::new(plan, optics, nodes.cross)).transpose()?;
        Ok(Self { nodes, main, cross })
    }

    /// Adds one of the windows.
    pub fn add(&mut self, spectra: &Spectra, plan: &BuildPlan, share: f64, advance: Advance) {
        for (ring, nodes) in plan.rings.iter().zip(&self.nodes.rings) {
            let what = RingSum { texels: &plan.texels, ring, filter: plan.filter, quantity: Quantity::Power, share };
            add_ring(spectra, what, &nodes.positions(), &mut self.main);
            advance(ring.quadrature.wavelengths_nm.len() as u64);
        }
        if let Some(Cross { sums, texels, ring: [ring], nodes }) = &mut self.cross {
            let filter = BoxFilter { width: 0.0, samples: 1 };
            let what = RingSum { texels, ring, filter, quantity: Quantity::Cross, share };
            add_ring(spectra, what, &nodes.positions(), sums);
        }
    }

    pub fn cross_tables(&self) -> Vec<Array3<f32>> {
        match &self.cross {
            Some(Cross { sums, texels, ring, nodes }) => to_tables(sums, texels, None, ring, &[*nodes], nodes.count),
            None => Vec::new(),
        }
    }
}

impl RingNodes {
    /// Where they lie in `|w|`.
    fn positions(&self) -> Vec<f64> {
        chebyshev::gauss_nodes(self.count, self.w[0], self.w[1])
    }
}

impl Cross {
    fn new(plan: &BuildPlan, optics: &OpticsConfig, count: usize) -> Result<Self> {
        let texels = Texels::whole(patch_grid(optics, plan.lobe_radius));
        let corner = plan.lobe_radius * SQRT_2;
        let wavelengths = plan::wavelengths_needed(optics, plan.bandwidth_nm, corner, max_abs_w(0.0), 1e-6);
        let quadrature = uniform_wavenumbers(&optics.illuminant, optics.wavelength_nm, wavelengths)?;
        let nodes = RingNodes { w: [0.0, max_abs_w(0.0)], count };
        let ring = Ring { rho: [0.0, corner * 1.01], w: nodes.w, quadrature };
        Ok(Self { sums: PowerSums::new(&texels, count), texels, ring: [ring], nodes })
    }
}
