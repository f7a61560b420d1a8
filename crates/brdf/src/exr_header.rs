//! The head of an OpenEXR file, byte by byte: attributes in a fixed order, and a layout that can be trusted.
//!
//! Two reasons not to leave this to the library: it writes custom attributes in the random order of a hash map, and it
//! believes the sizes that a damaged file states.

/// Magic number, then version 2 without flags: one part, scan lines, names below 32 bytes.
const START: [u8; 8] = [0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0];
/// The compression code of ZIP over blocks of 16 scan lines.
const ZIP16: u8 = 3;
/// Scan lines per compressed block.
const BLOCK_LINES: usize = 16;
/// Deflate cannot expand by more than 1032 (258 bytes from 2 bits); an image larger than that is a lie.
const DEFLATE_RATIO_MAX: u64 = 1032;
/// Largest image that is read, in bytes of its stored samples.
const IMAGE_BYTES_MAX: u64 = 1 << 31;

/// Number format of the three channels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Precision {
    /// 16-bit floats.
    Half,
    /// 32-bit floats.
    Float,
}

impl Precision {
    /// Bytes per sample.
    pub fn bytes(self) -> usize {
        match self {
            Self::Half => 2,
            Self::Float => 4,
        }
    }
}

/// A reason in words; the caller adds the path.
type Checked<T> = Result<T, String>;

/// One attribute, borrowed from the file's bytes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attribute<'a> {
    /// Its name.
    pub name: &'a [u8],
    /// The name of its type.
    pub kind: &'a [u8],
    /// Its value as stored.
    pub value: &'a [u8],
    /// The three together with their terminators, as stored.
    raw: &'a [u8],
}

/// What a checked file holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layout {
    /// Row and column of the whole image at which the file's pixels begin.
    pub first: [usize; 2],
    /// Pixels along x.
    pub width: usize,
    /// Pixels along y.
    pub height: usize,
    /// Number format of the three channels.
    pub precision: Precision,
}

/// All attributes in the order of the file, and where the header ends.
pub fn attributes(bytes: &[u8]) -> Checked<(Vec<Attribute<'_>>, usize)> {
    if !bytes.starts_with(&START) {
        return Err("this is not an OpenEXR file with one part of scan lines".into());
    }
    let mut found = Vec::new();
    let mut at = START.len();
    loop {
        if *bytes.get(at).ok_or("the header has no end")? == 0 {
            return Ok((found, at + 1));
        }
        let start = at;
        let name = text_until_zero(bytes, &mut at)?;
        let kind = text_until_zero(bytes, &mut at)?;
        let size = u32_at(bytes, at)? as usize;
        let value = slice(bytes, at + 4, size)?;
        at += 4 + size;
        found.push(Attribute { name, kind, value, raw: &bytes[start..at] });
    }
}

/// Sorts the header's attributes by name, as the OpenEXR library writes them. The header keeps its length, so nothing
/// behind it moves.
pub fn sort_attributes(bytes: &mut [u8]) -> Checked<()> {
    let (mut found, end) = attributes(bytes)?;
    found.sort_by_key(|attribute| attribute.name);
    let sorted: Vec<u8> = found.iter().flat_map(|attribute| attribute.raw).copied().collect();
    bytes[START.len()..end - 1].copy_from_slice(&sorted);
    Ok(())
}

/// Value of the attribute of this name and type.
pub fn find<'a>(attributes: &[Attribute<'a>], name: &str, kind: &str) -> Checked<&'a [u8]> {
    let mut named = attributes.iter().filter(|attribute| attribute.name == name.as_bytes());
    match (named.next(), named.next()) {
        (Some(found), None) if found.kind == kind.as_bytes() => Ok(found.value),
        (Some(_), None) => Err(format!("the attribute `{name}` is not of type `{kind}`")),
        (Some(_), Some(_)) => Err(format!("the attribute `{name}` stands twice")),
        (None, _) => Err(format!("the attribute `{name}` is missing")),
    }
}

/// Checks everything that decoding relies on against the bytes that are there: size, channels, compression, and every
/// block's place, row and length. Accepts exactly what this program writes.
pub fn check(bytes: &[u8]) -> Checked<Layout> {
    let (attributes, header_end) = attributes(bytes)?;
    if find(&attributes, "compression", "compression")? != [ZIP16] {
        return Err("its compression is not ZIP over 16 lines".into());
    }
    if find(&attributes, "lineOrder", "lineOrder")? != [0] {
        return Err("its lines are not in increasing order".into());
    }
    let precision = channel_precision(find(&attributes, "channels", "chlist")?)?;
    let window = window(find(&attributes, "dataWindow", "box2i")?).ok_or("its data window is empty or negative")?;
    let display = self::window(find(&attributes, "displayWindow", "box2i")?);
    let display = display.filter(|display| display.first == [0; 2]);
    let display = display.ok_or("its display window is empty or does not start at (0, 0)")?;
    let Window { first, size: [height, width] } = window;
    // Two numbers below 2^31 each.
    if (0..2).any(|axis| first[axis] + window.size[axis] > display.size[axis]) {
        return Err("its data window reaches beyond its display window".into());
    }

    let line_bytes = width as u64 * 3 * precision.bytes() as u64;
    let image_bytes = line_bytes * height as u64;
    let possible = (bytes.len() as u64).saturating_mul(DEFLATE_RATIO_MAX).min(IMAGE_BYTES_MAX);
    if image_bytes > possible {
        return Err(format!(
            "it claims {width} x {height} pixels, {image_bytes} bytes, of which {} stored bytes can hold at most {possible}",
            bytes.len()
        ));
    }
    check_blocks(bytes, header_end, window, line_bytes as usize)?;
    Ok(Layout { first, width, height, precision })
}

/// Every block in its place, one behind the other up to the end of the file.
fn check_blocks(bytes: &[u8], header_end: usize, window: Window, line_bytes: usize) -> Checked<()> {
    let (top, height) = (window.first[0], window.size[0]);
    let blocks = height.div_ceil(BLOCK_LINES);
    let table = slice(bytes, header_end, blocks * 8).map_err(|_| "its table of blocks is cut off")?;
    let mut expected = header_end + blocks * 8;
    for (block, offset) in table.chunks_exact(8).enumerate() {
        let offset = u64::from_le_bytes(offset.try_into().expect("chunks of eight"));
        if offset != expected as u64 {
            return Err(format!("block {block} is not where it should be"));
        }
        let row = u32_at(bytes, expected)? as usize;
        let size = u32_at(bytes, expected + 4)? as usize;
        let lines = BLOCK_LINES.min(height - block * BLOCK_LINES);
        if row != top + block * BLOCK_LINES || size == 0 || size > lines * line_bytes {
            return Err(format!("block {block} states a wrong row or length"));
        }
        slice(bytes, expected + 8, size).map_err(|_| format!("block {block} is cut off"))?;
        expected += 8 + size;
    }
    if expected != bytes.len() {
        return Err(format!("{} bytes stand behind its last block", bytes.len() - expected));
    }
    Ok(())
}

/// The channels must be B, G and R, all half or all float, sampled at every pixel.
fn channel_precision(value: &[u8]) -> Checked<Precision> {
    [Precision::Half, Precision::Float]
        .into_iter()
        .find(|precision| channel_list(*precision) == value)
        .ok_or_else(|| "its channels are not R, G and B, all half or all float".to_owned())
}

/// The channel list as stored: per channel a name, the type, linearity, three reserved bytes, sampling in x and y.
fn channel_list(precision: Precision) -> Vec<u8> {
    let code = match precision {
        Precision::Half => 1,
        Precision::Float => 2,
    };
    let channel = |name: u8| [name, 0, code, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0];
    let mut list: Vec<u8> = b"BGR".iter().flat_map(|&name| channel(name)).collect();
    list.push(0);
    list
}

/// A rectangle of pixels, in rows and columns.
#[derive(Clone, Copy)]
struct Window {
    first: [usize; 2],
    size: [usize; 2],
}

/// Left, top, right and bottom, all included; `None` where it is empty or begins left of or above 0.
fn window(corners: &[u8]) -> Option<Window> {
    let corners = corners.as_chunks::<4>().0;
    let corner = |index: usize| usize::try_from(i32::from_le_bytes(*corners.get(index)?)).ok();
    let [left, top, right, bottom] = [corner(0)?, corner(1)?, corner(2)?, corner(3)?];
    let side = |first: usize, last: usize| (last + 1).checked_sub(first).filter(|&side| side > 0);
    Some(Window { first: [top, left], size: [side(top, bottom)?, side(left, right)?] })
}

fn slice(bytes: &[u8], at: usize, count: usize) -> Checked<&[u8]> {
    let end = at.checked_add(count);
    end.and_then(|end| bytes.get(at..end)).ok_or_else(|| "the file is cut off".to_owned())
}

fn u32_at(bytes: &[u8], at: usize) -> Checked<u32> {
    slice(bytes, at, 4).map(|four| u32::from_le_bytes(four.try_into().expect("four bytes")))
}

/// A name of at most 31 bytes and its terminating zero.
fn text_until_zero<'a>(bytes: &'a [u8], at: &mut usize) -> Checked<&'a [u8]> {
    let rest = &bytes[*at..];
    let length = rest.iter().take(32).position(|&byte| byte == 0);
    let length = length.ok_or("an attribute's name or type has no end")?;
    *at += length + 1;
    Ok(&rest[..length])
}
