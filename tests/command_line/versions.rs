//! Runs and the versions they publish, and the commands that look at them.

use std::collections::BTreeSet;

use diffraction_brdf::atlas;

use crate::place::{HEAD, LASERS, Place, ROUGH, SCENES, contents, usual};

/// The layout of a version with `tables` tables per specimen, one window per scan over all positions.
fn layout(specimens: &[(&str, [usize; 2])], scenes: &[&str]) -> BTreeSet<String> {
    let mut files: BTreeSet<String> =
        ["atlas.json", "FORMAT.md", "manifest.toml", "report.html", "report.json"].map(String::from).into();
    for (specimen, [tables, spectral]) in specimens {
        let pictures = ["preview.png", "heights.png", "spectrum.png", "reflection_00deg.png", "reflection_45deg.png"];
        for file in ["specimen.json", "result.json", "lobe.exr", "spectral_lobe.exr"].into_iter().chain(pictures) {
            files.insert(format!("{specimen}/{file}"));
        }
        files.extend((0..*tables).map(|n| format!("{specimen}/table.{n:03}.exr")));
        files.extend((0..spectral.div_ceil(3)).map(|n| format!("{specimen}/spectral.{n:03}.exr")));
        for scene in scenes {
            for ending in [".exr", ".png", ".reference.exr", ".difference.exr", ".difference.png", ".compare.png"] {
                files.insert(format!("{specimen}/scenes/{scene}{ending}"));
            }
        }
    }
    files
}

#[test]
fn a_run_publishes_once_and_again_only_after_a_change() {
    let place = Place::with_scans();
    place.write("m.toml", &usual());
    let first = place.call("run m.toml").ended(0);
    assert!(first.stdout.starts_with("published out/small/v0001 in "), "{}", first.stdout);
    assert!(first.stdout.contains("out/small/v0001/report.html\n"), "{}", first.stdout);
    assert!(first.stderr.contains("[1/2] rough: ") && first.stderr.contains("[2/2] wave: "), "{}", first.stderr);
    assert_eq!((place.versions(), place.latest().as_str()), (vec!["latest".into(), "v0001".into()], "v0001"));

    let v1 = contents(&place.path("out/small/v0001"));
    let tables = |name: &str| {
        let specimen = place.json(&format!("out/small/v0001/{name}/specimen.json"));
        let spectral = specimen["spectral"]["tables"].as_u64().unwrap();
        [specimen["tables"]["tables"].as_array().unwrap().len(), spectral as usize]
    };
    let expected = layout(&[("rough", tables("rough")), ("wave", tables("wave"))], &["map", "ball"]);
    assert_eq!(v1.keys().cloned().collect::<BTreeSet<_>>(), expected);
    let verified = place.call("verify out/small --manifest m.toml").ended(0);
    assert!(verified.stdout.contains(&format!("{} files checked", expected.len())), "{}", verified.stdout);
    for region in ["whole hemisphere", "near specular"] {
        // Of each specimen the recorded directions, and fresh ones.
        assert_eq!(verified.stdout.matches(region).count(), 4, "{}", verified.stdout);
    }

    let second = place.call("--quiet run m.toml").ended(0);
    assert!(second.stdout.contains("out/small/v0001") && !second.stdout.contains("v0002"), "{}", second.stdout);
    assert_eq!(second.stderr, "");
    assert_eq!(contents(&place.path("out/small/v0001")), v1);
    assert_eq!(place.versions(), ["latest", "v0001"]);

    let third = place.publish(&usual().replace("n = 1.5", "n = 1.6"));
    assert!(third.stdout.starts_with("published out/small/v0002 in "), "{}", third.stdout);
    assert_eq!((place.versions().len(), place.latest().as_str()), (3, "v0002"));
    assert_eq!(contents(&place.path("out/small/v0001")), v1, "published versions never change");
    place.call("verify out/small --manifest m.toml").ended(0);

    let diff = place.call("diff out/small/v0001 out/small/v0002").ended(1);
    assert!(diff.stdout.contains("optics.material.dielectric.n: 1.5 -> 1.6"), "{}", diff.stdout);
    let diff = place.call("diff out/small/v0001 out/small --json").ended(1).json();
    let changed: Vec<&str> =
        diff["specimens"].as_array().unwrap().iter().map(|s| s["name"].as_str().unwrap()).collect();
    assert_eq!(changed, ["rough"], "the other specimen did not change");
    assert!(diff["specimens"][0]["check_values"]["max_relative"].as_f64().unwrap() > 0.1);
    let same = place.call("diff out/small/v0002 out/small").ended(0);
    assert!(same.stdout.contains("hold the same"), "{}", same.stdout);
}

#[test]
fn going_back_to_an_older_manifest_is_a_change() {
    let place = Place::with_scans();
    let manifest = |n: &str| [HEAD, LASERS, &ROUGH.replace("1.5", n)].concat();
    for n in ["1.5", "1.6", "1.5"] {
        place.publish(&manifest(n));
    }
    assert_eq!(place.latest(), "v0003");
    let diff = place.call("diff out/small/v0001 out/small/v0003").ended(0);
    assert!(diff.stdout.contains("hold the same"), "{}", diff.stdout);
}

#[test]
fn the_number_of_threads_changes_no_byte() {
    // A continuous spectrum and several windows: every sum over wavelengths and windows is taken.
    let optics = LASERS
        .replace("{ lines_nm = [633, 532, 450] }", "\"D65\"\nwavelength_nm = [550, 570]")
        .replace("sigma_um = 2, edge = \"tile\"", "sigma_um = 0.6, edge = \"fade\"");
    let manifest = [HEAD, &optics, ROUGH, SCENES].concat();
    let runs = ["1", "2", "3"].map(|threads| {
        let place = Place::with_scans();
        place.write("m.toml", &manifest);
        place.call(&format!("--quiet --threads {threads} run m.toml")).ended(0);
        let folder = place.path("out/small/v0001");
        let mut files = contents(&folder);
        assert!(files.keys().any(|name| name.ends_with("lobe.000.exr")), "several windows leave a cross term");
        files.retain(|name, _| !atlas::may_differ(name));
        // The index holds the digests of the timed files, so it is compared without them.
        files.remove("atlas.json").unwrap();
        (files, atlas::read_index(&folder).unwrap().content())
    });
    for run in &runs[1..] {
        for (name, bytes) in &runs[0].0 {
            assert_eq!(run.0.get(name), Some(bytes), "{name}");
        }
        assert_eq!(run.1, runs[0].1);
    }
}

#[test]
fn list_inspect_and_plan_tell_what_there_is_and_what_would_be() {
    let place = Place::with_scans();
    place.write("m.toml", &usual());
    let before = contents(place.folder());
    let plan = place.call("plan m.toml").ended(0);
    for part in ["atlas \"small\"", "rough", "wave", "left out:"] {
        assert!(plan.stdout.contains(part), "{part}: {}", plan.stdout);
    }
    let plan = place.call("plan m.toml --json").ended(0).json();
    assert_eq!(contents(place.folder()), before, "a plan writes nothing");

    place.call("--quiet run m.toml").ended(0);
    let built = place.json("out/small/v0001/rough/specimen.json");
    let forecast = &plan["specimens"][0]["forecast"];
    for (planned, done) in [("windows", "windows"), ("transforms", "transforms")] {
        assert_eq!(forecast[planned], built["build"][done], "{planned}");
    }
    assert_eq!(forecast["size"], 65);

    let list = place.call("list out").ended(0);
    assert!(list.stdout.starts_with("small\n  v0001 (latest): 2 specimens, "), "{}", list.stdout);
    assert!(list.stdout.ends_with(": rough, wave\n"), "{}", list.stdout);
    let list = place.call("list out --json").ended(0).json();
    assert_eq!(list[0]["versions"][0]["files"], contents(&place.path("out/small/v0001")).len());

    let scan = place.call("inspect rough.tif").ended(0);
    for part in ["80 x 64 samples", "80.0000 x 90.0000 nm", "rms height 29.98", " to 2.000 at 380 nm: periods"] {
        assert!(scan.stdout.contains(part), "{part}: {}", scan.stdout);
    }
    let atlas = place.call("inspect out/small").ended(0);
    assert!(atlas.stdout.contains("atlas \"small\""), "{}", atlas.stdout);
    assert!(atlas.stdout.contains("\nrough: ") && atlas.stdout.contains("\nwave: "), "{}", atlas.stdout);
    let atlas = place.call("inspect out/small/v0001 --json").ended(0).json();
    assert_eq!(atlas["index"]["specimens"][1]["name"], "wave");
    assert_eq!(atlas["specimens"][0], built);
}
