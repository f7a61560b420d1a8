//! Locks: what a run was made from and came to, and later runs held to it.

use std::fs;

use crate::place::{Called, HEAD, LASERS, Place, ROUGH, SCENES, WAVE, contents, usual};

/// A place with a published, locked atlas.
fn locked() -> Place {
    let place = Place::with_scans();
    place.write("m.toml", &usual());
    place.call("--quiet run m.toml --lock").ended(0);
    place
}

/// A frozen run that must find this difference, and publish nothing.
#[track_caller]
fn differs(place: &Place, difference: &str) -> Called {
    let before = place.versions();
    let run = place.call("--quiet run m.toml --frozen").ended(1);
    assert!(run.stderr.starts_with("error: not as locked: ") && run.stderr.contains(difference), "{}", run.stderr);
    assert_eq!((run.stdout.as_str(), place.versions()), ("", before));
    run
}

#[test]
fn a_frozen_run_makes_the_same_again() {
    let place = locked();
    let lock = place.json("m.lock");
    assert_eq!((&lock["atlas"], &lock["version"]), (&"small".into(), &"v0001".into()));
    assert!(lock["files"]["rough/table.000.exr"].is_string() && lock["files"].get("report.html").is_none());
    let run = place.call("--quiet run m.toml --frozen").ended(0);
    assert!(run.stdout.contains("holds the same already"), "{}", run.stdout);
    // From nothing, and from nothing but the store.
    fs::remove_dir_all(place.path("out")).unwrap();
    let run = place.call("--quiet run m.toml --frozen --no-cache").ended(0);
    assert!(run.stdout.contains(": 2 made"), "{}", run.stdout);
    fs::remove_dir_all(place.path("out")).unwrap();
    place.call("--quiet run m.toml --shard 1/1").ended(0);
    place.call("--quiet merge m.toml --frozen").ended(0);
    assert_eq!(place.versions(), ["latest", "v0001"]);
    // Writing it again changes no byte, nor does a comment.
    let before = fs::read(place.path("m.lock")).unwrap();
    place.write("m.toml", &("# last night's\n".to_owned() + &usual()));
    place.call("--quiet run m.toml --frozen").ended(0);
    place.call("--quiet run m.toml --lock").ended(0);
    assert_eq!(fs::read(place.path("m.lock")).unwrap(), before);
}

#[test]
fn the_first_difference_is_named_and_nothing_published() {
    let place = locked();
    for (manifest, difference) in [
        (usual().replace("n = 1.5", "n = 1.6"), "rough: optics.material.dielectric.n: 1.5 in the lock, 1.6 now"),
        (usual().replace("size = 65", "size = 67"), "rough: tables.size: 65 in the lock, 67 now"),
        (usual().replace("size_px = 24", "size_px = 25"), "rough: scenes.ball.scene.size_px: 24 in the lock, 25 now"),
        ([HEAD, LASERS, ROUGH, SCENES].concat(), "2 specimens, and the manifest 1"),
        (usual().replace("name = \"wave\"", "name = \"wave_b\""), "wave_b: it is not in the lock"),
        (usual().replace("name = \"small\"", "name = \"large\""), "locks the atlas \"small\""),
    ] {
        place.write("m.toml", &manifest);
        differs(&place, difference);
    }
    place.write("m.toml", &usual());
    let whole = fs::read(place.path("wave.tif")).unwrap();
    place.scan("wave.tif", crate::place::rough(9), [96, 64], [80.0, 80.0]);
    let run = differs(&place, "wave: inputs.wave.tif: sha256 ");
    assert!(run.stderr.contains("`--lock` in place of `--frozen`"), "{}", run.stderr);
    fs::write(place.path("wave.tif"), whole).unwrap();
    place.call("--quiet run m.toml --frozen").ended(0);
}

#[test]
fn a_file_that_comes_out_otherwise_is_a_difference() {
    let place = locked();
    let mut lock = place.json("m.lock");
    lock["files"]["wave/table.000.exr"] = "0".repeat(64).into();
    place.write("m.lock", &serde_json::to_string_pretty(&lock).unwrap());
    differs(&place, "wave/table.000.exr: sha256 000000000000 in the lock, sha256 ");
    // Also where it has to be made.
    fs::remove_dir_all(place.path("out/small/v0001")).unwrap();
    fs::remove_file(place.path("out/small/latest")).unwrap();
    let before = place.versions();
    assert!(before.is_empty());
    let run = place.call("--quiet run m.toml --frozen").ended(1);
    assert!(run.stderr.contains("wave/table.000.exr: sha256 000000000000 in the lock"), "{}", run.stderr);
    assert_eq!(place.versions(), [".units"], "what was made is there for a run that is not held to it");
    let run = place.call("--quiet run m.toml --lock").ended(0);
    assert!(run.stdout.contains(": 2 unchanged"), "{}", run.stdout);
    place.call("--quiet run m.toml --frozen").ended(0);
}

#[test]
fn what_failed_is_not_locked_and_fails_a_frozen_run() {
    let place = locked();
    let before = fs::read(place.path("m.lock")).unwrap();
    let whole = fs::read(place.path("rough.tif")).unwrap();
    fs::write(place.path("rough.tif"), &whole[..whole.len() / 2]).unwrap();
    differs(&place, "rough: inputs.rough.tif: ");
    let run = place.call("--quiet run m.toml --lock").ended(1);
    assert!(run.stderr.contains("the lock was not written: not everything was made"), "{}", run.stderr);
    assert_eq!(fs::read(place.path("m.lock")).unwrap(), before);
}

#[test]
fn a_lock_that_is_none_or_cannot_be_written_is_said() {
    let place = Place::with_scans();
    place.write("m.toml", &[HEAD, LASERS, WAVE, SCENES].concat());
    let run = place.call("--quiet run m.toml --frozen").ended(2);
    assert!(run.stderr.contains("m.lock: there is no lock; `run --lock` writes it"), "{}", run.stderr);
    assert!(!place.path("out").exists());
    place.write("m.lock", "{}");
    let run = place.call("--quiet run m.toml --frozen").ended(2);
    assert!(run.stderr.contains("m.lock: this is no lock"), "{}", run.stderr);
    // Somebody's file of that name stays; the run is done all the same.
    let before = contents(place.folder());
    let run = place.call("--quiet run m.toml --lock").ended(1);
    assert!(run.stdout.starts_with("published ") && run.stderr.contains("left as it is"), "{}", run.stderr);
    assert_eq!(contents(place.folder())["m.lock"], before["m.lock"]);
    place.call("--quiet run m.toml").ended(0);
    for wrong in ["--frozen --lock", "--frozen --only wave", "--lock --shard 1/2", "--frozen --dry-run"] {
        place.call(&format!("run m.toml {wrong}")).ended(2);
    }
}

#[test]
fn a_version_that_a_lock_names_is_not_pruned() {
    let place = locked();
    for n in ["1.6", "1.7"] {
        place.publish(&usual().replace("1.5", n));
    }
    let said = place.call("prune out/small --keep 1 --dry-run").ended(0).stdout;
    assert_eq!(said, "would remove v0001, v0002\n");
    assert_eq!(place.call("prune out/small --keep 1 --lock m.lock").ended(0).stdout, "removed v0002\n");
    assert_eq!(place.versions(), ["latest", "v0001", "v0003"]);
    fs::rename(place.path("out/small"), place.path("out/other")).unwrap();
    let refused = place.call("prune out/other --keep 1 --lock m.lock").ended(2);
    assert!(refused.stderr.contains("m.lock locks the atlas \"small\""), "{}", refused.stderr);
}
