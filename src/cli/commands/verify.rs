//! `verify`: whether an atlas is whole, and as accurate as it says.

use std::path::PathBuf;

/// Arguments of `verify`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas verify out/atlas/squamates --samples 200")]
pub struct VerifyArgs {
    /// An atlas, or one version of it
    pub atlas: PathBuf,
    /// Directions per specimen that are evaluated anew against the reference; 0 checks the files alone
    #[arg(long, value_name = "N", default_value_t = 64)]
    pub samples: usize,
    /// Chooses the directions
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Print as JSON
    #[arg(long)]
    pub json: bool,
}
