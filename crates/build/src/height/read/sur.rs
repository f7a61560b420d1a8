//! Digital Surf files (.sur, .pro), the format of MountainsMap: fields of fixed width, then integers, plain or packed.

use std::io::Read;

use flate2::read::ZlibDecoder;

use super::binary::Binary;
use super::config::ReadConfig;
use super::refusal::{Parsed, Refusal};
use super::stored::{Found, Line, RawScan, SampleKind, Sourced, Stored};
use super::tiff_pixels::checked_size;
use super::unit::LengthUnit;

/// The first bytes, of plain files and of packed ones.
const PLAIN: &[u8] = b"DIGITAL SURF";
const PACKED: &[u8] = b"DSCOMPRESSED";
/// Bytes of the header.
const HEADER: usize = 512;
/// The value of samples that were not measured lies this far below the smallest.
const BELOW_LEAST: f64 = 2.0;

/// Whether a file begins like one.
pub(super) fn is_surf(bytes: &[u8]) -> bool {
    bytes.starts_with(PLAIN) || bytes.starts_with(PACKED)
}

/// Reads the surface.
pub(super) fn read(bytes: &[u8], config: &ReadConfig) -> Parsed<RawScan> {
    if config.page.is_some_and(|page| page > 0) {
        return Err(Refusal::new("a Digital Surf file is read for its first surface (page 0)", "leave the page out"));
    }
    let binary = Binary::little(bytes);
    binary.range(0, HEADER)?;
    check_kind(binary)?;
    let kind = match binary.u16(98)? {
        16 => SampleKind::I16,
        32 => SampleKind::I32,
        bits => return Err(Refusal::damaged(format!("its samples have {bits} bits, not 16 or 32"))),
    };
    let side = |at: usize| u64::try_from(binary.i32(at)?).map_err(|_| Refusal::damaged("its size is negative"));
    let sides = [side(108)?, side(112)?];
    if sides.contains(&0) {
        return Err(Refusal::damaged("its header gives no size"));
    }
    let size = checked_size(sides, config.max_samples)?;
    let data_at = HEADER + usize::from(binary.u16(334)?) + usize::from(binary.u16(336)?);
    let mut values = if bytes.starts_with(PACKED) {
        let unpacked = unpack(binary, data_at, size, kind)?;
        Binary::little(&unpacked).samples(0, size, kind)?
    } else {
        binary.samples(data_at, size, kind)?
    };
    let not_measured = f64::from(binary.i32(100)?) - BELOW_LEAST;
    if binary.u16(86)? == 1 {
        for value in values.iter_mut().filter(|value| **value == not_measured) {
            *value = f64::NAN;
        }
    }
    let mut stored = Stored::of(size, kind, values);
    // 1: heights upside down; 2: mirrored left to right besides; 3: top to bottom.
    let inversion = binary.u16(290)?;
    match inversion {
        2 => stored.flip_columns(),
        3 => stored.flip_rows(),
        _ => {}
    }
    let sign = if matches!(inversion, 1..=3) { -1.0 } else { 1.0 };
    let scale = binary.f32(128)?;
    Ok(RawScan {
        channel: Some(binary.text(164, 16)?).filter(|name| !name.is_empty()),
        numbers: Line { scale: sign * scale, offset: 0.0 },
        unit_nm: if scale.is_finite() && scale != 0.0 {
            length(&binary.text(212, 16)?, "heights")
        } else {
            Err(format!("its header's height of one count is {scale}"))
        },
        pitch_nm: pitch(binary)?,
        ..RawScan::of("Digital Surf", stored)
    })
}

/// Refuses what is not a single surface.
fn check_kind(binary: Binary) -> Parsed<()> {
    let name = match binary.u16(18)? {
        // A surface comes before its pictures and further layers.
        2 | 8 | 11 | 13 | 16 => return Ok(()),
        1 | 7 | 17 => "a profile",
        4 | 5 | 18 => "a series",
        3 | 10 | 12 => "a picture",
        6 | 9 => "a disc in polar coordinates",
        14 | 15 => "force curves",
        19 => "a spectrum",
        _ => "an object of a type that is not known",
    };
    Err(Refusal::new(
        format!("this Digital Surf file holds {name}, not a surface"),
        "export the height map as .sur or as .gsf",
    ))
}

/// The packed samples: a table of unpacked and packed lengths, then pieces that make one zlib stream together.
fn unpack(binary: Binary, at: usize, size: [u32; 2], kind: SampleKind) -> Parsed<Vec<u8>> {
    const EXPANSION_MAX: u64 = 1032;
    let needed = u64::from(size[0]) * u64::from(size[1]) * kind.bytes() as u64;
    if needed > (binary.bytes.len() as u64).saturating_mul(EXPANSION_MAX) {
        return Err(Refusal::damaged("the file is too short for its samples"));
    }
    let streams = binary.u32(at)? as usize;
    let table = streams.checked_mul(8).and_then(|length| binary.range(at + 4, length).ok());
    let table = table.ok_or_else(|| Refusal::damaged("its table of packed streams is cut short"))?;
    let packed =
        (0..streams).try_fold(0usize, |sum, entry| Ok(sum.saturating_add(binary.u32(at + 8 + 8 * entry)? as usize)))?;
    let stream = binary.range(at + 4 + table.len(), packed)?;
    let mut unpacked = Vec::with_capacity(needed as usize);
    let taken = ZlibDecoder::new(stream).take(needed).read_to_end(&mut unpacked);
    taken.map_err(|error| Refusal::damaged(format!("its samples cannot be unpacked: {error}")))?;
    Ok(unpacked)
}

fn pitch(binary: Binary) -> Parsed<Found<[f64; 2]>> {
    let units = [length(&binary.text(180, 16)?, "pixels"), length(&binary.text(196, 16)?, "pixels")];
    let steps = [binary.f32(120)?, binary.f32(124)?];
    Ok(match units {
        [Ok(x), Ok(y)] => Ok(Sourced::new([steps[0] * x.value, steps[1] * y.value], "Digital Surf header")),
        [Err(reason), _] | [_, Err(reason)] => Err(reason),
    })
}

fn length(unit: &str, what: &str) -> Found<f64> {
    // A micro sign of MS-DOS reads as this in Latin-1.
    match LengthUnit::parse(if unit == "\u{e6}m" { "um" } else { unit }) {
        Some(unit) => Ok(Sourced::new(unit.to_nm(), "Digital Surf header")),
        None => Err(format!("its header measures {what} in {unit:?}, not a length")),
    }
}
