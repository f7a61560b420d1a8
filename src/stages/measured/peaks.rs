//! Peaks of sampled curves: where they are, and which of two curves' peaks belong together.

/// Least prominence of a peak as a share of the curve's range: what noise and the skirts of lobes leave out.
const PROMINENCE: f64 = 0.05;

/// Places of a curve's peaks, ascending. `at` increases strictly; a maximum at either end is none, for the curve
/// may go on rising. Between samples the place is that of a Gaussian (where the three values around it are
/// positive) or a parabola through the highest and its neighbours.
pub fn peaks(at: &[f64], values: &[f64]) -> Vec<f64> {
    let (low, high) = values.iter().fold((f64::MAX, f64::MIN), |(low, high), &v| (low.min(v), high.max(v)));
    let least = PROMINENCE * (high - low);
    let mut found = Vec::new();
    let mut index = 1;
    while index + 1 < values.len() {
        // A plateau counts as one sample in its middle.
        let mut end = index;
        while end + 1 < values.len() && values[end + 1] == values[index] {
            end += 1;
        }
        let is_top = values[index - 1] < values[index] && end + 1 < values.len() && values[end + 1] < values[index];
        if is_top && prominence(values, index, end) >= least && least > 0.0 {
            found.push(if end > index { 0.5 * (at[index] + at[end]) } else { vertex(at, values, index) });
        }
        index = end + 1;
    }
    found
}

/// How far one must descend from a top to reach higher ground on either side.
fn prominence(values: &[f64], first: usize, last: usize) -> f64 {
    let top = values[first];
    let descent = |side: &mut dyn Iterator<Item = &f64>| {
        side.take_while(|&&value| value <= top).fold(top, |low, &value| low.min(value))
    };
    let saddle = descent(&mut values[..first].iter().rev()).max(descent(&mut values[last + 1..].iter()));
    top - saddle
}

/// Top of the parabola through three samples, of their logarithms where those exist.
fn vertex(at: &[f64], values: &[f64], index: usize) -> f64 {
    let [a, b, c] = [at[index - 1], at[index], at[index + 1]];
    let mut y = [values[index - 1], values[index], values[index + 1]];
    if y.iter().all(|&y| y > 0.0) {
        y = y.map(f64::ln);
    }
    let (left, right) = ((y[1] - y[0]) / (b - a), (y[2] - y[1]) / (c - b));
    let curvature = (right - left) / (c - a);
    if curvature >= 0.0 {
        return b;
    }
    // The slope at the middle between a and b is `left`; it falls by 2 curvature per unit.
    (0.5 * (a + b) - 0.5 * left / curvature).clamp(a, c)
}

/// Pairs of peaks that are each other's nearest, in the order of the first list.
pub fn pairs(measured: &[f64], model: &[f64]) -> Vec<[f64; 2]> {
    let nearest =
        |place: f64, list: &[f64]| list.iter().copied().min_by(|a, b| (a - place).abs().total_cmp(&(b - place).abs()));
    let mutual = |&m: &f64| {
        let other = nearest(m, model)?;
        (nearest(other, measured) == Some(m)).then_some([m, other])
    };
    measured.iter().filter_map(mutual).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(at: &[f64], f: impl Fn(f64) -> f64) -> Vec<f64> {
        at.iter().map(|&x| f(x)).collect()
    }

    #[test]
    fn a_gaussian_is_found_exactly_on_uneven_samples() {
        let at = [0.0, 0.8, 1.1, 2.0, 2.4, 3.3, 4.0];
        let found = peaks(&at, &curve(&at, |x| (-(x - 2.13f64).powi(2)).exp()));
        assert_eq!(found.len(), 1);
        assert!((found[0] - 2.13).abs() < 1e-12, "{found:?}");
        // With a negative neighbour a parabola is taken; this one is a parabola.
        let found = peaks(&at, &curve(&at, |x| 0.1 - (x - 2.13f64).powi(2)));
        assert!((found[0] - 2.13).abs() < 1e-12, "{found:?}");
    }

    #[test]
    fn ends_ripples_and_constants_are_no_peaks() {
        let at: Vec<f64> = (0..50).map(f64::from).collect();
        assert!(peaks(&at, &at).is_empty());
        assert!(peaks(&at, &[1.0; 50]).is_empty());
        assert!(peaks(&at[..2], &[1.0, 2.0]).is_empty());
        let rippled = curve(&at, |x| (-((x - 25.0) / 8.0).powi(2)).exp() + 0.02 * (2.0 * x).cos());
        assert_eq!(peaks(&at, &rippled).len(), 1);
        let two = curve(&at, |x| (-((x - 12.0) / 3.0).powi(2)).exp() + 0.3 * (-((x - 33.0) / 3.0).powi(2)).exp());
        assert_eq!(peaks(&at, &two).len(), 2);
        let plateau = [0.0, 1.0, 1.0, 1.0, 0.0];
        assert_eq!(peaks(&at[..5], &plateau), [2.0]);
    }

    #[test]
    fn peaks_pair_only_with_each_others_nearest() {
        assert_eq!(pairs(&[10.0, 20.0, 30.0], &[11.0, 29.0]), [[10.0, 11.0], [30.0, 29.0]]);
        assert!(pairs(&[], &[1.0]).is_empty() && pairs(&[1.0], &[]).is_empty());
    }
}
