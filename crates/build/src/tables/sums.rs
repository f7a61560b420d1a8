//! The sums of a build: over windows and wavelengths, at the nodes of every ring, and of the cross term's patch.

use std::f64::consts::SQRT_2;

use ndarray::Array3;

use super::accumulate::{BoxFilter, PowerSums, Quantity, RingSum, add_ring};
use super::coefficients::{Values, to_tables};
use super::input::BuildInput;
use super::lobe::patch_grid;
use super::model::Advance;
use super::nodes::Nodes;
use super::plan::BuildPlan;
use super::rings::{Ring, RingNodes, quadrature, wavelengths_needed};
use super::texels::Texels;
use crate::optics::spectra::Spectra;
use diffraction_brdf::direction::max_abs_w;
use diffraction_brdf::error::Result;

/// The sums under way: the tables and, where windows are not averaged away, the cross term.
pub(super) struct Sums {
    pub nodes: Nodes,
    main: PowerSums,
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
    pub fn new(input: &BuildInput, plan: &BuildPlan, nodes: Nodes) -> Result<Self> {
        let main = PowerSums::new(&plan.texels, plan.channels, nodes.most());
        let cross = plan.crosses.then(|| Cross::new(input, plan, nodes.cross)).transpose()?;
        Ok(Self { nodes, main, cross })
    }

    /// Adds one of the windows, as this share of all.
    pub fn add(&mut self, spectra: &Spectra, plan: &BuildPlan, share: f64, advance: Advance) {
        for (ring, nodes) in plan.rings.iter().zip(&self.nodes.rings) {
            let what = RingSum { texels: &plan.texels, ring, filter: plan.filter, quantity: Quantity::Power, share };
            add_ring(spectra, what, &nodes.positions(), &mut self.main);
            advance(ring.wavelengths() as u64);
        }
        if let Some(Cross { sums, texels, ring: [ring], nodes }) = &mut self.cross {
            let filter = BoxFilter { width: 0.0, samples: 1 };
            let what = RingSum { texels, ring, filter, quantity: Quantity::Cross, share };
            add_ring(spectra, what, &nodes.positions(), sums);
        }
    }

    /// The tables.
    pub fn tables(&self, plan: &BuildPlan) -> Vec<Array3<f32>> {
        let BuildPlan { texels, rings, .. } = plan;
        let values = Values { sums: &self.main, texels, rings, nodes: &self.nodes.rings };
        to_tables(&values, plan.coverage.as_ref(), self.nodes.tables)
    }

    /// The patches of the cross term; none where there is none.
    pub fn cross_tables(&self) -> Vec<Array3<f32>> {
        match &self.cross {
            Some(Cross { sums, texels, ring, nodes }) => {
                to_tables(&Values { sums, texels, rings: ring, nodes: &[*nodes] }, None, nodes.count)
            }
            None => Vec::new(),
        }
    }
}

impl Cross {
    fn new(input: &BuildInput, plan: &BuildPlan, count: usize) -> Result<Self> {
        let texels = Texels::whole(patch_grid(input.optics, plan.lobe_radius));
        let corner = plan.lobe_radius * SQRT_2;
        let quadrature = quadrature(input, wavelengths_needed(input, corner, max_abs_w(0.0), 1e-6))?;
        let nodes = RingNodes { abs_w: [0.0, max_abs_w(0.0)], count };
        let ring = Ring { radius: [0.0, corner * 1.01], abs_w: nodes.abs_w, quadrature };
        Ok(Self { sums: PowerSums::new(&texels, plan.channels, count), texels, ring: [ring], nodes })
    }
}
