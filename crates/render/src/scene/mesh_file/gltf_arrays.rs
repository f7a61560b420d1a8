//! The bytes of a glTF file, and the arrays of vectors and indices in them.

use std::path::Path;

use super::gltf_document::{Accessor, Document};
use super::growing::{COORDINATE_MAX, TRIANGLES_MAX, bad, too_many, usable};
use super::opened::Opened;
use diffraction_brdf::error::Result;
use diffraction_brdf::files;

/// Most elements of one array: three indices for every triangle.
const ELEMENTS_MAX: usize = 3 * TRIANGLES_MAX;

/// A file with its document and the bytes it refers to.
pub struct Source {
    pub path: std::path::PathBuf,
    pub document: Document,
    pub buffers: Vec<Vec<u8>>,
}

/// Every buffer of a document; `binary` is what a binary file holds itself.
pub fn buffers(opened: &mut Opened, document: &Document, binary: Option<&[u8]>) -> Result<Vec<Vec<u8>>> {
    let path = opened.path.clone();
    let mut buffers = Vec::new();
    for (index, buffer) in document.buffers.iter().enumerate() {
        let fault = |text: &str| bad(&path, format!("buffer {index}: {text}"));
        let bytes = match buffer.uri.as_deref() {
            None if index > 0 => return Err(fault("it has no address (uri)")),
            None => binary.ok_or_else(|| fault("it should be in the file itself, which holds none"))?.to_vec(),
            Some(uri) if uri.starts_with("data:") => {
                embedded(uri).ok_or_else(|| fault("its address holds no base64 data"))?
            }
            Some(uri) => external(opened, uri)
                .unwrap_or_else(|| Err(fault("it is not in a file beside or below the mesh; nothing else is read")))?,
        };
        if bytes.len() < buffer.byte_length {
            return Err(fault(&format!("it has {} bytes, {} are expected", bytes.len(), buffer.byte_length)));
        }
        buffers.push(bytes);
    }
    Ok(buffers)
}

/// Bytes of a file beside the document; `None` where the address leads elsewhere.
fn external(opened: &mut Opened, uri: &str) -> Option<Result<Vec<u8>>> {
    let name = percent_decoded(uri).filter(|name| files::stays_below(name))?;
    let path = opened.path.parent().unwrap_or(Path::new("")).join(name);
    Some(opened.read(&path))
}

/// Bytes of `data:...;base64,...`.
fn embedded(uri: &str) -> Option<Vec<u8>> {
    let (head, text) = uri.split_once(',')?;
    let text = head.ends_with(";base64").then(|| text.trim_end_matches('=').as_bytes())?;
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3 + 3);
    for group in text.chunks(4) {
        let mut bits = 0u32;
        for &character in group {
            let value = match character {
                b'A'..=b'Z' => character - b'A',
                b'a'..=b'z' => character - b'a' + 26,
                b'0'..=b'9' => character - b'0' + 52,
                b'+' => 62,
                b'/' => 63,
                _ => return None,
            };
            bits = bits << 6 | u32::from(value);
        }
        // 2, 3 or 4 characters hold 1, 2 or 3 bytes; a single one holds none.
        if group.len() < 2 {
            return None;
        }
        bits <<= 6 * (4 - group.len());
        bytes.extend_from_slice(&bits.to_be_bytes()[1..group.len()]);
    }
    Some(bytes)
}

/// A relative address with `%20` and the like resolved.
fn percent_decoded(uri: &str) -> Option<String> {
    let mut bytes = Vec::new();
    let mut rest = uri.as_bytes();
    while let Some((&first, after)) = rest.split_first() {
        rest = after;
        if first == b'%' {
            let digits = std::str::from_utf8(rest.get(..2)?).ok()?;
            bytes.push(u8::from_str_radix(digits, 16).ok()?);
            rest = &rest[2..];
        } else {
            bytes.push(first);
        }
    }
    String::from_utf8(bytes).ok()
}

/// Where an accessor's elements are: bytes from the first one on, and the step between them.
struct Elements<'a> {
    bytes: &'a [u8],
    stride: usize,
    count: usize,
}

/// The bytes of an accessor whose elements take `size` each; they are all there.
fn elements<'a>(source: &'a Source, accessor: &Accessor, size: usize, what: &str) -> Result<Elements<'a>> {
    let Source { path, document, buffers } = source;
    let fault = |text: &str| bad(path, format!("{what}: {text}"));
    if accessor.sparse.is_some() {
        return Err(fault("sparse arrays are not supported"));
    }
    let view = accessor.buffer_view.ok_or_else(|| fault("it has no bytes; compressed meshes are not supported"))?;
    let view = document.buffer_views.get(view).ok_or_else(|| fault("its buffer view is missing"))?;
    let buffer = buffers.get(view.buffer).ok_or_else(|| fault("its buffer is missing"))?;
    let end = view.byte_offset.checked_add(view.byte_length);
    let bytes = end.and_then(|end| buffer.get(view.byte_offset..end)?.get(accessor.byte_offset..));
    let bytes = bytes.ok_or_else(|| fault("it leaves its buffer"))?;
    let stride = view.byte_stride.unwrap_or(size);
    if stride < size {
        return Err(fault("its elements overlap"));
    }
    let last = accessor.count.checked_sub(1).ok_or_else(|| fault("it is empty"))?;
    let needed = last.checked_mul(stride).and_then(|bytes| bytes.checked_add(size));
    if needed.is_none_or(|needed| needed > bytes.len()) {
        return Err(fault("it leaves its buffer"));
    }
    if accessor.count > ELEMENTS_MAX {
        return Err(too_many(path, "elements in one array", ELEMENTS_MAX));
    }
    Ok(Elements { bytes, stride, count: accessor.count })
}

/// An accessor of the expected type.
fn accessor<'a>(source: &'a Source, index: usize, kind: &str, what: &str) -> Result<&'a Accessor> {
    let fault = |text: &str| bad(&source.path, format!("{what}: {text}"));
    let accessor = source.document.accessors.get(index).ok_or_else(|| fault("its accessor is missing"))?;
    if accessor.kind != kind {
        return Err(fault(&format!("its type is {:?}, expected is {kind:?}", accessor.kind)));
    }
    Ok(accessor)
}

/// Vectors of floats, or of whole numbers that stand for shares of 1.
pub fn vectors<const N: usize>(source: &Source, index: usize, what: &str) -> Result<Vec<[f64; N]>> {
    let accessor = accessor(source, index, &format!("VEC{N}"), what)?;
    let fault = |text: String| bad(&source.path, format!("{what}: {text}"));
    let (width, read): (usize, fn(&[u8]) -> f64) = match (accessor.component_type, accessor.normalized) {
        (5126, _) => (4, |b| f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]]))),
        (5121, true) if N == 2 => (1, |b| f64::from(b[0]) / 255.0),
        (5123, true) if N == 2 => (2, |b| f64::from(u16::from_le_bytes([b[0], b[1]])) / 65_535.0),
        (component, _) => return Err(fault(format!("its component type {component} is not supported"))),
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
pub fn indices(source: &Source, index: usize, vertices: usize, what: &str) -> Result<Vec<u32>> {
    let accessor = accessor(source, index, "SCALAR", what)?;
    let fault = |text: String| bad(&source.path, format!("{what}: {text}"));
    let (width, read): (usize, fn(&[u8]) -> u32) = match accessor.component_type {
        5121 => (1, |b| u32::from(b[0])),
        5123 => (2, |b| u32::from(u16::from_le_bytes([b[0], b[1]]))),
        5125 => (4, |b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])),
        component => return Err(fault(format!("its component type {component} is not supported"))),
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
    fn base64_of_every_length_is_decoded_and_anything_else_refused() {
        // RFC 4648, section 10.
        for (text, bytes) in
            [("", ""), ("Zg==", "f"), ("Zm8=", "fo"), ("Zm9v", "foo"), ("Zm9vYmE=", "fooba"), ("Zm9vYmFy", "foobar")]
        {
            assert_eq!(
                embedded(&format!("data:application/octet-stream;base64,{text}")).as_deref(),
                Some(bytes.as_bytes())
            );
        }
        assert_eq!(embedded("data:;base64,+/+/"), Some(vec![0xfb, 0xff, 0xbf]));
        for wrong in ["data:;base64,Zm9v!", "data:;base64,Z", "data:text/plain,Zm9v", "data:;base64"] {
            assert_eq!(embedded(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn escapes_in_addresses_are_resolved() {
        assert_eq!(percent_decoded("my%20body%2B.bin").as_deref(), Some("my body+.bin"));
        for wrong in ["%", "%2", "%zz", "%ff"] {
            assert_eq!(percent_decoded(wrong), None, "{wrong}");
        }
    }
}
