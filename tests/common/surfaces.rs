//! Surfaces with known answers, plain settings, and directions by (u, v).

use std::f64::consts::TAU;

use diffraction_brdf::direction::Vec3;
use diffraction_brdf::spectrum::{Illuminant, Line};
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
use diffraction_build::tables::build::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Basis, Prefilter, Storage, TableSet, TablesConfig};
use ndarray::{Array2, Axis, Slice};

/// Laser light of equal luminance weights on these wavelengths; XYZ's Y is then the BRDF itself where
/// there is one line.
pub fn laser(wavelengths_nm: &[f64], sigma_nm: f64, edge: Edge, windows: Windows) -> OpticsConfig {
    OpticsConfig::ideal(
        Illuminant::Lines(wavelengths_nm.iter().map(|&wavelength_nm| Line { wavelength_nm, power: 1.0 }).collect()),
        sigma_nm,
        edge,
        windows,
    )
}

/// Every way of placing windows.
pub const PLACEMENTS: [(Edge, Windows); 4] = [
    (Edge::Fade, Windows::Centre),
    (Edge::Fade, Windows::Grid),
    (Edge::Tile, Windows::Centre),
    (Edge::Tile, Windows::Grid),
];

/// Point-sampled tables of a given size, in floats.
pub fn tables_config(tolerance: f64, size: Option<usize>) -> TablesConfig {
    TablesConfig {
        basis: Basis::Chebyshev,
        tolerance,
        size,
        count: None,
        wavelength_step_nm: None,
        storage: Some(Storage::Float),
        prefilter: Prefilter::None,
        memory_mib: 8192,
    }
}

/// Tables of one scan.
pub fn tables(field: &HeightField, optics: &OpticsConfig, tolerance: f64, size: Option<usize>) -> TableSet {
    build(&BuildInput::new(std::slice::from_ref(field), optics, &tables_config(tolerance, size)), &|_| ()).unwrap().0
}

/// Samples `height(x, y)` in nm; (0, 0) is the middle of the scan, row 0 the +y edge. The heights are
/// centred at mid-range, as a prepared scan is.
pub fn sampled(size: [usize; 2], pitch_nm: [f64; 2], height: impl Fn(f64, f64) -> f64) -> HeightField {
    let middle = size.map(|n| 0.5 * (n - 1) as f64);
    let heights = Array2::from_shape_fn((size[1], size[0]), |(row, column)| {
        height((column as f64 - middle[0]) * pitch_nm[0], (middle[1] - row as f64) * pitch_nm[1])
    });
    centred(HeightField { heights_nm: heights, pitch_nm })
}

/// Heights moved so that their extremes are opposite.
pub fn centred(mut field: HeightField) -> HeightField {
    let (low, high) = field.heights_nm.iter().fold((f64::MAX, f64::MIN), |(l, h), &x| (l.min(x), h.max(x)));
    field.heights_nm -= 0.5 * (low + high);
    field
}

/// A mirror.
pub fn flat(size: [usize; 2], pitch_nm: [f64; 2]) -> HeightField {
    HeightField { heights_nm: Array2::zeros((size[1], size[0])), pitch_nm }
}

/// A random surface of Gaussian heights that repeats at its edges: white noise smoothed by a Gaussian of
/// correlation length `correlation_nm` (autocorrelation `exp(-r²/l²)`), scaled to `rms_nm` exactly.
pub fn random(size: [usize; 2], pitch_nm: [f64; 2], correlation_nm: f64, rms_nm: f64, seed: u64) -> HeightField {
    let mut rng = fastrand::Rng::with_seed(seed);
    let mut normal = || {
        let radius = (-2.0 * (1.0 - rng.f64()).ln()).sqrt();
        radius * (TAU * rng.f64()).cos()
    };
    let noise = Array2::from_shape_simple_fn((size[1], size[0]), &mut normal);
    let along_x = smoothed(&noise, Axis(1), correlation_nm / pitch_nm[0]);
    let mut heights = smoothed(&along_x, Axis(0), correlation_nm / pitch_nm[1]);
    heights -= heights.mean().unwrap();
    heights *= rms_nm / (heights.mapv(|h| h * h).mean().unwrap()).sqrt();
    HeightField { heights_nm: heights, pitch_nm }
}

/// Periodic smoothing along one axis by `exp(-2 x²/l²)`, whose autocorrelation is `exp(-x²/l²)`.
fn smoothed(values: &Array2<f64>, axis: Axis, length: f64) -> Array2<f64> {
    let reach = (3.0 * length).ceil() as isize;
    let mut sum = Array2::zeros(values.raw_dim());
    for offset in -reach..=reach {
        let weight = (-2.0 * (offset as f64 / length).powi(2)).exp();
        sum.scaled_add(weight, &rolled_along(values, axis, offset));
    }
    sum
}

fn rolled_along(values: &Array2<f64>, axis: Axis, by: isize) -> Array2<f64> {
    let by = by.rem_euclid(values.len_of(axis) as isize);
    let tail = values.slice_axis(axis, Slice::from(-by..));
    let head = values.slice_axis(axis, Slice::from(..-by));
    if by == 0 {
        return values.clone();
    }
    ndarray::concatenate(axis, &[tail, head]).unwrap()
}

/// The periodic scan moved by whole columns and rows.
pub fn rolled(field: &HeightField, columns: isize, rows: isize) -> HeightField {
    let heights = rolled_along(&rolled_along(&field.heights_nm, Axis(1), columns), Axis(0), rows);
    HeightField { heights_nm: heights, ..*field }
}

/// Pits instead of bumps.
pub fn negated(field: &HeightField) -> HeightField {
    HeightField { heights_nm: -&field.heights_nm, ..*field }
}

/// The scan with its columns in reverse.
pub fn mirrored_x(field: &HeightField) -> HeightField {
    let mut heights = field.heights_nm.clone();
    heights.invert_axis(Axis(1));
    HeightField { heights_nm: heights.as_standard_layout().into_owned(), ..*field }
}

/// The scan turned by 180° in its plane.
pub fn half_turn(field: &HeightField) -> HeightField {
    let mut heights = field.heights_nm.clone();
    heights.invert_axis(Axis(0));
    heights.invert_axis(Axis(1));
    HeightField { heights_nm: heights.as_standard_layout().into_owned(), ..*field }
}

/// The same heights, said to lie closer or wider.
pub fn stretched(field: &HeightField, factor: f64) -> HeightField {
    HeightField { heights_nm: field.heights_nm.clone(), pitch_nm: field.pitch_nm.map(|p| p * factor) }
}

/// The direction `wo` that makes `q = (u, v, w)` for a given `wi`, if it is above the surface.
pub fn outgoing(wi: Vec3, u: f64, v: f64) -> Option<Vec3> {
    let (x, y) = (-u - wi[0], -v - wi[1]);
    let z2 = 1.0 - x * x - y * y;
    (z2 > 1e-6).then(|| [x, y, z2.sqrt()])
}

/// Standard deviation in (u, v) of the power spectrum of a coherence window at one wavelength:
/// `|G̃|²` is `exp(-(2πσ ξ)²)`, hence `λ / (2√2 π σ)`.
pub fn lobe_deviation(sigma_nm: f64, wavelength_nm: f64) -> f64 {
    wavelength_nm / (TAU * std::f64::consts::SQRT_2 * sigma_nm)
}

/// A square of (u, v) points around a centre for the trapezoid rule over one lobe, and their cell's area.
///
/// A spacing of 1.25 deviations integrates a Gaussian to `4 exp(-2π²/1.25²)` = 1.3e-5 in the plane; the
/// reach of 6.25 deviations leaves out 1e-9.
pub fn lobe_points(centre: [f64; 2], deviation: f64) -> (Vec<[f64; 2]>, f64) {
    let step = 1.25 * deviation;
    let points = (-5..=5)
        .flat_map(|j| (-5..=5).map(move |i| (i, j)))
        .map(|(i, j)| [centre[0] + f64::from(i) * step, centre[1] + f64::from(j) * step])
        .collect();
    (points, step * step)
}

/// Largest absolute difference, relative to the largest expected value.
pub fn worst_of_peak(found: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(found.len(), expected.len());
    let peak = expected.iter().copied().fold(0.0, f64::max);
    assert!(peak > 0.0, "nothing to compare");
    found.iter().zip(expected).map(|(f, e)| (f - e).abs()).fold(0.0, f64::max) / peak
}

/// The value below which a share of the numbers lies.
pub fn quantile(values: &[f64], share: f64) -> f64 {
    assert!(!values.is_empty(), "nothing to take a quantile of");
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[((sorted.len() - 1) as f64 * share).ceil() as usize]
}
