//! Tests of the statistics: closed forms, directions, degenerate fields.

use std::f64::consts::{SQRT_2, TAU};

use ndarray::Array2;
use proptest::prelude::*;

use super::*;

fn sinusoid(
    size: [usize; 2],
    pitch_nm: [f64; 2],
    amplitude_nm: f64,
    period_nm: f64,
    direction_deg: f64,
) -> HeightField {
    let (sin, cos) = direction_deg.to_radians().sin_cos();
    let heights_nm = Array2::from_shape_fn((size[1], size[0]), |(row, column)| {
        let (x, y) = (column as f64 * pitch_nm[0], -(row as f64) * pitch_nm[1]);
        amplitude_nm * (TAU * (x * cos + y * sin) / period_nm + 0.3).cos()
    });
    HeightField { heights_nm, pitch_nm }
}

fn angle_between(a: f64, b: f64) -> f64 {
    let d = (a - b).rem_euclid(180.0);
    d.min(180.0 - d)
}

proptest! {
    #[test]
    fn a_sinusoid_is_found_in_any_direction(period in 400.0f64..1500.0, direction in 0.0f64..180.0, pitch_y in 30.0f64..70.0) {
        let field = sinusoid([200, 160], [50.0, pitch_y], 40.0, period, direction);
        let found = statistics(&field, 400.0);
        prop_assert!(!found.dominant_periods.is_empty());
        let first = found.dominant_periods[0];
        prop_assert!((first.period_nm / period - 1.0).abs() < 2e-3, "{first:?}");
        prop_assert!(angle_between(first.direction_deg, direction) < 0.2, "{first:?}");
        prop_assert_eq!(first.relative_power, 1.0);
        prop_assert_eq!(found.dominant_periods.len(), 1);
    }
}

#[test]
fn a_sinusoid_meets_its_closed_forms() {
    // Whole periods, 40 samples each.
    let field = sinusoid([400, 300], [25.0, 25.0], 40.0, 1000.0, 0.0);
    let found = statistics(&field, 400.0);
    // The mean plane of whole cosines takes away less than 1 %.
    assert!((found.rms_height_nm / (40.0 / SQRT_2) - 1.0).abs() < 1e-2, "{found:?}");
    // A chord over 1/40 of a period is sinc(1/40) of the slope: 1 - 1.0e-3.
    assert!((found.rms_slope / (TAU * 40.0 / 1000.0 / SQRT_2) - 1.0).abs() < 4e-3, "{found:?}");
    assert!((found.peak_to_valley_nm / 80.0 - 1.0).abs() < 4e-3);
    let length = 1000.0 * (-1.0f64).exp().acos() / TAU;
    assert!((found.autocorrelation_length_nm / length - 1.0).abs() < 2e-2, "{found:?}");
    assert_eq!(found.usable_uv_radius, 2.0);
    assert_eq!(found.steep_share, 0.0);
}

#[test]
fn a_flat_field_is_said_to_be_flat() {
    for size in [[1, 1], [1, 9], [9, 1], [2, 2], [30, 20]] {
        let field = HeightField { heights_nm: Array2::from_elem((size[1], size[0]), 812.3), pitch_nm: [50.0, 60.0] };
        let found = statistics(&field, 380.0);
        assert_eq!((found.rms_height_nm, found.rms_slope, found.steep_share), (0.0, 0.0, 0.0));
        assert!(found.dominant_periods.is_empty() && found.warnings[0].contains("flat"));
    }
}

/// White noise smoothed by a Gaussian of 2 samples: rough, without a period or a preferred direction.
fn rough(size: [usize; 2], seed: u64) -> HeightField {
    let mut random = fastrand::Rng::with_seed(seed);
    let white = Array2::from_shape_simple_fn((size[1] + 12, size[0] + 12), || 10.0 * (random.f64() - 0.5));
    let weight = |j: usize, i: usize| (-((j as f64 - 6.0).powi(2) + (i as f64 - 6.0).powi(2)) / 8.0).exp();
    let around: Vec<_> = (0..13).flat_map(|j| (0..13).map(move |i| (j, i, weight(j, i)))).collect();
    let heights_nm = Array2::from_shape_fn((size[1], size[0]), |(row, column)| {
        around.iter().map(|&(j, i, weight)| weight * white[[row + j, column + i]]).sum::<f64>()
    });
    HeightField { heights_nm, pitch_nm: [50.0, 50.0] }
}

#[test]
fn a_rough_surface_has_no_period() {
    for seed in 0..20 {
        assert_eq!(statistics(&rough([120, 90], seed), 400.0).dominant_periods, []);
    }
}

/// Between the lines of a square scan, a wave of 2.4 periods is highest at the line of 2.8.
#[test]
fn a_wave_that_is_seen_fewer_than_two_and_a_half_times_is_no_period() {
    let side_nm = 100.0 * 50.0;
    for direction_deg in [0.0, 30.0, 45.0, 60.0] {
        let of = |waves: f64| {
            let field = sinusoid([100, 100], [50.0; 2], 40.0, side_nm / waves, direction_deg);
            statistics(&field, 400.0).dominant_periods
        };
        for waves in [0.7, 1.5, 2.0, 2.3, 2.4] {
            assert_eq!(of(waves), [], "{waves} waves at {direction_deg} degrees");
        }
        assert_eq!(of(3.0).len(), 1, "{direction_deg}");
    }
}

#[test]
fn what_a_scan_tells_begins_where_its_side_and_the_window_allow() {
    // 2.5 waves on 10 µm are a period of 4 µm.
    assert!((least_uv_radius(10_000.0, f64::INFINITY, 400.0) - 0.1).abs() < 1e-12);
    assert!(
        (least_uv_radius(10_000.0, 2_500.0, 400.0) - 0.1).abs() < 1e-12,
        "a quarter of the side hides nothing more"
    );
    assert!((least_uv_radius(10_000.0, 500.0, 400.0) - 0.212).abs() < 1e-12, "a narrow window does");
    // A lobe of amplitude deviation sigma: exp(-(2πσ ν/λ)²) is a half there, half of the full width away.
    let half_width = 0.5 * 0.265 / 500.0;
    assert!(((-(TAU * 500.0 * half_width).powi(2)).exp() - 0.5).abs() < 1e-3);
}

#[test]
fn two_gratings_and_a_rough_ground_are_told_apart() {
    let mut field = rough([200, 200], 1);
    let strong = sinusoid(field.size(), field.pitch_nm, 20.0, 800.0, 30.0);
    let weak = sinusoid(field.size(), field.pitch_nm, 10.0, 500.0, 120.0);
    field.heights_nm += &strong.heights_nm;
    field.heights_nm += &weak.heights_nm;
    let found = statistics(&field, 400.0).dominant_periods;
    assert_eq!(found.len(), 2, "{found:?}");
    for (period, (period_nm, direction_deg)) in found.iter().zip([(800.0, 30.0), (500.0, 120.0)]) {
        assert!((period.period_nm / period_nm - 1.0).abs() < 5e-3, "{period:?}");
        assert!(angle_between(period.direction_deg, direction_deg) < 0.5, "{period:?}");
    }
    // A quarter, but for what lines beside the peaks' centres lose: a factor of 0.52 at worst.
    assert!((0.25 * 0.52..0.25 / 0.52).contains(&found[1].relative_power), "{found:?}");
}

#[test]
fn a_slanted_facet_is_steep_from_one_half_on() {
    let ramp = |slope: f64| {
        let heights_nm = Array2::from_shape_fn((9, 12), |(row, column)| {
            slope * (0.6 * 40.0 * column as f64 - 0.8 * 25.0 * row as f64)
        });
        statistics(&HeightField { heights_nm, pitch_nm: [40.0, 25.0] }, 400.0)
    };
    assert_eq!((ramp(0.49).steep_share, ramp(0.51).steep_share), (0.0, 1.0));
    assert!((ramp(0.3).rms_slope - 0.3).abs() < 1e-12);
    // 0.51 * 0.6 * 40 nm is below a quarter of 400 nm; ten times as much is not.
    assert!(!ramp(0.51).warnings.iter().any(|warning| warning.contains("quarter")));
    assert!(ramp(5.1).warnings.iter().any(|warning| warning.contains("quarter")));
    // One half of a single line of samples rises.
    let heights_nm = Array2::from_shape_fn((1, 11), |(_, column)| 40.0 * column.min(5) as f64);
    let line = statistics(&HeightField { heights_nm, pitch_nm: [40.0, 25.0] }, 400.0);
    assert_eq!(line.steep_share, 0.5);
    assert_eq!(line.rms_slope, 0.5f64.sqrt());
}

#[test]
fn coarse_sampling_limits_the_directions() {
    let found = statistics(&sinusoid([60, 50], [100.0, 152.0], 5.0, 2000.0, 0.0), 380.0);
    assert_eq!(found.usable_uv_radius, 1.25);
    assert!(found.warnings.iter().any(|warning| warning.contains("1.25")));
    let line = statistics(&sinusoid([60, 1], [95.0, 1e6], 5.0, 2000.0, 0.0), 380.0);
    assert_eq!(line.usable_uv_radius, 2.0);
    assert!((line.dominant_periods[0].period_nm / 2000.0 - 1.0).abs() < 2e-2, "{line:?}");
}

#[test]
fn a_surface_larger_than_the_scan_has_no_correlation_length_and_survives_json() {
    let heights_nm = Array2::from_shape_fn((2, 3), |(row, column)| if row == 0 && column == 0 { 7.0 } else { 0.0 });
    let found = statistics(&HeightField { heights_nm, pitch_nm: [40.0, 25.0] }, 400.0);
    assert!(found.rms_height_nm > 0.0 && found.dominant_periods.is_empty());
    let flat = statistics(&HeightField { heights_nm: Array2::zeros((4, 4)), pitch_nm: [40.0, 25.0] }, 400.0);
    let text = serde_json::to_string(&flat).unwrap();
    assert!(text.contains("\"autocorrelation_length_nm\":null"));
    let back: Statistics = serde_json::from_str(&text).unwrap();
    assert!(back.autocorrelation_length_nm.is_nan());
    assert_eq!(serde_json::to_string(&back).unwrap(), text);
}

/// A profile along y (or x), the same in every column (or row).
#[test]
fn a_single_bump_has_no_period() {
    let bump = Array2::from_shape_fn((128, 128), |(j, i)| {
        100.0 * (-((i as f64 - 60.0).powi(2) + (j as f64 - 70.0).powi(2)) / 200.0).exp()
    });
    assert_eq!(statistics(&HeightField { heights_nm: bump, pitch_nm: [50.0; 2] }, 400.0).dominant_periods, []);
}

#[test]
fn rounding_of_a_slow_wave_is_no_period() {
    for waves in [0.3, 0.7, 1.0, 1.6] {
        let mut field = sinusoid([64, 64], [50.0; 2], 100.0, 3200.0 / waves, 20.0);
        for step_nm in [1e-5, 1e-2, 0.1] {
            field.heights_nm.mapv_inplace(|height| (height / step_nm).round() * step_nm);
            assert_eq!(statistics(&field, 400.0).dominant_periods, [], "{waves} {step_nm}");
        }
    }
}

/// What lies between the lines and beside slow waves that are ten times stronger is found in its place.
#[test]
fn a_period_beside_slow_waves_is_not_drawn_towards_them() {
    for waves in [6.5, 6.61, 7.3, 9.5] {
        let side_nm = 256.0 * 39.1;
        let mut field = sinusoid([256, 256], [39.1; 2], 30.0, side_nm / waves, 8.0);
        let slow = sinusoid(field.size(), field.pitch_nm, 300.0, side_nm / 0.9, 5.0);
        field.heights_nm += &slow.heights_nm;
        let found = statistics(&field, 400.0).dominant_periods;
        assert!((found[0].period_nm / (side_nm / waves) - 1.0).abs() < 0.03, "{waves}: {found:?}");
    }
}

/// A flat surface whose lines are offset: each by itself, or each from the one before.
fn offset_lines(seed: u64, wander: bool) -> HeightField {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut offset_nm = 0.0;
    let mut heights_nm = Array2::zeros((128, 96));
    for mut line in heights_nm.rows_mut() {
        let step_nm = 20.0 * (random.f64() - 0.5);
        offset_nm = if wander { offset_nm + step_nm } else { step_nm };
        line.fill(offset_nm);
    }
    HeightField { heights_nm, pitch_nm: [50.0; 2] }
}

#[test]
fn offsets_between_lines_are_no_period() {
    for wander in [false, true] {
        let told = (0..100).filter(|seed| !statistics(&offset_lines(*seed, wander), 400.0).dominant_periods.is_empty());
        let told = told.count();
        println!("wander {wander}: {told} of 100 scans have a period");
        // One in a hundred is expected.
        assert!(told <= 5, "wander {wander}: {told}");
    }
    // A wave along the lines' own offsets is one: of their own size, under them.
    let mut wave = offset_lines(1, false);
    for (row, mut line) in wave.heights_nm.rows_mut().into_iter().enumerate() {
        line += 20.0 * (TAU * row as f64 / 12.8).sin();
    }
    let found = statistics(&wave, 400.0).dominant_periods;
    assert!((found[0].period_nm / 640.0 - 1.0).abs() < 0.02, "{found:?}");
}
