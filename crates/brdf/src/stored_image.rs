//! One image of an atlas as a file: its numbers, scaled where they are halves, and what its header says.

use std::path::Path;

use ndarray::Array3;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::error::{Error, Result};
use crate::exr_image::{self, Place, Precision};
use crate::files;
use crate::table_set::Storage;

/// Exponent of the power of two at which the largest value of a half table is stored: 2^11 < peak <= 2^12.
///
/// Half floats keep their full precision of 2^-11 down to 2^-14, so values down to 2^-26 = 1.5e-8 of the peak are rounded
/// by at most 2^-11 of themselves, and those below by at most 2^-37 = 7.3e-12 of the peak (half the step 2^-24 of the
/// subnormal numbers, over 2^12). Above the peak 4 bits are left free, so that a reader that filters,
/// sums or converts colours in half floats does not overflow at 65504.
const PEAK_EXPONENT: i32 = 12;

pub(crate) const FIX: &str = "Restore specimen.json and the files beside it, or run the pipeline again.";

/// One axis of an image: positions of the first and the last texel centre, evenly spaced in between.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Axis {
    /// Coordinate at the centre of the first column or row.
    pub first: f64,
    /// Coordinate at the centre of the last column or row.
    pub last: f64,
    /// Number of columns or rows.
    pub samples: usize,
}

/// One array in one file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StoredArray {
    /// Name of the EXR file in the specimen's folder.
    pub file: String,
    /// Factor, a power of two: value = stored number times scale.
    pub scale: f64,
    /// Largest absolute value in 1/sr.
    pub peak: f64,
    /// Values that are not zero but were stored as zero.
    pub flushed: u64,
    /// Largest rounding error over the peak.
    pub rounding: f64,
}

impl Axis {
    /// The same axis from its other end.
    pub(crate) fn reversed(self) -> Self {
        Self { first: self.last, last: self.first, ..self }
    }
}

/// An image about to be written: its file, its format, and what its header says.
pub(crate) struct ImageJob<'a> {
    pub(crate) file: String,
    pub(crate) values: &'a Array3<f32>,
    pub(crate) storage: Storage,
    /// Number of the table in its first channel.
    pub(crate) order: usize,
    pub(crate) kind: &'static str,
    /// What columns and rows are, by name; an image of one row has columns alone.
    pub(crate) axes: Vec<(&'static str, Axis)>,
    /// Where it lies in a larger image; `None` where it is whole.
    pub(crate) place: Option<Place>,
}

impl ImageJob<'_> {
    /// Writes the image into an existing folder. Its header has besides what all images of the set have: a JSON object.
    pub(crate) fn write(&self, folder: &Path, of_set: &Value) -> Result<StoredArray> {
        let (scaled, stored) = scale_array(self.values, &self.file, self.storage);
        let mut attributes = of_set.clone();
        attributes["kind"] = json!(self.kind);
        attributes["order"] = json!(self.order);
        attributes["scale"] = json!(stored.scale);
        for (name, axis) in &self.axes {
            attributes[format!("{name}_first")] = json!(axis.first);
            attributes[format!("{name}_last")] = json!(axis.last);
        }
        let precision = match self.storage {
            Storage::Half => Precision::Half,
            Storage::Float => Precision::Float,
        };
        let image = scaled.as_ref().unwrap_or(self.values);
        let place = self.place.unwrap_or_else(|| Place::whole(image));
        exr_image::write_window(&folder.join(&self.file), image, place, precision, &attributes)?;
        Ok(stored)
    }
}

/// The numbers to store (`None`: the values themselves), and what storing them does. Values that are not finite pass
/// through, to be refused by the writer.
pub(crate) fn scale_array(values: &Array3<f32>, file: &str, storage: Storage) -> (Option<Array3<f32>>, StoredArray) {
    let peak = values.iter().fold(0f32, |peak, value| peak.max(value.abs()));
    let mut stored = StoredArray { file: file.to_owned(), scale: 1.0, peak: peak.into(), flushed: 0, rounding: 0.0 };
    if storage == Storage::Float {
        return (None, stored);
    }
    let scale = half_scale(peak);
    let mut largest_error = 0f64;
    let scaled = values.mapv(|value| {
        // Exact but for subnormal results, which are far below the smallest half float.
        let number = half::f16::from_f32(value / scale).to_f32();
        stored.flushed += u64::from(number == 0.0 && value != 0.0);
        largest_error = largest_error.max((f64::from(number) * f64::from(scale) - f64::from(value)).abs());
        // The unrounded number where it is not finite, so that the writer sees it.
        if value.is_finite() { number } else { value }
    });
    stored.scale = scale.into();
    stored.rounding = if peak > 0.0 { largest_error / f64::from(peak) } else { 0.0 };
    (Some(scaled), stored)
}

/// The power of two that brings `peak` into (2^11, 2^12]; 1 where everything is zero. Kept to normal 32-bit floats,
/// so that every reader can multiply by it.
pub fn half_scale(peak: f32) -> f32 {
    if peak == 0.0 || !peak.is_finite() {
        return 1.0;
    }
    let exponent = f64::from(peak).log2().ceil() as i32 - PEAK_EXPONENT;
    2f32.powi(exponent.clamp(-126, 127))
}

/// Rounds an array to what halves over its scale give back.
pub fn round_to_half(values: &mut Array3<f32>) {
    let scale = half_scale(values.iter().fold(0.0, |peak, value| peak.max(value.abs())));
    values.mapv_inplace(|value| half::f16::from_f32(value / scale).to_f32() * scale);
}

pub(crate) fn read_array(folder: &Path, stored: &StoredArray, shape: (usize, usize)) -> Result<Array3<f32>> {
    let path = folder.join(&stored.file);
    if !files::stays_below(&stored.file) {
        return Err(Error::bad_file(
            folder,
            format!("specimen.json names the file `{}`, outside its folder", stored.file),
            FIX,
        ));
    }
    let (mut values, _) = exr_image::read_rgb(&path)?;
    let (rows, columns, _) = values.dim();
    if (rows, columns) != shape {
        let what = format!("it holds {columns} x {rows} texels where specimen.json says {} x {}", shape.1, shape.0);
        return Err(Error::bad_file(&path, what, FIX));
    }
    values.mapv_inplace(|number| (f64::from(number) * stored.scale) as f32);
    if !values.iter().all(|value| value.is_finite()) {
        return Err(Error::bad_file(&path, "it holds values that are not finite", FIX));
    }
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_is_a_power_of_two_that_leaves_room_above_the_peak() {
        for peak in [1.0, 4096.0, 4097.0, 1e-3, 0.999, 3.4e38, 1.2e-38, 1e-45, f32::MIN_POSITIVE] {
            let scale = half_scale(peak);
            assert_eq!(f64::from(scale).log2().fract(), 0.0);
            assert!(scale.is_normal());
            let stored = peak / scale;
            assert!(stored <= 4096.0 && (stored > 2048.0 || scale == f32::MIN_POSITIVE), "{peak} {stored}");
        }
        assert_eq!(half_scale(0.0), 1.0);
    }

    #[test]
    fn rounding_and_flushing_are_counted() {
        // Peak 1 -> scale 2^-12. The subnormal floor in values is 2^-24 2^-12 = 2^-36; half of it rounds to even, 0.
        let tiny = 2f32.powi(-37);
        let values = Array3::from_shape_vec((1, 2, 3), vec![1.0, 0.0, tiny, tiny * 1.01, -tiny, 0.3]).unwrap();
        let (scaled, stored) = scale_array(&values, "x", Storage::Half);
        assert_eq!((stored.scale, stored.flushed, stored.peak), (2f64.powi(-12), 2, 1.0));
        assert_eq!(scaled.unwrap()[[0, 1, 0]], 2f32.powi(-24));
        // 0.3 = 1228.8 / 4096, where half floats step by 1: off by 0.2 / 4096, and 0.3 itself by at most 2^-26.
        assert!((stored.rounding - 0.2 / 4096.0).abs() <= 2f64.powi(-26), "{}", stored.rounding);
        let (none, exact) = scale_array(&values, "x", Storage::Float);
        assert!(none.is_none() && exact.flushed == 0 && exact.rounding == 0.0 && exact.scale == 1.0);
    }
}
