//! Published versions with something wrong with them, and what `verify` says.

use std::fs;

use diffraction_brdf::atlas;

use crate::place::{HEAD, LASERS, Place, ROUGH, contents, usual};

#[test]
fn one_changed_byte_in_any_file_is_found_and_named() {
    let place = Place::with_scans();
    place.publish(&usual());
    let folder = place.path("out/small/v0001");
    let mut random = fastrand::Rng::with_seed(7);
    let files = contents(&folder);
    assert!(files.len() > 40);
    for (name, bytes) in &files {
        let mut changed = bytes.clone();
        let at = random.usize(..changed.len());
        changed[at] ^= 1 << random.u8(..8);
        fs::write(folder.join(name), &changed).unwrap();
        // The atlas, its version, and with the scans at hand: the damage is seen on every way.
        for line in ["verify out/small", "verify out/small/v0001 --manifest m.toml"] {
            let verified = place.call(line).ended(1);
            assert!(verified.stderr.contains(&format!("failed: {name}: ")), "{name}, byte {at}: {}", verified.stderr);
            assert!(verified.stderr.ends_with("1 failed; the rest is done\n"), "{}", verified.stderr);
        }
        fs::write(folder.join(name), bytes).unwrap();
    }
    place.call("verify out/small --manifest m.toml").ended(0);
}

#[test]
fn files_missing_added_and_cut_short_are_named() {
    let place = Place::with_scans();
    place.publish(&usual());
    let folder = place.path("out/small/v0001");
    let table = folder.join("wave/table.000.exr");
    let bytes = fs::read(&table).unwrap();
    let failures = |expected: &str| {
        let json = place.call("verify out/small --json").ended(1).json();
        let failures = json["files"]["failures"].as_array().unwrap().clone();
        assert_eq!(failures.len(), 1, "{failures:?}");
        assert_eq!(failures[0]["file"], expected);
    };
    fs::write(&table, &bytes[..bytes.len() - 1]).unwrap();
    failures("wave/table.000.exr");
    fs::remove_file(&table).unwrap();
    failures("wave/table.000.exr");
    fs::write(&table, &bytes).unwrap();
    fs::write(folder.join("wave/notes.txt"), "mine").unwrap();
    failures("wave/notes.txt");
    fs::remove_file(folder.join("wave/notes.txt")).unwrap();
    place.call("verify out/small").ended(0);
    fs::remove_file(folder.join("atlas.json")).unwrap();
    failures("atlas.json");
}

#[test]
fn a_scan_that_was_exchanged_is_named() {
    let place = Place::with_scans();
    place.publish(&usual());
    place.publish(&usual().replace("n = 1.5", "n = 1.6"));
    fs::copy(place.path("bumps.tif"), place.path("rough.tif")).unwrap();
    // Each version has its own manifest, so that older ones are held against their scans too.
    for version in ["", "/v0001"] {
        let verified = place.call(&format!("verify out/small{version}")).ended(1);
        assert_eq!(
            verified.stderr,
            "failed: rough: rough.tif is not the file that the tables were made from\n1 failed; the rest is done\n"
        );
    }
    // From elsewhere the scans are not found, and that is said.
    let elsewhere = Place::empty();
    let atlas = place.path("out/small").display().to_string();
    let verified = elsewhere.call(&format!("verify {atlas}")).ended(0);
    assert!(verified.stdout.contains("not evaluated against the scans: "), "{}", verified.stdout);
    let manifest = place.path("m.toml").display().to_string();
    elsewhere.call(&format!("verify {atlas} --manifest {manifest}")).ended(1);
}

#[test]
fn tables_that_are_wrong_though_every_digest_fits_are_found_by_their_values() {
    let place = Place::with_scans();
    place.publish(&usual());
    let folder = place.path("out/small/v0001");
    let path = folder.join("rough/specimen.json");
    let mut specimen = place.json("out/small/v0001/rough/specimen.json");
    let scale = specimen["tables"]["tables"][0]["scale"].as_f64().unwrap();
    specimen["tables"]["tables"][0]["scale"] = (2.0 * scale).into();
    fs::write(&path, serde_json::to_string_pretty(&specimen).unwrap() + "\n").unwrap();
    let mut index = atlas::read_index(&folder).unwrap();
    index.files = atlas::record_files(&folder).unwrap();
    atlas::write_index(&folder, &mut index).unwrap();

    let verified = place.call("verify out/small --manifest m.toml").ended(1);
    for failure in [
        "rough: stored check values differ",
        "rough: whole hemisphere: errors at the recorded directions",
        "rough: whole hemisphere: errors against the scans",
    ] {
        assert!(verified.stderr.contains(&format!("failed: {failure}")), "{failure}: {}", verified.stderr);
    }
    assert!(!verified.stderr.contains("wave"), "{}", verified.stderr);
}

#[test]
fn a_damaged_version_is_replaced_by_the_next_run() {
    let place = Place::with_scans();
    place.publish(&usual());
    let table = place.path("out/small/v0001/wave/table.000.exr");
    let mut bytes = fs::read(&table).unwrap();
    bytes[1000] ^= 1;
    fs::write(&table, &bytes).unwrap();
    let again = place.publish(&usual());
    assert!(again.stdout.starts_with("published out/small/v0002"), "{}", again.stdout);
    place.call("verify out/small --manifest m.toml").ended(0);
}

#[test]
fn an_older_version_that_answers_says_so() {
    let place = Place::with_scans();
    place.publish(&usual());
    place.publish(&usual().replace("{ n = 1.5 }", "{ n = 1.6 }"));
    place.write("d.csv", "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg\n10,0,20,170\n");
    let table = place.path("out/small/v0002/wave/table.000.exr");
    let bytes = fs::read(&table).unwrap();
    // A file of its own: what did not change is stored once for both versions.
    fs::remove_file(&table).unwrap();
    fs::write(&table, &bytes[..bytes.len() - 1]).unwrap();
    let eval = "eval --directions d.csv --specimen rough --atlas out/small";
    let lines = [
        eval,
        "inspect out/small",
        "export out/small --form float-tables --out floats",
        "diff out/small out/small/v0001",
    ];
    for line in lines {
        let called = place.call(line).ended(0);
        for expected in ["warning: ", "out/small/v0001 is taken", "v0002/wave/table.000.exr: it has "] {
            assert!(called.stderr.contains(expected), "{line}: {}", called.stderr);
        }
    }
    assert_eq!(place.call(eval).stdout, place.call(&format!("{eval}/v0001")).stdout);
    fs::write(&table, &bytes).unwrap();
    assert_eq!(place.call(eval).ended(0).stderr, "");
    // Where none is whole, what is wrong with each is the answer.
    for version in ["v0001", "v0002"] {
        fs::remove_file(place.path(&format!("out/small/{version}/atlas.json"))).unwrap();
    }
    let refused = place.call(eval).ended(1);
    assert!(
        refused.stderr.contains("v0002/atlas.json: ") && refused.stderr.contains("v0001/atlas.json: "),
        "{}",
        refused.stderr
    );
}

#[test]
fn what_lies_beside_the_versions_is_looked_at() {
    let place = Place::with_scans();
    place.publish(&[HEAD, LASERS, ROUGH].concat());
    let root = place.path("out/small");
    let failed = |expected: &str| {
        let verified = place.call("verify out/small --samples 0").ended(1);
        assert!(verified.stderr.contains(&format!("failed: {expected}")), "{}", verified.stderr);
        // The version itself is whole.
        place.call("verify out/small/v0001 --samples 0").ended(0);
    };
    place.call("verify out/small --samples 0").ended(0);
    fs::remove_file(root.join("latest")).unwrap();
    failed("latest: it is missing");
    fs::write(root.join("latest"), "../../etc\n").unwrap();
    failed("latest: it names `../../etc`, the newest version is v0001");
    fs::write(root.join("latest"), "v0001\n").unwrap();
    fs::create_dir(root.join("v18446744073709551615")).unwrap();
    failed("v18446744073709551615: it is no part of the atlas");
    // Its number is no version's, so that there is a next one.
    place.publish(&[HEAD, LASERS, &ROUGH.replace("1.5", "1.6")].concat());
    assert_eq!(place.latest(), "v0002");
    fs::remove_dir(root.join("v18446744073709551615")).unwrap();
    fs::create_dir(root.join("v0002/rough/empty")).unwrap();
    let verified = place.call("verify out/small --samples 0").ended(1);
    assert!(verified.stderr.contains("failed: rough/empty: "), "{}", verified.stderr);
}

/// A version whose specimen.json was changed by someone who knows how to seal it again.
fn forge(place: &Place, change: impl Fn(&mut serde_json::Value)) {
    let folder = place.path("out/small/v0001");
    let mut specimen = place.json("out/small/v0001/rough/specimen.json");
    change(&mut specimen);
    fs::write(folder.join("rough/specimen.json"), serde_json::to_string_pretty(&specimen).unwrap() + "\n").unwrap();
    let mut index = atlas::read_index(&folder).unwrap();
    index.files = atlas::record_files(&folder).unwrap();
    atlas::write_index(&folder, &mut index).unwrap();
}

#[test]
fn forged_specimens_are_refused_and_never_give_values_that_are_none() {
    let place = Place::with_scans();
    place.publish(&[HEAD, LASERS, ROUGH].concat());
    place.write("d.csv", "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg\n10,0,20,170\n");
    let sound = place.json("out/small/v0001/rough/specimen.json");
    let eval = "eval --directions d.csv --atlas out/small --specimen rough";
    let lines = [
        eval.to_owned(),
        format!("{eval} --wavelengths-nm 500"),
        "export out/small --form shaders --out shaders".into(),
        "export out/small --form float-tables --out floats".into(),
        "verify out/small".into(),
    ];
    let refused = |what: &str| {
        for line in &lines {
            let called = place.call(line).ended(1);
            assert!(
                called.stderr.contains("specimen.json") && !called.stderr.contains("panicked"),
                "{what}, {line}: {}",
                called.stderr
            );
            assert!(!called.stdout.to_lowercase().contains("nan"), "{what}, {line}: {}", called.stdout);
        }
        forge(&place, |specimen| *specimen = sound.clone());
    };
    for n in [0.0, 1e308, 1e-200] {
        forge(&place, |specimen| specimen["optics"]["material"]["dielectric"]["n"] = n.into());
        refused(&format!("n = {n}"));
    }
    forge(&place, |specimen| specimen["tables"]["tables"] = serde_json::json!([]));
    for line in [&lines[0], &lines[2], &lines[3]] {
        let called = place.call(line).ended(1);
        assert!(called.stderr.contains("it holds no table"), "{line}: {}", called.stderr);
    }
}
