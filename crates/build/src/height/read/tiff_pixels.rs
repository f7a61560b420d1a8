//! TIFF pixels: checks a page's layout, and decodes it.
//!
//! The page is first packed anew: a BigTIFF in memory that holds its checked layout and its compressed
//! bytes and nothing else. What would mislead the decoder never reaches it: loops, private tags, byte
//! counts that are missing, too large or beyond the file, and WhiteIsZero, which it inverts silently.

use std::borrow::Cow;
use std::io::{Cursor, Read};

use ruzstd::decoding::StreamingDecoder;
use tiff::decoder::{Decoder, DecodingResult, Limits};

use super::directory::Directory;
use super::refusal::{Parsed, Refusal};
use super::stored::{SampleKind, Stored};

/// What a page holds, by its tags.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Page {
    pub(super) size: [u64; 2],
    pub(super) content: Content,
    /// What a second number per pixel is, where there is one.
    pub(super) second: Option<Second>,
    /// 0 WhiteIsZero, 1 BlackIsZero.
    pub(super) photometric: u64,
    /// Marked as a thumbnail, a level of a pyramid or a mask.
    pub(super) preview: bool,
    /// TIFF orientation, 1 to 8.
    pub(super) orientation: u64,
}

/// What the second number of a pixel is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Second {
    /// Opacity: 0 where there is no sample.
    Mask,
    /// Another channel, of which the file says nothing.
    Channel,
}

/// Whether a page can be heights at all.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Content {
    /// One number per pixel.
    Grey(SampleKind),
    /// One number of a type that is not read: bits and sample format.
    OddGrey { bits: u64, format: u64 },
    /// Colours of a picture.
    Colour,
    /// Indices of a colour table.
    Palette,
}

impl Page {
    /// Reads the describing tags.
    pub(super) fn new(directory: &Directory) -> Parsed<Self> {
        let or = |tag: u16, default: u64| Ok(directory.unsigned(tag)?.unwrap_or(default));
        let photometric = or(262, 1)?;
        let samples = or(277, 1)?;
        let content = match photometric {
            3 => Content::Palette,
            0 | 1 if matches!(samples, 1 | 2) => grey(all_alike(directory, 258)?, all_alike(directory, 339)?),
            _ => Content::Colour,
        };
        let second = match or(338, 0)? {
            _ if samples != 2 => None,
            1 | 2 => Some(Second::Mask),
            _ => Some(Second::Channel),
        };
        let required = |tag: u16, name: &str| {
            directory
                .unsigned(tag)?
                .filter(|&number| number > 0)
                .ok_or_else(|| Refusal::damaged(format!("a page has no {name}")))
        };
        Ok(Self {
            size: [required(256, "width")?, required(257, "height")?],
            content,
            second,
            photometric,
            preview: or(254, 0)? & 0b101 != 0 || or(255, 1)? == 2,
            orientation: or(274, 1)?,
        })
    }

    /// The page in a few words, for lists in messages.
    pub(super) fn summary(&self) -> String {
        let [nx, ny] = self.size;
        let content = match self.content {
            Content::Grey(kind) => kind.name().to_owned(),
            Content::OddGrey { bits, .. } => format!("{bits}-bit grey"),
            Content::Colour => "colour picture".to_owned(),
            Content::Palette => "palette picture".to_owned(),
        };
        let mark = match (self.preview, self.second) {
            (true, _) => ", a preview",
            (false, Some(Second::Mask)) => " with a mask",
            (false, Some(Second::Channel)) => ", two channels",
            (false, None) => "",
        };
        format!("{nx} x {ny} {content}{mark}")
    }
}

/// A tag with one value for each number of a pixel, 1 by default; 0 where they differ.
fn all_alike(directory: &Directory, tag: u16) -> Parsed<u64> {
    let values = directory.unsigned_list(tag)?.unwrap_or_else(|| vec![1]);
    let first = values.first().copied().unwrap_or(0);
    Ok(if values.iter().all(|&value| value == first) { first } else { 0 })
}

fn grey(bits: u64, format: u64) -> Content {
    Content::Grey(match (bits, format) {
        (8, 1) => SampleKind::U8,
        (8, 2) => SampleKind::I8,
        (16, 1) => SampleKind::U16,
        (16, 2) => SampleKind::I16,
        (16, 3) => SampleKind::F16,
        (32, 1) => SampleKind::U32,
        (32, 2) => SampleKind::I32,
        (32, 3) => SampleKind::F32,
        (64, 3) => SampleKind::F64,
        _ => return Content::OddGrey { bits, format },
    })
}

/// A checked layout: strips are chunks as wide as the page.
struct Layout<'a> {
    size: [u32; 2],
    kind: SampleKind,
    compression: u64,
    predictor: u64,
    /// Numbers of a pixel that lie side by side, 1 or 2.
    interleaved: usize,
    tiled: bool,
    chunk_size: [u32; 2],
    chunks: Vec<Cow<'a, [u8]>>,
}

/// Decodes a grey page; rows in the file's order, numbers as stored whatever the photometric tag says. Of two numbers per pixel the
/// first is returned; where the second is a mask, NaN stands where that is 0, unless it is 0 everywhere.
pub(super) fn decode(directory: &Directory, max_samples: usize) -> Parsed<Stored> {
    let page = Page::new(directory)?;
    let planar = page.second.is_some() && directory.unsigned(284)? == Some(2);
    let first = Layout::new(directory, &page, max_samples, 0)?;
    let (size, kind) = (first.size, first.kind);
    let (mut values, mask) = match (page.second, planar) {
        (None, _) => (first.decode(directory)?, None),
        (Some(second), false) => {
            let pairs = first.decode(directory)?;
            let of = |place: usize| pairs.iter().skip(place).step_by(2).copied().collect::<Vec<_>>();
            (of(0), (second == Second::Mask).then(|| of(1)))
        }
        (Some(second), true) => {
            let values = first.decode(directory)?;
            let decode_mask = || Layout::new(directory, &page, max_samples, 1)?.decode(directory);
            (values, (second == Second::Mask).then(decode_mask).transpose()?)
        }
    };
    if let Some(mask) = mask.filter(|mask| mask.iter().any(|&opacity| opacity != 0.0)) {
        for (value, _) in values.iter_mut().zip(mask).filter(|(_, opacity)| *opacity == 0.0) {
            *value = f64::NAN;
        }
    }
    Ok(Stored::of(size, kind, values))
}

/// Widens every type that [`SampleKind`] lists; exact.
fn as_f64(result: DecodingResult) -> Option<Vec<f64>> {
    fn widen<T: Into<f64>>(values: Vec<T>) -> Vec<f64> {
        values.into_iter().map(Into::into).collect()
    }
    Some(match result {
        DecodingResult::U8(values) => widen(values),
        DecodingResult::I8(values) => widen(values),
        DecodingResult::U16(values) => widen(values),
        DecodingResult::I16(values) => widen(values),
        DecodingResult::U32(values) => widen(values),
        DecodingResult::I32(values) => widen(values),
        DecodingResult::F16(values) => widen(values),
        DecodingResult::F32(values) => widen(values),
        DecodingResult::F64(values) => values,
        DecodingResult::U64(_) | DecodingResult::I64(_) => return None,
    })
}

impl<'a> Layout<'a> {
    /// The layout of plane `plane`, where the numbers of a pixel lie in planes.
    fn new(directory: &Directory<'a>, page: &Page, max_samples: usize, plane: usize) -> Parsed<Self> {
        let kind = heights_kind(page)?;
        let size = checked_size(page.size, max_samples)?;
        let or = |tag: u16, default: u64| Ok(directory.unsigned(tag)?.unwrap_or(default));
        let compression = or(259, 1)?;
        check_compression(compression)?;
        let predictor = or(317, 1)?;
        let fits = match predictor {
            1 => true,
            // On floating-point samples, too, differences are taken of the bits as integers.
            2 => true,
            3 => kind.range().is_none(),
            _ => false,
        };
        if !fits {
            return Err(Refusal::new(
                format!("predictor {predictor} does not go with {} samples", kind.name()),
                "save the TIFF without compression",
            ));
        }
        if or(266, 1)? != 1 {
            return Err(Refusal::new(
                "its bits are stored in reverse order (FillOrder)",
                "save the TIFF again with any current program",
            ));
        }
        let tiled = directory.has(324);
        let chunk_size = if tiled {
            tile_size(directory, size)?
        } else {
            let rows = or(278, u64::from(u32::MAX))?.min(u64::from(size[1])) as u32;
            [size[0], rows]
        };
        if chunk_size.contains(&0) {
            return Err(Refusal::damaged("its strips or tiles are empty"));
        }
        let is_planar = page.second.is_some() && or(284, 1)? == 2;
        let interleaved = if page.second.is_some() && !is_planar { 2 } else { 1 };
        let mut layout =
            Self { size, kind, compression, predictor, interleaved, tiled, chunk_size, chunks: Vec::new() };
        layout.chunks = layout.find_chunks(directory, plane)?;
        if compression == ZSTANDARD {
            layout.unpack_zstandard()?;
        }
        Ok(layout)
    }

    /// The numbers of the page, those of a pixel side by side.
    fn decode(&self, directory: &Directory) -> Parsed<Vec<f64>> {
        let numbers = self.size[0] as usize * self.size[1] as usize * self.interleaved;
        let packed = self.pack(directory.file().little_endian);
        let mut limits = Limits::default();
        limits.decoding_buffer_size = numbers * self.kind.bytes();
        limits.intermediate_buffer_size = packed.len();
        let cannot_decode = |error: tiff::TiffError| Refusal::damaged(format!("its pixels cannot be decoded: {error}"));
        let mut decoder = Decoder::new(Cursor::new(packed)).map_err(cannot_decode)?.with_limits(limits);
        let values = as_f64(decoder.read_image().map_err(cannot_decode)?);
        values
            .filter(|values| values.len() == numbers)
            .ok_or_else(|| Refusal::damaged("its pixels decode to another number of samples than it claims"))
    }

    /// Decompresses what the TIFF decoder does not, each chunk to the size that it must have.
    fn unpack_zstandard(&mut self) -> Parsed<()> {
        for index in 0..self.chunks.len() {
            let damaged = || Refusal::damaged(format!("strip or tile {index} is not whole Zstandard data"));
            // No overflow: the chunk is at most `largest_expansion` times as long as its stored bytes.
            let mut decoded = vec![0; self.chunk_bytes(index) as usize];
            let mut stream = StreamingDecoder::new(self.chunks[index].as_ref()).map_err(|_| damaged())?;
            stream.read_exact(&mut decoded).map_err(|_| damaged())?;
            self.chunks[index] = Cow::Owned(decoded);
        }
        self.compression = 1;
        Ok(())
    }

    /// Decoded bytes of one chunk: tiles are stored whole, the last strip only as far as it goes.
    fn chunk_bytes(&self, index: usize) -> u64 {
        let rows = if self.tiled {
            self.chunk_size[1]
        } else {
            // `index` is below the number of strips, so this neither overflows nor gets negative.
            let above = index as u64 * u64::from(self.chunk_size[1]);
            (u64::from(self.size[1]) - above).min(u64::from(self.chunk_size[1])) as u32
        };
        u64::from(self.chunk_size[0]) * u64::from(rows) * (self.kind.bytes() * self.interleaved) as u64
    }

    /// The compressed bytes of every chunk, checked against file and decoded size.
    fn find_chunks(&self, directory: &Directory<'a>, plane: usize) -> Parsed<Vec<Cow<'a, [u8]>>> {
        let [across, down] = [0, 1].map(|axis| self.size[axis].div_ceil(self.chunk_size[axis]) as usize);
        let count = across * down;
        let (start, end) = (plane * count, (plane + 1) * count);
        let (offsets_tag, counts_tag) = if self.tiled { (324, 325) } else { (273, 279) };
        let offsets = directory.unsigned_list(offsets_tag)?.unwrap_or_default();
        let counts = directory.unsigned_list(counts_tag)?;
        if offsets.len() < end || counts.as_ref().is_some_and(|counts| counts.len() < end) {
            return Err(Refusal::damaged(format!("it needs {end} strips or tiles but lists fewer")));
        }
        let file = directory.file().bytes;
        let mut total = 0;
        let mut chunks = Vec::with_capacity(count);
        for (index, &offset) in offsets[start..end].iter().enumerate() {
            let decoded = self.chunk_bytes(index);
            let stored = match (&counts, self.compression) {
                // Some programs count bits instead of bytes: what is not needed is not looked at.
                (Some(counts), 1) => counts[start + index].min(decoded),
                (Some(counts), _) => counts[start + index],
                (None, 1) => decoded,
                (None, _) if count == 1 => (file.len() as u64).saturating_sub(offset),
                (None, _) => {
                    return Err(Refusal::damaged(
                        "it has several compressed strips and does not say how long they are",
                    ));
                }
            };
            let chunk = usize::try_from(offset)
                .ok()
                .zip(usize::try_from(stored).ok())
                .and_then(|(start, length)| file.get(start..start.checked_add(length)?))
                .ok_or_else(|| {
                    Refusal::damaged(format!(
                        "strip or tile {index} (bytes {offset} and {stored} more) lies outside the file"
                    ))
                })?;
            if decoded > stored.saturating_mul(largest_expansion(self.compression)) {
                return Err(Refusal::damaged(format!(
                    "strip or tile {index} has {stored} bytes, too few for its samples"
                )));
            }
            total += chunk.len();
            chunks.push(Cow::Borrowed(chunk));
        }
        if total > file.len() {
            return Err(Refusal::damaged("its strips or tiles overlap"));
        }
        Ok(chunks)
    }

    /// The page as a BigTIFF of its own, in the byte order of its samples.
    fn pack(&self, little_endian: bool) -> Vec<u8> {
        let bytes_of = |number: u64, size: usize| -> Vec<u8> {
            if little_endian {
                number.to_le_bytes()[..size].to_vec()
            } else {
                number.to_be_bytes()[8 - size..].to_vec()
            }
        };
        let (offsets_tag, counts_tag) = if self.tiled { (324, 325) } else { (273, 279) };
        let mut tags: Vec<(u16, u64)> = vec![
            (256, u64::from(self.size[0])),
            (257, u64::from(self.size[1])),
            (258, self.kind.bytes() as u64 * 8),
            (259, self.compression),
            (262, 1),
            (277, self.interleaved as u64),
            (317, self.predictor),
            (339, sample_format(self.kind)),
            (offsets_tag, 0),
            (counts_tag, 0),
        ];
        if self.tiled {
            tags.push((322, u64::from(self.chunk_size[0])));
            tags.push((323, u64::from(self.chunk_size[1])));
        } else {
            tags.push((278, u64::from(self.chunk_size[1])));
        }
        tags.sort_unstable();

        let count = self.chunks.len();
        // A list of one is stored in its entry; longer ones follow the directory.
        let list_size = if count == 1 { 0 } else { count * 8 };
        let lists_at = 16 + 8 + tags.len() * 20 + 8;
        let data_at = lists_at + 2 * list_size;
        let data_size: usize = self.chunks.iter().map(|chunk| chunk.len()).sum();
        let mut packed = Vec::with_capacity(data_at + data_size);
        packed.extend(if little_endian { b"II" } else { b"MM" });
        for (number, size) in [(43, 2), (8, 2), (0, 2), (16, 8), (tags.len() as u64, 8)] {
            packed.extend(bytes_of(number, size));
        }
        for (tag, value) in tags {
            let (kind, count, value) = if tag == offsets_tag && count > 1 {
                (16, count as u64, lists_at as u64)
            } else if tag == counts_tag && count > 1 {
                (16, count as u64, (lists_at + list_size) as u64)
            } else if tag == offsets_tag {
                (16, 1, data_at as u64)
            } else if tag == counts_tag {
                (16, 1, data_size as u64)
            } else if matches!(tag, 256 | 257 | 278 | 322 | 323) {
                (4, 1, value)
            } else {
                (3, 1, value)
            };
            // Of two numbers per pixel each has an entry, of the same value.
            let (count, value) = match tag {
                258 | 339 if self.interleaved == 2 => (2, (value << 16) | value),
                _ => (count, value),
            };
            packed.extend(bytes_of(u64::from(tag), 2));
            packed.extend(bytes_of(kind, 2));
            packed.extend(bytes_of(count, 8));
            // Short values stand at the front of the field.
            let width = match kind {
                3 => 2 * count as usize,
                4 => 4,
                _ => 8,
            };
            packed.extend(bytes_of(value, width));
            packed.extend(std::iter::repeat_n(0, 8 - width));
        }
        packed.extend([0; 8]);
        if count > 1 {
            let mut at = data_at as u64;
            for chunk in &self.chunks {
                packed.extend(bytes_of(at, 8));
                at += chunk.len() as u64;
            }
            for chunk in &self.chunks {
                packed.extend(bytes_of(chunk.len() as u64, 8));
            }
        }
        for chunk in &self.chunks {
            packed.extend_from_slice(chunk);
        }
        packed
    }
}

/// The TIFF sample format of a type.
fn sample_format(kind: SampleKind) -> u64 {
    match kind {
        SampleKind::U8 | SampleKind::U16 | SampleKind::U32 => 1,
        SampleKind::I8 | SampleKind::I16 | SampleKind::I32 => 2,
        SampleKind::F16 | SampleKind::F32 | SampleKind::F64 => 3,
    }
}

/// The sample type of a page that can be heights, or why it cannot.
fn heights_kind(page: &Page) -> Parsed<SampleKind> {
    const EXPORT: &str = "export the height channel itself, as a grey TIFF with 16-bit or \
                          floating-point samples or as Gwyddion simple field (.gsf)";
    match page.content {
        Content::Grey(kind) => Ok(kind),
        Content::OddGrey { bits, format } => Err(Refusal::new(
            format!("{bits}-bit samples of TIFF sample format {format} are not read as heights"),
            EXPORT,
        )),
        Content::Colour if page.photometric <= 1 => Err(Refusal::new(
            "each of its pixels holds three or more numbers, and which is the height is not said",
            EXPORT,
        )),
        Content::Colour => Err(Refusal::new(
            "this is a colour picture (a rendered figure or a photograph), not a height scan: \
             colours, rulers and legends have no heights",
            EXPORT,
        )),
        Content::Palette => Err(Refusal::new("this is a preview in palette colours, not a height scan", EXPORT)),
    }
}

/// Sides as `u32`, their product within the limit.
pub(super) fn checked_size(size: [u64; 2], max_samples: usize) -> Parsed<[u32; 2]> {
    let within = size[0].checked_mul(size[1]).is_some_and(|samples| samples <= max_samples as u64);
    match size.map(u32::try_from) {
        [Ok(nx), Ok(ny)] if within => Ok([nx, ny]),
        _ => Err(Refusal::too_large(size, max_samples)),
    }
}

fn check_compression(compression: u64) -> Parsed<()> {
    let name = match compression {
        1 | 5 | 8 | 32946 | 32773 | ZSTANDARD => return Ok(()),
        2..=4 => "fax",
        6 | 7 => "JPEG",
        34712 => "JPEG 2000",
        34925 => "LZMA",
        50001 => "WebP",
        _ => "unknown",
    };
    Err(Refusal::new(
        format!("its compression ({compression}, {name}) is not read"),
        "save the TIFF without compression, or with LZW, Deflate or Zstandard",
    ))
}

/// The number that libtiff gives to Zstandard.
const ZSTANDARD: u64 = 50000;

/// Upper bound of decoded bytes per stored byte. Deflate: 258 bytes by two 1-bit codes; PackBits: 128
/// by 2 bytes; LZW: at most 4096 bytes by 9 bits, codes growing by one byte each time; Zstandard: a block of 128 KiB by 4 bytes.
fn largest_expansion(compression: u64) -> u64 {
    match compression {
        1 => 1,
        32773 => 64,
        5 => 3641,
        ZSTANDARD => 32768,
        _ => 1032,
    }
}

/// Tile sides. A tile much larger than its page would make the decoder's work arbitrary.
fn tile_size(directory: &Directory, size: [u32; 2]) -> Parsed<[u32; 2]> {
    let side = |tag: u16, axis: usize| {
        let side = directory.unsigned(tag)?.unwrap_or(0);
        let largest = u64::from(size[axis].max(4096)).next_multiple_of(16);
        if side > largest {
            return Err(Refusal::damaged(format!(
                "its tiles are {side} samples wide or high, the page only {}",
                size[axis]
            )));
        }
        Ok(side as u32)
    };
    Ok([side(322, 0)?, side(323, 1)?])
}
