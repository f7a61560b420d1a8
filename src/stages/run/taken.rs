//! A specimen with all that a version takes over of it, wherever it comes from: found, made, kept from before, or failed.

use std::path::PathBuf;

use serde::Serialize;

use super::choose::{Found, digest};
use super::describe::failed_result;
use crate::stages::archive::result_file::SpecimenRecord;
use crate::stages::cache::store::CacheUse;
use crate::stages::config::SpecimenConfig;
use crate::stages::gpu::stage::Compared;
use crate::stages::pictures::shared_scenes::Share;
use crate::stages::results::{Failure, SpecimenResult, StageTime};
use diffraction_brdf::atlas::{FileRecord, InputRecord};

/// How a specimen came into a run's outcome.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Origin {
    /// It was there: nothing that it is made from has changed.
    Unchanged,
    /// It was made.
    Made,
    /// Making it failed, and what the newest version held of it stays.
    Kept,
    /// Making it failed, and there was nothing to keep.
    Failed,
}

/// A specimen that has just been made, or failed to be.
#[derive(Debug, Clone, Copy)]
pub struct Finished<'a> {
    /// Its place among all specimens of the run, from 1, and their number.
    pub place: [usize; 2],
    /// What came of it.
    pub origin: Origin,
    /// What was found out, of an older version where that is kept.
    pub result: &'a SpecimenResult,
    /// What went wrong.
    pub failures: &'a [Failure],
    /// What the cache knew.
    pub used: CacheUse,
    /// Elapsed seconds.
    pub seconds: f64,
}

impl<'a> Finished<'a> {
    pub(super) fn of(taken: &'a Taken, place: [usize; 2], seconds: f64) -> Self {
        let Taken { origin, result, failures, used, .. } = taken;
        Self { place, origin: *origin, result, failures, used: *used, seconds }
    }
}

/// The files of a specimen, and what they were made from.
pub(super) struct Unit {
    pub(super) folder: PathBuf,
    /// As a version's index lists them.
    pub(super) files: Vec<FileRecord>,
    pub(super) inputs: Vec<InputRecord>,
    /// Digest of what they were made from.
    pub(super) made_from_sha256: String,
    /// Whether the newest version holds them.
    pub(super) is_published: bool,
}

/// A specimen of the version to come.
pub(super) struct Taken {
    pub(super) origin: Origin,
    pub(super) result: SpecimenResult,
    /// What went wrong, with what is known of it.
    pub(super) failures: Vec<Failure>,
    pub(super) stages: Vec<StageTime>,
    pub(super) gpu: Compared,
    /// Its files; `None` where there are none.
    pub(super) unit: Option<Unit>,
    /// Its shares of scenes that show several specimens.
    pub(super) shares: Vec<Share>,
    pub(super) used: CacheUse,
}

impl Taken {
    /// One that is there.
    pub(super) fn found(found: Found) -> Self {
        let Found { folder, record, files, is_published } = found;
        Self::of_record(record, folder, files, is_published, Origin::Unchanged)
    }

    /// As it is kept while others are made.
    pub(super) fn kept(self, is_one_of_many: bool) -> Self {
        if is_one_of_many { Self { result: self.result.in_short(), ..self } } else { self }
    }

    /// One of the folder in which it has just been finished.
    pub(super) fn made(record: SpecimenRecord, folder: PathBuf, files: Vec<FileRecord>) -> Self {
        Self::of_record(record, folder, files, false, Origin::Made)
    }

    fn of_record(
        record: SpecimenRecord,
        folder: PathBuf,
        files: Vec<FileRecord>,
        is_published: bool,
        origin: Origin,
    ) -> Self {
        let SpecimenRecord { schema: _, made_from, files: _, inputs, result, failures, gpu, gpu_spectral } = record;
        Self {
            origin,
            result,
            failures,
            stages: Vec::new(),
            gpu: Compared { rows: gpu, spectral: gpu_spectral },
            unit: Some(Unit { folder, files, inputs, made_from_sha256: digest(&made_from), is_published }),
            shares: Vec::new(),
            used: CacheUse::default(),
        }
    }

    /// One that failed: what there was of it, marked as stale, or nothing.
    pub(super) fn failed(specimen: &SpecimenConfig, failure: Failure, kept: Option<Found>) -> Self {
        let Some(kept) = kept else {
            return Self {
                origin: Origin::Failed,
                result: failed_result(specimen, &failure.message),
                failures: vec![failure],
                stages: Vec::new(),
                gpu: Compared::default(),
                unit: None,
                shares: Vec::new(),
                used: CacheUse::default(),
            };
        };
        let mut taken = Self { origin: Origin::Kept, ..Self::found(kept) };
        taken.result.stale = Some(failure.message.clone());
        taken.failures = vec![failure];
        taken
    }
}
