//! Height floor: reading and writing scans, generating, judging and preparing them, and their statistics.

pub mod prepare;
pub mod quality;
pub mod read;
pub mod statistics;
pub mod synthesize;
pub mod write;

use ndarray::Array2;

/// Smallest and largest believable distance of samples in nm: a hundredth of an atom, and one millimetre.
pub const PITCH_NM: [f64; 2] = [1e-3, 1e6];

/// A height field on a regular grid.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightField {
    /// Heights in nm, positive outward, shape `[rows, columns]`; row 0 is the +y edge.
    pub heights_nm: Array2<f64>,
    /// Sample spacing in nm along x (columns) and y (rows).
    pub pitch_nm: [f64; 2],
}

impl HeightField {
    /// Number of samples along x and y.
    pub fn size(&self) -> [usize; 2] {
        [self.heights_nm.ncols(), self.heights_nm.nrows()]
    }

    /// The part from a first column and row on, of so many columns and rows: `[x, y, width, height]`, within the field.
    pub(crate) fn cropped(&self, [x, y, width, height]: [usize; 4]) -> Self {
        let heights_nm = Array2::from_shape_fn((height, width), |(row, column)| self.heights_nm[[y + row, x + column]]);
        Self { heights_nm, pitch_nm: self.pitch_nm }
    }

    /// Extent in nm along x and y (samples times pitch: each sample stands for one cell).
    pub fn extent_nm(&self) -> [f64; 2] {
        let [nx, ny] = self.size();
        [nx as f64 * self.pitch_nm[0], ny as f64 * self.pitch_nm[1]]
    }
}
