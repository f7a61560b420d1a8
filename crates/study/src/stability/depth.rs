//! Stability in depth: from 1 nm to 20 µm peak to valley, `k w h` up to 630 rad.

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

use super::case::StabilityCase;
use super::series;
use super::support::{
    BOUND, Comparison, HALF_AS_MANY, TOLERANCE, case, config, laser, on_texels, optics, refused, relief, scaled, tables,
};
use diffraction_brdf::chebyshev::{Interpolant, nodes_for_exponential};
use diffraction_build::tables::forecast;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Basis, TablesConfig};
use diffraction_build::tables::resolution::nodes_bound;
use diffraction_build::tables::taylor;

/// Peak-to-valley depths in nm.
const DEPTHS_NM: [f64; 7] = [1.0, 100.0, 375.0, 1_500.0, 3_000.0, 6_000.0, 20_000.0];

/// Depth in nm from which there are tables enough for the undivided power too.
const DIVIDED_SHOWS_NM: f64 = 10.0;

/// Depth in nm from which four tables are too few.
const FOUR_FAIL_NM: f64 = 375.0;

/// Wavelength of the laser in nm: one shows all there is to a depth; a spectrum would only repeat it, hundreds of
/// times at 20 µm.
const VIOLET_NM: f64 = 400.0;

/// What one depth took.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct DepthRow {
    /// Peak to valley in nm.
    pub depth_nm: f64,
    /// Tables that the tolerance took; 0 where the depth was refused.
    pub tables: usize,
    /// Transforms that it took.
    pub transforms: usize,
    /// 95th percentile of the relative error of Y on texels.
    pub error: f64,
    /// The same with four tables whatever the depth.
    pub four_tables: f64,
    /// Half storage, see `StabilityCase::half`.
    pub half: f64,
}

/// Every depth with automatic settings, and with four tables.
pub(crate) fn rows_and_cases() -> (Vec<DepthRow>, Vec<StabilityCase>) {
    DEPTHS_NM.into_iter().map(depth).unzip()
}

/// The error at one depth. Guards: the number of tables follows the depth, four are enough up to a few hundred nm only;
/// and so few as a shallow surface needs cannot hold the power before it is divided by `w²`.
fn depth(depth_nm: f64) -> (DepthRow, StabilityCase) {
    let field = relief([32, 32], [125.0; 2], depth_nm);
    let optics = laser(VIOLET_NM, 800.0);
    let transforms = nodes_for_exponential(0.5 * depth_nm, 2.0 * TAU / VIOLET_NM, 1e-3 * TOLERANCE);
    let name = format!("depth {depth_nm} nm");
    let none = f64::INFINITY;
    let row = DepthRow { depth_nm, tables: 0, transforms, error: none, four_tables: none, half: none };
    let Ok(set) = tables(&field, &optics, &config(Basis::Chebyshev)) else { return (row, refused(&name)) };
    let found = Comparison::new(&set, &field, &optics, on_texels(&set, [0.05, 1.0]));
    let (error, four_tables, half) = (found.error(), found.with_tables(4), found.half());
    let row = DepthRow { tables: set.tables.len(), error, four_tables, half, ..row };
    let note = format!("{} tables; 95 % error of Y, tolerance {TOLERANCE} each for basis and wavelengths", row.tables);
    let kept = case(&name, &note, error, BOUND).half(half);
    let case = if depth_nm < DIVIDED_SHOWS_NM {
        kept.guarded("tables of the power over w²", found.whole(2))
    } else if depth_nm < FOUR_FAIL_NM {
        kept.guarded(HALF_AS_MANY, found.half_as_many())
    } else {
        kept.guarded("as many tables as the depth asks for; four", four_tables)
    };
    (row, case)
}

pub fn cases() -> Vec<StabilityCase> {
    vec![growth(), centring(), refused_series(), cancellation_forecast(), memory()]
}

/// Nodes needed in depth: `J_n(z)` dies off beyond `n = z + O(z^{1/3})` with `z` half the phase range, so from
/// 2 to 20 µm the number grows by at most ten, and so does what is stored, in halves whatever the depth. Guard: a basis
/// without cancellation; powers of `w` are as many times more, each with all the digits that cancel.
fn growth() -> StabilityCase {
    let ratio = nodes_bound(10_000.0, 380.0, 1e-3) as f64 / nodes_bound(1_000.0, 380.0, 1e-3) as f64;
    let bits = |depth_nm: f64| {
        let series = taylor::forecast(&[relief([32, 32], [125.0; 2], depth_nm)], 2.0 * TAU / 380.0, 1e-3);
        series.terms as f64 * (11.0 + series.digits_lost * std::f64::consts::LOG2_10)
    };
    let note = "bits stored per texel, 20 um over 2 um; linear growth means at most 10";
    case("growth from 2 to 20 um", note, ratio, 10.0)
        .guarded("polynomials that do not cancel; powers of w", bits(20_000.0) / bits(2_000.0))
}

/// A level far from zero: phases count from mid-range. Guard: without that the nodes, which are counted for the range
/// alone, miss the phasor `exp(i s h)` of the level itself.
fn centring() -> StabilityCase {
    let (low, optics) = (relief([32, 32], [125.0; 2], 200.0), optics(800.0));
    let mut high = low.clone();
    high.heights_nm += 1e6;
    let difference =
        match (tables(&low, &optics, &config(Basis::Chebyshev)), tables(&high, &optics, &config(Basis::Chebyshev))) {
            (Ok(low), Ok(high)) => {
                let peak = low.tables.iter().flatten().fold(0.0f32, |peak, v| peak.max(v.abs()));
                let off = low.tables.iter().flatten().zip(high.tables.iter().flatten()).map(|(a, b)| (a - b).abs());
                f64::from(off.fold(0.0, f32::max) / peak)
            }
            _ => f64::INFINITY,
        };
    let s_max = 2.0 * TAU / 380.0;
    let interpolant = Interpolant::new(nodes_for_exponential(100.0, s_max, 1e-5), 0.0, s_max);
    let s = 0.37 * s_max;
    let weights = interpolant.weights(s);
    let raw: f64 = interpolant.nodes().iter().zip(&weights).map(|(node, weight)| weight * (node * 1e6).cos()).sum();
    // Heights carry 52 bits: 1e6 nm leaves 1e-10 nm, 1e-12 rad; sums are kept in 24 bits.
    case("level of 1 mm", "largest difference of a table's value over its peak, against level 0", difference, 1e-5)
        .guarded("heights from mid-range", (raw - (s * 1e6).cos()).abs())
}

/// The published series at 1.5 µm: its terms reach 1e14 of their sum. Guard: it is refused, naming that; summed all
/// the same, its error is beyond any use.
fn refused_series() -> StabilityCase {
    let depth_nm = 1_500.0;
    let accepted = tables(&relief([48, 48], [125.0; 2], depth_nm), &optics(600.0), &config(Basis::Taylor)).is_ok();
    let summed = series::row(depth_nm).errors[1];
    let measured = if accepted { summed } else { 0.0 };
    let note = "error of the tables handed out: none where the series is refused, at most 10 % where it is not";
    case("published method at 1.5 um", note, measured, taylor::CATASTROPHE).guarded("refusal", summed)
}

/// The forecast of cancellation against the closed form: heights of two levels `d` apart, half each, lose
/// `log10(cosh(s d))` digits; the histogram rounds `d` up by at most one part in 512.
fn cancellation_forecast() -> StabilityCase {
    let heights = ndarray::Array2::from_shape_fn((8, 8), |(row, _)| (row % 2) as f64);
    let s_max = 2.0 * TAU / 380.0;
    let depth_nm = 1_500.0;
    let field = scaled(heights, [125.0; 2], depth_nm);
    let expected = (s_max * depth_nm).cosh().log10();
    let found = taylor::forecast(&[field], s_max, TOLERANCE).digits_lost;
    let bound = s_max * depth_nm / 512.0 / std::f64::consts::LN_10;
    // The worst pair of heights alone, as if every pair were that far apart, overstates the loss by log10(2).
    case("forecast of lost digits", "against the closed form of a step", (found - expected).abs(), bound)
        .guarded("mean over all pairs of heights", (s_max * depth_nm / std::f64::consts::LN_10 - expected).abs())
}

/// A depth whose transforms do not fit the memory allowed is refused before any is computed. Guard: the refusal;
/// without it the build takes what the forecast says.
fn memory() -> StabilityCase {
    let field = relief([256, 256], [125.0; 2], 20_000.0);
    let (optics, config) = (optics(8_000.0), TablesConfig { memory_mib: 16, ..config(Basis::Chebyshev) });
    let accepted = tables(&field, &optics, &config).is_ok();
    let roomy = TablesConfig { memory_mib: 1 << 16, ..config };
    let predicted =
        forecast::forecast(&BuildInput::new(&[field], &optics, &roomy), 1).map_or(f64::NAN, |f| f.memory_bytes as f64);
    let share = predicted / (16 << 20) as f64;
    let note = "memory taken over memory allowed: none where it is refused";
    case("20 um within 16 MiB", note, if accepted { share } else { 0.0 }, 1.0).guarded("refusal", share)
}
