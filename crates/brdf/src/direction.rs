//! Directions on the upper hemisphere, the wave-vector change `q`, and the geometry factor.

/// A vector in the local frame: x along scan columns, y up the image, z the outward normal.
pub type Vec3 = [f64; 3];

/// CIE XYZ, Y being luminous; 1/sr where it is a BRDF.
pub type Xyz = [f64; 3];

/// Cosines below this are rounding of a right angle: the cosine of 90 degrees itself comes out as 6e-17.
const COSINE_MIN: f64 = 1e-12;

/// Unit vector from polar angles in degrees (theta from the normal, phi from +x towards +y). At 90 degrees z is 0.
pub fn from_angles_deg(theta_deg: f64, phi_deg: f64) -> Vec3 {
    let (sin_t, cosine) = theta_deg.to_radians().sin_cos();
    let cos_t = if cosine.abs() < COSINE_MIN { 0.0 } else { cosine };
    let (sin_p, cos_p) = phi_deg.to_radians().sin_cos();
    [sin_t * cos_p, sin_t * sin_p, cos_t]
}

/// Polar angles of a unit vector in degrees: theta from the normal, phi in [0, 360). The inverse of [`from_angles_deg`].
pub fn angles_deg([x, y, z]: Vec3) -> [f64; 2] {
    let phi_deg = y.atan2(x).to_degrees();
    [x.hypot(y).atan2(z).to_degrees(), if phi_deg < 0.0 { phi_deg + 360.0 } else { phi_deg }]
}

/// Scalar product.
pub fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Vector scaled to unit length; the zero vector is returned unchanged.
pub fn normalise(a: Vec3) -> Vec3 {
    let length = dot(a, a).sqrt();
    if length == 0.0 {
        return a;
    }
    [a[0] / length, a[1] / length, a[2] / length]
}

/// `q = (u, v, w) = -wi - wo`; `w` lies in [-2, 0] for directions above the surface.
pub fn wave_vector_change(wi: Vec3, wo: Vec3) -> Vec3 {
    [-wi[0] - wo[0], -wi[1] - wo[1], -wi[2] - wo[2]]
}

/// Length of a vector in the plane of the surface, in directions' own scale: squares of its components neither overflow nor vanish,
/// and the root of their sum takes a fraction of the time of `hypot`.
pub fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

/// `sqrt(4 - u² - v²)`: the largest `|w|` that directions above the surface reach at a radius `sqrt(u² + v²)`.
pub fn max_abs_w(radius: f64) -> f64 {
    (4.0 - radius * radius).max(0.0).sqrt()
}

/// `t = |w| / sqrt(4 - u² - v²)`, the normalised `|w|`: in [0, 1] for directions above the surface.
pub fn normalised_abs_w(q: Vec3) -> f64 {
    let largest = max_abs_w(length([q[0], q[1]]));
    if largest == 0.0 { 0.0 } else { (q[2].abs() / largest).min(1.0) }
}

/// Geometry factor `G = (1 + wi·wo)² / (cos_i cos_o)` of the scalar (Kirchhoff) reflection model,
/// equal to `|q|⁴ / (4 cos_i cos_o)` (Stam 1999, eq. 9). Both cosines must be positive.
pub fn geometry_factor(wi: Vec3, wo: Vec3) -> f64 {
    let one_plus = 1.0 + dot(wi, wo);
    one_plus * one_plus / (wi[2] * wo[2])
}

/// V-cavity shadowing and masking (Cook and Torrance 1982), in [0, 1].
pub fn v_cavity_shadowing(wi: Vec3, wo: Vec3) -> f64 {
    let m = normalise([wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]]);
    let wo_m = dot(wo, m);
    if wo_m <= 0.0 {
        return 0.0;
    }
    let scale = 2.0 * m[2] / wo_m;
    (scale * wo[2]).min(scale * wi[2]).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn geometry_factor_equals_q_to_the_fourth() {
        let wi = from_angles_deg(35.0, 20.0);
        let wo = from_angles_deg(61.0, 250.0);
        let q = wave_vector_change(wi, wo);
        let expected = dot(q, q).powi(2) / (4.0 * wi[2] * wo[2]);
        assert!((geometry_factor(wi, wo) / expected - 1.0).abs() < 1e-13);
    }

    #[test]
    fn angles_and_vectors_are_inverse() {
        for (theta, phi) in [(0.0, 0.0), (35.0, 20.0), (89.9, 359.0), (61.0, 250.0), (90.0, 180.0)] {
            let [theta_deg, phi_deg] = angles_deg(from_angles_deg(theta, phi));
            assert!((theta_deg - theta).abs() < 1e-12 && (phi_deg - phi).abs() < 1e-9, "{theta_deg} {phi_deg}");
        }
    }

    #[test]
    fn the_horizon_is_not_above_the_surface() {
        for (theta_deg, phi_deg) in [(90.0, 0.0), (-90.0, 30.0), (90.0, 200.0), (270.0, 10.0)] {
            assert_eq!(from_angles_deg(theta_deg, phi_deg)[2], 0.0, "{theta_deg}");
        }
        assert!(from_angles_deg(89.999_999, 0.0)[2] > 1e-8);
    }

    #[test]
    fn mirror_direction_has_no_lateral_change() {
        let q = wave_vector_change(from_angles_deg(40.0, 10.0), from_angles_deg(40.0, 190.0));
        assert!(q[0].abs() < 1e-15 && q[1].abs() < 1e-15);
        assert!((q[2] + 2.0 * 40f64.to_radians().cos()).abs() < 1e-15);
    }
}
