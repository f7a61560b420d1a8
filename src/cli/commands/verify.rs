//! `verify`: whether an atlas is whole, and as accurate as it says.

use std::path::{Path, PathBuf};

use serde::Serialize;

use crate::cli::Global;
use crate::cli::output::{self, Outcome};
use crate::ground::error::{Error, Result};
use crate::ground::sampling::{self, Region};
use crate::ground::{files, metrics};
use crate::manifest::{self, Manifest, convert::specimen_config};
use crate::optics::spectral;
use crate::stages::atlas::{self, AtlasIndex};
use crate::stages::ingest::ingest;
use crate::stages::results::ErrorRow;
use crate::stages::specimen::{self, CheckValue, SpecimenFile};
use crate::stages::verify::{self, VerifyReport};
use crate::tables::build;
use crate::tables::evaluate::{Interpolation, brdf_xyz};
use crate::tables::model::TableSet;

/// Arguments of `verify`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas verify out/atlas/squamates --samples 200")]
pub struct VerifyArgs {
    /// An atlas, or one version of it
    pub atlas: PathBuf,
    /// Directions per specimen that are evaluated anew against the reference; 0 checks the files alone
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
pub fn run(args: &VerifyArgs, _global: &Global) -> Result<Outcome> {
    let folder = atlas::resolve(&args.atlas)?;
    let files = verify::verify_files(&folder)?;
    let mut report = Report { folder: folder.display().to_string(), files, specimens: Vec::new(), remarks: Vec::new() };
    // Damaged files would only be evaluated to nonsense.
    if report.files.failures.is_empty() {
        evaluate(args, &folder, &mut report)?;
    }
    if args.json {
        output::print_json(&report)?;
    } else {
        output::print(&report.to_text())?;
    }
    let failures = report.failures();
    Ok(if failures.is_empty() { Outcome::Done } else { Outcome::Failures(failures) })
}

/// Everything that was checked.
#[derive(Debug, Serialize)]
struct Report {
    folder: String,
    files: VerifyReport,
    specimens: Vec<SpecimenCheck>,
    remarks: Vec<String>,
}

/// One specimen's values.
#[derive(Debug, Serialize)]
struct SpecimenCheck {
    name: String,
    check_values: usize,
    /// Largest relative deviation of the stored check values from the tables evaluated now.
    check_worst: f64,
    /// Directions evaluated against the scans, and the median and 95th percentile of the relative error of Y.
    reference: Option<ReferenceCheck>,
}

#[derive(Debug, Serialize)]
struct ReferenceCheck {
    directions: usize,
    p50: f64,
    p95: f64,
    /// The median that was recorded when the atlas was made.
    recorded_p50: f64,
    passed: bool,
}

/// Stored check values have 17 digits: what they were computed from gives them back to rounding.
const CHECK_TOLERANCE: f64 = 1e-9;

/// The median over other directions than the recorded ones may be larger by this factor: medians of 64
/// and 128 samples of errors spread over a decade differ by less.
const MEDIAN_FACTOR: f64 = 3.0;

/// Errors below this are rounding and not compared.
const MEDIAN_FLOOR: f64 = 1e-5;

fn evaluate(args: &VerifyArgs, folder: &Path, report: &mut Report) -> Result<()> {
    let index = atlas::read_index(folder)?;
    let manifest = matching_manifest(args, &index, report)?;
    for entry in &index.specimens {
        let (file, set) = specimen::load(&folder.join(&entry.name))?;
        let reference = match &manifest {
            Some(manifest) if args.samples > 0 => against_scans(args, manifest, &file, &set)?,
            _ => None,
        };
        let deviation = |value: &CheckValue| {
            let now = brdf_xyz(&set, Interpolation::Bilinear, value.wi, value.wo);
            let scale = value.xyz[1].abs().max(f64::MIN_POSITIVE);
            (0..3).map(|c| (now[c] - value.xyz[c]).abs() / scale).fold(0.0, f64::max)
        };
        report.specimens.push(SpecimenCheck {
            name: entry.name.clone(),
            check_values: file.check_values.len(),
            check_worst: file.check_values.iter().map(deviation).fold(0.0, f64::max),
            reference,
        });
    }
    Ok(())
}

/// The manifest that names the scans: the one given, or `pipeline.toml` where it is the one the atlas was
/// made from. Without it, values are checked against the tables alone, and the report says so.
fn matching_manifest(args: &VerifyArgs, index: &AtlasIndex, report: &mut Report) -> Result<Option<Manifest>> {
    let path = args.manifest.as_deref().unwrap_or(Path::new(super::MANIFEST));
    let loaded = match manifest::load(path) {
        Err(error) if args.manifest.is_some() => return Err(error),
        loaded => loaded,
    };
    match loaded {
        Ok((manifest, text)) if files::sha256_hex(text.as_bytes()) == index.manifest_sha256 => Ok(Some(manifest)),
        Ok(_) if args.manifest.is_some() => Err(Error::Call(format!(
            "{}: this is not the manifest that the atlas was made from (its digest differs)",
            path.display()
        ))),
        _ => {
            report.remarks.push(
                "not evaluated against the scans: give the manifest the atlas was made from with `--manifest`".into(),
            );
            Ok(None)
        }
    }
}

fn against_scans(
    args: &VerifyArgs,
    manifest: &Manifest,
    file: &SpecimenFile,
    set: &TableSet,
) -> Result<Option<ReferenceCheck>> {
    let Some(section) = manifest.specimens.iter().find(|section| section.name == file.name) else { return Ok(None) };
    let config = specimen_config(section);
    let fields = ingest(&config)?.fields;
    let plan = build::plan(&fields, &config.optics, &manifest.tables)?;
    // The sequence that chose the recorded directions, further on.
    let skip = 1000 + args.seed as usize % 1_000_000;
    let pairs = sampling::direction_pairs(Region::Hemisphere, skip + args.samples).split_off(skip);
    let exact = spectral::brdf_xyz_batch(&fields, &config.optics, &plan.spectra, &pairs)?;
    let ours = pairs.iter().map(|&(wi, wo)| brdf_xyz(set, Interpolation::Bilinear, wi, wo)[1]);
    let exact: Vec<f64> = exact.iter().map(|xyz| xyz[1]).collect();
    let quantiles = metrics::relative_error_quantiles(&exact, &ours.collect::<Vec<_>>(), FLOOR_PER_SR);
    let recorded_p50 = recorded_median(file);
    Ok(Some(ReferenceCheck {
        directions: quantiles.count,
        p50: quantiles.p50,
        p95: quantiles.p95,
        recorded_p50,
        passed: quantiles.p50 <= (MEDIAN_FACTOR * recorded_p50).max(MEDIAN_FLOOR),
    }))
}

/// Luminance below which errors are relative to this, in 1/sr, as in the recorded rows.
const FLOOR_PER_SR: f64 = 1e-6;

fn recorded_median(file: &SpecimenFile) -> f64 {
    let rows: Vec<ErrorRow> = serde_json::from_value(file.errors.clone()).unwrap_or_default();
    let total = rows.iter().find(|row| row.what == "total" && row.region == Region::Hemisphere.name());
    total.map_or(0.0, |row| row.p50)
}

impl Report {
    fn failures(&self) -> Vec<String> {
        let files = self.files.failures.iter().map(|failure| format!("{}: {}", failure.file, failure.what));
        let values = self.specimens.iter().filter(|check| check.check_worst > CHECK_TOLERANCE).map(|check| {
            format!("{}: stored check values differ from the tables by {:.1e}", check.name, check.check_worst)
        });
        let references = self.specimens.iter().filter_map(|check| {
            let reference = check.reference.as_ref().filter(|reference| !reference.passed)?;
            Some(format!(
                "{}: median error {:.1e} against the scans, {:.1e} was recorded",
                check.name, reference.p50, reference.recorded_p50
            ))
        });
        files.chain(values).chain(references).collect()
    }

    fn to_text(&self) -> String {
        let mut text = format!("{}: {} files checked\n", self.folder, self.files.files_checked);
        for check in &self.specimens {
            text += &format!("{}: {} check values within {:.1e}", check.name, check.check_values, check.check_worst);
            if let Some(reference) = &check.reference {
                text += &format!(
                    "; {} directions against the scans: median error {:.1e} (recorded {:.1e}), 95 % below {:.1e}",
                    reference.directions, reference.p50, reference.recorded_p50, reference.p95
                );
            }
            text.push('\n');
        }
        for remark in &self.remarks {
            text += &format!("{remark}\n");
        }
        text
    }
}
