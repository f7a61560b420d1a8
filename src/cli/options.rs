//! What holds for every command.

/// The manifest where none is named.
pub(crate) const MANIFEST: &str = "pipeline.toml";

/// Above the options that every command has, at the end of its help.
const COMMON: &str = "Common options";

/// Options of every command.
#[derive(Debug, Clone, Copy, Default, clap::Args)]
pub(crate) struct Global {
    /// No progress and no remarks on stderr; errors still appear
    #[arg(long, global = true, help_heading = COMMON)]
    pub quiet: bool,
    /// Threads to use [default: one per core]; the results do not depend on it
    #[arg(long, global = true, help_heading = COMMON, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
}
