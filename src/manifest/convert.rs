//! From a manifest to the run it asks for.

use super::collection::Collection;
use super::model::Manifest;
use crate::stages::config::RunConfig;
use diffraction_brdf::atlas::InputRecord;
use diffraction_brdf::files;
use diffraction_brdf::json;

/// The run that a manifest asks for; `text` is the manifest, word for word.
pub fn run_config(manifest: Manifest, text: String) -> RunConfig {
    let Manifest {
        atlas,
        tables,
        cover,
        hold,
        specimens,
        collection,
        scenes,
        scenes_are_given,
        gpu,
        report,
        cache,
        base,
        ..
    } = manifest;
    let collection = collection.map(|Collection { file, sha256, .. }| InputRecord {
        path: file.strip_prefix(&base).unwrap_or(&file).display().to_string(),
        sha256,
    });
    RunConfig {
        atlas_root: atlas.out.join(&atlas.name),
        atlas_name: atlas.name,
        tables,
        cover,
        hold,
        specimens,
        collection,
        scenes,
        scenes_are_given,
        gpu: gpu.check,
        frame_time: gpu.frame_time,
        report,
        cache,
        reuse: true,
        memory_bytes: None,
        on_failure: atlas.on_failure,
        frozen: None,
        manifest_sha256: values_sha256(&text),
        manifest_text: text,
        base,
    }
}

/// SHA-256 of a manifest's values: comments and layout do not count. Of the text itself where that is no TOML.
pub fn values_sha256(text: &str) -> String {
    match toml::from_str::<serde_json::Value>(text) {
        Ok(values) => files::sha256_hex(json::canonical(&values).as_bytes()),
        Err(_) => files::sha256_hex(text.as_bytes()),
    }
}

#[cfg(test)]
mod tests {
    use super::values_sha256;

    #[test]
    fn comments_and_layout_do_not_count_and_values_do() {
        let first = values_sha256("a = 1\nb = { c = 0.5 }\n");
        assert_eq!(first, values_sha256("a=1 # one\n[b]\nc = 0.50\n"));
        for other in ["a = 1\nb = { c = 0.25 }\n", "a = 1\n", "a = 1.0\nb = { c = 0.5 }\n"] {
            assert_ne!(first, values_sha256(other));
        }
    }
}
