//! Members of zip archives, each read whole up to a limit.
//!
//! Own code, since the crate `zip` brings six more for what takes a screen here: the directory at the end, and flate2 for what it
//! names. Archives beyond 4 GiB and encrypted ones are refused.

use std::io::Read;

use flate2::Crc;
use flate2::read::DeflateDecoder;

use super::binary::Binary;
use super::refusal::{Parsed, Refusal};

/// The first bytes of a zip archive.
pub(super) const MAGIC: &[u8] = b"PK\x03\x04";
/// Marks of the directory's end and of an entry in it, and bytes of both without names and comments.
const END: &[u8] = b"PK\x05\x06";
const END_BYTES: usize = 22;
const ENTRY: &[u8] = b"PK\x01\x02";
const ENTRY_BYTES: usize = 46;
/// Bytes of what precedes a member, without its name.
const LOCAL_BYTES: usize = 30;
/// Longest comment behind the directory's end.
const COMMENT_MAX: usize = 65_535;

/// An archive in memory.
pub(super) struct Archive<'a> {
    bytes: &'a [u8],
    members: Vec<Member>,
}

/// An entry of the directory.
struct Member {
    name: String,
    is_encrypted: bool,
    /// 0 as it is, 8 deflated.
    method: u16,
    checksum: u32,
    packed_bytes: usize,
    /// Of what precedes the member.
    at: usize,
}

impl<'a> Archive<'a> {
    /// Reads the directory. Its entries lie one after another in the file, so there are no more than fit into it.
    pub(super) fn new(bytes: &'a [u8]) -> Parsed<Self> {
        let binary = Binary::little(bytes);
        let earliest = bytes.len().saturating_sub(END_BYTES + COMMENT_MAX);
        let tail = &bytes[earliest..];
        let end = tail.windows(END.len()).rposition(|window| window == END);
        let end = earliest + end.ok_or_else(|| Refusal::damaged("its zip archive has no directory"))?;
        let (count, mut at) = (binary.u16(end + 10)?, binary.u32(end + 16)? as usize);
        let mut members = Vec::new();
        for _ in 0..count {
            if binary.range(at, ENTRY.len())? != ENTRY {
                return Err(Refusal::damaged("the directory of its zip archive is broken"));
            }
            let length = |place: usize| binary.u16(at + place).map(usize::from);
            let name_bytes = length(28)?;
            members.push(Member {
                name: binary.text(at + ENTRY_BYTES, name_bytes)?.replace('\\', "/"),
                is_encrypted: binary.u16(at + 8)? & 1 != 0,
                method: binary.u16(at + 10)?,
                checksum: binary.u32(at + 16)?,
                packed_bytes: binary.u32(at + 20)? as usize,
                at: binary.u32(at + 42)? as usize,
            });
            at += ENTRY_BYTES + name_bytes + length(30)? + length(32)?;
        }
        Ok(Self { bytes, members })
    }

    /// Whether a member has this name or lies in a folder of this name that ends in `/`.
    pub(super) fn has(&self, name: &str) -> bool {
        let fits = |member: &str| member == name || (name.ends_with('/') && member.starts_with(name));
        self.members.iter().any(|member| fits(&member.name))
    }

    /// Whether a member's name ends so.
    pub(super) fn has_ending(&self, ending: &str) -> bool {
        self.members.iter().any(|member| member.name.ends_with(ending))
    }

    /// A member of at most `bytes_max` bytes, whatever it claims to have.
    pub(super) fn read(&self, name: &str, bytes_max: u64) -> Parsed<Vec<u8>> {
        // Programs disagree on separators and on a leading `./`.
        let name = name.trim().replace('\\', "/");
        let name = name.trim_start_matches("./");
        let refused = |what: &str| Refusal::damaged(format!("{name:?} in its zip archive {what}"));
        let member = self.members.iter().find(|member| member.name == name).ok_or_else(|| refused("is missing"))?;
        if member.is_encrypted {
            return Err(refused("is encrypted"));
        }
        let binary = Binary::little(self.bytes);
        let local = |place: usize| binary.u16(member.at.saturating_add(place)).map(usize::from);
        let start = member.at + LOCAL_BYTES + local(26)? + local(28)?;
        let packed = binary.range(start, member.packed_bytes)?;
        let limit = bytes_max.saturating_add(1);
        let mut content = Vec::new();
        match member.method {
            0 => packed.take(limit).read_to_end(&mut content),
            8 => DeflateDecoder::new(packed).take(limit).read_to_end(&mut content),
            method => return Err(refused(&format!("is packed by method {method}, which is not known"))),
        }
        .map_err(|error| refused(&format!("cannot be unpacked: {error}")))?;
        if content.len() as u64 > bytes_max {
            return Err(refused(&format!("has more than {bytes_max} bytes")));
        }
        let mut sum = Crc::new();
        sum.update(&content);
        if sum.sum() == member.checksum {
            Ok(content)
        } else {
            Err(refused("does not have the checksum that it should"))
        }
    }
}
