//! What the steps of one specimen are told.

use std::path::{Path, PathBuf};

use ndarray::Array2;

use super::memory::Memory;
use crate::stages::cache::store::Cache;
use crate::stages::config::{RunConfig, SpecimenConfig};
use crate::stages::results::{HeightMapFile, SpectrumFile, Statistics};
use diffraction_brdf::error::Result;
use diffraction_build::height::HeightField;

/// What is drawn of a scan.
#[derive(Debug, Clone, Copy)]
pub struct Heights<'a> {
    /// The prepared field.
    pub field: &'a HeightField,
    /// Samples that `despike` replaced, of the field's shape; `None` where it did not act.
    pub replaced: Option<&'a Array2<bool>>,
    /// Statistics of the field.
    pub statistics: &'a Statistics,
}

/// Draws a specimen's heights and their spectrum into its folder; given by the floor that knows how.
pub(crate) type Illustrate<'a> = &'a (dyn Fn(&Heights, &Path, &str) -> Result<(HeightMapFile, SpectrumFile)> + Sync);

/// One specimen of a run.
pub(super) struct Job<'a> {
    /// The run.
    pub(super) config: &'a RunConfig,
    /// The specimen.
    pub(super) specimen: &'a SpecimenConfig,
    /// Its folder in the version to come.
    pub(super) folder: PathBuf,
    /// What earlier runs kept.
    pub(super) cache: &'a Cache,
    /// Draws its heights.
    pub(super) illustrate: Illustrate<'a>,
    /// What it shares with those that are made meanwhile.
    pub(super) memory: &'a Memory,
}
