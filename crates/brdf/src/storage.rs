//! Tables in files: one EXR image per basis function, half floats scaled so that nothing visible is lost.

use std::path::Path;

use ndarray::Array3;
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::error::{Error, Result};
use crate::exr_image::{self, Place, Precision};
use crate::files;
use crate::front_factor::FrontFactor;
use crate::parallel;
use crate::table_set::{Basis, Lobe, Restriction, Rounding, Storage, TableSet};

/// Exponent of the power of two at which the largest value of a half table is stored: 2^11 < peak <= 2^12.
///
/// Half floats keep their full precision of 2^-11 down to 2^-14, so values down to 2^-26 = 1.5e-8 of the peak are rounded
/// by at most 2^-11 of themselves, and those below by at most 2^-37 = 7.3e-12 of the peak (half the step 2^-24 of the
/// subnormal numbers, over 2^12). Above the peak 4 bits are left free, so that a reader that filters,
/// sums or converts colours in half floats does not overflow at 65504.
const PEAK_EXPONENT: i32 = 12;

pub(crate) const FIX: &str = "Restore specimen.json and the files beside it, or run the pipeline again.";

/// What a renderer computes from tables in the Chebyshev basis.
const CHEBYSHEV_FORMULA: &str =
    "f = D (sum_n table_n T_n(2t - 1) + sum_n cross_n T_n(2t - 1) / |w|) + C lobe, t = |w| / sqrt(4 - u^2 - v^2)";
/// The same from tables made for certain scenes.
const RESTRICTED_FORMULA: &str = "f = D (sum_n table_n T_n(2s - 1) + sum_n cross_n T_n(2t - 1) / |w|) + C lobe, t = |w| / sqrt(4 - u^2 - v^2), s = (t - low) / (high - low)";
/// What a renderer computes from tables in powers of w.
const TAYLOR_FORMULA: &str = "f = D (sum_n table_n |w|^n) / w^2";

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

/// The lobe's files.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StoredLobe {
    /// Radius `sqrt(u² + v²)` at and beyond which the coherent part is zero; half the side of the cross term's square.
    pub radius_max: f64,
    /// Columns of the coherent image.
    pub radius: Axis,
    /// Rows of the coherent image.
    pub t: Axis,
    /// The coherent part; always 32-bit floats.
    pub coherent: StoredArray,
    /// The cross term; `None` where it vanishes.
    pub cross: Option<StoredCross>,
}

/// The cross term's files.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StoredCross {
    /// Columns of the patches.
    pub u: Axis,
    /// Rows of the patches.
    pub v: Axis,
    /// The patches, one per Chebyshev polynomial.
    pub patches: Vec<StoredArray>,
}

/// What tables made for certain scenes can answer for.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StoredRestriction {
    /// Texels along u and v of the whole grid over [-2, 2], of which the tables are a window.
    pub size: usize,
    /// Row and column of the whole grid at which the window begins.
    pub first: [usize; 2],
    /// Channels R, G, B: lowest `t`, highest `t`, and 1 where a texel is covered or 0 where not; 16-bit floats, exact.
    pub range: StoredArray,
}

/// Everything needed to read the tables of a specimen again, apart from its optics.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StoredTables {
    /// Which expansion in `w`.
    pub basis: Basis,
    /// The formula in words of a program.
    pub formula: String,
    /// Number format of tables and cross term.
    pub storage: Storage,
    /// What storing did to the values; absent where the numbers were written as they were read.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rounding: Option<Rounding>,
    /// Columns of the tables.
    pub u: Axis,
    /// Rows of the tables.
    pub v: Axis,
    /// Side of the square in (u, v) over which each texel is averaged; 0 for point samples.
    pub prefilter_width: f64,
    /// Radius in (u, v) up to which the scans' sampling can answer.
    pub usable_radius: f64,
    /// The tables, one per basis function.
    pub tables: Vec<StoredArray>,
    /// What they can answer for; absent where they cover every direction.
    #[serde(rename = "served", default, skip_serializing_if = "Option::is_none")]
    pub restriction: Option<StoredRestriction>,
    /// The lobe; `None` for powers of `w`, and where no direction that they cover lies in it.
    pub lobe: Option<StoredLobe>,
}

impl StoredTables {
    /// Names of all files in the specimen's folder.
    pub(crate) fn files(&self) -> impl Iterator<Item = &str> {
        let lobe = self.lobe.iter().flat_map(|lobe| {
            let patches = lobe.cross.iter().flat_map(|cross| &cross.patches);
            std::iter::once(&lobe.coherent).chain(patches)
        });
        let range = self.restriction.iter().map(|restriction| &restriction.range);
        self.tables.iter().chain(lobe).chain(range).map(|array| array.file.as_str())
    }
}

/// An array about to be written: its file, its format, and what its header says.
struct Job<'a> {
    file: String,
    kind: &'static str,
    order: usize,
    values: &'a Array3<f32>,
    storage: Storage,
    columns: (&'static str, Axis),
    rows: (&'static str, Axis),
}

/// Writes `table.NNN.exr`, where there is a lobe `lobe.exr` and `lobe.NNN.exr`, and where not every direction is covered
/// `range.exr`, into an existing folder.
pub fn write_tables(folder: &Path, set: &TableSet, storage: Storage) -> Result<StoredTables> {
    let [u, v] = table_axes(set);
    let shape = (v.samples, u.samples, 3);
    assert!(u.samples.min(v.samples) >= 2, "a table set holds at least one table of 2 x 2 texels");

    let table_jobs = set.tables.iter().enumerate().map(|(order, values)| {
        assert_eq!(values.dim(), shape, "all tables have the same size");
        Job {
            file: format!("table.{order:03}.exr"),
            kind: "table",
            order,
            values,
            storage,
            columns: ("u", u),
            rows: ("v", v),
        }
    });
    let mut jobs: Vec<Job> = table_jobs.collect();
    let axes = set.lobe.as_ref().map(lobe_axes);
    if let (Some(lobe), Some(axes)) = (&set.lobe, &axes) {
        jobs.extend(lobe_jobs(lobe, axes, storage));
    }
    jobs.extend(set.restriction.as_ref().map(|restriction| {
        assert_eq!(restriction.range.dim(), shape, "ranges are those of the tables' texels");
        Job {
            file: "range.exr".to_owned(),
            kind: "range",
            order: 0,
            values: &restriction.range,
            // Half floats from the start: nothing is rounded here.
            storage: Storage::Half,
            columns: ("u", u),
            rows: ("v", v),
        }
    }));
    // Collected in the order of the jobs, whatever thread wrote which.
    let mut stored: Vec<StoredArray> = parallel::map(&jobs, |job| write_array(folder, set, job))?;
    let restriction = set.restriction.as_ref().zip(stored.pop_if(|last| last.file == "range.exr"));
    let lobe_arrays = stored.split_off(set.tables.len());
    let formula = match (set.basis, &set.restriction) {
        (Basis::Chebyshev, None) => CHEBYSHEV_FORMULA,
        (Basis::Chebyshev, Some(_)) => RESTRICTED_FORMULA,
        (Basis::Taylor, _) => TAYLOR_FORMULA,
    };
    Ok(StoredTables {
        basis: set.basis,
        formula: formula.to_owned(),
        restriction: restriction.map(|(restriction, range)| StoredRestriction {
            size: restriction.size,
            first: restriction.first,
            range,
        }),
        storage,
        rounding: None,
        u,
        v,
        prefilter_width: set.prefilter_width,
        usable_radius: set.usable_radius,
        tables: stored,
        lobe: set.lobe.as_ref().zip(axes).map(|(lobe, axes)| stored_lobe(lobe, axes, lobe_arrays)),
    })
}

/// Reads what [`write_tables`] wrote; `front_factor` is that of their material.
///
/// # Errors
/// Files that are missing or damaged, and shapes that do not fit each other: what is returned can be evaluated everywhere.
pub fn read_tables(folder: &Path, stored: &StoredTables, front_factor: FrontFactor) -> Result<TableSet> {
    let shape = (stored.v.samples, stored.u.samples);
    let read_all =
        |arrays: &[StoredArray], shape: (usize, usize)| parallel::map(arrays, |array| read_array(folder, array, shape));
    let lobe = match &stored.lobe {
        None => None,
        Some(lobe) => Some(Lobe {
            coherent: read_array(folder, &lobe.coherent, (lobe.t.samples, lobe.radius.samples))?,
            radius_max: lobe.radius_max,
            cross: match &lobe.cross {
                None => Vec::new(),
                Some(cross) => read_all(&cross.patches, (cross.v.samples, cross.u.samples))?,
            },
        }),
    };
    let set = TableSet {
        basis: stored.basis,
        tables: read_all(&stored.tables, shape)?,
        lobe,
        prefilter_width: stored.prefilter_width,
        front_factor,
        restriction: match &stored.restriction {
            None => None,
            Some(restriction) => Some(Restriction {
                size: restriction.size,
                first: restriction.first,
                range: read_array(folder, &restriction.range, shape)?,
            }),
        },
        usable_radius: stored.usable_radius,
    };
    check_read(&set, stored).map_err(|what| Error::bad_file(&folder.join("specimen.json"), what, FIX))?;
    Ok(set)
}

/// Whether what was read can be evaluated, and lies where specimen.json says.
fn check_read(set: &TableSet, stored: &StoredTables) -> std::result::Result<(), String> {
    set.check().map_err(|what| format!("it describes tables that cannot be evaluated: {what}"))?;
    let near = |a: f64, b: f64| (a - b).abs() < 1e-9;
    for ((name, said), due) in [("u", stored.u), ("v", stored.v)].into_iter().zip(table_axes(set)) {
        if !(near(said.first, due.first) && near(said.last, due.last)) {
            let (first, last) = (said.first, said.last);
            return Err(format!("its axis {name} runs from {first} to {last}, not from {} to {}", due.first, due.last));
        }
    }
    Ok(())
}

/// Columns and rows of the tables: the whole square, or the covered window of it.
fn table_axes(set: &TableSet) -> [Axis; 2] {
    let (rows, columns, _) = set.tables.first().map_or((0, 0, 0), Array3::dim);
    let whole = Axis { first: -2.0, last: 2.0, samples: columns };
    let Some(Restriction { size, first: [row, column], .. }) = set.restriction else {
        return [whole, reversed(whole)];
    };
    let at = |texel: usize| -2.0 + 4.0 * texel as f64 / (size - 1) as f64;
    let u = Axis { first: at(column), last: at(column + columns - 1), samples: columns };
    [u, Axis { first: -at(row), last: -at(row + rows - 1), samples: rows }]
}

/// Axes of the lobe's images: radius, t, and for the cross term u and v.
#[derive(Clone, Copy)]
struct LobeAxes {
    radius: Axis,
    t: Axis,
    cross: Option<(Axis, Axis)>,
}

fn reversed(axis: Axis) -> Axis {
    Axis { first: axis.last, last: axis.first, ..axis }
}

fn lobe_axes(lobe: &Lobe) -> LobeAxes {
    let (t_samples, radius_samples, _) = lobe.coherent.dim();
    let cross = lobe.cross.first().map(|patch| {
        let u = Axis { first: -lobe.radius_max, last: lobe.radius_max, samples: patch.dim().1 };
        (u, reversed(u))
    });
    LobeAxes {
        radius: Axis { first: 0.0, last: lobe.radius_max, samples: radius_samples },
        t: Axis { first: 0.0, last: 1.0, samples: t_samples },
        cross,
    }
}

fn lobe_jobs<'a>(lobe: &'a Lobe, axes: &LobeAxes, storage: Storage) -> Vec<Job<'a>> {
    let mut jobs = vec![Job {
        file: "lobe.exr".to_owned(),
        kind: "lobe",
        order: 0,
        values: &lobe.coherent,
        // Divided by w², the lobe is what a mirror shows: its small file is not worth any rounding.
        storage: Storage::Float,
        columns: ("radius", axes.radius),
        rows: ("t", axes.t),
    }];
    if let Some((u, v)) = axes.cross {
        jobs.extend(lobe.cross.iter().enumerate().map(|(order, values)| {
            assert_eq!(
                values.dim(),
                (v.samples, u.samples, 3),
                "all patches of the cross term have the same square size"
            );
            Job {
                file: format!("lobe.{order:03}.exr"),
                kind: "cross",
                order,
                values,
                storage,
                columns: ("u", u),
                rows: ("v", v),
            }
        }));
    }
    jobs
}

fn stored_lobe(lobe: &Lobe, axes: LobeAxes, mut arrays: Vec<StoredArray>) -> StoredLobe {
    let patches = arrays.split_off(1);
    StoredLobe {
        radius_max: lobe.radius_max,
        radius: axes.radius,
        t: axes.t,
        coherent: arrays.swap_remove(0),
        cross: axes.cross.map(|(u, v)| StoredCross { u, v, patches }),
    }
}

fn write_array(folder: &Path, set: &TableSet, job: &Job) -> Result<StoredArray> {
    let path = folder.join(&job.file);
    let (scaled, stored) = scale_array(job.values, &job.file, job.storage);
    let mut attributes = json!({
        "kind": job.kind, "basis": set.basis, "order": job.order, "scale": stored.scale,
        "prefilter_width": set.prefilter_width, "usable_radius": set.usable_radius, "channels": "X, Y, Z in 1/sr",
    });
    for (name, axis) in [job.columns, job.rows] {
        attributes[format!("{name}_first")] = json!(axis.first);
        attributes[format!("{name}_last")] = json!(axis.last);
    }
    let precision = match job.storage {
        Storage::Half => Precision::Half,
        Storage::Float => Precision::Float,
    };
    let image = scaled.as_ref().unwrap_or(job.values);
    let place = match (&set.restriction, job.kind) {
        (Some(restriction), "table" | "range") => Place { first: restriction.first, whole: [restriction.size; 2] },
        _ => Place::whole(image),
    };
    exr_image::write_window(&path, image, place, precision, &attributes)?;
    Ok(stored)
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
