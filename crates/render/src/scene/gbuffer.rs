//! The geometry pass of an interactive renderer: surfaces and shadows pixel by pixel, for lights to be shaded later.
//!
//! A pixel has one surface point per position that its light samples look through: one in all where
//! `pixel_samples` is 1. Vectors are in the world.

use rayon::prelude::*;

use diffraction_brdf::direction::{dot, normalise};
use diffraction_brdf::error::{Error, Result};

use super::frame::{cross, to_local};
use super::hit::LitHit;
use super::light::{LightSample, light_samples};
use super::model::{Light, Scene, check};
use super::samples::{pixel_centre, pixel_width, position};
use super::surface::{self, Surface, surface};

/// Most surface points: 3 GB.
pub const POINTS_MAX: usize = 1 << 26;

/// Surfaces, lights and shadows of a picture.
#[derive(Debug, Clone, PartialEq)]
pub struct GBuffer {
    /// Name of the scene.
    pub scene: String,
    /// Pixels along each side.
    pub size_px: usize,
    /// Positions within a pixel: surface points are counted `[layer][row][column]`.
    pub layers: usize,
    /// Light samples.
    pub lights: Vec<LightSample>,
    /// The layer that each light sample looks at.
    pub layer_of_light: Vec<u32>,
    /// Angular radius in radians of the disc that each stands for; all 0 where lights are sampled.
    pub radius_of_light: Vec<f32>,
    /// Direction of the structure's x axis, and 1 where its y axis is `normal × tangent`, -1 where it is mirrored; all 0
    /// where there is no surface.
    pub tangent: Vec<[f32; 4]>,
    /// Outward normal.
    pub normal: Vec<[f32; 3]>,
    /// Unit vector to the viewer.
    pub to_viewer: Vec<[f32; 3]>,
    /// Words that hold a pixel's shadows.
    pub lit_words: usize,
    /// Bit `sample % 32` of word `sample / 32` is set where the light sample stands above the surface and nothing shades
    /// it, `[row][column][word]`.
    pub lit: Vec<u32>,
}

/// Gathers the geometry of a scene.
///
/// # Errors
/// `Error::Call` for a scene that cannot be rendered, has an environment, or whose specimen no camera sees (hemisphere,
/// screen);
/// `Error::Limit` beyond [`POINTS_MAX`].
pub fn gbuffer(scene: &Scene) -> Result<GBuffer> {
    check(scene)?;
    let lights = light_samples(scene);
    let points = vec![0.0; lights.len()];
    gathered(scene, lights, points)
}

/// The same with one look-up over its disc for each light, through the pixels' centres.
///
/// # Errors
/// As [`gbuffer`].
pub fn filtered_gbuffer(scene: &Scene) -> Result<GBuffer> {
    check(scene)?;
    let whole = |light: &Light| LightSample {
        direction: normalise(light.direction),
        irradiance: light.irradiance,
        pixel_offset: [0.0, 0.0],
    };
    let radius = |light: &Light| (0.5 * light.angular_diameter_deg).to_radians() as f32;
    gathered(scene, scene.lights.iter().map(whole).collect(), scene.lights.iter().map(radius).collect())
}

fn gathered(scene: &Scene, lights: Vec<LightSample>, radius_of_light: Vec<f32>) -> Result<GBuffer> {
    let Some(surface) = surface(scene) else {
        return Err(Error::Call(format!(
            "scene \"{}\": no camera sees the specimen itself; a frame takes \"sphere\", \"snake\", \"patch\" or a mesh",
            scene.name
        )));
    };
    if scene.environment.is_some() {
        return Err(Error::Call(format!(
            "scene \"{}\": frames are drawn under lights; samples of an environment differ from pixel to pixel",
            scene.name
        )));
    }
    let (offsets, layer_of_light) = layers(&lights);
    let side = scene.size_px;
    if offsets.len() * side * side > POINTS_MAX {
        return Err(Error::limit(
            format!(
                "scene \"{}\" has {} surface points in each of its {side} x {side} pixels",
                scene.name,
                offsets.len()
            ),
            "lower its size_px or pixel_samples",
        ));
    }
    let lit_words = lights.len().div_ceil(32);
    let rows: Vec<Row> = (0..side)
        .into_par_iter()
        .map(|row| gather_row(scene, &surface, &lights, &offsets, &layer_of_light, row))
        .collect();
    let points = offsets.len() * side * side;
    let mut out = GBuffer {
        scene: scene.name.clone(),
        size_px: side,
        layers: offsets.len(),
        layer_of_light,
        radius_of_light,
        tangent: Vec::with_capacity(points),
        normal: Vec::with_capacity(points),
        to_viewer: Vec::with_capacity(points),
        lit_words,
        lit: rows.iter().flat_map(|row| row.lit.iter().copied()).collect(),
        lights,
    };
    for layer in 0..out.layers {
        for row in &rows {
            let points = &row.points[layer * side..(layer + 1) * side];
            out.tangent.extend(points.iter().map(|point| point.tangent));
            out.normal.extend(points.iter().map(|point| point.normal));
            out.to_viewer.extend(points.iter().map(|point| point.to_viewer));
        }
    }
    Ok(out)
}

impl GBuffer {
    /// Whether a light stands for its disc.
    pub fn is_filtered(&self) -> bool {
        self.radius_of_light.iter().any(|radius| *radius > 0.0)
    }

    /// Pairs of directions that a frame shades.
    pub fn evaluations(&self) -> u64 {
        self.lit.iter().map(|word| u64::from(word.count_ones())).sum()
    }
}

/// Positions that light samples look through, and which of them each does.
fn layers(lights: &[LightSample]) -> (Vec<[f64; 2]>, Vec<u32>) {
    let mut offsets: Vec<[f64; 2]> = Vec::new();
    let layer_of_light = lights
        .iter()
        .map(|light| {
            let known = offsets.iter().position(|offset| *offset == light.pixel_offset);
            known.unwrap_or_else(|| {
                offsets.push(light.pixel_offset);
                offsets.len() - 1
            }) as u32
        })
        .collect();
    (offsets, layer_of_light)
}

/// A point as it is stored.
#[derive(Debug, Clone, Copy, Default)]
struct Point {
    tangent: [f32; 4],
    normal: [f32; 3],
    to_viewer: [f32; 3],
}

/// Points of a row, layer by layer, and its shadows.
struct Row {
    points: Vec<Point>,
    lit: Vec<u32>,
}

fn gather_row(
    scene: &Scene,
    surface: &Surface,
    lights: &[LightSample],
    offsets: &[[f64; 2]],
    layer_of_light: &[u32],
    row: usize,
) -> Row {
    let (side, words, width) = (scene.size_px, lights.len().div_ceil(32), pixel_width(scene));
    let mut out = Row { points: vec![Point::default(); offsets.len() * side], lit: vec![0; side * words] };
    for column in 0..side {
        let centre = pixel_centre(scene, row, column);
        let hits: Vec<Option<LitHit>> =
            offsets.iter().map(|offset| surface::hit(surface, position(centre, *offset, width))).collect();
        for (layer, hit) in hits.iter().enumerate() {
            out.points[layer * side + column] = hit.map_or_else(Point::default, |hit| stored(&hit));
        }
        for (index, light) in lights.iter().enumerate() {
            let Some(LitHit { hit, lifted }) = hits[layer_of_light[index] as usize] else { continue };
            let above = [light.direction, hit.to_viewer].iter().all(|&v| to_local(&hit.frame, v)[2] > 0.0);
            if above && surface::is_lit(surface, lifted, light.direction) {
                out.lit[column * words + index / 32] |= 1 << (index % 32);
            }
        }
    }
    out
}

fn stored(LitHit { hit, .. }: &LitHit) -> Point {
    let [x, y, z] = hit.frame.tangent.map(|c| c as f32);
    let upright = dot(cross(hit.frame.normal, hit.frame.tangent), hit.frame.bitangent) > 0.0;
    Point {
        tangent: [x, y, z, if upright { 1.0 } else { -1.0 }],
        normal: hit.frame.normal.map(|c| c as f32),
        to_viewer: hit.to_viewer.map(|c| c as f32),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::model::Shape;
    use crate::scene::samples::{pixel_range, samples};
    use diffraction_brdf::direction::Vec3;

    /// The samples of a pixel as a shader makes them.
    fn shaded(buffer: &GBuffer, row: usize, column: usize) -> Vec<(Vec3, Vec3, f64)> {
        let pixel = row * buffer.size_px + column;
        let mut out = Vec::new();
        for (index, light) in buffer.lights.iter().enumerate() {
            if buffer.lit[pixel * buffer.lit_words + index / 32] >> (index % 32) & 1 == 0 {
                continue;
            }
            let point = buffer.layer_of_light[index] as usize * buffer.size_px * buffer.size_px + pixel;
            let [x, y, z, hand] = buffer.tangent[point].map(f64::from);
            let normal = buffer.normal[point].map(f64::from);
            let bitangent = cross(normal, [x, y, z]).map(|c| hand * c);
            let local = |v: Vec3| [dot([x, y, z], v), dot(bitangent, v), dot(normal, v)];
            let wi = local(light.direction);
            out.push((wi, local(buffer.to_viewer[point].map(f64::from)), light.irradiance * wi[2]));
        }
        out
    }

    /// Largest difference from the pictures' own samples; infinite where a pixel has more or fewer of them.
    fn difference(scene: &Scene, buffer: &GBuffer) -> f64 {
        let samples = samples(scene).unwrap();
        let mut worst = 0.0f64;
        for (row, column) in (0..scene.size_px).flat_map(|row| (0..scene.size_px).map(move |column| (row, column))) {
            let (found, range) = (shaded(buffer, row, column), pixel_range(&samples, row, column));
            if found.len() != range.len() {
                return f64::INFINITY;
            }
            for (index, (wi, wo, weight)) in range.zip(found) {
                let apart =
                    |a: Vec3, b: [f32; 3]| a.iter().zip(b).map(|(a, b)| (a - f64::from(b)).abs()).fold(0.0, f64::max);
                worst = worst
                    .max(apart(wi, samples.wi[index]))
                    .max(apart(wo, samples.wo[index]))
                    .max((weight - f64::from(samples.weight[index])).abs());
            }
        }
        worst
    }

    #[test]
    fn lights_on_the_stored_surfaces_are_the_samples_of_the_picture() {
        let patch = Shape::Patch { width_mm: 20.0, distance_mm: 60.0, tilt_deg: 30.0, turn_deg: 15.0 };
        for shape in [Shape::Sphere, Shape::Snake, patch] {
            for (light_samples, pixel_samples) in [(40, 1), (3, 2)] {
                let disc = Light { angular_diameter_deg: 20.0, ..Light::point([-0.7, 0.5, 0.6]) };
                let lights = vec![Light::point([0.5, 0.3, 0.4]), disc];
                let still = Scene::still("s", shape.clone(), lights, 40);
                let scene = Scene { light_samples, pixel_samples, ..still };
                let mut buffer = gbuffer(&scene).unwrap();
                assert_eq!(buffer.evaluations() as usize, samples(&scene).unwrap().weight.len());
                // Components rounded to 32 bits (2^-25), the sums of their products likewise.
                assert!(difference(&scene, &buffer) < 3e-7);
                // Mirrored, the structure lies elsewhere; without a shadow, there is a sample more.
                buffer.tangent.iter_mut().for_each(|tangent| tangent[3] = -tangent[3]);
                assert!(difference(&scene, &buffer) > 0.1);
                buffer.lit[20 * 40 * buffer.lit_words] ^= 1;
                assert!(difference(&scene, &buffer) == f64::INFINITY);
            }
        }
    }

    #[test]
    fn what_no_camera_sees_is_refused() {
        let scene = Scene::still("map", Shape::Hemisphere, vec![Light::point([0.0, 0.0, 1.0])], 16);
        let error = gbuffer(&scene).unwrap_err().to_string();
        assert!(error.contains("\"map\"") && error.contains("\"snake\""), "{error}");
        let scene = Scene { shape: Shape::Sphere, size_px: 8192, pixel_samples: 4, ..scene };
        assert!(gbuffer(&scene).unwrap_err().to_string().contains("size_px"));
    }
}
