//! The command line: arguments in, exit status out; results on stdout, everything else on stderr.

pub(crate) mod commands;
pub(crate) mod destination;
pub(crate) mod directions;
pub(crate) mod lengths;
pub(crate) mod options;
pub(crate) mod output;
pub(crate) mod progress;
pub mod surroundings;
pub(crate) mod terminal;

use std::ffi::OsString;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

use crate::error::Result;
use commands::{cache, diff, eval, export, inspect, list, plan, prune, run, study, synthesize, verify, view};
use diffraction_brdf::error::Error;
use options::Global;
use output::Outcome;

/// Turns height scans of iridescent surfaces into BRDF tables that any renderer can evaluate.
#[derive(Debug, Parser)]
#[command(
    name = "diffraction-atlas",
    version,
    after_help = "Exit status: 0 done, or nothing to do, or what was compared is the same; 1 done with failures, which are listed, \
                  or not done for a file or a limit, or compared and different; 2 the call or the manifest is wrong, \
                  and nothing was written; 75 worth trying again as it is: another run holds the atlas, or the disk is full."
)]
pub(crate) struct Cli {
    /// What holds for every command.
    #[command(flatten)]
    pub global: Global,
    /// What to do.
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Run the pipeline: from a manifest to a published atlas (also what happens without a command)
    Run(run::RunArgs),
    /// Publish what `run --only` and `run --shard` have made, here or on other machines
    Merge(run::MergeArgs),
    /// Say what a run would compute, leave out, and take, without computing it
    Plan(plan::PlanArgs),
    /// Show what a scan or an atlas holds
    Inspect(inspect::InspectArgs),
    /// Evaluate the BRDF for a list of directions
    Eval(eval::EvalArgs),
    /// Check that an atlas is whole and as accurate as it says
    Verify(verify::VerifyArgs),
    /// Show an atlas in the browser, where it can be turned by hand
    View(view::ViewArgs),
    /// Say what changed between two versions
    Diff(diff::DiffArgs),
    /// Measure error against run time and memory, and run the stability suite
    Study(study::StudyArgs),
    /// Show or clear the intermediate results that runs keep
    Cache(cache::CacheArgs),
    /// Write an atlas in other forms
    Export(export::ExportArgs),
    /// List the atlases in a folder, their versions and specimens
    List(list::ListArgs),
    /// Remove old versions of an atlas
    Prune(prune::PruneArgs),
    /// Write a generated height field as a TIFF
    Synthesize(synthesize::SynthesizeArgs),
}

/// Parses the arguments, runs the command, and reports errors.
pub fn main(args: impl IntoIterator<Item = OsString>) -> ExitCode {
    let cli = match Cli::try_parse_from(args) {
        Ok(cli) => cli,
        Err(message) => {
            // clap knows which of its messages are results (--help, --version), in colours, and which are errors, which hold what
            // was typed; a reader that closed the pipe is nobody's fault.
            match message.use_stderr() {
                true => terminal::say(&message.render().to_string()),
                false => drop(message.print()),
            }
            return ExitCode::from(message.exit_code() as u8);
        }
    };
    let outcome = set_threads(cli.global.threads).and_then(|()| dispatch(&cli));
    output::conclude(outcome)
}

fn dispatch(cli: &Cli) -> Result<Outcome> {
    let global = &cli.global;
    match &cli.command {
        None => run::run(&run::RunArgs::default(), global),
        Some(Command::Run(args)) => run::run(args, global),
        Some(Command::Merge(args)) => run::merge(args, global),
        Some(Command::Plan(args)) => plan::run(args, global),
        Some(Command::Inspect(args)) => inspect::run(args, global),
        Some(Command::Eval(args)) => eval::run(args, global),
        Some(Command::Verify(args)) => verify::run(args, global),
        Some(Command::View(args)) => view::run(args, global),
        Some(Command::Diff(args)) => diff::run(args, global),
        Some(Command::Study(args)) => study::run(args, global),
        Some(Command::Cache(args)) => cache::run(args),
        Some(Command::Export(args)) => export::run(args, global),
        Some(Command::List(args)) => list::run(args, global),
        Some(Command::Prune(args)) => prune::run(args),
        Some(Command::Synthesize(args)) => synthesize::run(args, global),
    }
}

/// Sizes the pool of threads that all computations share.
fn set_threads(threads: Option<u16>) -> Result<()> {
    // Made here in any case: where the system allows fewer, the first use of the pool would panic.
    let count = threads.map_or(0, usize::from);
    rayon::ThreadPoolBuilder::new().num_threads(count).build_global().map_err(|error| {
        let what = threads.map_or("a thread per core".into(), |threads| format!("{threads} threads"));
        Error::limit(format!("cannot start {what}: {error}"), "ask for fewer with `--threads`")
    })?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn the_definition_is_consistent() {
        Cli::command().debug_assert();
    }

    #[test]
    fn global_options_stand_before_or_after_the_command() {
        for line in ["diffraction-atlas --quiet --threads 2 list", "diffraction-atlas list --quiet --threads 2"] {
            let cli = Cli::try_parse_from(line.split(' ')).unwrap();
            assert!(cli.global.quiet);
            assert_eq!(cli.global.threads, Some(2));
        }
        assert!(Cli::try_parse_from(["diffraction-atlas", "--threads", "0", "list"]).is_err());
    }
}
