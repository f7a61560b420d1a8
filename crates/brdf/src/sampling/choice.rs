//! What the densities of lobe and tables share: polar angles they are prepared for, the reflectance, choosing by mass.

use crate::front_factor::FrontFactor;

/// Polar angles of the viewer for which densities are prepared: `cos = ((k + 1/2) / NODES)²`, dense at grazing ones.
pub(super) const NODES: usize = 8;

/// Cosine of the viewer's polar angle at a node.
pub(super) fn node_cosine(node: usize) -> f64 {
    ((node as f64 + 0.5) / NODES as f64).powi(2)
}

/// The reflectance by the cosine at the half vector, in steps of 1/64: that of mirrored directions.
#[derive(Debug, Clone)]
pub(super) struct Reflectance(Vec<f64>);

impl Reflectance {
    pub(super) fn new(front_factor: FrontFactor) -> Self {
        let at = |k: usize| {
            let cos: f64 = (k as f64 / 64.0).max(0.01);
            let sin = (1.0 - cos * cos).sqrt();
            front_factor.coherent([sin, 0.0, cos], [-sin, 0.0, cos])
        };
        Self((0..=64).map(at).collect())
    }

    /// At a squared length of `q`, which is twice the cosine long.
    pub(super) fn at(&self, q2: f64) -> f64 {
        let at = (0.5 * q2.sqrt()).min(1.0) * 64.0;
        let first = (at as usize).min(63);
        let share = at - first as f64;
        (1.0 - share) * self.0[first] + share * self.0[first + 1]
    }
}

/// Chooses one of `range` with probabilities in proportion to `mass`, all alike where there is none: the index, its
/// probability, and what is left of the number `u` in [0, 1).
pub(super) fn choose(range: std::ops::Range<usize>, u: f64, mass: impl Fn(usize) -> f64) -> (usize, f64, f64) {
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
pub(super) fn probability(range: std::ops::Range<usize>, index: usize, mass: impl Fn(usize) -> f64) -> f64 {
    let total: f64 = range.clone().map(&mass).sum();
    if total > 0.0 { mass(index) / total } else { 1.0 / range.len() as f64 }
}
