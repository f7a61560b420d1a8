//! Filtered look-ups: the mean of the BRDF over all that a light's disc or a pixel's footprint reaches, from one look-up.
//!
//! A light that is even over a disc of directions moves (u, v) over an ellipse, and `cos_theta_i dω = du dv`: it fills that
//! ellipse evenly. So the mean of `f cos_theta_i` over the disc, over `cos_theta_i` at its centre, is the plain mean of `f` over the
//! ellipse. The front factor and `t` vary slowly there and are the centre's; tables and lobe do not, and are averaged.

use std::f64::consts::TAU;

use ndarray::Array3;

use crate::chebyshev;
use crate::direction::{Vec3, Xyz, length, max_abs_w, normalised_abs_w, wave_vector_change};
use crate::evaluate::{Interpolation, LookUp, cross_window_power, diffuse_window_power_by, stencil};
use crate::footprint::Footprint;
use crate::front_factor::Factor;
use crate::lobe_mean::LobeEllipse;
use crate::pyramid::{Beyond, Ellipse, Pyramid};
use crate::spectral::{Pair, SpectralTables, TABLES_PER_IMAGE};
use crate::splines::Splines;
use crate::table_set::{Basis, Lobe, TableSet};

/// Rings and points per ring at which tables are looked up that are not averaged texel by texel.
const POINTS: [usize; 2] = [4, 16];

/// Semi-axis in texels up to which seven points do, weighed so that polynomials of degree five have their mean over the ellipse:
/// within it a look-up is a few cubics that join smoothly.
const SEVEN_POINTS_MAX: f64 = 1.5;

/// Semi-axis in texels from which cubic look-ups give way to linear ones, until twice that: means over many texels are alike.
const CUBIC_MAX: f64 = 4.0;

/// Coarser copies of a table set.
#[derive(Debug, Clone)]
pub struct Pyramids {
    tables: Pyramid,
    cross: Pyramid,
}

impl Pyramids {
    /// Those of a table set.
    pub fn new(set: &TableSet) -> Self {
        // Texels of restricted tables each have a range of their own: they have no means.
        let tables = if set.restriction.is_some() { &[] } else { set.tables.as_slice() };
        Self { tables: Pyramid::new(tables), cross: Pyramid::new(set.lobe.as_ref().map_or(&[], |lobe| &lobe.cross)) }
    }

    /// Those of spectral tables.
    pub fn of_spectral(tables: &SpectralTables) -> Self {
        let cross = tables.lobe.as_ref().and_then(|lobe| lobe.cross.as_ref());
        Self { tables: Pyramid::new(&tables.images), cross: Pyramid::new(cross.map_or(&[], |cross| &cross.images)) }
    }
}

/// Mean of the BRDF over a footprint around two directions, XYZ in 1/sr: see [`Brdf::eval_filtered`](crate::Brdf::eval_filtered).
pub fn brdf_xyz_filtered(
    set: &TableSet,
    pyramids: &Pyramids,
    interpolation: Interpolation,
    directions: [Vec3; 2],
    footprint: Footprint,
) -> Xyz {
    brdf_xyz_filtered_by(set, pyramids, LookUp::Values(interpolation), directions, footprint)
}

/// [`brdf_xyz_filtered`] by [`Interpolation::Spline`] with the coefficients made before. Those of another set give numbers without
/// meaning.
pub fn brdf_xyz_filtered_by_splines(
    set: &TableSet,
    pyramids: &Pyramids,
    splines: &Splines,
    directions: [Vec3; 2],
    footprint: Footprint,
) -> Xyz {
    brdf_xyz_filtered_by(set, pyramids, LookUp::Splines(splines), directions, footprint)
}

pub(crate) fn brdf_xyz_filtered_by(
    set: &TableSet,
    pyramids: &Pyramids,
    look_up: LookUp,
    [wi, wo]: [Vec3; 2],
    footprint: Footprint,
) -> Xyz {
    if !(wi[2] > 0.0 && wo[2] > 0.0) {
        return [0.0; 3];
    }
    let q = wave_vector_change(wi, wo);
    let [diffuse, coherent] = [set.front_factor.diffuse(wi, wo), set.front_factor.coherent(wi, wo)];
    let interpolation = look_up.interpolation();
    let tables = diffuse_mean(set, pyramids, look_up, q, footprint);
    let Some(lobe) = &set.lobe else { return tables.map(|value| diffuse * value) };
    let cross = cross_mean(lobe, pyramids, interpolation, q, footprint);
    let mut coherent_mean = lobe_mean(lobe, interpolation, LobeEllipse::direct([q[0], q[1]], footprint), q[2]);
    if set.front_factor.factor == Factor::Vector {
        let image = lobe_mean(lobe, interpolation, LobeEllipse::image(wi, wo, footprint), q[2]);
        coherent_mean.iter_mut().zip(image).for_each(|(sum, image)| *sum += image);
    }
    std::array::from_fn(|c| diffuse * (tables[c] + cross[c]) + coherent * coherent_mean[c])
}

/// Mean of the tables' part, without what stands in front of it; not a number where they have no answer for a part of it.
fn diffuse_mean(set: &TableSet, pyramids: &Pyramids, look_up: LookUp, q: Vec3, footprint: Footprint) -> Xyz {
    let texels_per_unit = (set.size() as f64 - 1.0) / 4.0;
    let at_points = || mean_of_points(q, footprint, texels_per_unit, |q| diffuse_window_power_by(set, look_up, q));
    if set.restriction.is_some() {
        return at_points();
    }
    let by_texels = || {
        let basis = match set.basis {
            Basis::Chebyshev => chebyshev::shifted_values(set.tables.len(), normalised_abs_w(q)),
            Basis::Taylor => (0..set.tables.len()).map(|p| q[2].abs().powi(p as i32 - 2)).collect(),
        };
        let ellipse = Ellipse::new([2.0 - q[1], q[0] + 2.0].map(|x| x * texels_per_unit), footprint, texels_per_unit);
        expansion_mean(&set.tables, &pyramids.tables, &basis, ellipse, Beyond::Edge)
    };
    as_interpolated(look_up.interpolation(), footprint, texels_per_unit, at_points, by_texels)
}

/// A mean from linear look-ups texel by texel, or, of a small ellipse, from cubic ones at a few points.
fn as_interpolated<const N: usize>(
    interpolation: Interpolation,
    footprint: Footprint,
    texels_per_unit: f64,
    at_points: impl FnOnce() -> [f64; N],
    by_texels: impl FnOnce() -> [f64; N],
) -> [f64; N] {
    let semi_axis = 2.0 * footprint.axes().0[0].sqrt() * texels_per_unit;
    let share =
        if interpolation == Interpolation::Bilinear { 0.0 } else { (2.0 - semi_axis / CUBIC_MAX).clamp(0.0, 1.0) };
    let mut sum = [0.0; N];
    let mut add =
        |share: f64, value: [f64; N]| sum.iter_mut().zip(value).for_each(|(sum, value)| *sum += share * value);
    if share > 0.0 {
        add(share, at_points());
    }
    if share < 1.0 {
        add(1.0 - share, by_texels());
    }
    sum
}

/// Mean over points of the ellipse at the centre's `t`; not a number where one of them has no answer.
fn mean_of_points<const N: usize>(
    q: Vec3,
    footprint: Footprint,
    texels_per_unit: f64,
    value: impl Fn(Vec3) -> [f64; N],
) -> [f64; N] {
    let t = normalised_abs_w(q);
    let mut sum = [0.0; N];
    let mut add = |[x, y]: [f64; 2], share: f64| {
        let [mut u, mut v] = [q[0] + x, q[1] + y];
        let radius = length([u, v]);
        // No two directions reach further.
        if radius > 2.0 - 1e-9 {
            [u, v] = [u, v].map(|part| part * (2.0 - 1e-9) / radius);
        }
        let value = value([u, v, -t * max_abs_w(length([u, v]))]);
        sum.iter_mut().zip(value).for_each(|(sum, value)| *sum += share * value);
    };
    let (variances, [x, y]) = footprint.axes();
    let [major, minor] = variances.map(|variance| 2.0 * variance.sqrt());
    let place = |radius: f64, turns: f64| {
        let (sin, cos) = (turns * TAU).sin_cos();
        let [along, across] = [major * radius * cos, minor * radius * sin];
        [along * x - across * y, along * y + across * x]
    };
    if major == 0.0 {
        return value(q);
    }
    if major * texels_per_unit < SEVEN_POINTS_MAX {
        add([0.0, 0.0], 0.25);
        (0..6).for_each(|k| add(place((2.0f64 / 3.0).sqrt(), k as f64 / 6.0), 0.125));
        return sum;
    }
    // Rings of equal areas.
    for n in 0..POINTS[0] * POINTS[1] {
        let [ring, k] = [n / POINTS[1], n % POINTS[1]];
        let radius = ((ring as f64 + 0.5) / POINTS[0] as f64).sqrt();
        let turns = (k as f64 + 0.618 * ring as f64) / POINTS[1] as f64;
        add(place(radius, turns), 1.0 / (POINTS[0] * POINTS[1]) as f64);
    }
    sum
}

/// `Σ basis_n mean(table_n)` over an ellipse.
fn expansion_mean(tables: &[Array3<f32>], pyramid: &Pyramid, basis: &[f64], ellipse: Ellipse, beyond: Beyond) -> Xyz {
    let mut sum = [0.0; 3];
    pyramid.means(tables, ellipse, beyond, |n, mean| {
        sum.iter_mut().zip(mean).for_each(|(sum, mean)| *sum += basis[n] * mean);
    });
    sum
}

/// Mean of the cross term over `|w|`.
fn cross_mean(lobe: &Lobe, pyramids: &Pyramids, interpolation: Interpolation, q: Vec3, footprint: Footprint) -> Xyz {
    let Some(size) = lobe.cross.first().map(|patch| patch.dim().0) else { return [0.0; 3] };
    let texels_per_unit = (size as f64 - 1.0) / (2.0 * lobe.radius_max);
    let by_texels = || {
        let basis = chebyshev::shifted_values(lobe.cross.len(), normalised_abs_w(q));
        let ellipse =
            Ellipse::new([q[1], -q[0]].map(|x| (lobe.radius_max - x) * texels_per_unit), footprint, texels_per_unit);
        expansion_mean(&lobe.cross, &pyramids.cross, &basis, ellipse, Beyond::Zero).map(|value| value / q[2].abs())
    };
    let at_points = || mean_of_points(q, footprint, texels_per_unit, |q| cross_window_power(lobe, interpolation, q));
    as_interpolated(interpolation, footprint, texels_per_unit, at_points, by_texels)
}

/// Mean of the coherent table over an ellipse, at the centre's `t`.
fn lobe_mean(lobe: &Lobe, interpolation: Interpolation, ellipse: LobeEllipse, w: f64) -> Xyz {
    if !ellipse.reaches(lobe.radius_max) {
        return [0.0; 3];
    }
    let (rows, columns, _) = lobe.coherent.dim();
    let t = normalised_abs_w([ellipse.radius(), 0.0, w]);
    let taps = if interpolation == Interpolation::Bilinear { 2 } else { 4 };
    let (row, shares) = stencil(interpolation, t * (rows - 1) as f64, rows);
    let profile: Vec<Xyz> = (0..columns)
        .map(|column| {
            std::array::from_fn(|c| {
                let rows = shares.iter().enumerate().take(taps.min(rows - row));
                rows.map(|(k, share)| share * f64::from(lobe.coherent[[row + k, column, c]])).sum()
            })
        })
        .collect();
    ellipse.mean(lobe.radius_max, |radius| {
        let (column, shares) = stencil(interpolation, radius / lobe.radius_max * (columns - 1) as f64, columns);
        let mut sum = [0.0; 3];
        for (value, share) in profile[column..].iter().zip(shares).take(taps) {
            sum.iter_mut().zip(value).for_each(|(sum, value)| *sum += share * value);
        }
        sum
    })
}

/// Spectral tables with their coarser copies, for filtered look-ups.
#[derive(Debug)]
pub struct FilteredSpectral<'a> {
    tables: &'a SpectralTables,
    pyramids: Pyramids,
}

impl FilteredSpectral<'_> {
    /// Mean of the BRDF over a footprint in 1/sr at each wavelength in nm, as [`SpectralTables::eval`] is at a point; what is
    /// meant by it is told at [`Brdf::eval_filtered`](crate::Brdf::eval_filtered).
    pub fn eval_filtered(
        &self,
        interpolation: Interpolation,
        wi: Vec3,
        wo: Vec3,
        footprint: Footprint,
        wavelengths_nm: &[f64],
    ) -> Vec<f64> {
        spectral_filtered(
            self.tables,
            &self.pyramids,
            LookUp::Values(interpolation),
            [wi, wo],
            footprint,
            wavelengths_nm,
        )
    }
}

impl SpectralTables {
    /// The tables made ready for filtered look-ups: with coarser copies, which take a third of their memory.
    pub fn filtered(&self) -> FilteredSpectral<'_> {
        FilteredSpectral { tables: self, pyramids: Pyramids::of_spectral(self) }
    }
}

/// [`FilteredSpectral::eval_filtered`] with coarser copies that are kept elsewhere.
pub(crate) fn spectral_filtered(
    tables: &SpectralTables,
    pyramids: &Pyramids,
    look_up: LookUp,
    [wi, wo]: [Vec3; 2],
    footprint: Footprint,
    wavelengths_nm: &[f64],
) -> Vec<f64> {
    if !(wi[2] > 0.0 && wo[2] > 0.0) {
        return vec![0.0; wavelengths_nm.len()];
    }
    let pair = Pair::of(tables.front_factor, wi, wo);
    let q = wave_vector_change(wi, wo);
    let mut ellipses = vec![LobeEllipse::direct([q[0], q[1]], footprint)];
    if tables.front_factor.factor == Factor::Vector {
        ellipses.push(LobeEllipse::image(wi, wo, footprint));
    }
    let value = |&nm: &f64| {
        let r = tables.shortest_nm / nm;
        // The wavelength itself may differ by rounding.
        let inside = r > 0.0 && r <= 1.0 + 1e-9;
        let Some([diffuse, coherent]) = tables.front_at(&pair, nm).filter(|_| inside) else { return f64::NAN };
        let (q, scaled) = (q.map(|part| part * r.min(1.0)), footprint.scaled(r.min(1.0)));
        let mean = r.powi(4) * diffuse * spectral_diffuse_mean(tables, pyramids, look_up, q, scaled);
        let Some(lobe) = &tables.lobe else { return mean };
        let (share, width) = lobe.share_and_width(tables.shortest_nm, nm);
        let shape: f64 = ellipses.iter().map(|ellipse| ellipse.gaussian_mean(width)).sum();
        mean + share * coherent * lobe.power_at(q[2].abs()) * shape
    };
    wavelengths_nm.iter().map(value).collect()
}

/// Mean of tables and cross term at `(u', v', w')`.
fn spectral_diffuse_mean(
    tables: &SpectralTables,
    pyramids: &Pyramids,
    look_up: LookUp,
    q: Vec3,
    footprint: Footprint,
) -> f64 {
    let interpolation = look_up.interpolation();
    let texels_per_unit = (tables.size() as f64 - 1.0) / 4.0;
    let by_texels = || {
        let ellipse = Ellipse::new([2.0 - q[1], q[0] + 2.0].map(|x| x * texels_per_unit), footprint, texels_per_unit);
        [packed_mean(&tables.images, tables.count, &pyramids.tables, ellipse, Beyond::Edge, q)]
    };
    let at_points = || mean_of_points(q, footprint, texels_per_unit, |q| [tables.diffuse_at(look_up, q)]);
    let [diffuse] = as_interpolated(interpolation, footprint, texels_per_unit, at_points, by_texels);
    let Some(cross) = tables.lobe.as_ref().and_then(|lobe| lobe.cross.as_ref()) else { return diffuse };
    let texels_per_unit = (cross.images[0].dim().0 as f64 - 1.0) / (2.0 * cross.radius_max);
    let by_texels = || {
        let at = [q[1], -q[0]].map(|x| (cross.radius_max - x) * texels_per_unit);
        let ellipse = Ellipse::new(at, footprint, texels_per_unit);
        [packed_mean(&cross.images, cross.count, &pyramids.cross, ellipse, Beyond::Zero, q) / q[2].abs()]
    };
    let at_points = || mean_of_points(q, footprint, texels_per_unit, |q| [cross.value(interpolation, q)]);
    diffuse + as_interpolated(interpolation, footprint, texels_per_unit, at_points, by_texels)[0]
}

/// `Σ basis_n mean(table_n)` of packed tables.
fn packed_mean(
    images: &[Array3<f32>],
    count: usize,
    pyramid: &Pyramid,
    ellipse: Ellipse,
    beyond: Beyond,
    q: Vec3,
) -> f64 {
    let basis = chebyshev::shifted_values(count, normalised_abs_w(q));
    let mut sum = 0.0;
    pyramid.means(images, ellipse, beyond, |n, mean| {
        sum += basis[n * TABLES_PER_IMAGE..].iter().zip(mean).map(|(b, value)| b * value).sum::<f64>();
    });
    sum
}
