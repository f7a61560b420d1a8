//! What a specimen's files and the report say of it, put together from what its stages found out.

use std::path::Path;

use serde_json::{Value, json};

use super::config::{RunConfig, SpecimenConfig};
use super::ingest::Ingested;
use super::measured::Measurement;
use super::results::{BuildResult, LobeResult, SpecimenResult};
use super::specimen::SpecimenFile;
use diffraction_brdf::atlas::{InputRecord, SpecimenEntry};
use diffraction_brdf::direction::{Vec3, angles_deg, from_angles_deg};
use diffraction_brdf::error::Error;
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_brdf::specimen::CheckValue;
use diffraction_brdf::storage::StoredTables;
use diffraction_build::ground::sampling;
use diffraction_build::height::HeightField;
use diffraction_build::height::statistics::seam_warning;
use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
use diffraction_build::optics::pigment::Pigment;
use diffraction_build::tables::build::BuildPlan;
use diffraction_build::tables::model::{Basis, BuildRecord, Rounding, Storage, TableSet, TablesConfig};

/// Directions whose values are stored for testing other programs.
const CHECK_VALUES: usize = 20;

/// Everything about a specimen that is known before its errors are measured.
pub(super) fn describe(
    specimen: &SpecimenConfig,
    ingested: &Ingested,
    tables: &TablesConfig,
    set: &TableSet,
    pigment: Option<Pigment>,
    stored: &StoredTables,
    record: &BuildRecord,
    plan: &BuildPlan,
) -> SpecimenResult {
    let field = &ingested.fields[0];
    let [nx, ny] = field.extent_nm();
    SpecimenResult {
        generated: specimen.species.as_deref().is_some_and(|species| species.starts_with("generated")),
        scans: ingested.provenance.iter().map(to_value).collect(),
        size: field.size(),
        pitch_nm: field.pitch_nm,
        extent_um: [nx * 1e-3, ny * 1e-3],
        statistics: ingested.statistics.first().cloned(),
        optics: Some(specimen.optics.clone()),
        pigment,
        build: Some(BuildResult {
            basis: set.basis,
            tables: set.tables.len(),
            size: set.size(),
            storage: stored.storage,
            rounding: stored.rounding,
            stored_bytes: 0,
            prefilter_width: set.prefilter_width,
            tolerance: tables.tolerance,
            record: record.clone(),
            build_s: 0.0,
            build_cpu_s: None,
            memory_bytes: None,
            predicted: None,
        }),
        lobe: set.lobe.as_ref().map(|lobe| LobeResult {
            radius_max: lobe.radius_max,
            cross_tables: lobe.cross.len(),
            power_share: None,
        }),
        warnings: warnings(set, stored, tables, plan),
        ..nothing_yet(specimen)
    }
}

/// What a user must know about these tables.
fn warnings(set: &TableSet, stored: &StoredTables, tables: &TablesConfig, plan: &BuildPlan) -> Vec<String> {
    let mut warnings = Vec::new();
    if set.usable_radius < 2.0 {
        warnings.push(format!(
            "the scan's sampling answers for |(u, v)| up to {:.2} only: beyond, some wavelengths are missing and values are too dark",
            set.usable_radius
        ));
    }
    if set.prefilter_width > 0.0 {
        warnings.push(format!(
            "a texel ({:.4}) is wider than the coherence lobe: each holds the mean over a square of {:.4} in u and v, \
             so single directions differ from the point values while pictures of extended lights and pixels do not",
            plan.texels.grid.texel(),
            set.prefilter_width
        ));
    }
    warnings.extend(stored.rounding.and_then(|rounding| format_warning(stored.storage, tables, rounding)));
    if set.basis == Basis::Taylor {
        warnings.push("tables of the published Taylor series, kept for comparison".into());
    }
    warnings
}

/// What a user must know about the number format: that the automatic choice is floats although halves do for most, or that
/// halves were asked for and are too coarse.
fn format_warning(storage: Storage, tables: &TablesConfig, rounding: Rounding) -> Option<String> {
    let Rounding { half, allowed, .. } = rounding;
    let shift = format!("one colour in twenty by {half:.1e} or more");
    let left = format!("the tolerance of {:.0e} leaves {allowed:.1e} to storage", tables.tolerance);
    match (storage, tables.storage) {
        (Storage::Float, None) => Some(format!(
            "stored as 32-bit floats: 16-bit ones would shift {shift}, and {left}; textures of 16-bit floats, as on GPUs, \
             show that shift"
        )),
        (Storage::Half, Some(_)) if half > allowed => {
            Some(format!("16-bit floats shift {shift}, and {left}: tables.storage = \"auto\" would take 32-bit ones"))
        }
        _ => None,
    }
}

/// Ratio of two scans' rms heights or pitches from which on they are doubted to show one surface.
const UNLIKE: f64 = 2.0;

/// What a user must know about the scans: of each but the first, whose statistics stand beside these warnings, by its
/// file's name; whether they are alike enough to be averaged; whether each fits itself where it repeats.
pub(super) fn scan_warnings(ingested: &Ingested, optics: &OpticsConfig) -> Vec<String> {
    let name = |index: usize| ingested.provenance[index].file_name.as_str();
    let several = ingested.fields.len() > 1;
    let mut warnings = Vec::new();
    for (index, statistics) in ingested.statistics.iter().enumerate().skip(1) {
        warnings.extend(statistics.warnings.iter().map(|warning| format!("{}: {warning}", name(index))));
    }
    if optics.edge == Edge::Tile {
        let seen = ingested.fields.iter().enumerate().filter(|(_, field)| seams_are_seen(field, optics));
        for (index, field) in seen {
            let prefix = if several { format!("{}: ", name(index)) } else { String::new() };
            warnings.extend(seam_warning(field).map(|warning| format!("{prefix}{warning}")));
        }
    }
    let rms: Vec<f64> = ingested.statistics.iter().map(|statistics| statistics.rms_height_nm).collect();
    let pitch = |axis: usize| ingested.fields.iter().map(|field| field.pitch_nm[axis]).collect::<Vec<_>>();
    for (what, values) in [("rms height", rms), ("pitch along x", pitch(0)), ("pitch along y", pitch(1))] {
        warnings.extend(unlike(what, &values, &name));
    }
    warnings
}

/// Whether a coherence window lies on the edges: one in the middle of a scan 8 sigma wide, as `fade` asks for, does not.
fn seams_are_seen(field: &HeightField, optics: &OpticsConfig) -> bool {
    let inside = field.extent_nm().iter().all(|extent_nm| *extent_nm >= 8.0 * optics.sigma_nm);
    !(inside && optics.windows == Windows::Centre)
}

/// Says which scans differ most, where that is by more than [`UNLIKE`].
fn unlike<'a>(what: &str, values_nm: &[f64], name: &dyn Fn(usize) -> &'a str) -> Option<String> {
    let by_value = |a: &usize, b: &usize| values_nm[*a].total_cmp(&values_nm[*b]);
    let (low, high) = ((0..values_nm.len()).min_by(by_value)?, (0..values_nm.len()).max_by(by_value)?);
    (values_nm[high] > UNLIKE * values_nm[low]).then(|| {
        format!(
            "The scans differ much in {what} ({}: {:.3} nm, {}: {:.3} nm), and are averaged into one surface all the same; \
             specimens of their own keep them apart.",
            name(low),
            values_nm[low],
            name(high),
            values_nm[high]
        )
    })
}

pub(super) fn entry(specimen: &SpecimenConfig) -> SpecimenEntry {
    SpecimenEntry { name: specimen.name.clone(), species: specimen.species.clone().unwrap_or_default() }
}

pub(super) fn inputs(
    config: &RunConfig,
    specimen: &SpecimenConfig,
    ingested: &Ingested,
    measurement: Option<&Measurement>,
) -> Vec<InputRecord> {
    let record = |path: &Path, sha256: &str| InputRecord { path: config.relative_name(path), sha256: sha256.into() };
    let scans = specimen.scans.iter().zip(&ingested.provenance);
    let scans = scans.map(|(path, provenance)| record(path, &provenance.sha256));
    scans.chain(measurement.map(|m| record(&m.config.file, &m.sha256))).collect()
}

fn to_value(value: &impl serde::Serialize) -> Value {
    serde_json::to_value(value).unwrap_or(Value::Null)
}

pub(super) fn specimen_file(
    specimen: &SpecimenConfig,
    ingested: &Ingested,
    tables: StoredTables,
    result: &SpecimenResult,
    set: &TableSet,
    served: &[(Vec3, Vec3)],
) -> SpecimenFile {
    SpecimenFile {
        schema: diffraction_brdf::specimen::SCHEMA,
        name: specimen.name.clone(),
        species: specimen.species.clone().unwrap_or_default(),
        provenance: to_value(&ingested.provenance),
        preparation: json!({ "settings": specimen.prepare, "done": ingested.preparation }),
        statistics: to_value(&ingested.statistics),
        optics: specimen.optics.clone(),
        pigment: result.pigment,
        build: result.build.as_ref().map(|build| build.record.clone()).unwrap_or_default(),
        tables,
        errors: to_value(&result.errors),
        check_values: check_values(set, served),
        warnings: result.warnings.clone(),
    }
}

/// Values for testing other programs: half over the whole hemisphere, half around the mirror direction; where tables
/// do not serve every direction, some of those they do.
fn check_values(set: &TableSet, served: &[(Vec3, Vec3)]) -> Vec<CheckValue> {
    if set.served.is_some() {
        let step = served.len().div_ceil(CHECK_VALUES).max(1);
        return served.iter().step_by(step).map(|&(wi, wo)| served_value(set, wi, wo)).collect();
    }
    let angle = |share: f64, range: f64| (share * range * 10.0).round() / 10.0;
    (0..CHECK_VALUES)
        .map(|index| {
            let [a, b, c, d] = sampling::four(index);
            let (theta_i_deg, phi_i_deg) = (angle(a, 80.0), angle(b, 360.0));
            let (theta_r_deg, phi_r_deg) = if index % 2 == 0 {
                (angle(c, 80.0), angle(d, 360.0))
            } else {
                ((theta_i_deg + angle(c, 2.0) - 1.0).abs(), (phi_i_deg + 179.0 + angle(d, 2.0)) % 360.0)
            };
            let (wi, wo) = (from_angles_deg(theta_i_deg, phi_i_deg), from_angles_deg(theta_r_deg, phi_r_deg));
            let xyz = brdf_xyz(set, Interpolation::Bilinear, wi, wo);
            CheckValue { theta_i_deg, phi_i_deg, theta_r_deg, phi_r_deg, wi, wo, xyz }
        })
        .collect()
}

fn served_value(set: &TableSet, wi: Vec3, wo: Vec3) -> CheckValue {
    let [[theta_i_deg, phi_i_deg], [theta_r_deg, phi_r_deg]] = [wi, wo].map(angles_deg);
    // Samples of a picture are 32-bit floats, not quite of unit length.
    let (wi, wo) = (from_angles_deg(theta_i_deg, phi_i_deg), from_angles_deg(theta_r_deg, phi_r_deg));
    CheckValue {
        theta_i_deg,
        phi_i_deg,
        theta_r_deg,
        phi_r_deg,
        wi,
        wo,
        xyz: brdf_xyz(set, Interpolation::Bilinear, wi, wo),
    }
}

pub(super) fn failed_result(specimen: &SpecimenConfig, error: &Error) -> SpecimenResult {
    SpecimenResult { failed: Some(error.to_string()), ..nothing_yet(specimen) }
}

/// A specimen of which nothing is known but its name.
fn nothing_yet(specimen: &SpecimenConfig) -> SpecimenResult {
    SpecimenResult {
        name: specimen.name.clone(),
        species: specimen.species.clone(),
        generated: false,
        scans: Vec::new(),
        size: [0, 0],
        pitch_nm: [0.0, 0.0],
        extent_um: [0.0, 0.0],
        statistics: None,
        optics: None,
        pigment: None,
        build: None,
        lobe: None,
        errors: Vec::new(),
        power_sums: Vec::new(),
        measured: None,
        scenes: Vec::new(),
        height_map: None,
        spectrum: None,
        preview_png: None,
        reached_png: None,
        budget: None,
        warnings: Vec::new(),
        failed: None,
    }
}
