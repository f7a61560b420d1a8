//! Texels at which tables are read without interpolation, and what each should hold: a mean over its own square.

use super::batch::Pair;
use super::sample::{moved_to_texels, pair_of};
use crate::ground::direction::{Xyz, wave_vector_change};
use crate::ground::error::Result;
use crate::ground::sampling::{Region, direction_pairs};
use crate::height::HeightField;
use crate::optics::config::OpticsConfig;
use crate::optics::reference::{PICTURE_STEP, prefactor};
use crate::optics::spectra::transform;
use crate::optics::spectral::add_window;
use crate::tables::accumulate::BoxFilter;
use crate::tables::build::BuildPlan;
use crate::tables::model::TableSet;

/// Most texels.
const TEXELS: usize = 128;

/// Texels, and the directions that average over each as it does.
pub struct Texels {
    /// One direction per box sample, those of a texel side by side.
    pub pairs: Vec<Pair>,
    /// Box samples per texel.
    samples: usize,
    /// The texels' own directions.
    pub centres: Vec<Pair>,
}

impl Texels {
    /// Texels that directions over the hemisphere meet: outside the lobe, which has a table of its own, and where the
    /// whole box lies in the disc.
    pub fn of(set: &TableSet, filter: BoxFilter) -> Self {
        let BoxFilter { width, samples } = filter;
        let inner = set.lobe.as_ref().map_or(0.0, |lobe| lobe.radius_max) + width;
        let offset = |i: usize| ((i as f64 + 0.5) / samples as f64 - 0.5) * width;
        let (mut pairs, mut centres) = (Vec::new(), Vec::new());
        for (wi, wo) in moved_to_texels(&direction_pairs(Region::Hemisphere, 4 * TEXELS), set.size()) {
            let [u, v, w] = wave_vector_change(wi, wo);
            let w = w.abs();
            let rho = u.hypot(v);
            let deepest = (4.0 - (rho + width).powi(2)).max(0.0).sqrt();
            if rho > inner && rho < set.usable_radius - width && w < deepest && centres.len() < TEXELS {
                centres.push((wi, wo));
                let boxed =
                    (0..samples * samples).map(|i| pair_of(u + offset(i % samples), v + offset(i / samples), w));
                pairs.extend(boxed);
            }
        }
        Self { pairs, samples: samples * samples, centres }
    }

    /// Y at each texel's own direction for the mean power that it holds; `exact` is the BRDF at [`Self::pairs`].
    pub fn means(&self, optics: &OpticsConfig, exact: &[Xyz]) -> Vec<f64> {
        let parts = self.pairs.chunks(self.samples).zip(exact.chunks(self.samples));
        let mean = |(&(wi, wo), (pairs, exact)): (&Pair, (&[Pair], &[Xyz]))| {
            // Geometry and reflectance are outside the mean.
            let powers = pairs.iter().zip(exact).map(|(&(wi, wo), xyz)| xyz[1] / prefactor(optics, wi, wo));
            prefactor(optics, wi, wo) * powers.sum::<f64>() / self.samples as f64
        };
        self.centres.iter().zip(parts).map(mean).collect()
    }

    /// [`Self::means`] straight from the transforms of all windows.
    pub fn reference(&self, fields: &[HeightField], optics: &OpticsConfig, plan: &BuildPlan) -> Result<Vec<f64>> {
        let mut xyz = vec![[0.0; 3]; self.pairs.len()];
        for &(scan, placement) in &plan.windows {
            let spectra = transform(&fields[scan], placement, optics, &plan.spectra)?;
            add_window(&spectra, optics, &self.pairs, PICTURE_STEP, &mut xyz)?;
        }
        xyz.iter_mut().flatten().for_each(|x| *x /= plan.windows.len().max(1) as f64);
        Ok(self.means(optics, &xyz))
    }
}
