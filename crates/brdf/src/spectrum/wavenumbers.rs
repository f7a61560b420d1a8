//! Product quadrature on uniform wavenumbers.

use super::illuminant::{Illuminant, observer_2deg};
use super::quadrature::{SpectralQuadrature, lines_quadrature, normalised};
use crate::direction::Xyz;
use crate::error::Result;

/// Nodes and weights of Gauss and Legendre on [0, 1], exact up to degree 7.
const GAUSS: [[f64; 2]; 4] = [
    [0.069_431_844_202_973_71, 0.173_927_422_568_726_93],
    [0.330_009_478_207_571_9, 0.326_072_577_431_273_07],
    [0.669_990_521_792_428_1, 0.326_072_577_431_273_07],
    [0.930_568_155_797_026_3, 0.173_927_422_568_726_93],
];

/// Most nodes that one interpolating polynomial goes through, half of them on each side of the point, and how many it
/// goes through at the spectrum's ends, where one side has fewer.
///
/// In the middle a polynomial through twenty nodes is as good as the series of sines over all of them: it holds waves of
/// up to 0.4 periods per node. One-sided it would amplify what is not resolved by thousands; six do by five.
const NODES_MOST: usize = 20;
const NODES_AT_ENDS: usize = 6;

/// Product quadrature on `count` uniform wavenumbers (1/λ): the integrand is interpolated by local polynomials through up
/// to twenty nodes and integrated exactly against the illuminant and the observer.
///
/// These two are linear between the knots of their tables, with kinks that no rule of equal weights integrates. Here only
/// the integrand has to be resolved by the nodes; [`super::Lags::wavelengths`] says how many that takes.
///
/// # Errors
/// `Error::Call` if the light has no luminous power within the range.
pub fn uniform_wavenumbers(illuminant: &Illuminant, range_nm: [f64; 2], count: usize) -> Result<SpectralQuadrature> {
    if let Illuminant::Lines(lines) = illuminant {
        return lines_quadrature(lines);
    }
    let nodes = Nodes::new(range_nm, count);
    normalised((0..nodes.count).map(|j| nodes.wavelength_nm(j)).collect(), nodes.weights(illuminant))
}

/// [`uniform_wavenumbers`] with the light seen through a filter, which passes `share` of a wavelength in nm: the weights hold it
/// exactly, however few they are, and are normalised by the light without it.
///
/// # Errors
/// As [`uniform_wavenumbers`].
pub fn filtered_wavenumbers(
    illuminant: &Illuminant,
    range_nm: [f64; 2],
    count: usize,
    share: impl Fn(f64) -> f64,
) -> Result<SpectralQuadrature> {
    let plain = uniform_wavenumbers(illuminant, range_nm, count)?;
    if let Illuminant::Lines(_) = illuminant {
        let weights =
            plain.wavelengths_nm.iter().zip(&plain.weights).map(|(&nm, weight)| weight.map(|w| w * share(nm)));
        return Ok(SpectralQuadrature { weights: weights.collect(), ..plain });
    }
    let nodes = Nodes::new(range_nm, count);
    let luminous: f64 = nodes.weights(illuminant).iter().map(|weight| weight[1]).sum();
    let weights = nodes.weights_through(illuminant, share).into_iter().map(|weight| weight.map(|w| w / luminous));
    Ok(SpectralQuadrature { weights: weights.collect(), ..plain })
}

/// Uniform wavenumbers from the longest wavelength to the shortest.
pub(super) struct Nodes {
    range_nm: [f64; 2],
    pub(super) count: usize,
    /// Distance in 1/nm.
    pub(super) step: f64,
}

impl Nodes {
    pub(super) fn new(range_nm: [f64; 2], count: usize) -> Self {
        let count = count.max(2);
        Self { range_nm, count, step: (1.0 / range_nm[0] - 1.0 / range_nm[1]) / (count - 1) as f64 }
    }

    /// Wavenumber of the first node in 1/nm.
    pub(super) fn first(&self) -> f64 {
        1.0 / self.range_nm[1]
    }

    fn wavelength_nm(&self, j: usize) -> f64 {
        if j + 1 == self.count { self.range_nm[0] } else { 1.0 / (self.first() + j as f64 * self.step) }
    }

    /// Weights for X, Y, Z before they are normalised.
    pub(super) fn weights(&self, illuminant: &Illuminant) -> Vec<Xyz> {
        self.weights_through(illuminant, |_| 1.0)
    }

    /// The same of the light that a filter passes.
    fn weights_through(&self, illuminant: &Illuminant, share: impl Fn(f64) -> f64) -> Vec<Xyz> {
        let mut weights = vec![[0.0; 3]; self.count];
        let polynomials: Vec<Vec<f64>> = (0..=NODES_MOST).map(barycentric).collect();
        let mut cardinals = [0.0; NODES_MOST];
        // No cell is wider than the closest wavelengths lie, or nodes between its points would go without weight.
        for (nm, density) in densities(illuminant, self.range_nm, self.step * self.range_nm[0].powi(2)) {
            let position = (1.0 / nm - self.first()) / self.step;
            let below = (position as usize + 1).min(self.count - 1);
            let through = (2 * below.min(self.count - below)).clamp(NODES_AT_ENDS, NODES_MOST).min(self.count);
            let start = below.saturating_sub(through / 2).min(self.count - through);
            let cardinals = &mut cardinals[..through];
            interpolate(&polynomials[through], position - start as f64, cardinals);
            let density = density.map(|d| d * share(nm));
            for (weight, cardinal) in weights[start..].iter_mut().zip(cardinals) {
                for (sum, d) in weight.iter_mut().zip(density) {
                    *sum += *cardinal * d;
                }
            }
        }
        weights
    }
}

/// Points over a range with the density of the light seen by the observer, times the points' own weights: cells between
/// the knots of either table, and no wider than asked for.
pub(super) fn densities(illuminant: &Illuminant, range_nm: [f64; 2], widest_nm: f64) -> Vec<(f64, Xyz)> {
    let [low, high] = range_nm;
    // The observer's knots are whole; so are those of the CIE's lights.
    let mut knots: Vec<f64> = (low.ceil() as i64..=high.floor() as i64).map(|nm| nm as f64).collect();
    if let Illuminant::Tabulated { wavelength_nm, .. } = illuminant {
        knots.extend(wavelength_nm.iter().filter(|nm| (low..=high).contains(nm)));
    }
    knots.extend(range_nm);
    knots.sort_by(f64::total_cmp);
    knots.dedup();
    let mut points = Vec::new();
    for pair in knots.windows(2) {
        let cells = ((pair[1] - pair[0]) / widest_nm).ceil().max(1.0);
        let cell_nm = (pair[1] - pair[0]) / cells;
        for (cell, [place, share]) in (0..cells as usize).flat_map(|cell| GAUSS.map(|point| (cell, point))) {
            let nm = pair[0] + (cell as f64 + place) * cell_nm;
            let scale = illuminant.power(nm) * cell_nm * share;
            points.push((nm, observer_2deg(nm).map(|c| c * scale)));
        }
    }
    points
}

/// Barycentric weights of equidistant nodes: binomial coefficients of alternating sign.
fn barycentric(count: usize) -> Vec<f64> {
    let mut weight = 1.0;
    (0..count)
        .map(|j| {
            let here = weight;
            weight *= -((count - 1 - j) as f64) / (j + 1) as f64;
            here
        })
        .collect()
}

/// Values at `x` of the polynomials that are one at one of the nodes 0, 1, 2, ... and zero at the others.
fn interpolate(barycentric: &[f64], x: f64, cardinals: &mut [f64]) {
    let mut sum = 0.0;
    for (j, (cardinal, weight)) in cardinals.iter_mut().zip(barycentric).enumerate() {
        let distance = x - j as f64;
        *cardinal = weight / if distance == 0.0 { f64::MIN_POSITIVE.sqrt() } else { distance };
        sum += *cardinal;
    }
    cardinals.iter_mut().for_each(|cardinal| *cardinal /= sum);
}

#[cfg(test)]
mod tests {
    use super::super::quadrature::uniform_wavelengths;
    use super::*;

    fn integrate(q: &SpectralQuadrature, f: impl Fn(f64) -> f64) -> Xyz {
        let mut sum = [0.0; 3];
        for (nm, weight) in q.wavelengths_nm.iter().zip(&q.weights) {
            sum.iter_mut().zip(weight).for_each(|(sum, weight)| *sum += weight * f(*nm));
        }
        sum
    }

    #[test]
    fn cardinal_polynomials_interpolate_polynomials_exactly_nodes_included() {
        for count in [2, 6, 7, 20] {
            let weights = barycentric(count);
            let mut cardinals = vec![0.0; count];
            for x in [-0.4, 0.0, 0.3, 1.0, 2.5] {
                let p = |x: f64| {
                    (0..count).fold(1.0, |product, j| if j == 1 { product } else { product * (x / 9.0 - 0.1) + 0.5 })
                };
                interpolate(&weights, x, &mut cardinals);
                let value: f64 = cardinals.iter().enumerate().map(|(j, c)| c * p(j as f64)).sum();
                assert!((value - p(x)).abs() < 1e-8, "{count} nodes at {x}: {value} {}", p(x));
            }
        }
    }

    #[test]
    fn product_weights_integrate_oscillations_like_a_fine_trapezoid() {
        // Lag 10 µm in 1/λ: 13.5 periods over the visible range. A lamp of lines passes more of it on
        // to XYZ than daylight does and needs more nodes for the same error.
        let f = |nm: f64| 1.0 + (std::f64::consts::TAU * 10_000.0 / nm).cos();
        for (illuminant, nodes) in [(Illuminant::D65, 41), (Illuminant::F(11), 49)] {
            let fine = integrate(&uniform_wavelengths(&illuminant, [380.0, 780.0], 0.05).unwrap(), f);
            let coarse = integrate(&uniform_wavenumbers(&illuminant, [380.0, 780.0], nodes).unwrap(), f);
            for c in 0..3 {
                assert!((coarse[c] - fine[c]).abs() < 1e-3, "{illuminant:?} {coarse:?} {fine:?}");
            }
        }
    }

    #[test]
    fn a_filter_is_in_the_weights_however_few_they_are() {
        let edge = |nm: f64| 0.5 + 0.5 * ((nm - 520.0) / 8.0).tanh();
        for (illuminant, count) in [(Illuminant::D65, 8), (Illuminant::F(11), 8), (Illuminant::D65, 400)] {
            let fine = integrate(&uniform_wavelengths(&illuminant, [380.0, 780.0], 0.05).unwrap(), edge);
            let few = filtered_wavenumbers(&illuminant, [380.0, 780.0], count, edge).unwrap();
            let found = integrate(&few, |_| 1.0);
            let apart = integrate(&uniform_wavenumbers(&illuminant, [380.0, 780.0], 8).unwrap(), edge);
            for c in 0..3 {
                assert!((found[c] - fine[c]).abs() < 2e-5, "{illuminant:?} {found:?} {fine:?}");
            }
            assert!((apart[1] - fine[1]).abs() > 1e-3, "eight values of an edge are not the edge: {apart:?} {fine:?}");
        }
        let line = |nm| Illuminant::Lines(vec![super::super::Line { wavelength_nm: nm, power: 2.0 }]);
        let q = filtered_wavenumbers(&line(520.0), [380.0, 780.0], 9, edge).unwrap();
        assert!((q.weights[0][1] - 0.5).abs() < 1e-15);
        let same = filtered_wavenumbers(&Illuminant::D65, [380.0, 780.0], 40, |_| 1.0).unwrap();
        assert_eq!(same, uniform_wavenumbers(&Illuminant::D65, [380.0, 780.0], 40).unwrap());
    }

    #[test]
    fn knots_of_a_table_need_not_be_whole() {
        // A line 0.2 nm wide, between whole wavelengths, over a range that begins between them as well.
        let wavelength_nm = vec![500.0, 555.3, 555.4, 555.5, 600.0];
        let light = Illuminant::Tabulated { wavelength_nm, power: vec![0.0, 0.0, 1.0, 0.0, 0.0] };
        let points = densities(&light, [499.7, 601.3], f64::INFINITY);
        let luminous: f64 = points.iter().map(|(_, density)| density[1]).sum();
        let expected = 0.1 * observer_2deg(555.4)[1];
        assert!((luminous / expected - 1.0).abs() < 1e-6, "{luminous} {expected}");
    }

    #[test]
    fn every_wavelength_has_its_weight_however_many_there_are() {
        for count in [1_000, 30_000] {
            let q = uniform_wavenumbers(&Illuminant::E, [380.0, 780.0], count).unwrap();
            // E and the observer are smooth: neighbours weigh alike, where they weigh at all. Weights of cells that
            // cover a step four times over ripple by a few per cent, those of too few cells by all they have.
            let visible = q.weights.windows(2).filter(|pair| pair[0][1] > 1e-3 / count as f64);
            let ripple = visible.map(|pair| (pair[1][1] / pair[0][1] - 1.0).abs()).fold(0.0, f64::max);
            assert!(ripple < 0.2, "{count}: {ripple}");
        }
    }
}
