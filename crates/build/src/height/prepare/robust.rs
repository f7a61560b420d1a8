//! Medians and spreads that a few outliers do not change.

/// Ratio of standard deviation to median absolute deviation of a normal distribution, `1 / Φ⁻¹(3/4)`.
pub(crate) const SIGMA_PER_MAD: f64 = 1.482_602_218_505_602;

/// Median, of an even number the mean of the middle two; reorders the values, of which there is at least one.
pub(crate) fn median(values: &mut [f64]) -> f64 {
    let middle = values.len() / 2;
    let odd = values.len() % 2 == 1;
    let (below, upper, _) = values.select_nth_unstable_by(middle, f64::total_cmp);
    let upper = *upper;
    if odd {
        return upper;
    }
    let lower = below.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    0.5 * lower + 0.5 * upper
}

/// Standard deviation of normal deviates about `middle`, from their median distance to it; of at least one value.
pub(crate) fn sigma_about(middle: f64, values: &[f64]) -> f64 {
    let mut distances: Vec<f64> = values.iter().map(|value| (value - middle).abs()).collect();
    SIGMA_PER_MAD * median(&mut distances)
}

/// The value below which a share (0 to 1) of the values lies; reorders them, of which there is at least one.
pub(crate) fn quantile(values: &mut [f64], share: f64) -> f64 {
    let index = (share * (values.len() - 1) as f64).round() as usize;
    *values.select_nth_unstable_by(index, f64::total_cmp).1
}
