//! The small picture of a material: a ball under a sun high to the right.

use std::path::Path;

use diffraction_brdf::error::Result;
use diffraction_brdf::evaluate::Interpolation;
use diffraction_build::ground::colour::to_srgb8;
use diffraction_build::optics::pigment::Surface;
use diffraction_render::render::cpu;
use diffraction_render::render::png_image::write_png;
use diffraction_render::scene::model::{Light, Scene, Shape, exposure_factor};

/// Side of the picture in pixels.
const SIZE_PX: usize = 192;

/// Writes `preview.png` into a specimen's folder.
///
/// # Errors
/// The disk's.
pub(crate) fn write_preview(surface: Surface, folder: &Path) -> Result<()> {
    let sun = Light { angular_diameter_deg: 0.53, ..Light::point([0.5, 0.5, 1.0]) };
    let still = Scene::still("preview", Shape::Sphere, vec![sun], SIZE_PX);
    let scene = Scene { light_samples: 16, pixel_samples: 4, ..still };
    let image = cpu::render(&scene, &|wi, wo| surface.xyz(Interpolation::Bilinear, wi, wo))?;
    write_png(&folder.join("preview.png"), &to_srgb8(&image, exposure_factor(scene.exposure, &image)))
}
