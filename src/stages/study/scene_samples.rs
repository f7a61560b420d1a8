//! A scene of the manifest on a coarse lattice of its pixels, for the pictures that a study compares methods in.

use ndarray::Array3;

use crate::stages::pictures::scenes::pairs_of;
use diffraction_brdf::direction::{Vec3, Xyz};
use diffraction_brdf::error::Result;
use diffraction_render::scene::model::{Exposure, Scene, exposure_factor};
use diffraction_render::scene::samples::{ShadingSamples, pixel_range, samples_of, samples_per_pixel};
use diffraction_study::study::SceneSamples;

/// Most samples of a light or pixel: more pixels tell more about colours than smoother ones.
const LIGHT_SAMPLES_MAX: usize = 4;

/// A scene's samples and its exposure.
#[derive(Debug)]
pub struct DrawnScene {
    name: String,
    exposure: Exposure,
    samples: ShadingSamples,
    pairs: Vec<(Vec3, Vec3)>,
}

/// Gathers at most about `samples_max` samples of a scene.
///
/// # Errors
/// A scene that cannot be rendered.
pub fn drawn(scene: &Scene, samples_max: usize) -> Result<DrawnScene> {
    let scene = &Scene { light_samples: scene.light_samples.min(LIGHT_SAMPLES_MAX), pixel_samples: 1, ..scene.clone() };
    let side = ((samples_max / samples_per_pixel(scene).max(1)) as f64).sqrt().max(8.0);
    let stride = (scene.size_px as f64 / side).ceil().max(1.0) as usize;
    let samples = samples_of(scene, 0..scene.size_px, stride)?;
    let pairs = pairs_of(&samples).collect();
    Ok(DrawnScene { name: scene.name.clone(), exposure: scene.exposure, samples, pairs })
}

impl SceneSamples for DrawnScene {
    fn name(&self) -> &str {
        &self.name
    }

    fn pairs(&self) -> &[(Vec3, Vec3)] {
        &self.pairs
    }

    fn image(&self, brdf: &[Xyz]) -> Array3<f32> {
        let samples = &self.samples;
        Array3::from_shape_fn((samples.rows, samples.columns, 3), |(row, column, channel)| {
            let range = pixel_range(samples, row, column);
            range.map(|index| f64::from(samples.weight[index]) * brdf[index][channel]).sum::<f64>() as f32
        })
    }

    fn exposure(&self, reference: &Array3<f32>) -> f32 {
        exposure_factor(self.exposure, reference)
    }
}
