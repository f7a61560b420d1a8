//! A specimen's spectral tables: built, stored, read back, and measured against the reference.

use super::build::{Planned, Stored, Took};
use super::clock::{Clock, Step};
use super::job::Job;
use crate::stages::coverage::asked;
use crate::stages::results::SpectralResult;
use crate::stages::stage::Stage;
use crate::stages::usage::Stopwatch;
use diffraction_brdf::SpectralTables;
use diffraction_brdf::derived::DerivedLight;
use diffraction_brdf::error::Result;
use diffraction_brdf::evaluate::Interpolation;
use diffraction_brdf::files;
use diffraction_brdf::spectral_storage::{SpectralCheckValue, StoredSpectral, read_spectral};
use diffraction_brdf::storage::StoredTables;
use diffraction_build::accuracy::directions::DIRECTIONS;
use diffraction_build::accuracy::spectral::{Places, evaluate, rows, spline_error};
use diffraction_build::accuracy::texels;
use diffraction_build::ground::sampling::{Region, direction_pairs};
use diffraction_build::optics::pigment::pigment;
use diffraction_build::tables::coverage::budget::Cost;
use diffraction_build::tables::model::BuildRecord;
use diffraction_build::tables::plan::{BuildPlan, plan};
use diffraction_build::tables::resolution::lobe_radius;
use diffraction_build::tables::spectral::{SpectralBuilt, SpectralInput, build_spectral_planned};

/// Pairs of directions of each region with check values.
const CHECKED_PAIRS: usize = 4;

/// Wavelengths of a check value, evenly from the shortest to the longest.
const CHECKED_WAVELENGTHS: usize = 5;

/// Spectral tables in the specimen's folder.
pub(super) struct Spectral {
    /// As read back.
    pub(super) tables: SpectralTables,
    /// Before rounding, where tables of X, Y, Z are derived whose errors are going to be told by cause.
    pub(super) exact: Option<SpectralTables>,
    /// What was chosen while building.
    pub(super) record: BuildRecord,
    /// Files, axes, scales and check values.
    pub(super) files: StoredSpectral,
    /// What the report says of them.
    pub(super) result: SpectralResult,
}

/// Builds, stores and measures them, where the run asks for them and the optics allow it.
pub(super) fn spectral(job: &Job, planned: &Planned, clock: &mut Clock) -> Step<Option<Spectral>> {
    let obstacle = clock.stage(Stage::Plan, || asked::spectral_obstacle(job.config, planned.input.optics))?;
    if !job.config.hold.spectral || obstacle.is_some() {
        return Ok(None);
    }
    let whole = SpectralInput::new(planned.input.optics, planned.asked);
    let fewer = whole.on_fewer_texels(planned.asked);
    let stopwatch = Stopwatch::start();
    let lobe_radius = lobe_radius(planned.input.optics);
    let built = |settings: &SpectralInput| -> Result<(BuildPlan, SpectralBuilt)> {
        let input = settings.of(&planned.input);
        let plan = plan(&input)?;
        let built = build_spectral_planned(&input, &plan, settings, &|_| ())?;
        Ok((plan, built))
    };
    let (settings, (plan, built)) = clock.stage(Stage::BuildSpectral, || {
        if let Some(fewer) = fewer {
            let found = built(&fewer)?;
            let (error, tolerance) = (spline_error(&found.1.tables, lobe_radius), planned.asked.tolerance);
            if texels::suffice(error, tolerance) {
                return Ok((fewer, found));
            }
            let wanted = whole.on(texels::wanted(error, tolerance, found.1.tables.size()));
            let found = built(&wanted)?;
            return Ok((wanted, found));
        }
        let found = built(&whole)?;
        Ok((whole, found))
    })?;
    let input = settings.of(&planned.input);
    let time = stopwatch.read(Stage::BuildSpectral, None);
    let (stored, tables, stored_bytes) = clock.stage(Stage::StoreSpectral, || {
        let stored = built.write(&job.folder, &settings)?;
        let tables = read_spectral(&job.folder, &stored, planned.input.optics.front_factor())?;
        let size = |file: &str| files::size(&job.folder.join(file));
        let bytes = stored.files().map(size).sum::<Result<u64>>()?;
        Ok((stored, tables, bytes))
    })?;
    let errors = match job.config.report.reference {
        false => Vec::new(),
        true => clock.stage(Stage::MeasureSpectral, || {
            let places = Places::drawn(&tables, lobe_radius, DIRECTIONS);
            let reference = evaluate(&input, &plan, settings.optics_at_each(), tables.count, &places)?;
            Ok(rows(&places, &reference, &tables, &built.tables))
        })?,
    };
    let result = SpectralResult {
        tables: tables.count,
        size: tables.size(),
        storage: stored.storage,
        range_nm: [tables.shortest_nm, tables.longest_nm],
        stored_bytes,
        build_s: time.wall_s,
        build_cpu_s: time.cpu_s,
        errors,
    };
    let files = StoredSpectral { check_values: check_values(&tables), ..stored };
    let exact = (job.config.report.reference && !job.config.hold.xyz).then_some(built.tables);
    Ok(Some(Spectral { tables, exact, record: built.record, files, result }))
}

/// Tables of X, Y, Z in memory, derived from the spectral ones: what readers of an atlas without the former have.
pub(super) fn derived(job: &Job, planned: &Planned, spectral: &Spectral, clock: &mut Clock) -> Step<Stored> {
    let optics = planned.input.optics;
    let light = DerivedLight { illuminant: optics.illuminant.clone(), wavelength_nm: optics.wavelength_nm };
    let (set, exact, pigment) = clock.stage(Stage::DeriveTables, || {
        let exact = spectral.exact.as_ref().map(|tables| tables.xyz_tables(&light)).transpose()?;
        let pigment = job.specimen.albedo.map(|albedo| pigment(albedo, optics)).transpose()?;
        Ok((spectral.tables.xyz_tables(&light)?, exact, pigment))
    })?;
    let SpectralResult { stored_bytes, build_s, build_cpu_s, .. } = spectral.result;
    let cost = Cost {
        node_samples: spectral.record.node_samples as f64,
        seconds: build_s,
        memory_bytes: f64::NAN,
        stored_bytes: stored_bytes as f64,
    };
    Ok(Stored {
        files: StoredTables::derived(&set, light, spectral.files.storage, spectral.files.rounding),
        set,
        exact,
        pigment,
        record: spectral.record.clone(),
        took: Took { cost, processor_s: build_cpu_s, memory_bytes: None, stored_bytes },
    })
}

/// Directions of every region with values at some wavelengths.
fn check_values(tables: &SpectralTables) -> Vec<SpectralCheckValue> {
    let step = (tables.longest_nm - tables.shortest_nm) / (CHECKED_WAVELENGTHS - 1) as f64;
    let wavelength_nm: Vec<f64> =
        (0..CHECKED_WAVELENGTHS).map(|index| tables.shortest_nm + index as f64 * step).collect();
    let pairs = Region::ALL.into_iter().flat_map(|region| direction_pairs(region, CHECKED_PAIRS));
    pairs
        .map(|(wi, wo)| SpectralCheckValue {
            wi,
            wo,
            brdf: tables.eval(Interpolation::Bilinear, wi, wo, &wavelength_nm),
            brdf_spline: tables.eval(Interpolation::Spline, wi, wo, &wavelength_nm),
            wavelength_nm: wavelength_nm.clone(),
        })
        .collect()
}
