//! Runs killed at any moment, and two at once.

use std::fs;
use std::process::Stdio;
use std::time::{Duration, Instant};

use diffraction_brdf::atlas;

use crate::place::{HEAD, LASERS, Place, ROUGH, SCENES, WAVE, contents};

fn manifest(n: usize) -> String {
    // Each differs, so that each run has something to publish.
    let rough = ROUGH.replace("1.5", &format!("1.5{n:02}"));
    [HEAD, LASERS, &rough, WAVE, SCENES].concat()
}

#[test]
fn a_run_killed_at_any_moment_leaves_the_published_versions_and_the_next_run_completes() {
    check_kills(3);
}

#[test]
#[ignore = "slow: as the one above at more moments"]
fn a_run_killed_at_many_moments_leaves_the_published_versions_and_the_next_run_completes() {
    check_kills(50);
}

/// Kills runs at so many moments, spread over the time that a whole one takes.
fn check_kills(kills: usize) {
    let place = Place::with_scans();
    let started = Instant::now();
    place.publish(&manifest(0));
    let whole = started.elapsed();
    let root = place.path("out/small");
    let first = contents(&root.join("v0001"));
    let mut random = fastrand::Rng::with_seed(3);
    for n in 1..=kills {
        place.write("m.toml", &manifest(n));
        let mut run = std::process::Command::new(assert_cmd::cargo::cargo_bin("diffraction-atlas"))
            .args(["--quiet", "run", "m.toml"])
            .current_dir(place.folder())
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        // One moment in each part of the time a whole run took; how far the run is then does not matter.
        std::thread::sleep(whole.mul_f64((n as f64 - random.f64()) / kills as f64).max(Duration::from_millis(1)));
        run.kill().unwrap();
        run.wait().unwrap();

        assert_eq!(contents(&root.join("v0001")), first, "kill {n}");
        let numbers = atlas::version_numbers(&root).unwrap();
        for number in &numbers {
            place.call(&format!("verify out/small/{} --samples 0", atlas::version_name(*number))).ended(0);
        }
        // Killed between the last rename and the writing of `latest`, it names the version before.
        let latest = atlas::version_number(&place.latest()).unwrap();
        let newest = *numbers.last().unwrap();
        assert!(latest == newest || latest + 1 == newest, "latest {latest}, newest {newest}");
        place.call("list out").ended(0);
    }
    let published = place.publish(&manifest(kills + 1));
    let newest = place.latest();
    assert!(published.stdout.starts_with(&format!("published out/small/{newest} in")), "{}", published.stdout);
    place.call("verify out/small --manifest m.toml").ended(0);
    let left: Vec<String> = place.versions().into_iter().filter(|name| !name.starts_with('v')).collect();
    assert_eq!(left, ["latest"], "what the killed runs left is gone");
    // Nothing of what they had finished shows: the bytes are those of a run that nobody disturbed.
    let timeless = |folder: &std::path::Path| {
        let mut files = contents(folder);
        files.retain(|name, _| !atlas::may_differ(name) && name != "atlas.json");
        files
    };
    let interrupted = timeless(&root.join(newest));
    fs::rename(&root, place.path("out/interrupted")).unwrap();
    place.call("--quiet run m.toml --no-cache").ended(0);
    assert!(timeless(&root.join("v0001")) == interrupted);
}

#[test]
fn two_runs_into_one_atlas_do_not_meet() {
    let place = Place::with_scans();
    place.write("m.toml", &manifest(0));
    let held = diffraction_atlas::stages::archive::publish::begin(&place.path("out/small")).unwrap();
    let refused = place.call("run m.toml").ended(75);
    assert!(refused.stderr.contains("another run is publishing into this atlas"), "{}", refused.stderr);
    assert_eq!(refused.stdout, "");
    drop(held);
    place.call("--quiet run m.toml").ended(0);
}

#[test]
fn an_atlas_that_cannot_be_written_says_so() {
    let place = Place::with_scans();
    fs::write(place.path("out"), "a file where a folder should be").unwrap();
    place.write("m.toml", &manifest(0));
    let refused = place.call("--quiet run m.toml").ended(1);
    assert!(refused.stderr.starts_with("error: ") && refused.stderr.contains("out/small"), "{}", refused.stderr);
}
