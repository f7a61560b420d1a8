//! The directions on which methods are compared, and what the direct sum says there.

use super::{FLOOR_PER_SR, RegionErrors};
use crate::ground::direction::{Vec3, Xyz};
use crate::ground::error::Result;
use crate::ground::metrics::{ErrorQuantiles, relative_error_quantiles, relative_l2};
use crate::ground::sampling::{Region, direction_pairs};
use crate::height::HeightField;
use crate::optics::config::OpticsConfig;
use crate::optics::reference::brdf_xyz_batch;
use crate::tables::plan::usable_radius;

/// Directions of one region with their reference.
pub struct RegionSample {
    pub region: Region,
    pub pairs: Vec<(Vec3, Vec3)>,
    /// Reference Y in 1/sr.
    pub luminance: Vec<f64>,
}

/// All regions, and what the reference cost.
pub struct Sample {
    pub regions: Vec<RegionSample>,
    /// Wall seconds of the direct sum per direction, all threads at work.
    pub reference_s: f64,
}

impl Sample {
    /// Takes the directions the scans can answer for and sums them directly.
    pub fn measured(fields: &[HeightField], optics: &OpticsConfig, count: usize) -> Result<Self> {
        let usable = fields.iter().map(|f| usable_radius(optics, f.pitch_nm)).fold(2.0, f64::min);
        let started = std::time::Instant::now();
        let mut regions = Vec::new();
        for region in Region::ALL {
            let mut pairs = direction_pairs(region, count);
            pairs.retain(|(wi, wo)| (wi[0] + wo[0]).hypot(wi[1] + wo[1]) <= usable);
            let luminance = brdf_xyz_batch(fields, optics, &pairs)?.iter().map(|xyz| xyz[1]).collect();
            regions.push(RegionSample { region, pairs, luminance });
        }
        let directions: usize = regions.iter().map(|r| r.pairs.len()).sum();
        Ok(Self { regions, reference_s: started.elapsed().as_secs_f64() / directions.max(1) as f64 })
    }

    /// Errors of a method in every region.
    pub fn errors(&self, brdf: &dyn Fn(Vec3, Vec3) -> Result<Xyz>) -> Result<Vec<RegionErrors>> {
        let errors_of = |sample: &RegionSample| {
            let found = luminances(&sample.pairs, brdf)?;
            Ok(RegionErrors {
                region: sample.region,
                relative_l2: relative_l2(&sample.luminance, &found),
                quantiles: relative_error_quantiles(&sample.luminance, &found, FLOOR_PER_SR),
            })
        };
        self.regions.iter().map(errors_of).collect()
    }

    /// The directions of the whole hemisphere.
    pub fn hemisphere(&self) -> &RegionSample {
        // `Region::ALL` begins with the hemisphere, and `measured` keeps its order.
        &self.regions[0]
    }
}

/// Y of a method for each pair.
pub fn luminances(pairs: &[(Vec3, Vec3)], brdf: &dyn Fn(Vec3, Vec3) -> Result<Xyz>) -> Result<Vec<f64>> {
    pairs.iter().map(|&(wi, wo)| Ok(brdf(wi, wo)?[1])).collect()
}

/// Quantiles of the relative deviation of one set of luminances from another.
pub fn deviation(reference: &[f64], found: &[f64]) -> ErrorQuantiles {
    relative_error_quantiles(reference, found, FLOOR_PER_SR)
}
