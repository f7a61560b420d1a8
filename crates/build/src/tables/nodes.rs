//! How finely `w` is resolved: numbers of tables and of nodes.

use super::coverage::nodes::ring_nodes;
use super::input::BuildInput;
use super::order::OrderEstimator;
use super::plan::BuildPlan;
use super::rings::RingNodes;
use crate::optics::spectra::Spectra;

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
    /// What the order estimator finds necessary, or the configuration asks for.
    pub fn choose(spectra: &Spectra, input: &BuildInput, plan: &BuildPlan) -> Self {
        let own_ranges = plan.coverage.is_some();
        let alike = |count| plan.rings.iter().map(|ring| RingNodes { abs_w: ring.abs_w, count }).collect();
        if let (Some(tables), false) = (input.tables.count, own_ranges) {
            return Self { tables, cross: tables, rings: alike(tables) };
        }
        let tolerance = input.tables.tolerance;
        let order = OrderEstimator::new(spectra, plan, tolerance);
        let tables = input.tables.count.unwrap_or_else(|| order.tables(plan.nodes_bound, own_ranges));
        if !own_ranges {
            return Self { tables, cross: tables, rings: alike(tables) };
        }
        let cross = match plan.crosses {
            true => OrderEstimator::cross_patches(spectra, plan, tolerance),
            false => tables,
        };
        let rings = plan.rings.iter().map(|ring| ring_nodes(&order, plan, ring, tables)).collect();
        Self { tables, cross, rings }
    }

    /// Most nodes of a ring.
    pub fn most(&self) -> usize {
        self.rings.iter().map(|nodes| nodes.count).max().unwrap_or(1)
    }
}
