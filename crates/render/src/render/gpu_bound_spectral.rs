//! How far a GPU may be from the CPU with spectral tables: [`gpu_bound`](super::gpu_bound) for one value at a wavelength.
//!
//! Besides what is written there, the ratio `r = λ0/λ` is off by `6 u` (a quotient of a rounded number):
//!
//! - **Position.** `q' = r q` is off by `8 u` of its length, a texel's place by `4 u` of the table's size, as much again as without
//!   `r`; the patches' likewise.
//! - **t.** `ρ'²` is off by `20 u` of itself more: `δt = t ((10 + 10 ρ'²) u / (4 - ρ'²) + 12 ulp)`.
//! - **Powers.** `r⁴` by `26 u`, `r²` by `14 u`, `1/|w'|` by `14 u`: 64 u for all that is multiplied.
//! - **The lobe.** Of `exp(-x)`, with `x` off by `40 u` of itself (a squared quotient, a squared distance with two roots and
//!   quotients), and 3 + 2x ulp that WGSL allows: `(44 x + 6) u` more than the rounding of the products. Its power is read by hand
//!   in 32 bits, at a place off by `12 u` of the number of texels.

use super::gpu_bound::{
    BasisValues, Layers, RIM_SHARE, U, ULP, cells, chebyshev_values, corner_shares, diffuse_factor_error,
    filtered_error, front_error,
};
use diffraction_brdf::direction::{Vec3, normalised_abs_w, wave_vector_change};
use diffraction_brdf::front_factor::{Factor, FrontFactor, image_radius2};
use diffraction_brdf::shader::peak;
use diffraction_brdf::spectral::{SpectralLobe, SpectralTables};
use ndarray::{Array3, Axis};

/// Relative error of what is multiplied: powers of `r`, `1/|w'|`, and the sums.
const PRODUCTS: f64 = 64.0 * U;

/// Spectral tables, unpacked and looked through once for many bounds.
#[derive(Debug)]
pub struct SpectralBound<'a> {
    tables: &'a SpectralTables,
    grey: Layers<'a>,
    patches: Layers<'a>,
}

impl<'a> SpectralBound<'a> {
    /// For these tables.
    pub fn new(tables: &'a SpectralTables) -> Self {
        let cross = tables.lobe.as_ref().and_then(|lobe| lobe.cross.as_ref());
        Self {
            tables,
            grey: Layers::of(unpacked(&tables.images, tables.count)),
            patches: Layers::of(cross.map_or(Vec::new(), |cross| unpacked(&cross.images, cross.count))),
        }
    }

    /// Largest difference `|GPU - CPU|` in 1/sr for unit vectors to the light and to the viewer at a wavelength in nm; 0 for
    /// directions not above the surface. Not a number where the tables have no answer.
    pub fn at(&self, wi: Vec3, wo: Vec3, wavelength_nm: f64) -> f64 {
        let set = self.tables;
        if !(wi[2] > 0.0 && wo[2] > 0.0) {
            return 0.0;
        }
        let material = match &set.dispersion {
            None => Some(set.front_factor.material),
            Some(dispersion) => dispersion.material_at(wavelength_nm),
        };
        let r = set.shortest_nm / wavelength_nm;
        let (Some(material), true) = (material, r > 0.0 && r <= 1.0 + 1e-9) else { return f64::NAN };
        let front = FrontFactor { material, ..set.front_factor };
        let q = wave_vector_change(wi, wo).map(|part| part * r);
        let (mut value, mut error) = expansion(&self.grey, q, 2.0);
        if let Some(cross) = set.lobe.as_ref().and_then(|lobe| lobe.cross.as_ref()) {
            let (more, off) = self.cross(cross.radius_max, q);
            (value, error) = (value + more, error + off);
        }
        let (diffuse, off) = (front.diffuse(wi, wo), diffuse_factor_error(&front, wi, wo));
        let of_tables = (diffuse + off) * error * (1.0 + PRODUCTS) + (off + PRODUCTS * diffuse) * value.abs();
        let of_lobe = set.lobe.as_ref().map_or(0.0, |lobe| {
            let (share, width) = lobe.share_and_width(set.shortest_nm, wavelength_nm);
            let (value, error) = lobe_error(lobe, &front, wi, wo, [width, q[2].abs()]);
            let relative = front_error(&front, wi, wo) + PRODUCTS;
            share * front.coherent(wi, wo) * (error * (1.0 + relative) + relative * value)
        });
        r.powi(4) * of_tables + of_lobe + f64::from(f32::MIN_POSITIVE)
    }

    /// The same for the cross term, over `|w'|`.
    fn cross(&self, radius: f64, q: Vec3) -> (f64, f64) {
        let (reach, w) = (q[0].abs().max(q[1].abs()), q[2].abs());
        let rim = RIM_SHARE * radius;
        if reach >= radius + rim {
            return (0.0, 0.0);
        }
        let (value, mut error) = expansion(&self.patches, q, radius);
        if reach > radius - rim {
            // Both answers are right: all of it may be there or not.
            error += self.patches.tables.iter().map(|patch| f64::from(peak(patch))).sum::<f64>();
        }
        (value / w, error / w)
    }
}

/// Value and error of an expansion over `[-half_width, half_width]²`.
fn expansion(layers: &Layers, q: Vec3, half_width: f64) -> (f64, f64) {
    let side = layers.tables[0].dim().0;
    let at = [-q[1], q[0]].map(|x| (0.5 + 0.5 * x / half_width).clamp(0.0, 1.0) * (side - 1) as f64);
    let basis = basis(layers.tables.len(), q);
    let sampled = layers.tables.iter().zip(&basis.values).map(|(table, b)| b * sample_grey(table, at));
    (sampled.sum(), filtered_error(layers, &basis, at, side as f64 / (1 << 21) as f64)[0])
}

/// Chebyshev polynomials at `t'` with their errors.
fn basis(count: usize, q: Vec3) -> BasisValues {
    let rho2 = q[0] * q[0] + q[1] * q[1];
    let t = normalised_abs_w(q);
    let t_error = t * ((10.0 + 10.0 * rho2) * U / (4.0 - rho2).max(f64::MIN_POSITIVE) + 12.0 * ULP);
    chebyshev_values(count, t, t_error.min(1.0))
}

/// A grey table at a position in texels (row, column), between four texels.
fn sample_grey(table: &Array3<f32>, at: [f64; 2]) -> f64 {
    let last = [table.dim().0, table.dim().1].map(|count| count - 1);
    let first: [usize; 2] = std::array::from_fn(|axis| (at[axis] as usize).min(last[axis].saturating_sub(1)));
    let shares = corner_shares(std::array::from_fn(|axis| at[axis] - first[axis] as f64));
    let corners = [[0, 0], [0, 1], [1, 0], [1, 1]];
    let texel = |corner: [usize; 2]| {
        let [row, column] = std::array::from_fn(|axis| (first[axis] + corner[axis]).min(last[axis]));
        f64::from(table[[row, column, 0]])
    };
    corners.into_iter().zip(shares).map(|(corner, share)| share * texel(corner)).sum()
}

/// Power times form, and its error, for the form's width in (u, v) and `|w'|`.
fn lobe_error(lobe: &SpectralLobe, front: &FrontFactor, wi: Vec3, wo: Vec3, [width, abs_w]: [f64; 2]) -> (f64, f64) {
    let last = lobe.power.len() - 1;
    let at = (0.5 * abs_w).clamp(0.0, 1.0) * last as f64;
    let place_error = 12.0 * U * lobe.power.len() as f64;
    let (mut power, mut power_error) = (0.0f64, 0.0f64);
    for first in cells(at, place_error, lobe.power.len()) {
        let [low, high] = [first, first + 1].map(|index| f64::from(lobe.power[index]));
        let share = (at - first as f64).clamp(0.0, 1.0);
        power = power.max((low + share * (high - low)).abs());
        power_error = power_error.max(place_error * (high - low).abs() + 4.0 * ULP * low.abs().max(high.abs()));
    }
    let q = wave_vector_change(wi, wo);
    let image = (front.factor == Factor::Vector).then(|| image_radius2(wi, wo));
    let (mut shape, mut shape_error) = (0.0, 0.0);
    for radius2 in [Some(q[0] * q[0] + q[1] * q[1]), image].into_iter().flatten() {
        let x = radius2 / width.powi(2);
        let value = (-x).exp();
        shape += value;
        shape_error += value * (44.0 * x + 6.0) * U + f64::from(f32::MIN_POSITIVE);
    }
    (power * shape, power_error * (shape + shape_error) + power * shape_error)
}

/// Tables of three to an image, one channel each.
fn unpacked(images: &[Array3<f32>], count: usize) -> Vec<Array3<f32>> {
    let channels = images.iter().flat_map(|image| image.axis_iter(Axis(2)));
    channels.take(count).map(|channel| channel.insert_axis(Axis(2)).to_owned()).collect()
}
