//! Tables held against the scans they were made from: at the directions whose errors are recorded, and at fresh ones.

use serde::Serialize;

use super::specimen_file::SpecimenFile;
use super::verify_chance::is_implausible;
use crate::stages::config::RunConfig;
use crate::stages::coverage::asked;
use crate::stages::ingest::{Scans, ingest};
use diffraction_brdf::direction::Xyz;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_build::accuracy::directions::{Candidates, DRAWN, ErrorDirections, ErrorGroup, Group};
use diffraction_build::accuracy::rows::{Cause, ErrorRow, totals};
use diffraction_build::ground::metrics;
use diffraction_build::ground::sampling::{self, Region};
use diffraction_build::height::HeightField;
use diffraction_build::height::read::Provenance;
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::optics::spectra::SpectraConfig;
use diffraction_build::optics::spectral;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{TableSet, TablesConfig};
use diffraction_build::tables::plan;
use diffraction_render::scene::model::Scene;
use diffraction_render::scene::samples::samples;

/// Which directions are evaluated anew.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sampling {
    /// Directions above the floor, of each group.
    pub count: usize,
    /// Chooses them.
    pub seed: u64,
}

/// Relative errors over fresh directions of one group, beside those recorded when the atlas was made.
#[derive(Debug, Serialize)]
pub struct ReferenceCheck {
    /// The group's name.
    pub region: String,
    /// Directions bright enough to have a relative error.
    pub directions: usize,
    /// Their median.
    pub p50: f64,
    /// Their 95th percentile.
    pub p95: f64,
    /// Directions bright enough when the atlas was made.
    pub recorded_directions: usize,
    /// Their median.
    pub recorded_p50: f64,
    /// Their 95th percentile.
    pub recorded_p95: f64,
    /// Whether the errors are as recorded, but for chance.
    pub passed: bool,
}

/// Errors over the very directions of one group that were recorded when the atlas was made.
#[derive(Debug, Serialize)]
pub struct RecordedCheck {
    /// The group's name.
    pub region: String,
    /// Directions that were bright enough.
    pub directions: usize,
    /// Median, 95th and 99th percentile, largest, and relative L2, as they are now; `null` for what nothing tells.
    pub found: [Option<f64>; 5],
    /// The same as recorded.
    pub recorded: [Option<f64>; 5],
    /// Whether both are the same.
    pub passed: bool,
}

/// What the scans say of tables.
#[derive(Debug, Default)]
pub(super) struct AgainstScans {
    /// Scans that are not the ones the tables were made from: nothing is evaluated against them.
    pub(super) other_scans: Vec<String>,
    /// The errors at recorded directions, group by group; empty where these cannot be found again.
    pub(super) recorded: Vec<RecordedCheck>,
    /// The errors at fresh directions, group by group.
    pub(super) reference: Vec<ReferenceCheck>,
}

/// How a specimen is checked.
#[derive(Debug, Clone, Copy)]
pub(super) struct Checking {
    /// The fresh directions.
    pub(super) sampling: Sampling,
    /// Chance of a false alarm that this specimen may take.
    pub(super) alpha: f64,
    /// Whether this program's version is the one that made the atlas, so that it finds the recorded directions again.
    pub(super) same_program: bool,
}

/// Errors below this are rounding and not compared.
const ERROR_FLOOR: f64 = 1e-5;

/// What recorded errors may differ by from those at the same directions now, relatively and absolutely: other processors give the
/// reference other digits from the ninth on, relative to values of which errors are a ten-thousandth part.
const SAME: [f64; 2] = [1e-3, 1e-7];

/// Holds a specimen's tables against its scans; nothing where the run has no such specimen.
///
/// Errors at the recorded directions must be those that are recorded: an intact atlas cannot fail there, and a change of 1 % moves
/// them by 1 % of the values, far more than they may differ. Fresh directions are held to the recorded quantiles by
/// [`is_implausible`].
///
/// # Errors
/// Scans that cannot be read any more, and those of the transforms.
pub(super) fn against_scans(
    run: &RunConfig,
    file: &SpecimenFile,
    set: &TableSet,
    checking: Checking,
) -> Result<AgainstScans> {
    let Some(specimen) = run.specimens.iter().find(|specimen| specimen.name == file.name) else {
        return Ok(AgainstScans::default());
    };
    let scans = ingest(specimen)?;
    let other_scans = other_scans(file, &scans);
    if !other_scans.is_empty() {
        return Ok(AgainstScans { other_scans, ..AgainstScans::default() });
    }
    let rows: Vec<ErrorRow> = serde_json::from_value(file.errors.clone())
        .map_err(|error| Error::Call(format!("{}: its recorded errors cannot be read: {error}", file.name)))?;
    if rows.is_empty() {
        return Ok(AgainstScans::default());
    }
    let again = match (&set.restriction, checking.same_program) {
        (None, true) => ErrorDirections::of_regions(set),
        _ => ErrorDirections::default(),
    };
    let fresh = fresh_directions(run, file, set, &rows, checking.sampling)?;
    let pairs = [again.pairs.as_slice(), &fresh.pairs].concat();
    let exact = reference(&scans.fields, &scans.optics, &run.tables, &pairs)?;
    let (exact_again, exact_fresh) = exact.split_at(again.pairs.len());
    Ok(AgainstScans {
        other_scans,
        recorded: recorded_checks(&again, exact_again, set, &rows),
        reference: fresh_checks(&fresh, exact_fresh, set, &rows, checking.alpha),
    })
}

fn total<'a>(rows: &'a [ErrorRow], group: &Group) -> Option<&'a ErrorRow> {
    rows.iter().find(|row| row.cause == Cause::Total && row.group == *group)
}

/// Directions that the run did not see.
fn fresh_directions(
    run: &RunConfig,
    file: &SpecimenFile,
    set: &TableSet,
    rows: &[ErrorRow],
    sampling: Sampling,
) -> Result<ErrorDirections> {
    let mut candidates = match set.restriction {
        None => hemisphere_candidates(set, sampling.seed),
        Some(_) => scene_candidates(run, file, set, sampling.seed)?,
    };
    // What tables that went wrong would call dark is no measure: the recorded floor is.
    candidates.retain_mut(|candidates| {
        let row = total(rows, &candidates.group);
        candidates.floor_per_sr = row.map_or(0.0, |row| row.floor_per_sr);
        row.is_some()
    });
    Ok(ErrorDirections::drawn(set, candidates, sampling.count))
}

/// The rows of everything together, now and as recorded.
fn recorded_checks(again: &ErrorDirections, exact: &[Xyz], set: &TableSet, rows: &[ErrorRow]) -> Vec<RecordedCheck> {
    let now = totals(&again.groups, &again.pairs, exact, set);
    let pairs = now.iter().filter(|row| row.cause == Cause::Total);
    pairs.filter_map(|now| total(rows, &now.group).map(|recorded| recorded_check(now, recorded))).collect()
}

fn recorded_check(now: &ErrorRow, recorded: &ErrorRow) -> RecordedCheck {
    let figures = |row: &ErrorRow| [row.p50, row.p95, row.p99, row.worst, row.relative_l2];
    let is_same =
        |now: f64, then: f64| (now - then).abs() <= SAME[0] * then + SAME[1] || (now.is_nan() && then.is_nan());
    let passed = figures(now).into_iter().zip(figures(recorded)).all(|(now, then)| is_same(now, then));
    let known = |figures: [f64; 5]| figures.map(|figure| figure.is_finite().then_some(figure));
    RecordedCheck {
        region: now.group.to_string(),
        directions: now.directions,
        found: known(figures(now)),
        recorded: known(figures(recorded)),
        passed,
    }
}

fn fresh_checks(
    fresh: &ErrorDirections,
    exact: &[Xyz],
    set: &TableSet,
    rows: &[ErrorRow],
    alpha: f64,
) -> Vec<ReferenceCheck> {
    let mut start = 0;
    let check = |group: &ErrorGroup| {
        let range = start..start + group.len();
        start = range.end;
        let shown: Vec<Xyz> =
            fresh.pairs[range.clone()].iter().map(|&(wi, wo)| brdf_xyz(set, Interpolation::Bilinear, wi, wo)).collect();
        let errors = metrics::colour_errors(&exact[range], &shown, group.floor_per_sr);
        // Two quantiles of each group share what the specimen may take.
        let alpha = alpha / (2 * fresh.groups.len()) as f64;
        total(rows, &group.group).map(|recorded| reference_check(&group.group, errors, recorded, alpha))
    };
    fresh.groups.iter().filter_map(check).collect()
}

/// Names of scans with other digests than those recorded.
fn other_scans(file: &SpecimenFile, scans: &Scans) -> Vec<String> {
    let recorded: Vec<&str> = file
        .provenance
        .as_array()
        .map_or(Vec::new(), |scans| scans.iter().map(|scan| scan["sha256"].as_str().unwrap_or_default()).collect());
    let is_other = |(index, scan): &(usize, &Provenance)| recorded.get(*index) != Some(&scan.sha256.as_str());
    scans.provenance.iter().enumerate().filter(is_other).map(|(_, scan)| scan.file_name.clone()).collect()
}

/// The reference's XYZ.
fn reference(
    fields: &[HeightField],
    optics: &OpticsConfig,
    tables: &TablesConfig,
    pairs: &[([f64; 3], [f64; 3])],
) -> Result<Vec<Xyz>> {
    // Sums over every direction are not what is asked for here; transforms are.
    let roomy = TablesConfig { memory_mib: usize::MAX >> 20, ..tables.clone() };
    let plan = plan::plan(&BuildInput::new(fields, optics, &roomy))?;
    let spectra = SpectraConfig { memory_bytes: (tables.memory_mib as u64) << 20, ..plan.spectra };
    spectral::brdf_xyz_batch(fields, optics, &spectra, pairs)
}

/// Turns of candidates to choose from: indices stay small enough for their points to be evenly spread.
const TURNS: u64 = 1 << 16;

/// From the sequence that gave the recorded directions, further on.
fn hemisphere_candidates(set: &TableSet, seed: u64) -> Vec<Candidates> {
    Candidates::of_regions(set, 1 + (seed % TURNS) as usize)
        .into_iter()
        .filter(|candidates| candidates.group != Group::Region(Region::Grazing))
        .collect()
}

/// Directions of the scenes that the tables were made for, others than the recorded ones.
fn scene_candidates(run: &RunConfig, file: &SpecimenFile, set: &TableSet, seed: u64) -> Result<Vec<Candidates>> {
    let scenes = asked::restricted_to(run, &file.name).unwrap_or_default();
    let of_scene = |scene: &Scene| {
        let samples = samples(scene)?;
        let count = samples.weight.len();
        let drawn = (0..DRAWN.min(count)).map(|index| {
            let at = (sampling::plane(index + (seed % 1_000_000) as usize)[0] * count as f64) as usize;
            (samples.wi[at].map(f64::from), samples.wo[at].map(f64::from))
        });
        Ok(Candidates::of_scene(set, &scene.name, drawn.collect()))
    };
    scenes.iter().map(of_scene).collect()
}

fn reference_check(group: &Group, errors: Vec<f64>, recorded: &ErrorRow, alpha: f64) -> ReferenceCheck {
    let is_chance = |quantile: f64, limit: f64| {
        let limit = limit.max(ERROR_FLOOR);
        // A NaN counts as an error.
        let above = errors.iter().filter(|&&error| error.is_nan() || error > limit).count();
        !is_implausible(above, errors.len(), recorded.directions, quantile, alpha)
    };
    let passed = is_chance(0.5, recorded.p50) && is_chance(0.95, recorded.p95);
    let quantiles = metrics::quantiles(errors);
    ReferenceCheck {
        region: group.to_string(),
        directions: quantiles.count,
        p50: quantiles.p50,
        p95: quantiles.p95,
        recorded_directions: recorded.directions,
        recorded_p50: recorded.p50,
        recorded_p95: recorded.p95,
        passed,
    }
}

#[cfg(test)]
#[path = "verify_scans_tests.rs"]
mod tests;
