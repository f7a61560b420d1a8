//! `plan`: what a run would compute, what it leaves out and why, and what it would take.

use std::path::PathBuf;

use serde::Serialize;

use crate::cli::Global;
use crate::cli::output::{self, Outcome, bytes_in_words};
use crate::ground::error::Result;
use crate::manifest::{self, convert::run_config};
use crate::stages::ingest::ingest;
use crate::stages::measured;
use crate::tables::forecast::{Forecast, forecast};

/// Arguments of `plan`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas plan snakes.toml --json")]
pub struct PlanArgs {
    /// What to plan for
    #[arg(default_value = super::MANIFEST)]
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
    specimens: Vec<SpecimenPlan>,
    /// What no scene, file or stage of this manifest asks for.
    left_out: Vec<String>,
}

/// One specimen: its forecast, or why it would fail.
#[derive(Debug, Serialize)]
struct SpecimenPlan {
    name: String,
    forecast: Option<Forecast>,
    failure: Option<String>,
}

/// Reads the scans, plans, and prints; no table is computed.
///
/// # Errors
/// A wrong manifest. A specimen that would fail is part of the plan, and of the exit status.
pub fn run(args: &PlanArgs, _global: &Global) -> Result<Outcome> {
    let (manifest, text) = manifest::load(&args.manifest)?;
    let config = run_config(&manifest, &text);
    let threads = rayon::current_num_threads();
    let specimens = config.specimens.iter().map(|specimen| {
        let measurement = specimen.measured.as_ref().map(measured::read).transpose();
        let outcome = measurement
            .and_then(|_| ingest(specimen))
            .and_then(|ingested| forecast(&ingested.fields, &specimen.optics, &config.tables, threads));
        let (forecast, failure) = match outcome {
            Ok(forecast) => (Some(forecast), None),
            Err(error) => (None, Some(error.to_string())),
        };
        SpecimenPlan { name: specimen.name.clone(), forecast, failure }
    });
    let plan =
        Plan { atlas: config.atlas_name.clone(), threads, specimens: specimens.collect(), left_out: left_out(&config) };
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

fn left_out(config: &crate::stages::config::RunConfig) -> Vec<String> {
    let mut rows = Vec::new();
    if config.scenes.is_empty() {
        rows.push("scene pictures and their references: the manifest has no [[scene]]".into());
    }
    if config.gpu == crate::stages::config::GpuCheck::Off {
        rows.push("the GPU check: gpu.check = \"off\"".into());
    }
    rows.push("texels outside the disc |(u, v)| <= 2, which no pair of directions reaches: 21 % of each table".into());
    rows.push("wavelengths that inner texels do not need: their step grows as 1 / |(u, v)|".into());
    rows
}

impl Plan {
    fn to_text(&self) -> String {
        let mut text = format!("atlas \"{}\" on {} threads\n", self.atlas, self.threads);
        text +=
            "specimen                    windows transforms tables  size  nm at rim  seconds     memory      stored\n";
        let mut total_s = 0.0;
        for specimen in &self.specimens {
            match (&specimen.forecast, &specimen.failure) {
                (Some(f), _) => {
                    total_s += f.seconds;
                    text += &format!(
                        "{:<27} {:>7} {:>10} {:>6} {:>5} {:>10.2} {:>8.1} {:>10} {:>11}\n",
                        specimen.name,
                        f.windows,
                        f.transforms,
                        f.tables,
                        f.size,
                        f.step_min_nm,
                        f.seconds,
                        bytes_in_words(f.memory_bytes),
                        bytes_in_words(f.stored_bytes)
                    );
                }
                (None, Some(failure)) => text += &format!("{:<27} would fail: {failure}\n", specimen.name),
                (None, None) => {}
            }
        }
        text += &format!("tables in about {total_s:.1} s; pictures and measured errors come on top\nleft out:\n");
        for row in &self.left_out {
            text += &format!("  {row}\n");
        }
        text
    }
}
