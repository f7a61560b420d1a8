//! Seams where a repeated scan meets itself.

use ndarray::{ArrayView1, Axis};

use crate::height::HeightField;

/// Ratio of the seam's step to the largest between neighbouring lines from which on the reader is warned. Of surfaces
/// that repeat, and of scans whose edges are blended, it is at most 1; of eight scans as they were measured, 1.6 to 45.
const RATIO_WARNED: f64 = 1.5;

/// Root mean square steps below this change no colour: at 380 nm they scatter `(4π step/λ)²` = 1e-5 of the light.
const STEP_MIN_NM: f64 = 0.1;

/// Warns where opposite edges of a scan that repeats do not fit: the jump from the last line to the first is larger than
/// every one between neighbours, which diffracts into a bright cross.
pub fn seam_warning(field: &HeightField) -> Option<String> {
    let axes = [(1, "left and right"), (0, "upper and lower")];
    let (seam_nm, ratio, edges) = axes
        .into_iter()
        .filter_map(|(axis, edges)| seam(field, axis).map(|(seam_nm, ratio)| (seam_nm, ratio, edges)))
        .filter(|&(seam_nm, ratio, _)| seam_nm > STEP_MIN_NM && ratio > RATIO_WARNED)
        .max_by(|a, b| a.1.total_cmp(&b.1))?;
    Some(format!(
        "The {edges} edges do not fit each other: where the scan repeats (edge = \"auto\", \"tile\"), its heights jump by {seam_nm:.1} nm \
         rms, {} times as much as between any neighbouring lines, which shows as a bright cross. `blend_nm` makes the edges \
         fit; edge = \"fade\" does without repeating.",
        if ratio < 1e3 { format!("{ratio:.1}") } else { "over 1000".into() }
    ))
}

/// Root mean square step in nm from the last line to the first, and its ratio to the largest between neighbouring lines;
/// `None` where there are too few lines to tell.
fn seam(field: &HeightField, axis: usize) -> Option<(f64, f64)> {
    let lines: Vec<ArrayView1<f64>> = field.heights_nm.axis_iter(Axis(axis)).collect();
    let (Some(first), Some(last), true) = (lines.first(), lines.last(), lines.len() > 2) else { return None };
    let step_nm = |from: &ArrayView1<f64>, to: &ArrayView1<f64>| {
        let sum: f64 = from.iter().zip(to).map(|(a, b)| (a - b) * (a - b)).sum();
        (sum / from.len() as f64).sqrt()
    };
    let largest_nm = lines.windows(2).map(|pair| step_nm(&pair[0], &pair[1])).fold(0.0, f64::max);
    let seam_nm = step_nm(last, first);
    Some((seam_nm, if seam_nm > 0.0 { seam_nm / largest_nm } else { 0.0 }))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use ndarray::Array2;

    use super::*;

    /// A wave of so many periods along x over 100 columns, constant along y.
    fn wave(periods: f64) -> HeightField {
        let heights_nm = Array2::from_shape_fn((8, 100), |(_, i)| 50.0 * (TAU * periods * i as f64 / 100.0).sin());
        HeightField { heights_nm, pitch_nm: [50.0; 2] }
    }

    #[test]
    fn waves_fit_by_whole_periods_alone() {
        assert_eq!(seam_warning(&wave(3.0)), None);
        let warning = seam_warning(&wave(3.25)).unwrap();
        assert!(
            warning.contains("left and right") && warning.contains("`blend_nm`") && warning.contains("fade"),
            "{warning}"
        );
        // 50 nm at the end against steps of at most 50 · 2π · 3.25 / 100 nm inside.
        assert!(warning.contains("jump by 49.") || warning.contains("jump by 50."), "{warning}");
    }

    #[test]
    fn the_worse_of_two_seams_is_named() {
        let mut field = wave(3.25);
        field.heights_nm.indexed_iter_mut().for_each(|((j, _), height)| *height += 100.0 * j as f64);
        let warning = seam_warning(&field).unwrap();
        assert!(warning.contains("upper and lower") && warning.contains("700.0 nm"), "{warning}");
    }

    #[test]
    fn rounding_and_single_lines_are_no_seams() {
        let mut field = wave(4.0);
        field.heights_nm[[7, 5]] += 1e-9;
        assert_eq!(seam_warning(&field), None);
        let line = HeightField { heights_nm: Array2::from_shape_fn((1, 2), |(_, i)| i as f64), pitch_nm: [50.0; 2] };
        assert_eq!(seam_warning(&line), None);
        let flat = HeightField { heights_nm: Array2::zeros((9, 9)), pitch_nm: [50.0; 2] };
        assert_eq!(seam_warning(&flat), None);
    }
}
