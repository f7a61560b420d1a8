//! The limit that path tracers need of surfaces that would reflect more than arrives: see
//! [`Brdf::with_energy_limit`](crate::Brdf::with_energy_limit).

use serde::{Deserialize, Serialize};

use crate::direction::Vec3;

/// Directional albedo of luminance over the polar angle, the largest over azimuths: what a BRDF is divided by so that
/// nothing reflects more than arrives.
///
/// Azimuths are not told apart: which of them is bright changes within the width of an order, while the excess, the factor in front
/// of the tables, grows towards grazing light from anywhere.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Stored")]
pub struct EnergyLimit {
    cos_theta: Vec<f64>,
    albedo: Vec<f64>,
}

/// The same, unchecked.
#[derive(Deserialize)]
struct Stored {
    cos_theta: Vec<f64>,
    albedo: Vec<f64>,
}

impl TryFrom<Stored> for EnergyLimit {
    type Error = String;

    fn try_from(Stored { cos_theta, albedo }: Stored) -> Result<Self, String> {
        Self::new(cos_theta, albedo)
    }
}

impl EnergyLimit {
    /// Albedos at cosines of polar angles, which ascend from above 0 to 1 at most.
    ///
    /// # Errors
    /// Lists that differ in length or are empty, cosines that do not ascend within their range, and albedos that are not finite
    /// or negative; in words.
    pub fn new(cos_theta: Vec<f64>, albedo: Vec<f64>) -> Result<Self, String> {
        if cos_theta.len() != albedo.len() || albedo.is_empty() {
            return Err(format!("an energy limit has {} cosines and {} albedos", cos_theta.len(), albedo.len()));
        }
        let ascends = cos_theta.windows(2).all(|pair| pair[0] < pair[1]);
        let is_within = cos_theta[0] > 0.0 && cos_theta[cos_theta.len() - 1] <= 1.0;
        if !(ascends && is_within) {
            return Err("the cosines of an energy limit must ascend within 0 and 1".into());
        }
        if let Some(wrong) = albedo.iter().find(|albedo| !(albedo.is_finite() && **albedo >= 0.0)) {
            return Err(format!("an energy limit holds the albedo {wrong}"));
        }
        Ok(Self { cos_theta, albedo })
    }

    /// The albedo at a cosine above 0: `albedo cos_theta` between the two nearest nodes is linear, and constant beyond the
    /// first and the last, since the factor grows like `1/cos_theta`.
    pub fn albedo_at(&self, cos_theta: f64) -> f64 {
        let product = |index: usize| self.albedo[index] * self.cos_theta[index];
        let last = self.cos_theta.len() - 1;
        let above = self.cos_theta.partition_point(|node| *node <= cos_theta);
        let between = match above {
            0 => product(0),
            above if above > last => product(last),
            above => {
                let [low, high] = [self.cos_theta[above - 1], self.cos_theta[above]];
                let share = (cos_theta - low) / (high - low);
                product(above - 1) * (1.0 - share) + product(above) * share
            }
        };
        between / cos_theta
    }

    /// What the BRDF is multiplied by for a pair of directions above the surface: `1 / max(1, albedo(wi), albedo(wo))`.
    ///
    /// It is reciprocal, and what is reflected of light from `wi` is at most `albedo(wi)` times `1 / albedo(wi)`. The geometric mean
    /// of the two would be reciprocal too and is no limit: light from a bright angle into a dark one would keep the root of its
    /// excess.
    pub fn factor(&self, wi: Vec3, wo: Vec3) -> f64 {
        if !(wi[2] > 0.0 && wo[2] > 0.0) {
            return 1.0;
        }
        1.0 / self.albedo_at(wi[2]).max(self.albedo_at(wo[2])).max(1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn albedos_between_nodes_grow_towards_grazing_as_the_factor_does() {
        let limit = EnergyLimit::new(vec![0.1, 0.5, 1.0], vec![5.0, 1.0, 0.6]).unwrap();
        let close = |a: f64, b: f64| (a - b).abs() < 1e-12;
        assert!(
            close(limit.albedo_at(0.1), 5.0) && close(limit.albedo_at(0.5), 1.0) && close(limit.albedo_at(1.0), 0.6)
        );
        // 0.5 at both nodes: a pure 1/cos.
        assert!(close(limit.albedo_at(0.25), 2.0) && close(limit.albedo_at(0.01), 50.0));
        let [steep, low, up] = [[0.8f64.sqrt(), 0.0, 0.2f64.sqrt()], [0.75f64.sqrt(), 0.0, 0.5], [0.0, 0.0, 1.0]];
        assert_eq!(limit.factor(low, up), 1.0);
        assert!(limit.factor(steep, up) < 1.0 && limit.factor(steep, up) == limit.factor(up, steep));
        assert_eq!(limit.factor([0.0, 0.0, -1.0], up), 1.0);
    }

    #[test]
    fn limits_that_are_none_are_refused() {
        let read = |text: &str| serde_json::from_str::<EnergyLimit>(text);
        let good = r#"{"cos_theta":[0.5,1.0],"albedo":[2.0,0.5]}"#;
        assert_eq!(serde_json::to_string(&read(good).unwrap()).unwrap(), good);
        for bad in [
            "[0.5],\"albedo\":[2,1]",
            "[],\"albedo\":[]",
            "[1,0.5],\"albedo\":[2,1]",
            "[0,1],\"albedo\":[2,1]",
            "[0.5,1],\"albedo\":[2,-1]",
        ] {
            assert!(read(&format!("{{\"cos_theta\":{bad}}}")).is_err(), "{bad}");
        }
    }
}
