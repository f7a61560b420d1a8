//! Peaks of sampled curves: where they are, how far they stand out, and which of two curves' peaks belong together.

/// Least prominence of a peak as a share of the curve's range: what the skirts of lobes leave out.
const PROMINENCE: f64 = 0.05;

/// Least prominence in standard deviations of what smoothing leaves of the noise: the highest of some hundred values of noise stands
/// three above their mean, the deepest beside it three below.
const PROMINENCE_SIGMAS: f64 = 6.0;

/// Share of the curve's span that smoothing may reach over, as full width at half maximum.
const SMOOTHING_MAX: f64 = 1.0 / 12.0;

/// Factor between two widths that are tried.
const WIDER: f64 = 1.25;

/// A peak of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// Its place, in the curve's coordinate.
    pub at: f64,
    /// How far one must descend from it to reach higher ground, as a share of the curve's range.
    pub prominence: f64,
}

/// The peaks of a measured curve and of its model, smoothed alike.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Peaks {
    /// Those of the measurement and of the model, ascending.
    pub found: [Vec<Peak>; 2],
    /// Full width at half maximum of the Gaussian that both were smoothed with, in the curve's coordinate; 0 for none.
    pub smoothing: f64,
}

/// Peaks of a curve and of its model at the same places `at`, which increase strictly. Both are smoothed by the instrument's
/// resolution (full width at half maximum, 0 where it is not known), and further while the measurement's noise would pass for peaks.
///
/// The noise is what single values stand off the line between their neighbours, beyond what those of the model do.
pub fn peaks_of_both(at: &[f64], measured: &[f64], model: &[f64], resolution: f64) -> Peaks {
    if at.len() < 3 {
        return Peaks::default();
    }
    let [noise, own] = [measured, model].map(|values| roughness(at, values));
    let noise = (noise * noise - own * own).max(0.0).sqrt();
    let span = at[at.len() - 1] - at[0];
    let spacing = span / (at.len() - 1) as f64;
    let mut width = resolution.min(span * SMOOTHING_MAX);
    let (smooth, left) = loop {
        let (smooth, share) = smoothed(at, measured, width);
        let left = noise * share;
        let wider = (width * WIDER).max(1.5 * spacing);
        if PROMINENCE_SIGMAS * left <= PROMINENCE * range(&smooth) || wider > span * SMOOTHING_MAX {
            break (smooth, left);
        }
        width = wider;
    };
    let (model, _) = smoothed(at, model, width);
    Peaks { found: [peaks(at, &smooth, PROMINENCE_SIGMAS * left), peaks(at, &model, 0.0)], smoothing: width }
}

fn range(values: &[f64]) -> f64 {
    let (low, high) = values.iter().fold((f64::MAX, f64::MIN), |(low, high), &v| (low.min(v), high.max(v)));
    high - low
}

/// Standard deviation of noise that is independent from value to value, by the median of what values stand off the line between
/// their neighbours: a few peaks do not move it.
fn roughness(at: &[f64], values: &[f64]) -> f64 {
    let off = |index: usize| {
        let share = (at[index] - at[index - 1]) / (at[index + 1] - at[index - 1]);
        let off = values[index] - (1.0 - share) * values[index - 1] - share * values[index + 1];
        off.abs() / (1.0 + share * share + (1.0 - share).powi(2)).sqrt()
    };
    let mut found: Vec<f64> = (1..values.len() - 1).map(off).collect();
    found.sort_by(f64::total_cmp);
    // The median of a normal variable's modulus is 0.6745 of its standard deviation.
    found[found.len() / 2] / 0.6745
}

/// Weighted means under a Gaussian of a full width at half maximum; and the share of independent noise that is left, at the median
/// place.
fn smoothed(at: &[f64], values: &[f64], width: f64) -> (Vec<f64>, f64) {
    if width <= 0.0 {
        return (values.to_vec(), 1.0);
    }
    let mut left = Vec::with_capacity(at.len());
    let mean = |&place: &f64| {
        // Beyond two widths the Gaussian is below 2e-5.
        let first = at.partition_point(|&x| x < place - 2.0 * width);
        let end = at.partition_point(|&x| x <= place + 2.0 * width);
        let (mut sum, mut weights, mut squares) = (0.0, 0.0, 0.0);
        for index in first..end {
            let weight = (-4.0 * std::f64::consts::LN_2 * ((at[index] - place) / width).powi(2)).exp();
            sum += weight * values[index];
            weights += weight;
            squares += weight * weight;
        }
        left.push(squares.sqrt() / weights);
        sum / weights
    };
    let smooth = at.iter().map(mean).collect();
    left.sort_by(f64::total_cmp);
    (smooth, left[left.len() / 2])
}

/// A curve's peaks, ascending, of at least this prominence and [`PROMINENCE`] of its range. A maximum at either end is none, for the
/// curve may go on rising. Between samples the place is that of a Gaussian (where the three values around it are positive) or a
/// parabola through the highest and its neighbours.
fn peaks(at: &[f64], values: &[f64], least: f64) -> Vec<Peak> {
    let range = range(values);
    let least = least.max(PROMINENCE * range);
    let mut found = Vec::new();
    let mut index = 1;
    while index + 1 < values.len() {
        // A plateau counts as one sample in its middle.
        let mut end = index;
        while end + 1 < values.len() && values[end + 1] == values[index] {
            end += 1;
        }
        let is_top = values[index - 1] < values[index] && end + 1 < values.len() && values[end + 1] < values[index];
        let prominence = if is_top { prominence(values, index, end) } else { 0.0 };
        if is_top && prominence >= least && least > 0.0 {
            let at = if end > index { 0.5 * (at[index] + at[end]) } else { vertex(at, values, index) };
            found.push(Peak { at, prominence: prominence / range });
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
pub fn pairs(measured: &[Peak], model: &[Peak]) -> Vec<[Peak; 2]> {
    let nearest = |place: f64, list: &[Peak]| {
        list.iter().copied().min_by(|a, b| (a.at - place).abs().total_cmp(&(b.at - place).abs()))
    };
    let mutual = |peak: &Peak| {
        let other = nearest(peak.at, model)?;
        (nearest(other.at, measured)?.at == peak.at).then_some([*peak, other])
    };
    measured.iter().filter_map(mutual).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(at: &[f64], f: impl Fn(f64) -> f64) -> Vec<f64> {
        at.iter().map(|&x| f(x)).collect()
    }

    fn places(at: &[f64], values: &[f64]) -> Vec<f64> {
        peaks(at, values, 0.0).into_iter().map(|peak| peak.at).collect()
    }

    #[test]
    fn a_gaussian_is_found_exactly_on_uneven_samples() {
        let at = [0.0, 0.8, 1.1, 2.0, 2.4, 3.3, 4.0];
        let found = places(&at, &curve(&at, |x| (-(x - 2.13f64).powi(2)).exp()));
        assert_eq!(found.len(), 1);
        assert!((found[0] - 2.13).abs() < 1e-12, "{found:?}");
        // With a negative neighbour a parabola is taken; this one is a parabola.
        let found = places(&at, &curve(&at, |x| 0.1 - (x - 2.13f64).powi(2)));
        assert!((found[0] - 2.13).abs() < 1e-12, "{found:?}");
    }

    #[test]
    fn ends_ripples_and_constants_are_no_peaks() {
        let at: Vec<f64> = (0..50).map(f64::from).collect();
        assert!(places(&at, &at).is_empty());
        assert!(places(&at, &[1.0; 50]).is_empty());
        assert!(places(&at[..2], &[1.0, 2.0]).is_empty());
        let rippled = curve(&at, |x| (-((x - 25.0) / 8.0).powi(2)).exp() + 0.02 * (2.0 * x).cos());
        assert_eq!(places(&at, &rippled).len(), 1);
        let two = curve(&at, |x| (-((x - 12.0) / 3.0).powi(2)).exp() + 0.3 * (-((x - 33.0) / 3.0).powi(2)).exp());
        let found = peaks(&at, &two, 0.0);
        assert_eq!(found.len(), 2);
        assert!((found[0].prominence - 1.0).abs() < 0.01 && (found[1].prominence - 0.3).abs() < 0.01, "{found:?}");
        let plateau = [0.0, 1.0, 1.0, 1.0, 0.0];
        assert_eq!(places(&at[..5], &plateau), [2.0]);
    }

    /// Noise of 15 % of the peak, as a weak spectrum at 1 nm has it: one peak and no others, where it is, whatever the noise.
    #[test]
    fn noise_of_fifteen_per_cent_makes_no_peaks_and_hides_none() {
        let at: Vec<f64> = (0..301).map(|i| 400.0 + f64::from(i)).collect();
        let model = curve(&at, |nm| 0.05 + (-((nm - 523.0) / 36.0f64).powi(2)).exp());
        let mut random = fastrand::Rng::with_seed(3);
        let mut normal = || (0..12).map(|_| random.f64()).sum::<f64>() - 6.0;
        let (mut raw, mut worst) = (0, 0f64);
        for slit in [0.0, 5.0] {
            for _ in 0..200 {
                let measured: Vec<f64> = model.iter().map(|value| value + 0.15 * normal()).collect();
                raw += places(&at, &measured).len();
                let Peaks { found: [ours, models], .. } = peaks_of_both(&at, &measured, &model, slit);
                assert_eq!((ours.len(), models.len()), (1, 1), "{ours:?}");
                worst = worst.max((ours[0].at - 523.0).abs());
                assert!((models[0].at - 523.0).abs() < 0.1);
            }
        }
        // A top of this curvature under 25 nm of smoothing errs by 1.7 nm in the mean, and by five times that in 400 trials rarely.
        assert!(worst < 8.5, "{worst}");
        assert!(raw > 400 * 10, "without smoothing there are {raw} peaks");
    }

    #[test]
    fn a_clean_curve_is_not_smoothed_and_lines_between_samples_are_no_noise() {
        let at: Vec<f64> = (0..60).map(|i| 400.0 + 5.0 * f64::from(i)).collect();
        // Fringes of three samples a period, which only the model tells from noise.
        let fringes = curve(&at, |nm| 1.0 + 0.5 * (nm * std::f64::consts::TAU / 17.0).cos());
        let found = peaks_of_both(&at, &fringes, &fringes, 0.0);
        assert_eq!(found.smoothing, 0.0);
        assert!(found.found[0].len() > 14 && found.found[0] == found.found[1]);
        assert_eq!(peaks_of_both(&at, &fringes, &fringes, 8.0).smoothing, 8.0, "the slit is always taken");
    }

    #[test]
    fn peaks_pair_only_with_each_others_nearest() {
        let of = |places: &[f64]| places.iter().map(|&at| Peak { at, prominence: 1.0 }).collect::<Vec<_>>();
        let paired = |a: &[f64], b: &[f64]| {
            pairs(&of(a), &of(b)).into_iter().map(|pair| pair.map(|peak| peak.at)).collect::<Vec<_>>()
        };
        assert_eq!(paired(&[10.0, 20.0, 30.0], &[11.0, 29.0]), [[10.0, 11.0], [30.0, 29.0]]);
        assert!(paired(&[], &[1.0]).is_empty() && paired(&[1.0], &[]).is_empty());
    }
}
