//! The screen set-up: positions of known orders, and its energy against a form factor.

use std::f64::consts::{FRAC_1_PI, PI, TAU};

use diffraction_brdf::direction::{Vec3, dot, normalise};
use diffraction_render::render::cpu::render;
use diffraction_render::scene::model::{Scene, Shape};
use diffraction_render::scene::samples::pixel_centre;

use super::scene;

fn set_up(width_mm: f64, incidence_deg: f64, beam_diameter_mm: f64, size_px: usize) -> Scene {
    let shape =
        Shape::Screen { distance_mm: 100.0, width_mm, beam_diameter_mm, hole_diameter_mm: Some(0.0), incidence_deg };
    scene(shape, [0.0, 0.0, 1.0], size_px)
}

fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Form factor from a small area at the origin to a polygon above its horizon (Lambert's formula):
/// `Σ angle_k (normal of edge k's plane · n) / 2π`.
fn form_factor(normal: Vec3, corners: &[Vec3]) -> f64 {
    let mut sum = 0.0;
    for (k, &a) in corners.iter().enumerate() {
        let (a, b) = (normalise(a), normalise(corners[(k + 1) % corners.len()]));
        sum += dot(a, b).acos() * dot(normalise(cross(a, b)), normal);
    }
    sum.abs() / TAU
}

fn square(width_mm: f64) -> [Vec3; 4] {
    let h = 0.5 * width_mm;
    [[-h, -h, 100.0], [h, -h, 100.0], [h, h, 100.0], [-h, h, 100.0]]
}

#[test]
fn the_form_factor_meets_the_parallel_square_in_closed_form() {
    // Small square: F -> area / (π d²).
    let small = form_factor([0.0, 0.0, 1.0], &square(0.1));
    assert!((small / (0.01 / (PI * 1e4)) - 1.0).abs() < 1e-5);
    // Square of half width = distance: four corner pieces of the textbook's formula.
    let root = 2f64.sqrt();
    let corner = (1.0 / TAU) * 2.0 * (1.0 / root) * (1.0 / root).atan();
    let big = form_factor([0.0, 0.0, 1.0], &square(200.0));
    assert!((big - 4.0 * corner).abs() < 1e-14);
}

#[test]
fn a_white_sample_lights_the_screen_as_the_form_factor_says() {
    for (width_mm, incidence_deg) in [(150.0, 0.0), (400.0, 0.0), (100.0, 30.0), (60.0, -55.0)] {
        let size_px = 200;
        let scene = set_up(width_mm, incidence_deg, 1e-3, size_px);
        let image = render(&scene, &|_, _| [FRAC_1_PI; 3]).unwrap();
        let pixel_mm2 = (width_mm / size_px as f64).powi(2);
        let power: f64 = image.index_axis(ndarray::Axis(2), 1).iter().map(|&e| f64::from(e)).sum();
        let beam_mm2 = PI * 0.25e-6;
        let (sin, cos) = incidence_deg.to_radians().sin_cos();
        let normal = [sin, 0.0, cos];
        let expected = form_factor(normal, &square(width_mm));
        let ratio = power * pixel_mm2 / beam_mm2 / expected;
        // Midpoint rule: (pixel / distance)² / 24 times derivatives of order 10; pixel <= 2 mm.
        assert!((ratio - 1.0).abs() < 2e-4, "{width_mm} mm, {incidence_deg} deg: {ratio}");
        let tilted_more = form_factor(normalise([sin + 0.1, 0.0, cos]), &square(width_mm));
        assert!((tilted_more / expected - 1.0).abs() > 1e-3);
    }
}

/// Centre of gravity of the light near an order, in mm, the screen being seen from the source.
fn spot_mm(scene: &Scene, orders_u: f64, width_mm: f64) -> [f64; 2] {
    let width = 0.004;
    let order = move |wi: Vec3, wo: Vec3| {
        let (u, v) = (-wi[0] - wo[0] - orders_u, -wi[1] - wo[1]);
        [(-(u * u + v * v) / (2.0 * width * width)).exp(); 3]
    };
    let image = render(scene, &order).unwrap();
    let (mut sum, mut x, mut y) = (0.0, 0.0, 0.0);
    for ((row, column, channel), &value) in image.indexed_iter() {
        if channel == 1 {
            let [px, py] = pixel_centre(scene, row, column);
            sum += f64::from(value);
            x += f64::from(value) * px * 0.5 * width_mm;
            y += f64::from(value) * py * 0.5 * width_mm;
        }
    }
    assert!(sum > 0.0, "the order misses the screen");
    [x / sum, y / sum]
}

#[test]
fn orders_land_where_the_grating_equation_says() {
    let spacing = 532.0 / 1600.0;
    for incidence_deg in [0.0, 10.0, -15.0] {
        let scene = set_up(300.0, incidence_deg, 0.5, 300);
        let (sin, cos) = f64::to_radians(incidence_deg).sin_cos();
        for m in [-1.0, 0.0, 1.0] {
            // Local: u = -wi_x - wo_x = mλ/d, with wi = (-sin, 0, cos) for a beam along -z.
            let wo_x = sin - m * spacing;
            let wo_z = (1.0 - wo_x * wo_x).sqrt();
            // To the world: tangent (cos, 0, -sin), normal (sin, 0, cos).
            let world = [wo_x * cos + wo_z * sin, 0.0, -wo_x * sin + wo_z * cos];
            let expected_mm = 100.0 * world[0] / world[2];
            let [x, y] = spot_mm(&scene, m * spacing, 300.0);
            // The lobe is 0.4 mm wide; its skew by projection and falloff is of order width² / distance.
            assert!((x - expected_mm).abs() < 0.05, "order {m}: {x} and {expected_mm} mm");
            assert!(y.abs() < 0.05);
        }
    }
}

#[test]
fn the_mirror_direction_lands_at_twice_the_incidence() {
    let scene = set_up(300.0, 20.0, 0.5, 300);
    let [x, _] = spot_mm(&scene, 0.0, 300.0);
    assert!((x - 100.0 * 40f64.to_radians().tan()).abs() < 0.05, "{x}");
}

/// A mirror shows the beam's own cross-section: at normal incidence a disc of the beam's diameter.
#[test]
fn a_wide_beam_blurs_the_spot_by_its_diameter() {
    let mut scene = set_up(40.0, 0.0, 20.0, 80);
    scene.light_samples = 3000;
    let image = render(&scene, &|wi: Vec3, wo: Vec3| {
        let (u, v) = (wi[0] + wo[0], wi[1] + wo[1]);
        let width = 0.004;
        let f = (-(u * u + v * v) / (2.0 * width * width)).exp() / (2.0 * PI * width * width);
        [f; 3]
    })
    .unwrap();
    // All power of a lobe of unit power arrives evenly: irradiance 1 inside, 0 outside.
    let at = |x_mm: f64| image[[40, ((x_mm + 20.0) * 2.0) as usize, 1]];
    assert!((at(0.0) - 1.0).abs() < 0.02 && (at(7.0) - 1.0).abs() < 0.02);
    assert!(at(13.0) < 0.02 && at(-13.0) < 0.02);
}

/// A tilted mirror stretches the beam: the ray at `x` meets the sample at height `-x tan a` and goes
/// on at `2a`, so it lands at `x (1 + tan a tan 2a) + distance tan 2a`.
#[test]
fn a_tilted_mirror_stretches_the_spot() {
    let mut scene = set_up(300.0, 20.0, 20.0, 150);
    scene.light_samples = 400;
    let width = 0.004;
    let image = render(&scene, &|wi: Vec3, wo: Vec3| {
        let (u, v) = (wi[0] + wo[0], wi[1] + wo[1]);
        [(-(u * u + v * v) / (2.0 * width * width)).exp(); 3]
    })
    .unwrap();
    let (mut sum, mut x, mut xx) = (0.0, 0.0, 0.0);
    for ((row, column, _), &value) in image.indexed_iter() {
        let x_mm = pixel_centre(&scene, row, column)[0] * 150.0;
        sum += f64::from(value);
        x += f64::from(value) * x_mm;
        xx += f64::from(value) * x_mm * x_mm;
    }
    let deviation_mm = (xx / sum - (x / sum).powi(2)).sqrt();
    let (tan, tan_twice) = (20f64.to_radians().tan(), 40f64.to_radians().tan());
    // A disc's standard deviation along x is half its radius. The lobe (0.8 mm) adds in squares: 1 %.
    let expected_mm = 5.0 * (1.0 + tan * tan_twice);
    assert!((deviation_mm / expected_mm - 1.0).abs() < 0.02, "{deviation_mm} {expected_mm}");
}

#[test]
fn the_hole_is_dark() {
    let mut scene = set_up(40.0, 0.0, 10.0, 40);
    let Shape::Screen { ref mut hole_diameter_mm, .. } = scene.shape else { unreachable!() };
    *hole_diameter_mm = None;
    let image = render(&scene, &|_, _| [1.0; 3]).unwrap();
    // 1 mm pixels: the hole's radius is the beam's, 5 mm.
    assert_eq!(image[[20, 20, 1]], 0.0);
    assert_eq!(image[[20, 24, 1]], 0.0);
    assert!(image[[20, 26, 1]] > 0.0);
}
