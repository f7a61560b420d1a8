//! What pictures are shaded with: a specimen's tables by the look-up that is promised for them, made ready once for all its pictures.

use ndarray::Array3;

use diffraction_brdf::Footprint;
use diffraction_brdf::direction::{Vec3, Xyz};
use diffraction_brdf::error::Result;
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz, brdf_xyz_by_splines};
use diffraction_brdf::filtered::{Pyramids, brdf_xyz_filtered, brdf_xyz_filtered_by_splines};
use diffraction_brdf::splines::Splines;
use diffraction_build::optics::pigment::{Surface, pigment_xyz};
use diffraction_render::render::cpu;
use diffraction_render::scene::model::{LookUps, Scene};

/// A surface made ready for pictures.
pub struct Shading<'a> {
    surface: Surface<'a>,
    /// Where the promised look-up is by splines.
    splines: Option<Splines>,
    /// Not of tables restricted to scenes: they answer for the directions of points, not for what lies around them.
    pyramids: Option<Pyramids>,
    tolerance: f64,
}

impl<'a> Shading<'a> {
    /// With the relative error of the luminance that filtering may make in scenes that state none.
    pub fn new(surface: Surface<'a>, tolerance: f64) -> Self {
        let set = surface.tables;
        let splines = (set.look_up() == Interpolation::Spline).then(|| Splines::new(&set.tables));
        let pyramids = set.restriction.is_none().then(|| Pyramids::new(set));
        Self { surface, splines, pyramids, tolerance }
    }

    /// The surface's XYZ in 1/sr.
    pub fn xyz(&self, wi: Vec3, wo: Vec3) -> Xyz {
        let brdf = match &self.splines {
            Some(splines) => brdf_xyz_by_splines(self.surface.tables, splines, wi, wo),
            None => brdf_xyz(self.surface.tables, Interpolation::Bilinear, wi, wo),
        };
        self.with_pigment(brdf, wi, wo)
    }

    /// A scene's picture: of filtered look-ups where it wants them and the tables have them, else of points.
    ///
    /// # Errors
    /// A scene that cannot be rendered.
    pub fn render(&self, scene: &Scene) -> Result<Array3<f32>> {
        let Some(pyramids) = self.pyramids.as_ref().filter(|_| scene.look_ups == LookUps::Filtered) else {
            return cpu::render(scene, &|wi, wo| self.xyz(wi, wo));
        };
        let mean = |wi: Vec3, wo: Vec3, footprint: Footprint| {
            let (set, directions) = (self.surface.tables, [wi, wo]);
            let brdf = match &self.splines {
                Some(splines) => brdf_xyz_filtered_by_splines(set, pyramids, splines, directions, footprint),
                None => brdf_xyz_filtered(set, pyramids, Interpolation::Bilinear, directions, footprint),
            };
            self.with_pigment(brdf, wi, wo)
        };
        cpu::render_filtered(scene, scene.tolerance.unwrap_or(self.tolerance), &mean)
    }

    /// What lies below varies slowly: the centre's value stands for a mean.
    fn with_pigment(&self, brdf: Xyz, wi: Vec3, wo: Vec3) -> Xyz {
        let Some(pigment) = self.surface.pigment else { return brdf };
        let below = pigment_xyz(pigment, wi, wo);
        std::array::from_fn(|c| brdf[c] + below[c])
    }
}
