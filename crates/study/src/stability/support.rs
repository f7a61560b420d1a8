//! What the stability cases share: small surfaces, settings, and the error of tables against the direct sum.

use ndarray::Array2;

use super::case::{Guard, StabilityCase};
pub use crate::study::pair_of;
use crate::study::stored;
use diffraction_brdf::chebyshev::{gauss_nodes, interpolation_weights, shifted_values};
use diffraction_brdf::direction::max_abs_w;
use diffraction_brdf::direction::{Vec3, wave_vector_change};
use diffraction_brdf::error::Result;
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz, window_power};
use diffraction_brdf::spectrum::{Illuminant, Line};
use diffraction_brdf::storage::half_scale;
use diffraction_build::ground::metrics::relative_error_quantiles;
use diffraction_build::ground::sampling::four;
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
use diffraction_build::optics::reference::brdf_xyz_batch;
use diffraction_build::tables::build::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Basis, Prefilter, Storage, TableSet, TablesConfig};

/// Tolerance of every build of the suite.
pub const TOLERANCE: f64 = 1e-2;

/// Bound of the 95th percentile of the error on texels: basis and wavelengths may each take the tolerance.
pub(crate) const BOUND: f64 = 2.0 * TOLERANCE;

/// Directions compared per case.
const DIRECTIONS: usize = 60;

/// Name of the guard that [`Comparison::half_as_many`] takes out.
pub(crate) const HALF_AS_MANY: &str = "as many tables as the depth asks for; half as many";

/// A direction to the light and one to the viewer.
pub type Pair = (Vec3, Vec3);

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
pub(crate) const WAVE_SIGMA_NM: f64 = 800.0;

/// As [`optics`], lit by one laser line.
pub fn laser(wavelength_nm: f64, sigma_nm: f64) -> OpticsConfig {
    let illuminant = Illuminant::Lines(vec![Line { wavelength_nm, power: 1.0 }]);
    OpticsConfig { illuminant, ..optics(sigma_nm) }
}

/// Daylight on the periodically repeated scan, averaged over all window positions.
pub fn optics(sigma_nm: f64) -> OpticsConfig {
    OpticsConfig::ideal(Illuminant::D65, sigma_nm, Edge::Tile, Windows::Grid)
}

/// Small float tables.
pub fn config(basis: Basis) -> TablesConfig {
    TablesConfig {
        basis,
        tolerance: TOLERANCE,
        size: Some(21),
        count: None,
        wavelength_step_nm: None,
        storage: Some(Storage::Float),
        prefilter: Prefilter::None,
        memory_mib: 1024,
    }
}

/// Tables of one scan.
pub fn tables(field: &HeightField, optics: &OpticsConfig, config: &TablesConfig) -> Result<TableSet> {
    Ok(build(&BuildInput::new(std::slice::from_ref(field), optics, config), &|_| ())?.0)
}

/// Directions on texels, `t` between the two limits, so that no interpolation on the grid enters.
pub fn on_texels(set: &TableSet, t_range: [f64; 2]) -> Vec<Pair> {
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
pub(crate) fn on_row(set: &TableSet, t_range: [f64; 2]) -> Vec<Pair> {
    let texel = 4.0 / (set.size() - 1) as f64;
    let columns = (2..set.size() as i32 / 2).flat_map(|i| [f64::from(-i) * texel, f64::from(i) * texel]);
    columns
        .filter(|u| u.abs() < 1.9)
        .flat_map(|u| [0.0, 0.3, 0.7, 1.0].map(|share| (u, t_range[0] + (t_range[1] - t_range[0]) * share)))
        .map(|(u, t)| pair_of(u, 0.0, t * (4.0 - u * u).sqrt()))
        .collect()
}

/// Tables held against the direct sum of their scan in some directions.
pub struct Comparison<'a> {
    pub set: &'a TableSet,
    pub field: &'a HeightField,
    pub optics: OpticsConfig,
    pub pairs: Vec<Pair>,
    /// Y of the direct sum; not a number where it cannot be summed.
    exact: Vec<f64>,
}

impl<'a> Comparison<'a> {
    pub fn new(set: &'a TableSet, field: &'a HeightField, optics: &OpticsConfig, pairs: Vec<Pair>) -> Self {
        let reference = brdf_xyz_batch(std::slice::from_ref(field), optics, &pairs);
        let exact = reference.map_or(vec![f64::NAN; pairs.len()], |xyz| xyz.iter().map(|xyz| xyz[1]).collect());
        Self { set, field, optics: optics.clone(), pairs, exact }
    }

    /// 95th percentile of the relative error of Y above 1 % of the mean. NaN anywhere makes it NaN; nothing to
    /// compare makes it infinite, because such a case would prove nothing.
    pub fn error(&self) -> f64 {
        self.error_of(&|wi, wo| brdf_xyz(self.set, Interpolation::Cubic, wi, wo)[1])
    }

    /// [`Self::error`] of Y found in another way.
    pub fn error_of(&self, y: &dyn Fn(Vec3, Vec3) -> f64) -> f64 {
        let found: Vec<f64> = self.pairs.iter().map(|&(wi, wo)| y(wi, wo)).collect();
        if found.iter().chain(&self.exact).any(|f| f.is_nan()) {
            return f64::NAN;
        }
        let mean = self.exact.iter().sum::<f64>() / self.exact.len().max(1) as f64;
        let quantiles = relative_error_quantiles(&self.exact, &found, 1e-2 * mean);
        let nothing_to_compare = quantiles.count < 3 || !quantiles.worst.is_finite();
        if nothing_to_compare { f64::INFINITY } else { quantiles.p95 }
    }

    /// [`Self::error`] if the tables were read elsewhere than at `q`.
    pub(crate) fn misread(&self, elsewhere: &dyn Fn(Vec3) -> Vec3) -> f64 {
        self.error_of(&|wi, wo| {
            let q = elsewhere(wave_vector_change(wi, wo));
            self.set.front_factor.diffuse(wi, wo) * window_power(self.set, Interpolation::Cubic, q)[1]
        })
    }

    /// [`Self::error`] with as many polynomials in `t` for `|w|^power` times everything the set holds, the lobe
    /// included: 2 as in published tables, 0 for tables without a lobe of its own.
    pub fn whole(&self, power: i32) -> f64 {
        let count = self.set.tables.len();
        let nodes = gauss_nodes(count, 0.0, 1.0);
        self.error_of(&|wi, wo| {
            let [u, v, w] = wave_vector_change(wi, wo);
            let reach = max_abs_w(u.hypot(v));
            let weights = interpolation_weights(count, 0.0, 1.0, (w.abs() / reach).min(1.0));
            let terms = nodes.iter().zip(&weights).map(|(t, weight)| {
                let w = t * reach;
                weight * w.powi(power) * window_power(self.set, Interpolation::Cubic, [u, v, w])[1]
            });
            self.set.front_factor.diffuse(wi, wo) * terms.sum::<f64>() / w.abs().powi(power)
        })
    }

    /// [`Self::error`] of tables of another scan, or with other settings; infinite where they are refused.
    pub fn other(&self, field: &HeightField, optics: &OpticsConfig, config: &TablesConfig) -> f64 {
        match tables(field, optics, config) {
            Ok(set) => self.error_of(&|wi, wo| brdf_xyz(&set, Interpolation::Cubic, wi, wo)[1]),
            Err(_) => f64::INFINITY,
        }
    }

    /// [`Self::error`] with this many tables.
    pub(crate) fn with_tables(&self, count: usize) -> f64 {
        self.other(self.field, &self.optics, &TablesConfig { count: Some(count), ..config(Basis::Chebyshev) })
    }

    /// [`Self::error`] with half as many tables.
    pub(crate) fn half_as_many(&self) -> f64 {
        self.with_tables(self.set.tables.len() / 2)
    }

    /// See [`half_share`].
    pub fn half(&self) -> f64 {
        half_share(self.set, &self.pairs)
    }
}

/// Largest deviation of Y from tables stored as halves, over what rounding allows: each coefficient at its texel moves
/// by at most 2^-11 of itself, or half a step of the subnormal numbers under the table's scale, 2^-25 of it. Anything
/// beyond is an overflow, or a value flushed away that shows. The sum is kept in doubles. Pairs lie on texels.
fn half_share(set: &TableSet, pairs: &[Pair]) -> f64 {
    let halves = stored(set, Storage::Half);
    let scales: Vec<f64> = set
        .tables
        .iter()
        .map(|table| f64::from(half_scale(table.iter().fold(0.0f32, |peak, v| peak.max(v.abs())))))
        .collect();
    let last = (set.size() - 1) as f64;
    let share = |&(wi, wo): &Pair| {
        let q = wave_vector_change(wi, wo);
        let [row, column] = [(2.0 - q[1]) / 4.0 * last, (q[0] + 2.0) / 4.0 * last].map(|x| x.round() as usize);
        let t = (q[2].abs() / max_abs_w(q[0].hypot(q[1])).max(f64::MIN_POSITIVE)).min(1.0);
        let basis = shifted_values(set.tables.len(), t);
        let moved = set.tables.iter().zip(&scales).zip(&basis).map(|((table, scale), basis)| {
            basis.abs() * (2f64.powi(-11) * f64::from(table[[row, column, 1]].abs()) + 2f64.powi(-25) * scale)
        });
        // The texel's position is found to 2^-50; a neighbour enters with that weight.
        let allowed = set.front_factor.diffuse(wi, wo) * moved.sum::<f64>() * (1.0 + 1e-6);
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

/// What is taken out of a comparison: its name, and the error without it.
pub(crate) struct TakenOut<'a> {
    pub what: &'a str,
    pub without: &'a dyn Fn(&Comparison) -> f64,
}

/// A case that builds tables and compares them on texels; a refusal counts as broken.
pub fn compared(name: &str, field: &HeightField, optics: &OpticsConfig, taken_out: TakenOut) -> StabilityCase {
    let Ok(set) = tables(field, optics, &config(Basis::Chebyshev)) else { return refused(name) };
    let found = Comparison::new(&set, field, optics, on_texels(&set, [0.05, 1.0]));
    case(name, "95 % error of Y on texels", found.error(), BOUND)
        .half(found.half())
        .guarded(taken_out.what, (taken_out.without)(&found))
}

/// A figure with its bound, still without what keeps it.
pub(crate) struct Tried {
    name: String,
    note: String,
    measured: f64,
    bound: f64,
    half: Option<f64>,
}

pub fn case(name: &str, note: &str, measured: f64, bound: f64) -> Tried {
    Tried { name: name.into(), note: note.into(), measured, bound, half: None }
}

/// A case whose tables could not be built.
pub fn refused(name: &str) -> StabilityCase {
    case(name, "its tables could not be built", f64::NAN, 0.0).guarded("nothing", f64::NAN)
}

impl Tried {
    /// With the deviation of its tables as halves.
    pub fn half(self, share: f64) -> Self {
        Self { half: Some(share), ..self }
    }

    /// The case, with what keeps it and the figure without that.
    pub fn guarded(self, what: &str, without: f64) -> StabilityCase {
        let Self { name, note, measured, bound, half } = self;
        StabilityCase { name, note, measured, bound, guard: Guard { what: what.into(), without }, half }
    }
}
