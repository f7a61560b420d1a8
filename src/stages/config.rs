//! What a run is told to do: plain data that the manifest is turned into.

use std::path::{Path, PathBuf};

use super::archive::lock::Lock;
use super::cache::store::CacheConfig;
use crate::stages::measured::MeasuredConfig;
use diffraction_brdf::atlas::InputRecord;
use diffraction_build::height::prepare::PrepareConfig;
use diffraction_build::height::read::ReadConfig;
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::tables::model::TablesConfig;
use diffraction_render::scene::model::Scene;

/// A whole run.
#[derive(Debug, Clone)]
pub struct RunConfig {
    /// The atlas's name.
    pub atlas_name: String,
    /// Folder that holds the atlas's versions.
    pub atlas_root: PathBuf,
    /// What is asked of the tables.
    pub tables: TablesConfig,
    /// Which directions the tables answer for.
    pub cover: Cover,
    /// Which kinds of tables are stored.
    pub hold: Hold,
    /// The specimens, in order.
    pub specimens: Vec<SpecimenConfig>,
    /// The file that some of them are listed in.
    pub collection: Option<InputRecord>,
    /// The pictures, in order.
    pub scenes: Vec<Scene>,
    /// Whether the manifest asks for them; they are assumed otherwise.
    pub scenes_are_given: bool,
    /// Whether tables are checked on a GPU.
    pub gpu: GpuCheck,
    /// Whether frames are timed on it.
    pub frame_time: FrameTiming,
    /// What is found out besides.
    pub report: ReportConfig,
    /// Where intermediate results are kept.
    pub cache: CacheConfig,
    /// Whether specimens that are there already are taken over; otherwise all are made anew.
    pub reuse: bool,
    /// Bytes that specimens made at once may take together; `None` for a share of what is free.
    pub memory_bytes: Option<u64>,
    /// What becomes of a specimen that fails.
    pub on_failure: OnFailure,
    /// What the run is held to: nothing is published that differs from it.
    pub frozen: Option<Lock>,
    /// The manifest, word for word.
    pub manifest_text: String,
    /// SHA-256 of its values, which comments and layout do not change.
    pub manifest_sha256: String,
    /// Folder that input paths are recorded relative to.
    pub base: PathBuf,
}

impl RunConfig {
    /// An input's path as the atlas records it: from the manifest's folder where it lies below it.
    pub(crate) fn relative_name(&self, path: &Path) -> String {
        path.strip_prefix(&self.base).unwrap_or(path).display().to_string()
    }
}

/// What becomes of a specimen that fails: `atlas.on_failure` of a manifest.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum OnFailure {
    /// What the newest version holds of it stays, marked as stale.
    #[default]
    Keep,
    /// The new version has no such specimen.
    Drop,
    /// The run ends, and nothing is published.
    Stop,
}

/// Which kinds of tables an atlas holds: `tables.hold` of a manifest. One of them at least.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub struct Hold {
    /// Those of X, Y, Z. Where they are not stored, pictures, checks and readers have them derived from the spectral ones.
    pub xyz: bool,
    /// Those of single wavelengths.
    pub spectral: bool,
}

/// One specimen.
#[derive(Debug, Clone, PartialEq)]
pub struct SpecimenConfig {
    /// Name, and its folder in the atlas; safe as one.
    pub name: String,
    /// The species, for people.
    pub species: Option<String>,
    /// Its scans: existing files, sorted, none twice; their BRDFs are averaged.
    pub scans: Vec<PathBuf>,
    /// How to read them.
    pub read: ReadConfig,
    /// How to prepare them.
    pub prepare: PrepareConfig,
    /// The optics.
    pub optics: OpticsConfig,
    /// Whether the manifest says what it is made of; an ideal reflector is assumed otherwise.
    pub is_material_given: bool,
    /// Albedo of a pigment below the structure, linear sRGB.
    pub albedo: Option<[f64; 3]>,
    /// Measured reflectance to compare with.
    pub measured: Option<MeasuredConfig>,
}

/// Which directions the tables answer for: `tables.serve` of a manifest.
#[derive(Debug, Clone, PartialEq, Eq, Default, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Cover {
    /// Every pair above the surface: any scene, any renderer.
    #[default]
    All,
    /// Those of the manifest's scenes.
    Scenes,
    /// Those of the scenes with these names.
    Named(Vec<String>),
}

impl Cover {
    /// Whether tables answer for every direction.
    pub(crate) fn is_all(&self) -> bool {
        *self == Self::All
    }
}

/// What a run finds out besides the tables; what nobody asks for is not computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub struct ReportConfig {
    /// Whether `report.html` and `report.json` are written.
    pub write: bool,
    /// Whether errors are measured and pictures compared against the reference.
    pub reference: bool,
    /// Whether what the scenes do not need is built too, step by step, to measure what leaving it out saves.
    pub savings: bool,
}

/// Whether tables are checked on a GPU.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum GpuCheck {
    /// Where there is one; said in the report where there is none.
    Auto,
    /// A machine without one is a failure.
    Required,
    /// Never.
    Off,
}

/// Whether frames are timed on the GPU.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum FrameTiming {
    /// On hardware; times of a software driver say little.
    Auto,
    /// On whatever adapter there is.
    On,
    /// Never.
    Off,
}
