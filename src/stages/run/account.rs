//! The one account of memory: what making a specimen holds, step by step, from plans alone. `plan` prints it, and `run` refuses and waits by it.

use super::memory::Memory;
use crate::stages::config::{GpuCheck, RunConfig};
use crate::stages::coverage::asked;
use diffraction_brdf::direction::{Vec3, from_angles_deg};
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::spectral::TABLES_PER_IMAGE;
use diffraction_build::optics::reference;
use diffraction_build::tables::forecast::{Forecast, forecast_of};
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Basis, TablesConfig};
use diffraction_build::tables::plan::{BuildPlan, plan};
use diffraction_build::tables::spectral::SpectralInput;
use diffraction_render::scene::model::Scene;

/// Bytes of the program itself, its threads, and what every run keeps.
const PROGRAM_BYTES: f64 = 14.0 * MIB;
/// A software driver's compiler, which runs on the processor and in its memory; a hardware driver takes about as much.
const DRIVER_BYTES: f64 = 75.0 * MIB;
/// What it compiles for the check besides.
const PIPELINES_BYTES: f64 = 45.0 * MIB;
const MIB: f64 = 1_048_576.0;

/// For each sample of the scan that is read and looked at: heights as they are and as prepared, and the transform that its statistics take.
const READ_BYTES: f64 = 66.0;
/// For each sample of all scans, from then on: its height.
const HEIGHT_BYTES: f64 = 8.0;
/// What steps hold besides what is counted: small arrays, buffers of threads, memory that the allocator keeps.
const BESIDES: f64 = 1.02;
/// Of a table set: its splines and all coarser levels.
const PICTURED_SETS: f64 = 1.0 + 1.0 / 3.0;
/// For each pair of directions of the reference pictures: the pair, what the cache knows of it, its value.
const PAIR_BYTES: f64 = 260.0;
/// A pixel of a picture: three numbers, drawn, scaled and written.
const PIXEL_BYTES: f64 = 40.0;
/// Bytes of a texel of a table as a texture, four halves, once for values and once for splines.
const TEXTURE_BYTES: f64 = 16.0;
/// Directions in degrees whose direct sum stands for those that are brightest.
const DIRECT_DEG: [[f64; 2]; 2] = [[20.0, 10.0], [45.0, 200.0]];

/// What is known of a specimen before it is made.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ToHold<'a> {
    /// Its scans, optics and settings.
    pub input: &'a BuildInput<'a>,
    /// Its tables of X, Y, Z; where spectral ones alone are stored, those are derived from them.
    pub tables: &'a Forecast,
    /// Its spectral tables.
    pub spectral: Option<&'a Forecast>,
    /// What is pictured of it.
    pub scenes: &'a [Scene],
}

/// What making a specimen holds in bytes, beyond what the process holds anyway.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Account {
    /// Steps in their order.
    steps: Vec<(&'static str, f64)>,
    /// Most that building its tables takes.
    building_bytes: u64,
}

/// Bytes that the process holds whatever it makes.
pub(crate) fn program_bytes(config: &RunConfig) -> u64 {
    let driver = if config.gpu == GpuCheck::Off { 0.0 } else { DRIVER_BYTES };
    (PROGRAM_BYTES + driver) as u64
}

/// Whole MiB, rounded up.
pub(crate) fn mib(bytes: u64) -> u64 {
    bytes.div_ceil(1 << 20)
}

/// Bytes of the process while so many specimens are made at once: those that take most, as far as they are let.
pub(crate) fn at_once_bytes(config: &RunConfig, mut each: Vec<u64>, at_once: usize) -> u64 {
    each.sort_unstable_by(|a, b| b.cmp(a));
    let together: u64 = each.iter().take(at_once).sum();
    let most = each.first().copied().unwrap_or(0);
    let allowed = Memory::allowed_bytes(config).saturating_sub(program_bytes(config));
    program_bytes(config) + together.min(allowed.max(most))
}

/// The forecast of a specimen's spectral tables as they are built first, where there will be any.
///
/// # Errors
/// Those of planning, and of a source that spectral tables cannot hold where nothing else is asked for.
pub(crate) fn spectral_forecast(
    config: &RunConfig,
    input: &BuildInput,
    asked: &TablesConfig,
    threads: usize,
) -> Result<Option<Forecast>> {
    let obstacle = asked::spectral_obstacle(config, input.optics)?;
    if !config.hold.spectral || obstacle.is_some() {
        return Ok(None);
    }
    let whole = SpectralInput::new(input.optics, asked);
    let settings = whole.on_fewer_texels(asked).unwrap_or(whole);
    let input = settings.of(input);
    Ok(Some(forecast_of(&input, &plan(&input)?, threads)))
}

/// The account of a specimen whose tables are planned, as `run` holds it.
///
/// # Errors
/// As [`spectral_forecast`], and those of [`account`].
pub(super) fn account_of(
    config: &RunConfig,
    input: &BuildInput,
    plan: &BuildPlan,
    asked: &TablesConfig,
    scenes: &[Scene],
) -> Result<Account> {
    let threads = rayon::current_num_threads();
    let spectral = spectral_forecast(config, input, asked, threads)?;
    let tables = forecast_of(input, plan, threads);
    account(config, &ToHold { input, tables: &tables, spectral: spectral.as_ref(), scenes })
}

/// What a specimen holds.
///
/// # Errors
/// A scan too small for its window.
pub(crate) fn account(config: &RunConfig, known: &ToHold) -> Result<Account> {
    let ToHold { input, tables, spectral, scenes } = *known;
    let has_reference = config.report.reference;
    let counts = input.fields.iter().map(|field| field.heights_nm.len() as f64);
    let heights = HEIGHT_BYTES * counts.clone().sum::<f64>();
    let largest = counts.fold(0.0, f64::max);
    // The published series is built another way, which no forecast knows: as much as it may take.
    let built_bytes = match input.tables.basis {
        Basis::Chebyshev => tables.memory_bytes as f64,
        Basis::Taylor => (input.tables.memory_mib as f64) * MIB,
    };
    let s = spectral.map_or(0.0, spectral_set);
    let derived = if config.hold.xyz { None } else { spectral.map(|spectral| 3.0 * spectral_numbers(spectral)) };
    let t = derived.unwrap_or(tables.tables as f64 * tables.table_bytes as f64);
    // Those before rounding stay where errors are told by cause.
    let kept = if has_reference { 2.0 } else { 1.0 } * t;
    let mut steps = vec![("reading scans", heights - HEIGHT_BYTES * largest + READ_BYTES * largest)];
    // What deriving leaves behind: sums of a table set in parts too small for pages of their own.
    let left = if derived.is_some() { t } else { 0.0 };
    let mut add = |what, bytes: f64| steps.push((what, heights + bytes));
    if derived.is_none() {
        add("tables", built_bytes);
        add("storing tables", 3.0 * t);
    }
    let held = if derived.is_none() { kept } else { 0.0 };
    if let Some(spectral) = spectral {
        add("spectral tables", held + s + spectral.memory_bytes as f64);
        add("storing spectral tables", held + 3.0 * s);
        if has_reference {
            add("spectral errors", held + 3.0 * s + spectral.transforms_bytes as f64);
        }
    }
    let of_spectral = if derived.is_some() && has_reference { 2.0 * s } else { s };
    let held = kept + of_spectral + left;
    let pixels: f64 = scenes.iter().map(|scene| (scene.size_px * scene.size_px) as f64).sum();
    if !scenes.is_empty() {
        add("pictures", held + PICTURED_SETS * t + PIXEL_BYTES * pixels);
    }
    if has_reference {
        let pairs = PAIR_BYTES * pixels.min(picture_pairs(scenes));
        add("the reference", held + tables.transforms_bytes as f64 + PIXEL_BYTES * pixels + pairs);
        add("errors", held + PIXEL_BYTES * pixels + pairs + t.max(direct_bytes(input)?));
    }
    if config.gpu != GpuCheck::Off && !scenes.is_empty() {
        let numbers = tables.tables as f64 * tables.table_bytes as f64 / 12.0;
        let textures = TEXTURE_BYTES * (numbers + spectral.map_or(0.0, spectral_numbers) / 12.0);
        steps.push(("the check on the GPU", 2.0 * t + s + textures + PIXEL_BYTES * pixels + PIPELINES_BYTES));
    }
    let building = spectral.map_or(0, |spectral| spectral.memory_bytes);
    let building_bytes = if derived.is_none() { building.max(built_bytes as u64) } else { building };
    let besides = |(what, bytes)| (what, BESIDES * bytes);
    Ok(Account { steps: steps.into_iter().map(besides).collect(), building_bytes })
}

/// Bytes of the numbers of a spectral table set, without what fills up its images.
fn spectral_numbers(forecast: &Forecast) -> f64 {
    forecast.tables as f64 * forecast.table_bytes as f64
}

/// Bytes of a spectral table set, whose tables stand together in images.
fn spectral_set(forecast: &Forecast) -> f64 {
    forecast.tables.next_multiple_of(TABLES_PER_IMAGE) as f64 * forecast.table_bytes as f64
}

/// Most pairs of directions of the reference pictures.
fn picture_pairs(scenes: &[Scene]) -> f64 {
    (scenes.len() * crate::stages::pictures::scenes::REFERENCE_SAMPLES_MAX) as f64
}

/// What the direct sum holds, of as many pairs as are summed at once.
fn direct_bytes(input: &BuildInput) -> Result<f64> {
    let pairs: Vec<(Vec3, Vec3)> =
        DIRECT_DEG.iter().map(|[theta, phi]| ([0.0, 0.0, 1.0], from_angles_deg(*theta, *phi))).collect();
    let at_once = rayon::current_num_threads().min(pairs.len());
    Ok((at_once * reference::held_bytes(input.fields, input.optics, &pairs)?) as f64)
}

impl Account {
    /// Most bytes at once, and in which step.
    pub(crate) fn most(&self) -> (&'static str, u64) {
        let most = self.steps.iter().copied().max_by(|a, b| a.1.total_cmp(&b.1));
        most.map_or(("nothing", 0), |(what, bytes)| (what, bytes as u64))
    }

    /// Refuses what does not fit, before any of it is computed: building into `tables.memory_mib`, and the whole, the program with it, into
    /// `allowed` bytes.
    ///
    /// # Errors
    /// `Error::Limit` with the step, what it takes, what is allowed, and what to change.
    pub(crate) fn check(&self, config: &RunConfig, allowed: u64) -> Result<()> {
        let allowed_mib = config.tables.memory_mib as u64;
        if mib(self.building_bytes) > allowed_mib {
            return Err(Error::limit(
                format!("building its tables takes {} MiB, {allowed_mib} MiB are allowed", mib(self.building_bytes)),
                "lower tables.size, raise tables.tolerance, or raise tables.memory_mib",
            ));
        }
        let (step, bytes) = self.most();
        let whole = program_bytes(config) + bytes;
        if whole <= allowed {
            return Ok(());
        }
        let (whole, allowed) = (mib(whole), allowed >> 20);
        let (have, more) = match config.memory_bytes {
            Some(_) => (format!("--memory allows {allowed} MiB"), "raise --memory"),
            None => (format!("{allowed} MiB of this machine's memory are free"), "make it where there is more memory"),
        };
        Err(Error::limit(
            format!("making it takes {whole} MiB, most of it for {step}, and {have}"),
            format!("lower tables.size, crop the scan, or {more}"),
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_takes_most_counts_and_no_more_is_held_at_once_than_allowed() {
        let account = Account { steps: vec![("a", 3.0), ("b", 7.0), ("c", 5.0)], building_bytes: 4 };
        assert_eq!(account.most(), ("b", 7));
        assert_eq!((mib(0), mib(1), mib(1 << 20), mib((1 << 20) + 1)), (0, 1, 1, 2));
    }
}
