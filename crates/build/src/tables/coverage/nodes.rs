//! Nodes in `w` of a ring whose texels have ranges of their own.

use super::restrict::widened;
use super::shares::{RING_SHARE, WIDE_SHARE};
use crate::tables::accumulate::SIMD_WIDTH;
use crate::tables::order::OrderEstimator;
use crate::tables::plan::BuildPlan;
use crate::tables::rings::{Ring, RingNodes};

/// Steps, coarse to fine, of the numbers at which the nodes of a ring may begin and end in `|w|`.
const STEPS: [f64; 6] = [2.0, 1.0, 0.5, 0.25, 0.125, 0.0625];

/// Nodes over the coarsest interval of `|w|` that takes no more groups of them than the ring's own range does, for so many
/// tables: what a texel holds then does not move with every texel of the coverage.
pub(in crate::tables) fn ring_nodes(order: &OrderEstimator, plan: &BuildPlan, ring: &Ring, tables: usize) -> RingNodes {
    let limits = plan.abs_w_within(ring);
    let over = |abs_w: [f64; 2], share: f64| {
        // Fewer than the tables would leave their highest polynomials without information.
        let first = tables.next_multiple_of(SIMD_WIDTH);
        let last = plan.nodes_over(abs_w).next_multiple_of(SIMD_WIDTH).max(first);
        RingNodes { abs_w, count: order.ring_nodes(ring, abs_w, share, (first..=last).step_by(SIMD_WIDTH)) }
    };
    let enough = over(ring.abs_w, RING_SHARE).count;
    let [coarse @ .., finest] = STEPS.map(|step| widened(ring.abs_w, step, limits));
    let wide = coarse.into_iter().map(|abs_w| over(abs_w, WIDE_SHARE)).find(|nodes| nodes.count <= enough);
    wide.unwrap_or_else(|| over(finest, WIDE_SHARE))
}
