//! The pipeline: what is there already is found, the rest is made side by side, and all of it becomes a version.
//!
//! A specimen that fails is recorded and the others go on. Nothing is visible in the atlas before the one rename at the
//! end; specimens that are finished stay in the store till then, so that an interrupted run goes on where it was.

use std::path::Path;
use std::time::Instant;

use serde_json::Value;

use super::account::program_bytes;
use super::choose::{Choice, Found, choose};
use super::clock::Failed;
pub use super::job::Heights;
use super::make::{Computed, Workshop};
use super::memory::Memory;
use super::side_by_side::side_by_side;
use super::taken::Taken;
pub use super::taken::{Finished, Origin};
pub use super::underway::Helpers;
use super::underway::Run;
use super::version;
use crate::error::{Error, Result};
use crate::stages::archive::publish::{self, Published};
use crate::stages::archive::units;
use crate::stages::config::{OnFailure, RunConfig, SpecimenConfig};
use crate::stages::coverage::asked;
use crate::stages::log::Remarks;
use crate::stages::pictures::sharing::specimens_of;
use crate::stages::results::{Failure, RunResults};
use crate::stages::stage::Stage;
use crate::stages::usage;

/// How a run ended.
#[derive(Debug)]
pub struct RunOutcome {
    /// Everything found out.
    pub results: RunResults,
    /// How each specimen came into it, in the order of the results.
    pub origins: Vec<Origin>,
    /// What was published; `None` where every specimen failed.
    pub published: Option<Published>,
}

/// Runs the whole pipeline.
///
/// # Errors
/// Only what concerns the whole run: the disk, the lock. A specimen's failure is part of the outcome, unless the run shall end
/// with it.
pub fn run(config: &RunConfig, helpers: &Helpers) -> Result<RunOutcome> {
    publish_all(config, helpers, |_| true)
}

/// Publishes what is in the store and the newest version, and makes nothing but what cannot be made apart: specimens that share
/// a picture. Others that are not there have failed, on another machine or by not having been tried.
///
/// # Errors
/// As [`run`].
pub fn merge(config: &RunConfig, helpers: &Helpers) -> Result<RunOutcome> {
    publish_all(config, helpers, |name| shares_a_scene(config, name))
}

fn publish_all(config: &RunConfig, helpers: &Helpers, may_make: impl Fn(&str) -> bool) -> Result<RunOutcome> {
    let started = Instant::now();
    let staging = publish::begin(&config.atlas_root)?;
    let mut run = Run::begin(config, helpers)?;
    let specimens: Vec<&SpecimenConfig> = asked::specimens(config).collect();
    let (choices, scenes) = choose(config, &specimens, run.newest.as_ref());
    if let Some(lock) = &config.frozen {
        let names = specimens.iter().map(|specimen| specimen.name.as_str());
        lock.check_specimens(&config.atlas_name, names.zip(choices.iter().map(Choice::made_from)))?;
    }
    let taken = run.take(&specimens, choices, &staging.work(), &may_make)?;
    let origins: Vec<Origin> = taken.iter().map(|taken| taken.origin).collect();
    let (results, published) = version::publish(run, taken, scenes, started, staging)?;
    // What others may still be making stays.
    let is_done = |name: &str, origin: &Origin| may_make(name) || matches!(origin, Origin::Made | Origin::Unchanged);
    let names = specimens.iter().map(|specimen| specimen.name.as_str()).zip(&origins);
    units::forget(&config.atlas_root, names.filter(|(name, origin)| is_done(name, origin)).map(|(name, _)| name));
    Ok(RunOutcome { results, origins, published })
}

/// How making specimens for the store ended.
#[derive(Debug)]
pub struct UnitsOutcome {
    /// How each of them came.
    pub origins: Vec<Origin>,
    /// What went wrong.
    pub failures: Vec<Failure>,
}

/// Makes those specimens that are `wanted` for the store of the atlas, without a lock: several may do so at once, on several
/// machines. What is there already is left alone, and so are specimens that share a picture, which [`merge`] makes.
///
/// # Errors
/// As [`run`].
pub fn make_units(config: &RunConfig, helpers: &Helpers, wanted: impl Fn(&str) -> bool) -> Result<UnitsOutcome> {
    let work = units::begin(&config.atlas_root)?;
    let mut run = Run::begin(config, helpers)?;
    let is_wanted = |specimen: &&SpecimenConfig| wanted(&specimen.name) && !shares_a_scene(config, &specimen.name);
    let specimens: Vec<&SpecimenConfig> = asked::specimens(config).filter(is_wanted).collect();
    let (choices, _) = choose(config, &specimens, run.newest.as_ref());
    // What the newest version holds is not kept here, but by whoever merges.
    run.newest = None;
    let taken = run.take(&specimens, choices, work.path(), &|_| true)?;
    Ok(UnitsOutcome {
        origins: taken.iter().map(|taken| taken.origin).collect(),
        failures: taken.into_iter().flat_map(|taken| taken.failures).collect(),
    })
}

fn shares_a_scene(config: &RunConfig, name: &str) -> bool {
    config.scenes.iter().any(|scene| specimens_of(scene).iter().any(|member| member == name))
}

impl Run<'_> {
    /// All specimens in their order: those that are there, those that are made now, and those that neither are nor `may_make`.
    fn take(
        &mut self,
        specimens: &[&SpecimenConfig],
        choices: Vec<Choice>,
        work_folder: &Path,
        may_make: &dyn Fn(&str) -> bool,
    ) -> Result<Vec<Taken>> {
        let mut taken: Vec<Option<Taken>> = Vec::new();
        let mut to_make = Vec::new();
        for (index, choice) in choices.into_iter().enumerate() {
            let name = &specimens[index].name;
            taken.push(match choice {
                Choice::Found(found) => Some(Taken::found(*found)),
                Choice::Make { made_from, .. } if may_make(name) => {
                    to_make.push((index, made_from));
                    None
                }
                Choice::Make { made_from, .. } => Some(self.absent(specimens[index], made_from)),
            });
        }
        if !to_make.is_empty() {
            self.open_gpu()?;
            self.make(specimens, to_make, work_folder, &mut taken)?;
        }
        Ok(taken.into_iter().flatten().collect())
    }

    /// One that should have been made elsewhere and is not there: why, as far as that was left with the store.
    fn absent(&self, specimen: &SpecimenConfig, made_from: Option<Value>) -> Taken {
        let told = made_from
            .and_then(|made_from| units::failure(&units::place(&self.config.atlas_root, &specimen.name, &made_from)));
        let untold = || Failure {
            specimen: Some(specimen.name.clone()),
            stage: Stage::TakeFinished,
            message: format!("it has not been made yet: `run --only {}` makes it", specimen.name),
        };
        Taken::failed(specimen, told.unwrap_or_else(untold), self.kept(specimen)).kept(asked::is_of_many(self.config))
    }

    /// What the newest version holds of a specimen that failed, where that shall stay.
    fn kept(&self, specimen: &SpecimenConfig) -> Option<Found> {
        match (self.config.on_failure, &self.newest) {
            (OnFailure::Keep, Some(newest)) => newest.specimen(&specimen.name),
            _ => None,
        }
    }

    /// Makes specimens side by side, each into its place among those taken.
    fn make(
        &self,
        specimens: &[&SpecimenConfig],
        to_make: Vec<(usize, Option<Value>)>,
        work_folder: &Path,
        taken: &mut [Option<Taken>],
    ) -> Result<()> {
        let at_once = specimens_at_once(to_make.len());
        usage::share_processor(at_once > 1);
        let remarks = Remarks(self.helpers.progress);
        let workshop = Workshop {
            config: self.config,
            illustrate: self.helpers.illustrate,
            cache: &self.cache,
            memory: &Memory::of_run(self.config, program_bytes(self.config)),
            folder: work_folder,
            progress: if at_once > 1 { &remarks } else { self.helpers.progress },
        };
        if at_once > 1 {
            self.helpers.progress.stage("specimens", to_make.len() as u64);
        }
        let is_of_many = asked::is_of_many(self.config);
        let (places, mut made_from): (Vec<usize>, Vec<Option<Value>>) = to_make.into_iter().unzip();
        let work = |piece: usize| workshop.compute(specimens[places[piece]]);
        side_by_side(places.len(), at_once, work, |piece, computed| {
            let (index, seconds) = (places[piece], computed.seconds);
            let one = self.finish(&workshop, specimens[index], made_from[piece].take(), computed)?;
            (self.helpers.finished)(&Finished::of(&one, [index + 1, specimens.len()], seconds));
            if at_once > 1 {
                self.helpers.progress.advance(1);
            }
            taken[index] = Some(one.kept(is_of_many));
            Ok::<(), Error>(())
        })?;
        self.helpers.progress.finish();
        Ok(())
    }

    /// What a specimen leaves that was computed, or failed to be; an error where that is the whole run's.
    fn finish(
        &self,
        workshop: &Workshop,
        specimen: &SpecimenConfig,
        made_from: Option<Value>,
        computed: Computed,
    ) -> Result<Taken> {
        let Computed { done, log, .. } = computed;
        let failed = match done {
            Ok(described) => return workshop.finish(specimen, made_from, described, log, self.device()),
            Err(failed) => failed,
        };
        // A full disk is no specimen's fault, and would leave out the next ones too.
        if self.config.on_failure == OnFailure::Stop || failed.error.is_of_disk_below(&self.config.atlas_root) {
            return Err(failed.error.into());
        }
        let Failed { stage, error } = failed;
        let failure = Failure { specimen: Some(specimen.name.clone()), stage, message: error.to_string() };
        if let Some(made_from) = made_from {
            units::keep_failure(&units::place(&self.config.atlas_root, &specimen.name, &made_from), &failure)?;
        }
        Ok(Taken { stages: log.stages, ..Taken::failed(specimen, failure, self.kept(specimen)) })
    }
}

/// How many specimens are made at once: as many as there are threads, or one where memory is counted, which knows of one alone.
fn specimens_at_once(to_make: usize) -> usize {
    if usage::is_heap_counted() { 1 } else { rayon::current_num_threads().min(to_make) }
}
