//! Materials, and their Fresnel power reflectance at the half vector.

use num_complex::Complex;

use crate::direction::{Vec3, dot};

/// The material, by its refractive index; sets the Fresnel reflectance.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Material {
    /// Reflects everything.
    Ideal,
    /// Transparent, refractive index `n` against air.
    Dielectric {
        /// Refractive index.
        n: f64,
    },
    /// Complex index `n + ik`.
    Conductor {
        /// Real part.
        n: f64,
        /// Imaginary part, positive.
        k: f64,
    },
}

/// Power reflectance for unpolarised light; `cos_theta_d` is the cosine between either direction and
/// the half vector. The surrounding medium is air, `n = 1`.
pub fn reflectance(material: Material, cos_theta_d: f64) -> f64 {
    let index = match material {
        Material::Ideal => return 1.0,
        Material::Dielectric { n } => Complex::new(n, 0.0),
        Material::Conductor { n, k } => Complex::new(n, k),
    };
    let cos_i = Complex::new(cos_theta_d.clamp(0.0, 1.0), 0.0);
    let sin2_t = (Complex::new(1.0, 0.0) - cos_i * cos_i) / (index * index);
    let cos_t = root(Complex::new(1.0, 0.0) - sin2_t);
    let s = (cos_i - index * cos_t) / (cos_i + index * cos_t);
    let p = (index * cos_i - cos_t) / (index * cos_i + cos_t);
    0.5 * (s.norm_sqr() + p.norm_sqr())
}

/// The principal square root without inverse functions: `sqrt((|z| + |x|)/2)` is the larger part, and twice the product of both
/// is `y`.
pub(crate) fn root(z: Complex<f64>) -> Complex<f64> {
    if z.im == 0.0 {
        return z.sqrt();
    }
    let larger = (0.5 * (z.norm_sqr().sqrt() + z.re.abs())).sqrt();
    let smaller = 0.5 * z.im / larger;
    if z.re >= 0.0 { Complex::new(larger, smaller) } else { Complex::new(smaller.abs(), larger.copysign(z.im)) }
}

/// Cosine between `wi` (or `wo`) and their half vector: `|q| / 2`.
pub fn cos_half_angle(wi: Vec3, wo: Vec3) -> f64 {
    (0.5 + 0.5 * dot(wi, wo)).max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normal_incidence_meets_the_closed_forms() {
        let glass = reflectance(Material::Dielectric { n: 1.5 }, 1.0);
        assert!((glass - 0.04).abs() < 1e-15);
        let (n, k) = (0.27, 2.77);
        let gold = ((n - 1.0f64).powi(2) + k * k) / ((n + 1.0f64).powi(2) + k * k);
        assert!((reflectance(Material::Conductor { n, k }, 1.0) - gold).abs() < 1e-14);
    }

    #[test]
    fn roots_are_the_principal_ones() {
        for re in [-40.0, -1.0, -1e-9, 0.0, 1e-9, 0.3, 2.0] {
            for im in [-12.0, -1e-12, 0.0, 1e-12, 1.0, 12.0] {
                let z = Complex::new(re, im);
                let (found, polar) = (root(z), z.sqrt());
                assert!((found * found - z).norm() <= 4e-16 * z.norm(), "{z}: {found}");
                assert!(
                    found.re >= 0.0 && (found - polar).norm() <= 1e-7 * polar.norm().max(1e-9),
                    "{z}: {found} {polar}"
                );
            }
        }
    }

    #[test]
    fn brewster_angle_extinguishes_one_polarisation_and_grazing_reflects_all() {
        let n: f64 = 1.56;
        let brewster = n.atan();
        let sin_t = brewster.sin() / n;
        let s = ((brewster.cos() - n * (1.0 - sin_t * sin_t).sqrt())
            / (brewster.cos() + n * (1.0 - sin_t * sin_t).sqrt()))
        .powi(2);
        let both = reflectance(Material::Dielectric { n }, brewster.cos());
        assert!((both - 0.5 * s).abs() < 1e-14);
        assert!((reflectance(Material::Dielectric { n }, 0.0) - 1.0).abs() < 1e-14);
        assert!((reflectance(Material::Conductor { n: 1.0, k: 0.0 }, 0.3)).abs() < 1e-14);
    }
}
