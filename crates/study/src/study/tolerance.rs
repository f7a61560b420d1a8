//! Whether a tolerance is kept: tables with automatic settings, measured afterwards, and what they cost.
//!
//! Unlike the comparison of methods this takes the specimen's own light and windows. The reference is
//! `optics::spectral`. Where the grid resolves the light's lobes, a table promises its tolerance in every direction
//! under cubic look-ups; where it does not, each texel promises a mean over its own square, and only that.

use serde::{Deserialize, Serialize};

use super::batch::{PackedTables, stored};
use super::config::{StudyConfig, StudySpecimen};
use super::texels::Texels;
use diffraction_brdf::error::Result;
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_build::accuracy::directions::ErrorDirections;
use diffraction_build::accuracy::directions::Group;
use diffraction_build::accuracy::reference;
use diffraction_build::accuracy::rows::{Cause, ErrorRow, error_rows};
use diffraction_build::ground::metrics::{ErrorQuantiles, relative_error_quantiles};
use diffraction_build::ground::sampling::{Region, direction_pairs};
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::tables::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Basis, BuildRecord, Prefilter, Rounding, Storage, TableSet, TablesConfig};
use diffraction_build::tables::plan::{self, BuildPlan};
use diffraction_build::tables::resolution::{lobe_radius, resolving_size};
use diffraction_build::tables::rounding::{Chosen, choose};

/// Directions drawn, of which the first that meet usable texels are taken.
const DRAWN: usize = 8_192;

/// What a tolerance's promise came to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kept {
    /// In 95 % of directions, with cubic look-ups.
    Everywhere,
    /// In 95 % of texels, which are point samples; between them the grid adds more.
    OnTexels,
    /// In 95 % of texels, as means over a texel: the grid does not resolve the light's lobes.
    TexelMeans,
    /// Not kept.
    Missed,
}

/// One tolerance asked of one specimen.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ToleranceRow {
    /// The relative error asked for.
    pub tolerance: f64,
    /// What was chosen for it: halves, or floats where these are too coarse.
    pub storage: Storage,
    /// What storing does to the values.
    pub rounding: Rounding,
    /// Texels along u and v, and as many as the tolerance asks for.
    pub size: [usize; 2],
    /// Side of the square that a texel averages over; 0 for point samples.
    pub prefilter_width: f64,
    /// Tables.
    pub tables: usize,
    /// What was chosen while building.
    pub record: BuildRecord,
    /// Seconds to build.
    pub build_s: f64,
    /// Bytes a renderer holds.
    pub stored_bytes: u64,
    /// Luminance in 1/sr up to which directions are left out.
    pub floor_per_sr: f64,
    /// 95th percentiles of the shares of basis, wavelength step and storage over the hemisphere.
    pub shares: [f64; 3],
    /// Everything but the grid: tables at texels against the reference, averaged as they are.
    pub on_texels: ErrorQuantiles,
    /// The whole error over the hemisphere with cubic look-ups.
    pub cubic: ErrorQuantiles,
    /// The same with linear look-ups.
    pub bilinear: ErrorQuantiles,
    /// The verdict.
    pub kept: Kept,
}

/// All tolerances on one specimen.
pub fn rows(specimen: &StudySpecimen, config: &StudyConfig, advance: &dyn Fn()) -> Result<Vec<ToleranceRow>> {
    let asked = config.tolerances.iter();
    asked
        .map(|&tolerance| {
            let found = row(specimen, &automatic(&specimen.optics, config, tolerance));
            advance();
            found
        })
        .collect()
}

/// The settings with which a tolerance is asked for: everything automatic, but tables no larger than `size_max`.
pub fn automatic(optics: &OpticsConfig, config: &StudyConfig, tolerance: f64) -> TablesConfig {
    TablesConfig {
        tolerance,
        size: Some(resolving_size(optics, tolerance).min(config.size_max)),
        storage: None,
        prefilter: Prefilter::Auto,
        ..super::methods::tables_config(config, Basis::Chebyshev)
    }
}

/// Builds and stores with these settings and measures against their tolerance.
///
/// # Errors
/// Those of building, and of the transforms.
pub fn row(specimen: &StudySpecimen, tables: &TablesConfig) -> Result<ToleranceRow> {
    let (fields, optics) = (&specimen.fields, &specimen.optics);
    let tolerance = tables.tolerance;
    let started = std::time::Instant::now();
    let (built, record) = build::build(&BuildInput::new(fields, optics, tables), &|_| ())?;
    let build_s = started.elapsed().as_secs_f64();
    let Chosen { set, storage, rounding } = choose(&built, tables.storage, tolerance, lobe_radius(optics));
    let read = stored(&set, storage);
    let plan = plan::plan(&BuildInput::new(fields, optics, tables))?;
    let directions = ErrorDirections::of_regions(&read);
    let floor_per_sr = directions.groups[0].floor_per_sr;
    let reference = reference::evaluate(fields, optics, &plan, built.tables.len(), directions, [])?;
    let rows = error_rows(&reference, &read, &built);
    let found = |cause: Cause| over_hemisphere(&rows, cause);
    let on_texels = on_texels(specimen, &plan, [&built, &read], floor_per_sr)?;
    let cubic = found(Cause::TotalCubic);
    let kept = match built.prefilter_width {
        _ if on_texels.count == 0 || on_texels.p95 > tolerance => Kept::Missed,
        width if width > 0.0 => Kept::TexelMeans,
        _ if cubic.p95 <= tolerance => Kept::Everywhere,
        _ => Kept::OnTexels,
    };
    Ok(ToleranceRow {
        tolerance,
        storage,
        rounding,
        size: [built.size(), resolving_size(optics, tolerance)],
        prefilter_width: built.prefilter_width,
        tables: built.tables.len(),
        record,
        build_s,
        stored_bytes: PackedTables::new(&built, built.tables.len(), storage).bytes(),
        floor_per_sr,
        shares: [Cause::Basis, Cause::WavelengthStep, Cause::Storage].map(|cause| found(cause).p95),
        on_texels,
        cubic,
        bilinear: found(Cause::Total),
        kept,
    })
}

/// The quantiles of a cause's errors over the hemisphere.
fn over_hemisphere(rows: &[ErrorRow], cause: Cause) -> ErrorQuantiles {
    let row = rows.iter().find(|row| row.cause == cause && row.group == Group::Region(Region::Hemisphere));
    row.map_or(ErrorQuantiles::default(), |row| ErrorQuantiles {
        p50: row.p50,
        p95: row.p95,
        p99: row.p99,
        worst: row.worst,
        count: row.directions,
    })
}

/// Errors of the tables as read back, at texels of the tables as built and averaged as these are.
fn on_texels(
    specimen: &StudySpecimen,
    plan: &BuildPlan,
    [built, read]: [&TableSet; 2],
    floor_per_sr: f64,
) -> Result<ErrorQuantiles> {
    let optics = &specimen.optics;
    let texels = Texels::of(built, optics, plan.filter, &direction_pairs(Region::Hemisphere, DRAWN), floor_per_sr);
    let reference = texels.reference(&specimen.fields, optics, plan)?;
    let found = texels.centres.iter().map(|&(wi, wo)| brdf_xyz(read, Interpolation::Cubic, wi, wo)[1]);
    Ok(relative_error_quantiles(&reference, &found.collect::<Vec<_>>(), floor_per_sr))
}
