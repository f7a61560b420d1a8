//! `plan`: what a run would compute, what it leaves out and why, and what it would take.

use std::path::PathBuf;

use serde::Serialize;

use crate::cli::options::{Global, MANIFEST};
use crate::cli::output::{self, Outcome, bytes_in_words};
use crate::error::Result;
use crate::manifest::{self, convert::run_config};
use crate::stages::config::{RunConfig, SpecimenConfig};
use crate::stages::coverage::{asked, savings};
use crate::stages::ingest::ingest;
use crate::stages::measured;
use crate::stages::pictures::scenes::reference_samples;
use crate::stages::run::reference_forecast::{ReferenceForecast, reference_forecast};
use crate::stages::run::warnings::scan_warnings;
use diffraction_build::tables::coverage::budget::{Budget, Cost};
use diffraction_build::tables::forecast::{Forecast, forecast_of};
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::look_ups::{LookUp, LookUpForecast};
use diffraction_build::tables::model::Storage;
use diffraction_build::tables::plan;
use diffraction_build::tables::spectral::SpectralInput;
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
}

/// The plan of a run.
#[derive(Debug, Serialize)]
struct Plan {
    atlas: String,
    threads: usize,
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
    /// What evaluating its reference will take, where that is asked for.
    reference: Option<ReferenceForecast>,
    /// What its tables leave out, where they are restricted to scenes.
    budget: Option<Budget>,
    failure: Option<String>,
    /// What to know of its scans before running, in whole sentences.
    warnings: Vec<String>,
}

/// A specimen as a piece of work.
#[derive(Debug, Serialize)]
struct UnitPlan {
    /// Predicted seconds of tables and reference with all threads; pictures come on top.
    seconds: f64,
    /// Predicted memory of the process in MiB.
    memory_mib: u64,
}

/// What the program holds besides: itself, pictures, the tables that were read back.
const PROGRAM_MIB: u64 = 200;

/// Reads the scans, plans, and prints; no table is computed.
///
/// # Errors
/// A wrong manifest. A specimen that would fail is part of the plan, and of the exit status.
pub(crate) fn run(args: &PlanArgs, _global: &Global) -> Result<Outcome> {
    let (manifest, text) = manifest::load(&args.manifest)?;
    let config = run_config(manifest, text);
    let threads = rayon::current_num_threads();
    let asked_for = config.specimens.iter().filter(|specimen| asked::is_asked_for(&config, &specimen.name));
    let mut pictures = Pictures::default();
    let specimens = asked_for.map(|specimen| {
        plan_specimen(&config, specimen, threads, &mut pictures).unwrap_or_else(|error| SpecimenPlan {
            name: specimen.name.clone(),
            forecast: None,
            unit: None,
            reference: None,
            budget: None,
            failure: Some(error.to_string()),
            warnings: Vec::new(),
        })
    });
    let plan = Plan {
        atlas: config.atlas_name.clone(),
        threads,
        tolerance: config.tables.tolerance,
        specimens: specimens.collect(),
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

fn plan_specimen(
    config: &RunConfig,
    specimen: &SpecimenConfig,
    threads: usize,
    pictures: &mut Pictures,
) -> Result<SpecimenPlan> {
    specimen.measured.as_ref().map(measured::read).transpose()?;
    let ingested = ingest(specimen)?;
    let tables = asked::tables_for(config, &specimen.name);
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
    let forecast = match config.hold.xyz {
        true => forecast_of(&input, &plan, threads),
        false => {
            let spectral = SpectralInput::new(&ingested.optics, &tables);
            let input = spectral.of(&input);
            forecast_of(&input, &plan::plan(&input)?, threads)
        }
    };
    let reference = match config.report.reference {
        false => None,
        true => {
            let samples = pictures.of(asked::pictured_scenes(config, &specimen.name))?;
            Some(reference_forecast(&input, &plan, forecast.tables, &samples, threads))
        }
    };
    let of_first = ingested.statistics.iter().take(1).flat_map(|statistics| statistics.warnings.clone());
    let obstacle = asked::spectral_obstacle(config, &ingested.optics)?;
    let warnings = of_first.chain(scan_warnings(&ingested, &ingested.optics)).chain(obstacle).collect();
    let samples: usize = ingested.fields.iter().map(|field| field.heights_nm.len()).sum();
    let held_bytes = (samples * size_of::<f64>()) as u64 + forecast.memory_bytes;
    let unit = UnitPlan {
        seconds: forecast.seconds + reference.map_or(0.0, |reference: ReferenceForecast| reference.seconds),
        memory_mib: held_bytes.div_ceil(1 << 20) + PROGRAM_MIB,
    };
    Ok(SpecimenPlan {
        name: specimen.name.clone(),
        forecast: Some(forecast),
        unit: Some(unit),
        reference,
        budget,
        failure: None,
        warnings,
    })
}

/// Samples of the reference pictures: most scenes are the same for every specimen.
#[derive(Default)]
struct Pictures(Vec<(Scene, ShadingSamples)>);

impl Pictures {
    fn of(&mut self, scenes: Vec<Scene>) -> Result<Vec<&ShadingSamples>> {
        let mut places = Vec::new();
        for scene in scenes {
            let known = self.0.iter().position(|(known, _)| *known == scene);
            places.push(known.unwrap_or(self.0.len()));
            if known.is_none() {
                let samples = reference_samples(&scene)?;
                self.0.push((scene, samples));
            }
        }
        Ok(places.into_iter().map(|place| &self.0[place].1).collect())
    }
}

impl Plan {
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
        let references = self.specimens.iter().filter_map(|specimen| specimen.reference);
        let reference_s = references.map(|reference| reference.seconds).reduce(|a, b| a + b);
        match (self.specimens.iter().any(|specimen| specimen.forecast.is_some()), reference_s) {
            (false, _) => String::new(),
            (true, None) => format!("tables in about {tables_s:.2} s, no reference; pictures come on top\n"),
            (true, Some(reference_s)) => format!(
                "tables in about {tables_s:.2} s, the reference in about {reference_s:.2} s where none of it is known; \
                 pictures and the direct sum come on top\n"
            ),
        }
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
                        f.seconds,
                        specimen.reference.map_or("-".into(), |reference| format!("{:.2}", reference.seconds)),
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
