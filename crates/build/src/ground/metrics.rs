//! Error measures: quantiles of relative errors, relative L2, CIEDE2000 between XYZ images.

use ndarray::{Array2, Array3, ArrayView1, Zip};
use palette::{Lab, color_difference::Ciede2000, convert::FromColorUnclamped, white_point::D65};
use serde::{Deserialize, Serialize};

/// Nearest-rank quantiles of a set of errors; all zero for an empty set.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct ErrorQuantiles {
    /// Median.
    pub p50: f64,
    /// 95th percentile.
    pub p95: f64,
    /// 99th percentile.
    pub p99: f64,
    /// Largest.
    pub worst: f64,
    /// Number of errors.
    pub count: usize,
}

/// CIEDE2000 differences between two images.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct ColourDifference {
    /// Mean over the pixels.
    pub mean: f64,
    /// 95th percentile.
    pub p95: f64,
    /// Largest.
    pub max: f64,
}

/// The value at or below which the share `q` of a sorted, non-empty slice lies (nearest rank).
pub(crate) fn quantile_of_sorted(sorted: &[f64], q: f64) -> f64 {
    let rank = (q * sorted.len() as f64).ceil() as usize;
    sorted[rank.clamp(1, sorted.len()) - 1]
}

/// Quantiles of errors, in any order. NaN sorts above every number and so shows as the worst.
pub fn quantiles(mut errors: Vec<f64>) -> ErrorQuantiles {
    if errors.is_empty() {
        return ErrorQuantiles::default();
    }
    // Clearing the sign keeps a negative NaN from sorting below every number.
    errors.iter_mut().for_each(|error| *error = error.abs());
    errors.sort_unstable_by(f64::total_cmp);
    ErrorQuantiles {
        p50: quantile_of_sorted(&errors, 0.50),
        p95: quantile_of_sorted(&errors, 0.95),
        p99: quantile_of_sorted(&errors, 0.99),
        worst: errors[errors.len() - 1],
        count: errors.len(),
    }
}

/// Quantiles of `|test - reference| / |reference|` over the entries with `|reference| > floor`.
///
/// Entries at or below the floor are left out, not counted as zero; compare `count` with the
/// length to see how many. Both slices must have the same length.
pub fn relative_error_quantiles(reference: &[f64], test: &[f64], floor: f64) -> ErrorQuantiles {
    assert_eq!(reference.len(), test.len(), "compared sets differ in length");
    let errors = reference
        .iter()
        .zip(test)
        // A NaN reference is kept so that it shows.
        .filter(|(r, _)| r.is_nan() || r.abs() > floor)
        .map(|(r, t)| (t - r).abs() / r.abs())
        .collect();
    quantiles(errors)
}

/// Quantiles of the largest relative error of three channels over the entries whose Y exceeds the floor: that of Y over Y, those
/// of X and Z over X + Y + Z, the share of it that a colour shows.
///
/// Chromaticity coordinates then shift by four times as much at most: `dx = (dX - x dS) / S` with `|dS| <= 3 e S`. Where all
/// channels are the same it is what [`relative_error_quantiles`] says of one. Both slices must have the same length.
pub fn colour_error_quantiles(reference: &[[f64; 3]], test: &[[f64; 3]], floor: f64) -> ErrorQuantiles {
    quantiles(colour_errors(reference, test, floor))
}

/// The errors of [`colour_error_quantiles`], one by one.
pub fn colour_errors(reference: &[[f64; 3]], test: &[[f64; 3]], floor: f64) -> Vec<f64> {
    assert_eq!(reference.len(), test.len(), "compared sets differ in length");
    let counts = |r: &[f64; 3]| r.iter().any(|x| x.is_nan()) || r[1].abs() > floor;
    reference.iter().zip(test).filter(|(r, _)| counts(r)).map(|(r, t)| colour_error(r, t)).collect()
}

fn colour_error(reference: &[f64; 3], test: &[f64; 3]) -> f64 {
    let sum = reference.iter().map(|x| x.abs()).sum::<f64>();
    let of = |c: usize| (test[c] - reference[c]).abs() / if c == 1 { reference[1].abs() } else { sum };
    // The maximum of numbers alone would pass over one that is none.
    (0..3).map(of).fold(0.0, |most: f64, error| {
        if error.is_nan() {
            error
        } else if most.is_nan() {
            most
        } else {
            most.max(error)
        }
    })
}

/// `‖test - reference‖₂ / ‖reference‖₂`; 0 when both are zero, infinite when only the reference is.
pub fn relative_l2(reference: &[f64], test: &[f64]) -> f64 {
    assert_eq!(reference.len(), test.len(), "compared sets differ in length");
    let difference: f64 = reference.iter().zip(test).map(|(r, t)| (t - r).powi(2)).sum();
    let norm: f64 = reference.iter().map(|r| r * r).sum();
    if difference == 0.0 {
        return 0.0;
    }
    (difference / norm).sqrt()
}

/// The luminances of an XYZ image `[rows, columns, 3]`, row by row.
pub fn luminances(image: &Array3<f32>) -> Vec<f64> {
    image.index_axis(ndarray::Axis(2), 1).iter().map(|&y| f64::from(y)).collect()
}

/// Per-pixel CIEDE2000 between two XYZ images; `white_luminance` is the Y of the white both are
/// seen against (the reciprocal of the exposure), its chromaticity D65.
///
/// The formula was fitted to surface colours: over-bright pixels are taken as they are, so a
/// difference between two lights far above white counts although a display shows neither.
pub fn ciede2000_map(reference: &Array3<f32>, test: &Array3<f32>, white_luminance: f64) -> Array2<f32> {
    pixel_map(reference, test, |r, t| lab(r, white_luminance).difference(lab(t, white_luminance)) as f32)
}

/// Per-pixel largest difference of X, Y or Z as a share of the reference white's luminance.
pub fn difference_to_white_map(reference: &Array3<f32>, test: &Array3<f32>, white_luminance: f64) -> Array2<f32> {
    pixel_map(reference, test, |r, t| {
        let largest = r
            .iter()
            .zip(t)
            .map(|(a, b)| (f64::from(*b) - f64::from(*a)).abs())
            // Unlike f64::max this keeps a NaN.
            .fold(0.0f64, |m, d| if d <= m || m.is_nan() { m } else { d });
        (largest / white_luminance) as f32
    })
}

/// Mean, 95th percentile and maximum of [`ciede2000_map`].
pub fn ciede2000(reference: &Array3<f32>, test: &Array3<f32>, white_luminance: f64) -> ColourDifference {
    let map = ciede2000_map(reference, test, white_luminance);
    if map.is_empty() {
        return ColourDifference::default();
    }
    let differences: Vec<f64> = map.iter().map(|&d| f64::from(d)).collect();
    let mean = differences.iter().sum::<f64>() / differences.len() as f64;
    let summary = quantiles(differences);
    ColourDifference { mean, p95: summary.p95, max: summary.worst }
}

fn pixel_map(
    reference: &Array3<f32>,
    test: &Array3<f32>,
    measure: impl Fn(ArrayView1<f32>, ArrayView1<f32>) -> f32,
) -> Array2<f32> {
    assert_eq!(reference.dim(), test.dim(), "compared images differ in size");
    let (rows, columns, channels) = reference.dim();
    assert_eq!(channels, 3, "an XYZ image has three channels");
    let mut map = Array2::zeros((rows, columns));
    Zip::from(&mut map)
        .and(reference.lanes(ndarray::Axis(2)))
        .and(test.lanes(ndarray::Axis(2)))
        .for_each(|out, r, t| *out = measure(r, t));
    map
}

/// CIELAB of an XYZ pixel.
fn lab(xyz: ArrayView1<f32>, white_luminance: f64) -> Lab<D65, f64> {
    let [x, y, z] = [0, 1, 2].map(|c| f64::from(xyz[c]) / white_luminance);
    // The plain conversion would clamp lights brighter than white.
    Lab::from_color_unclamped(palette::Xyz::<D65, f64>::new(x, y, z))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two CIELAB colours and their difference.
    type Pair = ([f64; 3], [f64; 3], f64);

    /// From the data published with Sharma, Wu and Dalal, "The CIEDE2000 color-difference formula:
    /// implementation notes, supplementary test data, and mathematical observations", 2005:
    /// pairs 1, 4, 7, 9, 13, 17, 20, 25, 29, 33 and 34.
    const SHARMA: [Pair; 11] = [
        ([50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485], 2.0425),
        ([50.0, -1.3802, -84.2814], [50.0, 0.0, -82.7485], 1.0000),
        ([50.0, 0.0, 0.0], [50.0, -1.0, 2.0], 2.3669),
        ([50.0, 2.49, -0.001], [50.0, -2.49, 0.0009], 7.1792),
        ([50.0, -0.001, 2.49], [50.0, 0.0009, -2.49], 4.8045),
        ([50.0, 2.5, 0.0], [73.0, 25.0, -18.0], 27.1492),
        ([50.0, 2.5, 0.0], [58.0, 24.0, 15.0], 19.4535),
        ([60.2574, -34.0099, 36.2677], [60.4626, -34.1751, 39.4387], 1.2644),
        ([22.7233, 20.0904, -46.694], [23.0331, 14.973, -42.5619], 2.0373),
        ([6.7747, -0.2908, -2.4247], [5.8714, -0.0985, -2.2286], 0.6377),
        ([2.0776, 0.0795, -1.135], [0.9033, -0.0636, -0.5514], 0.9082),
    ];

    #[test]
    fn ciede2000_meets_the_published_pairs() {
        for (first, second, expected) in SHARMA {
            let [p, q] = [first, second].map(|[l, a, b]| Lab::<D65, f64>::new(l, a, b));
            // The published figures have four decimals.
            assert!((p.difference(q) - expected).abs() < 1e-4, "{first:?}");
        }
    }

    /// The same pairs as pixels: checks the way from XYZ and the white's scaling.
    #[test]
    fn ciede2000_of_images_meets_the_published_pairs() {
        let white = 0.37;
        let image = |pick: fn(&Pair) -> [f64; 3]| {
            let mut image = Array3::zeros((1, SHARMA.len(), 3));
            for (column, pair) in SHARMA.iter().enumerate() {
                let [l, a, b] = pick(pair);
                let xyz = palette::Xyz::<D65, f64>::from_color_unclamped(Lab::new(l, a, b));
                for (channel, value) in [xyz.x, xyz.y, xyz.z].into_iter().enumerate() {
                    image[[0, column, channel]] = (value * white) as f32;
                }
            }
            image
        };
        let (first, second) = (image(|p| p.0), image(|p| p.1));
        let map = ciede2000_map(&first, &second, white);
        for (difference, (_, _, expected)) in map.iter().zip(SHARMA) {
            // f32 pixels: 6e-8 relative in XYZ is about 1e-5 in a and b, up to 4e-4 in the pairs
            // that straddle the neutral axis with 1e-3 of hue difference.
            assert!((f64::from(*difference) - expected).abs() < 1e-3, "{difference} {expected}");
        }
        let total = ciede2000(&first, &second, white);
        assert!((total.max - 27.1492).abs() < 1e-3);
        // Shown to depend on the white: another one gives other numbers.
        assert!((ciede2000(&first, &second, 2.0 * white).max - 27.1492).abs() > 0.1);
        assert_eq!(ciede2000(&first, &first, white), ColourDifference::default());
    }

    #[test]
    fn quantiles_are_nearest_rank_and_show_nan() {
        let errors: Vec<f64> = (1..=200).rev().map(f64::from).collect();
        let q = quantiles(errors);
        assert_eq!([q.p50, q.p95, q.p99, q.worst], [100.0, 190.0, 198.0, 200.0]);
        assert!(quantiles(vec![1.0, -f64::NAN, 2.0]).worst.is_nan());
        assert_eq!(quantiles(vec![]).count, 0);
    }

    #[test]
    fn relative_errors_leave_out_what_lies_below_the_floor() {
        let q = relative_error_quantiles(&[1.0, 1e-9, 2.0], &[1.1, 1.0, 1.0], 1e-6);
        assert_eq!(q.count, 2);
        assert!((q.worst - 0.5).abs() < 1e-15 && (q.p50 - 0.1).abs() < 1e-12);
        assert!(relative_error_quantiles(&[f64::NAN], &[1.0], 1e-6).worst.is_nan());
    }

    #[test]
    fn colours_err_by_their_share() {
        let exact = [0.1, 0.2, 0.7];
        // Z off by a tenth of all three; Y off by a tenth of itself; X by as much of itself is a hundredth of all.
        for (test, error) in [([0.1, 0.2, 0.8], 0.1), ([0.1, 0.22, 0.7], 0.1), ([0.11, 0.2, 0.7], 0.01)] {
            let found = colour_error_quantiles(&[exact], &[test], 1e-6);
            assert!(found.count == 1 && (found.worst - error).abs() < 1e-12, "{found:?}");
        }
        let grey = colour_error_quantiles(&[[2.0; 3]], &[[2.5; 3]], 1e-6);
        assert_eq!(grey.worst, relative_error_quantiles(&[2.0], &[2.5], 1e-6).worst);
        assert!(colour_error_quantiles(&[exact], &[[f64::NAN, 0.2, 0.7]], 1e-6).worst.is_nan());
        assert_eq!(colour_error_quantiles(&[[1.0, 1e-9, 1.0]], &[[2.0; 3]], 1e-6).count, 0);
    }

    #[test]
    fn relative_l2_of_a_scaled_vector_is_the_scale_error() {
        let reference = [3.0, -4.0, 12.0];
        let test = reference.map(|r| 1.01 * r);
        assert!((relative_l2(&reference, &test) - 0.01).abs() < 1e-14);
        assert_eq!(relative_l2(&[0.0], &[0.0]), 0.0);
        assert_eq!(relative_l2(&[0.0], &[1.0]), f64::INFINITY);
    }

    #[test]
    fn difference_to_white_takes_the_largest_channel() {
        let reference = Array3::from_elem((1, 1, 3), 1.0f32);
        let mut test = reference.clone();
        test[[0, 0, 2]] = 0.5;
        test[[0, 0, 0]] = 1.25;
        assert_eq!(difference_to_white_map(&reference, &test, 2.0)[[0, 0]], 0.25);
        test[[0, 0, 1]] = f32::NAN;
        assert!(difference_to_white_map(&reference, &test, 2.0)[[0, 0]].is_nan());
    }
}
