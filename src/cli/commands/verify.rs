//! `verify`: whether an atlas is whole, and as accurate as it says.

use std::path::{Path, PathBuf};

use serde::Serialize;

use crate::cli::Global;
use crate::cli::output::{self, Outcome};
use crate::manifest::convert::run_config;
use crate::manifest::{self, Manifest};
use crate::stages::error_directions::{Candidates, DRAWN, ErrorDirections};
use crate::stages::ingest::ingest;
use crate::stages::results::ErrorRow;
use crate::stages::serve;
use crate::stages::specimen::{self, SpecimenFile};
use crate::stages::verify::{self, VerifyReport};
use diffraction_brdf::atlas::{self, AtlasIndex};
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_brdf::files;
use diffraction_brdf::specimen::CheckValue;
use diffraction_build::ground::metrics;
use diffraction_build::ground::sampling::{self, Region};
use diffraction_build::height::read::Provenance;
use diffraction_build::optics::spectral;
use diffraction_build::tables::build;
use diffraction_build::tables::model::{TableSet, TablesConfig};
use diffraction_render::scene::model::Scene;
use diffraction_render::scene::samples::samples;

/// Arguments of `verify`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas verify out/atlas/squamates --samples 200")]
pub struct VerifyArgs {
    /// An atlas, or one version of it
    pub atlas: PathBuf,
    /// Lit directions per specimen, over the hemisphere and again around the mirror direction, that are evaluated
    /// anew against the reference, besides a quarter as many dark ones; 0 checks the files alone
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
    let folder = target(&args.atlas)?;
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

/// The version to check: the one named, or the newest of an atlas, complete or damaged. Other commands fall
/// back on an older version where the newest is damaged; here that would hide the damage.
fn target(path: &Path) -> Result<PathBuf> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    if !path.is_dir() || atlas::version_number(&name).is_some() {
        let found = atlas::resolve(path).map(|found| found.folder);
        return found.or_else(|error| if path.is_dir() { Ok(path.to_owned()) } else { Err(error) });
    }
    match atlas::version_numbers(path)?.last() {
        Some(&newest) => Ok(path.join(atlas::version_name(newest))),
        None => Ok(atlas::resolve(path)?.folder),
    }
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
    /// Scans that are not the ones the tables were made from: nothing is evaluated against them.
    other_scans: Vec<String>,
    /// Directions evaluated against the scans, by region; empty where that was not asked for.
    reference: Vec<ReferenceCheck>,
}

/// Relative errors of Y over directions of one region, beside those recorded when the atlas was made.
#[derive(Debug, Serialize)]
struct ReferenceCheck {
    region: String,
    /// Directions bright enough to have a relative error.
    directions: usize,
    p50: f64,
    p95: f64,
    recorded_directions: usize,
    recorded_p50: f64,
    recorded_p95: f64,
    passed: bool,
}

/// Stored check values have 17 digits: what they were computed from gives them back to rounding.
const CHECK_TOLERANCE: f64 = 1e-9;

/// Errors below this are rounding and not compared.
const ERROR_FLOOR: f64 = 1e-5;

/// Standard deviations by which more errors than expected may lie above a recorded quantile.
const SIGMAS: f64 = 4.0;

fn evaluate(args: &VerifyArgs, folder: &Path, report: &mut Report) -> Result<()> {
    let index = atlas::read_index(folder)?;
    let manifest = matching_manifest(args, &index, report)?;
    for entry in &index.specimens {
        let (file, set) = specimen::load(&folder.join(&entry.name))?;
        let mut check = SpecimenCheck {
            name: entry.name.clone(),
            check_values: file.check_values.len(),
            check_worst: metrics::quantiles(file.check_values.iter().map(|value| deviation(&set, value)).collect())
                .worst,
            other_scans: Vec::new(),
            reference: Vec::new(),
        };
        if let Some(manifest) = manifest.as_ref().filter(|_| args.samples > 0) {
            against_scans(args, manifest, &file, &set, &mut check)?;
        }
        report.specimens.push(check);
    }
    Ok(())
}

/// Largest deviation of a stored check value from the tables evaluated now, relative to its Y.
fn deviation(set: &TableSet, value: &CheckValue) -> f64 {
    let now = brdf_xyz(set, Interpolation::Bilinear, value.wi, value.wo);
    let scale = value.xyz[1].abs().max(f64::MIN_POSITIVE);
    // A NaN is the worst of all.
    metrics::quantiles((0..3).map(|c| (now[c] - value.xyz[c]).abs() / scale).collect()).worst
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
    check: &mut SpecimenCheck,
) -> Result<()> {
    let Some(config) = manifest.specimens.iter().find(|config| config.name == file.name) else {
        return Ok(());
    };
    let ingested = ingest(&config)?;
    let recorded: Vec<&str> = file
        .provenance
        .as_array()
        .map_or(Vec::new(), |scans| scans.iter().map(|scan| scan["sha256"].as_str().unwrap_or_default()).collect());
    let is_other = |(index, scan): &(usize, &Provenance)| recorded.get(*index) != Some(&scan.sha256.as_str());
    let others = ingested.provenance.iter().enumerate().filter(is_other);
    check.other_scans = others.map(|(_, scan)| scan.file_name.clone()).collect();
    if !check.other_scans.is_empty() {
        return Ok(());
    }
    let fields = ingested.fields;
    // Sums over every direction are not what is asked for here; transforms are.
    let roomy = TablesConfig { memory_mib: usize::MAX >> 20, ..manifest.tables.clone() };
    let mut plan = build::plan(&fields, &config.optics, &roomy)?;
    plan.spectra.memory_bytes = (manifest.tables.memory_mib as u64) << 20;
    let recorded: Vec<ErrorRow> = serde_json::from_value(file.errors.clone()).unwrap_or_default();
    let totals = |region: &str| recorded.iter().find(|row| row.what == "total" && row.region == region);
    let mut candidates = match set.served {
        None => hemisphere_candidates(args, set),
        Some(_) => scene_candidates(args, manifest, file, set)?,
    };
    candidates.retain(|candidates| totals(&candidates.name).is_some());
    // What tables that went wrong would call dark is no measure.
    for candidates in &mut candidates {
        candidates.floor_per_sr = totals(&candidates.name).map_or(0.0, |row| row.floor_per_sr);
    }
    let ErrorDirections { groups, pairs } = ErrorDirections::drawn(set, candidates, args.samples);
    let exact = spectral::brdf_xyz_batch(&fields, &config.optics, &plan.spectra, &pairs)?;
    let mut directions = pairs.iter().zip(&exact);
    for group in &groups {
        let errors = directions.by_ref().take(group.len()).filter_map(|(&(wi, wo), exact)| {
            let ours = brdf_xyz(set, Interpolation::Bilinear, wi, wo)[1];
            // A NaN is kept, so that it counts as an error.
            (exact[1] > group.floor_per_sr || exact[1].is_nan()).then(|| (ours - exact[1]).abs() / exact[1])
        });
        let errors = errors.collect();
        if let Some(recorded) = totals(&group.name) {
            check.reference.push(reference_check(&group.name, errors, recorded));
        }
    }
    Ok(())
}

/// Turns of candidates to choose from: indices stay small enough for their points to be evenly spread.
const TURNS: u64 = 1 << 16;

/// From the sequence that gave the recorded directions, further on.
fn hemisphere_candidates(args: &VerifyArgs, set: &TableSet) -> Vec<Candidates> {
    Candidates::of_regions(set, 1 + (args.seed % TURNS) as usize)
        .into_iter()
        .filter(|candidates| candidates.name != Region::Grazing.name())
        .collect()
}

/// Directions of the scenes that the tables were made for, others than the recorded ones.
fn scene_candidates(
    args: &VerifyArgs,
    manifest: &Manifest,
    file: &SpecimenFile,
    set: &TableSet,
) -> Result<Vec<Candidates>> {
    let config = run_config(manifest, "");
    let scenes = serve::served_scenes(&config, &file.name).unwrap_or_default();
    let of_scene = |scene: &Scene| {
        let samples = samples(scene)?;
        let count = samples.weight.len();
        let drawn = (0..DRAWN.min(count)).map(|index| {
            let at = (sampling::plane(index + (args.seed % 1_000_000) as usize)[0] * count as f64) as usize;
            (samples.wi[at].map(f64::from), samples.wo[at].map(f64::from))
        });
        Ok(Candidates::of_scene(set, &scene.name, drawn.collect()))
    };
    scenes.iter().map(of_scene).collect()
}

fn reference_check(region: &str, errors: Vec<f64>, recorded: &ErrorRow) -> ReferenceCheck {
    let plausible = |quantile: f64, limit: f64| {
        let limit = limit.max(ERROR_FLOOR);
        let above = errors.iter().filter(|&&error| error.is_nan() || error > limit).count();
        above as f64 <= most_above(errors.len(), recorded.directions, quantile)
    };
    let passed = plausible(0.5, recorded.p50) && plausible(0.95, recorded.p95);
    let quantiles = metrics::quantiles(errors);
    ReferenceCheck {
        region: region.to_owned(),
        directions: quantiles.count,
        p50: quantiles.p50,
        p95: quantiles.p95,
        recorded_directions: recorded.directions,
        recorded_p50: recorded.p50,
        recorded_p95: recorded.p95,
        passed,
    }
}

/// How many of `count` errors may lie above a quantile of `recorded` others of the same kind by chance.
///
/// If both come from one distribution, whatever it is, the number above the `r`-th smallest recorded one is
/// a sum over a beta-distributed share with mean `1 - q` and variance `q (1 - q) / (recorded + 2)`: its own
/// variance is `count q (1 - q) (count + recorded + 1) / (recorded + 2)`.
fn most_above(count: usize, recorded: usize, q: f64) -> f64 {
    let (n, m) = (count as f64, recorded as f64);
    n * (1.0 - q) + SIGMAS * (n * q * (1.0 - q) * (n + m + 1.0) / (m + 2.0)).sqrt()
}

impl Report {
    fn failures(&self) -> Vec<String> {
        let files = self.files.failures.iter().map(|failure| format!("{}: {}", failure.file, failure.what));
        let values = self
            .specimens
            .iter()
            .filter(|check| check.check_worst.is_nan() || check.check_worst > CHECK_TOLERANCE)
            .map(|check| {
                format!("{}: stored check values differ from the tables by {:.1e}", check.name, check.check_worst)
            });
        let scans = self.specimens.iter().flat_map(|check| {
            let changed = |scan| format!("{}: {scan} is not the file that the tables were made from", check.name);
            check.other_scans.iter().map(changed)
        });
        let references = self.specimens.iter().flat_map(|check| {
            check.reference.iter().filter(|reference| !reference.passed).map(|reference| {
                format!(
                    "{}: {}: errors against the scans with median {:.1e} and 95th percentile {:.1e}, recorded were \
                     {:.1e} and {:.1e}",
                    check.name,
                    reference.region,
                    reference.p50,
                    reference.p95,
                    reference.recorded_p50,
                    reference.recorded_p95
                )
            })
        });
        files.chain(values).chain(scans).chain(references).collect()
    }

    fn to_text(&self) -> String {
        let mut text = format!("{}: {} files checked\n", self.folder, self.files.files_checked);
        for check in &self.specimens {
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
        for remark in &self.remarks {
            text += &format!("{remark}\n");
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn recorded(directions: usize, p50: f64, p95: f64) -> ErrorRow {
        let (what, region) = ("total".into(), Region::Hemisphere.name().into());
        ErrorRow {
            what,
            region,
            directions,
            floor_per_sr: 0.0,
            lit_share: 1.0,
            dark_directions: 0,
            missed_directions: 0,
            relative_l2: 0.0,
            p50,
            p95,
            p99: p95,
            worst: p95,
        }
    }

    /// Errors spread over three decades, `scale` at the median.
    fn errors(count: usize, scale: f64) -> Vec<f64> {
        (0..count).map(|i| scale * 10f64.powf(3.0 * ((i as f64 + 0.5) / count as f64 - 0.5))).collect()
    }

    #[test]
    fn errors_as_recorded_pass_and_larger_ones_fail() {
        let row = recorded(128, 1e-3, 1e-3 * 10f64.powf(1.35));
        let passed = |errors| reference_check("whole hemisphere", errors, &row).passed;
        assert!(passed(errors(64, 1e-3)));
        assert!(passed(errors(64, 1e-4)));
        assert!(!passed(errors(64, 1e-2)));
        // A defect in one direction of four shows in the tail.
        let mut some = errors(64, 1e-3);
        some.iter_mut().step_by(4).for_each(|error| *error = 1.0);
        assert!(!passed(some));
        assert!(!passed(vec![f64::NAN; 64]));
        assert!(passed(Vec::new()));
    }

    #[test]
    fn few_recorded_directions_allow_for_chance() {
        // Five directions on either side, as a grating leaves lit, say little about a median.
        assert!(most_above(5, 5, 0.5) > 5.0);
        assert!(most_above(64, 128, 0.5) < 64.0);
        // The limit tends to the binomial's for a quantile known exactly.
        let binomial = 32.0 + SIGMAS * 4.0;
        assert!((most_above(64, usize::MAX >> 12, 0.5) - binomial).abs() < 1e-6);
    }
}
