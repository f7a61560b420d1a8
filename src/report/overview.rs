//! The overview of a run's specimens: a row each, what failed first.

use minijinja::{Value, context};

use crate::report::error_facts;
use crate::report::facts::warnings;
use crate::report::numbers;
use crate::report::prose::prose;
use crate::report::svg::escape;
use crate::report::table_facts::{grid_short, tables_short};
use crate::stages::results::{Grade, SpecimenResult, StageTime};
use diffraction_build::accuracy::rows::promised;

/// How a specimen came out, the worst first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum State {
    /// There are no tables.
    Failed,
    /// Its verdict is that it is not good.
    Bad,
    /// There is something to know.
    Warned,
    /// Nothing speaks against it.
    Good,
}

/// How a specimen came out.
pub(crate) fn state(specimen: &SpecimenResult) -> State {
    match (&specimen.failed, specimen.verdict.as_ref().map(|verdict| verdict.grade)) {
        (Some(_), _) => State::Failed,
        (None, Some(Grade::Red)) => State::Bad,
        (None, Some(Grade::Amber)) => State::Warned,
        (None, _) if warnings(specimen).is_empty() => State::Good,
        (None, _) => State::Warned,
    }
}

/// Class of the colour of a specimen's state, and its word.
fn tone_and_word(state: State) -> [&'static str; 2] {
    match state {
        State::Failed => ["red", "failed"],
        State::Bad => ["red", "not good"],
        State::Warned => ["amber", "with care"],
        State::Good => ["green", "good"],
    }
}

/// The verdict's colour and words, where there is one, as a sentence of its own.
pub(crate) fn verdict(specimen: &SpecimenResult) -> Option<[String; 2]> {
    let sentence = &specimen.verdict.as_ref()?.sentence;
    let mut letters = sentence.chars();
    let first = letters.next()?.to_uppercase();
    Some([tone_and_word(state(specimen))[0].into(), first.chain(letters).collect()])
}

/// How many specimens there are, and how many of each state but the good ones.
pub(crate) fn counted(specimens: &[SpecimenResult]) -> String {
    let of = |wanted: State| specimens.iter().filter(|specimen| state(specimen) == wanted).count();
    let all = match specimens.len() {
        1 => "1 specimen".to_owned(),
        count => format!("{} specimens", numbers::count(count as u64)),
    };
    let counts = [State::Failed, State::Bad, State::Warned].map(|state| (of(state), tone_and_word(state)[1]));
    let named: Vec<String> = counts
        .into_iter()
        .filter(|(count, _)| *count > 0)
        .map(|(count, name)| format!("{count} {}", if name == "with care" { "to take with care" } else { name }))
        .collect();
    match named.is_empty() {
        true => format!("{all}, nothing to warn of."),
        false => format!("{all}, {}; they come first.", named.join(", ")),
    }
}

/// A cell: what it says, a number or word to sort by, and a second line.
fn cell(text: String, value: Option<f64>, small: String) -> Value {
    let value = value.filter(|value| value.is_finite()).map(|value| format!("{value:.6e}")).unwrap_or_default();
    context! { text, value, small }
}

/// The row of a specimen; `href` is where all about it is, `preview` its picture as markup.
pub(crate) fn row(href: &str, specimen: &SpecimenResult, preview: Option<String>, stages: &[&StageTime]) -> Value {
    let dash = || numbers::MISSING.to_string();
    let statistics = specimen.statistics.as_ref();
    let build = specimen.build.as_ref();
    let colours = specimen.scenes.iter().filter_map(|scene| scene.error).map(|error| error.ciede2000_p95);
    let colour = colours.filter(|value| value.is_finite()).reduce(f64::max);
    let period = statistics.and_then(|found| found.dominant_periods.first()).map(|period| period.period_nm);
    let rms = statistics.map(|found| found.rms_height_nm);
    let error = error_facts::p95(&specimen.errors, promised(&specimen.errors));
    let time = (!stages.is_empty()).then(|| stages.iter().map(|stage| stage.wall_s).sum::<f64>());
    let shown =
        |value: Option<f64>, text: &dyn Fn(f64) -> String| cell(value.map_or_else(dash, text), value, String::new());
    let warned = warnings(specimen);
    // Of a verdict the part after its word: what it is good with, or why it is not.
    let judged = specimen.verdict.as_ref().filter(|verdict| verdict.grade != Grade::Green);
    let reason = judged
        .map(|verdict| {
            verdict.sentence.trim_start_matches("not good because: ").trim_start_matches("good within limits: ")
        })
        .or(warned.first().map(String::as_str));
    context! {
        href => Value::from_safe_string(escape(href)),
        name => &specimen.name,
        species => specimen.species.clone().unwrap_or_default(),
        generated => specimen.generated,
        tone => tone_and_word(state(specimen))[0],
        word => tone_and_word(state(specimen))[1],
        state => state(specimen) as usize,
        reason => reason.map(|words| Value::from_safe_string(prose(&first_words(words)))),
        thumb => preview.map_or_else(|| Value::from(dash()), Value::from_safe_string),
        cells => [
            shown(period, &numbers::length_nm),
            shown(rms, &|rms| numbers::with_unit(rms, 3, "nm")),
            cell(
                build.map_or_else(dash, tables_short),
                build.map(|built| built.tables as f64),
                build.map_or_else(String::new, grid_short),
            ),
            shown(build.map(|built| built.stored_bytes as f64), &|bytes| numbers::bytes(bytes as u64)),
            shown(error, &numbers::percent),
            shown(colour, &|colour| numbers::number(colour, 2)),
            shown(time, &numbers::seconds),
        ],
    }
}

/// As much of a warning as an overview has room for: its first clause, or its first words.
pub(crate) fn first_words(warning: &str) -> String {
    const ROOM: usize = 90;
    let line = warning.lines().next().unwrap_or_default();
    let clause = line.split([';', ':']).next().filter(|clause| clause.len() > ROOM / 4).unwrap_or(line);
    if clause.chars().count() <= ROOM {
        return clause.into();
    }
    // Half of a piece of code is none.
    let clause = clause.replace('`', "");
    let cut: String = clause.chars().take(ROOM).collect();
    format!("{} …", cut.rsplit_once(' ').map_or(cut.as_str(), |(start, _)| start))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_warnings_are_cut_between_words() {
        let long = "one two three `four` five ".repeat(8);
        let cut = first_words(&long);
        assert!(cut.ends_with(" …") && cut.chars().count() < 96 && !cut.contains('`'), "{cut}");
        assert_eq!(
            first_words("The surface is steep here and there; so doubt it"),
            "The surface is steep here and there"
        );
    }
}
