//! Measured reflectance in a run: figures in the report, the file among the inputs, faults that name their place.

use crate::place::{HEAD, LASERS, Place, WAVE};

/// The first order of `wave.tif` (960 nm) along wavelength, in the units of the columns; not the true values.
fn csv(peak_nm: f64) -> String {
    let row = |i: u32| {
        let nm = 400.0 + 5.0 * f64::from(i);
        let value = (-((nm - peak_nm) / 40.0).powi(2)).exp();
        format!("0;0;30;0;{nm};{:.6};{:.6}\r\n", 5.0 * value, 0.02 + value).replace('.', ",")
    };
    let rows: String = (0..40).map(row).collect();
    format!(
        "\u{feff}theta_i_deg;phi_i_deg;theta_r_deg;phi_r_deg;wavelength_nm;brdf_per_sr;relative_radiance:a\r\n{rows}"
    )
}

fn manifest(measured: &str) -> String {
    format!("{HEAD}{LASERS}{WAVE}measured = {measured}\n")
}

#[test]
fn figures_stand_in_the_report_and_a_changed_file_publishes_anew() {
    let place = Place::with_scans();
    place.write("wave.csv", &csv(475.0));
    let text = manifest("{ file = \"wave.csv\", acceptance_deg = 1, bandwidth_nm = 3 }");
    place.publish(&text);
    let report = place.json("out/small/v0001/report.json");
    let measured = &report["specimens"][0]["measured"];
    assert_eq!(measured["file"], "wave.csv");
    assert_eq!(measured["rows"], 40);
    let columns = measured["columns"].as_array().unwrap();
    assert_eq!(columns.len(), 2);
    for column in columns {
        assert!(column["correlation"].as_f64().unwrap() > 0.9, "{}", column["correlation"]);
        let peaks = column["curves"][0]["peaks"].as_array().unwrap();
        // sin 30 deg x 960 nm, pulled by a lobe of 9 % of the wavelength.
        let model = peaks[0]["model"].as_f64().unwrap();
        assert!((model - 480.0).abs() < 15.0, "{model}");
    }
    assert!(columns[0]["scale"] == 1.0 && columns[1]["scale"] != 1.0);
    let index = place.json("out/small/v0001/atlas.json");
    let inputs: Vec<&str> = index["inputs"].as_array().unwrap().iter().map(|i| i["path"].as_str().unwrap()).collect();
    assert_eq!(inputs, ["wave.tif", "wave.csv"]);
    let page = std::fs::read_to_string(place.path("out/small/v0001/report.html")).unwrap();
    assert!(page.contains("<h3>Measured reflectance</h3>") && page.contains("relative_radiance:a"));

    place.publish(&text);
    assert_eq!(place.latest(), "v0001", "nothing has changed");
    place.write("wave.csv", &csv(476.0));
    place.publish(&text);
    assert_eq!(place.latest(), "v0002");
}

#[test]
fn a_faulty_file_fails_its_specimen_with_its_place() {
    let place = Place::with_scans();
    place.write("wave.csv", &csv(475.0).replacen("0;0;30;0;410", "0;0;x;0;410", 1));
    place.write("m.toml", &manifest("\"wave.csv\""));
    let called = place.call("--quiet run m.toml").ended(1);
    assert!(called.stderr.contains("wave.csv:4:5: `x` in the column `theta_r_deg`"), "{}", called.stderr);
    let called = place.call("plan m.toml").ended(1);
    assert!(called.stdout.contains("wave.csv:4:5:"), "{}", called.stdout);
}
