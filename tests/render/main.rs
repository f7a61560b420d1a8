//! Scenes and CPU rendering against closed forms, and pictures of a stand-in grating.

mod animation;
mod closed_forms;
mod environment;
mod grating;
mod meshes;
mod pictures;
mod screen;

use diffraction_atlas::ground::direction::Vec3;
use diffraction_atlas::scene::animation::Turn;
use diffraction_atlas::scene::model::{Exposure, Light, Scene, Shape};

/// A scene lit by one light of unit irradiance.
fn scene(shape: Shape, direction: Vec3, size_px: usize) -> Scene {
    Scene {
        name: "test".into(),
        shape,
        lights: vec![Light { direction, angular_diameter_deg: 0.0, irradiance: 1.0 }],
        environment: None,
        turn: Turn::default(),
        animation: None,
        size_px,
        exposure: Exposure::Auto,
        specimen: None,
        light_samples: 1,
        pixel_samples: 1,
    }
}
