//! Filtered look-ups on built tables, against the mean of `f cos_theta_i` over a thousand points of the light's disc.

use std::path::Path;
use std::sync::OnceLock;

use diffraction_brdf::direction::normalise;
use diffraction_brdf::spectrum::Illuminant;
use diffraction_brdf::{Brdf, Factor, Footprint, Interpolation, Material, SpectralTables, Vec3, Xyz};
use diffraction_build::ground::sampling::{Region, direction_pairs, plane};
use diffraction_build::height::HeightField;
use diffraction_build::height::read::{ReadConfig, read_scan};
use diffraction_build::height::synthesize::{Structure, synthesize};
use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
use diffraction_build::tables::build::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Basis, Prefilter, Storage, TablesConfig};
use diffraction_build::tables::spectral::{SpectralInput, build_spectral};
use rayon::prelude::*;

/// Half-angles of lights in degrees, with what the median and the 95th percentile of relative errors may be: a thousandth for the
/// sun, a hundredth for a lamp of one degree, at 95 of 100 pairs. What is left is of second order in the angle, so that bounds beyond grow with its square.
const LIGHTS: [(f64, [f64; 2]); 4] =
    [(0.265, [3e-4, 1e-3]), (1.0, [3e-3, 1e-2]), (2.5, [1.9e-2, 6.3e-2]), (5.0, [7.5e-2, 0.25])];
/// Pairs of directions, half of them near the mirror direction.
const PAIRS: usize = 300;
/// Points of the light's disc.
const POINTS: usize = 1024;
/// Values below this share of the brightest count by how far they are off that share of it.
const FLOOR: f64 = 1e-7;

/// At single wavelengths colours are narrower than in XYZ, and errors larger by up to this.
const WAVELENGTH_SHARE: f64 = 2.0;

struct Specimen {
    name: &'static str,
    brdf: Brdf,
    spectral: SpectralTables,
}

/// The tables of the bundled manifest.
fn built(name: &'static str, field: HeightField, factor: Factor) -> Specimen {
    let material = Material::Dielectric { n: 1.56 };
    let ideal = OpticsConfig::ideal(Illuminant::D65, 4_000.0, Edge::Tile, Windows::Grid);
    let optics = OpticsConfig { material, factor, ..ideal };
    let tables = TablesConfig {
        basis: Basis::Chebyshev,
        tolerance: 1e-3,
        size: Some(601),
        count: None,
        wavelength_step_nm: None,
        storage: Some(Storage::Float),
        prefilter: Prefilter::Auto,
        memory_mib: 2048,
    };
    let fields = [field];
    let input = BuildInput::new(&fields, &optics, &tables);
    let brdf = Brdf::new(build(&input, &|_| ()).unwrap().0).unwrap();
    let of_wavelengths = SpectralInput::new(&optics, &tables);
    let spectral = build_spectral(&input, &of_wavelengths, &|_| ()).unwrap().tables;
    Specimen { name, brdf, spectral }
}

fn bundled(name: &str) -> HeightField {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../specimens/{name}.tif"));
    read_scan(&path, &ReadConfig::default()).unwrap().field
}

fn specimens() -> &'static [Specimen] {
    static SPECIMENS: OnceLock<Vec<Specimen>> = OnceLock::new();
    SPECIMENS.get_or_init(|| {
        let rough = Structure::GaussianRough { rms_nm: 60.0, correlation_length_nm: 900.0, seed: 4 };
        let rough = synthesize(&rough, [512, 512], [62.5, 62.5]).unwrap();
        vec![
            built("corn_snake_like", bundled("corn_snake_like"), Factor::Vector),
            built("sunbeam_snake_like", bundled("sunbeam_snake_like"), Factor::Vector),
            built("rough, scalar factor", rough, Factor::Scalar),
        ]
    })
}

fn pairs() -> Vec<(Vec3, Vec3)> {
    [Region::Hemisphere, Region::NearSpecular]
        .into_iter()
        .flat_map(|region| direction_pairs(region, PAIRS / 2))
        .collect()
}

fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Directions of equal solid angle over a disc.
fn disc(wi: Vec3, half_angle_deg: f64, count: usize) -> Vec<Vec3> {
    let s = normalise(cross(wi, [0.36, -0.48, 0.8]));
    let p = cross(wi, s);
    let below = 1.0 - half_angle_deg.to_radians().cos();
    let direction = |n: usize| {
        let height = 1.0 - below * (n as f64 + 0.5) / count as f64;
        let across = (1.0 - height * height).sqrt();
        let (sin, cos) = (2.399_963_229_728_653 * n as f64).sin_cos();
        std::array::from_fn(|k| height * wi[k] + across * (cos * s[k] + sin * p[k]))
    };
    (0..count).map(direction).collect()
}

/// Mean of `f cos_theta_i` over the disc, over the centre's cosine.
fn mean<const N: usize>(wi: Vec3, half_angle_deg: f64, f: impl Fn(Vec3) -> [f64; N]) -> [f64; N] {
    let mut sum = [0.0; N];
    for wi in disc(wi, half_angle_deg, POINTS) {
        let value = f(wi);
        sum.iter_mut().zip(value).for_each(|(sum, value)| *sum += value * wi[2].max(0.0));
    }
    sum.map(|sum| sum / POINTS as f64 / wi[2])
}

/// Median and 95th percentile of relative errors.
fn percentiles(found: &[f64], expected: &[f64]) -> [f64; 2] {
    let floor = FLOOR * expected.iter().copied().fold(0.0, f64::max);
    let mut errors: Vec<f64> =
        found.iter().zip(expected).map(|(found, expected)| (found - expected).abs() / expected.max(floor)).collect();
    errors.sort_by(f64::total_cmp);
    [0.5, 0.95].map(|share| errors[(share * (errors.len() - 1) as f64) as usize])
}

fn of_light(wi: Vec3, half_angle_deg: f64) -> Footprint {
    Footprint::of_light(wi, 2.0 * half_angle_deg).unwrap()
}

#[test]
fn a_filtered_look_up_is_the_mean_over_the_light() {
    let mut wrong = Vec::new();
    for Specimen { name, brdf, .. } in specimens() {
        for (angle, bounds) in LIGHTS {
            let values: Vec<[Xyz; 3]> = pairs()
                .into_par_iter()
                .map(|(wi, wo)| {
                    [
                        mean(wi, angle, |wi| brdf.eval(wi, wo)),
                        brdf.eval_filtered(wi, wo, of_light(wi, angle)),
                        brdf.eval(wi, wo),
                    ]
                })
                .collect();
            let luminances = |k: usize| values.iter().map(|value| value[k][1]).collect::<Vec<_>>();
            let expected = luminances(0);
            let [filtered, centre] = [1, 2].map(|k| percentiles(&luminances(k), &expected));
            println!(
                "{name}, {angle} degrees: {:.1e} / {:.1e}, centre {:.1e} / {:.1e}",
                filtered[0], filtered[1], centre[0], centre[1]
            );
            if (0..2).any(|k| filtered[k] > bounds[k]) {
                wrong.push(format!("{name}, {angle} degrees: {filtered:?}, allowed are {bounds:?}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_filtered_look_up_at_a_wavelength_is_the_mean_over_the_light() {
    let mut wrong = Vec::new();
    for Specimen { name, spectral, .. } in specimens() {
        let filtered = spectral.filtered();
        for (angle, bounds) in LIGHTS {
            let values: Vec<[f64; 2]> = pairs()
                .into_par_iter()
                .enumerate()
                .map(|(n, (wi, wo))| {
                    let nm = [400.0 + 350.0 * plane(n)[0]];
                    let [expected] = mean(wi, angle, |wi| [spectral.eval(Interpolation::Bilinear, wi, wo, &nm)[0]]);
                    let footprint = of_light(wi, angle);
                    [expected, filtered.eval_filtered(Interpolation::Bilinear, wi, wo, footprint, &nm)[0]]
                })
                .collect();
            let [expected, found] = [0, 1].map(|k| values.iter().map(|value| value[k]).collect::<Vec<_>>());
            let errors = percentiles(&found, &expected);
            println!("{name} at one wavelength, {angle} degrees: {:.1e} / {:.1e}", errors[0], errors[1]);
            if (0..2).any(|k| errors[k] > WAVELENGTH_SHARE * bounds[k]) {
                wrong.push(format!("{name}, {angle} degrees: {errors:?}, {bounds:?}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn exchanged_axes_are_found() {
    let brdf = &specimens()[0].brdf;
    let turned = |wi: Vec3, angle: f64| {
        let [uu, uv, vv] = of_light(wi, angle).covariance();
        // A quarter of a turn.
        Footprint::new(vv, -uv, uu).unwrap()
    };
    let values: Vec<[f64; 3]> = pairs()
        .into_par_iter()
        .filter(|(wi, _)| wi[2] < 0.7)
        .map(|(wi, wo)| {
            [
                mean(wi, 1.0, |wi| brdf.eval(wi, wo))[1],
                brdf.eval_filtered(wi, wo, of_light(wi, 1.0))[1],
                brdf.eval_filtered(wi, wo, turned(wi, 1.0))[1],
            ]
        })
        .collect();
    let column = |k: usize| values.iter().map(|value| value[k]).collect::<Vec<_>>();
    let [right, wrong] = [1, 2].map(|k| percentiles(&column(k), &column(0)));
    println!("axes as they are {right:?}, exchanged {wrong:?}");
    assert!(wrong[1] > LIGHTS[1].1[1] && wrong[1] > 4.0 * right[1], "{right:?} {wrong:?}");
}

#[test]
fn small_footprints_lead_to_the_point_without_a_step() {
    for Specimen { name, brdf, spectral } in specimens() {
        let filtered = spectral.filtered();
        for interpolation in [Interpolation::Bilinear, Interpolation::Cubic] {
            let brdf = brdf.clone().with_interpolation(interpolation);
            for (wi, wo) in pairs().into_iter().step_by(17) {
                let at = |angle: f64| brdf.eval_filtered(wi, wo, of_light(wi, angle))[1];
                let point = brdf.eval(wi, wo)[1];
                assert!((at(0.0) - point).abs() < 1e-6 * point, "{name}: {} {point}", at(0.0));
                let scale = (0..40).map(|n| at(0.1 * f64::from(n))).fold(point, f64::max);
                let mut last = point;
                for n in 0..400 {
                    let value = at(5e-3 * f64::from(n));
                    assert!((value - last).abs() < 0.03 * scale, "{name}: a step from {last} to {value} at {n}");
                    last = value;
                }
                let (nm, zero) = ([551.0], Footprint::POINT);
                let point = spectral.eval(interpolation, wi, wo, &nm)[0];
                let found = filtered.eval_filtered(interpolation, wi, wo, zero, &nm)[0];
                assert!((found - point).abs() < 1e-6 * point, "{name}: {found} {point}");
            }
        }
    }
}

#[test]
fn light_and_viewer_may_be_exchanged_for_the_same_footprint() {
    let footprint = Footprint::new(3e-4, 1e-4, 1e-4).unwrap();
    for Specimen { name, brdf, .. } in specimens() {
        for (wi, wo) in pairs() {
            let [one, other] = [brdf.eval_filtered(wi, wo, footprint), brdf.eval_filtered(wo, wi, footprint)];
            for c in 0..3 {
                assert!((one[c] - other[c]).abs() <= 1e-9 * one[c].abs(), "{name}: {one:?} {other:?}");
            }
        }
        assert_eq!(brdf.eval_filtered([0.6, 0.0, -0.8], [0.0, 0.0, 1.0], footprint), [0.0; 3]);
    }
}

/// Mean of `f` over a normal distribution of (u, v) with the covariance of a light's footprint.
fn normal_mean(brdf: &Brdf, wi: Vec3, wo: Vec3, half_angle_deg: f64) -> f64 {
    let [uu, uv, vv] = of_light(wi, half_angle_deg).covariance();
    let [a, b] = [uu.sqrt(), uv / uu.sqrt()];
    let c = (vv - b * b).sqrt();
    let value = |n: usize| {
        let radius = (-2.0 * (1.0 - (n as f64 + 0.5) / POINTS as f64).ln()).sqrt();
        let (sin, cos) = (2.399_963_229_728_653 * n as f64).sin_cos();
        let [x, y] = [wi[0] + a * radius * cos, wi[1] + radius * (b * cos + c * sin)];
        brdf.eval([x, y, (1.0 - x * x - y * y).max(1e-6).sqrt()], wo)[1]
    };
    (0..POINTS).map(value).sum::<f64>() / POINTS as f64
}

#[test]
fn an_even_ellipse_is_nearer_than_a_normal_distribution() {
    for Specimen { name, brdf, .. } in specimens() {
        let values: Vec<[f64; 3]> = pairs()
            .into_par_iter()
            .map(|(wi, wo)| {
                let expected = mean(wi, 1.0, |wi| brdf.eval(wi, wo))[1];
                [expected, brdf.eval_filtered(wi, wo, of_light(wi, 1.0))[1], normal_mean(brdf, wi, wo, 1.0)]
            })
            .collect();
        let column = |k: usize| values.iter().map(|value| value[k]).collect::<Vec<_>>();
        let [even, normal] = [1, 2].map(|k| percentiles(&column(k), &column(0)));
        println!("{name}: even {:.1e} / {:.1e}, normal {:.1e} / {:.1e}", even[0], even[1], normal[0], normal[1]);
        assert!(normal[1] > 2.0 * even[1], "{name}: {even:?} {normal:?}");
    }
}
