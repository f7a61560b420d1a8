//! Tests of the checks: each fault made on several surfaces, sizes, amplitudes and places, and none on good ones.

use std::f64::consts::TAU;
use std::ops::Range;

use ndarray::Array2;
use proptest::prelude::*;

use super::*;
use crate::height::HeightField;
use crate::height::prepare::repair::{levelled, rms_nm};
use crate::height::synthesize::{Structure, synthesize};

/// Generated surfaces without a fault, with their names.
fn good(size: [usize; 2], seed: u64) -> Vec<(&'static str, HeightField)> {
    let pitch_nm = [62.5; 2];
    let rough = |rms_nm, correlation_length_nm| Structure::GaussianRough { rms_nm, correlation_length_nm, seed };
    [
        ("corn snake", Structure::CornSnake { seed }),
        ("sunbeam snake", Structure::SunbeamSnake { seed }),
        ("disc", Structure::CdTrack { seed }),
        ("fine rough", rough(20.0, 200.0)),
        ("coarse rough", rough(50.0, 1000.0)),
        ("sinusoid", Structure::Sinusoid { period_nm: 800.0, amplitude_nm: 60.0, direction_deg: 30.0 }),
        ("sinusoid across", Structure::Sinusoid { period_nm: 800.0, amplitude_nm: 60.0, direction_deg: 90.0 }),
        ("blazed", Structure::Blazed { period_nm: 2000.0, depth_nm: 250.0 }),
        ("lamellar", Structure::Lamellar { period_nm: 2000.0, depth_nm: 150.0, duty: 0.4 }),
        ("flat", Structure::Flat),
    ]
    .into_iter()
    .map(|(name, structure)| (name, synthesize(&structure, size, pitch_nm).unwrap()))
    .collect()
}

/// Rough surfaces, which is what faults are added to.
fn surface(which: usize, size: [usize; 2], seed: u64) -> HeightField {
    let structure = match which {
        0 => Structure::CornSnake { seed },
        1 => Structure::SunbeamSnake { seed },
        _ => Structure::GaussianRough { rms_nm: 30.0, correlation_length_nm: 400.0, seed },
    };
    synthesize(&structure, size, [62.5; 2]).unwrap()
}

/// Changes the heights of a part of the field, given as rows and columns.
fn change(field: &mut HeightField, rows: Range<usize>, columns: Range<usize>, to: impl Fn(f64) -> f64) {
    for row in rows {
        columns.clone().for_each(|column| field.heights_nm[[row, column]] = to(field.heights_nm[[row, column]]));
    }
}

fn faults(field: &HeightField) -> Vec<Fault> {
    advise(field).unwrap().findings.iter().map(|finding| finding.fault).collect()
}

fn rms(field: &HeightField) -> f64 {
    rms_nm(&levelled(field))
}

#[test]
fn good_surfaces_have_no_fault() {
    for size in [[256, 256], [320, 200], [200, 256]] {
        for (name, field) in good(size, 3) {
            assert_eq!(advise(&field).unwrap().findings, [], "{name} {size:?}");
        }
    }
}

#[test]
fn scans_too_small_to_tell_survive() {
    let mut random = fastrand::Rng::with_seed(1);
    for size in [[1, 1], [1, 9], [9, 1], [3, 3], [8, 40], [40, 2], [41, 17]] {
        let heights_nm = Array2::from_shape_simple_fn((size[1], size[0]), || 10.0 * random.f64());
        let field = HeightField { heights_nm, pitch_nm: [50.0; 2] };
        assert_eq!(faults(&field), [], "{size:?}");
    }
}

#[test]
fn a_decimal_comma_is_told_by_its_pixels() {
    let mut field = surface(0, [200, 160], 5);
    field.pitch_nm = [48.0, 8.0];
    let advice = advise(&field).unwrap();
    assert_eq!(advice.findings[0].fault, Fault::Pixels);
    assert!(advice.findings[0].sentence.contains("6.0 times") && advice.findings[0].sentence.contains("comma"));
    assert!(advice.left.is_empty(), "it may be meant");
    field.pitch_nm = [48.0, 12.0];
    assert_eq!(faults(&field), []);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(24) })]

    #[test]
    fn a_stopped_scan_is_cropped(which in 0usize..3, share in 0.1f64..0.8, value in -500.0f64..500.0, copies in any::<bool>()) {
        let clean = surface(which, [160, 128], 5);
        let kept = (share * 128.0) as usize;
        let mut field = clean.clone();
        let last = field.heights_nm.row(kept - 1).to_owned();
        for row in kept..128 {
            if copies { field.heights_nm.row_mut(row).assign(&last) } else { field.heights_nm.row_mut(row).fill(value) }
        }
        let advice = advise(&field).unwrap();
        prop_assert_eq!(advice.findings[0].fault, Fault::LostLines);
        prop_assert_eq!(advice.settings[0], Remedy::Crop([0, 0, 160, kept]));
        prop_assert!(advice.left.iter().all(|finding| finding.fault != Fault::LostLines));
    }

    #[test]
    fn lost_lines_are_filled_in(which in 0usize..3, rows in proptest::collection::btree_set(1usize..120, 1..6), value in -200.0f64..200.0) {
        let mut field = surface(which, [160, 128], 5);
        rows.iter().for_each(|row| field.heights_nm.row_mut(*row).fill(value));
        let advice = advise(&field).unwrap();
        prop_assert_eq!(advice.findings[0].fault, Fault::LostLines);
        prop_assert_eq!(&advice.settings, &[Remedy::Despike]);
        prop_assert_eq!(advice.left, []);
    }

    #[test]
    fn cut_off_heights_are_told(which in 0usize..3, share in 0.02f64..0.45, is_low in any::<bool>()) {
        let mut field = surface(which, [160, 128], 7);
        // A microscope's numbers are rounded.
        field.heights_nm.mapv_inplace(|height| (8.0 * height).round() / 8.0);
        let mut values: Vec<f64> = field.heights_nm.iter().copied().collect();
        let cut = crate::height::prepare::robust::quantile(&mut values, if is_low { share } else { 1.0 - share });
        field.heights_nm.mapv_inplace(|height| if is_low { height.max(cut) } else { height.min(cut) });
        let advice = advise(&field).unwrap();
        prop_assert_eq!(advice.findings[0].fault, Fault::Saturation);
        prop_assert_eq!(advice.left[0].fault, Fault::Saturation);
    }

    #[test]
    fn marks_for_missing_samples_are_told(
        which in 0usize..3, mark in 0usize..3, unit in prop_oneof![Just(1.0), Just(1e3)], side in 1usize..8, place in 0usize..100,
    ) {
        let mut field = surface(which, [160, 128], 7);
        let value = [-9999.0, -32768.0, 32767.0][mark];
        change(&mut field, place..place + side, place + 9..place + 9 + side, |_| value * unit);
        let advice = advise(&field).unwrap();
        prop_assert_eq!(advice.findings[0].fault, Fault::NoData);
        prop_assert_eq!(&advice.settings, &[Remedy::MissingValue(value)]);
        prop_assert_eq!(advice.left, []);
    }

    #[test]
    fn dust_is_told_with_its_number_and_masked(
        which in 0usize..3, pieces in proptest::collection::btree_set((1usize..7, 1usize..9), 1..4), side in 1usize..7, rise in 4.0f64..40.0, is_pit in any::<bool>(),
    ) {
        let clean = surface(which, [200, 160], 9);
        let (low, high) = crate::height::prepare::range_nm(&levelled(&clean));
        let mut field = clean.clone();
        for (row, column) in &pieces {
            let rise_nm = rise * (high - low) * if is_pit { -1.0 } else { 1.0 };
            change(&mut field, 20 * row..20 * row + side, 20 * column..20 * column + side, |height| height + rise_nm);
        }
        let advice = advise(&field).unwrap();
        prop_assert_eq!(advice.findings[0].fault, Fault::Blobs);
        let number = format!("{} spike", pieces.len());
        prop_assert!(advice.findings[0].sentence.starts_with(&number), "{}", advice.findings[0].sentence);
        prop_assert_eq!(&advice.settings, &[Remedy::Despike]);
        prop_assert_eq!(advice.left, []);
        prop_assert!(rms(&advice.prepared) < 1.1 * rms(&clean));
    }

    #[test]
    fn scars_are_told_and_masked(which in 0usize..3, rows in proptest::collection::btree_set(2usize..150, 1..12), length in 18usize..60, rise in 1.2f64..4.0) {
        let clean = surface(which, [200, 160], 11);
        let mut field = clean.clone();
        let height_nm = rise * rms(&clean);
        // No two beside each other.
        let rows: Vec<usize> = rows.into_iter().filter(|row| row % 3 == 0).collect();
        for row in &rows {
            change(&mut field, *row..row + 1, row / 2..row / 2 + length, |height| height + height_nm);
        }
        let advice = advise(&field).unwrap();
        if rows.is_empty() {
            prop_assert_eq!(advice.findings, []);
        } else {
            prop_assert_eq!(advice.findings[0].fault, Fault::Scars);
        }
    }

    #[test]
    fn lines_offset_against_each_other_are_told(which in 0usize..3, size in prop_oneof![Just([200, 160]), Just([96, 256])], share in 0.06f64..1.0, seed in any::<u64>()) {
        let mut field = surface(which, size, 13);
        let offset_nm = share * rms(&field);
        let mut random = fastrand::Rng::with_seed(seed);
        for mut row in field.heights_nm.rows_mut() {
            row += offset_nm * 12f64.sqrt() * (random.f64() - 0.5);
        }
        let advice = advise(&field).unwrap();
        prop_assert!(advice.findings.iter().any(|finding| finding.fault == Fault::LineOffsets), "{:?}", advice.findings);
        prop_assert_eq!(&advice.settings, &[Remedy::Rows]);
        prop_assert_eq!(advice.left, []);
    }

    #[test]
    fn a_bow_is_told(which in 0usize..3, ratio in 1.4f64..8.0, along_x in -1.0f64..1.0, is_valley in any::<bool>()) {
        let mut field = surface(which, [200, 160], 15);
        let bowl = Array2::from_shape_fn(field.heights_nm.dim(), |(row, column)| {
            let (x, y) = (column as f64 / 200.0 - 0.5, row as f64 / 160.0 - 0.5);
            (1.0 + along_x) * x * x + (1.0 - along_x) * y * y
        });
        let of_bowl = HeightField { heights_nm: bowl, pitch_nm: field.pitch_nm };
        let scale = ratio * rms(&field) / rms(&of_bowl) * if is_valley { 1.0 } else { -1.0 };
        field.heights_nm += &(scale * of_bowl.heights_nm);
        let advice = advise(&field).unwrap();
        prop_assert_eq!(advice.findings[0].fault, Fault::Bow);
        prop_assert_eq!(&advice.settings, &[Remedy::Quadratic]);
        prop_assert_eq!(advice.left, []);
    }

    #[test]
    fn a_steep_tilt_is_told(which in 0usize..3, degrees in 8.5f64..30.0, turn in 0.0f64..6.0) {
        let mut field = surface(which, [200, 160], 15);
        let slope = degrees.to_radians().tan();
        field.heights_nm.indexed_iter_mut().for_each(|((row, column), height)| {
            *height += 62.5 * slope * (turn.cos() * column as f64 - turn.sin() * row as f64);
        });
        let advice = advise(&field).unwrap();
        prop_assert_eq!(advice.findings[0].fault, Fault::Tilt);
        prop_assert_eq!(advice.settings, []);
        let unlevelled = findings(&field, &field);
        prop_assert_eq!(unlevelled[0].remedy, Some(Remedy::Plane));
    }

    #[test]
    fn a_step_between_two_parts_is_told(which in 0usize..3, share in 0.2f64..0.8, rise in 2.0f64..10.0, across in any::<bool>()) {
        let mut field = surface(which, [200, 160], 17);
        let step_nm = rise * rms(&field);
        let [rows, columns] = if across { [(share * 160.0) as usize, 0] } else { [0, (share * 200.0) as usize] };
        change(&mut field, rows..160, columns..200, |height| height + step_nm);
        let advice = advise(&field).unwrap();
        prop_assert!(advice.findings.iter().any(|finding| finding.fault == Fault::Step), "{:?}", advice.findings);
        prop_assert_eq!(advice.settings.len(), 1);
        prop_assert_eq!(advice.left, []);
    }

    #[test]
    fn a_high_step_is_no_bow(which in 0usize..3, share in 0.7f64..0.85, rise in 8.0f64..12.0) {
        let mut field = surface(which, [200, 160], 17);
        let step_nm = rise * rms(&field);
        change(&mut field, (share * 160.0) as usize..160, 0..200, |height| height + step_nm);
        let advice = advise(&field).unwrap();
        prop_assert_eq!(&advice.settings, &[Remedy::Rows]);
        prop_assert_eq!(advice.left, []);
    }

    #[test]
    // Between the strong orders of the sunbeam snake a hum may pass for a harmonic of theirs.
    fn hum_is_told(which in prop_oneof![Just(0usize), Just(2usize)], share in 0.4f64..0.9, waves in 3.0f64..20.0, lines in 2.1f64..4.5, phase in 0.0f64..6.0) {
        let mut field = surface(which, [200, 160], 19);
        let amplitude_nm = share * rms(&field);
        field.heights_nm.indexed_iter_mut().for_each(|((row, column), height)| {
            *height += amplitude_nm * (TAU * (waves * column as f64 / 200.0 + row as f64 / lines) + phase).cos();
        });
        prop_assert_eq!(faults(&field), [Fault::Hum]);
    }
}
