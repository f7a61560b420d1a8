//! Stability in shape, sampling, light and storage.

use ndarray::Array2;

use super::StabilityCase;
use super::support::{
    BOUND, case, compared, config, error, on_texels, optics, pair_of, refused, relief, scaled, tables,
};
use crate::ground::spectrum::{Illuminant, Line};
use crate::height::HeightField;
use crate::optics::config::OpticsConfig;
use crate::stages::study::stored;
use crate::tables::model::{Basis, Storage, TablesConfig};

pub fn cases() -> Vec<StabilityCase> {
    [surfaces(), unusable(), windows(), lights(), vec![flat(), threads(), halves()], finite_tables()].concat()
}

/// Any scan obeys the same sums: no bound but the tolerance.
fn surfaces() -> Vec<StabilityCase> {
    let at = |size: [usize; 2], depth: f64, h: &dyn Fn(usize, usize) -> f64| {
        scaled(Array2::from_shape_fn((size[1], size[0]), |(row, column)| h(column, row)), [125.0; 2], depth)
    };
    let hash = |x: usize, y: usize| ((x * 7_919 + y * 104_729 + x * y * 31) % 1_009) as f64;
    let list = [
        ("step of 300 nm", at([32, 32], 300.0, &|x, _| f64::from(u8::from(x > 20)))),
        ("ramp of 2 um with its seam", at([32, 32], 2_000.0, &|x, y| (x + 2 * y) as f64)),
        ("white noise", at([32, 32], 300.0, &hash)),
        ("checkerboard at Nyquist, with noise", at([32, 32], 200.0, &|x, y| 900.0 * ((x + y) % 2) as f64 + hash(x, y))),
        ("pixels of 1 : 20", relief([160, 12], [10.0, 200.0], 100.0)),
        ("pitch 10 nm", relief([100, 100], [10.0, 10.0], 50.0)),
    ];
    let note = "95 % error of Y on texels";
    let line = |nm: f64, sigma_nm: f64| {
        let illuminant = Illuminant::Lines(vec![Line { wavelength_nm: nm, power: 1.0 }]);
        OpticsConfig { illuminant, ..optics(sigma_nm) }
    };
    let spike = at([32, 32], 10_000.0, &|x, y| f64::from(u8::from(x == 20 && y == 9)));
    let coarse = relief([32, 32], [1_000.0, 1_000.0], 200.0);
    let mut cases: Vec<_> = list.iter().map(|(name, field)| compared(name, note, field, &optics(800.0))).collect();
    cases.push(compared("spike of 10 um in one sample", note, &spike, &line(532.0, 800.0)));
    // The sampling answers up to |(u, v)| = 0.35 at this wavelength: one ring of the table's texels.
    cases.push(compared("pitch 1 um", note, &coarse, &line(700.0, 8_000.0)));
    cases
}

/// Heights that are no surface are refused, as is what would need more nodes than any machine holds.
fn unusable() -> Vec<StabilityCase> {
    let with = |value: f64| {
        let mut field = relief([16, 16], [125.0; 2], 200.0);
        field.heights_nm[[3, 5]] = value;
        field
    };
    let mut cases: Vec<StabilityCase> =
        [("NaN", f64::NAN), ("infinite", f64::INFINITY), ("1e30 nm", 1e30), ("-1e300 nm", -1e300)]
            .into_iter()
            .flat_map(|(name, value)| {
                [Basis::Chebyshev, Basis::Taylor].map(|basis| {
                    refused(&format!("a height of {name}, {basis:?}"), "0 if refused", &with(value), basis)
                })
            })
            .collect();
    // Negative zero and denormals are heights like any other: nothing changes.
    let mut tiny = relief([32, 32], [125.0; 2], 200.0);
    tiny.heights_nm[[3, 5]] = -0.0;
    tiny.heights_nm[[4, 5]] = f64::MIN_POSITIVE * 0.5;
    cases.push(compared("-0 and denormal heights", "95 % error of Y on texels", &tiny, &optics(800.0)));
    cases
}

/// Windows far smaller and far larger than the scan.
fn windows() -> Vec<StabilityCase> {
    let field = relief([32, 32], [125.0; 2], 200.0);
    let note = "95 % error of Y on texels, tiled scan of 4 um";
    let at = |um: f64| compared(&format!("window of sigma {um} um"), note, &field, &optics(um * 1e3));
    [0.25, 1.0, 6.0, 40.0].into_iter().map(at).collect()
}

fn lights() -> Vec<StabilityCase> {
    let field = relief([32, 32], [125.0; 2], 200.0);
    let with = |illuminant, wavelength_nm| OpticsConfig { illuminant, wavelength_nm, ..optics(800.0) };
    let gap = Illuminant::Tabulated {
        wavelength_nm: vec![420.0, 480.0, 481.0, 599.0, 600.0, 680.0],
        power: vec![1.0, 2.0, 0.0, 0.0, 3.0, 1.0],
    };
    let laser = Illuminant::Lines(vec![Line { wavelength_nm: 532.0, power: 1.0 }]);
    let note = "95 % error of Y on texels";
    vec![
        compared("a laser line", note, &field, &with(laser, [380.0, 780.0])),
        compared("a spectrum with a gap", note, &field, &with(gap, [380.0, 780.0])),
        compared("200 to 2500 nm", note, &field, &with(Illuminant::E, [200.0, 2_500.0])),
    ]
}

/// A flat surface: nothing outside the lobe, to the last bit, and the mirror's peak `4πσ²/λ²` in it.
fn flat() -> StabilityCase {
    let field = HeightField { heights_nm: Array2::zeros((16, 1)), pitch_nm: [125.0, 400.0] };
    let Ok(set) = tables(&field, &optics(800.0), &config(Basis::Chebyshev)) else {
        return case("a constant line of 1 x N samples", "refused", f64::NAN, BOUND);
    };
    let diffuse: f32 = set.tables.iter().flat_map(|t| t.iter()).map(|v| v.abs()).sum();
    let mirror = error(&set, &field, &[2.0, 1.5, 1.0].map(|w| pair_of(0.0, 0.0, w)));
    let note = "diffuse part (exactly 0) and error of the lobe's peak";
    case("a constant line of 1 x N samples", note, f64::from(diffuse) + mirror, BOUND)
}

/// The same bits on one thread and on three.
fn threads() -> StabilityCase {
    let field = relief([32, 32], [125.0; 2], 300.0);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().ok()?;
        pool.install(|| tables(&field, &optics(800.0), &config(Basis::Chebyshev)).ok())
    };
    let (Some(one), Some(three)) = (on(1), on(3)) else {
        return case("one thread and three", "no pool of threads", f64::NAN, 0.0);
    };
    let bits = |set: &crate::tables::model::TableSet| -> Vec<u32> {
        let lobe = set.lobe.iter().flat_map(|l| l.coherent.iter());
        set.tables.iter().flat_map(|t| t.iter()).chain(lobe).map(|v| v.to_bits()).collect()
    };
    let different = bits(&one).iter().zip(&bits(&three)).filter(|(a, b)| a != b).count();
    case("one thread and three", "values whose bits differ", different as f64, 0.0)
}

/// Half floats: 11 bits round each table by 2^-11 at most; coefficients do not cancel, so three times that is
/// ample. Guard: each table is divided by its scale first. Without it a deep lobe overflows: 65504 is the end.
fn halves() -> StabilityCase {
    let field = relief([64, 64], [125.0; 2], 30.0);
    let Ok(set) = tables(&field, &optics(65_000.0), &config(Basis::Chebyshev)) else {
        return case("half storage", "could not be built", f64::NAN, 0.0);
    };
    let halves = stored(&set, Storage::Half);
    let pairs: Vec<_> =
        on_texels(&set, [0.05, 1.0]).into_iter().chain([2.0, 1.0, 0.3].map(|w| pair_of(0.0, 0.0, w))).collect();
    let y = |set: &crate::tables::model::TableSet| -> Vec<f64> {
        let value = |&(wi, wo): &(_, _)| {
            crate::tables::evaluate::brdf_xyz(set, crate::tables::evaluate::Interpolation::Cubic, wi, wo)[1]
        };
        pairs.iter().map(value).collect()
    };
    let mut plain = set.clone();
    let lobe = plain.lobe.iter_mut().map(|lobe| &mut lobe.coherent);
    plain.tables.iter_mut().chain(lobe).for_each(|t| t.mapv_inplace(|v| half::f16::from_f32(v).to_f32()));
    let exact = y(&set);
    let mean = exact.iter().sum::<f64>() / exact.len() as f64;
    let worst = |found: Vec<f64>| {
        let floor = 1e-9 * mean;
        let off = exact.iter().zip(found).filter(|(e, _)| **e > floor).map(|(e, f)| (f / e - 1.0).abs());
        off.fold(0.0, |worst: f64, e| if e.is_nan() { f64::INFINITY } else { worst.max(e) })
    };
    let note = "worst rounding of Y, values down to 1e-9 of the mean";
    let without_guard = Some(worst(y(&plain)));
    StabilityCase { without_guard, ..case("half storage", note, worst(y(&halves)), 3.0 * 2f64.powi(-11)) }
}

/// The smallest table, and the smallest scan. Two samples have all their structure in the line at the sampling's
/// very limit, which the tables leave out as ambiguous, so that values are not compared.
fn finite_tables() -> Vec<StabilityCase> {
    let finite = |name: &str, field: &HeightField, size: usize| {
        let config = TablesConfig { size: Some(size), ..config(Basis::Chebyshev) };
        let sums = tables(field, &optics(800.0), &config)
            .map(|set| set.tables.iter().flat_map(|t| t.iter()).map(|v| f64::from(*v)).sum::<f64>());
        case(name, "0 if finite", f64::from(u8::from(!sums.is_ok_and(f64::is_finite))), 0.0)
    };
    vec![
        finite("a table of 3 x 3 texels", &relief([32, 32], [125.0; 2], 200.0), 3),
        finite("a scan of 2 x 2 samples", &relief([2, 2], [125.0; 2], 200.0), 21),
    ]
}
