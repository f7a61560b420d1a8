//! Levelling: subtraction of a plane, of a second-order surface, of each scan line's own drift.

use ndarray::parallel::prelude::*;
use ndarray::{Array2, Axis};

use crate::height::HeightField;

/// Fewest samples in a scan line that tell its offset from the structure.
pub(crate) const LINE_SAMPLES_MIN: usize = 8;

/// Order of the subtracted surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// Offset and slopes.
    Plane,
    /// And curvatures.
    Quadratic,
}

/// Derivatives of a subtracted surface at the middle of the scan.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Surface {
    /// Along +x and +y.
    pub slope: [f64; 2],
    /// xx, xy, yy in 1/nm.
    pub curvature_per_nm: [f64; 3],
}

/// A column or row of basis values: orthogonal polynomials on equidistant samples.
struct Axes {
    /// Positions in samples from the middle.
    x: Vec<f64>,
    y: Vec<f64>,
    /// Their squares about the mean square.
    xx: Vec<f64>,
    yy: Vec<f64>,
}

/// Subtracts the least-squares surface of the given order, its offset included.
///
/// On a full grid with the origin in its middle 1, x, y, xy, x² - ⟨x²⟩, y² - ⟨y²⟩ are orthogonal, so
/// each coefficient is one quotient of sums and no equations are solved. What a grid is too small to
/// tell (the slope of one sample, the curvature of two) has a norm of exactly 0 and is taken as 0.
pub(crate) fn subtract_surface(field: &mut HeightField, order: Order) -> Surface {
    let axes = axes(field.size());
    let ones = [vec![1.0; axes.x.len()], vec![1.0; axes.y.len()]];
    let mut terms: Vec<(&[f64], &[f64])> = vec![(&ones[0], &ones[1]), (&axes.x, &ones[1]), (&ones[0], &axes.y)];
    if order == Order::Quadratic {
        terms.extend([(&axes.xx[..], &ones[1][..]), (&axes.x, &axes.y), (&ones[0], &axes.yy)]);
    }
    let mut coefficients = [0.0; 6];
    // Once more on what is left: removes the rounding of slopes far larger than the structure.
    for _ in 0..2 {
        for (coefficient, &(along_x, along_y)) in coefficients.iter_mut().zip(&terms) {
            *coefficient += subtract_term(&mut field.heights_nm, along_x, along_y);
        }
    }
    let [_, x, y, xx, xy, yy] = coefficients;
    let [dx, dy] = field.pitch_nm;
    // Rows count downwards, y upwards; subtracted from 0, for -0 looks odd in a record.
    Surface {
        slope: [x / dx, 0.0 - y / dy],
        curvature_per_nm: [2.0 * xx / (dx * dx), 0.0 - xy / (dx * dy), 2.0 * yy / (dy * dy)],
    }
}

fn axes([nx, ny]: [usize; 2]) -> Axes {
    let positions = |count: usize| -> Vec<f64> { (0..count).map(|i| i as f64 - 0.5 * (count - 1) as f64).collect() };
    let squares = |count: usize| -> Vec<f64> {
        // ⟨x²⟩ of 0, 1, ... n-1 about the middle; exact for two samples, whose squares both are 1/4.
        let mean = ((count * count) as f64 - 1.0) / 12.0;
        positions(count).into_iter().map(|x| x * x - mean).collect()
    };
    Axes { x: positions(nx), y: positions(ny), xx: squares(nx), yy: squares(ny) }
}

/// Projects the heights on `along_x[i] along_y[j]`, subtracts that part and returns its coefficient.
fn subtract_term(heights: &mut Array2<f64>, along_x: &[f64], along_y: &[f64]) -> f64 {
    let square = |values: &[f64]| values.iter().map(|value| value * value).sum::<f64>();
    let norm = square(along_x) * square(along_y);
    if norm == 0.0 {
        return 0.0;
    }
    // Sums by row, then over the rows in order: the same on any number of threads.
    let by_row: Vec<f64> = heights
        .axis_iter(Axis(0))
        .into_par_iter()
        .map(|row| row.iter().zip(along_x).map(|(height, x)| height * x).sum())
        .collect();
    let coefficient = by_row.iter().zip(along_y).map(|(sum, y)| sum * y).sum::<f64>() / norm;
    heights.axis_iter_mut(Axis(0)).into_par_iter().zip(along_y).for_each(|(mut row, y)| {
        let scale = coefficient * y;
        row.iter_mut().zip(along_x).for_each(|(height, x)| *height -= scale * x);
    });
    coefficient
}

/// Subtracts from each scan line its own offset; returns the root mean square of what was subtracted, about its mean over all lines.
///
/// Offsets are matched from line to line: each is the one before and the midmean of the differences to it, so that what stands on both
/// lines, however high, moves neither as long as it takes less than a quarter of a line. Levelling each line by itself, with a slope of its
/// own, takes more of the surface away (`matched_differences_leave_more_than_lines_by_themselves`). A tilt that the offsets have summed
/// up to is taken away at last. (A median of the differences would do as much, but it jumps where a structure has two levels of
/// equal share.)
pub(crate) fn subtract_lines(field: &mut HeightField) -> f64 {
    let heights = &field.heights_nm;
    let steps: Vec<f64> = (1..heights.nrows())
        .into_par_iter()
        .map(|row| {
            let mut steps: Vec<f64> = heights.row(row).iter().zip(heights.row(row - 1)).map(|(a, b)| a - b).collect();
            midmean(&mut steps)
        })
        .collect();
    // Summed in order: the same on any number of threads.
    let mut offsets = vec![0.0];
    steps.iter().for_each(|step| offsets.push(offsets[offsets.len() - 1] + step));
    let before = field.heights_nm.clone();
    for (mut line, offset) in field.heights_nm.rows_mut().into_iter().zip(&offsets) {
        line -= *offset;
    }
    subtract_surface(field, Order::Plane);
    let removed = before - &field.heights_nm;
    let count = removed.len() as f64;
    let mean = removed.sum() / count;
    (removed.iter().map(|height| (height - mean).powi(2)).sum::<f64>() / count).sqrt()
}

/// Mean of the middle half of the values, of which there is at least one; sorts them.
fn midmean(values: &mut [f64]) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    let quarter = values.len() / 4;
    let half = &values[quarter..values.len() - quarter];
    half.iter().sum::<f64>() / half.len() as f64
}
