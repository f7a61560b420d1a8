//! Everything a run found out, as plain data: what the stages hand to the report and to `report.json`.
//!
//! Picture paths are relative to the folder that holds `report.html`. A measured number that could
//! not be determined is NaN in memory, `null` in JSON and a dash in the report.

use serde::{Deserialize, Serialize};

use super::cache::store::CacheUse;
use super::goniometry::Goniometry;
pub use super::gpu::results::{GpuResult, GpuRow};
use super::stage::Stage;
use crate::stages::measured::MeasuredResult;
use diffraction_brdf::error::{Error, Result};
use diffraction_build::accuracy::power_sums::{DirectionalAlbedo, PowerSum};
use diffraction_build::accuracy::rows::{ErrorRow, promised};
use diffraction_build::ground::null_for_nan;
pub use diffraction_build::height::quality::{Grade, Verdict};
pub use diffraction_build::height::statistics::{Period, Statistics};
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::optics::pigment::Pigment;
use diffraction_build::tables::coverage::budget::{Budget, Cost};
use diffraction_build::tables::model::{Basis, BuildRecord, Rounding, Storage};

/// Version of the layout of `report.json`; raised when a field changes its meaning or disappears.
pub const RESULTS_SCHEMA: u32 = 2;

/// A whole run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RunResults {
    /// [`RESULTS_SCHEMA`] of the program that wrote this.
    pub schema: u32,
    /// Name of the atlas, from the manifest.
    pub atlas_name: String,
    /// The version that this run publishes if anything has changed, such as `v0003`; `None` where every specimen failed.
    pub version: Option<String>,
    /// Version of the program.
    pub program_version: String,
    /// When the run began: UTC in RFC 3339.
    pub started: String,
    /// Threads the run used.
    pub threads: usize,
    /// Logical processors of the machine.
    pub cpu_count: usize,
    /// The manifest, word for word.
    pub manifest_text: String,
    /// One entry per specimen, in the manifest's order; in short where there are more than [`WHOLE_MAX`].
    pub specimens: Vec<SpecimenResult>,
    /// The scenes that several specimens share, in the manifest's order.
    #[serde(default)]
    pub shared_scenes: Vec<SharedSceneResult>,
    /// Times, in the order the stages ended in.
    pub stages: Vec<StageTime>,
    /// Outcome of the GPU stage.
    pub gpu: GpuResult,
    /// What went wrong, in the order it happened.
    pub failures: Vec<Failure>,
    /// What nobody asked for and was not done: specimens, pictures, stages.
    #[serde(default)]
    pub left_out: Vec<String>,
    /// What the cache knew; `None` where the run had none.
    #[serde(default)]
    pub cache: Option<CacheUse>,
    /// Most memory the process held, in MiB, where the system tells.
    pub peak_memory_mib: Option<f64>,
    /// Duration of the run in seconds.
    pub total_wall_s: f64,
}

/// Most specimens of which a run's results hold everything, and one page tells it. Of more they hold what an overview shows, each has a
/// page of its own, and its `result.json` holds the rest: so memory hardly grows with their number.
pub const WHOLE_MAX: usize = 20;

impl RunResults {
    /// Whether there are too many specimens to tell everything of each in one place.
    pub fn is_of_many(&self) -> bool {
        self.specimens.len() > WHOLE_MAX
    }
}

/// Duration of one stage.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StageTime {
    /// Which stage.
    pub name: Stage,
    /// The specimen it worked on; `None` for what concerns the whole atlas.
    pub specimen: Option<String>,
    /// Elapsed seconds.
    pub wall_s: f64,
    /// Processor seconds over all threads, where measured.
    pub cpu_s: Option<f64>,
}

/// One thing that went wrong without stopping the run.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Failure {
    /// The specimen it concerns, if any.
    pub specimen: Option<String>,
    /// The stage that failed.
    pub stage: Stage,
    /// What happened and what to do about it.
    pub message: String,
}

/// One specimen, from its scans to its measured errors.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SpecimenResult {
    /// Name, from the manifest; also its folder in the atlas.
    pub name: String,
    /// Species, from the manifest.
    pub species: Option<String>,
    /// Whether the heights were generated rather than scanned.
    pub generated: bool,
    /// Provenance of each scan, one JSON object each.
    pub scans: Vec<serde_json::Value>,
    /// Samples along x and y.
    pub size: [usize; 2],
    /// Sample spacing in nm along x and y.
    pub pitch_nm: [f64; 2],
    /// Extent in µm along x and y.
    pub extent_um: [f64; 2],
    /// Statistics of the prepared heights; `None` where reading them failed.
    pub statistics: Option<Statistics>,
    /// The optics the tables were computed for.
    pub optics: Option<OpticsConfig>,
    /// What pictures show below the structure.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pigment: Option<Pigment>,
    /// What was built; `None` where building failed.
    pub build: Option<BuildResult>,
    /// The coherent lobe, for tables that keep it apart.
    pub lobe: Option<LobeResult>,
    /// Measured errors against the reference evaluator.
    pub errors: Vec<ErrorRow>,
    /// Sums over the hemisphere of `f cos_theta_o`, for unit Fresnel reflectance.
    pub power_sums: Vec<PowerSum>,
    /// Share of the arriving light that the specimen's own material reflects, up to grazing light.
    #[serde(default)]
    pub albedo: Vec<DirectionalAlbedo>,
    /// Comparison with measured reflectance, where the manifest names some.
    #[serde(default)]
    pub measured: Option<MeasuredResult>,
    /// Which colours it shows from which angles; `None` where its tables are restricted to scenes.
    #[serde(default)]
    pub goniometry: Option<Goniometry>,
    /// The scenes rendered with the tables.
    pub scenes: Vec<SceneResult>,
    /// Picture of the heights.
    pub height_map: Option<HeightMapFile>,
    /// Picture of the heights' power spectrum.
    pub spectrum: Option<SpectrumFile>,
    /// Path of a small picture of the material.
    pub preview_png: Option<String>,
    /// Path of the picture of what its tables cover, where that is not every direction.
    #[serde(default)]
    pub reached_png: Option<String>,
    /// Its spectral tables, where there are any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spectral: Option<SpectralResult>,
    /// What its tables leave out and what that saves; `None` where they are not restricted to scenes.
    #[serde(default)]
    pub budget: Option<Budget>,
    /// What to think of it in one line; `None` in files of older programs.
    #[serde(default)]
    pub verdict: Option<Verdict>,
    /// What the reader must know before using the tables.
    pub warnings: Vec<String>,
    /// Why there are no tables.
    pub failed: Option<String>,
    /// Why all of this is that of an older version: what kept it from being made again.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stale: Option<String>,
}

impl SpecimenResult {
    /// What an overview shows of it, its warnings included, and what was measured of it, which the viewer looks for.
    pub fn in_short(self) -> Self {
        const TOLD_OF_SCANS: [&str; 2] = ["file_name", "warnings"];
        let in_short = |scan: serde_json::Value| match scan {
            serde_json::Value::Object(fields) => {
                fields.into_iter().filter(|(key, _)| TOLD_OF_SCANS.contains(&key.as_str())).collect()
            }
            other => other,
        };
        let promised = promised(&self.errors);
        Self {
            scans: self.scans.into_iter().map(in_short).collect(),
            errors: self.errors.into_iter().filter(|row| row.cause == promised).collect(),
            optics: None,
            power_sums: Vec::new(),
            albedo: Vec::new(),
            goniometry: None,
            spectral: self.spectral.map(|spectral| SpectralResult { errors: Vec::new(), ..spectral }),
            budget: None,
            ..self
        }
    }
}

/// What was built and what it cost.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BuildResult {
    /// The expansion in `w`.
    pub basis: Basis,
    /// Number of tables.
    pub tables: usize,
    /// Texels along u and v.
    pub size: usize,
    /// Number format of the stored tables.
    pub storage: Storage,
    /// What storing did to their values.
    #[serde(default)]
    pub rounding: Option<Rounding>,
    /// Bytes of all table files of the specimen.
    pub stored_bytes: u64,
    /// Side of the square in (u, v) that a texel averages over; 0 for point samples.
    pub prefilter_width: f64,
    /// The error asked for, relative.
    pub tolerance: f64,
    /// Choices made while building.
    pub record: BuildRecord,
    /// Elapsed seconds.
    pub build_s: f64,
    /// Seconds that all threads together ran: what the machine would have needed with nothing else to do, times its
    /// threads. `None` where the system does not tell.
    #[serde(default)]
    pub build_cpu_s: Option<f64>,
    /// Most bytes that building held on the heap, its tables included, the scans not; `None` where nobody counted them.
    #[serde(default)]
    pub memory_bytes: Option<u64>,
    /// What the plan predicted, where there is a prediction.
    #[serde(default)]
    pub predicted: Option<Cost>,
}

/// Spectral tables, what they cost and how good they are.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SpectralResult {
    /// Number of tables.
    pub tables: usize,
    /// Texels along both spatial frequencies.
    pub size: usize,
    /// Number format of the stored tables.
    pub storage: Storage,
    /// Shortest and longest wavelength in nm.
    pub range_nm: [f64; 2],
    /// Bytes of all their files.
    pub stored_bytes: u64,
    /// Elapsed seconds of building.
    pub build_s: f64,
    /// Seconds that all threads together ran; `None` where the system does not tell.
    pub build_cpu_s: Option<f64>,
    /// Errors at single wavelengths, by cause.
    pub errors: Vec<ErrorRow>,
}

/// The coherent lobe, in numbers.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LobeResult {
    /// Radius in (u, v) beyond which it is zero.
    pub radius_max: f64,
    /// Number of cross-term patches.
    pub cross_tables: usize,
    /// Share of the reflected luminous power at normal incidence that lies in the lobe, where measured.
    pub power_share: Option<f64>,
}

/// One rendered scene.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SceneResult {
    /// Name, from the manifest.
    pub name: String,
    /// Shape, in the manifest's word.
    pub shape: String,
    /// Width and height of the picture in pixels.
    pub size_px: [usize; 2],
    /// Factor applied to the luminance before it is shown.
    pub exposure: f64,
    /// Where the light comes from, in words.
    #[serde(default)]
    pub light: String,
    /// Seconds to render from the tables.
    pub seconds: f64,
    /// Measured difference from the reference, where one was rendered.
    pub error: Option<SceneError>,
    /// Pixels that ask for directions which the tables do not cover: painted in a marker's colour, and a failure.
    #[serde(rename = "unserved_pixels", default)]
    pub uncovered_pixels: usize,
    /// The picture made with the tables.
    pub table_png: String,
    /// Tables left, reference right, on the pixels that were compared.
    pub side_by_side_png: Option<String>,
    /// Map of the difference in colour.
    pub difference_png: Option<String>,
    /// What the brightest colour of the difference map stands for, in words.
    pub difference_scale: Option<String>,
    /// The animation, an animated PNG.
    #[serde(default)]
    pub animation_png: Option<String>,
    /// What moves in it, in words.
    #[serde(default)]
    pub animation: Option<String>,
}

/// One rendered scene with several specimens.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SharedSceneResult {
    /// Names of the specimens, in the manifest's order.
    pub specimens: Vec<String>,
    /// The picture.
    pub picture: SceneResult,
}

/// Difference of a scene from its reference.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SceneError {
    /// Pixels compared: evenly chosen ones, each light seen as a few points.
    pub pixels: usize,
    /// Root of the summed squared differences of XYZ over the root of the summed squares.
    #[serde(with = "null_for_nan")]
    pub relative_l2: f64,
    /// Mean colour difference CIEDE2000.
    #[serde(with = "null_for_nan")]
    pub ciede2000_mean: f64,
    /// Its 95th percentile.
    #[serde(with = "null_for_nan")]
    pub ciede2000_p95: f64,
    /// Its maximum.
    #[serde(with = "null_for_nan")]
    pub ciede2000_max: f64,
}

/// A picture of the heights and what its colours mean.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct HeightMapFile {
    /// Path of the PNG.
    pub png: String,
    /// Length in µm of the bar drawn into the picture; 0 where there was no room for one.
    pub scale_bar_um: f64,
    /// Height of the darkest colour in nm.
    pub low_nm: f64,
    /// Height of the brightest colour in nm.
    pub high_nm: f64,
    /// Samples that `despike` replaced, which are marked in the picture.
    #[serde(default)]
    pub replaced_samples: usize,
}

/// A picture of the power spectrum and what its axes and colours mean.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SpectrumFile {
    /// Path of the PNG; frequency 0 is in its centre, +y up.
    pub png: String,
    /// Frequency at the middle of each edge, in cycles per µm.
    pub half_range_per_um: f64,
    /// Power of the darkest colour in dB below the brightest, negative.
    pub low_db: f64,
}

/// The results as indented JSON, fields in their order here.
pub fn to_json(results: &RunResults) -> String {
    // Plain structs with string keys: there is nothing in them that JSON could refuse.
    serde_json::to_string_pretty(results).expect("plain data can always be written as JSON")
}

/// Results read back from JSON; refuses a layout this program does not know.
///
/// `name` is the file's name for the messages.
pub fn from_json(text: &str, name: &str) -> Result<RunResults> {
    let bad = |what: String| {
        Error::bad_file(
            std::path::Path::new(name),
            what,
            format!("name a report.json of schema {RESULTS_SCHEMA}, as this program writes it"),
        )
    };
    // The schema comes first: another layout would only fail on some field or other.
    let value: serde_json::Value = serde_json::from_str(text).map_err(|error| bad(format!("is not JSON: {error}")))?;
    match value.get("schema").and_then(serde_json::Value::as_u64) {
        Some(schema) if schema == u64::from(RESULTS_SCHEMA) => {}
        Some(schema) => return Err(bad(format!("has schema {schema}"))),
        None => return Err(bad("has no `schema`".into())),
    }
    serde_json::from_value(value).map_err(|error| bad(format!("does not hold the results of a run: {error}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_unknown_layout_is_refused_by_name() {
        for (text, complaint) in [
            ("{", "JSON"),
            ("{}", "`schema`"),
            ("{\"schema\": 99}", "schema 99"),
            (&format!("{{\"schema\": {RESULTS_SCHEMA}}}"), "missing field"),
        ] {
            let error = from_json(text, "report.json").unwrap_err().to_string();
            assert!(error.starts_with("report.json: ") && error.contains(complaint), "{error}");
        }
    }
}
