//! Finding what scenes look up.

use rayon::prelude::*;

use super::ranges::{Coverage, Directions, TexelSet};
use super::smooth::smooth;
use crate::tables::grid::Grid;
use crate::tables::input::BuildInput;
use crate::tables::plan::grid;
use diffraction_brdf::error::{Error, Result};

/// Texels beside everything looked up that are covered as well: cubics read them.
const MARGIN_TEXELS: f64 = 1.0;

/// A scene, as far as tables are restricted to it.
pub trait LookUps: Sync {
    /// Its name.
    fn name(&self) -> &str;

    /// Whether its pictures are exposed by what they show. Where they are, what is dark beside the rest needs no accuracy.
    fn is_exposed_by_content(&self) -> bool;

    /// Number of parts that can be visited side by side.
    fn parts(&self) -> usize;

    /// Calls `mark` with all directions that a part looks up. Texels are `texel` wide in (u, v).
    ///
    /// # Errors
    /// A scene that cannot be rendered.
    fn visit(&self, part: usize, texel: f64, mark: &mut dyn FnMut(&Directions)) -> Result<()>;
}

/// Everything that the scenes look up on the grid of a specimen's tables.
///
/// # Errors
/// A scene that cannot be rendered; grids beyond the allowed memory.
pub fn cover(input: &BuildInput, scenes: &[&dyn LookUps]) -> Result<Coverage> {
    let grid = grid(input);
    let copies = copies_of(grid, input.tables.memory_mib)?;
    let mut coverage = Coverage::none(grid);
    for &scene in scenes {
        let looked_up = looked_up(scene, grid, copies)?;
        coverage = coverage.merge(&looked_up);
        coverage.exposed_by.push(match scene.is_exposed_by_content() {
            true => TexelSet::of(&looked_up),
            false => TexelSet::none(),
        });
    }
    Ok(smooth(coverage, input))
}

/// What one scene looks up of a grid, with at most so many copies of the grid filled at once.
///
/// # Errors
/// A scene that cannot be rendered.
pub fn looked_up(scene: &dyn LookUps, grid: Grid, copies: usize) -> Result<Coverage> {
    let copies = copies.min(scene.parts()).max(1);
    let of_copy = |copy: usize| {
        let mut coverage = Coverage::none(grid);
        // Parts in turn: what takes long in a picture lies together.
        for part in (copy..scene.parts()).step_by(copies) {
            scene.visit(part, grid.texel(), &mut |directions| coverage.mark(directions, MARGIN_TEXELS))?;
        }
        Ok(coverage)
    };
    let marked = (0..copies).into_par_iter().map(of_copy).collect::<Result<Vec<Coverage>>>()?;
    Ok(marked.into_iter().reduce(|a, b| a.merge(&b)).unwrap_or_else(|| Coverage::none(grid)))
}

/// Copies of a grid's coverage that threads may fill at once; others hold what was found, scene by scene.
fn copies_of(grid: Grid, memory_mib: usize) -> Result<usize> {
    const OTHERS: usize = 3;
    let bytes = Coverage::bytes(grid);
    let copies = ((memory_mib as u64) << 20) / bytes;
    match usize::try_from(copies).unwrap_or(usize::MAX).checked_sub(OTHERS) {
        Some(copies @ 1..) => Ok(copies.min(rayon::current_num_threads())),
        _ => Err(Error::limit(
            format!(
                "finding what the scenes reach on {0} x {0} texels needs {1} MiB, {memory_mib} MiB are allowed",
                grid.size,
                (bytes * (OTHERS as u64 + 1)) >> 20
            ),
            "lower tables.size or raise tables.memory_mib",
        )),
    }
}
