//! Tables restricted to a manifest's scenes: which scenes a specimen's tables answer, and what that saves.

use std::path::Path;

use super::config::{GpuCheck, RunConfig, Serve};
use super::known::Built;
use super::pictures::sharing::scenes_for;
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

/// The scenes that a specimen's tables are restricted to, or its shares of them; `None` where they are not.
pub fn restricted_to(config: &RunConfig, specimen: &str) -> Option<Vec<Scene>> {
    let shown = scenes_for(&config.scenes, specimen);
    match &config.serve {
        Serve::All => None,
        Serve::Scenes => Some(shown),
        Serve::Named(names) => Some(shown.into_iter().filter(|scene| names.contains(&scene.name)).collect()),
    }
}

/// The scenes that are pictured with a specimen's tables: those they answer.
pub fn pictured_scenes(config: &RunConfig, specimen: &str) -> Vec<Scene> {
    restricted_to(config, specimen).unwrap_or_else(|| scenes_for(&config.scenes, specimen))
}

/// What is asked of a specimen's tables: the tolerance of the scene that asks for most where they are restricted to scenes.
pub fn tables_for(config: &RunConfig, specimen: &str) -> TablesConfig {
    let tolerance = |scene: Scene| scene.tolerance.unwrap_or(config.tables.tolerance);
    let strictest =
        restricted_to(config, specimen).and_then(|scenes| scenes.into_iter().map(tolerance).reduce(f64::min));
    TablesConfig { tolerance: strictest.unwrap_or(config.tables.tolerance), ..config.tables.clone() }
}

/// Whether anything is asked of a specimen: always, unless tables are restricted to scenes and none of them shows it.
pub fn is_asked_for(config: &RunConfig, specimen: &str) -> bool {
    restricted_to(config, specimen).is_none_or(|scenes| !scenes.is_empty())
}

/// Specimens, pictures and stages that nobody asks for, with the reason.
pub fn left_out(config: &RunConfig) -> Vec<String> {
    let mut rows = Vec::new();
    for specimen in config.specimens.iter().filter(|specimen| !is_asked_for(config, &specimen.name)) {
        rows.push(format!("the specimen {}: no scene that its tables are restricted to shows it", specimen.name));
    }
    if let Serve::Named(names) = &config.serve {
        for scene in config.scenes.iter().filter(|scene| !names.contains(&scene.name)) {
            rows.push(format!("the scene {}: tables.serve does not name it", scene.name));
        }
    }
    let stages = [
        (config.scenes.is_empty(), "pictures of scenes: the manifest has no [[scene]]"),
        (config.gpu == GpuCheck::Off, "the check on a GPU: gpu.check = \"off\""),
        (!config.report.reference, "reference pictures and measured errors: report.reference = false"),
        (!config.report.write, "report.html and report.json: report.write = false"),
    ];
    rows.extend(stages.into_iter().filter(|(absent, _)| *absent).map(|(_, row)| row.to_owned()));
    rows
}

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
pub fn cost_of(built: &Built, stored_bytes: f64) -> Cost {
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
