//! What a manifest asks of each specimen: which scenes its tables answer for, with which tolerance; and what nobody asks for.

use crate::stages::config::{Cover, GpuCheck, RunConfig, SpecimenConfig};
use crate::stages::pictures::sharing::scenes_for;
use crate::stages::results::WHOLE_MAX;
use diffraction_brdf::error::{Error, Result};
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::tables::model::TablesConfig;
use diffraction_build::tables::spectral::obstacle;
use diffraction_render::scene::model::Scene;

/// The scenes that a specimen's tables are restricted to, or its shares of them; `None` where they are not.
pub(crate) fn restricted_to(config: &RunConfig, specimen: &str) -> Option<Vec<Scene>> {
    let shown = scenes_for(&config.scenes, specimen);
    match &config.cover {
        Cover::All => None,
        Cover::Scenes => Some(shown),
        Cover::Named(names) => Some(shown.into_iter().filter(|scene| names.contains(&scene.name)).collect()),
    }
}

/// The scenes that are pictured with a specimen's tables: those they answer.
pub(crate) fn pictured_scenes(config: &RunConfig, specimen: &str) -> Vec<Scene> {
    restricted_to(config, specimen).unwrap_or_else(|| scenes_for(&config.scenes, specimen))
}

/// What is asked of a specimen's tables: the tolerance of the scene that asks for most where they are restricted to scenes.
pub(crate) fn tables_for(config: &RunConfig, specimen: &str) -> TablesConfig {
    let tolerance = |scene: Scene| scene.tolerance.unwrap_or(config.tables.tolerance);
    let strictest =
        restricted_to(config, specimen).and_then(|scenes| scenes.into_iter().map(tolerance).reduce(f64::min));
    TablesConfig { tolerance: strictest.unwrap_or(config.tables.tolerance), ..config.tables.clone() }
}

/// Whether anything is asked of a specimen: always, unless tables are restricted to scenes and none of them shows it.
pub(crate) fn is_asked_for(config: &RunConfig, specimen: &str) -> bool {
    restricted_to(config, specimen).is_none_or(|scenes| !scenes.is_empty())
}

/// The specimens of which anything is asked, in the manifest's order.
pub(crate) fn specimens(config: &RunConfig) -> impl Iterator<Item = &SpecimenConfig> {
    config.specimens.iter().filter(|specimen| is_asked_for(config, &specimen.name))
}

/// Whether that is of more specimens than a report tells everything of in one place.
pub(crate) fn is_of_many(config: &RunConfig) -> bool {
    specimens(config).nth(WHOLE_MAX).is_some()
}

/// What to know of a specimen's spectral tables where they are asked for and cannot be made; they are then left out.
///
/// # Errors
/// [`Error::Limit`] where there are no others.
pub(crate) fn spectral_obstacle(config: &RunConfig, optics: &OpticsConfig) -> Result<Option<String>> {
    let Some(why) = obstacle(optics).filter(|_| config.hold.spectral) else { return Ok(None) };
    if config.hold.xyz {
        return Ok(Some(format!("no spectral tables: {why}")));
    }
    Err(Error::limit(
        format!("spectral tables alone are asked for and cannot be made: {why}"),
        "add \"xyz\" to tables.hold",
    ))
}

/// What was assumed where the manifest says nothing and one might want to know.
pub fn assumed(config: &RunConfig) -> Vec<String> {
    let names: Vec<&str> = config.scenes.iter().map(|scene| scene.name.as_str()).collect();
    let row = || {
        format!(
            "the scenes {}: the manifest has no [[scene]]; `scene = []` at its top asks for none",
            names.join(" and ")
        )
    };
    (!config.scenes_are_given && !names.is_empty()).then(row).into_iter().collect()
}

/// Specimens, pictures and stages that nobody asks for, with the reason.
pub fn left_out(config: &RunConfig) -> Vec<String> {
    let mut rows = Vec::new();
    for specimen in config.specimens.iter().filter(|specimen| !is_asked_for(config, &specimen.name)) {
        rows.push(format!("the specimen {}: no scene that its tables are restricted to shows it", specimen.name));
    }
    if !config.hold.xyz {
        rows.push("files of X, Y, Z: tables.hold names spectral tables alone, from which readers derive them".into());
    }
    if let Cover::Named(names) = &config.cover {
        for scene in config.scenes.iter().filter(|scene| !names.contains(&scene.name)) {
            rows.push(format!("the scene {}: tables.serve does not name it", scene.name));
        }
    }
    let stages = [
        (config.scenes.is_empty(), "pictures of scenes: scene = []"),
        (config.gpu == GpuCheck::Off, "the check on a GPU: gpu.check = \"off\""),
        (!config.report.reference, "reference pictures and measured errors: report.reference = false"),
        (!config.report.write, "report.html and report.json: report.write = false"),
    ];
    rows.extend(stages.into_iter().filter(|(absent, _)| *absent).map(|(_, row)| row.to_owned()));
    rows
}
