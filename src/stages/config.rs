//! What a run is told to do: plain data that the manifest is turned into.

use std::path::{Path, PathBuf};

use crate::height::prepare::PrepareConfig;
use crate::height::read::ReadConfig;
use crate::optics::config::OpticsConfig;
use crate::scene::model::Scene;
use crate::stages::measured::MeasuredConfig;
use crate::tables::model::TablesConfig;

/// A whole run.
#[derive(Debug, Clone)]
pub struct RunConfig {
    /// The atlas's name.
    pub atlas_name: String,
    /// Folder that holds the atlas's versions.
    pub atlas_root: PathBuf,
    /// What is asked of the tables.
    pub tables: TablesConfig,
    /// The specimens, in order.
    pub specimens: Vec<SpecimenConfig>,
    /// The pictures, in order.
    pub scenes: Vec<Scene>,
    /// Whether tables are checked on a GPU.
    pub gpu: GpuCheck,
    /// The manifest, word for word.
    pub manifest_text: String,
    /// Folder that input paths are recorded relative to.
    pub base: PathBuf,
}

impl RunConfig {
    /// An input's path as the atlas records it: from the manifest's folder where it lies below it.
    pub fn relative_name(&self, path: &Path) -> String {
        path.strip_prefix(&self.base).unwrap_or(path).display().to_string()
    }
}

/// One specimen.
#[derive(Debug, Clone)]
pub struct SpecimenConfig {
    /// Name, and its folder in the atlas.
    pub name: String,
    /// The species, for people.
    pub species: Option<String>,
    /// Its scans, averaged.
    pub scans: Vec<PathBuf>,
    /// How to read them.
    pub read: ReadConfig,
    /// How to prepare them.
    pub prepare: PrepareConfig,
    /// The optics.
    pub optics: OpticsConfig,
    /// Measured reflectance to compare with.
    pub measured: Option<MeasuredConfig>,
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
