//! The pipeline: specimen after specimen from scan to published tables, with times and failures.
//!
//! Each specimen passes the same chain of functions; a specimen that fails is recorded and the others go
//! on. Nothing is visible in the atlas before the one rename at the end.

use std::path::Path;
use std::time::Instant;

use serde_json::{Value, json};

use super::atlas::{AtlasIndex, InputRecord, SpecimenEntry};
use super::config::{GpuCheck, RunConfig, SpecimenConfig};
use super::format_md::format_md;
use super::gpu_check::check_specimen;
use super::ingest::{Ingested, ingest};
use super::measure;
use super::progress::Progress;
use super::publish::{self, Published, Staging};
use super::results::{
    BuildResult, Failure, GpuResult, GpuRow, HeightMapFile, LobeResult, RESULTS_SCHEMA, RunResults, SpecimenResult,
    SpectrumFile, StageTime, Statistics,
};
use super::scenes::{SceneWork, render_tables};
use super::shared_scenes::{self, Share, SharedScenes};
use super::specimen::{self, CheckValue, SpecimenFile};
use super::worked::work_number;
use crate::ground::direction::{Vec3, from_angles_deg};
use crate::ground::error::{Error, Result};
use crate::ground::png_image::write_png;
use crate::ground::{files, sampling};
use crate::height::HeightField;
use crate::render::cpu;
use crate::render::gpu::Gpu;
use crate::scene::model::{Exposure, Light, Scene, Shape};
use crate::tables::build::{self, BuildPlan};
use crate::tables::evaluate::{Interpolation, brdf_xyz};
use crate::tables::model::{Basis, BuildRecord, TableSet};
use crate::tables::storage::{read_tables, write_tables};

/// Directions whose values are stored for testing other programs.
const CHECK_VALUES: usize = 20;

/// Directions of the worked number in `FORMAT.md`, in degrees.
const WORKED_DEG: [f64; 4] = [35.0, 20.0, 61.0, 250.0];

/// Side of the preview in pixels.
const PREVIEW_PX: usize = 192;

/// Draws a specimen's heights and their spectrum into its folder; given by the floor that knows how.
pub type Illustrate<'a> =
    &'a (dyn Fn(&HeightField, &Statistics, &Path, &str) -> Result<(HeightMapFile, SpectrumFile)> + Sync);

/// Writes the report of a run into its folder; likewise.
pub type WriteReport<'a> = &'a (dyn Fn(&RunResults, &Path) -> Result<()> + Sync);

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
    let mut results = empty_results(config, helpers);
    let gpu = open_gpu(config, &mut results)?;
    let mut index = AtlasIndex::new(
        &config.atlas_name,
        &files::sha256_hex(config.manifest_text.as_bytes()),
        Vec::new(),
        Vec::new(),
    );
    let mut example = None;
    let mut shared = SharedScenes::new(&config.scenes);
    for (number, specimen) in config.specimens.iter().enumerate() {
        let label = format!("[{}/{}] {}", number + 1, config.specimens.len(), specimen.name);
        let specimen_started = Instant::now();
        match run_specimen(config, specimen, &staging, helpers, gpu.as_ref(), &mut results.stages) {
            Ok(done) => {
                helpers.progress.message(&done_line(&label, &done.result, specimen_started.elapsed().as_secs_f64()));
                record_gpu(&mut results, &specimen.name, done.gpu);
                index.inputs.extend(done.inputs);
                shared.add(done.shares);
                index.specimens.push(entry(specimen));
                example.get_or_insert(specimen.name.clone());
                results.specimens.push(done.result);
            }
            Err(failed) => {
                helpers.progress.message(&format!("{label}: failed to {}", failed.stage));
                let _ = std::fs::remove_dir_all(staging.path().join(&specimen.name));
                results.failures.push(Failure {
                    specimen: Some(specimen.name.clone()),
                    stage: failed.stage.into(),
                    message: failed.error.to_string(),
                });
                results.specimens.push(failed_result(specimen, &failed.error));
            }
        }
    }
    index.inputs.extend(shared_scenes::inputs(&config.scenes, &config.base));
    let (pictures, failures) = shared.finish(staging.path());
    results.shared_scenes = pictures;
    results.failures.extend(failures);
    results.total_wall_s = started.elapsed().as_secs_f64();
    results.peak_memory_mib = peak_memory_mib();
    let Some(example) = example else {
        return Ok(RunOutcome { results, published: None });
    };
    write_format(&staging.path().join(example), staging.path())?;
    // Where nothing has changed the report goes with the staging folder.
    results.version = Some(staging.next_version()?);
    (helpers.write_report)(&results, staging.path())?;
    let published = publish::publish(staging, index)?;
    results.version = Some(published.version().to_owned());
    Ok(RunOutcome { results, published: Some(published) })
}

/// Largest side of the pictures compared on the GPU: every texel look-up is exercised at any size, and a
/// software driver takes seconds beyond.
const GPU_SIDE_MAX_PX: usize = 128;

/// The GPU, where one is wanted and there.
fn open_gpu(config: &RunConfig, results: &mut RunResults) -> Result<Option<Gpu>> {
    let gpu = match config.gpu {
        GpuCheck::Off => return Ok(None),
        GpuCheck::Required => Some(Gpu::require()?),
        GpuCheck::Auto => Gpu::open()?,
    };
    results.gpu = match &gpu {
        Some(gpu) => GpuResult::Checked { adapter: adapter_text(gpu), rows: Vec::new() },
        None => GpuResult::Skipped { why: "no adapter: no Vulkan, Metal or DirectX 12 driver was found".into() },
    };
    Ok(gpu)
}

fn adapter_text(gpu: &Gpu) -> String {
    let info = gpu.info();
    format!("{} ({}, {})", info.adapter, info.backend, info.driver)
}

/// Every scene of a specimen on the GPU against the CPU: the largest difference as a share of what
/// rounding and hardware filtering allow that pixel.
fn gpu_rows(gpu: &Gpu, name: &str, set: &TableSet, scenes: &[Scene]) -> Result<Vec<GpuRow>> {
    let smaller = |scene: &Scene| Scene { size_px: scene.size_px.min(GPU_SIDE_MAX_PX), ..scene.clone() };
    let scenes: Vec<Scene> = scenes.iter().map(smaller).collect();
    let checks = check_specimen(gpu, set, &scenes)?;
    Ok(checks
        .into_iter()
        .map(|check| GpuRow {
            specimen: name.to_owned(),
            what: format!("{}, share of the difference allowed", check.scene),
            values: check.samples,
            relative_l2: check.mean,
            // A value that is not finite has no share; it must not pass.
            worst: if check.not_finite == 0 { check.worst_of_tolerance } else { f64::NAN },
            limit: 1.0,
        })
        .collect())
}

/// Adds a specimen's comparisons; those that miss their limit are failures of the run.
fn record_gpu(results: &mut RunResults, specimen: &str, rows: Vec<GpuRow>) {
    for row in rows.iter().filter(|row| !row.passed()) {
        results.failures.push(Failure {
            specimen: Some(specimen.to_owned()),
            stage: "check on the GPU".into(),
            message: format!("{}: {:.2} times what rounding and filtering allow", row.what, row.worst),
        });
    }
    if let GpuResult::Checked { rows: all, .. } = &mut results.gpu {
        all.extend(rows);
    }
}

/// The line that a finished specimen leaves on the screen.
fn done_line(label: &str, result: &SpecimenResult, seconds: f64) -> String {
    let (tables, size) = result.build.as_ref().map_or((0, 0), |build| (build.tables, build.size));
    format!("{label}: {tables} tables of {size}², {seconds:.1} s")
}

/// What a finished specimen leaves besides its files.
struct Done {
    result: SpecimenResult,
    gpu: Vec<GpuRow>,
    inputs: Vec<InputRecord>,
    shares: Vec<Share>,
}

/// Where and why a specimen failed.
struct Failed {
    stage: &'static str,
    error: Error,
}

/// Times one stage and says which one failed.
struct Clock<'a> {
    specimen: &'a str,
    times: &'a mut Vec<StageTime>,
    progress: &'a dyn Progress,
}

impl Clock<'_> {
    fn stage<T>(
        &mut self,
        name: &'static str,
        steps: u64,
        work: impl FnOnce() -> Result<T>,
    ) -> std::result::Result<T, Failed> {
        self.progress.stage(&format!("{}: {name}", self.specimen), steps);
        let started = Instant::now();
        let outcome = work();
        self.progress.finish();
        self.times.push(StageTime {
            name: name.into(),
            specimen: Some(self.specimen.into()),
            wall_s: started.elapsed().as_secs_f64(),
            cpu_s: None,
        });
        outcome.map_err(|error| Failed { stage: name, error })
    }

    fn last_s(&self) -> f64 {
        self.times.last().map_or(0.0, |time| time.wall_s)
    }
}

fn run_specimen(
    config: &RunConfig,
    specimen: &SpecimenConfig,
    staging: &Staging,
    helpers: &Helpers,
    gpu: Option<&Gpu>,
    times: &mut Vec<StageTime>,
) -> std::result::Result<Done, Failed> {
    let mut clock = Clock { specimen: &specimen.name, times, progress: helpers.progress };
    let folder = staging.path().join(&specimen.name);
    let optics = &specimen.optics;
    let ingested = clock.stage("read and prepare", 0, || {
        files::create_folder(&folder.join("scenes"))?;
        ingest(specimen)
    })?;
    let plan = clock.stage("plan", 0, || build::plan(&ingested.fields, optics, &config.tables))?;
    let steps = plan.rings.iter().map(|ring| ring.quadrature.wavelengths_nm.len()).sum::<usize>() * plan.windows.len();
    let (built, record) = clock.stage("build tables", steps as u64, || {
        build::build(&ingested.fields, optics, &config.tables, &|n| helpers.progress.advance(n))
    })?;
    let build_s = clock.last_s();
    let stored = clock.stage("store tables", 0, || write_tables(&folder, &built, config.tables.storage))?;
    let set = clock.stage("read back", 0, || read_tables(&folder, &stored, optics))?;
    let wanted = shared_scenes::scenes_for(&config.scenes, &specimen.name);
    let works = clock.stage("render scenes", 0, || {
        wanted.iter().map(|scene| render_tables(scene, &set)).collect::<Result<Vec<SceneWork>>>()
    })?;
    let pairs: Vec<(Vec3, Vec3)> =
        measure::fixed_pairs().into_iter().chain(works.iter().flat_map(SceneWork::pairs)).collect();
    let gpu = match gpu {
        Some(gpu) => clock.stage("check on the GPU", 0, || gpu_rows(gpu, &specimen.name, &set, &wanted))?,
        None => Vec::new(),
    };
    let yardstick = clock.stage("evaluate the reference", 0, || {
        measure::yardstick(&ingested.fields, optics, &plan, built.tables.len(), pairs)
    })?;
    let mut result = describe(specimen, &ingested, config, &set, &record, &plan);
    clock.stage("measure errors", 0, || {
        result.errors = measure::error_rows(&yardstick, &set, &built);
        result.errors.push(measure::direct_row(&ingested.fields, optics, &yardstick)?);
        let (sums, lobe_share) = measure::power_sums(&set);
        result.power_sums = sums;
        if let Some(lobe) = &mut result.lobe {
            lobe.power_share = lobe_share;
        }
        Ok(())
    })?;
    let mut shares = Vec::new();
    clock.stage("write pictures", 0, || {
        let mut next = measure::fixed_pairs().len();
        for work in works {
            let reference = &yardstick.xyz[next..next + work.pair_count()];
            next += work.pair_count();
            if work.is_share() {
                let expected = work.expected(reference);
                shares.push(shared_scenes::share(work, expected));
            } else {
                result.scenes.push(work.finish(reference, &folder, &specimen.name)?);
            }
        }
        write_preview(&set, &folder)?;
        result.preview_png = Some(format!("{}/preview.png", specimen.name));
        if let Some(statistics) = &result.statistics {
            let (map, spectrum) = (helpers.illustrate)(&ingested.fields[0], statistics, &folder, &specimen.name)?;
            result.height_map = Some(map);
            result.spectrum = Some(spectrum);
        }
        let file = specimen_file(specimen, &ingested, stored, &result, &set);
        specimen::write(&folder, &file)
    })?;
    if let Some(build) = &mut result.build {
        build.build_s = build_s;
        build.stored_bytes = clock.stage("count bytes", 0, || exr_bytes(&folder))?;
    }
    Ok(Done { result, gpu, inputs: inputs(config, specimen, &ingested), shares })
}

/// Everything about a specimen that is known before its errors are measured.
fn describe(
    specimen: &SpecimenConfig,
    ingested: &Ingested,
    config: &RunConfig,
    set: &TableSet,
    record: &BuildRecord,
    plan: &BuildPlan,
) -> SpecimenResult {
    let field = &ingested.fields[0];
    let [nx, ny] = field.extent_nm();
    SpecimenResult {
        name: specimen.name.clone(),
        species: specimen.species.clone(),
        generated: specimen.species.as_deref().is_some_and(|species| species.starts_with("generated")),
        scans: ingested.provenance.iter().map(to_value).collect(),
        size: field.size(),
        pitch_nm: field.pitch_nm,
        extent_um: [nx * 1e-3, ny * 1e-3],
        statistics: ingested.statistics.first().cloned(),
        optics: Some(specimen.optics.clone()),
        build: Some(BuildResult {
            basis: set.basis,
            tables: set.tables.len(),
            size: set.size(),
            storage: config.tables.storage,
            stored_bytes: 0,
            prefilter_width: set.prefilter_width,
            tolerance: config.tables.tolerance,
            record: record.clone(),
            build_s: 0.0,
        }),
        lobe: set.lobe.as_ref().map(|lobe| LobeResult {
            radius_max: lobe.radius_max,
            cross_tables: lobe.cross.len(),
            power_share: None,
        }),
        errors: Vec::new(),
        power_sums: Vec::new(),
        scenes: Vec::new(),
        height_map: None,
        spectrum: None,
        preview_png: None,
        warnings: warnings(specimen, set, plan),
        failed: None,
    }
}

/// What a user must know about these tables.
fn warnings(specimen: &SpecimenConfig, set: &TableSet, plan: &BuildPlan) -> Vec<String> {
    let mut warnings = Vec::new();
    if specimen.measured.is_some() {
        warnings.push("`measured` is named, but this version does not compare with measured reflectance yet".into());
    }
    if set.usable_radius < 2.0 {
        warnings.push(format!(
            "the scan's sampling answers for |(u, v)| up to {:.2} only: beyond, some wavelengths are missing and values are too dark",
            set.usable_radius
        ));
    }
    if set.prefilter_width > 0.0 {
        warnings.push(format!(
            "a texel ({:.4}) is wider than the coherence lobe: each holds the mean over a square of {:.4} in u and v, \
             so single directions differ from the point values while pictures of extended lights and pixels do not",
            plan.grid.texel(),
            set.prefilter_width
        ));
    }
    if set.basis == Basis::Taylor {
        warnings.push("tables of the published Taylor series, kept for comparison".into());
    }
    warnings
}

fn entry(specimen: &SpecimenConfig) -> SpecimenEntry {
    SpecimenEntry { name: specimen.name.clone(), species: specimen.species.clone().unwrap_or_default() }
}

fn inputs(config: &RunConfig, specimen: &SpecimenConfig, ingested: &Ingested) -> Vec<InputRecord> {
    let name = |path: &Path| path.strip_prefix(&config.base).unwrap_or(path).display().to_string();
    let scans = specimen.scans.iter().zip(&ingested.provenance);
    scans.map(|(path, provenance)| InputRecord { path: name(path), sha256: provenance.sha256.clone() }).collect()
}

fn to_value(value: &impl serde::Serialize) -> Value {
    serde_json::to_value(value).unwrap_or(Value::Null)
}

fn specimen_file(
    specimen: &SpecimenConfig,
    ingested: &Ingested,
    tables: crate::tables::storage::StoredTables,
    result: &SpecimenResult,
    set: &TableSet,
) -> SpecimenFile {
    SpecimenFile {
        schema: specimen::SCHEMA,
        name: specimen.name.clone(),
        species: specimen.species.clone().unwrap_or_default(),
        provenance: to_value(&ingested.provenance),
        preparation: json!({ "settings": specimen.prepare, "done": ingested.preparation }),
        statistics: to_value(&ingested.statistics),
        optics: specimen.optics.clone(),
        build: result.build.as_ref().map(|build| build.record.clone()).unwrap_or_default(),
        tables,
        errors: to_value(&result.errors),
        check_values: check_values(set),
        warnings: result.warnings.clone(),
    }
}

/// Values for testing other programs: half over the whole hemisphere, half around the mirror direction.
fn check_values(set: &TableSet) -> Vec<CheckValue> {
    let angle = |share: f64, range: f64| (share * range * 10.0).round() / 10.0;
    (0..CHECK_VALUES)
        .map(|index| {
            let [a, b, c, d] = sampling::four(index);
            let (theta_i_deg, phi_i_deg) = (angle(a, 80.0), angle(b, 360.0));
            let (theta_r_deg, phi_r_deg) = if index % 2 == 0 {
                (angle(c, 80.0), angle(d, 360.0))
            } else {
                ((theta_i_deg + angle(c, 2.0) - 1.0).abs(), (phi_i_deg + 179.0 + angle(d, 2.0)) % 360.0)
            };
            let (wi, wo) = (from_angles_deg(theta_i_deg, phi_i_deg), from_angles_deg(theta_r_deg, phi_r_deg));
            let xyz = brdf_xyz(set, Interpolation::Bilinear, wi, wo);
            CheckValue { theta_i_deg, phi_i_deg, theta_r_deg, phi_r_deg, wi, wo, xyz }
        })
        .collect()
}

/// A ball under a sun high to the right: the picture of a specimen in lists.
fn write_preview(set: &TableSet, folder: &Path) -> Result<()> {
    let scene = Scene {
        name: "preview".into(),
        shape: Shape::Sphere,
        lights: vec![Light { direction: [0.5, 0.5, 1.0], angular_diameter_deg: 0.53, irradiance: 1.0 }],
        size_px: PREVIEW_PX,
        exposure: Exposure::Auto,
        specimen: None,
        light_samples: 16,
        pixel_samples: 4,
    };
    let image = cpu::render(&scene, &|wi, wo| brdf_xyz(set, Interpolation::Bilinear, wi, wo))?;
    let exposure = crate::scene::model::exposure_factor(scene.exposure, &image);
    write_png(&folder.join("preview.png"), &crate::ground::colour::to_srgb8(&image, exposure))
}

fn write_format(specimen_folder: &Path, version_folder: &Path) -> Result<()> {
    let (file, set) = specimen::load(specimen_folder)?;
    let text = format_md(&file, &work_number(&set, WORKED_DEG));
    files::replace(&version_folder.join("FORMAT.md"), text.as_bytes())
}

/// Bytes of the table files: what a renderer loads.
fn exr_bytes(folder: &Path) -> Result<u64> {
    let mut bytes = 0;
    for (path, kind) in files::entries(folder)? {
        if kind.is_file() && path.extension().is_some_and(|extension| extension == "exr") {
            bytes += path.metadata().map_err(|e| Error::disk(&path, "read the size of", e))?.len();
        }
    }
    Ok(bytes)
}

fn failed_result(specimen: &SpecimenConfig, error: &Error) -> SpecimenResult {
    SpecimenResult {
        name: specimen.name.clone(),
        species: specimen.species.clone(),
        generated: false,
        scans: Vec::new(),
        size: [0, 0],
        pitch_nm: [0.0, 0.0],
        extent_um: [0.0, 0.0],
        statistics: None,
        optics: None,
        build: None,
        lobe: None,
        errors: Vec::new(),
        power_sums: Vec::new(),
        scenes: Vec::new(),
        height_map: None,
        spectrum: None,
        preview_png: None,
        warnings: Vec::new(),
        failed: Some(error.to_string()),
    }
}

fn empty_results(config: &RunConfig, helpers: &Helpers) -> RunResults {
    RunResults {
        schema: RESULTS_SCHEMA,
        atlas_name: config.atlas_name.clone(),
        version: None,
        program_version: env!("CARGO_PKG_VERSION").into(),
        started: helpers.started.into(),
        threads: rayon::current_num_threads(),
        cpu_count: std::thread::available_parallelism().map_or(1, usize::from),
        manifest_text: config.manifest_text.clone(),
        specimens: Vec::new(),
        shared_scenes: Vec::new(),
        stages: Vec::new(),
        gpu: GpuResult::Off,
        failures: Vec::new(),
        peak_memory_mib: None,
        total_wall_s: 0.0,
    }
}

/// Most memory this process held, where the system tells (Linux).
fn peak_memory_mib() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    let kib: f64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kib / 1024.0)
}
