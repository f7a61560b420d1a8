//! Closed forms of reflectance and geometry, written apart from the crate's own.

use std::f64::consts::TAU;

use diffraction_brdf::direction::Vec3;
use diffraction_build::optics::config::Material;

/// Fresnel power reflectance in real arithmetic (Born and Wolf, Principles of Optics, 7th ed., §14.2: a
/// plane wave on an absorbing half space), for unpolarised light.
pub fn fresnel(material: Material, cos: f64) -> f64 {
    let (n, k) = match material {
        Material::Ideal => return 1.0,
        Material::Dielectric { n } => (n, 0.0),
        Material::Conductor { n, k } => (n, k),
    };
    let sin2 = 1.0 - cos * cos;
    let real = n * n - k * k - sin2;
    let length = (real * real + 4.0 * n * n * k * k).sqrt();
    let a = (0.5 * (length + real)).sqrt();
    let b2 = 0.5 * (length - real);
    let s = ((a - cos).powi(2) + b2) / ((a + cos).powi(2) + b2);
    let tangent = sin2 / cos;
    let p = s * ((a - tangent).powi(2) + b2) / ((a + tangent).powi(2) + b2);
    0.5 * (s + p)
}

/// `R G / w²`: what stands before the window's power spectrum, from the angles alone.
pub fn front(material: Material, wi: Vec3, wo: Vec3) -> f64 {
    let cos_between = wi[0] * wo[0] + wi[1] * wo[1] + wi[2] * wo[2];
    let between = 1.0 + cos_between;
    let abs_w = wi[2] + wo[2];
    fresnel(material, (0.5 * between).sqrt()) * between * between / (wi[2] * wo[2] * abs_w * abs_w)
}

/// Density over (u, v) of a unit of power in a lobe of this deviation.
pub fn gaussian(u: f64, v: f64, deviation: f64) -> f64 {
    (-0.5 * (u * u + v * v) / (deviation * deviation)).exp() / (TAU * deviation * deviation)
}
