//! Gratings: the power, place and shape of every order against its closed form.

use std::f64::consts::{PI, TAU};

use crate::common::optics_forms::{front, gaussian};
use crate::common::surfaces::{
    laser, lobe_deviation, lobe_points, negated, outgoing, rolled, sampled, stretched, tables, tables_config,
    worst_of_peak,
};
use diffraction_brdf::direction::{Vec3, from_angles_deg};
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz, lobe_window_power};
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, Material, OpticsConfig, Windows};
use diffraction_build::optics::reference::brdf_xyz_batch;
use diffraction_build::tables::build::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::TablesConfig;

const WAVELENGTH_NM: f64 = 550.0;
const SIGMA_NM: f64 = 4_000.0;

/// 11 σ along both axes: nothing of the window is cut. Rows half a σ apart sample a Gaussian exactly.
const LENGTH_NM: f64 = 44_000.0;
const ROWS: usize = 22;
const ROW_PITCH_NM: f64 = 2_000.0;

/// A grating along x with the power of each of its orders as a function of the phase per height, `k w`.
struct Grating {
    name: &'static str,
    field: HeightField,
    period_nm: f64,
    power: Box<dyn Fn(i32, f64) -> f64>,
}

fn ruled(period_nm: f64, samples: usize, height: impl Fn(f64) -> f64) -> HeightField {
    let pitch = period_nm / samples as f64;
    // An even number of columns: samples lie at half pitches, never on an edge of the profile.
    let columns = 2 * (0.5 * LENGTH_NM / pitch).ceil() as usize;
    sampled([columns, ROWS], [pitch, ROW_PITCH_NM], |x, _| height((x / period_nm).rem_euclid(1.0)))
}

fn sinusoid(amplitude_nm: f64) -> Grating {
    Grating {
        name: "sinusoid",
        field: ruled(1_600.0, 20, |share| amplitude_nm * (TAU * share).cos()),
        period_nm: 1_600.0,
        // Twenty samples per period alias order m with m - 20: J_17(4.7)² is 1e-13.
        power: Box::new(move |order, phase| libm::jn(order, phase * amplitude_nm).powi(2)),
    }
}

const SAMPLES: usize = 50;

/// `sin(x) / (n sin(x/n))` squared: the sum of n equal steps of phase `2x/n`, which tends to sinc².
fn sampled_sinc2(x: f64, n: f64) -> f64 {
    if x.abs() < 1e-9 { 1.0 } else { (x.sin() / (n * (x / n).sin())).powi(2) }
}

fn sinc2(x: f64) -> f64 {
    if x.abs() < 1e-9 { 1.0 } else { (x.sin() / x).powi(2) }
}

/// Ridges of 40 % of the period.
fn lamellar(depth_nm: f64) -> Grating {
    const DUTY: f64 = 0.4;
    Grating {
        name: "lamellar",
        field: ruled(2_500.0, SAMPLES, |share| if share < DUTY { depth_nm } else { 0.0 }),
        period_nm: 2_500.0,
        power: Box::new(move |order, phase| {
            let depth = 4.0 * (0.5 * phase * depth_nm).sin().powi(2);
            if order == 0 {
                return 1.0 - depth * DUTY * (1.0 - DUTY);
            }
            let (m, n) = (f64::from(order), SAMPLES as f64);
            depth * ((PI * m * DUTY).sin() / (n * (PI * m / n).sin())).powi(2)
        }),
    }
}

/// Ramps that rise along +x; `k w` is negative, so light goes to positive orders.
fn blazed(depth_nm: f64) -> Grating {
    Grating {
        name: "blazed",
        field: ruled(2_500.0, SAMPLES, |share| depth_nm * (share * SAMPLES as f64).floor() / SAMPLES as f64),
        period_nm: 2_500.0,
        power: Box::new(move |order, phase| {
            sampled_sinc2(0.5 * phase * depth_nm + PI * f64::from(order), SAMPLES as f64)
        }),
    }
}

fn gratings() -> Vec<Grating> {
    // At normal incidence order 0 has w = -2: the second sinusoid and the lamellar one send nothing there.
    let first_zero = 2.404_825_557_695_773 * WAVELENGTH_NM / (2.0 * TAU);
    vec![
        sinusoid(30.0),
        sinusoid(first_zero),
        sinusoid(200.0),
        lamellar(80.0),
        lamellar(0.25 * WAVELENGTH_NM),
        blazed(120.0),
        blazed(0.5 * WAVELENGTH_NM),
    ]
}

fn optics() -> OpticsConfig {
    laser(&[WAVELENGTH_NM], SIGMA_NM, Edge::Fade, Windows::Centre)
}

fn incident() -> [Vec3; 2] {
    [from_angles_deg(0.0, 0.0), from_angles_deg(35.0, 30.0)]
}

/// One order's lobe: pairs of directions, and the closed form `(R G/w²) power · gaussian` at each.
struct Order {
    number: i32,
    pairs: Vec<(Vec3, Vec3)>,
    expected: Vec<f64>,
    cell: f64,
    /// `(R G/w²) power` at the centre, and what the lobe's width adds: half the variance times the Laplacian.
    centre: [f64; 2],
    /// `R G/w²` there.
    front: f64,
}

/// Every order whose whole lobe is above the surface.
fn orders(grating: &Grating, wi: Vec3) -> Vec<Order> {
    let s = lobe_deviation(SIGMA_NM, WAVELENGTH_NM);
    let efficiency = |order: i32, wo: Vec3| {
        let phase = -TAU / WAVELENGTH_NM * (wi[2] + wo[2]);
        front(Material::Ideal, wi, wo) * (grating.power)(order, phase)
    };
    (-5..=5)
        .filter_map(|number| {
            let u = f64::from(number) * WAVELENGTH_NM / grating.period_nm;
            let (points, cell) = lobe_points([u, 0.0], s);
            let pairs: Vec<_> = points.iter().map(|p| Some((wi, outgoing(wi, p[0], p[1])?))).collect::<Option<_>>()?;
            // Near the horizon 1/cos_o varies within one lobe beyond its second order.
            if pairs.iter().any(|p| p.1[2] < 0.3) {
                return None;
            }
            let expected = points
                .iter()
                .zip(&pairs)
                .map(|(p, pair)| efficiency(number, pair.1) * gaussian(p[0] - u, p[1], s))
                .collect();
            let at = |du: f64, dv: f64| efficiency(number, outgoing(wi, u + du, dv).unwrap());
            let around = at(s, 0.0) + at(-s, 0.0) + at(0.0, s) + at(0.0, -s);
            let middle = outgoing(wi, u, 0.0).unwrap();
            Some(Order {
                number,
                pairs,
                expected,
                cell,
                centre: [at(0.0, 0.0), 0.5 * (around - 4.0 * at(0.0, 0.0))],
                front: front(Material::Ideal, wi, middle),
            })
        })
        .collect()
}

fn reference(field: &HeightField, optics: &OpticsConfig, pairs: &[(Vec3, Vec3)]) -> Vec<f64> {
    brdf_xyz_batch(std::slice::from_ref(field), optics, pairs).unwrap().iter().map(|xyz| xyz[1]).collect()
}

/// Worst pointwise deviation over all orders relative to the brightest point, and worst deviation of an
/// order's integral from its closed form relative to all light that a mirror would send there.
fn deviations(orders: &[Order], brdf: impl Fn(&[(Vec3, Vec3)]) -> Vec<f64>) -> [f64; 2] {
    assert!(orders.len() >= 4, "too few orders to speak of");
    let found: Vec<Vec<f64>> = orders.iter().map(|o| brdf(&o.pairs)).collect();
    let expected: Vec<f64> = orders.iter().flat_map(|o| o.expected.clone()).collect();
    let integral = orders.iter().zip(&found).map(|(order, f)| {
        let sum = f.iter().sum::<f64>() * order.cell;
        (sum - order.centre[0] - order.centre[1]).abs() / order.front
    });
    [worst_of_peak(&found.concat(), &expected), integral.fold(0.0, f64::max)]
}

/// Pointwise: the window's cut at 5.5 σ leaves 2.7e-7 of the amplitude; neighbouring orders are 14
/// deviations apart. The integral: 1.3e-5 by the trapezoid rule and the fourth order of the widening, an
/// eighth of s⁴ times fourth derivatives of up to 2000 (`J²(k w a)` through `w` at cos_o = 0.3).
const TOLERANCE: [f64; 2] = [2e-6, 1e-4];

#[test]
fn orders_of_gratings_meet_their_closed_forms() {
    for grating in gratings() {
        for wi in incident() {
            let orders = orders(&grating, wi);
            let worst = deviations(&orders, |pairs| reference(&grating.field, &optics(), pairs));
            println!("{} {wi:?}: {} orders, {worst:?}", grating.name, orders.len());
            assert!(worst[0] < TOLERANCE[0] && worst[1] < TOLERANCE[1], "{}: {worst:?}", grating.name);
        }
    }
}

#[test]
fn order_zero_vanishes_where_it_must() {
    let wi = from_angles_deg(0.0, 0.0);
    for grating in [&gratings()[1], &lamellar_half()] {
        let zero = orders(grating, wi).into_iter().find(|o| o.number == 0).unwrap();
        let found = reference(&grating.field, &optics(), &zero.pairs);
        // Through the lobe w changes by u²/2 <= 0.007, the amplitude by no more than its product with
        // the largest slope of J0 or sin, times its argument.
        let share = found.iter().sum::<f64>() * zero.cell / zero.front;
        assert!(share < 1e-4, "{}: {share:e}", grating.name);
    }
}

/// Equal ridges and grooves a quarter of a wavelength deep: half a wavelength of path, nothing in order 0.
fn lamellar_half() -> Grating {
    let depth_nm = 0.25 * WAVELENGTH_NM;
    Grating {
        name: "lamellar, half",
        field: ruled(2_500.0, SAMPLES, |share| if share < 0.5 { depth_nm } else { 0.0 }),
        period_nm: 2_500.0,
        power: Box::new(move |order, phase| {
            let (m, n) = (f64::from(order), SAMPLES as f64);
            let depth = (0.5 * phase * depth_nm).sin().powi(2);
            if order == 0 {
                1.0 - depth
            } else {
                4.0 * depth * ((0.5 * PI * m).sin() / (n * (PI * m / n).sin())).powi(2)
            }
        }),
    }
}

#[test]
fn sampled_envelopes_are_sinc_squared_within_the_sampling() {
    // sin x / x for small steps: the ratio is 1 + x²/(3n²) to leading order.
    let (blaze, ridge) = (blazed(200.0), lamellar(100.0));
    let phase = -TAU / WAVELENGTH_NM * 1.9;
    for order in -5..=5 {
        let x = 0.5 * phase * 200.0 + PI * f64::from(order);
        let ratio = (blaze.power)(order, phase) / sinc2(x);
        let step = x / SAMPLES as f64;
        assert!((ratio - 1.0 - step * step / 3.0).abs() < 0.1 * step * step, "blazed {order}: {ratio}");
        if order != 0 {
            let duty = 0.4;
            let x = PI * f64::from(order) * duty;
            let expected = 4.0 * (0.5 * phase * 100.0).sin().powi(2) * duty * duty * sinc2(x);
            let step = PI * f64::from(order) / SAMPLES as f64;
            let off = (ridge.power)(order, phase) - expected * (1.0 + step * step / 3.0);
            assert!(off.abs() < 0.1 * step * step * expected + 1e-12, "lamellar {order}: {off:e}");
        }
    }
}

/// Size of the tables whose texel, 0.26 deviations, costs the cubic 3/128 · 0.26⁴ · 3 = 3.2e-4 of the peak
/// along each axis.
const SIZE: usize = 1001;

#[test]
fn orders_in_tables_meet_their_closed_forms() {
    for grating in [sinusoid(100.0), lamellar(80.0), blazed(0.5 * WAVELENGTH_NM)] {
        let set = tables(&grating.field, &optics(), 1e-3, Some(SIZE));
        for wi in incident() {
            let worst = deviations(&orders(&grating, wi), |pairs| {
                pairs.iter().map(|p| brdf_xyz(&set, Interpolation::Cubic, p.0, p.1)[1]).collect()
            });
            println!("{} {wi:?}: {} tables, {worst:?}", grating.name, set.tables.len());
            // The grid's share, and basis and nodes in `|w|` with up to the tolerance each.
            assert!(worst[0] < 2.7e-3 && worst[1] < 2.1e-3, "{}: {worst:?}", grating.name);
        }
    }
}

#[test]
fn the_order_test_sees_sign_pitch_and_depth() {
    let grating = blazed(120.0);
    let orders = orders(&grating, incident()[1]);
    let mut deeper = grating.field.clone();
    deeper.heights_nm *= 1.01;
    let wrong = [("negated", negated(&grating.field)), ("pitch", stretched(&grating.field, 1.01)), ("depth", deeper)];
    for (what, field) in wrong {
        let worst = deviations(&orders, |pairs| reference(&field, &optics(), pairs));
        assert!(worst[0] > 4e-3, "{what}: {worst:?}");
    }
    let flipped = tables(&negated(&grating.field), &optics(), 1e-3, Some(SIZE));
    let worst = deviations(&orders, |pairs| {
        pairs.iter().map(|p| brdf_xyz(&flipped, Interpolation::Cubic, p.0, p.1)[1]).collect()
    });
    assert!(worst[0] > 0.1 && worst[1] > 0.1, "negated in tables: {worst:?}");
}

const PEAK_SIGMA_NM: f64 = 6_000.0;
const PEAK_LINES_NM: [f64; 3] = [450.0, 550.0, 650.0];

/// Periods that the peaks of `f` along u give by the grating equation: a blind scan for local maxima, each
/// put where the parabola through three logarithms has its top, which is exact for a Gaussian.
fn periods_nm(wavelength_nm: f64, wi: Vec3, brdf: impl Fn(&[(Vec3, Vec3)]) -> Vec<f64>) -> Vec<f64> {
    let step = 0.5 * lobe_deviation(PEAK_SIGMA_NM, wavelength_nm);
    let u: Vec<f64> = (0..).map(|i| 0.1 + f64::from(i) * step).take_while(|&u| u < 0.65).collect();
    let f = brdf(&u.iter().map(|&u| (wi, outgoing(wi, u, 0.0).unwrap())).collect::<Vec<_>>());
    let brightest = f.iter().copied().fold(0.0, f64::max);
    (1..f.len() - 1)
        .filter(|&i| f[i] > f[i - 1] && f[i] >= f[i + 1] && f[i] > 0.2 * brightest)
        .map(|i| {
            let [a, b, c] = [f[i - 1], f[i], f[i + 1]].map(f64::ln);
            let top = u[i] + 0.5 * step * (a - c) / (a - 2.0 * b + c);
            let order = (top * 2_500.0 / wavelength_nm).round();
            order * wavelength_nm / top
        })
        .collect()
}

/// The front factor and the envelope move a peak by the lobe's variance times their logarithmic slope in
/// u. At normal incidence these are `u/cos²` and, where sinc² is above 0.2, `2.1 · (πH/λ) u/cos`: together
/// below 6 u, and 8 u at 20°. With a deviation below 0.0122 the period is right within 1.5e-4 · 6 = 9e-4.
const PERIOD_TOLERANCE: f64 = 1e-3;

fn period_error(periods: &[f64]) -> f64 {
    assert!(!periods.is_empty(), "no peak found");
    periods.iter().map(|d| (d / 2_500.0 - 1.0).abs()).fold(0.0, f64::max)
}

/// 66 µm along both axes, 11 σ.
fn wide(height: f64) -> HeightField {
    sampled([1320, 33], [50.0, ROW_PITCH_NM], |x, _| height * (x / 2_500.0).rem_euclid(1.0))
}

#[test]
fn peaks_of_the_blazed_grating_give_its_period_back() {
    let field = wide(300.0);
    for wi in [from_angles_deg(0.0, 0.0), from_angles_deg(20.0, 0.0)] {
        for nm in PEAK_LINES_NM {
            let optics = laser(&[nm], PEAK_SIGMA_NM, Edge::Fade, Windows::Centre);
            let direct = periods_nm(nm, wi, |pairs| reference(&field, &optics, pairs));
            println!("{nm} nm, {wi:?}: {direct:.1?}");
            assert!(period_error(&direct) < PERIOD_TOLERANCE, "{nm} nm, reference: {direct:?}");
            let stretched = periods_nm(nm, wi, |pairs| reference(&stretched(&field, 1.01), &optics, pairs));
            assert!(period_error(&stretched) > 5.0 * PERIOD_TOLERANCE, "a pitch wrong by 1 % is not seen");
        }
    }
}

#[test]
fn peaks_in_tables_give_the_period_back() {
    let field = wide(300.0);
    for nm in PEAK_LINES_NM {
        let optics = laser(&[nm], PEAK_SIGMA_NM, Edge::Fade, Windows::Centre);
        let set = tables(&field, &optics, 1e-3, Some(1201));
        let periods = periods_nm(nm, from_angles_deg(0.0, 0.0), |pairs| {
            pairs.iter().map(|p| brdf_xyz(&set, Interpolation::Cubic, p.0, p.1)[1]).collect()
        });
        println!("{nm} nm, {} tables: {periods:.1?}", set.tables.len());
        assert!(period_error(&periods) < PERIOD_TOLERANCE, "{nm} nm: {periods:?}");
    }
}

/// A grating on a strip in the middle of a mirror: an order's share of the light is the square of the
/// window's share of the strip, `(erf((b - x)/√2σ) + erf((b + x)/√2σ))² / 4` with the window x off.
#[test]
fn the_window_stands_in_the_middle_of_the_scan() {
    const HALF: f64 = 6_400.0;
    let amplitude = 60.0;
    let everywhere = sinusoid(amplitude);
    let strip = ruled_strip(amplitude, HALF);
    let wi = from_angles_deg(0.0, 0.0);
    let peak = [(wi, outgoing(wi, WAVELENGTH_NM / everywhere.period_nm, 0.0).unwrap())];
    let quarter = strip.size()[0] as isize / 4;
    let share = |off: f64| {
        let part = |x: f64| libm::erf(x / (2f64.sqrt() * SIGMA_NM));
        (0.5 * (part(HALF - off) + part(HALF + off))).powi(2)
    };
    for edge in [Edge::Fade, Edge::Tile] {
        let optics = OpticsConfig { edge, ..optics() };
        let whole = reference(&everywhere.field, &optics, &peak)[0];
        let ratio = |field: &HeightField| {
            let set = tables(field, &optics, 1e-3, Some(SIZE));
            let table = brdf_xyz(&set, Interpolation::Cubic, peak[0].0, peak[0].1)[1];
            [reference(field, &optics, &peak)[0] / whole, table / whole]
        };
        let moved = quarter as f64 * strip.pitch_nm[0];
        for (found, moved) in ratio(&strip).into_iter().zip(ratio(&rolled(&strip, quarter, 0))) {
            // The mirror beside the strip leaks into the order with g(b) d/(2π m) of the amplitude's
            // length 2πσ: 0.28 · 255 nm / 10 µm = 0.7 % over J_1 = 0.6, twice that of the power.
            assert!((found / share(0.0) - 1.0).abs() < 0.025, "{edge:?}: {found} against {}", share(0.0));
            assert!(moved < 0.2 * share(0.0), "{edge:?}: a window a quarter tile off is not seen, {moved}");
        }
        assert!(share(moved) < 0.1 * share(0.0));
    }
}

fn ruled_strip(amplitude: f64, half: f64) -> HeightField {
    let pitch = 80.0;
    sampled([550, ROWS], [pitch, ROW_PITCH_NM], |x, _| {
        // A sine starts and ends at the mirror's level: four periods on either side.
        if x.abs() < half { amplitude * (TAU * x / 1_600.0).sin() } else { 0.0 }
    })
}

/// A surface of two levels so far apart that daylight shows every phase between them: the mirror direction keeps half the light,
/// the mean of `cos²`, at any depth and angle.
#[test]
fn a_surface_of_two_deep_levels_keeps_half_of_its_mirror_image() {
    let optics = OpticsConfig { illuminant: Illuminant::E, ..laser(&[550.0], SIGMA_NM, Edge::Tile, Windows::Grid) };
    let levels = |depth_nm: f64| sampled([16, 4], [100.0, 100.0], |x, _| if x > 0.0 { depth_nm } else { 0.0 });
    let pairs = [10.0, 40.0].map(|theta| (from_angles_deg(theta, 0.0), from_angles_deg(theta, 180.0)));
    let luminance = |depth_nm: f64| -> Vec<f64> {
        brdf_xyz_batch(&[levels(depth_nm)], &optics, &pairs).unwrap().iter().map(|xyz| xyz[1]).collect()
    };
    let flat = luminance(0.0);
    for depth_nm in [20_000.0, 60_000.0] {
        let kept: Vec<f64> = luminance(depth_nm).iter().zip(&flat).map(|(deep, flat)| deep / flat).collect();
        // What is left of a cosine of more than fifty periods over the eye's range, whose ends are dark.
        assert!(kept.iter().all(|kept| (kept - 0.5).abs() < 2e-3), "{depth_nm} nm: {kept:?}");
    }
    // The same in tables: the lobe at normal incidence.
    let normal = |depth_nm: f64| {
        let few = TablesConfig { count: Some(3), ..tables_config(0.1, Some(21)) };
        let set = build(&BuildInput::new(&[levels(depth_nm)], &optics, &few), &|_| ()).unwrap().0;
        lobe_window_power(&set, Interpolation::Bilinear, [0.0, 0.0, -2.0])[1]
    };
    let kept = normal(20_000.0) / normal(0.0);
    assert!((kept - 0.5).abs() < 2e-3, "{kept}");
}
