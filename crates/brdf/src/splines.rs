//! Cubic B-splines through tables' texels: the closest look-up, which graphics hardware makes of four linear ones.
//!
//! A spline is `Σ c_k B(x - k)` with coefficients `c` of its own, a recursive filter of the values. Straight from the values
//! (`through_values`) it takes hundreds of texels, from coefficients ([`Splines`]) four by four.

use ndarray::{Array3, ArrayView3, Axis};

use crate::direction::Xyz;
use crate::parallel;

/// The pole of the filter that turns values into coefficients, `√3 - 2`.
pub(crate) const POLE: f64 = -0.267_949_192_431_122_7;

/// Texels on each side of a place beyond which values count less than 1e-15 in its coefficients.
const REACH: i64 = 28;

/// Texels beyond the rim of the disc from which on values are held: tables are zero beyond three, and the step there must not
/// ring into the disc.
const HELD_TEXELS: f64 = 2.0;

/// The coefficients of a stack of square tables.
#[derive(Debug, Clone, PartialEq)]
pub struct Splines {
    /// One array for each table, of its shape.
    coefficients: Vec<Array3<f32>>,
}

impl Splines {
    /// Those of tables over the square `[-2, 2]²`, all of one shape `[size, size, 3]`.
    pub fn new(tables: &[Array3<f32>]) -> Self {
        // Filters cannot fail.
        let coefficients =
            parallel::map(tables, |table| Ok(coefficients(table.view()))).expect("filtering has no errors");
        Self { coefficients }
    }

    /// The coefficients, one array for each table: what a texture holds for look-ups by four linear ones.
    pub fn coefficients(&self) -> &[Array3<f32>] {
        &self.coefficients
    }

    /// The splines' values, table after table, at a position in texels (row, column).
    pub(crate) fn values(&self, at: [f64; 2]) -> impl Iterator<Item = Xyz> {
        let (rows, columns, _) = self.coefficients.first().map_or((1, 1, 3), Array3::dim);
        let [(rows, wy), (columns, wx)] = [taps(at[0], rows), taps(at[1], columns)];
        self.coefficients.iter().map(move |table| {
            let mut sum = [0.0; 3];
            for (row, wy) in rows.iter().zip(wy) {
                for (column, wx) in columns.iter().zip(wx) {
                    for (c, sum) in sum.iter_mut().enumerate() {
                        *sum += wy * wx * f64::from(table[[*row, *column, c]]);
                    }
                }
            }
            sum
        })
    }
}

/// The four texels of a look-up along one axis, mirrored at its ends, and the B-spline's weights.
fn taps(at: f64, count: usize) -> ([usize; 4], [f64; 4]) {
    let at = at.clamp(0.0, (count - 1) as f64);
    let first = at.floor() as i64 - 1;
    (std::array::from_fn(|k| mirrored(first + k as i64, count)), weights(at - at.floor()))
}

/// The cubic B-spline at `1 + f`, `f`, `1 - f`, `2 - f`.
fn weights(f: f64) -> [f64; 4] {
    let g = 1.0 - f;
    [g * g * g, 4.0 - 6.0 * f * f + 3.0 * f * f * f, 4.0 - 6.0 * g * g + 3.0 * g * g * g, f * f * f].map(|w| w / 6.0)
}

/// An index reflected at the ends of an axis, which are not repeated.
fn mirrored(index: i64, count: usize) -> usize {
    let last = count as i64 - 1;
    if last == 0 {
        return 0;
    }
    let folded = index.rem_euclid(2 * last);
    folded.min(2 * last - folded) as usize
}

/// The texel whose value stands at a texel of a square table: itself, or beyond the rim of the disc one at it.
fn held([row, column]: [usize; 2], size: usize) -> [usize; 2] {
    let middle = 0.5 * (size - 1) as f64;
    let [y, x] = [row as f64 - middle, column as f64 - middle];
    let limit = middle + HELD_TEXELS;
    if x * x + y * y <= limit * limit {
        return [row, column];
    }
    let radius = x.hypot(y);
    let at = |x: f64| ((middle + x * limit / radius).round().max(0.0) as usize).min(size - 1);
    [at(y), at(x)]
}

/// The coefficients of a square table.
fn coefficients(table: ArrayView3<f32>) -> Array3<f32> {
    let (size, _, channels) = table.dim();
    let mut found = Array3::from_shape_fn((size, size, channels), |(row, column, c)| {
        let [row, column] = held([row, column], size);
        f64::from(table[[row, column, c]])
    });
    for axis in [1, 0] {
        for mut lane in found.lanes_mut(Axis(axis)) {
            let mut line = lane.to_vec();
            filter(&mut line);
            lane.iter_mut().zip(line).for_each(|(slot, value)| *slot = value);
        }
    }
    found.mapv(|value| value as f32)
}

/// In place, along a line that goes on mirrored at its ends: coefficients whose spline passes through the values.
fn filter(line: &mut [f64]) {
    let last = line.len() - 1;
    if last == 0 {
        return;
    }
    // The causal filter's start is a sum over the mirrored line.
    let start = (0..=2 * REACH).map(|k| POLE.powi(k as i32) * line[mirrored(k, last + 1)]).sum();
    line[0] = start;
    for k in 1..=last {
        line[k] += POLE * line[k - 1];
    }
    line[last] = POLE / (POLE * POLE - 1.0) * (line[last] + POLE * line[last - 1]);
    for k in (0..last).rev() {
        line[k] = POLE * (line[k + 1] - line[k]);
    }
    line.iter_mut().for_each(|value| *value *= 6.0);
}

/// The spline through a square table's values at a position in texels (row, column), without coefficients.
pub(crate) fn through_values(table: ArrayView3<f32>, at: [f64; 2]) -> Xyz {
    let (size, _, _) = table.dim();
    let [(rows, wy), (columns, wx)] = at.map(|at| {
        let (first, shares) = cardinal(at.clamp(0.0, (size - 1) as f64));
        let texels: [usize; TAPS] = std::array::from_fn(|k| mirrored(first + k as i64, size));
        (texels, shares)
    });
    let mut sum = [0.0; 3];
    for (row, wy) in rows.into_iter().zip(wy) {
        let mut line = [0.0; 3];
        for (column, wx) in columns.into_iter().zip(wx) {
            let [row, column] = held([row, column], size);
            line.iter_mut().enumerate().for_each(|(c, sum)| *sum += wx * f64::from(table[[row, column, c]]));
        }
        sum.iter_mut().zip(line).for_each(|(sum, value)| *sum += wy * value);
    }
    sum
}

/// Texels along each axis that count in a spline through values.
const TAPS: usize = 2 * REACH as usize;

/// First texel, and what each counts in the spline through values: a coefficient is `√3 Σ POLE^|k| value_k`.
fn cardinal(at: f64) -> (i64, [f64; TAPS]) {
    let (whole, spline) = (at.floor() as i64, weights(at - at.floor()));
    let first = whole + 1 - REACH;
    // No texel is further from one of the four coefficients.
    let mut powers = [3f64.sqrt(); REACH as usize + 2];
    (1..powers.len()).for_each(|k| powers[k] = POLE * powers[k - 1]);
    let shares = std::array::from_fn(|index| {
        let of = |(k, weight): (i64, f64)| weight * powers[(index as i64 + 2 - REACH - k).unsigned_abs() as usize];
        (0..).zip(spline).map(of).sum::<f64>()
    });
    (first, shares)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A smooth table over the disc, zero from three texels beyond it.
    fn table(size: usize) -> Array3<f32> {
        let middle = 0.5 * (size - 1) as f64;
        Array3::from_shape_fn((size, size, 3), |(row, column, c)| {
            let [y, x] = [row as f64 - middle, column as f64 - middle];
            let inside = x.hypot(y) <= middle + 3.0;
            if inside { (3.0 + (0.3 * x + 0.1 * y).cos() + (0.2 * y + c as f64).sin()) as f32 } else { 0.0 }
        })
    }

    #[test]
    fn splines_pass_through_the_values_of_the_disc() {
        let size = 41;
        let table = table(size);
        let splines = Splines::new(std::slice::from_ref(&table));
        for (row, column) in [(20, 20), (3, 20), (20, 0), (40, 20), (8, 9), (20, 40)] {
            let at = [row as f64, column as f64];
            let found = splines.values(at).next().unwrap();
            for c in 0..3 {
                let value = f64::from(table[[row, column, c]]);
                assert!((found[c] - value).abs() < 2e-6, "{row} {column} {c}: {} {value}", found[c]);
            }
        }
    }

    #[test]
    fn coefficients_and_values_give_one_spline() {
        let table = table(41);
        let splines = Splines::new(std::slice::from_ref(&table));
        let mut worst = 0.0f64;
        for k in 0..400 {
            let angle = 0.77 * f64::from(k);
            let radius = 20.0 * (f64::from(k) / 400.0).sqrt();
            let at = [20.0 + radius * angle.sin(), 20.0 + radius * angle.cos()];
            let [fast, slow] = [splines.values(at).next().unwrap(), through_values(table.view(), at)];
            for c in 0..3 {
                worst = worst.max((fast[c] - slow[c]).abs());
            }
        }
        // Coefficients of at most ten, in 24 bits.
        assert!(worst < 2e-6, "{worst:e}");
        // Another pole would be another spline.
        let smoothed = splines.coefficients()[0].clone();
        let wrong = through_values(smoothed.view(), [20.4, 20.4]);
        let right = through_values(table.view(), [20.4, 20.4]);
        assert!((wrong[0] - right[0]).abs() > 1e-3);
    }

    #[test]
    fn errors_fall_with_the_fourth_power_of_the_texel() {
        // Of a wave with h = 0.6 rad a texel the error is h⁴/384 at most for each axis that it runs along.
        let error = |step: f64| {
            let size = 81;
            let wave = |x: f64| 2.0 + (step * x + 0.3).cos();
            let table = Array3::from_shape_fn((size, size, 3), |(_, column, _)| wave(column as f64) as f32);
            let at = |k: u32| 40.0 + f64::from(k) / 37.0;
            (0..37).map(|k| (through_values(table.view(), [40.0, at(k)])[0] - wave(at(k))).abs()).fold(0.0, f64::max)
        };
        for step in [0.4f64, 0.6] {
            let bound = step.powi(4) / 384.0;
            assert!(error(step) < 1.1 * bound && error(step) > 0.7 * bound, "{step}: {:e} {bound:e}", error(step));
        }
    }

    #[test]
    fn nothing_beyond_the_rim_rings_into_the_disc() {
        let table = table(41);
        let mut other = table.clone();
        for ((row, column, _), value) in other.indexed_iter_mut() {
            if (row as f64 - 20.0).hypot(column as f64 - 20.0) > 23.0 {
                *value = 1e6;
            }
        }
        let at = [20.0 + 20.0 * 0.7f64.sin(), 20.0 + 20.0 * 0.7f64.cos()];
        assert_eq!(through_values(table.view(), at), through_values(other.view(), at));
        assert_eq!(Splines::new(&[table]), Splines::new(&[other]));
    }
}
