//! What a run tells while it goes on: how far it is, how long its stages took, what went wrong.

use super::results::{Failure, StageTime};
use super::stage::Stage;
use super::usage::Stopwatch;
use diffraction_build::ground::progress::Progress;

/// A listener for one of several specimens that are made at once: what is worth reading by itself is passed on, how far it is
/// says nothing.
pub(crate) struct Remarks<'a>(pub &'a dyn Progress);

impl Progress for Remarks<'_> {
    fn stage(&self, _name: &str, _total: u64) {}
    fn advance(&self, _n: u64) {}
    fn message(&self, text: &str) {
        self.0.message(text);
    }
    fn finish(&self) {}
}

/// Times and failures so far, in the order they came, and who hears of them.
pub(crate) struct Log<'a> {
    progress: &'a dyn Progress,
    /// Times, in the order the stages ended in.
    pub stages: Vec<StageTime>,
    /// Failures that did not stop the run.
    pub failures: Vec<Failure>,
}

impl<'a> Log<'a> {
    /// Nothing so far.
    pub fn new(progress: &'a dyn Progress) -> Self {
        Self { progress, stages: Vec::new(), failures: Vec::new() }
    }

    /// Who hears how far the run is.
    pub fn progress(&self) -> &'a dyn Progress {
        self.progress
    }

    /// Does a stage's work and times it, whether it fails or not; `steps` are equal ones, 0 where their number is not known.
    ///
    /// # Errors
    /// Those of the work.
    pub fn timed<T, E>(
        &mut self,
        stage: Stage,
        specimen: &str,
        steps: u64,
        work: impl FnOnce() -> Result<T, E>,
    ) -> Result<T, E> {
        self.progress.stage(&format!("{specimen}: {stage}"), steps);
        let stopwatch = Stopwatch::start();
        let outcome = work();
        self.progress.finish();
        self.stages.push(stopwatch.read(stage, Some(specimen)));
        outcome
    }

    /// A failure that does not stop the run; of no specimen where it concerns them all.
    pub fn fail(&mut self, stage: Stage, specimen: Option<&str>, message: String) {
        self.failures.push(Failure { specimen: specimen.map(Into::into), stage, message });
    }
}
