//! The instrument that looks: radiance factors averaged over what it accepts.

use std::f64::consts::PI;

use diffraction_brdf::Footprint;
use diffraction_brdf::direction::{Vec3, Xyz};
use diffraction_brdf::error::Result;
use diffraction_brdf::evaluate::Interpolation;
use diffraction_brdf::filtered::{Pyramids, brdf_xyz_filtered};
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::optics::light::white;
use diffraction_build::optics::pigment::{Surface, pigment_xyz};

/// Angular diameter in degrees that strips and spectra are averaged over: their step, so that no order falls between two.
pub(super) const ACCEPTANCE_DEG: f64 = 1.0;

/// A surface, what is needed to average over it, and the white that its colours are seen against.
pub(super) struct Instrument<'a> {
    surface: Surface<'a>,
    pyramids: Pyramids,
    white: Xyz,
}

impl<'a> Instrument<'a> {
    /// An instrument before a surface; fails on a light without power in the range.
    pub(super) fn new(surface: Surface<'a>, optics: &OpticsConfig) -> Result<Self> {
        let white = white(&optics.illuminant, optics.wavelength_nm)?;
        Ok(Self { surface, pyramids: Pyramids::new(surface.tables), white })
    }

    /// XYZ of the light itself, or of equal energy under a light of a single colour.
    pub(super) fn white(&self) -> Xyz {
        self.white
    }

    /// XYZ of the radiance factor, averaged over what it accepts.
    pub(super) fn radiance_factor(&self, wi: Vec3, wo: Vec3) -> Result<Xyz> {
        Ok(self.averaged(wi, wo, Footprint::of_light(wi, ACCEPTANCE_DEG)?))
    }

    /// XYZ of the radiance factor, averaged over a footprint.
    pub(super) fn averaged(&self, wi: Vec3, wo: Vec3, footprint: Footprint) -> Xyz {
        let Surface { tables, pigment } = self.surface;
        let brdf = brdf_xyz_filtered(tables, &self.pyramids, Interpolation::Bilinear, [wi, wo], footprint);
        let below = pigment.map_or([0.0; 3], |pigment| pigment_xyz(pigment, wi, wo));
        std::array::from_fn(|c| PI * (brdf[c] + below[c]))
    }
}
