//! The table set: plain data that an atlas stores and a renderer evaluates.

use ndarray::Array3;
use serde::{Deserialize, Serialize};

use crate::front_factor::FrontFactor;

/// Which expansion in `w` the tables hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Basis {
    /// Shifted Chebyshev polynomials in `t = |w| / sqrt(4 - u² - v²)`, the coherent part apart.
    Chebyshev,
    /// Powers of `w`: the published method (Dhillon et al. 2014, eq. 8).
    Taylor,
}

/// Number format of the stored tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Storage {
    /// 16-bit floats, each table divided by its scale.
    Half,
    /// 32-bit floats.
    Float,
}

/// What storing a set's numbers does to its values: 95th percentiles of relative changes, the largest of those of texels
/// spread over the disc, of those above the luminance floor, and of those around the mirror direction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Rounding {
    /// With 16-bit floats.
    pub half: f64,
    /// With 32-bit floats.
    pub float: f64,
    /// What the tolerance gives to it.
    pub allowed: f64,
}

/// The coherent lobe: the light that a flat surface of the same mean phasor would send around the
/// mirror direction. A table over radius and `t`.
#[derive(Debug, Clone, PartialEq)]
pub struct Lobe {
    /// `∫ S x̄ |c|² G̃² / (λ² A) dλ` in 1/sr, shape `[t, radius, 3]`: `t` from 0 to 1 and the radius
    /// `sqrt(u² + v²)` from 0 to `radius_max`, both ends included.
    pub coherent: Array3<f32>,
    /// Outer radius of the lobe; it is zero beyond.
    pub radius_max: f64,
    /// Cross term of the lobe with the rest: one patch per Chebyshev polynomial in `t`, shape
    /// `[v, u, 3]` over [-radius_max, radius_max]² with row 0 at `v = +radius_max`; empty where
    /// it vanishes (all window positions averaged).
    pub cross: Vec<Array3<f32>>,
}

/// The part of (u, v, w) that tables restricted to scenes can answer for.
///
/// Tables then hold a window of the whole grid, and at each texel the Chebyshev polynomials run over that texel's own
/// range of `t` instead of [0, 1]: they are `T_n(2s - 1)` with `s = (t - low) / (high - low)`, where `low` and `high`
/// are interpolated between texels like the tables themselves. A look-up that reads a texel which is not covered, or
/// lies outside the range, has no answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Restriction {
    /// Texels along u and v of the whole grid over [-2, 2].
    pub size: usize,
    /// Row and column of the whole grid at which the window begins.
    pub first: [usize; 2],
    /// Lowest `t`, highest `t`, and 1 where the texel is covered or 0 where not; shape `[rows, columns, 3]`, that of
    /// the tables.
    pub range: Array3<f32>,
}

/// The tables of one specimen.
///
/// Texel `(row, column)` of a table lies at `u = -2 + 4 column / (size - 1)`,
/// `v = 2 - 4 row / (size - 1)`; channels are X, Y, Z in 1/sr without the front factor. With `|w| = -w`, `t = |w| / sqrt(4 - u² - v²)` and `T_n*(t) = T_n(2t - 1)`:
///
/// `f = D (Σ table_n T_n*(t) + Σ cross_n T_n*(t) / |w|) + C lobe` for `Basis::Chebyshev`,
/// `f = D Σ table_n |w|^n / w²` for `Basis::Taylor` (no lobe),
/// with `D` and `C` of [`FrontFactor::diffuse`] and [`FrontFactor::coherent`], and `lobe` of
/// [`coherent_lobe`](crate::evaluate::coherent_lobe).
#[derive(Debug, Clone, PartialEq)]
pub struct TableSet {
    /// Which expansion the tables hold.
    pub basis: Basis,
    /// One array per basis function, shape `[size, size, 3]` or that of the covered window, 0 beyond the disc of radius 2 but for a rim of
    /// three texels, which keeps interpolation at the rim free of zeros.
    pub tables: Vec<Array3<f32>>,
    /// The coherent lobe; `None` for `Basis::Taylor`, whose tables contain it.
    pub lobe: Option<Lobe>,
    /// Side of the square in (u, v) over which each texel is averaged; 0 for point samples.
    pub prefilter_width: f64,
    /// What stands in front of the tables' values.
    pub front_factor: FrontFactor,
    /// What they can answer for; `None` for every pair of directions above the surface.
    pub restriction: Option<Restriction>,
    /// Radius of the (u, v) disc that the scans' sampling can answer for; beyond it is zero or doubtful.
    pub usable_radius: f64,
}

impl TableSet {
    /// Texels along u and v of the whole grid.
    pub fn size(&self) -> usize {
        match &self.restriction {
            Some(restriction) => restriction.size,
            None => self.tables.first().map_or(0, |table| table.dim().0),
        }
    }

    /// What keeps the set from being evaluated, in words: shapes that do not fit, numbers that are not finite. A set that
    /// passes is evaluated everywhere without a panic.
    pub(crate) fn check(&self) -> Result<(), String> {
        let (rows, columns, _) = self.tables.first().ok_or("it holds no table")?.dim();
        check_images("tables", &self.tables, [rows, columns])?;
        match &self.restriction {
            None if rows != columns => return Err(format!("its tables of {columns} x {rows} texels are not square")),
            None => {}
            Some(restriction) => {
                check_images("ranges", std::slice::from_ref(&restriction.range), [rows, columns])?;
                let reaches =
                    |first: usize, count: usize| first.checked_add(count).is_none_or(|end| end > restriction.size);
                if reaches(restriction.first[0], rows) || reaches(restriction.first[1], columns) {
                    let ([row, column], size) = (restriction.first, restriction.size);
                    return Err(format!(
                        "its {columns} x {rows} texels begin at column {column}, row {row} of {size} x {size}"
                    ));
                }
            }
        }
        if let Some(lobe) = &self.lobe {
            if !(lobe.radius_max > 0.0 && lobe.radius_max <= 2.0) {
                return Err(format!("its lobe has the radius {}, which is not in (0, 2]", lobe.radius_max));
            }
            let (rows, columns, _) = lobe.coherent.dim();
            check_images("the lobe", std::slice::from_ref(&lobe.coherent), [rows, columns])?;
            if let Some(side) = lobe.cross.first().map(|patch| patch.dim().0) {
                check_images("patches of the cross term", &lobe.cross, [side, side])?;
            }
        }
        self.front_factor.check()
    }
}

/// Whether images have one shape of at least two texels a side and three channels, and hold finite numbers.
fn check_images(what: &str, images: &[Array3<f32>], [rows, columns]: [usize; 2]) -> Result<(), String> {
    if rows < 2 || columns < 2 || images.iter().any(|image| image.dim() != (rows, columns, 3)) {
        return Err(format!("{what} are not all of one size of at least 2 x 2 texels with three channels"));
    }
    if images.iter().any(|image| image.iter().any(|value| !value.is_finite())) {
        return Err(format!("{what} hold values that are not finite"));
    }
    Ok(())
}
