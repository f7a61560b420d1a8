//! How far a GPU may be from the CPU: a bound for every pixel, from the rounding and filtering that the hardware is allowed.
//!
//! Per sample, the shader computes `f = front (Σ b_n table_n + lobe)` from the same `wi`, `wo` and weights. With
//! `u = 2^-24` (rounding to nearest) and `ulp = 2u`, WGSL allows 2.5 ulp for a quotient and about 5 for a root, the rest
//! is rounded correctly. What may differ:
//!
//! - **Storage.** Half texels are off by `|half(v / scale) scale - v|`: nothing where the atlas stores halves, else at
//!   most `2^-11 |v|`, or `2^-25 scale` among subnormals.
//! - **Filtering.** Hardware places a position on a grid of 1/256 texel (Direct3D asks for 8 bits; Vulkan's drivers report
//!   them), an error of `2^-9` in each share, plus that of the coordinate in 32 bits, `size 2^-22` texels. All layers
//!   share one position, hence the error is that times the slope of the *sum*: `δ (|∂_row| + |∂_column|) + δ² |∂²|`. Next
//!   to a texel's centre the position may fall into the neighbouring cell: the larger slope counts.
//! - **t.** `4 - u² - v²` is off by at most `20 u`: `δt = t (10 u / (4 - ρ²) + 8 ulp)`, at most 1. `|T_n'| <= n²` in
//!   `2t - 1`, hence `δb_n = min(2, 2 n² δt)`, and `2 n² ulp` from the recurrence. For powers of `w` it is
//!   `(2n + 6) ulp |b_n|`.
//! - **Front.** `1 + wi·wo` is off by `8 u`, squared in `G`; see `front_error` for reflectance and shadowing.
//! - **Summing.** `n` terms in 32 bits: `n u Σ |term|`.

use std::borrow::Cow;

use ndarray::{Array3, Axis};
use rayon::prelude::*;
use rustfft::num_complex::Complex;

use super::gpu_layout::RUN_SAMPLES_MAX;
use crate::scene::samples::{ShadingSamples, pixel_range};
use diffraction_brdf::chebyshev;
use diffraction_brdf::direction::{Vec3, Xyz, dot, max_abs_w, normalised_abs_w, wave_vector_change};
use diffraction_brdf::evaluate::{Interpolation, coherent_lobe, cross_window_power, diffuse_window_power, sample};
use diffraction_brdf::front_factor::{Factor, FrontFactor, image_radius2, polarised_factors};
use diffraction_brdf::material::{Material, cos_half_angle, reflectance};
use diffraction_brdf::shader::peak;
use diffraction_brdf::storage::half_scale;
use diffraction_build::optics::pigment::{Pigment, Surface};
use diffraction_build::tables::model::{Basis, Lobe, Restriction, TableSet};

/// Rounding to nearest in 32 bits.
pub(super) const U: f64 = 1.0 / (1 << 24) as f64;
/// Unit in the last place.
pub(super) const ULP: f64 = 2.0 * U;
/// Error of a bilinear share on hardware that keeps 8 bits of it.
const SHARE_ERROR: f64 = 1.0 / 512.0;

/// Tables with what their upload does to them.
#[derive(Debug)]
pub(super) struct Layers<'a> {
    pub(super) tables: Cow<'a, [Array3<f32>]>,
    scales: Vec<f32>,
}

impl<'a> Layers<'a> {
    /// Looks through every texel for the largest: once for many bounds.
    pub(super) fn of(tables: impl Into<Cow<'a, [Array3<f32>]>>) -> Self {
        let tables = tables.into();
        let scales = tables.iter().map(|table| half_scale(peak(table))).collect();
        Self { tables, scales }
    }
}

/// Values of the basis functions and how far the shader's may be off.
pub(super) struct BasisValues {
    pub(super) values: Vec<f64>,
    errors: Vec<f64>,
}

/// Largest difference `|GPU - CPU|` that each channel of each pixel may show, `[rows, columns, 3]`, in the unit of the
/// picture.
pub fn bound_image(surface: Surface, samples: &ShadingSamples) -> Array3<f32> {
    let set = surface.tables;
    let tables = Layers::of(&set.tables[..]);
    let cross = Layers::of(set.lobe.as_ref().map_or(&[][..], |lobe| &lobe.cross));
    let mut image = Array3::zeros((samples.rows, samples.columns, 3));
    image.axis_iter_mut(Axis(0)).into_par_iter().enumerate().for_each(|(row, mut line)| {
        for (column, mut pixel) in line.outer_iter_mut().enumerate() {
            let mut bound = [0.0; 3];
            for index in pixel_range(samples, row, column) {
                let (wi, wo) = (samples.wi[index].map(f64::from), samples.wo[index].map(f64::from));
                let mut of_sample = sample_bound(set, &tables, &cross, wi, wo);
                if let Some(pigment) = surface.pigment {
                    add(&mut of_sample, pigment_bound(pigment, wi, wo));
                }
                for (sum, value) in bound.iter_mut().zip(of_sample) {
                    *sum += f64::from(samples.weight[index]) * value;
                }
            }
            for (slot, value) in pixel.iter_mut().zip(bound) {
                // Numbers below the smallest normal one may be flushed to zero.
                *slot = (value + f64::from(f32::MIN_POSITIVE)) as f32;
            }
        }
    });
    image
}

fn sample_bound(set: &TableSet, tables: &Layers, cross: &Layers, wi: Vec3, wo: Vec3) -> Xyz {
    if !(wi[2] > 0.0 && wo[2] > 0.0) {
        return [0.0; 3];
    }
    let q = wave_vector_change(wi, wo);
    let (w, rho) = (q[2].abs(), q[0].hypot(q[1]));
    let reach = max_abs_w(rho);
    let t = if reach == 0.0 { 0.0 } else { (w / reach).min(1.0) };
    let t_error = (t * (10.0 * U / (reach * reach) + 8.0 * ULP)).min(1.0);
    let (mut s, mut s_error, mut first) = (t, t_error, [0; 2]);
    let last = (set.size() - 1) as f64;
    let grid_place = [0.5 - 0.25 * q[1], 0.5 + 0.25 * q[0]].map(|x| x.clamp(0.0, 1.0) * last);
    let place_error = set.size() as f64 / (1 << 22) as f64;
    if let Some(restriction) = &set.restriction {
        first = restriction.first;
        let at = std::array::from_fn(|axis| grid_place[axis] - first[axis] as f64);
        (s, s_error) = range_error(restriction, at, place_error, t, t_error);
    }
    let basis = match set.basis {
        Basis::Chebyshev => chebyshev_values(tables.tables.len(), s, s_error),
        Basis::Taylor => power_values(tables.tables.len(), w),
    };
    let place = std::array::from_fn(|axis| grid_place[axis] - first[axis] as f64);
    let mut tables_error = filtered_error(tables, &basis, place, place_error);
    let mut value = diffuse_window_power(set, Interpolation::Bilinear, q);
    let (mut lobe_bound, mut lobe_shown) = ([0.0; 3], [0.0; 3]);
    if let Some(lobe) = &set.lobe {
        add(&mut tables_error, cross_error(lobe, cross, q, t, t_error));
        add(&mut value, cross_window_power(lobe, Interpolation::Bilinear, q));
        lobe_bound = lobe_error(&set.front_factor, lobe, wi, wo, t_error);
        lobe_shown = coherent_lobe(set, lobe, Interpolation::Bilinear, wi, wo);
    }
    // Rounding of the runs' sums, and of both pictures.
    let sums = (RUN_SAMPLES_MAX + 8) as f64 * U;
    let (diffuse, off) = (set.front_factor.diffuse(wi, wo), diffuse_factor_error(&set.front_factor, wi, wo));
    let (coherent, relative) = (set.front_factor.coherent(wi, wo), front_error(&set.front_factor, wi, wo) + sums);
    std::array::from_fn(|c| {
        let of_tables = (diffuse + off) * tables_error[c] * (1.0 + sums) + (off + sums * diffuse) * value[c].abs();
        of_tables + coherent * (lobe_bound[c] * (1.0 + relative) + relative * lobe_shown[c].abs())
    })
}

/// The pigment's share: two reflectances, their product, and what the sums round of it.
fn pigment_bound(pigment: &Pigment, wi: Vec3, wo: Vec3) -> Xyz {
    let material = Material::Dielectric { n: pigment.n };
    let [(passed_i, error_i), (passed_o, error_o)] =
        [wi, wo].map(|v| (1.0 - reflectance(material, v[2]), reflectance_error(material, v[2], 0.0) + 2.0 * U));
    let error = passed_i * error_o + passed_o * error_i + error_i * error_o;
    let rounding = (RUN_SAMPLES_MAX + 12) as f64 * U;
    pigment.xyz_per_sr.map(|c| c * (error + rounding * passed_i * passed_o))
}

fn add(sum: &mut Xyz, more: Xyz) {
    sum.iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
}

pub(super) fn chebyshev_values(count: usize, t: f64, t_error: f64) -> BasisValues {
    let square = |n: usize| (n * n) as f64;
    BasisValues {
        values: chebyshev::shifted_values(count, t),
        errors: (0..count).map(|n| (2.0 * square(n) * t_error).min(2.0) + 2.0 * square(n) * ULP).collect(),
    }
}

fn power_values(count: usize, w: f64) -> BasisValues {
    let values: Vec<f64> = (0..count).map(|n| w.powi(n as i32 - 2)).collect();
    let errors = values.iter().enumerate().map(|(n, value)| (2 * n + 6) as f64 * ULP * value).collect();
    BasisValues { values, errors }
}

/// Relative error of reflectance, geometry and shadowing. The half angle's cosine `c` comes from `1 + wi·wo`, off by `8 u`.
pub(crate) fn front_error(front: &FrontFactor, wi: Vec3, wo: Vec3) -> f64 {
    let one_plus = (1.0 + dot(wi, wo)).max(f64::MIN_POSITIVE);
    let cosine = cos_half_angle(wi, wo).max(f64::MIN_POSITIVE);
    let cosine_error = 4.0 * U / cosine + 5.0 * ULP;
    let mut relative = 16.0 * U / one_plus + 10.0 * ULP;
    if front.shadowing {
        relative += 16.0 * ULP + 8.0 * ULP / cosine;
    }
    let error = reflectance_error(front.material, cosine, cosine_error);
    relative + error.min(1.0) / reflectance(front.material, cosine).max(f64::MIN_POSITIVE)
}

/// Absolute error of the factor of tables and cross term.
///
/// For `R G` it is [`front_error`] of it. The vector factor is a sum of squares. The azimuth's cosine, a quotient of products of
/// two components, is off by `8 u`, its square and that of the sine by `16 u`; the amplitude that p scatters into p is a
/// difference, off by `16 u` of either term; the roots lose digits where the permittivity is near a squared sine.
pub(super) fn diffuse_factor_error(front: &FrontFactor, wi: Vec3, wo: Vec3) -> f64 {
    let value = front.diffuse(wi, wo);
    let index = match (front.factor, front.material) {
        (Factor::Scalar, _) | (_, Material::Ideal) => return value * front_error(front, wi, wo),
        (_, Material::Dielectric { n }) => Complex::new(n, 0.0),
        (_, Material::Conductor { n, k }) => Complex::new(n, k),
    };
    let eps = index * index;
    let lateral2 = |v: Vec3| v[0] * v[0] + v[1] * v[1];
    let roots = [wi, wo].map(|v| (eps - lateral2(v)).sqrt());
    let denominators = [(wi, 0), (wo, 1)].map(|(v, i)| [roots[i] + v[2], eps * v[2] + roots[i]].map(|x| x.norm_sqr()));
    let contrast = (eps - 1.0).norm_sqr();
    let [[s_i, p_i], [s_o, p_o]] = denominators;
    let of_azimuth = 1.0 / (s_i * s_o) + roots[1].norm_sqr() / (s_i * p_o) + roots[0].norm_sqr() / (p_i * s_o);
    let terms = (roots[0] * roots[1]).norm() + eps.norm() * (lateral2(wi) * lateral2(wo)).sqrt();
    let p_to_p = polarised_factors(index, wi, wo)[3];
    let off = 16.0 * U * terms * (contrast / (p_i * p_o)).sqrt();
    let of_roots = (eps.norm() + 2.0) * roots.iter().map(|root| 1.0 / root.norm_sqr().max(U)).sum::<f64>();
    let shadowing =
        if front.shadowing { 16.0 * ULP + 8.0 * ULP / cos_half_angle(wi, wo).max(f64::MIN_POSITIVE) } else { 0.0 };
    let sum = 16.0 * U * contrast * of_azimuth + 2.0 * off * p_to_p.sqrt() + off * off;
    2.0 * wi[2] * wo[2] * sum + value * (64.0 * U + 8.0 * U * of_roots + shadowing)
}

/// Absolute error of the reflectance at a cosine that is off by so much.
///
/// An amplitude of reflection is a quotient whose denominator is at least as large as either term of its numerator, hence
/// off by some ulp of 1, more where the root `cos_t` starts from a cancelled `1 - sin²/n²`; `R` then by
/// `2 sqrt(R)` times that.
fn reflectance_error(material: Material, cosine: f64, cosine_error: f64) -> f64 {
    let index = match material {
        Material::Ideal => return 0.0,
        Material::Dielectric { n } => Complex::new(n, 0.0),
        Material::Conductor { n, k } => Complex::new(n, k),
    };
    let cos2_t = (Complex::new(1.0, 0.0) - (1.0 - cosine * cosine).max(0.0) / (index * index)).norm();
    let amplitude_error = ULP * (24.0 + 4.0 / cos2_t.max(U));
    let value = reflectance(material, cosine);
    let moved = [-cosine_error, cosine_error].map(|d| (reflectance(material, cosine + d) - value).abs());
    2.0 * value.sqrt() * amplitude_error + amplitude_error.powi(2) + moved[0].max(moved[1])
}

/// Where `t` lies in the range of what is covered at a position in texels, and how far that may be off: by the error of
/// `t`, and by those of the two filtered ends.
fn range_error(restriction: &Restriction, at: [f64; 2], place_error: f64, t: f64, t_error: f64) -> (f64, f64) {
    let (rows, columns, _) = restriction.range.dim();
    let mut ends_error = 0.0f64;
    for row in cells(at[0], place_error, rows) {
        for column in cells(at[1], place_error, columns) {
            let second = [(row + 1).min(rows - 1), (column + 1).min(columns - 1)];
            let share = [(at[0] - row as f64).clamp(0.0, 1.0), (at[1] - column as f64).clamp(0.0, 1.0)];
            for end in 0..2 {
                let texel = |r: usize, c: usize| f64::from(restriction.range[[r, c, end]]);
                let corners =
                    [texel(row, column), texel(row, second[1]), texel(second[0], column), texel(second[0], second[1])];
                ends_error = ends_error.max(slope_error(corners, share, [SHARE_ERROR + place_error; 2]) + 4.0 * ULP);
            }
        }
    }
    let range = sample(restriction.range.view(), Interpolation::Bilinear, at);
    let length = (range[1] - range[0]).max(f64::MIN_POSITIVE);
    (((t - range[0]) / length).clamp(0.0, 1.0), ((t_error + ends_error + 4.0 * ULP) / length).min(1.0))
}

/// Bound for a sum of layers at a position (row, column) in texels.
pub(super) fn filtered_error(layers: &Layers, basis: &BasisValues, at: [f64; 2], place_error: f64) -> Xyz {
    let Some((rows, columns, _)) = layers.tables.first().map(Array3::dim) else {
        return [0.0; 3];
    };
    let mut error: Xyz = [0.0; 3];
    for row in cells(at[0], place_error, rows) {
        for column in cells(at[1], place_error, columns) {
            let here = cell_error(layers, basis, [row, column], at, SHARE_ERROR + place_error);
            error.iter_mut().zip(here).for_each(|(error, here)| *error = error.max(here));
        }
    }
    error
}

/// First texels of the cells that a coordinate may fall into.
pub(super) fn cells(at: f64, error: f64, count: usize) -> std::ops::RangeInclusive<usize> {
    let cell = |x: f64| (x.max(0.0) as usize).min(count.saturating_sub(2));
    cell(at - error)..=cell(at + error)
}

fn cell_error(layers: &Layers, basis: &BasisValues, first: [usize; 2], at: [f64; 2], share_error: f64) -> Xyz {
    let (rows, columns, channels) = layers.tables[0].dim();
    let second = [(first[0] + 1).min(rows - 1), (first[1] + 1).min(columns - 1)];
    let corners = [[first[0], first[1]], [first[0], second[1]], [second[0], first[1]], [second[0], second[1]]];
    let share: [f64; 2] = std::array::from_fn(|axis| (at[axis] - first[axis] as f64).clamp(0.0, 1.0));
    let shares = corner_shares(share);
    let mut error = [0.0; 3];
    for (c, error) in error.iter_mut().enumerate().take(channels) {
        let mut sums = [0.0; 4];
        let (mut rounding, mut magnitude) = (0.0, 0.0);
        for (n, table) in layers.tables.iter().enumerate() {
            let (value, value_error) = (basis.values[n], basis.errors[n]);
            let (mut between, mut stored) = (0.0, 0.0);
            for (k, corner) in corners.iter().enumerate() {
                let texel = table[[corner[0], corner[1], c]];
                sums[k] += value * f64::from(texel);
                between += shares[k] * f64::from(texel.abs());
                stored += shares[k] * half_error(texel, layers.scales[n]);
            }
            // The shares that weigh the storage errors are themselves off by less than 2 %.
            rounding += value.abs() * 1.02 * stored + value_error * between;
            magnitude += value.abs() * between;
        }
        *error =
            rounding + slope_error(sums, share, [share_error; 2]) + (layers.tables.len() + 8) as f64 * ULP * magnitude;
    }
    error
}

pub(super) fn corner_shares([row, column]: [f64; 2]) -> [f64; 4] {
    [(1.0 - row) * (1.0 - column), (1.0 - row) * column, row * (1.0 - column), row * column]
}

/// What errors of the shares do to a bilinear value.
pub(super) fn slope_error(corners: [f64; 4], [row, column]: [f64; 2], [row_error, column_error]: [f64; 2]) -> f64 {
    let [a, b, c, d] = corners;
    let along_row = (1.0 - column) * (c - a) + column * (d - b);
    let along_column = (1.0 - row) * (b - a) + row * (d - c);
    let twist = a - b - c + d;
    row_error * along_row.abs() + column_error * along_column.abs() + row_error * column_error * twist.abs()
}

/// What storing a number as a half does to it; never more than the format's own bound, so that a wrong conversion
/// cannot excuse itself.
fn half_error(value: f32, scale: f32) -> f64 {
    let stored = half::f16::from_f32(value / scale).to_f32();
    let actual = (f64::from(stored) * f64::from(scale) - f64::from(value)).abs();
    actual.min(f64::from(value.abs()) / 2048.0 + f64::from(scale) / (1 << 25) as f64)
}

/// Bound for the coherent lobe and its cross term.
/// The cross term's share, over `|w|`.
fn cross_error(lobe: &Lobe, cross: &Layers, q: Vec3, t: f64, t_error: f64) -> Xyz {
    let mut error = [0.0; 3];
    let (w, reach) = (q[2].abs(), q[0].abs().max(q[1].abs()));
    let rim = RIM_SHARE * lobe.radius_max;
    if cross.tables.is_empty() || reach >= lobe.radius_max + rim {
        return error;
    }
    let basis = chebyshev_values(cross.tables.len(), t, t_error);
    let side = cross.tables[0].dim().0;
    let at = [-q[1], q[0]].map(|x| (0.5 + 0.5 * x / lobe.radius_max).clamp(0.0, 1.0) * (side - 1) as f64);
    let here = filtered_error(cross, &basis, at, side as f64 / (1 << 22) as f64);
    add(&mut error, here.map(|e| e / w));
    if reach > lobe.radius_max - rim {
        // Both answers are right: all of it may be there or not.
        let peaks = cross.tables.iter().map(|table| f64::from(peak(table))).sum::<f64>();
        add(&mut error, [peaks / w; 3]);
    }
    error
}

/// Share of the lobe's radius within which a direction may count as inside or not: rounding.
pub(super) const RIM_SHARE: f64 = 1e-6;

/// The coherent table's share without its factor, that of the image in the horizon included.
fn lobe_error(front: &FrontFactor, lobe: &Lobe, wi: Vec3, wo: Vec3, t_error: f64) -> Xyz {
    let [u, v, w] = wave_vector_change(wi, wo);
    let radius = u.hypot(v);
    let rim = RIM_SHARE * lobe.radius_max;
    let mut error = [0.0; 3];
    if radius >= lobe.radius_max + rim {
        return error;
    }
    let image = (front.factor == Factor::Vector).then(|| image_radius2(wi, wo).sqrt());
    for radius in [Some(radius), image].into_iter().flatten().filter(|radius| *radius < lobe.radius_max + rim) {
        let whole = radius > lobe.radius_max - rim;
        add(&mut error, coherent_error(lobe, radius, normalised_abs_w([radius, 0.0, w]), t_error, whole));
    }
    error
}

fn coherent_error(lobe: &Lobe, radius: f64, t: f64, t_error: f64, whole: bool) -> Xyz {
    let (rows, columns, _) = lobe.coherent.dim();
    let at = [t * (rows - 1) as f64, (radius / lobe.radius_max).min(1.0) * (columns - 1) as f64];
    // The radius over the lobe's is off by a root and a quotient, 8 ulp.
    let errors = [t_error * rows as f64 + rows as f64 * 2.0 * ULP, columns as f64 * 8.0 * ULP];
    let mut error: Xyz = [0.0; 3];
    for row in cells(at[0], errors[0], rows) {
        for column in cells(at[1], errors[1], columns) {
            let (row_2, column_2) = ((row + 1).min(rows - 1), (column + 1).min(columns - 1));
            let share = [(at[0] - row as f64).clamp(0.0, 1.0), (at[1] - column as f64).clamp(0.0, 1.0)];
            for (c, error) in error.iter_mut().enumerate() {
                let texel = |r: usize, k: usize| f64::from(lobe.coherent[[r, k, c]]);
                let corners = [texel(row, column), texel(row, column_2), texel(row_2, column), texel(row_2, column_2)];
                let largest = corners.iter().fold(0.0f64, |m, v| m.max(v.abs()));
                let part = if whole { 1.0 } else { 16.0 * ULP };
                *error = error.max(slope_error(corners, share, errors) + part * largest);
            }
        }
    }
    error
}
