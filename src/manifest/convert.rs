//! From the manifest's sections to the stages' configuration.

use super::model::{
    DespikeSection, ExposureSection, HeightSection, HeightUnit, LevelSection, Manifest, SceneSection, ShapeSection,
    SpecimenSection,
};
use crate::stages::config::{RunConfig, SpecimenConfig};
use diffraction_build::height::prepare::{Despike, Level, PrepareConfig};
use diffraction_build::height::read::{HeightScale, LengthUnit, ReadConfig};
use diffraction_render::scene::model::{Exposure, Light, Scene, Shape};
use diffraction_render::scene::turn::Turn;

/// The run that a manifest asks for; `text` is the manifest, word for word.
pub fn run_config(manifest: &Manifest, text: &str) -> RunConfig {
    RunConfig {
        atlas_name: manifest.atlas.name.clone(),
        atlas_root: manifest.atlas.out.join(&manifest.atlas.name),
        tables: manifest.tables.clone(),
        serve: manifest.serve.clone(),
        specimens: manifest.specimens.iter().map(specimen_config).collect(),
        scenes: manifest.scenes.iter().map(scene).collect(),
        gpu: manifest.gpu.check,
        frame_time: manifest.gpu.frame_time,
        report: manifest.report,
        cache: manifest.cache.clone(),
        manifest_text: text.to_owned(),
        base: manifest.base.clone(),
    }
}

/// One specimen's configuration.
pub fn specimen_config(section: &SpecimenSection) -> SpecimenConfig {
    SpecimenConfig {
        name: section.name.clone(),
        species: section.species.clone(),
        scans: section.scans.clone(),
        read: ReadConfig {
            page: section.page,
            pitch_nm: section.pitch_nm,
            height: section.height.map(height_scale),
            max_missing_share: section.max_missing_share,
            ..ReadConfig::default()
        },
        prepare: PrepareConfig {
            level: level(section.level),
            despike: section.despike.map(|DespikeSection { threshold_rms }| Despike { threshold_rms }),
            blend_nm: section.blend_nm,
        },
        optics: section.optics.clone(),
        albedo: section.albedo,
        measured: section.measured.clone(),
    }
}

fn height_scale(section: HeightSection) -> HeightScale {
    match section {
        HeightSection::FullScaleNm(full_scale_nm) => HeightScale::FullScaleNm(full_scale_nm),
        HeightSection::Unit(unit) => HeightScale::Unit(length_unit(unit)),
        HeightSection::Linear { nm_per_count, offset_nm } => HeightScale::Linear { nm_per_count, offset_nm },
    }
}

fn length_unit(unit: HeightUnit) -> LengthUnit {
    match unit {
        HeightUnit::Pm => LengthUnit::Pm,
        HeightUnit::Nm => LengthUnit::Nm,
        HeightUnit::Um => LengthUnit::Um,
        HeightUnit::Mm => LengthUnit::Mm,
        HeightUnit::Cm => LengthUnit::Cm,
        HeightUnit::M => LengthUnit::M,
        HeightUnit::Angstrom => LengthUnit::Angstrom,
        HeightUnit::Inch => LengthUnit::Inch,
    }
}

fn level(section: LevelSection) -> Level {
    match section {
        LevelSection::None => Level::None,
        LevelSection::Plane => Level::Plane,
        LevelSection::Quadratic => Level::Quadratic,
        LevelSection::Rows => Level::Rows,
    }
}

/// What a scene shows.
pub fn shape(section: &ShapeSection) -> Shape {
    match section {
        ShapeSection::Hemisphere => Shape::Hemisphere,
        ShapeSection::Sphere => Shape::Sphere,
        ShapeSection::Snake => Shape::Snake,
        ShapeSection::Mesh(mesh) => Shape::Mesh(mesh.clone()),
        &ShapeSection::Patch { width_mm, distance_mm, tilt_deg, turn_deg } => {
            Shape::Patch { width_mm, distance_mm, tilt_deg, turn_deg }
        }
        &ShapeSection::Screen { width_mm, distance_mm, beam_diameter_mm, hole_diameter_mm, incidence_deg } => {
            Shape::Screen { distance_mm, width_mm, beam_diameter_mm, hole_diameter_mm, incidence_deg }
        }
    }
}

fn scene(section: &SceneSection) -> Scene {
    let light = |light: &super::model::LightSection| Light {
        direction: light.direction,
        angular_diameter_deg: light.angular_diameter_deg,
        irradiance: light.irradiance,
    };
    Scene {
        name: section.name.clone(),
        shape: shape(&section.shape),
        lights: section.lights.iter().map(light).collect(),
        environment: section.environment.clone(),
        turn: Turn::default(),
        animation: section.animation,
        size_px: section.size_px,
        exposure: match section.exposure {
            ExposureSection::Auto => Exposure::Auto,
            ExposureSection::Ev(stops) => Exposure::Ev(stops),
        },
        specimen: section.specimen.clone(),
        tolerance: section.tolerance,
        light_samples: section.light_samples,
        pixel_samples: section.pixel_samples,
    }
}
