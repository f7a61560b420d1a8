//! Means of tables over ellipses: the weight of each texel under linear interpolation, and coarser levels for large ellipses.

use std::f64::consts::PI;
use std::sync::OnceLock;

use ndarray::Array3;

use crate::footprint::Footprint;

/// Chords across an ellipse.
const CHORDS: usize = 48;

/// Semi-axes of an ellipse in texels from which coarser levels are mixed in: the longer one, and the geometric mean of both.
/// A level is read with ellipses of at most twice that.
const SEMI_AXES_MAX: [f64; 2] = [6.0, 3.5];

/// Coarsest levels have at least this many texels a side.
const SIDE_MIN: usize = 4;

/// Coarser copies of tables, each of half as many texels: means of two by two.
#[derive(Debug, Clone)]
pub struct Pyramid {
    /// From the first level below the tables themselves.
    levels: Vec<Vec<Array3<f32>>>,
}

/// What lies beyond a table's edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Beyond {
    /// The edge's own values.
    Edge,
    /// Nothing.
    Zero,
}

/// An ellipse on a table, in texels: x along columns, y along rows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ellipse {
    /// Row and column of its centre.
    pub at: [f64; 2],
    /// Covariance, with columns for u and rows for v.
    pub footprint: Footprint,
}

impl Ellipse {
    /// The ellipse of a footprint in (u, v) on a table with so many texels per unit of u and v, whose rows run against v.
    pub fn new(at: [f64; 2], footprint: Footprint, texels_per_unit: f64) -> Self {
        let (variances, [x, y]) = footprint.scaled(texels_per_unit).axes();
        Self { at, footprint: Footprint::of_axes(variances, [x, -y]) }
    }

    /// The ellipse on a coarser level.
    ///
    /// That level's means and the linear interpolation between them blur by `(4^level - 1) / 4` squared texels more than the
    /// tables' own interpolation; the ellipse is narrower by that, so that the variance is right where it is not below zero.
    fn on_level(self, level: usize) -> Self {
        let step = (1u64 << level) as f64;
        let (variances, axis) = self.footprint.axes();
        let blur = 0.25 * (1.0 - 1.0 / (step * step));
        let variances = variances.map(|variance| (variance / (step * step) - blur).max(0.0));
        Self { at: self.at.map(|at| (at - 0.5 * (step - 1.0)) / step), footprint: Footprint::of_axes(variances, axis) }
    }
}

impl Pyramid {
    /// The pyramid above tables of one shape `[rows, columns, 3]`.
    pub fn new(tables: &[Array3<f32>]) -> Self {
        let mut levels: Vec<Vec<Array3<f32>>> = Vec::new();
        loop {
            let finer = levels.last().map_or(tables, Vec::as_slice);
            let Some((rows, columns, _)) = finer.first().map(Array3::dim) else { break };
            if rows.min(columns) < 2 * SIDE_MIN {
                break;
            }
            levels.push(finer.iter().map(halved).collect());
        }
        Self { levels }
    }

    /// Means of tables over an ellipse, channel by channel. `add` is called with a table's number and its part of the
    /// mean: once, or twice where two levels are mixed.
    pub fn means(
        &self,
        tables: &[Array3<f32>],
        ellipse: Ellipse,
        beyond: Beyond,
        mut add: impl FnMut(usize, [f64; 3]),
    ) {
        let Some((rows, columns, _)) = tables.first().map(Array3::dim) else { return };
        let ([major, minor], _) = ellipse.footprint.axes();
        let [longer, middle] = [2.0 * major.sqrt(), 2.0 * (major * minor).powf(0.25)];
        let level =
            (longer / SEMI_AXES_MAX[0]).max(middle / SEMI_AXES_MAX[1]).log2().clamp(0.0, self.levels.len() as f64);
        for level in [level.floor(), level.floor() + 1.0].map(|at| (at as usize, 1.0 - (level - at).abs())) {
            let (level, share) = level;
            if share <= 0.0 {
                continue;
            }
            let images = if level == 0 { tables } else { &self.levels[level - 1] };
            let weights = Weights::new(ellipse.on_level(level), [rows, columns], level, images[0].dim(), beyond);
            for (n, image) in images.iter().enumerate() {
                add(n, weights.mean(image).map(|value| share * value));
            }
        }
    }
}

/// Means of two by two texels; at an odd edge the last texel counts twice.
fn halved(table: &Array3<f32>) -> Array3<f32> {
    let (rows, columns, channels) = table.dim();
    Array3::from_shape_fn((rows.div_ceil(2), columns.div_ceil(2), channels), |(row, column, c)| {
        let [rows, columns] = [[2 * row, (2 * row + 1).min(rows - 1)], [2 * column, (2 * column + 1).min(columns - 1)]];
        let sum: f64 = rows.iter().flat_map(|r| columns.map(|k| f64::from(table[[*r, k, c]]))).sum();
        (0.25 * sum) as f32
    })
}

/// Places of chords across the unit disc, and the share of its area that belongs to each: Gauss's rule with Chebyshev's
/// polynomials of the second kind, whose weight is the chord's length.
fn chords() -> &'static [[f64; 2]; CHORDS] {
    static PLACES: OnceLock<[[f64; 2]; CHORDS]> = OnceLock::new();
    PLACES.get_or_init(|| {
        std::array::from_fn(|k| {
            let angle = (k + 1) as f64 * PI / (CHORDS + 1) as f64;
            [-angle.cos(), 2.0 / (CHORDS + 1) as f64 * angle.sin().powi(2)]
        })
    })
}

/// Weights of texels in a rectangle.
struct Weights {
    first: [usize; 2],
    columns: usize,
    /// Row by row.
    weights: Vec<f64>,
    /// Columns of each row that have weights: from, to.
    spans: Vec<[usize; 2]>,
}

/// Where a table answers along one axis, in texels of a level, and the level's number of texels.
#[derive(Clone, Copy)]
struct Range {
    low: f64,
    high: f64,
    count: usize,
}

impl Range {
    fn new(finest: usize, level: usize, count: usize) -> Self {
        let step = (1u64 << level) as f64;
        let place = |at: f64| (at - 0.5 * (step - 1.0)) / step;
        Self { low: place(0.0), high: place((finest - 1) as f64), count }
    }

    /// First texel of the pair around a place, and the share of the second.
    fn cell(&self, at: f64) -> (usize, f64) {
        let at = at.clamp(0.0, (self.count - 1) as f64);
        let first = (at as usize).min(self.count - 2);
        (first, at - first as f64)
    }
}

impl Weights {
    fn new(ellipse: Ellipse, finest: [usize; 2], level: usize, dim: (usize, usize, usize), beyond: Beyond) -> Self {
        let rows = Range::new(finest[0], level, dim.0);
        let columns = Range::new(finest[1], level, dim.1);
        let [xx, xy, yy] = ellipse.footprint.covariance();
        let [half_height, half_width] = [2.0 * yy.sqrt(), 2.0 * xx.sqrt()];
        let reach = |range: &Range, at: f64, half: f64| [range.cell(at - half).0, range.cell(at + half).0 + 1];
        let [row_first, row_last] = reach(&rows, ellipse.at[0], half_height);
        let [column_first, column_last] = reach(&columns, ellipse.at[1], half_width);
        let mut found = Self {
            first: [row_first, column_first],
            columns: column_last - column_first + 1,
            weights: vec![0.0; (row_last - row_first + 1) * (column_last - column_first + 1)],
            spans: vec![[usize::MAX, 0]; row_last - row_first + 1],
        };
        let slope = if yy > 0.0 { xy / yy } else { 0.0 };
        let half_chord = 2.0 * (xx - slope * xy).max(0.0).sqrt();
        for &[place, share] in chords() {
            let y = ellipse.at[0] + half_height * place;
            if beyond == Beyond::Zero && !(rows.low..=rows.high).contains(&y) {
                continue;
            }
            let x = ellipse.at[1] + slope * half_height * place;
            let half = half_chord * (1.0 - place * place).sqrt();
            // Rounding must not leave the rectangle.
            let ends = [(x - half).max(ellipse.at[1] - half_width), (x + half).min(ellipse.at[1] + half_width)];
            found.add_chord(rows.cell(y), columns, ends, share, beyond);
        }
        found
    }

    /// Adds a chord along a row: linear interpolation along it, integrated exactly, cell by cell.
    fn add_chord(&mut self, row: (usize, f64), columns: Range, [low, high]: [f64; 2], share: f64, beyond: Beyond) {
        let length = high - low;
        if length <= 0.0 {
            let at = 0.5 * (low + high);
            if beyond == Beyond::Edge || (columns.low..=columns.high).contains(&at) {
                self.add(row, columns.cell(at), share);
            }
            return;
        }
        let last = (columns.count - 1) as f64;
        let [mut from, mut to] = [low, high];
        if beyond == Beyond::Zero {
            [from, to] = [from.max(columns.low), to.min(columns.high)];
        }
        for outside in [[from, to.min(0.0)], [from.max(last), to]] {
            if outside[1] > outside[0] {
                self.add(row, columns.cell(outside[1]), share * (outside[1] - outside[0]) / length);
            }
        }
        [from, to] = [from.max(0.0), to.min(last)];
        while from < to {
            let next = (from.floor() + 1.0).min(to);
            self.add(row, columns.cell(0.5 * (from + next)), share * (next - from) / length);
            from = next;
        }
    }

    fn add(&mut self, (row, y): (usize, f64), (column, x): (usize, f64), share: f64) {
        let [row, column] = [row - self.first[0], column - self.first[1]];
        for (row, y) in [(row, 1.0 - y), (row + 1, y)] {
            let span = &mut self.spans[row];
            *span = [span[0].min(column), span[1].max(column + 2)];
            self.weights[row * self.columns + column] += share * y * (1.0 - x);
            self.weights[row * self.columns + column + 1] += share * y * x;
        }
    }

    fn mean(&self, image: &Array3<f32>) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (n, [from, to]) in self.spans.iter().enumerate().filter(|(_, [from, to])| from < to) {
            let weights = &self.weights[n * self.columns..][*from..*to];
            for (k, weight) in weights.iter().enumerate() {
                let texel = [self.first[0] + n, self.first[1] + from + k];
                for (c, sum) in sum.iter_mut().enumerate() {
                    *sum += weight * f64::from(image[[texel[0], texel[1], c]]);
                }
            }
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIDE: usize = 161;

    fn table(value: impl Fn(f64, f64) -> f64) -> Vec<Array3<f32>> {
        vec![Array3::from_shape_fn((SIDE, SIDE, 3), |(row, column, c)| {
            (value(column as f64, row as f64) * [1.0, 2.0, 0.5][c]) as f32
        })]
    }

    fn mean(tables: &[Array3<f32>], ellipse: Ellipse, beyond: Beyond) -> [f64; 3] {
        let mut sum = [0.0; 3];
        Pyramid::new(tables).means(tables, ellipse, beyond, |_, mean| {
            sum.iter_mut().zip(mean).for_each(|(sum, mean)| *sum += mean);
        });
        sum
    }

    fn ellipse(at: [f64; 2], [xx, xy, yy]: [f64; 3]) -> Ellipse {
        Ellipse { at, footprint: Footprint::new(xx, xy, yy).unwrap() }
    }

    /// From far below a texel to coarse levels, along the axes and across.
    const SHAPES: [[f64; 3]; 8] = [
        [0.0, 0.0, 0.0],
        [1e-6, 0.0, 1e-6],
        [0.04, 0.01, 0.02],
        [1.0, 0.0, 0.0],
        [4.0, 1.5, 3.0],
        [30.0, -20.0, 16.0],
        [100.0, 20.0, 90.0],
        [300.0, -100.0, 250.0],
    ];

    #[test]
    fn planes_keep_their_value_and_quadratics_gain_the_variance() {
        for shape in SHAPES {
            let at = [80.3, 77.6];
            let plane = mean(&table(|x, y| 100.0 + x - 0.5 * y), ellipse(at, shape), Beyond::Edge);
            let expected = 100.0 + at[1] - 0.5 * at[0];
            for (value, scale) in plane.into_iter().zip([1.0, 2.0, 0.5]) {
                assert!((value - scale * expected).abs() < 1e-3, "{shape:?}: {plane:?} {expected}");
            }
            // Linear interpolation adds up to a quarter to the mean of x².
            let [xx, xy, yy] = shape;
            let square = |f: fn(f64, f64) -> f64| mean(&table(f), ellipse(at, shape), Beyond::Edge)[0];
            let found = [
                square(|x, _| (x - 80.0).powi(2)) - 2.4f64.powi(2),
                square(|x, y| (x - 80.0) * (y - 80.0)) + 2.4 * 0.3,
                square(|_, y| (y - 80.0).powi(2)) - 0.3f64.powi(2),
            ];
            for (found, expected) in found.into_iter().zip([xx, xy, yy]) {
                let allowed = 0.3 + 0.01 * (xx + yy);
                assert!((found - expected).abs() < allowed, "{shape:?}: {found} {expected}");
            }
            if (xx - yy).abs() > 2.0 {
                assert!((found[0] - yy).abs() > 0.3 + 0.01 * (xx + yy), "exchanged axes must be found: {shape:?}");
            }
        }
    }

    #[test]
    fn nothing_lies_beyond_a_patch() {
        let flat = table(|_, _| 1.0);
        for shape in SHAPES {
            let edge = mean(&flat, ellipse([80.0, 160.0], shape), Beyond::Zero)[0];
            if shape[0] > 0.1 {
                assert!((edge - 0.5).abs() < 1e-3, "{shape:?}: half of the ellipse lies beyond the edge, not {edge}");
            }
            assert!((mean(&flat, ellipse([3.0, 160.0], shape), Beyond::Edge)[0] - 1.0).abs() < 1e-6);
        }
        assert_eq!(mean(&flat, ellipse([80.0, 200.0], [4.0, 0.0, 4.0]), Beyond::Zero), [0.0; 3]);
    }

    #[test]
    fn few_texels_are_read_and_levels_change_without_a_step() {
        let waves = table(|x, y| 2.0 + (0.9 * x).sin() * (0.7 * y + 0.2 * x).cos());
        let mut last = None;
        for n in 0..4000 {
            let size = 0.02 * (f64::from(n) * 0.002).exp() - 0.02;
            let shape = ellipse([80.3, 77.6], [size, 0.3 * size, 0.5 * size]);
            let value = mean(&waves, shape, Beyond::Edge)[0];
            if let Some(last) = last.replace(value) {
                assert!((value - last).abs() < 2e-3, "a step from {last} to {value} at {size}");
            }
        }
        for shape in [[1600.0, 0.0, 1600.0], [1600.0, 1590.0, 1600.0], [1600.0, 0.0, 1.0], [1.0, 0.0, 1600.0]] {
            let whole = ellipse([80.0, 80.0], shape);
            let ([major, minor], _) = whole.footprint.axes();
            let [longer, middle] = [2.0 * major.sqrt(), 2.0 * (major * minor).powf(0.25)];
            let level = (longer / SEMI_AXES_MAX[0]).max(middle / SEMI_AXES_MAX[1]).log2().floor() as usize;
            let side = SIDE.div_ceil(1 << level);
            let weights = Weights::new(whole.on_level(level), [SIDE, SIDE], level, (side, side, 3), Beyond::Edge);
            let read: usize = weights.spans.iter().map(|[from, to]| to.saturating_sub(*from)).sum();
            assert!(read > 0 && read <= 300, "{shape:?}: {read} texels");
        }
    }
}
