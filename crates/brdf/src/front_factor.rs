//! The factor in front of the window's power: reflectance, geometry and shadowing.

use serde::{Deserialize, Serialize};

use crate::direction::{Vec3, geometry_factor, v_cavity_shadowing};
use crate::material::{Material, cos_half_angle, reflectance};

/// What the factor depends on besides the two directions.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct FrontFactor {
    /// Sets the Fresnel reflectance.
    pub material: Material,
    /// Whether the V-cavity shadowing factor is applied.
    pub shadowing: bool,
}

impl FrontFactor {
    /// `R G` times the shadowing, without unit; zero for directions not above the surface.
    pub fn value(&self, wi: Vec3, wo: Vec3) -> f64 {
        if !(wi[2] > 0.0 && wo[2] > 0.0) {
            return 0.0;
        }
        let shadowing = if self.shadowing { v_cavity_shadowing(wi, wo) } else { 1.0 };
        reflectance(self.material, cos_half_angle(wi, wo)) * geometry_factor(wi, wo) * shadowing
    }
}
