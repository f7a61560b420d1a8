//! Stability in depth: from 1 nm to 20 µm peak to valley, `k w h` up to 630 rad.

use std::f64::consts::TAU;

use super::StabilityCase;
use super::support::{BOUND, TOLERANCE, case, config, error, on_texels, optics, refused, relief, tables};
use crate::ground::spectrum::{Illuminant, Line};
use crate::optics::config::OpticsConfig;
use crate::tables::model::{Basis, TablesConfig};
use crate::tables::plan::nodes_bound;
use crate::tables::taylor::forecast;

/// Peak-to-valley depths in nm.
const DEPTHS_NM: [f64; 6] = [1.0, 100.0, 375.0, 1_500.0, 6_000.0, 20_000.0];

pub fn cases() -> Vec<StabilityCase> {
    let mut cases: Vec<StabilityCase> = DEPTHS_NM.into_iter().map(depth).collect();
    cases.push(growth());
    cases.push(refused(
        "published method at 1.5 um",
        "its terms reach 1e14 of their sum: refused, 0 if so",
        &relief([48, 48], [125.0; 2], 1_500.0),
        Basis::Taylor,
    ));
    cases.push(cancellation_forecast());
    cases
}

/// Error of the tables at one depth. Guard: the number of tables follows the depth; without it four are kept,
/// which is enough up to a few hundred nm only.
fn depth(depth_nm: f64) -> StabilityCase {
    let field = relief([32, 32], [125.0; 2], depth_nm);
    // One wavelength shows all there is to a depth; a spectrum would only repeat it, hundreds of times at 20 µm.
    let violet = Illuminant::Lines(vec![Line { wavelength_nm: 400.0, power: 1.0 }]);
    let optics = OpticsConfig { illuminant: violet, ..optics(800.0) };
    let found = |config: &TablesConfig| match tables(&field, &optics, config) {
        Ok(set) => (error(&set, &field, &on_texels(&set, [0.05, 1.0])), set.tables.len()),
        Err(_) => (f64::INFINITY, 0),
    };
    let automatic = config(Basis::Chebyshev);
    let (measured, count) = found(&automatic);
    let without_guard = (depth_nm >= 1_500.0).then(|| found(&TablesConfig { count: Some(4), ..automatic.clone() }).0);
    let note = format!("{count} tables; 95 % error of Y, tolerance {TOLERANCE} each for basis and wavelengths");
    StabilityCase { without_guard, ..case(&format!("depth {depth_nm} nm"), &note, measured, BOUND) }
}

/// Nodes needed in depth: `J_n(z)` dies off beyond `n = z + O(z^{1/3})` with `z` half the phase range, so from
/// 2 to 20 µm the number grows by at most ten, and by at least half of that.
fn growth() -> StabilityCase {
    let ratio = nodes_bound(10_000.0, 380.0, 1e-3) as f64 / nodes_bound(1_000.0, 380.0, 1e-3) as f64;
    case("number of tables, 2 to 20 um", "ratio of the bounds; linear growth means at most 10", ratio, 10.0)
}

/// The forecast of cancellation against the closed form: heights of two levels `d` apart, half each, lose
/// `log10((1 + exp(s d)) / 2)` digits; the histogram rounds `d` up by at most one part in 512.
fn cancellation_forecast() -> StabilityCase {
    let heights = ndarray::Array2::from_shape_fn((8, 8), |(row, _)| (row % 2) as f64);
    let s_max = 2.0 * TAU / 380.0;
    let depth_nm = 1_500.0;
    let field = super::support::scaled(heights, [125.0; 2], depth_nm);
    let expected = (0.5 * (1.0 + (s_max * depth_nm).exp())).log10();
    let found = forecast(&[field], s_max, TOLERANCE).digits_lost;
    let bound = s_max * depth_nm / 512.0 / std::f64::consts::LN_10;
    case("forecast of lost digits", "against the closed form of a step", (found - expected).abs(), bound)
}
