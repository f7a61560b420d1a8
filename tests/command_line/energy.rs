//! The energy limit: from a run through the atlas to the crate that others read it with.

use diffraction_brdf::direction::from_angles_deg;
use diffraction_brdf::{Atlas, Brdf};

use crate::place::{HEAD, LASERS, Place, ROUGH, WAVE};

/// Share of the arriving light of Y that is reflected, by samples.
fn reflected(brdf: &Brdf, theta_deg: f64) -> f64 {
    const SAMPLES: usize = 1 << 16;
    let wo = from_angles_deg(theta_deg, 0.0);
    let mut random = fastrand::Rng::with_seed(5);
    let weight =
        |()| brdf.sample(wo, [random.f64(), random.f64(), random.f64()]).map_or(0.0, |sample| sample.weight[1]);
    std::iter::repeat_n((), SAMPLES).map(weight).sum::<f64>() / SAMPLES as f64
}

#[test]
fn an_ideal_surface_comes_with_a_limit_and_one_of_glass_needs_none() {
    let place = Place::with_scans();
    let run = place.publish(&[HEAD, &LASERS.replace("size = 65", "size = 129"), ROUGH, WAVE].concat());
    assert_eq!(run.status, 0);
    let atlas = Atlas::open(place.path("out/small")).unwrap();
    let wave = atlas.brdf("wave").unwrap();
    let limited = wave.clone().with_energy_limit();
    for theta_deg in [0.0, 40.0, 60.0, 75.0, 85.0, 88.0, 89.5] {
        let [free, kept] = [&wave, &limited].map(|brdf| reflected(brdf, theta_deg));
        println!("{theta_deg}: {free:.3} becomes {kept:.3}");
        // 65536 samples of bounded weight.
        assert!(kept < 1.02 && kept <= free, "{theta_deg}: {kept}");
        assert!(theta_deg < 89.0 || free > 1.5, "{theta_deg}: {free}");
    }
    let stored = place.json("out/small/v0001/wave/specimen.json")["energy_limit"].clone();
    assert_eq!(stored["albedo"].as_array().map(Vec::len), Some(32), "{stored}");
    assert!(place.json("out/small/v0001/rough/specimen.json").get("energy_limit").is_none());
    let glass = atlas.brdf("rough").unwrap();
    let (wi, wo) = (from_angles_deg(88.0, 20.0), from_angles_deg(85.0, 190.0));
    assert!(glass.energy_limit().is_none());
    assert_eq!(glass.clone().with_energy_limit().eval(wi, wo).map(f64::to_bits), glass.eval(wi, wo).map(f64::to_bits));
    assert!(place.call("inspect out/small").ended(0).stdout.contains("wave"));
    let text = std::fs::read_to_string(place.path("out/small/v0001/FORMAT.md")).unwrap();
    assert!(text.contains("max(1, a(wi_z), a(wo_z))"), "how to use it");
}
