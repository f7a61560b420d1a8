//! Mirrors, level and tilted: power, place and shape of the one lobe they reflect.

use crate::common::optics_forms::{fresnel, front, gaussian};
use crate::common::surfaces::{
    PLACEMENTS, flat, laser, lobe_deviation, lobe_points, negated, outgoing, sampled, stretched, tables, worst_of_peak,
};
use diffraction_brdf::direction::{Vec3, dot, from_angles_deg};
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, Material, OpticsConfig, Windows};
use diffraction_build::optics::reference::brdf_xyz_batch;

const MATERIALS: [Material; 3] =
    [Material::Ideal, Material::Dielectric { n: 1.56 }, Material::Conductor { n: 0.27, k: 2.77 }];

const WAVELENGTH_NM: f64 = 550.0;
const SIGMA_NM: f64 = 5_000.0;

fn incident() -> [Vec3; 3] {
    [from_angles_deg(0.0, 0.0), from_angles_deg(35.0, 20.0), from_angles_deg(60.0, 200.0)]
}

/// `∫ f cos_o dω_o` over the lobe, `cos_o dω_o` being `du dv`.
fn integral(wi: Vec3, brdf: impl Fn(&[(Vec3, Vec3)]) -> Vec<f64>) -> f64 {
    let (points, area) = lobe_points([0.0; 2], lobe_deviation(SIGMA_NM, WAVELENGTH_NM));
    let pairs: Vec<_> = points.iter().map(|p| (wi, outgoing(wi, p[0], p[1]).unwrap())).collect();
    brdf(&pairs).iter().sum::<f64>() * area
}

/// What the lobe's width adds to `R`: half its variance times the Laplacian of `R G/w²`, which is 1 · R at
/// the centre. Central differences over one deviation make that half the sum of four differences.
fn widening(material: Material, wi: Vec3) -> f64 {
    let s = lobe_deviation(SIGMA_NM, WAVELENGTH_NM);
    let at = |u: f64, v: f64| front(material, wi, outgoing(wi, u, v).unwrap());
    0.5 * (at(s, 0.0) + at(-s, 0.0) + at(0.0, s) + at(0.0, -s) - 4.0 * at(0.0, 0.0))
}

fn reference(field: &HeightField, optics: &OpticsConfig, pairs: &[(Vec3, Vec3)]) -> Vec<f64> {
    brdf_xyz_batch(std::slice::from_ref(field), optics, pairs).unwrap().iter().map(|xyz| xyz[1]).collect()
}

/// 1.3e-5 by the trapezoid rule, and 1.3e-4 by windows that two edges of the scan cut at 4 σ: each takes
/// `erfc(4/√2)/2` = 3.2e-5 off the amplitude. The fourth order of the widening is below 1e-5.
const TOLERANCE: f64 = 1.6e-4;

/// Twelve texels per deviation: chords err by at most an eighth of the squared step times the curvature.
const BILINEAR: f64 = 1.0 / (8.0 * 12.0 * 12.0);

#[test]
fn a_mirror_reflects_its_fresnel_reflectance() {
    for (edge, windows) in PLACEMENTS {
        // A tile may be smaller than the window; a scan that fades holds twelve windows, or one.
        let size = if edge == Edge::Tile { [20, 14] } else { [160, 120] };
        let mirror = flat(size, [400.0, 600.0]);
        let mut optics = laser(&[WAVELENGTH_NM], SIGMA_NM, edge, windows);
        let mut set = tables(&mirror, &optics, 1e-4, Some(101));
        for material in MATERIALS {
            optics.material = material;
            set.front_factor.material = material;
            for wi in incident() {
                let expected = fresnel(material, wi[2]) + widening(material, wi);
                let direct = integral(wi, |pairs| reference(&mirror, &optics, pairs));
                let [bilinear, cubic] = [Interpolation::Bilinear, Interpolation::Cubic].map(|interpolation| {
                    integral(wi, |pairs| pairs.iter().map(|p| brdf_xyz(&set, interpolation, p.0, p.1)[1]).collect())
                });
                let errors = [direct, bilinear, cubic].map(|sum| (sum / expected - 1.0).abs());
                let what = format!("{edge:?} {windows:?} {material:?} {wi:?}: {errors:?}");
                assert!(errors[0] < TOLERANCE, "reference, {what}");
                assert!(errors[1] < TOLERANCE + BILINEAR, "bilinear, {what}");
                assert!(errors[2] < TOLERANCE, "cubic, {what}");
            }
        }
    }
}

#[test]
fn the_mirror_test_sees_an_index_wrong_by_one_percent_and_a_wrong_geometry_factor() {
    let mirror = flat([160, 120], [400.0, 600.0]);
    let mut optics = laser(&[WAVELENGTH_NM], SIGMA_NM, Edge::Fade, Windows::Centre);
    optics.material = Material::Dielectric { n: 1.56 * 1.01 };
    let told = Material::Dielectric { n: 1.56 };
    let wi = incident()[1];
    let expected = fresnel(told, wi[2]) + widening(told, wi);
    let found = integral(wi, |pairs| reference(&mirror, &optics, pairs));
    assert!((found / expected - 1.0).abs() > 100.0 * TOLERANCE, "{found} against {expected}");
    // One cosine too many, the commonest slip in a BRDF.
    optics.material = told;
    let slipped =
        integral(wi, |pairs| reference(&mirror, &optics, pairs).iter().zip(pairs).map(|(f, p)| f * p.1[2]).collect());
    assert!((slipped / expected - 1.0).abs() > 100.0 * TOLERANCE);
}

/// A scan of just 8 σ cuts its window at 4 σ, where the amplitude is `e⁻⁸`. The steps there diffract about
/// `(R G/w²) 2 e⁻¹⁶ sin²(4σq) / (πu)²` along the axes, `q = 2πu/λ`, whatever the wavelength and σ: 2.3e-8/u². The
/// tables leave that light out of the coherent lobe, which ends at 6.44 deviations.
#[test]
fn a_window_cut_at_four_sigma_loses_a_known_trace_of_light() {
    let mirror = flat([400, 80], [100.0, 500.0]);
    let optics = laser(&[WAVELENGTH_NM], SIGMA_NM, Edge::Fade, Windows::Centre);
    let set = tables(&mirror, &optics, 1e-4, Some(101));
    let wi = from_angles_deg(0.0, 0.0);
    let closed = |u: f64, wo: Vec3| {
        let q = std::f64::consts::TAU * u / WAVELENGTH_NM;
        let (sin, cos) = (4.0 * SIGMA_NM * q).sin_cos();
        // By parts, with the first and second derivative of the Gaussian at 4 σ.
        let edge = sin - 4.0 / (q * SIGMA_NM) * cos - 15.0 / (q * SIGMA_NM).powi(2) * sin;
        front(Material::Ideal, wi, wo) * 2.0 * (-16f64).exp() * (edge / (std::f64::consts::PI * u)).powi(2)
    };
    let pairs: Vec<_> = (0..200).map(|i| (wi, outgoing(wi, 0.2 + 0.002 * f64::from(i), 0.0).unwrap())).collect();
    let expected: Vec<f64> = pairs.iter().map(|p| closed(-p.1[0], p.1)).collect();
    // The third derivative adds 52/(qσ)³ = 3.5 % of the amplitude at u = 0.2; samples of 100 nm instead
    // of an integral (q p/2)²/6 = 1 % at u = 0.6; the cut of y at 4 σ 6e-5.
    let found = reference(&mirror, &optics, &pairs);
    let error = worst_of_peak(&found, &expected);
    let most = found.iter().copied().fold(0.0, f64::max);
    println!("a trace of up to {most:.2e} 1/sr, off its closed form by {error:.2e}");
    assert!(error < 0.1, "{error:e}");
    // A mirror has no diffuse part but for the rounding of 1 - 1.
    let left = pairs.iter().map(|p| brdf_xyz(&set, Interpolation::Cubic, p.0, p.1)[1]).fold(0.0, f64::max);
    assert!(left < 1e-9 * most, "{left:e}");
    // Cut at 5.5 σ, there is none.
    let wider = reference(&flat([560, 120], [100.0, 500.0]), &optics, &pairs);
    assert!(wider.iter().all(|f| *f < 1e-4 * most), "the closed form would pass for anything");
}

const SLOPE: [f64; 2] = [0.03, -0.02];
const TILT_SIGMA_NM: f64 = 2_500.0;

fn tilted() -> HeightField {
    sampled([116, 140], [250.0, 200.0], |x, y| SLOPE[0] * x + SLOPE[1] * y)
}

/// The lobe of a tilted mirror in closed form: `p` is a plane wave, which moves the window's spectrum to
/// `(u, v) = -w (slope_x, slope_y)`.
fn tilted_lobe(wi: Vec3) -> (Vec<(Vec3, Vec3)>, Vec<f64>) {
    let s = lobe_deviation(TILT_SIGMA_NM, WAVELENGTH_NM);
    let normal = [-SLOPE[0], -SLOPE[1], 1.0];
    let facing = 2.0 * dot(wi, normal) / dot(normal, normal);
    let (points, _) = lobe_points([facing * SLOPE[0], facing * SLOPE[1]], s);
    let pairs: Vec<_> = points.iter().map(|p| (wi, outgoing(wi, p[0], p[1]).unwrap())).collect();
    let expected = points
        .iter()
        .zip(&pairs)
        .map(|(p, (wi, wo))| {
            let abs_w = wi[2] + wo[2];
            front(Material::Ideal, *wi, *wo) * gaussian(p[0] - abs_w * SLOPE[0], p[1] - abs_w * SLOPE[1], s)
        })
        .collect();
    (pairs, expected)
}

#[test]
fn a_tilted_mirror_obeys_the_law_of_reflection() {
    let field = tilted();
    let optics = laser(&[WAVELENGTH_NM], TILT_SIGMA_NM, Edge::Fade, Windows::Centre);
    let set = tables(&field, &optics, 1e-3, Some(601));
    for wi in [from_angles_deg(0.0, 0.0), from_angles_deg(35.0, 20.0), from_angles_deg(45.0, 200.0)] {
        let (pairs, expected) = tilted_lobe(wi);
        let direct = reference(&field, &optics, &pairs);
        // The window is cut at 5.5 σ, where its amplitude is 2.7e-7.
        let error = worst_of_peak(&direct, &expected);
        assert!(error < 1e-6, "reference: {error:e}");
        // The centroid, whatever the shape, is where the law of reflection says.
        let total: f64 = direct.iter().sum();
        let centroid: f64 = direct.iter().zip(&pairs).map(|(f, p)| f * (-p.0[0] - p.1[0])).sum::<f64>() / total;
        let normal = [-SLOPE[0], -SLOPE[1], 1.0];
        let law = 2.0 * dot(wi, normal) / dot(normal, normal) * SLOPE[0];
        let s = lobe_deviation(TILT_SIGMA_NM, WAVELENGTH_NM);
        // The front factor's slope, at most 4 here, moves it by its product with the variance.
        assert!((centroid - law).abs() < 4.0 * s * s, "{centroid} against {law}");
        // Texels of 0.27 deviations: the cubic errs by 3/128 · 0.27⁴ · 3 per axis = 7.5e-4 of the peak, and
        // basis and nodes in `|w|` by up to the tolerance.
        let cubic: Vec<f64> = pairs.iter().map(|p| brdf_xyz(&set, Interpolation::Cubic, p.0, p.1)[1]).collect();
        let error = worst_of_peak(&cubic, &expected);
        assert!(error < 2.5e-3, "cubic: {error:e}");
    }
}

#[test]
fn the_tilted_mirror_test_sees_sign_pitch_and_orientation() {
    let field = tilted();
    let optics = laser(&[WAVELENGTH_NM], TILT_SIGMA_NM, Edge::Fade, Windows::Centre);
    let mut upside_down = field.clone();
    upside_down.heights_nm.invert_axis(ndarray::Axis(0));
    let (pairs, expected) = tilted_lobe(incident()[1]);
    for (what, wrong) in [("negated", negated(&field)), ("pitch", stretched(&field, 1.01)), ("rows", upside_down)] {
        let error = worst_of_peak(&reference(&wrong, &optics, &pairs), &expected);
        assert!(error > 5e-3, "{what}: {error:e}");
        let set = tables(&wrong, &optics, 1e-3, Some(601));
        let cubic: Vec<f64> = pairs.iter().map(|p| brdf_xyz(&set, Interpolation::Cubic, p.0, p.1)[1]).collect();
        let error = worst_of_peak(&cubic, &expected);
        assert!(error > 5e-3, "{what} in tables: {error:e}");
    }
}
