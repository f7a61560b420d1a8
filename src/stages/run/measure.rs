//! From stored tables to what is known of them: pictures, the reference, errors, measured reflectance.

use super::build::{Ingested, Planned, Stored, not_compared};
use super::clock::{Clock, Step};
use super::job::Job;
use crate::stages::cache::known::Known;
use crate::stages::ingest::Scans;
use crate::stages::measured::{self, MeasuredResult};
use crate::stages::pictures::scenes::{SceneWork, candidates_of, render_tables};
use crate::stages::pictures::shading::Shading;
use crate::stages::stage::Stage;
use diffraction_brdf::SpectralTables;
use diffraction_brdf::direction::{Vec3, Xyz};
use diffraction_brdf::energy::EnergyLimit;
use diffraction_brdf::error::Result;
use diffraction_build::accuracy::directions::{DIRECTIONS, ErrorDirections};
use diffraction_build::accuracy::energy::energy_limit;
use diffraction_build::accuracy::power_sums::{Reflected, reflected};
use diffraction_build::accuracy::reference::Reference;
use diffraction_build::accuracy::rows::{ErrorRow, error_rows};
use diffraction_build::accuracy::thinned::{is_in_question, sampling_rows, thinned};
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::plan::plan_for;

/// What the stored tables show, and how far that is from the reference.
pub(super) struct Measured {
    pub(super) stored: Stored,
    /// The scenes as the tables show them, and for each the reference's XYZ at its pairs, where that is asked for.
    pub(super) pictures: Vec<(SceneWork, Option<Vec<Xyz>>)>,
    /// The pairs of directions on which errors are counted.
    pub(super) counted: Vec<(Vec3, Vec3)>,
    pub(super) errors: Vec<ErrorRow>,
    pub(super) reflected: Reflected,
    pub(super) energy_limit: Option<EnergyLimit>,
    pub(super) measured: Option<MeasuredResult>,
    /// Why there is no comparison though there is a measurement.
    pub(super) not_compared: Option<String>,
}

/// Renders, evaluates the reference at the same directions, and compares.
pub(super) fn measure(
    job: &Job,
    ingested: &Ingested,
    planned: &Planned,
    mut stored: Stored,
    spectral: Option<&SpectralTables>,
    clock: &mut Clock,
) -> Step<Measured> {
    let works = render(job, ingested, &stored, clock)?;
    let directions = match job.config.cover.is_all() {
        true => ErrorDirections::of_regions(&stored.set),
        false => ErrorDirections::drawn(&stored.set, candidates_of(&stored.set, &works), DIRECTIONS),
    };
    let counted = directions.pairs.clone();
    // Dropped with this function: the tables before rounding have told all they can.
    let exact = stored.exact.take();
    let reference = match &exact {
        None => None,
        Some(exact) => Some(clock.stage(Stage::EvaluateReference, || {
            let pictures = works.iter().flat_map(SceneWork::pairs);
            planned.known.reference(&planned.input, &planned.plan, exact.tables.len(), directions, pictures)
        })?),
    };
    let (errors, reflected, energy_limit) = clock.stage(Stage::MeasureErrors, || {
        let errors = match (&reference, &exact) {
            (Some(reference), Some(exact)) => {
                let mut errors = error_rows(reference, &stored.set, exact);
                errors.extend(sampling(job, ingested, planned, reference)?);
                errors.push(planned.known.direct_row(&planned.input, reference)?);
                errors
            }
            _ => Vec::new(),
        };
        let reflected = reflected(&stored.set);
        let energy_limit = energy_limit(&stored.set, &reflected.albedo);
        Ok((errors, reflected, energy_limit))
    })?;
    let compared = ingested.measurement.as_ref().map(|measurement| {
        clock.stage(Stage::CompareMeasured, || {
            let file = job.config.relative_name(&measurement.config.file);
            let memory_bytes = planned.plan.spectra.memory_bytes;
            let Scans { fields, optics, .. } = &ingested.scans;
            measured::compare(fields, optics, spectral, measurement, file, memory_bytes)
        })
    });
    let (measured, not_compared) = match compared {
        None => (None, None),
        Some(Ok(measured)) => (Some(measured), None),
        Some(Err(failed)) => (None, Some(not_compared(&failed.error))),
    };
    let pictures = with_reference(works, reference.as_ref(), counted.len());
    Ok(Measured { stored, pictures, counted, errors, reflected, energy_limit, measured, not_compared })
}

/// The rows of the scans' sampling, where it is in question.
fn sampling(job: &Job, ingested: &Ingested, planned: &Planned, reference: &Reference) -> Result<Vec<ErrorRow>> {
    let Scans { fields, optics, statistics, .. } = &ingested.scans;
    let Some(thin) = thinned(fields, optics.edge).filter(|_| is_in_question(statistics)) else { return Ok(Vec::new()) };
    let input = BuildInput::new(&thin, optics, planned.input.tables);
    sampling_rows(reference, &thin, optics, |pairs| {
        let plan = plan_for(&input, planned.coverage.clone())?;
        let known = Known::new(job.cache, &thin);
        let found = known.reference(&input, &plan, 0, ErrorDirections::default(), pairs.iter().copied())?;
        Ok(found.xyz)
    })
}

/// The scenes from the tables, and the files of animations.
fn render(job: &Job, ingested: &Ingested, stored: &Stored, clock: &mut Clock) -> Step<Vec<SceneWork>> {
    if ingested.scenes.is_empty() {
        return Ok(Vec::new());
    }
    let (surface, tolerance) = (stored.surface(), job.config.tables.tolerance);
    let (works, shading) = clock.stage(Stage::RenderScenes, || {
        let shading = Shading::new(surface, tolerance);
        let of_scene = |scene| render_tables(scene, &shading, surface.pigment);
        Ok((ingested.scenes.iter().map(of_scene).collect::<Result<Vec<_>>>()?, shading))
    })?;
    if works.iter().any(SceneWork::is_animated) {
        clock
            .stage(Stage::RenderAnimations, || works.iter().try_for_each(|work| work.animate(&shading, &job.folder)))?;
    }
    Ok(works)
}

/// Each scene with the reference's values at its own pairs, which follow the first `counted` ones, scene after scene.
fn with_reference(
    works: Vec<SceneWork>,
    reference: Option<&Reference>,
    counted: usize,
) -> Vec<(SceneWork, Option<Vec<Xyz>>)> {
    let mut next = counted;
    let own = |work: SceneWork| {
        let own = next..next + work.pair_count();
        next = own.end;
        let values = reference.map(|reference| reference.xyz[own].to_vec());
        (work, values)
    };
    works.into_iter().map(own).collect()
}
