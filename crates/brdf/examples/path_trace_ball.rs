//! A ball with a specimen's surface under a sky with a sun, path-traced: directions are drawn from the BRDF and from the
//! sun, and the two weighted by the power heuristic (Veach 1997, section 9.2.4).
//!
//!     cargo run --release -p diffraction-brdf --example path_trace_ball -- out/atlas/bundled sunbeam_snake_like ball.ppm

use std::error::Error;
use std::f64::consts::TAU;

use diffraction_brdf::direction::{dot, normalise};
use diffraction_brdf::{Atlas, Brdf, Vec3, Xyz};

const SIZE: usize = 320;
const SAMPLES: usize = 64;
/// Towards the sun; the camera looks along -z. Cosine of its radius of 3 degrees, and its radiance.
const SUN: Vec3 = [0.48, 0.64, 0.6];
const SUN_COS: f64 = 0.998_63;
const SUN_RADIANCE: f64 = 150.0;

/// Luminance of what is seen in a direction: a sky that is brighter above, a dim ground, and the sun.
fn sky(direction: Vec3) -> f64 {
    let sun = if dot(direction, SUN) > SUN_COS { SUN_RADIANCE } else { 0.0 };
    sun + if direction[1] > 0.0 { 0.3 + 0.5 * direction[1] } else { 0.1 }
}

/// A vector in a frame of three unit vectors, and back.
fn to_world(frame: &[Vec3; 3], v: Vec3) -> Vec3 {
    [0, 1, 2].map(|k| v[0] * frame[0][k] + v[1] * frame[1][k] + v[2] * frame[2][k])
}
fn to_local(frame: &[Vec3; 3], v: Vec3) -> Vec3 {
    frame.map(|axis| dot(axis, v))
}

fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Unit vectors x, y, z: z along the normal, x across `up`.
fn frame(normal: Vec3, up: Vec3) -> [Vec3; 3] {
    let x = normalise(cross(up, normal));
    [x, cross(normal, x), normal]
}

/// One estimate of the radiance that leaves the surface towards the viewer: a sample of the BRDF and one of the sun. The ball
/// is convex, so that every path ends in the sky after one reflection.
fn radiance(brdf: &Brdf, surface: &[Vec3; 3], wo: Vec3, random: &mut fastrand::Rng) -> Xyz {
    let sun_pdf = 1.0 / (TAU * (1.0 - SUN_COS));
    let heuristic = |this: f64, other: f64| this * this / (this * this + other * other);
    let mut sum = [0.0; 3];

    if let Some(sample) = brdf.sample(wo, [random.f64(), random.f64(), random.f64()]) {
        let direction = to_world(surface, sample.wi);
        let sun = dot(direction, SUN) > SUN_COS;
        let share = if sun { heuristic(sample.pdf, sun_pdf) } else { 1.0 };
        sum = sample.weight.map(|weight| weight * share * sky(direction));
    }

    let cos = 1.0 - random.f64() * (1.0 - SUN_COS);
    let (sin, phi) = ((1.0 - cos * cos).sqrt(), TAU * random.f64());
    let direction = to_world(&frame(SUN, [0.0, 1.0, 0.0]), [sin * phi.cos(), sin * phi.sin(), cos]);
    let wi = to_local(surface, direction);
    if wi[2] > 0.0 && brdf.answers(wi, wo) {
        let factor = heuristic(sun_pdf, brdf.pdf(wi, wo)) / sun_pdf * wi[2] * sky(direction);
        sum.iter_mut().zip(brdf.eval(wi, wo)).for_each(|(sum, value)| *sum += value * factor);
    }
    sum
}

/// Mean over the samples of one pixel.
fn pixel(brdf: &Brdf, x: usize, y: usize) -> Xyz {
    let mut random = fastrand::Rng::with_seed((y * SIZE + x) as u64);
    let mut sum = [0.0; 3];
    for _ in 0..SAMPLES {
        let at = |pixel: usize, random: f64| 2.2 * (pixel as f64 + random) / SIZE as f64 - 1.1;
        let (px, py) = (at(x, random.f64()), -at(y, random.f64()));
        let z2 = 1.0 - px * px - py * py;
        let seen = if z2 > 0.0 {
            // The structure's x axis runs along the ball's circles of latitude.
            let surface = frame([px, py, z2.sqrt()], [0.0, 1.0, 0.0]);
            radiance(brdf, &surface, to_local(&surface, [0.0, 0.0, 1.0]), &mut random)
        } else {
            [0.95 * 0.15, 0.15, 1.09 * 0.15]
        };
        sum.iter_mut().zip(seen).for_each(|(sum, value)| *sum += value / SAMPLES as f64);
    }
    sum
}

/// XYZ to sRGB bytes, clipped.
fn srgb([x, y, z]: Xyz) -> [u8; 3] {
    let linear = [
        3.2404542 * x - 1.5371385 * y - 0.4985314 * z,
        -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
        0.0556434 * x - 0.2040259 * y + 1.0572252 * z,
    ];
    let encode = |c: f64| if c <= 0.0031308 { 12.92 * c } else { 1.055 * c.powf(1.0 / 2.4) - 0.055 };
    linear.map(|c| (255.0 * encode(c.clamp(0.0, 1.0))).round() as u8)
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [atlas, specimen, picture] = arguments.as_slice() else {
        return Err("call it with an atlas, a specimen and the picture to write".into());
    };
    let brdf = Atlas::open(atlas)?.brdf(specimen)?;
    let pixels = (0..SIZE * SIZE).flat_map(|n| srgb(pixel(&brdf, n % SIZE, n / SIZE)));
    let mut bytes = format!("P6\n{SIZE} {SIZE}\n255\n").into_bytes();
    bytes.extend(pixels);
    Ok(std::fs::write(picture, bytes)?)
}
