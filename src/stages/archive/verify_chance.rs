//! How far fresh errors may lie above recorded quantiles by chance: an exact bound, whatever the errors' distribution.

/// Chance that an intact atlas fails anywhere in one call of `verify`.
pub(super) const FALSE_ALARMS_MAX: f64 = 1e-4;

/// Share that lies at or below a quantile, and the rank of that quantile among `count` sorted values (nearest rank, from 1).
fn rank(count: usize, quantile: f64) -> usize {
    ((quantile * count as f64).ceil() as usize).clamp(1, count.max(1))
}

/// Whether so many of `fresh` errors above a quantile of `recorded` ones have a chance below `alpha`, if both come from one
/// continuous distribution; whichever it is does not matter. Values that are equal only lower the chance.
///
/// The share of the distribution above the `r`-th smallest of `m` values is beta distributed, with `m - r + 1` and `r`; so the
/// number above it among `n` others is beta-binomial (David and Nagaraja, Order Statistics, 2003, section 7.2).
pub(super) fn is_implausible(above: usize, fresh: usize, recorded: usize, quantile: f64, alpha: f64) -> bool {
    if recorded == 0 || above == 0 {
        return false;
    }
    let r = rank(recorded, quantile) as f64;
    tail(above, fresh, recorded as f64 - r + 1.0, r) < alpha
}

/// Chance of at least `k` of `n` for a beta-binomial distribution.
fn tail(k: usize, n: usize, alpha: f64, beta: f64) -> f64 {
    // From the last term down: each is the one after it times a ratio, in logarithms, since they span hundreds of decades.
    let mut log_term: f64 = (0..n).map(|j| (alpha + j as f64).ln() - (alpha + beta + j as f64).ln()).sum();
    let mut sum = log_term.exp();
    for j in (k..n).rev() {
        let (taken, left) = (j as f64, (n - j) as f64);
        log_term += ((taken + 1.0) * (beta + left - 1.0)).ln() - (left * (alpha + taken)).ln();
        sum += log_term.exp();
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tail_is_that_of_counting() {
        // Of one fresh value among three recorded ones all four places are equally likely: above the middle one are two of them.
        assert!((tail(1, 1, 2.0, 2.0) - 0.5).abs() < 1e-14);
        // Two fresh among one recorded: both above it in one of three orders, at least one in two.
        assert!((tail(2, 2, 1.0, 1.0) - 1.0 / 3.0).abs() < 1e-14 && (tail(1, 2, 1.0, 1.0) - 2.0 / 3.0).abs() < 1e-14);
        assert!((tail(0, 64, 65.0, 64.0) - 1.0).abs() < 1e-12 && (tail(0, 5000, 7.0, 122.0) - 1.0).abs() < 1e-9);
        // Few recorded ones never say that all fresh ones are too large.
        assert!(!is_implausible(64, 64, 5, 0.5, 1e-4));
        assert!(is_implausible(64, 64, 128, 0.5, 1e-6) && !is_implausible(40, 64, 128, 0.5, 1e-6));
    }

    /// Draws with a generator in place of errors: no more alarms than allowed, and no far fewer.
    #[test]
    fn alarms_come_as_often_as_allowed_and_no_oftener() {
        let mut random = fastrand::Rng::with_seed(5);
        for (quantile, recorded, fresh) in [(0.5, 128, 64), (0.95, 128, 64), (0.95, 9, 16)] {
            let allowed = 0.02;
            let runs = 20_000;
            let alarms = (0..runs).filter(|_| {
                let mut known: Vec<f64> = (0..recorded).map(|_| random.f64()).collect();
                known.sort_by(f64::total_cmp);
                let limit = known[rank(recorded, quantile) - 1];
                let above = (0..fresh).filter(|_| random.f64() > limit).count();
                is_implausible(above, fresh, recorded, quantile, allowed)
            });
            let share = alarms.count() as f64 / f64::from(runs);
            // Whole numbers jump over the bound, and four standard deviations of this count are 0.004.
            assert!(share < allowed + 0.004 && (share > 0.0 || recorded < 10), "{quantile} {recorded}: {share}");
        }
    }
}
