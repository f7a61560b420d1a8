//! The directions on which methods are compared, and what the direct sum says there.

use super::batch::{Batch, Pair, on_all_threads};
use super::rows::RegionErrors;
use diffraction_brdf::direction::wave_vector_change;
use diffraction_brdf::error::Result;
pub use diffraction_build::accuracy::directions::floor_per_sr;
use diffraction_build::ground::metrics::{ErrorQuantiles, relative_error_quantiles, relative_l2};
use diffraction_build::ground::progress::Progress;
use diffraction_build::ground::sampling::{Region, direction_pairs};
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::optics::reference::brdf_xyz_batch;
use diffraction_build::tables::resolution::usable_radius;

/// Directions summed between two words of progress.
const PART: usize = 16;

/// Directions with their reference.
pub struct Directions {
    pub pairs: Vec<Pair>,
    /// Reference Y in 1/sr.
    pub luminance: Vec<f64>,
}

/// All regions, and what the reference cost.
pub struct Sample {
    /// In the order of `Region::ALL`.
    pub regions: Vec<(Region, Directions)>,
    /// The hemisphere's directions, moved to where (u, v) meets the nearest texel: no grid enters there.
    pub on_texels: Directions,
    /// Wall seconds of the direct sum per direction, all threads at work.
    pub reference_s: f64,
    /// Luminance in 1/sr up to which directions are left out of relative errors.
    pub floor_per_sr: f64,
}

/// Steps of progress of [`Sample::measured`].
pub fn count(directions: usize) -> u64 {
    ((Region::ALL.len() + 1) * directions.div_ceil(PART)) as u64
}

impl Sample {
    /// Takes the directions the scans can answer for and sums them directly; `size` is that of the tables.
    pub fn measured(
        fields: &[HeightField],
        optics: &OpticsConfig,
        [directions, size]: [usize; 2],
        progress: &dyn Progress,
    ) -> Result<Self> {
        let usable = fields.iter().map(|f| usable_radius(optics, f.pitch_nm)).fold(2.0, f64::min);
        let started = std::time::Instant::now();
        let summed = |mut pairs: Vec<Pair>| -> Result<Directions> {
            pairs.retain(|&(wi, wo)| {
                let q = wave_vector_change(wi, wo);
                q[0].hypot(q[1]) <= usable
            });
            let mut luminance = Vec::with_capacity(pairs.len());
            for part in pairs.chunks(PART) {
                luminance.extend(brdf_xyz_batch(fields, optics, part)?.iter().map(|xyz| xyz[1]));
                progress.advance(1);
            }
            Ok(Directions { pairs, luminance })
        };
        let mut regions = Vec::new();
        for region in Region::ALL {
            regions.push((region, summed(direction_pairs(region, directions))?));
        }
        let on_texels = summed(moved_to_texels(&direction_pairs(Region::Hemisphere, directions), size))?;
        let count = on_texels.pairs.len() + regions.iter().map(|(_, found)| found.pairs.len()).sum::<usize>();
        Ok(Self {
            reference_s: started.elapsed().as_secs_f64() / count.max(1) as f64,
            floor_per_sr: floor_per_sr(optics.material, &regions[0].1.luminance),
            regions,
            on_texels,
        })
    }

    /// Errors of a method in every region.
    pub fn errors(&self, batch: Batch) -> Vec<RegionErrors> {
        let errors_of = |(region, exact): &(Region, Directions)| {
            let found = luminances(batch, &exact.pairs);
            RegionErrors {
                region: *region,
                relative_l2: relative_l2(&exact.luminance, &found),
                quantiles: self.deviation(&exact.luminance, &found),
            }
        };
        self.regions.iter().map(errors_of).collect()
    }

    /// Errors of a method where (u, v) lies on texels.
    pub(crate) fn errors_on_texels(&self, batch: Batch) -> ErrorQuantiles {
        self.deviation(&self.on_texels.luminance, &luminances(batch, &self.on_texels.pairs))
    }

    /// The directions of the whole hemisphere.
    pub fn hemisphere(&self) -> &Directions {
        // `Region::ALL` begins with the hemisphere.
        &self.regions[0].1
    }

    /// Quantiles of the relative deviation of luminances from others, above the floor.
    pub fn deviation(&self, reference: &[f64], found: &[f64]) -> ErrorQuantiles {
        relative_error_quantiles(reference, found, self.floor_per_sr)
    }
}

/// Y of a method for each pair.
pub fn luminances(batch: Batch, pairs: &[Pair]) -> Vec<f64> {
    on_all_threads(batch, pairs).iter().map(|xyz| xyz[1]).collect()
}

/// Pairs whose (u, v) is the texel nearest to that of the given pairs, with the same share of the reach in `w`.
pub(crate) fn moved_to_texels(pairs: &[Pair], size: usize) -> Vec<Pair> {
    let texel = 4.0 / (size - 1) as f64;
    let moved = |&(wi, wo): &Pair| {
        let q = wave_vector_change(wi, wo);
        let reach = |u: f64, v: f64| (4.0 - u * u - v * v).max(0.0).sqrt();
        let [u, v] = [q[0], q[1]].map(|x| (x / texel).round() * texel);
        let t = q[2].abs() / reach(q[0], q[1]).max(f64::MIN_POSITIVE);
        (u.hypot(v) < 1.99).then(|| pair_of(u, v, t.min(1.0) * reach(u, v)))
    };
    pairs.iter().filter_map(moved).collect()
}

/// Directions with a given `(u, v, |w|)`: both half a `|w|` high, turned about `q` by the horizontal normal to it.
pub fn pair_of(u: f64, v: f64, w: f64) -> Pair {
    let rho = u.hypot(v);
    let turn = (1.0 - 0.25 * (rho * rho + w * w)).max(0.0).sqrt();
    let across = if rho > 0.0 { [-v / rho, u / rho] } else { [1.0, 0.0] };
    let tilted = |sign: f64| [-0.5 * u + sign * turn * across[0], -0.5 * v + sign * turn * across[1], 0.5 * w];
    (tilted(1.0), tilted(-1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_moved_to_texels_lie_on_them_and_are_unit_vectors() {
        let size = 101;
        let moved = moved_to_texels(&direction_pairs(Region::Hemisphere, 300), size);
        assert!(moved.len() > 290);
        for (wi, wo) in moved {
            let q = wave_vector_change(wi, wo);
            for x in [q[0], q[1]] {
                let texels = x * (size - 1) as f64 / 4.0;
                assert!((texels - texels.round()).abs() < 1e-9);
            }
            for d in [wi, wo] {
                assert!((d.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-12 && d[2] > 0.0);
            }
        }
    }
}
