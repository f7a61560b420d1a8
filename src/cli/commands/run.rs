//! `run`: the pipeline from a manifest to a published atlas.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

use serde_json::json;

use crate::cli::destination;
use crate::cli::options::{Global, MANIFEST};
use crate::cli::output::{self, Outcome};
use crate::cli::progress::{Logged, reporter};
use crate::cli::terminal;
use crate::error::Result;
use crate::manifest::inputs::inputs;
use crate::manifest::keys::nearest;
use crate::manifest::{self, convert::run_config};
use crate::report::spectrum_picture::{spectrum_half_range_per_um, spectrum_picture};
use crate::report::{self, facts, pictures};
use crate::stages::archive::lock::Lock;
use crate::stages::archive::publish::Published;
use crate::stages::config::{OnFailure, RunConfig};
use crate::stages::results::{Failure, Grade, HeightMapFile, SpecimenResult, SpectrumFile};
use crate::stages::run::outlook::{Outlook, outlook};
use crate::stages::run::pipeline::{self, Finished, Heights, Helpers, Origin, RunOutcome, UnitsOutcome};
use diffraction_brdf::error::Error;
use diffraction_brdf::files;
use diffraction_build::ground::progress::Progress;
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
    /// Say what would be computed and why, and compute nothing
    #[arg(long, conflicts_with_all = ["lock", "frozen"])]
    pub dry_run: bool,
    /// Memory that specimens computed at once may take together [default: three quarters of what is free]
    #[arg(long, value_name = "MIB", value_parser = clap::value_parser!(u64).range(1..=1 << 24))]
    pub memory: Option<u64>,
    /// Print a line of JSON for each finished specimen and one for the run, in place of text
    #[arg(long)]
    pub json_lines: bool,
    /// Make only these specimens, for a later `merge`; nothing is published, and several may do so at once
    #[arg(long, value_name = "NAME", num_args = 1.., conflicts_with_all = ["shard", "no_cache", "lock", "frozen"])]
    pub only: Vec<String>,
    /// Likewise the I-th of N parts of the specimens; without a value the part of a task of a Slurm array
    #[arg(long, value_name = "I/N", num_args = 0..=1, default_missing_value = "slurm", value_parser = shard, conflicts_with_all = ["no_cache", "lock", "frozen"])]
    pub shard: Option<Shard>,
    /// Append what the run says to a file
    #[arg(long, value_name = "FILE")]
    pub log: Option<PathBuf>,
    #[command(flatten)]
    pub lock: LockArgs,
}

/// What the lock beside the manifest is for, in `run` and `merge`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, clap::Args)]
pub(crate) struct LockArgs {
    /// Write digests of inputs, settings and files into the lock beside the manifest, such as pipeline.lock
    #[arg(long)]
    pub lock: bool,
    /// Publish nothing that differs from the lock beside the manifest, and name the first difference
    #[arg(long, conflicts_with = "lock")]
    pub frozen: bool,
}

impl LockArgs {
    /// Holds the run to the lock, where that is asked for.
    fn freeze(self, manifest: &Path, config: &mut RunConfig) -> Result<()> {
        if self.frozen {
            config.frozen = Some(Lock::read(&lock_path(manifest))?);
            // A version with a specimen of before, or without one, is not what was locked.
            config.on_failure = OnFailure::Stop;
        }
        Ok(())
    }

    /// Writes the lock of what was published, where that is asked for; gives what kept it from being written.
    fn write(self, manifest: &Path, outcome: &RunOutcome, config: &RunConfig) -> Option<String> {
        let published = outcome.published.as_ref().filter(|_| self.lock)?;
        if !outcome.results.failures.is_empty() {
            return Some("the lock was not written: not everything was made".into());
        }
        let lock = Lock::of_version(&config.atlas_root.join(published.version()));
        let written = lock.and_then(|lock| lock.write(&lock_path(manifest)));
        written.err().map(|error| format!("the lock was not written: {error}"))
    }
}

/// `snakes.lock` beside `snakes.toml`.
fn lock_path(manifest: &Path) -> PathBuf {
    manifest.with_extension("lock")
}

impl Default for RunArgs {
    fn default() -> Self {
        Self {
            manifest: MANIFEST.into(),
            no_cache: false,
            dry_run: false,
            memory: None,
            json_lines: false,
            only: Vec::new(),
            shard: None,
            log: None,
            lock: LockArgs::default(),
        }
    }
}

/// One of several parts of the specimens, from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Shard {
    index: u64,
    count: u64,
}

impl Shard {
    /// Whether a specimen is of this part. By its name alone: one that comes or goes moves no other.
    fn holds(&self, name: &str) -> bool {
        let digest = files::sha256_hex(name.as_bytes());
        let number = u64::from_str_radix(&digest[..16], 16).unwrap_or(0);
        number % self.count == self.index - 1
    }
}

/// `I/N`, or what Slurm says of the task that this is.
fn shard(text: &str) -> std::result::Result<Shard, String> {
    let (index, count) = match text {
        "slurm" => slurm_task(&|name| std::env::var(name).ok()?.parse().ok())
            .ok_or("no part is named, and this is no task of a Slurm array: write --shard I/N")?,
        text => text
            .split_once('/')
            .and_then(|(index, count)| Some((index.parse().ok()?, count.parse().ok()?)))
            .ok_or("write it as I/N, such as 3/16")?,
    };
    match (1..=count).contains(&index) {
        true => Ok(Shard { index, count }),
        false => Err(format!("there is no part {index} of {count}: they are counted from 1")),
    }
}

/// Place in a Slurm array, from 1, and the number of its tasks.
fn slurm_task(number: &dyn Fn(&str) -> Option<u64>) -> Option<(u64, u64)> {
    let [task, first, count] = ["ID", "MIN", "COUNT"].map(|what| number(&format!("SLURM_ARRAY_TASK_{what}")));
    let step = number("SLURM_ARRAY_TASK_STEP").unwrap_or(1).max(1);
    Some((task?.checked_sub(first?)? / step + 1, count?))
}

/// Runs the pipeline and publishes.
///
/// # Errors
/// A wrong manifest, or what concerns the whole run.
pub(crate) fn run(args: &RunArgs, global: &Global) -> Result<Outcome> {
    let (manifest, text) = manifest::load(&args.manifest)?;
    if let Some(log) = &args.log {
        let inputs = inputs(&manifest, &text);
        let inputs: Vec<&Path> = inputs.iter().map(PathBuf::as_path).chain([args.manifest.as_path()]).collect();
        destination::check_log(log, &inputs)?;
    }
    let mut config = run_config(manifest, text);
    if args.no_cache {
        config.cache.limit_mib = 0;
        config.reuse = false;
    }
    config.memory_bytes = args.memory.map(|mib| mib << 20);
    args.lock.freeze(&args.manifest, &mut config)?;
    if args.dry_run {
        output::print(&outlook_text(&outlook(&config)?))?;
        return Ok(Outcome::Done);
    }
    let progress = Logged::new(reporter(global.quiet), args.log.as_deref())?;
    let tell = |finished: &Finished| {
        match args.json_lines {
            // A reader that is gone has had enough, and the run goes on.
            true => drop(output::print(&finished_json(finished))),
            false => progress.message(&finished_line(finished)),
        }
    };
    let helpers = Helpers {
        illustrate: &illustrate,
        write_report: &report::write,
        progress: &progress,
        finished: &tell,
        started: &utc_now(),
    };
    if let Some(wanted) = part(args, &config)? {
        let outcome = pipeline::make_units(&config, &helpers, wanted)?;
        return conclude_units(&outcome, &progress, args.json_lines);
    }
    let outcome = pipeline::run(&config, &helpers)?;
    let lock = args.lock.write(&args.manifest, &outcome, &config);
    Ok(with_failure(conclude(&outcome, &config, &progress, args.json_lines, global.quiet)?, lock))
}

/// Arguments of `merge`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(
    after_help = "Example:\n  diffraction-atlas run snakes.toml --shard 1/2\n  diffraction-atlas run snakes.toml --shard 2/2\n  \
                        diffraction-atlas merge snakes.toml"
)]
pub(crate) struct MergeArgs {
    /// What was computed
    #[arg(default_value = MANIFEST)]
    pub manifest: PathBuf,
    #[command(flatten)]
    pub lock: LockArgs,
}

/// Publishes what `run --only` and `run --shard` have made.
///
/// # Errors
/// As [`run`].
pub(crate) fn merge(args: &MergeArgs, global: &Global) -> Result<Outcome> {
    let (manifest, text) = manifest::load(&args.manifest)?;
    let mut config = run_config(manifest, text);
    args.lock.freeze(&args.manifest, &mut config)?;
    let progress = Logged::new(reporter(global.quiet), None)?;
    let helpers = Helpers {
        illustrate: &illustrate,
        write_report: &report::write,
        progress: &progress,
        finished: &|finished| progress.message(&finished_line(finished)),
        started: &utc_now(),
    };
    let outcome = pipeline::merge(&config, &helpers)?;
    let lock = args.lock.write(&args.manifest, &outcome, &config);
    Ok(with_failure(conclude(&outcome, &config, &progress, false, global.quiet)?, lock))
}

/// An outcome with one more failure, where there is one.
fn with_failure(outcome: Outcome, failure: Option<String>) -> Outcome {
    match (outcome, failure) {
        (outcome, None) => outcome,
        (Outcome::Failures(mut lines), Some(line)) => {
            lines.push(line);
            Outcome::Failures(lines)
        }
        (_, Some(line)) => Outcome::Failures(vec![line]),
    }
}

/// Whether a specimen is wanted by its name.
type Wanted<'a> = Box<dyn Fn(&str) -> bool + 'a>;

/// Which specimens are asked for; `None` for all of them, and publishing.
fn part<'a>(args: &'a RunArgs, config: &RunConfig) -> Result<Option<Wanted<'a>>> {
    if let Some(shard) = &args.shard {
        return Ok(Some(Box::new(|name| shard.holds(name))));
    }
    if args.only.is_empty() {
        return Ok(None);
    }
    let known: Vec<&str> = config.specimens.iter().map(|specimen| specimen.name.as_str()).collect();
    match args.only.iter().find(|name| !known.contains(&name.as_str())) {
        Some(unknown) => {
            Err(Error::Call(format!("--only: the manifest has no specimen `{unknown}`{}", like(unknown, &known)))
                .into())
        }
        None => Ok(Some(Box::new(|name| args.only.iter().any(|wanted| wanted == name)))),
    }
}

fn like(unknown: &str, known: &[&str]) -> String {
    nearest(unknown, known).map_or_else(String::new, |name| format!("; did you mean `{name}`?"))
}

/// What is said of a run that has published, or had nothing to.
fn conclude(
    outcome: &RunOutcome,
    config: &RunConfig,
    progress: &Logged,
    as_json: bool,
    quiet: bool,
) -> Result<Outcome> {
    let summary = match as_json {
        true => summary_json(&outcome.origins, outcome.published.as_ref(), &outcome.results.failures),
        false => summary(outcome, config),
    };
    output::print(&summary)?;
    progress.note(&summary);
    let specimens = &outcome.results.specimens;
    let said = warning_lines(specimens) + &verdict_lines(specimens);
    if !quiet {
        terminal::say(&said);
    }
    progress.note(&said);
    Ok(failed(&outcome.results.failures, progress))
}

fn conclude_units(outcome: &UnitsOutcome, progress: &Logged, as_json: bool) -> Result<Outcome> {
    let summary = match as_json {
        true => summary_json(&outcome.origins, None, &outcome.failures),
        false => format!("{}\n", counts_in_words(&outcome.origins)),
    };
    output::print(&summary)?;
    progress.note(&summary);
    Ok(failed(&outcome.failures, progress))
}

fn failed(failures: &[Failure], progress: &Logged) -> Outcome {
    let lines: Vec<String> = failures.iter().map(failure_line).collect();
    progress.note(&lines.join("\n"));
    if lines.is_empty() { Outcome::Done } else { Outcome::Failures(lines) }
}

/// What a run would do: specimens to make with the reason, and how many are left as they are.
fn outlook_text(outlooks: &[Outlook]) -> String {
    let (to_make, unchanged): (Vec<&Outlook>, Vec<&Outlook>) = outlooks.iter().partition(|outlook| outlook.make);
    let mut text: String = to_make.iter().map(|outlook| format!("make {}: {}\n", outlook.name, outlook.why)).collect();
    text += &format!("{} to make, {} unchanged\n", to_make.len(), unchanged.len());
    text
}

/// The line that a finished specimen leaves.
fn finished_line(finished: &Finished) -> String {
    let Finished { place: [index, count], origin, result, failures, used, seconds } = finished;
    let label = format!("[{index}/{count}] {}", result.name);
    let stage = failures.first().map_or("make it".into(), |failure| failure.stage.to_string());
    match origin {
        Origin::Failed => return format!("{label}: failed to {stage}"),
        Origin::Kept => return format!("{label}: failed to {stage}; what there was of it is kept, marked as stale"),
        Origin::Made | Origin::Unchanged => {}
    }
    let (tables, size) = result.build.as_ref().map_or((0, 0), |build| (build.tables, build.size));
    let known = [
        (used.tables_found > 0).then(|| "the tables".into()),
        (used.pairs_found > 0).then(|| format!("{} reference values", used.pairs_found)),
    ];
    let known: Vec<String> = known.into_iter().flatten().collect();
    let known = if known.is_empty() { String::new() } else { format!(", known: {}", known.join(", ")) };
    let warnings = match facts::warnings(result).len() {
        0 => String::new(),
        1 => ", 1 warning".into(),
        count => format!(", {count} warnings"),
    };
    let followed = result.optics.as_ref().filter(|optics| optics.sigma_follows_scan);
    let sigma = followed.map_or(String::new(), |optics| format!(", sigma = {:.3} µm", optics.sigma_nm * 1e-3));
    format!("{label}: {tables} tables of {size}²{sigma}, {seconds:.1} s{known}{warnings}")
}

/// The same as a line of JSON.
fn finished_json(finished: &Finished) -> String {
    let Finished { place: [index, count], origin, result, failures, seconds, .. } = finished;
    let line = json!({
        "event": "specimen",
        "name": result.name,
        "index": index,
        "count": count,
        "outcome": origin,
        "seconds": seconds,
        "warnings": facts::warnings(result),
        "failures": failures,
    });
    format!("{line}\n")
}

fn summary_json(origins: &[Origin], published: Option<&Published>, failures: &[Failure]) -> String {
    let counts: BTreeMap<&str, usize> = counts(origins).into_iter().collect();
    let line = json!({ "event": "run", "published": published, "specimens": counts, "failures": failures });
    format!("{line}\n")
}

/// How many specimens came in which way.
fn counts(origins: &[Origin]) -> [(&'static str, usize); 4] {
    let count = |wanted| origins.iter().filter(|origin| **origin == wanted).count();
    [
        ("made", count(Origin::Made)),
        ("unchanged", count(Origin::Unchanged)),
        ("kept", count(Origin::Kept)),
        ("failed", count(Origin::Failed)),
    ]
}

fn counts_in_words(origins: &[Origin]) -> String {
    let counts = counts(origins).into_iter().filter(|(_, count)| *count > 0);
    counts.map(|(what, count)| format!("{count} {what}")).collect::<Vec<_>>().join(", ")
}

fn summary(outcome: &RunOutcome, config: &RunConfig) -> String {
    let Some(published) = &outcome.published else { return String::new() };
    let (folder, counts) = (config.atlas_root.join(published.version()), counts_in_words(&outcome.origins));
    let folder = folder.display();
    match published {
        Published::Version(_) if !config.report.write => {
            format!("published {folder} in {:.1} s: {counts}\n", outcome.results.total_wall_s)
        }
        Published::Version(_) => format!(
            "published {folder} in {:.1} s: {counts}\nreport    {folder}/report.html\n",
            outcome.results.total_wall_s
        ),
        Published::Unchanged(_) => format!("{folder} holds the same already; nothing was published: {counts}\n"),
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

/// What to think of each specimen, a line each; of more than a screen holds, of those that are not good.
fn verdict_lines(specimens: &[SpecimenResult]) -> String {
    const SHOWN: usize = 20;
    let is_shown = |grade: Grade| specimens.len() <= SHOWN || grade == Grade::Red;
    let verdicts = specimens.iter().filter_map(|specimen| Some((&specimen.name, specimen.verdict.as_ref()?)));
    verdicts
        .filter(|(_, verdict)| is_shown(verdict.grade))
        .map(|(name, verdict)| format!("verdict: {name}: {}\n", verdict.sentence))
        .collect()
}

fn failure_line(failure: &Failure) -> String {
    let specimen = failure.specimen.as_deref().unwrap_or("the run");
    format!("{specimen} ({}): {}", failure.stage, failure.message)
}

/// Draws heights and spectrum for the report.
fn illustrate(
    heights: &Heights,
    folder: &Path,
    prefix: &str,
) -> diffraction_brdf::Result<(HeightMapFile, SpectrumFile)> {
    let Heights { field, replaced, statistics } = *heights;
    let map = pictures::height_map(field, replaced)?;
    write_png(&folder.join("heights.png"), &map.rgb)?;
    let periods_nm: Vec<f64> = statistics.dominant_periods.iter().map(|period| period.period_nm).collect();
    let spectrum = spectrum_picture(field, spectrum_half_range_per_um(field, &periods_nm))?;
    write_png(&folder.join("spectrum.png"), &spectrum.rgb)?;
    let map = HeightMapFile {
        png: format!("{prefix}/heights.png"),
        scale_bar_um: map.scale_bar_um,
        low_nm: map.low_nm,
        high_nm: map.high_nm,
        replaced_samples: replaced.map_or(0, |replaced| replaced.iter().filter(|is_replaced| **is_replaced).count()),
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_hold_every_specimen_once_and_stay_when_others_come() {
        let names: Vec<String> = (0..200).map(|n| format!("scale_{n}")).collect();
        let parts: Vec<Shard> = (1..=7).map(|index| shard(&format!("{index}/7")).unwrap()).collect();
        for name in &names {
            assert_eq!(parts.iter().filter(|part| part.holds(name)).count(), 1, "{name}");
        }
        let sizes: Vec<usize> = parts.iter().map(|part| names.iter().filter(|name| part.holds(name)).count()).collect();
        assert!(sizes.iter().all(|size| (10..50).contains(size)), "{sizes:?}");
        for wrong in ["0/7", "8/7", "1", "a/b", "1/0"] {
            assert!(shard(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_task_of_an_array_is_a_part_whatever_its_numbers() {
        let tasks = |id: u64, min: u64, count: u64, step: u64| {
            let variables = [("ID", id), ("MIN", min), ("COUNT", count), ("STEP", step)];
            slurm_task(&|name| variables.iter().find(|(end, _)| name.ends_with(end)).map(|(_, value)| *value))
        };
        assert_eq!(tasks(1, 1, 4, 1), Some((1, 4)));
        assert_eq!(tasks(30, 10, 3, 10), Some((3, 3)));
        assert_eq!(slurm_task(&|_| None), None);
    }
}
