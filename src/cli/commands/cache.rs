//! `cache`: the intermediate results that runs keep.

use std::path::PathBuf;

use crate::cli::options::MANIFEST;
use crate::cli::output::{self, Outcome};
use crate::error::Result;
use crate::manifest;
use crate::stages::cache::store;

/// Arguments of `cache`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas cache pipeline.toml --clear")]
pub(crate) struct CacheArgs {
    /// Manifest whose runs keep them
    #[arg(default_value = MANIFEST)]
    pub manifest: PathBuf,
    /// Remove them all; the next run computes everything anew
    #[arg(long)]
    pub clear: bool,
}

/// Shows or clears the cache.
///
/// # Errors
/// A wrong manifest, or the disk's.
pub(crate) fn run(args: &CacheArgs) -> Result<Outcome> {
    let (manifest, _) = manifest::load(&args.manifest)?;
    let config = &manifest.cache;
    let folder = config.folder.display();
    let (entries, bytes) = if args.clear { store::clear(&config.folder)? } else { store::size(&config.folder)? };
    let mib = bytes as f64 / f64::from(1 << 20);
    output::print(&match args.clear {
        true => format!("{folder}: removed {entries} entries, {mib:.1} MiB\n"),
        false => format!("{folder}: {entries} entries, {mib:.1} of {} MiB\n", config.limit_mib),
    })?;
    Ok(Outcome::Done)
}
