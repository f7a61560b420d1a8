//! glTF 2.0, as text or binary: the triangles of its default scene, where its nodes place them.
//!
//! The container and the JSON are read by the `gltf` crate, whose numbers are `f32` and whose indices keep 32 bits. Its
//! accessors are not used: they trust indices, counts and types, which are checked here before anything is taken or
//! allocated.

use std::borrow::Cow;
use std::path::Path;

use gltf::binary::{self, Glb};
use gltf::json::material::Material;
use gltf::json::mesh::{Mode, Primitive, Semantic};
use gltf::json::scene::Node;
use gltf::json::validation::Checked;
use gltf::json::{Index, Root};

use super::gltf_arrays::{Source, buffers, indices, vectors};
use super::growing::{COORDINATE_MAX, Growing, NO_MATERIAL, bad, usable};
use super::opened::Opened;
use crate::scene::frame::{add_scaled, cross};
use crate::scene::tangents::RawMesh;
use diffraction_brdf::direction::{Vec3, dot};
use diffraction_brdf::error::Result;

/// Deepest tree of nodes.
const DEPTH_MAX: usize = 128;
/// Extensions that change how a surface looks, not where it is.
const HARMLESS: [&str; 4] = ["KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_"];

/// Axes and origin of one node's coordinates in the world.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Placement {
    axes: [Vec3; 3],
    origin: Vec3,
}

const AT_HOME: Placement = Placement { axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], origin: [0.0; 3] };

/// The mesh of a glTF file, read together with the files it names.
///
/// # Errors
/// As [`read`](super::read).
pub fn parse(opened: &mut Opened, bytes: &[u8]) -> Result<RawMesh> {
    let path = opened.path.clone();
    let (json, binary) = parts(&path, bytes)?;
    let root = Root::from_slice(&json).map_err(|e| bad(&path, format!("it is not the JSON of glTF 2.0: {e}")))?;
    refuse_unsupported(&path, &root)?;
    let buffers = buffers(opened, &root, binary)?;
    let source = Source { path, root, buffers };
    let mut mesh = Growing::default();
    for (node, placement) in placed_nodes(&source)? {
        add_node(&source, &mut mesh, node, &placement)?;
    }
    Ok(mesh.raw)
}

/// Bytes of the file itself.
type Part<'a> = Cow<'a, [u8]>;

/// JSON and, of a binary file, its buffer.
fn parts<'a>(path: &Path, bytes: &'a [u8]) -> Result<(Part<'a>, Option<Part<'a>>)> {
    if !bytes.starts_with(b"glTF") {
        return Ok((bytes.into(), None));
    }
    let cut = "the binary glTF file is cut short";
    // The crate subtracts the header from this length unseen.
    let length = bytes.get(8..12).map_or(0, |word| u32::from_le_bytes([word[0], word[1], word[2], word[3]]));
    if length < 12 {
        return Err(bad(path, cut));
    }
    let glb = Glb::from_slice(bytes).map_err(|error| match error {
        gltf::Error::Binary(binary::Error::Version(version)) => {
            bad(path, format!("its version of binary glTF is {version}, this program reads 2"))
        }
        gltf::Error::Binary(binary::Error::ChunkType(_) | binary::Error::UnknownChunkType(_)) => {
            bad(path, "the parts of the binary glTF file are not in their order")
        }
        _ => bad(path, cut),
    })?;
    Ok((glb.json, glb.bin))
}

fn refuse_unsupported(path: &Path, root: &Root) -> Result<()> {
    let version = &root.asset.version;
    if !version.starts_with("2.") {
        return Err(bad(path, format!("its version of glTF is {version:?}, this program reads 2.0")));
    }
    let is_harmless = |name: &String| HARMLESS.iter().any(|known| name.starts_with(known));
    match root.extensions_required.iter().find(|name| !is_harmless(name)) {
        Some(name) => Err(bad(path, format!("it needs the extension {name:?}, which is not supported"))),
        None => Ok(()),
    }
}

/// The nodes of the default scene with their places in the world, parents first.
fn placed_nodes(source: &Source) -> Result<Vec<(&Node, Placement)>> {
    let Source { path, root, .. } = source;
    let scene = root.scene.map_or(0, |scene| scene.value());
    let first = &root.scenes.get(scene).ok_or_else(|| bad(path, format!("it has no scene {scene}")))?.nodes;
    let mut seen = vec![false; root.nodes.len()];
    let mut open: Vec<(usize, Placement, usize)> = first.iter().rev().map(|node| (node.value(), AT_HOME, 0)).collect();
    let mut placed = Vec::new();
    while let Some((index, outer, depth)) = open.pop() {
        let node = root.nodes.get(index).ok_or_else(|| bad(path, format!("it has no node {index}")))?;
        if std::mem::replace(&mut seen[index], true) {
            return Err(bad(path, format!("node {index} has two parents or is its own ancestor")));
        }
        if depth > DEPTH_MAX {
            return Err(bad(path, format!("its nodes are nested more than {DEPTH_MAX} deep")));
        }
        let placement = within(&outer, &own_placement(node));
        if !placement.axes.iter().chain([&placement.origin]).flatten().all(|&c| usable(c)) {
            return Err(bad(path, format!("the transform of node {index} is not within ±{COORDINATE_MAX:e}")));
        }
        let children = node.children.iter().flatten().rev();
        open.extend(children.map(|child| (child.value(), placement, depth + 1)));
        placed.push((node, placement));
    }
    Ok(placed)
}

fn own_placement(node: &Node) -> Placement {
    if let Some(m) = node.matrix.map(|m| m.map(f64::from)) {
        let column = |at: usize| [m[at], m[at + 1], m[at + 2]];
        return Placement { axes: [column(0), column(4), column(8)], origin: column(12) };
    }
    let quaternion = node.rotation.map_or([0.0, 0.0, 0.0, 1.0], |rotation| rotation.0.map(f64::from));
    // Of unit length but for its few digits, which must not stretch the mesh.
    let length = quaternion.iter().map(|q| q * q).sum::<f64>().sqrt();
    let [x, y, z, w] = quaternion.map(|q| q / length);
    let [a, b, c] = node.scale.map_or([1.0; 3], |scale| scale.map(f64::from));
    Placement {
        axes: [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)].map(|v| v * a),
            [2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w)].map(|v| v * b),
            [2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y)].map(|v| v * c),
        ],
        origin: node.translation.map_or([0.0; 3], |shift| shift.map(f64::from)),
    }
}

fn turned(axes: &[Vec3; 3], v: Vec3) -> Vec3 {
    add_scaled(add_scaled(axes[0].map(|c| c * v[0]), axes[1], v[1]), axes[2], v[2])
}

fn placed(placement: &Placement, v: Vec3) -> Vec3 {
    add_scaled(placement.origin, turned(&placement.axes, v), 1.0)
}

fn within(outer: &Placement, inner: &Placement) -> Placement {
    Placement { axes: inner.axes.map(|axis| turned(&outer.axes, axis)), origin: placed(outer, inner.origin) }
}

/// The axes that turn normals, and whether the placement mirrors. Cofactors keep normals perpendicular under any
/// stretching; with the determinant's sign, outwards stays outwards in a mirrored node.
fn axes_of_normals([a, b, c]: [Vec3; 3]) -> ([Vec3; 3], bool) {
    let is_mirrored = dot(cross(a, b), c) < 0.0;
    let sign = if is_mirrored { -1.0 } else { 1.0 };
    ([cross(b, c), cross(c, a), cross(a, b)].map(|axis| axis.map(|v| v * sign)), is_mirrored)
}

fn add_node(source: &Source, mesh: &mut Growing, node: &Node, placement: &Placement) -> Result<()> {
    let Some(index) = node.mesh.map(|mesh| mesh.value()) else {
        return Ok(());
    };
    let fault = |text: &str| bad(&source.path, format!("mesh {index}: {text}"));
    if node.skin.is_some() {
        return Err(fault("it is posed by a skeleton (skin), which is not supported; apply the pose"));
    }
    let found = source.root.meshes.get(index).ok_or_else(|| fault("it is missing"))?;
    for (number, primitive) in found.primitives.iter().enumerate() {
        add_primitive(source, mesh, primitive, placement, &format!("mesh {index}, primitive {number}"))?;
    }
    Ok(())
}

/// What a primitive holds, in its node's coordinates.
struct Arrays {
    positions: Vec<Vec3>,
    uvs: Vec<[f64; 2]>,
    normals: Option<Vec<Vec3>>,
    triangles: Vec<[u32; 3]>,
}

fn arrays(source: &Source, primitive: &Primitive, what: &str) -> Result<Arrays> {
    let fault = |text: &str| bad(&source.path, format!("{what}: {text}"));
    if primitive.targets.as_ref().is_some_and(|targets| !targets.is_empty()) {
        return Err(fault("it is posed by morph targets, which are not supported; apply the pose"));
    }
    let Checked::Valid(mode @ (Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan)) = primitive.mode else {
        return Err(fault("it holds points or lines, not triangles; remove it"));
    };
    let attribute = |semantic| primitive.attributes.get(&Checked::Valid(semantic)).copied();
    let position = attribute(Semantic::Positions).ok_or_else(|| fault("it has no positions (POSITION)"))?;
    let uv = attribute(Semantic::TexCoords(0)).ok_or_else(|| {
        fault("it has no texture coordinates (TEXCOORD_0), so the structure has no direction on it; unwrap the mesh")
    })?;
    let positions = vectors::<3>(source, position, &format!("{what}, POSITION"))?;
    let uvs = vectors::<2>(source, uv, &format!("{what}, TEXCOORD_0"))?;
    let normals = attribute(Semantic::Normals)
        .map(|normal| vectors::<3>(source, normal, &format!("{what}, NORMAL")))
        .transpose()?;
    if uvs.len() != positions.len() || normals.as_ref().is_some_and(|normals| normals.len() != positions.len()) {
        return Err(fault("its attributes differ in number"));
    }
    let corners = match primitive.indices {
        Some(index) => indices(source, index, positions.len(), &format!("{what}, indices"))?,
        None => (0..positions.len() as u32).collect(),
    };
    Ok(Arrays { positions, uvs, normals, triangles: triangles(&corners, mode) })
}

fn add_primitive(
    source: &Source,
    mesh: &mut Growing,
    primitive: &Primitive,
    placement: &Placement,
    what: &str,
) -> Result<()> {
    let path = &source.path;
    let Arrays { positions, uvs, normals, triangles } = arrays(source, primitive, what)?;
    let (normal_axes, is_mirrored) = axes_of_normals(placement.axes);
    let vertex = |mesh: &mut Growing, index: u32| {
        let index = index as usize;
        let position = placed(placement, positions[index]);
        if !position.iter().all(|&c| usable(c)) {
            return Err(bad(path, format!("{what}: vertex {index} is not within ±{COORDINATE_MAX:e}")));
        }
        let normal = normals.as_ref().map_or([0.0; 3], |normals| turned(&normal_axes, normals[index]));
        // In glTF v runs down the picture.
        mesh.vertex(path, position, normal, [uvs[index][0], 1.0 - uvs[index][1]])
    };
    let material = mesh.material(path, &material_name(source, primitive.material)?)?;
    let ordered = |[a, b, c]: [u32; 3]| if is_mirrored { [a, c, b] } else { [a, b, c] };
    if normals.is_none() {
        // Flat facets, as the format says: their corners are shared with nobody.
        for triangle in triangles {
            let [a, b, c] = ordered(triangle).map(|index| vertex(mesh, index));
            mesh.triangle(path, [a?, b?, c?], material)?;
        }
        return Ok(());
    }
    let first = mesh.raw.positions.len() as u32;
    for index in 0..positions.len() as u32 {
        vertex(mesh, index)?;
    }
    for triangle in triangles {
        mesh.triangle(path, ordered(triangle).map(|index| first + index), material)?;
    }
    Ok(())
}

/// Triangles of a list, a strip or a fan.
fn triangles(corners: &[u32], mode: Mode) -> Vec<[u32; 3]> {
    match mode {
        Mode::TriangleStrip => {
            let steps = corners.windows(3).enumerate();
            steps.map(|(k, w)| if k % 2 == 0 { [w[0], w[1], w[2]] } else { [w[1], w[0], w[2]] }).collect()
        }
        Mode::TriangleFan => {
            corners.get(1..).unwrap_or_default().windows(2).map(|w| [corners[0], w[0], w[1]]).collect()
        }
        _ => corners.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect(),
    }
}

fn material_name(source: &Source, material: Option<Index<Material>>) -> Result<String> {
    let Some(index) = material.map(|material| material.value()) else {
        return Ok(NO_MATERIAL.to_owned());
    };
    let material = source.root.materials.get(index);
    let material = material.ok_or_else(|| bad(&source.path, format!("it has no material {index}")))?;
    Ok(material.name.clone().unwrap_or_else(|| format!("material_{index}")))
}
