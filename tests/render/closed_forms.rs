//! Pictures whose every pixel is known: Lambertian and mirror-like surfaces, grating orders.

use std::f64::consts::{FRAC_1_PI, PI};

use diffraction_brdf::direction::{Vec3, Xyz, dot, from_angles_deg, normalise};
use diffraction_render::render::cpu::{render, shade};
use diffraction_render::scene::model::{Light, Shape};
use diffraction_render::scene::samples::{pixel_centre, pixel_range, samples, samples_of};
use diffraction_render::scene::sphere;
use ndarray::Array3;

use super::scene;

const PATCH: Shape = Shape::Patch { width_mm: 30.0, distance_mm: 80.0, tilt_deg: 40.0, turn_deg: 25.0 };

fn lambertian(_: Vec3, _: Vec3) -> Xyz {
    [0.5 * FRAC_1_PI, FRAC_1_PI, 2.0 * FRAC_1_PI]
}

/// A Gaussian lobe around the mirror direction: with `cos_o dω_o = du dv` its power is 1.
fn mirror_lobe(width: f64) -> impl Fn(Vec3, Vec3) -> Xyz {
    move |wi, wo| {
        let (u, v) = (wi[0] + wo[0], wi[1] + wo[1]);
        let f = (-(u * u + v * v) / (2.0 * width * width)).exp() / (2.0 * PI * width * width);
        [f; 3]
    }
}

fn brightest(image: &Array3<f32>) -> (usize, usize) {
    let (mut best, mut at) = (0.0, (0, 0));
    for ((row, column, channel), &value) in image.indexed_iter() {
        if channel == 1 && value > best {
            (best, at) = (value, (row, column));
        }
    }
    at
}

/// Largest difference between a picture of a white sphere and `cos / π` for light from `direction`.
fn lambertian_defect(image: &Array3<f32>, direction: Vec3) -> f64 {
    let scene = scene(Shape::Sphere, direction, image.dim().0);
    let to_light = normalise(direction);
    let mut worst: f64 = 0.0;
    for ((row, column, channel), &value) in image.indexed_iter() {
        let [x, y] = pixel_centre(&scene, row, column).map(|c| c / sphere::RADIUS);
        let z_squared = 1.0 - x * x - y * y;
        let expected = if z_squared > 0.0 { dot([x, y, z_squared.sqrt()], to_light).max(0.0) * FRAC_1_PI } else { 0.0 };
        let expected = expected * [0.5, 1.0, 2.0][channel];
        worst = worst.max((f64::from(value) - expected).abs());
    }
    worst
}

#[test]
fn a_lambertian_sphere_shows_the_cosine() {
    let direction = [0.5, 0.8, 0.3];
    let image = render(&scene(Shape::Sphere, direction, 65), &lambertian).unwrap();
    // Weights are f32 and at most 1, channels at most 2/π: rounding of 2^-24 twice.
    assert!(lambertian_defect(&image, direction) < 1.3e-7);
    assert!(lambertian_defect(&image, [0.5, 0.81, 0.3]) > 1e-3);
}

#[test]
fn a_light_behind_the_sphere_leaves_it_dark() {
    let image = render(&scene(Shape::Sphere, [0.0, 0.0, -1.0], 33), &lambertian).unwrap();
    assert!(image.iter().all(|&value| value == 0.0));
}

#[test]
fn two_lights_add_up() {
    let (a, b) = ([0.0, 1.0, 1.0], [-1.0, 0.0, 0.2]);
    let mut both = scene(Shape::Sphere, a, 33);
    both.lights.push(Light { direction: b, angular_diameter_deg: 0.0, irradiance: 2.5 });
    let sum = render(&scene(Shape::Sphere, a, 33), &lambertian).unwrap()
        + render(&scene(Shape::Sphere, b, 33), &lambertian).unwrap() * 2.5;
    let image = render(&both, &lambertian).unwrap();
    for (value, expected) in image.iter().zip(&sum) {
        assert!((value - expected).abs() < 1e-6);
    }
}

/// A convex disc light wholly above the horizon irradiates like its centre.
#[test]
fn a_disc_light_irradiates_like_its_centre() {
    let mut wide = scene(PATCH, [0.2, 1.0, 1.0], 9);
    let point = render(&wide, &lambertian).unwrap();
    wide.lights[0].angular_diameter_deg = 40.0;
    wide.light_samples = 2000;
    let disc = render(&wide, &lambertian).unwrap();
    let ratio = disc[[4, 4, 1]] / point[[4, 4, 1]];
    // The spiral's lateral balance, about 1 / n of the cone's half width.
    assert!((ratio - 1.0).abs() < 1e-3, "{ratio}");
}

#[test]
fn total_light_of_a_sphere_converges_with_pixel_samples() {
    let mut front = scene(Shape::Sphere, [0.0, 0.0, 1.0], 16);
    let total = |image: &Array3<f32>| {
        let area = (2.0 / 16.0) * (2.0 / 16.0);
        image.index_axis(ndarray::Axis(2), 1).iter().map(|&y| f64::from(y) * area).sum::<f64>()
    };
    // ∫ (1/π) sqrt(1 - ρ²) over the disc of radius R is (2/3) R².
    let expected = 2.0 / 3.0 * sphere::RADIUS * sphere::RADIUS;
    front.pixel_samples = 64;
    let fine = (total(&render(&front, &lambertian).unwrap()) / expected - 1.0).abs();
    assert!(fine < 3e-4, "{fine}");
}

#[test]
fn a_highlight_sits_at_the_half_vector() {
    for direction in [[0.3, 0.2, 1.0], [-1.0, 0.4, 0.1], [0.2, -1.0, -0.2]] {
        let scene = scene(Shape::Sphere, direction, 201);
        let image = render(&scene, &mirror_lobe(0.05)).unwrap();
        let [lx, ly, lz] = normalise(direction);
        let half = normalise([lx, ly, lz + 1.0]);
        let (row, column) = brightest(&image);
        let [x, y] = pixel_centre(&scene, row, column);
        // The cosine of the light moves the maximum of f cos_i by about width² / 2 of the radius, below
        // the pixel's 0.01.
        let off = (x - half[0] * sphere::RADIUS).hypot(y - half[1] * sphere::RADIUS);
        assert!(off < 0.015, "{direction:?}: off by {off}");
    }
}

#[test]
fn a_turned_structure_turns_its_streak_on_a_patch() {
    // A lobe drawn out along local x shows as a bright line along the structure's x axis.
    let streak = |wi: Vec3, wo: Vec3| [(-((wi[1] + wo[1]) / 0.01).powi(2)).exp(); 3];
    for turn_deg in [0.0, 30.0, 90.0] {
        let shape = Shape::Patch { width_mm: 50.0, distance_mm: 100.0, tilt_deg: 0.0, turn_deg };
        let scene = scene(shape, [0.0, 0.0, 1.0], 101);
        let image = render(&scene, &streak).unwrap();
        let (sin, cos) = f64::to_radians(turn_deg).sin_cos();
        let at = |x: f64, y: f64| {
            let index = |c: f64| (50.0 + c * 40.0).round() as usize;
            image[[index(-y), index(x), 1]]
        };
        assert!(at(cos, sin) > 0.8 && at(-sin, cos) < 1e-3, "turned by {turn_deg}");
    }
}

#[test]
fn the_hemisphere_shows_grating_orders_where_the_equation_says() {
    let (wavelength_nm, pitch_nm, width) = (550.0, 1600.0, 0.01);
    let spacing = wavelength_nm / pitch_nm;
    let orders = move |wi: Vec3, wo: Vec3| {
        let (u, v) = (-wi[0] - wo[0], -wi[1] - wo[1]);
        let off = u - spacing * (u / spacing).round();
        [(-(off * off + v * v) / (2.0 * width * width)).exp(); 3]
    };
    let wi = from_angles_deg(20.0, 0.0);
    let scene = scene(Shape::Hemisphere, wi, 401);
    let image = render(&scene, &orders).unwrap();
    let row: Vec<f32> = (0..401).map(|column| image[[200, column, 1]]).collect();
    let found: Vec<f64> = (1..400)
        .filter(|&c| row[c] > 0.5 && row[c] >= row[c - 1] && row[c] > row[c + 1])
        .map(|c| pixel_centre(&scene, 200, c)[0])
        .collect();
    // sin_r = -sin_i - mλ/d inside (-1, 1): m = -3 .. 1, from left to right m = 1, 0, -1, ...
    let expected: Vec<f64> = (-3..=1).rev().map(|m| -wi[0] - f64::from(m) * spacing).collect();
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (f, e) in found.iter().zip(&expected) {
        // Half a pixel.
        assert!((f - e).abs() <= 0.5 * 2.0 / 401.0 + 1e-9, "{f} {e}");
    }
}

#[test]
fn the_hemisphere_map_integrates_to_the_reflected_power() {
    let wi = from_angles_deg(30.0, 70.0);
    let scene = scene(Shape::Hemisphere, wi, 200);
    let image = render(&scene, &mirror_lobe(0.05)).unwrap();
    let power: f64 = image.iter().map(|&f| f64::from(f)).sum::<f64>() / 3.0 * 1e-4;
    // Pixels of 0.01 against a width of 0.05: the midpoint rule on a Gaussian is exact to rounding.
    assert!((power - 1.0).abs() < 1e-5, "{power}");
}

/// The map shows `f` in 1/sr whatever the irradiance, the light's angle or the sampling.
#[test]
fn the_hemisphere_map_of_a_lambertian_is_its_brdf() {
    let mut scene = scene(Shape::Hemisphere, from_angles_deg(60.0, 10.0), 20);
    scene.lights[0].irradiance = 7.0;
    scene.lights[0].angular_diameter_deg = 10.0;
    scene.light_samples = 12;
    scene.pixel_samples = 5;
    let image = render(&scene, &lambertian).unwrap();
    assert!((f64::from(image[[4, 9, 1]]) - FRAC_1_PI).abs() < 1e-7);
    assert_eq!(image[[0, 0, 1]], 0.0);
}

#[test]
fn stored_directions_are_unit_vectors_above_the_surface() {
    let mut shapes = vec![Shape::Hemisphere, Shape::Sphere, Shape::Snake, PATCH];
    shapes.push(Shape::Screen {
        distance_mm: 50.0,
        width_mm: 120.0,
        beam_diameter_mm: 2.0,
        hole_diameter_mm: None,
        incidence_deg: 35.0,
    });
    for shape in shapes {
        let mut scene = scene(shape, [0.3, 0.9, 0.15], 32);
        scene.lights[0].angular_diameter_deg = 30.0;
        scene.light_samples = 9;
        scene.pixel_samples = 4;
        let samples = samples(&scene).unwrap();
        assert!(!samples.weight.is_empty());
        assert_eq!(samples.first.len(), 32 * 32 + 1);
        assert_eq!(*samples.first.last().unwrap() as usize, samples.weight.len());
        for (wi, wo) in samples.wi.iter().zip(&samples.wo) {
            for v in [wi, wo] {
                let length: f32 = v.iter().map(|c| c * c).sum();
                assert!((length - 1.0).abs() < 1e-6 && v[2] > 0.0);
            }
        }
        assert!(samples.weight.iter().all(|&w| w > 0.0 && w.is_finite()));
    }
}

#[test]
fn patch_samples_carry_the_geometry() {
    let scene = scene(PATCH, [0.1, 0.7, 1.0], 21);
    let samples = samples(&scene).unwrap();
    let to_light = normalise([0.1, 0.7, 1.0]);
    let (sin, cos) = 40f64.to_radians().sin_cos();
    let cos_i = dot([0.0, sin, cos], to_light);
    for (wi, weight) in samples.wi.iter().zip(&samples.weight) {
        assert!((f64::from(wi[2]) - cos_i).abs() < 1e-7);
        assert!((f64::from(*weight) - cos_i).abs() < 1e-7);
    }
    // The middle looks straight at the camera, so cos_o is the tilt's cosine.
    let middle = pixel_range(&samples, 10, 10);
    assert!((f64::from(samples.wo[middle.start][2]) - cos).abs() < 1e-7);
}

#[test]
fn subsets_and_bands_hold_the_same_pixels() {
    let mut scene = scene(Shape::Sphere, [0.3, 0.2, 1.0], 50);
    scene.lights[0].angular_diameter_deg = 0.5;
    // 50 pixels a row of 3000 samples: several bands.
    scene.light_samples = 3000;
    let brdf = mirror_lobe(0.02);
    let all = samples(&scene).unwrap();
    let whole = shade(&all, &brdf);
    assert_eq!(render(&scene, &brdf).unwrap(), whole);
    // Every seventh pixel, as references are gathered.
    let subset = shade(&samples_of(&scene, 0..50, 7).unwrap(), &brdf);
    assert_eq!(subset.dim(), (8, 8, 3));
    for ((row, column, channel), value) in subset.indexed_iter() {
        assert_eq!(*value, whole[[7 * row, 7 * column, channel]]);
    }
    assert!(subset.iter().any(|&value| value > 0.0));
    let part = samples_of(&scene, 20..30, 1).unwrap();
    assert_eq!(pixel_range(&part, 3, 5).len(), pixel_range(&all, 23, 5).len());
}

#[test]
fn pictures_are_the_same_on_any_number_of_threads() {
    let mut scene = scene(PATCH, [0.1, 0.7, 1.0], 40);
    scene.lights[0].angular_diameter_deg = 5.0;
    scene.light_samples = 20;
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| render(&scene, &mirror_lobe(0.03)).unwrap())
    };
    let bits = |image: Array3<f32>| image.mapv(f32::to_bits);
    assert_eq!(bits(on(1)), bits(on(5)));
}

#[test]
fn too_many_samples_at_once_are_refused_and_bands_are_offered() {
    let mut scene = scene(Shape::Sphere, [0.0, 0.0, 1.0], 4096);
    scene.lights[0].angular_diameter_deg = 1.0;
    scene.light_samples = 64;
    let message = samples(&scene).unwrap_err().to_string();
    assert!(message.contains("light_samples"), "{message}");
    assert!(samples_of(&scene, 0..4, 1).is_ok());
    scene.light_samples = 0;
    assert!(samples(&scene).unwrap_err().to_string().contains("light_samples = 0"));
}
