//! Low-discrepancy points and the fixed sets of directions on which errors are measured.

use diffraction_brdf::direction::{Vec3, from_angles_deg};

/// Point `index` of the additive recurrence on the plane number (Roberts 2018), in [0, 1)²: evenly
/// spread for any count, the same on every machine.
pub fn plane(index: usize) -> [f64; 2] {
    // 1/g and 1/g² for the real root g of x³ = x + 1.
    const STEP: [f64; 2] = [0.754_877_666_246_692_8, 0.569_840_290_998_053_3];
    STEP.map(|step| (0.5 + (index + 1) as f64 * step).fract())
}

/// The same point, exact for indices that 64-bit floats cannot tell apart any more.
pub fn plane_far(index: u64) -> [f64; 2] {
    // The same steps in units of 2^-64; multiples of them wrap around just as fractions do.
    const STEP: [u64; 2] = [0xc13f_a9a9_02a6_328f, 0x91e1_0da5_c79e_7b1c];
    STEP.map(|step| {
        ((1u64 << 63).wrapping_add(index.wrapping_add(1).wrapping_mul(step)) >> 11) as f64 / (1u64 << 53) as f64
    })
}

/// Point `index` of the same kind in [0, 1)⁴.
pub fn four(index: usize) -> [f64; 4] {
    // Powers of 1/g for the real root g of x⁵ = x + 1.
    const G: f64 = 1.167_303_978_261_418_7;
    let mut step = 1.0;
    [(); 4].map(|()| {
        step /= G;
        (0.5 + (index + 1) as f64 * step).fract()
    })
}

/// Where on the hemisphere a set of directions lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Region {
    /// Both directions uniform in solid angle up to 85°.
    Hemisphere,
    /// Within [`NEAR_DEG`] of the mirror direction, or further where a lobe reaches further.
    NearSpecular,
    /// At least one direction between 75° and 89°.
    Grazing,
}

/// How far directions near the mirror direction lie from it in degrees, in polar angle and azimuth each; more where a
/// lobe is wider.
pub const NEAR_DEG: f64 = 5.0;

impl Region {
    /// All regions.
    pub const ALL: [Self; 3] = [Self::Hemisphere, Self::NearSpecular, Self::Grazing];

    /// Plain name for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::Hemisphere => "whole hemisphere",
            Self::NearSpecular => "near specular",
            Self::Grazing => "grazing",
        }
    }
}

/// `count` pairs `(wi, wo)` of a region; a longer list starts with the shorter one.
pub fn direction_pairs(region: Region, count: usize) -> Vec<(Vec3, Vec3)> {
    direction_pairs_in(region, 0..count)
}

/// Pairs of a region's list from one place to another.
pub fn direction_pairs_in(region: Region, places: std::ops::Range<usize>) -> Vec<(Vec3, Vec3)> {
    places
        .map(|index| {
            let [a, b, c, d] = four(index);
            let phi_i = 360.0 * b;
            match region {
                Region::Hemisphere => {
                    (from_angles_deg(theta(a, 0.0, 85.0), phi_i), from_angles_deg(theta(c, 0.0, 85.0), 360.0 * d))
                }
                Region::NearSpecular => near_specular(NEAR_DEG, theta(a, 0.0, 80.0), phi_i, [c, d]),
                Region::Grazing => {
                    let wi = from_angles_deg(theta(a, 75.0, 89.0), phi_i);
                    (wi, from_angles_deg(theta(c, 0.0, 89.0), 360.0 * d))
                }
            }
        })
        .collect()
}

/// Pairs of [`Region::NearSpecular`] up to so many degrees from the mirror direction, from one place of their list to another.
pub fn near_specular_pairs(within_deg: f64, places: std::ops::Range<usize>) -> Vec<(Vec3, Vec3)> {
    let at = |index| {
        let [a, b, c, d] = four(index);
        near_specular(within_deg, theta(a, 0.0, 80.0), 360.0 * b, [c, d])
    };
    places.map(at).collect()
}

/// Degrees of a polar angle at a share of the solid angle between two.
fn theta(share: f64, low_deg: f64, high_deg: f64) -> f64 {
    let (low, high) = (low_deg.to_radians().cos(), high_deg.to_radians().cos());
    (low + share * (high - low)).acos().to_degrees()
}

/// A pair of which one direction lies off the mirror of the other, by shares of a reach in polar angle and azimuth.
fn near_specular(within_deg: f64, theta_i: f64, phi_i: f64, [c, d]: [f64; 2]) -> (Vec3, Vec3) {
    let [tilt, turn] = [c, d].map(|share| within_deg * (share - 0.5) * 2.0);
    // What would lie beyond 85° comes back, and what would pass the normal goes on upon its other side.
    let theta_o = if theta_i + tilt > 85.0 { 170.0 - theta_i - tilt } else { theta_i + tilt };
    (from_angles_deg(theta_i, phi_i), from_angles_deg(theta_o, phi_i + 180.0 + turn))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_fill_the_square_evenly() {
        let n = 1000;
        let mut cells = [0usize; 25];
        for i in 0..n {
            let [x, y] = plane(i);
            cells[(x * 5.0) as usize * 5 + (y * 5.0) as usize] += 1;
        }
        assert!(cells.iter().all(|&c| (30..=50).contains(&c)), "{cells:?}");
    }

    #[test]
    fn far_points_continue_the_near_ones() {
        let apart = |a: [f64; 2], b: [f64; 2]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!((0..1000).all(|index| apart(plane(index), plane_far(index as u64)) < 1e-12));
        // Neighbours keep their distance however far out: 1/g and 1/g² of the side, up to whole sides.
        let [a, b] = [plane_far(1 << 50), plane_far((1 << 50) + 1)];
        for (step, c) in [(0.754_877_666_246_692_8, 0), (0.569_840_290_998_053_3, 1)] {
            assert!(((b[c] - a[c] - step).rem_euclid(1.0) + 1e-12) % 1.0 < 1e-11);
        }
    }

    #[test]
    fn regions_are_where_they_say() {
        for region in Region::ALL {
            for (wi, wo) in direction_pairs(region, 200) {
                assert!(wi[2] > 0.0 && wo[2] > 0.0);
                if region == Region::Grazing {
                    assert!(wi[2] < 75f64.to_radians().cos() + 1e-12);
                }
            }
        }
    }

    #[test]
    fn directions_near_the_mirror_reach_as_far_as_they_are_told() {
        assert_eq!(near_specular_pairs(NEAR_DEG, 7..90), direction_pairs_in(Region::NearSpecular, 7..90));
        let farthest = |within_deg: f64| {
            let offset = |(wi, wo): (Vec3, Vec3)| {
                assert!(wo[2] > 84.9999f64.to_radians().cos() - 1e-6, "{wo:?}");
                (wi[0] + wo[0]).hypot(wi[1] + wo[1])
            };
            near_specular_pairs(within_deg, 0..2000).into_iter().map(offset).fold(0.0, f64::max)
        };
        assert!(farthest(5.0) < 0.13 && farthest(20.0) > 0.3 && farthest(90.0) > 1.2);
    }
}
