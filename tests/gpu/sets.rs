//! Small table sets of every kind, and the adapter.

use std::sync::OnceLock;

use crate::skip::skipped;
use diffraction_atlas::stages::coverage::savings::cover;
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, Material, OpticsConfig, Windows};
use diffraction_build::tables::build::{build, build_planned};
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Basis, Prefilter, Storage, TableSet, TablesConfig};
use diffraction_build::tables::plan::plan_for;
use diffraction_render::render::gpu::Gpu;
use diffraction_render::scene::model::{Light, Scene, Shape};
use ndarray::Array2;

/// The adapter, or `None` with a loud line.
pub fn gpu(test: &str) -> Option<&'static Gpu> {
    static GPU: OnceLock<Option<Gpu>> = OnceLock::new();
    let gpu = GPU.get_or_init(|| Gpu::open().expect("an adapter that is there must open")).as_ref();
    if gpu.is_none() {
        skipped(format_args!("{test}: no Vulkan adapter"));
    }
    gpu
}

/// A sinusoid with a few bumps: 64 x 64 samples of 100 nm.
fn surface() -> HeightField {
    let heights_nm = Array2::from_shape_fn((64, 64), |(row, column)| {
        let (x, y) = (column as f64 / 64.0, row as f64 / 64.0);
        let bump = |cx: f64, cy: f64| 90.0 * (-((x - cx).powi(2) + (y - cy).powi(2)) / 0.004).exp();
        60.0 * (std::f64::consts::TAU * 5.0 * x).sin() + bump(0.3, 0.6) + bump(0.62, 0.4)
    });
    let middle = heights_nm.iter().fold((f64::MAX, f64::MIN), |(l, h), &x| (l.min(x), h.max(x)));
    HeightField { heights_nm: heights_nm - 0.5 * (middle.0 + middle.1), pitch_nm: [100.0, 100.0] }
}

/// The optics of the sets.
pub fn optics(windows: Windows, material: Material, shadowing: bool) -> OpticsConfig {
    OpticsConfig { material, shadowing, ..OpticsConfig::ideal(Illuminant::D65, 1_500.0, Edge::Tile, windows) }
}

/// What the full set reflects as.
const FULL_MATERIAL: Material = Material::Conductor { n: 0.9, k: 6.2 };

/// A set over that surface: `Windows::Centre` has a cross term, `Windows::Grid` none.
pub fn build_set(basis: Basis, windows: Windows, material: Material, shadowing: bool) -> TableSet {
    let optics = optics(windows, material, shadowing);
    let config = TablesConfig {
        basis,
        tolerance: 1e-2,
        size: Some(65),
        // Few enough that the last Chebyshev table still shows above rounding; enough powers to converge.
        count: Some(if basis == Basis::Taylor { 16 } else { 5 }),
        wavelength_step_nm: Some(20.0),
        storage: Some(Storage::Float),
        prefilter: Prefilter::None,
        memory_mib: 256,
    };
    build(&BuildInput::new(&[surface()], &optics, &config), &|_| ()).expect("the set builds").0
}

/// A set with everything: cross term, conductor, shadowing.
pub fn full_set() -> &'static TableSet {
    static SET: OnceLock<TableSet> = OnceLock::new();
    SET.get_or_init(|| build_set(Basis::Chebyshev, Windows::Centre, FULL_MATERIAL, true))
}

/// The same surface's tables for one scene alone, lobe and cross term included.
pub fn restricted_set(scene: &Scene) -> TableSet {
    let optics = optics(Windows::Centre, FULL_MATERIAL, true);
    let config = TablesConfig {
        basis: Basis::Chebyshev,
        tolerance: 1e-2,
        size: Some(65),
        count: Some(3),
        wavelength_step_nm: Some(20.0),
        storage: Some(Storage::Float),
        prefilter: Prefilter::None,
        memory_mib: 256,
    };
    let fields = [surface()];
    let input = BuildInput::new(&fields, &optics, &config);
    let covered = cover(&input, &[scene]).expect("the scene renders");
    let plan = plan_for(&input, Some(covered)).expect("the build fits");
    build_planned(&input, &plan, &|_| ()).expect("the set builds").0
}

/// A sphere under a lamp and the sun.
pub fn sphere(size_px: usize) -> Scene {
    let disc = Light { angular_diameter_deg: 8.0, ..Light::point([-0.8, 0.5, 0.4]) };
    let still = Scene::still("sphere", Shape::Sphere, vec![Light::point([0.3, 0.2, 1.0]), disc], size_px);
    Scene { light_samples: 5, ..still }
}

/// Every kind of picture, small.
pub fn scenes() -> Vec<Scene> {
    let base = sphere(48);
    let of = |name: &str, shape, pixel_samples| Scene { name: name.into(), shape, pixel_samples, ..base.clone() };
    vec![
        base.clone(),
        of("hemisphere", Shape::Hemisphere, 4),
        of("patch", Shape::Patch { width_mm: 20.0, distance_mm: 60.0, tilt_deg: 30.0, turn_deg: 15.0 }, 1),
        of("snake", Shape::Snake, 1),
        of(
            "screen",
            Shape::Screen {
                distance_mm: 50.0,
                width_mm: 100.0,
                beam_diameter_mm: 1.0,
                hole_diameter_mm: None,
                incidence_deg: 10.0,
            },
            70, // more than one run of samples in a pixel
        ),
    ]
}
