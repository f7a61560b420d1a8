//! Stability in shape and sampling: steps, spikes, noise, odd scans and pitches, heights that are none.

use std::f64::consts::TAU;

use ndarray::Array2;

use super::StabilityCase;
use super::support::{
    BOUND, build_error, case, compared, config, error, laser, on_row, optics, pair_of, relief, scaled, tables,
};
use crate::ground::direction::{from_angles_deg, wave_vector_change};
use crate::height::HeightField;
use crate::optics::spectra::bandwidth_nm;
use crate::tables::evaluate::{Interpolation, window_power};
use crate::tables::model::{Basis, TablesConfig};

pub fn cases() -> Vec<StabilityCase> {
    [surfaces(), pitches(), unusable(), vec![not_numbers(), flat(), line(), nyquist()], finite_tables()].concat()
}

/// Any scan obeys the same sums: no bound but the tolerance.
fn surfaces() -> Vec<StabilityCase> {
    let at = |depth: f64, h: &dyn Fn(usize, usize) -> f64| {
        scaled(Array2::from_shape_fn((32, 32), |(row, column)| h(column, row)), [125.0; 2], depth)
    };
    let hash = |x: usize, y: usize| ((x * 7_919 + y * 104_729 + x * y * 31) % 1_009) as f64;
    let list = [
        ("step of 300 nm", at(300.0, &|x, _| f64::from(u8::from(x > 20)))),
        ("ramp of 2 um with its seam", at(2_000.0, &|x, y| (x + 2 * y) as f64)),
        ("white noise", at(300.0, &hash)),
        ("checkerboard at Nyquist, with noise", at(200.0, &|x, y| 900.0 * ((x + y) % 2) as f64 + hash(x, y))),
        ("pixels of 1 : 20", relief([160, 12], [10.0, 200.0], 100.0)),
    ];
    let note = "95 % error of Y on texels";
    let mut cases: Vec<_> = list.iter().map(|(name, field)| compared(name, note, field, &optics(800.0))).collect();
    // Guard: the nodes in depth follow from peak to valley; counted from the rms height of 310 nm they are too few.
    let spike = at(10_000.0, &|x, y| f64::from(u8::from(x == 20 && y == 9)));
    let light = laser(532.0, 800.0);
    let few = TablesConfig { count: Some(6), ..config(Basis::Chebyshev) };
    let [without, _] = build_error(&spike, &light, &few);
    let spike = compared("spike of 10 um in one sample", note, &spike, &light);
    cases.push(spike.guarded("tables for the whole range, not for the rms height", without));
    cases
}

/// From 1 nm to 1 µm between samples.
fn pitches() -> Vec<StabilityCase> {
    let note = "95 % error of Y on texels";
    let coarse = relief([32, 32], [1_000.0, 1_000.0], 200.0);
    vec![
        one_row("pitch 1 nm", &relief([4_096, 1], [1.0, 4_096.0], 100.0)),
        compared("pitch 10 nm", note, &relief([100, 100], [10.0, 10.0], 50.0), &optics(800.0)),
        // The sampling answers up to |(u, v)| = 0.35 at this wavelength: one ring of the table's texels.
        compared("pitch 1 um", note, &coarse, &laser(700.0, 8_000.0)),
    ]
}

/// A field with one sample replaced.
fn with(value: f64) -> HeightField {
    let mut field = relief([16, 16], [125.0; 2], 200.0);
    field.heights_nm[[3, 5]] = value;
    field
}

/// Heights that would need more nodes than any machine holds are refused, in no time. Guard: the refusal; without it
/// the phase range alone, half of which is the fewest nodes, asks for the memory given.
fn unusable() -> Vec<StabilityCase> {
    let mut cases = Vec::new();
    for (name, value) in [("1e30 nm", 1e30), ("-1e300 nm", -1e300), ("1 m", 1e9)] {
        for basis in [Basis::Chebyshev, Basis::Taylor] {
            let field = with(value);
            let config = config(basis);
            let accepted = tables(&field, &optics(600.0), &config).is_ok();
            // Lines of the tile of 2 µm within 2/λ, times the nodes, times a complex float.
            let nodes = 0.5 * bandwidth_nm(&field) * 2.0 * TAU / 380.0;
            let share = nodes * 16.0 * 16.0 * 8.0 / ((config.memory_mib as f64) * (1 << 20) as f64);
            let note = "memory taken over memory allowed: none where it is refused";
            cases.push(
                case(&format!("a height of {name}, {basis:?}"), note, if accepted { share } else { 0.0 }, 1.0)
                    .guarded("refusal", share),
            );
        }
    }
    // Negative zero and denormals are heights like any other: nothing changes.
    let mut tiny = relief([32, 32], [125.0; 2], 200.0);
    tiny.heights_nm[[3, 5]] = -0.0;
    tiny.heights_nm[[4, 5]] = f64::MIN_POSITIVE * 0.5;
    cases.push(compared("-0 and denormal heights", "95 % error of Y on texels", &tiny, &optics(800.0)));
    cases
}

/// Heights that are no numbers are refused. Guard: the refusal; a single one makes every sum no number.
fn not_numbers() -> StabilityCase {
    let values = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    let accepted = values
        .into_iter()
        .flat_map(|value| [Basis::Chebyshev, Basis::Taylor].map(|basis| (value, basis)))
        .filter(|&(value, basis)| tables(&with(value), &optics(600.0), &config(basis)).is_ok())
        .count();
    let pair = (from_angles_deg(20.0, 0.0), from_angles_deg(40.0, 90.0));
    let summed = values.into_iter().filter(|&value| {
        let sum = crate::optics::reference::brdf_xyz(&[with(value)], &optics(600.0), pair.0, pair.1);
        sum.is_ok_and(|xyz| xyz[1].is_nan())
    });
    case("heights of NaN and infinity", "scans accepted, of both bases", accepted as f64, 0.0)
        .guarded("refusal; sums that are no number", summed.count() as f64)
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

/// One row of samples: light on one row of texels alone.
fn line() -> StabilityCase {
    one_row("a relief of N x 1 samples", &relief([64, 1], [60.0, 3_840.0], 150.0))
}

fn one_row(name: &str, field: &HeightField) -> StabilityCase {
    let measured = match tables(field, &optics(1_500.0), &config(Basis::Chebyshev)) {
        Ok(set) => error(&set, field, &on_row(&set, [0.1, 1.0])),
        Err(_) => f64::INFINITY,
    };
    case(name, "95 % error of Y on the row of texels that has light", measured, BOUND)
}

/// Beyond the frequencies that the sampling holds there is no light, exactly. Guard: lines past that limit are left
/// out; a sum over the samples repeats there what lies below it.
fn nyquist() -> StabilityCase {
    let field = relief([32, 32], [600.0; 2], 200.0);
    let optics = laser(532.0, 4_000.0);
    let Ok(set) = tables(&field, &optics, &config(Basis::Chebyshev)) else {
        return case("beyond the sampling's limit", "refused", f64::NAN, 0.0);
    };
    // The limit lies at |u| = 0.5 · 532 / 600 = 0.44; the lobes are 0.02 wide.
    let directions = [0.6, 0.7, 0.8].map(|u| pair_of(u, 0.2, 1.5));
    let light = |&(wi, wo): &(_, _)| window_power(&set, Interpolation::Bilinear, wave_vector_change(wi, wo))[1];
    let beyond: f64 = directions.iter().map(light).sum();
    let alias = [0.6, 0.7, 0.8].map(|u: f64| u - 532.0 / 600.0).map(|u| pair_of(u, 0.2, 1.5));
    case("beyond the sampling's limit", "sum of the tables' values, exactly 0", beyond, 0.0)
        .guarded("no lines past the limit; their aliases", alias.iter().map(light).sum())
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
