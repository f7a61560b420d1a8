//! The manifest as plain data: every default filled in, every path and pattern resolved.

use std::path::PathBuf;

use super::collection::Collection;
use crate::stages::cache::store::CacheConfig;
use crate::stages::config::{Cover, FrameTiming, GpuCheck, Hold, OnFailure, ReportConfig, SpecimenConfig};
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::tables::model::TablesConfig;
use diffraction_render::scene::model::Scene;

/// A whole manifest.
#[derive(Debug, Clone, PartialEq)]
pub struct Manifest {
    /// Version of the manifest's format.
    pub schema: u32,
    /// What the atlas is called and where it goes.
    pub atlas: AtlasSection,
    /// The optics that specimens start from.
    pub optics: OpticsConfig,
    /// What is asked of the tables.
    pub tables: TablesConfig,
    /// Which directions the tables answer for.
    pub cover: Cover,
    /// Which kinds of tables are stored.
    pub hold: Hold,
    /// The specimens, at least one, in the manifest's order; names are unique.
    pub specimens: Vec<SpecimenConfig>,
    /// The CSV file that some of them come from.
    pub collection: Option<Collection>,
    /// The pictures, in the manifest's order; names are unique.
    pub scenes: Vec<Scene>,
    /// Whether the manifest says which pictures it wants; two are assumed otherwise.
    pub scenes_are_given: bool,
    /// What a GPU is used for.
    pub gpu: GpuSection,
    /// What is found out besides the tables.
    pub report: ReportConfig,
    /// Where intermediate results are kept.
    pub cache: CacheConfig,
    /// The folder that relative paths start at.
    pub base: PathBuf,
}

/// What a GPU is used for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GpuSection {
    /// Whether tables are checked on one.
    pub check: GpuCheck,
    /// Whether frames are timed on it.
    pub frame_time: FrameTiming,
}

/// What the atlas is called and where it goes.
#[derive(Debug, Clone, PartialEq)]
pub struct AtlasSection {
    /// Safe as a folder's name.
    pub name: String,
    /// The folder that holds atlases; this one's versions go to `out/name`.
    pub out: PathBuf,
    /// What becomes of a specimen that fails.
    pub on_failure: OnFailure,
}
