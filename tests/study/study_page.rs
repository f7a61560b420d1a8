//! The page of a study, and figures on real scans; the study itself has its own tests.

use crate::waves;
use diffraction_atlas::report::study_page::study_files;
use diffraction_atlas::stages::study::{FrameClock, drawn};
use diffraction_build::ground::progress::Silent;
use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
use diffraction_render::scene::model::{Light, Scene, Shape};
use diffraction_study::stability::{DepthRow, GrazingRow, Guard, SeriesRow, Stability, StabilityCase};
use diffraction_study::study::{GpuClock, PURPOSES, Study, StudyConfig, StudySpecimen, run_study};

fn specimen(height_nm: f64) -> StudySpecimen {
    waves::specimen(height_nm, vec![Box::new(drawn(&ball(), 1_000).unwrap())])
}

fn ball() -> Scene {
    Scene::still("ball", Shape::Sphere, vec![Light::point([0.3, 0.2, 1.0])], 24)
}

/// One case and one row of each kind: the suite itself has its own tests.
fn stability() -> Stability {
    let guard = Guard { what: "a <guard>".into(), without: f64::INFINITY };
    Stability {
        cases: vec![StabilityCase {
            name: "a <case>".into(),
            note: "what".into(),
            measured: 1e-3,
            bound: 1e-2,
            guard,
            half: Some(0.5),
        }],
        depths: vec![DepthRow {
            depth_nm: 321.0,
            tables: 11,
            transforms: 22,
            error: 1.23e-3,
            four_tables: 4.56,
            half: 0.789,
        }],
        series: vec![SeriesRow {
            depth_nm: 654.0,
            terms: 33,
            digits_lost: 4.32,
            errors: [0.654, 1.0e-4, 1.0e-9],
            predicted: [0.543, 2.0e-4, 2.0e-9],
        }],
        grazing: vec![GrazingRow { normalised_w: 3e-3, divided: 2.34e-3, whole: 34.5 }],
    }
}

#[test]
fn the_page_holds_every_row_and_needs_nothing_else() {
    let config = StudyConfig {
        chebyshev: vec![2, 3],
        taylor: vec![6],
        harmonics: vec![2],
        light_fields: vec![[8, 32]],
        paths: vec![64],
        wavelength_steps_nm: vec![],
        sizes: vec![21, 41],
        size: 41,
        equal_size: 101,
        tolerances: vec![3e-2],
        size_max: 101,
        directions: 6,
        ..waves::config()
    };
    let mut named = specimen(100.0);
    named.name = "<b>bold</b> & co".into();
    let study = run_study(&[named], &config, Err("not asked for"), &Silent);
    let files = study_files(&study, &stability()).unwrap();
    let text = |name: &str| String::from_utf8(files.iter().find(|f| f.0 == name).unwrap().1.clone()).unwrap();
    let html = text("report.html");
    assert!(html.contains("&lt;b&gt;bold") && !html.contains("<b>bold"), "names are escaped");
    assert!(!html.contains("http://") || html.matches("http://").count() == html.matches("http://www.w3.org/").count());
    for row in &study.specimens[0].methods {
        assert!(html.contains(&format!("<td>{}</td><td>{}</td>", row.method, row.setting)), "{}", row.method);
    }
    for (family, purpose) in PURPOSES {
        assert!(study.specimens[0].methods.iter().any(|row| row.method.starts_with(family)), "{family}");
        assert!(html.contains(&purpose[..20]), "{family}");
    }
    let equal = &study.specimens[0].equal;
    let mut filed = 0;
    for row in equal {
        for contender in [&row.chebyshev, &row.taylor].into_iter().flatten() {
            let Some(files) = contender.files else { continue };
            filed += 1;
            assert!(files.error <= row.target && files.tables >= contender.tables, "{row:?}");
            // Bits that the error leaves out are not in the files, nor is what lies beyond the disc.
            let all = contender.bytes * files.tables as u64 / contender.tables as u64;
            assert!(files.bytes < all * 3 / 4, "{row:?}");
        }
    }
    assert!(filed > 0, "no method met a target");
    let again: Study = serde_json::from_str(&text("study.json")).unwrap();
    assert_eq!(again.specimens[0].methods.len(), study.specimens[0].methods.len());
    let svg: Vec<_> = files.iter().filter(|f| f.0.ends_with(".svg")).collect();
    let named = |part: &str| svg.iter().any(|(name, _)| name.ends_with(&format!("{part}.svg")));
    for part in ["cost", "cost-on-texels", "tables", "tolerance", "basis", "grid", "storage", "stability.series"] {
        assert!(named(part), "{part} in {:?}", svg.iter().map(|f| &f.0).collect::<Vec<_>>());
    }
    for (name, bytes) in svg {
        let text = std::str::from_utf8(bytes).unwrap();
        assert!(roxmltree::Document::parse(text).is_ok() && !text.contains("NaN"), "{name}");
        assert!(text.contains("<path fill=\"#") || name.starts_with("stability"), "{name} shows points");
    }
    for cells in [
        "<td>a &lt;case&gt;</td><td>what</td><td>1.0e-3</td><td>0.0100</td>\n<td>kept</td><td>∞</td>\n<td>a &lt;guard&gt;</td><td>0.500</td>",
        "<td>321</td><td>11</td><td>22</td><td>1.2e-3</td><td>4.56</td><td>0.789</td>",
        "<td>654</td><td>33</td><td>4.32</td>\n<td>0.654 (0.543)</td><td>1.0e-4 (2.0e-4)</td><td>1.0e-9 (2.0e-9)</td>",
        "<td>3.0e-3</td><td>2.3e-3</td><td>34.5</td>",
    ] {
        assert!(html.contains(cells), "the suite is on the page: {cells}");
    }
    for part in ["specimen-1", "stability", "depth", "series", "grazing", "cases"] {
        assert!(html.contains(&format!("href=\"#{part}\"")) && html.contains(&format!("id=\"{part}\"")), "{part}");
    }
    assert!(html.contains("<img src=\"data:image"), "pictures are in the page");
}

/// `cargo test --release measuring_snake -- --ignored --nocapture`: bytes and time at equal error on tables as large as an
/// atlas of the snake scans holds.
#[test]
#[ignore = "minutes of measuring, and figures that a busy machine spoils"]
fn measuring_snake_scans_at_equal_error() {
    let Some(shared) = crate::skip::shared("") else { return };
    let pitch_nm = [65_000.0 / 1332.0; 2];
    let config = StudyConfig {
        directions: 8,
        timed_directions: 400_000,
        size: 101,
        chebyshev: vec![3, 4, 5, 6, 8],
        taylor: vec![24],
        harmonics: vec![],
        light_fields: vec![],
        paths: vec![],
        wavelength_steps_nm: vec![],
        sizes: vec![],
        equal_size: 1001,
        tolerances: vec![],
        gpu: true,
        memory_mib: 4096,
        ..waves::config()
    };
    let gpu = FrameClock::open().unwrap();
    let gpu = gpu.as_ref().map(|clock| clock as &dyn GpuClock).ok_or("no adapter");
    for (name, scale) in [("elaphe_guttata", 375.0 / 65535.0), ("xenopeltis_unicolor", 1.0)] {
        let mut field = crate::common::load(&shared.join(format!("specimens/{name}.tif")), pitch_nm, scale);
        let (low, high) = field.heights_nm.iter().fold((f64::MAX, f64::MIN), |(l, h), &x| (l.min(x), h.max(x)));
        field.heights_nm -= 0.5 * (low + high);
        let optics = crate::common::reference_optics(16_250.0, Edge::Tile);
        let optics = OpticsConfig { windows: Windows::Grid, ..optics };
        let specimen = StudySpecimen { name: name.into(), fields: vec![field], optics, scenes: vec![], lights: vec![] };
        let study = run_study(&[specimen], &config, gpu, &Silent);
        assert!(study.failures.is_empty(), "{:?}", study.failures);
        for row in &study.specimens[0].equal {
            println!("{name} {:?} {:.1e} best {}: {:?}", row.measure, row.target, row.taylors_best, row.ratios());
            println!("    files {:?}\n    {:?}\n    {:?}", row.files_ratio(), row.chebyshev, row.taylor);
        }
        // Half against float storage is a factor of two, and the series takes at least twice the tables.
        let ratios = study.specimens[0].equal.iter().filter_map(|row| row.ratios());
        assert!(ratios.clone().count() >= 6);
        for [bytes, ..] in ratios {
            assert!(bytes.unwrap() > 4.0, "{bytes:?}");
        }
    }
}
