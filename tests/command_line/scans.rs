//! Scans from the command line: generated, looked at, and saved.

use diffraction_build::height::read::{ReadConfig, read_scan};
use diffraction_build::height::synthesize::{Structure, synthesize};
use tiff::encoder::{TiffEncoder, colortype::Gray16};

use crate::place::{HEAD, LASERS, Place, rough};

#[test]
fn a_synthesized_scan_is_read_as_it_was_made() {
    let place = Place::empty();
    let line = "synthesize gaussian-rough --rms-nm 30 --correlation-length-nm 400 --seed 9 --size 72,40 \
                --pitch-nm 84.04,74.56 --out s.tif";
    let made = place.call(line).ended(0);
    assert!(made.stdout.starts_with("s.tif: 72 x 40 samples, pitch 84.04 x 74.56 nm"), "{}", made.stdout);
    let expected = synthesize(&rough(9), [72, 40], [84.04, 74.56]).unwrap();
    let read = read_scan(&place.path("s.tif"), &ReadConfig::default()).unwrap().field;
    assert_eq!(read.size(), [72, 40]);
    for (axis, pitch) in [84.04, 74.56].into_iter().enumerate() {
        assert!((read.pitch_nm[axis] / pitch - 1.0).abs() < 1e-6, "{:?}", read.pitch_nm);
    }
    let rounded = expected.heights_nm.mapv(|h| f64::from(h as f32));
    assert_eq!(read.heights_nm, rounded);

    // The same command gives the same bytes, another seed others.
    let bytes = |line: &str| {
        place.call(&format!("--quiet {line} --force")).ended(0);
        std::fs::read(place.path("s.tif")).unwrap()
    };
    let first = bytes(line);
    assert_eq!(bytes(line), first);
    assert_ne!(bytes(&line.replace("--seed 9", "--seed 10")), first);
}

#[test]
fn saved_heights_are_those_that_were_read() {
    let place = Place::empty();
    // 16-bit counts without any calibration: all of it comes from the command line.
    let (columns, rows) = (24, 16);
    let counts: Vec<u16> = (0..columns * rows).map(|i| (i * 40_503 % 65_536) as u16).collect();
    let file = std::fs::File::create(place.path("counts.tif")).unwrap();
    let mut encoder = TiffEncoder::new(file).unwrap();
    encoder.write_image::<Gray16>(columns, rows, &counts).unwrap();

    let refused = place.call("inspect counts.tif").ended(1);
    assert!(refused.stderr.contains("add `--pitch-nm N`"), "{}", refused.stderr);
    let refused = place.call("inspect counts.tif --pitch-nm 50 --save-heights h.tif").ended(1);
    assert!(refused.stderr.contains("add `--full-scale-nm N`"), "{}", refused.stderr);
    assert!(!place.path("h.tif").exists());

    let calibrated = "inspect counts.tif --pitch-nm 50,40 --full-scale-nm 375 --save-heights h.tif --json";
    let first = place.call(calibrated).ended(0).json();
    assert_eq!(first["provenance"]["pitch_from"], "option: --pitch-nm");
    assert_eq!(first["provenance"]["height_from"], "option: --full-scale-nm");
    let saved = read_scan(&place.path("h.tif"), &ReadConfig::default()).unwrap().field;
    assert_eq!(saved.size(), [24, 16]);
    for (height, &count) in saved.heights_nm.iter().zip(&counts) {
        let expected = 375.0 * f64::from(count) / 65535.0;
        // Stored as 32-bit floats.
        assert!((height - expected).abs() <= expected * 2f64.powi(-24), "{height} {expected}");
    }
    // Read again without being told anything, all is as it was, and saving once more changes no byte.
    let again = place.call("inspect h.tif --save-heights h2.tif --json").ended(0).json();
    for statistic in ["rms_height_nm", "rms_slope", "peak_to_valley_nm", "autocorrelation_length_nm"] {
        let [a, b] = [&first, &again].map(|json| json["statistics"][statistic].as_f64().unwrap());
        assert!((a - b).abs() <= 1e-5 * a.abs().max(1e-3), "{statistic}: {a} {b}");
    }
    let read = |name: &str| std::fs::read(place.path(name)).unwrap();
    assert_eq!(read("h.tif"), read("h2.tif"));
}

#[test]
fn every_scan_of_a_specimen_is_described() {
    let place = Place::empty();
    let rough = |rms_nm: f64| Structure::GaussianRough { rms_nm, correlation_length_nm: 400.0, seed: 3 };
    place.scan("a.tif", rough(20.0), [80, 64], [80.0, 90.0]);
    place.scan("b.tif", rough(300.0), [80, 64], [80.0, 90.0]);
    // Two thirds of a period: what repeats has a step.
    let wave = Structure::Sinusoid { period_nm: 9600.0, amplitude_nm: 120.0, direction_deg: 0.0 };
    place.scan("c.tif", wave, [80, 64], [80.0, 90.0]);
    let specimen = "[[specimen]]\nname = \"rough\"\nscans = [\"?.tif\"]\nlevel = \"none\"\n";
    place.publish(&[HEAD, LASERS, specimen].concat());
    let file = place.json("out/small/v0001/rough/specimen.json");
    let warnings: Vec<&str> = file["warnings"].as_array().unwrap().iter().map(|text| text.as_str().unwrap()).collect();
    let say = |name: &str, what: &str| warnings.iter().any(|text| text.starts_with(name) && text.contains(what));
    // The second is steep, the third alone does not fit itself.
    for (name, steep, seam) in [("a.tif: ", false, false), ("b.tif: ", true, false), ("c.tif: ", false, true)] {
        assert_eq!((say(name, "steeper"), say(name, "edges do not fit")), (steep, seam), "{name}: {warnings:?}");
    }
    assert!(say("The scans differ much in rms height (a.tif: ", "b.tif: "), "{warnings:?}");
    assert!(!say("The scans differ much in pitch", ""), "{warnings:?}");
    // Alone, blended, or faded there is no seam, and one scan differs from no other.
    let alone = specimen.replace("?.tif", "c.tif");
    for (number, (manifest, seam)) in
        [(alone.clone(), true), (alone + "blend_nm = 1000\n", false)].into_iter().enumerate()
    {
        place.publish(&[HEAD, LASERS, &manifest].concat());
        let file = place.json(&format!("out/small/v000{}/rough/specimen.json", number + 2));
        assert_eq!(file["warnings"].to_string().contains("do not fit"), seam, "{}", file["warnings"]);
        assert!(!file["warnings"].to_string().contains("differ much"));
    }
    assert!(place.call("inspect c.tif").ended(0).stdout.contains("edges do not fit"));
    assert!(!place.call("inspect a.tif").ended(0).stdout.contains("edges do not fit"));
}

#[test]
fn what_has_no_correlation_length_says_none() {
    let place = Place::empty();
    place.scan("flat.tif", Structure::Flat, [16, 16], [80.0; 2]);
    let shown = place.call("inspect flat.tif").ended(0).stdout;
    assert!(shown.contains("correlation   none\n"), "{shown}");
    assert!(!shown.contains("NaN"), "{shown}");
}

/// A folder of what a microscope wrote: a line for each file that says what to do about it.
#[test]
fn a_folder_is_told_file_by_file() {
    let place = Place::empty();
    std::fs::create_dir(place.path("scans")).unwrap();
    place.scan("scans/good.tif", rough(3), [80, 64], [80.0, 90.0]);
    place.scan("scans/lines.tif", Structure::CornSnake { seed: 3 }, [128, 128], [62.5; 2]);
    let mut offset = read_scan(&place.path("scans/lines.tif"), &ReadConfig::default()).unwrap().field;
    let mut random = fastrand::Rng::with_seed(1);
    offset.heights_nm.rows_mut().into_iter().for_each(|mut line| line += 60.0 * random.f64());
    diffraction_build::height::write::write_scan_tiff(&place.path("scans/lines.tif"), &offset).unwrap();
    std::fs::write(place.path("scans/map.topostats"), b"\x89HDF\r\n\x1a\nmore").unwrap();
    for name in ["scans/notes.MD", "scans/.hidden", "scans/log.csv"] {
        std::fs::write(place.path(name), "taken on Monday").unwrap();
    }
    let called = place.call("inspect scans").ended(1);
    assert!(called.stderr.contains("2 more, named as notes"), "{}", called.stderr);
    let row = |name: &str| called.stdout.lines().find(|line| line.contains(name)).unwrap().to_owned();
    assert_eq!(called.stdout.lines().count(), 4, "{}", called.stdout);
    assert!(row("good.tif").contains("  good for all directions"), "{}", called.stdout);
    assert!(row("lines.tif").contains("level = \"rows\""), "{}", called.stdout);
    assert!(row("map.topostats").contains("cannot be read"), "{}", called.stdout);
    assert!(called.stderr.contains("HDF5") && called.stderr.contains("tools/convert.py"), "{}", called.stderr);
    assert!(place.call("inspect .").ended(2).stderr.contains("no scan to look at"));
}

#[test]
fn integers_in_a_unit_of_length_are_asked_about() {
    let place = Place::empty();
    let counts: Vec<u16> = (0..32 * 32).map(|i| (i * 40_503 % 65_536) as u16).collect();
    let file = std::fs::File::create(place.path("counts.tif")).unwrap();
    TiffEncoder::new(file).unwrap().write_image::<Gray16>(32, 32, &counts).unwrap();
    let shown = place.call("inspect counts.tif --pitch-nm 50 --unit nm").ended(0).stdout;
    assert!(shown.contains("is the unit right?") && shown.contains("--full-scale-nm"), "{shown}");
    for meant in ["--unit pm", "--full-scale-nm 375"] {
        let shown = place.call(&format!("inspect counts.tif --pitch-nm 50 {meant}")).ended(0).stdout;
        assert!(!shown.contains("is the unit right?"), "{meant}: {shown}");
    }
}

/// `sigma_um = "auto"` is what `inspect` says that the scan resolves, and each command says so.
#[test]
fn a_coherence_that_follows_the_scan_says_what_it_took() {
    let place = Place::empty();
    place.scan("s.tif", rough(3), [80, 64], [80.0, 90.0]);
    let resolved = place.call("inspect s.tif --json").ended(0).json()["resolved_sigma_um"].as_f64().unwrap();
    // The shorter side is 64 x 90 nm.
    assert!((resolved - 1.44).abs() < 1e-6, "{resolved}");
    let specimen = "[[specimen]]\nname = \"s\"\nscans = \"s.tif\"\n";
    let manifest = |coherence: &str| format!("{HEAD}{LASERS}{specimen}coherence = {coherence}\n");
    for (coherence, sigma_um) in [
        ("{ sigma_um = \"auto\", edge = \"auto\" }", 1.44),
        ("{ sigma_um = \"auto\", edge = \"tile\" }", 5.76 / 4.3),
        ("{ sigma_um = \"auto\", edge = \"fade\" }", 0.72),
    ] {
        place.write("m.toml", &manifest(coherence));
        let plan = place.call("plan m.toml").ended(0);
        let said = format!("s: sigma = {sigma_um:.3} µm by sigma_um = \"auto\"");
        assert!(plan.stdout.contains(&said), "{coherence}: {}", plan.stdout);
        assert!(!plan.stdout.contains("too small for a coherence"), "{coherence}: {}", plan.stdout);
    }
    let run = place.publish(&manifest("{ sigma_um = \"auto\", edge = \"auto\" }"));
    let file = place.json("out/small/v0001/s/specimen.json");
    let sigma_nm = file["optics"]["sigma_nm"].as_f64().unwrap();
    assert!((sigma_nm / 1440.0 - 1.0).abs() < 1e-6, "{sigma_nm}");
    assert_eq!(file["optics"]["sigma_follows_scan"], true);
    assert!(file["optics"]["lobe_sigma_nm"].is_null(), "{}", file["optics"]);
    let text = std::fs::read_to_string(place.path("out/small/v0001/report.html")).unwrap();
    assert!(text.contains("σ = 1.44 µm (auto: what the scan tells)"), "{}", run.stdout);
    place.call("verify out/small").ended(0);
    // A larger scan is another specimen: its coherence grew with it.
    place.scan("s.tif", rough(3), [160, 128], [80.0, 90.0]);
    place.publish(&manifest("{ sigma_um = \"auto\", edge = \"auto\" }"));
    let sigma_nm = place.json("out/small/v0002/s/specimen.json")["optics"]["sigma_nm"].as_f64().unwrap();
    assert!((sigma_nm / 2880.0 - 1.0).abs() < 1e-6, "{sigma_nm}");
    place.write("m.toml", &manifest("{ sigma_um = \"aut\" }"));
    assert!(place.call("plan m.toml").ended(2).stderr.contains("or \"auto\" to follow the scan"));
}
