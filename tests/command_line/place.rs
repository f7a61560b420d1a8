//! A folder to call the program in, with small scans and manifests.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use diffraction_brdf::files;
use diffraction_build::height::synthesize::{Structure, synthesize};
use diffraction_build::height::write::write_scan_tiff;
use serde_json::Value;

/// How a call ended.
#[derive(Debug)]
pub struct Called {
    pub status: i32,
    pub stdout: String,
    pub stderr: String,
}

impl Called {
    /// Itself, if the exit status is this one.
    #[track_caller]
    pub fn ended(self, status: i32) -> Self {
        assert_eq!(self.status, status, "stdout:\n{}\nstderr:\n{}", self.stdout, self.stderr);
        self
    }

    /// What stdout holds, as JSON.
    #[track_caller]
    pub fn json(&self) -> Value {
        serde_json::from_str(&self.stdout).unwrap_or_else(|e| panic!("{e}:\n{}", self.stdout))
    }
}

/// The program, in a folder.
pub fn program(folder: &Path) -> Command {
    let mut command = Command::cargo_bin("diffraction-atlas").unwrap();
    // Mesa's loader complains on stderr where this is not set, whoever starts the program.
    command.env("XDG_RUNTIME_DIR", folder).current_dir(folder);
    command
}

/// Calls the program in a folder; words are separated by spaces.
pub fn call(folder: &Path, line: &str) -> Called {
    let output = program(folder).args(line.split_whitespace()).output().unwrap();
    Called {
        status: output.status.code().expect("ended by itself"),
        stdout: String::from_utf8(output.stdout).unwrap(),
        stderr: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Every file below a folder with its bytes.
pub fn contents(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let read = |path: String| (path.clone(), std::fs::read(folder.join(&path)).unwrap());
    files::list(folder).unwrap().into_iter().map(read).collect()
}

/// A folder of its own, removed at the end.
pub struct Place {
    folder: tempfile::TempDir,
}

impl Place {
    /// An empty folder.
    pub fn empty() -> Self {
        Self { folder: tempfile::tempdir().unwrap() }
    }

    /// A folder with the scans `rough.tif`, `bumps.tif` and `wave.tif`, all periodic.
    pub fn with_scans() -> Self {
        let place = Self::empty();
        place.scan("rough.tif", rough(1), [80, 64], [80.0, 90.0]);
        place.scan("bumps.tif", rough(2), [80, 64], [80.0, 90.0]);
        let wave = Structure::Sinusoid { period_nm: 960.0, amplitude_nm: 60.0, direction_deg: 0.0 };
        place.scan("wave.tif", wave, [96, 64], [80.0, 80.0]);
        place
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub fn folder(&self) -> &Path {
        self.folder.path()
    }

    pub fn write(&self, name: &str, text: &str) {
        std::fs::write(self.path(name), text).unwrap();
    }

    pub fn scan(&self, name: &str, structure: Structure, size: [usize; 2], pitch_nm: [f64; 2]) {
        write_scan_tiff(&self.path(name), &synthesize(&structure, size, pitch_nm).unwrap()).unwrap();
    }

    /// Calls the program here.
    pub fn call(&self, line: &str) -> Called {
        call(self.folder(), line)
    }

    /// Runs a manifest with this text, which must succeed; without the pictures that are drawn where it has no scenes.
    #[track_caller]
    pub fn publish(&self, manifest: &str) -> Called {
        let without = if manifest.contains("[[scene]]") { "" } else { "scene = []\n" };
        self.write("m.toml", &format!("{without}{manifest}"));
        self.call("--quiet run m.toml").ended(0)
    }

    /// A JSON file of a version.
    pub fn json(&self, name: &str) -> Value {
        serde_json::from_slice(&std::fs::read(self.path(name)).unwrap()).unwrap()
    }

    /// Names of the folders and files of the atlas itself, sorted, without the lock.
    pub fn versions(&self) -> Vec<String> {
        let entries = files::entries(&self.path("out/small")).unwrap();
        let names = entries.iter().map(|(path, _)| path.file_name().unwrap().to_string_lossy().into_owned());
        let mut names: Vec<String> = names.filter(|name| name != ".lock").collect();
        names.sort();
        names
    }

    pub fn latest(&self) -> String {
        std::fs::read_to_string(self.path("out/small/latest")).unwrap().trim_end().to_owned()
    }
}

/// A random surface as of a matt foil.
pub fn rough(seed: u64) -> Structure {
    Structure::GaussianRough { rms_nm: 30.0, correlation_length_nm: 400.0, seed }
}

/// What the manifests here begin with. Three laser lines take little time, and the grid does not matter where
/// values are not the point.
pub const HEAD: &str = r#"schema = 1
[atlas]
name = "small"
out = "out"
[gpu]
check = "off"
"#;

pub const LASERS: &str = r#"[optics]
illuminant = { lines_nm = [633, 532, 450] }
coherence = { sigma_um = 2, edge = "tile" }
[tables]
size = 65
"#;

pub const ROUGH: &str = "[[specimen]]\nname = \"rough\"\nscans = [\"rough.tif\"]\nmaterial = { n = 1.5 }\n";
pub const WAVE: &str = "[[specimen]]\nname = \"wave\"\nscans = [\"wave.tif\"]\nlevel = \"none\"\n";

pub const SCENES: &str = r#"[[scene]]
name = "map"
shape = "hemisphere"
light = { direction = [0, 0, 1] }
size_px = 16
[[scene]]
name = "ball"
shape = "sphere"
size_px = 24
light_samples = 4
"#;

/// The usual manifest: two specimens, two scenes.
pub fn usual() -> String {
    [HEAD, LASERS, ROUGH, WAVE, SCENES].concat()
}
