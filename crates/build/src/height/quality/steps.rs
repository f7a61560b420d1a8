//! Steps from one side of the scan to the other.

use ndarray::{ArrayView2, Axis};

use super::finding::{Fault, Finding, Remedy};
use super::prepared::Prepared;
use crate::height::prepare::robust::{median, sigma_about};

/// Least step in rms heights.
const STEP_MIN_RMS: f64 = 0.1;

/// Least ratio to the next largest median step between neighbouring lines: of gratings there are several alike.
const RATIO_MIN: f64 = 3.0;

/// Least step in robust standard deviations of the others.
const SIGMAS_MIN: f64 = 6.0;

/// Part of the scan at either edge in which steps are not told: a tip that settles over the first lines leaves a seam.
const MARGIN: f64 = 1.0 / 16.0;

/// Share of samples that step by at least half of it: a step crosses the whole scan.
const CROSSES_MIN: f64 = 0.8;

/// Tells a single step that is three times the largest median step between any other two lines.
pub(super) fn check(prepared: &Prepared) -> Option<Finding> {
    let heights = prepared.levelled.heights_nm.view();
    let [nx, ny] = prepared.field.size();
    if let Some((column, step_nm)) = step(heights, Axis(1), prepared.rms_nm) {
        let kept = if column >= nx - column { [0, 0, column, ny] } else { [column, 0, nx - column, ny] };
        return Some(Finding {
            fault: Fault::Step,
            in_short: format!("a step of {:.0} nm", step_nm.abs()),
            sentence: format!(
                "A step of {:.1} nm crosses the whole scan between columns {} and {column}. Where the surface has no such edge and scans were \
                 joined, `{}` keeps the larger part.",
                step_nm.abs(),
                column - 1,
                Remedy::Crop(kept).toml()
            ),
            remedy: Some(Remedy::Crop(kept)),
        });
    }
    let (row, step_nm) = step(heights, Axis(0), prepared.rms_nm)?;
    Some(Finding {
        fault: Fault::Step,
        in_short: format!("a step of {:.0} nm", step_nm.abs()),
        sentence: format!(
            "A step of {:.1} nm crosses the whole scan between rows {} and {row}, as where the tip changed or scans were joined. \
             `level = \"rows\"` gives each line its own offset.",
            step_nm.abs(),
            row - 1
        ),
        remedy: Some(Remedy::Rows),
    })
}

/// Index of the line after a step across an axis, and its height.
fn step(heights: ArrayView2<f64>, axis: Axis, rms_nm: f64) -> Option<(usize, f64)> {
    let count = heights.len_of(axis);
    let rises = |line: usize| -> Vec<f64> {
        let [before, after] = [line - 1, line].map(|line| heights.index_axis(axis, line));
        after.iter().zip(before).map(|(after, before)| after - before).collect()
    };
    let mut steps: Vec<f64> = (1..count).map(|line| median(&mut rises(line))).collect();
    if steps.len() < 16 {
        return None;
    }
    let usual = median(&mut steps.clone());
    steps.iter_mut().for_each(|step| *step -= usual);
    let by_size = |a: &usize, b: &usize| steps[*a].abs().total_cmp(&steps[*b].abs());
    let largest = (0..steps.len()).max_by(by_size)?;
    let next = (0..steps.len()).filter(|index| *index != largest).max_by(by_size)?;
    let (line, step_nm) = (largest + 1, steps[largest]);
    let sigma = sigma_about(0.0, &steps);
    let margin = (MARGIN * count as f64).ceil() as usize;
    let stands_out = step_nm.abs() > STEP_MIN_RMS * rms_nm
        && step_nm.abs() > RATIO_MIN * steps[next].abs()
        && step_nm.abs() > SIGMAS_MIN * sigma
        && (margin..=count - margin).contains(&line);
    if !stands_out {
        return None;
    }
    let rises = rises(line);
    let crossing = rises.iter().filter(|rise| (**rise - usual) * step_nm.signum() > 0.5 * step_nm.abs()).count();
    (crossing as f64 >= CROSSES_MIN * rises.len() as f64).then_some((line, step_nm))
}
