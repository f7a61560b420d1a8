//! `eval`: tables and reference, directions and their faults.

use diffraction_brdf::direction::from_angles_deg;
use serde_json::Value;

use crate::place::{HEAD, LASERS, Place, ROUGH, SCENES, WAVE, contents, program, usual};

pub const COLUMNS: &str = "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg";

/// The values beside the angles, a row per direction.
pub fn values(csv: &str) -> Vec<Vec<f64>> {
    let cells = |line: &str| line.split(',').skip(4).map(|cell| cell.parse().unwrap()).collect();
    csv.lines().skip(1).map(cells).collect()
}

/// Evenly spread directions up to 70 degrees that are not near the mirror direction.
pub fn directions(count: usize) -> String {
    let mut csv = format!("{COLUMNS}\n");
    let mut random = fastrand::Rng::with_seed(11);
    let mut found = 0;
    while found < count {
        let [ti, pi, tr, pr] = [70.0, 360.0, 70.0, 360.0].map(|range| (random.f64() * range * 10.0).round() / 10.0);
        let (wi, wo) = (from_angles_deg(ti, pi), from_angles_deg(tr, pr));
        if (wi[0] + wo[0]).hypot(wi[1] + wo[1]) > 0.5 {
            csv += &format!("{ti},{pi},{tr},{pr}\n");
            found += 1;
        }
    }
    csv
}

/// Sorted relative differences of the second column, Y.
fn differences(a: &[Vec<f64>], b: &[Vec<f64>]) -> Vec<f64> {
    assert_eq!(a.len(), b.len());
    let mut found: Vec<f64> = a.iter().zip(b).map(|(a, b)| (a[1] - b[1]).abs() / b[1]).collect();
    found.sort_by(f64::total_cmp);
    found
}

#[test]
fn an_atlas_alone_gives_its_check_values_back() {
    let place = Place::with_scans();
    place.publish(&usual());
    // Nothing but the version's own files, in a folder of its own.
    let elsewhere = Place::empty();
    std::fs::rename(place.path("out/small/v0001"), elsewhere.path("atlas")).unwrap();
    drop(place);
    for specimen in ["rough", "wave"] {
        let checks = elsewhere.json(&format!("atlas/{specimen}/specimen.json"))["check_values"].clone();
        let checks = checks.as_array().unwrap();
        assert_eq!(checks.len(), 20);
        let mut csv = format!("{COLUMNS}\n");
        for check in checks {
            let angles: Vec<String> = COLUMNS.split(',').map(|name| check[name].to_string()).collect();
            csv += &format!("{}\n", angles.join(","));
        }
        elsewhere.write("d.csv", &csv);
        let line = format!("eval --directions d.csv --atlas atlas --specimen {specimen} --interpolation ");
        let bilinear = elsewhere.call(&format!("{line}bilinear")).ended(0);
        let header = bilinear.stdout.lines().next().unwrap();
        assert_eq!(header, format!("{COLUMNS},X,Y,Z"));
        // Ten digits are written: half a unit of the tenth at most.
        let deviation = |values: &[Vec<f64>]| {
            let worst = |(row, check): (&Vec<f64>, &Value)| {
                (0..3)
                    .map(|c| {
                        let stored = check["xyz"][c].as_f64().unwrap();
                        (row[c] - stored).abs() / stored.abs().max(1e-300)
                    })
                    .fold(0.0, f64::max)
            };
            values.iter().zip(checks).map(worst).fold(0.0, f64::max)
        };
        assert!(deviation(&values(&bilinear.stdout)) <= 5.1e-10, "{specimen}: {}", bilinear.stdout);
        // Another way of looking up texels is another value: the comparison above can fail.
        let cubic = elsewhere.call(&format!("{line}cubic")).ended(0);
        assert!(deviation(&values(&cubic.stdout)) > 1e-6);
    }
}

#[test]
fn tables_on_a_fine_grid_give_the_reference_within_their_tolerance() {
    let place = Place::empty();
    // 3.84 um square, 0.4 um of coherence: the lobes are wide against the texels of a small table.
    place.scan("rough.tif", crate::place::rough(5), [64, 64], [60.0, 60.0]);
    let optics = LASERS
        .replace("sigma_um = 2, edge = \"tile\"", "sigma_um = 0.4, edge = \"fade\"")
        .replace("size = 65", "size = 129\nstorage = \"float\"\nprefilter = \"none\"");
    place.publish(&[HEAD, &optics, ROUGH].concat());
    place.write("d.csv", &directions(100));
    let tables = place.call("eval --directions d.csv --atlas out/small --specimen rough").ended(0);
    let reference =
        place.call("eval --directions d.csv --method reference --manifest m.toml --specimen rough").ended(0);
    let [tables, reference] = [&tables, &reference].map(|called| values(&called.stdout));
    let found = differences(&tables, &reference);
    // The tolerance of 1e-3 holds for the basis; the grid and single precision add their share.
    assert!(found[50] < 1e-3 && found[95] < 1e-2, "median {:.1e}, 95 % {:.1e}", found[50], found[95]);
    // A refractive index off by 1 % is seen.
    place.write("m2.toml", &[HEAD, &optics, &ROUGH.replace("1.5", "1.515")].concat());
    let other = place.call("eval --directions d.csv --method reference --manifest m2.toml --specimen rough").ended(0);
    assert!(differences(&tables, &values(&other.stdout))[50] > 1e-2);
}

#[test]
fn directions_below_the_surface_are_refused_by_their_line() {
    let place = Place::with_scans();
    place.publish(&[HEAD, LASERS, ROUGH].concat());
    for line in ["--atlas out/small", "--method reference --manifest m.toml"] {
        let eval = |csv: &str| {
            place.write("d.csv", csv);
            place.call(&format!("eval --directions d.csv --specimen rough {line}"))
        };
        for (row, column) in [
            ("30,0,90,0", "theta_r"),
            ("90,20,10,200", "theta_i"),
            ("10,0,-95,180", "theta_r"),
            ("1e300,0,0,0", "theta_i"),
        ] {
            let called = eval(&format!("{COLUMNS}\n10,0,12,170\n{row}\n")).ended(1);
            assert_eq!(called.stdout, "");
            let expected = format!("line 3: `{column}_deg` must lie above the horizon, between -90 and 90");
            assert!(called.stderr.contains(&expected), "{line}, {row}: {}", called.stderr);
        }
        let plain = eval(&format!("{COLUMNS}\n10,0,89.9,170\n")).ended(0).stdout;
        assert!(values(&plain)[0].iter().all(|x| (0.0..1e3).contains(x)), "{line}: {plain}");
        // As measured files may be written.
        let header = COLUMNS.replace(',', ";");
        assert_eq!(eval(&format!("# made by hand\n{header}\n10;0;89,9;170\n")).ended(0).stdout, plain);
    }
}

#[test]
fn wavelengths_are_evaluated_one_by_one() {
    let place = Place::with_scans();
    let green = LASERS.replace("[633, 532, 450]", "[532]");
    place.write("m.toml", &[HEAD, &green, ROUGH].concat());
    place.write("d.csv", &directions(10));
    let line = "eval --directions d.csv --method direct-sum --manifest m.toml --specimen rough";
    let spectral = place.call(&format!("{line} --wavelengths-nm 532,633.5")).ended(0);
    assert_eq!(spectral.stdout.lines().next().unwrap(), format!("{COLUMNS},f_532_nm,f_633.5_nm"));
    let xyz = place.call(line).ended(0);
    for (spectral, xyz) in values(&spectral.stdout).iter().zip(values(&xyz.stdout)) {
        // Under one line, Y is the BRDF at that line; both are written with ten digits.
        assert!((spectral[0] - xyz[1]).abs() <= 1e-9 * xyz[1], "{spectral:?} {xyz:?}");
        assert!((spectral[1] - xyz[1]).abs() > 1e-6 * xyz[1]);
    }
    place.call(&format!("{line} --wavelengths-nm 532 --out f.csv")).ended(0);
    let stored = std::fs::read_to_string(place.path("f.csv")).unwrap();
    assert_eq!(values(&stored), values(&spectral.stdout).iter().map(|row| vec![row[0]]).collect::<Vec<_>>());
    assert_eq!(place.call(&format!("{line} --wavelengths-nm 532,-1")).status, 2);
    // By the transforms, which is what is meant where nothing else is said: the same but for their interpolation.
    let fast = line.replace("direct-sum", "reference");
    for more in ["", "--wavelengths-nm 532,633.5"] {
        let [exact, found] =
            [line, &fast].map(|line| values(&place.call(&format!("{line} {more}")).ended(0).stdout).concat());
        let largest = exact.iter().copied().fold(0.0, f64::max);
        let worst = found.iter().zip(&exact).map(|(a, b)| (a - b).abs() / largest).fold(0.0, f64::max);
        assert!(worst > 0.0 && worst < 1e-6, "{more}: {worst:e}");
    }
}

/// What `eval` writes of single wavelengths is a measured file, and other forms hold the same numbers.
#[test]
fn values_have_the_forms_that_others_read() {
    let place = Place::with_scans();
    // Fine enough that spectral tables answer a measurement, and not the scan.
    let settings = LASERS.replace("size = 65", "size = 401");
    place.publish(&[HEAD, &settings, ROUGH].concat());
    let angles = "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg";
    place.write("d.csv", &format!("{angles},operator\n10,0,25,180,me\n"));
    let tables = "eval --directions d.csv --atlas out/small --specimen rough";
    let nm: Vec<String> = (0..20).map(|i| (450 + 5 * i).to_string()).collect();
    let long = place.call(&format!("{tables} --wavelengths-nm {} --long --out long.csv", nm.join(","))).ended(0);
    assert!(long.stderr.contains("not used: `operator`"), "{}", long.stderr);
    place.publish(&[HEAD, &settings, ROUGH, "measured = \"long.csv\"\n"].concat());
    let report = place.json("out/small/v0002/report.json");
    let column = &report["specimens"][0]["measured"]["columns"][0];
    assert_eq!((column["name"].as_str(), column["values"].as_u64()), (Some("brdf_per_sr"), Some(20)));
    assert!(column["relative_l2"].as_f64().unwrap() < 1e-8, "{column}");

    let colour = place.call(&format!("{tables} --colour --quiet")).ended(0);
    assert_eq!(colour.stderr, "");
    let names = "X,Y,Z,sRGB_R,sRGB_G,sRGB_B,x,y,dominant_nm";
    assert_eq!(colour.stdout.lines().next().unwrap(), format!("{angles},{names}"));
    let [x, y, z, r, g, b, cx, cy, _] = values(&colour.stdout)[0][..] else { panic!("nine values") };
    assert!((cx - x / (x + y + z)).abs() < 1e-8 && (cy - y / (x + y + z)).abs() < 1e-8);
    assert!([r, g, b].iter().all(|c| (0.0..=1.0).contains(c)));

    place.call(&format!("{tables} --npy --out v.npy")).ended(0);
    let bytes = std::fs::read(place.path("v.npy")).unwrap();
    let last = f64::from_le_bytes(bytes[bytes.len() - 8..].try_into().unwrap());
    assert!((last - z).abs() <= 1e-9 * z, "{last} {z}");
    assert_eq!(place.call(&format!("{tables} --npy")).status, 2, "NumPy's form needs a file");
    assert_eq!(place.call(&format!("{tables} --long")).status, 2, "a row for each of no wavelengths");
}

/// One atlas answers for wavelengths and lights that its manifest did not name.
#[test]
fn an_atlas_answers_for_other_wavelengths_and_lights() {
    let place = Place::with_scans();
    // Fine enough for the lobe of 2 µm of coherence at 380 nm.
    let settings = LASERS.replace("size = 65", "size = 401");
    place.publish(&[HEAD, &settings, ROUGH].concat());
    place.write("d.csv", &directions(10));
    let tables = "eval --directions d.csv --atlas out/small --specimen rough";
    let scan = "eval --directions d.csv --method reference --specimen rough --manifest";
    let meets = |line: &str, by_scan: &str, tolerance: f64| {
        let [found, exact] = [line, by_scan].map(|line| place.call(line).ended(0).stdout);
        assert_eq!(found.lines().next(), exact.lines().next());
        let (found, exact) = (values(&found).concat(), values(&exact).concat());
        let largest = exact.iter().copied().fold(0.0, f64::max);
        let worst = found.iter().zip(&exact).map(|(a, b)| (a - b).abs() / largest).fold(0.0, f64::max);
        assert!(worst < tolerance && worst > 0.0, "{line}: {worst:e}");
    };
    meets(
        &format!("{tables} --wavelengths-nm 450,500,780"),
        &format!("{scan} m.toml --wavelengths-nm 450,500,780"),
        1e-2,
    );
    for (light, written) in [("A", "\"A\""), ("F11", "\"F11\""), ("532,450", "{ lines_nm = [450, 532] }")] {
        let other = LASERS.replace("{ lines_nm = [633, 532, 450] }", written);
        assert_ne!(other, LASERS);
        place.write("other.toml", &[HEAD, &other, ROUGH].concat());
        meets(&format!("{tables} --illuminant {light}"), &format!("{scan} other.toml"), 1e-2);
    }
    let own = place.call(tables).ended(0).stdout;
    let other = place.call(&format!("{tables} --illuminant A")).ended(0).stdout;
    assert_ne!(values(&own), values(&other));
}

/// Spectral tables alone: no file of X, Y, Z, and everything still answers.
#[test]
fn spectral_tables_alone_answer_for_everything() {
    let place = Place::with_scans();
    // Fine enough that what lies between texels is no question: 401 leaves 4e-3, and a cubic falls with the fourth power.
    let settings = LASERS.replace("size = 65", "size = 801");
    place.publish(&[HEAD, &settings, ROUGH, SCENES].concat());
    let alone = settings.clone() + "hold = [\"spectral\"]\n";
    let head = HEAD.replace("\"small\"", "\"alone\"");
    place.write("alone.toml", &[&head, &alone, ROUGH, SCENES].concat());
    place.call("run alone.toml --quiet").ended(0);
    let files = contents(&place.path("out/alone/v0001"));
    let is_xyz = |path: &&String| path.contains("/table.") || path.contains("/lobe.");
    assert!(
        !files.keys().any(|path| is_xyz(&path)) && files.contains_key("rough/spectral.000.exr"),
        "{:?}",
        files.keys()
    );
    assert!(files.contains_key("rough/preview.png") && files.contains_key("rough/scenes/map.exr"));
    let specimen: serde_json::Value = serde_json::from_slice(&files["rough/specimen.json"]).unwrap();
    assert_eq!(specimen["tables"]["tables"].as_array().map(Vec::len), Some(0));
    assert_eq!(specimen["tables"]["derived_under"]["wavelength_nm"].as_array().map(Vec::len), Some(2));
    assert!(!specimen["spectral"]["check_values"].as_array().unwrap().is_empty());
    let page = String::from_utf8(files["FORMAT.md"].clone()).unwrap();
    assert!(page.contains("holds spectral tables alone") && !page.contains("## A worked number"));
    // Values are those of an atlas with both kinds, whose own tables of X, Y, Z come from the scan.
    place.write("d.csv", &directions(10));
    let of = |atlas: &str, more: &str| {
        let line = format!("eval --directions d.csv --atlas out/{atlas} --specimen rough --interpolation cubic {more}");
        values(&place.call(&line).ended(0).stdout).concat()
    };
    for (more, tolerance) in [("", 2e-3), ("--wavelengths-nm 450,500,780", 1e-12)] {
        let (found, exact) = (of("alone", more), of("small", more));
        let largest = exact.iter().copied().fold(0.0, f64::max);
        let worst = found.iter().zip(&exact).map(|(a, b)| (a - b).abs() / largest).fold(0.0, f64::max);
        assert!(worst <= tolerance, "{more}: {worst:e}");
    }
    place.call("verify out/alone").ended(0);
    assert!(place.call("inspect out/alone").ended(0).stdout.contains("spectral tables of 801"));
    assert!(place.call("plan alone.toml").ended(0).stdout.contains("files of X, Y, Z"));
    place.call("export out/alone --form shaders --out shaders").ended(0);
    assert!(place.path("shaders/rough/spectral_tables.rgba16f").is_file());
    // A library user sees no difference either.
    let brdf = diffraction_brdf::Atlas::open(place.path("out/alone")).unwrap().brdf("rough").unwrap();
    assert!(brdf.eval([0.0, 0.0, 1.0], [0.0, 0.0, 1.0])[1] > 0.0);
    // Without the spectral tables' entry there is nothing to derive from.
    let mut broken = specimen.clone();
    broken.as_object_mut().unwrap().remove("spectral");
    let folder = place.path("broken");
    std::fs::create_dir(&folder).unwrap();
    std::fs::write(folder.join("specimen.json"), broken.to_string()).unwrap();
    let error = diffraction_brdf::specimen::load(&folder).unwrap_err().to_string();
    assert!(error.contains("derived from spectral ones"), "{error}");
}

#[test]
fn polarised_values_add_up_to_the_unpolarised_ones() {
    let place = Place::with_scans();
    place.publish(&[HEAD, LASERS, ROUGH, WAVE].concat());
    // Away from the mirror direction, and in it, where the lobe is.
    place.write("d.csv", &(directions(10) + "40,10,40,190\n57.3,0,57,180.5\n"));
    // Splines' coefficients are made once, in 32 bits, for many values, and in 64 for one.
    for (line, bound) in [
        ("--atlas out/small", f64::from(f32::EPSILON)),
        ("--method direct-sum --manifest m.toml", 2e-9),
        ("--method direct-sum --manifest m.toml --wavelengths-nm 450,633", 2e-9),
    ] {
        let line = format!("eval --directions d.csv --specimen rough {line}");
        let (plain, kept) = (place.call(&line).ended(0), place.call(&format!("{line} --polarised")).ended(0));
        let first = plain.stdout.lines().next().unwrap().split(',').nth(4).unwrap();
        let header = kept.stdout.lines().next().unwrap();
        assert!(header.starts_with(&format!("{COLUMNS},{first}_ss,{first}_sp,{first}_ps,{first}_pp,")), "{header}");
        let (plain, kept) = (values(&plain.stdout), values(&kept.stdout));
        assert_eq!(plain.len(), 12);
        for (plain, kept) in plain.iter().zip(&kept) {
            assert_eq!(kept.len(), 4 * plain.len());
            for (sum, kinds) in plain.iter().zip(kept.chunks(4)) {
                let half = 0.5 * kinds.iter().sum::<f64>();
                assert!((half - sum).abs() <= bound * sum.abs(), "{line}: {half} {sum}");
            }
        }
        // Near Brewster's angle of n = 1.5, p is hardly reflected; elsewhere some light changes its polarisation.
        let [brewster, apart] = [&kept[11], &kept[0]];
        assert!(brewster[3] < 1e-2 * brewster[0], "{brewster:?}");
        assert!(apart[1] > 1e-6 * apart[0], "{apart:?}");
    }
    // An ideal reflector has no index.
    for line in ["--atlas out/small", "--method reference --manifest m.toml"] {
        let called = place.call(&format!("eval --directions d.csv --specimen wave --polarised {line}")).ended(1);
        assert!(called.stdout.is_empty() && called.stderr.contains("ideal reflector, which has no refractive index"));
    }
}

#[test]
fn directions_come_from_standard_input_and_values_as_json() {
    let place = Place::with_scans();
    place.publish(&[HEAD, LASERS, ROUGH].concat());
    let csv = format!("{COLUMNS}\n10,20,30.5,200\n0,0,12,-7\n");
    place.write("d.csv", &csv);
    let line = "--atlas out/small --specimen rough --wavelengths-nm 450,633";
    let plain = place.call(&format!("eval --directions d.csv {line}")).ended(0);
    let piped = |line: &str, input: &str| {
        let words = format!("eval --directions - {line}");
        program(place.folder()).args(words.split(' ')).write_stdin(input).output().unwrap()
    };
    assert_eq!(String::from_utf8(piped(line, &csv).stdout).unwrap(), plain.stdout);
    let spoilt = piped(line, &csv.replace("12", "twelve"));
    let said = String::from_utf8(spoilt.stderr).unwrap();
    assert!(spoilt.status.code() == Some(1) && said.contains("standard input: line 3: `twelve`"), "{said}");

    let json = place.call(&format!("eval --directions d.csv {line} --json")).ended(0).json();
    let rows = values(&plain.stdout);
    assert_eq!(json.as_array().unwrap().len(), rows.len());
    for (object, row) in json.as_array().unwrap().iter().zip(rows) {
        let names: Vec<&String> = object.as_object().unwrap().keys().collect();
        assert_eq!(names, ["theta_i_deg", "phi_i_deg", "theta_r_deg", "phi_r_deg", "f_450_nm", "f_633_nm"]);
        for (name, expected) in names.iter().skip(4).zip(row) {
            // CSV holds ten digits.
            let found = object[name.as_str()].as_f64().unwrap();
            assert!((found - expected).abs() <= 1e-9 * expected.abs(), "{name}: {found} for {expected}");
        }
    }
    place.call(&format!("eval --directions d.csv {line} --json --out d.json")).ended(0);
    assert_eq!(place.json("d.json"), json);
}

#[test]
fn what_is_wrong_with_a_call_is_said() {
    let place = Place::with_scans();
    place.publish(&[HEAD, LASERS, ROUGH, WAVE].concat());
    place.write("good.csv", &format!("{COLUMNS}\n1,2,3,4\n"));
    place.write("word.csv", &format!("{COLUMNS}\n1,2,3,4\n1,two,3,4\n"));
    place.write("short.csv", &format!("{COLUMNS}\n1,2,3,4\n\n1,2,3\n"));
    place.write("columns.csv", "theta_i_deg,phi_i_deg,theta_o_deg,phi_o_deg\n1,2,3,4\n");
    let tables = "--atlas out/small --specimen rough";
    for (line, status, fragment) in [
        (format!("--directions word.csv {tables}"), 1, "word.csv: line 3: `two` in `phi_i_deg`"),
        (
            format!("--directions short.csv {tables}"),
            1,
            "short.csv: line 4: expected 4 cells as in the line of names, found 3",
        ),
        (format!("--directions columns.csv {tables}"), 1, "`theta_r_deg` is missing"),
        (format!("--directions none.csv {tables}"), 1, "none.csv: cannot read"),
        ("--directions good.csv --atlas out/small --specimen ruff".into(), 2, "it holds rough, wave"),
        ("--directions good.csv --atlas out --specimen rough".into(), 2, "no atlas"),
        ("--directions good.csv --atlas nowhere --specimen rough".into(), 2, "nowhere: there is no such folder"),
        ("--directions good.csv --method reference --manifest m.toml --specimen ruff".into(), 2, "rough, wave"),
        (format!("--directions good.csv {tables} --wavelengths-nm 200"), 2, "begin at 380 nm"),
        (format!("--directions good.csv {tables} --illuminant D66"), 2, "did you mean \"D65\"?"),
        (format!("--directions good.csv {tables} --illuminant 200000"), 2, "no line between"),
        (format!("--directions good.csv {tables} --illuminant none.csv"), 2, "none.csv"),
        (format!("--directions good.csv {tables} --illuminant A --wavelengths-nm 500"), 2, "cannot be used with"),
    ] {
        let called = place.call(&format!("eval {line}")).ended(status);
        assert_eq!(called.stdout, "", "{line}");
        assert!(called.stderr.contains(fragment), "{line}: {}", called.stderr);
    }
}
