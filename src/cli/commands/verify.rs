//! `verify`: whether an atlas is whole, and as accurate as it says.

use std::path::{Path, PathBuf};

use crate::cli::options::{Global, MANIFEST};
use crate::cli::output::{self, Outcome};
use crate::error::Result;
use crate::manifest;
use crate::manifest::convert::{run_config, values_sha256};
use crate::stages::archive::verify::{MadeBy, Verified, verify};
use crate::stages::archive::verify_scans::Sampling;
use diffraction_brdf::atlas::{AtlasIndex, MANIFEST_FILE};
use diffraction_brdf::error::Error;
use diffraction_brdf::files;

/// Arguments of `verify`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(
    after_help = "Checked are: digests and readability of every file, `latest` and what lies beside the versions, stored check
values against the tables, and, where the scans are found, errors at the recorded directions, which must be those that
are recorded, and at fresh ones. An intact atlas fails in fewer than one call in 10,000, whatever the seed; a change of the
tables' values by 1 % is seen at the recorded directions.

Example:
  diffraction-atlas verify out/atlas/squamates --samples 200"
)]
pub(crate) struct VerifyArgs {
    /// An atlas, or one version of it
    pub atlas: PathBuf,
    /// Fresh directions above the luminance floor per specimen, over the hemisphere and again around the mirror direction, that are
    /// evaluated against the reference, besides a quarter as many below it; 0 checks the files alone
    #[arg(long, value_name = "N", default_value_t = 64)]
    pub samples: usize,
    /// Where paths in the version's own manifest start: the folder of this file [default: the current folder]. Versions without a
    /// manifest need the very file that they were made from
    #[arg(long, value_name = "FILE")]
    pub manifest: Option<PathBuf>,
    /// Chooses the fresh directions
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
    let verified = verify(&args.atlas, sampling, |folder, index| made_by(folder, index, args.manifest.as_deref()))?;
    if args.json {
        output::print_json(&verified)?;
    } else {
        output::print(&to_text(&verified))?;
    }
    let failures = verified.failures();
    Ok(if failures.is_empty() { Outcome::Done } else { Outcome::Failures(failures) })
}

/// The run that made a version, by the manifest that lies in it; paths start where those of the file do that is named, or that
/// would be. Where its scans are not found values are checked against the tables alone, and a remark says so.
fn made_by(folder: &Path, index: &AtlasIndex, given: Option<&Path>) -> Result<MadeBy> {
    let own = folder.join(MANIFEST_FILE);
    if !own.is_file() {
        return matching_manifest(given, &index.manifest_sha256);
    }
    let text = files::read_text(&own)?;
    let place = given.unwrap_or(Path::new(MANIFEST));
    match manifest::parse(&text, &place.with_file_name(MANIFEST_FILE).display().to_string()) {
        Ok(manifest) => Ok(Ok(run_config(manifest, text))),
        Err(error) if given.is_some() => Err(error),
        Err(error) => Ok(Err(format!(
            "not evaluated against the scans: {}; name the manifest with `--manifest`: paths in the version's own start at its folder",
            error.to_string().lines().next().unwrap_or_default()
        ))),
    }
}

/// For versions that hold no manifest: the one given, or `pipeline.toml` where it is the one the atlas was made from.
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
        for recorded in check.recorded.iter().filter(|recorded| recorded.passed) {
            text += &format!(
                "  {:<16} {:>4} recorded directions against the scans: errors as recorded\n",
                recorded.region, recorded.directions
            );
        }
        for reference in &check.reference {
            text += &format!(
                "  {:<16} {:>4} fresh directions against the scans: median error {:.1e} (recorded {:.1e}), \
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
