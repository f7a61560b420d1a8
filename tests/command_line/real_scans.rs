//! The real scans of `tests/real_scans.toml`, which are not part of the repository.
//!
//! `REAL_SCANS` may name the atlas that a run of that manifest has just made, so that it is not made twice.

use std::path::{Path, PathBuf};

use crate::place::{Place, call};
use crate::skip::shared;

/// Name, published or measured period in nm, if the surface has one.
const SPECIMENS: [(&str, Option<f64>); 8] = [
    ("elaphe_guttata", Some(1140.0)),
    ("xenopeltis_unicolor", Some(1550.0)),
    ("butterfly_vcardui_10x3", None),
    ("butterfly_vcardui_41pct", None),
    ("grating_nanosurf_314nm", Some(314.0)),
    ("grating_silicon_3um", Some(3000.0)),
    ("polymer_sbs_pmma_25um", None),
    ("rough_film_dimension_10um", None),
];

/// Above this pitch a scan cannot answer for every direction at 380 nm: frequencies up to 2 / 380 nm.
const PITCH_MAX_NM: f64 = 95.0;

#[test]
#[ignore = "slow: whole scans"]
fn the_real_scans_make_an_atlas() {
    if shared("specimens").is_none() {
        return;
    }
    let place = Place::empty();
    let atlas = std::env::var_os("REAL_SCANS").map_or_else(|| made(&place), PathBuf::from);
    let version = atlas.join(std::fs::read_to_string(atlas.join("latest")).unwrap().trim());
    let report = std::fs::read(version.join("report.json")).unwrap();
    let report: serde_json::Value = serde_json::from_slice(&report).unwrap();
    let specimens = report["specimens"].as_array().unwrap();
    let names: Vec<&str> = specimens.iter().map(|s| s["name"].as_str().unwrap()).collect();
    assert_eq!(names, SPECIMENS.map(|(name, _)| name));
    for (specimen, (name, period_nm)) in specimens.iter().zip(SPECIMENS) {
        assert!(specimen["failed"].is_null(), "{name}: {}", specimen["failed"]);
        let warnings = specimen["warnings"].to_string();
        let pitch_nm = (0..2).map(|axis| specimen["pitch_nm"][axis].as_f64().unwrap()).fold(0.0, f64::max);
        assert_eq!(
            warnings.contains("sampling answers for"),
            pitch_nm > PITCH_MAX_NM,
            "{name}, {pitch_nm} nm: {warnings}"
        );
        if let Some(expected) = period_nm {
            let found = specimen["statistics"]["dominant_periods"][0]["period_nm"].as_f64().unwrap();
            assert!((found / expected - 1.0).abs() < 0.05, "{name}: {found} nm, {expected} nm expected");
        }
        for file in ["specimen.json", "table.000.exr", "lobe.exr", "preview.png", "scenes/sphere.png"] {
            assert!(version.join(name).join(file).is_file(), "{name}/{file}");
        }
    }
    assert!(version.join("elaphe_guttata/scenes/screen.compare.png").is_file());
}

/// The atlas of the manifest, made in this place.
fn made(place: &Place) -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    // Relative paths start at the manifest: here it lies elsewhere.
    let manifest = std::fs::read_to_string(root.join("tests/real_scans.toml")).unwrap();
    let shared = root.join("../shared").canonicalize().unwrap();
    let manifest = manifest
        .replace("\"../../shared/", &format!("\"{}/", shared.display()))
        .replace("out = \"../out/atlas\"", "out = \"out\"");
    place.write("real_scans.toml", &manifest);
    let run = call(place.folder(), "--quiet run real_scans.toml").ended(0);
    assert!(run.stdout.starts_with("published out/real_scans/v0001 in "), "{}", run.stdout);
    assert!(!run.stderr.contains("failed"), "{}", run.stderr);
    place.call("verify out/real_scans --samples 0").ended(0);
    place.path("out/real_scans")
}
