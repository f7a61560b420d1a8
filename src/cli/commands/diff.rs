//! `diff`: what changed between two versions of an atlas.

use std::path::PathBuf;

use crate::cli::options::Global;
use crate::cli::output::{self, Outcome};
use crate::error::Result;
use crate::stages::archive::diff::diff;

/// Arguments of `diff`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas diff out/atlas/squamates/v0001 out/atlas/squamates/v0002")]
pub(crate) struct DiffArgs {
    /// The older version
    pub a: PathBuf,
    /// The newer version
    pub b: PathBuf,
    /// Print as JSON
    #[arg(long)]
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
        output::print(&report.to_text())?;
    }
    Ok(Outcome::Done)
}
