//! What stands in front of a window's power for one pair of directions.

use super::config::OpticsConfig;
use diffraction_brdf::direction::{Vec3, wave_vector_change};
use diffraction_brdf::front_factor::{Factor, image_radius2};

/// What a pair of directions asks of a window's power.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairFactors {
    /// `-wi - wo`.
    pub q: Vec3,
    /// Factor of all but the coherent part, before the division by `w²`.
    pub diffuse: f64,
    /// Factor of the coherent part.
    pub coherent: f64,
    /// Distance in (u, v) of the lobe's image in the horizon, where it counts.
    pub image_radius: Option<f64>,
}

impl PairFactors {
    /// `None` for directions not above the surface.
    pub fn of(optics: &OpticsConfig, wi: Vec3, wo: Vec3) -> Option<Self> {
        let front = optics.front_factor();
        (wi[2] > 0.0 && wo[2] > 0.0).then(|| Self {
            q: wave_vector_change(wi, wo),
            diffuse: front.diffuse(wi, wo),
            coherent: front.coherent(wi, wo),
            image_radius: (front.factor == Factor::Vector).then(|| image_radius2(wi, wo).sqrt()),
        })
    }

    /// The same by polarisation: ss, sp, ps, pp, the incident one first; `None` where the factor knows none, or for directions
    /// not above the surface.
    pub fn polarised(optics: &OpticsConfig, wi: Vec3, wo: Vec3) -> Option<[Self; 4]> {
        let (all, front) = (Self::of(optics, wi, wo)?, optics.front_factor().polarised(wi, wo)?);
        Some(std::array::from_fn(|kind| Self { diffuse: front.diffuse[kind], coherent: front.coherent[kind], ..all }))
    }

    /// The BRDF in 1/sr at a wavelength from the power without the coherent part, the coherent part, and that of the image, in
    /// nm².
    pub fn brdf(&self, wavelength_nm: f64, rest_nm2: f64, coherent_nm2: f64) -> f64 {
        (self.diffuse * rest_nm2 / (self.q[2] * self.q[2]) + self.coherent * coherent_nm2) / wavelength_nm.powi(2)
    }
}
