//! `study`: error against run time and memory, and the stability suite; in builds with the feature of that name.

mod args;
#[cfg(feature = "study")]
mod measure;

pub(crate) use args::StudyArgs;

use crate::cli::options::Global;
use crate::cli::output::Outcome;
use crate::error::Result;

/// Studies, runs the stability suite, and writes.
///
/// # Errors
/// A wrong manifest, a specimen it does not hold, or the disk's.
#[cfg(feature = "study")]
pub(crate) fn run(args: &StudyArgs, global: &Global) -> Result<Outcome> {
    measure::run(args, global)
}

/// Says that this build has no study.
///
/// # Errors
/// Always.
#[cfg(not(feature = "study"))]
pub(crate) fn run(_args: &StudyArgs, _global: &Global) -> Result<Outcome> {
    Err(diffraction_brdf::Error::Call(
        "this build has no study: build the program with its default features, or with `--features study`".into(),
    )
    .into())
}
