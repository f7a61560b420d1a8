//! Scenes on a coarse lattice of their pixels: every method's picture against the reference's.

use ndarray::Array3;

use super::batch::{Batch, on_all_threads};
use super::config::StudySpecimen;
use super::lent::SceneSamples;
use super::rows::{Picture, SceneColour};
use diffraction_brdf::error::Result;
use diffraction_build::ground::colour::to_srgb8;
use diffraction_build::ground::metrics::ciede2000;
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::optics::reference::PICTURE_STEP;
use diffraction_build::optics::spectra::Spectra;
use diffraction_build::optics::spectral::add_window;

/// Scenes of one specimen with their references.
pub struct Pictures<'a> {
    scenes: Vec<Reference<'a>>,
}

struct Reference<'a> {
    scene: &'a dyn SceneSamples,
    image: Array3<f32>,
    exposure: f32,
}

impl<'a> Pictures<'a> {
    /// Evaluates the reference in every scene: straight from the transforms, which the study holds against the direct
    /// sum.
    pub fn of(specimen: &'a StudySpecimen, optics: &OpticsConfig, spectra: &[Spectra]) -> Result<Self> {
        let reference = |scene: &'a dyn SceneSamples| -> Result<Reference<'a>> {
            let mut xyz = vec![[0.0; 3]; scene.pairs().len()];
            for window in spectra {
                add_window(window, optics, scene.pairs(), PICTURE_STEP, &mut xyz)?;
            }
            xyz.iter_mut().flatten().for_each(|x| *x /= spectra.len().max(1) as f64);
            let image = scene.image(&xyz);
            let exposure = scene.exposure(&image);
            Ok(Reference { scene, image, exposure })
        };
        Ok(Self { scenes: specimen.scenes.iter().map(|scene| reference(scene.as_ref())).collect::<Result<_>>()? })
    }

    /// The reference's own pictures.
    pub fn shown(&self) -> Vec<Picture> {
        self.scenes.iter().map(|scene| scene.shown(&scene.image)).collect()
    }

    /// Colour differences of a method on every scene, and its pictures.
    pub fn compared(&self, batch: Batch) -> (Vec<SceneColour>, Vec<Picture>) {
        let compare = |reference: &Reference| {
            let scene = reference.scene;
            let image = scene.image(&on_all_threads(batch, scene.pairs()));
            let difference = ciede2000(&reference.image, &image, 1.0 / f64::from(reference.exposure));
            let colour = SceneColour {
                scene: scene.name().into(),
                pixels: image.len() / 3,
                mean: difference.mean,
                p95: difference.p95,
                max: difference.max,
            };
            (colour, reference.shown(&image))
        };
        self.scenes.iter().map(compare).unzip()
    }
}

impl Reference<'_> {
    fn shown(&self, image: &Array3<f32>) -> Picture {
        Picture { scene: self.scene.name().into(), rgb: to_srgb8(image, self.exposure) }
    }
}
