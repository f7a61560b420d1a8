//! KTX 2.0 containers of uncompressed floats: a texture with its format, size, layers and levels in one file that engines load.
//!
//! Written from the specification (Khronos, KTX File Format 2.0) and the Khronos Data Format Specification 1.3; the crate `ktx2` reads
//! such files and writes none, and the test asks it. Nothing is compressed: float tables of many digits give a few per cent.

/// Number format of a texture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Format {
    /// Four 16-bit floats.
    Rgba16f,
    /// Four 32-bit floats.
    Rgba32f,
    /// One 32-bit float.
    R32f,
}

impl Format {
    /// Its usual name.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Rgba16f => "RGBA16F",
            Self::Rgba32f => "RGBA32F",
            Self::R32f => "R32F",
        }
    }

    /// Bytes of a channel, and channels.
    fn channels(self) -> [usize; 2] {
        match self {
            Self::Rgba16f => [2, 4],
            Self::Rgba32f => [4, 4],
            Self::R32f => [4, 1],
        }
    }

    /// Bytes of a texel.
    pub(crate) fn texel_bytes(self) -> usize {
        self.channels().into_iter().product()
    }

    /// `VK_FORMAT_R16G16B16A16_SFLOAT`, `VK_FORMAT_R32G32B32A32_SFLOAT`, `VK_FORMAT_R32_SFLOAT`.
    fn vulkan(self) -> u32 {
        match self {
            Self::Rgba16f => 97,
            Self::Rgba32f => 109,
            Self::R32f => 100,
        }
    }
}

/// A level of a texture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Level {
    /// Number of rows and columns.
    pub(crate) size: [usize; 2],
    /// All layers, each row by row, without padding.
    pub(crate) bytes: Vec<u8>,
}

const IDENTIFIER: [u8; 12] = *b"\xABKTX 20\xBB\r\n\x1A\n";
/// Identifier, header, and the index of what follows the levels' own.
const HEADER_BYTES: usize = 80;
/// An entry of the index of levels.
const LEVEL_BYTES: usize = 24;

/// The container of a texture: levels from the finest to the coarsest; `layers` of an array, none of a plain texture. Rows come from
/// the top (`KTXorientation` is `rd`).
pub(crate) fn ktx2(format: Format, layers: Option<usize>, levels: &[Level]) -> Vec<u8> {
    let (descriptor, about) = (data_format(format), key_values());
    let after_levels = HEADER_BYTES + LEVEL_BYTES * levels.len();
    let about_at = after_levels + descriptor.len();
    // Coarser levels first, each at a multiple of its texel.
    let (mut offsets, mut end) = (vec![0; levels.len()], about_at + about.len());
    for (level, offset) in levels.iter().zip(&mut offsets).rev() {
        *offset = end.next_multiple_of(format.texel_bytes());
        end = *offset + level.bytes.len();
    }
    let [rows, columns] = levels[0].size;
    let mut out = Vec::with_capacity(end);
    out.extend(IDENTIFIER);
    let word = |out: &mut Vec<u8>, value: usize| out.extend((value as u32).to_le_bytes());
    let long = |out: &mut Vec<u8>, value: usize| out.extend((value as u64).to_le_bytes());
    // Format, bytes of a number, width, height, depth, layers, faces, levels, no compression.
    out.extend(format.vulkan().to_le_bytes());
    for value in [format.channels()[0], columns, rows, 0, layers.unwrap_or(0), 1, levels.len(), 0] {
        word(&mut out, value);
    }
    [after_levels, descriptor.len(), about_at, about.len()].into_iter().for_each(|value| word(&mut out, value));
    // No data of a compression.
    [0, 0].into_iter().for_each(|value| long(&mut out, value));
    for (level, offset) in levels.iter().zip(&offsets) {
        [*offset, level.bytes.len(), level.bytes.len()].into_iter().for_each(|value| long(&mut out, value));
    }
    out.extend(descriptor);
    out.extend(about);
    for (level, offset) in levels.iter().zip(&offsets).rev() {
        out.resize(*offset, 0);
        out.extend(&level.bytes);
    }
    out
}

/// The Basic Data Format Descriptor: linear numbers that are no colours.
fn data_format(format: Format) -> Vec<u8> {
    let [bytes, channels] = format.channels();
    let block = 24 + 16 * channels;
    let mut out = Vec::with_capacity(4 + block);
    out.extend((4 + block as u32).to_le_bytes());
    // Khronos's basic descriptor, version 2.
    out.extend(0u32.to_le_bytes());
    out.extend([2, 0]);
    out.extend((block as u16).to_le_bytes());
    // Model RGBSDA, unspecified primaries, linear, straight alpha; blocks of one texel, all in the first plane.
    out.extend([1, 0, 1, 0]);
    out.extend([0; 4]);
    out.extend([format.texel_bytes() as u8, 0, 0, 0, 0, 0, 0, 0]);
    for (channel, id) in [0u8, 1, 2, 15].into_iter().take(channels).enumerate() {
        let bits = 8 * bytes;
        out.extend(((channel * bits) as u16).to_le_bytes());
        // Bits less one; a signed float.
        out.extend([bits as u8 - 1, 0xC0 | id]);
        out.extend([0; 4]);
        [-1f32, 1.0].into_iter().for_each(|bound| out.extend(bound.to_le_bytes()));
    }
    out
}

/// Keys with their values, each ended by a zero and padded to four bytes.
fn key_values() -> Vec<u8> {
    let writer = concat!("diffraction-atlas ", env!("CARGO_PKG_VERSION"));
    let mut out = Vec::new();
    for (key, value) in [("KTXorientation", "rd"), ("KTXwriter", writer)] {
        let length = key.len() + value.len() + 2;
        out.extend((length as u32).to_le_bytes());
        [key, value].into_iter().for_each(|text| out.extend(text.bytes().chain([0])));
        out.resize(out.len().next_multiple_of(4), 0);
    }
    out
}
