//! Choosing one of several things with given probabilities.

use std::ops::Range;

/// Chooses one of `range` with probabilities in proportion to `mass`, all alike where there is none: the index, and what is
/// left of the number `u` in [0, 1).
pub(super) fn choose(range: Range<usize>, u: f64, mass: impl Fn(usize) -> f64) -> (usize, f64) {
    let total: f64 = range.clone().map(&mass).sum();
    if total.is_nan() || total <= 0.0 {
        let at = u * range.len() as f64;
        let index = (at as usize).min(range.len() - 1);
        return (range.start + index, (at - index as f64).min(1.0));
    }
    let (target, mut below) = (u * total, 0.0);
    let mut last = (range.start, 0.0, 0.0);
    for index in range {
        let here = mass(index);
        if here > 0.0 {
            last = (index, here, below);
            if target < below + here {
                break;
            }
        }
        below += here;
    }
    let (index, here, below) = last;
    (index, ((target - below) / here).clamp(0.0, 1.0))
}

/// The probability with which [`choose`] takes `index`.
pub(super) fn probability(range: Range<usize>, index: usize, mass: impl Fn(usize) -> f64) -> f64 {
    let total: f64 = range.clone().map(&mass).sum();
    if total > 0.0 { mass(index) / total } else { 1.0 / range.len() as f64 }
}
