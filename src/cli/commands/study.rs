//! `study`: error against run time and memory, and the stability suite; in builds with the feature of that name.

#[cfg(feature = "study")]
mod measure;

use std::path::PathBuf;

use crate::cli::Global;
use crate::cli::output::Outcome;
use diffraction_brdf::error::Result;

/// Arguments of `study`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas study snakes.toml --specimen elaphe_guttata --out out/study")]
pub struct StudyArgs {
    /// What to study
    #[arg(default_value = super::MANIFEST)]
    pub manifest: PathBuf,
    /// Only these specimens; may be given several times
    #[arg(long, value_name = "NAME")]
    pub specimen: Vec<String>,
    /// More directions and settings: minutes per specimen instead of seconds
    #[arg(long)]
    pub thorough: bool,
    /// Folder for tables, plots, and JSON
    #[arg(long, value_name = "DIR", default_value = "out/study")]
    pub out: PathBuf,
}

/// Studies, runs the stability suite, and writes.
///
/// # Errors
/// A wrong manifest, a specimen it does not hold, or the disk's.
#[cfg(feature = "study")]
pub fn run(args: &StudyArgs, global: &Global) -> Result<Outcome> {
    measure::run(args, global)
}

/// Says that this build has no study.
///
/// # Errors
/// Always.
#[cfg(not(feature = "study"))]
pub fn run(_args: &StudyArgs, _global: &Global) -> Result<Outcome> {
    Err(diffraction_brdf::error::Error::Call(
        "this build has no study: build the program with its default features, or with `--features study`".into(),
    ))
}
