//! The study measures what is known: the order of the methods, and the limits of the published one.

mod waves;

use diffraction_brdf::direction::{Vec3, Xyz, from_angles_deg};
use diffraction_build::ground::colour::auto_exposure;
use diffraction_build::ground::progress::Silent;
use diffraction_build::height::HeightField;
use diffraction_build::height::synthesize::{bundled, synthesize};
use diffraction_build::optics::config::{Factor, Material, OpticsConfig};
use diffraction_study::study::{
    Contender, Measure, MethodRow, SceneSamples, SpecimenStudy, StudyConfig, StudySpecimen, run_study,
};
use ndarray::Array3;

/// Why no GPU is lent.
const NO_GPU: Result<&dyn diffraction_study::study::GpuClock, &str> = Err("not asked for");

/// A picture of every viewing direction: the light 20° off the normal, one direction per pixel.
#[derive(Debug)]
struct Dome(Vec<(Vec3, Vec3)>);

/// Pixels along each side of the dome.
const DOME_PX: usize = 24;

impl Dome {
    fn new() -> Self {
        let wi = from_angles_deg(20.0, 30.0);
        let pixel = |index: usize| {
            let [x, y] = [index % DOME_PX, index / DOME_PX].map(|i| (i as f64 + 0.5) / DOME_PX as f64 * 1.2 - 0.6);
            (wi, [x, y, (1.0 - x * x - y * y).sqrt()])
        };
        Self((0..DOME_PX * DOME_PX).map(pixel).collect())
    }
}

impl SceneSamples for Dome {
    fn name(&self) -> &str {
        "dome"
    }

    fn pairs(&self) -> &[(Vec3, Vec3)] {
        &self.0
    }

    fn image(&self, brdf: &[Xyz]) -> Array3<f32> {
        Array3::from_shape_fn((DOME_PX, DOME_PX, 3), |(row, column, k)| brdf[row * DOME_PX + column][k] as f32)
    }

    fn exposure(&self, reference: &Array3<f32>) -> f32 {
        auto_exposure(reference)
    }
}

fn specimen(height_nm: f64) -> StudySpecimen {
    waves::specimen(height_nm, vec![Box::new(Dome::new())])
}

fn median(study: &SpecimenStudy, method: &str, setting: &str) -> f64 {
    let row = |row: &&MethodRow| row.method == method && row.setting == setting;
    study.methods.iter().find(row).unwrap().errors[0].quantiles.p50
}

#[test]
fn methods_rank_as_theory_says() {
    let study = run_study(&[specimen(200.0)], &waves::config(), NO_GPU, &Silent);
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
    // Optical paths need no preparation and meet the scan slowly; the Wigner distribution of one line does not meet it.
    let [few, many] = ["64 paths", "4096 paths"].map(|setting| median(shallow, "optical paths", setting));
    assert!(many < 0.3 * few && many > median(shallow, "FFT", "no tables"), "{few:e} {many:e}");
    assert!(median(shallow, "WBSDF", "plane of incidence") > 0.1);
    // Halves carry 11 bits: 5e-4 at worst per table, no knob hides a larger loss.
    assert!(knob("storage, half", "half").p95 < 5e-3 && knob("storage, half", "half").p95 > 0.0);
    // Six bits less are 64 times the rounding.
    let [coarse, fine] = ["5 bits", "11 bits"].map(|bits| knob("storage", bits).p50);
    assert!((16.0..256.0).contains(&(coarse / fine)), "{coarse:e} {fine:e}");
}

/// Its tables are read with `R G` alone, so that under another factor they would seem to be off by what the factors differ in.
#[test]
fn another_factor_than_that_of_the_published_series_is_refused() {
    let mut vector = specimen(200.0);
    vector.optics.material = Material::Dielectric { n: 1.56 };
    vector.optics.factor = Factor::Vector;
    let study = run_study(&[vector], &waves::config(), NO_GPU, &Silent);
    let [refusal] = &study.failures[..] else { panic!("{:?}", study.failures) };
    assert!(refusal.message.contains("scalar front factor") && study.specimens.is_empty(), "{}", refusal.message);
}

/// `cargo test --release -p diffraction-study measuring_deeper -- --ignored --nocapture`: how the gap at equal error widens with depth, on the
/// bundled corn snake's structure at several times its height.
#[test]
#[ignore = "minutes of measuring, and figures that a busy machine spoils"]
fn measuring_deeper_structures_at_equal_error() {
    let (_, structure, size, pitch_nm) = bundled().into_iter().find(|(name, ..)| *name == "corn_snake_like").unwrap();
    let snake = synthesize(&structure, size, pitch_nm).unwrap();
    let config = StudyConfig {
        directions: 8,
        timed_directions: 400_000,
        size: 101,
        chebyshev: (3..=12).collect(),
        taylor: vec![48],
        harmonics: vec![],
        light_fields: vec![],
        paths: vec![],
        wavelength_steps_nm: vec![],
        sizes: vec![],
        equal_size: 601,
        tolerances: vec![],
        memory_mib: 8192,
        ..waves::config()
    };
    let mut smaller = Vec::new();
    for times in [1.0, 1.5, 2.0, 2.5, 3.0] {
        let optics = OpticsConfig { sigma_nm: 4_000.0, ..specimen(1.0).optics };
        let field = HeightField { heights_nm: &snake.heights_nm * times, pitch_nm };
        let specimen =
            StudySpecimen { name: "deeper".into(), fields: vec![field], optics, scenes: vec![], lights: vec![] };
        let study = run_study(&[specimen], &config, NO_GPU, &Silent);
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

#[test]
fn a_deep_surface_lists_the_published_method_as_refused() {
    let config = StudyConfig {
        chebyshev: vec![],
        taylor: vec![24],
        harmonics: vec![],
        light_fields: vec![],
        paths: vec![],
        wavelength_steps_nm: vec![],
        sizes: vec![],
        size: 41,
        equal_size: 41,
        tolerances: vec![],
        directions: 4,
        ..waves::config()
    };
    let study = run_study(&[StudySpecimen { scenes: vec![], ..specimen(1_500.0) }], &config, NO_GPU, &Silent);
    let deep = &study.specimens[0];
    assert!(
        deep.refusals.len() == 2 && deep.refusals.iter().all(|refusal| refusal.what.starts_with("taylor")),
        "{:?}",
        deep.refusals
    );
    assert!(deep.taylor_digits_lost > 8.0);
}
