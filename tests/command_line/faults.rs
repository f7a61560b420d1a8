//! Specimens that fail among others that do not, and manifests that are wrong.

use std::fs;
use std::io::{Error as IoError, ErrorKind};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use diffraction_atlas::manifest::{self, convert::run_config};
use diffraction_atlas::stages::results::{HeightMapFile, SpectrumFile};
use diffraction_atlas::stages::run::pipeline::{self, Heights, Helpers};
use diffraction_brdf::error::Error;
use diffraction_build::ground::progress::Silent;

use crate::place::{HEAD, LASERS, Place, ROUGH, SCENES, WAVE, contents, usual};

/// A specimen whose scan is cut short, one whose heights mean nothing, and one too small for its window.
const BAD: &str = r#"[[specimen]]
name = "cut"
scans = ["cut.tif"]
[[specimen]]
name = "unitless"
scans = ["unitless.gsf"]
[[specimen]]
name = "narrow"
scans = ["rough.tif"]
coherence = { sigma_um = 5, edge = "fade" }
"#;

fn add_bad_scans(place: &Place) {
    let rough = fs::read(place.path("rough.tif")).unwrap();
    fs::write(place.path("cut.tif"), &rough[..rough.len() / 2]).unwrap();
    let mut gsf = b"Gwyddion Simple Field 1.0\nXRes = 8\nYRes = 8\n".to_vec();
    gsf.resize(gsf.len().next_multiple_of(4).max(gsf.len() + 4 - gsf.len() % 4), 0);
    gsf.extend([0; 8 * 8 * 4]);
    fs::write(place.path("unitless.gsf"), gsf).unwrap();
}

#[test]
fn bad_specimens_never_stop_the_others() {
    let place = Place::with_scans();
    add_bad_scans(&place);
    place.write("m.toml", &[HEAD, LASERS, BAD, ROUGH, WAVE, SCENES].concat());
    let run = place.call("--quiet run m.toml").ended(1);
    assert!(run.stdout.starts_with("published out/small/v0001 in "), "{}", run.stdout);
    let causes = [("cut", "cut.tif: "), ("unitless", "pitch_nm"), ("narrow", "sigma")];
    for (name, cause) in causes {
        let line = run.stderr.split("failed: ").find(|line| line.starts_with(name));
        assert!(line.is_some_and(|line| line.contains(cause)), "{name}: {}", run.stderr);
    }
    assert!(run.stderr.ends_with("3 failed; the rest is done\n"), "{}", run.stderr);

    let report = place.json("out/small/v0001/report.json");
    let failures = report["failures"].as_array().unwrap();
    let page = fs::read_to_string(place.path("out/small/v0001/report.html")).unwrap();
    assert_eq!(failures.len(), causes.len());
    for (failure, (name, cause)) in failures.iter().zip(causes) {
        assert_eq!(failure["specimen"], name);
        assert!(failure["message"].as_str().unwrap().contains(cause), "{failure}");
        assert!(page.contains(&format!(">{name}<")), "{name} is in the report");
    }
    let index = place.json("out/small/v0001/atlas.json");
    let names: Vec<_> = index["specimens"].as_array().unwrap().iter().map(|s| s["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["rough", "wave"]);
    for (name, _) in causes {
        assert!(!place.path(&format!("out/small/v0001/{name}")).exists(), "{name}");
    }
    place.call("verify out/small --manifest m.toml").ended(0);

    // The plan knows it before.
    let plan = place.call("plan m.toml").ended(1);
    for (name, _) in causes {
        assert!(plan.stderr.contains(&format!("failed: {name}: ")), "{name}: {}", plan.stderr);
    }
}

#[test]
fn where_every_specimen_fails_nothing_is_published() {
    let place = Place::with_scans();
    add_bad_scans(&place);
    place.write("m.toml", &[HEAD, LASERS, BAD].concat());
    let run = place.call("--quiet run m.toml").ended(1);
    assert_eq!(run.stdout, "");
    assert_eq!(run.stderr.matches("failed: ").count(), 3, "{}", run.stderr);
    assert!(place.versions().is_empty(), "{:?}", place.versions());
}

/// Pictures of heights on a disk that is full when the second specimen's turn comes.
fn illustrate_until_full(
    _: &Heights,
    folder: &Path,
    _: &str,
) -> diffraction_brdf::error::Result<(HeightMapFile, SpectrumFile)> {
    if folder.ends_with("wave") {
        return Err(Error::disk(&folder.join("heights.png"), "write", IoError::from(ErrorKind::StorageFull)));
    }
    let png = String::new();
    Ok((
        HeightMapFile { png: png.clone(), scale_bar_um: 1.0, low_nm: 0.0, high_nm: 1.0, replaced_samples: 0 },
        SpectrumFile { png, half_range_per_um: 1.0, low_db: -60.0 },
    ))
}

#[test]
fn a_full_disk_ends_the_run_and_publishes_nothing() {
    let place = Place::with_scans();
    place.publish(&usual());
    place.write("m.toml", &usual().replace("{ n = 1.5 }", "{ n = 1.6 }"));
    let (manifest, text) = manifest::load(&place.path("m.toml")).unwrap();
    let write_report = |_: &_, _: &Path| Ok(());
    let helpers = Helpers {
        illustrate: &illustrate_until_full,
        write_report: &write_report,
        progress: &Silent,
        finished: &|_| (),
        started: "",
    };
    let error = pipeline::run(&run_config(manifest, text), &helpers).unwrap_err();
    assert!(error.to_string().contains("wave/heights.png: cannot write"), "{error}");
    assert_eq!(error.exit_status(), 75, "worth trying again");
    // What was finished before waits in the store for the next run.
    let left: Vec<String> = place.versions().into_iter().filter(|name| name != ".units").collect();
    assert_eq!((left, place.latest()), (vec!["latest".into(), "v0001".into()], "v0001".into()));
}

/// A disk that is full once.
fn illustrate_after_a_full_disk(
    heights: &Heights,
    folder: &Path,
    name: &str,
) -> diffraction_brdf::error::Result<(HeightMapFile, SpectrumFile)> {
    static WAS_FULL: AtomicBool = AtomicBool::new(false);
    if folder.ends_with("wave") && WAS_FULL.swap(true, Ordering::Relaxed) {
        return illustrate_until_full(heights, Path::new("other"), name);
    }
    illustrate_until_full(heights, folder, name)
}

#[test]
fn a_full_disk_is_relieved_of_the_cache_first() {
    let place = Place::with_scans();
    place.write("m.toml", &usual());
    let (manifest, text) = manifest::load(&place.path("m.toml")).unwrap();
    let write_report = |_: &_, _: &Path| Ok(());
    let helpers = Helpers {
        illustrate: &illustrate_after_a_full_disk,
        write_report: &write_report,
        progress: &Silent,
        finished: &|_| (),
        started: "",
    };
    let outcome = pipeline::run(&run_config(manifest, text), &helpers).unwrap();
    assert_eq!(outcome.results.failures, []);
    assert_eq!((place.latest().as_str(), outcome.origins.len()), ("v0001", 2));
}

/// Line and column of a text's first occurrence, from 1.
fn position(manifest: &str, text: &str) -> (usize, usize) {
    let at = manifest.find(text).unwrap();
    let line_start = manifest[..at].rfind('\n').map_or(0, |at| at + 1);
    (manifest[..at].matches('\n').count() + 1, manifest[line_start..at].chars().count() + 1)
}

#[test]
fn a_wrong_manifest_writes_nothing_and_says_where() {
    let place = Place::with_scans();
    let wave = "name = \"wave\"\n";
    let faults = [
        // A typo in a key.
        ("sigma_um", "sigma_mu", "sigma_mu", "the nearest known key is `sigma_um`"),
        ("[[scene]]", "[[scenes]]", "scenes]]", "`scene`"),
        ("size = 65", "size = 64", "64", "`tables.size` must be odd"),
        // A missing file, and a pattern without any.
        ("\"wave.tif\"", "\"waves.tif\"", "\"waves.tif\"", "waves.tif"),
        ("\"wave.tif\"", "\"w*.gsf\"", "\"w*.gsf\"", "w*.gsf"),
        // A wrong unit: of the key, of the heights, and none at all.
        ("sigma_um = 2", "sigma_nm = 2000", "sigma_nm", "sigma_um = 2"),
        (wave, "name = \"wave\"\nheight = { unit = \"furlong\" }\n", "\"furlong\"", "\"nm\""),
        (wave, "name = \"wave\"\nheight = { unit = 7 }\n", "7 }", "specimen \"wave\": height.unit"),
        // A negative pitch, and other numbers out of range.
        (wave, "name = \"wave\"\npitch_nm = -48.8\n", "-48.8", "specimen \"wave\": pitch_nm"),
        (wave, "name = \"wave\"\npitch_nm = [80, 0]\n", "0]\n", "specimen \"wave\": pitch_nm"),
        (wave, "name = \"wave\"\npitch_nm = nan\n", "nan\n", "specimen \"wave\": pitch_nm"),
        // Two specimens of one name; a scene of a specimen that is not there.
        (wave, "name = \"rough\"\n", "", "repeats the name \"rough\""),
        ("shape = \"sphere\"", "shape = \"sphere\"\nspecimen = \"waves\"", "\"waves\"", "did you mean \"wave\"?"),
        // No TOML at all.
        ("[tables]", "[tables", "", "unclosed table"),
    ];
    for (old, new, marker, fragment) in faults {
        let manifest = usual().replacen(old, new, 1);
        assert_ne!(manifest, usual(), "{old}");
        place.write("m.toml", &manifest);
        let before = contents(place.folder());
        for command in ["run", "plan"] {
            let called = place.call(&format!("{command} m.toml")).ended(2);
            assert_eq!(called.stdout, "", "{new}");
            let prefix = "error: m.toml:";
            assert!(called.stderr.starts_with(prefix), "{new}: {}", called.stderr);
            let mut numbers = called.stderr[prefix.len()..].split(':').map(|n| n.parse::<usize>());
            let (line, column) = (numbers.next().unwrap().unwrap(), numbers.next().unwrap().unwrap());
            let expected = match marker {
                // The second of two equal names is at fault; TOML's own faults are where the parser gave up.
                "" if new.contains("rough") => (position(&manifest, "wave.tif").0 - 1, 8),
                "" => (line, column),
                marker => position(&manifest, marker),
            };
            assert_eq!((line, column), expected, "{new}: {}", called.stderr);
            assert!(called.stderr.contains(fragment), "{new}: {fragment}: {}", called.stderr);
        }
        assert_eq!(contents(place.folder()), before, "{new} wrote something");
        assert!(!place.path("out").exists(), "{new} made a folder");
    }
}
