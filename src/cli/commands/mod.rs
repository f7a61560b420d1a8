//! One file per command: its arguments and what it does.

pub(crate) mod cache;
pub(crate) mod diff;
pub(crate) mod eval;
pub(crate) mod export;
mod export_forms;
pub(crate) mod inspect;
pub(crate) mod inspect_many;
mod inspect_verdict;
pub(crate) mod list;
pub(crate) mod plan;
pub(crate) mod prune;
pub(crate) mod run;
pub(crate) mod study;
pub(crate) mod synthesize;
pub(crate) mod verify;
pub(crate) mod view;

#[cfg(test)]
mod tests {
    use clap::{Args, Command};

    use super::*;

    fn command<A: Args>(name: &'static str) -> Command {
        A::augment_args(Command::new(name))
    }

    fn all() -> Vec<Command> {
        vec![
            command::<run::RunArgs>("run"),
            command::<plan::PlanArgs>("plan"),
            command::<inspect::InspectArgs>("inspect"),
            command::<eval::EvalArgs>("eval"),
            command::<study::StudyArgs>("study"),
            command::<verify::VerifyArgs>("verify"),
            command::<diff::DiffArgs>("diff"),
            command::<cache::CacheArgs>("cache"),
            command::<export::ExportArgs>("export"),
            command::<synthesize::SynthesizeArgs>("synthesize"),
            command::<list::ListArgs>("list"),
            command::<view::ViewArgs>("view"),
        ]
    }

    #[test]
    fn each_help_has_an_example_that_parses() {
        for command in all() {
            command.clone().debug_assert();
            let help = command.clone().render_long_help().to_string();
            let name = command.get_name().to_owned();
            let start = format!("diffraction-atlas {name}");
            let examples: Vec<&str> = help.lines().map(str::trim).filter(|line| line.starts_with(&start)).collect();
            assert!(!examples.is_empty(), "{name} has no example:\n{help}");
            for example in examples {
                let words = example.split_whitespace().skip(1);
                command.clone().try_get_matches_from(words).unwrap_or_else(|error| panic!("{example}\n{error}"));
            }
        }
    }
}
