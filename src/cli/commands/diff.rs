//! `diff`: what changed between two versions of an atlas.

use std::path::PathBuf;

use crate::cli::options::Global;
use crate::cli::output::{self, Outcome};
use crate::error::Result;
use crate::stages::archive::diff::diff;

/// Arguments of `diff`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Exit status: 0 both hold the same; 1 they differ; 2 the call is wrong.

Example:
  diffraction-atlas diff out/atlas/squamates/v0001 out/atlas/squamates/v0002")]
pub(crate) struct DiffArgs {
    /// The older version
    pub a: PathBuf,
    /// The newer version
    pub b: PathBuf,
    /// Print every key, file and table that differs, after the summary
    #[arg(long)]
    pub details: bool,
    /// Print as JSON, with all details
    #[arg(long, conflicts_with = "details")]
    pub json: bool,
}

/// Compares and prints.
///
/// # Errors
/// A folder that is no atlas.
pub(crate) fn run(args: &DiffArgs, _global: &Global) -> Result<Outcome> {
    let report = diff(&output::version_folder(&args.a)?, &output::version_folder(&args.b)?)?;
    if args.json {
        output::print_json(&report)?;
    } else {
        output::print(&report.to_text(args.details))?;
    }
    Ok(if report.is_same() { Outcome::Done } else { Outcome::Different })
}
