//! A mesh as the body of a scene: framing it, what a ray meets, and which specimen covers which part.

use std::path::PathBuf;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use diffraction_brdf::direction::{Vec3, dot};

use super::bvh::{self, Ray};
use super::camera::{self, Camera, View};
use super::frame::add_scaled;
use super::hit::{Hit, LitHit};
use super::mesh_file::Model;
use super::triangles::{first_hit, is_open, surface};
use super::turn::{Turn, back, carried, turned};

/// A mesh in a scene. Lights and camera are in the file's own coordinates.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MeshShape {
    /// The file.
    pub path: PathBuf,
    /// The camera; without one, it looks along -z at the whole mesh.
    #[serde(default)]
    pub camera: Option<Camera>,
    /// Names of the specimens that cover the mesh by material; none where one specimen covers all of it.
    #[serde(default)]
    pub specimens: Vec<String>,
    /// For each material of the mesh, the index of its specimen; empty where `specimens` is.
    #[serde(default)]
    pub specimen_of_material: Vec<usize>,
    /// The only specimen whose surface is shown, by index; the rest hides and shades and is dark itself.
    #[serde(default)]
    pub shown: Option<usize>,
    /// What was read from the file by [`mesh_file::read`](super::mesh_file::read); a scene without it is refused.
    #[serde(skip)]
    pub model: Arc<Model>,
}

/// A mesh and what the camera sees of it.
#[derive(Debug)]
pub struct MeshView<'a> {
    shape: &'a MeshShape,
    view: View,
    /// Turns the mesh about `middle`.
    turn: Turn,
    /// Middle of the mesh's box.
    middle: Vec3,
}

/// The camera in use.
pub fn camera_of(shape: &MeshShape) -> Camera {
    shape.camera.unwrap_or_else(|| camera::automatic(&bvh::bounds(&shape.model.mesh.bvh)))
}

/// The view of a mesh that has passed [`check`], turned about the middle of its box. The camera stays.
///
/// # Panics
/// Where it has not.
pub fn view(shape: &MeshShape, turn: Turn) -> MeshView<'_> {
    let view = camera::view(&camera_of(shape)).expect("the camera was checked");
    MeshView { shape, view, turn, middle: bvh::middle(&bvh::bounds(&shape.model.mesh.bvh)) }
}

/// A point turned about another.
fn turned_about(middle: Vec3, point: Vec3, turn: Turn) -> Vec3 {
    if turn.angle_deg == 0.0 {
        // Exactly: a mesh that is not turned must not lose digits.
        return point;
    }
    add_scaled(middle, turned(add_scaled(point, middle, -1.0), turn), 1.0)
}

/// What keeps a mesh from being shown.
pub fn check(shape: &MeshShape) -> std::result::Result<(), String> {
    let path = shape.path.display();
    let mesh = &shape.model.mesh;
    if mesh.triangles.is_empty() {
        return Err(format!("the mesh {path} has not been read"));
    }
    if camera::view(&camera_of(shape)).is_none() {
        return Err("camera: position and target must differ, and up must not lie along the line between them".into());
    }
    let covered = shape.specimen_of_material.len();
    if !shape.specimens.is_empty() && covered != mesh.material_names.len() {
        return Err(format!("{covered} of the {} materials of {path} have a specimen", mesh.material_names.len()));
    }
    if shape.specimen_of_material.iter().chain(&shape.shown).any(|&index| index >= shape.specimens.len()) {
        return Err("materials: a specimen's index is out of range".into());
    }
    Ok(())
}

/// Where the camera ray through picture point `(x, y)` meets the outside of the mesh, where the specimen is shown.
pub(crate) fn hit(view: &MeshView, xy: [f64; 2]) -> Option<LitHit> {
    let MeshView { shape, view, turn, middle } = view;
    let ray = turned_back(*middle, *turn, camera::ray(view, xy));
    let mesh = &shape.model.mesh;
    let point = surface(mesh, &first_hit(mesh, &ray)?);
    let to_viewer = ray.direction.map(|c| -c);
    let is_shown = shape.shown.is_none_or(|shown| shape.specimen_of_material[point.material] == shown);
    (is_shown && dot(point.facet, to_viewer) > 0.0).then(|| LitHit {
        hit: Hit { frame: carried(&point.frame, *turn), to_viewer: turned(to_viewer, *turn) },
        lifted: turned_about(*middle, point.lifted, *turn),
    })
}

/// Whether no other part of the mesh stands between a point and a light.
pub fn is_lit(view: &MeshView, from: Vec3, direction: Vec3) -> bool {
    let ray = turned_back(view.middle, view.turn, Ray { origin: from, direction });
    is_open(&view.shape.model.mesh, &ray)
}

/// A ray as the mesh sees it in the file's own coordinates.
fn turned_back(middle: Vec3, turn: Turn, ray: Ray) -> Ray {
    let turn = back(turn);
    Ray { origin: turned_about(middle, ray.origin, turn), direction: turned(ray.direction, turn) }
}
