//! What a manifest's scenes need of a specimen's tables, and what is saved by leaving out the rest.
//!
//! A piece of pruning is a step from all directions to those that are asked for. Each can be taken back alone, which
//! gives its share of the work: predicted by the forecast, measured by building.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::config::{GpuCheck, RunConfig, Serve};
use super::known::Built;
use super::pictures::sharing::scenes_for;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::files;
use diffraction_build::ground::null_for_nan;
use diffraction_build::ground::spectrum::Illuminant;
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::tables::build::{self, BuildPlan, plan, plan_for, smooth};
use diffraction_build::tables::domain::{Domain, TexelSet};
use diffraction_build::tables::forecast::{Forecast, forecast_of};
use diffraction_build::tables::model::TablesConfig;
use diffraction_build::tables::plan::Grid;
use diffraction_build::tables::plan::lobe_radius;
use diffraction_build::tables::rounding;
use diffraction_render::scene::model::{Exposure, Scene};
use diffraction_render::scene::reach::reach;

/// The scenes that a specimen's tables must serve, or its shares of them; `None` where they serve every direction.
pub fn served_scenes(config: &RunConfig, specimen: &str) -> Option<Vec<Scene>> {
    let shown = scenes_for(&config.scenes, specimen);
    match &config.serve {
        Serve::All => None,
        Serve::Scenes => Some(shown),
        Serve::Named(names) => Some(shown.into_iter().filter(|scene| names.contains(&scene.name)).collect()),
    }
}

/// The scenes that are pictured with a specimen's tables: those they serve.
pub fn pictured_scenes(config: &RunConfig, specimen: &str) -> Vec<Scene> {
    served_scenes(config, specimen).unwrap_or_else(|| scenes_for(&config.scenes, specimen))
}

/// What is asked of a specimen's tables: the tolerance of the scene that asks for most where they serve scenes.
pub fn tables_for(config: &RunConfig, specimen: &str) -> TablesConfig {
    let tolerance = |scene: Scene| scene.tolerance.unwrap_or(config.tables.tolerance);
    let strictest =
        served_scenes(config, specimen).and_then(|scenes| scenes.into_iter().map(tolerance).reduce(f64::min));
    TablesConfig { tolerance: strictest.unwrap_or(config.tables.tolerance), ..config.tables.clone() }
}

/// Whether anything is asked of a specimen: always, unless tables serve scenes and none of them shows it.
pub fn is_asked_for(config: &RunConfig, specimen: &str) -> bool {
    served_scenes(config, specimen).is_none_or(|scenes| !scenes.is_empty())
}

/// Specimens, pictures and stages that nobody asks for, with the reason.
pub fn left_out(config: &RunConfig) -> Vec<String> {
    let mut rows = Vec::new();
    for specimen in config.specimens.iter().filter(|specimen| !is_asked_for(config, &specimen.name)) {
        rows.push(format!("the specimen {}: no scene that is served shows it", specimen.name));
    }
    if let Serve::Named(names) = &config.serve {
        for scene in config.scenes.iter().filter(|scene| !names.contains(&scene.name)) {
            rows.push(format!("the scene {}: tables.serve does not name it", scene.name));
        }
    }
    let stages = [
        (config.scenes.is_empty(), "pictures of scenes: the manifest has no [[scene]]"),
        (config.gpu == GpuCheck::Off, "the check on a GPU: gpu.check = \"off\""),
        (!config.report.reference, "reference pictures and measured errors: report.reference = false"),
        (!config.report.write, "report.html and report.json: report.write = false"),
    ];
    rows.extend(stages.into_iter().filter(|(absent, _)| *absent).map(|(_, row)| row.to_owned()));
    rows
}

/// What tables are made of: prepared scans, optics and settings.
#[derive(Debug, Clone, Copy)]
pub struct Source<'a> {
    /// Prepared heights, one per scan.
    pub fields: &'a [HeightField],
    /// The optics.
    pub optics: &'a OpticsConfig,
    /// What is asked of the tables.
    pub tables: &'a TablesConfig,
}

/// Everything that the scenes reach on the grid of a specimen's tables.
///
/// # Errors
/// A scene that cannot be rendered.
pub fn domain_of(source: &Source, scenes: &[&Scene]) -> Result<Domain> {
    let grid = build::grid(source.optics, source.tables);
    let parts = parts_of(grid, source.tables.memory_mib)?;
    let mut domain = Domain::new(grid);
    for scene in scenes {
        let reached = reach(scene, grid, parts)?;
        domain = domain.merge(&reached);
        domain.scenes.push(match scene.exposure {
            Exposure::Auto => TexelSet::reached(&reached),
            Exposure::Ev(_) => TexelSet(Vec::new()),
        });
    }
    Ok(smooth(domain, source.fields, source.optics, source.tables.tolerance))
}

/// Copies of a grid's domain that threads may fill at once; others hold what was found, light by light and scene by scene.
fn parts_of(grid: Grid, memory_mib: usize) -> Result<usize> {
    const OTHERS: usize = 3;
    let bytes = Domain::bytes(grid);
    let copies = ((memory_mib as u64) << 20) / bytes;
    match usize::try_from(copies).unwrap_or(usize::MAX).checked_sub(OTHERS) {
        Some(parts @ 1..) => Ok(parts.min(rayon::current_num_threads())),
        _ => Err(Error::limit(
            format!(
                "finding what the scenes reach on {0} x {0} texels needs {1} MiB, {memory_mib} MiB are allowed",
                grid.size,
                (bytes * (OTHERS as u64 + 1)) >> 20
            ),
            "lower tables.size or raise tables.memory_mib",
        )),
    }
}

/// A step that leaves something out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Pruning {
    /// Texels that no look-up reads.
    Texels,
    /// Depths that no direction at a texel has.
    Depths,
    /// Wavelengths that a radius in (u, v) does not need.
    Wavelengths,
    /// Wavelengths at which the lamp, a laser, does not shine.
    Spectrum,
    /// The coherent lobe where no direction lies in it.
    Lobe,
    /// Accuracy that none of the scenes asks for.
    Tolerance,
}

impl Pruning {
    /// Every step.
    pub const ALL: [Self; 6] =
        [Self::Texels, Self::Depths, Self::Wavelengths, Self::Spectrum, Self::Lobe, Self::Tolerance];

    /// What is left out, for people.
    pub fn what(self) -> &'static str {
        match self {
            Self::Texels => "texels that no look-up reads",
            Self::Depths => "depths that no direction has",
            Self::Wavelengths => "wavelengths beyond what a radius needs",
            Self::Spectrum => "wavelengths without light",
            Self::Lobe => "the coherent lobe",
            Self::Tolerance => "accuracy that no scene asks for",
        }
    }
}

/// The optics with one step taken back: as they are, unless it is the spectrum's, for which lines become daylight.
fn optics_without(step: Option<Pruning>, optics: &OpticsConfig) -> OpticsConfig {
    if step != Some(Pruning::Spectrum) || !is_laser(optics) {
        return optics.clone();
    }
    OpticsConfig { illuminant: Illuminant::D65, wavelength_nm: VISIBLE_NM, ..optics.clone() }
}

fn is_laser(optics: &OpticsConfig) -> bool {
    matches!(optics.illuminant, Illuminant::Lines(_))
}

/// The wavelengths that the eye's observer is tabulated for.
const VISIBLE_NM: [f64; 2] = [380.0, 780.0];

/// The plan for the scenes with one step taken back; with none, the plan itself.
///
/// # Errors
/// Those of planning.
pub fn plan_without(step: Option<Pruning>, source: &Source, domain: &Domain) -> Result<BuildPlan> {
    let domain = match step {
        Some(Pruning::Texels) => domain.with_all_texels(),
        Some(Pruning::Depths) => domain.with_all_depths(),
        _ => domain.clone(),
    };
    let mut plan = plan_for(source.fields, &optics_without(step, source.optics), source.tables, Some(domain))?;
    match step {
        Some(Pruning::Wavelengths) => plan.use_rim_wavelengths(),
        Some(Pruning::Lobe) => plan.lobe_seen = true,
        _ => {}
    }
    Ok(plan)
}

/// What a row of the budget compares with: tables for every direction, and for daylight where the lamp is a laser, or
/// those of the scenes with one step taken back. `whole` is what tables for every direction are asked for.
fn compared(
    step: Option<Pruning>,
    source: &Source,
    scenes: &[&Scene],
    domain: &Domain,
    whole: &TablesConfig,
) -> Result<(OpticsConfig, TablesConfig, BuildPlan)> {
    let asked = if matches!(step, None | Some(Pruning::Tolerance)) { whole } else { source.tables };
    // What is left out may be what would not fit.
    let tables = TablesConfig { memory_mib: MEMORY_COMPARED_MIB, ..asked.clone() };
    let optics = optics_without(step.or(Some(Pruning::Spectrum)), source.optics);
    let source = Source { tables: &tables, ..*source };
    let plan = match step {
        None => plan(source.fields, &optics, &tables)?,
        Some(Pruning::Tolerance) => plan_without(None, &source, &domain_of(&source, scenes)?)?,
        step => plan_without(step, &source, domain)?,
    };
    Ok((optics, tables, plan))
}

/// Memory that tables which are only compared with may take on paper: all there is.
const MEMORY_COMPARED_MIB: usize = 1 << 24;

/// What one thing left out saves.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BudgetRow {
    /// The step; `None` for all of them together.
    pub step: Option<Pruning>,
    /// What is left out.
    pub what: String,
    /// Why nobody misses it.
    pub why: String,
    /// Error bound that leaving it out adds, relative.
    pub error_bound: f64,
    /// What the tables would take with it.
    pub with_it: Cost,
    /// The same, measured; `None` where nothing was built.
    pub measured: Option<Cost>,
}

/// What tables take.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Cost {
    /// Texels times wavelengths times nodes in depth.
    pub node_samples: f64,
    /// Seconds to build.
    pub seconds: f64,
    /// Most bytes that building holds on the heap, its tables included, the scans not.
    #[serde(with = "null_for_nan")]
    pub memory_bytes: f64,
    /// Bytes of the table files before compression.
    pub stored_bytes: f64,
}

impl Cost {
    /// What tables took that were built.
    pub fn measured(built: &Built, stored_bytes: f64) -> Self {
        Self {
            node_samples: built.record.node_samples as f64,
            seconds: built.seconds,
            memory_bytes: built.memory_bytes.map_or(f64::NAN, |bytes| bytes as f64),
            stored_bytes,
        }
    }

    /// The predicted cost.
    pub fn predicted(forecast: &Forecast) -> Self {
        Self {
            node_samples: forecast.node_samples,
            seconds: forecast.seconds,
            memory_bytes: forecast.memory_bytes as f64,
            stored_bytes: forecast.stored_bytes as f64,
        }
    }
}

/// What serving certain scenes takes, and what each thing left out saves.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Budget {
    /// Names of the scenes served.
    pub scenes: Vec<String>,
    /// Share of the disc of (u, v) that is reached.
    pub reached_share: f64,
    /// What the served tables take.
    pub served: Cost,
    /// The same, measured.
    pub measured: Option<Cost>,
    /// All steps together, then each by itself.
    pub rows: Vec<BudgetRow>,
}

/// Predicts what the scenes need and what every step saves, compared with tables for every direction of which `whole`
/// is asked.
///
/// # Errors
/// Those of planning.
pub fn budget(source: &Source, scenes: &[&Scene], domain: &Domain, whole: &TablesConfig) -> Result<Budget> {
    let Source { fields, optics, tables } = *source;
    let threads = rayon::current_num_threads();
    let cost = |step| -> Result<Cost> {
        let (optics, tables, plan) = compared(step, source, scenes, domain, whole)?;
        Ok(Cost::predicted(&forecast_of(fields, &optics, &tables, &plan, threads)))
    };
    let served = plan_without(None, source, domain)?;
    let mut rows = vec![BudgetRow {
        step: None,
        what: "all of it".into(),
        why: if is_laser(optics) { "tables for every direction and wavelength" } else { "tables for every direction" }
            .into(),
        error_bound: build::RANGE_SHARE * tables.tolerance,
        with_it: cost(None)?,
        measured: None,
    }];
    for step in Pruning::ALL.into_iter().filter(|&step| saves(step, &served, source, whole)) {
        rows.push(BudgetRow {
            step: Some(step),
            what: step.what().into(),
            why: why(step, domain, &served, whole),
            error_bound: match step {
                Pruning::Texels | Pruning::Lobe | Pruning::Spectrum => 0.0,
                Pruning::Depths => build::RANGE_SHARE * tables.tolerance,
                Pruning::Wavelengths | Pruning::Tolerance => tables.tolerance,
            },
            with_it: cost(Some(step))?,
            measured: None,
        });
    }
    Ok(Budget {
        scenes: scenes.iter().map(|scene| scene.name.clone()).collect(),
        reached_share: share_of_disc(domain),
        served: Cost::predicted(&forecast_of(fields, optics, tables, &served, threads)),
        measured: None,
        rows,
    })
}

/// The budget of tables that have been built, with what they took. `savings` builds everything that was left out as well,
/// step by step, and measures it.
///
/// # Errors
/// Those of planning, building and the disk.
pub fn account(
    source: &Source,
    scenes: &[&Scene],
    domain: &Domain,
    whole: &TablesConfig,
    measured: Cost,
    savings: bool,
) -> Result<Budget> {
    let mut budget = budget(source, scenes, domain, whole)?;
    budget.measured = Some(measured);
    if savings {
        for row in &mut budget.rows {
            let (optics, tables, plan) = compared(row.step, source, scenes, domain, whole)?;
            // What would not fit stays a prediction.
            if row.with_it.memory_bytes <= (source.tables.memory_mib as f64) * f64::from(1 << 20) {
                row.measured = Some(measure(&Source { optics: &optics, tables: &tables, ..*source }, &plan)?);
            }
        }
    }
    Ok(budget)
}

/// Builds and stores tables for nothing but their cost.
///
/// # Errors
/// Those of building, and the disk's.
pub fn measure(source: &Source, plan: &BuildPlan) -> Result<Cost> {
    let built = Built::measured(source, plan, &|_| ())?;
    let folder = tempfile::tempdir().map_err(|e| Error::disk(Path::new("."), "create a temporary folder", e))?;
    rounding::choose(&built.set, source.tables.storage, source.tables.tolerance, lobe_radius(source.optics))
        .write(folder.path())?;
    let stored_bytes = files::bytes_of(folder.path(), "exr")? as f64;
    Ok(Cost::measured(&built, stored_bytes))
}

fn share_of_disc(domain: &Domain) -> f64 {
    let [reached, all] = domain.disc_texels();
    reached as f64 / all.max(1) as f64
}

/// Whether there is anything for a step to leave out.
fn saves(step: Pruning, served: &BuildPlan, source: &Source, whole: &TablesConfig) -> bool {
    let optics = source.optics;
    match step {
        Pruning::Texels | Pruning::Depths => true,
        // Lines are all needed everywhere; only a spectrum is resolved as a radius asks.
        Pruning::Wavelengths => !is_laser(optics),
        Pruning::Spectrum => is_laser(optics),
        Pruning::Lobe => !served.lobe_seen,
        Pruning::Tolerance => whole.tolerance < source.tables.tolerance,
    }
}

fn why(step: Pruning, domain: &Domain, plan: &BuildPlan, whole: &TablesConfig) -> String {
    match step {
        Pruning::Texels => {
            let [reached, all] = domain.disc_texels();
            format!("the scenes read {reached} of {all} texels in the disc")
        }
        Pruning::Depths => {
            let mean = domain.iter().map(|(_, _, [low, high])| high - low).sum::<f64>() / domain.texels().max(1) as f64;
            format!("a texel is asked for {:.1} % of its depths on average", 100.0 * mean)
        }
        Pruning::Wavelengths => {
            let counts = plan.rings.iter().map(|ring| ring.quadrature.wavelengths_nm.len());
            let (few, many) = (counts.clone().min().unwrap_or(0), counts.max().unwrap_or(0));
            format!("{few} to {many} wavelengths by radius, {} at the rim", plan.rim.wavelengths_nm.len())
        }
        Pruning::Spectrum => "a laser shines in its lines alone; compared with daylight".into(),
        Pruning::Lobe => "no direction comes near the mirror's".into(),
        Pruning::Tolerance => format!("other tables are made for a tolerance of {}", whole.tolerance),
    }
}
