//! Mesh files: from OBJ and glTF to triangles with frames.

mod gltf;
mod gltf_arrays;
mod growing;
mod obj;
mod opened;

use std::fmt;
use std::path::{Path, PathBuf};

use diffraction_brdf::direction::Vec3;
use diffraction_brdf::error::{Error, Result};

use self::growing::bad;
use self::opened::Opened;
use super::tangents;
use super::triangles::TriangleMesh;

pub use self::growing::COORDINATE_MAX;

/// Most triangles with the same three corners. No hierarchy keeps them apart, so that a ray is tried against each.
const COINCIDENT_MAX: usize = 64;

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
    let heap = coincident(&raw.positions, &raw.triangles);
    if heap > COINCIDENT_MAX {
        let what = format!(
            "{}: {heap} of its triangles lie in one place, and every ray there would meet them all",
            path.display()
        );
        return Err(Error::limit(
            what,
            format!("Remove duplicates; up to {COINCIDENT_MAX} in one place are rendered."),
        ));
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

/// Most triangles that share their three corners' places, in whatever order.
fn coincident(positions: &[Vec3], triangles: &[[u32; 3]]) -> usize {
    // Adding zero makes -0 and 0 the same place.
    let place = |vertex: u32| positions[vertex as usize].map(|c| (c + 0.0).to_bits());
    let mut corners: Vec<[[u64; 3]; 3]> = triangles
        .iter()
        .map(|triangle| {
            let mut corners = triangle.map(place);
            corners.sort_unstable();
            corners
        })
        .collect();
    corners.sort_unstable();
    corners.chunk_by(|a, b| a == b).map(<[_]>::len).max().unwrap_or(0)
}
