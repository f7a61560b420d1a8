//! `run`: the pipeline from a manifest to a published atlas.

use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

use crate::cli::options::{Global, MANIFEST};
use crate::cli::output::{self, Outcome};
use crate::cli::progress::reporter;
use crate::manifest::{self, convert::run_config};
use crate::report::spectrum_picture::{spectrum_half_range_per_um, spectrum_picture};
use crate::report::{self, pictures};
use crate::stages::archive::publish::Published;
use crate::stages::config::RunConfig;
use crate::stages::results::{Failure, HeightMapFile, SpectrumFile, Statistics};
use crate::stages::run::pipeline::{self, Helpers};
use diffraction_brdf::error::Result;
use diffraction_build::height::HeightField;
use diffraction_render::render::png_image::write_png;

/// Arguments of `run`; those of the program called without a command are the defaults.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(after_help = "Example:\n  diffraction-atlas run snakes.toml")]
pub struct RunArgs {
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
pub fn run(args: &RunArgs, global: &Global) -> Result<Outcome> {
    let (manifest, text) = manifest::load(&args.manifest)?;
    let mut config = run_config(&manifest, &text);
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
    let failures: Vec<String> = outcome.results.failures.iter().map(failure_line).collect();
    Ok(if failures.is_empty() { Outcome::Done } else { Outcome::Failures(failures) })
}

fn summary(published: &Published, config: &RunConfig, wall_s: f64) -> String {
    let folder = config.atlas_root.join(published.version());
    match published {
        Published::Version(_) => format!(
            "published {} in {wall_s:.1} s\nreport    {}\n",
            folder.display(),
            folder.join("report.html").display()
        ),
        Published::Unchanged(_) => format!("{} holds the same already; nothing was published\n", folder.display()),
    }
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
) -> Result<(HeightMapFile, SpectrumFile)> {
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

/// The time in UTC, RFC 3339 to the second.
fn utc_now() -> String {
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |d| d.as_secs());
    rfc3339(seconds)
}

/// Days to dates by Howard Hinnant's `civil_from_days`.
fn rfc3339(seconds: u64) -> String {
    let (days, of_day) = ((seconds / 86_400) as i64 + 719_468, seconds % 86_400);
    let era = days.div_euclid(146_097);
    let day_of_era = days.rem_euclid(146_097);
    let year_of_era = (day_of_era - day_of_era / 1_460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month_index = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * month_index + 2) / 5 + 1;
    let month = if month_index < 10 { month_index + 3 } else { month_index - 9 };
    let year = year_of_era + era * 400 + i64::from(month <= 2);
    format!("{year:04}-{month:02}-{day:02}T{:02}:{:02}:{:02}Z", of_day / 3600, of_day / 60 % 60, of_day % 60)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_follow_the_calendar() {
        for (seconds, expected) in [
            (0, "1970-01-01T00:00:00Z"),
            (951_782_399, "2000-02-28T23:59:59Z"),
            (951_782_400, "2000-02-29T00:00:00Z"),
            (1_795_305_600, "2026-11-22T00:00:00Z"),
            (4_107_542_400, "2100-03-01T00:00:00Z"),
        ] {
            assert_eq!(rfc3339(seconds), expected);
        }
    }
}
