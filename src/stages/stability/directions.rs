//! Stability in direction: grazing, specular, retro-reflected, in the plane and below it.

use super::StabilityCase;
use super::support::{BOUND, case, config, error, on_texels, optics, pair_of, relief, tables};
use crate::ground::direction::{Vec3, from_angles_deg};
use crate::height::HeightField;
use crate::tables::evaluate::{Interpolation, brdf_xyz};
use crate::tables::model::{Basis, TableSet};

pub fn cases() -> Vec<StabilityCase> {
    let field = relief([32, 32], [125.0; 2], 150.0);
    let optics = optics(800.0);
    let Ok(set) = tables(&field, &optics, &config(Basis::Chebyshev)) else {
        return vec![case("tables of the directions", "could not be built", f64::NAN, 0.0)];
    };
    let mut cases: Vec<StabilityCase> =
        [1e-1, 1e-2, 1e-3, 1.7e-4].into_iter().map(|t| grazing(&set, &field, t)).collect();
    cases.extend([lobe(&set, &field), below(&set), reciprocity(&set), retro(&set, &field)]);
    cases
}

/// `w` towards 0, down to both directions at 89.99°: the diffuse part is stored divided by `w²`, so nothing of it
/// is divided by a small number.
fn grazing(set: &TableSet, field: &HeightField, t: f64) -> StabilityCase {
    // The mirror lobe's own skirts are divided by w² and end where the kernels are cut, at 3e-7 of its peak.
    let lobe = set.lobe.as_ref().map_or(0.0, |lobe| lobe.radius_max);
    let outside = |(wi, wo): &(Vec3, Vec3)| (wi[0] + wo[0]).hypot(wi[1] + wo[1]) > lobe;
    let pairs: Vec<(Vec3, Vec3)> = on_texels(set, [t, t]).into_iter().filter(outside).collect();
    let measured = error(set, field, &pairs);
    let note = "95 % error of Y on texels, basis and wavelengths each within the tolerance";
    case(&format!("w towards 0, t = {t}"), note, measured, BOUND)
}

/// The mirror direction at normal, oblique and grazing incidence: the coherent table is linear in `t` with an
/// error of the tolerance and the tables add theirs.
fn lobe(set: &TableSet, field: &HeightField) -> StabilityCase {
    let pairs: Vec<(Vec3, Vec3)> = [2.0, 1.9, 1.4, 0.7, 0.2, 0.02].map(|w| pair_of(0.0, 0.0, w)).to_vec();
    case("exact mirror direction", "0° to 89.4°; coherent table and diffuse part", error(set, field, &pairs), BOUND)
}

/// Directions in the surface and below it reflect nothing, exactly.
fn below(set: &TableSet) -> StabilityCase {
    let up = from_angles_deg(30.0, 10.0);
    let dark = [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], from_angles_deg(120.0, 45.0), [0.0, 0.0, -1.0], [f64::NAN; 3]];
    let both = dark.iter().flat_map(|&d| [(up, d), (d, up), (d, d)]);
    let light: f64 = both.map(|(wi, wo)| brdf_xyz(set, Interpolation::Bilinear, wi, wo)[1].abs()).sum();
    case("in the plane and below it", "sum of Y, exactly 0", light, 0.0)
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
