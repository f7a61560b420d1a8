//! Means over an ellipse of what depends on the distance from a point alone: the coherent lobe under a light with a size.

use std::f64::consts::PI;
use std::sync::OnceLock;

use crate::direction::{Vec3, length};
use crate::footprint::Footprint;
use crate::front_factor::image_radius2;

/// Chords across the ellipse, and places along a chord where no closed form is known.
const NODES: usize = 24;

/// Where a lobe lies, seen from the centre of the light's ellipse, in the frame of the ellipse's axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LobeEllipse {
    centre: [f64; 2],
    semi_axes: [f64; 2],
}

impl LobeEllipse {
    /// The ellipse of a footprint around `(u, v)`.
    pub fn direct([u, v]: [f64; 2], footprint: Footprint) -> Self {
        let (variances, [x, y]) = footprint.axes();
        Self { centre: [u * x + v * y, v * x - u * y], semi_axes: variances.map(|variance| 2.0 * variance.sqrt()) }
    }

    /// The ellipse around the place of the lobe's mirror image in the horizon (see [`image_radius2`]).
    ///
    /// In the plane of the two directions' mirror, the distance of the image across the horizon stands in place of that of the
    /// lobe and moves as it does; along the horizon nothing changes. The covariance between the two is left out: it is
    /// that of lights turned against the horizon, and has a sign that would tell light from viewer.
    pub fn image(wi: Vec3, wo: Vec3, footprint: Footprint) -> Self {
        let [x, y] = [wo[0] - wi[0], wo[1] - wi[1]];
        let length = x.hypot(y);
        let [x, y] = if length > 0.0 { [x / length, y / length] } else { [1.0, 0.0] };
        let along = (wi[1] + wo[1]) * x - (wi[0] + wo[0]) * y;
        let across = (image_radius2(wi, wo) - along * along).max(0.0).sqrt();
        let [uu, uv, vv] = footprint.covariance();
        let variances = [x * x * uu + 2.0 * x * y * uv + y * y * vv, y * y * uu - 2.0 * x * y * uv + x * x * vv];
        Self { centre: [across, along], semi_axes: variances.map(|variance| 2.0 * variance.max(0.0).sqrt()) }
    }

    /// Distance of the ellipse's centre from the lobe's.
    pub fn radius(&self) -> f64 {
        self.centre[0].hypot(self.centre[1])
    }

    /// Whether the ellipse's bounding rectangle comes within a distance of the lobe's centre.
    pub fn reaches(&self, reach: f64) -> bool {
        let [x, y] = [0, 1].map(|k| (self.centre[k].abs() - self.semi_axes[k]).max(0.0));
        x.hypot(y) < reach
    }

    /// Mean over the ellipse of a function of the distance from the lobe's centre that is zero from `reach` on.
    pub fn mean<const N: usize>(&self, reach: f64, value: impl Fn(f64) -> [f64; N]) -> [f64; N] {
        self.over_chords(reach, |y, [low, high]| {
            let mut sum = [0.0; N];
            let half = 0.5 * (high - low);
            for [place, _, weight] in nodes() {
                let x = self.centre[0] + self.semi_axes[0] * (low + half * (1.0 + place));
                let value = value(length([x, y]));
                sum.iter_mut().zip(value).for_each(|(sum, value)| *sum += half * weight * value);
            }
            sum
        })
    }

    /// Mean over the ellipse of `exp(-(distance/width)²)`: along chords in closed form.
    pub fn gaussian_mean(&self, width: f64) -> f64 {
        // Beyond it is less than 1e-15.
        let reach = 6.0 * width;
        let [centre, semi_axis] = [self.centre[0], self.semi_axes[0]];
        let [mean] = self.over_chords(reach, |y, [low, high]| {
            let [from, to] = [low, high].map(|xi| (centre + semi_axis * xi) / width);
            let along = if to - from > 1e-5 {
                0.5 * PI.sqrt() * (libm::erf(to) - libm::erf(from)) / (to - from)
            } else {
                (-(0.5 * (from + to)).powi(2)).exp()
            };
            [(high - low) * along * (-(y / width).powi(2)).exp()]
        });
        mean
    }

    /// Integral over the unit disc, divided by its area, of what `chord` gives for the chord at `y`, between two places of the
    /// disc: of chords and parts of them no further than `reach` from the lobe's centre.
    fn over_chords<const N: usize>(&self, reach: f64, chord: impl Fn(f64, [f64; 2]) -> [f64; N]) -> [f64; N] {
        let mut sum = [0.0; N];
        let Some([low, high]) = within(self.centre[1], self.semi_axes[1], reach, 1.0) else { return sum };
        let [middle, half] = [0.5 * (low + high), 0.5 * (high - low)];
        for [place, chebyshev, _] in nodes() {
            let eta = middle + half * place;
            let y = self.centre[1] + self.semi_axes[1] * eta;
            let limit = (1.0 - eta * eta).max(0.0).sqrt();
            let reach = (reach * reach - y * y).max(0.0).sqrt();
            let Some(ends) = within(self.centre[0], self.semi_axes[0], reach, limit) else { continue };
            let value = chord(y, ends);
            sum.iter_mut().zip(value).for_each(|(sum, value)| *sum += half * chebyshev * value / PI);
        }
        sum
    }
}

/// The part of `[-limit, limit]` where `|centre + semi_axis x| < reach`.
fn within(centre: f64, semi_axis: f64, reach: f64, limit: f64) -> Option<[f64; 2]> {
    let [low, high] = if semi_axis > 0.0 {
        [((-reach - centre) / semi_axis).max(-limit), ((reach - centre) / semi_axis).min(limit)]
    } else if centre.abs() < reach {
        [-limit, limit]
    } else {
        return None;
    };
    (low < high).then_some([low, high])
}

/// Places in [-1, 1], each with two weights: of functions that vanish at the ends like a chord's length (Gauss's rule with
/// Chebyshev's polynomials of the second kind), and of any smooth ones (Fejér's second rule).
fn nodes() -> &'static [[f64; 3]; NODES] {
    static PLACES: OnceLock<[[f64; 3]; NODES]> = OnceLock::new();
    PLACES.get_or_init(|| {
        std::array::from_fn(|k| {
            let angle = (k + 1) as f64 * PI / (NODES + 1) as f64;
            let step = PI / (NODES + 1) as f64;
            let terms = (1..=NODES.div_ceil(2)).map(|j| ((2 * j - 1) as f64 * angle).sin() / (2 * j - 1) as f64);
            [-angle.cos(), step * angle.sin(), 4.0 / PI * step * angle.sin() * terms.sum::<f64>()]
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The mean by brute force.
    fn counted(centre: [f64; 2], [uu, uv, vv]: [f64; 3], value: impl Fn(f64) -> f64) -> f64 {
        const RINGS: usize = 600;
        let [a, b] = [2.0 * uu.sqrt(), 2.0 * uv / uu.sqrt()];
        let c = 2.0 * (vv - uv * uv / uu).sqrt();
        let (mut sum, mut count) = (0.0, 0.0);
        for ring in 0..RINGS {
            let radius = ((ring as f64 + 0.5) / RINGS as f64).sqrt();
            for k in 0..RINGS {
                let (sin, cos) = ((k as f64 + 0.618 * ring as f64) / RINGS as f64 * 2.0 * PI).sin_cos();
                let [x, y] = [radius * cos, radius * sin];
                sum += value((centre[0] + a * x).hypot(centre[1] + b * x + c * y));
                count += 1.0;
            }
        }
        sum / count
    }

    #[test]
    fn means_are_those_of_many_points() {
        const WIDTH: f64 = 0.006;
        let gauss = |radius: f64| (-(radius / WIDTH).powi(2)).exp();
        let mut largest_wrong = 0.0_f64;
        for [size, ratio] in [[1e-4_f64, 1.0], [2e-3, 0.5], [5e-3, 1.0], [2e-2, 0.7], [4e-2, 0.3]] {
            for centre in [[0.0, 0.0], [4e-3, -3e-3], [-1.5e-2, 1e-2], [3e-2, 3e-2]] {
                let covariance = [0.25 * size * size, 0.1 * ratio * size * size, 0.25 * (ratio * size).powi(2)];
                let footprint = Footprint::new(covariance[0], covariance[1], covariance[2]).unwrap();
                let ellipse = LobeEllipse::direct(centre, footprint);
                let expected = counted(centre, covariance, gauss);
                let closed = ellipse.gaussian_mean(WIDTH);
                let [by_points] = ellipse.mean(6.0 * WIDTH, |radius| [gauss(radius)]);
                for found in [closed, by_points] {
                    assert!((found - expected).abs() < 1e-3 * expected + 2e-5, "{size} {centre:?}: {found} {expected}");
                }
                // Twenty-four places over the twelve widths of the lobe err by 2.0e-4, closed forms along as many chords by 2e-9.
                assert!((closed - by_points).abs() < 2.1e-4 * closed + 1e-7, "{size} {centre:?}: {closed} {by_points}");
                let exchanged = Footprint::new(covariance[2], covariance[1], covariance[0]).unwrap();
                let wrong = LobeEllipse::direct(centre, exchanged).gaussian_mean(WIDTH);
                largest_wrong = largest_wrong.max((wrong - expected).abs() / (1e-3 * expected + 2e-5));
            }
        }
        assert!(largest_wrong > 20.0, "exchanged axes must be found, and are off by {largest_wrong} bounds at most");
    }

    #[test]
    fn a_point_is_looked_up_as_a_point() {
        let ellipse = LobeEllipse::direct([3e-3, 4e-3], Footprint::POINT);
        let expected = (-1.0f64).exp();
        assert!((ellipse.gaussian_mean(5e-3) - expected).abs() < 1e-14);
        assert!((ellipse.mean(0.1, |radius| [(-(radius / 5e-3).powi(2)).exp()])[0] - expected).abs() < 1e-14);
        assert_eq!(ellipse.mean(4.9e-3, |_| [1.0]), [0.0]);
    }
}
