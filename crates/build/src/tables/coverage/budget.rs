//! What restricting tables to scenes saves.
//!
//! A piece of pruning is a step from all directions to those that are asked for. Each can be taken back alone, which
//! gives its share of the work: predicted by the forecast, measured by building.

use serde::{Deserialize, Serialize};

use super::find::{LookUps, cover};
use super::ranges::Coverage;
use super::shares::RANGE_SHARES;
use crate::ground::null_for_nan;
use crate::optics::config::OpticsConfig;
use crate::tables::forecast::{Forecast, forecast_of};
use crate::tables::input::BuildInput;
use crate::tables::model::TablesConfig;
use crate::tables::plan::{BuildPlan, Scope, plan, plan_within};
use diffraction_brdf::error::Result;
use diffraction_brdf::spectrum::Illuminant;

/// Share of the tolerance that ranges of `|w|` of their own take.
const RANGE_SHARE: f64 = RANGE_SHARES[0] + RANGE_SHARES[1];

/// A step that leaves something out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Pruning {
    /// Texels that no look-up reads.
    Texels,
    /// Values of `|w|` that no direction at a texel has.
    #[serde(rename = "depths")]
    Ranges,
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
        [Self::Texels, Self::Ranges, Self::Wavelengths, Self::Spectrum, Self::Lobe, Self::Tolerance];

    /// What is left out, for people.
    pub fn what(self) -> &'static str {
        match self {
            Self::Texels => "texels that no look-up reads",
            Self::Ranges => "|w| that no direction has",
            Self::Wavelengths => "wavelengths beyond what a radius needs",
            Self::Spectrum => "wavelengths without light",
            Self::Lobe => "the coherent lobe",
            Self::Tolerance => "accuracy that no scene asks for",
        }
    }
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
    /// Texels times wavelengths times nodes in `w`.
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

/// What tables restricted to certain scenes take, and what each thing left out saves.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Budget {
    /// Names of the scenes.
    pub scenes: Vec<String>,
    /// Share of the disc of (u, v) that is covered.
    pub reached_share: f64,
    /// What the tables take.
    #[serde(rename = "served")]
    pub restricted: Cost,
    /// The same, measured.
    pub measured: Option<Cost>,
    /// All steps together, then each by itself.
    pub rows: Vec<BudgetRow>,
}

/// Builds and stores tables for nothing but their cost.
pub type Measure<'a> = &'a dyn Fn(&BuildInput, &BuildPlan) -> Result<Cost>;

/// Predicts what the scenes need and what every step saves, compared with tables for every direction of which `whole`
/// is asked.
///
/// # Errors
/// Those of planning.
pub fn budget(
    input: &BuildInput,
    scenes: &[&dyn LookUps],
    coverage: &Coverage,
    whole: &TablesConfig,
) -> Result<Budget> {
    let (restricted, threads) = (plan_without(None, input, coverage)?, rayon::current_num_threads());
    let taken_back = |step: Option<Pruning>| TakenBack { step, input, scenes, coverage, whole };
    let with_it =
        |step| taken_back(step).with_plan(|input, plan| Ok(Cost::predicted(&forecast_of(input, plan, threads))));
    let mut rows = vec![BudgetRow {
        step: None,
        what: "all of it".into(),
        why: match is_laser(input.optics) {
            true => "tables for every direction and wavelength".into(),
            false => "tables for every direction".into(),
        },
        error_bound: RANGE_SHARE * input.tables.tolerance,
        with_it: with_it(None)?,
        measured: None,
    }];
    for step in Pruning::ALL.into_iter().filter(|&step| saves(step, &restricted, input, whole)) {
        rows.push(BudgetRow {
            step: Some(step),
            what: step.what().into(),
            why: why(step, coverage, &restricted, whole),
            error_bound: match step {
                Pruning::Texels | Pruning::Lobe | Pruning::Spectrum => 0.0,
                Pruning::Ranges => RANGE_SHARE * input.tables.tolerance,
                Pruning::Wavelengths | Pruning::Tolerance => input.tables.tolerance,
            },
            with_it: with_it(Some(step))?,
            measured: None,
        });
    }
    Ok(Budget {
        scenes: scenes.iter().map(|scene| scene.name().to_owned()).collect(),
        reached_share: share_of_disc(coverage),
        restricted: Cost::predicted(&forecast_of(input, &restricted, threads)),
        measured: None,
        rows,
    })
}

/// The budget of tables that have been built, with what they took. With `measure`, everything that was left out is built as
/// well, step by step, and measured.
///
/// # Errors
/// Those of planning and of measuring.
pub fn account(
    input: &BuildInput,
    scenes: &[&dyn LookUps],
    coverage: &Coverage,
    whole: &TablesConfig,
    taken: Cost,
    measure: Option<Measure>,
) -> Result<Budget> {
    let budget = budget(input, scenes, coverage, whole)?;
    let measured = |row: BudgetRow| -> Result<BudgetRow> {
        // What would not fit stays a prediction.
        let fits = row.with_it.memory_bytes <= (input.tables.memory_mib as f64) * f64::from(1 << 20);
        let taken_back = TakenBack { step: row.step, input, scenes, coverage, whole };
        let measured = measure.filter(|_| fits).map(|measure| taken_back.with_plan(measure)).transpose()?;
        Ok(BudgetRow { measured, ..row })
    };
    let rows = budget.rows.into_iter().map(measured).collect::<Result<_>>()?;
    Ok(Budget { measured: Some(taken), rows, ..budget })
}

/// The plan for a coverage with one step taken back; with none, the plan itself.
fn plan_without(step: Option<Pruning>, input: &BuildInput, coverage: &Coverage) -> Result<BuildPlan> {
    let coverage = match step {
        Some(Pruning::Texels) => coverage.with_all_texels(),
        Some(Pruning::Ranges) => coverage.with_whole_ranges(),
        _ => coverage.clone(),
    };
    let scope = Scope {
        coverage: Some(coverage),
        rim_wavelengths: step == Some(Pruning::Wavelengths),
        keeps_lobe: step == Some(Pruning::Lobe),
    };
    plan_within(input, scope)
}

/// Memory that tables which are only compared with may take on paper: all there is.
const MEMORY_COMPARED_MIB: usize = 1 << 24;

/// What a row of the budget compares with: tables for every direction, and for daylight where the lamp is a laser, or
/// those of the scenes with one step taken back.
struct TakenBack<'a> {
    step: Option<Pruning>,
    input: &'a BuildInput<'a>,
    scenes: &'a [&'a dyn LookUps],
    coverage: &'a Coverage,
    /// What tables for every direction are asked for.
    whole: &'a TablesConfig,
}

impl TakenBack<'_> {
    fn with_plan<T>(&self, work: impl Fn(&BuildInput, &BuildPlan) -> Result<T>) -> Result<T> {
        let Self { step, input, scenes, coverage, whole } = *self;
        let asked = if matches!(step, None | Some(Pruning::Tolerance)) { whole } else { input.tables };
        // What is left out may be what would not fit.
        let tables = TablesConfig { memory_mib: MEMORY_COMPARED_MIB, ..asked.clone() };
        let optics = match step {
            None | Some(Pruning::Spectrum) => under_daylight(input.optics),
            Some(_) => input.optics.clone(),
        };
        let input = input.with(&optics, &tables);
        let plan = match step {
            None => plan(&input)?,
            Some(Pruning::Tolerance) => plan_without(None, &input, &cover(&input, scenes)?)?,
            step => plan_without(step, &input, coverage)?,
        };
        work(&input, &plan)
    }
}

/// The wavelengths that the eye's observer is tabulated for.
const VISIBLE_NM: [f64; 2] = [380.0, 780.0];

/// The optics with daylight in place of a laser's lines.
fn under_daylight(optics: &OpticsConfig) -> OpticsConfig {
    if !is_laser(optics) {
        return optics.clone();
    }
    // Whether the material is known at all of them changes no number of texels, wavelengths or nodes.
    OpticsConfig { illuminant: Illuminant::D65, wavelength_nm: VISIBLE_NM, dispersion: None, ..optics.clone() }
}

fn is_laser(optics: &OpticsConfig) -> bool {
    matches!(optics.illuminant, Illuminant::Lines(_))
}

fn share_of_disc(coverage: &Coverage) -> f64 {
    let [covered, all] = coverage.disc_texels();
    covered as f64 / all.max(1) as f64
}

/// Whether there is anything for a step to leave out.
fn saves(step: Pruning, restricted: &BuildPlan, input: &BuildInput, whole: &TablesConfig) -> bool {
    match step {
        Pruning::Texels | Pruning::Ranges => true,
        // Lines are all needed everywhere; only a spectrum is resolved as a radius asks.
        Pruning::Wavelengths => !is_laser(input.optics),
        Pruning::Spectrum => is_laser(input.optics),
        Pruning::Lobe => !restricted.lobe_seen,
        Pruning::Tolerance => whole.tolerance < input.tables.tolerance,
    }
}

fn why(step: Pruning, coverage: &Coverage, plan: &BuildPlan, whole: &TablesConfig) -> String {
    match step {
        Pruning::Texels => {
            let [covered, all] = coverage.disc_texels();
            format!("the scenes read {covered} of {all} texels in the disc")
        }
        Pruning::Ranges => {
            let lengths = coverage.iter().map(|(_, _, [low, high])| high - low).sum::<f64>();
            let mean = lengths / coverage.count().max(1) as f64;
            format!("a texel is asked for {:.1} % of its |w| on average", 100.0 * mean)
        }
        Pruning::Wavelengths => {
            let counts = plan.rings.iter().map(|ring| ring.wavelengths());
            let (few, many) = (counts.clone().min().unwrap_or(0), counts.max().unwrap_or(0));
            format!("{few} to {many} wavelengths by radius, {} at the rim", plan.rim.wavelengths_nm.len())
        }
        Pruning::Spectrum => "a laser shines in its lines alone; compared with daylight".into(),
        Pruning::Lobe => "no direction comes near the mirror's".into(),
        Pruning::Tolerance => format!("other tables are made for a tolerance of {}", whole.tolerance),
    }
}
