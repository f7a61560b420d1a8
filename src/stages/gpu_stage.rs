//! The GPU stage of a run: opens the GPU where one is wanted, and checks a specimen's published files on it.
//!
//! All that the GPU is given comes from files: tables, the CPU's pictures and the reference pictures of a specimen's
//! folder. The GPU lives on a thread of its own, and the stage ends with an error when it does not answer in time.

use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use ndarray::Array3;

use super::config::{FrameTiming, GpuCheck, RunConfig, Serve, SpecimenConfig};
use super::frame_time;
use super::gpu_check::{ReferenceCheck, Shade, check_picture, check_reference, reference_limit};
use super::gpu_results::{GpuResult, GpuRow};
use super::results::{Failure, RunResults};
use super::scenes::reference_stride;
use super::serve;
use super::shared_scenes::specimens_of;
use super::specimen;
use super::usage::Stopwatch;
use diffraction_brdf::atlas::DIFFERENCE_SUFFIX;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::exr_image::read_rgb;
use diffraction_brdf::shader::{LAYERS_MAX, SIDE_MAX, table_image};
use diffraction_build::ground::progress::Progress;
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::optics::pigment::Surface;
use diffraction_build::tables::model::{Basis, Storage, TableSet, TablesConfig};
use diffraction_build::tables::plan::lobe_width;
use diffraction_render::render::gpu::{Gpu, GpuInfo};
use diffraction_render::render::gpu_tables::{shade, upload};
use diffraction_render::render::gpu_thread::OwningThread;
use diffraction_render::render::png_image::write_png;
use diffraction_render::scene::model::Scene;
use diffraction_render::scene::samples::ShadingSamples;

/// Name of the stage, in times and failures.
pub const STAGE: &str = "check on the GPU";

/// Longest wait for the GPU, over one specimen.
const TIME_LIMIT: Duration = Duration::from_secs(300);

/// Most pixels compared along each side on a software driver, which takes seconds beyond: every which pixel then.
/// Hardware draws whole pictures.
const SOFTWARE_SIDE_MAX_PX: usize = 128;

/// A GPU on its thread.
#[derive(Debug)]
pub struct GpuStage {
    thread: OwningThread<Gpu>,
    info: GpuInfo,
}

impl GpuStage {
    /// Takes over an open GPU.
    pub fn new(gpu: Gpu) -> Self {
        let info = gpu.info().clone();
        Self { thread: OwningThread::new(gpu), info }
    }

    /// The thread, for one more stage's worth of waiting.
    pub fn thread(&self) -> &OwningThread<Gpu> {
        self.thread.allow(TIME_LIMIT);
        &self.thread
    }
}

/// Opens the GPU, where one is wanted and there, and says how that went.
///
/// # Errors
/// With `GpuCheck::Required`, `Error::Gpu` where there is none or it cannot be opened.
pub fn open(config: &RunConfig, results: &mut RunResults, progress: &dyn Progress) -> Result<Option<GpuStage>> {
    let gpu = match config.gpu {
        GpuCheck::Off => return Ok(None),
        GpuCheck::Required => Ok(Some(Gpu::require()?)),
        GpuCheck::Auto => Gpu::open(),
    };
    let (result, gpu) = match gpu {
        Ok(Some(gpu)) => {
            let stage = GpuStage::new(gpu);
            (GpuResult::Checked { gpu: Box::new(stage.info.clone()), rows: Vec::new(), frames: None }, Some(stage))
        }
        Ok(None) => (skipped(), None),
        Err(error) => {
            results.failures.push(Failure { specimen: None, stage: STAGE.into(), message: error.to_string() });
            (GpuResult::Unusable { why: error.to_string() }, None)
        }
    };
    if let GpuResult::Skipped { why } = &result {
        progress.message(&format!("GPU check skipped: {why}"));
    }
    results.gpu = result;
    Ok(gpu)
}

fn skipped() -> GpuResult {
    GpuResult::Skipped { why: "no adapter (neither a Vulkan nor a Metal nor a DirectX 12 driver was found)".into() }
}

/// Checks a specimen whose folder in `version_folder` is complete, and adds the outcome to the results: the time, the
/// comparisons, and as failures of the run whatever is wrong. Returns why there is nothing to compare, where no GPU has to
/// take such tables and none is required.
///
/// # Errors
/// `Error::Disk` in `version_folder`.
pub fn check(
    stage: &GpuStage,
    config: &RunConfig,
    specimen: &SpecimenConfig,
    version_folder: &Path,
    results: &mut RunResults,
    progress: &dyn Progress,
) -> Result<Option<String>> {
    let name = &specimen.name;
    if config.gpu == GpuCheck::Auto
        && let Some(why) = beyond_limits(&version_folder.join(name))
    {
        progress.message(&format!("{name}: GPU check skipped: {why}"));
        return Ok(Some(format!("not checked on the GPU: {why}")));
    }
    progress.stage(&format!("{name}: {STAGE}"), 0);
    let stopwatch = Stopwatch::start();
    // Shares of a scene have no picture of their own.
    let pictured = serve::pictured_scenes(config, name);
    let scenes: Vec<&Scene> = pictured.iter().filter(|scene| specimens_of(scene).is_empty()).collect();
    let reference = config.report.reference;
    let tables = serve::tables_for(config, name);
    let checked = check_files(stage, &version_folder.join(name), name, &scenes, &tables, reference);
    progress.finish();
    results.stages.push(stopwatch.read(STAGE, Some(name)));
    let mut fail = |message| {
        results.failures.push(Failure { specimen: Some(name.clone()), stage: STAGE.into(), message });
    };
    match checked {
        Err(error) if error.is_of_disk_below(version_folder) => return Err(error),
        Err(error) => fail(error.to_string()),
        Ok(rows) => {
            rows.iter().filter_map(GpuRow::complaint).for_each(&mut fail);
            if let GpuResult::Checked { rows: all, .. } = &mut results.gpu {
                all.extend(rows);
            }
        }
    }
    Ok(None)
}

/// Why the tables in a specimen's folder are more than every GPU takes, if they are.
fn beyond_limits(folder: &Path) -> Option<String> {
    let tables = specimen::read(folder).ok()?.tables;
    let (layers, side) = (tables.tables.len(), tables.u.samples.max(tables.v.samples));
    let layers_max = LAYERS_MAX - usize::from(tables.served.is_some());
    if layers > layers_max {
        return Some(format!("its {layers} tables are more than the {layers_max} layers that every GPU takes"));
    }
    (side > SIDE_MAX)
        .then(|| format!("its tables are {side} texels wide, more than the {SIDE_MAX} that every GPU takes"))
}

/// Times frames of the first specimen that has tables in `version_folder`, where that is wanted, and adds the outcome to the
/// results.
///
/// # Errors
/// `Error::Disk` in `version_folder`.
pub fn time_frames(
    stage: &GpuStage,
    config: &RunConfig,
    version_folder: &Path,
    results: &mut RunResults,
    progress: &dyn Progress,
) -> Result<()> {
    let wanted = match config.frame_time {
        FrameTiming::On => true,
        FrameTiming::Auto => !stage.info.is_software(),
        FrameTiming::Off => false,
    };
    // The published method is not compared with itself, and the frame shows more than tables for other scenes serve.
    let wanted = wanted && config.tables.basis == Basis::Chebyshev && config.serve == Serve::All;
    let done = |specimen: &&SpecimenConfig| {
        version_folder.join(&specimen.name).join(diffraction_brdf::specimen::FILE).is_file()
    };
    let fits = |specimen: &&SpecimenConfig| {
        config.frame_time == FrameTiming::On || beyond_limits(&version_folder.join(&specimen.name)).is_none()
    };
    let Some(specimen) = config.specimens.iter().find(done).filter(|_| wanted).filter(fits) else { return Ok(()) };
    progress.stage(&format!("{}: {}", specimen.name, frame_time::STAGE), 0);
    let stopwatch = Stopwatch::start();
    let compared = frame_time::compare(stage, config, specimen, &version_folder.join(&specimen.name));
    progress.finish();
    let name = Some(specimen.name.clone());
    results.stages.push(stopwatch.read(frame_time::STAGE, name.as_deref()));
    match compared {
        Err(error) if error.is_of_disk_below(version_folder) => return Err(error),
        Err(error) => {
            let (stage, message) = (frame_time::STAGE.into(), error.to_string());
            results.failures.push(Failure { specimen: name, stage, message });
        }
        Ok(compared) => {
            progress.message(&compared.in_words());
            if let GpuResult::Checked { frames, .. } = &mut results.gpu {
                *frames = Some(Box::new(compared));
            }
        }
    }
    Ok(())
}

/// Checks scenes from the files in a specimen's folder; where a comparison fails, a picture of the differences is written
/// beside the scene's. `reference` says whether there are reference pictures.
///
/// # Errors
/// `Error::Gpu` above all; the disk's. A picture that differs is no error.
pub fn check_files(
    stage: &GpuStage,
    folder: &Path,
    specimen: &str,
    scenes: &[&Scene],
    config: &TablesConfig,
    reference: bool,
) -> Result<Vec<GpuRow>> {
    let (file, set) = specimen::load(folder)?;
    let thread = stage.thread();
    let pigment = file.pigment;
    let surface = Surface { tables: &set, pigment: pigment.as_ref() };
    let image = table_image(&set, pigment.map(|pigment| pigment.xyz_per_sr))?;
    let tables = Arc::new(thread.run("upload the tables", move |gpu| upload(gpu, &image))?);
    let shade = |samples: &Arc<ShadingSamples>| {
        let (tables, samples) = (tables.clone(), samples.clone());
        thread.run("shade samples", move |gpu| shade(gpu, &tables, &samples))
    };
    let storage = file.tables.storage;
    let job = Job { shade: &shade, surface, optics: &file.optics, storage, folder, specimen, config, reference };
    let side_max = if stage.info.is_software() { SOFTWARE_SIDE_MAX_PX } else { usize::MAX };
    scenes.iter().map(|scene| job.check(scene, scene.size_px.div_ceil(side_max))).collect()
}

/// What the scenes of a specimen have in common.
struct Job<'a> {
    shade: Shade<'a>,
    surface: Surface<'a>,
    optics: &'a OpticsConfig,
    storage: Storage,
    folder: &'a Path,
    specimen: &'a str,
    config: &'a TablesConfig,
    reference: bool,
}

impl Job<'_> {
    fn check(&self, scene: &Scene, stride: usize) -> Result<GpuRow> {
        let by_cpu = self.picture(scene, ".exr", scene.size_px)?;
        let mut cpu = check_picture(self.shade, self.surface, scene, &by_cpu, stride)?;
        let mut reference = match self.reference {
            false => None,
            true => Some(self.against_reference(scene, &by_cpu)?),
        };
        let of_reference = reference.as_mut().and_then(|check| check.difference.take());
        let difference = cpu.difference.take().or(of_reference);
        let difference_png = difference.map(|picture| self.write_difference(&picture, &scene.name)).transpose()?;
        let promised = tolerance_holds(self.surface.tables, self.optics, self.config);
        Ok(GpuRow { specimen: self.specimen.to_owned(), cpu, reference, promised, difference_png })
    }

    fn against_reference(&self, scene: &Scene, by_cpu: &Array3<f32>) -> Result<ReferenceCheck> {
        let side = scene.size_px.div_ceil(reference_stride(scene));
        let reference = self.picture(scene, ".reference.exr", side)?;
        let limit = reference_limit(self.config.tolerance, self.storage);
        check_reference(self.shade, self.surface, scene, by_cpu, &reference, limit)
    }

    fn picture(&self, scene: &Scene, ending: &str, side: usize) -> Result<Array3<f32>> {
        let path = self.folder.join(format!("scenes/{}{ending}", scene.name));
        let (image, _) = read_rgb(&path)?;
        if image.dim() == (side, side, 3) {
            return Ok(image);
        }
        let what = format!("has {} by {} pixels where the scene has {side} by {side}", image.dim().1, image.dim().0);
        Err(Error::bad_file(&path, what, "run the pipeline again to draw it anew"))
    }

    /// Path of the written picture, relative to the report.
    fn write_difference(&self, picture: &Array3<u8>, scene: &str) -> Result<String> {
        let file = format!("scenes/{scene}{DIFFERENCE_SUFFIX}");
        write_png(&self.folder.join(&file), picture)?;
        Ok(format!("{}/{file}", self.specimen))
    }
}

/// Whether tables must be as good as the tolerance says: number and steps were left to it, texels hold point values of a
/// grid that resolves the lobes, and the scan answers for the whole hemisphere.
fn tolerance_holds(set: &TableSet, optics: &OpticsConfig, config: &TablesConfig) -> bool {
    let low_nm = optics.illuminant.reach_nm(optics.wavelength_nm)[0];
    let texel = 4.0 / (set.size().max(2) - 1) as f64;
    set.basis == Basis::Chebyshev
        && config.count.is_none()
        && config.wavelength_step_nm.is_none()
        && set.prefilter_width == 0.0
        && set.usable_radius >= 2.0
        && texel <= lobe_width(optics.sigma_nm, low_nm)
}
