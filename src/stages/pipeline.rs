//! The pipeline: specimen after specimen from scan to published tables, with times and failures.
//!
//! Each specimen passes the same chain of functions; a specimen that fails is recorded and the others go
//! on. Nothing is visible in the atlas before the one rename at the end.

use std::path::Path;
use std::time::Instant;

use super::cache::{Cache, CacheUse};
use super::config::{RunConfig, Serve, SpecimenConfig};
use super::describe::{describe, entry, failed_result, inputs, scan_warnings, specimen_file};
use super::format_md::format_md;
use super::gpu_stage;
use super::ingest::ingest;
use super::known::Known;
use super::known_reach::known_reach;
use super::measured;
use super::publish::{self, Published, Staging};
use super::reached::reached_picture;
use super::results::{
    Failure, GpuResult, HeightMapFile, RESULTS_SCHEMA, RunResults, SpecimenResult, SpectrumFile, StageTime, Statistics,
};
use super::scenes::{self, SceneWork, candidates_of, render_tables};
use super::serve::{self, Cost, Source};
use super::shared_scenes::{self, Share, SharedScenes};
use super::specimen;
use super::usage::Stopwatch;
use super::worked::work_number;
use diffraction_brdf::atlas::{AtlasIndex, InputRecord};
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::evaluate::Interpolation;
use diffraction_brdf::files;
use diffraction_brdf::storage::read_tables;
use diffraction_build::accuracy::directions::{DIRECTIONS, ErrorDirections};
use diffraction_build::accuracy::power_sums::power_sums;
use diffraction_build::accuracy::rows;
use diffraction_build::ground::memory;
use diffraction_build::ground::progress::Progress;
use diffraction_build::height::HeightField;
use diffraction_build::optics::pigment::Surface;
use diffraction_build::optics::pigment::pigment;
use diffraction_build::tables::build;
use diffraction_build::tables::forecast::forecast_of;
use diffraction_build::tables::model::Basis;
use diffraction_build::tables::plan::lobe_radius;
use diffraction_build::tables::rounding;
use diffraction_render::render::cpu;
use diffraction_render::render::png_image::write_png;
use diffraction_render::scene::model::{Light, Scene, Shape};

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
    let gpu = gpu_stage::open(config, &mut results, helpers.progress)?;
    let cache = Cache::open(&config.cache);
    results.cache = cache.is_on().then(CacheUse::default);
    let mut index = AtlasIndex::new(
        &config.atlas_name,
        &files::sha256_hex(config.manifest_text.as_bytes()),
        Vec::new(),
        Vec::new(),
    );
    let mut example = None;
    let mut shared = SharedScenes::new(&config.scenes);
    let asked_for: Vec<&SpecimenConfig> =
        config.specimens.iter().filter(|specimen| serve::is_asked_for(config, &specimen.name)).collect();
    for (number, specimen) in asked_for.iter().enumerate() {
        let label = format!("[{}/{}] {}", number + 1, asked_for.len(), specimen.name);
        let specimen_started = Instant::now();
        match run_specimen(config, specimen, &staging, helpers, &cache, &mut results.stages) {
            Ok(mut done) => {
                if let Some(used) = &mut results.cache {
                    *used = used.with(&done.used, cache.traffic());
                }
                if let Some(gpu) = &gpu {
                    let unchecked =
                        gpu_stage::check(gpu, config, specimen, staging.path(), &mut results, helpers.progress)?;
                    done.result.warnings.extend(unchecked);
                }
                helpers.progress.message(&done_line(&label, &done, specimen_started.elapsed().as_secs_f64()));
                record_unserved(&mut results, &done.result);
                results.failures.extend(rows::disagreement(&done.result.errors).map(|message| Failure {
                    specimen: Some(specimen.name.clone()),
                    stage: "measure errors".into(),
                    message,
                }));
                index.inputs.extend(done.inputs);
                shared.add(done.shares);
                index.specimens.push(entry(specimen));
                example.get_or_insert(specimen.name.clone());
                results.specimens.push(done.result);
            }
            // A full disk is no specimen's fault, and would leave out the next ones too.
            Err(failed) if failed.error.is_of_disk_below(staging.path()) => return Err(failed.error),
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
    if let Some(gpu) = &gpu {
        gpu_stage::time_frames(gpu, config, staging.path(), &mut results, helpers.progress)?;
    }
    index.inputs.extend(scenes::inputs(config));
    index.inputs.extend(shared_scenes::inputs(&config.scenes, &config.base));
    let (pictures, failures) = shared.finish(staging.path())?;
    results.shared_scenes = pictures;
    results.failures.extend(failures);
    results.total_wall_s = started.elapsed().as_secs_f64();
    results.peak_memory_mib = memory::process_peak_bytes().map(|bytes| bytes as f64 / f64::from(1 << 20));
    let Some(example) = example else {
        return Ok(RunOutcome { results, published: None });
    };
    write_format(&staging.path().join(example), staging.path())?;
    // Where nothing has changed the report goes with the staging folder.
    results.version = Some(staging.next_version()?);
    if config.report.write {
        (helpers.write_report)(&results, staging.path())?;
    }
    let published = publish::publish(staging, index)?;
    results.version = Some(published.version().to_owned());
    Ok(RunOutcome { results, published: Some(published) })
}

/// Lists pictures that ask for more than the tables serve.
fn record_unserved(results: &mut RunResults, specimen: &SpecimenResult) {
    for scene in specimen.scenes.iter().filter(|scene| scene.unserved_pixels > 0) {
        results.failures.push(Failure {
            specimen: Some(specimen.name.clone()),
            stage: "render scenes".into(),
            message: format!(
                "{}: {} pixels ask for directions that the tables do not serve",
                scene.name, scene.unserved_pixels
            ),
        });
    }
}

/// The line that a finished specimen leaves on the screen.
fn done_line(label: &str, done: &Done, seconds: f64) -> String {
    let (tables, size) = done.result.build.as_ref().map_or((0, 0), |build| (build.tables, build.size));
    let CacheUse { tables_found, texels_found, texels_summed, pairs_found, .. } = done.used;
    // Not all until it is all.
    let percent = 100 * texels_found / (texels_found + texels_summed).max(1);
    let known: Vec<String> = [
        (tables_found > 0).then(|| "the tables".into()),
        (texels_found > 0).then(|| format!("{percent} % of the tables' sums")),
        (pairs_found > 0).then(|| format!("{pairs_found} reference values")),
    ]
    .into_iter()
    .flatten()
    .collect();
    let known = if known.is_empty() { String::new() } else { format!(", known: {}", known.join(", ")) };
    format!("{label}: {tables} tables of {size}², {seconds:.1} s{known}")
}

/// What a finished specimen leaves besides its files.
struct Done {
    result: SpecimenResult,
    inputs: Vec<InputRecord>,
    shares: Vec<Share>,
    used: CacheUse,
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
        let stopwatch = Stopwatch::start();
        let outcome = work();
        self.progress.finish();
        self.times.push(stopwatch.read(name, Some(self.specimen)));
        outcome.map_err(|error| Failed { stage: name, error })
    }
}

fn run_specimen(
    config: &RunConfig,
    specimen: &SpecimenConfig,
    staging: &Staging,
    helpers: &Helpers,
    cache: &Cache,
    times: &mut Vec<StageTime>,
) -> std::result::Result<Done, Failed> {
    let mut clock = Clock { specimen: &specimen.name, times, progress: helpers.progress };
    let folder = staging.path().join(&specimen.name);
    let optics = &specimen.optics;
    let ingested = clock.stage("read and prepare", 0, || {
        files::create_folder(&folder.join("scenes"))?;
        ingest(specimen)
    })?;
    let measurement = match &specimen.measured {
        Some(config) => Some(clock.stage("read measured reflectance", 0, || measured::read(config))?),
        None => None,
    };
    let tables = serve::tables_for(config, &specimen.name);
    let source = Source { fields: &ingested.fields, optics, tables: &tables };
    let known = Known::new(cache, &ingested.fields);
    let pictured = serve::pictured_scenes(config, &specimen.name);
    let wanted: Vec<&Scene> = pictured.iter().collect();
    let serving = config.serve != Serve::All;
    let domain = match serving {
        false => None,
        true => Some(clock.stage("find what the scenes reach", 0, || {
            let reach = |scene: &Scene, grid, parts| known_reach(cache, scene, grid, parts);
            serve::domain_by(&reach, &source, &wanted)
        })?),
    };
    let plan = clock.stage("plan", 0, || build::plan_for(&ingested.fields, optics, &tables, domain.clone()))?;
    let steps = plan.rings.iter().map(|ring| ring.quadrature.wavelengths_nm.len()).sum::<usize>() * plan.windows.len();
    let done = clock.stage("build tables", steps as u64, || {
        known.tables(&source, &plan, config.report.savings, &|n| helpers.progress.advance(n))
    })?;
    let built = &done.set;
    let chosen = clock.stage("round to the tolerance", 0, || {
        Ok(rounding::choose(built, tables.storage, tables.tolerance, lobe_radius(optics)))
    })?;
    let stored = clock.stage("store tables", 0, || chosen.write(&folder))?;
    let (set, pigment) = clock.stage("read back", 0, || {
        let pigment = specimen.albedo.map(|albedo| pigment(albedo, optics)).transpose()?;
        Ok((read_tables(&folder, &stored, optics.front_factor())?, pigment))
    })?;
    let surface = Surface { tables: &set, pigment: pigment.as_ref() };
    let works = clock.stage("render scenes", 0, || {
        wanted.iter().map(|scene| render_tables(scene, surface)).collect::<Result<Vec<SceneWork>>>()
    })?;
    if works.iter().any(SceneWork::is_animated) {
        clock.stage("render animations", 0, || works.iter().try_for_each(|work| work.animate(surface, &folder)))?;
    }
    let directions = match serving {
        false => ErrorDirections::of_regions(&set),
        true => ErrorDirections::drawn(&set, candidates_of(&set, &works), DIRECTIONS),
    };
    let served = directions.pairs.clone();
    let mut result = describe(specimen, &ingested, &tables, &set, pigment, &stored, &done.record, &plan);
    let reference = match config.report.reference {
        false => None,
        true => Some(clock.stage("evaluate the reference", 0, || {
            let pictures = works.iter().flat_map(SceneWork::pairs);
            known.reference(&source, &plan, built.tables.len(), directions, pictures)
        })?),
    };
    result.warnings.extend(scan_warnings(&ingested, optics));
    result.warnings.extend(scenes::warnings(&wanted, optics));
    clock.stage("measure errors", 0, || {
        if let Some(reference) = &reference {
            result.errors = rows::error_rows(reference, &set, built);
            result.errors.push(known.direct_row(&source, reference)?);
            result.warnings.extend(rows::broken_tolerances(&result.errors, tables.tolerance));
        }
        let (sums, lobe_share) = power_sums(&set);
        result.power_sums = sums;
        if let Some(lobe) = &mut result.lobe {
            lobe.power_share = lobe_share;
        }
        Ok(())
    })?;
    if let Some(measurement) = &measurement {
        result.measured = Some(clock.stage("compare with measured reflectance", 0, || {
            let file = config.relative_name(&measurement.config.file);
            measured::compare(&ingested.fields, optics, measurement, file, plan.spectra.memory_bytes)
        })?);
    }
    let mut shares = Vec::new();
    clock.stage("write pictures", 0, || {
        let mut next = served.len();
        for work in works {
            let own = next..next + work.pair_count();
            next = own.end;
            let exact = reference.as_ref().map(|reference| &reference.xyz[own]);
            if work.is_share() {
                let expected = exact.map(|exact| work.expected(exact));
                shares.push(shared_scenes::share(work, expected));
            } else {
                result.scenes.push(work.finish(exact, &folder, &specimen.name)?);
            }
        }
        result.preview_png = preview(surface, &result, &folder)?;
        if let Some(picture) = reached_picture(&set) {
            write_png(&folder.join("served.png"), &picture)?;
            result.reached_png = Some(format!("{}/served.png", specimen.name));
        }
        if let Some(statistics) = &result.statistics {
            let (map, spectrum) = (helpers.illustrate)(&ingested.fields[0], statistics, &folder, &specimen.name)?;
            result.height_map = Some(map);
            result.spectrum = Some(spectrum);
        }
        let file = specimen_file(specimen, &ingested, stored, &result, &set, &served);
        specimen::write(&folder, &file)
    })?;
    let stored_bytes = clock.stage("count bytes", 0, || files::bytes_of(&folder, "exr"))?;
    // What was put together from earlier sums tells nothing of what tables cost.
    let measured = (done.known_share() == 0.0).then(|| Cost::measured(&done, stored_bytes as f64));
    if let Some(build) = &mut result.build {
        (build.build_s, build.stored_bytes) = (done.seconds, stored_bytes);
        build.build_cpu_s = done.processor_s;
        build.known_share = done.known_share();
        build.memory_bytes = done.memory_bytes;
        // The published series is built another way, which no forecast knows.
        if tables.basis == Basis::Chebyshev {
            let threads = rayon::current_num_threads();
            build.predicted = Some(Cost::predicted(&forecast_of(source.fields, optics, &tables, &plan, threads)));
        }
    }
    if let Some(domain) = &domain {
        result.budget = Some(clock.stage("account for what is left out", 0, || {
            serve::account(&source, &wanted, domain, &config.tables, measured, config.report.savings)
        })?);
    }
    let inputs = inputs(config, specimen, &ingested, measurement.as_ref());
    Ok(Done { result, inputs, shares, used: known.used() })
}

/// Path of the picture of a specimen in lists: the first of its scenes where tables serve nothing else.
fn preview(surface: Surface, result: &SpecimenResult, folder: &Path) -> Result<Option<String>> {
    if surface.tables.served.is_some() {
        return Ok(result.scenes.first().map(|scene| scene.table_png.clone()));
    }
    write_preview(surface, folder)?;
    Ok(Some(format!("{}/preview.png", result.name)))
}

/// A ball under a sun high to the right.
fn write_preview(surface: Surface, folder: &Path) -> Result<()> {
    let sun = Light { angular_diameter_deg: 0.53, ..Light::point([0.5, 0.5, 1.0]) };
    let still = Scene::still("preview", Shape::Sphere, vec![sun], PREVIEW_PX);
    let scene = Scene { light_samples: 16, pixel_samples: 4, ..still };
    let image = cpu::render(&scene, &|wi, wo| surface.xyz(Interpolation::Bilinear, wi, wo))?;
    let exposure = diffraction_render::scene::model::exposure_factor(scene.exposure, &image);
    write_png(&folder.join("preview.png"), &diffraction_build::ground::colour::to_srgb8(&image, exposure))
}

fn write_format(specimen_folder: &Path, version_folder: &Path) -> Result<()> {
    let (file, set) = specimen::load(specimen_folder)?;
    let angles = match (&set.served, file.check_values.first()) {
        (Some(_), Some(c)) => [c.theta_i_deg, c.phi_i_deg, c.theta_r_deg, c.phi_r_deg],
        _ => WORKED_DEG,
    };
    let text = format_md(&file, &work_number(&set, angles));
    files::replace(&version_folder.join("FORMAT.md"), text.as_bytes())
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
        left_out: serve::left_out(config),
        cache: None,
        peak_memory_mib: None,
        total_wall_s: 0.0,
    }
}
