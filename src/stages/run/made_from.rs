//! Everything that a specimen's folder depends on, as one JSON value: equal values, equal bytes but for times.

use std::path::Path;

use serde_json::{Map, Value, json};

use crate::stages::config::{ReportConfig, RunConfig, SpecimenConfig};
use crate::stages::coverage::asked;
use crate::stages::digest::sha256_file;
use crate::stages::measured::MeasuredConfig;
use crate::stages::program;
use diffraction_build::height::read::ReadConfig;
use diffraction_build::tables::model::TablesConfig;
use diffraction_render::scene::model::{Scene, Shape};

/// What the specimen is going to be made from; `None` where a file cannot be read, which making it then says.
///
/// Fields are taken apart one by one, so that a new one has to be counted in, or left out for a reason.
pub(super) fn made_from(config: &RunConfig, specimen: &SpecimenConfig) -> Option<Value> {
    let SpecimenConfig { name, species, scans, read, prepare, optics, is_material_given, albedo, measured } = specimen;
    // Working memory changes no value, and words of messages are the same for all manifests.
    let ReadConfig {
        page,
        channel,
        pitch_nm,
        height,
        max_missing_share,
        missing_value,
        crop,
        max_samples: _,
        words: _,
    } = read;
    let tables = TablesConfig { memory_mib: 0, ..config.tables.clone() };
    let ReportConfig { write: _, reference, savings } = config.report;
    let mut inputs = Map::new();
    for path in scans.iter().chain(measured.iter().map(|measured| &measured.file)) {
        inputs.insert(config.relative_name(path), digest(path)?);
    }
    let scenes = asked::pictured_scenes(config, name);
    let scenes =
        scenes.iter().map(|scene| Some((scene.name.clone(), scene_value(scene)?))).collect::<Option<Map<_, _>>>()?;
    let instrument = measured.as_ref().map(|MeasuredConfig { file, acceptance_deg, bandwidth_nm, export }| {
        json!({
            "file": config.relative_name(file),
            "acceptance_deg": acceptance_deg,
            "bandwidth_nm": bandwidth_nm,
            "export": export,
        })
    });
    Some(json!({
        "program": program::digest()?,
        "inputs": inputs,
        "specimen": {
            "name": name,
            "species": species,
            "read": {
                "page": page,
                "channel": channel,
                "pitch_nm": pitch_nm,
                "height": height,
                "max_missing_share": max_missing_share,
                "missing_value": missing_value,
                "crop": crop,
            },
            "prepare": prepare,
            "is_material_given": is_material_given,
            "albedo": albedo,
            "measured": instrument,
        },
        "optics": optics,
        "tables": tables,
        "hold": config.hold,
        "for_scenes_alone": !config.cover.is_all(),
        "scenes": scenes,
        "report": { "reference": reference, "savings": savings },
        // Not the adapter: what it draws is not published, and machines that share their work have different ones.
        "gpu": config.gpu,
    }))
}

/// A scene with what was read from its files; `None` where a path of it has no form in JSON.
pub(super) fn scene_value(scene: &Scene) -> Option<Value> {
    let mesh = match &scene.shape {
        Shape::Mesh(mesh) => mesh.model.files.iter().map(|(_, sha256)| sha256.as_str()).collect(),
        _ => Vec::new(),
    };
    let sky = scene.environment.as_ref().map(|environment| environment.sky.rotation_and_light());
    let scene = serde_json::to_value(scene).ok()?;
    Some(json!({ "scene": scene, "mesh": mesh, "sky": sky }))
}

fn digest(path: &Path) -> Option<Value> {
    sha256_file(path).ok().map(|(_, sha256)| sha256.into())
}
