//! Tables of X, Y, Z under a light, derived from spectral tables in memory.
//!
//! At every texel they are the sum over wavelengths along the ray `(u, v)/λ`: no transforms, and no scan. So an atlas may hold
//! spectral tables alone, and whatever takes tables of X, Y, Z still has them.

use std::f64::consts::SQRT_2;

use ndarray::Array3;
use serde::{Deserialize, Serialize};

use crate::chebyshev;
use crate::direction::{Xyz, max_abs_w};
use crate::error::Result;
use crate::evaluate::{Interpolation, stencil};
use crate::material::reflectance;
use crate::parallel;
use crate::spectral::{SpectralCross, SpectralLobe, SpectralTables, TABLES_PER_IMAGE};
use crate::spectrum::{Illuminant, SpectralQuadrature, filtered_wavenumbers, uniform_wavenumbers};
use crate::splines::Splines;
use crate::table_set::{Basis, Lobe, TableSet};

/// Texels beyond the rim of the disc that are filled, as in tables that are built.
const RIM_TEXELS: f64 = 3.0;

/// Texels of the lobe's table per standard deviation of the narrowest lobe, as in tables that are built.
const LOBE_TEXELS: f64 = 12.0;

/// Standard deviations at which the lobe is below 1e-9 of its peak.
const LOBE_REACH: f64 = 6.44;

/// Fewest wavelengths over which the lobe is summed, as in tables that are built.
const LOBE_WAVELENGTHS: usize = 200;

/// The light under which tables of X, Y, Z are derived.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DerivedLight {
    /// Its spectrum.
    pub illuminant: Illuminant,
    /// The part of it that counts, in nm.
    pub wavelength_nm: [f64; 2],
}

/// Inner radius in (u, v), and the wavelengths from there on outwards.
type Ring = (f64, SpectralQuadrature);

/// A stack of packed tables over a square of (u', v'), and how the wavelength enters.
struct Stack<'a> {
    images: &'a [Array3<f32>],
    /// Of images over the whole square of (u', v').
    splines: Option<Splines>,
    count: usize,
    half_width: f64,
    /// Power of `r` in front of a value.
    power: i32,
}

/// Square images over `[-half_width, half_width]²` in (u, v); texels beyond `radius_max` stay zero.
#[derive(Clone, Copy)]
struct Square {
    size: usize,
    half_width: f64,
    radius_max: f64,
}

impl SpectralTables {
    /// Tables of X, Y, Z under a light, on the grid of these and as many: what a builder makes from the scan, here from spline
    /// look-ups along the ray of wavelengths. A material's colour at normal incidence is in them, the lobe's at every angle.
    ///
    /// It takes seconds for tables of the usual size.
    ///
    /// # Errors
    /// [`Error::Call`](crate::Error::Call) for a light that the eye does not see, for wavelengths of it that are shorter than the
    /// tables', and where the material's index is not known at all of it.
    pub fn xyz_tables(&self, light: &DerivedLight) -> Result<TableSet> {
        let DerivedLight { illuminant, wavelength_nm } = light;
        let reach_nm = illuminant.reach_nm(*wavelength_nm);
        self.check_wavelengths(&reach_nm)?;
        let coloured = |count: usize| match self.dispersion {
            None => uniform_wavenumbers(illuminant, *wavelength_nm, count),
            Some(_) => filtered_wavenumbers(illuminant, *wavelength_nm, count, |nm| self.relative_reflectance(nm, 1.0)),
        };
        let rings = self.ring_counts(illuminant, *wavelength_nm);
        let most = rings.iter().map(|(_, count)| *count).max().unwrap_or(0);
        let rings: Vec<Ring> =
            rings.into_iter().map(|(inner, count)| Ok((inner, coloured(count)?))).collect::<Result<_>>()?;
        let lobe = match &self.lobe {
            None => None,
            Some(lobe) => {
                let radius_max = (LOBE_REACH * self.deviation(lobe, reach_nm[1])).min(2.0);
                let fine = uniform_wavenumbers(illuminant, *wavelength_nm, most.max(LOBE_WAVELENGTHS))?;
                let cross = lobe.cross.as_ref();
                let of_cross = |cross| self.xyz_cross(cross, radius_max, &[(0.0, coloured(most)?)]);
                Some(Lobe {
                    coherent: self.xyz_lobe(lobe, &fine, radius_max, reach_nm[0])?,
                    radius_max,
                    cross: cross.map(of_cross).transpose()?.unwrap_or_default(),
                })
            }
        };
        let splines = Some(Splines::new(&self.images));
        let stack = Stack { images: &self.images, splines, count: self.count, half_width: 2.0, power: 4 };
        let size = self.size();
        let square = Square { size, half_width: 2.0, radius_max: 2.0 + RIM_TEXELS * 4.0 / (size - 1) as f64 };
        Ok(TableSet {
            basis: Basis::Chebyshev,
            tables: self.summed(&stack, square, &rings)?,
            lobe,
            prefilter_width: self.prefilter_width,
            front_factor: self.front_factor,
            restriction: None,
            usable_radius: self.usable_radius,
        })
    }

    /// Reflectance at a wavelength over that of the front factor's material, at an angle.
    fn relative_reflectance(&self, nm: f64, cos_theta_d: f64) -> f64 {
        let Some(dispersion) = &self.dispersion else { return 1.0 };
        let of = |material| reflectance(material, cos_theta_d);
        // The light's ends were checked, and with them all between.
        dispersion.material_at(nm).map_or(f64::NAN, |material| of(material) / of(self.front_factor.material))
    }

    /// Standard deviation of the lobe in (u, v) at a wavelength.
    fn deviation(&self, lobe: &SpectralLobe, nm: f64) -> f64 {
        lobe.share_and_width(self.shortest_nm, nm).1 / SQRT_2
    }

    /// The coherent part over radius and `t`.
    fn xyz_lobe(
        &self,
        lobe: &SpectralLobe,
        quadrature: &SpectralQuadrature,
        radius_max: f64,
        narrowest_nm: f64,
    ) -> Result<Array3<f32>> {
        let columns = (radius_max / self.deviation(lobe, narrowest_nm) * LOBE_TEXELS).ceil() as usize + 1;
        let rows: Vec<usize> = (0..lobe.power.len()).collect();
        let radius = |column: usize| radius_max * column as f64 / (columns - 1) as f64;
        let SpectralQuadrature { wavelengths_nm, weights } = quadrature;
        let seen: Vec<(f64, f64)> =
            wavelengths_nm.iter().map(|nm| lobe.share_and_width(self.shortest_nm, *nm)).collect();
        // What the form counts at each radius and wavelength, whatever `t` is.
        let shapes: Vec<f64> = (0..columns)
            .flat_map(|column| seen.iter().map(move |(share, width)| share * (-(radius(column) / width).powi(2)).exp()))
            .collect();
        let row = |row: &usize| -> Result<Vec<f32>> {
            let t = *row as f64 / (rows.len() - 1) as f64;
            let mut line = Vec::with_capacity(3 * columns);
            for (column, shapes) in shapes.chunks_exact(wavelengths_nm.len()).enumerate() {
                let abs_w = t * max_abs_w(radius(column));
                let cos_theta_d = 0.5 * radius(column).hypot(abs_w);
                let mut sum = [0.0; 3];
                for ((nm, weight), shape) in wavelengths_nm.iter().zip(weights).zip(shapes) {
                    let power =
                        lobe.power_at(abs_w * self.shortest_nm / nm) * self.relative_reflectance(*nm, cos_theta_d);
                    add(&mut sum, weight, shape * power);
                }
                line.extend(sum.map(|value| value as f32));
            }
            Ok(line)
        };
        let numbers = parallel::map(&rows, row)?.concat();
        Ok(Array3::from_shape_vec((rows.len(), columns, 3), numbers).expect("three numbers for each texel"))
    }

    /// The cross term's patches over `[-radius_max, radius_max]²`, texels as close as those of the spectral ones.
    fn xyz_cross(&self, cross: &SpectralCross, radius_max: f64, ring: &[Ring]) -> Result<Vec<Array3<f32>>> {
        let half = (cross.images[0].dim().0 - 1) as f64 / 2.0;
        let size = 2 * (radius_max / cross.radius_max * half).ceil() as usize + 1;
        // One power of `r` goes with `|w'|`, over which the patches stand.
        let stack =
            Stack { images: &cross.images, splines: None, count: cross.count, half_width: cross.radius_max, power: 3 };
        self.summed(&stack, Square { size, half_width: radius_max, radius_max: f64::INFINITY }, ring)
    }

    /// Sums a stack over the wavelengths of each texel's ring: coefficients of `T_n(2t - 1)`.
    fn summed(&self, stack: &Stack, square: Square, rings: &[Ring]) -> Result<Vec<Array3<f32>>> {
        let Square { size, half_width, radius_max } = square;
        let count = stack.count;
        let t_nodes = chebyshev::gauss_nodes(count, 0.0, 1.0);
        let matrix = chebyshev::coefficient_matrix(count);
        let at = |index: usize| half_width * (2.0 * index as f64 / (size - 1) as f64 - 1.0);
        let rows: Vec<usize> = (0..size).collect();
        let row = |row: &usize| -> Result<Vec<Xyz>> {
            let mut values = vec![[0.0; 3]; count];
            let mut scratch = vec![0.0; TABLES_PER_IMAGE * stack.images.len()];
            let mut line = vec![[0.0; 3]; size * count];
            for (column, coefficients) in line.chunks_exact_mut(count).enumerate() {
                let uv = [at(column), -at(*row)];
                let radius = uv[0].hypot(uv[1]);
                let ring = rings.iter().find(|(inner, _)| radius >= *inner).filter(|_| radius <= radius_max);
                let Some((_, quadrature)) = ring else { continue };
                values.fill([0.0; 3]);
                for (nm, weight) in quadrature.wavelengths_nm.iter().zip(&quadrature.weights) {
                    let r = (self.shortest_nm / nm).min(1.0);
                    if !stack.look_up(uv.map(|x| r * x), &mut scratch) {
                        continue;
                    }
                    // From shares of the reach here to shares of the reach at the shortest wavelength.
                    let [reach, shortest] = [r * max_abs_w(radius), max_abs_w(r * radius)];
                    let narrowing = if shortest > 0.0 { (reach / shortest).min(1.0) } else { 0.0 };
                    for (value, t) in values.iter_mut().zip(&t_nodes) {
                        add(
                            value,
                            weight,
                            r.powi(stack.power) * expansion(&scratch[..count], 2.0 * narrowing * t - 1.0),
                        );
                    }
                }
                for (coefficient, weights) in coefficients.iter_mut().zip(&matrix) {
                    values.iter().zip(weights).for_each(|(value, weight)| add(coefficient, value, *weight));
                }
            }
            Ok(line)
        };
        let lines = parallel::map(&rows, row)?;
        let table = |n: usize| {
            Array3::from_shape_fn((size, size, 3), |(row, column, c)| lines[row][column * count + n][c] as f32)
        };
        Ok((0..count).map(table).collect())
    }
}

impl Stack<'_> {
    /// The tables at `(u', v')`, by splines or cubics; false where there is nothing.
    fn look_up(&self, [u, v]: [f64; 2], tables: &mut [f64]) -> bool {
        if u.abs().max(v.abs()) >= self.half_width && self.half_width < 2.0 {
            return false;
        }
        let size = self.images[0].dim().0;
        let at = |x: f64| (self.half_width + x) / (2.0 * self.half_width) * (size - 1) as f64;
        if let Some(splines) = &self.splines {
            for (sums, value) in tables.chunks_exact_mut(TABLES_PER_IMAGE).zip(splines.values([at(-v), at(u)])) {
                sums.copy_from_slice(&value);
            }
            return true;
        }
        let (row, wy) = stencil(Interpolation::Cubic, at(-v), size);
        let (column, wx) = stencil(Interpolation::Cubic, at(u), size);
        tables.fill(0.0);
        for (image, sums) in self.images.iter().zip(tables.chunks_exact_mut(TABLES_PER_IMAGE)) {
            for (dy, wy) in wy.iter().enumerate().take(size - row) {
                for (dx, wx) in wx.iter().enumerate().take(size - column) {
                    let weight = wy * wx;
                    for (c, sum) in sums.iter_mut().enumerate() {
                        *sum += weight * f64::from(image[[row + dy, column + dx, c]]);
                    }
                }
            }
        }
        true
    }
}

/// `Σ a_n T_n(x)`.
fn expansion(coefficients: &[f64], x: f64) -> f64 {
    let [mut last, mut this, mut sum] = [x, 1.0, 0.0];
    for a in coefficients {
        sum += a * this;
        (last, this) = (this, 2.0 * x * this - last);
    }
    sum
}

fn add(sum: &mut Xyz, weight: &Xyz, value: f64) {
    sum.iter_mut().zip(weight).for_each(|(sum, weight)| *sum += weight * value);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_expansion_is_the_sum_of_its_polynomials() {
        let coefficients = [0.7, -0.3, 0.2, 0.05];
        for t in [0.0, 0.2, 0.9, 1.0] {
            let basis = chebyshev::shifted_values(4, t);
            let expected: f64 = coefficients.iter().zip(&basis).map(|(a, b)| a * b).sum();
            assert!((expansion(&coefficients, 2.0 * t - 1.0) - expected).abs() < 1e-15);
        }
    }
}
