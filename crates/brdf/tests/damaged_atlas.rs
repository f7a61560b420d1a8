//! Atlases that are damaged, partial, newer, or hostile: an error that says where, or the published values; never a panic.

#[path = "tiny_atlas/mod.rs"]
mod tiny_atlas;

use std::fs;
use std::path::{Path, PathBuf};

use diffraction_brdf::atlas::{AtlasIndex, SpecimenEntry};
use diffraction_brdf::direction::from_angles_deg;
use diffraction_brdf::specimen::SCHEMA;
use diffraction_brdf::{Atlas, Brdf, Error, Result, Vec3, Xyz, files};
use proptest::prelude::*;
use serde_json::{Value, json};
use tiny_atlas::{publish, write_tiny_atlas};

fn tiny() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    write_tiny_atlas(folder.path());
    folder
}

fn directions() -> impl Iterator<Item = (Vec3, Vec3)> {
    let at = |n: usize| from_angles_deg((n * 37 % 95) as f64, (n * 113) as f64);
    (0..40).map(move |n| (at(n), at(3 * n + 1)))
}

/// Values at many directions, among them some that are no directions above the surface.
fn values(brdf: &Brdf) -> Vec<Xyz> {
    let odd = [[f64::NAN, 0.0, 1.0], [0.0; 3], [1e300, 0.0, 1e300], [0.0, 0.0, f64::INFINITY], [0.0, 1.0, 1e-320]];
    for a in odd {
        for b in odd {
            brdf.eval(a, b);
            brdf.pdf(a, b);
            brdf.answers(a, b);
            brdf.sample(a, [0.5; 3]);
        }
    }
    for (n, (_, wo)) in directions().enumerate() {
        if let Some(sample) = brdf.sample(wo, [n as f64 / 40.0, 0.3, 0.999_999]) {
            assert!(sample.pdf > 0.0 && sample.wi[2] > 0.0, "{sample:?}");
        }
    }
    directions().map(|(wi, wo)| brdf.eval(wi, wo)).collect()
}

fn read_all(root: &Path) -> Result<Vec<Xyz>> {
    let atlas = Atlas::open(root)?;
    let names: Vec<&str> = atlas.specimens().iter().map(|specimen| specimen.name.as_str()).collect();
    assert!(!names.is_empty());
    Ok(values(&atlas.brdf(names[0])?))
}

fn all_files(root: &Path) -> Vec<PathBuf> {
    files::list(root).unwrap().into_iter().map(|file| root.join(file)).collect()
}

/// An error must name a path of the atlas and say what to do.
fn check_error(error: &Error, root: &Path) {
    let text = error.to_string();
    assert!(text.contains(root.to_str().unwrap()) && text.len() < 2_000, "{text}");
}

#[test]
fn check_values_are_met() {
    let folder = tiny();
    let brdf = Atlas::open(folder.path()).unwrap().brdf("grating").unwrap();
    assert_eq!(brdf.check_values().len(), 2);
    for check in brdf.check_values() {
        assert_eq!(brdf.eval(check.wi, check.wo), check.xyz);
        assert!(check.xyz[1] > 0.0);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn changed_and_cut_files_give_an_error_or_the_published_values(
        file in any::<prop::sample::Index>(), at in any::<prop::sample::Index>(), flip in 1u8.., cut in any::<bool>(),
    ) {
        let folder = tiny();
        let sound = read_all(folder.path()).unwrap();
        let paths = all_files(folder.path());
        let path = &paths[file.index(paths.len())];
        let mut bytes = fs::read(path).unwrap();
        let at = at.index(bytes.len());
        if cut { bytes.truncate(at) } else { bytes[at] ^= flip }
        fs::write(path, bytes).unwrap();
        match read_all(folder.path()) {
            Ok(values) => prop_assert_eq!(values, sound),
            Err(error) => check_error(&error, folder.path()),
        }
    }

    /// As above where the index was made anew, so that no digest gives the change away.
    #[test]
    fn files_changed_before_they_were_published_never_panic(
        file in any::<prop::sample::Index>(), at in any::<prop::sample::Index>(), flip in 1u8.., cut in any::<bool>(),
    ) {
        let folder = tiny();
        let version = folder.path().join("v0001");
        let paths: Vec<_> = all_files(&version.join("grating"));
        let path = &paths[file.index(paths.len())];
        let mut bytes = fs::read(path).unwrap();
        let at = at.index(bytes.len());
        if cut { bytes.truncate(at) } else { bytes[at] ^= flip }
        fs::write(path, bytes).unwrap();
        republish(&version);
        if let Err(error) = read_all(folder.path()) {
            check_error(&error, folder.path());
        }
    }

    /// Any number or text in specimen.json replaced by another.
    #[test]
    fn hostile_fields_never_panic(field in any::<prop::sample::Index>(), with in any::<prop::sample::Index>()) {
        let hostile = [
            json!(0), json!(-1), json!(1), json!(2), json!(1e308), json!(-1e308), json!(5e-324), json!(u64::MAX), json!(3.5),
            json!(null), json!([]), json!({}), json!(""), json!("../table.000.exr"), json!("table.001.exr"), json!(true),
            json!("taylor"), json!("ideal"), json!({"conductor": {"n": 0.0, "k": -1.0}}), json!("lobe.exr"),
        ];
        let folder = tiny();
        let version = folder.path().join("v0001");
        let path = version.join("grating/specimen.json");
        let mut record: Value = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
        let mut places = Vec::new();
        pointers(&record, String::new(), &mut places);
        let place = &places[field.index(places.len())];
        *record.pointer_mut(place).unwrap() = hostile[with.index(hostile.len())].clone();
        fs::write(&path, record.to_string()).unwrap();
        republish(&version);
        if let Err(error) = read_all(folder.path()) {
            check_error(&error, folder.path());
        }
    }
}

fn republish(version: &Path) {
    let specimens = vec![SpecimenEntry { name: "grating".into(), species: String::new(), stale: None }];
    publish(version, AtlasIndex::new("tiny", "", vec![], specimens));
}

fn pointers(value: &Value, at: String, found: &mut Vec<String>) {
    match value {
        Value::Object(map) => map.iter().for_each(|(key, value)| pointers(value, format!("{at}/{key}"), found)),
        Value::Array(items) => {
            items.iter().enumerate().for_each(|(n, value)| pointers(value, format!("{at}/{n}"), found));
        }
        _ => {}
    }
    found.push(at);
}

#[test]
fn a_partial_newer_version_is_passed_over_and_told() {
    let folder = tiny();
    let sound = read_all(folder.path()).unwrap();
    let newer = folder.path().join("v0002");
    fs::create_dir(&newer).unwrap();
    let atlas = Atlas::open(folder.path()).unwrap();
    assert!(atlas.folder().ends_with("v0001"));
    assert!(atlas.passed_over()[0].contains("v0002"), "{:?}", atlas.passed_over());
    assert_eq!(read_all(folder.path()).unwrap(), sound);
    // One whose files are not all there.
    for file in all_files(&folder.path().join("v0001")) {
        let to = newer.join(file.strip_prefix(folder.path().join("v0001")).unwrap());
        fs::create_dir_all(to.parent().unwrap()).unwrap();
        fs::copy(&file, to).unwrap();
    }
    assert!(Atlas::open(folder.path()).unwrap().passed_over().is_empty());
    fs::remove_file(newer.join("grating/lobe.exr")).unwrap();
    let atlas = Atlas::open(folder.path()).unwrap();
    assert!(atlas.passed_over()[0].contains("lobe.exr: it is missing"), "{:?}", atlas.passed_over());
    // Asked for by its own folder, the file is named.
    let error = Atlas::open(&newer).unwrap().brdf("grating").unwrap_err();
    assert!(error.to_string().contains("lobe.exr: it is missing\n  Restore the file"), "{error}");
}

#[test]
fn another_schema_is_named_in_either_file() {
    for file in ["atlas.json", "grating/specimen.json"] {
        let folder = tiny();
        let version = folder.path().join("v0001");
        let path = version.join(file);
        let text = fs::read_to_string(&path).unwrap();
        fs::write(&path, text.replace(&format!("\"schema\": {SCHEMA}"), &format!("\"schema\": {}", SCHEMA + 1)))
            .unwrap();
        if file != "atlas.json" {
            republish(&version);
        }
        let error = read_all(folder.path()).unwrap_err().to_string();
        let said = format!("its schema is {}, this program reads 1 to {SCHEMA}", SCHEMA + 1);
        assert!(error.contains(&said), "{error}");
    }
}

#[test]
fn what_is_no_atlas_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let error = Atlas::open(folder.path()).unwrap_err();
    assert!(matches!(error, Error::Call(_)) && error.to_string().contains("this is no atlas"), "{error}");
    let missing = folder.path().join("missing");
    assert!(Atlas::open(&missing).unwrap_err().to_string().contains("missing: there is no such folder"));
}
