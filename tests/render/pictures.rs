//! Pictures of the stand-in grating in every set-up, written to the target's tmp folder to be
//! looked at, with the colours checked where the grating equation puts them.

use std::path::Path;

use diffraction_brdf::direction::{Vec3, Xyz};
use diffraction_build::ground::colour::to_srgb8;
use diffraction_render::render::cpu::render;
use diffraction_render::render::png_image::write_png;
use diffraction_render::scene::model::{Exposure, Scene, Shape, exposure_factor};
use diffraction_render::scene::samples::pixel_centre;
use diffraction_render::scene::sphere;
use ndarray::Array3;

use super::grating::{Grating, brdf};
use super::scene;

const SCALE_LIKE: Grating =
    Grating { pitch_nm: 1550.0, amplitude_nm: 70.0, width_u: 0.008, width_v: 0.12, pitch_spread: 0.02, step_nm: 4.0 };

const CLEAN: Grating =
    Grating { pitch_nm: 1600.0, amplitude_nm: 70.0, width_u: 0.006, width_v: 0.012, pitch_spread: 0.0, step_nm: 4.0 };

/// Side of the pictures; `PICTURE_PX` in the environment sets another one for a closer look.
fn size_px() -> usize {
    std::env::var("PICTURE_PX").map_or(96, |text| text.parse().expect("PICTURE_PX is a number"))
}

fn picture(name: &str, scene: &Scene, grating: &Grating) -> Array3<f32> {
    let shader = |wi: Vec3, wo: Vec3| -> Xyz { brdf(grating, wi, wo) };
    let image = render(scene, &shader).unwrap();
    assert!(image.iter().all(|value| value.is_finite()));
    let exposure = exposure_factor(scene.exposure, &image);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    write_png(&folder.join(format!("{name}.png")), &to_srgb8(&image, exposure)).unwrap();
    image
}

fn at(image: &Array3<f32>, scene: &Scene, x: f64, y: f64) -> Xyz {
    let side = scene.size_px as f64;
    let column = ((x + 1.0) * 0.5 * side) as usize;
    let row = ((1.0 - y) * 0.5 * side) as usize;
    let [cx, cy] = pixel_centre(scene, row, column);
    assert!((cx - x).abs() <= 1.0 / side + 1e-12 && (cy - y).abs() <= 1.0 / side + 1e-12);
    [0, 1, 2].map(|channel| f64::from(image[[row, column, channel]]))
}

/// Bluish, greenish and reddish in turn along a first order that starts at the inside.
fn assert_fan(colours: [Xyz; 3]) {
    let share = |xyz: Xyz| xyz.map(|c| c / xyz.iter().sum::<f64>());
    let [blue, green, red] = colours.map(share);
    assert!(blue[2] > 0.6, "blue end {blue:?}");
    assert!(green[1] > green[0] && green[1] > green[2], "middle {green:?}");
    assert!(red[0] > 0.55 && red[2] < 0.05, "red end {red:?}");
}

#[test]
fn sphere_under_the_sun() {
    let mut scene = scene(Shape::Sphere, [0.3, 0.2, 1.0], size_px());
    scene.lights[0].angular_diameter_deg = 0.53;
    scene.light_samples = 4;
    picture("sphere", &scene, &SCALE_LIKE);

    // Light from the camera: u = 2 sin(longitude) along the equator.
    let mut front = super::scene(Shape::Sphere, [0.0, 0.0, 1.0], size_px());
    front.pixel_samples = 4;
    let image = picture("sphere_front", &front, &SCALE_LIKE);
    let along = |wavelength_nm: f64| {
        let x = 0.5 * wavelength_nm / SCALE_LIKE.pitch_nm * sphere::RADIUS;
        at(&image, &front, x, 1.0 / size_px() as f64)
    };
    assert_fan([along(450.0), along(545.0), along(630.0)]);
    // Dark between the mirror image and the first order, which begins at 400 nm.
    assert!(along(200.0)[1] < 0.02 * along(545.0)[1]);
}

#[test]
fn snake_under_the_sun() {
    let mut scene = scene(Shape::Snake, [0.1, 0.6, 1.0], size_px());
    scene.lights[0].angular_diameter_deg = 0.53;
    scene.light_samples = 4;
    let image = picture("snake", &scene, &SCALE_LIKE);
    assert!(image.iter().any(|&value| value > 0.1));
}

#[test]
fn hemisphere_map() {
    let scene = scene(Shape::Hemisphere, [0.0, 0.0, 1.0], size_px());
    let image = picture("hemisphere", &scene, &CLEAN);
    let along = |wavelength_nm: f64| {
        let x = -wavelength_nm / CLEAN.pitch_nm;
        at(&image, &scene, x, 1.0 / size_px() as f64)
    };
    assert_fan([along(450.0), along(545.0), along(630.0)]);
    assert!(along(250.0)[1] < 1e-3 * along(545.0)[1]);
    // Nothing above and below the plane of diffraction.
    assert!(at(&image, &scene, -0.34, 0.3)[1] < 1e-9);
}

#[test]
fn patch_in_perspective() {
    let mut scene = scene(
        Shape::Patch { width_mm: 100.0, distance_mm: 150.0, tilt_deg: 25.0, turn_deg: 20.0 },
        [-0.25, 0.75, 1.0],
        size_px(),
    );
    scene.lights[0].angular_diameter_deg = 0.53;
    scene.light_samples = 4;
    let image = picture("patch", &scene, &SCALE_LIKE);
    assert!(image.iter().any(|&value| value > 0.1));
}

#[test]
fn screen_with_white_beam() {
    let shape = Shape::Screen {
        distance_mm: 100.0,
        width_mm: 200.0,
        beam_diameter_mm: 3.0,
        hole_diameter_mm: Some(6.0),
        incidence_deg: 0.0,
    };
    let mut scene = scene(shape, [0.0, 0.0, 1.0], size_px());
    scene.light_samples = 16;
    scene.exposure = Exposure::Auto;
    let image = picture("screen", &scene, &CLEAN);
    // At normal incidence the first order of λ lands at distance tan(asin(λ/d)).
    let along = |wavelength_nm: f64| {
        let tangent = (wavelength_nm / CLEAN.pitch_nm).asin().tan();
        at(&image, &scene, tangent, 1.0 / size_px() as f64)
    };
    assert_fan([along(450.0), along(545.0), along(630.0)]);
    assert!(along(250.0)[1] < 1e-2 * along(545.0)[1]);
}
