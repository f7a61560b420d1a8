//! The bytes of a glTF file, and the arrays of vectors and indices in them.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use base64::Engine;
use base64::alphabet::STANDARD;
use base64::engine::DecodePaddingMode;
use base64::engine::general_purpose::{GeneralPurpose, GeneralPurposeConfig};
use gltf::json::accessor::{Accessor, ComponentType, Type};
use gltf::json::validation::{Checked, USize64};
use gltf::json::{Index, Root};
use percent_encoding::percent_decode_str;

use super::growing::{COORDINATE_MAX, TRIANGLES_MAX, bad, too_many, usable};
use super::opened::Opened;
use diffraction_brdf::error::Result;
use diffraction_brdf::files;

/// Most elements of one array: three indices for every triangle.
const ELEMENTS_MAX: usize = 3 * TRIANGLES_MAX;

/// Base64 with or without its padding.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &STANDARD,
    GeneralPurposeConfig::new()
        .with_decode_padding_mode(DecodePaddingMode::Indifferent)
        .with_decode_allow_trailing_bits(true),
);

/// A file with its document and the bytes it refers to.
pub struct Source {
    pub path: PathBuf,
    pub root: Root,
    pub buffers: Vec<Vec<u8>>,
}

/// Every buffer of a document; `binary` is what a binary file holds itself.
pub fn buffers(opened: &mut Opened, root: &Root, binary: Option<Cow<'_, [u8]>>) -> Result<Vec<Vec<u8>>> {
    let path = opened.path.clone();
    let mut buffers = Vec::new();
    for (index, buffer) in root.buffers.iter().enumerate() {
        let fault = |text: &str| bad(&path, format!("buffer {index}: {text}"));
        let bytes = match buffer.uri.as_deref() {
            None if index > 0 => return Err(fault("it has no address (uri)")),
            None => {
                binary.as_deref().ok_or_else(|| fault("it should be in the file itself, which holds none"))?.to_vec()
            }
            Some(uri) if uri.starts_with("data:") => {
                embedded(uri).ok_or_else(|| fault("its address holds no base64 data"))?
            }
            Some(uri) => external(opened, uri)
                .unwrap_or_else(|| Err(fault("it is not in a file beside or below the mesh; nothing else is read")))?,
        };
        let expected = buffer.byte_length.0;
        if (bytes.len() as u64) < expected {
            return Err(fault(&format!("it has {} bytes, {expected} are expected", bytes.len())));
        }
        buffers.push(bytes);
    }
    Ok(buffers)
}

/// Bytes of a file beside the document; `None` where the address leads elsewhere.
fn external(opened: &mut Opened, uri: &str) -> Option<Result<Vec<u8>>> {
    let name = percent_decode_str(uri).decode_utf8().ok()?;
    // A reference may begin in the document's own folder (RFC 3986, section 4.2): `./mesh.bin`.
    let name = name.trim_start_matches("./");
    let path = files::stays_below(name).then(|| opened.path.parent().unwrap_or(Path::new("")).join(name))?;
    Some(opened.read(&path))
}

/// Bytes of `data:...;base64,...`.
fn embedded(uri: &str) -> Option<Vec<u8>> {
    let (head, text) = uri.split_once(',')?;
    head.ends_with(";base64").then(|| BASE64.decode(text).ok())?
}

/// Where an accessor's elements are: bytes from the first one on, and the step between them.
struct Elements<'a> {
    bytes: &'a [u8],
    stride: usize,
    count: usize,
}

/// A number of bytes or elements, 0 where none is given; too large for any file where it is for this machine.
fn whole(number: Option<USize64>) -> usize {
    number.map_or(0, |number| usize::try_from(number.0).unwrap_or(usize::MAX))
}

/// The bytes of an accessor whose elements take `size` each; they are all there.
fn elements<'a>(source: &'a Source, accessor: &Accessor, size: usize, what: &str) -> Result<Elements<'a>> {
    let Source { path, root, buffers } = source;
    let fault = |text: &str| bad(path, format!("{what}: {text}"));
    if accessor.sparse.is_some() {
        return Err(fault("sparse arrays are not supported"));
    }
    let view = accessor.buffer_view.ok_or_else(|| fault("it has no bytes; compressed meshes are not supported"))?;
    let view = root.buffer_views.get(view.value()).ok_or_else(|| fault("its buffer view is missing"))?;
    let buffer = buffers.get(view.buffer.value()).ok_or_else(|| fault("its buffer is missing"))?;
    let start = whole(view.byte_offset);
    let end = start.checked_add(whole(Some(view.byte_length)));
    let bytes = end.and_then(|end| buffer.get(start..end)?.get(whole(accessor.byte_offset)..));
    let bytes = bytes.ok_or_else(|| fault("it leaves its buffer"))?;
    let stride = view.byte_stride.map_or(size, |stride| stride.0);
    if stride < size {
        return Err(fault("its elements overlap"));
    }
    let count = whole(Some(accessor.count));
    let last = count.checked_sub(1).ok_or_else(|| fault("it is empty"))?;
    let needed = last.checked_mul(stride).and_then(|bytes| bytes.checked_add(size));
    if needed.is_none_or(|needed| needed > bytes.len()) {
        return Err(fault("it leaves its buffer"));
    }
    if count > ELEMENTS_MAX {
        return Err(too_many(path, "elements in one array", ELEMENTS_MAX));
    }
    Ok(Elements { bytes, stride, count })
}

/// An accessor of the expected type, and the type of its numbers.
fn accessor<'a>(
    source: &'a Source,
    index: Index<Accessor>,
    kind: Type,
    what: &str,
) -> Result<(&'a Accessor, ComponentType)> {
    let fault = |text: &str| bad(&source.path, format!("{what}: {text}"));
    let accessor = source.root.accessors.get(index.value()).ok_or_else(|| fault("its accessor is missing"))?;
    if accessor.type_ != Checked::Valid(kind) {
        let name = |kind| serde_json::to_string(kind).unwrap_or_else(|_| "none of glTF".to_owned());
        return Err(fault(&format!(
            "its type is {}, expected is {}",
            name(&accessor.type_),
            name(&Checked::Valid(kind))
        )));
    }
    match accessor.component_type {
        Checked::Valid(component) => Ok((accessor, component.0)),
        Checked::Invalid => Err(fault("its component type is none of glTF")),
    }
}

fn unsupported(component: ComponentType) -> String {
    format!("its component type {} is not supported", component.as_gl_enum())
}

/// Vectors of floats, or of whole numbers that stand for shares of 1.
pub fn vectors<const N: usize>(source: &Source, index: Index<Accessor>, what: &str) -> Result<Vec<[f64; N]>> {
    let (accessor, component) = accessor(source, index, if N == 2 { Type::Vec2 } else { Type::Vec3 }, what)?;
    let fault = |text: String| bad(&source.path, format!("{what}: {text}"));
    let (width, read): (usize, fn(&[u8]) -> f64) = match (component, accessor.normalized) {
        (ComponentType::F32, _) => (4, |b| f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]]))),
        (ComponentType::U8, true) if N == 2 => (1, |b| f64::from(b[0]) / 255.0),
        (ComponentType::U16, true) if N == 2 => (2, |b| f64::from(u16::from_le_bytes([b[0], b[1]])) / 65_535.0),
        (component, _) => return Err(fault(unsupported(component))),
    };
    let Elements { bytes, stride, count } = elements(source, accessor, N * width, what)?;
    let vector = |k: usize| std::array::from_fn(|c| read(&bytes[k * stride + c * width..]));
    let vectors: Vec<[f64; N]> = (0..count).map(vector).collect();
    match vectors.iter().position(|v| !v.iter().all(|&c| usable(c))) {
        Some(at) => Err(fault(format!("element {at}, {:?}, is not within ±{COORDINATE_MAX:e}", vectors[at]))),
        None => Ok(vectors),
    }
}

/// Indices of vertices, each below `vertices`.
pub fn indices(source: &Source, index: Index<Accessor>, vertices: usize, what: &str) -> Result<Vec<u32>> {
    let (accessor, component) = accessor(source, index, Type::Scalar, what)?;
    let fault = |text: String| bad(&source.path, format!("{what}: {text}"));
    let (width, read): (usize, fn(&[u8]) -> u32) = match component {
        ComponentType::U8 => (1, |b| u32::from(b[0])),
        ComponentType::U16 => (2, |b| u32::from(u16::from_le_bytes([b[0], b[1]]))),
        ComponentType::U32 => (4, |b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])),
        component => return Err(fault(unsupported(component))),
    };
    let Elements { bytes, stride, count } = elements(source, accessor, width, what)?;
    let indices: Vec<u32> = (0..count).map(|k| read(&bytes[k * stride..])).collect();
    match indices.iter().find(|&&index| index as usize >= vertices) {
        Some(index) => Err(fault(format!("it refers to vertex {index}; there are {vertices}"))),
        None => Ok(indices),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_is_read_with_and_without_padding_and_anything_else_refused() {
        for text in ["Zm9vYg==", "Zm9vYg"] {
            assert_eq!(
                embedded(&format!("data:application/octet-stream;base64,{text}")).as_deref(),
                Some(&b"foob"[..])
            );
        }
        assert_eq!(embedded("data:;base64,+/+/"), Some(vec![0xfb, 0xff, 0xbf]));
        for wrong in ["data:;base64,Zm9v!", "data:;base64,Z", "data:text/plain,Zm9v", "data:;base64"] {
            assert_eq!(embedded(wrong), None, "{wrong}");
        }
    }
}
