//! What the stability cases share: small surfaces, settings, and the error of tables against the direct sum.

use ndarray::Array2;

use super::StabilityCase;
use crate::ground::direction::Vec3;
use crate::ground::error::Result;
use crate::ground::metrics::relative_error_quantiles;
use crate::ground::sampling::four;
use crate::ground::spectrum::Illuminant;
use crate::height::HeightField;
use crate::optics::config::{Edge, Material, OpticsConfig, Windows};
use crate::optics::reference::brdf_xyz_batch;
pub use crate::stages::study::pair_of;
use crate::tables::build::build;
use crate::tables::evaluate::{Interpolation, brdf_xyz};
use crate::tables::model::{Basis, Prefilter, Storage, TableSet, TablesConfig};

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

/// A case that builds tables and compares them on texels; a refusal counts as broken.
pub fn compared(name: &str, note: &str, field: &HeightField, optics: &OpticsConfig) -> StabilityCase {
    let measured = match tables(field, optics, &config(Basis::Chebyshev)) {
        Ok(set) => error(&set, field, &on_texels(&set, [0.05, 1.0])),
        Err(_) => f64::INFINITY,
    };
    case(name, note, measured, BOUND)
}

/// A case without a guard to take out.
pub fn case(name: &str, note: &str, measured: f64, bound: f64) -> StabilityCase {
    StabilityCase { name: name.into(), note: note.into(), measured, bound, without_guard: None }
}

/// A case that must be refused before anything is computed: 0 where it is, 1 where it is not.
pub fn refused(name: &str, note: &str, field: &HeightField, basis: Basis) -> StabilityCase {
    let accepted = tables(field, &optics(600.0), &config(basis)).is_ok();
    case(name, note, f64::from(u8::from(accepted)), 0.0)
}
