//! Tables held against the scans they were made from, at other directions than those whose errors are recorded.

use serde::Serialize;

use super::specimen_file::SpecimenFile;
use crate::stages::config::RunConfig;
use crate::stages::coverage::asked;
use crate::stages::ingest::{Scans, ingest};
use diffraction_brdf::direction::Xyz;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_build::accuracy::directions::{Candidates, DRAWN, ErrorDirections, Group};
use diffraction_build::accuracy::rows::{Cause, ErrorRow};
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

/// Relative errors of Y over directions of one group, beside those recorded when the atlas was made.
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

/// What the scans say of tables.
#[derive(Debug, Default)]
pub(super) struct AgainstScans {
    /// Scans that are not the ones the tables were made from: nothing is evaluated against them.
    pub(super) other_scans: Vec<String>,
    /// The errors, group by group.
    pub(super) reference: Vec<ReferenceCheck>,
}

/// Errors below this are rounding and not compared.
const ERROR_FLOOR: f64 = 1e-5;

/// Standard deviations by which more errors than expected may lie above a recorded quantile.
const SIGMAS: f64 = 4.0;

/// Holds a specimen's tables against its scans; nothing where the run has no such specimen.
///
/// # Errors
/// Scans that cannot be read any more, and those of the transforms.
pub(super) fn against_scans(
    run: &RunConfig,
    file: &SpecimenFile,
    set: &TableSet,
    sampling: Sampling,
) -> Result<AgainstScans> {
    let Some(specimen) = run.specimens.iter().find(|specimen| specimen.name == file.name) else {
        return Ok(AgainstScans::default());
    };
    let scans = ingest(specimen)?;
    let other_scans = other_scans(file, &scans);
    if !other_scans.is_empty() {
        return Ok(AgainstScans { other_scans, reference: Vec::new() });
    }
    let recorded: Vec<ErrorRow> = serde_json::from_value(file.errors.clone())
        .map_err(|error| Error::Call(format!("{}: its recorded errors cannot be read: {error}", file.name)))?;
    let total = |group: &Group| recorded.iter().find(|row| row.cause == Cause::Total && row.group == *group);
    let mut candidates = match set.restriction {
        None => hemisphere_candidates(set, sampling.seed),
        Some(_) => scene_candidates(run, file, set, sampling.seed)?,
    };
    // What tables that went wrong would call dark is no measure: the recorded floor is.
    candidates.retain_mut(|candidates| {
        let row = total(&candidates.group);
        candidates.floor_per_sr = row.map_or(0.0, |row| row.floor_per_sr);
        row.is_some()
    });
    let ErrorDirections { groups, pairs } = ErrorDirections::drawn(set, candidates, sampling.count);
    let exact = reference(&scans.fields, &scans.optics, &run.tables, &pairs)?;
    let mut directions = pairs.iter().zip(&exact);
    let mut reference = Vec::new();
    for group in &groups {
        let errors = directions.by_ref().take(group.len()).filter_map(|(&(wi, wo), exact)| {
            let ours = brdf_xyz(set, Interpolation::Bilinear, wi, wo)[1];
            // A NaN is kept, so that it counts as an error.
            (exact[1] > group.floor_per_sr || exact[1].is_nan()).then(|| (ours - exact[1]).abs() / exact[1])
        });
        let errors = errors.collect();
        reference.extend(total(&group.group).map(|recorded| reference_check(&group.group, errors, recorded)));
    }
    Ok(AgainstScans { other_scans, reference })
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

fn reference_check(group: &Group, errors: Vec<f64>, recorded: &ErrorRow) -> ReferenceCheck {
    let plausible = |quantile: f64, limit: f64| {
        let limit = limit.max(ERROR_FLOOR);
        let above = errors.iter().filter(|&&error| error.is_nan() || error > limit).count();
        above as f64 <= most_above(errors.len(), recorded.directions, quantile)
    };
    let passed = plausible(0.5, recorded.p50) && plausible(0.95, recorded.p95);
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

/// How many of `count` errors may lie above a quantile of `recorded` others of the same kind by chance.
///
/// If both come from one distribution, whatever it is, the number above the `r`-th smallest recorded one is
/// a sum over a beta-distributed share with mean `1 - q` and variance `q (1 - q) / (recorded + 2)`: its own
/// variance is `count q (1 - q) (count + recorded + 1) / (recorded + 2)`.
fn most_above(count: usize, recorded: usize, q: f64) -> f64 {
    let (n, m) = (count as f64, recorded as f64);
    n * (1.0 - q) + SIGMAS * (n * q * (1.0 - q) * (n + m + 1.0) / (m + 2.0)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn recorded(directions: usize, p50: f64, p95: f64) -> ErrorRow {
        ErrorRow {
            cause: Cause::Total,
            group: Group::Region(Region::Hemisphere),
            directions,
            floor_per_sr: 0.0,
            share_above: 1.0,
            directions_below: 0,
            missed_directions: 0,
            left_out_per_sr: None,
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
        let passed = |errors| reference_check(&row.group, errors, &row).passed;
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
