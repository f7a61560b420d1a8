//! A run under way: what it is lent, and what it has open.

use std::path::Path;

use super::choose::Newest;
use super::job::Illustrate;
use super::taken::Finished;
use crate::error::Result;
use crate::stages::cache::store::Cache;
use crate::stages::config::RunConfig;
use crate::stages::gpu::device::GpuDevice;
use crate::stages::gpu::stage::{self as gpu_stage, Opened};
use crate::stages::log::Log;
use crate::stages::results::RunResults;
use diffraction_build::ground::progress::Progress;

/// Writes the report of a run into its folder; given by the floor that knows how.
pub(crate) type WriteReport<'a> = &'a (dyn Fn(&RunResults, &Path) -> diffraction_brdf::Result<()> + Sync);

/// What the floors above lend to the pipeline.
#[derive(Clone, Copy)]
pub struct Helpers<'a> {
    /// Draws pictures of heights.
    pub illustrate: Illustrate<'a>,
    /// Writes report files.
    pub write_report: WriteReport<'a>,
    /// Hears how far the run is.
    pub progress: &'a dyn Progress,
    /// Hears of every specimen that has been made, or failed to be, as they are done.
    pub finished: &'a dyn Fn(&Finished),
    /// The time in UTC, RFC 3339.
    pub started: &'a str,
}

/// A run under way.
pub(super) struct Run<'a> {
    pub(super) config: &'a RunConfig,
    pub(super) helpers: &'a Helpers<'a>,
    pub(super) log: Log<'a>,
    /// The GPU, once it is needed.
    pub(super) gpu: Option<Opened>,
    pub(super) cache: Cache,
    pub(super) newest: Option<Newest>,
}

impl<'a> Run<'a> {
    /// Opens everything but the GPU.
    ///
    /// # Errors
    /// The disk's.
    pub(super) fn begin(config: &'a RunConfig, helpers: &'a Helpers<'a>) -> Result<Self> {
        let newest = Newest::of(&config.atlas_root)?;
        Ok(Self {
            gpu: None,
            log: Log::new(helpers.progress),
            config,
            helpers,
            cache: Cache::open(&config.cache),
            newest,
        })
    }

    /// Opens the GPU, where one is wanted and not open yet.
    ///
    /// # Errors
    /// One that is required and not there.
    pub(super) fn open_gpu(&mut self) -> Result<()> {
        if self.gpu.is_none() {
            self.gpu = Some(gpu_stage::open(self.config.gpu, &mut self.log)?);
        }
        Ok(())
    }

    /// The GPU, where it is open.
    pub(super) fn device(&self) -> Option<&GpuDevice> {
        self.gpu.as_ref().and_then(Opened::device)
    }
}
