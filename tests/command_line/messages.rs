//! Messages of faults that users make: what is wrong, and what is likely meant.

use std::fs;

use crate::place::{HEAD, LASERS, Place, ROUGH};

#[test]
fn manifests_say_what_is_likely_meant() {
    let place = Place::with_scans();
    let manifest = [HEAD, LASERS, ROUGH].concat();
    for (old, new, expected) in [
        ("\"rough.tif\"", "\"ruogh.tif\"", "did you mean `rough.tif`?"),
        ("\"rough.tif\"", "\"r*.TIF\"", "names keep their case, and `rough.tif` is there"),
        ("\"rough.tif\"", "\"~/rough.tif\"", "`~` is a shell's word"),
        ("\"rough.tif\"", "\"C:\\Users\\me\\rough.tif\"", "forward slashes"),
        ("name = \"rough\"\n", "name = \"rough\"\npitch_nm = 48,8\n", "numbers have a decimal point"),
        ("name = \"rough\"\n", "name = \"rough\"\npitch_nm = \"48,8\"\n", "with a decimal point and without quotes"),
        ("name = \"rough\"\n", "name = \"rough\"\npitch_nm = 1e-300\n", "`specimen \"rough\": pitch_nm`"),
    ] {
        let wrong = manifest.replacen(old, new, 1);
        assert_ne!(wrong, manifest, "{old}");
        place.write("m.toml", &wrong);
        let called = place.call("plan m.toml").ended(2);
        assert!(called.stderr.contains(expected), "{new}: {}", called.stderr);
    }
}

#[test]
fn a_pixel_that_is_far_longer_than_wide_is_asked_about() {
    let place = Place::with_scans();
    let called = place.call("inspect rough.tif --pitch-nm 48,8").ended(0);
    assert!(
        called.stdout.contains("6.0 times as long as wide") && called.stdout.contains("decimal comma"),
        "{}",
        called.stdout
    );
    assert!(!place.call("inspect rough.tif").ended(0).stdout.contains("as long as wide"));
    let called = place.call("inspect rough.tif --pitch-nm 1e-300").ended(2);
    assert!(called.stderr.contains("--pitch-nm"), "{}", called.stderr);
}

#[test]
fn a_report_that_was_not_written_is_not_named() {
    let place = Place::with_scans();
    let run = place.publish(&format!("{}{LASERS}{ROUGH}[report]\nwrite = false\n", HEAD));
    assert!(run.stdout.starts_with("published ") && !run.stdout.contains("report"), "{}", run.stdout);
}

/// Pipes and devices never end; names of specimens lead nowhere.
#[cfg(unix)]
#[test]
fn what_never_ends_is_refused() {
    let place = Place::with_scans();
    place.publish(&[HEAD, LASERS, ROUGH].concat());
    let called = place.call("eval --directions /dev/zero --atlas out/small --specimen rough").ended(1);
    assert!(called.stderr.contains("/dev/zero"), "{}", called.stderr);
    let made = std::process::Command::new("mkfifo").arg(place.path("sky.exr")).status();
    if !made.is_ok_and(|status| status.success()) {
        eprintln!("SKIPPED: there is no mkfifo");
        return;
    }
    let scene = "[[scene]]\nname = \"ball\"\nshape = \"sphere\"\nenvironment = \"sky.exr\"\n";
    place.write("m.toml", &[HEAD, LASERS, ROUGH, scene].concat());
    let called = place.call("plan m.toml").ended(2);
    assert!(called.stderr.contains("sky.exr"), "{}", called.stderr);
    fs::remove_file(place.path("sky.exr")).unwrap();
}

#[test]
fn several_scans_make_one_table() {
    let place = Place::with_scans();
    place.write("bad.tif", "no scan");
    let called = place.call("inspect rough.tif wave.tif bad.tif").ended(1);
    assert_eq!(called.stdout.lines().count(), 4, "{}", called.stdout);
    assert!(called.stdout.contains("80 x 64") && called.stdout.contains("96 x 64"), "{}", called.stdout);
    assert!(called.stderr.contains("failed: bad.tif: "), "{}", called.stderr);
    let json = place.call("inspect rough.tif wave.tif --json").ended(0).json();
    assert_eq!((json[1]["file"].as_str(), json[1]["size"][0].as_u64()), (Some("wave.tif"), Some(96)));
    place.call("inspect rough.tif wave.tif --save-heights h.tif").ended(2);
}

/// Drivers of a GPU complain where a variable is missing that servers do not set; that is no user's business.
#[test]
fn what_drivers_miss_does_not_reach_the_user() {
    let place = Place::with_scans();
    place.write("m.toml", &[&HEAD.replace("\"off\"", "\"auto\""), LASERS, ROUGH, crate::place::SCENES].concat());
    let mut program = crate::place::program(place.folder());
    let output = program.env_remove("XDG_RUNTIME_DIR").args(["--quiet", "run", "m.toml"]).output().unwrap();
    assert_eq!((output.status.code(), String::from_utf8(output.stderr).unwrap().as_str()), (Some(0), ""));
}
