//! `plan`: what a run would compute, what it leaves out and why, and what it would take.

use std::path::PathBuf;

/// Arguments of `plan`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas plan snakes.toml --json")]
pub struct PlanArgs {
    /// What to plan for
    #[arg(default_value = super::MANIFEST)]
    pub manifest: PathBuf,
    /// Print the plan as JSON
    #[arg(long)]
    pub json: bool,
}
