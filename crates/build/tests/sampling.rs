//! Sampling of built tables: densities against counts, mean weights against quadrature, reciprocity, and the bound on weights.

#[path = "../../brdf/tests/tiny_atlas/mod.rs"]
mod tiny_atlas;

use std::f64::consts::PI;
use std::path::Path;
use std::sync::OnceLock;

use diffraction_brdf::direction::from_angles_deg;
use diffraction_brdf::spectrum::Illuminant;
use diffraction_brdf::{Brdf, Factor, FrontFactor, Material, Restriction, Vec3, Xyz};
use diffraction_build::height::prepare::{Level, PrepareConfig, prepare};
use diffraction_build::height::read::{ReadConfig, read_scan};
use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
use diffraction_build::tables::build::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Basis, Prefilter, Storage, TablesConfig};
use ndarray::Array3;
use rayon::prelude::*;

/// Polar angles of the viewer in degrees.
const ANGLES_DEG: [f64; 5] = [0.0, 35.0, 70.0, 85.0, 89.0];
/// Samples per viewer.
const SAMPLES: usize = 30_000;
/// Bins of the hemisphere in y and φ, where `wi = (h sin φ, y, h cos φ)`, `h = sqrt(1 - y²)`, in a frame with x along the
/// viewer's projection: all of one solid angle, and none whose form is extreme near the mirror direction.
const BINS: [usize; 2] = [24, 48];
/// Points per side of a bin at which densities are integrated.
const POINTS: usize = 12;
/// A chi-square value of this probability or less fails; the random numbers are always the same.
const SIGNIFICANCE: f64 = 1e-4;

/// Small tables of a bundled specimen, with a coherence that they resolve.
fn built(name: &str, material: Material, level: Level, blend_nm: Option<f64>) -> Brdf {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../specimens/{name}.tif"));
    let scan = read_scan(&path, &ReadConfig::default()).unwrap();
    let (field, _) = prepare(&scan.field, &PrepareConfig { level, despike: None, blend_nm }).unwrap();
    let optics = OpticsConfig { material, ..OpticsConfig::ideal(Illuminant::D65, 1_500.0, Edge::Tile, Windows::Grid) };
    let config = TablesConfig {
        basis: Basis::Chebyshev,
        tolerance: 1e-2,
        size: Some(161),
        count: None,
        wavelength_step_nm: None,
        storage: Some(Storage::Float),
        prefilter: Prefilter::Auto,
        memory_mib: 512,
    };
    Brdf::new(build(&BuildInput::new(&[field], &optics, &config), &|_| ()).unwrap().0).unwrap()
}

/// All bundled specimens with the materials of pipeline.toml, and the made-up one, which has shadowing and a cross term.
fn specimens() -> &'static [(&'static str, Brdf)] {
    static SPECIMENS: OnceLock<Vec<(&'static str, Brdf)>> = OnceLock::new();
    SPECIMENS.get_or_init(|| {
        let keratin = Material::Dielectric { n: 1.56 };
        let generated = [
            ("corn_snake_like", keratin),
            ("sunbeam_snake_like", keratin),
            ("blazed_2500nm", Material::Ideal),
            ("sinusoid_1600nm", Material::Ideal),
            ("cd_track_like", Material::Conductor { n: 0.96, k: 6.7 }),
        ];
        let mut all: Vec<_> = generated.map(|(name, material)| (name, built(name, material, Level::None, None))).into();
        let measured = "grating_nanosurf_314nm";
        all.push((measured, built(measured, Material::Dielectric { n: 1.5 }, Level::Plane, Some(300.0))));
        // The tables are the same for the other model of reflection.
        for (of, name) in [(0, "corn_snake_like, vector"), (3, "sinusoid_1600nm, vector"), (4, "cd_track_like, vector")]
        {
            let mut tables = all[of].1.tables().clone();
            tables.front_factor.factor = Factor::Vector;
            all.push((name, Brdf::new(tables).unwrap()));
        }
        all.push(("tiny", Brdf::new(tiny_atlas::tiny_tables()).unwrap()));
        all
    })
}

/// A specimen seen from one direction.
struct Case {
    what: String,
    brdf: &'static Brdf,
    wo: Vec3,
    integrals: Integrals,
    drawn: Drawn,
}

/// Every specimen at every angle, each at an azimuth of its own.
fn cases() -> &'static [Case] {
    static CASES: OnceLock<Vec<Case>> = OnceLock::new();
    CASES.get_or_init(|| {
        let pairs = (0..specimens().len()).flat_map(|n| (0..ANGLES_DEG.len()).map(move |k| (n, k)));
        let case = |(n, k): (usize, usize)| {
            let ((name, brdf), angle) = (&specimens()[n], ANGLES_DEG[k]);
            let wo = from_angles_deg(angle, 77.0 * n as f64 + 31.0 * k as f64);
            let what = format!("{name} at {angle} degrees");
            Case { what, brdf, wo, integrals: integrate(brdf, wo), drawn: draw(brdf, wo) }
        };
        pairs.collect::<Vec<_>>().into_par_iter().map(case).collect()
    })
}

/// Cosine and sine of the viewer's azimuth.
fn azimuth(wo: Vec3) -> [f64; 2] {
    let length = wo[0].hypot(wo[1]);
    if length > 0.0 { [wo[0] / length, wo[1] / length] } else { [1.0, 0.0] }
}

/// The direction at `y` and `φ` in the viewer's frame.
fn direction(wo: Vec3, y: f64, phi: f64) -> Vec3 {
    let [cos, sin] = azimuth(wo);
    let h = (1.0 - y * y).sqrt();
    let x = h * phi.sin();
    [x * cos - y * sin, x * sin + y * cos, h * phi.cos()]
}

fn bin_of(wo: Vec3, wi: Vec3) -> usize {
    let [cos, sin] = azimuth(wo);
    let [x, y] = [wi[0] * cos + wi[1] * sin, wi[1] * cos - wi[0] * sin];
    let place = |share: f64, bins: usize| ((share * bins as f64) as usize).min(bins - 1);
    place(0.5 * (y + 1.0), BINS[0]) * BINS[1] + place(x.atan2(wi[2]) / PI + 0.5, BINS[1])
}

/// Integrals over the hemisphere.
struct Integrals {
    /// Of the density, per bin.
    shares: Vec<f64>,
    /// Of a density that is wrong by up to 30 %, per bin, scaled to the same total.
    tilted: Vec<f64>,
    /// Of the BRDF times the cosine.
    albedo: Xyz,
}

fn integrate(brdf: &Brdf, wo: Vec3) -> Integrals {
    let mut random = fastrand::Rng::with_seed(11);
    let area = 2.0 / (BINS[0] * POINTS) as f64 * PI / (BINS[1] * POINTS) as f64;
    let empty = vec![0.0; BINS[0] * BINS[1]];
    let mut found = Integrals { shares: empty.clone(), tilted: empty, albedo: [0.0; 3] };
    for row in 0..BINS[0] * POINTS {
        for column in 0..BINS[1] * POINTS {
            let y = -1.0 + 2.0 * (row as f64 + random.f64()) / (BINS[0] * POINTS) as f64;
            let phi = PI * ((column as f64 + random.f64()) / (BINS[1] * POINTS) as f64 - 0.5);
            let wi = direction(wo, y, phi);
            let share = brdf.pdf(wi, wo) * area;
            let bin = row / POINTS * BINS[1] + column / POINTS;
            found.shares[bin] += share;
            found.tilted[bin] += share * (1.0 + 0.3 * (3.0 * wi[0] + 5.0 * wi[1]).sin());
            let xyz = brdf.eval(wi, wo);
            found.albedo.iter_mut().zip(xyz).for_each(|(sum, value)| *sum += value * wi[2] * area);
        }
    }
    let scale = found.shares.iter().sum::<f64>() / found.tilted.iter().sum::<f64>();
    found.tilted.iter_mut().for_each(|share| *share *= scale);
    found
}

/// What sampling gives: counts per bin, the mean of the weights, its standard error, the largest, and samples without one.
struct Drawn {
    counts: Vec<f64>,
    mean: Xyz,
    error: Xyz,
    largest: f64,
    lost: usize,
}

fn draw(brdf: &Brdf, wo: Vec3) -> Drawn {
    let mut random = fastrand::Rng::with_seed(5);
    let mut drawn =
        Drawn { counts: vec![0.0; BINS[0] * BINS[1]], mean: [0.0; 3], error: [0.0; 3], largest: 0.0, lost: 0 };
    for _ in 0..SAMPLES {
        let Some(sample) = brdf.sample(wo, [random.f64(), random.f64(), random.f64()]) else {
            drawn.lost += 1;
            continue;
        };
        drawn.counts[bin_of(wo, sample.wi)] += 1.0;
        for c in 0..3 {
            drawn.mean[c] += sample.weight[c] / SAMPLES as f64;
            drawn.error[c] += sample.weight[c].powi(2) / SAMPLES as f64;
            drawn.largest = drawn.largest.max(sample.weight[c].abs());
        }
    }
    for c in 0..3 {
        drawn.error[c] = ((drawn.error[c] - drawn.mean[c].powi(2)).max(0.0) / SAMPLES as f64).sqrt();
    }
    drawn
}

/// Probability of a chi-square value as large as that of counts against expected shares (Wilson and Hilferty 1931); bins
/// that expect fewer than five are put together.
fn chi_square_probability(counts: &[f64], shares: &[f64], samples: usize) -> f64 {
    let (mut value, mut bins, mut pooled) = (0.0, 0usize, [0.0; 2]);
    let mut add = |count: f64, expected: f64| {
        value += (count - expected).powi(2) / expected;
        bins += 1;
    };
    for (count, share) in counts.iter().zip(shares) {
        let expected = share * samples as f64;
        if expected >= 5.0 {
            add(*count, expected);
        } else {
            pooled = [pooled[0] + count, pooled[1] + expected];
        }
    }
    if pooled[1] > 0.0 {
        add(pooled[0], pooled[1]);
    }
    let freedom = (bins - 1) as f64;
    let spread = 2.0 / (9.0 * freedom);
    let z = ((value / freedom).cbrt() - (1.0 - spread)) / spread.sqrt();
    0.5 * libm::erfc(z / 2f64.sqrt())
}

#[test]
fn samples_are_drawn_from_the_density_that_is_stated() {
    for Case { what, integrals, drawn, .. } in cases() {
        let total: f64 = integrals.shares.iter().sum();
        let probability = chi_square_probability(&drawn.counts, &integrals.shares, SAMPLES);
        println!("{what}: density {total:.4}, probability {probability:.3}, lost {}", drawn.lost);
        assert!((total - 1.0).abs() < 0.01, "{what}: the density integrates to {total}");
        assert!(probability > SIGNIFICANCE, "{what}: chi-square of probability {probability:e}");
        assert!(drawn.lost <= SAMPLES / 500, "{what}: {} samples were lost", drawn.lost);
    }
}

#[test]
fn a_density_that_is_a_little_wrong_is_found_out() {
    for Case { what, integrals, drawn, .. } in cases() {
        let probability = chi_square_probability(&drawn.counts, &integrals.tilted, SAMPLES);
        assert!(probability < 0.1 * SIGNIFICANCE, "{what}: {probability:e}");
    }
}

#[test]
fn mean_weights_are_the_directional_albedo() {
    for Case { what, integrals: Integrals { albedo, .. }, drawn, .. } in cases() {
        println!("{what}: albedo {:.4}, mean {:.4} ± {:.4}", albedo[1], drawn.mean[1], drawn.error[1]);
        for c in 0..3 {
            let allowed = 4.0 * drawn.error[c] + 0.01 * albedo[c];
            assert!((drawn.mean[c] - albedo[c]).abs() < allowed, "{what}: {:?} for {albedo:?}", drawn.mean);
            // The weights vary little: this many samples give the albedo to two per cent.
            assert!(drawn.error[c] < 0.02 * albedo[c], "{what}: ± {:?} of {albedo:?}", drawn.error);
        }
    }
}

#[test]
fn weights_stay_below_their_bound() {
    for Case { what, brdf, wo, drawn, .. } in cases() {
        let bound = brdf.weight_bound(*wo);
        println!("{what}: largest weight {:.2}, bound {bound:.1}", drawn.largest);
        assert!(bound.is_finite() && drawn.largest <= bound, "{what}: {} above {bound}", drawn.largest);
        assert!(drawn.largest < 40.0 * drawn.mean[1], "{what}: {} for an albedo of {:?}", drawn.largest, drawn.mean);
    }
}

#[test]
fn light_and_viewer_may_be_exchanged() {
    for (name, brdf) in specimens() {
        for n in 0..200 {
            let [a, b] = [n, 3 * n + 1].map(|n| from_angles_deg((n * 37 % 90) as f64, (n * 113) as f64));
            let [one, other] = [brdf.eval(a, b), brdf.eval(b, a)];
            for c in 0..3 {
                assert!((one[c] - other[c]).abs() <= 1e-9 * one[c].abs(), "{name}: {one:?} {other:?}");
            }
        }
    }
}

/// Integral of the density.
fn density_total(brdf: &Brdf, wo: Vec3) -> f64 {
    const SIDE: usize = 300;
    let at = |n: usize| {
        direction(
            wo,
            -1.0 + 2.0 * ((n / SIDE) as f64 + 0.5) / SIDE as f64,
            PI * ((n % SIDE) as f64 + 0.5) / SIDE as f64 - PI / 2.0,
        )
    };
    (0..SIDE * SIDE).map(|n| brdf.pdf(at(n), wo)).sum::<f64>() * 2.0 * PI / (SIDE * SIDE) as f64
}

#[test]
fn where_tables_have_no_answer_nothing_is_drawn_and_the_density_is_zero() {
    let mut set = tiny_atlas::tiny_tables();
    // A window to the right of the middle, for the lower half of t.
    let window =
        |table: &Array3<f32>| Array3::from_shape_fn((33, 36, 3), |(row, column, c)| table[[row + 16, column + 24, c]]);
    set.tables = set.tables.iter().map(window).collect();
    let range = Array3::from_shape_fn((33, 36, 3), |(row, _, channel)| match channel {
        0 => 0.1,
        1 => 0.8,
        _ => f32::from(u8::from(row > 3)),
    });
    set.restriction = Some(Restriction { size: 65, first: [16, 24], range });
    let brdf = Brdf::new(set).unwrap();
    for angle in ANGLES_DEG {
        let wo = from_angles_deg(angle, 160.0);
        let drawn = draw(&brdf, wo);
        let total = density_total(&brdf, wo);
        let found = 1.0 - drawn.lost as f64 / SAMPLES as f64;
        assert!((total - found).abs() < 0.01, "{angle}: {total} {found}");
        let mut random = fastrand::Rng::with_seed(3);
        for _ in 0..2_000 {
            let u = [random.f64(), random.f64(), random.f64()];
            if let Some(sample) = brdf.sample(wo, u) {
                assert!(brdf.answers(sample.wi, wo) && sample.weight[1].is_finite());
            }
            let wi = direction(wo, 2.0 * u[0] - 1.0, PI * (u[1] - 0.5));
            assert_eq!(brdf.pdf(wi, wo) == 0.0, !brdf.answers(wi, wo), "{wi:?}");
        }
    }
}

#[test]
fn nothing_comes_from_below_the_surface() {
    let brdf = Brdf::new(tiny_atlas::tiny_tables()).unwrap();
    for wo in [[0.6, 0.0, -0.8], [1.0, 0.0, 0.0], [f64::NAN, 0.0, 1.0]] {
        assert!(brdf.sample(wo, [0.3, 0.4, 0.5]).is_none());
        assert_eq!(brdf.pdf([0.0, 0.0, 1.0], wo), 0.0);
        assert_eq!(brdf.pdf(wo, [0.0, 0.0, 1.0]), 0.0);
    }
}

#[test]
fn a_black_surface_is_sampled_evenly() {
    let mut set = tiny_atlas::tiny_tables();
    set.tables.iter_mut().for_each(|table| table.fill(0.0));
    set.lobe = None;
    set.front_factor = FrontFactor { material: Material::Ideal, shadowing: false, factor: Factor::Scalar };
    let brdf = Brdf::new(set).unwrap();
    let sample = brdf.sample(from_angles_deg(60.0, 10.0), [0.3, 0.4, 0.5]).unwrap();
    assert!((sample.pdf - 0.5 / PI).abs() < 1e-15 && sample.weight == [0.0; 3]);
}
