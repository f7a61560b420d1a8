//! From a manifest to the run it asks for.

use super::model::Manifest;
use crate::stages::config::RunConfig;

/// The run that a manifest asks for; `text` is the manifest, word for word.
pub fn run_config(manifest: Manifest, text: String) -> RunConfig {
    let Manifest { atlas, tables, cover, hold, specimens, scenes, scenes_are_given, gpu, report, cache, base, .. } =
        manifest;
    RunConfig {
        atlas_root: atlas.out.join(&atlas.name),
        atlas_name: atlas.name,
        tables,
        cover,
        hold,
        specimens,
        scenes,
        scenes_are_given,
        gpu: gpu.check,
        frame_time: gpu.frame_time,
        report,
        cache,
        manifest_text: text,
        base,
    }
}
