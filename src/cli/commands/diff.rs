//! `diff`: what changed between two versions of an atlas.

use std::path::PathBuf;

/// Arguments of `diff`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas diff out/atlas/squamates/v0001 out/atlas/squamates/v0002")]
pub struct DiffArgs {
    /// The older version
    pub a: PathBuf,
    /// The newer version
    pub b: PathBuf,
    /// Print as JSON
    #[arg(long)]
    pub json: bool,
}
