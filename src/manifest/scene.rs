//! The `[[scene]]` tables.

use super::defaults;
use super::keys;
use super::model::{ExposureSection, LightSection, SceneSection, ShapeSection};
use super::name;
use super::reader::{Item, Section};
use crate::ground::error::Result;

/// Width and height of a picture.
const SIZE_PX: [usize; 2] = [16, 8192];

/// Most directions that stand for a light's disc.
const LIGHT_SAMPLES_MAX: usize = 4096;

/// Most lights of one scene.
const LIGHTS_MAX: usize = 64;

/// Longest length of a scene in mm.
const LENGTH_MAX_MM: f64 = 1e5;

/// Steepest angle: at 90 degrees nothing is lit.
const ANGLE_MAX_DEG: f64 = 89.0;

/// What a shape is called, which keys it takes beside those of every scene, and whether it is flat.
#[derive(Debug, Clone, Copy)]
struct Kind {
    word: &'static str,
    own_keys: &'static [&'static str],
    flat: bool,
    lights_max: usize,
}

const KINDS: [Kind; 4] = [
    Kind {
        word: "hemisphere",
        own_keys: &["light", "light_samples"],
        flat: true,
        lights_max: 1,
    },
    Kind {
        word: "sphere",
        own_keys: &["light", "light_samples"],
        flat: false,
        lights_max: LIGHTS_MAX,
    },
    Kind {
        word: "patch",
        own_keys: &[
            "light",
            "light_samples",
            "width_mm",
            "distance_mm",
            "tilt_deg",
        ],
        flat: true,
        lights_max: LIGHTS_MAX,
    },
    Kind {
        word: "screen",
        own_keys: &[
            "width_mm",
            "distance_mm",
            "beam_diameter_mm",
            "incidence_deg",
        ],
        flat: true,
        lights_max: 0,
    },
];

/// Keys that every shape takes.
const COMMON_KEYS: &[&str] = &["name", "shape", "specimen", "size_px", "exposure"];

/// Reads every scene; `specimens` are the names that `specimen` may give.
pub fn read_all(item: &Item, specimens: &[&str]) -> Result<Vec<SceneSection>> {
    if !item.is_list() {
        return Err(item.error("must be written as [[scene]], with double brackets"));
    }
    let mut scenes: Vec<SceneSection> = Vec::new();
    for item in item.list()? {
        let section = item.section(&keys::SCENE, "[[scene]]")?;
        let name_item = section.require("name", "name = \"sphere\"")?;
        let name = name::read(&name_item)?;
        name::refuse_repetition(
            &name_item,
            &name,
            scenes.iter().map(|other| other.name.as_str()),
        )?;
        scenes.push(read(&section, name, specimens)?);
    }
    Ok(scenes)
}

fn read(section: &Section, name: String, specimens: &[&str]) -> Result<SceneSection> {
    let kind = section
        .require("shape", "shape = \"sphere\"")?
        .choice(&KINDS.map(|kind| (kind.word, kind)))?;
    refuse_foreign_keys(section, kind)?;
    let size = section
        .get("size_px")
        .map(|item| item.integer_within(SIZE_PX[0], SIZE_PX[1], "pixels"));
    let samples = section
        .get("light_samples")
        .map(|item| item.integer_within(1, LIGHT_SAMPLES_MAX, ""));
    Ok(SceneSection {
        name,
        shape: shape(section, kind)?,
        lights: lights(section, kind)?,
        size_px: size.transpose()?.unwrap_or(defaults::SIZE_PX),
        exposure: section
            .get("exposure")
            .map_or(Ok(ExposureSection::Auto), |item| exposure(&item))?,
        light_samples: samples.transpose()?.unwrap_or(defaults::LIGHT_SAMPLES),
        specimen: section
            .get("specimen")
            .map(|item| one_of(&item, specimens))
            .transpose()?,
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
    let homes: Vec<&str> = KINDS
        .iter()
        .filter(|other| other.own_keys.contains(key))
        .map(|other| other.word)
        .collect();
    let message = format!(
        "`{key}` does not apply to the shape \"{}\" but to {}; here {} may stand",
        kind.word,
        keys::quoted(&homes),
        keys::quoted(kind.own_keys),
    );
    Err(section.error_at_key(key, message))
}

fn shape(section: &Section, kind: Kind) -> Result<ShapeSection> {
    let length = |key: &str, default: f64| match section.get(key) {
        Some(item) => item.number_above(0.0, LENGTH_MAX_MM, "mm"),
        None => Ok(default),
    };
    let angle = |key: &str, default: f64, low: f64| match section.get(key) {
        Some(item) => item.number_within(low, ANGLE_MAX_DEG, "degrees"),
        None => Ok(default),
    };
    Ok(match kind.word {
        "hemisphere" => ShapeSection::Hemisphere,
        "sphere" => ShapeSection::Sphere,
        "patch" => ShapeSection::Patch {
            width_mm: length("width_mm", defaults::PATCH[0])?,
            distance_mm: length("distance_mm", defaults::PATCH[1])?,
            tilt_deg: angle("tilt_deg", defaults::PATCH[2], -ANGLE_MAX_DEG)?,
        },
        _ => ShapeSection::Screen {
            width_mm: length("width_mm", defaults::SCREEN[0])?,
            distance_mm: length("distance_mm", defaults::SCREEN[1])?,
            beam_diameter_mm: length("beam_diameter_mm", defaults::SCREEN[2])?,
            incidence_deg: angle("incidence_deg", defaults::SCREEN[3], 0.0)?,
        },
    })
}

fn lights(section: &Section, kind: Kind) -> Result<Vec<LightSection>> {
    let Some(item) = section.get("light") else {
        let count = usize::from(kind.lights_max > 0);
        return Ok(vec![defaults::LIGHT; count]);
    };
    let items = if item.is_list() {
        item.list()?
    } else {
        vec![item.clone()]
    };
    if items.is_empty() || items.len() > kind.lights_max {
        let (word, max) = (kind.word, kind.lights_max);
        let allowed = if max == 1 {
            "exactly 1 light".to_owned()
        } else {
            format!("1 to {max} lights")
        };
        return Err(item.error(format!(
            "must hold {allowed} for the shape \"{word}\"; found {}",
            items.len()
        )));
    }
    items.iter().map(|item| light(item, kind)).collect()
}

fn light(item: &Item, kind: Kind) -> Result<LightSection> {
    let example = "{ direction = [0.3, 0.2, 1.0] }";
    let section = item.section(&keys::LIGHT, example)?;
    let diameter = section
        .get("angular_diameter_deg")
        .map(|item| item.number_within(0.0, 90.0, "degrees"));
    let irradiance = section
        .get("irradiance")
        .map(|item| item.number_above(0.0, 1e6, ""));
    Ok(LightSection {
        direction: direction(&section.require("direction", example)?, kind)?,
        angular_diameter_deg: diameter
            .transpose()?
            .unwrap_or(defaults::LIGHT.angular_diameter_deg),
        irradiance: irradiance
            .transpose()?
            .unwrap_or(defaults::LIGHT.irradiance),
    })
}

fn direction(item: &Item, kind: Kind) -> Result<[f64; 3]> {
    let [x, y, z] = item.list_of::<3>("three numbers, towards the light")?;
    // Within these bounds no length overflows or underflows when it is squared.
    let component = |item: &Item| item.number_within(-1e6, 1e6, "");
    let direction = [component(&x)?, component(&y)?, component(&z)?];
    if direction.iter().all(|component| component.abs() < 1e-6) {
        return Err(item.error("must not be zero: it points towards the light"));
    }
    if kind.flat && direction[2] <= 0.0 {
        return Err(item.error(format!(
            "must have a positive third number: below the horizon it never lights the shape \"{}\"",
            kind.word
        )));
    }
    Ok(direction)
}

fn exposure(item: &Item) -> Result<ExposureSection> {
    if !item.is_table() {
        if item.as_text() == Some("auto") {
            return Ok(ExposureSection::Auto);
        }
        return Err(item.error("must be \"auto\" or { ev = 0.5 }"));
    }
    let section = item.section(&keys::EXPOSURE, "{ ev = 0.5 }")?;
    let ev = section.require("ev", "{ ev = 0.5 }")?;
    ev.number_within(-40.0, 40.0, "stops")
        .map(ExposureSection::Ev)
}

fn one_of(item: &Item, specimens: &[&str]) -> Result<String> {
    let options: Vec<(&str, &str)> = specimens.iter().map(|name| (*name, *name)).collect();
    item.choice(&options).map(str::to_owned)
}
