//! What one wants to know of a specimen first: its colours, whether it is good, what it costs, whether it matches.

use minijinja::{Value, context};

use crate::report::error_facts::figures;
use crate::report::facts::{cost, warnings};
use crate::report::measured;
use crate::report::overview::first_words;
use crate::report::prose::prose;
use crate::stages::results::SpecimenResult;

/// What the template needs; `None` where there are no tables.
pub(crate) fn view(specimen: &SpecimenResult) -> Option<Value> {
    let cost = cost(specimen)?;
    let warned = warnings(specimen);
    let (tone, verdict) = match warned.len() {
        0 => ("green", "Nothing speaks against it.".to_owned()),
        1 => ("amber", "One thing to know:".to_owned()),
        count => ("amber", format!("{count} things to know, above all:")),
    };
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
        verdict,
        reason => warned.first().map(|warning| Value::from_safe_string(prose(&first_words(warning)))),
        more => if warned.len() > 1 { "All of them" } else { "In full" },
        figures,
        cost,
        match => Value::from_safe_string(prose(&matched)),
    })
}
