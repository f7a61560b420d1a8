//! Materials by name and by file: what a run records of them, and what `eval` makes of them.

use diffraction_brdf::dispersion::Dispersion;
use diffraction_brdf::files;
use serde_json::Value;

use crate::evaluation::{COLUMNS, directions, values};
use crate::place::{HEAD, Place};

const OPTICS: &str = r#"[optics]
coherence = { sigma_um = 0.4, edge = "fade" }
[tables]
size = 129
prefilter = "none"
"#;

/// A metal that reflects little of the blue.
const GILT: &str = "# worn\nwavelength_nm,n,k\n350,1.5,1.9\n450,1.4,1.9\n520,0.6,2.1\n600,0.25,3\n800,0.15,5\n";

fn place() -> Place {
    let place = Place::empty();
    place.scan("rough.tif", crate::place::rough(5), [64, 64], [60.0, 60.0]);
    place.write("nk.csv", GILT);
    // Along the normal first: there every part of the surface meets light at 0 degrees.
    place.write("d.csv", &format!("{COLUMNS}\n0,0,0,0\n"));
    place
}

fn manifest(materials: &[(&str, &str)]) -> String {
    let specimen = |(name, material): &(&str, &str)| {
        format!("[[specimen]]\nname = \"{name}\"\nscans = [\"rough.tif\"]\nmaterial = {material}\n")
    };
    [HEAD, OPTICS].concat() + &materials.iter().map(specimen).collect::<String>()
}

const MATERIALS: [(&str, &str); 4] = [
    ("ideal", "\"ideal\""),
    ("gold", "{ metal = \"gold\" }"),
    ("gilt", "{ file = \"nk.csv\" }"),
    ("chitin", "{ substance = \"chitin\" }"),
];

fn specimen(place: &Place, name: &str) -> Value {
    place.json(&format!("out/small/{}/{name}/specimen.json", place.latest()))
}

fn eval(place: &Place, name: &str, rest: &str) -> Vec<Vec<f64>> {
    values(&place.call(&format!("eval --directions d.csv --specimen {name} {rest}")).ended(0).stdout)
}

#[test]
fn a_run_records_where_an_index_comes_from() {
    let place = place();
    let text = manifest(&MATERIALS) + "[report]\nreference = false\n";
    place.publish(&text);
    let optics = |name: &str| specimen(&place, name)["optics"].clone();
    assert!(optics("ideal").get("dispersion").is_none(), "what is the same at every wavelength says nothing of it");
    let gold = optics("gold");
    let [n, k] = ["n", "k"].map(|part| gold["material"]["conductor"][part].as_f64().unwrap());
    let reference_nm = gold["dispersion"]["reference_nm"].as_f64().unwrap();
    assert_eq!(Dispersion::metal("gold").unwrap().index_at(reference_nm), Some([n, k]));
    let table = &gold["dispersion"]["table"];
    assert!(table["origin"]["literature"].as_str().unwrap().contains("Johnson"), "{table}");
    let gilt = optics("gilt");
    let file = &gilt["dispersion"]["table"]["origin"]["file"];
    let sha256 = files::sha256_hex(GILT.as_bytes());
    assert_eq!((file["path"].as_str(), file["sha256"].as_str()), (Some("nk.csv"), Some(sha256.as_str())));
    assert!(optics("chitin")["material"]["dielectric"]["n"].as_f64().unwrap() > 1.54);
    let inputs = |version: &str| place.json(&format!("out/small/{version}/atlas.json"))["inputs"].clone();
    let is_there = |inputs: &Value, sha256: &str| {
        inputs.as_array().unwrap().iter().any(|input| input["path"] == "nk.csv" && input["sha256"] == sha256)
    };
    assert!(is_there(&inputs("v0001"), &sha256), "{}", inputs("v0001"));
    let format = std::fs::read_to_string(place.path("out/small/v0001/FORMAT.md")).unwrap();
    assert!(format.contains("`R`, the Fresnel reflectance"), "{format}");
    // Another index in the file is another atlas; the same is none.
    place.publish(&text);
    assert_eq!(place.latest(), "v0001");
    let other = GILT.replace("0.25,3", "0.26,3");
    place.write("nk.csv", &other);
    place.publish(&text);
    assert_eq!(place.latest(), "v0002");
    assert!(is_there(&inputs("v0002"), &files::sha256_hex(other.as_bytes())));
}

#[test]
fn along_the_normal_tables_and_scan_reflect_each_wavelength_by_its_own_index() {
    let place = place();
    place.publish(&(manifest(&MATERIALS) + "[report]\nreference = false\n"));
    let reference = "--method reference --manifest m.toml";
    let by_wavelength =
        |name: &str| eval(&place, name, &format!("{reference} --wavelengths-nm 420,520,560,700"))[0].clone();
    let ideal = by_wavelength("ideal");
    for (name, table) in [("gold", Dispersion::metal("gold")), ("chitin", Dispersion::substance("chitin"))] {
        for ((nm, found), ideal) in [420.0, 520.0, 560.0, 700.0].into_iter().zip(by_wavelength(name)).zip(&ideal) {
            let [n, k] = table.as_ref().unwrap().index_at(nm).unwrap();
            let expected = ((n - 1.0f64).powi(2) + k * k) / ((n + 1.0).powi(2) + k * k);
            assert!((found / ideal / expected - 1.0).abs() < 1e-8, "{name} {nm}: {found} of {ideal}");
        }
    }
    let mut blue = Vec::new();
    for (name, _) in MATERIALS {
        let tables = eval(&place, name, "--atlas out/small")[0].clone();
        let scan = eval(&place, name, reference)[0].clone();
        for c in 0..3 {
            // In the mirror direction the front factor is the reflectance, which tables hold of each wavelength.
            assert!((tables[c] / scan[c] - 1.0).abs() < 1e-3, "{name}: {tables:?} {scan:?}");
        }
        blue.push(tables[2] / tables[1]);
    }
    let message = place
        .call(&format!("eval --directions d.csv --specimen gold {reference} --wavelengths-nm 1000"))
        .ended(2)
        .stderr;
    assert!(message.contains("gold is known from 300.9 to 892 nm") && message.contains("1000 nm"), "{message}");
}

#[test]
fn the_report_tells_what_one_front_factor_costs() {
    let place = place();
    place.write("d.csv", &directions(20));
    place.publish(&manifest(&MATERIALS[..2]));
    let rows = |name: &str| {
        let errors = specimen(&place, name)["errors"].clone();
        let rows = errors.as_array().unwrap().iter();
        rows.filter(|row| row["what"] == "front factor at one wavelength").cloned().collect::<Vec<_>>()
    };
    assert!(rows("ideal").is_empty());
    let gold = rows("gold");
    assert!(!gold.is_empty());
    for row in &gold {
        let p95 = row["p95"].as_f64().unwrap();
        assert!(p95 > 1e-4 && p95 < 0.3, "{row}");
    }
    place.call("verify out/small --manifest m.toml").ended(0);
    let report = std::fs::read_to_string(place.path("out/small/v0001/report.html")).unwrap();
    assert!(report.contains("front factor at one wavelength") && report.contains("Johnson and R. W. Christy"));
}
