//! From measurements to the finished folder of a specimen, and what the report and the index say of it.

use std::path::Path;

use serde_json::{Value, json};

use super::build::{Ingested, Planned, Stored};
use super::check_values::check_values;
use super::clock::{Clock, Step};
use super::job::{Heights, Job};
use super::measure::Measured;
use super::spectral::Spectral;
use super::verdict::{Outcome, failed_verdict, verdict};
use super::warnings::{scan_warnings, table_warnings};
use crate::stages::archive::specimen_file::{self, SpecimenFile};
use crate::stages::cache::store::CacheUse;
use crate::stages::config::SpecimenConfig;
use crate::stages::coverage::{asked, savings};
use crate::stages::goniometry::goniometry;
use crate::stages::pictures::covered::covered_picture;
use crate::stages::pictures::preview::write_preview;
use crate::stages::pictures::scenes;
use crate::stages::pictures::shared_scenes::{self, Share};
use crate::stages::results::{BuildResult, HeightMapFile, LobeResult, SceneResult, SpecimenResult, SpectrumFile};
use crate::stages::stage::Stage;
use diffraction_brdf::atlas::InputRecord;
use diffraction_brdf::dispersion::Origin;
use diffraction_brdf::error::Result;
use diffraction_brdf::spectral_storage::StoredSpectral;
use diffraction_build::accuracy::power_sums::too_bright;
use diffraction_build::accuracy::rows;
use diffraction_build::optics::pigment::Surface;
use diffraction_build::tables::coverage::budget::{Budget, Cost};
use diffraction_build::tables::forecast::forecast_of;
use diffraction_build::tables::model::Basis;
use diffraction_render::render::png_image::write_png;
use diffraction_render::scene::model::Scene;

/// What is said where the manifest names no material.
const NO_MATERIAL: &str = "no material is given, so all light is reflected and brightness means nothing yet: say what it is made of, such \
                           as material = { n = 1.56 } for keratin, or material = \"ideal\" if that is meant";

/// What a finished specimen leaves besides its files.
pub(super) struct Described {
    pub(super) result: SpecimenResult,
    pub(super) inputs: Vec<InputRecord>,
    /// Its shares of scenes that show several specimens.
    pub(super) shares: Vec<Share>,
    /// What the cache knew.
    pub(super) used: CacheUse,
}

/// Files of pictures, by their paths from the report.
struct Pictures {
    scenes: Vec<SceneResult>,
    preview_png: Option<String>,
    coverage_png: Option<String>,
    heights: Option<(HeightMapFile, SpectrumFile)>,
}

/// Writes pictures and `specimen.json`, accounts for what was left out, and puts the result together.
pub(super) fn describe(
    job: &Job,
    ingested: &Ingested,
    planned: &Planned,
    mut measured: Measured,
    spectral: Option<Spectral>,
    clock: &mut Clock,
) -> Step<Described> {
    let mut warnings = warnings(job, ingested, planned, &measured);
    if !job.specimen.is_material_given {
        warnings.push(NO_MATERIAL.into());
    }
    let pictures = std::mem::take(&mut measured.pictures);
    let (shares, own): (Vec<_>, Vec<_>) = pictures.into_iter().partition(|(work, _)| work.is_share());
    let shares = shares.into_iter().map(|(work, reference)| {
        let expected = reference.map(|reference| work.expected(&reference));
        shared_scenes::share(work, expected)
    });
    let goniometry = clock.stage(Stage::LookAround, || {
        let tables = spectral.as_ref().map(|spectral| &spectral.tables);
        goniometry(measured.stored.surface(), tables, &ingested.scans.optics, &job.folder, &job.specimen.name)
    })?;
    let (shares, pictures) = clock.stage(Stage::WritePictures, || {
        let shares: Vec<Share> = shares.collect();
        let scenes =
            own.into_iter().map(|(work, reference)| work.finish(reference.as_deref(), &job.folder, &job.specimen.name));
        let pictures = write_pictures(job, ingested, measured.stored.surface(), scenes.collect::<Result<_>>()?)?;
        let files = spectral.as_ref().map(|spectral| &spectral.files);
        let file = specimen_json(job.specimen, ingested, &measured, files, &warnings);
        specimen_file::write(&job.folder, &file)?;
        Ok((shares, pictures))
    })?;
    let budget = match &planned.coverage {
        None => None,
        Some(covered) => Some(clock.stage(Stage::AccountSavings, || {
            let scenes: Vec<&Scene> = ingested.scenes.iter().collect();
            let (whole, cost) = (&job.config.tables, measured.stored.took.cost);
            savings::account(&planned.input, &scenes, covered, whole, cost, job.config.report.savings)
        })?),
    };
    Ok(Described {
        result: SpecimenResult {
            spectral: spectral.map(|spectral| spectral.result),
            goniometry,
            ..result(job, ingested, planned, measured, pictures, budget, warnings)
        },
        inputs: inputs(job, ingested),
        shares,
        used: planned.known.used(),
    })
}

/// What a user must know: of tables, scans, pictures, errors.
fn warnings(job: &Job, ingested: &Ingested, planned: &Planned, measured: &Measured) -> Vec<String> {
    let optics = &ingested.scans.optics;
    let Stored { set, files, .. } = &measured.stored;
    let scenes: Vec<&Scene> = ingested.scenes.iter().collect();
    let mut warnings = table_warnings(set, files, &ingested.tables, planned.plan.texels.grid.texel());
    warnings.extend(scan_warnings(&ingested.scans, optics));
    // Where it keeps all tables from being made, there is no specimen to warn of.
    warnings.extend(asked::spectral_obstacle(job.config, optics).ok().flatten());
    warnings.extend(scenes::warnings(&scenes, optics));
    warnings.extend(too_bright(&measured.reflected.albedo, measured.energy_limit.as_ref()));
    warnings.extend(rows::broken_tolerances(&measured.errors, ingested.tables.tolerance, set.size()));
    warnings.extend(ingested.unread.iter().chain(&measured.not_compared).cloned());
    warnings
}

/// All pictures but those of `scenes`, which are written already.
fn write_pictures(job: &Job, ingested: &Ingested, surface: Surface, scenes: Vec<SceneResult>) -> Result<Pictures> {
    let (folder, name) = (&job.folder, &job.specimen.name);
    let coverage = covered_picture(surface.tables);
    let preview_png = match &coverage {
        None => {
            write_preview(surface, folder)?;
            Some(format!("{name}/preview.png"))
        }
        // A ball asks for directions that the tables lack.
        Some(_) => scenes.first().map(|scene| scene.table_png.clone()),
    };
    let coverage_png = match coverage {
        None => None,
        Some(picture) => {
            write_png(&folder.join("served.png"), &picture)?;
            Some(format!("{name}/served.png"))
        }
    };
    let heights = match ingested.scans.statistics.first() {
        None => None,
        Some(statistics) => {
            let (field, replaced) = (&ingested.scans.fields[0], ingested.scans.replaced.as_ref());
            Some((job.illustrate)(&Heights { field, replaced, statistics }, folder, name)?)
        }
    };
    Ok(Pictures { scenes, preview_png, coverage_png, heights })
}

fn to_value(value: &impl serde::Serialize) -> Value {
    serde_json::to_value(value).unwrap_or(Value::Null)
}

fn specimen_json(
    specimen: &SpecimenConfig,
    ingested: &Ingested,
    measured: &Measured,
    spectral: Option<&StoredSpectral>,
    warnings: &[String],
) -> SpecimenFile {
    let Stored { set, files, pigment, record, .. } = &measured.stored;
    SpecimenFile {
        schema: diffraction_brdf::specimen::SCHEMA,
        name: specimen.name.clone(),
        species: specimen.species.clone().unwrap_or_default(),
        provenance: to_value(&ingested.scans.provenance),
        preparation: json!({ "settings": specimen.prepare, "done": ingested.scans.preparation }),
        statistics: to_value(&ingested.scans.statistics),
        optics: ingested.scans.optics.clone(),
        pigment: *pigment,
        build: record.clone(),
        tables: files.clone(),
        spectral: spectral.cloned(),
        errors: to_value(&measured.errors),
        albedo: measured.reflected.albedo.clone(),
        energy_limit: measured.energy_limit.clone(),
        // Those of derived tables are the spectral ones'.
        check_values: match files.derived_under {
            None => check_values(set, &measured.counted),
            Some(_) => Vec::new(),
        },
        warnings: warnings.to_vec(),
    }
}

/// Files that the specimen is made from.
fn inputs(job: &Job, ingested: &Ingested) -> Vec<InputRecord> {
    let record =
        |path: &Path, sha256: &str| InputRecord { path: job.config.relative_name(path), sha256: sha256.into() };
    let scans = job.specimen.scans.iter().zip(&ingested.scans.provenance);
    let scans = scans.map(|(path, provenance)| record(path, &provenance.sha256));
    let material = match ingested.scans.optics.dispersion.as_ref().map(|dispersive| dispersive.table.origin()) {
        Some(Origin::File { path, sha256 }) => Some(record(&job.config.base.join(path), sha256)),
        _ => None,
    };
    let measurement = ingested.measurement.as_ref().map(|m| record(&m.config.file, &m.sha256));
    scans.chain(measurement).chain(material).collect()
}

fn result(
    job: &Job,
    ingested: &Ingested,
    planned: &Planned,
    measured: Measured,
    pictures: Pictures,
    budget: Option<Budget>,
    warnings: Vec<String>,
) -> SpecimenResult {
    let (specimen, field) = (job.specimen, &ingested.scans.fields[0]);
    let outcome = Outcome {
        usable_radius: measured.stored.set.usable_radius,
        breaks_tolerance: measured.errors.iter().any(|row| row.is_over(ingested.tables.tolerance)),
        is_material_given: specimen.is_material_given,
    };
    let verdict = verdict(&ingested.scans, &outcome);
    let [width_nm, height_nm] = field.extent_nm();
    let (height_map, spectrum) = pictures.heights.unzip();
    SpecimenResult {
        name: specimen.name.clone(),
        species: specimen.species.clone(),
        generated: specimen.species.as_deref().is_some_and(|species| species.starts_with("generated")),
        scans: ingested.scans.provenance.iter().map(to_value).collect(),
        size: field.size(),
        pitch_nm: field.pitch_nm,
        extent_um: [width_nm * 1e-3, height_nm * 1e-3],
        statistics: ingested.scans.statistics.first().cloned(),
        optics: Some(ingested.scans.optics.clone()),
        pigment: measured.stored.pigment,
        build: Some(build_result(ingested, planned, &measured.stored)),
        lobe: measured.stored.set.lobe.as_ref().map(|lobe| LobeResult {
            radius_max: lobe.radius_max,
            cross_tables: lobe.cross.len(),
            power_share: measured.reflected.lobe_share,
        }),
        errors: measured.errors,
        power_sums: measured.reflected.power_sums,
        albedo: measured.reflected.albedo,
        measured: measured.measured,
        goniometry: None,
        scenes: pictures.scenes,
        height_map,
        spectrum,
        preview_png: pictures.preview_png,
        reached_png: pictures.coverage_png,
        spectral: None,
        budget,
        verdict: Some(verdict),
        warnings,
        failed: None,
        stale: None,
    }
}

fn build_result(ingested: &Ingested, planned: &Planned, stored: &Stored) -> BuildResult {
    let Planned { input, plan, .. } = planned;
    // The published series is built another way, which no forecast knows; derived tables are not built at all.
    let is_predicted = input.tables.basis == Basis::Chebyshev && stored.files.derived_under.is_none();
    let predicted = is_predicted.then(|| {
        let threads = rayon::current_num_threads();
        Cost::predicted(&forecast_of(input, plan, threads))
    });
    BuildResult {
        basis: stored.set.basis,
        tables: stored.set.tables.len(),
        size: stored.set.size(),
        storage: stored.files.storage,
        rounding: stored.files.rounding,
        stored_bytes: stored.took.stored_bytes,
        prefilter_width: stored.set.prefilter_width,
        tolerance: ingested.tables.tolerance,
        record: stored.record.clone(),
        build_s: stored.took.cost.seconds,
        build_cpu_s: stored.took.processor_s,
        memory_bytes: stored.took.memory_bytes,
        predicted,
    }
}

/// A specimen of which nothing is known but its name, and why.
pub(super) fn failed_result(specimen: &SpecimenConfig, why: &str) -> SpecimenResult {
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
        albedo: Vec::new(),
        measured: None,
        goniometry: None,
        scenes: Vec::new(),
        height_map: None,
        spectrum: None,
        preview_png: None,
        reached_png: None,
        spectral: None,
        budget: None,
        verdict: Some(failed_verdict(why)),
        warnings: Vec::new(),
        failed: Some(why.to_owned()),
        stale: None,
    }
}
