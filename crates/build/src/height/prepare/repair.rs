//! Filling in of lost lines, dust and scars, smoothly from what surrounds them.

use ndarray::Array2;
use serde::{Deserialize, Serialize};

use super::blobs::blobs;
use super::level::{Order, subtract_surface};
use super::lost_lines::lost_lines;
use super::scars::scars;
use crate::height::HeightField;
use crate::height::read::missing::fill;

/// Most lost lines in a row that are filled in; of more, what lies between is unknown, and the scan is to be cropped.
pub(crate) const LOST_BLOCK_MAX: usize = 4;

/// What was masked and filled in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Repaired {
    /// Scan lines without a measurement.
    pub lost_lines: usize,
    /// Spikes and pieces of dust.
    pub blobs: usize,
    /// Streaks along the fast axis.
    pub scars: usize,
    /// Samples of all of them.
    pub samples: usize,
}

/// Fills in what is no surface, one kind after the other, since each hides the next.
pub(crate) fn repair(field: &mut HeightField) -> Repaired {
    let mut repaired = Repaired::default();
    let mut masked = Array2::from_elem(field.heights_nm.dim(), false);
    let lost = lost_lines(&field.heights_nm);
    let mut first = 0;
    for block in lost.chunk_by(|a, b| a == b) {
        if block[0] && block.len() <= LOST_BLOCK_MAX {
            repaired.lost_lines += block.len();
            (first..first + block.len()).for_each(|row| masked.row_mut(row).fill(true));
        }
        first += block.len();
    }
    fill_in(field, &mut masked, &mut repaired);

    let levelled = levelled(field);
    let found = blobs(&levelled.heights_nm);
    repaired.blobs = found.count;
    found.samples.iter().for_each(|place| mask_around(&mut masked, *place));
    fill_in(field, &mut masked, &mut repaired);

    let rms_nm = rms_nm(&self::levelled(field));
    let found = scars(&field.heights_nm, rms_nm);
    repaired.scars = found.len();
    for scar in &found {
        scar.columns.clone().for_each(|column| masked[[scar.row, column]] = true);
    }
    fill_in(field, &mut masked, &mut repaired);
    repaired
}

/// Fills in the masked samples, counts them, and clears the mask.
fn fill_in(field: &mut HeightField, masked: &mut Array2<bool>, repaired: &mut Repaired) {
    repaired.samples += fill_marked(field, masked);
    masked.fill(false);
}

/// Fills in marked samples smoothly; returns their number, 0 where none is known.
pub(crate) fn fill_marked(field: &mut HeightField, marked: &Array2<bool>) -> usize {
    let count = marked.iter().filter(|marked| **marked).count();
    if count == 0 || count == marked.len() {
        return 0;
    }
    let known = |(height, marked): (&f64, &bool)| if *marked { f64::NAN } else { *height };
    let mut heights: Vec<f64> = field.heights_nm.iter().zip(marked).map(known).collect();
    fill(&mut heights, field.size(), field.pitch_nm);
    field.heights_nm.iter_mut().zip(heights).for_each(|(height, filled)| *height = filled);
    count
}

/// Masks a sample and those around it, since a tip as wide as a sample widens what it meets.
fn mask_around(masked: &mut Array2<bool>, [row, column]: [usize; 2]) {
    let (rows, columns) = masked.dim();
    for j in row.saturating_sub(1)..(row + 2).min(rows) {
        for i in column.saturating_sub(1)..(column + 2).min(columns) {
            masked[[j, i]] = true;
        }
    }
}

/// The field about its best plane.
pub(crate) fn levelled(field: &HeightField) -> HeightField {
    let mut levelled = field.clone();
    subtract_surface(&mut levelled, Order::Plane);
    levelled
}

/// Root mean square in nm of heights with mean 0.
pub(crate) fn rms_nm(field: &HeightField) -> f64 {
    (field.heights_nm.iter().map(|height| height * height).sum::<f64>() / field.heights_nm.len() as f64).sqrt()
}
