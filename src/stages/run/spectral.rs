//! A specimen's spectral tables: built, stored, read back, and measured against the reference.

use super::build::Planned;
use super::clock::{Clock, Step};
use super::job::Job;
use crate::stages::coverage::asked;
use crate::stages::results::SpectralResult;
use crate::stages::stage::Stage;
use crate::stages::usage::Stopwatch;
use diffraction_brdf::SpectralTables;
use diffraction_brdf::error::Result;
use diffraction_brdf::evaluate::Interpolation;
use diffraction_brdf::files;
use diffraction_brdf::spectral_storage::{SpectralCheckValue, StoredSpectral, read_spectral};
use diffraction_build::accuracy::directions::DIRECTIONS;
use diffraction_build::accuracy::spectral::{Places, evaluate, rows};
use diffraction_build::ground::sampling::{Region, direction_pairs};
use diffraction_build::tables::plan::plan;
use diffraction_build::tables::spectral::{SpectralInput, build_spectral_planned};

/// Pairs of directions of each region with check values.
const CHECKED_PAIRS: usize = 4;

/// Wavelengths of a check value, evenly from the shortest to the longest.
const CHECKED_WAVELENGTHS: usize = 5;

/// Spectral tables in the specimen's folder.
pub(super) struct Spectral {
    /// Files, axes, scales and check values.
    pub(super) files: StoredSpectral,
    /// What the report says of them.
    pub(super) result: SpectralResult,
    /// The tables as a reader gets them.
    pub(super) tables: SpectralTables,
}

/// Builds, stores and measures them, where the run asks for them.
pub(super) fn spectral(job: &Job, planned: &Planned, clock: &mut Clock) -> Step<Option<Spectral>> {
    if !asked::is_spectral(job.config, job.specimen) {
        return Ok(None);
    }
    let settings = SpectralInput::new(planned.input.optics, planned.input.tables);
    let input = settings.of(&planned.input);
    let stopwatch = Stopwatch::start();
    let (plan, built) = clock.stage(Stage::BuildSpectral, || {
        let plan = plan(&input)?;
        let built = build_spectral_planned(&input, &plan, &|_| ())?;
        Ok((plan, built))
    })?;
    let time = stopwatch.read(Stage::BuildSpectral, None);
    let (stored, tables, stored_bytes) = clock.stage(Stage::StoreSpectral, || {
        let stored = built.write(&job.folder, &input, &settings)?;
        let tables = read_spectral(&job.folder, &stored, planned.input.optics.front_factor())?;
        let size = |file: &str| files::size(&job.folder.join(file));
        let bytes = stored.files().map(size).sum::<Result<u64>>()?;
        Ok((stored, tables, bytes))
    })?;
    let errors = match job.config.report.reference {
        false => Vec::new(),
        true => clock.stage(Stage::MeasureSpectral, || {
            let places = Places::drawn(&tables, DIRECTIONS);
            let reference = evaluate(&input, &plan, tables.count, &places)?;
            Ok(rows(&places, &reference, &tables, &built.packed(&built.grey, &input, &settings)))
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
    Ok(Some(Spectral { files, result, tables }))
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
            wavelength_nm: wavelength_nm.clone(),
        })
        .collect()
}
