//! Mesh files: the same square in every form, and files that lack, break or hide something.

use std::path::Path;

use diffraction_brdf::error::Result;
use diffraction_render::scene::frame::cross;
use diffraction_render::scene::mesh_file::{Model, read};
use proptest::prelude::*;

/// A unit square in two materials, facing +z.
const OBJ: &str = "# a square
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
vn 0 0 1
usemtl of no face
usemtl back
f 1/1/1 2/2/1 3/3/1
usemtl the belly
f -4/-4/-1 -2/-2/-1 -1/-1/-1
";

fn read_bytes(name: &str, bytes: &[u8]) -> Result<Model> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join(name), bytes).unwrap();
    read(&folder.path().join(name))
}

fn message(name: &str, bytes: &[u8]) -> String {
    let message = read_bytes(name, bytes).unwrap_err().to_string();
    assert!(message.contains(name), "the file is named: {message}");
    message
}

/// Positions, normals, texture coordinates (v down), indices: the square's buffer.
fn buffer() -> Vec<u8> {
    let corners = [[0f32, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let mut bytes = Vec::new();
    let mut push = |value: f32| bytes.extend(value.to_le_bytes());
    corners.iter().for_each(|c| [c[0], c[1], 0.0].into_iter().for_each(&mut push));
    corners.iter().for_each(|_| [0.0, 0.0, 1.0].into_iter().for_each(&mut push));
    corners.iter().for_each(|c| [c[0], 1.0 - c[1]].into_iter().for_each(&mut push));
    [0u16, 1, 2, 0, 2, 3].iter().for_each(|index| bytes.extend(index.to_le_bytes()));
    bytes
}

/// The square as a glTF document; `uri` is the buffer's address with its quotes, or nothing.
fn document(uri: &str) -> String {
    let uri = if uri.is_empty() { String::new() } else { format!("\"uri\": {uri}, ") };
    format!(
        r#"{{ "asset": {{ "version": "2.0" }}, "scene": 0, "scenes": [ {{ "nodes": [0] }} ],
  "nodes": [ {{ "mesh": 0 }} ],
  "meshes": [ {{ "primitives": [
    {{ "attributes": {{ "POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2 }}, "indices": 3, "material": 0 }} ] }} ],
  "materials": [ {{ "name": "back" }} ],
  "accessors": [
    {{ "bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3" }},
    {{ "bufferView": 0, "byteOffset": 48, "componentType": 5126, "count": 4, "type": "VEC3" }},
    {{ "bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2" }},
    {{ "bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR" }} ],
  "bufferViews": [
    {{ "buffer": 0, "byteLength": 96 }}, {{ "buffer": 0, "byteOffset": 96, "byteLength": 32, "byteStride": 8 }},
    {{ "buffer": 0, "byteOffset": 128, "byteLength": 12 }} ],
  "buffers": [ {{ {uri}"byteLength": 140 }} ] }}"#
    )
}

fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for group in bytes.chunks(3) {
        let bits = group.iter().fold(0u32, |bits, &byte| bits << 8 | u32::from(byte)) << (8 * (3 - group.len()));
        for digit in 0..4 {
            let value = (bits >> (18 - 6 * digit) & 63) as usize;
            text.push(if digit <= group.len() { DIGITS[value] as char } else { '=' });
        }
    }
    text
}

fn embedded() -> String {
    document(&format!("\"data:application/octet-stream;base64,{}\"", base64(&buffer())))
}

fn binary() -> Vec<u8> {
    let mut json = document("").into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let buffer = buffer();
    let mut bytes = b"glTF".to_vec();
    for word in [2, (12 + 8 + json.len() + 8 + buffer.len()) as u32, json.len() as u32, 0x4E4F_534A] {
        bytes.extend(word.to_le_bytes());
    }
    bytes.extend(json);
    bytes.extend((buffer.len() as u32).to_le_bytes());
    bytes.extend(0x004E_4942u32.to_le_bytes());
    bytes.extend(buffer);
    bytes
}

/// The square's frame, corner after corner: position, normal, tangent.
fn corners(model: &Model) -> Vec<[[f64; 3]; 3]> {
    let mesh = &model.mesh;
    let vertices = mesh.triangles.iter().flatten().map(|&v| v as usize);
    vertices.map(|v| [mesh.positions[v], mesh.normals[v], mesh.tangents[v]]).collect()
}

#[test]
fn every_form_holds_the_same_square() {
    let obj = read_bytes("a.obj", OBJ.as_bytes()).unwrap();
    assert_eq!(obj.mesh.material_names, ["back", "the belly"]);
    assert_eq!(obj.mesh.materials, [0, 1]);
    assert_eq!(obj.mesh.positions.len(), 4, "corners are shared");
    assert_eq!(obj.mesh.mirrored, [false, false]);
    assert!(obj.mesh.tangents.iter().all(|t| *t == [1.0, 0.0, 0.0]));
    assert_eq!(obj.files.len(), 1);
    let quad = OBJ.split("usemtl").next().unwrap().to_owned() + "f 1/1/1 2/2/1 3/3/1 4/4/1\n";
    let quad = read_bytes("q.obj", quad.replace('\n', "\r\n").as_bytes()).unwrap();
    assert_eq!(quad.mesh.material_names, ["default"]);

    let text = read_bytes("a.gltf", embedded().as_bytes()).unwrap();
    let binary = read_bytes("a.glb", &binary()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("a b.bin"), buffer()).unwrap();
    std::fs::write(folder.path().join("a.gltf"), document("\"a%20b.bin\"")).unwrap();
    let beside = read(&folder.path().join("a.gltf")).unwrap();
    assert_eq!(beside.files.len(), 2, "the buffer's file is an input too");
    assert_ne!(beside.files[0].1, beside.files[1].1);
    for model in [&quad, &text, &binary, &beside] {
        assert_eq!(corners(model), corners(&obj));
        assert_eq!(model.mesh.mirrored, [false, false], "v runs up in every form");
    }
    assert_eq!(text.mesh.material_names, ["back"]);
}

#[test]
fn without_normals_facets_are_flat() {
    let obj = "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 -2\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 4/3 2/2\n";
    let flat = read_bytes("a.obj", obj.as_bytes()).unwrap();
    assert_eq!(flat.mesh.normals[..3], [[0.0, 0.0, 1.0]; 3]);
    assert_eq!(flat.mesh.normals[3..], [[0.0, -1.0, 0.0]; 3]);
    let gltf = embedded().replace("\"NORMAL\": 1, ", "");
    let gltf = read_bytes("a.gltf", gltf.as_bytes()).unwrap();
    assert!(gltf.mesh.normals.iter().all(|n| *n == [0.0, 0.0, 1.0]));
}

#[test]
fn nodes_place_what_they_hold() {
    // Outer node: a quarter turn about x (y to z) and a shift; inner node: stretched, and mirrored in x.
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let nodes = format!(
        "\"nodes\": [ {{ \"rotation\": [{half}, 0, 0, {half}], \"translation\": [5, 0, 0], \"children\": [1] }}, \
         {{ \"mesh\": 0, \"matrix\": [-2,0,0,0, 0,3,0,0, 0,0,4,0, 0,0,1,1] }} ]"
    );
    let model = read_bytes("a.gltf", embedded().replace("\"nodes\": [ { \"mesh\": 0 } ]", &nodes).as_bytes()).unwrap();
    let mesh = &model.mesh;
    let close = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
    // (1, 1, 0) becomes (-2, 3, 1), then (-2, -1, 3), then (3, -1, 3).
    assert!(mesh.positions.iter().any(|&p| close(p, [3.0, -1.0, 3.0])), "{:?}", mesh.positions);
    for [_, normal, tangent] in corners(&model) {
        assert!(close(normal, [0.0, -1.0, 0.0]) && close(tangent, [-1.0, 0.0, 0.0]), "{normal:?} {tangent:?}");
        // Seen from outside, v is on the other side of u than in the file.
        assert!(close(cross(normal, tangent), [0.0, 0.0, -1.0]));
    }
    assert_eq!(mesh.mirrored, [true, true]);
}

#[test]
fn faulty_obj_files_name_the_line_and_what_is_missing() {
    for (find, replace, expected) in [
        ("f 1/1/1 2/2/1 3/3/1", "f 1 2 3", "line 13: the face has no texture coordinates"),
        ("f 1/1/1 2/2/1 3/3/1", "f 1//1 2//1 3//1", "line 13: the face has no texture coordinates"),
        ("f 1/1/1 2/2/1 3/3/1", "f 1/1/1 2/2/1", "line 13: a face needs 3 corners"),
        ("f 1/1/1 2/2/1 3/3/1", "f 1/1/1 2/2/1 9/3/1", "line 13: the face refers to vertex (v) 9; 4 are listed"),
        ("f 1/1/1 2/2/1 3/3/1", "f 1/1/1 2/2/1 0/3/1", "vertex (v) 0"),
        ("f 1/1/1 2/2/1 3/3/1", "f 1/1/1 2/2/1 -9223372036854775808/3/1", "vertex (v) -9223372036854775808"),
        ("f 1/1/1 2/2/1 3/3/1", "f 1/1/1 2/7/1 3/3/1", "texture coordinate (vt) 7"),
        ("f 1/1/1 2/2/1 3/3/1", "f 1/1/1 2/2/5 3/3/1", "normal (vn) 5"),
        ("f 1/1/1 2/2/1 3/3/1", "f a/1/1 2/2/1 3/3/1", "\"a\" is not the number of a vertex"),
        ("v 1 1 0", "v 1 nan 0", "line 4: \"nan\" is not a number"),
        ("v 1 1 0", "v 1 inf 0", "\"inf\" is not a number"),
        ("v 1 1 0", "v 1 1e10 0", "\"1e10\" is not a number within"),
        ("v 1 1 0", "v 1 1", "line 4: it must hold 3 numbers, found 2"),
        ("vn 0 0 1", "vn 0 0 0", "the zero vector"),
        ("v 1 1 0", "v 1 1 \\", "line 4: it goes on in the next line"),
        ("vt 1 1\n", "vt 0.5 0\n", "texture coordinates of triangle 0"),
    ] {
        assert_eq!(OBJ.matches(find).count(), 1, "{find}");
        let found = message("a.obj", OBJ.replace(find, replace).as_bytes());
        assert!(found.contains(expected), "{replace}: {found}");
    }
    assert!(message("a.obj", b"").contains("holds no triangles"));
    assert!(message("a.obj", b"v 0 0 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 1/1/1 1/1/1\n").contains("has an area"));
    assert!(message("a.stl", b"solid").contains(".obj, .gltf or .glb"));
}

#[test]
fn faulty_gltf_files_name_what_is_missing() {
    for (find, replace, expected) in [
        ("\"version\": \"2.0\"", "\"version\": \"1.0\"", "version of glTF is \"1.0\""),
        (", \"TEXCOORD_0\": 2", "", "mesh 0, primitive 0: it has no texture coordinates (TEXCOORD_0)"),
        ("\"POSITION\": 0, ", "", "no positions (POSITION)"),
        ("\"indices\": 3", "\"indices\": 9", "its accessor is missing"),
        ("\"indices\": 3", "\"indices\": 3, \"mode\": 1", "points or lines"),
        ("\"indices\": 3", "\"indices\": 3, \"targets\": [{}]", "morph targets"),
        ("\"material\": 0", "\"material\": 1", "it has no material 1"),
        ("{ \"mesh\": 0 }", "{ \"mesh\": 4 }", "mesh 4: it is missing"),
        ("{ \"mesh\": 0 }", "{ \"mesh\": 0, \"skin\": 0 }", "posed by a skeleton"),
        ("{ \"mesh\": 0 }", "{ \"mesh\": 0, \"children\": [0] }", "node 0 has two parents or is its own ancestor"),
        ("{ \"mesh\": 0 }", "{ \"mesh\": 0, \"children\": [1] }", "it has no node 1"),
        ("{ \"mesh\": 0 }", "{ \"mesh\": 0, \"scale\": [1e30, 1, 1] }", "transform of node 0"),
        ("{ \"mesh\": 0 }", "{ \"mesh\": 0, \"scale\": [1e300, 1, 1] }", "number out of range at line 2"),
        ("{ \"mesh\": 0 }", "{ }", "holds no triangles"),
        ("\"scene\": 0", "\"scene\": 3", "it has no scene 3"),
        ("\"scene\": 0", "\"extensionsRequired\": [\"KHR_draco_mesh_compression\"]", "KHR_draco_mesh_compression"),
        ("\"count\": 6", "\"count\": 7", "it leaves its buffer"),
        ("\"count\": 6", "\"count\": 0", "it is empty"),
        ("\"count\": 6", "\"count\": 18446744073709551615", "it leaves its buffer"),
        ("\"byteOffset\": 48", "\"byteOffset\": 49", "it leaves its buffer"),
        ("\"byteOffset\": 128", "\"byteOffset\": 18446744073709551615", "it leaves its buffer"),
        ("\"byteStride\": 8", "\"byteStride\": 4", "its elements overlap"),
        ("\"componentType\": 5123", "\"componentType\": 5126", "component type 5126"),
        ("\"type\": \"VEC2\"", "\"type\": \"VEC3\"", "its type is \"VEC3\""),
        (
            "\"type\": \"VEC2\"",
            "\"type\": \"VEC2\", \"sparse\": { \"count\": 1, \"indices\": { \"bufferView\": 0, \"componentType\": 5123 }, \"values\": { \"bufferView\": 0 } }",
            "sparse arrays are not supported",
        ),
        ("\"byteLength\": 140", "\"byteLength\": 141", "buffer 0: it has 140 bytes, 141 are expected"),
        ("data:application/octet-stream;base64,", "data:,", "no base64"),
        ("data:application/octet-stream;base64,", "https://example.org/", "beside or below the mesh"),
        ("data:application/octet-stream;base64,", "../", "beside or below the mesh"),
    ] {
        let good = embedded();
        assert_eq!(good.matches(find).count(), 1, "{find}");
        let found = message("a.gltf", good.replace(find, replace).as_bytes());
        assert!(found.contains(expected), "{replace}: {found}");
    }
    let missing = read_bytes("a.gltf", document("\"nowhere.bin\"").as_bytes()).unwrap_err().to_string();
    assert!(missing.contains("nowhere.bin: cannot read"), "{missing}");
    assert!(message("a.gltf", b"{").contains("not the JSON of glTF"));
    assert!(message("a.gltf", "[".repeat(100_000).as_bytes()).contains("not the JSON of glTF"));
    // A coordinate that is no number, and an index beyond the vertices.
    let mut bytes = binary();
    let first = bytes.len() - 140;
    bytes[first..first + 4].fill(0xff);
    assert!(message("a.glb", &bytes).contains("POSITION: element 0, [NaN, 0.0, 0.0], is not within"));
    let mut bytes = binary();
    let last = bytes.len() - 2;
    bytes[last] = 9;
    assert!(message("a.glb", &bytes).contains("it refers to vertex 9; there are 4"));
}

#[test]
fn a_binary_file_cut_anywhere_is_refused() {
    let whole = binary();
    assert!(read_bytes("a.glb", &whole).is_ok());
    for length in (0..whole.len()).step_by(7).chain([whole.len() - 1, 3, 4, 11, 12, 19, 20]) {
        assert!(read_bytes("a.glb", &whole[..length]).is_err(), "cut to {length}");
    }
}

#[test]
fn a_file_that_is_not_there_is_named() {
    assert!(read(Path::new("nowhere/a.obj")).unwrap_err().to_string().contains("nowhere/a.obj"));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    /// Whatever is read is finite and in range.
    #[test]
    fn garbled_files_are_read_or_refused(
        which in 0usize..3, at in proptest::collection::vec((0usize..4000, 0u8..=255), 1..6),
    ) {
        let (name, mut bytes) = match which {
            0 => ("a.obj", OBJ.as_bytes().to_vec()),
            1 => ("a.gltf", embedded().into_bytes()),
            _ => ("a.glb", binary()),
        };
        for (place, byte) in at {
            let place = place % bytes.len();
            bytes[place] = byte;
        }
        if let Ok(model) = read_bytes(name, &bytes) {
            let mesh = &model.mesh;
            prop_assert!(mesh.triangles.iter().flatten().all(|&v| (v as usize) < mesh.positions.len()));
            for v in mesh.positions.iter().chain(&mesh.normals).chain(&mesh.tangents) {
                prop_assert!(v.iter().all(|c| c.is_finite()));
            }
            prop_assert!(mesh.materials.iter().all(|&m| usize::from(m) < mesh.material_names.len()));
        }
    }
}

#[test]
fn a_reference_may_begin_in_the_documents_own_folder() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("ok.bin"), buffer()).unwrap();
    for uri in ["\"ok.bin\"", "\"./ok.bin\"", "\"././ok.bin\""] {
        std::fs::write(folder.path().join("square.gltf"), document(uri)).unwrap();
        assert_eq!(read(&folder.path().join("square.gltf")).unwrap().mesh.triangles.len(), 2, "{uri}");
    }
    for uri in ["\"./../ok.bin\"", "\"/ok.bin\"", "\"./\""] {
        std::fs::write(folder.path().join("square.gltf"), document(uri)).unwrap();
        assert!(read(&folder.path().join("square.gltf")).is_err(), "{uri}");
    }
}

/// No hierarchy keeps triangles in one place apart: each ray would meet them all.
#[test]
fn coincident_triangles_are_refused() {
    let face = "f 1/1/1 2/2/1 3/3/1\n";
    let few = format!("{OBJ}{}", face.repeat(60));
    assert!(read_bytes("few.obj", few.as_bytes()).is_ok());
    // The same corners in another order are the same place.
    let many = format!("{OBJ}{}{}", face.repeat(40), "f 2/2/1 3/3/1 1/1/1\n".repeat(40));
    assert!(message("many.obj", many.as_bytes()).contains("81 of its triangles lie in one place"));
}
