//! What a manifest's scenes need of a specimen's tables, and what is saved by leaving out the rest.
//!
//! A piece of pruning is a step from all directions to those that are asked for. Each can be taken back alone, which
//! gives its share of the work: predicted by the forecast, measured by building.

use std::path::Path;
use std::time::Instant;

use serde::{Deserialize, Serialize};

use super::config::{GpuCheck, RunConfig, Serve};
use super::results::null_for_nan;
use super::shared_scenes::scenes_for;
use super::usage;
use crate::ground::error::{Error, Result};
use crate::ground::files;
use crate::ground::spectrum::Illuminant;
use crate::height::HeightField;
use crate::optics::config::OpticsConfig;
use crate::scene::model::Scene;
use crate::scene::reach::reach;
use crate::tables::build::{self, BuildPlan, plan, plan_for, smooth};
use crate::tables::domain::Domain;
use crate::tables::forecast::{Forecast, forecast_of};
use crate::tables::model::TablesConfig;
use crate::tables::rounding;

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
    let mut domain = Domain::new(grid);
    for scene in scenes {
        domain = domain.merge(&reach(scene, grid)?);
    }
    Ok(smooth(domain, source.fields, source.optics, source.tables.tolerance))
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
}

impl Pruning {
    /// Every step.
    pub const ALL: [Self; 5] = [Self::Texels, Self::Depths, Self::Wavelengths, Self::Spectrum, Self::Lobe];

    /// What is left out, for people.
    pub fn what(self) -> &'static str {
        match self {
            Self::Texels => "texels that no look-up reads",
            Self::Depths => "depths that no direction has",
            Self::Wavelengths => "wavelengths beyond what a radius needs",
            Self::Spectrum => "wavelengths without light",
            Self::Lobe => "the coherent lobe",
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

/// The plan for every direction, and for daylight where the lamp is a laser.
fn plan_for_all(source: &Source) -> Result<BuildPlan> {
    plan(source.fields, &optics_without(Some(Pruning::Spectrum), source.optics), source.tables)
}

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
    /// Working memory in bytes; the largest resident memory of the process where it is measured.
    #[serde(with = "null_for_nan")]
    pub memory_bytes: f64,
    /// Bytes of the table files before compression.
    pub stored_bytes: f64,
}

impl Cost {
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

/// Predicts what the scenes need and what every step saves.
///
/// # Errors
/// Those of planning.
pub fn budget(source: &Source, scenes: &[&Scene], domain: &Domain) -> Result<Budget> {
    let Source { fields, optics, tables } = *source;
    let threads = rayon::current_num_threads();
    let cost = |step, plan: &BuildPlan| {
        Cost::predicted(&forecast_of(fields, &optics_without(step, optics), tables, plan, threads))
    };
    let served = plan_without(None, source, domain)?;
    let mut rows = vec![BudgetRow {
        step: None,
        what: "all of it".into(),
        why: if is_laser(optics) { "tables for every direction and wavelength" } else { "tables for every direction" }
            .into(),
        error_bound: build::RANGE_SHARE * tables.tolerance,
        with_it: cost(Some(Pruning::Spectrum), &plan_for_all(source)?),
        measured: None,
    }];
    for step in Pruning::ALL.into_iter().filter(|&step| saves(step, &served, optics)) {
        rows.push(BudgetRow {
            step: Some(step),
            what: step.what().into(),
            why: why(step, domain, &served),
            error_bound: match step {
                Pruning::Texels | Pruning::Lobe | Pruning::Spectrum => 0.0,
                Pruning::Depths => build::RANGE_SHARE * tables.tolerance,
                Pruning::Wavelengths => tables.tolerance,
            },
            with_it: cost(Some(step), &plan_without(Some(step), source, domain)?),
            measured: None,
        });
    }
    Ok(Budget {
        scenes: scenes.iter().map(|scene| scene.name.clone()).collect(),
        reached_share: share_of_disc(domain),
        served: cost(None, &served),
        measured: None,
        rows,
    })
}

/// The budget of tables that have been built, with what they took. `savings` builds everything that was left out as
/// well, step by step, and measures it.
///
/// # Errors
/// Those of planning, building and the disk.
pub fn account(source: &Source, scenes: &[&Scene], domain: &Domain, measured: Cost, savings: bool) -> Result<Budget> {
    let mut budget = budget(source, scenes, domain)?;
    budget.measured = Some(measured);
    if savings {
        for row in &mut budget.rows {
            let (step, plan) = match row.step {
                None => (Some(Pruning::Spectrum), plan_for_all(source)?),
                step => (step, plan_without(step, source, domain)?),
            };
            let optics = optics_without(step, source.optics);
            row.measured = Some(measure(&Source { optics: &optics, ..*source }, &plan)?);
        }
    }
    Ok(budget)
}

/// Builds and stores tables for nothing but their cost.
///
/// # Errors
/// Those of building, and the disk's.
pub fn measure(source: &Source, plan: &BuildPlan) -> Result<Cost> {
    usage::restart();
    let started = Instant::now();
    let (set, record) = build::build_planned(source.fields, source.optics, source.tables, plan, &|_| ())?;
    let seconds = started.elapsed().as_secs_f64();
    let memory_bytes = usage::peak_bytes().map_or(f64::NAN, |bytes| bytes as f64);
    let folder = tempfile::tempdir().map_err(|e| Error::disk(Path::new("."), "create a temporary folder", e))?;
    rounding::choose(&set, source.tables.storage, source.tables.tolerance).write(folder.path())?;
    let stored_bytes = files::bytes_of(folder.path(), "exr")? as f64;
    Ok(Cost { node_samples: record.node_samples as f64, seconds, memory_bytes, stored_bytes })
}

fn share_of_disc(domain: &Domain) -> f64 {
    let [reached, all] = domain.disc_texels();
    reached as f64 / all.max(1) as f64
}

/// Whether there is anything for a step to leave out.
fn saves(step: Pruning, served: &BuildPlan, optics: &OpticsConfig) -> bool {
    match step {
        Pruning::Texels | Pruning::Depths => true,
        // Lines are all needed everywhere; only a spectrum is resolved as a radius asks.
        Pruning::Wavelengths => !is_laser(optics),
        Pruning::Spectrum => is_laser(optics),
        Pruning::Lobe => !served.lobe_seen,
    }
}

fn why(step: Pruning, domain: &Domain, plan: &BuildPlan) -> String {
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
    }
}
