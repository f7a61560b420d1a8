//! A good manifest and the files it names, for the tests of manifests.

use std::path::Path;

use diffraction_atlas::error::Result;
use diffraction_atlas::manifest::{self, Manifest};
use diffraction_brdf::exr_image::{Precision, write_rgb};
use ndarray::Array3;

/// A good manifest. Tables of faults count its lines.
pub const GOOD: &str = r#"schema = 1

[atlas]
name = "squamates"
out = "out"

[optics]
illuminant = "D65"
wavelength_nm = [380, 780]
coherence = { sigma_um = 16.25, edge = "tile" }
windows = "grid"

[tables]
tolerance = 1e-3
size = 501
memory_mib = 512

[[specimen]]
name = "elaphe"
scans = ["snake.tif"]
pitch_nm = [48.8, 48.8]
height = { full_scale_nm = 375 }
level = "plane"
material = { n = 1.56 }
despike = { threshold_rms = 8 }

[[specimen]]
name = "xenopeltis"
scans = ["snake.tif"]

[[scene]]
name = "sphere"
shape = "sphere"
light = [{ direction = [0.3, 0.2, 1.0], angular_diameter_deg = 0.53 }]
size_px = 512

[[scene]]
name = "patch"
shape = "patch"
tilt_deg = 20

[gpu]
check = "auto"
"#;

/// A square of two materials.
pub const BODY: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n\
                        usemtl back\nf 1/1 2/2 3/3\nusemtl belly\nf 1/1 3/3 4/4\n";

/// A folder with the files that `GOOD` names.
pub fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [
        ("snake.tif", "not looked into"),
        ("snake2.tif", "not looked into"),
        ("measured.csv", ""),
        ("lamp.csv", "wavelength_nm,power\n400,1\n700,2\n"),
        ("dark.csv", "wavelength_nm,power\n400,0\n700,0\n"),
        ("nk.csv", "wavelength_nm,n,k\n300,1.5,2\n550,0.4,2.4\n900,0.2,6\n"),
        ("nk_red.csv", "wavelength_nm,n,k\n500,1.5,2\n800,0.2,6\n"),
        ("nk_worn.csv", "wavelength_nm,n,k\n300,1.5,2\n900,0,6\n"),
        ("collection.csv", "name,scans,pitch_nm,material.n\nrow,snake2.tif,50,1.4\n"),
        ("body.obj", BODY),
        ("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
    ] {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    for (name, [rows, columns], value) in
        [("sky.exr", [4, 8], 0.5), ("flat.exr", [4, 4], 0.5), ("night.exr", [4, 8], 0.0)]
    {
        let image = Array3::from_elem((rows, columns, 3), value);
        write_rgb(&folder.path().join(name), &image, Precision::Half, &serde_json::json!({})).unwrap();
    }
    folder
}

/// Parses as if the text stood in `m.toml` in a folder.
pub fn parse_in(folder: &Path, text: &str) -> Result<Manifest> {
    manifest::parse(text, &folder.join("m.toml").display().to_string())
}

/// The good manifest with one place replaced.
pub fn good_with(find: &str, replace: &str) -> String {
    assert_eq!(GOOD.matches(find).count(), 1, "{find:?} must stand in the good manifest once");
    GOOD.replace(find, replace)
}
