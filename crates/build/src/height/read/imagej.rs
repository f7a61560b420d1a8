//! Calibration in ImageJ's manner: the description's keys, the resolution tags, the image's own info text.

use super::config::ReadConfig;
use super::directory::Directory;
use super::free_text;
use super::refusal::{Parsed, Refusal};
use super::stored::{Found, Line, RawScan, SampleKind, Sourced};
use super::unit::LengthUnit;
use super::unit::unescape;

/// The keys of an ImageJ description that bear on calibration.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Description {
    unit: Option<String>,
    yunit: Option<String>,
    vunit: Option<String>,
    cf: Option<String>,
    c0: Option<String>,
    c1: Option<String>,
    images: Option<String>,
}

/// Reads a description; `None` if it is not ImageJ's.
pub(super) fn parse(text: &str) -> Option<Description> {
    if !text.starts_with("ImageJ=") {
        return None;
    }
    let mut keys = Description::default();
    for (key, value) in text.lines().filter_map(|line| line.split_once('=')) {
        let slot = match key.trim() {
            "unit" => &mut keys.unit,
            "yunit" => &mut keys.yunit,
            "vunit" => &mut keys.vunit,
            "cf" => &mut keys.cf,
            "c0" => &mut keys.c0,
            "c1" => &mut keys.c1,
            "images" => &mut keys.images,
            // min and max are display limits, spacing and zunit belong to slices: no heights.
            _ => continue,
        };
        *slot = Some(unescape(value.trim()));
    }
    Some(keys)
}

/// Refuses to choose from a stack whose images have no directory each, as ImageJ saves very large ones.
pub(super) fn check_stack(keys: &Description, directories: usize, config: &ReadConfig) -> Parsed<()> {
    let images: Option<usize> = keys.images.as_deref().and_then(|text| text.parse().ok());
    match images {
        Some(images) if images > directories && config.page.is_none() => Err(Refusal::new(
            format!("a stack of {images} images of which only {directories} can be told apart"),
            format!("save the scan alone, or read the first image: {}", config.words.page.replace("{}", "0")),
        )),
        _ => Ok(()),
    }
}

/// Fills in what ImageJ knows of the scan. `first` is the directory with the description.
pub(super) fn apply(scan: &mut RawScan, keys: &Description, first: &Directory) -> Parsed<()> {
    scan.pitch_nm = pitch(keys, first, &mut scan.warnings)?;
    apply_line(scan, keys)?;
    scan.unit_nm = unit(scan, keys, first)?;
    Ok(())
}

/// Pixel sizes are one over the resolution, in the description's unit.
fn pitch(keys: &Description, first: &Directory, warnings: &mut Vec<String>) -> Parsed<Found<[f64; 2]>> {
    let Some(unit_x) = &keys.unit else {
        return free_text::pitch_from_resolution(first);
    };
    let unit_y = keys.yunit.as_ref().unwrap_or(unit_x);
    let (Some(x), Some(y)) = (LengthUnit::parse(unit_x), LengthUnit::parse(unit_y)) else {
        return Ok(Err(format!(
            "its ImageJ description measures pixels in {unit_x:?} and {unit_y:?}, not both lengths"
        )));
    };
    let [Some(per_unit_x), Some(per_unit_y)] = [first.number(282)?, first.number(283)?] else {
        return Ok(Err("it has no resolution tags".to_owned()));
    };
    // ImageJ reads micrometres beside ResolutionUnit cm as pixels per cm.
    let per_cm = first.unsigned(296)? == Some(3);
    let mut quirk = false;
    let mut meant = |unit: LengthUnit| {
        let is_cm = per_cm && unit == LengthUnit::Um;
        quirk |= is_cm;
        if is_cm { LengthUnit::Cm } else { unit }
    };
    let pitch = [meant(x).to_nm() / per_unit_x, meant(y).to_nm() / per_unit_y];
    if quirk {
        warnings.push("unit micrometre beside ResolutionUnit cm: read as pixels per cm, as ImageJ does".to_owned());
    }
    if pitch.iter().all(|pitch| pitch.is_finite() && *pitch > 0.0) {
        Ok(Ok(Sourced::new(pitch, "ImageJ description")))
    } else {
        Ok(Err("its resolution tags are not positive numbers".to_owned()))
    }
}

/// The calibration line of integer samples, and ImageJ's mark for signed 16-bit ones.
fn apply_line(scan: &mut RawScan, keys: &Description) -> Parsed<()> {
    let is_short = matches!(scan.stored.kind, SampleKind::U8 | SampleKind::U16);
    let straight = keys.cf.as_deref() == Some("0");
    if !is_short || !straight {
        return Ok(());
    }
    let number = |key: &str, text: &Option<String>| {
        let text = text.as_deref().unwrap_or("");
        text.parse::<f64>().ok().filter(|number| number.is_finite()).ok_or_else(|| {
            Refusal::damaged(format!("its ImageJ description has a calibration line but {key} is {text:?}"))
        })
    };
    let offset = number("c0", &keys.c0)?;
    let scale = number("c1", &keys.c1)?;
    if scan.stored.kind == SampleKind::U16 && offset == -32768.0 && scale == 1.0 {
        scan.stored.kind = SampleKind::I16;
        for value in &mut scan.stored.values {
            *value -= 32768.0;
        }
    } else {
        scan.numbers = Line { scale, offset };
    }
    Ok(())
}

/// The unit of the values: `vunit`, or a line of the info text.
fn unit(scan: &RawScan, keys: &Description, first: &Directory) -> Parsed<Found<f64>> {
    let kind = scan.stored.kind;
    let integer = kind.range().is_some();
    if integer && keys.cf.as_deref().is_some_and(|cf| cf != "0") {
        return Ok(Err(format!(
            "its ImageJ calibration function is number {}, not a straight line",
            keys.cf.as_deref().unwrap_or("")
        )));
    }
    if integer && keys.cf.is_none() {
        return Ok(Err(format!(
            "its ImageJ description has no calibration line (cf, c0, c1) for {} samples; min and \
             max are display limits",
            kind.name()
        )));
    }
    if let Some(vunit) = &keys.vunit {
        return Ok(match LengthUnit::parse(vunit) {
            Some(unit) => Ok(Sourced::new(unit.to_nm(), "ImageJ description")),
            None => Err(format!("its ImageJ value unit is {vunit:?}, not a length")),
        });
    }
    Ok(info_text(first)?
        .and_then(|info| free_text::height_unit(&info, "ImageJ info text"))
        .unwrap_or_else(|| Err("its ImageJ description has no value unit (vunit)".to_owned())))
}

/// The "Info" property in ImageJ's own metadata tags, 50838 (byte counts) and 50839 (blocks).
///
/// The first block is a header: the magic "IJIJ", then pairs of a block type and a number of blocks,
/// all 32-bit numbers in the file's byte order. Text is UTF-16 in the same order.
fn info_text(directory: &Directory) -> Parsed<Option<String>> {
    let (Some(sizes), Some(blocks)) = (directory.unsigned_list(50838)?, directory.bytes(50839)?) else {
        return Ok(None);
    };
    let little_endian = directory.file().little_endian;
    let word = |bytes: &[u8]| match *bytes {
        [a, b, c, d] if little_endian => u32::from_le_bytes([a, b, c, d]),
        [a, b, c, d] => u32::from_be_bytes([a, b, c, d]),
        _ => 0,
    };
    let damaged = || Refusal::damaged("its ImageJ metadata tags do not fit together");
    let mut start = 0usize;
    let mut pieces = Vec::with_capacity(sizes.len());
    for size in sizes {
        let end = usize::try_from(size).ok().and_then(|size| start.checked_add(size)).ok_or_else(damaged)?;
        pieces.push(blocks.get(start..end).ok_or_else(damaged)?);
        start = end;
    }
    let Some((header, pieces)) = pieces.split_first() else {
        return Ok(None);
    };
    let header: Vec<u32> = header.chunks_exact(4).map(word).collect();
    if header.first() != Some(&u32::from_be_bytes(*b"IJIJ")) {
        return Err(damaged());
    }
    let mut index = 0usize;
    for pair in header[1..].chunks_exact(2) {
        if pair[0] == u32::from_be_bytes(*b"info") && pair[1] > 0 {
            let piece = pieces.get(index).ok_or_else(damaged)?;
            let units = piece.chunks_exact(2).map(|pair| {
                if little_endian {
                    u16::from_le_bytes([pair[0], pair[1]])
                } else {
                    u16::from_be_bytes([pair[0], pair[1]])
                }
            });
            let text =
                char::decode_utf16(units).map(|character| character.unwrap_or(char::REPLACEMENT_CHARACTER)).collect();
            return Ok(Some(text));
        }
        index = index.saturating_add(pair[1] as usize);
    }
    Ok(None)
}
