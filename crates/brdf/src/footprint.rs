//! How far (u, v) reach for lights with a size and for pixels of curved surfaces: covariances that add.

use crate::direction::{Vec3, wave_vector_change};
use crate::error::{Error, Result};

/// The (u, v) that one look-up stands for: a covariance around the centre's.
///
/// It stands for the ellipse that has this covariance when evenly filled: semi-axes of twice the standard deviations.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Footprint {
    uu: f64,
    uv: f64,
    vv: f64,
}

impl Footprint {
    /// A single point: the default.
    pub const POINT: Self = Self { uu: 0.0, uv: 0.0, vv: 0.0 };

    /// The footprint of a covariance of (u, v), without unit.
    ///
    /// # Errors
    /// [`Error::Call`] for numbers that are not finite or are no covariance: a negative variance, or a correlation beyond 1.
    pub fn new(uu: f64, uv: f64, vv: f64) -> Result<Self> {
        let is_finite = uu.is_finite() && uv.is_finite() && vv.is_finite();
        // A covariance of rank one is rounded to either side of zero.
        if !(is_finite && uu >= 0.0 && vv >= 0.0 && uv * uv <= uu * vv * (1.0 + 1e-9)) {
            return Err(Error::Call(format!(
                "({uu}, {uv}, {vv}) is no covariance of (u, v): variances must not be negative, nor uv² larger than uu vv"
            )));
        }
        Ok(Self { uu, uv, vv })
    }

    /// The footprint of a round light that is even over its disc, `angular_diameter_deg` across, around the direction `wi`.
    ///
    /// Seen along the normal the disc is an ellipse, exactly so as long as it is above the horizon: with the angular radius
    /// α its semi-axes are `sin α` across the plane of incidence and `sin α cos_theta_i` along it.
    ///
    /// # Errors
    /// [`Error::Call`] for a diameter that is not in [0, 180] degrees.
    pub fn of_light(wi: Vec3, angular_diameter_deg: f64) -> Result<Self> {
        if !(0.0..=180.0).contains(&angular_diameter_deg) {
            return Err(Error::Call(format!(
                "a light's angular diameter lies between 0 and 180 degrees, not at {angular_diameter_deg}"
            )));
        }
        let variance = 0.25 * (0.5 * angular_diameter_deg).to_radians().sin().powi(2);
        // Along the unit vector p of incidence in the plane the variance is smaller by cos², which is 1 - sin²; and sin p is
        // the lateral part of wi.
        let [x, y, _] = wi;
        Self::new(variance * (1.0 - x * x), -variance * x * y, variance * (1.0 - y * y))
    }

    /// The footprint of a pixel on a curved surface, over which the normal is tilted by `(a, b)` along x and y in radians with
    /// the covariance `[aa, ab, bb]`.
    ///
    /// Directions stay where they are while the frame tilts. The lateral part of `h = wi + wo` in a frame whose normal is
    /// `(a, b, 1)` is `(h_x - a h_z, h_y - b h_z)`, so `(u, v) = -h` moves by `(a, b) |w|`: the covariance is that of the
    /// normals times `w²`. Of first order in the tilt, as is the tilt's definition.
    ///
    /// # Errors
    /// [`Error::Call`] for what is no covariance.
    pub fn of_normals(wi: Vec3, wo: Vec3, [aa, ab, bb]: [f64; 3]) -> Result<Self> {
        let w2 = wave_vector_change(wi, wo)[2].powi(2);
        Self::new(w2 * aa, w2 * ab, w2 * bb)
    }

    /// `[uu, uv, vv]`.
    pub fn covariance(&self) -> [f64; 3] {
        [self.uu, self.uv, self.vv]
    }

    /// The footprint of (u, v) scaled by a factor.
    pub(crate) fn scaled(self, factor: f64) -> Self {
        let square = factor * factor;
        Self { uu: square * self.uu, uv: square * self.uv, vv: square * self.vv }
    }

    /// Variances along the axes of the ellipse, the larger first, and the unit vector of the first axis.
    pub(crate) fn axes(&self) -> ([f64; 2], [f64; 2]) {
        let (mean, half) = (0.5 * (self.uu + self.vv), 0.5 * (self.uu - self.vv));
        let spread = half.hypot(self.uv);
        let angle = 0.5 * self.uv.atan2(half);
        ([mean + spread, (mean - spread).max(0.0)], [angle.cos(), angle.sin()])
    }

    /// The footprint with these variances along a unit vector and across it.
    pub(crate) fn of_axes([along, across]: [f64; 2], [x, y]: [f64; 2]) -> Self {
        Self { uu: along * x * x + across * y * y, uv: (along - across) * x * y, vv: along * y * y + across * x * x }
    }
}

impl std::ops::Add for Footprint {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { uu: self.uu + other.uu, uv: self.uv + other.uv, vv: self.vv + other.vv }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::direction::{dot, from_angles_deg, normalise};

    fn cross(a: Vec3, b: Vec3) -> Vec3 {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    }

    /// Covariance of the lateral parts of directions that are even over the disc in what they light the surface with.
    fn counted(wi: Vec3, radius: f64) -> [f64; 3] {
        let s = normalise(cross(wi, [0.3, -0.5, 0.81]));
        let p = cross(wi, s);
        let (mut sums, mut weight) = ([0.0; 5], 0.0);
        for n in 0..200_000 {
            let height = 1.0 - (1.0 - radius.cos()) * (f64::from(n) + 0.5) / 200_000.0;
            let phi = 2.399_963_229_728_653 * f64::from(n);
            let across = (1.0 - height * height).sqrt();
            let d: Vec3 = std::array::from_fn(|k| height * wi[k] + across * (phi.cos() * s[k] + phi.sin() * p[k]));
            weight += d[2];
            let moments = [d[0], d[1], d[0] * d[0], d[0] * d[1], d[1] * d[1]];
            sums.iter_mut().zip(moments).for_each(|(sum, moment)| *sum += d[2] * moment);
        }
        let [x, y, xx, xy, yy] = sums.map(|sum| sum / weight);
        [xx - x * x, xy - x * y, yy - y * y]
    }

    #[test]
    fn a_lights_disc_has_the_covariance_that_is_stated() {
        for (theta, phi, diameter) in [(0.0, 0.0, 0.53), (40.0, 25.0, 2.0), (70.0, 200.0, 10.0), (60.0, 90.0, 20.0)] {
            let wi = from_angles_deg(theta, phi);
            let stated = Footprint::of_light(wi, diameter).unwrap().covariance();
            let counted = counted(wi, (0.5 * diameter).to_radians());
            let scale = stated[0] + stated[2];
            let exchanged = [stated[2], stated[1], stated[0]];
            let error = |guess: [f64; 3]| (0..3).map(|k| (guess[k] - counted[k]).abs()).fold(0.0, f64::max) / scale;
            assert!(error(stated) < 1e-4, "{theta} {phi}: {stated:?} {counted:?}");
            if theta > 0.0 {
                assert!(error(exchanged) > 0.05, "exchanged axes must be found: {theta} {phi}");
            }
        }
    }

    #[test]
    fn tilted_normals_move_u_and_v_as_stated() {
        let (wi, wo) = (from_angles_deg(40.0, 20.0), from_angles_deg(55.0, 150.0));
        let local = |a: f64, b: f64| {
            let z = normalise([a, b, 1.0]);
            let x = normalise([1.0 - z[0] * z[0], -z[0] * z[1], -z[0] * z[2]]);
            let y = cross(z, x);
            let turned = |d: Vec3| [dot(d, x), dot(d, y), dot(d, z)];
            wave_vector_change(turned(wi), turned(wo))
        };
        const STEP: f64 = 1e-5;
        let difference = |a: f64, b: f64, k: usize| (local(a, b)[k] - local(-a, -b)[k]) / (2.0 * STEP);
        let [du_da, dv_da, du_db, dv_db] =
            [(STEP, 0.0, 0), (STEP, 0.0, 1), (0.0, STEP, 0), (0.0, STEP, 1)].map(|(a, b, k)| difference(a, b, k));
        let [aa, ab, bb] = [2e-4, 5e-5, 1e-4];
        let expected = [
            du_da * du_da * aa + 2.0 * du_da * du_db * ab + du_db * du_db * bb,
            du_da * dv_da * aa + (du_da * dv_db + du_db * dv_da) * ab + du_db * dv_db * bb,
            dv_da * dv_da * aa + 2.0 * dv_da * dv_db * ab + dv_db * dv_db * bb,
        ];
        let found = Footprint::of_normals(wi, wo, [aa, ab, bb]).unwrap().covariance();
        for k in 0..3 {
            assert!((found[k] - expected[k]).abs() < 1e-8 * aa, "{found:?} {expected:?}");
        }
        assert!((found[0] / expected[2] - 1.0).abs() > 0.5, "exchanged axes must be found");
    }

    #[test]
    fn axes_are_those_of_the_covariance() {
        for [uu, uv, vv] in [[3.0, 1.0, 2.0], [1.0, -0.4, 5.0], [2.0, 0.0, 2.0], [0.0, 0.0, 0.0], [1.0, 1.0, 1.0]] {
            let footprint = Footprint::new(uu, uv, vv).unwrap();
            let (variances, axis) = footprint.axes();
            let back = Footprint::of_axes(variances, axis).covariance();
            assert!(variances[0] >= variances[1]);
            for (found, given) in back.into_iter().zip([uu, uv, vv]) {
                assert!((found - given).abs() < 1e-14, "{back:?}");
            }
        }
    }

    #[test]
    fn what_is_no_footprint_is_told() {
        for [uu, uv, vv] in [[-1e-9, 0.0, 1.0], [1.0, 1.1, 1.0], [f64::NAN, 0.0, 1.0], [1.0, 0.0, f64::INFINITY]] {
            let message = Footprint::new(uu, uv, vv).unwrap_err().to_string();
            assert!(message.contains("no covariance"), "{message}");
        }
        for diameter in [-0.1, 181.0, f64::NAN] {
            let message = Footprint::of_light([0.0, 0.0, 1.0], diameter).unwrap_err().to_string();
            assert!(message.contains("between 0 and 180"), "{message}");
        }
    }

    #[test]
    fn footprints_add_as_covariances() {
        let sum = Footprint::new(1.0, 0.5, 2.0).unwrap() + Footprint::new(0.5, -0.25, 0.5).unwrap();
        assert_eq!(sum, Footprint::new(1.5, 0.25, 2.5).unwrap());
    }
}
