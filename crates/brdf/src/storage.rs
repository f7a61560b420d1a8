//! Tables in files: one EXR image per basis function, half floats scaled so that nothing visible is lost.

use std::path::Path;

use ndarray::Array3;
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::derived::DerivedLight;
use crate::error::{Error, Result};
use crate::exr_image::Place;
use crate::front_factor::FrontFactor;
use crate::parallel;
pub(crate) use crate::stored_image::FIX;
use crate::stored_image::{ImageJob, read_array};
use crate::table_set::{Basis, Lobe, Restriction, Rounding, Storage, TableSet};

pub use crate::stored_image::{Axis, StoredArray, half_scale, round_to_half};

/// What a renderer computes from tables in the Chebyshev basis.
const CHEBYSHEV_FORMULA: &str =
    "f = D (sum_n table_n T_n(2t - 1) + sum_n cross_n T_n(2t - 1) / |w|) + C lobe, t = |w| / sqrt(4 - u^2 - v^2)";
/// The same from tables made for certain scenes.
const RESTRICTED_FORMULA: &str = "f = D (sum_n table_n T_n(2s - 1) + sum_n cross_n T_n(2t - 1) / |w|) + C lobe, t = |w| / sqrt(4 - u^2 - v^2), s = (t - low) / (high - low)";
/// What a renderer computes from tables in powers of w.
const TAYLOR_FORMULA: &str = "f = D (sum_n table_n |w|^n) / w^2";

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
    /// The light under which a reader derives them from the spectral tables, where these alone are stored: there is then no file of
    /// tables and lobe.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub derived_under: Option<DerivedLight>,
}

impl StoredTables {
    /// What stands in the place of files for tables that were derived under a light; `storage` and `rounding` are those of the
    /// spectral tables.
    pub fn derived(set: &TableSet, light: DerivedLight, storage: Storage, rounding: Option<Rounding>) -> Self {
        let [u, v] = table_axes(set);
        Self {
            basis: set.basis,
            formula: CHEBYSHEV_FORMULA.to_owned(),
            storage,
            rounding,
            u,
            v,
            prefilter_width: set.prefilter_width,
            usable_radius: set.usable_radius,
            tables: Vec::new(),
            restriction: None,
            lobe: None,
            derived_under: Some(light),
        }
    }

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

/// Writes `table.NNN.exr`, where there is a lobe `lobe.exr` and `lobe.NNN.exr`, and where not every direction is covered
/// `range.exr`, into an existing folder.
pub fn write_tables(folder: &Path, set: &TableSet, storage: Storage) -> Result<StoredTables> {
    let [u, v] = table_axes(set);
    let shape = (v.samples, u.samples, 3);
    assert!(u.samples.min(v.samples) >= 2, "a table set holds at least one table of 2 x 2 texels");

    let place =
        set.restriction.as_ref().map(|restriction| Place { first: restriction.first, whole: [restriction.size; 2] });
    let of_tables = |file: String, kind, order, values, storage| ImageJob {
        file,
        kind,
        order,
        values,
        storage,
        axes: vec![("u", u), ("v", v)],
        place,
    };
    let table_jobs = set.tables.iter().enumerate().map(|(order, values)| {
        assert_eq!(values.dim(), shape, "all tables have the same size");
        of_tables(format!("table.{order:03}.exr"), "table", order, values, storage)
    });
    let mut jobs: Vec<ImageJob> = table_jobs.collect();
    let axes = set.lobe.as_ref().map(lobe_axes);
    if let (Some(lobe), Some(axes)) = (&set.lobe, &axes) {
        jobs.extend(lobe_jobs(lobe, axes, storage));
    }
    jobs.extend(set.restriction.as_ref().map(|restriction| {
        assert_eq!(restriction.range.dim(), shape, "ranges are those of the tables' texels");
        // Half floats from the start: nothing is rounded here.
        of_tables("range.exr".to_owned(), "range", 0, &restriction.range, Storage::Half)
    }));
    // Collected in the order of the jobs, whatever thread wrote which.
    let of_set = json!({
        "basis": set.basis, "prefilter_width": set.prefilter_width, "usable_radius": set.usable_radius,
        "channels": "X, Y, Z in 1/sr",
    });
    let mut stored: Vec<StoredArray> = parallel::map(&jobs, |job| job.write(folder, &of_set))?;
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
        derived_under: None,
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
        return [whole, whole.reversed()];
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

fn lobe_axes(lobe: &Lobe) -> LobeAxes {
    let (t_samples, radius_samples, _) = lobe.coherent.dim();
    let cross = lobe.cross.first().map(|patch| {
        let u = Axis { first: -lobe.radius_max, last: lobe.radius_max, samples: patch.dim().1 };
        (u, u.reversed())
    });
    LobeAxes {
        radius: Axis { first: 0.0, last: lobe.radius_max, samples: radius_samples },
        t: Axis { first: 0.0, last: 1.0, samples: t_samples },
        cross,
    }
}

fn lobe_jobs<'a>(lobe: &'a Lobe, axes: &LobeAxes, storage: Storage) -> Vec<ImageJob<'a>> {
    let mut jobs = vec![ImageJob {
        file: "lobe.exr".to_owned(),
        kind: "lobe",
        order: 0,
        values: &lobe.coherent,
        // Divided by w², the lobe is what a mirror shows: its small file is not worth any rounding.
        storage: Storage::Float,
        axes: vec![("radius", axes.radius), ("t", axes.t)],
        place: None,
    }];
    if let Some((u, v)) = axes.cross {
        jobs.extend(lobe.cross.iter().enumerate().map(|(order, values)| {
            assert_eq!(
                values.dim(),
                (v.samples, u.samples, 3),
                "all patches of the cross term have the same square size"
            );
            ImageJob {
                file: format!("lobe.{order:03}.exr"),
                kind: "cross",
                order,
                values,
                storage,
                axes: vec![("u", u), ("v", v)],
                place: None,
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
