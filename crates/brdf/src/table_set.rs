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
/// spread over the disc, of lit ones, and of those around the mirror direction.
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

/// The part of (u, v, w) that tables made for certain scenes can answer for.
///
/// Tables then hold a window of the whole grid, and at each texel the Chebyshev polynomials run over that texel's own
/// range of `t` instead of [0, 1]: they are `T_n(2s - 1)` with `s = (t - low) / (high - low)`, where `low` and `high`
/// are interpolated between texels like the tables themselves. A look-up that reads a texel which is not served, or
/// lies outside the range, has no answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Served {
    /// Texels along u and v of the whole grid over [-2, 2].
    pub size: usize,
    /// Row and column of the whole grid at which the window begins.
    pub first: [usize; 2],
    /// Lowest `t`, highest `t`, and 1 where the texel is served or 0 where not; shape `[rows, columns, 3]`, that of
    /// the tables.
    pub range: Array3<f32>,
}

/// The tables of one specimen.
///
/// Texel `(row, column)` of a table lies at `u = -2 + 4 column / (size - 1)`,
/// `v = 2 - 4 row / (size - 1)`; channels are X, Y, Z in 1/sr for unit Fresnel reflectance and
/// geometry factor. With `|w| = -w`, `t = |w| / sqrt(4 - u² - v²)` and `T_n*(t) = T_n(2t - 1)`:
///
/// `f = R G (coherent / w² + Σ cross_n T_n*(t) / |w| + Σ table_n T_n*(t))` for `Basis::Chebyshev`,
/// `f = R G Σ table_n |w|^n / w²` for `Basis::Taylor` (no lobe).
#[derive(Debug, Clone, PartialEq)]
pub struct TableSet {
    /// Which expansion the tables hold.
    pub basis: Basis,
    /// One array per basis function, shape `[size, size, 3]` or that of the served window, 0 beyond the disc of radius 2 but for a rim of
    /// three texels, which keeps interpolation at the rim free of zeros.
    pub tables: Vec<Array3<f32>>,
    /// The coherent lobe; `None` for `Basis::Taylor`, whose tables contain it.
    pub lobe: Option<Lobe>,
    /// Side of the square in (u, v) over which each texel is averaged; 0 for point samples.
    pub prefilter_width: f64,
    /// What stands in front of the tables' values.
    pub front_factor: FrontFactor,
    /// What they can answer for; `None` for every pair of directions above the surface.
    pub served: Option<Served>,
    /// Radius of the (u, v) disc that the scans' sampling can answer for; beyond it is zero or doubtful.
    pub usable_radius: f64,
}

impl TableSet {
    /// Texels along u and v of the whole grid.
    pub fn size(&self) -> usize {
        match &self.served {
            Some(served) => served.size,
            None => self.tables.first().map_or(0, |table| table.dim().0),
        }
    }
}
