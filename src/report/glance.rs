//! What one wants to know of a specimen first: its colours, whether it is good, what it costs, whether it matches.

use minijinja::{Value, context};

use crate::report::error_facts::figures;
use crate::report::facts::{cost, warnings};
use crate::report::measured;
use crate::report::overview::{self, first_words};
use crate::report::prose::prose;
use crate::stages::results::SpecimenResult;

/// What the template needs; `None` where there are no tables.
pub(crate) fn view(specimen: &SpecimenResult) -> Option<Value> {
    let cost = cost(specimen)?;
    let warned = warnings(specimen);
    let [tone, verdict] = overview::verdict(specimen).unwrap_or_else(|| {
        let [tone, words] = match warned.len() {
            0 => ["green", "Nothing speaks against it."],
            _ => ["amber", "Not without reserve."],
        };
        [tone.into(), words.into()]
    });
    let sentence = match &specimen.goniometry {
        Some(found) => found.sentence.clone(),
        None if specimen.reached_png.is_some() => {
            "The tables answer for the scenes below alone, so not every direction was looked at.".into()
        }
        None => "Not looked at from all sides.".into(),
    };
    let figures: Vec<Value> = figures(specimen)
        .into_iter()
        .map(|figure| context! { name => figure.name, value => figure.value, meaning => figure.meaning })
        .collect();
    let matched = match &specimen.measured {
        Some(found) => measured::in_short(found),
        None => "Not compared: `measured = \"reflectance.csv\"` lays a spectrometer’s values over these.".into(),
    };
    Some(context! {
        sentence,
        tone,
        verdict => Value::from_safe_string(prose(&verdict)),
        reason => warned.first().map(|warning| Value::from_safe_string(prose(&first_words(warning)))),
        more => match warned.len() {
            0 | 1 => "In full".into(),
            count => format!("All {count} things to know"),
        },
        figures,
        cost,
        match => Value::from_safe_string(prose(&matched)),
    })
}
