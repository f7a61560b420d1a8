//! The energy limit of tables that would reflect more than arrives: their directional albedo, over all directions of incidence.

use rayon::prelude::*;

use super::power_sums::{ALBEDO_MAX, DirectionalAlbedo, Fineness, Summand};
use crate::tables::model::TableSet;
use diffraction_brdf::direction::{Vec3, from_angles_deg};
use diffraction_brdf::energy::EnergyLimit;

/// Nodes over the polar angle, the square of whose places is the cosine: they lie close where the albedo is steep.
const NODES: usize = 32;

/// Azimuths of a node. An albedo with orders has its maxima between them; how much of it is missed is measured in tests.
const AZIMUTHS: usize = 16;

/// Share of an albedo that its coarse sum may miss, see [`Fineness::Coarse`]: a limit is for the whole.
const MISSED_SHARE: f64 = 0.014;

/// Polar angles in degrees, and steps of azimuth, at which an excess is looked for beside those of the albedo's own list.
const PROBED: ([f64; 2], usize) = ([80.0, 89.5], 8);

/// The limit of tables for every direction; `None` where no direction looked at reflects more than arrives. `albedo` is theirs
/// for light from the azimuth 0.
pub fn energy_limit(set: &TableSet, albedo: &[DirectionalAlbedo]) -> Option<EnergyLimit> {
    if set.restriction.is_some() {
        return None;
    }
    let summand = Summand::new(set);
    let (thetas, steps) = PROBED;
    let probes = thetas.into_iter().flat_map(|theta| (1..steps).map(move |step| (theta, step)));
    let is_above = |at: f64| at > ALBEDO_MAX;
    let is_excess = albedo.iter().any(|at| is_above(at.albedo))
        || probes.into_iter().any(|(theta, step)| {
            is_above(of_direction(&summand, from_angles_deg(theta, step as f64 * 360.0 / steps as f64)))
        });
    if !is_excess {
        return None;
    }
    let cos_theta: Vec<f64> = (1..=NODES).map(|node| (node as f64 / NODES as f64).powi(2)).collect();
    let albedo = cos_theta.iter().map(|cos| brightest(&summand, *cos)).collect();
    // What is not finite is no limit, and said elsewhere.
    EnergyLimit::new(cos_theta, albedo).ok()
}

/// The largest albedo over azimuths at a cosine, with what sums may miss.
fn brightest(summand: &Summand, cos_theta: f64) -> f64 {
    // The same from every side where light falls straight on.
    let count = if cos_theta < 1.0 { AZIMUTHS } else { 1 };
    let at = |index: usize| {
        // No azimuth lies on an axis of a grating alone.
        let degrees = index as f64 * 360.0 / count as f64;
        of_direction(summand, from_angles_deg(cos_theta.acos().to_degrees(), degrees))
    };
    let all: Vec<f64> = (0..count).into_par_iter().map(at).collect();
    (1.0 + MISSED_SHARE) * all.into_iter().fold(0.0, f64::max)
}

fn of_direction(summand: &Summand, wi: Vec3) -> f64 {
    let [diffuse, lobe] = summand.parts(wi, Fineness::Coarse);
    diffuse[0] + lobe[0]
}

#[cfg(test)]
mod tests {
    use ndarray::Array2;

    use super::*;
    use crate::accuracy::power_sums::reflected;
    use crate::accuracy::power_sums::tests::{bundled, tables};
    use crate::height::HeightField;
    use crate::height::prepare::Level;
    use diffraction_brdf::material::Material;

    /// The albedo under a limit, by the fine quadrature.
    fn limited(set: &TableSet, limit: &EnergyLimit, theta_i_deg: f64, phi_i_deg: f64) -> f64 {
        let wi = from_angles_deg(theta_i_deg, phi_i_deg);
        let factor = |wo: Vec3| limit.factor(wi, wo);
        let [diffuse, lobe] = Summand::new(set).weighed_parts(wi, Fineness::Full, &factor);
        diffuse[0] + lobe[0]
    }

    #[test]
    fn a_limit_keeps_an_ideal_blazed_grating_from_reflecting_more_than_arrives() {
        let set = tables(&bundled("blazed_2500nm.tif", Level::None), Material::Ideal);
        let started = std::time::Instant::now();
        let limit = energy_limit(&set, &reflected(&set).albedo).unwrap();
        println!("{limit:.3?} in {:?}", started.elapsed());
        let mut worst: [f64; 2] = [0.0; 2];
        for phi in [0.0, 22.5, 31.0, 77.0, 90.0, 125.0, 180.0, 183.0, 270.0, 301.0] {
            let thetas =
                [0.0, 20.0, 30.0, 45.0, 55.0, 60.0, 64.0, 70.0, 75.0, 80.0, 83.0, 85.0, 87.0, 88.0, 89.0, 89.5];
            let albedo = thetas.map(|theta| limited(&set, &limit, theta, phi));
            println!("{phi}: {albedo:.3?}");
            worst[0] = albedo.into_iter().fold(worst[0], f64::max);
            // The geometric mean of both albedos would be no limit.
            let mean = |wo: Vec3| {
                let wi = from_angles_deg(89.5, phi);
                1.0 / (limit.albedo_at(wi[2]) * limit.albedo_at(wo[2])).sqrt().max(1.0)
            };
            let [diffuse, lobe] = Summand::new(&set).weighed_parts(from_angles_deg(89.5, phi), Fineness::Full, &mean);
            worst[1] = worst[1].max(diffuse[0] + lobe[0]);
        }
        assert!(worst[0] <= 1.01 && worst[1] > 1.1, "{worst:?}");
    }

    #[test]
    fn surfaces_that_need_no_limit_have_none() {
        let keratin = tables(&bundled("corn_snake_like.tif", Level::None), Material::Dielectric { n: 1.56 });
        let flat = HeightField { heights_nm: Array2::zeros((64, 64)), pitch_nm: [500.0; 2] };
        for set in [keratin, tables(&flat, Material::Ideal)] {
            assert_eq!(energy_limit(&set, &reflected(&set).albedo), None);
        }
    }
}
