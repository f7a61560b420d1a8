//! The small picture of a material: a ball under a sun high to the right, a filtered look-up for each light and pixel.

use std::path::Path;

use diffraction_brdf::error::Result;
use diffraction_brdf::evaluate::Interpolation;
use diffraction_brdf::filtered::{Pyramids, brdf_xyz_filtered};
use diffraction_build::ground::colour::to_srgb8;
use diffraction_build::optics::pigment::{Surface, pigment_xyz};
use diffraction_render::render::cpu;
use diffraction_render::render::png_image::write_png;
use diffraction_render::scene::model::{Light, Scene, Shape, exposure_factor};

/// Side of the picture in pixels.
const SIZE_PX: usize = 192;

/// What filtering may err by: the sun is small enough for one look-up.
const TOLERANCE: f64 = 1e-3;

/// Writes `preview.png` into a specimen's folder.
///
/// # Errors
/// The disk's.
pub(crate) fn write_preview(surface: Surface, folder: &Path) -> Result<()> {
    let sun = Light { angular_diameter_deg: 0.53, ..Light::point([0.5, 0.5, 1.0]) };
    let scene = Scene::still("preview", Shape::Sphere, vec![sun], SIZE_PX);
    let pyramids = Pyramids::new(surface.tables);
    let image = cpu::render_filtered(&scene, TOLERANCE, &|wi, wo, footprint| {
        let brdf = brdf_xyz_filtered(surface.tables, &pyramids, Interpolation::Bilinear, [wi, wo], footprint);
        let below = surface.pigment.map_or([0.0; 3], |pigment| pigment_xyz(pigment, wi, wo));
        std::array::from_fn(|c| brdf[c] + below[c])
    })?;
    write_png(&folder.join("preview.png"), &to_srgb8(&image, exposure_factor(scene.exposure, &image)))
}
