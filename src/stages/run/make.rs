//! A specimen made: computed in a private folder, checked on the GPU, recorded, and handed to the store.

use std::path::Path;
use std::time::Instant;

use serde_json::Value;

use super::choose::found;
use super::clock::{Clock, Step};
use super::describe::Described;
use super::job::{Illustrate, Job};
use super::memory::Memory;
use super::specimen::run_specimen;
use super::taken::{Origin, Taken};
use crate::error::Result;
use crate::stages::archive::result_file::SpecimenRecord;
use crate::stages::archive::units;
use crate::stages::cache::store::Cache;
use crate::stages::config::{RunConfig, SpecimenConfig};
use crate::stages::gpu::device::GpuDevice;
use crate::stages::gpu::stage::{self as gpu_stage, Checked, Compared};
use crate::stages::log::Log;
use crate::stages::results::SpecimenResult;
use crate::stages::stage::Stage;
use diffraction_brdf::error::Error;
use diffraction_build::accuracy::rows;
use diffraction_build::ground::progress::Progress;

/// What making specimens takes, the same for all of them.
pub(super) struct Workshop<'a> {
    pub(super) config: &'a RunConfig,
    pub(super) illustrate: Illustrate<'a>,
    pub(super) cache: &'a Cache,
    pub(super) memory: &'a Memory,
    /// Folder in which specimens are made, each in one by its name.
    pub(super) folder: &'a Path,
    pub(super) progress: &'a dyn Progress,
}

/// A specimen that is computed, or failed to be.
pub(super) struct Computed<'a> {
    pub(super) done: Step<Described>,
    pub(super) log: Log<'a>,
    pub(super) seconds: f64,
}

impl<'a> Workshop<'a> {
    /// From scans to files; may go on for several specimens at once.
    pub(super) fn compute(&self, specimen: &SpecimenConfig) -> Computed<'a> {
        let started = Instant::now();
        let mut log = Log::new(self.progress);
        let mut done = self.attempt(specimen, &mut log);
        if done.as_ref().is_err_and(|failed| failed.error.is_of_full_disk())
            && let Some(bytes) = self.cache.give_way(&self.config.cache)
        {
            let (mib, folder) = (bytes >> 20, self.config.cache.folder.display());
            let name = &specimen.name;
            self.progress
                .message(&format!("the disk is full: {folder} has given way, {mib} MiB; {name} is made again"));
            done = self.attempt(specimen, &mut log);
        }
        Computed { done, log, seconds: started.elapsed().as_secs_f64() }
    }

    fn attempt(&self, specimen: &SpecimenConfig, log: &mut Log) -> Step<Described> {
        let job = Job {
            config: self.config,
            specimen,
            folder: self.folder.join(&specimen.name),
            cache: self.cache,
            illustrate: self.illustrate,
            memory: self.memory,
        };
        let done = run_specimen(&job, &mut Clock { specimen: &specimen.name, log });
        if done.is_err() {
            // What is left of it shall take no room; where it cannot be removed it goes with the folder above.
            let _ = std::fs::remove_dir_all(&job.folder);
        }
        done
    }

    /// What a specimen that was computed comes to: checked on the GPU, recorded, and in the store.
    ///
    /// # Errors
    /// The disk's.
    pub(super) fn finish(
        &self,
        specimen: &SpecimenConfig,
        made_from: Option<Value>,
        described: Described,
        mut log: Log,
        gpu: Option<&GpuDevice>,
    ) -> Result<Taken> {
        let Described { mut result, inputs, shares, used } = described;
        let mut compared = Compared::default();
        if let Some(device) = gpu {
            match gpu_stage::check(device, self.config, specimen, self.folder, &mut log)? {
                Checked::Rows(rows) => compared = rows,
                Checked::Beyond(why) => result.warnings.push(why),
            }
        }
        complain(&result, &mut log);
        let folder = self.folder.join(&specimen.name);
        let record = SpecimenRecord {
            schema: 0,
            made_from: made_from.clone().unwrap_or_default(),
            files: Vec::new(),
            inputs,
            result,
            failures: std::mem::take(&mut log.failures),
            gpu: compared.rows,
            gpu_spectral: compared.spectral,
        };
        let (record, files) = record.write(&folder)?;
        let taken = match made_from {
            None => Taken::made(record, folder, files),
            Some(made_from) => self.hand_over(Taken::made(record, folder, files), &made_from)?,
        };
        Ok(Taken { stages: log.stages, shares, used, ..taken })
    }

    /// To the store, where whoever was faster with the same comes first.
    fn hand_over(&self, mut taken: Taken, made_from: &Value) -> Result<Taken> {
        let name = &taken.result.name;
        let place = units::place(&self.config.atlas_root, name, made_from);
        let Some(unit) = &mut taken.unit else { return Ok(taken) };
        if units::keep(&unit.folder, &place, |place| found(place.to_owned(), name).is_some())? {
            unit.folder = place;
            return Ok(taken);
        }
        match found(place, name) {
            Some(found) => Ok(Taken { origin: Origin::Made, ..Taken::found(found) }),
            None => Err(Error::limit(
                format!("{name}: its finished files were changed or removed by somebody else"),
                "Leave the folder .units of the atlas alone, and run again.",
            )
            .into()),
        }
    }
}

/// Failures that keep nothing from being made: pixels without an answer, references that disagree.
fn complain(result: &SpecimenResult, log: &mut Log) {
    for scene in result.scenes.iter().filter(|scene| scene.uncovered_pixels > 0) {
        let (name, pixels) = (&scene.name, scene.uncovered_pixels);
        let message = format!("{name}: {pixels} pixels ask for directions that the tables do not cover");
        log.fail(Stage::RenderScenes, Some(&result.name), message);
    }
    if let Some(message) = rows::disagreement(&result.errors) {
        log.fail(Stage::MeasureErrors, Some(&result.name), message);
    }
}
