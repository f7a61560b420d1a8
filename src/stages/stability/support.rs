//! What the stability cases share: small surfaces, settings, and the error of tables against the direct sum.

use ndarray::Array2;

use super::StabilityCase;
use crate::ground::chebyshev::shifted_values;
use crate::ground::direction::{Vec3, wave_vector_change};
use crate::ground::error::Result;
use crate::ground::metrics::relative_error_quantiles;
use crate::ground::sampling::four;
use crate::ground::spectrum::{Illuminant, Line};
use crate::height::HeightField;
use crate::optics::config::{Edge, Material, OpticsConfig, Windows};
use crate::optics::reference::{brdf_xyz_batch, prefactor};
pub use crate::stages::study::pair_of;
use crate::stages::study::stored;
use crate::tables::build::build;
use crate::tables::evaluate::{Interpolation, brdf_xyz};
use crate::tables::model::{Basis, Prefilter, Storage, TableSet, TablesConfig};
use crate::tables::plan::w_reach;
use crate::tables::storage::half_scale;

/// Tolerance of every build of the suite.
pub const TOLERANCE: f64 = 1e-2;

/// Bound of the 95th percentile of the error on texels: basis and wavelengths may each take the tolerance.
pub const BOUND: f64 = 2.0 * TOLERANCE;

/// Directions compared per case.
const DIRECTIONS: usize = 60;

/// Samples of a smooth periodic relief of the wanted peak-to-valley depth, centred.
pub fn relief(size: [usize; 2], pitch_nm: [f64; 2], depth_nm: f64) -> HeightField {
    let wave = |index: usize, x: f64, y: f64| {
        let (a, b) = ((index % 4) as f64 + 1.0, (index % 5) as f64 - 2.0);
        (std::f64::consts::TAU * (a * x + b * y) + (index * index) as f64).sin()
    };
    let heights = Array2::from_shape_fn((size[1], size[0]), |(row, column)| {
        let (x, y) = (column as f64 / size[0] as f64, row as f64 / size[1] as f64);
        (0..12).map(|index| wave(index, x, y)).sum::<f64>()
    });
    scaled(heights, pitch_nm, depth_nm)
}

/// A field from heights in any unit, centred and scaled to a peak-to-valley depth.
pub fn scaled(heights: Array2<f64>, pitch_nm: [f64; 2], depth_nm: f64) -> HeightField {
    let (low, high) = heights.iter().fold((f64::MAX, f64::MIN), |(low, high), &h| (low.min(h), high.max(h)));
    let factor = if high > low { depth_nm / (high - low) } else { 0.0 };
    HeightField { heights_nm: heights.mapv(|h| (h - 0.5 * (low + high)) * factor), pitch_nm }
}

/// Standard deviation in nm of the window where a case only needs lines.
pub const WAVE_SIGMA_NM: f64 = 800.0;

/// As [`optics`], lit by one laser line.
pub fn laser(wavelength_nm: f64, sigma_nm: f64) -> OpticsConfig {
    let illuminant = Illuminant::Lines(vec![Line { wavelength_nm, power: 1.0 }]);
    OpticsConfig { illuminant, ..optics(sigma_nm) }
}

/// Daylight on the periodically repeated scan, averaged over all window positions.
pub fn optics(sigma_nm: f64) -> OpticsConfig {
    OpticsConfig {
        illuminant: Illuminant::D65,
        wavelength_nm: [380.0, 780.0],
        sigma_nm,
        edge: Edge::Tile,
        windows: Windows::Grid,
        material: Material::Ideal,
        shadowing: false,
    }
}

/// Small float tables.
pub fn config(basis: Basis) -> TablesConfig {
    TablesConfig {
        basis,
        tolerance: TOLERANCE,
        size: Some(21),
        count: None,
        wavelength_step_nm: None,
        storage: Storage::Float,
        prefilter: Prefilter::None,
        memory_mib: 1024,
    }
}

/// Tables of one scan.
pub fn tables(field: &HeightField, optics: &OpticsConfig, config: &TablesConfig) -> Result<TableSet> {
    Ok(build(std::slice::from_ref(field), optics, config, &|_| ())?.0)
}

/// Directions on texels, `t` between the two limits, so that no interpolation on the grid enters.
pub fn on_texels(set: &TableSet, t_range: [f64; 2]) -> Vec<(Vec3, Vec3)> {
    let texel = 4.0 / (set.size() - 1) as f64;
    // The middle of the lobe belongs to its own table, which is not on these texels.
    let nearest = set.lobe.as_ref().map_or(0.0, |lobe| lobe.radius_max.min(0.6));
    (0..4_000)
        .map(|index| {
            let [a, b, c, _] = four(index);
            let [u, v] = [a, b].map(|share| ((share - 0.5) * 4.0 / texel).round() * texel);
            (u, v, t_range[0] + (t_range[1] - t_range[0]) * c)
        })
        .filter(|(u, v, _)| (nearest..set.usable_radius.min(1.99)).contains(&u.hypot(*v)))
        .take(DIRECTIONS)
        .map(|(u, v, t)| pair_of(u, v, t * (4.0 - u * u - v * v).sqrt()))
        .collect()
}

/// Directions on the row of texels at `v = 0`, where a surface without structure along y sends its light, from the
/// second texel on.
pub fn on_row(set: &TableSet, t_range: [f64; 2]) -> Vec<(Vec3, Vec3)> {
    let texel = 4.0 / (set.size() - 1) as f64;
    let columns = (2..set.size() as i32 / 2).flat_map(|i| [f64::from(-i) * texel, f64::from(i) * texel]);
    columns
        .filter(|u| u.abs() < 1.9)
        .flat_map(|u| [0.0, 0.3, 0.7, 1.0].map(|share| (u, t_range[0] + (t_range[1] - t_range[0]) * share)))
        .map(|(u, t)| pair_of(u, 0.0, t * (4.0 - u * u).sqrt()))
        .collect()
}

/// 95th percentile of the relative error of Y above 1 % of the mean. NaN anywhere makes it NaN; nothing to
/// compare makes it infinite, because such a case would prove nothing.
pub fn error(set: &TableSet, field: &HeightField, pairs: &[(Vec3, Vec3)]) -> f64 {
    let Ok(reference) = brdf_xyz_batch(std::slice::from_ref(field), &set.optics, pairs) else { return f64::NAN };
    let exact: Vec<f64> = reference.iter().map(|xyz| xyz[1]).collect();
    let found: Vec<f64> = pairs.iter().map(|&(wi, wo)| brdf_xyz(set, Interpolation::Cubic, wi, wo)[1]).collect();
    let mean = exact.iter().sum::<f64>() / exact.len().max(1) as f64;
    if found.iter().chain(&exact).any(|f| !f.is_finite()) {
        return f64::NAN;
    }
    let quantiles = relative_error_quantiles(&exact, &found, 1e-2 * mean);
    if quantiles.count < 3 { f64::INFINITY } else { quantiles.p95 }
}

/// Y of the direct sum for each pair; empty where it cannot be summed.
pub fn luminance(field: &HeightField, set: &TableSet, pairs: &[(Vec3, Vec3)]) -> Vec<f64> {
    let reference = brdf_xyz_batch(std::slice::from_ref(field), &set.optics, pairs).unwrap_or_default();
    reference.iter().map(|xyz| xyz[1]).collect()
}

/// Largest deviation of Y from tables stored as halves, over what rounding allows: each coefficient at its texel moves
/// by at most 2^-11 of itself, or half a step of the subnormal numbers under the table's scale, 2^-25 of it. Anything
/// beyond is an overflow, or a value flushed away that shows. The sum is kept in doubles. Pairs lie on texels.
pub fn half_share(set: &TableSet, pairs: &[(Vec3, Vec3)]) -> f64 {
    let halves = stored(set, Storage::Half);
    let scales: Vec<f64> = set
        .tables
        .iter()
        .map(|table| f64::from(half_scale(table.iter().fold(0.0f32, |peak, v| peak.max(v.abs())))))
        .collect();
    let last = (set.size() - 1) as f64;
    let share = |&(wi, wo): &(Vec3, Vec3)| {
        let q = wave_vector_change(wi, wo);
        let [row, column] = [(2.0 - q[1]) / 4.0 * last, (q[0] + 2.0) / 4.0 * last].map(|x| x.round() as usize);
        let t = (q[2].abs() / w_reach(q[0].hypot(q[1])).max(f64::MIN_POSITIVE)).min(1.0);
        let basis = shifted_values(set.tables.len(), t);
        let moved = set.tables.iter().zip(&scales).zip(&basis).map(|((table, scale), basis)| {
            basis.abs() * (2f64.powi(-11) * f64::from(table[[row, column, 1]].abs()) + 2f64.powi(-25) * scale)
        });
        // The texel's position is found to 2^-50; a neighbour enters with that weight.
        let allowed = prefactor(&set.optics, wi, wo) * moved.sum::<f64>() * (1.0 + 1e-6);
        let [exact, found] = [set, &halves].map(|set| brdf_xyz(set, Interpolation::Cubic, wi, wo)[1]);
        let off = (found - exact).abs();
        if off.is_nan() {
            f64::INFINITY
        } else if off <= 1e-12 * exact.abs() {
            0.0
        } else {
            off / allowed
        }
    };
    pairs.iter().map(share).fold(0.0, f64::max)
}

/// The error of one build on texels; infinite where it was refused. And half storage.
pub fn build_error(field: &HeightField, optics: &OpticsConfig, config: &TablesConfig) -> [f64; 2] {
    match tables(field, optics, config) {
        Ok(set) => {
            let pairs = on_texels(&set, [0.05, 1.0]);
            [error(&set, field, &pairs), half_share(&set, &pairs)]
        }
        Err(_) => [f64::INFINITY; 2],
    }
}

/// A case that builds tables and compares them on texels; a refusal counts as broken.
pub fn compared(name: &str, note: &str, field: &HeightField, optics: &OpticsConfig) -> StabilityCase {
    let [measured, half] = build_error(field, optics, &config(Basis::Chebyshev));
    StabilityCase { half: Some(half), ..case(name, note, measured, BOUND) }
}

/// A case without a guard to take out.
pub fn case(name: &str, note: &str, measured: f64, bound: f64) -> StabilityCase {
    StabilityCase { name: name.into(), note: note.into(), measured, bound, guard: None, half: None }
}
