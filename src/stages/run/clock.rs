//! The stages of one specimen: timed, and named where they fail.

use crate::stages::log::Log;
use crate::stages::stage::Stage;
use diffraction_brdf::error::{Error, Result};

/// Where and why a specimen failed.
pub(super) struct Failed {
    pub(super) stage: Stage,
    pub(super) error: Error,
}

/// What a step of a specimen gives.
pub(super) type Step<T> = std::result::Result<T, Failed>;

/// Times the stages of one specimen.
pub(super) struct Clock<'a, 'b> {
    pub(super) specimen: &'a str,
    pub(super) log: &'a mut Log<'b>,
}

impl Clock<'_, '_> {
    /// Does a stage's work.
    pub(super) fn stage<T>(&mut self, stage: Stage, work: impl FnOnce() -> Result<T>) -> Step<T> {
        self.stage_of(stage, 0, work)
    }

    /// Does the work of a stage of so many equal steps.
    pub(super) fn stage_of<T>(&mut self, stage: Stage, steps: u64, work: impl FnOnce() -> Result<T>) -> Step<T> {
        self.log.timed(stage, self.specimen, steps, work).map_err(|error| Failed { stage, error })
    }
}
