//! Whether a version is whole, and as accurate as it says.

use std::path::{Path, PathBuf};

use serde::Serialize;

use super::specimen_file;
use super::verify_chance::FALSE_ALARMS_MAX;
use super::verify_files::{Failure, VerifyReport, verify_files};
use super::verify_root::verify_root;
use super::verify_scans::{AgainstScans, Checking, RecordedCheck, ReferenceCheck, Sampling, against_scans};
use crate::error::Result;
use crate::stages::config::RunConfig;
use diffraction_brdf::atlas::{self, AtlasIndex};
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_brdf::specimen::CheckValue;
use diffraction_brdf::spectral_storage::{SpectralCheckValue, read_spectral};
use diffraction_brdf::{SpectralTables, Xyz};
use diffraction_build::ground::metrics;
use diffraction_build::tables::model::TableSet;

/// Everything that was checked.
#[derive(Debug, Serialize)]
pub(crate) struct Verified {
    /// The version's folder.
    pub(crate) folder: String,
    /// What is wrong beside its versions, where the whole atlas is checked.
    pub(crate) atlas: Vec<Failure>,
    /// Its files.
    pub(crate) files: VerifyReport,
    /// Its specimens; none where files are damaged.
    pub(crate) specimens: Vec<SpecimenCheck>,
    /// What was not checked.
    pub(crate) remarks: Vec<String>,
}

/// One specimen's values.
#[derive(Debug, Serialize)]
pub(crate) struct SpecimenCheck {
    /// The specimen.
    pub(crate) name: String,
    /// Number of stored check values.
    pub(crate) check_values: usize,
    /// Their largest relative deviation from the tables evaluated now.
    pub(crate) check_worst: f64,
    /// Scans that are not the ones the tables were made from: nothing is evaluated against them.
    pub(crate) other_scans: Vec<String>,
    /// The recorded directions evaluated anew, by group; empty where that was not asked for, or where they cannot be found again.
    pub(crate) recorded: Vec<RecordedCheck>,
    /// Fresh directions evaluated against the scans, by group; empty where that was not asked for.
    pub(crate) reference: Vec<ReferenceCheck>,
}

/// Stored check values have 17 digits: what they were computed from gives them back to rounding.
const CHECK_TOLERANCE: f64 = 1e-9;

/// The run a version was made by, which names the scans; or why it is not known, as a remark.
pub(crate) type MadeBy = std::result::Result<RunConfig, String>;

/// Checks a version's files, its check values and, where the scans are known, its errors: at the recorded directions, and at a
/// sample of fresh ones. `made_by` finds the run that made a version. Where an atlas is named, what lies beside its versions is
/// checked too.
///
/// # Errors
/// A folder that is no atlas, or scans that cannot be read any more.
pub(crate) fn verify(
    path: &Path,
    sampling: Sampling,
    made_by: impl FnOnce(&Path, &AtlasIndex) -> Result<MadeBy>,
) -> Result<Verified> {
    let folder = target(path)?;
    let atlas = if folder == path { Vec::new() } else { verify_root(path)? };
    let files = verify_files(&folder)?;
    let (mut specimens, mut remarks) = (Vec::new(), Vec::new());
    // Damaged files would only be evaluated to nonsense.
    if files.failures.is_empty() {
        let index = atlas::read_index(&folder)?;
        let run =
            if sampling.count > 0 { made_by(&folder, &index)? } else { Err("not evaluated against the scans".into()) };
        let same_program = index.program_version == env!("CARGO_PKG_VERSION");
        let alpha = FALSE_ALARMS_MAX / index.specimens.len().max(1) as f64;
        let checking = Checking { sampling, alpha, same_program };
        for entry in &index.specimens {
            let specimen_folder = atlas::specimen_folder(&folder, &index, &entry.name)?;
            // What was kept from an older version was made from what that one's manifest and scans were.
            let own_run = run.as_ref().ok().filter(|_| entry.stale.is_none());
            if entry.stale.is_some() && run.is_ok() {
                remarks
                    .push(format!("{}: kept from an older version, and not evaluated against the scans", entry.name));
            }
            specimens.push(check_specimen(&specimen_folder, own_run, checking)?);
        }
        if run.is_ok() && !same_program {
            remarks.push(format!(
                "made by version {} of the program, whose directions this one may not find again: checked at fresh ones alone",
                index.program_version
            ));
        }
        remarks.extend(run.err());
    }
    Ok(Verified { folder: folder.display().to_string(), atlas, files, specimens, remarks })
}

/// The version to check: the one named, or the newest of an atlas, complete or damaged. Other commands fall
/// back on an older version where the newest is damaged; here that would hide the damage.
fn target(path: &Path) -> diffraction_brdf::Result<PathBuf> {
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

fn check_specimen(folder: &Path, run: Option<&RunConfig>, checking: Checking) -> Result<SpecimenCheck> {
    let (file, set) = specimen_file::load(folder)?;
    let AgainstScans { other_scans, recorded, reference } = match run {
        Some(run) => against_scans(run, &file, &set, checking)?,
        None => AgainstScans::default(),
    };
    let mut deviations: Vec<f64> = file.check_values.iter().map(|value| deviation(&set, value)).collect();
    if let Some(stored) = &file.spectral {
        let tables = read_spectral(folder, stored, set.front_factor)?;
        deviations.extend(stored.check_values.iter().map(|value| spectral_deviation(&tables, value)));
    }
    Ok(SpecimenCheck {
        check_values: deviations.len(),
        check_worst: metrics::quantiles(deviations).worst,
        name: file.name,
        other_scans,
        recorded,
        reference,
    })
}

/// Largest deviation of a stored check value from the tables evaluated now, relative to its Y.
fn deviation(set: &TableSet, value: &CheckValue) -> f64 {
    let scale = value.xyz[1].abs().max(f64::MIN_POSITIVE);
    let of = |(look_up, then): (Interpolation, Xyz)| {
        let now = brdf_xyz(set, look_up, value.wi, value.wo);
        (0..3).map(move |c| (now[c] - then[c]).abs() / scale)
    };
    let by_splines = value.xyz_spline.map(|xyz| (Interpolation::Spline, xyz));
    // A NaN is the worst of all.
    metrics::quantiles(std::iter::once((Interpolation::Bilinear, value.xyz)).chain(by_splines).flat_map(of).collect())
        .worst
}

/// The same for a check value of spectral tables, relative to its largest.
fn spectral_deviation(tables: &SpectralTables, value: &SpectralCheckValue) -> f64 {
    let scale = value.brdf.iter().fold(f64::MIN_POSITIVE, |largest, brdf| largest.max(brdf.abs()));
    let kinds = [(Interpolation::Bilinear, &value.brdf), (Interpolation::Spline, &value.brdf_spline)];
    let stated = kinds.iter().filter(|(look_up, then)| *look_up == Interpolation::Bilinear || !then.is_empty());
    let mut deviations = Vec::new();
    for (look_up, then) in stated {
        let now = tables.eval(*look_up, value.wi, value.wo, &value.wavelength_nm);
        if now.len() != then.len() {
            return f64::NAN;
        }
        deviations.extend(now.iter().zip(then.iter()).map(|(now, then)| (now - then).abs() / scale));
    }
    metrics::quantiles(deviations).worst
}

impl Verified {
    /// What is wrong, a line each.
    pub(crate) fn failures(&self) -> Vec<String> {
        let all_files = self.atlas.iter().chain(&self.files.failures);
        let files = all_files.map(|failure| format!("{}: {}", failure.file, failure.what));
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
        let recorded = self.specimens.iter().flat_map(|check| {
            check.recorded.iter().filter(|recorded| !recorded.passed).map(|recorded| {
                let [now, then] = [recorded.found, recorded.recorded].map(|figures| {
                    figures.map(|figure| figure.map_or("none".into(), |figure| format!("{figure:.3e}"))).join(", ")
                });
                format!(
                    "{}: {}: errors at the recorded directions (median, 95 %, 99 %, largest, relative L2) are {now}; recorded were \
                     {then}",
                    check.name, recorded.region
                )
            })
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
        files.chain(values).chain(scans).chain(recorded).chain(references).collect()
    }
}
