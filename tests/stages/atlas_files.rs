//! Tables through files and back, and an atlas's files as other programs and `verify` see them.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::atlas_example::{index, random_tables, write_specimen};
use diffraction_atlas::error::Error;
use diffraction_atlas::stages::archive::format_md::format_md;
use diffraction_atlas::stages::archive::publish;
use diffraction_atlas::stages::archive::specimen_file;
use diffraction_atlas::stages::archive::verify_files;
use diffraction_atlas::stages::archive::worked::work_number;
use diffraction_brdf::atlas;
use diffraction_brdf::evaluate::{self, Interpolation};
use diffraction_brdf::files;
use diffraction_brdf::specimen::CheckValue;
use diffraction_brdf::storage::{self, StoredTables};
use diffraction_build::tables::model::{Basis, Storage, TableSet};
use ndarray::Array3;

fn through_files(set: &TableSet, storage: Storage) -> (StoredTables, TableSet) {
    let folder = tempfile::tempdir().unwrap();
    let stored = storage::write_tables(folder.path(), set, storage).unwrap();
    let back = storage::read_tables(folder.path(), &stored, set.front_factor).unwrap();
    (stored, back)
}

#[test]
fn float_tables_come_back_exactly() {
    for (seed, basis) in [(1, Basis::Chebyshev), (2, Basis::Taylor)] {
        let set = random_tables(seed, basis, 33);
        assert_eq!(through_files(&set, Storage::Float).1, set);
    }
    let mut plain = random_tables(3, Basis::Chebyshev, 5);
    plain.lobe.as_mut().unwrap().cross.clear();
    assert_eq!(through_files(&plain, Storage::Float).1, plain);
}

/// Whether each value is within half a step of a half float: 2^-11 of itself, or 2^-25 in stored numbers where those
/// are subnormal.
fn within_rounding(before: &Array3<f32>, after: &Array3<f32>, scale: f64, steps: f64) -> bool {
    before.iter().zip(after).all(|(&before, &after)| {
        let (before, after) = (f64::from(before), f64::from(after));
        (after - before).abs() <= steps * (before.abs() * 2f64.powi(-11)).max(scale * 2f64.powi(-25))
    })
}

#[test]
fn half_tables_come_back_within_rounding() {
    let mut set = random_tables(4, Basis::Chebyshev, 65);
    // Values far out of the range of half floats, at either end.
    set.tables[1].mapv_inplace(|value| value * 1e9);
    set.tables[2].mapv_inplace(|value| value * 1e-20);
    set.tables[3].fill(0.0);
    let (stored, back) = through_files(&set, Storage::Half);
    for ((before, after), array) in set.tables.iter().zip(&back.tables).zip(&stored.tables) {
        assert!(within_rounding(before, after, array.scale, 1.0), "{}", array.file);
        assert!(array.peak == 0.0 || !within_rounding(before, after, array.scale, 0.9), "the bound is not tight");
        assert!(array.rounding <= 2f64.powi(-11));
        assert_eq!(array.flushed, 0, "nine decades fit");
    }
    let (lobe, lobe_back) = (set.lobe.as_ref().unwrap(), back.lobe.as_ref().unwrap());
    assert_eq!(lobe.coherent, lobe_back.coherent, "the coherent lobe is never rounded");
    let patches = stored.lobe.unwrap().cross.unwrap().patches;
    for ((before, after), array) in lobe.cross.iter().zip(&lobe_back.cross).zip(&patches) {
        assert!(within_rounding(before, after, array.scale, 1.0), "{}", array.file);
    }
    // Half tables read back are stored again without any further loss.
    assert_eq!(through_files(&back, Storage::Half).1, back);
}

#[test]
fn tables_that_are_not_finite_are_refused() {
    for storage in [Storage::Half, Storage::Float] {
        for bad in [f32::INFINITY, f32::NAN] {
            let mut set = random_tables(5, Basis::Taylor, 5);
            set.tables[2][[1, 1, 1]] = bad;
            let folder = tempfile::tempdir().unwrap();
            let error = storage::write_tables(folder.path(), &set, storage).unwrap_err().to_string();
            assert!(error.contains("table.002.exr: 1 values are not finite"), "{error}");
        }
    }
}

#[test]
fn files_that_do_not_fit_their_description_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let set = random_tables(6, Basis::Chebyshev, 9);
    let stored = storage::write_tables(folder.path(), &set, Storage::Half).unwrap();
    let read =
        |stored: &StoredTables| storage::read_tables(folder.path(), stored, set.front_factor).unwrap_err().to_string();

    let mut larger = stored.clone();
    larger.u.samples = 11;
    assert!(read(&larger).contains("9 x 9 texels where specimen.json says 11 x 9"), "{}", read(&larger));
    let mut outside = stored.clone();
    outside.tables[0].file = "../table.000.exr".to_owned();
    assert!(read(&outside).contains("outside its folder"));
    let mut huge = stored.clone();
    huge.tables[0].scale = 1e300;
    assert!(read(&huge).contains("not finite"));
    fs::remove_file(folder.path().join("lobe.001.exr")).unwrap();
    assert!(read(&stored).contains("lobe.001.exr: cannot read"));
}

fn bytes_of(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let read = |path: String| (path.clone(), fs::read(folder.join(path)).unwrap());
    files::list(folder).unwrap().into_iter().map(read).collect()
}

#[test]
fn bytes_do_not_depend_on_threads_or_chance() {
    let set = random_tables(7, Basis::Chebyshev, 65);
    let write = |threads: usize| {
        let folder = tempfile::tempdir().unwrap();
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| write_specimen(folder.path(), "one", &set, Storage::Half));
        bytes_of(folder.path())
    };
    let first = write(1);
    assert_eq!(first.len(), 4 + 1 + 3 + 1);
    assert_eq!(first, write(2));
    assert_eq!(first, write(2));
}

/// Publishes a version with two specimens, one of each basis.
fn publish_example(root: &Path) -> std::path::PathBuf {
    let staging = publish::begin(root).unwrap();
    write_specimen(staging.path(), "one", &random_tables(8, Basis::Chebyshev, 33), Storage::Half);
    write_specimen(staging.path(), "two", &random_tables(9, Basis::Taylor, 17), Storage::Float);
    fs::write(staging.path().join("report.html"), "<p>report</p>").unwrap();
    let published = publish::publish(staging, index("aa", &["one", "two"]), Vec::new()).unwrap();
    root.join(published.version())
}

#[test]
fn a_specimen_is_loaded_as_it_was_written() {
    let root = tempfile::tempdir().unwrap();
    let version = publish_example(root.path());
    let (file, tables) = specimen_file::load(&version.join("two")).unwrap();
    assert_eq!(tables, random_tables(9, Basis::Taylor, 17));
    assert_eq!((file.name.as_str(), file.check_values.len()), ("two", 20));
    let worked = work_number(&tables, angles(&file.check_values[1]));
    assert_eq!(worked.xyz, file.check_values[1].xyz);
    let found = atlas::read_index(&version).unwrap();
    assert_eq!(atlas::specimen_folder(&version, &found, "two").unwrap(), version.join("two"));
    let unknown = atlas::specimen_folder(&version, &found, "three").unwrap_err();
    assert!(unknown.to_string().contains("no specimen `three`; it holds one, two"));
    assert_eq!(Error::from(unknown).exit_status(), 2);
}

fn angles(check: &CheckValue) -> [f64; 4] {
    [check.theta_i_deg, check.phi_i_deg, check.theta_r_deg, check.phi_r_deg]
}

#[test]
fn the_worked_number_is_what_the_fast_evaluation_gives() {
    // Both in double precision; steep random tables (neighbours up to 1e9 apart) magnify rounding of the position.
    for (seed, basis) in [(13, Basis::Chebyshev), (14, Basis::Taylor)] {
        let set = random_tables(seed, basis, 33);
        let mut random = fastrand::Rng::with_seed(seed);
        for n in 0..200 {
            let theta = 85.0 * random.f64();
            let spread = if n % 2 == 0 { 80.0 } else { 2.0 };
            let angles =
                [theta, 20.0, (theta + spread * (random.f64() - 0.5)).abs().min(85.0), 200.0 + spread * random.f64()];
            let worked = work_number(&set, angles);
            let fast = evaluate::brdf_xyz(&set, Interpolation::Bilinear, worked.wi, worked.wo);
            let largest = fast.iter().fold(0f64, |largest, value| largest.max(value.abs()));
            for (slow, fast) in worked.xyz.iter().zip(fast) {
                assert!((slow - fast).abs() <= 1e-9 * largest, "{basis:?} {angles:?}: {slow} against {fast}");
            }
        }
    }
}

#[test]
fn verify_names_exactly_the_file_with_a_flipped_bit() {
    let root = tempfile::tempdir().unwrap();
    let version = publish_example(root.path());
    let sound = verify_files::verify_files(&version).unwrap();
    let all = bytes_of(&version);
    assert_eq!((sound.files_checked, sound.failures.len()), (all.len(), 0));
    let mut random = fastrand::Rng::with_seed(10);
    for (path, bytes) in &all {
        let mut changed = bytes.clone();
        changed[random.usize(..bytes.len())] ^= 1 << random.u8(..8);
        fs::write(version.join(path), &changed).unwrap();
        let failures = verify_files::verify_files(&version).unwrap().failures;
        assert_eq!(failures.iter().map(|failure| &failure.file).collect::<Vec<_>>(), [path]);
        fs::write(version.join(path), bytes).unwrap();
    }
    assert_eq!(verify_files::verify_files(&version).unwrap(), sound);
}

#[test]
fn verify_sees_missing_added_and_cut_files() {
    let root = tempfile::tempdir().unwrap();
    let version = publish_example(root.path());
    fs::remove_file(version.join("one/table.001.exr")).unwrap();
    fs::write(version.join("one/table.004.exr"), "x").unwrap();
    fs::write(version.join("report.html"), "<p>rep").unwrap();
    let failures = verify_files::verify_files(&version).unwrap().failures;
    let found: Vec<_> = failures.iter().map(|failure| (failure.file.as_str(), failure.what.as_str())).collect();
    let expected = [
        ("one/table.001.exr", "it is missing"),
        ("one/table.004.exr", "it is not listed in atlas.json"),
        ("report.html", "it has 6 bytes, published were 13"),
    ];
    assert_eq!(found, expected);
}

#[test]
fn verify_finds_what_was_published_unreadable() {
    let root = tempfile::tempdir().unwrap();
    let staging = publish::begin(root.path()).unwrap();
    write_specimen(staging.path(), "one", &random_tables(11, Basis::Taylor, 5), Storage::Half);
    fs::write(staging.path().join("picture.exr"), "no picture").unwrap();
    let version =
        root.path().join(publish::publish(staging, index("aa", &["one", "lost"]), Vec::new()).unwrap().version());
    let failures = verify_files::verify_files(&version).unwrap().failures;
    assert_eq!(
        failures.iter().map(|failure| failure.file.as_str()).collect::<Vec<_>>(),
        ["lost/specimen.json", "picture.exr"]
    );
    assert!(failures[1].what.contains("not an OpenEXR file"), "{}", failures[1].what);
}

#[test]
fn the_format_page_holds_the_worked_number() {
    let folder = tempfile::tempdir().unwrap();
    let set = random_tables(12, Basis::Chebyshev, 33);
    let file = write_specimen(folder.path(), "one", &set, Storage::Half);
    let (_, stored) = specimen_file::load(&folder.path().join("one")).unwrap();
    let worked = work_number(&stored, [40.0, 10.0, 40.5, 190.2]);
    assert!(worked.lobe.as_ref().unwrap().lookup.is_some(), "the example shows the lobe");
    let page = format_md(&file, Some(&worked));
    // The page's last line is the number itself, to seven digits.
    let last = page.lines().last().unwrap();
    let numbers = last.split(['(', ')']).nth(1).unwrap().split(", ");
    for (number, expected) in numbers.zip(worked.xyz) {
        assert!((number.parse::<f64>().unwrap() / expected - 1.0).abs() <= 5e-7, "{last}");
    }
    for needed in ["`table.NNN.exr`, 4 files of 33 x 33", "n = 1.56", "switched on", "`radius_max` = 0.0468751"] {
        assert!(page.contains(needed), "{needed} is missing in\n{page}");
    }
    assert!(page.lines().all(|line| line.len() <= 220), "lines that need no scrolling");
    assert!(page.lines().count() <= 150, "one page, not {} lines", page.lines().count());
}

#[test]
fn python_reads_the_images_and_meets_the_check_values() {
    // .ci/run puts what it needs into an environment of its own.
    let python = std::env::var("PYTHON").unwrap_or_else(|_| "python3".into());
    let available = Command::new(&python).args(["-c", "import OpenEXR, numpy"]).output();
    if !available.is_ok_and(|output| output.status.success()) {
        skip!("{python} with OpenEXR and numpy is not installed, nobody else has read these files");
    }
    let root = tempfile::tempdir().unwrap();
    let version = publish_example(root.path());
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/read_with_openexr.py");
    let run = |version: &Path| Command::new(&python).arg(&script).arg(version).output().unwrap();
    let output = run(&version);
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{said}{}", String::from_utf8_lossy(&output.stderr));
    assert!(said.contains("12 images read, 60 check values met"), "{said}");

    // A check value that is off by a millionth must not pass.
    let path = version.join("one");
    let mut file = specimen_file::read(&path).unwrap();
    file.check_values[7].xyz[1] *= 1.000_001;
    specimen_file::write(&path, &file).unwrap();
    assert!(!run(&version).status.success());
}
