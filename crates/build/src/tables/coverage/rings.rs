//! Rings of tables restricted to scenes.

use super::ranges::Coverage;
use super::shares::RING_SHARE;
use crate::tables::accumulate::SIMD_WIDTH;
use crate::tables::grid::Grid;
use crate::tables::input::BuildInput;
use crate::tables::resolution::{narrowest_blur, nodes_expected};
use crate::tables::rings::{Ring, quadrature, wavelengths_of};
use crate::tables::texels::Texels;
use crate::tables::work::WindowWork;
use diffraction_brdf::direction::max_abs_w;
use diffraction_brdf::error::Result;

/// Where `t` is nearly the same everywhere, `|w|` is not: rings are cut so that `max_abs_w` changes by no more than this,
/// nor their radii by more than this ratio, and with them the nodes of a ring stay few...
const FINE_STEP: f64 = 0.25;
const FINE_RATIO: f64 = 1.19;
/// ...but no narrower than this many widths of what blurs a line, since every ring interpolates all lines whose blur
/// reaches into it.
const FINE_LOBES: f64 = 20.0;

/// Multiplications and additions that a value of a kernel counts for: an exponential of double precision.
const OPERATIONS_PER_KERNEL_VALUE: f64 = 20.0;

/// Rings finer than those for every direction, each with the `|w|` that one light and one camera can have in it. They know
/// nothing of the scenes, so that what a texel holds does not depend on which others are covered.
///
/// # Errors
/// `Error::Call` for an invisible light.
pub(super) fn fine_rings(input: &BuildInput, radius_max: f64) -> Result<Vec<Ring>> {
    let narrowest = FINE_LOBES * narrowest_blur(input.optics);
    let mut rings = Vec::new();
    let mut outer = radius_max;
    while outer > 0.0 {
        let by_reach = (4.0 - (max_abs_w(outer) + FINE_STEP).powi(2)).max(0.0).sqrt();
        let inner = by_reach.max(outer / FINE_RATIO).min(outer - narrowest).max(0.0);
        let inner = if inner < narrowest { 0.0 } else { inner };
        rings.push(Ring {
            radius: [inner, outer],
            abs_w: [max_abs_w(outer), max_abs_w(inner)],
            quadrature: quadrature(input, wavelengths_of(input, [inner, outer]))?,
        });
        outer = inner;
    }
    Ok(rings)
}

/// Joins rings with their neighbours wherever the sums over all of their texels then are fewer operations: narrow rings have
/// few nodes, but every one interpolates all lines whose blur reaches into it. There are at most `nodes_bound` nodes.
pub(super) fn join_rings(
    rings: Vec<Ring>,
    input: &BuildInput,
    texels: &Texels,
    windows: &[WindowWork],
    nodes_bound: usize,
) -> Vec<Ring> {
    let operations = |(ring, texels_within): &(Ring, f64)| -> f64 {
        let length = ring.abs_w[1] - ring.abs_w[0];
        let tolerance = RING_SHARE * input.tables.tolerance;
        let nodes = nodes_expected(input.rms_nm, input.wavelength_range_nm[0], length, tolerance);
        let nodes = nodes.min(nodes_bound).max(input.tables.count.unwrap_or(1));
        windows.iter().map(|window| ring_operations(window, ring, *texels_within, &texels.grid, nodes)).sum()
    };
    let mut joined: Vec<(Ring, f64)> = Vec::new();
    for ring in rings {
        let next = (ring.clone(), texels.count_within(ring.radius) as f64);
        if let Some(last) = joined.last_mut() {
            // The outer radius asks for more wavelengths.
            let abs_w = [last.0.abs_w[0].min(ring.abs_w[0]), last.0.abs_w[1].max(ring.abs_w[1])];
            let quadrature = last.0.quadrature.clone();
            let both = (Ring { radius: [ring.radius[0], last.0.radius[1]], abs_w, quadrature }, last.1 + next.1);
            if operations(&both) <= operations(last) + operations(&next) {
                *last = both;
                continue;
            }
        }
        joined.push(next);
    }
    joined.into_iter().map(|(ring, _)| ring).collect()
}

/// Multiplications, each with an addition, of one window's sums over a ring with so many texels and nodes; those of a lane
/// of nodes, which a processor does at once, count as one.
fn ring_operations(window: &WindowWork, ring: &Ring, texels: f64, grid: &Grid, nodes: usize) -> f64 {
    let work = window.ring(ring, texels, grid);
    // Every power is a square or two; and at every wavelength a texel's enters X, Y and Z.
    let sums = window.parts * work.powers + 3.0 * texels * work.wavelengths;
    OPERATIONS_PER_KERNEL_VALUE * work.kernel_values
        + nodes.div_ceil(SIMD_WIDTH) as f64 * (work.line_products + work.tap_products + sums)
}

/// The rings that hold texels of a coverage, with the `|w|` that these are asked for.
pub(super) fn covered_rings(rings: Vec<Ring>, coverage: &Coverage) -> Vec<Ring> {
    let outermost = rings.first().map(|ring| ring.radius[1]);
    let radii: Vec<f64> = outermost.into_iter().chain(rings.iter().map(|ring| ring.radius[0])).collect();
    let covered = rings.into_iter().zip(coverage.abs_w_of_rings(&radii));
    covered.filter_map(|(ring, abs_w)| Some(Ring { abs_w: abs_w?, ..ring })).collect()
}
