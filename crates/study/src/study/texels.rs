//! Texels at which tables are read without interpolation, and what each should hold: a mean over its own square.

use super::batch::Pair;
use super::sample::{moved_to_texels, pair_of};
use diffraction_brdf::direction::{Vec3, Xyz, wave_vector_change};
use diffraction_brdf::error::Result;
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::optics::reference::FULL_STEP;
use diffraction_build::optics::spectra::transform;
use diffraction_build::optics::spectral::add_window;
use diffraction_build::tables::accumulate::BoxFilter;
use diffraction_build::tables::model::TableSet;
use diffraction_build::tables::plan::BuildPlan;
use diffraction_build::tables::resolution::lobe_width;

/// Most texels.
const TEXELS: usize = 128;

/// Texels, and the directions that average over each as it does.
pub struct Texels {
    /// One direction per node of the square, those of a texel side by side.
    pairs: Vec<Pair>,
    /// Shares of the nodes in the mean.
    weights: Vec<f64>,
    /// The texels' own directions.
    pub centres: Vec<Pair>,
}

impl Texels {
    /// At most 128 texels nearest to where directions meet the tables, where these are above the floor: outside the lobe,
    /// which has a table of its own, and where the whole box lies in the disc.
    pub fn of(set: &TableSet, optics: &OpticsConfig, filter: BoxFilter, near: &[Pair], floor_per_sr: f64) -> Self {
        let width = filter.width;
        let nodes = if width > 0.0 { gauss_legendre(box_nodes(optics, width)) } else { vec![(0.0, 1.0)] };
        let inner = set.lobe.as_ref().map_or(0.0, |lobe| lobe.radius_max) + width;
        let offset = |(x, _): (f64, f64)| 0.5 * width * x;
        let is_above = |wi: Vec3, wo: Vec3| brdf_xyz(set, Interpolation::Cubic, wi, wo)[1] > floor_per_sr;
        let (mut pairs, mut centres) = (Vec::new(), Vec::new());
        for (wi, wo) in moved_to_texels(near, set.size()) {
            if centres.len() == TEXELS {
                break;
            }
            let [u, v, w] = wave_vector_change(wi, wo);
            let w = w.abs();
            let rho = u.hypot(v);
            let reach = (4.0 - (rho + width).powi(2)).max(0.0).sqrt();
            if rho > inner && rho < set.usable_radius - width && w < reach && is_above(wi, wo) {
                centres.push((wi, wo));
                for &y in &nodes {
                    pairs.extend(nodes.iter().map(|&x| pair_of(u + offset(x), v + offset(y), w)));
                }
            }
        }
        let weights = nodes.iter().flat_map(|y| nodes.iter().map(|x| x.1 * y.1)).collect();
        Self { pairs, weights, centres }
    }

    /// Y at each texel's own direction for the mean power that it should hold; `exact` is the BRDF at its pairs.
    fn means(&self, optics: &OpticsConfig, exact: &[Xyz]) -> Vec<f64> {
        let nodes = self.weights.len();
        let parts = self.pairs.chunks(nodes).zip(exact.chunks(nodes));
        let mean = |(&(wi, wo), (pairs, exact)): (&Pair, (&[Pair], &[Xyz]))| {
            // Geometry and reflectance are outside the mean.
            let powers = pairs.iter().zip(exact).map(|(&(wi, wo), xyz)| xyz[1] / optics.front_factor().diffuse(wi, wo));
            optics.front_factor().diffuse(wi, wo)
                * powers.zip(&self.weights).map(|(power, weight)| weight * power).sum::<f64>()
        };
        self.centres.iter().zip(parts).map(mean).collect()
    }

    /// Y at each texel's own direction for the mean power that it should hold, straight from the transforms of all
    /// windows.
    pub fn reference(&self, fields: &[HeightField], optics: &OpticsConfig, plan: &BuildPlan) -> Result<Vec<f64>> {
        let mut xyz = vec![[0.0; 3]; self.pairs.len()];
        for &(scan, placement) in &plan.windows {
            let spectra = transform(&fields[scan], placement, optics, &plan.spectra)?;
            add_window(&spectra, optics, &self.pairs, FULL_STEP, &mut xyz)?;
        }
        xyz.iter_mut().flatten().for_each(|x| *x /= plan.windows.len().max(1) as f64);
        Ok(self.means(optics, &xyz))
    }
}

/// Nodes along a square's side for lobes of the shortest wavelength: Gauss-Legendre with `n` nodes is exact up to the
/// degree `2n - 1`; a Gaussian seen over `r` standard deviations leaves `(r/2)^2n / (2n)!` and less: 1e-8 for r = 1.5
/// and five nodes, of which every further standard deviation takes two more.
fn box_nodes(optics: &OpticsConfig, width: f64) -> usize {
    let low_nm = optics.illuminant.reach_nm(optics.wavelength_nm)[0];
    4 + (2.0 * width / lobe_width(optics.sigma_nm, low_nm)).ceil() as usize
}

/// Nodes on [-1, 1] and weights with the sum 1, by Newton's method on the Legendre polynomial.
fn gauss_legendre(count: usize) -> Vec<(f64, f64)> {
    let n = count as f64;
    (0..count)
        .map(|i| {
            let mut x = (std::f64::consts::PI * (i as f64 + 0.75) / (n + 0.5)).cos();
            let mut slope = 1.0;
            // Converges quadratically from Tricomi's estimate: four steps reach rounding, the rest costs nothing.
            for _ in 0..8 {
                let (mut before, mut here) = (0.0, 1.0);
                for l in 0..count {
                    let l = l as f64;
                    (before, here) = (here, ((2.0 * l + 1.0) * x * here - l * before) / (l + 1.0));
                }
                slope = n * (x * here - before) / (x * x - 1.0);
                x -= here / slope;
            }
            (x, 1.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gauss_legendre_integrates_polynomials_to_twice_its_length_exactly() {
        for count in 1..12 {
            let nodes = gauss_legendre(count);
            for degree in 0..2 * count {
                let mean: f64 = nodes.iter().map(|(x, weight)| weight * x.powi(degree as i32)).sum();
                let exact = if degree % 2 == 0 { 1.0 / (degree as f64 + 1.0) } else { 0.0 };
                assert!((mean - exact).abs() < 1e-13, "{count} nodes, degree {degree}: {mean}");
            }
            let beyond: f64 = nodes.iter().map(|(x, weight)| weight * x.powi(2 * count as i32)).sum();
            assert!((beyond - 1.0 / (2.0 * count as f64 + 1.0)).abs() > 1e-9);
        }
    }
}
