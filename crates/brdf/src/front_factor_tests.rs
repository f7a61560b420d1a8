//! The front factors against an independent implementation, against each other in the mirror direction, and at the
//! ends of their range.

use std::f64::consts::PI;

use super::*;
use crate::direction::from_angles_deg;

const MATERIALS: [Material; 3] =
    [Material::Ideal, Material::Dielectric { n: 1.56 }, Material::Conductor { n: 0.96, k: 6.7 }];

fn of(material: Material, factor: Factor) -> FrontFactor {
    FrontFactor { material, shadowing: false, factor }
}

fn directions() -> impl Iterator<Item = (Vec3, Vec3)> {
    let thetas = [0.0, 1e-6, 20.0, 45.0, 60.0, 80.0, 89.0, 89.99];
    let pairs = thetas.into_iter().flat_map(move |i| thetas.map(|o| (i, o)));
    pairs.flat_map(|(i, o)| {
        [0.0, 40.0, 90.0, 135.0, 180.0].map(|phi| (from_angles_deg(i, 17.0), from_angles_deg(o, 17.0 + phi)))
    })
}

/// Orders of gratings in the plane of incidence, by an implementation that shares nothing with this one
/// (`tests/rigorous/factors.py`): the ratio of the two factors of every order. Every tenth case of the file.
#[test]
fn the_ratio_of_the_factors_is_that_of_an_independent_implementation() {
    let worst = |wrong: fn(Complex<f64>, Vec3, Vec3) -> [f64; 4]| {
        let text = include_str!("../../../tests/rigorous/cases.csv");
        let mut worst = [0.0f64; 2];
        for line in text.lines().skip(1) {
            let cells: Vec<&str> = line.split(',').collect();
            let (material, which) = match cells[1] {
                "aluminium" => (Material::Conductor { n: 0.96, k: 6.7 }, 0),
                "n = 1.56" | "dielectric" => (Material::Dielectric { n: 1.56 }, 1),
                _ => continue,
            };
            let number = |column: usize| cells[column].parse::<f64>().unwrap();
            let (period, theta_i_deg) = (number(2), number(4));
            let orders = |column: usize| cells[column].split(' ').map(|cell| cell.parse::<f64>().unwrap());
            for (m, (scalar, vector)) in (cells[6].parse::<i32>().unwrap()..).zip(orders(8).zip(orders(9))) {
                if scalar < 1e-3 {
                    continue;
                }
                let sine_i = theta_i_deg.to_radians().sin();
                let sine_o = sine_i + f64::from(m) / period;
                let wi = [-sine_i, 0.0, theta_i_deg.to_radians().cos()];
                let wo = [sine_o, 0.0, (1.0 - sine_o * sine_o).sqrt()];
                let index = complex_index(material).unwrap();
                let ours = 2.0 * wi[2] * wo[2] * wrong(index, wi, wo).iter().sum::<f64>()
                    / of(material, Factor::Scalar).diffuse(wi, wo);
                worst[which] = worst[which].max((ours / (vector / scalar) - 1.0).abs());
            }
        }
        worst
    };
    // Four digits in the file.
    let found = worst(polarised_factors);
    assert!(found.iter().all(|&worst| worst > 0.0 && worst < 2e-3), "{found:?}");
    // A wrong sign of φ: the viewer's lateral direction turned round.
    let turned = worst(|index, wi, wo| polarised_factors(index, wi, [-wo[0], -wo[1], wo[2]]));
    assert!(turned.iter().all(|&worst| worst > 0.1), "{turned:?}");
    // a and b exchanged, as they are if each root belongs to the other direction's sine.
    let exchanged = worst(|index, wi, wo| {
        let sine = |v: Vec3| v[0].hypot(v[1]);
        let other = |from: Vec3, to: Vec3| [from[0].signum() * sine(to), 0.0, from[2]];
        polarised_factors(index, other(wi, wo), other(wo, wi))
    });
    assert!(exchanged.iter().any(|&worst| worst > 0.02), "{exchanged:?}");
    // A missing cosine of either direction.
    for missing in [
        (|index, wi, wo| polarised_factors(index, wi, wo).map(|q| q / wi[2]))
            as fn(Complex<f64>, Vec3, Vec3) -> [f64; 4],
        |index, wi, wo| polarised_factors(index, wi, wo).map(|q| q / wo[2]),
    ] {
        let without = worst(missing);
        assert!(without.iter().all(|&worst| worst > 0.1), "{without:?}");
    }
}

#[test]
fn both_factors_reflect_r_in_the_mirror_direction() {
    for material in MATERIALS {
        for theta in [0.0, 1e-9, 30.0, 60.0, 85.0, 89.99] {
            let (wi, wo) = (from_angles_deg(theta, 50.0), from_angles_deg(theta, 230.0));
            let w2 = (wi[2] + wo[2]).powi(2);
            let r = reflectance(material, wi[2]);
            for factor in [Factor::Vector, Factor::Scalar] {
                let front = of(material, factor);
                for value in [front.diffuse(wi, wo) / w2, front.coherent(wi, wo)] {
                    // 1 + wi·wo is 6e-8 at 89.99 degrees, and rounded by 1e-16.
                    assert!((value / r - 1.0).abs() < 1e-8, "{material:?} {theta} {factor:?}: {value} {r}");
                }
            }
        }
    }
}

#[test]
fn factors_are_reciprocal_finite_and_the_vector_one_is_bounded() {
    let mut scalar_at_grazing = 0.0f64;
    for material in MATERIALS {
        for (wi, wo) in directions() {
            for factor in [Factor::Vector, Factor::Scalar] {
                let front = of(material, factor);
                for (there, back) in
                    [(front.diffuse(wi, wo), front.diffuse(wo, wi)), (front.coherent(wi, wo), front.coherent(wo, wi))]
                {
                    assert!(there.is_finite() && there >= 0.0, "{material:?} {factor:?} {wi:?} {wo:?}: {there}");
                    assert!((there - back).abs() <= 1e-12 * there.max(1.0), "{there} {back}");
                }
            }
            scalar_at_grazing = scalar_at_grazing.max(of(material, Factor::Scalar).diffuse(wi, wo));
            if let Some(index) = complex_index(material) {
                // Largest in p, back towards the light. With x = √|ε| cos θ a denominator is √|ε| |1 + x e^iφ|, for good metals at
                // φ near 90 degrees: at most 8 |ε| x_i x_o / ((1 + x_i²) (1 + x_o²)) <= 2 |ε|.
                let found = of(material, Factor::Vector).diffuse(wi, wo);
                assert!(found <= 2.0 * index.norm_sqr(), "{material:?} {wi:?} {wo:?}: {found}");
            }
        }
    }
    assert!(scalar_at_grazing > 1e3, "the scalar one has no bound: {scalar_at_grazing}");
}

#[test]
fn at_normal_incidence_the_azimuth_does_not_matter() {
    let index = Complex::new(1.56, 0.0);
    let wo = from_angles_deg(40.0, 0.0);
    let exact: f64 = polarised_factors(index, [0.0, 0.0, 1.0], wo).iter().sum();
    for tilt_deg in [1e-12, 1e-9, 1e-6, 1e-4] {
        for phi in [0.0, 45.0, 90.0, 200.0] {
            let near: f64 = polarised_factors(index, from_angles_deg(tilt_deg, phi), wo).iter().sum();
            assert!((near / exact - 1.0).abs() < 1e-5, "{tilt_deg} {phi}: {near} {exact}");
        }
    }
    // The roots a and b exchanged between the two that cross over, which orders in the plane of incidence never show.
    let exchanged = |phi: f64| {
        let wi = from_angles_deg(1e-6, phi);
        let [ss, sp, ps, pp] = polarised_factors(index, wi, wo);
        let root = |v: Vec3| (index * index - (v[0] * v[0] + v[1] * v[1])).norm();
        let by = (root(wi) / root(wo)).powi(2);
        ss + sp * by + ps / by + pp
    };
    assert!((exchanged(90.0) / exact - 1.0).abs() > 0.01, "{} {exact}", exchanged(90.0));
}

/// Scattering across the plane of incidence turns s into p: at φ = 90° nothing of s stays s, and p is left with what the
/// normal components reflect.
#[test]
fn polarisations_cross_over_at_a_right_angle() {
    let index = Complex::new(1.56, 0.0);
    let [ss, sp, ps, pp] = polarised_factors(index, from_angles_deg(60.0, 0.0), from_angles_deg(60.0, 90.0));
    assert!(ss < 1e-30 && sp > 0.01 && (sp / ps - 1.0).abs() < 1e-12 && pp > 0.0, "{ss} {sp} {ps} {pp}");
    // In the mirror direction they do not cross, and each is its own Fresnel reflectance.
    let (wi, wo) = (from_angles_deg(60.0, 0.0), from_angles_deg(60.0, 180.0));
    let in_plane = polarised_factors(index, wi, wo).map(|q| q * 4.0 * wi[2] * wo[2] / (wi[2] + wo[2]).powi(2));
    for (found, expected) in in_plane.into_iter().zip(polarised_reflectances(index, wi, wo)) {
        assert!((found - expected).abs() < 1e-12, "{found} {expected}");
    }
}

/// A Gaussian lobe and its image, over the viewer's disc: `∫ du dv`, the lateral frequency being the area element.
fn reflected(theta_i_deg: f64, width: f64, with_image: bool) -> f64 {
    let wi = from_angles_deg(theta_i_deg, 0.0);
    let shape = |r2: f64| (-0.5 * r2 / (width * width)).exp() / (2.0 * PI * width * width);
    let (steps, reach) = (600, 8.0 * width);
    let cell = 2.0 * reach / f64::from(steps);
    let mut sum = 0.0;
    for row in 0..steps {
        for column in 0..steps {
            let [du, dv] = [column, row].map(|i| (f64::from(i) + 0.5) * cell - reach);
            let (x, y) = (-wi[0] - du, -wi[1] - dv);
            let z2 = 1.0 - x * x - y * y;
            if z2 > 0.0 {
                let image = if with_image { shape(image_radius2(wi, [x, y, z2.sqrt()])) } else { 0.0 };
                sum += (shape(du * du + dv * dv) + image) * cell * cell;
            }
        }
    }
    sum
}

#[test]
fn the_lobe_and_its_image_keep_the_power_of_a_flat_surface_up_to_grazing() {
    // Windows of 16.25 and 4 µm at 450 nm.
    for width in [0.0031, 0.0127] {
        for theta_i_deg in [0.0, 45.0, 80.0, 85.0, 88.0, 89.5, 89.9] {
            let whole = reflected(theta_i_deg, width, true);
            assert!((whole - 1.0).abs() < 0.01, "{width} {theta_i_deg}: {whole}");
        }
        assert!(reflected(89.9, width, false) < 0.6, "without the image half is lost");
    }
}

#[test]
fn half_the_sum_of_the_polarisations_is_the_unpolarised_factor() {
    for material in [Material::Dielectric { n: 1.56 }, Material::Conductor { n: 0.96, k: 6.7 }] {
        let front = FrontFactor { material, shadowing: true, factor: Factor::Vector };
        for (theta_i, theta_o, phi) in [(0.0, 20.0, 10.0), (60.0, 60.0, 180.0), (60.0, 20.0, 77.0), (85.0, 70.0, 300.0)]
        {
            let (wi, wo) = (from_angles_deg(theta_i, 0.0), from_angles_deg(theta_o, phi));
            let found = front.polarised(wi, wo).unwrap();
            let half = |values: [f64; 4]| 0.5 * values.iter().sum::<f64>();
            for (found, expected) in
                [(half(found.diffuse), front.diffuse(wi, wo)), (half(found.coherent), front.coherent(wi, wo))]
            {
                assert!(
                    (found / expected - 1.0).abs() < 1e-12,
                    "{material:?} {theta_i} {theta_o} {phi}: {found} {expected}"
                );
            }
        }
    }
    // Near Brewster's angle, 57.3 degrees, p is not reflected.
    let keratin = FrontFactor { material: Material::Dielectric { n: 1.56 }, shadowing: false, factor: Factor::Vector };
    let [wi, wo] = [0.0, 180.0].map(|phi| from_angles_deg(57.34, phi));
    let [ss, sp, ps, pp] = keratin.polarised(wi, wo).unwrap().diffuse;
    assert!(pp < 1e-4 * ss && sp < 1e-20 && ps < 1e-20, "{ss} {sp} {ps} {pp}");
    // What knows no index or no polarisation has none.
    for front in
        [FrontFactor { material: Material::Ideal, ..keratin }, FrontFactor { factor: Factor::Scalar, ..keratin }]
    {
        assert_eq!(front.polarised(wi, wo), None);
    }
}
