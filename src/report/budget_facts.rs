//! What tables for certain scenes leave out, as rows of the report.

use minijinja::{Value, context};

use super::numbers;
use diffraction_build::tables::coverage::budget::{Budget, BudgetRow, Cost};

/// Title, introduction and rows of a specimen's budget.
pub fn budget(budget: &Budget) -> Value {
    let rows: Vec<Value> = budget.rows.iter().map(|row| row_cells(row, budget)).collect();
    let restricted = [&budget.restricted].into_iter().chain(&budget.measured).map(cost_cells).collect::<Vec<_>>();
    context! {
        about => format!(
            "These tables cover {} and nothing else: {} of the disc of (u, v).",
            in_words(&budget.scenes),
            percent(budget.reached_share)
        ),
        restricted => restricted,
        rows => rows,
        measured => budget.rows.iter().any(|row| row.measured.is_some()),
    }
}

fn in_words(scenes: &[String]) -> String {
    match scenes {
        [one] => format!("the scene {one}"),
        [] => "no scene".into(),
        several => format!("the scenes {}", several.join(", ")),
    }
}

fn percent(share: f64) -> String {
    format!("{} %", numbers::number(100.0 * share, 2))
}

/// Sums, seconds, memory, bytes.
fn cost_cells(cost: &Cost) -> [String; 4] {
    let bytes = |count: f64| if count.is_finite() { numbers::bytes(count as u64) } else { numbers::MISSING.into() };
    [
        numbers::number(cost.node_samples, 2),
        numbers::seconds(cost.seconds),
        bytes(cost.memory_bytes),
        bytes(cost.stored_bytes),
    ]
}

fn row_cells(row: &BudgetRow, budget: &Budget) -> Value {
    let ratios = |with: &Cost, of: Option<&Cost>| {
        let ratio = |with: f64, of: Option<f64>| match of.map(|of| with / of) {
            Some(ratio) if ratio.is_finite() => format!("{} ×", numbers::number(ratio, 2)),
            _ => numbers::MISSING.into(),
        };
        let parts: [fn(&Cost) -> f64; 4] =
            [|cost| cost.node_samples, |cost| cost.seconds, |cost| cost.memory_bytes, |cost| cost.stored_bytes];
        parts.map(|part| ratio(part(with), of.map(part)))
    };
    context! {
        what => &row.what,
        why => &row.why,
        predicted => ratios(&row.with_it, Some(&budget.restricted)),
        found => row.measured.as_ref().map(|measured| ratios(measured, budget.measured.as_ref())),
        error => numbers::number(row.error_bound, 1),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn savings_are_ratios_to_the_restricted_tables() {
        let cost = |node_samples| Cost { node_samples, seconds: 1.0, memory_bytes: f64::NAN, stored_bytes: 2e6 };
        let row = BudgetRow {
            step: None,
            what: "all of it".into(),
            why: "x".into(),
            error_bound: 1e-5,
            with_it: cost(5e6),
            measured: None,
        };
        let view = budget(&Budget {
            scenes: vec!["ball".into()],
            reached_share: 0.25,
            restricted: cost(1e6),
            measured: Some(cost(1e6)),
            rows: vec![row],
        });
        assert!(view.get_attr("about").unwrap().to_string().contains("the scene ball and nothing else: 25 %"));
        let first = view.get_attr("rows").unwrap().get_item(&Value::from(0)).unwrap();
        assert_eq!(first.get_attr("predicted").unwrap().get_item(&Value::from(0)).unwrap().to_string(), "5.0 ×");
    }
}
