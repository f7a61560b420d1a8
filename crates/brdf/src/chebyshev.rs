//! Chebyshev interpolation on an interval: nodes, weights, coefficients, and how many are enough.

use std::f64::consts::PI;

/// The `count` Gauss nodes (zeros of `T_count`) on `[low, high]`, ascending; no node touches an end.
pub fn gauss_nodes(count: usize, low: f64, high: f64) -> Vec<f64> {
    (0..count)
        .map(|k| {
            let x = -((2 * k + 1) as f64 * PI / (2 * count) as f64).cos();
            0.5 * (low + high) + 0.5 * (high - low) * x
        })
        .collect()
}

/// Interpolation from [`gauss_nodes`], prepared for many points.
#[derive(Debug, Clone, PartialEq)]
pub struct Interpolant {
    nodes: Vec<f64>,
    /// Barycentric weight of each node, up to a common factor.
    barycentric: Vec<f64>,
}

impl Interpolant {
    /// `count` nodes on `[low, high]`.
    pub fn new(count: usize, low: f64, high: f64) -> Self {
        let barycentric = (0..count).map(|k| {
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            sign * ((2 * k + 1) as f64 * PI / (2 * count) as f64).sin()
        });
        Self { nodes: gauss_nodes(count, low, high), barycentric: barycentric.collect() }
    }

    /// The nodes, ascending.
    pub fn nodes(&self) -> &[f64] {
        &self.nodes
    }

    /// Weights that interpolate values at the nodes to `x` (barycentric formula; Berrut and Trefethen
    /// 2004, eq. 5.3). They sum to one.
    pub fn weights(&self, x: f64) -> Vec<f64> {
        let mut weights = vec![0.0; self.nodes.len()];
        self.weights_into(x, &mut weights);
        weights
    }

    /// [`Self::weights`] into a slice of as many elements as there are nodes.
    pub fn weights_into(&self, x: f64, weights: &mut [f64]) {
        if let Some(hit) = self.nodes.iter().position(|&node| node == x) {
            weights.fill(0.0);
            weights[hit] = 1.0;
            return;
        }
        let mut sum = 0.0;
        for ((weight, node), b) in weights.iter_mut().zip(&self.nodes).zip(&self.barycentric) {
            *weight = b / (x - node);
            sum += *weight;
        }
        weights.iter_mut().for_each(|w| *w /= sum);
    }

    /// [`Self::weights`] for several points: node by node, those of all points side by side.
    pub fn weights_of<const L: usize>(&self, x: [f64; L], weights: &mut Vec<[f64; L]>) {
        let mut sums = [0.0; L];
        weights.clear();
        weights.extend(self.nodes.iter().zip(&self.barycentric).map(|(node, b)| {
            let here = x.map(|x| b / (x - node));
            sums.iter_mut().zip(here).for_each(|(sum, weight)| *sum += weight);
            here
        }));
        let scales = sums.map(|sum| 1.0 / sum);
        for weights in weights.iter_mut() {
            weights.iter_mut().zip(scales).for_each(|(weight, scale)| *weight *= scale);
        }
        // At a node itself its weight is infinite, and so is the sum.
        for i in (0..L).filter(|&i| !sums[i].is_finite()) {
            if let Some(hit) = self.nodes.iter().position(|&node| node == x[i]) {
                weights.iter_mut().enumerate().for_each(|(k, weights)| weights[i] = if k == hit { 1.0 } else { 0.0 });
            }
        }
    }
}

/// [`Interpolant::weights`] for a single point.
pub fn interpolation_weights(count: usize, low: f64, high: f64, x: f64) -> Vec<f64> {
    Interpolant::new(count, low, high).weights(x)
}

/// Row-major matrix `[count][count]` that takes values at [`gauss_nodes`] to coefficients of
/// `T_0 .. T_{count-1}`.
pub fn coefficient_matrix(count: usize) -> Vec<Vec<f64>> {
    (0..count)
        .map(|n| {
            let scale = if n == 0 { 1.0 } else { 2.0 } / count as f64;
            (0..count)
                .map(|k| {
                    let angle = (2 * k + 1) as f64 * PI / (2 * count) as f64;
                    // x = -cos(angle): T_n(x) = (-1)^n cos(n angle).
                    let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
                    scale * sign * (n as f64 * angle).cos()
                })
                .collect()
        })
        .collect()
}

/// Values of the shifted polynomials `T_n(2t - 1)`, from `n = 0` on, for `t` in [0, 1], by recurrence.
pub fn shifted(t: f64) -> impl Iterator<Item = f64> {
    let x = 2.0 * t - 1.0;
    // T_n and T_{n+1}.
    let mut pair = [1.0, x];
    std::iter::repeat_with(move || {
        let [value, next] = pair;
        pair = [next, 2.0 * x * next - value];
        value
    })
}

/// The first `count` of [`shifted`].
pub fn shifted_values(count: usize, t: f64) -> Vec<f64> {
    shifted(t).take(count).collect()
}

/// Nodes that interpolate `exp(i s h)`, `|h| <= bandwidth`, over `s` in `[0, s_max]` to `tolerance`.
///
/// On the mapped interval the function is `exp(i z x)` with `z = bandwidth s_max / 2`, whose
/// Chebyshev coefficients are `2 i^n J_n(z)`; interpolation at Gauss nodes errs by at most twice the
/// sum of those left out (aliasing), hence `4 Σ_{n >= count} |J_n(z)|`.
pub fn nodes_for_exponential(bandwidth: f64, s_max: f64, tolerance: f64) -> usize {
    let z = 0.5 * bandwidth.abs() * s_max;
    // Beyond n = z the J_n fall faster than exponentially: this many more reach any f64 tolerance.
    let far = (z + 12.0 * z.cbrt() + 40.0) as usize;
    let mut tail = 0.0;
    for n in (1..far).rev() {
        tail += 4.0 * libm::jn(n as i32, z).abs();
        if tail > tolerance {
            return (n + 1).max(2);
        }
    }
    2
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn polynomials_are_interpolated_exactly(
            count in 1usize..12, low in -3.0f64..0.0, width in 0.1f64..5.0, share in 0.0f64..1.0,
        ) {
            let high = low + width;
            let x = low + share * width;
            let p = |x: f64| (0..count).fold(0.0, |sum, n| sum * x * 0.5 + (n as f64 + 1.0).sin());
            let weights = interpolation_weights(count, low, high, x);
            let value: f64 = gauss_nodes(count, low, high).iter().zip(&weights).map(|(&n, w)| p(n) * w).sum();
            // Lebesgue constant of Gauss nodes below 4 for count < 12, values below 1e3.
            prop_assert!((value - p(x)).abs() < 1e-10 * (1.0 + p(x).abs().max(100.0)));
            let matrix = coefficient_matrix(count);
            let values: Vec<f64> = gauss_nodes(count, 0.0, 1.0).into_iter().map(p).collect();
            let basis = shifted_values(count, share);
            let by_coefficients: f64 = (0..count)
                .map(|n| basis[n] * matrix[n].iter().zip(&values).map(|(m, v)| m * v).sum::<f64>())
                .sum();
            prop_assert!((by_coefficients - p(share)).abs() < 1e-9 * (1.0 + p(share).abs()));
        }

        #[test]
        fn node_count_keeps_its_promise(bandwidth in 0.0f64..300.0, exponent in -9.0f64..-1.0) {
            let (s_max, tolerance) = (0.033, 10f64.powf(exponent));
            let count = nodes_for_exponential(bandwidth, s_max, tolerance);
            let nodes = gauss_nodes(count, 0.0, s_max);
            for i in 0..40 {
                let s = s_max * i as f64 / 39.0;
                let weights = interpolation_weights(count, 0.0, s_max, s);
                let (mut re, mut im) = (0.0, 0.0);
                for (node, w) in nodes.iter().zip(&weights) {
                    re += w * (node * bandwidth).cos();
                    im += w * (node * bandwidth).sin();
                }
                let error = ((re - (s * bandwidth).cos()).powi(2) + (im - (s * bandwidth).sin()).powi(2)).sqrt();
                prop_assert!(error <= tolerance + 1e-13, "{count} nodes, error {error:e}");
            }
        }
    }

    #[test]
    fn weights_of_several_points_are_those_of_each() {
        for count in [2, 7, 24] {
            let interpolant = Interpolant::new(count, -0.3, 2.0);
            let x = [-0.3, 1.234, interpolant.nodes()[1], 1.9];
            let mut found = Vec::new();
            interpolant.weights_of(x, &mut found);
            assert_eq!(found.len(), count);
            for (i, x) in x.into_iter().enumerate() {
                let expected = interpolant.weights(x);
                // Quotients of the same numbers, rounded once more.
                assert!(found.iter().zip(&expected).all(|(f, e)| (f[i] - e).abs() <= 1e-15 * e.abs()), "{count} {x}");
            }
            assert!(interpolant.weights(1.234) != interpolant.weights(1.235));
        }
    }

    #[test]
    fn one_node_fewer_than_a_polynomial_needs_is_seen() {
        let p = |x: f64| x * x;
        let weights = interpolation_weights(2, 0.0, 1.0, 0.9);
        let value: f64 = gauss_nodes(2, 0.0, 1.0).iter().zip(&weights).map(|(&n, w)| p(n) * w).sum();
        assert!((value - p(0.9)).abs() > 1e-2);
    }

    #[test]
    fn node_count_grows_linearly_with_depth() {
        let shallow = nodes_for_exponential(1_000.0, 0.033, 1e-6);
        let deep = nodes_for_exponential(10_000.0, 0.033, 1e-6);
        assert!(deep < 10 * shallow && deep > 3 * shallow, "{shallow} {deep}");
    }
}
