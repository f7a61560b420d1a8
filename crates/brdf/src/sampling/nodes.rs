//! Polar angles of the viewer at which densities are prepared.

/// Polar angles of the viewer for which densities are prepared: `cos = ((k + 1/2) / NODES)²`, dense at grazing ones.
pub(super) const NODES: usize = 8;

/// Cosine of the viewer's polar angle at a node.
pub(super) fn node_cosine(node: usize) -> f64 {
    ((node as f64 + 0.5) / NODES as f64).powi(2)
}

/// The node for a viewer.
pub(super) fn node_of(cos_o: f64) -> usize {
    ((NODES as f64 * cos_o.sqrt()) as usize).min(NODES - 1)
}
