//! Publishing versions: one rename, nothing where nothing changed, and every way to be interrupted.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use crate::atlas_example::{index, random_tables, write_specimen};
use diffraction_atlas::error::Error;
use diffraction_atlas::stages::archive::diff::diff;
use diffraction_atlas::stages::archive::publish;
use diffraction_atlas::stages::archive::publish::{Published, Staging};
use diffraction_atlas::stages::archive::verify_files;
use diffraction_brdf::atlas;
use diffraction_brdf::files;
use diffraction_build::tables::model::{Basis, Storage};

/// A run whose tables follow from `seed`; its report differs every time.
fn run(root: &Path, seed: u64, report: &str) -> Published {
    let staging = publish::begin(root).unwrap();
    write_specimen(staging.path(), "one", &random_tables(seed, Basis::Chebyshev, 17), Storage::Half);
    fs::write(staging.path().join("report.json"), report).unwrap();
    publish::publish(staging, index("aa", &["one"]), Vec::new()).unwrap()
}

fn version(number: u64) -> Published {
    Published::Version(atlas::version_name(number))
}

fn unchanged(number: u64) -> Published {
    Published::Unchanged(atlas::version_name(number))
}

fn latest(root: &Path) -> String {
    fs::read_to_string(root.join("latest")).unwrap().trim_end().to_owned()
}

/// Names in the atlas's folder, without the lock.
fn names(root: &Path) -> Vec<String> {
    let name = |entry: std::io::Result<fs::DirEntry>| entry.unwrap().file_name().into_string().unwrap();
    let mut names: Vec<String> = fs::read_dir(root).unwrap().map(name).filter(|name| name != ".lock").collect();
    names.sort();
    names
}

#[test]
fn a_change_publishes_and_no_change_does_not() {
    let root = tempfile::tempdir().unwrap();
    let root = &root.path().join("out/atlas/test");
    assert_eq!(run(root, 1, "10:00"), version(1));
    let first = atlas::record_files(&root.join("v0001")).unwrap();
    assert_eq!(run(root, 1, "10:05"), unchanged(1), "times are no change");
    assert_eq!(names(root), ["latest", "v0001"]);
    assert_eq!(run(root, 2, "10:10"), version(2));
    assert_eq!(run(root, 1, "10:15"), version(3), "going back is a change");
    assert_eq!((latest(root).as_str(), names(root).len()), ("v0003", 4));
    assert_eq!(atlas::record_files(&root.join("v0001")).unwrap(), first, "published versions never change");
    assert_eq!(atlas::resolve(root).unwrap().folder, root.join("v0003"));
    assert_eq!(atlas::resolve(&root.join("v0001")).unwrap().folder, root.join("v0001"));

    // Another digest of an input is a change though the tables are the same.
    let staging = publish::begin(root).unwrap();
    write_specimen(staging.path(), "one", &random_tables(1, Basis::Chebyshev, 17), Storage::Half);
    fs::write(staging.path().join("report.json"), "10:20").unwrap();
    assert_eq!(publish::publish(staging, index("bb", &["one"]), Vec::new()).unwrap(), version(4));
}

#[test]
fn two_runs_at_once_are_refused_and_a_dropped_run_leaves_nothing() {
    let root = tempfile::tempdir().unwrap();
    let staging: Staging = publish::begin(root.path()).unwrap();
    fs::write(staging.path().join("half"), "done").unwrap();
    let error = publish::begin(root.path()).unwrap_err();
    assert!(error.to_string().contains("another run is publishing"), "{error}");
    assert!(staging.path().join("half").exists(), "the refused run touched nothing");
    drop(staging);
    assert_eq!(names(root.path()), Vec::<String>::new());
    assert_eq!(run(root.path(), 1, ""), version(1));
}

#[test]
fn what_a_dead_run_left_is_put_right() {
    let root = tempfile::tempdir().unwrap();
    let root = root.path();
    run(root, 1, "");
    run(root, 2, "");
    // Killed while writing, and killed between the rename and `latest`.
    fs::create_dir(root.join(".staging-99999")).unwrap();
    fs::write(root.join(".staging-99999/table.000.exr"), "half").unwrap();
    fs::write(root.join(".latest.99999-0.part"), "v00").unwrap();
    fs::write(root.join("latest"), "v0001\n").unwrap();
    assert_eq!(atlas::resolve(root).unwrap().folder, root.join("v0002"), "readers need no repair");
    assert_eq!(run(root, 2, ""), unchanged(2));
    assert_eq!((names(root), latest(root)), (vec!["latest".into(), "v0001".into(), "v0002".into()], "v0002".into()));

    for lost in [None, Some("v0042\n"), Some("")] {
        match lost {
            None => fs::remove_file(root.join("latest")).unwrap(),
            Some(text) => fs::write(root.join("latest"), text).unwrap(),
        }
        assert_eq!(run(root, 2, ""), unchanged(2));
        assert_eq!(latest(root), "v0002");
    }
}

#[test]
fn damaged_versions_are_passed_over_and_never_overwritten() {
    let root = tempfile::tempdir().unwrap();
    let root = root.path();
    run(root, 1, "");
    run(root, 2, "");
    // A version without its index, as a copy that broke off would leave.
    fs::remove_file(root.join("v0002/atlas.json")).unwrap();
    assert_eq!(atlas::resolve(root).unwrap().folder, root.join("v0001"));
    assert_eq!(run(root, 1, ""), unchanged(1));
    assert_eq!((run(root, 2, ""), latest(root)), (version(3), "v0003".to_owned()));
    assert!(root.join("v0002").exists());
    // Right sizes, wrong content: the same run publishes anew instead of trusting it.
    let path = root.join("v0003/one/table.000.exr");
    let mut bytes = fs::read(&path).unwrap();
    *bytes.last_mut().unwrap() ^= 1;
    fs::write(&path, bytes).unwrap();
    assert_eq!(run(root, 2, ""), version(4));
}

#[test]
fn an_empty_folder_is_no_atlas() {
    let root = tempfile::tempdir().unwrap();
    let error = atlas::resolve(root.path()).unwrap_err();
    assert!(error.to_string().contains("this is no atlas"));
    assert_eq!(Error::from(error).exit_status(), 2);
    assert!(atlas::resolve(&root.path().join("missing")).unwrap_err().to_string().contains("no such folder"));
}

const KILLED_ROOT: &str = "DIFFRACTION_ATLAS_TEST_KILLED_ROOT";

/// No test but a process that publishes for ever, for the one below to kill.
#[test]
fn publisher_to_be_killed() {
    let Ok(root) = std::env::var(KILLED_ROOT) else { return };
    for seed in 0.. {
        run(Path::new(&root), seed % 3, &seed.to_string());
    }
}

/// Gives up after half a minute; what is asserted then fails.
fn wait_for_a_second_version(root: &Path) {
    for _ in 0..3000 {
        if atlas::version_numbers(root).unwrap().len() > 1 {
            return;
        }
        std::thread::sleep(Duration::from_millis(10));
    }
}

#[test]
fn a_killed_run_leaves_every_version_whole() {
    let root = tempfile::tempdir().unwrap();
    let root = root.path();
    run(root, 100, "");
    let mut random = fastrand::Rng::with_seed(1);
    let mut known = atlas::version_numbers(root).unwrap();
    for round in 0..12 {
        let mut child = Command::new(std::env::current_exe().unwrap())
            .args(["--exact", concat!(module_path!(), "::publisher_to_be_killed").split_once("::").unwrap().1])
            .env(KILLED_ROOT, root)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        // The first one is given the time for one version; then any moment will do.
        if round == 0 {
            wait_for_a_second_version(root);
        }
        std::thread::sleep(Duration::from_millis(random.u64(2..60)));
        child.kill().unwrap();
        child.wait().unwrap();
        let found = atlas::version_numbers(root).unwrap();
        assert!(found.starts_with(&known), "{known:?} became {found:?}");
        for &number in &found {
            let report = verify_files::verify_files(&root.join(atlas::version_name(number))).unwrap();
            assert_eq!(report.failures, []);
        }
        known = found;
    }
    eprintln!("{} versions published by runs that were killed", known.len() - 1);
    assert!(known.len() > 1, "the killed runs published nothing at all");
    let next = known.last().unwrap() + 1;
    assert_eq!((run(root, 101, ""), latest(root)), (version(next), atlas::version_name(next)));
    assert_eq!(names(root).len(), known.len() + 2, "leftovers are gone: {:?}", names(root));
}

#[test]
fn diff_tells_what_changed() {
    let root = tempfile::tempdir().unwrap();
    let root = root.path();
    run(root, 1, "10:00");
    let staging = publish::begin(root).unwrap();
    let mut set = random_tables(1, Basis::Chebyshev, 17);
    set.usable_radius = 1.5;
    let peak = set.tables[0].iter().copied().fold(0f32, f32::max);
    // Half the peak at a texel that is small against it: stored exactly but for 2^-11.
    let [row, column, channel] = [5, 5, 0];
    let before = f64::from(set.tables[0][[row, column, channel]]);
    set.tables[0][[row, column, channel]] = peak / 2.0;
    write_specimen(staging.path(), "one", &set, Storage::Half);
    write_specimen(staging.path(), "two", &set, Storage::Half);
    fs::write(staging.path().join("report.json"), "10:05").unwrap();
    publish::publish(staging, index("bb", &["one", "two"]), Vec::new()).unwrap();

    let report = diff(&root.join("v0001"), root).unwrap();
    assert_eq!((report.added.as_slice(), report.removed.len()), (["two".to_owned()].as_slice(), 0));
    assert_eq!(report.inputs.len(), 1);
    assert!(report.files.iter().all(|change| change.what != "report.json"));
    let one = &report.specimens[0];
    assert_eq!(one.tables.iter().map(|change| change.table.as_str()).collect::<Vec<_>>(), ["table.000"]);
    let expected = (f64::from(peak) / 2.0 - before).abs() / f64::from(peak);
    assert!((one.tables[0].max_relative.unwrap() - expected).abs() <= 2f64.powi(-10));
    assert!(one.settings.iter().any(|change| change.what == "tables.usable_radius"));
    let text = report.to_text(true);
    let needed = [
        "usable_radius: 1.71 -> 1.5",
        "a.tif: \"aa\" -> \"bb\"",
        "one/table.000.exr: sha256 ",
        "specimens added    two",
        "specimens changed  one",
        "inputs changed     a.tif",
        "colours            one: CIEDE2000 up to ",
        "table.000: differs by up to",
    ];
    for needed in needed {
        assert!(text.contains(needed), "{needed} is missing in\n{text}");
    }
    let summary = report.to_text(false);
    assert!(!summary.contains("sha256 ") && summary.contains("--details"), "{summary}");
    let same = diff(&root.join("v0001"), &root.join("v0001")).unwrap();
    assert!(same.is_same() && same.to_text(false).contains("hold the same"));
    assert!(files::list(root).unwrap().iter().all(|path| !path.ends_with(".part")));
}
