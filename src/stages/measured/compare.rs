//! Figures of a comparison: scale, relative error, correlation, curves and their peaks.

use std::f64::consts::PI;

use super::figures::{CurveResult, MeasuredColumn, MeasuredResult, PeakPair};
use super::kind::Kind;
use super::measurement::{Column, Measurement};
use super::model::Modelled;
use super::peaks::{Peaks, pairs, peaks_of_both};
use diffraction_build::ground::metrics::relative_l2;

/// Fewest samples that make a curve.
const CURVE_MIN: usize = 5;

/// Names of the coordinates that a curve may run along; the wavelength is the last.
const COORDINATES: [&str; 5] = ["theta_i_deg", "phi_i_deg", "theta_r_deg", "phi_r_deg", "wavelength_nm"];

/// The figures of a measurement for what the model says to its rows.
pub fn figures(measurement: &Measurement, modelled: &Modelled, file: String) -> MeasuredResult {
    MeasuredResult {
        file,
        rows: measurement.wavelength_nm.len(),
        acceptance_deg: measurement.config.acceptance_deg,
        bandwidth_nm: measurement.config.bandwidth_nm,
        samples: modelled.samples,
        notes: measurement.notes.iter().chain(&modelled.notes).cloned().collect(),
        columns: measurement.columns.iter().map(|column| of_column(measurement, modelled, column)).collect(),
    }
}

fn of_column(measurement: &Measurement, modelled: &Modelled, column: &Column) -> MeasuredColumn {
    let rows: Vec<usize> = (0..column.values.len()).filter(|&row| !column.values[row].is_nan()).collect();
    let model: Vec<f64> =
        (0..column.values.len()).map(|row| predicted(column.kind, measurement, modelled, row)).collect();
    let measured_at = |row: &usize| column.values[*row];
    let best_scale = {
        let [cross, own] = rows.iter().fold([0.0; 2], |[cross, own], &row| {
            [cross + model[row] * column.values[row], own + model[row] * model[row]]
        });
        cross / own
    };
    let scale = if column.kind.is_relative() { best_scale } else { 1.0 };
    let scaled: Vec<f64> = model.iter().map(|value| scale * value).collect();
    let pair = |rows: &[usize]| -> [Vec<f64>; 2] {
        [rows.iter().map(measured_at).collect(), rows.iter().map(|&row| scaled[row]).collect()]
    };
    let [measured, ours] = pair(&rows);
    let curves = (0..COORDINATES.len())
        .rev()
        .flat_map(|along| groups(measurement, &rows, along).into_iter().map(move |group| (along, group)));
    MeasuredColumn {
        name: column.name.clone(),
        kind: column.kind,
        values: rows.len(),
        relative_l2: relative_l2(&measured, &ours),
        correlation: correlation(&measured, &ours),
        scale,
        best_scale,
        curves: curves
            .filter_map(|(along, group)| curve(measurement, along, &group, &column.values, &scaled))
            .collect(),
    }
}

/// What the instrument would show, by the kind's formula.
fn predicted(kind: Kind, measurement: &Measurement, modelled: &Modelled, row: usize) -> f64 {
    let scatter = modelled.scatter_per_sr[row];
    let cosine = measurement.angles_deg[row][2].to_radians().cos();
    match kind {
        Kind::Brdf | Kind::RelativeRadiance => scatter / cosine,
        Kind::Scatter | Kind::RelativePower => scatter,
        Kind::RadianceFactor => PI * scatter / modelled.mean_cosine[row],
        Kind::ConeReflectance => modelled.cone_sr * scatter,
    }
}

fn coordinate(measurement: &Measurement, row: usize, index: usize) -> f64 {
    if index < 4 { measurement.angles_deg[row][index] } else { measurement.wavelength_nm[row] }
}

/// Rows that differ in one coordinate alone, sorted by it, group after group.
fn groups(measurement: &Measurement, rows: &[usize], along: usize) -> Vec<Vec<usize>> {
    let order = (0..COORDINATES.len()).filter(|&index| index != along);
    let fixed: Vec<usize> = order.collect();
    let compare = |a: &usize, b: &usize, indices: &[usize]| {
        let by = |&index: &usize| coordinate(measurement, *a, index).total_cmp(&coordinate(measurement, *b, index));
        indices.iter().map(by).find(|order| order.is_ne()).unwrap_or(std::cmp::Ordering::Equal)
    };
    let mut sorted = rows.to_vec();
    // The row's number comes last: the order of equals is that of the file.
    sorted.sort_by(|a, b| compare(a, b, &fixed).then(compare(a, b, &[along])).then(a.cmp(b)));
    sorted.chunk_by(|a, b| compare(a, b, &fixed).is_eq()).map(<[usize]>::to_vec).collect()
}

/// A group as a curve; `None` where it has too few distinct samples.
fn curve(
    measurement: &Measurement,
    along: usize,
    group: &[usize],
    values: &[f64],
    scaled: &[f64],
) -> Option<CurveResult> {
    let (mut at, mut measured, mut model) = (Vec::new(), Vec::new(), Vec::new());
    for repeats in group.chunk_by(|&a, &b| coordinate(measurement, a, along) == coordinate(measurement, b, along)) {
        let mean = |of: &[f64]| repeats.iter().map(|&row| of[row]).sum::<f64>() / repeats.len() as f64;
        at.push(coordinate(measurement, repeats[0], along));
        measured.push(mean(values));
        model.push(mean(scaled));
    }
    if at.len() < CURVE_MIN {
        return None;
    }
    // A slit blurs spectra, a cone the scans of angles.
    let resolution = match along {
        4 => measurement.config.bandwidth_nm,
        _ => measurement.config.acceptance_deg,
    };
    let Peaks { found, smoothing } = peaks_of_both(&at, &measured, &model, resolution);
    let pairs = pairs(&found[0], &found[1]);
    Some(CurveResult {
        along: COORDINATES[along].into(),
        angles_deg: measurement.angles_deg[group[0]],
        wavelength_nm: measurement.wavelength_nm[group[0]],
        relative_l2: relative_l2(&measured, &model),
        correlation: correlation(&measured, &model),
        peak_counts: [found[0].len(), found[1].len()],
        smoothing,
        peaks: pairs
            .into_iter()
            .map(|[measured, model]| PeakPair {
                measured: measured.at,
                model: model.at,
                prominence: [measured.prominence, model.prominence],
            })
            .collect(),
        at,
        measured,
        model,
    })
}

/// Pearson's correlation; NaN where either side is constant.
fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let mean = |of: &[f64]| of.iter().sum::<f64>() / of.len() as f64;
    let (mean_a, mean_b) = (mean(a), mean(b));
    let product = |f: &dyn Fn(f64, f64) -> f64| a.iter().zip(b).map(|(a, b)| f(a - mean_a, b - mean_b)).sum::<f64>();
    product(&|a, b| a * b) / (product(&|a, _| a * a) * product(&|_, b| b * b)).sqrt()
}
