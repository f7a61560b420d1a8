//! `plan`: what a run would compute, what it leaves out and why, and what it would take.

use std::path::PathBuf;

use serde::Serialize;

use crate::cli::options::{Global, MANIFEST};
use crate::cli::output::{self, Outcome, bytes_in_words};
use crate::error::Result;
use crate::manifest::{self, convert::run_config};
use crate::stages::cache::store;
use crate::stages::config::{RunConfig, SpecimenConfig};
use crate::stages::coverage::{asked, savings};
use crate::stages::ingest::ingest;
use crate::stages::measured;
use crate::stages::pictures::scenes::reference_samples;
use crate::stages::run::account::{ToHold, account, at_once_bytes, mib, program_bytes, spectral_forecast};
use crate::stages::run::memory::Memory;
use crate::stages::run::outlook::outlook;
use crate::stages::run::reference_forecast::{ReferenceForecast, reference_forecast};
use crate::stages::run::warnings::{scan_warnings, sigma_taken};
use crate::stages::run::whole_forecast::{Known, Part, mean_of, shared_parts, specimen_parts, summed};
use diffraction_brdf::front_factor::Factor;
use diffraction_brdf::material::Material;
use diffraction_build::ground::speed::slowdown;
use diffraction_build::tables::coverage::budget::{Budget, Cost};
use diffraction_build::tables::forecast::{Forecast, forecast_of};
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::look_ups::{LookUp, LookUpForecast, tried_first};
use diffraction_build::tables::model::{Storage, TablesConfig};
use diffraction_build::tables::plan::{self, automatic_size};
use diffraction_render::scene::model::Scene;
use diffraction_render::scene::samples::ShadingSamples;

/// Arguments of `plan`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas plan snakes.toml --json")]
pub(crate) struct PlanArgs {
    /// What to plan for
    #[arg(default_value = MANIFEST)]
    pub manifest: PathBuf,
    /// Print the plan as JSON
    #[arg(long)]
    pub json: bool,
    /// MiB of memory that the run may take, as `run --memory`: what does not fit is told
    #[arg(long, value_name = "MIB")]
    pub memory: Option<u64>,
}

/// The plan of a run.
#[derive(Debug, Serialize)]
struct Plan {
    atlas: String,
    threads: usize,
    /// How many times as long as on the machine of the forecasts' constants the same work takes here and now.
    slowdown: f64,
    /// Predicted seconds of the whole run, without what is there already: the mean of the two below.
    seconds: f64,
    /// The same where the texels tried first suffice for every specimen, and where they do for none.
    seconds_range: [f64; 2],
    /// What they are spent on, the longest first.
    parts: Vec<Part>,
    /// Predicted memory of the process in MiB, with as many specimens made at once as there are threads and as the run may hold.
    memory_mib: u64,
    /// Specimens that are there already: they take next to nothing.
    unchanged: Vec<String>,
    /// Entries and bytes of the cache, which may save more.
    cache: [u64; 2],
    /// The relative error asked for.
    tolerance: f64,
    specimens: Vec<SpecimenPlan>,
    /// What no scene, file or stage of this manifest asks for.
    assumed: Vec<String>,
    left_out: Vec<String>,
}

/// One specimen: its forecast, or why it would fail.
#[derive(Debug, Serialize)]
struct SpecimenPlan {
    name: String,
    forecast: Option<Forecast>,
    /// What making it takes as one piece of work, for whoever hands such pieces to machines.
    unit: Option<UnitPlan>,
    /// Texels a side that its tables have where the ones tried first do not suffice; `None` where the size is known.
    size_max: Option<usize>,
    /// Parts of making it where the texels tried first suffice, and where they do not.
    #[serde(skip)]
    parts: [Vec<Part>; 2],
    /// Whether something is wrong with its scans.
    #[serde(skip)]
    has_fault: bool,
    /// What evaluating its reference will take, where that is asked for.
    reference: Option<ReferenceForecast>,
    /// What its tables leave out, where they are restricted to scenes.
    budget: Option<Budget>,
    failure: Option<String>,
    /// What sigma was taken, where it follows the scans.
    #[serde(skip_serializing_if = "Option::is_none")]
    coherence: Option<String>,
    /// What to know of its scans before running, in whole sentences.
    warnings: Vec<String>,
}

/// A specimen as a piece of work.
#[derive(Debug, Serialize)]
struct UnitPlan {
    /// Predicted seconds with all threads.
    seconds: f64,
    /// Predicted memory of a process that makes it alone, in MiB: most where the texels tried first do not suffice.
    memory_mib: u64,
    /// What of it is the specimen's own, in bytes.
    #[serde(skip)]
    own_bytes: u64,
    /// The step that takes it.
    memory_step: &'static str,
}

/// Reads the scans, plans, and prints; no table is computed.
///
/// # Errors
/// A wrong manifest. A specimen that would fail is part of the plan, and of the exit status.
pub(crate) fn run(args: &PlanArgs, _global: &Global) -> Result<Outcome> {
    let (manifest, text) = manifest::load(&args.manifest)?;
    let mut config = run_config(manifest, text);
    config.memory_bytes = args.memory.map(|mib| mib << 20);
    let threads = rayon::current_num_threads();
    let slowdown = slowdown();
    let asked_for = config.specimens.iter().filter(|specimen| asked::is_asked_for(&config, &specimen.name));
    let mut pictures = Pictures::default();
    let specimens = asked_for.map(|specimen| {
        plan_specimen(&config, specimen, [threads as f64, slowdown], &mut pictures).unwrap_or_else(|error| {
            SpecimenPlan {
                name: specimen.name.clone(),
                forecast: None,
                unit: None,
                size_max: None,
                parts: Default::default(),
                has_fault: false,
                reference: None,
                budget: None,
                failure: Some(error.to_string()),
                coherence: None,
                warnings: Vec::new(),
            }
        })
    });
    let specimens: Vec<SpecimenPlan> = specimens.collect();
    let unchanged: Vec<String> =
        outlook(&config)?.into_iter().filter(|outlook| !outlook.make).map(|outlook| outlook.name).collect();
    let made = || specimens.iter().filter(|specimen| !unchanged.contains(&specimen.name));
    let shared = if made().next().is_some() { shared_parts(&config, threads, slowdown) } else { Vec::new() };
    let [fewest, most] = [0, 1]
        .map(|which| summed(made().flat_map(|specimen| specimen.parts[which].clone()).chain(shared.iter().copied())));
    let parts = mean_of(&fewest, &most);
    let own = made().filter_map(|specimen| specimen.unit.as_ref()).map(|unit| unit.own_bytes).collect();
    let (entries, bytes) = store::size(&config.cache.folder)?;
    let plan = Plan {
        atlas: config.atlas_name.clone(),
        threads,
        slowdown,
        seconds: seconds_of(&parts),
        seconds_range: [seconds_of(&fewest), seconds_of(&most)],
        parts,
        memory_mib: mib(at_once_bytes(&config, own, threads)),
        unchanged,
        cache: [entries as u64, bytes],
        tolerance: config.tables.tolerance,
        specimens,
        assumed: asked::assumed(&config),
        left_out: asked::left_out(&config),
    };
    if args.json {
        output::print_json(&plan)?;
    } else {
        output::print(&plan.to_text())?;
    }
    let failures: Vec<String> = plan
        .specimens
        .iter()
        .filter_map(|s| s.failure.as_ref().map(|failure| format!("{}: {failure}", s.name)))
        .collect();
    Ok(if failures.is_empty() { Outcome::Done } else { Outcome::Failures(failures) })
}

fn seconds_of(parts: &[Part]) -> f64 {
    // An empty sum is -0.
    parts.iter().map(|part| part.seconds).fold(0.0, |sum, seconds| sum + seconds)
}

fn plan_specimen(
    config: &RunConfig,
    specimen: &SpecimenConfig,
    [threads, slowdown]: [f64; 2],
    pictures: &mut Pictures,
) -> Result<SpecimenPlan> {
    let threads = threads as usize;
    specimen.measured.as_ref().map(measured::read).transpose()?;
    let ingested = ingest(specimen)?;
    let asked = asked::tables_for(config, &specimen.name);
    // As a run does: on fewer texels first, and on more where they do not suffice.
    let may_try = config.cover.is_all() && config.hold.xyz;
    let fewer = tried_first(&ingested.optics, &asked).filter(|_| may_try);
    let size_max = fewer.map(|_| automatic_size(&ingested.optics, asked.tolerance));
    let tables = TablesConfig { size: fewer.or(asked.size), ..asked.clone() };
    let input = BuildInput::new(&ingested.fields, &ingested.optics, &tables);
    let (plan, budget) = match asked::restricted_to(config, &specimen.name) {
        None => (plan::plan(&input)?, None),
        Some(scenes) => {
            let scenes: Vec<&Scene> = scenes.iter().collect();
            let covered = savings::cover(&input, &scenes)?;
            let budget = savings::predict(&input, &scenes, &covered, &config.tables)?;
            (plan::plan_for(&input, Some(covered))?, Some(budget))
        }
    };
    let obstacle = asked::spectral_obstacle(config, &ingested.optics)?;
    let of_spectral = spectral_forecast(config, &input, &asked, threads)?;
    let of_xyz = forecast_of(&input, &plan, threads);
    let scenes = asked::pictured_scenes(config, &specimen.name);
    let to_hold = ToHold { input: &input, tables: &of_xyz, spectral: of_spectral.as_ref(), scenes: &scenes };
    let held = account(config, &to_hold)?;
    held.check(config, Memory::refused_from_bytes(config))?;
    let reference = match config.report.reference {
        false => None,
        true => {
            let tables = of_spectral.as_ref().filter(|_| !config.hold.xyz).unwrap_or(&of_xyz).tables;
            Some(reference_forecast(&input, &plan, tables, &pictures.of(&scenes)?, threads))
        }
    };
    let of_first = ingested.statistics.iter().take(1).flat_map(|statistics| statistics.warnings.clone());
    let of_files = ingested.provenance.iter().flat_map(|scan| scan.warnings.clone());
    let warnings = of_first.chain(of_files).chain(scan_warnings(&ingested, &ingested.optics)).chain(obstacle).collect();
    let samples: usize = ingested.fields.iter().map(|field| field.heights_nm.len()).sum();
    let at_most = match size_max {
        None => None,
        Some(size) => {
            let tables = TablesConfig { size: Some(size), ..tables.clone() };
            let input = input.with(&ingested.optics, &tables);
            Some(forecast_of(&input, &plan::plan(&input)?, threads))
        }
    };
    let (step, own_bytes) = match &at_most {
        None => held.most(),
        Some(tables) => account(config, &ToHold { tables, ..to_hold })?.most(),
    };
    let (forecast, spectral) = match (config.hold.xyz, of_spectral) {
        (false, Some(spectral)) => (spectral, None),
        (_, spectral) => (of_xyz, spectral),
    };
    let may_exceed = ingested.optics.material == Material::Ideal || ingested.optics.factor == Factor::Scalar;
    let spectral = spectral.as_ref();
    let fewest = Known { samples, tables: &forecast, tried: None, may_exceed, spectral, reference, scenes: &scenes };
    let most = at_most.as_ref().map_or(fewest, |tables| Known { tables, tried: Some(&forecast), ..fewest });
    let parts = [fewest, most].map(|known| specimen_parts(config, &known, threads, slowdown));
    let unit = UnitPlan {
        seconds: seconds_of(&mean_of(&parts[0], &parts[1])),
        memory_mib: mib(program_bytes(config) + own_bytes),
        own_bytes,
        memory_step: step,
    };
    Ok(SpecimenPlan {
        name: specimen.name.clone(),
        forecast: Some(forecast),
        unit: Some(unit),
        size_max,
        parts,
        has_fault: ingested.findings.iter().any(|findings| !findings.is_empty()),
        reference,
        budget,
        failure: None,
        coherence: sigma_taken(&ingested.optics),
        warnings,
    })
}

/// Seconds and transforms of a specimen from which on it is said to be far too expensive.
const EXPENSIVE_S: f64 = 60.0;
const EXPENSIVE_TRANSFORMS: usize = 60;

/// Seconds with as many digits as a prediction has.
fn in_seconds(seconds: f64) -> String {
    match seconds {
        _ if seconds < 10.0 => format!("{seconds:.1} s"),
        _ if seconds < 600.0 => format!("{seconds:.0} s"),
        _ => format!("{:.0} min", seconds / 60.0),
    }
}

/// Samples of the reference pictures: most scenes are the same for every specimen.
#[derive(Default)]
struct Pictures(Vec<(Scene, ShadingSamples)>);

impl Pictures {
    fn of(&mut self, scenes: &[Scene]) -> Result<Vec<&ShadingSamples>> {
        let mut places = Vec::new();
        for scene in scenes {
            let known = self.0.iter().position(|(known, _)| known == scene);
            places.push(known.unwrap_or(self.0.len()));
            if known.is_none() {
                self.0.push((scene.clone(), reference_samples(scene)?));
            }
        }
        Ok(places.into_iter().map(|place| &self.0[place].1).collect())
    }
}

impl Plan {
    /// Which sizes are guesses, since tables that were built decide.
    fn guesses_text(&self) -> String {
        let mut kinds: Vec<([usize; 2], Vec<&str>)> = Vec::new();
        for specimen in &self.specimens {
            let (Some(forecast), Some(most)) = (&specimen.forecast, specimen.size_max) else { continue };
            match kinds.iter_mut().find(|(sizes, _)| *sizes == [forecast.size, most]) {
                Some((_, names)) => names.push(&specimen.name),
                None => kinds.push(([forecast.size, most], vec![&specimen.name])),
            }
        }
        let line = |([size, most], names): &([usize; 2], Vec<&str>)| {
            let times = (*most as f64 / *size as f64).powi(2);
            format!(
                "size of {}: {size}² texels are tried first; where those that were built do not keep the tolerance, up to {most}² are taken, with {times:.1} \
                 times the memory and bytes\n",
                names.join(", ")
            )
        };
        kinds.iter().map(line).collect::<String>()
            + "numbers of tables are estimated from the heights' spread: a guess, within a half of what comes out\n"
    }

    /// A line for each kind of averaging, and for each kind of look-up between texels, with the specimens that it concerns.
    fn windows_text(&self) -> String {
        self.shared_lines("windows", &|forecast| windows_in_words(forecast, self.tolerance))
            + &self.shared_lines("look-ups", &|forecast| look_ups_in_words(forecast, self.tolerance))
    }

    /// What forecasts have to say, each line once with all specimens that say it.
    fn shared_lines(&self, what: &str, in_words: &dyn Fn(&Forecast) -> String) -> String {
        let mut lines: Vec<(String, Vec<&str>)> = Vec::new();
        for specimen in &self.specimens {
            let Some(forecast) = &specimen.forecast else { continue };
            let line = in_words(forecast);
            match lines.iter_mut().find(|(known, _)| *known == line) {
                Some((_, names)) => names.push(&specimen.name),
                None => lines.push((line, vec![&specimen.name])),
            }
        }
        lines.iter().map(|(line, names)| format!("{what} of {}: {line}\n", names.join(", "))).collect()
    }

    /// What all specimens take; nothing where none has a forecast.
    fn total_text(&self, tables_s: f64) -> String {
        if self.specimens.iter().all(|specimen| specimen.forecast.is_none()) {
            return String::new();
        }
        let references = self.specimens.iter().filter_map(|specimen| specimen.reference);
        let reference = match references.map(|reference| reference.seconds).reduce(|a, b| a + b) {
            None => "no reference".to_owned(),
            Some(seconds) => {
                format!("the reference in about {:.2} s where none of it is known", self.slowdown * seconds)
            }
        };
        let parts: Vec<String> =
            self.parts.iter().map(|part| format!("{} {}", part.what, in_seconds(part.seconds))).collect();
        let whole = match parts.is_empty() {
            true => "the whole run: nothing is to be made\n".to_owned(),
            false => format!(
                "the whole run in about {}{} on this machine, which now takes {:.1} times as long as the one that the constants are from: {}\n",
                in_seconds(self.seconds),
                self.range_text(),
                self.slowdown,
                parts.join(", ")
            ),
        };
        let mut text = format!("tables in about {:.2} s, {reference}\n{whole}", self.slowdown * tables_s);
        if !self.unchanged.is_empty() {
            text += &format!("there already, and taken over: {}\n", self.unchanged.join(", "));
        }
        let [entries, bytes] = self.cache;
        if entries > 0 {
            text += &format!("the cache holds {entries} entries, {}, which may save more\n", bytes_in_words(bytes));
        }
        text + &self.far_too_expensive()
    }

    /// How much more or less it is by what cannot be known before tables are built; nothing where all is known.
    fn range_text(&self) -> String {
        let [fewest, most] = self.seconds_range;
        if most <= 1.1 * fewest {
            return String::new();
        }
        format!(
            " ({} where the texels tried first suffice, {} where they never do)",
            in_seconds(fewest),
            in_seconds(most)
        )
    }

    /// Specimens that take far more than most, with the reason and what to do.
    fn far_too_expensive(&self) -> String {
        let mut text = String::new();
        for specimen in &self.specimens {
            let (Some(unit), Some(forecast)) = (&specimen.unit, &specimen.forecast) else { continue };
            if unit.seconds > EXPENSIVE_S && forecast.transforms > EXPENSIVE_TRANSFORMS {
                text += &format!(
                    "{} takes {}, for its heights span so much that {} transforms are needed: a relief that diffracts needs some ten. {}\n",
                    specimen.name,
                    in_seconds(unit.seconds),
                    forecast.transforms,
                    if specimen.has_fault {
                        "The warning below says where, and which key mends it."
                    } else {
                        "Is the unit of `height` right? `despike` takes single spikes away."
                    }
                );
            }
        }
        text
    }

    fn to_text(&self) -> String {
        let mut text = format!("atlas \"{}\" on {} threads\n", self.atlas, self.threads);
        text += "specimen                    windows transforms tables  size  nm at rim  seconds reference     memory      stored  numbers\n";
        let mut total_s = 0.0;
        for specimen in &self.specimens {
            match (&specimen.forecast, &specimen.failure) {
                (Some(f), _) => {
                    total_s += f.seconds;
                    let step = f.step_min_nm.map_or("-".into(), |step_nm| format!("{step_nm:.2}"));
                    text += &format!(
                        "{:<27} {:>7} {:>10} {:>6} {:>5} {:>10} {:>8.2} {:>9} {:>10} {:>11}  {}\n",
                        specimen.name,
                        f.windows,
                        f.transforms,
                        f.tables,
                        f.size,
                        step,
                        self.slowdown * f.seconds,
                        specimen
                            .reference
                            .map_or("-".into(), |reference| format!("{:.2}", self.slowdown * reference.seconds)),
                        bytes_in_words(f.memory_bytes),
                        bytes_in_words(f.stored_bytes),
                        numbers_in_words(f)
                    );
                }
                (None, Some(failure)) => text += &format!("{:<27} would fail: {failure}\n", specimen.name),
                (None, None) => {}
            }
        }
        text += &self.total_text(total_s);
        text += &self.windows_text();
        text += &self.guesses_text();
        if self.specimens.iter().flat_map(|specimen| &specimen.forecast).any(|forecast| !forecast.storage_asked) {
            text +=
                "whether numbers are half or float is decided by what halves do to the tables, once they are built\n";
        }
        for specimen in &self.specimens {
            if let Some(budget) = &specimen.budget {
                text += &budget_text(&specimen.name, budget);
            }
        }
        for specimen in &self.specimens {
            text.extend(specimen.coherence.iter().map(|words| format!("{}: {words}\n", specimen.name)));
            text.extend(specimen.warnings.iter().map(|warning| format!("warning: {}: {warning}\n", specimen.name)));
        }
        if !self.assumed.is_empty() {
            text += "assumed:\n";
        }
        for row in &self.assumed {
            text += &format!("  {row}\n");
        }
        if !self.left_out.is_empty() {
            text += "left out:\n";
        }
        for row in &self.left_out {
            text += &format!("  {row}\n");
        }
        text
    }
}

/// Whether any of a specimen's windows, and so of its scans, could be left out.
fn windows_in_words(forecast: &Forecast, tolerance: f64) -> String {
    let (count, moves) = (forecast.windows, forecast.speckle_deviation);
    match count {
        _ if moves == 0.0 => "the mean over all positions of the window is exact and costs no more than one".into(),
        1 => "one window with its speckle, which is as large as the light; none can be left out".into(),
        _ if moves > tolerance => format!(
            "all {count} windows are needed: at one wavelength their mean still moves by about {:.0} % on a rough \
             surface; more scans lower it",
            100.0 * moves
        ),
        _ => format!("{count} windows are more than the tolerance asks for: their mean moves by {moves:.0e}"),
    }
}

/// Which look-ups between texels keep the tolerance, and how many texels would.
fn look_ups_in_words(forecast: &Forecast, tolerance: f64) -> String {
    let mut parts = Vec::new();
    for LookUpForecast { look_up, error, size_needed } in forecast.look_ups {
        let kind = match look_up {
            LookUp::Linear => "linear",
            LookUp::Cubic => "cubic",
            LookUp::Spline => "spline",
        };
        let grown = (size_needed as f64 / forecast.size as f64).powi(2);
        parts.push(if error <= tolerance {
            format!("{kind} ones keep the tolerance of {tolerance:.0e} ({error:.1e})")
        } else {
            format!(
                "{kind} ones err by about {error:.1e}: a tolerance of {tolerance:.0e} takes {size_needed}² texels, {} of memory",
                bytes_in_words((grown * forecast.memory_bytes as f64) as u64)
            )
        });
    }
    format!("with {}² texels, {}", forecast.size, parts.join("; "))
}

/// The number format of a forecast.
fn numbers_in_words(forecast: &Forecast) -> &'static str {
    match (forecast.storage, forecast.storage_asked) {
        (Storage::Half, true) => "half",
        (Storage::Float, true) => "float",
        (Storage::Half, false) => "half is likely",
        (Storage::Float, false) => "float is likely",
    }
}

/// What a specimen's tables leave out, one row per thing.
fn budget_text(name: &str, budget: &Budget) -> String {
    let mut text = format!(
        "{name} for {} alone: {:.2} % of the disc of (u, v)\n  {:<42} {:>9} {:>9} {:>11} {:>11} {:>8}  why\n",
        budget.scenes.join(", "),
        100.0 * budget.reached_share,
        "left out",
        "saves sums",
        "seconds",
        "memory",
        "stored",
        "error"
    );
    for row in &budget.rows {
        let saved = |of: fn(&Cost) -> f64| (of(&row.with_it) - of(&budget.restricted)).max(0.0);
        text += &format!(
            "  {:<42} {:>9.1e} {:>9.2} {:>11} {:>11} {:>8.0e}  {}\n",
            row.what,
            saved(|cost| cost.node_samples),
            saved(|cost| cost.seconds),
            bytes_in_words(saved(|cost| cost.memory_bytes) as u64),
            bytes_in_words(saved(|cost| cost.stored_bytes) as u64),
            row.error_bound,
            row.why
        );
    }
    text
}
