//! The light: a source of fixed size, and specimens that have one of their own.

use serde_json::json;

use crate::evaluation::{directions, values};
use crate::place::{HEAD, LASERS, Place, ROUGH, SCENES, WAVE};

const SOURCE: &str = r#"[optics]
illuminant = { lines_nm = [633, 532, 450] }
coherence = { source_deg = 10 }
[tables]
size = 401
prefilter = "none"
"#;

#[test]
fn a_source_of_fixed_size_is_built_told_and_verified() {
    let place = Place::with_scans();
    let run = place.publish(&[HEAD, SOURCE, ROUGH, WAVE].concat());
    assert!(!run.stderr.contains("error"), "{}", run.stderr);
    place.write("d.csv", &directions(40));
    let y = |line: &str| -> Vec<f64> {
        values(&place.call(&format!("eval --directions d.csv {line}")).ended(0).stdout)
            .iter()
            .map(|xyz| xyz[1])
            .collect()
    };
    let straight = |manifest: &str| y(&format!("--method reference --manifest {manifest} --specimen rough"));
    let (tables, reference) = (y("--atlas out/small --specimen rough --interpolation cubic"), straight("m.toml"));
    let worst = |a: &[f64]| a.iter().zip(&reference).map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max);
    println!("tables against the direct sum: {:.1e}", worst(&tables));
    assert!(worst(&tables) < 5e-3, "{tables:?} {reference:?}");
    // One coherence for all three lines, that of the green one.
    place.write("one.toml", &[HEAD, &SOURCE.replace("source_deg = 10", "sigma_um = 1.372"), ROUGH].concat());
    assert!(worst(&straight("one.toml")) > 0.02);

    let optics = place.json("out/small/v0001/rough/specimen.json")["optics"].clone();
    assert_eq!(optics["source_deg"], json!(10.0));
    // At the longest wavelength 1.63 µm, and a quarter of the scan's shorter side of 5.76 µm for the body.
    assert!((optics["lobe_sigma_nm"].as_f64().unwrap() / 1632.6 - 1.0).abs() < 1e-4, "{optics}");
    assert!((optics["sigma_nm"].as_f64().unwrap() / 1440.0 - 1.0).abs() < 1e-9, "{optics}");
    let page = std::fs::read_to_string(place.path("out/small/v0001/report.html")).unwrap();
    assert!(page.contains("a source 10 degrees wide") && page.contains("at 633 nm"), "what the report says");
    place.call("verify out/small --manifest m.toml").ended(0);
    assert!(place.call("plan m.toml").ended(0).stdout.contains("1.633 µm at 633 nm"));
    let refused = place.call("study m.toml --specimen rough --out study");
    if !refused.stderr.contains("no study") {
        assert!(refused.status == 2 && refused.stderr.contains("source of fixed size"), "{}", refused.stderr);
    }
}

#[test]
fn the_published_basis_knows_no_source() {
    let place = Place::with_scans();
    place.write("m.toml", &[HEAD, &SOURCE.replace("size = 401", "basis = \"taylor\""), WAVE].concat());
    let run = place.call("run m.toml").ended(2);
    assert!(run.stderr.contains("m.toml:11:9") && run.stderr.contains("`tables.basis`"), "{}", run.stderr);
    assert!(run.stderr.contains("\"wave\"") && run.stderr.contains("sigma_um"), "{}", run.stderr);
}

/// Two squares of two materials.
const SQUARES: &str = "v -2 -1 0\nv 0 -1 0\nv 0 1 0\nv -2 1 0\nv 2 -1 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n\
                       usemtl left\nf 1/1 2/2 3/3 4/4\nusemtl right\nf 2/1 5/2 6/3 3/4\n";
const SHARED: &str = "[[scene]]\nname = \"both\"\nshape = \"squares.obj\"\nmaterials = { left = \"rough\", right = \"wave\" }\nsize_px = 16\n";

/// Rough under lamps of its own; wave under the manifest's lasers.
fn own_light() -> String {
    format!("{ROUGH}illuminant = \"F11\"\n")
}

#[test]
fn a_specimen_may_have_a_light_of_its_own() {
    let place = Place::with_scans();
    place.write("r.csv", "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,wavelength_nm,brdf_per_sr\n30,0,10,0,600,0.1\n");
    let measured = "measured = \"r.csv\"\n";
    place.publish(&[HEAD, LASERS, &own_light(), measured, WAVE, SCENES].concat());
    let optics = |specimen: &str| place.json(&format!("out/small/v0001/{specimen}/specimen.json"))["optics"].clone();
    assert_eq!(
        (&optics("rough")["illuminant"], &optics("rough")["wavelength_nm"]),
        (&json!({"f": 11}), &json!([380.0, 780.0]))
    );
    assert_eq!(optics("wave")["wavelength_nm"], json!([450.0, 633.0]));
    let page = std::fs::read_to_string(place.path("out/small/v0001/report.html")).unwrap();
    assert!(page.contains("F11, 380 to 780 nm") && page.contains("laser lines at"), "what the report says");
    place.call("verify out/small --manifest m.toml").ended(0);
    place.call("plan m.toml").ended(0);
    // Each as if the manifest had its light and no other.
    let files = |version: &str, specimen: &str| -> Vec<(String, Vec<u8>)> {
        let folder = crate::place::contents(&place.path(&format!("out/small/{version}/{specimen}")));
        folder.into_iter().filter(|(path, _)| path.ends_with(".exr") || path.ends_with("preview.png")).collect()
    };
    let kept = [files("v0001", "rough"), files("v0001", "wave")];
    place.publish(
        &[HEAD, &LASERS.replace("{ lines_nm = [633, 532, 450] }", "\"F11\""), ROUGH, measured, WAVE, SCENES].concat(),
    );
    assert_eq!(files("v0002", "rough"), kept[0]);
    assert_ne!(files("v0002", "wave"), kept[1]);
    assert!(kept[0].len() > 4, "tables and pictures");
}

#[test]
fn a_picture_of_several_specimens_has_one_light() {
    let place = Place::with_scans();
    place.write("squares.obj", SQUARES);
    place.write("m.toml", &[HEAD, LASERS, &own_light(), WAVE, SHARED].concat());
    let run = place.call("run m.toml").ended(2);
    assert!(run.stderr.contains("m.toml:24:1") && run.stderr.contains("materials"), "{}", run.stderr);
    for word in ["\"both\"", "\"rough\"", "\"wave\"", "illuminant"] {
        assert!(run.stderr.contains(word), "{word}: {}", run.stderr);
    }
    assert!(!place.path("out").exists());
    let same = format!("{WAVE}illuminant = \"F11\"\n");
    place.write("m.toml", &[HEAD, LASERS, &own_light(), &same, SHARED].concat());
    place.call("plan m.toml").ended(0);
}
