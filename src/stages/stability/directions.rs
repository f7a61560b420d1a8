//! Stability in direction: grazing, specular, retro-reflected, in the plane and below it.

use serde::{Deserialize, Serialize};

use super::StabilityCase;
use super::support::{BOUND, case, config, error, half_share, luminance, on_texels, optics, pair_of, relief, tables};
use crate::ground::chebyshev;
use crate::ground::direction::{Vec3, from_angles_deg, geometry_factor, wave_vector_change};
use crate::ground::metrics::relative_error_quantiles;
use crate::height::HeightField;
use crate::optics::reference::{brdf_xyz_batch, prefactor};
use crate::tables::evaluate::{Interpolation, brdf_xyz, lobe_window_power, window_power};
use crate::tables::model::{Basis, TableSet};
use crate::tables::plan::w_reach;

/// Shares of the reach in `w`: both directions from 60° to 89.99°.
const T: [f64; 8] = [0.5, 0.2, 0.1, 3e-2, 1e-2, 3e-3, 1e-3, 1.7e-4];

/// From here on a table of the undivided power has lost what it should hold.
const PLAIN_FAILS: f64 = 1e-2;

/// Errors at one share of the reach in `w`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct GrazingRow {
    /// `|w| / sqrt(4 - u² - v²)`.
    pub t: f64,
    /// 95th percentile of the relative error of Y on texels.
    pub divided: f64,
    /// The same if tables held `|P|²` whole, with as many polynomials.
    pub whole: f64,
}

/// Grazing rows, and every case.
pub fn rows_and_cases() -> (Vec<GrazingRow>, Vec<StabilityCase>) {
    let field = relief([32, 32], [125.0; 2], 150.0);
    let optics = optics(800.0);
    let Ok(set) = tables(&field, &optics, &config(Basis::Chebyshev)) else {
        return (Vec::new(), vec![case("tables of the directions", "could not be built", f64::NAN, 0.0)]);
    };
    let rows: Vec<GrazingRow> = T.into_iter().map(|t| grazing(&set, &field, t)).collect();
    let mut cases: Vec<StabilityCase> = rows.iter().map(|row| grazing_case(&set, row)).collect();
    cases.extend([
        normal(&set, &field),
        lobe(&set, &field),
        lobe_between_texels(&set, &field),
        grazing_mirror(&set, &field),
        below(&set),
        reciprocity(&set),
        retro(&set, &field),
    ]);
    (rows, cases)
}

/// Pairs outside the lobe: its skirts are divided by w² and end where the kernels are cut, at 3e-7 of its peak.
fn outside(set: &TableSet, t: f64) -> Vec<(Vec3, Vec3)> {
    let lobe = set.lobe.as_ref().map_or(0.0, |lobe| lobe.radius_max);
    let mut pairs = on_texels(set, [t, t]);
    pairs.retain(|(wi, wo)| (wi[0] + wo[0]).hypot(wi[1] + wo[1]) > lobe);
    pairs
}

/// `w` towards 0: the diffuse part is stored divided by `w²`, so nothing of it is divided by a small number.
fn grazing(set: &TableSet, field: &HeightField, t: f64) -> GrazingRow {
    let pairs = outside(set, t);
    let exact = brdf_xyz_batch(std::slice::from_ref(field), &set.optics, &pairs).unwrap_or_default();
    let exact: Vec<f64> = exact.iter().map(|xyz| xyz[1]).collect();
    let whole: Vec<f64> = pairs.iter().map(|&(wi, wo)| undivided(set, wi, wo)).collect();
    let floor = 1e-2 * exact.iter().sum::<f64>() / exact.len().max(1) as f64;
    GrazingRow { t, divided: error(set, field, &pairs), whole: relative_error_quantiles(&exact, &whole, floor).p95 }
}

/// Y if as many polynomials in `t` stood for `w²` times the power, as in published tables.
fn undivided(set: &TableSet, wi: Vec3, wo: Vec3) -> f64 {
    let [u, v, w] = wave_vector_change(wi, wo);
    let reach = w_reach(u.hypot(v));
    let count = set.tables.len();
    let weights = chebyshev::interpolation_weights(count, 0.0, 1.0, (w.abs() / reach).min(1.0));
    let nodes = chebyshev::gauss_nodes(count, 0.0, 1.0);
    let power = nodes.iter().zip(&weights).map(|(t, weight)| {
        let w = t * reach;
        weight * w * w * window_power(set, Interpolation::Cubic, [u, v, w])[1]
    });
    prefactor(&set.optics, wi, wo) * power.sum::<f64>() / (w * w)
}

fn grazing_case(set: &TableSet, row: &GrazingRow) -> StabilityCase {
    let note = "95 % error of Y on texels, basis and wavelengths each within the tolerance";
    let kept = case(&format!("w towards 0, t = {}", row.t), note, row.divided, BOUND);
    let kept = StabilityCase { half: Some(half_share(set, &outside(set, row.t))), ..kept };
    if row.t > PLAIN_FAILS { kept } else { kept.guarded("tables of the power over w²", row.whole) }
}

/// Light along the normal, the viewer anywhere on texels.
fn normal(set: &TableSet, field: &HeightField) -> StabilityCase {
    let texel = 4.0 / (set.size() - 1) as f64;
    let inner = set.lobe.as_ref().map_or(0.0, |lobe| lobe.radius_max.min(0.6));
    let side = 4i32;
    let grid = (-side..=side).flat_map(|i| (-side..=side).map(move |j| [f64::from(i) * texel, f64::from(j) * texel]));
    let pairs: Vec<(Vec3, Vec3)> = grid
        .filter(|[x, y]| (inner..0.99).contains(&x.hypot(*y)))
        .map(|[x, y]| ([0.0, 0.0, 1.0], [x, y, (1.0 - x * x - y * y).sqrt()]))
        .collect();
    case("normal incidence", "95 % error of Y, viewer on texels", error(set, field, &pairs), BOUND)
}

/// The mirror direction at normal, oblique and grazing incidence: the coherent table is linear in `t` with an
/// error of the tolerance and the tables add theirs.
fn lobe(set: &TableSet, field: &HeightField) -> StabilityCase {
    let pairs: Vec<(Vec3, Vec3)> = [2.0, 1.9, 1.4, 0.7, 0.2, 0.02].map(|w| pair_of(0.0, 0.0, w)).to_vec();
    case("exact mirror direction", "0° to 89.4°; coherent table and diffuse part", error(set, field, &pairs), BOUND)
}

/// Inside the mirror's lobe, halfway between texels of the tables. Guard: the lobe has a table of its own; read from
/// the tables' texels by linear interpolation it is cut or spread.
fn lobe_between_texels(set: &TableSet, field: &HeightField) -> StabilityCase {
    let texel = 4.0 / (set.size() - 1) as f64;
    let pairs: Vec<(Vec3, Vec3)> =
        [0.25, 0.5].iter().flat_map(|&s| [2.0, 1.5, 1.0].map(|w| pair_of(s * texel, 0.0, w))).collect();
    let exact = luminance(field, set, &pairs);
    let on_grid = |&(wi, wo): &(Vec3, Vec3)| {
        let [u, _, w] = wave_vector_change(wi, wo);
        let [left, right] = [0.0, -texel].map(|u| lobe_window_power(set, Interpolation::Cubic, [u, 0.0, w])[1]);
        let share = u.abs() / texel;
        let rest = window_power(set, Interpolation::Cubic, [u, 0.0, w])[1]
            - lobe_window_power(set, Interpolation::Cubic, [u, 0.0, w])[1];
        prefactor(&set.optics, wi, wo) * (rest + (1.0 - share) * left + share * right)
    };
    let without: Vec<f64> = pairs.iter().map(on_grid).collect();
    // The lobe carries the light there; what the tables add between their own texels is a few per cent of it.
    case("mirror lobe between texels", "95 % error of Y", error(set, field, &pairs), 5.0 * BOUND)
        .guarded("a table of its own for the lobe", relative_error_quantiles(&exact, &without, 0.0).p95)
}

/// Light and viewer at the same grazing angle, opposite azimuths: the mirror direction at 85° and 89.9°, finite and
/// right although both cosines vanish.
fn grazing_mirror(set: &TableSet, field: &HeightField) -> StabilityCase {
    let pairs: Vec<(Vec3, Vec3)> =
        [85.0, 88.0, 89.9].map(|theta| (from_angles_deg(theta, 20.0), from_angles_deg(theta, 200.0))).to_vec();
    case("grazing mirror, 85 to 89.9 degrees", "95 % error of Y", error(set, field, &pairs), BOUND)
}

/// Directions in the surface and below it reflect nothing, exactly. Guard: they are turned away before the geometry
/// factor divides by their cosines.
fn below(set: &TableSet) -> StabilityCase {
    let up = from_angles_deg(30.0, 10.0);
    let dark = [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], from_angles_deg(120.0, 45.0), [0.0, 0.0, -1.0], [f64::NAN; 3]];
    let both: Vec<(Vec3, Vec3)> = dark.iter().flat_map(|&d| [(up, d), (d, up), (d, d)]).collect();
    let light: f64 = both.iter().map(|&(wi, wo)| brdf_xyz(set, Interpolation::Bilinear, wi, wo)[1].abs()).sum();
    let unguarded = |&(wi, wo): &(Vec3, Vec3)| {
        let power = window_power(set, Interpolation::Bilinear, wave_vector_change(wi, wo))[1];
        (geometry_factor(wi, wo) * power).abs()
    };
    let finite = both.iter().filter(|(wi, wo)| wi.iter().chain(wo).all(|x| x.is_finite()));
    case("in the plane and below it", "sum of Y, exactly 0", light, 0.0)
        .guarded("only directions above the surface", finite.map(unguarded).fold(0.0, f64::max))
}

/// `q` is symmetric in the two directions: only the order of roundings differs.
fn reciprocity(set: &TableSet) -> StabilityCase {
    let pairs = on_texels(set, [0.0, 1.0]);
    let worst = pairs.iter().map(|&(wi, wo)| {
        let [a, b] = [(wi, wo), (wo, wi)].map(|(a, b)| brdf_xyz(set, Interpolation::Cubic, a, b)[1]);
        (a - b).abs() / a.abs().max(f64::MIN_POSITIVE)
    });
    // Sums of fewer than a hundred products in f64.
    case("reciprocity", "largest relative difference", worst.fold(0.0, f64::max), 1e-13)
}

/// Light returned to its source, up to 80°: on texels, as `q = -2 wi` for `t = 1`.
fn retro(set: &TableSet, field: &HeightField) -> StabilityCase {
    case("exact retro-reflection", "t = 1 on texels", error(set, field, &on_texels(set, [1.0, 1.0])), BOUND)
}
