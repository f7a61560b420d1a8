//! TIFF directories: a bounded walk over the tags of an untrusted file.
//!
//! The pixel decoder is not asked for tags: it would list a private tag's megabytes as 32-byte values.
//! Here every value is a range inside the file.

use super::refusal::{Parsed, Refusal};
use super::text;

/// Longest text tag that is looked at, in bytes.
const TEXT_MAX: usize = 4 << 20;

/// A TIFF or BigTIFF file in memory.
#[derive(Clone, Copy)]
pub(super) struct TiffFile<'a> {
    pub(super) bytes: &'a [u8],
    pub(super) little_endian: bool,
    big: bool,
}

/// One tag: its type and the place of its value.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Entry {
    tag: u16,
    kind: u16,
    /// Start and length of the value in the file; `None` if it would lie outside.
    place: Option<(usize, usize)>,
}

/// The tags of one page, bound to their file.
#[derive(Clone)]
pub(super) struct Directory<'a> {
    file: TiffFile<'a>,
    entries: Vec<Entry>,
}

impl<'a> TiffFile<'a> {
    /// Looks at the header only; the caller has checked the magic bytes.
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        let little_endian = bytes.first() == Some(&b'I');
        let version = if little_endian { bytes.get(2) } else { bytes.get(3) };
        Self { bytes, little_endian, big: version == Some(&43) }
    }

    /// Every directory of the main chain, in order.
    pub(super) fn directories(self) -> Parsed<Vec<Directory<'a>>> {
        let mut next = if self.big {
            if self.unsigned(4, 2)? != 8 {
                return Err(Refusal::damaged("the BigTIFF header is not one"));
            }
            self.unsigned(8, 8)?
        } else {
            self.unsigned(4, 4)?
        };
        let mut directories = Vec::new();
        let mut visited = std::collections::BTreeSet::new();
        // Directories that overlap could make many tags of few bytes; honest ones do not overlap.
        let mut budget = self.bytes.len() / if self.big { 20 } else { 12 };
        while next != 0 {
            if !visited.insert(next) {
                return Err(Refusal::damaged(format!(
                    "its directories form a loop (the one at byte {next} comes round again)"
                )));
            }
            let (directory, following) = self.directory(next, &mut budget)?;
            directories.push(directory);
            next = following;
        }
        if directories.is_empty() {
            return Err(Refusal::damaged("the TIFF has no directory"));
        }
        Ok(directories)
    }

    fn directory(self, at: u64, budget: &mut usize) -> Parsed<(Directory<'a>, u64)> {
        let outside = || Refusal::damaged(format!("no complete directory at byte {at}"));
        let (count_size, entry_size, pointer_size) = if self.big { (8, 20, 8) } else { (2, 12, 4) };
        let start = usize::try_from(at).map_err(|_| outside())?;
        let count = usize::try_from(self.unsigned(start, count_size).map_err(|_| outside())?).map_err(|_| outside())?;
        *budget = budget.checked_sub(count.max(1)).ok_or_else(outside)?;
        // No overflow: the count is below the file's length, and so is the start.
        let first = start + count_size;
        let end = first + count * entry_size;
        let next = self.unsigned(end, pointer_size).map_err(|_| outside())?;
        let entries = (0..count).map(|index| self.entry(first + index * entry_size)).collect::<Parsed<Vec<_>>>()?;
        Ok((Directory { file: self, entries }, next))
    }

    fn entry(self, at: usize) -> Parsed<Entry> {
        let kind = self.unsigned(at + 2, 2)? as u16;
        let (count, inline_at, inline_size) =
            if self.big { (self.unsigned(at + 4, 8)?, at + 12, 8) } else { (self.unsigned(at + 4, 4)?, at + 8, 4) };
        let length = usize::try_from(count).ok().and_then(|count| count.checked_mul(type_size(kind)));
        let place = match length {
            Some(length) if length <= inline_size => Some((inline_at, length)),
            Some(length) => usize::try_from(self.unsigned(inline_at, inline_size)?)
                .ok()
                .filter(|start| start.checked_add(length).is_some_and(|end| end <= self.bytes.len()))
                .map(|start| (start, length)),
            None => None,
        };
        Ok(Entry { tag: self.unsigned(at, 2)? as u16, kind, place })
    }

    fn unsigned(self, at: usize, size: usize) -> Parsed<u64> {
        at.checked_add(size)
            .and_then(|end| self.bytes.get(at..end))
            .map(|bytes| self.number(bytes))
            .ok_or_else(|| Refusal::damaged(format!("the file ends before byte {at}")))
    }

    /// An unsigned number of up to 8 bytes in the file's byte order.
    fn number(self, bytes: &[u8]) -> u64 {
        let join = |sum: u64, byte: &u8| (sum << 8) | u64::from(*byte);
        if self.little_endian { bytes.iter().rev().fold(0, join) } else { bytes.iter().fold(0, join) }
    }
}

/// Bytes of one element of a TIFF field type; 0 for types that do not exist.
fn type_size(kind: u16) -> usize {
    match kind {
        1 | 2 | 6 | 7 => 1,
        3 | 8 => 2,
        4 | 9 | 11 | 13 => 4,
        5 | 10 | 12 | 16 | 17 | 18 => 8,
        _ => 0,
    }
}

impl<'a> Directory<'a> {
    /// The file this directory belongs to.
    pub(super) fn file(&self) -> TiffFile<'a> {
        self.file
    }

    pub(super) fn has(&self, tag: u16) -> bool {
        self.entries.iter().any(|entry| entry.tag == tag)
    }

    /// Type and bytes of a tag's value; `None` where the tag is absent.
    fn value(&self, tag: u16) -> Parsed<Option<(u16, &'a [u8])>> {
        let Some(entry) = self.entries.iter().find(|entry| entry.tag == tag) else {
            return Ok(None);
        };
        match entry.place {
            Some((start, length)) => Ok(Some((entry.kind, &self.file.bytes[start..start + length]))),
            None => Err(Refusal::damaged(format!("the value of tag {tag} lies outside the file"))),
        }
    }

    /// The bytes of a tag's value, whatever its type.
    pub(super) fn bytes(&self, tag: u16) -> Parsed<Option<&'a [u8]>> {
        Ok(self.value(tag)?.map(|(_, bytes)| bytes))
    }

    /// All unsigned integers of a tag, also of signed types: real files have those too.
    pub(super) fn unsigned_list(&self, tag: u16) -> Parsed<Option<Vec<u64>>> {
        let Some((kind, bytes)) = self.value(tag)? else {
            return Ok(None);
        };
        let is_signed = matches!(kind, 6 | 8 | 9 | 17);
        if !is_signed && !matches!(kind, 1 | 3 | 4 | 13 | 16 | 18) {
            return Err(wrong_type(tag, kind));
        }
        let size = type_size(kind);
        let numbers = bytes.chunks_exact(size).map(|bytes| {
            let number = self.file.number(bytes);
            let is_negative = is_signed && number >> (8 * size - 1) == 1;
            if is_negative { Err(Refusal::damaged(format!("tag {tag} is negative"))) } else { Ok(number) }
        });
        numbers.collect::<Parsed<_>>().map(Some)
    }

    /// The first unsigned integer of a tag.
    pub(super) fn unsigned(&self, tag: u16) -> Parsed<Option<u64>> {
        match self.unsigned_list(tag)? {
            None => Ok(None),
            Some(list) => match list.first() {
                Some(&number) => Ok(Some(number)),
                None => Err(Refusal::damaged(format!("tag {tag} is empty"))),
            },
        }
    }

    /// The first number of a tag, integer, fraction or float. May be NaN or infinite.
    pub(super) fn number(&self, tag: u16) -> Parsed<Option<f64>> {
        let Some((kind, bytes)) = self.value(tag)? else {
            return Ok(None);
        };
        let Some(first) = bytes.get(..type_size(kind)).filter(|first| !first.is_empty()) else {
            return Err(wrong_type(tag, kind));
        };
        let number = |bytes: &[u8]| self.file.number(bytes);
        Ok(Some(match kind {
            1 | 3 | 4 | 13 | 16 | 18 => number(first) as f64,
            6 => f64::from(number(first) as u8 as i8),
            8 => f64::from(number(first) as u16 as i16),
            9 => f64::from(number(first) as u32 as i32),
            17 => number(first) as i64 as f64,
            5 => number(&first[..4]) as f64 / number(&first[4..]) as f64,
            10 => f64::from(number(&first[..4]) as u32 as i32) / f64::from(number(&first[4..]) as u32 as i32),
            11 => f64::from(f32::from_bits(number(first) as u32)),
            12 => f64::from_bits(number(first)),
            _ => return Err(wrong_type(tag, kind)),
        }))
    }

    /// The text of a tag up to its first NUL.
    pub(super) fn text(&self, tag: u16) -> Parsed<Option<String>> {
        let Some((kind, bytes)) = self.value(tag)? else {
            return Ok(None);
        };
        if !matches!(kind, 1 | 2 | 7) {
            return Err(wrong_type(tag, kind));
        }
        if bytes.len() > TEXT_MAX {
            return Err(Refusal::new(
                format!("the text in tag {tag} has {} bytes", bytes.len()),
                format!("shorten it; up to {TEXT_MAX} are read"),
            ));
        }
        Ok(Some(text::decode(bytes)))
    }
}

fn wrong_type(tag: u16, kind: u16) -> Refusal {
    Refusal::damaged(format!("tag {tag} has an unexpected type or no value ({kind})"))
}
