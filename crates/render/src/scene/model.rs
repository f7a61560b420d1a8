//! Scene description: what is shown, under which lights, how large, how exposed.

use ndarray::Array3;
use serde::{Deserialize, Serialize};

use diffraction_brdf::direction::{Vec3, dot};
use diffraction_brdf::error::{Error, Result};
use diffraction_build::ground::colour::auto_exposure;

use super::environment::{Environment, scalar_irradiance};
use super::limits::{
    ANIMATION_PIXELS_MAX, DIAMETER_MAX_DEG, EV_MAX, FPS_MAX, FRAMES_MAX, IRRADIANCE_MAX, LENGTH_MM, LIGHTS_MAX,
    ROW_SAMPLES_MAX, SAMPLES_MAX, SIZE_MAX_PX, TILT_MAX_DEG, TURN_MAX_DEG,
};
use super::mesh::{self, MeshShape};
use super::turn::{Axis, Turn};

/// A distant light, seen as a uniform disc.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Light {
    /// Direction to the light's centre in the world; any length but zero.
    pub direction: Vec3,
    /// Full angle of the disc; 0 for a point, 0.53 for the sun.
    #[serde(default)]
    pub angular_diameter_deg: f64,
    /// Relative luminous irradiance on a surface facing the light.
    #[serde(default = "one")]
    pub irradiance: f64,
}

impl Light {
    /// A point of unit irradiance.
    pub fn point(direction: Vec3) -> Self {
        Self { direction, angular_diameter_deg: 0.0, irradiance: 1.0 }
    }
}

/// What the picture shows.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase", deny_unknown_fields)]
pub enum Shape {
    /// Map of the BRDF itself in 1/sr (no cosine, no irradiance): the light direction is that of the
    /// first light, the pixel at `(x, y)` in the unit disc is the viewing direction with those direction
    /// cosines.
    Hemisphere,
    /// A sphere seen from afar; the structure's x axis runs along the circles of latitude.
    Sphere,
    /// A coiled snake with scales; the structure's x axis runs along the body, from head to tail, on every scale.
    Snake,
    /// The triangles of a file; the structure's x axis runs along the texture coordinate u.
    Mesh(MeshShape),
    /// A flat square seen in perspective by a camera in front of its centre.
    Patch {
        /// Side of the square.
        width_mm: f64,
        /// From the camera to the square's centre; more than its width.
        distance_mm: f64,
        /// Leans the upper edge away from the camera, about the picture's horizontal.
        #[serde(default)]
        tilt_deg: f64,
        /// Turns the structure within the square, counter-clockwise as seen from its front.
        #[serde(default)]
        turn_deg: f64,
    },
    /// Irradiance on a square screen: a collimated beam passes at a right angle through a hole in the
    /// screen's centre and meets the flat sample behind it, which sends light back to the screen.
    Screen {
        /// From the screen to the sample's centre.
        distance_mm: f64,
        /// Side of the screen, which fills the picture.
        width_mm: f64,
        /// Diameter of the beam.
        beam_diameter_mm: f64,
        /// Diameter of the hole, dark in the picture; as wide as the beam unless given.
        #[serde(default)]
        hole_diameter_mm: Option<f64>,
        /// Angle of incidence: turns the sample's normal about the vertical towards +x, so the mirror
        /// direction meets the screen at `x = distance tan(2 incidence)`.
        #[serde(default)]
        incidence_deg: f64,
    },
}

/// How scene values become display values.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Exposure {
    /// Brings the 99.5th percentile of the lit pixels' luminance to white.
    #[default]
    Auto,
    /// Exposure value: 0 shows luminance `1/π`, a white Lambertian surface facing a light of unit
    /// irradiance, as white; +1 doubles the brightness.
    Ev(f64),
}

/// What a pixel is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum LookUps {
    /// Means over lights' discs and pixels, one look-up each where that keeps the tolerance: see `filtered`.
    #[default]
    Filtered,
    /// Values at `light_samples` and `pixel_samples` points.
    Points,
}

/// What moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Moving {
    /// The object with its structure; camera and lights stay.
    Turntable,
    /// The lights and the environment; camera and object stay.
    Light,
}

/// An animation of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Animation {
    /// What moves.
    pub kind: Moving,
    /// What it turns about.
    pub axis: Axis,
    /// Number of frames.
    pub frames: usize,
    /// 360 (or -360) goes round steadily; less swings to and fro like a pendulum, half of it to either side.
    pub degrees: f64,
    /// Frames per second.
    pub fps: u16,
    /// Side of the square picture.
    pub size_px: usize,
}

/// One picture.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// Name of the picture's files.
    pub name: String,
    /// What is shown.
    pub shape: Shape,
    /// The lights. `Hemisphere` and `Screen` use the first one only; the screen's beam takes its
    /// irradiance and divergence from it (1 and 0 where there is none) and ignores its direction.
    #[serde(default)]
    pub lights: Vec<Light>,
    /// Light from all around, besides the lights; not for `Hemisphere` and `Screen`.
    #[serde(default)]
    pub environment: Option<Environment>,
    /// Turn of the object, besides what its shape says: of `Patch` about either axis, of `Sphere` and `Snake` about
    /// the viewing axis.
    #[serde(default)]
    pub turn: Turn,
    /// Frames to show besides the picture itself.
    #[serde(default)]
    pub animation: Option<Animation>,
    /// Side of the square picture.
    pub size_px: usize,
    /// How values become display values.
    #[serde(default)]
    pub exposure: Exposure,
    /// The specimen shown; every one where absent.
    #[serde(default)]
    pub specimen: Option<String>,
    /// Relative error of the luminance that tables made for this picture may have for each of their causes; that of all
    /// tables where absent.
    #[serde(default)]
    pub tolerance: Option<f64>,
    /// What a pixel is made of.
    #[serde(default)]
    pub look_ups: LookUps,
    /// Samples of each light that has an angular diameter, and of the screen's beam; of filtered look-ups, of each light that is too
    /// large for one.
    #[serde(default = "default_light_samples")]
    pub light_samples: usize,
    /// Positions within each pixel, against jagged edges and lobes narrower than a pixel; 1 is the
    /// pixel's centre. Light and pixel are sampled together: the larger count is used for both. Filtered look-ups have
    /// the mean over the pixel without them.
    #[serde(default = "one_sample")]
    pub pixel_samples: usize,
}

impl Scene {
    /// A still of every specimen, sampled once per light and pixel, exposed automatically, without surroundings. What
    /// else a scene needs goes before it: `Scene { light_samples: 16, ..Scene::still(..) }`.
    pub fn still(name: &str, shape: Shape, lights: Vec<Light>, size_px: usize) -> Self {
        Self {
            name: name.into(),
            shape,
            lights,
            environment: None,
            turn: Turn::default(),
            animation: None,
            size_px,
            exposure: Exposure::Auto,
            specimen: None,
            tolerance: None,
            look_ups: LookUps::default(),
            light_samples: 1,
            pixel_samples: 1,
        }
    }
}

/// The scene in which the specimen of this index alone is bright: its share of the picture. Shares add up to it.
///
/// # Panics
/// For a scene without materials.
pub fn share_of(scene: &Scene, index: usize) -> Scene {
    let mut scene = scene.clone();
    match &mut scene.shape {
        Shape::Mesh(mesh) if index < mesh.specimens.len() => mesh.shown = Some(index),
        _ => panic!("scene \"{}\" has no specimen of index {index}", scene.name),
    }
    scene
}

fn one() -> f64 {
    1.0
}

fn one_sample() -> usize {
    1
}

fn default_light_samples() -> usize {
    16
}

/// The factor that brings scene values to display values, white being 1; apply the same number to
/// pictures that are to be compared.
pub fn exposure_factor(exposure: Exposure, image: &Array3<f32>) -> f32 {
    match exposure {
        Exposure::Auto => auto_exposure(image),
        Exposure::Ev(ev) => (std::f64::consts::PI * ev.exp2()) as f32,
    }
}

/// Checks that a scene can be rendered. The message names the scene and the key.
pub fn check(scene: &Scene) -> Result<()> {
    check_counts(scene)
        .and_then(|()| check_lights(scene))
        .and_then(|()| check_shape(&scene.shape))
        .and_then(|()| check_turns(scene))
        .and_then(|()| check_row(scene))
        .map_err(|message| Error::Call(format!("scene \"{}\": {message}", scene.name)))
}

type Checked = std::result::Result<(), String>;

fn check_counts(scene: &Scene) -> Checked {
    counted("size_px", scene.size_px, SIZE_MAX_PX)?;
    counted("light_samples", scene.light_samples, SAMPLES_MAX)?;
    counted("pixel_samples", scene.pixel_samples, SAMPLES_MAX)?;
    if let Exposure::Ev(ev) = scene.exposure {
        within("exposure ev", ev, -EV_MAX, EV_MAX)?;
    }
    Ok(())
}

fn check_lights(scene: &Scene) -> Checked {
    let screen = matches!(scene.shape, Shape::Screen { .. });
    if scene.environment.is_some() && (screen || scene.shape == Shape::Hemisphere) {
        return Err("environment: this shape has one light and no surroundings".into());
    }
    if scene.environment.as_ref().is_some_and(|environment| scalar_irradiance(environment) <= 0.0) {
        return Err("environment: its image has not been read".into());
    }
    if scene.lights.is_empty() && scene.environment.is_none() && !screen {
        return Err("light: at least one is needed, as [{ direction = [x, y, z] }]".into());
    }
    if scene.lights.len() > LIGHTS_MAX {
        return Err(format!("light: {} are more than {LIGHTS_MAX}", scene.lights.len()));
    }
    for light in &scene.lights {
        let length_squared = dot(light.direction, light.direction);
        if !length_squared.is_normal() {
            return Err(format!("light direction = {:?} must be finite and not the zero vector", light.direction));
        }
        within("light angular_diameter_deg", light.angular_diameter_deg, 0.0, DIAMETER_MAX_DEG)?;
        within("light irradiance", light.irradiance, 0.0, IRRADIANCE_MAX)?;
    }
    if scene.shape == Shape::Hemisphere && scene.lights[0].direction[2] <= 0.0 {
        return Err(format!(
            "light direction = {:?} must have a positive z for shape = \"hemisphere\": \
             the surface faces +z",
            scene.lights[0].direction
        ));
    }
    Ok(())
}

fn check_shape(shape: &Shape) -> Checked {
    match *shape {
        Shape::Hemisphere | Shape::Sphere | Shape::Snake => Ok(()),
        Shape::Mesh(ref shape) => mesh::check(shape),
        Shape::Patch { width_mm, distance_mm, tilt_deg, turn_deg } => {
            length("width_mm", width_mm)?;
            length("distance_mm", distance_mm)?;
            within("tilt_deg", tilt_deg, -TILT_MAX_DEG, TILT_MAX_DEG)?;
            within("turn_deg", turn_deg, -TURN_MAX_DEG, TURN_MAX_DEG)?;
            if distance_mm <= width_mm {
                return Err(format!(
                    "distance_mm = {distance_mm} must exceed width_mm = {width_mm}, \
                     or the tilted square could reach the camera"
                ));
            }
            Ok(())
        }
        Shape::Screen { distance_mm, width_mm, beam_diameter_mm, hole_diameter_mm, incidence_deg } => {
            length("distance_mm", distance_mm)?;
            length("width_mm", width_mm)?;
            length("beam_diameter_mm", beam_diameter_mm)?;
            within("hole_diameter_mm", hole_diameter_mm.unwrap_or(0.0), 0.0, LENGTH_MM[1])?;
            within("incidence_deg", incidence_deg, -TILT_MAX_DEG, TILT_MAX_DEG)?;
            // The spot is stretched along the tilted sample, whose rim must stay behind the screen.
            let reach_mm = 0.5 * beam_diameter_mm * incidence_deg.to_radians().tan().abs();
            if reach_mm >= distance_mm {
                return Err(format!(
                    "beam_diameter_mm = {beam_diameter_mm} at incidence_deg = {incidence_deg} \
                     would light the sample up to the screen, distance_mm = {distance_mm} away"
                ));
            }
            Ok(())
        }
    }
}

fn check_turns(scene: &Scene) -> Checked {
    within("turn", scene.turn.angle_deg, -TURN_MAX_DEG, TURN_MAX_DEG)?;
    if scene.turn.angle_deg != 0.0 {
        check_turn(&scene.shape, Moving::Turntable, scene.turn.axis)?;
    }
    let Some(animation) = &scene.animation else { return Ok(()) };
    check_turn(&scene.shape, animation.kind, animation.axis)?;
    within("animate degrees", animation.degrees, -TURN_MAX_DEG, TURN_MAX_DEG)?;
    counted("animate frames", animation.frames, FRAMES_MAX)?;
    counted("animate size_px", animation.size_px, SIZE_MAX_PX)?;
    counted("animate fps", animation.fps.into(), FPS_MAX)?;
    if animation.frames.saturating_mul(animation.size_px.saturating_mul(animation.size_px)) > ANIMATION_PIXELS_MAX {
        return Err(format!(
            "animate: {} frames of {} x {} pixels are more than {ANIMATION_PIXELS_MAX} pixels together",
            animation.frames, animation.size_px, animation.size_px
        ));
    }
    Ok(())
}

/// Whether a shape can be shown with itself or its lights turned about an axis.
///
/// # Errors
/// Why it cannot, and what can, in words.
pub fn check_turn(shape: &Shape, kind: Moving, axis: Axis) -> Checked {
    match (shape, kind, axis) {
        (Shape::Screen { .. }, ..) => Err("a screen's beam and sample do not move".into()),
        (Shape::Hemisphere, Moving::Turntable, _) => {
            Err("a hemisphere has no object to turn; turn its light about the viewing axis".into())
        }
        (Shape::Hemisphere, Moving::Light, Axis::Vertical) => {
            Err("about the vertical the light would set; turn it about the viewing axis, the surface's normal".into())
        }
        (Shape::Sphere, Moving::Turntable, Axis::Vertical) => Err("a ball whose structure follows circles of \
            latitude looks the same after every turn about the vertical; use the viewing axis"
            .into()),
        (Shape::Snake, Moving::Turntable, Axis::Vertical) => {
            Err("a snake is seen from above only; use the viewing axis".into())
        }
        (Shape::Sphere | Shape::Snake, Moving::Turntable, Axis::Viewing)
        | (Shape::Patch { .. } | Shape::Mesh(_), Moving::Turntable, _)
        | (_, Moving::Light, _) => Ok(()),
    }
}

fn check_row(scene: &Scene) -> Checked {
    let lights = scene.lights.len() + usize::from(scene.environment.is_some());
    let size_px = scene.animation.map_or(0, |animation| animation.size_px).max(scene.size_px);
    check_row_samples(size_px, [scene.light_samples, scene.pixel_samples], lights)
}

/// Whether a row of a picture, which is rendered at a time, takes no more than [`ROW_SAMPLES_MAX`] samples, with
/// `[light_samples, pixel_samples]`; an environment counts as a light.
///
/// # Errors
/// How many it takes and what to lower, in words.
pub fn check_row_samples(size_px: usize, samples: [usize; 2], lights: usize) -> Checked {
    let [light_samples, pixel_samples] = samples;
    let (per_pixel, lights) = (light_samples.max(pixel_samples), lights.max(1));
    let row = size_px.saturating_mul(per_pixel).saturating_mul(lights);
    if row > ROW_SAMPLES_MAX {
        return Err(format!(
            "size_px x samples x lights = {size_px} x {per_pixel} x {lights} = {row} exceeds {ROW_SAMPLES_MAX}; lower \
             size_px, light_samples = {light_samples} or pixel_samples = {pixel_samples}, or leave lights out"
        ));
    }
    Ok(())
}

fn counted(key: &str, value: usize, max: usize) -> Checked {
    if value == 0 || value > max {
        return Err(format!("{key} = {value} must lie between 1 and {max}"));
    }
    Ok(())
}

fn length(key: &str, value_mm: f64) -> Checked {
    within(key, value_mm, LENGTH_MM[0], LENGTH_MM[1])
}

fn within(key: &str, value: f64, low: f64, high: f64) -> Checked {
    // Written so that NaN is refused.
    if !(low..=high).contains(&value) {
        return Err(format!("{key} = {value} must lie between {low} and {high}"));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene() -> Scene {
        serde_json::from_str(
            r#"{ "name": "s", "shape": "sphere", "size_px": 8, "lights": [{ "direction": [0, 0, 2] }] }"#,
        )
        .unwrap()
    }

    fn message(change: impl FnOnce(&mut Scene)) -> String {
        let mut scene = scene();
        change(&mut scene);
        check(&scene).unwrap_err().to_string()
    }

    #[test]
    fn defaults_are_filled_in_and_accepted() {
        let scene = scene();
        check(&scene).unwrap();
        assert_eq!(scene.lights[0].irradiance, 1.0);
        assert_eq!(scene.exposure, Exposure::Auto);
        let back: Scene = serde_json::from_str(&serde_json::to_string(&scene).unwrap()).unwrap();
        assert_eq!(back, scene);
    }

    #[test]
    fn unknown_keys_are_refused() {
        let wrong = r#"{ "name": "s", "shape": "sphere", "size_px": 8, "sizes": 1 }"#;
        assert!(serde_json::from_str::<Scene>(wrong).is_err());
    }

    #[test]
    fn what_cannot_be_rendered_is_refused_by_name() {
        assert!(message(|s| s.size_px = 0).contains("size_px = 0"));
        assert!(message(|s| s.size_px = 1 << 40).contains("size_px"));
        let crowded = |s: &mut Scene| {
            s.size_px = SIZE_MAX_PX;
            s.light_samples = 513;
        };
        assert!(message(crowded).contains("light_samples = 513"));
        assert!(message(|s| s.lights.clear()).contains("light"));
        assert!(message(|s| s.lights[0].direction = [0.0; 3]).contains("direction"));
        assert!(message(|s| s.lights[0].direction[1] = f64::NAN).contains("direction"));
        assert!(message(|s| s.lights[0].irradiance = -1.0).contains("irradiance"));
        assert!(message(|s| s.lights[0].angular_diameter_deg = 360.0).contains("angular"));
        assert!(message(|s| s.exposure = Exposure::Ev(f64::INFINITY)).contains("ev"));
        let below = |s: &mut Scene| {
            s.shape = Shape::Hemisphere;
            s.lights[0].direction = [0.0, 0.0, -1.0];
        };
        assert!(message(below).contains("positive z"));
        let near =
            |s: &mut Scene| s.shape = Shape::Patch { width_mm: 10.0, distance_mm: 9.0, tilt_deg: 0.0, turn_deg: 0.0 };
        assert!(message(near).contains("distance_mm = 9"));
        let touching = |s: &mut Scene| {
            s.shape = Shape::Screen {
                distance_mm: 10.0,
                width_mm: 100.0,
                beam_diameter_mm: 30.0,
                hole_diameter_mm: None,
                incidence_deg: 45.0,
            }
        };
        assert!(message(touching).contains("beam_diameter_mm"));
    }

    #[test]
    fn exposure_value_zero_shows_a_white_lambertian_as_white() {
        let image = Array3::zeros((1, 1, 3));
        let lambertian = std::f32::consts::FRAC_1_PI;
        assert!((exposure_factor(Exposure::Ev(0.0), &image) * lambertian - 1.0).abs() < 1e-6);
        assert!((exposure_factor(Exposure::Ev(1.0), &image) * lambertian - 2.0).abs() < 1e-6);
    }
}
