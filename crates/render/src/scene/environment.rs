//! Light from all around: an image in longitude and latitude, its radiance in a direction, and directions drawn from it.
//!
//! Longitude runs along the columns, the middle one being world +z, where the camera is; seen from the object,
//! columns to the right lie to the right, towards world -x. The top row is world +y. Radiance is constant over a texel,
//! and the light has the illuminant's spectrum everywhere.

use std::f64::consts::{PI, TAU};
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ndarray::{Array2, Axis};
use serde::{Deserialize, Serialize};

use super::exr_foreign::read_luminance;
use super::turn::{Turn, back, turned};
use diffraction_brdf::direction::Vec3;
use diffraction_brdf::error::{Error, Result};

/// An environment, ready to light a scene.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Environment {
    /// The image file.
    pub file: PathBuf,
    /// Its SHA-256, hexadecimal.
    pub sha256: String,
    /// Turn of the whole image, that of the lights in an animation.
    #[serde(default)]
    pub turn: Turn,
    /// What was read from the file by [`load`]; a scene without it is refused.
    #[serde(skip)]
    pub sky: Arc<Sky>,
}

/// The image's light.
#[derive(Clone, PartialEq, Default)]
pub struct Sky {
    /// Radiance of each texel.
    radiance: Array2<f32>,
    /// Turn about the vertical, from +z towards +x.
    rotate_deg: f64,
    /// `∫ L dω` up to the end of each row.
    rows: Vec<f64>,
    /// Share of its row's light up to the end of each texel.
    columns: Array2<f32>,
}

/// Without the texels: scenes are shown in messages.
impl fmt::Debug for Sky {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Sky").field("size", &self.radiance.dim()).finish_non_exhaustive()
    }
}

impl Sky {
    /// Turn about the vertical in degrees, and all of the light: with the file's digest they tell which sky it is.
    pub fn rotation_and_light(&self) -> [f64; 2] {
        [self.rotate_deg, self.rows.last().copied().unwrap_or(0.0)]
    }
}

/// Reads an image, turns it about the vertical by `rotate_deg` (from +z towards +x, counter-clockwise seen from
/// above), and multiplies its luminance by `scale`.
///
/// # Errors
/// An image that cannot be read, is not twice as wide as high, or is black.
pub fn load(path: &Path, rotate_deg: f64, scale: f64) -> Result<Environment> {
    let (luminance, sha256) = read_luminance(path)?;
    let (rows, columns) = luminance.dim();
    if columns != 2 * rows {
        return Err(Error::bad_file(
            path,
            format!("it has {columns} x {rows} pixels, which is not all directions: twice as wide as high"),
            "Save the whole sphere in longitude and latitude (equirectangular).",
        ));
    }
    let Some(sky) = sky(luminance.mapv_into(|l| (f64::from(l) * scale) as f32), rotate_deg) else {
        return Err(Error::bad_file(path, "it is black and lights nothing", "Choose another image."));
    };
    Ok(Environment { file: path.to_owned(), sha256, turn: Turn::default(), sky: Arc::new(sky) })
}

/// The light of an image of radiances; `None` for a black one.
pub fn sky(radiance: Array2<f32>, rotate_deg: f64) -> Option<Sky> {
    let (height, width) = radiance.dim();
    let (mut rows, mut total) = (Vec::with_capacity(height), 0.0);
    let mut columns = Array2::zeros((height, width));
    for (row, (texels, mut shares)) in radiance.outer_iter().zip(columns.axis_iter_mut(Axis(0))).enumerate() {
        let sum: f64 = texels.iter().map(|&l| f64::from(l)).sum();
        let mut running = 0.0;
        for (share, &l) in shares.iter_mut().zip(texels) {
            running += f64::from(l);
            *share = if sum > 0.0 { (running / sum) as f32 } else { 1.0 };
        }
        total += texel_solid_angle(row, height, width) * sum;
        rows.push(total);
    }
    (total.is_finite() && total > 0.0).then_some(Sky { radiance, rotate_deg, rows, columns })
}

/// `∫ L dω` over all directions: a sky of uniform L has 4π L, and π L falls on the ground below it. 0 before reading.
pub fn scalar_irradiance(environment: &Environment) -> f64 {
    environment.sky.rows.last().copied().unwrap_or(0.0)
}

/// Radiance from a direction in the world.
pub fn radiance(environment: &Environment, to_light: Vec3) -> f64 {
    let sky = &*environment.sky;
    let (rows, columns) = sky.radiance.dim();
    let [x, y, z] = turned(to_light, back(environment.turn));
    let row = (y.clamp(-1.0, 1.0).acos() / PI * rows as f64) as usize;
    let turns = ((-x).atan2(z) + sky.rotate_deg.to_radians()) / TAU + 0.5;
    let column = ((turns - turns.floor()) * columns as f64) as usize;
    f64::from(sky.radiance[[row.min(rows - 1), column.min(columns - 1)]])
}

/// The direction in the world that belongs to a point of the unit square: where points are spread evenly, directions
/// are distributed like the radiance.
///
/// The second coordinate finds a row by the rows' shares of the light, the first a texel by its share of the row's; within
/// a texel equal areas are equal solid angles.
pub(crate) fn direction_by_light(environment: &Environment, [along, across]: [f64; 2]) -> Vec3 {
    let sky = &*environment.sky;
    let (height, width) = sky.radiance.dim();
    let target = across * sky.rows[height - 1];
    let row = sky.rows.partition_point(|&sum| sum <= target).min(height - 1);
    let below = if row == 0 { 0.0 } else { sky.rows[row - 1] };
    let down = ((target - below) / (sky.rows[row] - below)).clamp(0.0, 1.0);
    let shares = sky.columns.row(row);
    let share = |column: usize| f64::from(shares[column]);
    let (mut column, mut after) = (0, width - 1);
    while column < after {
        let middle = (column + after) / 2;
        if share(middle) <= along { column = middle + 1 } else { after = middle }
    }
    let before = if column == 0 { 0.0 } else { share(column - 1) };
    let right = ((along - before) / (share(column) - before).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    let direction = direction([height, width], row as f64 + down, column as f64 + right, sky.rotate_deg);
    turned(direction, environment.turn)
}

/// Solid angle of a texel in sr.
fn texel_solid_angle(row: usize, rows: usize, columns: usize) -> f64 {
    TAU / columns as f64 * (sine(row, rows) - sine(row + 1, rows))
}

/// Sine of the latitude of the upper edge of a row.
fn sine(row: usize, rows: usize) -> f64 {
    (PI * row as f64 / rows as f64).cos()
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
    use crate::scene::turn::Axis as TurnAxis;
    use diffraction_brdf::direction::dot;
    use diffraction_build::ground::sampling::plane;

    fn environment(image: Array2<f32>, rotate_deg: f64, turn: Turn) -> Environment {
        let sky = Arc::new(sky(image, rotate_deg).unwrap());
        Environment { file: PathBuf::new(), sha256: String::new(), turn, sky }
    }

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
    fn a_direction_has_the_radiance_of_the_texel_it_was_drawn_from() {
        let image = Array2::from_shape_fn((4, 8), |(row, column)| (1 + 8 * row + column) as f32);
        let turn = Turn { axis: TurnAxis::Viewing, angle_deg: 70.0 };
        for (rotate_deg, turn) in [(0.0, Turn::default()), (-250.0, Turn::default()), (30.0, turn)] {
            let sky = environment(image.clone(), rotate_deg, turn);
            for (row, column) in (0..4).flat_map(|row| (0..8).map(move |column| (row, column))) {
                let inside = direction([4, 8], row as f64 + 0.3, column as f64 + 0.7, rotate_deg);
                assert_eq!(radiance(&sky, turned(inside, turn)), f64::from(image[[row, column]]));
            }
        }
    }

    #[test]
    fn one_bright_texel_gets_every_direction() {
        let mut image = Array2::zeros((16, 32));
        image[[5, 20]] = 3.0f32;
        let environment = environment(image, 30.0, Turn::default());
        let total = scalar_irradiance(&environment);
        assert!((total - 3.0 * texel_solid_angle(5, 16, 32)).abs() < 1e-12);
        let directions: Vec<Vec3> = (0..64).map(|index| direction_by_light(&environment, plane(index))).collect();
        let middle = direction([16, 32], 5.5, 20.5, 30.0);
        // Half a diagonal of 11.25 degrees by as much.
        assert!(directions.iter().all(|&d| dot(d, middle) > f64::to_radians(8.0).cos()));
        let mean = directions.iter().fold([0.0; 3], |sum, d| [0, 1, 2].map(|k| sum[k] + d[k] / 64.0));
        assert!(mean.iter().zip(middle).all(|(mean, middle)| (mean - middle).abs() < 0.01), "{mean:?} {middle:?}");
        assert!(sky(Array2::zeros((4, 8)), 0.0).is_none());
    }

    #[test]
    fn texels_get_directions_by_their_light() {
        let image = Array2::from_shape_fn((4, 8), |(row, column)| (1 + row * column) as f32);
        let environment = environment(image.clone(), 0.0, Turn::default());
        let (count, total) = (20_000, scalar_irradiance(&environment));
        let mut found = Array2::<f64>::zeros((4, 8));
        for [x, y, z] in (0..count).map(|index| direction_by_light(&environment, plane(index))) {
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
