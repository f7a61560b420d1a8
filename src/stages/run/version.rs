//! The version to come: specimens and shared scenes put together, its index, and what the run says of it all.

use std::collections::HashSet;
use std::time::Instant;

use super::choose::{FoundScenes, Newest};
use super::made_from::scene_value;
use super::taken::Taken;
use super::underway::Run;
use crate::error::Result;
use crate::stages::archive::format_md::write_format;
use crate::stages::archive::publish::{self, Published, Staging};
use crate::stages::cache::store::CacheUse;
use crate::stages::config::RunConfig;
use crate::stages::coverage::asked;
use crate::stages::digest::record_file;
use crate::stages::gpu::results::{FrameComparison, GpuResult};
use crate::stages::gpu::stage::{self as gpu_stage, Compared, Opened};
use crate::stages::pictures::scenes;
use crate::stages::pictures::shared_scenes::{self, FOLDER, SharedRecord, SharedScenes};
use crate::stages::pictures::sharing::specimens_of;
use crate::stages::results::{RESULTS_SCHEMA, RunResults, SharedSceneResult};
use diffraction_brdf::atlas::{AtlasIndex, FileRecord, MANIFEST_FILE, PAGES_FOLDER, SpecimenEntry, page_path};
use diffraction_brdf::files;
use diffraction_build::ground::memory;
use serde_json::json;

/// What the run found out besides its specimens.
#[derive(Default)]
struct Besides {
    /// The version that is published if anything has changed.
    version: Option<String>,
    shared: Vec<SharedSceneResult>,
    frames: Option<FrameComparison>,
}

/// Publishes what was taken, unless there is nothing, or the newest version holds the same.
pub(super) fn publish(
    mut run: Run,
    mut taken: Vec<Taken>,
    found: FoundScenes,
    started: Instant,
    mut staging: Staging,
) -> Result<(RunResults, Option<Published>)> {
    if taken.iter().all(|taken| taken.unit.is_none()) {
        return Ok((results(run, taken, Besides::default(), started), None));
    }
    let index = index(run.config, &taken);
    if let Some(newest) =
        run.newest.as_ref().filter(|newest| holds_the_same(newest, run.config, &index, &taken, &found))
    {
        if let Some(lock) = &run.config.frozen {
            lock.check_files(&newest.index)?;
        }
        let published = Published::Unchanged(newest.name.clone());
        let shared = found.into_values().map(|record| record.result).collect();
        return Ok((results(run, taken, Besides { shared, ..Besides::default() }, started), Some(published)));
    }
    let mut known = link_specimens(&taken, &mut staging)?;
    known.extend(link_pages(&run, &taken, &mut staging)?);
    run.open_gpu()?;
    let frames = match run.gpu.as_ref().and_then(Opened::device) {
        Some(device) => gpu_stage::time_frames(device, run.config, staging.path(), &mut run.log)?,
        None => None,
    };
    let shared = shared_scenes(&mut run, &mut taken, found, &staging)?;
    files::replace(&staging.path().join(MANIFEST_FILE), run.config.manifest_text.as_bytes())?;
    write_format(&staging.path().join(&index.specimens[0].name), staging.path())?;
    let (config, helpers) = (run.config, run.helpers);
    let version = Some(staging.next_version()?);
    let results = results(run, taken, Besides { version, shared, frames }, started);
    if config.report.write {
        (helpers.write_report)(&results, staging.path())?;
    }
    let index = publish::recorded(&staging, index, known)?;
    if let Some(lock) = &config.frozen {
        lock.check_files(&index)?;
    }
    let published = publish::publish_recorded(staging, index)?;
    Ok((results, Some(published)))
}

fn index(config: &RunConfig, taken: &[Taken]) -> AtlasIndex {
    let units = || taken.iter().filter_map(|taken| Some((taken, taken.unit.as_ref()?)));
    let mut inputs: Vec<_> = units().flat_map(|(_, unit)| unit.inputs.iter().cloned()).collect();
    inputs.extend(config.collection.clone());
    inputs.extend(scenes::inputs(config));
    inputs.extend(shared_scenes::inputs(&config.scenes, &config.base));
    let entry = |(taken, _): (&Taken, _)| SpecimenEntry {
        name: taken.result.name.clone(),
        species: taken.result.species.clone().unwrap_or_default(),
        stale: taken.result.stale.clone(),
    };
    AtlasIndex::new(&config.atlas_name, &config.manifest_sha256, inputs, units().map(entry).collect())
}

/// Whether the newest version is what would be published, undamaged: then nothing has to be put together.
fn holds_the_same(
    newest: &Newest,
    config: &RunConfig,
    index: &AtlasIndex,
    taken: &[Taken],
    found: &FoundScenes,
) -> bool {
    let shared = config.scenes.iter().filter(|scene| !specimens_of(scene).is_empty()).count();
    let units = || taken.iter().filter_map(|taken| taken.unit.as_ref());
    let described = AtlasIndex { files: newest.index.files.clone(), ..index.clone() };
    if found.len() != shared || units().any(|unit| !unit.is_published) || described.content() != newest.index.content()
    {
        return false;
    }
    let of_units: usize = units().map(|unit| unit.files.len()).sum();
    let names: HashSet<&str> = index.specimens.iter().map(|entry| entry.name.as_str()).collect();
    let of_specimen = |file: &&FileRecord| file.path.split_once('/').is_some_and(|(name, _)| names.contains(name));
    let (specimens, others): (Vec<_>, Vec<_>) = newest.index.files.iter().partition(of_specimen);
    let is_wanted = |file: &FileRecord| match file.path.strip_prefix(FOLDER).and_then(|path| path.strip_prefix('/')) {
        Some(path) => {
            path == diffraction_brdf::atlas::RESULT_FILE || found.keys().any(|scene| is_of_scene(path, scene))
        }
        None => true,
    };
    let is_whole = |file: &FileRecord| record_file(&newest.folder, file.path.clone()).is_ok_and(|now| now == *file);
    specimens.len() == of_units && others.iter().all(|file| is_wanted(file) && is_whole(file))
}

/// Whether a file of the shared scenes' folder is this scene's.
fn is_of_scene(file: &str, scene: &str) -> bool {
    file.strip_prefix(scene).is_some_and(|ending| ending.starts_with('.'))
}

/// Links the folder of every specimen into the version to come, and gives its files.
fn link_specimens(taken: &[Taken], staging: &mut Staging) -> Result<Vec<FileRecord>> {
    let mut known = Vec::new();
    for taken in taken {
        if let Some(unit) = &taken.unit {
            let linked = files::link_tree(&unit.folder, &staging.path().join(&taken.result.name))?;
            known.extend(unit.files.iter().cloned());
            if linked && unit.is_published {
                staging.note_published(unit.files.iter());
            }
        }
    }
    Ok(known)
}

/// Links the pages of specimens that the newest version holds as they are: nothing on them changes. Others are written with the report.
fn link_pages(run: &Run, taken: &[Taken], staging: &mut Staging) -> Result<Vec<FileRecord>> {
    let Some(newest) = run.newest.as_ref().filter(|_| run.config.report.write && asked::is_of_many(run.config)) else {
        return Ok(Vec::new());
    };
    files::create_folder(&staging.path().join(PAGES_FOLDER))?;
    let mut known = Vec::new();
    for taken in taken.iter().filter(|taken| taken.unit.as_ref().is_some_and(|unit| unit.is_published)) {
        let name = &taken.result.name;
        let was_stale = newest.entry(name).is_none_or(|entry| entry.stale.is_some());
        let page = page_path(name);
        if let (Some(record), false) = (newest.file(&page), was_stale || taken.result.stale.is_some()) {
            let from = newest.folder.join(&page);
            if record_file(&newest.folder, page.clone()).is_ok_and(|now| now == *record) {
                if files::link(&from, &staging.path().join(&page))? {
                    staging.note_published([record].into_iter());
                }
                known.push(record.clone());
            }
        }
    }
    Ok(known)
}

/// The scenes that several specimens share: those that were found are linked, the others summed up.
fn shared_scenes(
    run: &mut Run,
    taken: &mut [Taken],
    found: FoundScenes,
    staging: &Staging,
) -> Result<Vec<SharedSceneResult>> {
    let mut sums = SharedScenes::new(&run.config.scenes, |name| found.contains_key(name));
    // In the manifest's order, whichever was done first: sums depend on theirs.
    taken.iter_mut().for_each(|taken| sums.add(std::mem::take(&mut taken.shares)));
    let made = sums.finish(staging.path(), &mut run.log)?;
    let mut records = Vec::new();
    for scene in run.config.scenes.iter().filter(|scene| !specimens_of(scene).is_empty()) {
        if let Some(record) = found.get(&scene.name) {
            link_scene(run, &scene.name, staging)?;
            records.push(record.clone());
        } else if let Some(result) = made.iter().find(|result| result.picture.name == scene.name) {
            let digest_of = |name: &String| {
                let unit = taken.iter().find(|taken| taken.result.name == *name)?.unit.as_ref()?;
                Some((name.clone(), json!(unit.made_from_sha256)))
            };
            let specimens: Option<serde_json::Map<_, _>> = specimens_of(scene).iter().map(digest_of).collect();
            let made_from = json!({ "scene": scene_value(scene), "specimens": specimens });
            records.push(SharedRecord { made_from, result: result.clone() });
        }
    }
    if !records.is_empty() {
        SharedRecord::write_all(&records, staging.path())?;
    }
    Ok(records.into_iter().map(|record| record.result).collect())
}

fn link_scene(run: &Run, scene: &str, staging: &Staging) -> Result<()> {
    let Some(newest) = &run.newest else { return Ok(()) };
    files::create_folder(&staging.path().join(FOLDER))?;
    for file in &newest.index.files {
        let name = file.path.strip_prefix(FOLDER).and_then(|path| path.strip_prefix('/'));
        if name.is_some_and(|name| is_of_scene(name, scene)) {
            files::link(&newest.folder.join(&file.path), &staging.path().join(&file.path))?;
        }
    }
    Ok(())
}

fn results(run: Run, taken: Vec<Taken>, besides: Besides, started: Instant) -> RunResults {
    let Run { config, helpers, log, gpu, cache, newest: _ } = run;
    let (mut specimens, mut stages, mut failures) = (Vec::new(), Vec::new(), Vec::new());
    let (mut compared, mut used) = (Compared::default(), CacheUse::default());
    for taken in taken {
        specimens.push(taken.result);
        stages.extend(taken.stages);
        failures.extend(taken.failures);
        compared.rows.extend(taken.gpu.rows);
        compared.spectral.extend(taken.gpu.spectral);
        used = used.with(&taken.used, cache.traffic());
    }
    stages.extend(log.stages);
    failures.extend(log.failures);
    RunResults {
        schema: RESULTS_SCHEMA,
        atlas_name: config.atlas_name.clone(),
        version: besides.version,
        program_version: env!("CARGO_PKG_VERSION").into(),
        started: helpers.started.into(),
        threads: rayon::current_num_threads(),
        cpu_count: std::thread::available_parallelism().map_or(1, usize::from),
        manifest_text: config.manifest_text.clone(),
        specimens,
        shared_scenes: besides.shared,
        stages,
        gpu: gpu.map_or(GpuResult::Off, |gpu| gpu.into_result(compared, besides.frames)),
        failures,
        left_out: asked::left_out(config),
        cache: cache.is_on().then_some(used),
        peak_memory_mib: memory::process_peak_bytes().map(|bytes| bytes as f64 / f64::from(1 << 20)),
        total_wall_s: started.elapsed().as_secs_f64(),
    }
}
