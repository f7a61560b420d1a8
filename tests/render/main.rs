//! Scenes and CPU rendering against closed forms, and pictures of a stand-in grating.

mod animation;
mod closed_forms;
mod environment;
mod filtered;
mod grating;
mod mesh_files;
mod meshes;
mod pictures;
mod screen;

use diffraction_brdf::direction::Vec3;
use diffraction_render::scene::model::{Light, Scene, Shape};

/// A scene lit by one light of unit irradiance.
fn scene(shape: Shape, direction: Vec3, size_px: usize) -> Scene {
    Scene::still("test", shape, vec![Light::point(direction)], size_px)
}
