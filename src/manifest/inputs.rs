//! Every file that a manifest reads, so that no command writes onto one.

use std::path::PathBuf;

use toml::Value;

use super::model::Manifest;

/// The scans, and whatever text in the manifest names a file that is there: measured data, lights, materials, meshes, environments,
/// what a CSV file of specimens names.
pub(crate) fn inputs(manifest: &Manifest, text: &str) -> Vec<PathBuf> {
    let mut found: Vec<PathBuf> = manifest.specimens.iter().flat_map(|specimen| specimen.scans.clone()).collect();
    found.extend(manifest.collection.iter().flat_map(|collection| collection.named.clone()));
    let document = text.parse::<toml::Table>().unwrap_or_default();
    for name in texts(&Value::Table(document)) {
        let path = manifest.base.join(name);
        if path.is_file() {
            found.push(path);
        }
    }
    found
}

fn texts(value: &Value) -> Vec<String> {
    match value {
        Value::String(text) => vec![text.clone()],
        Value::Array(items) => items.iter().flat_map(texts).collect(),
        Value::Table(table) => table.values().flat_map(texts).collect(),
        _ => Vec::new(),
    }
}
