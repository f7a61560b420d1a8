//! The manifest's scenes on a coarse lattice of their pixels: every method's picture against the reference's.

use ndarray::Array3;

use super::batch::{Batch, Pair, on_all_threads};
use super::{Picture, SceneColour, StudySpecimen};
use diffraction_brdf::direction::Xyz;
use diffraction_brdf::error::Result;
use diffraction_build::ground::colour::to_srgb8;
use diffraction_build::ground::metrics::ciede2000;
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::optics::reference::PICTURE_STEP;
use diffraction_build::optics::spectra::Spectra;
use diffraction_build::optics::spectral::add_window;
use diffraction_render::scene::model::{Scene, exposure_factor};
use diffraction_render::scene::samples::{ShadingSamples, pixel_range, samples_of, samples_per_pixel};

/// Most samples of a light or pixel: more pixels tell more about colours than smoother ones.
const LIGHT_SAMPLES_MAX: usize = 4;

/// Scenes of one specimen with their references.
pub struct Pictures {
    scenes: Vec<Reference>,
}

struct Reference {
    name: String,
    samples: ShadingSamples,
    pairs: Vec<Pair>,
    image: Array3<f32>,
    exposure: f32,
}

impl Pictures {
    /// Gathers at most about `samples_max` samples of every scene and evaluates the reference there: straight from the
    /// transforms, which the study holds against the direct sum.
    pub fn of(
        specimen: &StudySpecimen,
        optics: &OpticsConfig,
        spectra: &[Spectra],
        samples_max: usize,
    ) -> Result<Self> {
        let reference = |scene: &Scene| -> Result<Reference> {
            let scene =
                &Scene { light_samples: scene.light_samples.min(LIGHT_SAMPLES_MAX), pixel_samples: 1, ..scene.clone() };
            let side = ((samples_max / samples_per_pixel(scene).max(1)) as f64).sqrt().max(8.0);
            let stride = (scene.size_px as f64 / side).ceil().max(1.0) as usize;
            let samples = samples_of(scene, 0..scene.size_px, stride)?;
            let pairs: Vec<Pair> =
                samples.wi.iter().zip(&samples.wo).map(|(wi, wo)| (wi.map(f64::from), wo.map(f64::from))).collect();
            let mut xyz = vec![[0.0; 3]; pairs.len()];
            for window in spectra {
                add_window(window, optics, &pairs, PICTURE_STEP, &mut xyz)?;
            }
            xyz.iter_mut().flatten().for_each(|x| *x /= spectra.len().max(1) as f64);
            let image = gather(&samples, &xyz);
            let exposure = exposure_factor(scene.exposure, &image);
            Ok(Reference { name: scene.name.clone(), samples, pairs, image, exposure })
        };
        Ok(Self { scenes: specimen.scenes.iter().map(reference).collect::<Result<_>>()? })
    }

    /// The reference's own pictures.
    pub fn shown(&self) -> Vec<Picture> {
        self.scenes.iter().map(|scene| scene.shown(&scene.image)).collect()
    }

    /// Colour differences of a method on every scene, and its pictures.
    pub fn compared(&self, batch: Batch) -> (Vec<SceneColour>, Vec<Picture>) {
        let compare = |scene: &Reference| {
            let image = gather(&scene.samples, &on_all_threads(batch, &scene.pairs));
            let difference = ciede2000(&scene.image, &image, 1.0 / f64::from(scene.exposure));
            let colour = SceneColour {
                scene: scene.name.clone(),
                pixels: image.len() / 3,
                mean: difference.mean,
                p95: difference.p95,
                max: difference.max,
            };
            (colour, scene.shown(&image))
        };
        self.scenes.iter().map(compare).unzip()
    }
}

impl Reference {
    fn shown(&self, image: &Array3<f32>) -> Picture {
        Picture { scene: self.name.clone(), rgb: to_srgb8(image, self.exposure) }
    }
}

/// XYZ image from the BRDF at each sample.
fn gather(samples: &ShadingSamples, brdf: &[Xyz]) -> Array3<f32> {
    Array3::from_shape_fn((samples.rows, samples.columns, 3), |(row, column, channel)| {
        let range = pixel_range(samples, row, column);
        range.map(|index| f64::from(samples.weight[index]) * brdf[index][channel]).sum::<f64>() as f32
    })
}
