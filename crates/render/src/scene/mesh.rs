//! A mesh file as the body of a scene: reading it, framing it, and which specimen covers which part.

mod gltf;
mod gltf_arrays;
mod gltf_document;
mod obj;

use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use diffraction_brdf::direction::{Vec3, dot};
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::files;

use super::animation::{Turn, back, carried, turned};
use super::bvh::{self, Ray};
use super::camera::{self, Camera, View};
use super::frame::add_scaled;
use super::model::{Scene, Shape};
use super::surface::{Hit, LitHit};
use super::tangents::{self, RawMesh};
use super::triangles::{TriangleMesh, first_hit, is_open, surface};

/// Largest mesh file, and largest sum of the files it names.
pub const BYTES_MAX: u64 = 512 << 20;
/// Most triangles of a mesh, and most vertices: 0.8 GB when ready.
pub const TRIANGLES_MAX: usize = 1 << 22;
/// Largest coordinate: squares of it are far from overflow.
pub const COORDINATE_MAX: f64 = 1e9;
/// Most materials of a mesh.
pub const MATERIALS_MAX: usize = 1 << 12;
/// The material of triangles that name none.
pub const NO_MATERIAL: &str = "default";

/// What to do about a file that does not hold what it must.
const EXPORT: &str = "Export it again from the modelling program, as OBJ or glTF, with UVs and normals.";

/// A mesh that has been read.
#[derive(Clone, PartialEq, Default)]
pub struct Model {
    /// The triangles.
    pub mesh: TriangleMesh,
    /// Every file that was read, with its SHA-256 in hexadecimal.
    pub files: Vec<(PathBuf, String)>,
}

/// Without the vertices: scenes are shown in messages.
impl fmt::Debug for Model {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let triangles = self.mesh.triangles.len();
        f.debug_struct("Model").field("triangles", &triangles).field("files", &self.files).finish_non_exhaustive()
    }
}

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
    /// What was read from the file by [`read`]; a scene without it is refused.
    #[serde(skip)]
    pub model: Arc<Model>,
}

/// Reads a mesh by the ending of its name: `.obj`, `.gltf` or `.glb`.
///
/// # Errors
/// `Error::BadFile` for what is no mesh, lacks texture coordinates, or uses what is not supported; `Error::Disk`;
/// `Error::Limit`.
pub fn read(path: &Path) -> Result<Model> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    let mut reading = Reading { path: path.to_owned(), files: Vec::new(), bytes: 0 };
    let bytes = reading.read(path)?;
    let raw = match ending.as_deref() {
        Some("obj") => obj::parse(path, &bytes)?,
        Some("gltf" | "glb") => gltf::parse(&mut reading, &bytes)?,
        _ => {
            let what = "a mesh's name ends in .obj, .gltf or .glb";
            return Err(Error::bad_file(path, what, "Convert it to one of these."));
        }
    };
    if raw.triangles.is_empty() {
        return Err(bad(path, "it holds no triangles"));
    }
    let mesh = tangents::build(raw).map_err(|triangle| {
        bad(
            path,
            format!(
                "the texture coordinates of triangle {triangle} (from 0, in the file's order) lie on a line, so the \
                 structure has no direction there; unwrap the mesh"
            ),
        )
    })?;
    if mesh.triangles.is_empty() {
        return Err(bad(path, "none of its triangles has an area"));
    }
    Ok(Model { mesh, files: reading.files })
}

/// A fault of the file itself.
fn bad(path: &Path, what: impl Into<String>) -> Error {
    Error::bad_file(path, what, EXPORT)
}

/// A mesh with too much of something.
fn too_many(path: &Path, what: &str, max: usize) -> Error {
    Error::limit(format!("{}: it has more than {max} {what}", path.display()), "Simplify the mesh.")
}

/// What has been read so far.
struct Reading {
    path: PathBuf,
    files: Vec<(PathBuf, String)>,
    bytes: u64,
}

impl Reading {
    /// A file's bytes, unless there are too many.
    fn read(&mut self, path: &Path) -> Result<Vec<u8>> {
        let metadata = path.metadata().map_err(|e| Error::disk(path, "read", e))?;
        if !metadata.is_file() {
            return Err(bad(path, "it is not a file"));
        }
        self.bytes += metadata.len();
        if self.bytes > BYTES_MAX {
            let what =
                format!("{}: with it the mesh takes {} bytes, more than {BYTES_MAX}", path.display(), self.bytes);
            return Err(Error::limit(what, "Simplify the mesh."));
        }
        let bytes = files::read(path)?;
        self.files.push((path.to_owned(), files::sha256_hex(&bytes)));
        Ok(bytes)
    }
}

/// A mesh being put together, with its limits.
#[derive(Default)]
struct Growing {
    raw: RawMesh,
}

impl Growing {
    fn vertex(&mut self, path: &Path, position: Vec3, normal: Vec3, uv: [f64; 2]) -> Result<u32> {
        if self.raw.positions.len() >= TRIANGLES_MAX {
            return Err(too_many(path, "vertices", TRIANGLES_MAX));
        }
        self.raw.positions.push(position);
        self.raw.normals.push(normal);
        self.raw.uvs.push(uv);
        Ok((self.raw.positions.len() - 1) as u32)
    }

    fn triangle(&mut self, path: &Path, triangle: [u32; 3], material: u16) -> Result<()> {
        if self.raw.triangles.len() >= TRIANGLES_MAX {
            return Err(too_many(path, "triangles", TRIANGLES_MAX));
        }
        self.raw.triangles.push(triangle);
        self.raw.materials.push(material);
        Ok(())
    }

    /// Index of a material; the same name is the same material.
    fn material(&mut self, path: &Path, name: &str) -> Result<u16> {
        let names = &mut self.raw.material_names;
        if let Some(index) = names.iter().position(|known| known == name) {
            return Ok(index as u16);
        }
        if names.len() >= MATERIALS_MAX {
            return Err(too_many(path, "materials", MATERIALS_MAX));
        }
        names.push(name.to_owned());
        Ok((names.len() - 1) as u16)
    }
}

/// Whether a coordinate can be worked with.
fn usable(c: f64) -> bool {
    c.abs() <= COORDINATE_MAX
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

/// The scene in which the specimen of this index alone is bright: its share of the picture. Shares add up to it.
///
/// # Panics
/// For a scene without materials.
pub fn share(scene: &Scene, index: usize) -> Scene {
    let mut scene = scene.clone();
    match &mut scene.shape {
        Shape::Mesh(mesh) if index < mesh.specimens.len() => mesh.shown = Some(index),
        _ => panic!("scene \"{}\" has no specimen of index {index}", scene.name),
    }
    scene
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
pub fn hit(view: &MeshView, xy: [f64; 2]) -> Option<LitHit> {
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
