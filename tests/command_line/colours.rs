//! Which colours a specimen shows from which angles: maps, strips, spectra and the sentence, against the grating equation.

use diffraction_build::height::synthesize::Structure;
use serde_json::Value;

use crate::place::{HEAD, Place};

const PERIOD_NM: f64 = 1600.0;

/// The goniometry of a sinusoid whose lines lie across this direction, seen in daylight.
fn sinusoid(direction_deg: f64) -> Value {
    let place = Place::empty();
    let wave = Structure::Sinusoid { period_nm: PERIOD_NM, amplitude_nm: 40.0, direction_deg };
    // The other side is as long: a whole number of periods either way.
    place.scan("wave.tif", wave, [256, 256], [100.0, 100.0]);
    let specimen = "[[specimen]]\nname = \"wave\"\nscans = [\"wave.tif\"]\nlevel = \"none\"\nmaterial = { n = 1.56 }\n";
    let settings =
        "[optics]\ncoherence = { sigma_um = 4, edge = \"tile\" }\n[tables]\nsize = 401\n[report]\nreference = false\n";
    place.publish(&[HEAD, settings, specimen].concat());
    let found = place.json("out/small/v0001/report.json")["specimens"][0]["goniometry"].clone();
    for map in found["maps"].as_array().unwrap() {
        assert!(place.path("out/small/v0001").join(map["png"].as_str().unwrap()).is_file());
    }
    let page = std::fs::read_to_string(place.path("out/small/v0001/report.html")).unwrap();
    assert!(page.contains(found["sentence"].as_str().unwrap()), "the sentence stands in the report");
    found
}

/// Luminance over the angle of a set-up.
fn strip(found: &Value, set_up: &str, plane: &str) -> Vec<(f64, f64)> {
    let strips = found["strips"].as_array().unwrap();
    let strip = strips.iter().find(|strip| strip["set_up"] == set_up && strip["plane"] == plane).unwrap();
    let first = strip["first_deg"].as_f64().unwrap();
    let values = strip["xyz"].as_array().unwrap().iter().enumerate();
    values.map(|(n, xyz)| (first + n as f64, xyz[1].as_f64().unwrap())).collect()
}

/// The angle of the brightest value from `low` to `high` degrees.
fn peak(strip: &[(f64, f64)], low: f64, high: f64) -> f64 {
    let within = strip.iter().filter(|(angle, _)| (low..=high).contains(angle));
    within.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap().0
}

#[test]
fn a_sinusoid_shows_its_orders_where_the_grating_equation_has_them() {
    let found = sinusoid(0.0);
    let told = found["sentence"].as_str().unwrap();
    assert!(told.contains("along x, either way, it runs from blue to red between"), "{told}");
    assert!(told.contains("along y, either way, it stays dark"), "{told}");

    // Green, which the eye sees best, in each set-up: light and view at the angles of `sin + sin = m λ / d`.
    let green = 555.0 / PERIOD_NM;
    let normal = strip(&found, "normal_incidence", "xz");
    for (low, high, sign) in [(10.0, 30.0, 1.0), (-30.0, -10.0, -1.0)] {
        let expected = sign * green.asin().to_degrees();
        assert!((peak(&normal, low, high) - expected).abs() <= 1.0, "{expected}");
    }
    let back = strip(&found, "back_scattering", "xz");
    assert!((peak(&back, 6.0, 15.0) - (green / 2.0).asin().to_degrees()).abs() <= 1.0);
    // Arms 45 degrees apart: 2 sin(tilt) cos(22.5°) = λ / d.
    let arms = strip(&found, "fixed_arms", "xz");
    let expected = (green / (2.0 * 22.5f64.to_radians().cos())).asin().to_degrees();
    assert!((peak(&arms, 6.0, 18.0) - expected).abs() <= 1.0, "{expected}");

    let bright = found["brightest"].as_array().unwrap();
    assert_eq!(bright[0]["theta_deg"], 0.0);
    let order = &bright[1];
    assert!((order["theta_deg"].as_f64().unwrap() - green.asin().to_degrees()).abs() < 1.5, "{order}");
    // Its spectrum peaks at the wavelength that the equation gives for the direction.
    let numbers =
        |key: &str| -> Vec<f64> { order[key].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect() };
    let (nm, factor) = (numbers("wavelength_nm"), numbers("radiance_factor"));
    let at = (0..nm.len()).max_by(|&a, &b| factor[a].total_cmp(&factor[b])).unwrap();
    let expected = PERIOD_NM * order["theta_deg"].as_f64().unwrap().to_radians().sin();
    assert!((nm[at] - expected).abs() < 12.0, "{} for {expected}", nm[at]);
}

#[test]
fn turned_by_a_quarter_the_colours_turn_too() {
    let found = sinusoid(90.0);
    let told = found["sentence"].as_str().unwrap();
    assert!(told.contains("along y, either way, it runs from blue to red between"), "{told}");
    assert!(told.contains("along x, either way, it stays dark"), "{told}");
    let [across, along] = ["xz", "yz"].map(|plane| strip(&found, "normal_incidence", plane));
    let luminance = |strip: &[(f64, f64)]| strip.iter().find(|(angle, _)| *angle == 20.0).unwrap().1;
    assert!(luminance(&along) > 1e3 * luminance(&across), "exchanged axes must be found");
}
