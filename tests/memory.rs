//! What a plan says that building will hold in memory, against what lived on the heap.

mod common;

use std::sync::Mutex;

use common::surfaces::{laser, random, tables_config};
use diffraction_atlas::stages::built::Built;
use diffraction_atlas::stages::coverage::savings::cover;
use diffraction_atlas::stages::usage::{HeapCounter, lend_heap_counter, with_heap_bytes};
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, Material, OpticsConfig, Windows};
use diffraction_build::tables::forecast::{Forecast, forecast_of};
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Prefilter, TablesConfig};
use diffraction_build::tables::plan::{BuildPlan, plan_for};
use diffraction_render::scene::model::{Light, Scene, Shape};
use peak_alloc::PeakAlloc;

#[global_allocator]
static HEAP: PeakAlloc = PeakAlloc;

/// What lives on the heap is everybody's: one measurement at a time.
static ALONE: Mutex<()> = Mutex::new(());

struct Case {
    name: &'static str,
    field: HeightField,
    optics: OpticsConfig,
    tables: TablesConfig,
    scene: Option<Scene>,
}

impl Case {
    fn input(&self) -> BuildInput<'_> {
        BuildInput::new(std::slice::from_ref(&self.field), &self.optics, &self.tables)
    }

    fn planned(&self) -> (BuildPlan, Forecast) {
        let input = self.input();
        let coverage = self.scene.as_ref().map(|scene| cover(&input, &[scene]).unwrap());
        let plan = plan_for(&input, coverage).unwrap();
        let forecast = forecast_of(&input, &plan, rayon::current_num_threads());
        (plan, forecast)
    }

    fn measured(&self) -> Built {
        Built::measured(&self.input(), &self.planned().0, &|_| ()).unwrap()
    }
}

fn daylight(sigma_nm: f64, edge: Edge, windows: Windows) -> OpticsConfig {
    let illuminant = Illuminant::D65;
    let material = Material::Ideal;
    OpticsConfig { material, ..OpticsConfig::ideal(illuminant, sigma_nm, edge, windows) }
}

/// A surface of so many samples, 60 nm apart, and so deep.
fn surface(samples: usize, rms_nm: f64) -> HeightField {
    random([samples; 2], [60.0; 2], 500.0, rms_nm, 5)
}

fn cases() -> Vec<Case> {
    let point = |size| tables_config(1e-3, Some(size));
    let averaged = |size| TablesConfig { prefilter: Prefilter::Auto, ..point(size) };
    let scene = |shape, size_px| Some(Scene::still("scene", shape, vec![Light::point([0.3, 0.2, 1.0])], size_px));
    let tile = daylight(2000.0, Edge::Tile, Windows::Grid);
    let case =
        |name, field, optics: &OpticsConfig, tables, scene| Case { name, field, optics: optics.clone(), tables, scene };
    vec![
        case("tile, larger tables", surface(256, 50.0), &tile, point(401), None),
        case("tile, larger scan", surface(768, 50.0), &tile, point(101), None),
        case("tile, deep", surface(192, 400.0), &tile, point(101), None),
        case("tile, one window", surface(256, 50.0), &daylight(2000.0, Edge::Tile, Windows::Centre), point(301), None),
        case(
            "tile, texel means",
            surface(512, 30.0),
            &daylight(6000.0, Edge::Tile, Windows::Centre),
            averaged(201),
            None,
        ),
        case(
            "fade, several windows",
            surface(260, 50.0),
            &daylight(1200.0, Edge::Fade, Windows::Grid),
            point(151),
            None,
        ),
        case("fade, one window", surface(512, 50.0), &daylight(3000.0, Edge::Fade, Windows::Centre), point(151), None),
        case("laser", surface(384, 50.0), &laser(&[633.0], 2000.0, Edge::Tile, Windows::Grid), point(601), None),
        case("restricted, ball", surface(256, 50.0), &tile, point(401), scene(Shape::Sphere, 64)),
        case("restricted, snake", surface(256, 50.0), &tile, point(401), scene(Shape::Snake, 48)),
        case(
            "restricted, laser",
            surface(256, 50.0),
            &laser(&[633.0], 2000.0, Edge::Tile, Windows::Grid),
            point(401),
            scene(Shape::Sphere, 64),
        ),
    ]
}

fn lend() {
    lend_heap_counter(HeapCounter {
        live_bytes: || HEAP.current_usage(),
        peak_bytes: || HEAP.peak_usage(),
        restart: || HEAP.reset_peak_usage(),
    });
}

fn is_within_two(predicted: f64, measured: f64) -> bool {
    (0.5..=2.0).contains(&(predicted / measured))
}

#[test]
fn memory_is_predicted_within_a_factor_of_two() {
    let _alone = ALONE.lock().unwrap_or_else(|e| e.into_inner());
    lend();
    let mut off = Vec::new();
    for case in cases() {
        let (_, forecast) = case.planned();
        let built = case.measured();
        let (predicted, measured) = (forecast.memory_bytes as f64, built.memory_bytes.unwrap() as f64);
        println!(
            "{:24} {:3} windows, {:2} transforms, {:2} ({:2}) tables: {:7.2} MB, {:7.2} predicted, {:.2}; {:.2} s, {:.2}",
            case.name,
            built.record.windows,
            built.record.transforms,
            built.set.tables.len(),
            forecast.tables,
            1e-6 * measured,
            1e-6 * predicted,
            predicted / measured,
            built.seconds,
            forecast.seconds,
        );
        if !is_within_two(predicted, measured) {
            off.push(case.name);
        }
    }
    assert!(off.is_empty(), "{off:?}");
}

/// Where the number of tables is given, nothing is estimated: array by array the prediction is what is allocated, but for
/// quadratures, taps and one sixteenth of the scratch in the mean.
#[test]
fn a_given_number_of_tables_leaves_a_tenth() {
    let _alone = ALONE.lock().unwrap_or_else(|e| e.into_inner());
    lend();
    for case in cases_of_seven_tables() {
        let measured = case.measured().memory_bytes.unwrap() as f64;
        let ratio = case.planned().1.memory_bytes as f64 / measured;
        println!("{:24} {:7.2} MB, {ratio:.3}", case.name, 1e-6 * measured);
        assert!((0.9..1.1).contains(&ratio), "{}: {ratio}", case.name);
    }
}

#[test]
fn a_wrong_prediction_is_off() {
    let _alone = ALONE.lock().unwrap_or_else(|e| e.into_inner());
    lend();
    let [tables, scan, ..] = &mut cases_of_seven_tables()[..] else { panic!("two cases at least") };
    let measured = [&*tables, &*scan].map(|case| case.measured().memory_bytes.unwrap() as f64);
    // Tables three halves as wide, a scan as wide: each rules the memory of its case.
    tables.tables.size = Some(601);
    scan.field = surface(1152, 50.0);
    for (case, measured) in [&*tables, &*scan].into_iter().zip(measured) {
        let predicted = case.planned().1.memory_bytes as f64;
        assert!(!is_within_two(predicted, measured), "{}: {predicted:e}, {measured:e}", case.name);
    }
}

fn cases_of_seven_tables() -> Vec<Case> {
    let mut cases: Vec<Case> = cases().into_iter().filter(|case| case.scene.is_none()).collect();
    cases.iter_mut().for_each(|case| case.tables.count = Some(7));
    cases
}

#[test]
fn what_lived_meanwhile_is_counted_and_nothing_else() {
    let _alone = ALONE.lock().unwrap_or_else(|e| e.into_inner());
    lend();
    let before = vec![1u8; 8 << 20];
    let (kept, bytes) = with_heap_bytes(|| {
        drop(std::hint::black_box(vec![2u8; 32 << 20]));
        vec![3u8; 1 << 20]
    });
    let bytes = bytes.unwrap();
    // The harness may print meanwhile.
    assert!((32 << 20..(32 << 20) + (1 << 16)).contains(&bytes), "{bytes}");
    assert_eq!(before.len() + kept.len(), 9 << 20);
}
