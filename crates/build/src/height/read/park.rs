//! Park Systems TIFF (SmartScan, XEI): heights in a private tag behind a palette preview.

use super::binary::Binary;
use super::channels::{self, Channel, Named};
use super::config::ReadConfig;
use super::directory::Directory;
use super::refusal::{Parsed, Refusal};
use super::stored::{Line, RawScan, SampleKind, Sourced, Stored};
use super::tiff_pixels::checked_size;
use super::unit::LengthUnit;

const TAG_MAGIC: u16 = 50432;
const TAG_DATA: u16 = 50434;
const TAG_HEADER: u16 = 50435;
const MAGIC: u64 = 0x0E03_1301;
/// Bytes up to the data type, the last field read; headers of either version are longer.
const HEADER_MIN: usize = 352;

/// Whether the file carries Park's private tags.
pub(super) fn is_park(directory: &Directory) -> Parsed<bool> {
    Ok(directory.has(TAG_MAGIC)
        && directory.unsigned(TAG_MAGIC)? == Some(MAGIC)
        && directory.has(TAG_DATA)
        && directory.has(TAG_HEADER))
}

/// The header's fields that are used, little-endian and packed.
#[derive(Debug, Clone, PartialEq)]
struct Header {
    source: String,
    size: [u64; 2],
    extent_um: [f64; 2],
    gain: f64,
    z_scale: f64,
    z_offset: f64,
    z_unit: String,
    kind: SampleKind,
}

/// Reads the height map.
pub(super) fn read(directory: &Directory, config: &ReadConfig) -> Parsed<RawScan> {
    let header =
        Header::new(directory.bytes(TAG_HEADER)?.unwrap_or_default(), directory.unsigned(50433)?.unwrap_or(0))?;
    let channel = Channel { page: 0, name: header.source.clone(), is_length: None };
    let is_asked = config.page.is_some() || config.channel.is_some() || config.height.is_some();
    if !is_asked && !matches!(channels::named(&header.source), Named::Height(_)) {
        return Err(Refusal::new(
            format!("its channel is {:?}, not a height", header.source),
            format!(
                "export the height or topography channel; or, if this one is a height after all, ask for it: {}",
                config.words.channel.replace("{}", &header.source)
            ),
        ));
    }
    if config.page.is_some() || config.channel.is_some() {
        channels::choose(&[channel], config)?;
    }
    let size = checked_size(header.size, config.max_samples)?;
    let data = Binary::little(directory.bytes(TAG_DATA)?.unwrap_or_default());
    let mut stored = Stored::of(size, header.kind, data.samples(0, size, header.kind)?);
    // The bottom row comes first.
    stored.flip_rows();
    let unit_nm = LengthUnit::parse(&header.z_unit)
        .map(|unit| Sourced::new(unit.to_nm(), "Park header"))
        .ok_or_else(|| format!("its Park header's z unit is {:?}, not a length", header.z_unit));
    let pitch = [0, 1].map(|axis| header.extent_um[axis] * 1e3 / header.size[axis] as f64);
    Ok(RawScan {
        channel: Some(header.source),
        numbers: Line { scale: header.gain * header.z_scale, offset: header.gain * header.z_offset },
        unit_nm,
        pitch_nm: Ok(Sourced::new(pitch, "Park header")),
        ..RawScan::of("Park TIFF", stored)
    })
}

impl Header {
    fn new(bytes: &[u8], version: u64) -> Parsed<Self> {
        if bytes.len() < HEADER_MIN {
            return Err(Refusal::damaged(format!(
                "its Park header has {} bytes, at least {HEADER_MIN} are needed",
                bytes.len()
            )));
        }
        if integer(bytes, 0) == 1 {
            return Err(Refusal::new(
                "this Park file holds a line profile, not a height map",
                "export the topography image",
            ));
        }
        // Version 1 knows 16-bit data only.
        let kind = match (version, integer(bytes, 348)) {
            (0..=0x0100_0001, _) | (_, 0) => SampleKind::I16,
            (_, 1) => SampleKind::I32,
            (_, 2) => SampleKind::F32,
            (_, kind) => {
                return Err(Refusal::damaged(format!("its Park header names data type {kind}, which is not known")));
            }
        };
        let side = |at: usize| {
            u64::try_from(integer(bytes, at))
                .ok()
                .filter(|&side| side > 0)
                .ok_or_else(|| Refusal::damaged("its Park header gives no size"))
        };
        let z_scale = float(bytes, 228);
        let header = Self {
            source: text(&bytes[4..68]),
            size: [side(100)?, side(104)?],
            extent_um: [float(bytes, 140), float(bytes, 148)],
            gain: float(bytes, 220),
            // Zero stands for "not set".
            z_scale: if z_scale == 0.0 { 1.0 } else { z_scale },
            z_offset: float(bytes, 236),
            z_unit: text(&bytes[244..260]),
            kind,
        };
        let line = [header.gain, header.z_scale, header.z_offset];
        if line.iter().any(|number| !number.is_finite()) || header.gain == 0.0 {
            return Err(Refusal::damaged("its Park header has no usable gain, scale and offset"));
        }
        Ok(header)
    }
}

fn integer(bytes: &[u8], at: usize) -> i32 {
    let mut word = [0; 4];
    word.copy_from_slice(&bytes[at..at + 4]);
    i32::from_le_bytes(word)
}

fn float(bytes: &[u8], at: usize) -> f64 {
    let mut word = [0; 8];
    word.copy_from_slice(&bytes[at..at + 8]);
    f64::from_le_bytes(word)
}

/// UTF-16LE of fixed width, ended by NUL.
fn text(bytes: &[u8]) -> String {
    let units = bytes.chunks_exact(2).map(|pair| u16::from_le_bytes([pair[0], pair[1]])).take_while(|&unit| unit != 0);
    char::decode_utf16(units).map(|character| character.unwrap_or(char::REPLACEMENT_CHARACTER)).collect()
}
