//! What remains of a plan for every direction where tables are restricted to scenes.

use super::ranges::{Coverage, Hull};
use super::rings::{covered_rings, fine_rings, join_rings};
use crate::tables::input::BuildInput;
use crate::tables::rings::Ring;
use crate::tables::texels::Texels;
use crate::tables::work::WindowWork;
use diffraction_brdf::direction::max_abs_w;
use diffraction_brdf::error::{Error, Result};

/// What a plan for every direction settles before it is restricted.
pub(in crate::tables) struct Whole<'a> {
    /// All texels.
    pub texels: &'a Texels,
    /// Extent of all directions.
    pub hull: Hull,
    /// Upper bound of the numbers of nodes in `w`.
    pub nodes_bound: usize,
    /// Radius of the coherent lobe in (u, v).
    pub lobe_radius: f64,
    /// Whether it has a cross term.
    pub crosses: bool,
}

/// What is left.
pub(in crate::tables) struct Restricted {
    /// Rings that hold texels.
    pub rings: Vec<Ring>,
    /// Extent that the transforms hold.
    pub transformed: Hull,
    /// Extent of the coverage.
    pub covered: Hull,
    /// Whether some direction lies within the coherent lobe.
    pub lobe_seen: bool,
    /// Whether the cross term is needed.
    pub crosses: bool,
}

/// Leaves out of a plan for every direction, with the work of its windows, what a coverage does not ask for.
///
/// What remains of the rings, of `|w|` and of the transforms' nodes is cut at places that do not move with every texel of
/// the coverage: sums then are what they were for one that differs little, bit for bit.
///
/// # Errors
/// An invisible light; a coverage of nothing.
pub(in crate::tables) fn restrict(
    input: &BuildInput,
    coverage: &Coverage,
    whole: &Whole,
    work: &[WindowWork],
) -> Result<Restricted> {
    let rings = fine_rings(input, whole.hull.radius[1])?;
    let rings = join_rings(rings, input, whole.texels, work, whole.nodes_bound);
    let covered = coverage.hull().ok_or_else(|| {
        Error::limit("no scene sees and lights any of this surface", "change the scene, or set tables.serve = \"all\"")
    })?;
    let lobe_seen = covered.radius[0] < whole.lobe_radius;
    let crosses = whole.crosses && lobe_seen;
    let transformed = match crosses {
        // The cross term keeps its whole patch and all of `|w|`.
        true => {
            let patch = whole.lobe_radius;
            let [u, v] = [covered.u, covered.v].map(|[low, high]| [low.min(-patch), high.max(patch)]);
            Hull { u, v, abs_w: whole.hull.abs_w, ..covered }
        }
        false => {
            let share = 0.25 * (covered.abs_w[1] - covered.abs_w[0]) / max_abs_w(0.0);
            let step = max_abs_w(0.0) * share.max(1e-6).log2().floor().exp2();
            Hull { abs_w: widened(covered.abs_w, step, whole.hull.abs_w), ..covered }
        }
    };
    Ok(Restricted { rings: covered_rings(rings, coverage), transformed, covered, lobe_seen, crosses })
}

/// An interval widened to whole multiples of a step, within limits that hold it.
pub(super) fn widened([low, high]: [f64; 2], step: f64, limits: [f64; 2]) -> [f64; 2] {
    [((low / step).floor() * step).max(limits[0]), ((high / step).ceil() * step).min(limits[1])]
}
