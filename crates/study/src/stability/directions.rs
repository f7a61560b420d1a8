//! Stability in direction: grazing, specular, retro-reflected, in the plane and below it.

use serde::{Deserialize, Serialize};

use super::case::StabilityCase;
use super::support::{
    BOUND, Comparison, HALF_AS_MANY, Pair, case, config, on_texels, optics, pair_of, refused, relief, tables,
};
use diffraction_brdf::direction::{Vec3, from_angles_deg, geometry_factor, wave_vector_change};
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz, lobe_window_power, window_power};
use diffraction_brdf::front_factor::FrontFactor;
use diffraction_brdf::material::reflectance;
use diffraction_build::ground::sampling::{Region, direction_pairs};
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::Material;
use diffraction_build::tables::model::{Basis, TableSet};

/// Shares of the reach in `w`: both directions from 60° to 89.99°.
const T: [f64; 8] = [0.5, 0.2, 0.1, 3e-2, 1e-2, 3e-3, 1e-3, 1.7e-4];

/// From here on a table of the undivided power has lost what it should hold.
const PLAIN_FAILS: f64 = 3e-2;

/// Errors at one share of the reach in `w`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct GrazingRow {
    /// `|w| / sqrt(4 - u² - v²)`, `t` in the files.
    #[serde(rename = "t")]
    pub normalised_w: f64,
    /// 95th percentile of the relative error of Y on texels.
    pub divided: f64,
    /// The same if tables held `|P|²` whole, with as many polynomials.
    pub whole: f64,
}

/// Grazing rows, and every case.
pub(crate) fn rows_and_cases() -> (Vec<GrazingRow>, Vec<StabilityCase>) {
    let field = relief([32, 32], [125.0; 2], 150.0);
    let optics = optics(800.0);
    let Ok(set) = tables(&field, &optics, &config(Basis::Chebyshev)) else {
        return (Vec::new(), vec![refused("tables of the directions")]);
    };
    let (rows, mut cases): (Vec<_>, Vec<_>) = T.into_iter().map(|t| grazing(&set, &field, t)).unzip();
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
fn outside(set: &TableSet, t: f64) -> Vec<Pair> {
    let lobe = set.lobe.as_ref().map_or(0.0, |lobe| lobe.radius_max);
    let mut pairs = on_texels(set, [t, t]);
    pairs.retain(|(wi, wo)| (wi[0] + wo[0]).hypot(wi[1] + wo[1]) > lobe);
    pairs
}

/// `w` towards 0: the diffuse part is stored divided by `w²`, so nothing of it is divided by a small number.
fn grazing(set: &TableSet, field: &HeightField, t: f64) -> (GrazingRow, StabilityCase) {
    let found = Comparison::new(set, field, &optics(800.0), outside(set, t));
    let row = GrazingRow { normalised_w: t, divided: found.error(), whole: found.whole(2) };
    let note = "95 % error of Y on texels, basis and wavelengths each within the tolerance";
    let kept = case(&format!("w towards 0, t = {t}"), note, row.divided, BOUND).half(found.half());
    let case = if t > PLAIN_FAILS {
        kept.guarded(HALF_AS_MANY, found.half_as_many())
    } else {
        kept.guarded("tables of the power over w²", row.whole)
    };
    (row, case)
}

/// Light along the normal, the viewer anywhere on texels. Guard: `q` is against the two directions; for any surface that
/// is not its own mirror image, the light goes elsewhere with the other sign.
fn normal(set: &TableSet, field: &HeightField) -> StabilityCase {
    let texel = 4.0 / (set.size() - 1) as f64;
    let inner = set.lobe.as_ref().map_or(0.0, |lobe| lobe.radius_max.min(0.6));
    let side = 4i32;
    let grid = (-side..=side).flat_map(|i| (-side..=side).map(move |j| [f64::from(i) * texel, f64::from(j) * texel]));
    let pairs: Vec<Pair> = grid
        .filter(|[x, y]| (inner..0.99).contains(&x.hypot(*y)))
        .map(|[x, y]| ([0.0, 0.0, 1.0], [x, y, (1.0 - x * x - y * y).sqrt()]))
        .collect();
    let found = Comparison::new(set, field, &optics(800.0), pairs);
    case("normal incidence", "95 % error of Y, viewer on texels", found.error(), BOUND)
        .guarded("the sign of (u, v)", found.misread(&|[u, v, w]| [-u, -v, w]))
}

/// The mirror direction at normal, oblique and grazing incidence: the coherent table is linear in `t` with an
/// error of the tolerance and the tables add theirs. Guard: the lobe has a table of its own; it rises with `1/w²`, which
/// no polynomial holds.
fn lobe(set: &TableSet, field: &HeightField) -> StabilityCase {
    let pairs: Vec<Pair> = [2.0, 1.9, 1.4, 0.7, 0.2, 0.02].map(|w| pair_of(0.0, 0.0, w)).to_vec();
    let found = Comparison::new(set, field, &optics(800.0), pairs);
    case("exact mirror direction", "95 % error of Y, 0° to 89.4°", found.error(), BOUND)
        .guarded("a table of its own for the lobe; polynomials", found.whole(0))
}

/// Inside the mirror's lobe, halfway between texels of the tables. Guard: the lobe has a table of its own; read from
/// the tables' texels by linear interpolation it is cut or spread.
fn lobe_between_texels(set: &TableSet, field: &HeightField) -> StabilityCase {
    let texel = 4.0 / (set.size() - 1) as f64;
    let pairs: Vec<Pair> =
        [0.25, 0.5].iter().flat_map(|&s| [2.0, 1.5, 1.0].map(|w| pair_of(s * texel, 0.0, w))).collect();
    let found = Comparison::new(set, field, &optics(800.0), pairs);
    let on_grid = found.error_of(&|wi, wo| {
        let [u, _, w] = wave_vector_change(wi, wo);
        let [left, right] = [0.0, -texel].map(|u| lobe_window_power(set, Interpolation::Cubic, [u, 0.0, w])[1]);
        let share = u.abs() / texel;
        let rest = window_power(set, Interpolation::Cubic, [u, 0.0, w])[1]
            - lobe_window_power(set, Interpolation::Cubic, [u, 0.0, w])[1];
        set.front_factor.diffuse(wi, wo) * (rest + (1.0 - share) * left + share * right)
    });
    // The lobe carries the light there; what the tables add between their own texels is a few per cent of it.
    case("mirror lobe between texels", "95 % error of Y", found.error(), 5.0 * BOUND)
        .guarded("a table of its own for the lobe; the tables' texels", on_grid)
}

/// Light and viewer at the same grazing angle, opposite azimuths: the mirror direction at 85° and 89.9°, finite and
/// right although both cosines vanish. Guard: the lobe's table holds `|c|²` and is divided by `w²` after the look-up; a
/// table of the quotient begins with a pole.
fn grazing_mirror(set: &TableSet, field: &HeightField) -> StabilityCase {
    let pairs: Vec<Pair> =
        [85.0, 88.0, 89.9].map(|theta| (from_angles_deg(theta, 20.0), from_angles_deg(theta, 200.0))).to_vec();
    let steps = set.lobe.as_ref().map_or(1, |lobe| lobe.coherent.dim().0 - 1) as f64;
    let found = Comparison::new(set, field, &optics(800.0), pairs);
    let of_quotients = found.error_of(&|wi, wo| {
        let at = 0.5 * wave_vector_change(wi, wo)[2].abs() * steps;
        let row = |row: f64| lobe_window_power(set, Interpolation::Bilinear, [0.0, 0.0, 2.0 * row / steps])[1];
        let share = at - at.floor();
        set.front_factor.diffuse(wi, wo) * ((1.0 - share) * row(at.floor()) + share * row(at.floor() + 1.0))
    });
    case("grazing mirror, 85 to 89.9 degrees", "95 % error of Y", found.error(), BOUND)
        .guarded("division by w² after the look-up", of_quotients)
}

/// Directions in the surface and below it reflect nothing, exactly. Guard: they are turned away before the geometry
/// factor divides by their cosines.
fn below(set: &TableSet) -> StabilityCase {
    let up = from_angles_deg(30.0, 10.0);
    let unlit = [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], from_angles_deg(120.0, 45.0), [0.0, 0.0, -1.0], [f64::NAN; 3]];
    let both: Vec<Pair> = unlit.iter().flat_map(|&d| [(up, d), (d, up), (d, d)]).collect();
    let light: f64 = both.iter().map(|&(wi, wo)| brdf_xyz(set, Interpolation::Bilinear, wi, wo)[1].abs()).sum();
    let unguarded = |&(wi, wo): &Pair| {
        let power = window_power(set, Interpolation::Bilinear, wave_vector_change(wi, wo))[1];
        (geometry_factor(wi, wo) * power).abs()
    };
    let finite = both.iter().filter(|(wi, wo)| wi.iter().chain(wo).all(|x| x.is_finite()));
    case("in the plane and below it", "sum of Y, exactly 0", light, 0.0)
        .guarded("only directions above the surface", finite.map(unguarded).fold(0.0, f64::max))
}

/// `q` is symmetric in the two directions: only the order of roundings differs. Guard: reflectance at half the angle
/// between them, which is theirs in common; at the light's own angle of incidence it is not.
fn reciprocity(set: &TableSet) -> StabilityCase {
    let material = Material::Dielectric { n: 1.56 };
    let set = &TableSet { front_factor: FrontFactor { material, ..set.front_factor }, ..set.clone() };
    let pairs = direction_pairs(Region::Hemisphere, 60);
    let worst = |value: &dyn Fn(Vec3, Vec3) -> f64| {
        let differences = pairs.iter().map(|&(wi, wo)| {
            let [a, b] = [value(wi, wo), value(wo, wi)];
            (a - b).abs() / a.abs().max(f64::MIN_POSITIVE)
        });
        differences.fold(0.0, f64::max)
    };
    let own = worst(&|wi, wo| brdf_xyz(set, Interpolation::Cubic, wi, wo)[1]);
    let at_incidence = worst(&|wi, wo| {
        let power = window_power(set, Interpolation::Cubic, wave_vector_change(wi, wo))[1];
        reflectance(material, wi[2]) * geometry_factor(wi, wo) * power
    });
    // Sums of fewer than a hundred products in f64.
    case("reciprocity", "largest relative difference, n = 1.56", own, 1e-13)
        .guarded("reflectance at half the angle between light and view", at_incidence)
}

/// Light returned to its source, up to 80°: on texels, as `q = -2 wi` for `t = 1`, beyond the last node. Guard: as many
/// tables as the depth asks for; two only, and the end of their range is a guess.
fn retro(set: &TableSet, field: &HeightField) -> StabilityCase {
    let found = Comparison::new(set, field, &optics(800.0), on_texels(set, [1.0, 1.0]));
    case("exact retro-reflection", "95 % error of Y, t = 1 on texels", found.error(), BOUND)
        .guarded("as many tables as the depth asks for; two", found.with_tables(2))
}
