//! Light from all around: against every texel as a light, and against closed forms.

use std::f64::consts::{FRAC_1_PI, PI};
use std::sync::Arc;

use diffraction_brdf::direction::{Vec3, Xyz, dot, normalise};
use diffraction_render::render::cpu;
use diffraction_render::scene::environment::{self, Environment};
use diffraction_render::scene::model::{Scene, Shape};
use diffraction_render::scene::turn::Turn;
use ndarray::{Array2, Array3};

use super::scene;

/// A dim sky with a bright window and a floor.
fn map() -> Array2<f32> {
    Array2::from_shape_fn((8, 16), |(row, column)| match (row, column) {
        (2..4, 9..11) => 12.0,
        (0..4, _) => 0.4 + 0.05 * column as f32,
        _ => 0.1,
    })
}

fn environment(map: &Array2<f32>) -> Environment {
    let sky = environment::sky(map.clone(), 0.0).unwrap();
    Environment { file: "sky.exr".into(), sha256: String::new(), turn: Turn::default(), sky: Arc::new(sky) }
}

fn lit(shape: Shape, map: &Array2<f32>, count: usize) -> Scene {
    let environment = Some(environment(map));
    Scene { environment, light_samples: count, ..Scene::still("sky", shape, Vec::new(), 16) }
}

/// Half a white Lambertian, half a lobe 14 degrees wide about the mirror direction.
fn glossy(wi: Vec3, wo: Vec3) -> Xyz {
    let half = normalise([wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]]);
    [0.5 * FRAC_1_PI + 2.0 * half[2].powi(64); 3]
}

/// The picture with `parts`² points in every texel as lights of their own: midpoints in the sine of latitude and
/// in longitude, each with its luminance times its solid angle.
fn every_texel(
    shape: &Shape,
    map: &Array2<f32>,
    parts: usize,
    brdf: &(dyn Fn(Vec3, Vec3) -> Xyz + Sync),
) -> Array3<f32> {
    let (rows, columns) = map.dim();
    let sine = |row: usize| (PI * row as f64 / rows as f64).cos();
    let mut sum = Array3::<f64>::zeros((16, 16, 3));
    for ((row, column), &luminance) in map.indexed_iter() {
        let solid_angle = 2.0 * PI / columns as f64 * (sine(row) - sine(row + 1)) / (parts * parts) as f64;
        for part in 0..parts * parts {
            let share = |index: usize| (index as f64 + 0.5) / parts as f64;
            let y = sine(row) + share(part / parts) * (sine(row + 1) - sine(row));
            let longitude = 2.0 * PI * ((column as f64 + share(part % parts)) / columns as f64 - 0.5);
            let level = (1.0 - y * y).sqrt();
            let direction = [-level * longitude.sin(), y, level * longitude.cos()];
            let mut one = scene(shape.clone(), direction, 16);
            one.lights[0].irradiance = f64::from(luminance) * solid_angle;
            sum += &cpu::render(&one, brdf).unwrap().mapv(f64::from);
        }
    }
    sum.mapv(|value| value as f32)
}

/// Largest difference as a share of the brightest pixel.
fn worst(a: &Array3<f32>, b: &Array3<f32>) -> f64 {
    let peak = a.iter().copied().fold(0.0, f32::max);
    a.iter().zip(b).map(|(a, b)| f64::from((a - b).abs() / peak)).fold(0.0, f64::max)
}

#[test]
fn sampled_light_is_that_of_every_texel() {
    let patch = Shape::Patch { width_mm: 20.0, distance_mm: 60.0, tilt_deg: 25.0, turn_deg: 10.0 };
    for shape in [Shape::Sphere, patch] {
        // 64 points per texel of 22 degrees: midpoints 2.8 degrees apart under a lobe of 14 err by (2.8/14)²/24.
        let brute = every_texel(&shape, &map(), 8, &glossy);
        let errors = [64, 512, 4096]
            .map(|count| worst(&brute, &cpu::render(&lit(shape.clone(), &map(), count), &glossy).unwrap()));
        println!("{shape:?}: {errors:.4?}");
        // A low-discrepancy set errs by its discrepancy, some 2 ln(n)/n, times the integrand's variation: here the
        // lobe's rise and fall and the window's four edges, about 6 of the brightest pixel.
        for (error, count) in errors.into_iter().zip([64.0f64, 512.0, 4096.0]) {
            assert!(error < 12.0 * count.ln() / count + 2e-3, "{count}: {error}");
        }
        // Turned by one texel, or upside down, it is another light.
        let turned = Array2::from_shape_fn((8, 16), |(row, column)| map()[[row, (column + 1) % 16]]);
        let flipped = Array2::from_shape_fn((8, 16), |(row, column)| map()[[7 - row, column]]);
        for other in [turned, flipped] {
            let error = worst(&brute, &cpu::render(&lit(shape.clone(), &other, 4096), &glossy).unwrap());
            assert!(error > 5.0 * errors[2] && error > 0.05, "{error}");
        }
    }
}

#[test]
fn a_uniform_sky_gives_the_power_sum_times_its_radiance() {
    const RADIANCE: f64 = 3.0;
    let sky = Array2::from_elem((8, 16), RADIANCE as f32);
    let total = environment::scalar_irradiance(&environment(&sky));
    assert!((total / (4.0 * PI * RADIANCE) - 1.0).abs() < 1e-12);
    let patch = Shape::Patch { width_mm: 1.0, distance_mm: 1000.0, tilt_deg: 0.0, turn_deg: 0.0 };
    // A white furnace: a Lambertian looks like the sky itself. Of n samples, those above the horizon carry
    // n/2 ∓ ln(n) cosines.
    let white = cpu::render(&lit(patch.clone(), &sky, 4096), &|_, _| [FRAC_1_PI; 3]).unwrap();
    let middle = f64::from(white[[8, 8, 1]]);
    assert!((middle / RADIANCE - 1.0).abs() < 5e-3, "{middle}");
    // A mirror seen through a coherence window of 0.8 µm at 550 nm: f = (G/w²) exp(-(u² + v²)/2s²)/(2πs²), s = 0.077,
    // summed over the incident hemisphere on a fine lattice of (u, v), where cosθ dω is the area.
    let s = 550.0 / (2.0 * 2f64.sqrt() * PI * 800.0);
    let mirror = |wi: Vec3, wo: Vec3| {
        let (u, v, w) = (wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]);
        let front = (1.0 + dot(wi, wo)).powi(2) / (wi[2] * wo[2] * w * w);
        [front * (-(u * u + v * v) / (2.0 * s * s)).exp() / (2.0 * PI * s * s); 3]
    };
    let cell = s / 8.0;
    let lattice = (-64..=64).flat_map(|i| (-64..=64).map(move |j| [f64::from(i) * cell, f64::from(j) * cell]));
    let power: f64 =
        lattice.map(|[x, y]| mirror([x, y, (1.0 - x * x - y * y).sqrt()], [0.0, 0.0, 1.0])[0] * cell * cell).sum();
    assert!((power - 1.0).abs() < 0.02, "{power}");
    let found = cpu::render(&lit(patch.clone(), &sky, 4096), &mirror).unwrap();
    let mean =
        (7..9).flat_map(|r| (7..9).map(move |c| (r, c))).map(|(r, c)| f64::from(found[[r, c, 1]])).sum::<f64>() / 4.0;
    println!("white {middle:.5}, mirror {:.5} against {power:.5}", mean / RADIANCE);
    // Half of 4096 directions lie around the mirror direction, hundreds of them in the lobe.
    assert!((mean / (RADIANCE * power) - 1.0).abs() < 0.01, "{mean}");
    // As few as 64 do not miss it; the light alone would lie 0.44 apart, five deviations of the lobe.
    let few = cpu::render(&lit(patch.clone(), &sky, 64), &mirror).unwrap();
    let worst = few.iter().map(|&y| (f64::from(y) / (RADIANCE * power) - 1.0).abs());
    let (worst, covered) = worst.filter(|error| *error < 0.99).fold((0.0f64, 0), |(w, n), e| (w.max(e), n + 1));
    println!("64 directions: {worst:.3}");
    assert!(worst < 0.5 && covered > 100, "{worst} {covered}");
}

#[test]
fn an_environment_adds_to_the_lights_and_is_refused_where_it_has_no_place() {
    let mut both = scene(Shape::Sphere, [0.5, 0.5, 1.0], 16);
    let sun = cpu::render(&both, &glossy).unwrap();
    both.environment = Some(environment(&map()));
    both.light_samples = 64;
    let sky = cpu::render(&lit(Shape::Sphere, &map(), 64), &glossy).unwrap();
    let sum = cpu::render(&both, &glossy).unwrap();
    assert!(worst(&sum, &(&sun + &sky)) < 1e-6);
    // As many bytes on one thread.
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    assert_eq!(one.install(|| cpu::render(&both, &glossy).unwrap()), sum);
    both.shape = Shape::Hemisphere;
    assert!(cpu::render(&both, &glossy).unwrap_err().to_string().contains("environment"));
}
