//! The `[[scene]]` tables.

use std::path::Path;

use super::defaults;
use super::keys;
use super::mesh;
use super::name;
use super::reader::{Item, Section};
use super::tables;
use crate::error::Result;
use crate::stages::config::SpecimenConfig;
use crate::stages::pictures::sharing::specimens_of;
use diffraction_render::scene::environment::{self, Environment};
use diffraction_render::scene::limits::{
    ANIMATION_PIXELS_MAX, DIAMETER_MAX_DEG, EV_MAX, FPS_MAX, FRAMES_MAX, IRRADIANCE_MAX, LENGTH_MM, LIGHTS_MAX,
    SAMPLES_MAX, SIZE_MAX_PX, TILT_MAX_DEG, TURN_MAX_DEG,
};
use diffraction_render::scene::model::{
    Animation, Exposure, Light, LookUps, Moving, Scene, Shape, check_row_samples, check_turn,
};
use diffraction_render::scene::turn::{Axis, Turn};

/// Width and height of a picture: below, nobody sees anything.
const SIZE_PX: [usize; 2] = [16, SIZE_MAX_PX];

/// What a shape is called, which keys it takes beside those of every scene, and how many lights.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Kind {
    word: &'static str,
    own_keys: &'static [&'static str],
    lights_max: usize,
}

const KINDS: [Kind; 5] = [
    Kind { word: "hemisphere", own_keys: &["light"], lights_max: 1 },
    Kind { word: "sphere", own_keys: &["light", "environment"], lights_max: LIGHTS_MAX },
    Kind { word: "snake", own_keys: &["light", "environment"], lights_max: LIGHTS_MAX },
    Kind {
        word: "patch",
        own_keys: &["light", "environment", "width_mm", "distance_mm", "tilt_deg", "turn_deg"],
        lights_max: LIGHTS_MAX,
    },
    Kind {
        word: "screen",
        own_keys: &[
            "width_mm",
            "distance_mm",
            "beam_diameter_mm",
            "beam_divergence_deg",
            "hole_diameter_mm",
            "incidence_deg",
        ],
        lights_max: 0,
    },
];

/// A mesh file is named in the shape's place.
const MESH: Kind =
    Kind { word: "a mesh", own_keys: &["light", "environment", "camera", "materials"], lights_max: LIGHTS_MAX };

/// Keys that every shape takes.
const COMMON_KEYS: &[&str] = &[
    "name",
    "shape",
    "specimen",
    "size_px",
    "exposure",
    "tolerance",
    "animate",
    "look_ups",
    "light_samples",
    "pixel_samples",
];

/// Reads every scene; `specimens` are the names that `specimen` may give.
pub(crate) fn read_all(item: &Item, specimens: &[&str], base: &Path) -> Result<Vec<Scene>> {
    if !item.is_list() {
        return Err(item.error("must be written as [[scene]], with double brackets"));
    }
    let mut scenes: Vec<Scene> = Vec::new();
    for item in item.list()? {
        let section = item.section(&keys::SCENE, "[[scene]]")?;
        let name_item = section.require("name", "name = \"sphere\"")?;
        let name = name::read(&name_item)?;
        name::refuse_repetition(&name_item, &name, scenes.iter().map(|other| other.name.as_str()))?;
        scenes.push(read(&section, name, specimens, base)?);
    }
    Ok(scenes)
}

/// Refuses a tolerance where no tables are made for the scene: it would be ignored.
pub(crate) fn refuse_tolerances(item: &Item) -> Result<()> {
    for item in item.list()? {
        let section = item.section(&keys::SCENE, "[[scene]]")?;
        if section.has("tolerance") {
            let message = "`tolerance` of a scene goes with tables that are made for scenes: set tables.serve = \"scenes\", or \
                           tables.tolerance for tables for every direction";
            return Err(section.error_at_key("tolerance", message));
        }
    }
    Ok(())
}

/// Refuses a picture of several specimens under several illuminants: X, Y, Z are relative to one white, and there is one light.
pub(crate) fn refuse_mixed_lights(item: &Item, scenes: &[Scene], specimens: &[SpecimenConfig]) -> Result<()> {
    for (item, scene) in item.list()?.iter().zip(scenes) {
        let shown = specimens.iter().filter(|specimen| specimens_of(scene).contains(&specimen.name));
        let light = |specimen: &SpecimenConfig| (specimen.optics.illuminant.clone(), specimen.optics.wavelength_nm);
        let mut lights = shown.map(|specimen| (specimen, light(specimen)));
        let Some((first, light)) = lights.next() else { continue };
        if let Some((other, _)) = lights.find(|(_, other)| *other != light) {
            let message = format!(
                "scene \"{}\" shows \"{}\" and \"{}\" in one picture, whose `illuminant` differ: one picture has one light; give them the \
                 same, or a scene each",
                scene.name, first.name, other.name
            );
            return Err(item.section(&keys::SCENE, "[[scene]]")?.error_at_key("materials", message));
        }
    }
    Ok(())
}

fn read(section: &Section, name: String, specimens: &[&str], base: &Path) -> Result<Scene> {
    let item = section.require("shape", "shape = \"sphere\"")?;
    let kind = if mesh::names_a_file(&item) {
        MESH
    } else {
        item.choice_besides(&KINDS.map(|kind| (kind.word, kind)), mesh::EXAMPLE)?
    };
    refuse_foreign_keys(section, kind)?;
    let whole = |key: &str, [low, high]: [usize; 2], default: usize| match section.get(key) {
        Some(item) => item.integer_within(low, high, ""),
        None => Ok(default),
    };
    let shape =
        if kind == MESH { Shape::Mesh(mesh::read(section, &item, specimens, base)?) } else { shape(section, kind)? };
    let samples = if section.has("environment") { defaults::ENVIRONMENT_SAMPLES } else { defaults::LIGHT_SAMPLES };
    let light_samples = whole("light_samples", [1, SAMPLES_MAX], samples)?;
    let pixel_samples = whole("pixel_samples", [1, SAMPLES_MAX], defaults::PIXEL_SAMPLES)?;
    let size_px = whole("size_px", SIZE_PX, defaults::SIZE_PX)?;
    let scene = Scene {
        name,
        lights: lights(section, kind, &shape)?,
        animation: section.get("animate").map(|item| animation(&item, &shape, size_px)).transpose()?,
        shape,
        size_px,
        turn: Turn::default(),
        exposure: section.get("exposure").map_or(Ok(Exposure::Auto), |item| exposure(&item))?,
        environment: section.get("environment").map(|item| environment(&item, base)).transpose()?,
        tolerance: section.get("tolerance").map(|item| tables::tolerance(&item)).transpose()?,
        look_ups: section.get("look_ups").map_or(Ok(LookUps::default()), |item| {
            item.choice(&[("filtered", LookUps::Filtered), ("points", LookUps::Points)])
        })?,
        light_samples,
        pixel_samples,
        specimen: section.get("specimen").map(|item| one_of(&item, specimens)).transpose()?,
    };
    check_row(section, &scene)?;
    Ok(scene)
}

/// A row that is too long for the memory is pointed at where it may be shortened.
fn check_row(section: &Section, scene: &Scene) -> Result<()> {
    let lights = scene.lights.len() + usize::from(scene.environment.is_some());
    let size_px = scene.animation.map_or(0, |animation| animation.size_px).max(scene.size_px);
    check_row_samples(size_px, [scene.light_samples, scene.pixel_samples], lights).map_err(|why| {
        let keys = ["light_samples", "pixel_samples", "size_px", "light", "environment"];
        let key = keys.into_iter().find(|key| section.has(key)).unwrap_or("name");
        section.error_at_key(key, format!("a row of the picture takes too many samples: {why}"))
    })
}

/// A key of another shape would be ignored, so it is refused.
fn refuse_foreign_keys(section: &Section, kind: Kind) -> Result<()> {
    let foreign = keys::SCENE
        .names
        .iter()
        .find(|key| section.has(key) && !COMMON_KEYS.contains(key) && !kind.own_keys.contains(key));
    let Some(key) = foreign else {
        return Ok(());
    };
    let kinds = KINDS.iter().chain([&MESH]);
    let homes: Vec<&str> = kinds.filter(|other| other.own_keys.contains(key)).map(|other| other.word).collect();
    let (this, kind_of) = if kind == MESH {
        (kind.word.to_owned(), kind.word.to_owned())
    } else {
        (format!("\"{}\"", kind.word), format!("the shape \"{}\"", kind.word))
    };
    let message = format!(
        "`{key}` does not apply to {kind_of} but to {}; {this} takes {}",
        keys::quoted(&homes),
        keys::quoted(kind.own_keys),
    );
    Err(section.error_at_key(key, message))
}

fn shape(section: &Section, kind: Kind) -> Result<Shape> {
    let length = |key: &str, value: &mut f64| match section.get(key) {
        Some(item) => item.number_within(LENGTH_MM[0], LENGTH_MM[1], "mm").map(|given| *value = given),
        None => Ok(()),
    };
    let angle = |key: &str, value: &mut f64, max: f64| match section.get(key) {
        Some(item) => item.number_within(-max, max, "degrees").map(|given| *value = given),
        None => Ok(()),
    };
    let mut shape = match kind.word {
        "hemisphere" => Shape::Hemisphere,
        "sphere" => Shape::Sphere,
        "snake" => Shape::Snake,
        "patch" => defaults::PATCH,
        _ => defaults::SCREEN,
    };
    match &mut shape {
        Shape::Hemisphere | Shape::Sphere | Shape::Snake | Shape::Mesh(_) => {}
        Shape::Patch { width_mm, distance_mm, tilt_deg, turn_deg } => {
            length("width_mm", width_mm)?;
            length("distance_mm", distance_mm)?;
            angle("tilt_deg", tilt_deg, TILT_MAX_DEG)?;
            angle("turn_deg", turn_deg, TURN_MAX_DEG)?;
            if distance_mm <= width_mm {
                let message = format!(
                    "`distance_mm` ({distance_mm}) must exceed `width_mm` ({width_mm}), or the tilted square could \
                     reach the camera"
                );
                return Err(section.error_at_either("distance_mm", "width_mm", message));
            }
        }
        Shape::Screen { width_mm, distance_mm, beam_diameter_mm, hole_diameter_mm, incidence_deg } => {
            length("width_mm", width_mm)?;
            length("distance_mm", distance_mm)?;
            length("beam_diameter_mm", beam_diameter_mm)?;
            let hole = section.get("hole_diameter_mm").map(|item| item.number_within(0.0, LENGTH_MM[1], "mm"));
            *hole_diameter_mm = hole.transpose()?;
            angle("incidence_deg", incidence_deg, TILT_MAX_DEG)?;
            // The spot is stretched along the tilted specimen, whose rim must stay behind the screen.
            let reach_mm = 0.5 * *beam_diameter_mm * incidence_deg.to_radians().tan().abs();
            if reach_mm >= *distance_mm {
                let message = format!(
                    "at `incidence_deg` = {incidence_deg} a beam of {beam_diameter_mm} mm lights the specimen up to the \
                     screen, {distance_mm} mm away"
                );
                return Err(section.error_at_either("incidence_deg", "beam_diameter_mm", message));
            }
        }
    }
    Ok(shape)
}

fn lights(section: &Section, kind: Kind, shape: &Shape) -> Result<Vec<Light>> {
    if matches!(shape, Shape::Screen { .. }) {
        return Ok(vec![beam(section)?]);
    }
    let Some(item) = section.get("light") else {
        if section.has("environment") {
            return Ok(Vec::new());
        }
        if height_above_horizon(defaults::LIGHT.direction, shape) <= 0.0 {
            let message = "the square is turned away from the default light; add `light`";
            return Err(section.error_at_key("tilt_deg", message));
        }
        return Ok(vec![defaults::LIGHT]);
    };
    let items = if item.is_list() { item.list()? } else { vec![item.clone()] };
    if items.is_empty() || items.len() > kind.lights_max {
        let (word, max) = (kind.word, kind.lights_max);
        let allowed = if max == 1 { "exactly 1 light".to_owned() } else { format!("1 to {max} lights") };
        return Err(item.error(format!("must hold {allowed} for the shape \"{word}\"; found {}", items.len())));
    }
    items.iter().map(|item| light(item, shape)).collect()
}

/// The light that stands for a screen's beam.
fn beam(section: &Section) -> Result<Light> {
    let divergence =
        section.get("beam_divergence_deg").map(|item| item.number_within(0.0, DIAMETER_MAX_DEG, "degrees"));
    Ok(Light {
        direction: [0.0, 0.0, 1.0],
        angular_diameter_deg: divergence.transpose()?.unwrap_or(defaults::BEAM_DIVERGENCE_DEG),
        irradiance: 1.0,
    })
}

fn light(item: &Item, shape: &Shape) -> Result<Light> {
    let example = "{ direction = [0.3, 0.2, 1.0] }";
    let section = item.section(&keys::LIGHT, example)?;
    let diameter = section.get("angular_diameter_deg").map(|item| item.number_within(0.0, DIAMETER_MAX_DEG, "degrees"));
    let irradiance = section.get("irradiance").map(|item| item.number_above(0.0, IRRADIANCE_MAX, ""));
    Ok(Light {
        direction: direction(&section.require("direction", example)?, shape)?,
        angular_diameter_deg: diameter.transpose()?.unwrap_or(defaults::LIGHT.angular_diameter_deg),
        irradiance: irradiance.transpose()?.unwrap_or(defaults::LIGHT.irradiance),
    })
}

/// An image of all directions, alone or with how it is turned and scaled.
fn environment(item: &Item, base: &Path) -> Result<Environment> {
    let (mut rotate_deg, mut scale) = (defaults::ENVIRONMENT_ROTATE_DEG, defaults::ENVIRONMENT_SCALE);
    let mut file = item.clone();
    if item.is_table() {
        let example = "{ file = \"sky.exr\", rotate_deg = 90 }";
        let section = item.section(&keys::ENVIRONMENT, example)?;
        file = section.require("file", example)?;
        if let Some(item) = section.get("rotate_deg") {
            rotate_deg = item.number_within(-TURN_MAX_DEG, TURN_MAX_DEG, "degrees")?;
        }
        if let Some(item) = section.get("scale") {
            scale = item.number_above(0.0, IRRADIANCE_MAX, "")?;
        }
    }
    let path = base.join(file.text_not_empty()?);
    environment::load(&path, rotate_deg, scale).map_err(|why| file.error(format!("cannot light a scene: {why}")))
}

fn direction(item: &Item, shape: &Shape) -> Result<[f64; 3]> {
    let [x, y, z] = item.list_of::<3>("three numbers, towards the light")?;
    // Within these bounds no length overflows or underflows when it is squared.
    let component = |item: &Item| item.number_within(-1e6, 1e6, "");
    let direction = [component(&x)?, component(&y)?, component(&z)?];
    if direction.iter().all(|component| component.abs() < 1e-6) {
        return Err(item.error("must not be zero: it points towards the light"));
    }
    if height_above_horizon(direction, shape) <= 0.0 {
        return Err(
            item.error("lies below the horizon of the flat surface and never lights it; an untilted surface faces +z")
        );
    }
    Ok(direction)
}

/// Scalar product with a flat shape's normal; a ball has no horizon.
fn height_above_horizon([_, y, z]: [f64; 3], shape: &Shape) -> f64 {
    let tilt_deg = match shape {
        Shape::Sphere | Shape::Snake | Shape::Mesh(_) => return f64::INFINITY,
        Shape::Patch { tilt_deg, .. } => *tilt_deg,
        Shape::Hemisphere | Shape::Screen { .. } => 0.0,
    };
    // With its upper edge away from the camera, the surface looks up: its normal leans to +y.
    let (sin, cos) = tilt_deg.to_radians().sin_cos();
    y * sin + z * cos
}

/// Frames of an object or a light that turns; `size_px` is the still's.
fn animation(item: &Item, shape: &Shape, size_px: usize) -> Result<Animation> {
    let example = "{ kind = \"light\", frames = 24 }";
    let section = item.section(&keys::ANIMATE, example)?;
    let kind_item = section.require("kind", "kind = \"light\"")?;
    let moving = kind_item.choice(&[("turntable", Moving::Turntable), ("light", Moving::Light)])?;
    let axis = section.get("axis").map(|item| item.choice(&[("vertical", Axis::Vertical), ("viewing", Axis::Viewing)]));
    let axis = axis.transpose()?.unwrap_or(defaults::ANIMATE_AXIS);
    if let Err(why) = check_turn(shape, moving, axis) {
        return Err(section.error_at_either("axis", "kind", format!("`{}`: {why}", item.path())));
    }
    let whole = |key: &str, [low, high]: [usize; 2], default: usize| match section.get(key) {
        Some(item) => item.integer_within(low, high, ""),
        None => Ok(default),
    };
    let animation = Animation {
        kind: moving,
        axis,
        frames: whole("frames", [2, FRAMES_MAX], defaults::ANIMATE_FRAMES)?,
        degrees: match section.get("degrees") {
            Some(item) => item.number_within(-TURN_MAX_DEG, TURN_MAX_DEG, "degrees")?,
            None => defaults::ANIMATE_DEGREES,
        },
        fps: whole("fps", [1, FPS_MAX], defaults::ANIMATE_FPS)? as u16,
        size_px: whole("size_px", SIZE_PX, size_px)?,
    };
    if animation.degrees == 0.0 {
        return Err(section.error_at_key("degrees", format!("`{}.degrees`: nothing moves by 0 degrees", item.path())));
    }
    if animation.frames * animation.size_px * animation.size_px > ANIMATION_PIXELS_MAX {
        let (frames, side) = (animation.frames, animation.size_px);
        return Err(item.error(format!(
            "asks for {frames} frames of {side} x {side} pixels, more than {ANIMATION_PIXELS_MAX} pixels together; \
             `size_px` here makes it smaller than the still"
        )));
    }
    Ok(animation)
}

fn exposure(item: &Item) -> Result<Exposure> {
    if !item.is_table() {
        if item.as_text() == Some("auto") {
            return Ok(Exposure::Auto);
        }
        return Err(item.error("must be \"auto\" or { ev = 0.5 }"));
    }
    let section = item.section(&keys::EXPOSURE, "{ ev = 0.5 }")?;
    let ev = section.require("ev", "{ ev = 0.5 }")?;
    ev.number_within(-EV_MAX, EV_MAX, "stops").map(Exposure::Ev)
}

fn one_of(item: &Item, specimens: &[&str]) -> Result<String> {
    let options: Vec<(&str, &str)> = specimens.iter().map(|name| (*name, *name)).collect();
    item.choice(&options).map(str::to_owned)
}
