//! What a study finds out, row by row.

use ndarray::Array3;
use serde::{Deserialize, Serialize};

use diffraction_build::ground::metrics::ErrorQuantiles;
use diffraction_build::ground::sampling::Region;
use diffraction_build::tables::model::{Basis, Storage};

/// Something that was refused, and why.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Refusal {
    /// A specimen, or a method with its setting.
    pub what: String,
    /// The program's own message.
    pub message: String,
}

/// One method at one setting.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MethodRow {
    /// Family: rows of one family are joined in plots.
    pub method: String,
    /// What was set, such as "8 tables".
    pub setting: String,
    /// Expansion, for tables.
    pub basis: Option<Basis>,
    /// Number format, for tables.
    pub storage: Option<Storage>,
    /// Seconds to build or fit; what must be done once.
    pub build_s: f64,
    /// Seconds per direction in a batch on one thread; tables with cubic look-ups, with which errors are measured.
    pub evaluate_s: f64,
    /// Wall seconds per direction with all threads at work.
    pub all_threads_s: f64,
    /// Seconds per direction on one thread with linear look-ups, for tables.
    pub bilinear_s: Option<f64>,
    /// Seconds per direction on the GPU, linear look-ups; for half tables where there is a GPU.
    pub gpu_s: Option<f64>,
    /// Memory that building took on top of what the process held, in bytes, where the system tells.
    pub peak_bytes: Option<u64>,
    /// Bytes a renderer has to hold.
    pub stored_bytes: u64,
    /// Errors by region.
    pub errors: Vec<RegionErrors>,
    /// Errors where (u, v) lies on texels, over the hemisphere: without the grid's share.
    pub on_texels: ErrorQuantiles,
    /// `∫ Y cos_o dω_o` at normal incidence over the usable disc: the share of power sent back. `None` for
    /// methods too slow to integrate.
    pub power_sum: Option<f64>,
    /// Colour differences in every scene, against the picture straight from the transforms.
    pub colours: Vec<SceneColour>,
    /// The pictures; of the reference in the row of the transforms.
    #[serde(skip)]
    pub pictures: Vec<Picture>,
}

/// How a method's picture of a scene differs in colour: CIEDE2000.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SceneColour {
    /// The scene.
    pub scene: String,
    /// Pixels compared.
    pub pixels: usize,
    /// Mean.
    pub mean: f64,
    /// 95th percentile.
    pub p95: f64,
    /// Largest.
    pub max: f64,
}

/// A small picture for people.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// The scene.
    pub scene: String,
    /// sRGB, `[rows, columns, 3]`.
    pub rgb: Array3<u8>,
}

/// Errors over the directions of one region.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct RegionErrors {
    /// Which directions.
    pub region: Region,
    /// `‖Y - Y_ref‖ / ‖Y_ref‖`, directions below the floor included.
    pub relative_l2: f64,
    /// Pointwise relative errors above the floor.
    pub quantiles: ErrorQuantiles,
}

/// One knob changed alone, everything else at its finest.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct KnobRow {
    /// The knob: "basis", "wavelength step", "grid, bilinear", "grid, cubic", "storage", "windows".
    pub knob: String,
    /// Its value for the axis of a plot: tables, nm, texels; 0 where it is not a number.
    pub value: f64,
    /// The setting for people.
    pub setting: String,
    /// Errors of Y over the whole hemisphere, above the floor.
    pub quantiles: ErrorQuantiles,
}
