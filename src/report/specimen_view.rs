//! A specimen's section of the report.

use minijinja::{Value, context};

use crate::report::embed::{Album, missing};
use crate::report::error_facts::{self, by_cause};
use crate::report::facts::{self, Fact};
use crate::report::prose::prose;
use crate::report::scene_view::scene_view;
use crate::report::{budget_facts, frames, glance, goniometry, measured, numbers, plots, provenance};
use crate::stages::results::{SpecimenResult, StageTime};
use diffraction_brdf::error::Result;
use diffraction_build::accuracy::rows::ErrorRow;

/// What the template needs of a specimen.
pub(crate) fn specimen_section(
    number: usize,
    specimen: &SpecimenResult,
    stages: &[&StageTime],
    album: &mut Album,
) -> Result<Value> {
    let periods = specimen.statistics.as_ref().map_or(&[][..], |found| &found.dominant_periods);
    let height_map = match &specimen.height_map {
        Some(file) => Some(Value::from_safe_string(match album.picture(&file.png)? {
            Some(picture) => {
                let id = format!("heights-{number}");
                frames::height_frame(&picture.href, &id, specimen.extent_um, file)
            }
            None => missing(&file.png),
        })),
        None => None,
    };
    let replaced = specimen.height_map.as_ref().map(|file| file.replaced_samples).filter(|samples| *samples > 0);
    let spectrum = match &specimen.spectrum {
        Some(file) => Some(Value::from_safe_string(match album.picture(&file.png)? {
            Some(picture) => {
                let id = format!("spectrum-{number}");
                frames::spectrum_frame(&picture.href, &id, file, periods)
            }
            None => missing(&file.png),
        })),
        None => None,
    };
    let scenes = specimen.scenes.iter().map(|scene| scene_view(scene, album)).collect::<Result<Vec<Value>>>()?;
    let tolerance = specimen.build.as_ref().map(|built| built.tolerance);
    let rows = by_cause(&specimen.errors);
    let errors: Vec<(&ErrorRow, bool)> =
        rows.iter().map(|row| (row, tolerance.is_some_and(|tolerance| row.is_over(tolerance)))).collect();
    let over = errors.iter().any(|(_, over)| *over);
    let prose = |text: &str| Value::from_safe_string(prose(text));
    let goniometry = match &specimen.goniometry {
        Some(found) => Some(goniometry::view(found, periods, album)?),
        None => None,
    };
    Ok(context! {
        goniometry => goniometry,
        id => anchor(number),
        glance => glance::view(specimen),
        name => &specimen.name,
        species => specimen.species.clone().unwrap_or_default(),
        generated => specimen.generated,
        failed => specimen.failed.as_deref().map(prose),
        warnings => facts::warnings(specimen).iter().map(|warning| prose(warning)).collect::<Vec<_>>(),
        keeps => error_facts::what_would_keep(specimen).as_deref().map(prose),
        facts => fact_values(&facts::of_surface(specimen)),
        table_facts => fact_values(&facts::of_tables(specimen)),
        height_map => height_map,
        first_of => match specimen.scans.len() {
            0 | 1 => String::new(),
            count => format!(" of the first of {count} scans"),
        },
        replaced => replaced.map(|samples| numbers::count(samples as u64)),
        spectrum => spectrum,
        marks => facts::period_marks(periods),
        scenes => scenes,
        budget => specimen.budget.as_ref().map(budget_facts::budget),
        reached => match &specimen.reached_png {
            Some(path) => Some(Value::from_safe_string(album.img(path, "The part of the disc that is covered")?)),
            None => None,
        },
        errors => errors
            .iter()
            .enumerate()
            .map(|(index, &(row, over))| {
                let first = index == 0 || errors[index - 1].0.cause != row.cause;
                error_view(row, first, over)
            })
            .collect::<Vec<_>>(),
        error_plot => Value::from_safe_string(plots::error_plot(&rows, tolerance)),
        counted => error_facts::counted_directions(&rows),
        over => if over {
            format!(
                "Highlighted: above the tolerance of {} that was asked for.",
                numbers::round_percent(tolerance.unwrap_or(f64::NAN))
            )
        } else {
            String::new()
        },
        spectral_errors => spectral_errors(specimen),
        measured => specimen.measured.as_ref().map(|found| Value::from_safe_string(measured::section(found))),
        power_plot => Value::from_safe_string(plots::power_plot(&specimen.power_sums)),
        times => Value::from_safe_string(plots::time_plot(&by_stage(stages))),
        scans_title => if specimen.scans.len() == 1 { "The scan’s file" } else { "The scans’ files" },
        scans => specimen
            .scans
            .iter()
            .map(|scan| fact_values(&provenance::of_scan(scan)))
            .collect::<Vec<_>>(),
    })
}

/// Rows of the errors at single wavelengths; none where there are no spectral tables, or nothing was measured.
fn spectral_errors(specimen: &SpecimenResult) -> Vec<Value> {
    let rows = by_cause(specimen.spectral.as_ref().map_or(&[], |spectral| &spectral.errors));
    let is_first = |index: usize| index == 0 || rows[index - 1].cause != rows[index].cause;
    rows.iter().enumerate().map(|(index, row)| error_view(row, is_first(index), false)).collect()
}

/// A table row; only the first of a cause names it.
fn error_view(row: &ErrorRow, first: bool, over: bool) -> Value {
    context! {
        what => if first { row.cause.name() } else { "" },
        region => row.group.to_string(),
        directions => numbers::count(row.directions as u64),
        p50 => numbers::percent(row.p50),
        p95 => numbers::percent(row.p95),
        p99 => numbers::percent(row.p99),
        worst => numbers::percent(row.worst),
        l2 => numbers::percent(row.relative_l2),
        over => over,
    }
}

/// Elapsed seconds per stage, in the order in which the stages first occur.
pub(crate) fn by_stage(stages: &[&StageTime]) -> Vec<(String, f64)> {
    let mut sums: Vec<(String, f64)> = Vec::new();
    for stage in stages {
        match sums.iter_mut().find(|sum| sum.0 == stage.name.as_str()) {
            Some(sum) => sum.1 += stage.wall_s,
            None => sums.push((stage.name.to_string(), stage.wall_s)),
        }
    }
    sums
}

fn fact_values(facts: &[Fact]) -> Vec<Value> {
    facts.iter().map(|fact| context! { name => &fact.name, text => &fact.text }).collect()
}

/// Where a specimen's section is on the page.
pub(crate) fn anchor(number: usize) -> String {
    format!("specimen-{number}")
}
