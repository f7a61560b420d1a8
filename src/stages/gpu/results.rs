//! What the GPU stage found out, as plain data.

use ndarray::Array3;
use serde::{Deserialize, Serialize};

use diffraction_build::ground::metrics::ColourDifference;
use diffraction_render::render::gpu::GpuInfo;
use diffraction_render::render::gpu_frame::FrameTime;

/// Outcome of the GPU stage.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "state", rename_all = "snake_case")]
pub enum GpuResult {
    /// Switched off in the manifest.
    Off,
    /// Wanted where possible, but not possible here.
    Skipped {
        /// Why.
        why: String,
    },
    /// An adapter is there but cannot be used; also a failure of the run.
    Unusable {
        /// Why.
        why: String,
    },
    /// Done, or as far as it came: what stopped it is a failure of the run.
    Checked {
        /// The adapter, its driver, limits and features.
        gpu: Box<GpuInfo>,
        /// One row per scene of a specimen.
        rows: Vec<GpuRow>,
        /// One row per specimen with spectral tables.
        #[serde(default)]
        spectral: Vec<GpuSpectralRow>,
        /// How long a frame takes, where that was measured.
        frames: Option<Box<FrameComparison>>,
    },
}

/// How a scene on the GPU compares with the CPU. Differences are those of X, Y or Z, as shares of the display's white.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct GpuSceneCheck {
    /// The scene's name.
    pub scene: String,
    /// Pixels compared.
    pub pixels: usize,
    /// Samples shaded.
    pub samples: usize,
    /// Largest difference.
    pub worst: f64,
    /// Mean difference.
    pub mean: f64,
    /// Largest difference that a pixel was allowed, derived from the hardware's rounding and filtering.
    pub tolerance: f64,
    /// Mean difference that the pixels were allowed.
    pub tolerance_mean: f64,
    /// The largest share that a difference takes of what its own pixel was allowed; above 1 fails.
    pub worst_of_tolerance: f64,
    /// Row and column of that pixel among those compared.
    pub worst_pixel: [usize; 2],
    /// Values from the GPU that are not finite; any fails.
    pub not_finite: usize,
    /// Colour differences between the two pictures.
    pub ciede2000: ColourDifference,
    /// Whether every value is finite and within its pixel's tolerance.
    pub passed: bool,
    /// Picture of the differences where the check fails, for a PNG: grey up to what a pixel was allowed,
    /// red beyond, magenta where the GPU's value is not finite.
    #[serde(skip)]
    pub difference: Option<Array3<u8>>,
}

/// How a scene on the GPU compares with the reference. Differences are those of X, Y or Z, as shares of the display's
/// white, or of the value itself where that is brighter.
///
/// What separates the two pictures are the tables (what the manifest's tolerance is about), the linear look-ups of
/// graphics hardware (their difference from cubic ones, found on the CPU at the same pixel), and the GPU's rounding (its
/// bound). Where every value is within a relative limit so is their sum, hence: what look-up and rounding leave of the
/// differences must be within [`ReferenceCheck::limit`] of the light shown. A mean or quantile over pixels would not do:
/// gratings leave most of them dark.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReferenceCheck {
    /// Pixels compared.
    pub pixels: usize,
    /// Largest difference of the GPU's picture from the reference.
    pub worst: f64,
    /// Mean difference.
    pub mean: f64,
    /// Mean difference of the CPU's picture from the reference, with the same linear look-ups.
    pub mean_by_cpu: f64,
    /// Mean share of the linear look-ups.
    pub look_up_mean: f64,
    /// Sum of what look-ups and rounding leave unexplained, over the light shown: the sum of all values, white where they
    /// are brighter.
    pub unexplained: f64,
    /// What that share may be: the tolerance for number of tables and wavelength step each, and half a unit in the last place.
    pub limit: f64,
    /// The largest share that `|GPU - reference|` takes of `|CPU - reference|` and the GPU's bound together; above 1 fails.
    pub worst_of_tolerance: f64,
    /// Root of the summed squared differences over the root of the summed squares.
    pub relative_l2: f64,
    /// Colour differences between the two pictures.
    pub ciede2000: ColourDifference,
    /// Whether the GPU adds no more than its bound.
    pub passed: bool,
    /// Whether the tables are as good as the tolerance says: `unexplained <= limit`.
    pub accurate: bool,
    /// Picture of the differences where the check fails.
    #[serde(skip)]
    pub difference: Option<Array3<u8>>,
}

/// How a published picture compares with the same by the GPU, with the look-ups that it was made with.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PictureCheck {
    /// Pixels compared.
    pub pixels: usize,
    /// Root of the summed squared differences over the root of the summed squares.
    pub relative_l2: f64,
    /// What that may be.
    pub limit: f64,
    /// Colour differences between the two pictures.
    pub ciede2000: ColourDifference,
    /// Whether it is within its limit.
    pub passed: bool,
    /// Picture of the differences where it is not: grey up to the limit's share of the brightest value, red beyond.
    #[serde(skip)]
    pub difference: Option<Array3<u8>>,
}

/// One scene of one specimen on the GPU.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct GpuRow {
    /// The specimen.
    pub specimen: String,
    /// Against the CPU, at the same points and by the same linear look-ups.
    pub cpu: GpuSceneCheck,
    /// Against the published picture.
    #[serde(default)]
    pub picture: Option<PictureCheck>,
    /// Against the published reference picture, where there is one.
    pub reference: Option<ReferenceCheck>,
    /// Whether the manifest leaves number of tables and steps to the tolerance; only then must the tables meet it.
    pub promised: bool,
    /// Path of the picture of the differences, where a comparison failed.
    pub difference_png: Option<String>,
}

impl GpuRow {
    /// Whether nothing is wrong.
    pub fn passed(&self) -> bool {
        let meets = |reference: &ReferenceCheck| reference.passed && (reference.accurate || !self.promised);
        self.cpu.passed
            && self.picture.as_ref().is_none_or(|picture| picture.passed)
            && self.reference.as_ref().is_none_or(meets)
    }

    /// What is wrong, in words.
    pub fn complaint(&self) -> Option<String> {
        let scene = &self.cpu.scene;
        if !self.cpu.passed {
            let [row, column] = self.cpu.worst_pixel;
            return Some(format!(
                "scene \"{scene}\": row {row}, column {column} differs from the CPU by {} times what rounding and \
                 filtering allow (worst difference {:.2e} of white, {} values not finite)",
                times(self.cpu.worst_of_tolerance),
                self.cpu.worst,
                self.cpu.not_finite
            ));
        }
        if let Some(picture) = self.picture.as_ref().filter(|picture| !picture.passed) {
            return Some(format!(
                "scene \"{scene}\": the published picture differs from the same by the GPU by {:.1e} of its light, more than {:.0e}: it was not \
                 made from these tables, or the GPU is wrong",
                picture.relative_l2, picture.limit
            ));
        }
        let reference = self.reference.as_ref()?;
        if !reference.passed {
            return Some(format!(
                "scene \"{scene}\": a pixel is {} times as far from the reference as the CPU and the GPU's rounding together",
                times(reference.worst_of_tolerance)
            ));
        }
        (self.promised && !reference.accurate).then(|| {
            format!(
                "scene \"{scene}\": {:.1e} of the light shown differs from the reference beside what look-ups and rounding \
                 explain; the tolerance promises {:.1e}: the tables are wrong",
                reference.unexplained, reference.limit
            )
        })
    }
}

/// A specimen's spectral tables on the GPU against the CPU, value by value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct GpuSpectralRow {
    /// The specimen.
    pub specimen: String,
    /// Values compared, each at a pair of directions and a wavelength.
    pub values: usize,
    /// Those from the GPU that are not finite; any fails.
    pub not_finite: usize,
    /// Those that are farther off than the hardware's rounding and filtering allow.
    pub beyond: usize,
    /// The largest share that a difference takes of what its own value was allowed.
    pub worst_of_tolerance: f64,
}

impl GpuSpectralRow {
    /// Whether nothing is wrong.
    pub fn passed(&self) -> bool {
        self.beyond == 0
    }

    /// What is wrong, in words.
    pub fn complaint(&self) -> Option<String> {
        (!self.passed()).then(|| {
            format!(
                "spectral tables: {} of {} values differ from the CPU by more than rounding and filtering allow, the worst by {} \
                 times as much ({} not finite)",
                self.beyond,
                self.values,
                times(self.worst_of_tolerance),
                self.not_finite
            )
        })
    }
}

/// A factor, readable whether just above 1 or beyond counting.
fn times(factor: f64) -> String {
    if factor < 1e3 { format!("{factor:.3}") } else { format!("{factor:.1e}") }
}

/// Frame times of the atlas's tables and of the published method's at equal error, from one run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FrameComparison {
    /// The specimen.
    pub specimen: String,
    /// The atlas's tables.
    pub atlas: MethodFrame,
    /// The published method's tables; `None` where it is refused.
    pub taylor: Option<MethodFrame>,
    /// Why it is refused.
    pub refused: Option<String>,
    /// What copying within the GPU's memory reaches, bytes read and written counted.
    pub copy_gb_per_s: f64,
}

/// One method's frame.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MethodFrame {
    /// 95th percentile of the luminance's relative error as the GPU holds the tables, with cubic look-ups: over the
    /// hemisphere, near the mirror direction, at grazing angles.
    pub error_p95: [f64; 3],
    /// The time.
    pub time: FrameTime,
}

impl FrameComparison {
    /// How many times as long a frame takes with the published method.
    pub fn ratio(&self) -> Option<f64> {
        self.taylor.as_ref().map(|taylor| taylor.time.median_ms / self.atlas.time.median_ms)
    }

    /// One line for the screen.
    pub(crate) fn in_words(&self) -> String {
        let one = |frame: &MethodFrame| format!("{} tables {:.3} ms", frame.time.tables, frame.time.median_ms);
        let side = self.atlas.time.size_px;
        let published = match (&self.taylor, self.ratio()) {
            (Some(taylor), Some(ratio)) => format!("the published method's {}, {ratio:.2} times as long", one(taylor)),
            _ => "the published method is refused".into(),
        };
        format!("{}: the snake in {side}² pixels from {}; {published}", self.specimen, one(&self.atlas))
    }
}
