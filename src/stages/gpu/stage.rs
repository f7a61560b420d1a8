//! The GPU's stages of a run: opening, checking a specimen, timing frames. What goes wrong on it is a failure of the run.

use std::path::Path;

use super::device::GpuDevice;
use super::frame_time;
use super::published::{beyond_limits, check_files};
use super::results::{FrameComparison, GpuResult, GpuRow, GpuSpectralRow};
use super::spectral::check_spectral;
use crate::error::{Error, Result};
use crate::stages::config::{FrameTiming, GpuCheck, RunConfig, SpecimenConfig};
use crate::stages::coverage::asked;
use crate::stages::log::Log;
use crate::stages::pictures::sharing::specimens_of;
use crate::stages::stage::Stage;
use diffraction_build::tables::model::Basis;
use diffraction_render::render::gpu::Gpu;
use diffraction_render::scene::model::Scene;

/// A GPU, or why there is none.
#[derive(Debug)]
pub(crate) enum Opened {
    /// Ready.
    Ready(GpuDevice),
    /// Not wanted, not there or not usable; what the results say of it.
    Not(GpuResult),
}

impl Opened {
    /// The GPU, where it is ready.
    pub fn device(&self) -> Option<&GpuDevice> {
        match self {
            Self::Ready(device) => Some(device),
            Self::Not(_) => None,
        }
    }

    /// What the results say, given what was found out on it.
    pub(crate) fn into_result(self, compared: Compared, frames: Option<FrameComparison>) -> GpuResult {
        match self {
            Self::Ready(device) => {
                let (gpu, frames) = (Box::new(device.info().clone()), frames.map(Box::new));
                let Compared { rows, spectral } = compared;
                GpuResult::Checked { gpu, rows, spectral, frames }
            }
            Self::Not(result) => result,
        }
    }
}

/// Opens the GPU, where one is wanted and there, and says how that went.
///
/// # Errors
/// With `GpuCheck::Required`, `Error::Gpu` where there is none or it cannot be opened.
pub fn open(check: GpuCheck, log: &mut Log) -> Result<Opened> {
    let gpu = match check {
        GpuCheck::Off => return Ok(Opened::Not(GpuResult::Off)),
        GpuCheck::Required => Ok(Some(Gpu::require()?)),
        GpuCheck::Auto => Gpu::open(),
    };
    Ok(match gpu {
        Ok(Some(gpu)) => Opened::Ready(GpuDevice::new(gpu)),
        Ok(None) => {
            let why = "no adapter (neither a Vulkan nor a Metal nor a DirectX 12 driver was found)";
            log.progress().message(&format!("GPU check skipped: {why}"));
            Opened::Not(GpuResult::Skipped { why: why.into() })
        }
        Err(error) => {
            log.fail(Stage::CheckOnGpu, None, error.to_string());
            Opened::Not(GpuResult::Unusable { why: error.to_string() })
        }
    })
}

/// Comparisons of the GPU with the CPU.
#[derive(Debug, Default)]
pub struct Compared {
    /// Scenes.
    pub rows: Vec<GpuRow>,
    /// Spectral tables.
    pub spectral: Vec<GpuSpectralRow>,
}

/// What came of checking a specimen.
pub enum Checked {
    /// The comparisons; none where the GPU failed.
    Rows(Compared),
    /// Nothing to compare, and why: no GPU has to take such tables, and none is required.
    Beyond(String),
}

/// Checks a specimen whose folder in `version_folder` is complete; whatever is wrong is a failure of the run.
///
/// # Errors
/// `Error::Disk` in `version_folder`.
pub fn check(
    device: &GpuDevice,
    config: &RunConfig,
    specimen: &SpecimenConfig,
    version_folder: &Path,
    log: &mut Log,
) -> Result<Checked> {
    let name = &specimen.name;
    let folder = version_folder.join(name);
    if config.gpu == GpuCheck::Auto
        && let Some(why) = beyond_limits(&folder)
    {
        log.progress().message(&format!("{name}: GPU check skipped: {why}"));
        return Ok(Checked::Beyond(format!("not checked on the GPU: {why}")));
    }
    // Shares of a scene have no picture of their own.
    let pictured = asked::pictured_scenes(config, name);
    let scenes: Vec<&Scene> = pictured.iter().filter(|scene| specimens_of(scene).is_empty()).collect();
    let tables = asked::tables_for(config, name);
    let checked = log.timed(Stage::CheckOnGpu, name, 0, || -> diffraction_render::error::Result<Compared> {
        let rows = check_files(device, &folder, name, &scenes, &tables, config.report.reference)?;
        Ok(Compared { rows, spectral: check_spectral(device, &folder, name)?.into_iter().collect() })
    });
    let mut fail = |message| log.fail(Stage::CheckOnGpu, Some(name), message);
    match checked.map_err(Error::from) {
        Err(error) if error.is_of_disk_below(version_folder) => Err(error),
        Err(error) => {
            fail(error.to_string());
            Ok(Checked::Rows(Compared::default()))
        }
        Ok(compared) => {
            let of_tables = compared.spectral.iter().filter_map(GpuSpectralRow::complaint);
            compared.rows.iter().filter_map(GpuRow::complaint).chain(of_tables).for_each(fail);
            Ok(Checked::Rows(compared))
        }
    }
}

/// Times frames of the first specimen that has tables in `version_folder`, where that is wanted.
///
/// # Errors
/// `Error::Disk` in `version_folder`.
pub fn time_frames(
    device: &GpuDevice,
    config: &RunConfig,
    version_folder: &Path,
    log: &mut Log,
) -> Result<Option<FrameComparison>> {
    let wanted = match config.frame_time {
        FrameTiming::On => true,
        FrameTiming::Auto => !device.info().is_software(),
        FrameTiming::Off => false,
    };
    // The published method is not compared with itself, and the frame shows more than restricted tables answer for.
    if !wanted || config.tables.basis != Basis::Chebyshev || !config.cover.is_all() {
        return Ok(None);
    }
    let folder = |specimen: &SpecimenConfig| version_folder.join(&specimen.name);
    let done = |specimen: &&SpecimenConfig| folder(specimen).join(diffraction_brdf::specimen::FILE).is_file();
    let fits =
        |specimen: &&SpecimenConfig| config.frame_time == FrameTiming::On || beyond_limits(&folder(specimen)).is_none();
    let Some(specimen) = config.specimens.iter().find(done).filter(fits) else { return Ok(None) };
    let compared = log.timed(Stage::TimeFrames, &specimen.name, 0, || {
        frame_time::compare(device, config, specimen, &folder(specimen))
    });
    match compared.map_err(Error::from) {
        Err(error) if error.is_of_disk_below(version_folder) => Err(error),
        Err(error) => {
            log.fail(Stage::TimeFrames, Some(&specimen.name), error.to_string());
            Ok(None)
        }
        Ok(compared) => {
            log.progress().message(&compared.in_words());
            Ok(Some(compared))
        }
    }
}
