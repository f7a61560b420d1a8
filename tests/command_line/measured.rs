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
fn a_faulty_file_costs_the_comparison_and_not_the_tables() {
    let place = Place::with_scans();
    place.write("wave.csv", &csv(475.0).replacen("0;0;30;0;410", "0;0;x;0;410", 1));
    place.write("m.toml", &manifest("\"wave.csv\""));
    let called = place.call("run m.toml").ended(0);
    let expected =
        "warning: wave: not compared with the measured reflectance: wave.csv:4:5: `x` in the column `theta_r_deg`";
    assert!(called.stderr.lines().any(|line| line.starts_with(expected)), "{}", called.stderr);
    let report = place.json("out/small/v0001/report.json");
    assert!(report["specimens"][0]["measured"].is_null() && report["specimens"][0]["build"].is_object());
    let called = place.call("plan m.toml").ended(1);
    assert!(called.stdout.contains("wave.csv:4:5:"), "{}", called.stdout);
}

/// What a spectrometer writes, with the geometry in the manifest, is compared as a file that says it all.
#[test]
fn a_spectrometers_export_is_compared() {
    let place = Place::with_scans();
    let rows: String = csv(475.0)
        .lines()
        .skip(1)
        .map(|line| {
            let cells: Vec<&str> = line.split(';').collect();
            format!("{}\t{}\n", cells[4], cells[5])
        })
        .collect();
    place.write(
        "wave.txt",
        &format!("SpectraSuite Data File\n>>>>>Begin Processed Spectral Data<<<<<\n150,0\t1,0\n{rows}>>>>>End<<<<<\n"),
    );
    place.write("wave.csv", &csv(475.0));
    let place_of = "theta_i_deg = 0, theta_r_deg = 30, kind = \"brdf_per_sr\", white_reflectance = 1";
    place.publish(&manifest(&format!("{{ file = \"wave.txt\", {place_of} }}")));
    place.publish(&manifest("\"wave.csv\""));
    let column = |version: &str| {
        place.json(&format!("out/small/{version}/report.json"))["specimens"][0]["measured"]["columns"][0].clone()
    };
    let (export, long) = (column("v0001"), column("v0002"));
    for figure in ["values", "relative_l2", "correlation", "best_scale"] {
        assert_eq!(export[figure], long[figure], "{figure}");
    }
    let notes = place.json("out/small/v0001/report.json")["specimens"][0]["measured"]["notes"].to_string();
    assert!(notes.contains("1 rows with wavelengths outside"), "{notes}");
    // Without the geometry nobody knows what the values are.
    place.write("m.toml", &manifest("{ file = \"wave.txt\", theta_i_deg = 0 }"));
    let called = place.call("run m.toml").ended(2);
    assert!(called.stderr.contains("`kind` is missing"), "{}", called.stderr);
    place.write("m.toml", &manifest("\"wave.txt\""));
    let called = place.call("run m.toml").ended(0);
    assert!(called.stderr.contains("say the geometry and the kind in the manifest"), "{}", called.stderr);
}
