//! The bundled specimens: what their README says gives them, and the reader takes them as they are.

use std::path::{Path, PathBuf};

use assert_cmd::Command;
use diffraction_build::height::read::{ReadConfig, read_scan};
use diffraction_build::height::synthesize::{bundled, synthesize};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("specimens")
}

/// The commands in the README, without the program's name.
fn commands() -> Vec<Vec<String>> {
    let text = std::fs::read_to_string(folder().join("README.md")).unwrap();
    let lines = text.lines().filter_map(|line| line.strip_prefix("diffraction-atlas "));
    lines.map(|line| line.split_whitespace().map(str::to_owned).collect()).collect()
}

#[test]
fn bundled_files_hold_what_their_parameters_give() {
    for (name, structure, size, pitch_nm) in bundled() {
        let path = folder().join(format!("{name}.tif"));
        // No key of a manifest helps: the file alone must say pitch and unit.
        let scan = read_scan(&path, &ReadConfig::default()).unwrap();
        let mut field = synthesize(&structure, size, pitch_nm).unwrap();
        field.heights_nm.mapv_inplace(|height| f64::from(height as f32));
        assert!(scan.field == field, "{name}.tif is out of date: generate it again");
        assert!(scan.provenance.warnings.is_empty(), "{:?}", scan.provenance);
        assert!(std::fs::metadata(&path).unwrap().len() < 500_000, "{name}");
    }
}

#[test]
fn the_measured_file_says_its_pitch_and_unit() {
    let scan = read_scan(&folder().join("grating_nanosurf_314nm.tif"), &ReadConfig::default()).unwrap();
    assert_eq!(scan.field.size(), [256, 256]);
    for pitch in scan.field.pitch_nm {
        assert!((pitch / 11.71875 - 1.0).abs() < 1e-6, "{pitch}");
    }
    // The range recorded when the heights were converted to nm.
    let low = scan.field.heights_nm.iter().copied().fold(f64::INFINITY, f64::min);
    let high = scan.field.heights_nm.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    assert!((low - 718.667).abs() < 1e-3 && (high - 1021.29).abs() < 1e-2, "{low} {high}");
}

#[test]
fn the_commands_in_the_readme_give_the_bundled_files() {
    let place = tempfile::tempdir().unwrap();
    let commands = commands();
    assert_eq!(commands.len(), bundled().len());
    for command in &commands {
        let output =
            Command::cargo_bin("diffraction-atlas").unwrap().current_dir(place.path()).args(command).output().unwrap();
        let stderr = String::from_utf8(output.stderr).unwrap();
        // In particular no note of a seam.
        assert_eq!((output.status.code(), stderr.as_str()), (Some(0), ""), "{command:?}");
    }
    for (name, ..) in bundled() {
        // Heights rather than bytes: another release of the deflate encoder may pack them differently.
        let [made, kept] = [place.path(), &folder()]
            .map(|folder| read_scan(&folder.join(format!("{name}.tif")), &ReadConfig::default()).unwrap());
        assert!(made.field == kept.field, "{name}");
    }
}

#[test]
fn every_file_is_described() {
    let text = std::fs::read_to_string(folder().join("README.md")).unwrap();
    for entry in std::fs::read_dir(folder()).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        assert!(name == "README.md" || text.contains(&format!("`{name}`")), "{name} is not in the README");
    }
}

#[test]
fn a_tile_with_a_seam_is_remarked_upon() {
    let place = tempfile::tempdir().unwrap();
    let call = |line: &str| {
        let output = Command::cargo_bin("diffraction-atlas")
            .unwrap()
            .current_dir(place.path())
            .args(line.split_whitespace())
            .output()
            .unwrap();
        (output.status.code(), String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap())
    };
    let line = "synthesize sinusoid --period-nm 700 --amplitude-nm 60 --size 64,2 --pitch-nm 50 --out s.tif";
    let (status, stdout, stderr) = call(line);
    assert_eq!(status, Some(0));
    assert!(stdout.starts_with("s.tif: 64 x 2 samples, pitch 50 x 50 nm, heights -"), "{stdout}");
    assert!(stderr.contains("seam"), "{stderr}");
    assert_eq!(call(&format!("--quiet {line} --force")).2, "");
    let (status, stdout, stderr) = call("synthesize cd-track --size 64 --pitch-nm 500 --out none.tif");
    assert_eq!((status, stdout.as_str()), (Some(2), ""));
    assert!(stderr.contains("too coarse"), "{stderr}");
    assert!(!place.path().join("none.tif").exists());
}
