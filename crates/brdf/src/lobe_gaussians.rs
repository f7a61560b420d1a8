//! The coherent lobe's profiles as sums of Gaussians, whose means over an ellipse are known in closed form.
//!
//! At one wavelength the profile is a Gaussian over (u, v), as wide as the wavelength is long where the window is the same for
//! all; in X, Y, Z it is an integral of them over the visible. Eight widths over a factor of two span that space: factors, of either
//! sign, are those of least squares relative to the profile.

use ndarray::{Array3, ArrayView1, Axis};

use crate::table_set::Lobe;

/// Number of Gaussians: `LOBE_GAUSSIANS` of tables_filtered.wgsl.
pub const GAUSSIANS: usize = 8;
/// The outer radius in widths of the widest one: tables end where it is 1e-9.
const REACH: f64 = 4.55;
/// Widths of the widest over the narrowest, shorter than the visible's 780 / 380 nm: no light has all its power at its ends.
const WIDTHS_RATIO: f64 = 2.0;
/// Share of a profile's peak from which on differences count absolutely.
const FLOOR: f64 = 1e-8;

/// `exp(-(radius / width)²)` of each.
fn gaussians(radius: f64, radius_max: f64) -> [f64; GAUSSIANS] {
    std::array::from_fn(|k| {
        let width = radius_max / REACH * WIDTHS_RATIO.powf(-(k as f64) / (GAUSSIANS - 1) as f64);
        (-(radius / width).powi(2)).exp()
    })
}

/// Factors `[t, Gaussian, 3]` for each row of the coherent table.
pub(crate) fn factors(lobe: &Lobe) -> Array3<f32> {
    let (rows, columns, channels) = lobe.coherent.dim();
    let mut out = Array3::zeros((rows, GAUSSIANS, channels));
    let shapes: Vec<[f64; GAUSSIANS]> = (0..columns)
        .map(|column| gaussians(lobe.radius_max * column as f64 / (columns - 1).max(1) as f64, lobe.radius_max))
        .collect();
    for row in 0..rows {
        for c in 0..channels {
            let found = fitted(&shapes, lobe.coherent.index_axis(Axis(0), row).index_axis_move(Axis(1), c));
            (0..GAUSSIANS).for_each(|k| out[[row, k, c]] = found[k] as f32);
        }
    }
    out
}

/// Least squares relative to the profile, by orthogonalising twice.
fn fitted(shapes: &[[f64; GAUSSIANS]], profile: ArrayView1<f32>) -> [f64; GAUSSIANS] {
    let peak = profile.iter().fold(0.0f64, |peak, value| peak.max(f64::from(value.abs())));
    if peak == 0.0 {
        return [0.0; GAUSSIANS];
    }
    let weights: Vec<f64> = profile.iter().map(|value| 1.0 / (f64::from(value.abs()) + FLOOR * peak)).collect();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut columns: Vec<Vec<f64>> = Vec::with_capacity(GAUSSIANS);
    let mut triangle = [[0.0; GAUSSIANS]; GAUSSIANS];
    for k in 0..GAUSSIANS {
        let mut column: Vec<f64> = shapes.iter().zip(&weights).map(|(shape, weight)| weight * shape[k]).collect();
        for _ in 0..2 {
            for (j, other) in columns.iter().enumerate() {
                let share = dot(other, &column);
                triangle[j][k] += share;
                column.iter_mut().zip(other).for_each(|(value, other)| *value -= share * other);
            }
        }
        let length = dot(&column, &column).sqrt();
        // Of a profile with fewer texels than Gaussians some add nothing.
        let scale = if length > 1e-12 { 1.0 / length } else { 0.0 };
        triangle[k][k] = length;
        column.iter_mut().for_each(|value| *value *= scale);
        columns.push(column);
    }
    let weighed: Vec<f64> = profile.iter().zip(&weights).map(|(value, weight)| f64::from(*value) * weight).collect();
    let mut found = [0.0; GAUSSIANS];
    for k in (0..GAUSSIANS).rev() {
        let known: f64 = (k + 1..GAUSSIANS).map(|j| triangle[k][j] * found[j]).sum();
        let length = triangle[k][k];
        found[k] = if length > 1e-12 { (dot(&columns[k], &weighed) - known) / length } else { 0.0 };
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Largest difference from the profile, relative to it down to 1e-7 of its peak.
    fn worst(lobe: &Lobe, factors: &Array3<f32>) -> f64 {
        let (rows, columns, _) = lobe.coherent.dim();
        let mut worst = 0.0f64;
        for row in 0..rows {
            let peak = f64::from(lobe.coherent[[row, 0, 1]]);
            for column in 0..columns {
                let shapes = gaussians(lobe.radius_max * column as f64 / (columns - 1) as f64, lobe.radius_max);
                let sum: f64 = (0..GAUSSIANS).map(|k| shapes[k] * f64::from(factors[[row, k, 1]])).sum();
                let value = f64::from(lobe.coherent[[row, column, 1]]);
                worst = worst.max((sum - value).abs() / value.max(1e-7 * peak));
            }
        }
        worst
    }

    /// A lobe of a 4 µm window whose heights make colours, in a green and in a wide band.
    fn lobe() -> Lobe {
        const SIGMA_NM: f64 = 4_000.0;
        let radius_max = REACH * 780.0 / (std::f64::consts::TAU * SIGMA_NM);
        let coherent = Array3::from_shape_fn((9, 160, 3), |(row, column, c)| {
            let radius = radius_max * column as f64 / 159.0;
            let value = |nm: f64| {
                let eye = (-((nm - 555.0) / [70.0, 42.0, 30.0][c]).powi(2) / 2.0).exp();
                let power = 0.5 + 0.5 * (4.0 * std::f64::consts::PI * 250.0 * row as f64 / 8.0 / nm).cos();
                eye * power * (-(std::f64::consts::TAU * SIGMA_NM * radius / nm).powi(2)).exp()
            };
            (0..=200).map(|n| value(380.0 + 2.0 * f64::from(n))).sum::<f64>() as f32
        });
        Lobe { coherent, radius_max, cross: Vec::new() }
    }

    #[test]
    fn eight_gaussians_are_the_profile() {
        let lobe = lobe();
        let mut found = factors(&lobe);
        let right = worst(&lobe, &found);
        println!("off by {right:.1e} of the profile");
        assert!(right < 2e-3, "{right}");
        found.index_axis_mut(Axis(1), 2).mapv_inplace(|value| 1.01 * value);
        assert!(worst(&lobe, &found) > 4.0 * right.max(1e-3), "a wrong factor must be found");
    }

    #[test]
    fn one_wavelength_and_darkness_have_factors_too() {
        let mut line = lobe();
        line.coherent = Array3::from_shape_fn((2, 90, 3), |(row, column, _)| {
            row as f32 * (-(REACH * column as f64 / 89.0).powi(2)).exp() as f32
        });
        let found = factors(&line);
        assert!(found.index_axis(Axis(0), 0).iter().all(|value| *value == 0.0));
        assert!((found[[1, 0, 0]] - 1.0).abs() < 1e-4 && found[[1, 4, 0]].abs() < 1e-4, "{found:?}");
        line.coherent = Array3::from_elem((1, 2, 3), 1.0);
        assert!(factors(&line).iter().all(|value| value.is_finite()));
    }
}
