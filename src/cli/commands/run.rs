//! `run`: the pipeline from a manifest to a published atlas.

use std::path::PathBuf;

/// Arguments of `run`; those of the program called without a command are the defaults.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas run snakes.toml")]
pub struct RunArgs {
    /// What to compute
    #[arg(default_value = super::MANIFEST)]
    pub manifest: PathBuf,
}

impl Default for RunArgs {
    fn default() -> Self {
        Self { manifest: super::MANIFEST.into() }
    }
}
