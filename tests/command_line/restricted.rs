//! Tables restricted to scenes: what is written, what is left out, and what refuses to answer.

use diffraction_brdf::exr_image::read_rgb;

use crate::evaluation::directions;
use crate::place::{HEAD, LASERS, Place, ROUGH, SCENES, WAVE};

/// A flat patch far away under one light: a few texels.
const PATCH: &str = r#"[[scene]]
name = "far"
shape = "patch"
specimen = "rough"
width_mm = 10
distance_mm = 900
tilt_deg = 30
light = { direction = [0.35, 0.866, 0.5], angular_diameter_deg = 0.5 }
size_px = 24
"#;

fn manifest(serve: &str, rest: &[&str]) -> String {
    let lasers = LASERS.replace("size = 65\n", &format!("size = 65\nserve = {serve}\n"));
    [&[HEAD, &lasers, ROUGH, WAVE], rest].concat().concat()
}

#[test]
fn only_what_a_scene_needs_is_published() {
    let place = Place::with_scans();
    place.publish(&manifest("\"scenes\"", &[PATCH, "[report]\nsavings = true\n"]));
    let index = place.json("out/small/v0001/atlas.json");
    assert_eq!(index["specimens"].as_array().unwrap().len(), 1, "no scene shows the wave");
    let about = place.json("out/small/v0001/rough/specimen.json");
    let restriction = &about["tables"]["served"];
    assert_eq!(restriction["size"], 65);
    let texels = about["tables"]["u"]["samples"].as_u64().unwrap() * about["tables"]["v"]["samples"].as_u64().unwrap();
    assert!(texels < 300 && about["tables"]["lobe"].is_null(), "{texels} texels");
    assert!(!about["check_values"].as_array().unwrap().is_empty());
    let format = std::fs::read_to_string(place.path("out/small/v0001/FORMAT.md")).unwrap();
    assert!(format.contains("`range.exr`") && format.contains("no answer"), "{format}");

    let report = place.json("out/small/v0001/report.json");
    assert!(report["left_out"][0].as_str().unwrap().contains("wave"), "{}", report["left_out"]);
    let budget = &report["specimens"][0]["budget"];
    for row in budget["rows"].as_array().unwrap() {
        assert!(row["measured"]["seconds"].as_f64().unwrap() > 0.0, "{row}");
    }
    let sums = |cost: &serde_json::Value| cost["node_samples"].as_f64().unwrap();
    assert!(sums(&budget["rows"][0]["measured"]) > 1_000.0 * sums(&budget["measured"]), "{budget}");
    place.call("verify out/small --manifest m.toml").ended(0);
    assert!(place.call("inspect out/small").ended(0).stdout.contains("restricted to the scenes of its manifest"));
    // Nothing has changed: nothing is published.
    assert!(place.call("run m.toml").ended(0).stdout.contains("nothing was published"));
}

/// Where tables for every direction would not fit, those of a scene may.
#[test]
fn what_is_left_out_need_not_fit() {
    let place = Place::with_scans();
    let with = |memory_mib: usize| {
        let size = format!("size = 2001\nmemory_mib = {memory_mib}\n");
        manifest("\"scenes\"", &[PATCH]).replace("size = 65\n", &size)
    };
    place.write("all.toml", &with(160).replace("serve = \"scenes\"", "serve = \"all\""));
    assert!(place.call("plan all.toml").ended(1).stdout.contains("sums over 2001 x 2001 texels need 183 MiB"));
    place.publish(&with(160));
    let budget = &place.json("out/small/v0001/report.json")["specimens"][0]["budget"];
    assert!(
        budget["rows"][0]["with_it"]["memory_bytes"].as_f64().unwrap()
            > 1e3 * budget["served"]["memory_bytes"].as_f64().unwrap()
    );
    place.write("tight.toml", &with(64));
    let said = place.call("plan tight.toml").ended(1).stdout;
    assert!(
        said.contains("finding what the scenes reach on 2001 x 2001 texels needs 122 MiB, 64 MiB are allowed"),
        "{said}"
    );
}

#[test]
fn directions_that_are_not_covered_are_refused() {
    let place = Place::with_scans();
    place.write("d.csv", &directions(12));
    place.publish(&manifest("\"scenes\"", &[PATCH]));
    let refused = place.call("eval --directions d.csv --atlas out/small --specimen rough").ended(1);
    assert!(
        refused.stdout.is_empty() && refused.stderr.contains("12 of 12 directions, row 1 the first"),
        "{refused:?}"
    );
    // The directions of a check value are covered.
    let about = place.json("out/small/v0001/rough/specimen.json");
    let check = &about["check_values"][0];
    let angle = |key: &str| check[key].as_f64().unwrap();
    let row = ["theta_i_deg", "phi_i_deg", "theta_r_deg", "phi_r_deg"].map(|key| format!("{}", angle(key))).join(",");
    place.write("one.csv", &format!("theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg\n{row}\n"));
    let value = place
        .call("eval --directions one.csv --atlas out/small --specimen rough --interpolation bilinear")
        .ended(0)
        .stdout;
    let y: f64 = value.lines().nth(1).unwrap().split(',').nth(5).unwrap().parse().unwrap();
    assert!((y / check["xyz"][1].as_f64().unwrap() - 1.0).abs() < 1e-6, "{value}");
}

#[test]
fn the_plan_lists_what_is_left_out() {
    let place = Place::with_scans();
    place.write("m.toml", &manifest("[\"far\"]", &[SCENES, PATCH]));
    let said = place.call("plan m.toml").ended(0).stdout;
    for expected in [
        "rough for far alone",
        "texels that no look-up reads",
        "the scene ball: tables.serve does not name it",
        "the specimen wave",
    ] {
        assert!(said.contains(expected), "{expected}:\n{said}");
    }
    let plan = place.call("plan m.toml --json").ended(0).json();
    let rows = plan["specimens"][0]["budget"]["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 5, "everything, then texels, |w|, spectrum and lobe");
    assert!(!place.path("out").exists(), "nothing is written");
}

/// A scene that is content with less needs fewer tables, and differs by no more than it allows.
#[test]
fn a_scene_pays_for_its_own_tolerance() {
    let place = Place::with_scans();
    let ball = "[[scene]]\nname = \"ball\"\nshape = \"sphere\"\nsize_px = 24\nlight_samples = 4\n";
    let with = |scenes: &str| manifest("\"scenes\"", &[scenes, "[cache]\nlimit_mib = 0\n"]);
    let content = format!("{ball}tolerance = 0.05\n");
    let both = format!("{content}{PATCH}tolerance = 2e-3\n");
    let mut pictures = Vec::new();
    for (version, scenes, tolerance) in [(1, content.as_str(), 0.05), (2, ball, 1e-3), (3, both.as_str(), 2e-3)] {
        place.publish(&with(scenes));
        let folder = format!("out/small/v{version:04}");
        let report = place.json(&format!("{folder}/report.json"));
        let rough = &report["specimens"][0];
        assert_eq!(rough["build"]["tolerance"], tolerance, "the strictest of what is covered");
        let image = read_rgb(&place.path(&format!("{folder}/rough/scenes/ball.exr"))).unwrap().0;
        pictures.push((rough["build"]["tables"].as_u64().unwrap(), image));
    }
    let [(few, rough), (many, fine), (between, _)] = &pictures[..] else { panic!("three versions") };
    assert!(few < many && few < between, "{few} {between} {many}");
    let white = fine.iter().copied().fold(0.0, f32::max);
    let differences = rough.iter().zip(fine).map(|(a, b)| (a - b).abs() / white);
    let worst = differences.fold(0.0, f32::max);
    assert!(worst > 0.0 && worst < 0.05, "{worst}");
}

#[test]
fn what_cannot_be_covered_is_said() {
    let place = Place::with_scans();
    for (text, expected) in [
        (manifest("\"scenes\"", &[]), "there must be a [[scene]] to cover"),
        (manifest("[]", &[SCENES]), "covers no direction at all"),
        (manifest("[\"bal\"]", &[SCENES]), "did you mean \"ball\"?"),
        (manifest("\"some\"", &[SCENES]), "scenes"),
        (manifest("\"all\"", &[SCENES, "tolerance = 0.01\n"]), "goes with tables that are made for scenes"),
        (manifest("\"scenes\"\nbasis = \"taylor\"", &[SCENES]), "goes with basis = \"chebyshev\""),
    ] {
        place.write("m.toml", &text);
        let refused = place.call("run m.toml").ended(2);
        assert!(refused.stderr.contains(expected), "{expected}:\n{}", refused.stderr);
    }
}

#[test]
fn what_nobody_asks_for_is_not_done() {
    let place = Place::with_scans();
    place.publish(&[HEAD, LASERS, ROUGH, SCENES, "[report]\nwrite = false\nreference = false\n"].concat());
    let version = place.path("out/small/v0001");
    assert!(!version.join("report.html").exists() && !version.join("rough/scenes/ball.reference.exr").exists());
    assert!(version.join("rough/scenes/ball.png").exists() && version.join("rough/table.000.exr").exists());
}
