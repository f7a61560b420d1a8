//! `prune`: old versions of an atlas removed.

use std::path::{Path, PathBuf};

use crate::cli::output::{self, Outcome};
use crate::error::Result;
use crate::stages::archive::lock::Lock;
use crate::stages::archive::prune::prune;
use diffraction_brdf::atlas;
use diffraction_brdf::error::Error;

/// Arguments of `prune`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas prune out/atlas/squamates --keep 30 --dry-run")]
pub(crate) struct PruneArgs {
    /// The atlas
    pub atlas: PathBuf,
    /// How many versions stay, the newest; the one that `latest` names always does
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub keep: u32,
    /// Keep the version that a lock names, too; may be given several times
    #[arg(long, value_name = "FILE")]
    pub lock: Vec<PathBuf>,
    /// Say what would go, and remove nothing
    #[arg(long)]
    pub dry_run: bool,
}

/// Removes, and says what.
///
/// # Errors
/// A folder that is no atlas, a run that is publishing into it, or the disk's.
pub(crate) fn run(args: &PruneArgs) -> Result<Outcome> {
    if !args.atlas.is_dir() || atlas::version_numbers(&args.atlas)?.is_empty() {
        return Err(Error::Call(format!("{}: this is no atlas: it holds no version", args.atlas.display())).into());
    }
    let locked =
        args.lock.iter().map(|path| locked(path, &args.atlas)).collect::<diffraction_brdf::Result<Vec<_>>>()?;
    let gone = prune(&args.atlas, args.keep as usize, &locked, args.dry_run)?;
    let verb = if args.dry_run { "would remove" } else { "removed" };
    output::print(&match gone.is_empty() {
        true => "nothing to remove\n".to_owned(),
        false => format!("{verb} {}\n", gone.join(", ")),
    })?;
    Ok(Outcome::Done)
}

/// The version of this atlas that a lock names.
fn locked(path: &Path, atlas: &Path) -> diffraction_brdf::Result<String> {
    let lock = Lock::read(path)?;
    let [of, version] = lock.names();
    let absolute = std::path::absolute(atlas).unwrap_or_else(|_| atlas.to_owned());
    if absolute.file_name().is_some_and(|name| name == of) {
        return Ok(version.to_owned());
    }
    Err(Error::Call(format!("{} locks the atlas {of:?}, not {}", path.display(), atlas.display())))
}
