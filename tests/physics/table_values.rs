//! Tables against an independent evaluator's figures.

use crate::common::surfaces::{centred, quantile, stretched, tables};
use crate::common::{Case, bundled_cases, whole_cases};
use diffraction_brdf::direction::wave_vector_change;
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_build::height::HeightField;

/// Rows darker than this (1/sr) are not compared: the issue is visible light.
const FLOOR_PER_SR: f64 = 1e-6;

/// Asked of the tables: basis and wavelengths may err by as much each, and so may the independent
/// evaluator (see `reference_values`).
const TOLERANCE: f64 = 1e-3;

/// The error of the luminance allowed in 95 % of the rows. Basis, wavelengths and the independent evaluator
/// take 3e-3. The coarsest grid below, the tile's, holds 1.5 texels per deviation of the lobe at 450 nm, where
/// the cubic errs by 3/128 (1/1.5)⁴ 3 = 1.4 % at a sharp peak; a row mixes many such peaks of either sign.
const ALLOWED: f64 = 1e-2;

/// Relative errors of the luminance outside the coherent lobe and inside it.
struct Errors {
    outside: Vec<f64>,
    inside: Vec<f64>,
}

fn errors(case: &Case, told: &HeightField, size: usize) -> [Errors; 2] {
    let set = tables(&centred(told.clone()), &case.optics, TOLERANCE, Some(size));
    let radius_max = set.lobe.as_ref().unwrap().radius_max;
    println!("{}: {} tables of {size}², lobe up to {radius_max:.4}", case.name, set.tables.len());
    [Interpolation::Bilinear, Interpolation::Cubic].map(|interpolation| {
        let mut errors = Errors { outside: Vec::new(), inside: Vec::new() };
        for row in case.rows.iter().filter(|row| row.xyz[1] > FLOOR_PER_SR) {
            let q = wave_vector_change(row.wi, row.wo);
            let error = (brdf_xyz(&set, interpolation, row.wi, row.wo)[1] / row.xyz[1] - 1.0).abs();
            let part = if q[0].hypot(q[1]) > radius_max { &mut errors.outside } else { &mut errors.inside };
            part.push(error);
        }
        for (part, errors) in [("outside", &errors.outside), ("inside", &errors.inside)] {
            if !errors.is_empty() {
                let [a, b, c, d] = [0.5, 0.95, 0.99, 1.0].map(|share| quantile(errors, share));
                println!(
                    "  {interpolation:?}, {part} the lobe, {} rows: p50 {a:.1e}, p95 {b:.1e}, p99 {c:.1e}, worst {d:.1e}",
                    errors.len()
                );
            }
        }
        errors
    })
}

/// Texels along each axis of whole scans: 1.5 (tile), 2.9 (snakes), 5 and 3.8 (gratings) per deviation at 450 nm.
fn size(case: &Case) -> usize {
    if case.name == "sinusoid_1600nm" { 1501 } else { 2001 }
}

/// Three texels per deviation on gratings, more than five on pieces of snakes, whose windows are narrower.
fn small_size(case: &Case) -> usize {
    if case.optics.sigma_nm < 3_000.0 { 901 } else { 1201 }
}

#[test]
fn tables_meet_the_independent_evaluator() {
    for case in bundled_cases().into_iter().filter(|case| case.name != "sinusoid_1600nm") {
        check(&case, small_size(&case), 10);
    }
}

#[test]
#[ignore = "slow: whole scans"]
fn tables_of_whole_scans_meet_the_independent_evaluator() {
    let Some(shared) = crate::skip::shared("") else { return };
    for case in whole_cases(&shared) {
        check(&case, size(&case), 80);
    }
}

/// Compares a case in at least so many rows outside the lobe.
fn check(case: &Case, size: usize, rows: usize) {
    let [_, cubic] = errors(case, &case.field, size);
    assert!(cubic.outside.len() >= rows, "{}: {} rows are too few to speak of", case.name, cubic.outside.len());
    let p95 = quantile(&cubic.outside, 0.95);
    assert!(p95 < ALLOWED, "{}: {p95:e}", case.name);
}

#[test]
fn a_pitch_wrong_by_one_percent_fails() {
    let case = bundled_cases().into_iter().find(|case| case.name == "elaphe_guttata_fade").unwrap();
    let [_, cubic] = errors(&case, &stretched(&case.field, 1.01), small_size(&case));
    let p95 = quantile(&cubic.outside, 0.95);
    assert!(p95 > 3.0 * ALLOWED, "{p95:e}");
}
