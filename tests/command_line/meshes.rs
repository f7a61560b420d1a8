//! Scenes that several specimens share.

use diffraction_brdf::exr_image::read_rgb;
use ndarray::Axis;

use crate::place::{HEAD, LASERS, Place, ROUGH, WAVE};

/// Two squares side by side, of two materials, and scenes of both together and of one specimen alone.
const SQUARES: &str = "v -2 -1 0\nv 0 -1 0\nv 0 1 0\nv -2 1 0\nv 2 -1 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n\
                       usemtl left\nf 1/1 2/2 3/3 4/4\nusemtl right\nf 2/1 5/2 6/3 3/4\n";
const SHARED: &str = r#"[[scene]]
name = "both"
shape = "squares.obj"
materials = { left = "rough", right = "wave" }
light = { direction = [0.3, 0.1, 1.0], angular_diameter_deg = 0 }
size_px = 32
[[scene]]
name = "alone"
shape = "squares.obj"
light = { direction = [0.3, 0.1, 1.0], angular_diameter_deg = 0 }
size_px = 32
"#;

#[test]
fn a_shared_scene_shows_each_specimen_where_its_material_is() {
    let place = Place::with_scans();
    place.write("squares.obj", SQUARES);
    // Each square shows one pair of directions: the grid must resolve what lies there.
    let lasers = LASERS.replace("size = 65", "size = 401");
    place.write("m.toml", &[HEAD, &lasers, ROUGH, WAVE, SHARED].concat());
    place.call("--quiet run m.toml").ended(0);
    let picture = |path: &str| read_rgb(&place.path(&format!("out/small/v0001/{path}.exr"))).unwrap().0;
    let (both, rough, wave) = (picture("scenes/both"), picture("rough/scenes/alone"), picture("wave/scenes/alone"));
    let ((left, right), (rough_left, _), (_, wave_right)) =
        (both.view().split_at(Axis(1), 16), rough.view().split_at(Axis(1), 16), wave.view().split_at(Axis(1), 16));
    assert_eq!((left, right), (rough_left, wave_right));
    assert!(both.iter().any(|&value| value > 0.0) && rough != wave);
    assert!(!place.path("out/small/v0001/rough/scenes/both.png").exists());

    let report = place.json("out/small/v0001/report.json");
    let shared = &report["shared_scenes"][0];
    assert_eq!(shared["specimens"], serde_json::json!(["rough", "wave"]));
    assert!(shared["picture"]["error"]["relative_l2"].as_f64().unwrap() < 0.02, "{shared}");
    let page = std::fs::read_to_string(place.path("out/small/v0001/report.html")).unwrap();
    assert!(page.contains("Scenes of several specimens") && page.contains("rough, wave"));
    let index = place.json("out/small/v0001/atlas.json");
    let inputs = index["inputs"].as_array().unwrap();
    assert_eq!(inputs.iter().filter(|input| input["path"] == "squares.obj").count(), 1, "{inputs:?}");
    place.call("verify out/small --manifest m.toml").ended(0);

    // The mesh is an input: a change of it alone makes a new version.
    place.call("--quiet run m.toml").ended(0);
    assert_eq!(place.versions(), ["latest", "v0001"]);
    place.write("squares.obj", &SQUARES.replace("v 2 1 0", "v 2 0.5 0"));
    place.call("--quiet run m.toml").ended(0);
    assert_eq!(place.versions(), ["latest", "v0001", "v0002"]);
}

#[test]
fn a_shared_scene_falls_with_one_of_its_specimens_and_nothing_else_does() {
    let place = Place::with_scans();
    place.write("squares.obj", SQUARES);
    let scan = std::fs::read(place.path("wave.tif")).unwrap();
    std::fs::write(place.path("wave.tif"), &scan[..scan.len() / 2]).unwrap();
    place.write("m.toml", &[HEAD, LASERS, ROUGH, WAVE, SHARED].concat());
    let run = place.call("--quiet run m.toml").ended(1);
    assert!(run.stderr.contains("scene \"both\" is left out: it shows rough, wave"), "{}", run.stderr);
    assert!(place.path("out/small/v0001/rough/scenes/alone.png").exists());
    assert!(!place.path("out/small/v0001/scenes").exists());
    place.call("verify out/small").ended(0);
}
