//! The factor in front of the window's power: how strongly the surface reflects from one direction into another.
//!
//! Two models share every table. The *scalar* one (Stam 1999, eq. 9; Dhillon et al. 2014, eq. 1) is `R G` with the Fresnel
//! reflectance `R` at the half vector and the geometry factor `G`: it grows without bound towards grazing angles. The
//! *vector* one is first-order vector perturbation theory (Rayleigh-Rice; Elson and Bennett 1979; Stover 1995), exact for
//! surfaces that are optically smooth: it follows the polarisations, and is bounded.

use num_complex::Complex;
use serde::{Deserialize, Serialize};

use crate::direction::{Vec3, geometry_factor, v_cavity_shadowing};
use crate::dispersion::INDEX_MAX;
use crate::material::{Material, cos_half_angle, reflectance, root};

/// Which model of reflection stands in front of the tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Factor {
    /// First-order vector perturbation; `R G` for an ideal reflector, which has no refractive index.
    Vector,
    /// `R G`, the published model. What atlases mean that do not say.
    #[default]
    Scalar,
}

/// What the factor depends on besides the two directions.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct FrontFactor {
    /// Sets the reflectance.
    pub material: Material,
    /// Whether the V-cavity shadowing factor is applied.
    pub shadowing: bool,
    /// Which model.
    #[serde(default)]
    pub factor: Factor,
}

/// Factors by polarisation, without unit: ss, sp, ps, pp, the incident one first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Polarised {
    /// Of diffuse part and cross term.
    pub diffuse: [f64; 4],
    /// Of the coherent lobe.
    pub coherent: [f64; 4],
}

/// Smallest modulus of a refractive index: no material has one near it, and squares of it are far from underflow.
const INDEX_MIN: f64 = 1e-3;

impl FrontFactor {
    /// What keeps the factor from being a number in every direction, in words: an index that no material has.
    pub(crate) fn check(&self) -> std::result::Result<(), String> {
        let [n, k] = match self.material {
            Material::Ideal => return Ok(()),
            Material::Dielectric { n } => [n, 0.0],
            Material::Conductor { n, k } => [n, k],
        };
        let is_possible = n > 0.0 && k >= 0.0 && n.hypot(k) >= INDEX_MIN && n.max(k) <= INDEX_MAX;
        if is_possible { Ok(()) } else { Err(format!("its material has the refractive index {n} + {k}i")) }
    }

    /// The factor of diffuse part and cross term, without unit, shadowing included; zero for directions not above the
    /// surface.
    pub fn diffuse(&self, wi: Vec3, wo: Vec3) -> f64 {
        if !above(wi, wo) {
            return 0.0;
        }
        let factor = match (self.factor, complex_index(self.material)) {
            (Factor::Vector, Some(index)) => 2.0 * wi[2] * wo[2] * polarised_factors(index, wi, wo).iter().sum::<f64>(),
            _ => reflectance(self.material, cos_half_angle(wi, wo)) * geometry_factor(wi, wo),
        };
        factor * self.shadowing(wi, wo)
    }

    /// The factor of the coherent lobe, without unit, shadowing included; zero for directions not above the surface.
    ///
    /// The lobe is what a flat surface reflects of light with a spread, and that is `R` of it: `R G / w²` is `R` in the
    /// mirror direction and stays near it but for grazing angles, where it has no bound. So the vector model takes `R`.
    pub fn coherent(&self, wi: Vec3, wo: Vec3) -> f64 {
        if !above(wi, wo) {
            return 0.0;
        }
        let mirror = reflectance(self.material, cos_half_angle(wi, wo)) * self.shadowing(wi, wo);
        match self.factor {
            Factor::Vector => mirror,
            Factor::Scalar => mirror * geometry_factor(wi, wo) / (wi[2] + wo[2]).powi(2),
        }
    }

    /// Both factors with the polarisations kept apart; `None` for the scalar factor and for ideal reflectors, which know none.
    /// Half the sum of the four is the unpolarised factor; zeros for directions not above the surface.
    pub fn polarised(&self, wi: Vec3, wo: Vec3) -> Option<Polarised> {
        let index = complex_index(self.material).filter(|_| self.factor == Factor::Vector)?;
        if !above(wi, wo) {
            return Some(Polarised { diffuse: [0.0; 4], coherent: [0.0; 4] });
        }
        let shadowing = self.shadowing(wi, wo);
        Some(Polarised {
            diffuse: polarised_factors(index, wi, wo).map(|factor| 4.0 * wi[2] * wo[2] * factor * shadowing),
            coherent: polarised_reflectances(index, wi, wo).map(|reflectance| reflectance * shadowing),
        })
    }

    fn shadowing(&self, wi: Vec3, wo: Vec3) -> f64 {
        if self.shadowing { v_cavity_shadowing(wi, wo) } else { 1.0 }
    }
}

fn above(wi: Vec3, wo: Vec3) -> bool {
    wi[2] > 0.0 && wo[2] > 0.0
}

fn complex_index(material: Material) -> Option<Complex<f64>> {
    match material {
        Material::Ideal => None,
        Material::Dielectric { n } => Some(Complex::new(n, 0.0)),
        Material::Conductor { n, k } => Some(Complex::new(n, k)),
    }
}

/// Below this product of squared sines the azimuth between the planes of incidence and of scattering is rounding; the
/// sum of the four factors does not depend on it there.
const SINES_MIN: f64 = 1e-24;

/// `Q_ss, Q_sp, Q_ps, Q_pp` without unit, the first letter the incident polarisation, the second the scattered one: the
/// scattered power is `4 cos_theta_i cos_theta_o Q` times the window's (Rayleigh-Rice; Stover 1995, eq. 4.1 to 4.6).
///
/// Written with the lateral components of the directions: `cos φ` is that between the incident light's lateral direction
/// of travel, `-wi`, and the scattered one's, so it is 1 on the mirror's side.
pub fn polarised_factors(index: Complex<f64>, wi: Vec3, wo: Vec3) -> [f64; 4] {
    let one = Complex::new(1.0, 0.0);
    let eps = index * index;
    let lateral2 = |v: Vec3| v[0] * v[0] + v[1] * v[1];
    let [sin2_i, sin2_o] = [lateral2(wi), lateral2(wo)];
    let (cos_i, cos_o) = (wi[2], wo[2]);
    let [a, b] = [root(eps - sin2_i), root(eps - sin2_o)];
    let sines = (sin2_i * sin2_o).sqrt();
    let cos_phi =
        if sin2_i * sin2_o > SINES_MIN { (-(wi[0] * wo[0] + wi[1] * wo[1]) / sines).clamp(-1.0, 1.0) } else { 1.0 };
    let sin2_phi = 1.0 - cos_phi * cos_phi;
    // Only moduli are asked for: those of the denominators are real, which spares complex divisions.
    let [s_i, s_o] = [(a + cos_i).norm_sqr(), (b + cos_o).norm_sqr()];
    let [p_i, p_o] = [(eps * cos_i + a).norm_sqr(), (eps * cos_o + b).norm_sqr()];
    let contrast = (eps - one).norm_sqr();
    [
        contrast * cos_phi * cos_phi / (s_i * s_o),
        contrast * sin2_phi * b.norm_sqr() / (s_i * p_o),
        contrast * sin2_phi * a.norm_sqr() / (p_i * s_o),
        contrast * (a * b * cos_phi - eps * sines).norm_sqr() / (p_i * p_o),
    ]
}

/// Square of the lateral distance at which the lobe's mirror image in the horizon lies, given that of the lobe itself:
/// `u² + v² + 4 (1 - sin_theta_i) (1 - sin_theta_o)`.
///
/// Of a lobe near the horizon a part lies below it, where nothing leaves. Reflected at the horizon it comes back: what is a
/// distance `d = 1 - sin_theta_o` above it takes the light of `-d`. With `d_i` and `d_o` the squared distance of the image is
/// `(d_i + d_o)²` in place of `(d_i - d_o)²` across the horizon and the same along it; the sum of the two stays
/// reciprocal, and holds the lobe's whole power as far as the horizon is straight over its width. `1 - sin θ` is taken from
/// the cosine, so nothing cancels.
pub fn image_radius2(wi: Vec3, wo: Vec3) -> f64 {
    let lateral2 = (wi[0] + wo[0]).powi(2) + (wi[1] + wo[1]).powi(2);
    let to_horizon = |v: Vec3| v[2] * v[2] / (1.0 + v[0].hypot(v[1]));
    lateral2 + 4.0 * to_horizon(wi) * to_horizon(wo)
}

/// The four polarised reflectances of the lobe, in the order of [`polarised_factors`]: a flat surface keeps s and p apart.
pub(crate) fn polarised_reflectances(index: Complex<f64>, wi: Vec3, wo: Vec3) -> [f64; 4] {
    let cos = cos_half_angle(wi, wo).clamp(0.0, 1.0);
    let inside = root(index * index - (1.0 - cos * cos));
    let s = (inside - cos) / (inside + cos);
    let p = (index * index * cos - inside) / (index * index * cos + inside);
    [s.norm_sqr(), 0.0, 0.0, p.norm_sqr()]
}

#[cfg(test)]
#[path = "front_factor_tests.rs"]
mod tests;
