//! What `study` is told.

use std::path::PathBuf;

use crate::cli::options::MANIFEST;

/// Arguments of `study`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas study snakes.toml --specimen elaphe_guttata --out out/study")]
pub(crate) struct StudyArgs {
    /// What to study
    #[arg(default_value = MANIFEST)]
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
    /// Replace the files of an earlier study in that folder
    #[arg(long)]
    pub force: bool,
}
