//! How many wavelengths an order of diffraction takes: pulses in 1/λ under a light that is not smooth.

use std::f64::consts::{SQRT_2, TAU};

use super::illuminant::Illuminant;
use super::wavenumbers::{Nodes, densities};

/// Share of the pulses, even over the wavelengths, that must be integrated to the tolerance.
const QUANTILE: f64 = 0.95;

/// Share of the brightest pulse's luminance up to which pulses do not count.
const FLOOR_SHARE: f64 = 1e-3;

/// Narrowest pulse that is tried, in nm at the short end: well within the nanometre between the observer's knots.
const NARROWEST_NM: f64 = 0.25;

/// Deviations beyond which a pulse is nothing: `exp(-6.5²/2)` = 7e-10.
const REACH: f64 = 6.5;

/// Fewest wavelengths of a continuous spectrum over what the eye sees: enough for whatever is smooth in it.
const FEWEST: usize = 24;

/// What is seen of light, in nm.
pub const VISIBLE_NM: [f64; 2] = [380.0, 780.0];

/// What limits the lags between two points of a surface that interfere, and so how fast a direction's light can change with
/// the wavelength.
///
/// Along a direction, `|P|²` as a function of `1/λ` is a sum over pairs of surface points of waves at the lag
/// `ρ Δx + |w| Δh`. The window weights `Δx` by `exp(-Δx²/4σ²)`: whatever the surface, its spectrum is made of Gaussian
/// pulses with the standard deviation `1/(2√2 π σ ρ)`, one for each line of a periodic surface. A grating shows a direction
/// one of them, where no errors average out, and so each is integrated to the tolerance. Relief modulates pulses by lags up to
/// `L = 2 |w|` times the half range of the heights. These have at most the variance `L²`; that of waves, of which the
/// outermost heights meet the outermost seldom, is `L²/4`, and variances of lags add: the pulses are taken to be
/// narrower by as much.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lags {
    /// Standard deviation in nm of the coherence window.
    pub sigma_nm: f64,
    /// Half the range of the heights in nm.
    pub half_height_range_nm: f64,
}

impl Lags {
    /// How many wavelengths integrate the luminance of 95 % of the pulses to a relative error, at a distance `radius` from the
    /// mirror direction in (u, v) and up to this `|w|`.
    pub fn wavelengths(
        &self,
        illuminant: &Illuminant,
        range_nm: [f64; 2],
        [radius, abs_w]: [f64; 2],
        tolerance: f64,
    ) -> usize {
        // Deviations of lag times 2π.
        let (window, relief) = (SQRT_2 * TAU * self.sigma_nm * radius, TAU * self.half_height_range_nm * abs_w);
        // A range wider than the eye's spreads the same nodes thinner over what it sees.
        let span = |[low_nm, high_nm]: [f64; 2]| 1.0 / low_nm - 1.0 / high_nm;
        let widening = (span(illuminant.reach_nm(range_nm)) / span(VISIBLE_NM)).max(1.0);
        let fewest = (widening * FEWEST as f64) as usize;
        wavenumbers_for_pulses(illuminant, range_nm, 1.0 / window.hypot(relief), tolerance, fewest)
    }
}

/// Wavenumbers of [`super::uniform_wavenumbers`] that integrate the luminance of 95 % of Gaussian pulses to a relative
/// error of `tolerance`, wherever in the spectrum they lie; never fewer than `fewest`. `deviation` is the pulses' standard
/// deviation in 1/nm.
///
/// Quadrature with nodes `δ` apart replaces the spectrum `Ŵ` of the light as seen by the observer by one of period `1/δ`,
/// equal to `Ŵ` up to about `1/(2δ)`, for that is what its polynomials resolve. A pulse of deviation `s` weights the
/// difference by its own spectrum `exp(-2π²s²τ²)`. Two things remain. The light's mean comes back at the lag `1/δ`, as in
/// the trapezoid rule: `2 exp(-2π²s²/δ²)`. But tables of lights are made of straight lines. A kink, a slope that changes by
/// `κ` times the light, has the spectrum `κ/(2πτ)²`, which from `1/(2δ)` on is wrong by as much as it is large. Weighted by
/// the pulse, whose spectrum falls there over a lag of `δ/(2π²s²)`, that is on both sides
///
/// ```text
/// 4 · κδ²/π² · exp(-π²s²/(2δ²)) · δ/(2π²s²) = (2/π⁴) κδ (δ/s)² exp(-π²s²/(2δ²))
/// ```
///
/// and rules: with daylight's `κδ` of 0.2 it is 6e-4 for `δ = 1.4 s` and 3e-5 for `δ = s`, where the trapezoid rule's own
/// term is 8e-5 and 5e-9. It hangs on the light's table, so the number is found by trying pulses in the light at hand
/// under the very weights that are used later: that counts each kink where it is, lines of lamps, and a spectrum cut
/// where it is bright.
fn wavenumbers_for_pulses(
    illuminant: &Illuminant,
    range_nm: [f64; 2],
    deviation: f64,
    tolerance: f64,
    fewest: usize,
) -> usize {
    if let Illuminant::Lines(lines) = illuminant {
        return lines.len();
    }
    let narrowest = NARROWEST_NM / range_nm[0].powi(2);
    if deviation < narrowest {
        // The narrower, the less a pulse sees of the light's unevenness: at most in proportion.
        let count = wavenumbers_for_pulses(illuminant, range_nm, narrowest, tolerance, 2);
        return (((count - 1) as f64 * narrowest / deviation).ceil() as usize + 1).max(fewest);
    }
    let span = 1.0 / range_nm[0] - 1.0 / range_nm[1];
    let pulses = Pulses::new(illuminant, range_nm, deviation.min(span));
    let enough = |count: usize| pulses.error(illuminant, count) <= tolerance;
    if enough(fewest) {
        return fewest;
    }
    let (mut too_few, mut count) = (fewest, fewest.max((span / deviation) as usize + 1));
    // Sixty-four nodes per deviation are beyond what rounding lets improve.
    while !enough(count) && (count as f64) < 64.0 * span / deviation {
        (too_few, count) = (count, 2 * count);
    }
    while count - too_few > 1 + count / 64 {
        let middle = (count + too_few) / 2;
        *(if enough(middle) { &mut count } else { &mut too_few }) = middle;
    }
    count
}

/// Pulses that are tried, and their exact luminance.
struct Pulses {
    range_nm: [f64; 2],
    /// Standard deviation in 1/nm.
    deviation: f64,
    /// Wavenumbers in 1/nm.
    centres: Vec<f64>,
    luminance: Vec<f64>,
}

impl Pulses {
    fn new(illuminant: &Illuminant, range_nm: [f64; 2], deviation: f64) -> Self {
        let [low, high] = range_nm;
        // A cell of half a deviation leaves 1e-9 of a pulse to the Gauss points in it.
        let points = densities(illuminant, range_nm, 0.5 * deviation * low * low);
        let count = ((4.0 * (1.0 / low - 1.0 / high) / deviation) as usize).clamp(64, 1024);
        let centre = |i: usize| 1.0 / (low + (i as f64 + 0.5) / count as f64 * (high - low));
        let luminance = |c: &f64| {
            let reach = REACH * deviation;
            let first = points.partition_point(|(nm, _)| 1.0 / nm > c + reach);
            let near = points[first..].iter().take_while(|(nm, _)| 1.0 / nm >= c - reach);
            near.map(|(nm, density)| density[1] * gaussian((1.0 / nm - c) / deviation)).sum()
        };
        let centres: Vec<f64> = (0..count).map(centre).collect();
        Self { range_nm, deviation, luminance: centres.iter().map(luminance).collect(), centres }
    }

    /// The quantile of the pulses' relative errors under the weights of `count` wavenumbers.
    fn error(&self, illuminant: &Illuminant, count: usize) -> f64 {
        let nodes = Nodes::new(self.range_nm, count);
        let weights = nodes.weights(illuminant);
        let brightest = self.luminance.iter().copied().fold(0.0, f64::max);
        let pulses = self.centres.iter().zip(&self.luminance).filter(|(_, exact)| **exact > FLOOR_SHARE * brightest);
        let error = |(centre, exact): (&f64, &f64)| {
            let (position, width) = ((centre - nodes.first()) / nodes.step, self.deviation / nodes.step);
            let first = (position - REACH * width).ceil().max(0.0) as usize;
            let last = ((position + REACH * width).floor().max(0.0) as usize).min(nodes.count - 1);
            let found: f64 = (first..=last).map(|j| weights[j][1] * gaussian((j as f64 - position) / width)).sum();
            (found / exact - 1.0).abs()
        };
        let mut errors: Vec<f64> = pulses.map(error).collect();
        errors.sort_by(f64::total_cmp);
        let last = errors.len().saturating_sub(1);
        errors.get((last as f64 * QUANTILE).ceil() as usize).copied().unwrap_or(0.0)
    }
}

fn gaussian(x: f64) -> f64 {
    (-0.5 * x * x).exp()
}

#[cfg(test)]
mod tests {
    use super::super::quadrature::uniform_wavelengths;
    use super::*;

    /// Errors of pulses by plain sums over 0.02 nm, for the product weights of `count` wavenumbers.
    fn errors(light: &Illuminant, range_nm: [f64; 2], deviation: f64, count: usize) -> Vec<f64> {
        let fine = uniform_wavelengths(light, range_nm, 0.02).unwrap();
        let coarse = super::super::uniform_wavenumbers(light, range_nm, count).unwrap();
        let sum = |q: &super::super::SpectralQuadrature, centre: f64| -> f64 {
            let terms = q.wavelengths_nm.iter().zip(&q.weights);
            terms.map(|(nm, weight)| weight[1] * gaussian((1.0 / nm - centre) / deviation)).sum()
        };
        let centres: Vec<f64> = (0..300)
            .map(|i| 1.0 / (range_nm[0] + 5.0 + i as f64 / 300.0 * (range_nm[1] - range_nm[0] - 10.0)))
            .collect();
        let exact: Vec<f64> = centres.iter().map(|&c| sum(&fine, c)).collect();
        let brightest = exact.iter().copied().fold(0.0, f64::max);
        let bright = centres.iter().zip(&exact).filter(|(_, e)| **e > FLOOR_SHARE * brightest);
        let mut errors: Vec<f64> = bright.map(|(&c, e)| (sum(&coarse, c) / e - 1.0).abs()).collect();
        errors.sort_by(f64::total_cmp);
        errors
    }

    #[test]
    fn as_many_as_it_says_keep_the_tolerance_and_two_thirds_do_not() {
        for (light, range_nm) in
            [(Illuminant::D65, [380.0, 780.0]), (Illuminant::E, [450.0, 650.0]), (Illuminant::F(11), [380.0, 780.0])]
        {
            // A window of σ = 4 µm at a radius of 1.
            let deviation = 1.0 / (std::f64::consts::TAU * std::f64::consts::SQRT_2 * 4_000.0);
            for tolerance in [1e-2, 1e-3, 1e-4] {
                let count = wavenumbers_for_pulses(&light, range_nm, deviation, tolerance, 2);
                let at = |count: usize| {
                    let errors = errors(&light, range_nm, deviation, count);
                    errors[errors.len() * 95 / 100]
                };
                println!("{light:?} {tolerance:e}: {count}, {:e} {:e}", at(count), at(count * 2 / 3));
                assert!(at(count) < 1.2 * tolerance, "{light:?} {tolerance:e}: {:e} with {count}", at(count));
                assert!(at(count * 2 / 3) > 1.5 * tolerance, "{light:?} {tolerance:e}: {count} are too many");
            }
        }
    }

    #[test]
    fn numbers_grow_in_proportion_to_narrow_pulses_and_are_few_for_wide_ones() {
        let count = |deviation: f64| wavenumbers_for_pulses(&Illuminant::D65, [380.0, 780.0], deviation, 1e-3, 24);
        assert_eq!(count(f64::INFINITY), 24);
        assert_eq!(count(1.0), 24);
        let (narrow, narrower) = (count(1e-6), count(1e-8));
        assert!(narrow > 500 && (narrower as f64 / narrow as f64 / 100.0 - 1.0).abs() < 0.01, "{narrow} {narrower}");
        let line = Illuminant::Lines(vec![super::super::Line { wavelength_nm: 633.0, power: 1.0 }]);
        assert_eq!(wavenumbers_for_pulses(&line, [380.0, 780.0], 1e-8, 1e-9, 24), 1);
    }
}
