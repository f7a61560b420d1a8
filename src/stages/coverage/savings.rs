//! What scenes look up of a specimen's tables, and what leaving out the rest saves.

use std::path::Path;

use crate::stages::built::Built;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::files;
use diffraction_build::tables::coverage::budget::{self, Budget, Cost};
use diffraction_build::tables::coverage::find::{self, LookUps};
use diffraction_build::tables::coverage::ranges::Coverage;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::TablesConfig;
use diffraction_build::tables::plan::BuildPlan;
use diffraction_build::tables::resolution::lobe_radius;
use diffraction_build::tables::rounding;
use diffraction_render::scene::model::Scene;
use diffraction_render::scene::reach::SceneLookUps;

/// Everything that the scenes look up on the grid of a specimen's tables.
///
/// # Errors
/// A scene that cannot be rendered; grids beyond the allowed memory.
pub fn cover(input: &BuildInput, scenes: &[&Scene]) -> Result<Coverage> {
    with_look_ups(scenes, |scenes| find::cover(input, scenes))
}

/// Predicts what the scenes need and what each thing left out saves, compared with tables for every direction of which
/// `whole` is asked.
///
/// # Errors
/// Those of planning.
pub fn predict(input: &BuildInput, scenes: &[&Scene], coverage: &Coverage, whole: &TablesConfig) -> Result<Budget> {
    with_look_ups(scenes, |scenes| budget::budget(input, scenes, coverage, whole))
}

/// The budget of tables that have been built, with what they took. `savings` builds everything that was left out as well,
/// step by step, and measures it.
///
/// # Errors
/// Those of planning, building and the disk.
pub fn account(
    input: &BuildInput,
    scenes: &[&Scene],
    coverage: &Coverage,
    whole: &TablesConfig,
    taken: Cost,
    savings: bool,
) -> Result<Budget> {
    let measure: Option<budget::Measure> = if savings { Some(&measure) } else { None };
    with_look_ups(scenes, |scenes| budget::account(input, scenes, coverage, whole, taken, measure))
}

fn with_look_ups<T>(scenes: &[&Scene], work: impl FnOnce(&[&dyn LookUps]) -> T) -> T {
    let look_ups: Vec<SceneLookUps> = scenes.iter().map(|scene| SceneLookUps::new(scene)).collect();
    work(&look_ups.iter().map(|scene| scene as &dyn LookUps).collect::<Vec<_>>())
}

/// What tables took that were built.
pub(crate) fn cost_of(built: &Built, stored_bytes: f64) -> Cost {
    Cost {
        node_samples: built.record.node_samples as f64,
        seconds: built.seconds,
        memory_bytes: built.memory_bytes.map_or(f64::NAN, |bytes| bytes as f64),
        stored_bytes,
    }
}

/// Builds and stores tables for nothing but their cost.
///
/// # Errors
/// Those of building, and the disk's.
pub fn measure(input: &BuildInput, plan: &BuildPlan) -> Result<Cost> {
    let built = Built::measured(input, plan, &|_| ())?;
    let folder = tempfile::tempdir().map_err(|e| Error::disk(Path::new("."), "create a temporary folder", e))?;
    let TablesConfig { storage, tolerance, .. } = *input.tables;
    rounding::choose(&built.set, storage, tolerance, lobe_radius(input.optics)).write(folder.path())?;
    let stored_bytes = files::bytes_of(folder.path(), "exr")? as f64;
    Ok(cost_of(&built, stored_bytes))
}
