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
