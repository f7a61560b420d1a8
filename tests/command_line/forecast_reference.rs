//! What a plan says that the reference will take, against what a run evaluates.

use crate::common::surfaces::{laser, random, tables_config};
use assert_cmd::Command;
use diffraction_atlas::stages::pictures::scenes::{reference_samples, render_tables};
use diffraction_atlas::stages::pictures::shading::Shading;
use diffraction_atlas::stages::run::reference_forecast::{ReferenceForecast, reference_forecast};
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
use diffraction_build::optics::pigment::Surface;
use diffraction_build::optics::window::placements;
use diffraction_build::tables::build::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::plan::plan;
use diffraction_render::scene::model::{Light, Scene, Shape};
use serde_json::Value;

fn surface() -> HeightField {
    random([48, 40], [110.0; 2], 400.0, 40.0, 7)
}

fn scenes() -> Vec<Scene> {
    let sun = Light { direction: [0.3, 0.2, 1.0], angular_diameter_deg: 0.53, irradiance: 1.0 };
    let still = |name, shape| Scene { light_samples: 3, ..Scene::still(name, shape, vec![sun], 33) };
    vec![still("ball", Shape::Sphere), still("map", Shape::Hemisphere)]
}

fn forecast(optics: &OpticsConfig, scenes: &[Scene], threads: usize) -> ReferenceForecast {
    let (fields, tables) = ([surface()], tables_config(1e-2, Some(65)));
    let input = BuildInput::new(&fields, optics, &tables);
    let plan = plan(&input).unwrap();
    let samples: Vec<_> = scenes.iter().map(|scene| reference_samples(scene).unwrap()).collect();
    reference_forecast(&input, &plan, 4, &samples.iter().collect::<Vec<_>>(), threads)
}

#[test]
fn pairs_are_those_that_a_run_evaluates() {
    let optics = laser(&[450.0, 633.0], 900.0, Edge::Tile, Windows::Grid);
    let tables = build(&BuildInput::new(&[surface()], &optics, &tables_config(1e-2, Some(65))), &|_| ()).unwrap().0;
    let shading = Shading::new(Surface::without_pigment(&tables), 1e-2);
    let evaluated = |scene: &Scene| render_tables(scene, &shading, None).unwrap().pairs().count() as u64;
    let expected: u64 = scenes().iter().map(evaluated).sum();
    let found = forecast(&optics, &scenes(), 1).picture_pairs;
    assert!(expected > 2_000 && found == expected, "{found} {expected}");
    assert!(forecast(&optics, &scenes()[..1], 1).picture_pairs < expected);
}

#[test]
fn every_pair_counts_once_for_each_line_of_a_laser_and_each_window() {
    for (lines, windows) in [(&[633.0][..], Windows::Centre), (&[450.0, 532.0, 633.0][..], Windows::Grid)] {
        let optics = laser(lines, 500.0, Edge::Fade, windows);
        let count = placements(&surface(), &optics).unwrap().len();
        assert_eq!(count > 1, windows == Windows::Grid);
        let [with, without] = [&scenes()[..], &[]].map(|scenes| forecast(&optics, scenes, 1));
        let expected = (with.picture_pairs as usize * lines.len() * count) as f64;
        assert_eq!(with.evaluations - without.evaluations, expected);
        // Errors are counted at one direction and more in three regions, and each takes what a picture's pair takes.
        assert!(without.evaluations > (without.error_pairs as usize * lines.len() * count) as f64);
        assert!(with.seconds > without.seconds && without.seconds > 0.0);
        assert_eq!(forecast(&optics, &scenes(), 2).seconds, 0.5 * with.seconds);
    }
}

#[test]
fn nothing_is_predicted_where_no_reference_is_asked_for() {
    let place = tempfile::tempdir().unwrap();
    let scan = format!("{}/specimens/sinusoid_1600nm.tif", env!("CARGO_MANIFEST_DIR"));
    let manifest = |reference: bool| {
        format!(
            "schema = 1\natlas = {{ name = \"a\", out = \"out\" }}\n\
             optics = {{ illuminant = \"D65\", coherence = {{ sigma_um = 4, edge = \"tile\" }} }}\n\
             report = {{ reference = {reference} }}\n\
             [[specimen]]\nname = \"s\"\nscans = [\"{scan}\"]\nmaterial = \"ideal\"\n\
             [[scene]]\nname = \"ball\"\nshape = \"sphere\"\nlight = {{ direction = [0, 0, 1] }}\nsize_px = 32\n"
        )
    };
    let plan = |reference: bool, json: bool| {
        let path = place.path().join("m.toml");
        std::fs::write(&path, manifest(reference)).unwrap();
        let mut command = Command::cargo_bin("diffraction-atlas").unwrap();
        command.arg("plan").arg(&path).args(json.then_some("--json"));
        let output = command.output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    };
    let json = |reference| serde_json::from_str::<Value>(&plan(reference, true)).unwrap()["specimens"][0].clone();
    assert_eq!(json(false)["reference"], Value::Null);
    assert!(json(true)["reference"]["picture_pairs"].as_u64().unwrap() > 100);
    let (with, without) = (plan(true, false), plan(false, false));
    assert!(with.contains("the reference in about"), "{with}");
    assert!(without.contains("no reference") && without.contains("report.reference = false"), "{without}");
}

/// A total for the run with what it is spent on; what is there already takes none of it.
#[test]
fn the_whole_run_is_predicted_and_what_is_there_is_not() {
    let place = crate::place::Place::with_scans();
    place.write("m.toml", &crate::place::usual());
    let first = place.call("plan m.toml --json").ended(0).json();
    let seconds = |plan: &Value| plan["seconds"].as_f64().unwrap();
    let parts = first["parts"].as_array().unwrap();
    let sum: f64 = parts.iter().map(|part| part["seconds"].as_f64().unwrap()).sum();
    assert!((sum / seconds(&first) - 1.0).abs() < 1e-9 && parts.len() >= 6, "{first}");
    assert!(first["slowdown"].as_f64().unwrap() > 0.0);
    let [fewest, most] = [0, 1].map(|end| first["seconds_range"][end].as_f64().unwrap());
    assert!(fewest <= seconds(&first) && seconds(&first) <= most, "{first}");
    let text = place.call("plan m.toml").ended(0).stdout;
    assert!(text.contains("the whole run in about ") && text.contains("the reference "), "{text}");
    place.publish(&crate::place::usual());
    let again = place.call("plan m.toml --json").ended(0).json();
    assert_eq!(again["unchanged"], serde_json::json!(["rough", "wave"]));
    assert_eq!(seconds(&again), 0.0);
    assert!(again["cache"][0].as_u64().unwrap() > 0, "{again}");
    assert!(place.call("plan m.toml").ended(0).stdout.contains("there already, and taken over: rough, wave"));
}

/// Slow surfaces say why, and what to do.
#[test]
fn what_is_far_too_expensive_is_said_with_the_reason() {
    let place = crate::place::Place::with_scans();
    let read = diffraction_build::height::read::read_scan(&place.path("rough.tif"), &Default::default()).unwrap();
    let mut field = read.field;
    field.heights_nm[[20, 30]] = 60_000.0;
    diffraction_build::height::write::write_scan_tiff(&place.path("rough.tif"), &field).unwrap();
    let manifest = crate::place::usual().replace("illuminant = { lines_nm = [633, 532, 450] }\n", "");
    place.write("m.toml", &manifest);
    let text = place.call("plan m.toml").ended(0).stdout;
    assert!(text.contains("rough takes ") && text.contains("transforms are needed"), "{text}");
    assert!(text.contains("column 30, row 20") && text.contains("despike"), "{text}");
    assert!(!text.contains("wave takes "), "{text}");
}
