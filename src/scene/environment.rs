//! Light from all around: an image in longitude and latitude as a fixed set of directions.
//!
//! Longitude runs along the columns, the middle one being world +z, where the camera is; seen from the object,
//! columns to the right lie to the right, towards world -x. The top row is world +y. A texel weighs by its
//! luminance times its solid angle, and the light has the illuminant's spectrum everywhere.

use std::f64::consts::{PI, TAU};
use std::path::{Path, PathBuf};

use ndarray::Array2;
use serde::{Deserialize, Serialize};

use crate::ground::direction::Vec3;
use crate::ground::error::{Error, Result};
use crate::ground::exr_foreign::read_luminance;
use crate::ground::sampling::plane;

/// An environment, ready to light a scene.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Environment {
    /// The image file.
    pub file: PathBuf,
    /// Its SHA-256, hexadecimal.
    pub sha256: String,
    /// `∫ L dω` over all directions, `L` being the image's luminance times the scale: π L for a sky of uniform
    /// L would be the irradiance below it, 4π L is this.
    pub scalar_irradiance: f64,
    /// Unit vectors to the light in the world. Any number of them, from the first on, stands for the whole:
    /// each carries an equal share of `scalar_irradiance`.
    pub directions: Vec<Vec3>,
}

/// Reads an image, turns it about the vertical by `rotate_deg` (from +z towards +x, counter-clockwise seen from
/// above), and takes `count` directions from it.
///
/// # Errors
/// An image that cannot be read, is not twice as wide as high, or is black.
pub fn load(path: &Path, rotate_deg: f64, scale: f64, count: usize) -> Result<Environment> {
    let (luminance, sha256) = read_luminance(path)?;
    let (rows, columns) = luminance.dim();
    if columns != 2 * rows {
        return Err(Error::bad_file(
            path,
            format!("it has {columns} x {rows} pixels, which is not all directions: twice as wide as high"),
            "Save the whole sphere in longitude and latitude (equirectangular).",
        ));
    }
    let Some((scalar_irradiance, directions)) = sample(&luminance, rotate_deg, count) else {
        return Err(Error::bad_file(path, "it is black and lights nothing", "Choose another image."));
    };
    Ok(Environment { file: path.to_owned(), sha256, scalar_irradiance: scale * scalar_irradiance, directions })
}

/// `∫ L dω`, and directions distributed like `L`; `None` for a black image.
///
/// The low-discrepancy points of the unit square are mapped first to a row by the rows' shares of the light, then to
/// a column by its share of the row's; within a texel to equal solid angles.
pub fn sample(luminance: &Array2<f32>, rotate_deg: f64, count: usize) -> Option<(f64, Vec<Vec3>)> {
    let (rows, columns) = luminance.dim();
    let mut running = Vec::with_capacity(rows);
    let mut total = 0.0;
    for (row, texels) in luminance.outer_iter().enumerate() {
        total += texel_solid_angle(row, rows, columns) * texels.iter().map(|&l| f64::from(l)).sum::<f64>();
        running.push(total);
    }
    if !(total.is_finite() && total > 0.0) {
        return None;
    }
    let directions = (0..count).map(|index| {
        let [along, across] = plane(index);
        let row = running.partition_point(|&sum| sum <= across * total).min(rows - 1);
        let below = if row == 0 { 0.0 } else { running[row - 1] };
        let down = ((across * total - below) / (running[row] - below)).clamp(0.0, 1.0);
        let (column, right) = place(luminance.row(row).iter().map(|&l| f64::from(l)), along);
        direction([rows, columns], row as f64 + down, column as f64 + right, rotate_deg)
    });
    Some((total, directions.collect()))
}

/// Solid angle of a texel in sr.
fn texel_solid_angle(row: usize, rows: usize, columns: usize) -> f64 {
    TAU / columns as f64 * (sine(row, rows) - sine(row + 1, rows))
}

/// Sine of the latitude of the upper edge of a row.
fn sine(row: usize, rows: usize) -> f64 {
    (PI * row as f64 / rows as f64).cos()
}

/// The element in which a share of the sum is reached, and how far into it.
fn place(values: impl Iterator<Item = f64> + Clone, share: f64) -> (usize, f64) {
    let target = share * values.clone().sum::<f64>();
    let (mut sum, mut last) = (0.0, (0, 0.0));
    for (index, value) in values.enumerate().filter(|(_, value)| *value > 0.0) {
        if sum + value > target {
            return (index, ((target - sum) / value).clamp(0.0, 1.0));
        }
        sum += value;
        // Rounding may leave the target beyond the last element: its far edge.
        last = (index, 1.0);
    }
    last
}

/// The direction at a row and a column, counted in texels from the upper left corner; between the edges of a
/// row evenly in the sine of latitude.
pub fn direction([rows, columns]: [usize; 2], row: f64, column: f64, rotate_deg: f64) -> Vec3 {
    let whole = (row.floor() as usize).min(rows - 1);
    let down = row - whole as f64;
    let y = sine(whole, rows) + down * (sine(whole + 1, rows) - sine(whole, rows));
    let longitude = TAU * (column / columns as f64 - 0.5) - rotate_deg.to_radians();
    let level = (1.0 - y * y).max(0.0).sqrt();
    [-level * longitude.sin(), y, level * longitude.cos()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ground::direction::dot;

    #[test]
    fn columns_and_rows_lie_where_the_convention_says() {
        let at = |row, column, rotate_deg| direction([4, 8], row, column, rotate_deg);
        let near = |a: Vec3, b: Vec3| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-15);
        assert!(near(at(2.0, 4.0, 0.0), [0.0, 0.0, 1.0]), "the middle is towards the camera");
        assert!(near(at(2.0, 6.0, 0.0), [-1.0, 0.0, 0.0]), "right of it, seen from the object");
        assert!(near(at(2.0, 0.0, 0.0), [0.0, 0.0, -1.0]), "the seam is behind");
        assert!(near(at(0.0, 3.0, 0.0), [0.0, 1.0, 0.0]), "the top is up");
        assert!(near(at(2.0, 4.0, 90.0), [1.0, 0.0, 0.0]), "turned from +z to +x");
    }

    #[test]
    fn one_bright_texel_gets_every_direction() {
        let mut image = Array2::zeros((16, 32));
        image[[5, 20]] = 3.0f32;
        let (total, directions) = sample(&image, 30.0, 64).unwrap();
        assert!((total - 3.0 * texel_solid_angle(5, 16, 32)).abs() < 1e-12);
        let middle = direction([16, 32], 5.5, 20.5, 30.0);
        // Half a diagonal of 11.25 degrees by as much.
        assert!(directions.iter().all(|&d| dot(d, middle) > f64::to_radians(8.0).cos()));
        let mean = directions.iter().fold([0.0; 3], |sum, d| [0, 1, 2].map(|k| sum[k] + d[k] / 64.0));
        assert!(mean.iter().zip(middle).all(|(mean, middle)| (mean - middle).abs() < 0.01), "{mean:?} {middle:?}");
        assert!(sample(&Array2::zeros((4, 8)), 0.0, 8).is_none());
    }

    #[test]
    fn texels_get_directions_by_their_light() {
        let image = Array2::from_shape_fn((4, 8), |(row, column)| (1 + row * column) as f32);
        let count = 20_000;
        let (total, directions) = sample(&image, 0.0, count).unwrap();
        let mut found = Array2::<f64>::zeros((4, 8));
        for [x, y, z] in directions {
            let row = ((y.acos() / PI) * 4.0) as usize;
            let column = (((-x).atan2(z) / TAU + 0.5) * 8.0) as usize;
            found[[row.min(3), column.min(7)]] += 1.0 / count as f64;
        }
        for ((row, column), share) in found.indexed_iter() {
            let expected = f64::from(image[[row, column]]) * texel_solid_angle(row, 4, 8) / total;
            // The discrepancy of this sequence is about 2 ln(n) / n.
            assert!((share - expected).abs() < 1e-3, "{row} {column}: {share} {expected}");
        }
        let solid: f64 = (0..4).map(|row| 8.0 * texel_solid_angle(row, 4, 8)).sum();
        assert!((solid - 4.0 * PI).abs() < 1e-12);
    }
}
