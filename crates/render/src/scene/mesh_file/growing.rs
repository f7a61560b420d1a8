//! A mesh being put together from a file: its limits, and the words for what goes beyond them.

use std::path::Path;

use crate::scene::tangents::RawMesh;
use diffraction_brdf::direction::Vec3;
use diffraction_brdf::error::{Error, Result};

/// Most triangles of a mesh, and most vertices: 0.8 GB when ready.
pub(super) const TRIANGLES_MAX: usize = 1 << 22;
/// Largest coordinate: squares of it are far from overflow.
pub const COORDINATE_MAX: f64 = 1e9;
/// Most materials of a mesh.
pub(super) const MATERIALS_MAX: usize = 1 << 12;
/// The material of triangles that name none.
pub(super) const NO_MATERIAL: &str = "default";

/// What to do about a file that does not hold what it must.
const EXPORT: &str = "Export it again from the modelling program, as OBJ or glTF, with UVs and normals.";

/// A fault of the file itself.
pub(super) fn bad(path: &Path, what: impl Into<String>) -> Error {
    Error::bad_file(path, what, EXPORT)
}

/// A mesh with too much of something.
pub(super) fn too_many(path: &Path, what: &str, max: usize) -> Error {
    Error::limit(format!("{}: it has more than {max} {what}", path.display()), "Simplify the mesh.")
}

/// Whether a coordinate can be worked with.
pub(super) fn usable(c: f64) -> bool {
    c.abs() <= COORDINATE_MAX
}

/// A mesh being put together, with its limits.
#[derive(Default)]
pub(super) struct Growing {
    pub(super) raw: RawMesh,
}

impl Growing {
    pub(super) fn vertex(&mut self, path: &Path, position: Vec3, normal: Vec3, uv: [f64; 2]) -> Result<u32> {
        if self.raw.positions.len() >= TRIANGLES_MAX {
            return Err(too_many(path, "vertices", TRIANGLES_MAX));
        }
        self.raw.positions.push(position);
        self.raw.normals.push(normal);
        self.raw.uvs.push(uv);
        Ok((self.raw.positions.len() - 1) as u32)
    }

    pub(super) fn triangle(&mut self, path: &Path, triangle: [u32; 3], material: u16) -> Result<()> {
        if self.raw.triangles.len() >= TRIANGLES_MAX {
            return Err(too_many(path, "triangles", TRIANGLES_MAX));
        }
        self.raw.triangles.push(triangle);
        self.raw.materials.push(material);
        Ok(())
    }

    /// Index of a material; the same name is the same material.
    pub(super) fn material(&mut self, path: &Path, name: &str) -> Result<u16> {
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
