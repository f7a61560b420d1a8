//! `run`: the pipeline from a manifest to a published atlas.

use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

use crate::cli::options::{Global, MANIFEST};
use crate::cli::output::{self, Outcome};
use crate::cli::progress::reporter;
use crate::cli::terminal;
use crate::error::Result;
use crate::manifest::{self, convert::run_config};
use crate::report::spectrum_picture::{spectrum_half_range_per_um, spectrum_picture};
use crate::report::{self, facts, pictures};
use crate::stages::archive::publish::Published;
use crate::stages::config::RunConfig;
use crate::stages::results::{Failure, HeightMapFile, SpecimenResult, SpectrumFile, Statistics};
use crate::stages::run::pipeline::{self, Helpers};
use diffraction_build::height::HeightField;
use diffraction_render::render::png_image::write_png;

/// Arguments of `run`; those of the program called without a command are the defaults.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas run snakes.toml")]
pub(crate) struct RunArgs {
    /// What to compute
    #[arg(default_value = MANIFEST)]
    pub manifest: PathBuf,
    /// Compute everything anew, and keep nothing for later runs
    #[arg(long)]
    pub no_cache: bool,
}

impl Default for RunArgs {
    fn default() -> Self {
        Self { manifest: MANIFEST.into(), no_cache: false }
    }
}

/// Runs the pipeline and publishes.
///
/// # Errors
/// A wrong manifest, or what concerns the whole run.
pub(crate) fn run(args: &RunArgs, global: &Global) -> Result<Outcome> {
    let (manifest, text) = manifest::load(&args.manifest)?;
    let mut config = run_config(manifest, text);
    if args.no_cache {
        config.cache.limit_mib = 0;
    }
    let progress = reporter(global.quiet);
    let helpers = Helpers {
        illustrate: &illustrate,
        write_report: &report::write,
        progress: progress.as_ref(),
        started: &utc_now(),
    };
    let outcome = pipeline::run(&config, &helpers)?;
    if let Some(published) = &outcome.published {
        output::print(&summary(published, &config, outcome.results.total_wall_s))?;
    }
    if !global.quiet {
        terminal::say(&warning_lines(&outcome.results.specimens));
    }
    let failures: Vec<String> = outcome.results.failures.iter().map(failure_line).collect();
    Ok(if failures.is_empty() { Outcome::Done } else { Outcome::Failures(failures) })
}

fn summary(published: &Published, config: &RunConfig, wall_s: f64) -> String {
    let folder = config.atlas_root.join(published.version());
    match published {
        Published::Version(_) => {
            let published = format!("published {} in {wall_s:.1} s\n", folder.display());
            match config.report.write {
                true => format!("{published}report    {}\n", folder.join("report.html").display()),
                false => published,
            }
        }
        Published::Unchanged(_) => format!("{} holds the same already; nothing was published\n", folder.display()),
    }
}

/// Most warnings that are shown before the report is named instead.
const WARNINGS_SHOWN: usize = 10;

/// What a user must know of the specimens, a line each; what several share once.
fn warning_lines(specimens: &[SpecimenResult]) -> String {
    let mut told: Vec<(String, Vec<&str>)> = Vec::new();
    for specimen in specimens {
        for warning in facts::warnings(specimen) {
            match told.iter_mut().find(|(text, _)| *text == warning) {
                Some((_, names)) => names.push(&specimen.name),
                None => told.push((warning, vec![&specimen.name])),
            }
        }
    }
    let mut lines: String = told
        .iter()
        .take(WARNINGS_SHOWN)
        .map(|(text, names)| format!("warning: {}: {text}\n", names.join(", ")))
        .collect();
    if told.len() > WARNINGS_SHOWN {
        lines += &format!("{} warnings; all of them are in the report\n", told.len());
    }
    lines
}

fn failure_line(failure: &Failure) -> String {
    let specimen = failure.specimen.as_deref().unwrap_or("the run");
    format!("{specimen} ({}): {}", failure.stage, failure.message)
}

/// Draws heights and spectrum for the report.
fn illustrate(
    field: &HeightField,
    statistics: &Statistics,
    folder: &Path,
    prefix: &str,
) -> diffraction_brdf::Result<(HeightMapFile, SpectrumFile)> {
    let map = pictures::height_map(field)?;
    write_png(&folder.join("heights.png"), &map.rgb)?;
    let periods_nm: Vec<f64> = statistics.dominant_periods.iter().map(|period| period.period_nm).collect();
    let spectrum = spectrum_picture(field, spectrum_half_range_per_um(field, &periods_nm))?;
    write_png(&folder.join("spectrum.png"), &spectrum.rgb)?;
    let map = HeightMapFile {
        png: format!("{prefix}/heights.png"),
        scale_bar_um: map.scale_bar_um,
        low_nm: map.low_nm,
        high_nm: map.high_nm,
    };
    let spectrum = SpectrumFile {
        png: format!("{prefix}/spectrum.png"),
        half_range_per_um: spectrum.half_range_per_um,
        low_db: spectrum.low_db,
    };
    Ok((map, spectrum))
}

/// The time in UTC, RFC 3339 to the second; 1970 for a clock that is set to before.
fn utc_now() -> String {
    humantime::format_rfc3339_seconds(SystemTime::now().max(UNIX_EPOCH)).to_string()
}
