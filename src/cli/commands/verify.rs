//! `verify`: whether an atlas is whole, and as accurate as it says.

use std::path::{Path, PathBuf};

use crate::cli::options::{Global, MANIFEST};
use crate::cli::output::{self, Outcome};
use crate::error::Result;
use crate::manifest;
use crate::manifest::convert::{run_config, values_sha256};
use crate::stages::archive::verify::{MadeBy, Verified, target, verify};
use crate::stages::archive::verify_scans::Sampling;
use diffraction_brdf::error::Error;

/// Arguments of `verify`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas verify out/atlas/squamates --samples 200")]
pub(crate) struct VerifyArgs {
    /// An atlas, or one version of it
    pub atlas: PathBuf,
    /// Directions above the luminance floor per specimen, over the hemisphere and again around the mirror direction, that are evaluated
    /// anew against the reference, besides a quarter as many below it; 0 checks the files alone
    #[arg(long, value_name = "N", default_value_t = 64)]
    pub samples: usize,
    /// The manifest the atlas was made from, which names the scans [default: pipeline.toml where it is]
    #[arg(long, value_name = "FILE")]
    pub manifest: Option<PathBuf>,
    /// Chooses the directions
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Print as JSON
    #[arg(long)]
    pub json: bool,
}

/// Checks and prints.
///
/// # Errors
/// A folder that is no atlas, or scans that cannot be read any more.
pub(crate) fn run(args: &VerifyArgs, _global: &Global) -> Result<Outcome> {
    let sampling = Sampling { count: args.samples, seed: args.seed };
    let verified =
        verify(&target(&args.atlas)?, sampling, |digest| matching_manifest(args.manifest.as_deref(), digest))?;
    if args.json {
        output::print_json(&verified)?;
    } else {
        output::print(&to_text(&verified))?;
    }
    let failures = verified.failures();
    Ok(if failures.is_empty() { Outcome::Done } else { Outcome::Failures(failures) })
}

/// The manifest that names the scans: the one given, or `pipeline.toml` where it is the one the atlas was
/// made from. Without it, values are checked against the tables alone, and a remark says so.
fn matching_manifest(given: Option<&Path>, digest: &str) -> Result<MadeBy> {
    let path = given.unwrap_or(Path::new(MANIFEST));
    match manifest::load(path) {
        Err(error) if given.is_some() => Err(error),
        Ok((manifest, text)) if values_sha256(&text) == digest => Ok(Ok(run_config(manifest, text))),
        Ok(_) if given.is_some() => Err(Error::Call(format!(
            "{}: this is not the manifest that the atlas was made from (its digest differs)",
            path.display()
        ))
        .into()),
        _ => Ok(Err(
            "not evaluated against the scans: give the manifest the atlas was made from with `--manifest`".into()
        )),
    }
}

fn to_text(verified: &Verified) -> String {
    let mut text = format!("{}: {} files checked\n", verified.folder, verified.files.files_checked);
    for check in &verified.specimens {
        text += &format!("{}: {} check values within {:.1e}\n", check.name, check.check_values, check.check_worst);
        for reference in &check.reference {
            text += &format!(
                "  {:<16} {:>4} directions against the scans: median error {:.1e} (recorded {:.1e}), \
                 95 % below {:.1e} (recorded {:.1e})\n",
                reference.region,
                reference.directions,
                reference.p50,
                reference.recorded_p50,
                reference.p95,
                reference.recorded_p95
            );
        }
    }
    for remark in &verified.remarks {
        text += &format!("{remark}\n");
    }
    text
}
