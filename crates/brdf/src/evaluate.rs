//! Evaluating a table set for a pair of directions, as a renderer would.

use ndarray::{Array3, ArrayView3};

use crate::chebyshev;
use crate::direction::{Vec3, Xyz, length, normalised_abs_w, wave_vector_change};
use crate::front_factor::{Factor, image_radius2};
use crate::splines::{Splines, through_values};
use crate::table_set::{Basis, Lobe, Restriction, TableSet};

/// How values between texels are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interpolation {
    /// Two by two texels, as graphics hardware does.
    Bilinear,
    /// Four by four texels, the cubic through each four: for offline use.
    Cubic,
    /// The cubic B-spline through all texels: what `FORMAT.md` describes, and the tolerance is meant for. Tables restricted to scenes
    /// and those of the lobe, which are finer, are looked up as by [`Self::Cubic`].
    Spline,
}

/// How the tables are looked up: straight from their values, or from splines' coefficients that were made of them.
#[derive(Debug, Clone, Copy)]
pub(crate) enum LookUp<'a> {
    Values(Interpolation),
    Splines(&'a Splines),
}

impl LookUp<'_> {
    /// The kind.
    pub(crate) fn interpolation(self) -> Interpolation {
        match self {
            Self::Values(interpolation) => interpolation,
            Self::Splines(_) => Interpolation::Spline,
        }
    }
}

impl TableSet {
    /// The look-up that `FORMAT.md` describes for such tables, and for which their errors are promised: by splines; linear
    /// where each texel has a range of its own, and of the published method.
    pub fn look_up(&self) -> Interpolation {
        match (&self.restriction, self.basis) {
            (None, Basis::Chebyshev) => Interpolation::Spline,
            _ => Interpolation::Bilinear,
        }
    }
}

/// XYZ of the BRDF in 1/sr; zero for directions not above the surface, not a number for those that the tables do not
/// cover (see [`answers`]).
pub fn brdf_xyz(set: &TableSet, interpolation: Interpolation, wi: Vec3, wo: Vec3) -> Xyz {
    brdf_xyz_by(set, LookUp::Values(interpolation), wi, wo)
}

/// [`brdf_xyz`] by [`Interpolation::Spline`] with the coefficients made before: many times faster. Those of another set give
/// numbers without meaning.
pub fn brdf_xyz_by_splines(set: &TableSet, splines: &Splines, wi: Vec3, wo: Vec3) -> Xyz {
    brdf_xyz_by(set, LookUp::Splines(splines), wi, wo)
}

pub(crate) fn brdf_xyz_by(set: &TableSet, look_up: LookUp, wi: Vec3, wo: Vec3) -> Xyz {
    if !(wi[2] > 0.0 && wo[2] > 0.0) {
        return [0.0; 3];
    }
    let (front, [diffuse, coherent]) = (set.front_factor, parts(set, look_up, wi, wo));
    combined(front.diffuse(wi, wo), front.coherent(wi, wo), diffuse, coherent)
}

/// The BRDF in 1/sr by polarisation, XYZ each: ss, sp, ps, pp, the incident one first, s across the plane of incidence or of
/// scattering. Half their sum is [`brdf_xyz`]. `None` for a factor that does not know polarisation (see
/// [`FrontFactor::polarised`](crate::FrontFactor::polarised)).
pub fn brdf_xyz_polarised(set: &TableSet, interpolation: Interpolation, wi: Vec3, wo: Vec3) -> Option<[Xyz; 4]> {
    let front = set.front_factor.polarised(wi, wo)?;
    if !(wi[2] > 0.0 && wo[2] > 0.0) {
        return Some([[0.0; 3]; 4]);
    }
    let [diffuse, coherent] = parts(set, LookUp::Values(interpolation), wi, wo);
    Some(std::array::from_fn(|kind| combined(front.diffuse[kind], front.coherent[kind], diffuse, coherent)))
}

fn combined(front_diffuse: f64, front_coherent: f64, diffuse: Xyz, coherent: Xyz) -> Xyz {
    std::array::from_fn(|c| front_diffuse * diffuse[c] + front_coherent * coherent[c])
}

/// Diffuse part with the cross term, and coherent lobe, for two directions above the surface: without what stands in front.
fn parts(set: &TableSet, look_up: LookUp, wi: Vec3, wo: Vec3) -> [Xyz; 2] {
    let (q, interpolation) = (wave_vector_change(wi, wo), look_up.interpolation());
    let tables = diffuse_window_power_by(set, look_up, q);
    let Some(lobe) = &set.lobe else { return [tables, [0.0; 3]] };
    let cross = cross_window_power(lobe, interpolation, q);
    [std::array::from_fn(|c| tables[c] + cross[c]), coherent_lobe(set, lobe, interpolation, wi, wo)]
}

/// The coherent lobe between two directions in 1/sr, without its front factor; with the vector factor the light that
/// would leave below the horizon is added where it comes back (see [`image_radius2`]).
pub fn coherent_lobe(set: &TableSet, lobe: &Lobe, interpolation: Interpolation, wi: Vec3, wo: Vec3) -> Xyz {
    let [u, v, w] = wave_vector_change(wi, wo);
    let direct = coherent_value(lobe, interpolation, length([u, v]), w);
    match set.front_factor.factor {
        Factor::Scalar => direct,
        Factor::Vector => {
            let image = coherent_value(lobe, interpolation, image_radius2(wi, wo).sqrt(), w);
            std::array::from_fn(|c| direct[c] + image[c])
        }
    }
}

/// `|P|² / (λ² A w²)` at `q = (u, v, w)`, in 1/sr: what the tables hold, without what stands in front of it.
pub fn window_power(set: &TableSet, interpolation: Interpolation, q: Vec3) -> Xyz {
    let mut sum = diffuse_window_power(set, interpolation, q);
    let lobe = lobe_window_power(set, interpolation, q);
    sum.iter_mut().zip(lobe).for_each(|(sum, lobe)| *sum += lobe);
    sum
}

/// The tables' part of [`window_power`], without the lobe; not a number where they have no answer.
pub fn diffuse_window_power(set: &TableSet, interpolation: Interpolation, q: Vec3) -> Xyz {
    diffuse_window_power_by(set, LookUp::Values(interpolation), q)
}

pub(crate) fn diffuse_window_power_by(set: &TableSet, look_up: LookUp, q: Vec3) -> Xyz {
    let w = q[2].abs();
    let size = set.size() as f64 - 1.0;
    let mut at = [(2.0 - q[1]) / 4.0 * size, (q[0] + 2.0) / 4.0 * size];
    let mut t = normalised_abs_w(q);
    if let Some(restriction) = &set.restriction {
        at = [at[0] - restriction.first[0] as f64, at[1] - restriction.first[1] as f64];
        match share_of_range(restriction, look_up.interpolation(), at, t) {
            Some(share) => t = share,
            None => return [f64::NAN; 3],
        }
    }
    let basis = match set.basis {
        Basis::Chebyshev => chebyshev::shifted_values(set.tables.len(), t),
        // I_p w^p / w².
        Basis::Taylor => (0..set.tables.len()).map(|p| w.powi(p as i32 - 2)).collect(),
    };
    match look_up {
        LookUp::Splines(splines) => weighed(splines.values(at), &basis),
        LookUp::Values(Interpolation::Spline) if set.restriction.is_none() => {
            weighed(set.tables.iter().map(|table| through_values(table.view(), at)), &basis)
        }
        LookUp::Values(interpolation) => expansion(&set.tables, &basis, interpolation, at),
    }
}

/// Whether the tables can answer for a pair of directions: always where they cover every direction, or where one of
/// the two is not above the surface and there is nothing to look up.
pub fn answers(set: &TableSet, interpolation: Interpolation, wi: Vec3, wo: Vec3) -> bool {
    set.restriction.is_none()
        || !(wi[2] > 0.0 && wo[2] > 0.0)
        || diffuse_window_power(set, interpolation, wave_vector_change(wi, wo)).iter().all(|value| !value.is_nan())
}

/// How far `t` may lie outside the range between the texels, as a share of the range: rounding to 32 bits, and filters of
/// graphics hardware.
const RANGE_SLACK: f64 = 0.02;

/// Where `t` lies in the range at a position in the covered window, 0 to 1; `None` outside of what is covered.
fn share_of_range(restriction: &Restriction, interpolation: Interpolation, at: [f64; 2], t: f64) -> Option<f64> {
    let (rows, columns, _) = restriction.range.dim();
    let inside = |x: f64, count: usize| x >= 0.0 && x <= (count - 1) as f64;
    if !inside(at[0], rows) || !inside(at[1], columns) {
        return None;
    }
    let (row, wy) = stencil(interpolation, at[0], rows);
    let (column, wx) = stencil(interpolation, at[1], columns);
    let [mut low, mut high] = [0.0; 2];
    for (dy, wy) in wy.iter().enumerate().filter(|(_, weight)| **weight != 0.0) {
        for (dx, wx) in wx.iter().enumerate().filter(|(_, weight)| **weight != 0.0) {
            let texel = |channel| f64::from(restriction.range[[row + dy, column + dx, channel]]);
            if texel(2) == 0.0 {
                return None;
            }
            low += wy * wx * texel(0);
            high += wy * wx * texel(1);
        }
    }
    let share = (t - low) / (high - low);
    (-RANGE_SLACK..=1.0 + RANGE_SLACK).contains(&share).then_some(share.clamp(0.0, 1.0))
}

/// The lobe's part of [`window_power`]: zero where the tables contain it.
pub fn lobe_window_power(set: &TableSet, interpolation: Interpolation, q: Vec3) -> Xyz {
    set.lobe.as_ref().map_or([0.0; 3], |lobe| lobe_value(lobe, interpolation, q))
}

fn lobe_value(lobe: &Lobe, interpolation: Interpolation, q: Vec3) -> Xyz {
    let [u, v, w] = q;
    let coherent = coherent_value(lobe, interpolation, length([u, v]), w);
    let cross = cross_window_power(lobe, interpolation, q);
    std::array::from_fn(|c| coherent[c] / (w * w) + cross[c])
}

/// The coherent table at a radius and `w`: 0 from `radius_max` on.
fn coherent_value(lobe: &Lobe, interpolation: Interpolation, radius: f64, w: f64) -> Xyz {
    if radius >= lobe.radius_max {
        return [0.0; 3];
    }
    let (rows, columns, _) = lobe.coherent.dim();
    let t = normalised_abs_w([radius, 0.0, w]);
    let at = [t * (rows - 1) as f64, radius / lobe.radius_max * (columns - 1) as f64];
    sample(lobe.coherent.view(), interpolation, at)
}

/// The cross term at `q`, over `|w|`: 0 where it vanishes.
pub fn cross_window_power(lobe: &Lobe, interpolation: Interpolation, q: Vec3) -> Xyz {
    if lobe.cross.is_empty() || q[0].abs().max(q[1].abs()) >= lobe.radius_max {
        return [0.0; 3];
    }
    let size = lobe.cross[0].dim().0 as f64 - 1.0;
    let at = [q[1], -q[0]].map(|x| (lobe.radius_max - x) / (2.0 * lobe.radius_max) * size);
    let basis = chebyshev::shifted_values(lobe.cross.len(), normalised_abs_w(q));
    expansion(&lobe.cross, &basis, interpolation, at).map(|value| value / q[2].abs())
}

/// `Σ basis_n table_n` at a position in texels (row, column).
fn expansion(tables: &[Array3<f32>], basis: &[f64], interpolation: Interpolation, at: [f64; 2]) -> Xyz {
    weighed(tables.iter().map(|table| sample(table.view(), interpolation, at)), basis)
}

/// `Σ basis_n value_n`.
fn weighed(values: impl Iterator<Item = Xyz>, basis: &[f64]) -> Xyz {
    let mut sum = [0.0; 3];
    for (value, factor) in values.zip(basis) {
        sum.iter_mut().zip(value).for_each(|(sum, value)| *sum += factor * value);
    }
    sum
}

/// One table at a position in texels (row, column), clamped to its edges; splines, which are of whole tables, as cubics.
pub fn sample(table: ArrayView3<f32>, interpolation: Interpolation, at: [f64; 2]) -> Xyz {
    let (rows, columns, _) = table.dim();
    let (row, wy) = stencil(interpolation, at[0], rows);
    let (column, wx) = stencil(interpolation, at[1], columns);
    let mut sum = [0.0; 3];
    // Of the four by four texels a linear look-up reads two by two.
    let taps = if interpolation == Interpolation::Bilinear { 2 } else { 4 };
    // Lines of plain floats: no look-up is more frequent.
    let table = table.as_standard_layout();
    let (texels, _) = table.as_slice().expect("in standard layout").as_chunks::<3>();
    for (line, wy) in texels[row * columns..].chunks(columns).zip(wy).take(taps) {
        for (texel, wx) in line[column..].iter().zip(wx).take(taps) {
            sum.iter_mut().zip(texel).for_each(|(sum, value)| *sum += wy * wx * f64::from(*value));
        }
    }
    sum
}

/// First texel and weights along one axis; those of cubics for splines, whose weights are of coefficients.
pub fn stencil(interpolation: Interpolation, at: f64, count: usize) -> (usize, [f64; 4]) {
    let at = at.clamp(0.0, (count - 1) as f64);
    if interpolation == Interpolation::Bilinear || count < 4 {
        let first = (at as usize).min(count.saturating_sub(2));
        let share = at - first as f64;
        return (first, [1.0 - share, share, 0.0, 0.0]);
    }
    let first = (at as usize).saturating_sub(1).min(count - 4);
    let x = at - first as f64;
    // Lagrange's cubic through the nodes 0, 1, 2, 3.
    let weights = [
        -(x - 1.0) * (x - 2.0) * (x - 3.0) / 6.0,
        x * (x - 2.0) * (x - 3.0) / 2.0,
        -x * (x - 1.0) * (x - 3.0) / 2.0,
        x * (x - 1.0) * (x - 2.0) / 6.0,
    ];
    (first, weights)
}
