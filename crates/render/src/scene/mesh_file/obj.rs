//! Wavefront OBJ: vertices, texture coordinates, normals, polygons and material names; the rest is passed over.
//!
//! Read here and not by `tobj` 4.0.5, which was tried on the files of `mesh_files.rs`. It keeps the name of a material only
//! where a file beside the mesh defines it; names cover the mesh with specimens here. To a corner without texture
//! coordinates or normal it gives those of another corner, or shifts all that follow. It refuses comments behind a face
//! and names that are not UTF-8. Its errors tell neither line nor number, and it holds a whole polygon and all faces
//! before the first limit could be checked: 12 bytes of memory for each of the file.

use std::collections::HashMap;
use std::path::Path;

use super::growing::{COORDINATE_MAX, Growing, NO_MATERIAL, TRIANGLES_MAX, bad, too_many, usable};
use crate::scene::tangents::RawMesh;
use diffraction_brdf::direction::{Vec3, dot};
use diffraction_brdf::error::{Error, Result};

/// What a file has listed so far.
#[derive(Default)]
struct Lists {
    positions: Vec<Vec3>,
    uvs: Vec<[f64; 2]>,
    normals: Vec<Vec3>,
}

/// One corner of a polygon: indices into the lists.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
struct Corner {
    position: usize,
    uv: usize,
    normal: Option<usize>,
}

/// The mesh as far as it is put together.
struct Assembly<'a> {
    path: &'a Path,
    mesh: Growing,
    /// Vertices by their corner. Only looked up, never walked through: its order does not matter.
    known: HashMap<Corner, u32>,
}

/// The material of the faces that follow; it counts from its first face on.
struct Named {
    name: String,
    index: Option<u16>,
}

/// What is wrong: with one line, or else.
enum Fault {
    Line(String),
    Other(Error),
}

impl From<Error> for Fault {
    fn from(error: Error) -> Self {
        Self::Other(error)
    }
}

impl From<String> for Fault {
    fn from(what: String) -> Self {
        Self::Line(what)
    }
}

/// The mesh of an OBJ file. Polygons become fans of triangles about their first corner. Triangles with a corner that has
/// no normal are flat.
///
/// # Errors
/// As [`read`](super::read), with the line.
pub fn parse(path: &Path, bytes: &[u8]) -> Result<RawMesh> {
    let mut lists = Lists::default();
    let mut assembly = Assembly { path, mesh: Growing::default(), known: HashMap::new() };
    let mut material = Named { name: NO_MATERIAL.to_owned(), index: None };
    for (index, line) in bytes.split(|&byte| byte == b'\n').enumerate() {
        // Names and comments may be in any encoding; numbers are ASCII.
        let line = String::from_utf8_lossy(line);
        statement(&mut assembly, &mut lists, &mut material, &line).map_err(|fault| match fault {
            Fault::Line(what) => bad(path, format!("line {}: {what}", index + 1)),
            Fault::Other(error) => error,
        })?;
    }
    Ok(assembly.mesh.raw)
}

fn statement(
    assembly: &mut Assembly,
    lists: &mut Lists,
    material: &mut Named,
    line: &str,
) -> std::result::Result<(), Fault> {
    let path = assembly.path;
    let line = line.split('#').next().unwrap_or_default().trim();
    if line.ends_with('\\') {
        return Err(Fault::Line("it goes on in the next line, which is not supported".into()));
    }
    let (keyword, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
    match keyword {
        "v" => push(path, &mut lists.positions, numbers::<3>(rest, 3)?)?,
        "vn" => push(path, &mut lists.normals, numbers::<3>(rest, 3)?)?,
        "vt" => push(path, &mut lists.uvs, numbers::<2>(rest, 1)?)?,
        "usemtl" => *material = Named { name: rest.trim().to_owned(), index: None },
        "f" => {
            let index = match material.index {
                Some(index) => index,
                None => assembly.mesh.material(path, &material.name)?,
            };
            material.index = Some(index);
            face(assembly, lists, rest, index)?;
        }
        _ => {}
    }
    Ok(())
}

fn push<T>(path: &Path, list: &mut Vec<T>, item: T) -> Result<()> {
    if list.len() >= TRIANGLES_MAX {
        return Err(too_many(path, "vertices, texture coordinates or normals", TRIANGLES_MAX));
    }
    list.push(item);
    Ok(())
}

/// The first `N` numbers of a line, of which `least` must be there; 0 stands for the others.
fn numbers<const N: usize>(text: &str, least: usize) -> std::result::Result<[f64; N], String> {
    let mut values = [0.0; N];
    let mut words = text.split_ascii_whitespace();
    for (index, value) in values.iter_mut().enumerate() {
        let Some(word) = words.next() else {
            if index < least {
                return Err(format!("it must hold {least} numbers, found {index}"));
            }
            break;
        };
        let number = word.parse().ok().filter(|&number| usable(number));
        *value = number.ok_or_else(|| format!("{:?} is not a number within ±{COORDINATE_MAX:e}", start_of(word)))?;
    }
    Ok(values)
}

/// Enough of a word to recognise it.
fn start_of(word: &str) -> String {
    word.chars().take(40).collect()
}

fn face(assembly: &mut Assembly, lists: &Lists, text: &str, material: u16) -> std::result::Result<(), Fault> {
    // Held one corner at a time: a polygon may have any number of them.
    let mut words = text.split_ascii_whitespace().map(|word| corner(lists, word));
    let mut next = || words.next().transpose();
    let (Some(first), Some(mut last), Some(mut third)) = (next()?, next()?, next()?) else {
        return Err(Fault::Line("a face needs 3 corners or more".into()));
    };
    loop {
        triangle(assembly, lists, [first, last, third], material)?;
        last = third;
        match next()? {
            Some(corner) => third = corner,
            None => return Ok(()),
        }
    }
}

fn triangle(
    assembly: &mut Assembly,
    lists: &Lists,
    corners: [Corner; 3],
    material: u16,
) -> std::result::Result<(), Fault> {
    let Assembly { path, mesh, known } = assembly;
    let is_flat = corners.iter().any(|corner| corner.normal.is_none());
    let mut vertices = [0; 3];
    for (vertex, corner) in vertices.iter_mut().zip(corners) {
        let (position, uv) = (lists.positions[corner.position], lists.uvs[corner.uv]);
        *vertex = match (corner.normal, known.get(&corner)) {
            // A facet of its own: its corners are shared with nobody.
            _ if is_flat => mesh.vertex(path, position, [0.0; 3], uv)?,
            (_, Some(&index)) => index,
            (normal, None) => {
                let normal = normal.map_or([0.0; 3], |normal| lists.normals[normal]);
                if dot(normal, normal) == 0.0 {
                    return Err(Fault::Line("one of its normals (vn) is the zero vector".into()));
                }
                let index = mesh.vertex(path, position, normal, uv)?;
                known.insert(corner, index);
                index
            }
        };
    }
    Ok(mesh.triangle(path, vertices, material)?)
}

/// The indices of `v/vt/vn` or `v/vt`: from 1, or backwards from the last one so far.
fn corner(lists: &Lists, word: &str) -> std::result::Result<Corner, String> {
    let mut parts = word.split('/');
    let position = index(parts.next().unwrap_or_default(), lists.positions.len(), "vertex (v)")?;
    let Some(uv) = parts.next().filter(|text| !text.is_empty()) else {
        return Err(
            "the face has no texture coordinates, so the structure has no direction on it; unwrap the mesh and \
                    write faces as `f v/vt/vn`"
                .into(),
        );
    };
    Ok(Corner {
        position,
        uv: index(uv, lists.uvs.len(), "texture coordinate (vt)")?,
        normal: parts.next().map(|text| index(text, lists.normals.len(), "normal (vn)")).transpose()?,
    })
}

fn index(text: &str, count: usize, what: &str) -> std::result::Result<usize, String> {
    let number: i64 = text.parse().map_err(|_| format!("{:?} is not the number of a {what}", start_of(text)))?;
    let from_zero = if number < 0 { number.checked_add(count as i64) } else { number.checked_sub(1) };
    from_zero
        .and_then(|index| usize::try_from(index).ok())
        .filter(|&index| index < count)
        .ok_or_else(|| format!("the face refers to {what} {number}; {count} are listed before it"))
}
