//! Mesh files: from OBJ and glTF to triangles with frames.

mod gltf;
mod gltf_arrays;
mod growing;
mod obj;
mod opened;

use std::fmt;
use std::path::{Path, PathBuf};

use diffraction_brdf::error::{Error, Result};

use self::growing::bad;
use self::opened::Opened;
use super::tangents;
use super::triangles::TriangleMesh;

pub use self::growing::COORDINATE_MAX;

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

/// Reads a mesh by the ending of its name: `.obj`, `.gltf` or `.glb`.
///
/// # Errors
/// `Error::BadFile` for what is no mesh, lacks texture coordinates, or uses what is not supported; `Error::Disk`;
/// `Error::Limit`.
pub fn read(path: &Path) -> Result<Model> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    let mut opened = Opened::new(path);
    let bytes = opened.read(path)?;
    let raw = match ending.as_deref() {
        Some("obj") => obj::parse(path, &bytes)?,
        Some("gltf" | "glb") => gltf::parse(&mut opened, &bytes)?,
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
    Ok(Model { mesh, files: opened.files })
}
