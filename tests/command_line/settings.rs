//! Optics, tables and scans other than the usual ones, each held against what it must come to.

use diffraction_brdf::exr_image::{check_file, read_rgb};
use serde_json::Value;

use crate::evaluation::{COLUMNS, directions, values};
use crate::place::{HEAD, LASERS, Place, ROUGH};

/// Scans and settings in which the grid resolves the lobe: 3.84 um square, 0.4 um of coherence.
const FINE: &str = r#"[optics]
illuminant = { lines_nm = [633, 532, 450] }
coherence = { sigma_um = 0.4, edge = "fade" }
[tables]
size = 129
prefilter = "none"
"#;

fn fine_place() -> Place {
    let place = Place::empty();
    for (name, seed) in [("rough.tif", 5), ("rough_b.tif", 6)] {
        place.scan(name, crate::place::rough(seed), [64, 64], [60.0, 60.0]);
    }
    place.write("d.csv", &directions(40));
    place
}

/// XYZ of a specimen from the tables of the newest version.
fn tables(place: &Place, specimen: &str) -> Vec<Vec<f64>> {
    values(&place.call(&format!("eval --directions d.csv --atlas out/small --specimen {specimen}")).ended(0).stdout)
}

/// XYZ of a specimen of `m.toml` straight from its scans.
fn reference(place: &Place, specimen: &str) -> Vec<Vec<f64>> {
    let line = format!("eval --directions d.csv --method direct-sum --manifest m.toml --specimen {specimen}");
    values(&place.call(&line).ended(0).stdout)
}

fn specimen_json(place: &Place, specimen: &str) -> Value {
    place.json(&format!("out/small/{}/{specimen}/specimen.json", place.latest()))
}

/// Largest difference of Y, relative to the second set's.
fn worst(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    assert!(!a.is_empty() && a.len() == b.len());
    a.iter().zip(b).map(|(a, b)| (a[1] - b[1]).abs() / b[1]).fold(0.0, f64::max)
}

#[test]
fn several_scans_are_averaged() {
    let place = fine_place();
    let one = |name: &str, scans: &str| format!("[[specimen]]\nname = \"{name}\"\nscans = {scans}\nlevel = \"none\"\n");
    let specimens = [
        one("a", "\"rough.tif\""),
        one("b", "\"rough_b.tif\""),
        one("both", "[\"rough.tif\", \"rough_b.tif\"]"),
        one("pattern", "\"rough*.tif\""),
    ];
    place.publish(&[HEAD, FINE, &specimens.concat()].concat());
    let mean = |of: &dyn Fn(&Place, &str) -> Vec<Vec<f64>>| -> Vec<Vec<f64>> {
        let (a, b) = (of(&place, "a"), of(&place, "b"));
        assert!(worst(&a, &b) > 0.1, "the two scans differ");
        a.iter().zip(&b).map(|(a, b)| (0..3).map(|c| 0.5 * (a[c] + b[c])).collect()).collect()
    };
    // Powers add: equal scans weigh the same. Ten digits are written.
    assert!(worst(&reference(&place, "both"), &mean(&reference)) < 1e-9);
    // Half tables: 2^-11 of each of a few terms.
    assert!(worst(&tables(&place, "both"), &mean(&tables)) < 5e-3);
    assert_eq!(tables(&place, "pattern"), tables(&place, "both"));
    let provenance = specimen_json(&place, "both")["provenance"].clone();
    assert_eq!(provenance.as_array().unwrap().len(), 2);
    assert_eq!(place.json("out/small/v0001/atlas.json")["inputs"].as_array().unwrap().len(), 6);
}

#[test]
fn one_window_in_the_centre_or_all_the_scan_holds() {
    let place = fine_place();
    place.scan("rough.tif", crate::place::rough(5), [128, 96], [60.0, 60.0]);
    place.publish(&[HEAD, FINE, ROUGH].concat());
    let many = specimen_json(&place, "rough")["build"]["windows"].as_u64().unwrap();
    assert!(many > 1, "{many}");
    let grid = tables(&place, "rough");
    assert!(worst(&grid, &reference(&place, "rough")) < 0.05);

    place.publish(&[HEAD, &FINE.replace("[tables]", "windows = \"centre\"\n[tables]"), ROUGH].concat());
    assert_eq!(specimen_json(&place, "rough")["build"]["windows"], 1);
    let centre = tables(&place, "rough");
    assert!(worst(&centre, &grid) > 0.1, "one window alone shows speckle");
    assert!(worst(&centre, &reference(&place, "rough")) < 0.05);
}

#[test]
fn a_flat_spectrum_from_a_file_is_equal_energy() {
    let place = fine_place();
    place.write("lamp.csv", "# a lamp that does not exist\nwavelength_nm,power\n300,7\n900,7\n");
    let with = |illuminant: &str| {
        let optics = FINE.replace("{ lines_nm = [633, 532, 450] }", &format!("{illuminant:?}"));
        // Half tables would round some values up here and down there.
        let optics = optics.replace("prefilter", "storage = \"float\"\nprefilter");
        place.publish(&[HEAD, &optics, ROUGH].concat());
        (tables(&place, "rough"), reference(&place, "rough"))
    };
    let ((lamp, lamp_reference), (equal, equal_reference), (day, _)) = (with("lamp.csv"), with("E"), with("D65"));
    // Tables are summed in single precision: 1e-7 of the brightest order, seen from directions where the orders
    // come to less than a thousandth of it.
    assert!(worst(&lamp, &equal) < 2e-4, "{:e}", worst(&lamp, &equal));
    assert!(worst(&lamp_reference, &equal_reference) < 1e-9);
    assert!(worst(&lamp, &day) > 5e-3, "daylight is another light");
    assert!(worst(&lamp, &lamp_reference) < 0.05);
}

#[test]
fn materials_scale_by_their_reflectance() {
    let place = fine_place();
    // Light and viewer both along the normal meet every facet of the mean plane at 0 degrees, where
    // R = ((n - 1)² + k²) / ((n + 1)² + k²).
    place.write("d.csv", &format!("{COLUMNS}\n0,0,0,0\n"));
    let names = [("ideal", "\"ideal\""), ("keratin", "{ n = 1.56 }"), ("silver", "{ n = 0.13, k = 3.3 }")];
    let specimen = |(name, material): (&str, &str)| {
        format!("[[specimen]]\nname = \"{name}\"\nscans = [\"rough.tif\"]\nmaterial = {material}\n")
    };
    place.publish(&[HEAD, FINE, &names.map(specimen).concat()].concat());
    let reflectance = |n: f64, k: f64| ((n - 1.0).powi(2) + k * k) / ((n + 1.0).powi(2) + k * k);
    for of in [tables, reference] {
        let ideal = of(&place, "ideal")[0][1];
        assert!(ideal > 0.0);
        for (name, n, k) in [("keratin", 1.56, 0.0), ("silver", 0.13, 3.3)] {
            let ratio = of(&place, name)[0][1] / ideal;
            assert!((ratio / reflectance(n, k) - 1.0).abs() < 1e-8, "{name}: {ratio}");
        }
    }
}

#[test]
fn float_storage_keeps_more_digits_than_half() {
    let place = fine_place();
    let with = |storage: &str| {
        let tables_section = format!("storage = \"{storage}\"\ncount = 8\nprefilter");
        place.publish(&[HEAD, &FINE.replace("prefilter", &tables_section), ROUGH].concat());
        let json = specimen_json(&place, "rough");
        assert_eq!(json["tables"]["storage"], storage);
        let tables_found = json["tables"]["tables"].as_array().unwrap().len();
        assert_eq!(tables_found, 8, "as many as the manifest says");
        let path = place.path(&format!("out/small/{}/rough/table.000.exr", place.latest()));
        check_file(&path).unwrap();
        (tables(&place, "rough"), std::fs::metadata(path).unwrap().len())
    };
    let ((half, half_bytes), (float, float_bytes)) = (with("half"), with("float"));
    assert!(float_bytes > half_bytes);
    let difference = worst(&half, &float);
    // Eight terms, each off by at most 2^-11 of itself; the sum of their magnitudes is about the value.
    assert!(difference > 1e-6 && difference < 5e-3, "{difference:e}");
}

#[test]
fn the_published_series_agrees_where_it_can_and_refuses_where_it_cannot() {
    let place = fine_place();
    let taylor = |tables_section: &str| FINE.replace("prefilter", &format!("{tables_section}\nprefilter"));
    place.publish(&[HEAD, &taylor("basis = \"taylor\"\nstorage = \"float\""), ROUGH].concat());
    let json = specimen_json(&place, "rough");
    assert_eq!(json["tables"]["basis"], "taylor");
    assert!(json["tables"]["lobe"].is_null());
    assert!(!place.path("out/small/v0001/rough/lobe.exr").exists());
    assert!(worst(&tables(&place, "rough"), &reference(&place, "rough")) < 0.05);
    place.call("verify out/small --manifest m.toml").ended(0);

    // Three micrometres deep: its terms would cancel to nothing.
    let deep = r#"[[specimen]]
name = "deep"
scans = ["deep.tif"]
"#;
    let wave = diffraction_build::height::synthesize::Structure::Sinusoid {
        period_nm: 960.0,
        amplitude_nm: 1500.0,
        direction_deg: 0.0,
    };
    place.scan("deep.tif", wave, [64, 64], [60.0, 60.0]);
    place.write("m.toml", &[HEAD, &taylor("basis = \"taylor\""), deep].concat());
    let refused = place.call("--quiet run m.toml").ended(1);
    assert!(refused.stderr.contains("failed: deep") && refused.stderr.contains("chebyshev"), "{}", refused.stderr);
}

#[test]
fn a_tiled_scan_without_seams_is_the_same_wherever_it_is_cut() {
    // Averaged over all window positions, a periodic scan has no first column.
    let place = Place::with_scans();
    let whole = diffraction_build::height::read::read_scan(&place.path("rough.tif"), &Default::default()).unwrap();
    let mut turned = whole.field.clone();
    let (rows, columns) = turned.heights_nm.dim();
    turned.heights_nm = ndarray::Array2::from_shape_fn((rows, columns), |(r, c)| {
        whole.field.heights_nm[[(r + 9) % rows, (c + 31) % columns]]
    });
    diffraction_build::height::write::write_scan_tiff(&place.path("turned.tif"), &turned).unwrap();
    place.write("d.csv", &directions(20));
    let specimen =
        |name: &str| format!("[[specimen]]\nname = \"{name}\"\nscans = [\"{name}.tif\"]\nlevel = \"none\"\n");
    place.publish(&[HEAD, LASERS, &specimen("rough"), &specimen("turned")].concat());
    let (a, b) = (tables(&place, "rough"), tables(&place, "turned"));
    // Half tables whose rounding may fall either way.
    assert!(worst(&a, &b) < 5e-3, "{:e}", worst(&a, &b));
}

/// A white pigment adds what passes the surface twice, and that to pictures alone: drawn from tables and from the reference
/// alike, while tables, `eval` and the values to test readers with stay as they were.
#[test]
fn a_pigment_lies_below_the_structure_in_pictures_alone() {
    let place = fine_place();
    let specimen = |name: &str, rest: &str| ROUGH.replace("\"rough\"", &format!("\"{name}\"")) + rest;
    let scene = "[[scene]]\nname = \"tile\"\nshape = \"patch\"\nwidth_mm = 1\ndistance_mm = 1000\nsize_px = 16\n\
        light = { direction = [3, 0, 4], angular_diameter_deg = 0, irradiance = 2 }\n";
    let checked = HEAD.replace("\"off\"", "\"auto\"");
    place.publish(&[&checked, FINE, &specimen("bare", ""), &specimen("dyed", "albedo = [1, 1, 1]\n"), scene].concat());
    let read = |file: &str| read_rgb(&place.path(&format!("out/small/v0001/{file}"))).unwrap().0;
    let bytes = |file: &str| std::fs::read(place.path(&format!("out/small/v0001/{file}"))).unwrap();
    assert_eq!(bytes("bare/table.000.exr"), bytes("dyed/table.000.exr"));
    assert_eq!(tables(&place, "bare"), tables(&place, "dyed"));
    let json = ["bare", "dyed"].map(|name| specimen_json(&place, name));
    assert_eq!(json[0]["check_values"], json[1]["check_values"]);
    assert!(json[0].get("pigment").is_none());
    // n = 1.5 at cosine 1 and 0.8, from the two polarisations' closed forms.
    let (cos_i, cos_t) = (0.8f64, (1.0f64 - 0.36 / 2.25).sqrt());
    let s = ((cos_i - 1.5 * cos_t) / (cos_i + 1.5 * cos_t)).powi(2);
    let p = ((1.5 * cos_i - cos_t) / (1.5 * cos_i + cos_t)).powi(2);
    let expected = 2.0 * 0.8 / std::f64::consts::PI * (1.0 - 0.04) * (1.0 - 0.5 * (s + p));
    for kind in ["tile.exr", "tile.reference.exr"] {
        let added = read(&format!("dyed/scenes/{kind}")) - read(&format!("bare/scenes/{kind}"));
        // The middle half of the square, which the camera sees from within 0.03 degrees of the normal.
        let side = added.dim().0;
        for (row, column) in (side / 4..3 * side / 4).flat_map(|r| (side / 4..3 * side / 4).map(move |c| (r, c))) {
            // A white's Y, read from 32-bit pictures.
            let found = f64::from(added[[row, column, 1]]);
            assert!((found / expected - 1.0).abs() < 3e-4, "{kind}: {found} for {expected}");
        }
    }
    let report = place.json("out/small/v0001/report.json");
    assert_eq!(report["failures"].as_array().unwrap().len(), 0, "{}", report["failures"]);
}
