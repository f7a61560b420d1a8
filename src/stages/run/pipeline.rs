//! The pipeline: specimen after specimen from scan to published tables, with times and failures.
//!
//! Each specimen passes the same chain of steps; one that fails is recorded and the others go on. Nothing is visible in
//! the atlas before the one rename at the end.

use std::path::Path;
use std::time::Instant;

use super::clock::{Clock, Failed};
use super::describe::{Described, failed_result};
use super::job::{Illustrate, Job};
use super::specimen::run_specimen;
use crate::error::Result;
use crate::stages::archive::format_md::write_format;
use crate::stages::archive::publish::{self, MANIFEST_FILE, Published};
use crate::stages::cache::store::{Cache, CacheUse};
use crate::stages::config::{RunConfig, SpecimenConfig};
use crate::stages::coverage::asked;
use crate::stages::gpu::stage::{self as gpu_stage, Checked, Compared, Opened};
use crate::stages::log::Log;
use crate::stages::pictures::scenes;
use crate::stages::pictures::shared_scenes::{self, SharedScenes};
use crate::stages::results::{RESULTS_SCHEMA, RunResults, SpecimenResult};
use crate::stages::stage::Stage;
use diffraction_brdf::atlas::{AtlasIndex, InputRecord, SpecimenEntry};
use diffraction_brdf::files;
use diffraction_build::accuracy::rows;
use diffraction_build::ground::memory;
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
    /// The time in UTC, RFC 3339.
    pub started: &'a str,
}

/// How a run ended.
#[derive(Debug)]
pub struct RunOutcome {
    /// Everything found out.
    pub results: RunResults,
    /// What was published; `None` where every specimen failed.
    pub published: Option<Published>,
}

/// Runs the whole pipeline.
///
/// # Errors
/// Only what concerns the whole run: the disk, the lock. A specimen's failure is part of the outcome.
pub fn run(config: &RunConfig, helpers: &Helpers) -> Result<RunOutcome> {
    let started = Instant::now();
    let staging = publish::begin(&config.atlas_root)?;
    let mut run = Run::begin(config, helpers, staging.path())?;
    let asked_for: Vec<&SpecimenConfig> =
        config.specimens.iter().filter(|specimen| asked::is_asked_for(config, &specimen.name)).collect();
    for (index, specimen) in asked_for.iter().enumerate() {
        run.specimen(specimen, &format!("[{}/{}] {}", index + 1, asked_for.len(), specimen.name))?;
    }
    let example = run.entries.first().map(|entry| entry.name.clone());
    // Where nothing has changed the report goes with the staging folder.
    let version = example.is_some().then(|| staging.next_version()).transpose()?;
    let (results, index) = run.finish(started, version)?;
    let Some(example) = example else {
        return Ok(RunOutcome { results, published: None });
    };
    write_format(&staging.path().join(example), staging.path())?;
    files::replace(&staging.path().join(MANIFEST_FILE), config.manifest_text.as_bytes())?;
    if config.report.write {
        (helpers.write_report)(&results, staging.path())?;
    }
    let published = publish::publish(staging, index)?;
    Ok(RunOutcome { results, published: Some(published) })
}

/// A run under way.
struct Run<'a> {
    config: &'a RunConfig,
    helpers: &'a Helpers<'a>,
    /// The folder that becomes the version.
    folder: &'a Path,
    log: Log<'a>,
    gpu: Opened,
    cache: Cache,
    used: CacheUse,
    shared: SharedScenes,
    inputs: Vec<InputRecord>,
    entries: Vec<SpecimenEntry>,
    specimens: Vec<SpecimenResult>,
    compared: Compared,
}

impl<'a> Run<'a> {
    fn begin(config: &'a RunConfig, helpers: &'a Helpers<'a>, folder: &'a Path) -> Result<Self> {
        let mut log = Log::new(helpers.progress);
        Ok(Self {
            gpu: gpu_stage::open(config.gpu, &mut log)?,
            config,
            helpers,
            folder,
            log,
            cache: Cache::open(&config.cache),
            used: CacheUse::default(),
            shared: SharedScenes::new(&config.scenes),
            inputs: Vec::new(),
            entries: Vec::new(),
            specimens: Vec::new(),
            compared: Compared::default(),
        })
    }

    /// One specimen with all that belongs to it.
    fn specimen(&mut self, specimen: &SpecimenConfig, label: &str) -> Result<()> {
        let started = Instant::now();
        let job = Job {
            config: self.config,
            specimen,
            folder: self.folder.join(&specimen.name),
            cache: &self.cache,
            illustrate: self.helpers.illustrate,
        };
        match run_specimen(&job, &mut Clock { specimen: &specimen.name, log: &mut self.log }) {
            Ok(described) => self.keep(specimen, described, label, started),
            // A full disk is no specimen's fault, and would leave out the next ones too.
            Err(Failed { error, .. }) if error.is_of_disk_below(self.folder) => Err(error.into()),
            Err(Failed { stage, error }) => {
                self.helpers.progress.message(&format!("{label}: failed to {stage}"));
                // What is left of it shall not be published; where it cannot be removed, publishing fails too.
                let _ = std::fs::remove_dir_all(&job.folder);
                self.log.fail(stage, Some(&specimen.name), error.to_string());
                self.specimens.push(failed_result(specimen, &error));
                Ok(())
            }
        }
    }

    /// Takes over what a finished specimen leaves, and checks its files on the GPU.
    fn keep(&mut self, specimen: &SpecimenConfig, described: Described, label: &str, started: Instant) -> Result<()> {
        let Described { mut result, inputs, shares, used } = described;
        self.used = self.used.with(&used, self.cache.traffic());
        if let Some(device) = self.gpu.device() {
            match gpu_stage::check(device, self.config, specimen, self.folder, &mut self.log)? {
                Checked::Rows(Compared { rows, spectral }) => {
                    self.compared.rows.extend(rows);
                    self.compared.spectral.extend(spectral);
                }
                Checked::Beyond(why) => result.warnings.push(why),
            }
        }
        self.helpers.progress.message(&done_line(label, &result, used, started.elapsed().as_secs_f64()));
        for scene in result.scenes.iter().filter(|scene| scene.uncovered_pixels > 0) {
            let (name, pixels) = (&scene.name, scene.uncovered_pixels);
            let message = format!("{name}: {pixels} pixels ask for directions that the tables do not cover");
            self.log.fail(Stage::RenderScenes, Some(&specimen.name), message);
        }
        if let Some(message) = rows::disagreement(&result.errors) {
            self.log.fail(Stage::MeasureErrors, Some(&specimen.name), message);
        }
        self.inputs.extend(inputs);
        self.shared.add(shares);
        let species = specimen.species.clone().unwrap_or_default();
        self.entries.push(SpecimenEntry { name: specimen.name.clone(), species });
        self.specimens.push(result);
        Ok(())
    }

    /// What concerns all specimens together; the results and the index of the version to come.
    fn finish(mut self, started: Instant, version: Option<String>) -> Result<(RunResults, AtlasIndex)> {
        let config = self.config;
        let frames = match self.gpu.device() {
            Some(device) => gpu_stage::time_frames(device, config, self.folder, &mut self.log)?,
            None => None,
        };
        self.inputs.extend(scenes::inputs(config));
        self.inputs.extend(shared_scenes::inputs(&config.scenes, &config.base));
        let shared_scenes = self.shared.finish(self.folder, &mut self.log)?;
        let manifest_sha256 = files::sha256_hex(config.manifest_text.as_bytes());
        let index = AtlasIndex::new(&config.atlas_name, &manifest_sha256, self.inputs, self.entries);
        let results = RunResults {
            schema: RESULTS_SCHEMA,
            atlas_name: config.atlas_name.clone(),
            version,
            program_version: env!("CARGO_PKG_VERSION").into(),
            started: self.helpers.started.into(),
            threads: rayon::current_num_threads(),
            cpu_count: std::thread::available_parallelism().map_or(1, usize::from),
            manifest_text: config.manifest_text.clone(),
            specimens: self.specimens,
            shared_scenes,
            stages: self.log.stages,
            gpu: self.gpu.into_result(self.compared, frames),
            failures: self.log.failures,
            left_out: asked::left_out(config),
            cache: self.cache.is_on().then_some(self.used),
            peak_memory_mib: memory::process_peak_bytes().map(|bytes| bytes as f64 / f64::from(1 << 20)),
            total_wall_s: started.elapsed().as_secs_f64(),
        };
        Ok((results, index))
    }
}

/// The line that a finished specimen leaves on the screen.
fn done_line(label: &str, result: &SpecimenResult, used: CacheUse, seconds: f64) -> String {
    let (tables, size) = result.build.as_ref().map_or((0, 0), |build| (build.tables, build.size));
    let CacheUse { tables_found, pairs_found, .. } = used;
    let known = [
        (tables_found > 0).then(|| "the tables".into()),
        (pairs_found > 0).then(|| format!("{pairs_found} reference values")),
    ];
    let known: Vec<String> = known.into_iter().flatten().collect();
    let known = if known.is_empty() { String::new() } else { format!(", known: {}", known.join(", ")) };
    format!("{label}: {tables} tables of {size}², {seconds:.1} s{known}")
}
