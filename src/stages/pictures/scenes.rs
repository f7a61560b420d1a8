//! Scenes rendered from the tables, and from the reference on a coarser lattice of the same pixels.

use std::path::Path;
use std::time::Instant;

use ndarray::{Array2, Array3};
use serde_json::json;

use super::shading::Shading;
use crate::stages::config::RunConfig;
use crate::stages::results::{SceneError, SceneResult};
use diffraction_brdf::atlas::InputRecord;
use diffraction_brdf::direction::{Vec3, Xyz, angles_deg, normalise};
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::exr_image::{Precision, write_rgb};
use diffraction_brdf::files;
use diffraction_build::accuracy::directions::{Candidates, DRAWN};
use diffraction_build::ground::colour::to_srgb8;
use diffraction_build::ground::metrics;
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::optics::pigment::{Pigment, pigment_xyz};
use diffraction_build::tables::model::TableSet;
use diffraction_build::tables::resolution::lobe_width;
use diffraction_render::render::cpu;
use diffraction_render::render::png_image::{encode_animation, heat_map, side_by_side, write_png};
use diffraction_render::scene::animation;
use diffraction_render::scene::light::environment_count;
use diffraction_render::scene::model::{Animation, Light, Moving, Scene, Shape, exposure_factor};
use diffraction_render::scene::samples::{ShadingSamples, samples_of, samples_per_pixel};
use diffraction_render::scene::turn::Axis;

/// Most pairs of directions that one scene may ask of the reference: sets the lattice of its picture.
pub(crate) const REFERENCE_SAMPLES_MAX: usize = 40_000;

/// Most samples of a light in a pixel of a reference picture: so few that nearly every second pixel of a picture has one. The
/// tables' picture that it is compared with has the same.
const REFERENCE_LIGHT_SAMPLES: usize = 2;

/// Share of the pixels that the difference map's colours span, and the least full scale in CIEDE2000.
const DIFFERENCE_SPAN: f64 = 0.998;
const DIFFERENCE_LEAST: f64 = 0.01;

/// End of the name of an animation's file.
const ANIMATION: &str = ".animated.png";

/// Gap between pictures side by side, and its colour.
const GAP_PX: usize = 4;
const GAP_RGB: [u8; 3] = [128, 128, 128];

/// A scene rendered from the tables, waiting for its reference.
pub struct SceneWork {
    scene: Scene,
    image: Array3<f32>,
    exposure: f32,
    seconds: f64,
    /// Pixels that look up what the tables do not cover.
    uncovered: usize,
    /// Every `stride`-th pixel is compared.
    stride: usize,
    subset: ShadingSamples,
    /// What the tables show of the subset.
    compared: Array3<f32>,
    /// What lies below the structure, which the reference does not know of.
    pigment: Option<Pigment>,
}

/// Renders a scene from the tables and lists the pairs its reference needs.
///
/// # Errors
/// A scene that cannot be rendered.
pub fn render_tables(scene: &Scene, shading: &Shading, pigment: Option<&Pigment>) -> Result<SceneWork> {
    let started = Instant::now();
    let image = shading.render(scene)?;
    let seconds = started.elapsed().as_secs_f64();
    let uncovered = image.rows().into_iter().filter(|xyz| xyz.iter().any(|value| value.is_nan())).count();
    let stride = reference_stride(scene);
    let subset = reference_samples(scene)?;
    let compared = cpu::shade(&subset, &|wi, wo| shading.xyz(wi, wo));
    let exposure = exposure_factor(scene.exposure, &image);
    let pigment = pigment.copied();
    Ok(SceneWork { scene: scene.clone(), image, exposure, seconds, uncovered, stride, subset, compared, pigment })
}

/// The samples of a scene's reference picture.
///
/// # Errors
/// A scene that cannot be rendered.
pub fn reference_samples(scene: &Scene) -> Result<ShadingSamples> {
    samples_of(&with_reference(scene), 0..scene.size_px, reference_stride(scene))
}

/// A scene as it is compared with its reference: lights of a size are seen as a few points. Surroundings keep their samples.
pub(crate) fn with_reference(scene: &Scene) -> Scene {
    let most = if scene.environment.is_some() { usize::MAX } else { REFERENCE_LIGHT_SAMPLES };
    let (light_samples, pixel_samples) = (scene.light_samples.min(most), scene.pixel_samples.min(most));
    Scene { light_samples, pixel_samples, ..scene.clone() }
}

/// The pairs of directions of samples, in order.
pub(crate) fn pairs_of(samples: &ShadingSamples) -> impl Iterator<Item = (Vec3, Vec3)> + '_ {
    samples.wi.iter().zip(&samples.wo).map(|(wi, wo)| (wi.map(f64::from), wo.map(f64::from)))
}

/// Of how many pixels in each direction one has a reference.
pub(crate) fn reference_stride(scene: &Scene) -> usize {
    let per_pixel = samples_per_pixel(&with_reference(scene)).max(1);
    let side = ((REFERENCE_SAMPLES_MAX / per_pixel) as f64).sqrt().max(1.0);
    (scene.size_px as f64 / side).ceil().max(1.0) as usize
}

/// The directions of scenes to draw from, each with a floor of its own: for tables restricted to them.
pub(crate) fn candidates_of(set: &TableSet, scenes: &[SceneWork]) -> Vec<Candidates> {
    let of_scene = |scene: &SceneWork| {
        let step = scene.pair_count().div_ceil(DRAWN).max(1);
        Candidates::of_scene(set, scene.name(), scene.pairs().step_by(step).collect())
    };
    scenes.iter().map(of_scene).collect()
}

impl SceneWork {
    /// The pairs of directions whose BRDF the reference picture needs, in order.
    pub fn pairs(&self) -> impl Iterator<Item = (Vec3, Vec3)> + '_ {
        pairs_of(&self.subset)
    }

    /// The scene's name.
    pub fn name(&self) -> &str {
        &self.scene.name
    }

    /// Number of pairs.
    pub(crate) fn pair_count(&self) -> usize {
        self.subset.wi.len()
    }

    /// Whether the scene moves.
    pub(crate) fn is_animated(&self) -> bool {
        self.scene.animation.is_some()
    }

    /// Renders the animation from the tables, if there is one, at the still's exposure, and writes it into the
    /// specimen's folder.
    ///
    /// # Errors
    /// The disk's; `Error::Limit` for a frame that asks for directions that the tables do not cover.
    pub fn animate(&self, shading: &Shading, folder: &Path) -> Result<()> {
        let Some(animation) = &self.scene.animation else {
            return Ok(());
        };
        let picture = |index: usize| -> Result<Array3<u8>> {
            let scene = animation::frame(&self.scene, animation, index);
            let image = shading.render(&scene)?;
            if image.iter().any(|value| value.is_nan()) {
                return Err(Error::limit(
                    format!(
                        "frame {index} of scene \"{}\" asks for directions that the tables do not cover",
                        scene.name
                    ),
                    "set tables.serve = \"all\"",
                ));
            }
            Ok(to_srgb8(&image, self.exposure))
        };
        let bytes = encode_animation(animation.frames, animation.fps, picture)?;
        files::replace(&folder.join(format!("scenes/{}{ANIMATION}", self.scene.name)), &bytes)
    }

    /// Whether this is one specimen's share of a scene that several appear in.
    pub(crate) fn is_share(&self) -> bool {
        matches!(&self.scene.shape, Shape::Mesh(mesh) if mesh.shown.is_some())
    }

    /// The reference picture, from the BRDF at [`Self::pairs`] and the pigment.
    pub fn expected(&self, reference: &[Xyz]) -> Array3<f32> {
        let Some(pigment) = &self.pigment else { return gather(&self.subset, reference) };
        let shown = |((wi, wo), brdf): ((Vec3, Vec3), &Xyz)| {
            let below = pigment_xyz(pigment, wi, wo);
            std::array::from_fn(|c| brdf[c] + below[c])
        };
        let shown: Vec<Xyz> = self.pairs().zip(reference).map(shown).collect();
        gather(&self.subset, &shown)
    }

    /// Both shares of a scene together.
    pub fn plus(mut self, other: &Self) -> Self {
        self.image += &other.image;
        self.compared += &other.compared;
        self.seconds += other.seconds;
        self.uncovered += other.uncovered;
        self
    }

    /// All shares together as the scene's own picture.
    pub fn whole(self, scene: &Scene) -> Self {
        Self { exposure: exposure_factor(scene.exposure, &self.image), scene: scene.clone(), ..self }
    }

    /// Writes the pictures into the specimen's folder and, where there is a reference, compares them. `reference` holds
    /// the BRDF at [`Self::pairs`]; `prefix` is the specimen's folder relative to the report.
    ///
    /// # Errors
    /// The disk's.
    pub fn finish(&self, reference: Option<&[Xyz]>, folder: &Path, prefix: &str) -> Result<SceneResult> {
        let expected = reference.map(|reference| self.expected(reference));
        self.write(expected.as_ref(), &folder.join("scenes"), &format!("{prefix}/scenes"))
    }

    /// Writes the pictures into a folder and, where there is a reference picture, compares them; `prefix` is that folder
    /// relative to the report.
    ///
    /// # Errors
    /// The disk's.
    pub fn write(&self, expected: Option<&Array3<f32>>, folder: &Path, prefix: &str) -> Result<SceneResult> {
        let name = &self.scene.name;
        let path = |ending: &str| folder.join(format!("{name}{ending}"));
        let attributes = json!({ "kind": "tables", "scene": name, "exposure": f64::from(self.exposure) });
        // Pixels without an answer are black in numbers, and carry the marker's colour where people look.
        let numbers = self.image.mapv(|value| if value.is_nan() { 0.0 } else { value });
        write_rgb(&path(".exr"), &numbers, Precision::Float, &attributes)?;
        write_png(&path(".png"), &to_srgb8(&self.image, self.exposure))?;
        let file = |ending: &str| format!("{prefix}/{name}{ending}");
        let result = SceneResult {
            name: name.clone(),
            shape: shape_name(&self.scene.shape).into(),
            size_px: [self.scene.size_px; 2],
            exposure: f64::from(self.exposure),
            light: light_text(&self.scene),
            seconds: self.seconds,
            error: None,
            uncovered_pixels: self.uncovered,
            table_png: file(".png"),
            side_by_side_png: None,
            difference_png: None,
            difference_scale: None,
            animation_png: self.scene.animation.map(|_| file(ANIMATION)),
            animation: self.scene.animation.as_ref().map(animation_text),
        };
        match expected {
            Some(expected) => self.compare(expected, folder, prefix, result),
            None => Ok(result),
        }
    }

    fn compare(&self, expected: &Array3<f32>, folder: &Path, prefix: &str, result: SceneResult) -> Result<SceneResult> {
        let name = &self.scene.name;
        let ours = &self.compared;
        let white = 1.0 / f64::from(self.exposure);
        let path = |ending: &str| folder.join(format!("{name}{ending}"));
        let difference = ours - expected;
        for (image, ending, kind) in [(expected, ".reference", "reference"), (&difference, ".difference", "difference")]
        {
            let attributes = json!({ "kind": kind, "scene": name, "exposure": f64::from(self.exposure) });
            write_rgb(&path(&format!("{ending}.exr")), image, Precision::Float, &attributes)?;
        }
        let enlarge = |image: &Array3<u8>| enlarged(image, self.stride);
        let pair = [ours, expected].map(|image| enlarge(&to_srgb8(image, self.exposure)));
        write_png(&path(".compare.png"), &side_by_side(&[&pair[0], &pair[1]], GAP_PX, GAP_RGB))?;
        let map = metrics::ciede2000_map(expected, ours, white);
        let full_scale = full_scale(&map);
        write_png(&path(".difference.png"), &enlarge(&heat_map(&map, full_scale as f32)))?;
        let colour = metrics::ciede2000(expected, ours, white);
        let flat = |image: &Array3<f32>| image.iter().map(|&v| f64::from(v)).collect::<Vec<_>>();
        let file = |ending: &str| format!("{prefix}/{name}{ending}");
        Ok(SceneResult {
            error: Some(SceneError {
                pixels: ours.len() / 3,
                relative_l2: metrics::relative_l2(&flat(expected), &flat(ours)),
                ciede2000_mean: colour.mean,
                ciede2000_p95: colour.p95,
                ciede2000_max: colour.max,
            }),
            side_by_side_png: Some(file(".compare.png")),
            difference_png: Some(file(".difference.png")),
            difference_scale: Some(format!("ΔE₀₀ {full_scale}")),
            ..result
        })
    }
}

/// A round number that all but the most extreme of the finite differences keep below.
fn full_scale(map: &Array2<f32>) -> f64 {
    let mut sorted: Vec<f64> = map.iter().map(|value| f64::from(*value)).filter(|value| value.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    let most = sorted.get(((sorted.len() as f64 * DIFFERENCE_SPAN) as usize).min(sorted.len().saturating_sub(1)));
    let most = most.copied().unwrap_or_default().max(DIFFERENCE_LEAST);
    let power = 10f64.powf(most.log10().floor());
    [1.0, 2.0, 5.0, 10.0].map(|digit| digit * power).into_iter().find(|round| *round >= most).unwrap_or(most)
}

/// What a user must know about the pictures of a specimen: an environment's directions further apart than the
/// coherence lobe is wide at half maximum. Only around the mirror direction are there more of them.
pub fn warnings(scenes: &[&Scene], optics: &OpticsConfig) -> Vec<String> {
    let longest_nm = optics.illuminant.reach_nm(optics.wavelength_nm)[1];
    let width = (8.0 * 2f64.ln()).sqrt() * lobe_width(optics.body_coherence().sigma_nm_at(longest_nm), longest_nm);
    let mut warnings = Vec::new();
    for scene in scenes.iter().filter(|scene| scene.environment.is_some()) {
        // Half of them lie around the mirror direction.
        let by_light = environment_count(scene).div_ceil(2);
        let distance = (4.0 * std::f64::consts::PI / by_light as f64).sqrt();
        if distance > width {
            warnings.push(format!(
                "scene \"{}\": away from the mirror direction a pixel sees its environment in {by_light} directions, up to {:.0} \
                 degrees apart where lobes are {:.1} degrees wide: orders of diffraction there are grainy; more \
                 light_samples smooth them",
                scene.name,
                distance.to_degrees(),
                width.to_degrees()
            ));
        }
    }
    warnings
}

/// Where a scene's light comes from, in words: polar angle and azimuth of each light, and its width.
fn light_text(scene: &Scene) -> String {
    let from = match scene.shape {
        Shape::Screen { incidence_deg, .. } => return format!("beam {incidence_deg}° from the normal"),
        Shape::Hemisphere => "the normal",
        _ => "the viewing axis",
    };
    let one = |light: &Light| {
        let [theta, phi] = angles_deg(normalise(light.direction)).map(f64::round);
        let azimuth = if theta == 0.0 { String::new() } else { format!(" at azimuth {phi}°") };
        let width = match light.angular_diameter_deg {
            0.0 => "a point".to_string(),
            width => format!("{width}° wide"),
        };
        format!("light {theta}° from {from}{azimuth}, {width}")
    };
    let lights = match &scene.shape {
        Shape::Hemisphere => &scene.lights[..scene.lights.len().min(1)],
        _ => &scene.lights[..],
    };
    let all = lights.iter().map(one).chain(scene.environment.is_some().then(|| "light from all around".to_string()));
    all.collect::<Vec<_>>().join("; ")
}

/// How an animation goes, in words.
fn animation_text(animation: &Animation) -> String {
    let what = match animation.kind {
        Moving::Turntable => "the object turns",
        Moving::Light => "the light turns",
    };
    let axis = match animation.axis {
        Axis::Vertical => "the vertical",
        Axis::Viewing => "the viewing axis",
    };
    let how = if animation.degrees.abs() >= 360.0 { "once round" } else { "to and fro" };
    format!("{what} {how} by {}° about {axis}, {} frames", animation.degrees, animation.frames)
}

/// Files that the scenes of a run use, each once.
pub fn inputs(config: &RunConfig) -> Vec<InputRecord> {
    let mut inputs: Vec<InputRecord> = Vec::new();
    for environment in config.scenes.iter().filter_map(|scene| scene.environment.as_ref()) {
        let path = config.relative_name(&environment.file);
        if inputs.iter().all(|input| input.path != path) {
            inputs.push(InputRecord { path, sha256: environment.sha256.clone() });
        }
    }
    inputs
}

/// The word the manifest uses for a shape.
pub(crate) fn shape_name(shape: &Shape) -> &'static str {
    match shape {
        Shape::Hemisphere => "hemisphere",
        Shape::Sphere => "sphere",
        Shape::Snake => "snake",
        Shape::Mesh(_) => "mesh",
        Shape::Patch { .. } => "patch",
        Shape::Screen { .. } => "screen",
    }
}

/// XYZ image from the BRDF at each sample: what `render::cpu::shade` does with a function.
fn gather(samples: &ShadingSamples, brdf: &[Xyz]) -> Array3<f32> {
    Array3::from_shape_fn((samples.rows, samples.columns, 3), |(row, column, channel)| {
        let range = diffraction_render::scene::samples::pixel_range(samples, row, column);
        range.map(|index| f64::from(samples.weight[index]) * brdf[index][channel]).sum::<f64>() as f32
    })
}

/// Each pixel as a square of `factor` pixels.
fn enlarged(image: &Array3<u8>, factor: usize) -> Array3<u8> {
    let (rows, columns, _) = image.dim();
    Array3::from_shape_fn((rows * factor, columns * factor, 3), |(row, column, channel)| {
        image[[row / factor, column / factor, channel]]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_map_of_differences_uses_its_colours() {
        let scale = |most: f32| {
            full_scale(&Array2::from_shape_fn((40, 50), |(row, column)| most * (row + column) as f32 / 88.0))
        };
        for (most, round) in [(0.43, 0.5), (1.7, 2.0), (0.0001, DIFFERENCE_LEAST), (7.0, 10.0)] {
            assert!((scale(most) - round).abs() < 1e-9, "{most}: {}", scale(most));
        }
        let mut speck = Array2::from_elem((50, 50), 0.09f32);
        (speck[[0, 0]], speck[[1, 1]]) = (30.0, f32::NAN);
        assert!((full_scale(&speck) - 0.1).abs() < 1e-6, "one pixel does not darken the rest");
    }

    #[test]
    fn nearly_every_second_pixel_of_a_picture_has_a_reference() {
        let light = Light { direction: [0.3, 0.2, 1.0], angular_diameter_deg: 0.53, irradiance: 1.0 };
        for (size_px, stride) in [(64, 1), (256, 2), (512, 4)] {
            let scene = Scene { light_samples: 16, ..Scene::still("a", Shape::Sphere, vec![light], size_px) };
            assert_eq!(reference_stride(&scene), stride);
            assert_eq!(reference_samples(&scene).unwrap().rows, size_px.div_ceil(stride));
        }
    }
}
