//! From a specimen's scans to its stored tables: ingested, planned, built, stored.

use super::clock::{Clock, Step};
use super::job::Job;
use crate::stages::built::Built;
use crate::stages::cache::known::Known;
use crate::stages::config::Cover;
use crate::stages::coverage::{asked, savings};
use crate::stages::ingest::{Scans, ingest as read_scans};
use crate::stages::measured::{self, Measurement};
use crate::stages::stage::Stage;
use diffraction_brdf::error::Error;
use diffraction_brdf::files;
use diffraction_brdf::storage::{StoredTables, read_tables};
use diffraction_build::accuracy::texels;
use diffraction_build::optics::pigment::{Pigment, Surface, pigment};
use diffraction_build::tables::coverage::budget::Cost;
use diffraction_build::tables::coverage::ranges::Coverage;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::look_ups::tried_first;
use diffraction_build::tables::model::{BuildRecord, TableSet, TablesConfig};
use diffraction_build::tables::plan::{BuildPlan, automatic_size, plan_for};
use diffraction_build::tables::resolution::lobe_radius;
use diffraction_build::tables::rounding;
use diffraction_render::scene::model::Scene;

/// Everything that is read.
pub(super) struct Ingested {
    pub(super) scans: Scans,
    pub(super) measurement: Option<Measurement>,
    /// Why there is no measurement though one is named: that costs the comparison, not the tables.
    pub(super) unread: Option<String>,
    /// What is asked of the tables.
    pub(super) tables: TablesConfig,
    /// What is pictured with them.
    pub(super) scenes: Vec<Scene>,
}

/// What is going to be computed.
pub(super) struct Planned<'a> {
    pub(super) input: BuildInput<'a>,
    /// What the manifest asks of the tables; `input` has the size that was chosen.
    pub(super) asked: &'a TablesConfig,
    /// What the tables are restricted to; `None` for every direction.
    pub(super) coverage: Option<Coverage>,
    pub(super) plan: BuildPlan,
    pub(super) known: Known<'a>,
}

/// The specimen's files, read back.
pub(super) struct Stored {
    /// The tables as a reader gets them.
    pub(super) set: TableSet,
    /// The tables before rounding, where errors are going to be told by cause.
    pub(super) exact: Option<TableSet>,
    pub(super) files: StoredTables,
    pub(super) pigment: Option<Pigment>,
    pub(super) record: BuildRecord,
    pub(super) took: Took,
}

/// What building took.
pub(super) struct Took {
    pub(super) cost: Cost,
    pub(super) processor_s: Option<f64>,
    pub(super) memory_bytes: Option<u64>,
    pub(super) stored_bytes: u64,
}

impl Stored {
    /// What pictures show.
    pub(super) fn surface(&self) -> Surface<'_> {
        Surface { tables: &self.set, pigment: self.pigment.as_ref() }
    }
}

/// Reads scans and measurement.
pub(super) fn ingest(job: &Job, clock: &mut Clock) -> Step<Ingested> {
    let (config, specimen) = (job.config, job.specimen);
    let scans = clock.stage(Stage::ReadAndPrepare, || {
        files::create_folder(&job.folder.join("scenes"))?;
        read_scans(specimen)
    })?;
    let read = |config| clock.stage(Stage::ReadMeasured, || measured::read(config));
    let (measurement, unread) = match specimen.measured.as_ref().map(read) {
        None => (None, None),
        Some(Ok(measurement)) => (Some(measurement), None),
        Some(Err(failed)) => (None, Some(not_compared(&failed.error))),
    };
    let tables = asked::tables_for(config, &specimen.name);
    Ok(Ingested { scans, measurement, unread, tables, scenes: asked::pictured_scenes(config, &specimen.name) })
}

/// What a user must know of a measurement that is not compared with.
pub(super) fn not_compared(error: &Error) -> String {
    let what = error.to_string().lines().map(str::trim).collect::<Vec<_>>().join(" ");
    format!("not compared with the measured reflectance: {what}")
}

/// The settings with which tables are tried first, on fewer texels than the tolerance may ask for; `None` where that is not to be
/// decided: the size is given, or tables are restricted to scenes, or there are none of X, Y, Z.
pub(super) fn on_fewer_texels(job: &Job, ingested: &Ingested) -> Option<TablesConfig> {
    let asked = &ingested.tables;
    let may_try = job.config.cover.is_all() && job.config.hold.xyz;
    let size = tried_first(&ingested.scans.optics, asked).filter(|_| may_try)?;
    Some(TablesConfig { size: Some(size), ..asked.clone() })
}

/// Texels a side that tables take for the tolerance, told from those that were built: as many where they suffice, else more; `None`
/// for as many as are taken where nothing is known.
pub(super) fn more_texels(built: &Built, planned: &Planned, clock: &mut Clock) -> Step<Option<usize>> {
    let (tolerance, size) = (planned.asked.tolerance, built.set.size());
    let error = clock.stage(Stage::CountTexels, || Ok(texels::spline_error(&built.set)))?;
    let wanted = if texels::suffice(error, tolerance) { size } else { texels::wanted(error, tolerance, size) };
    Ok((wanted < automatic_size(planned.input.optics, tolerance)).then_some(wanted))
}

/// Plans the tables with these settings, for the scenes alone where they are restricted to them.
pub(super) fn plan<'a>(
    job: &Job<'a>,
    ingested: &'a Ingested,
    tables: &'a TablesConfig,
    clock: &mut Clock,
) -> Step<Planned<'a>> {
    let optics = &ingested.scans.optics;
    let fields = &ingested.scans.fields;
    let input = BuildInput::new(fields, optics, tables);
    let coverage = match job.config.cover {
        Cover::All => None,
        Cover::Scenes | Cover::Named(_) => {
            let scenes: Vec<&Scene> = ingested.scenes.iter().collect();
            Some(clock.stage(Stage::FindCoverage, || savings::cover(&input, &scenes))?)
        }
    };
    let plan = clock.stage(Stage::Plan, || plan_for(&input, coverage.clone()))?;
    Ok(Planned { input, asked: &ingested.tables, coverage, plan, known: Known::new(job.cache, fields) })
}

/// Builds the tables, or finds them in the cache.
pub(super) fn build(planned: &Planned, clock: &mut Clock) -> Step<Built> {
    let Planned { input, plan, known, .. } = planned;
    let wavelengths = plan.rings.iter().map(|ring| ring.wavelengths()).sum::<usize>();
    let progress = clock.log.progress();
    clock.stage_of(Stage::BuildTables, (wavelengths * plan.windows.len()) as u64, || {
        known.tables(input, plan, &|n| progress.advance(n))
    })
}

/// Stores the tables and reads them back: from here on they are what a reader gets.
pub(super) fn store(job: &Job, planned: &Planned, built: Built, clock: &mut Clock) -> Step<Stored> {
    let optics = planned.input.optics;
    let tables = planned.input.tables;
    let chosen = clock.stage(Stage::Round, || {
        Ok(rounding::choose(&built.set, tables.storage, tables.tolerance, lobe_radius(optics)))
    })?;
    let (stored, stored_bytes) = clock.stage(Stage::StoreTables, || {
        let stored = chosen.write(&job.folder)?;
        Ok((stored, files::bytes_of(&job.folder, "exr")?))
    })?;
    let took = Took {
        cost: savings::cost_of(&built, stored_bytes as f64),
        processor_s: built.processor_s,
        memory_bytes: built.memory_bytes,
        stored_bytes,
    };
    // What nobody asks for again leaves its room to what is read back.
    drop(chosen);
    let exact = job.config.report.reference.then_some(built.set);
    let (set, pigment) = clock.stage(Stage::ReadBack, || {
        let pigment = job.specimen.albedo.map(|albedo| pigment(albedo, optics)).transpose()?;
        Ok((read_tables(&job.folder, &stored, optics.front_factor())?, pigment))
    })?;
    Ok(Stored { set, exact, files: stored, pigment, record: built.record, took })
}
