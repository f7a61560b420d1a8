//! Luminance alone of tables for every direction, laid out for sums over millions of directions.

use diffraction_brdf::chebyshev;
use diffraction_brdf::direction::{Vec3, normalised_abs_w};
use diffraction_brdf::evaluate::{Interpolation, stencil};

use crate::tables::model::{Basis, TableSet};

/// Y of all tables, those of one texel side by side: a sum over directions needs no X and Z, which are two thirds of the tables.
#[derive(Debug, Clone)]
pub(super) struct LuminanceTables {
    /// `[size, size, count]`.
    values: Vec<f32>,
    size: usize,
    count: usize,
    basis: Basis,
}

impl LuminanceTables {
    /// Those of a set that is not restricted to scenes.
    pub(super) fn new(set: &TableSet) -> Self {
        let (size, count) = (set.size(), set.tables.len());
        let mut values = vec![0.0; size * size * count];
        for (n, table) in set.tables.iter().enumerate() {
            let texels = values.chunks_exact_mut(count);
            texels.zip(table.exact_chunks([1, 1, 3])).for_each(|(texel, xyz)| texel[n] = xyz[[0, 0, 1]]);
        }
        Self { values, size, count, basis: set.basis }
    }

    /// What [`diffuse_window_power`](diffraction_brdf::evaluate::diffuse_window_power) gives with linear look-ups, of Y.
    pub(super) fn power(&self, q: Vec3) -> f64 {
        let texels_per_unit = (self.size as f64 - 1.0) / 4.0;
        let [(row, wy), (column, wx)] =
            [2.0 - q[1], q[0] + 2.0].map(|at| stencil(Interpolation::Bilinear, at * texels_per_unit, self.size));
        let row_last = (row + 1).min(self.size - 1);
        let column_last = (column + 1).min(self.size - 1);
        let texel = |row: usize, column: usize| &self.values[(row * self.size + column) * self.count..][..self.count];
        let corners =
            [texel(row, column), texel(row, column_last), texel(row_last, column), texel(row_last, column_last)];
        let shares = [wy[0] * wx[0], wy[0] * wx[1], wy[1] * wx[0], wy[1] * wx[1]];
        let value =
            |n: usize| -> f64 { corners.iter().zip(shares).map(|(texel, share)| share * f64::from(texel[n])).sum() };
        match self.basis {
            Basis::Chebyshev => {
                chebyshev::shifted(normalised_abs_w(q)).take(self.count).enumerate().map(|(n, b)| b * value(n)).sum()
            }
            // I_p w^p / w².
            Basis::Taylor => (0..self.count).map(|p| q[2].abs().powi(p as i32 - 2) * value(p)).sum(),
        }
    }
}

#[cfg(test)]
mod tests {
    use ndarray::Array3;

    use super::*;
    use diffraction_brdf::direction::{from_angles_deg, wave_vector_change};
    use diffraction_brdf::evaluate::diffuse_window_power;
    use diffraction_brdf::{Factor, FrontFactor, Material};

    #[test]
    fn luminance_is_the_y_of_the_tables() {
        for basis in [Basis::Chebyshev, Basis::Taylor] {
            let table = |n: usize| {
                Array3::from_shape_fn((21, 21, 3), |(row, column, c)| {
                    ((row * 7 + column * 3 + c * 5 + n * 11) % 13) as f32
                })
            };
            let set = TableSet {
                basis,
                tables: (0..5).map(table).collect(),
                lobe: None,
                prefilter_width: 0.0,
                front_factor: FrontFactor { material: Material::Ideal, shadowing: false, factor: Factor::Scalar },
                restriction: None,
                usable_radius: 2.0,
            };
            let luminance = LuminanceTables::new(&set);
            for k in 0..200 {
                let [theta_i, theta_o] = [0.37, 0.61].map(|step: f64| 90.0 * (step * f64::from(k)).fract());
                let q =
                    wave_vector_change(from_angles_deg(theta_i, 3.0 * f64::from(k)), from_angles_deg(theta_o, 70.0));
                let [x, y, _] = diffuse_window_power(&set, Interpolation::Bilinear, q);
                let found = luminance.power(q);
                assert!((found - y).abs() < 1e-12 * y.abs().max(1.0), "{k}: {found} {y}");
                assert!(k > 20 || (found - x).abs() > 1e-6, "another channel must be found");
            }
        }
    }
}
