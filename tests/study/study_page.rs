//! The study measures what is known: the order of the methods, and the limits of the published one.

use diffraction_atlas::report::study_page::study_files;
use diffraction_atlas::stages::progress::Silent;
use diffraction_atlas::stages::stability::{DepthRow, GrazingRow, Guard, SeriesRow, Stability, StabilityCase};
use diffraction_atlas::stages::study::{
    Contender, Measure, MethodRow, SpecimenStudy, Study, StudyConfig, StudySpecimen, run_study,
};
use diffraction_build::ground::spectrum::Illuminant;
use diffraction_build::height::HeightField;
use diffraction_build::height::synthesize::{bundled, synthesize};
use diffraction_build::optics::config::{Edge, Material, OpticsConfig, Windows};
use diffraction_render::scene::model::{Light, Scene, Shape};
use ndarray::Array2;

fn specimen(depth_nm: f64) -> StudySpecimen {
    let heights_nm = Array2::from_shape_fn((128, 128), |(row, column)| {
        let (x, y) = (column as f64 / 128.0, row as f64 / 128.0);
        // Waves of many directions: dark gaps between orders would leave nothing to compare.
        (0..24)
            .map(|i| {
                let (a, b) = (2.0 * f64::from(i % 7) + 1.0, 2.0 * f64::from(i % 11) - 10.0);
                (std::f64::consts::TAU * (a * x + b * y) + f64::from(i * i)).sin()
            })
            .sum::<f64>()
            * depth_nm
            / 28.0
    });
    StudySpecimen {
        name: format!("waves {depth_nm} nm"),
        fields: vec![HeightField { heights_nm, pitch_nm: [90.0, 90.0] }],
        optics: OpticsConfig {
            illuminant: Illuminant::D65,
            wavelength_nm: [380.0, 780.0],
            sigma_nm: 900.0,
            edge: Edge::Tile,
            windows: Windows::Grid,
            material: Material::Ideal,
            shadowing: false,
        },
        scenes: vec![ball()],
    }
}

fn ball() -> Scene {
    Scene::still("ball", Shape::Sphere, vec![Light::point([0.3, 0.2, 1.0])], 24)
}

fn config() -> StudyConfig {
    StudyConfig {
        directions: 40,
        timed_directions: 2_000,
        size: 141,
        chebyshev: vec![2, 6],
        taylor: vec![6, 24],
        harmonics: vec![4],
        wavelength_steps_nm: vec![40.0, 5.0],
        sizes: vec![41, 141],
        equal_size: 101,
        tolerances: vec![1e-2],
        size_max: 201,
        picture_samples: 1_000,
        gpu: false,
        memory_mib: 512,
    }
}

fn median(study: &SpecimenStudy, method: &str, setting: &str) -> f64 {
    let row = |row: &&MethodRow| row.method == method && row.setting == setting;
    study.methods.iter().find(row).unwrap().errors[0].quantiles.p50
}

#[test]
fn methods_rank_as_theory_says() {
    let study = run_study(&[specimen(200.0)], &config(), &Silent);
    assert!(study.failures.is_empty(), "{:?}", study.failures);
    let shallow = &study.specimens[0];
    for row in &shallow.methods {
        println!("{} {}: {:?} power {:?}", row.method, row.setting, row.errors[0].quantiles, row.power_sum);
    }
    for row in &shallow.knobs {
        println!("{} {}: {:?}", row.knob, row.setting, row.quantiles);
    }
    // The transforms are good to 1e-7 of the whole amplitude; orders here carry 1e-3 of it and more.
    assert!(median(shallow, "FFT", "no tables") < 1e-3);
    // More tables help until the grid's own error, measured by its knob, is all that is left.
    let knob = |name: &str, setting: &str| {
        shallow.knobs.iter().find(|k| k.knob == name && k.setting == setting).unwrap().quantiles
    };
    let grid = knob("grid, cubic", "141 texels").p95;
    let tail = |method: &str, setting: &str| {
        shallow.methods.iter().find(|r| r.method == method && r.setting == setting).unwrap().errors[0].quantiles.p95
    };
    for (method, few, many) in [("chebyshev, float", 2, 6), ("taylor, float", 6, 24)] {
        let [few, many] = [few, many].map(|n| tail(method, &format!("{n} tables")));
        assert!(many < 0.2 * few && many < 5.0 * grid, "{method}: {few:e} {many:e}, grid {grid:e}");
    }
    assert!(knob("basis", "6 tables").p95 < 1e-3 * knob("basis", "2 tables").p95);
    assert!(knob("wavelength step", "5 nm").p95 < 0.1 * knob("wavelength step", "40 nm").p95);
    assert!(knob("grid, bilinear", "141 texels").p50 > knob("grid, cubic", "141 texels").p50);
    // Closed forms know no scan: of the order of the value itself.
    for (method, setting) in [("Stam, random", "rms, length"), ("Stam, regular", "2 waves")] {
        assert!(median(shallow, method, setting) > 0.1, "{method}");
    }
    // Halves carry 11 bits: 5e-4 at worst per table, no knob hides a larger loss.
    assert!(knob("storage, half", "half").p95 < 5e-3 && knob("storage, half", "half").p95 > 0.0);
    // Six bits less are 64 times the rounding.
    let [coarse, fine] = ["5 bits", "11 bits"].map(|bits| knob("storage", bits).p50);
    assert!((16.0..256.0).contains(&(coarse / fine)), "{coarse:e} {fine:e}");
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
        grazing: vec![GrazingRow { t: 3e-3, divided: 2.34e-3, whole: 34.5 }],
    }
}

#[test]
fn the_page_holds_every_row_and_needs_nothing_else() {
    let config = StudyConfig {
        chebyshev: vec![2, 3],
        taylor: vec![6],
        harmonics: vec![2],
        wavelength_steps_nm: vec![],
        sizes: vec![21, 41],
        size: 41,
        directions: 6,
        ..config()
    };
    let mut named = specimen(100.0);
    named.name = "<b>bold</b> & co".into();
    let study = run_study(&[named], &config, &Silent);
    let files = study_files(&study, &stability()).unwrap();
    let text = |name: &str| String::from_utf8(files.iter().find(|f| f.0 == name).unwrap().1.clone()).unwrap();
    let html = text("report.html");
    assert!(html.contains("&lt;b&gt;bold") && !html.contains("<b>bold"), "names are escaped");
    assert!(!html.contains("http://") || html.matches("http://").count() == html.matches("http://www.w3.org/").count());
    for row in &study.specimens[0].methods {
        assert!(html.contains(&format!("<td>{}</td><td>{}</td>", row.method, row.setting)), "{}", row.method);
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
    assert!(filed >= 8, "{filed}");
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
        assert!(text.contains("<polygon") || name.starts_with("stability"), "{name} shows points");
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

/// `cargo test --release --test study deeper -- --ignored --nocapture`: how the gap at equal error widens with depth, on the
/// bundled corn snake's structure at several times its height.
#[test]
#[ignore = "minutes of measuring, and figures that a busy machine spoils"]
fn deeper_structures_at_equal_error() {
    let (_, structure, size, pitch_nm) = bundled().into_iter().find(|(name, ..)| *name == "corn_snake_like").unwrap();
    let snake = synthesize(&structure, size, pitch_nm).unwrap();
    let config = StudyConfig {
        directions: 8,
        timed_directions: 400_000,
        size: 101,
        chebyshev: (3..=12).collect(),
        taylor: vec![48],
        harmonics: vec![],
        wavelength_steps_nm: vec![],
        sizes: vec![],
        equal_size: 601,
        tolerances: vec![],
        memory_mib: 8192,
        ..config()
    };
    let mut smaller = Vec::new();
    for times in [1.0, 1.5, 2.0, 2.5, 3.0] {
        let optics = OpticsConfig { windows: Windows::Grid, ..crate::common::reference_optics(4_000.0, Edge::Tile) };
        let field = HeightField { heights_nm: &snake.heights_nm * times, pitch_nm };
        let specimen = StudySpecimen { name: "deeper".into(), fields: vec![field], optics, scenes: vec![] };
        let study = run_study(&[specimen], &config, &Silent);
        assert!(study.failures.is_empty(), "{:?}", study.failures);
        for row in &study.specimens[0].equal {
            let tables = |one: &Option<Contender>| one.as_ref().map(|one| (one.tables, one.error));
            println!("x{times} {:?} {:.1e} best {}: {:?}", row.measure, row.target, row.taylors_best, row.ratios());
            println!("    {:?} {:?}", tables(&row.chebyshev), tables(&row.taylor));
        }
        let hemisphere = study.specimens[0].equal.iter().find(|row| row.measure == Measure::P95 && row.target == 3e-2);
        smaller.extend(hemisphere.and_then(|row| row.ratios()).and_then(|[bytes, ..]| bytes));
    }
    assert!(smaller.len() >= 2 && smaller.is_sorted(), "{smaller:?}");
}

/// `cargo test --release --test study -- --ignored --nocapture`: bytes and time at equal error on tables as large as an
/// atlas of the snake scans holds.
#[test]
#[ignore = "minutes of measuring, and figures that a busy machine spoils"]
fn snake_scans_at_equal_error() {
    let Some(shared) = crate::skip::shared("") else { return };
    let pitch_nm = [65_000.0 / 1332.0; 2];
    let config = StudyConfig {
        directions: 8,
        timed_directions: 400_000,
        size: 101,
        chebyshev: vec![3, 4, 5, 6, 8],
        taylor: vec![24],
        harmonics: vec![],
        wavelength_steps_nm: vec![],
        sizes: vec![],
        equal_size: 1001,
        tolerances: vec![],
        gpu: true,
        memory_mib: 4096,
        ..config()
    };
    for (name, scale) in [("elaphe_guttata", 375.0 / 65535.0), ("xenopeltis_unicolor", 1.0)] {
        let mut field = crate::common::load(&shared.join(format!("specimens/{name}.tif")), pitch_nm, scale);
        let (low, high) = field.heights_nm.iter().fold((f64::MAX, f64::MIN), |(l, h), &x| (l.min(x), h.max(x)));
        field.heights_nm -= 0.5 * (low + high);
        let optics = crate::common::reference_optics(16_250.0, Edge::Tile);
        let optics = OpticsConfig { windows: Windows::Grid, ..optics };
        let specimen = StudySpecimen { name: name.into(), fields: vec![field], optics, scenes: vec![] };
        let study = run_study(&[specimen], &config, &Silent);
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

#[test]
fn a_deep_surface_lists_the_published_method_as_refused() {
    let config = StudyConfig {
        chebyshev: vec![],
        taylor: vec![24],
        harmonics: vec![],
        wavelength_steps_nm: vec![],
        sizes: vec![],
        size: 41,
        directions: 4,
        ..config()
    };
    let study = run_study(&[specimen(1_500.0)], &config, &Silent);
    let deep = &study.specimens[0];
    assert!(
        deep.refusals.len() == 2 && deep.refusals.iter().all(|refusal| refusal.what.starts_with("taylor")),
        "{:?}",
        deep.refusals
    );
    assert!(deep.taylor_digits_lost > 8.0);
}
