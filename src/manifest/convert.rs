//! From a manifest to the configuration of its run.

use super::model::Manifest;
use crate::stages::config::RunConfig;

/// The run that a manifest asks for; `text` is the manifest, word for word.
pub fn run_config(manifest: &Manifest, text: &str) -> RunConfig {
    RunConfig {
        atlas_name: manifest.atlas.name.clone(),
        atlas_root: manifest.atlas.out.join(&manifest.atlas.name),
        tables: manifest.tables.clone(),
        serve: manifest.serve.clone(),
        specimens: manifest.specimens.clone(),
        scenes: manifest.scenes.clone(),
        gpu: manifest.gpu.check,
        frame_time: manifest.gpu.frame_time,
        report: manifest.report,
        cache: manifest.cache.clone(),
        manifest_text: text.to_owned(),
        base: manifest.base.clone(),
    }
}
