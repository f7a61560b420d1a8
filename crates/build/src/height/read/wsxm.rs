//! WSxM images (.top, .stp): an INI text with its own length, then samples from the lower right corner on.

use super::binary::Binary;
use super::config::ReadConfig;
use super::refusal::{Parsed, Refusal};
use super::stored::{Found, Line, RawScan, SampleKind, Sourced, Stored};
use super::text;
use super::tiff_pixels::checked_size;
use super::unit::LengthUnit;

/// The first bytes.
pub(super) const MAGIC: &[u8] = b"WSxM file copyright";
/// Longest header that is looked through.
const HEADER_MAX: usize = 1 << 20;

/// Reads the image.
pub(super) fn read(bytes: &[u8], config: &ReadConfig) -> Parsed<RawScan> {
    if config.page.is_some_and(|page| page > 0) {
        return Err(Refusal::new("a WSxM file holds one image (page 0)", "leave the page out"));
    }
    const END: &[u8] = b"[Header end]";
    let head = &bytes[..bytes.len().min(HEADER_MAX)];
    let end = head
        .windows(END.len())
        .position(|window| window == END)
        .ok_or_else(|| Refusal::damaged("its header has no end"))?;
    let header = text::decode(&head[..end]);
    if header.lines().nth(1).is_none_or(|line| line.trim() != "SxM Image file") {
        return Err(Refusal::new(
            "this WSxM file holds no image",
            "save the topography as .stp or .top, or export it as .gsf",
        ));
    }
    let get = |key: &str| {
        header.lines().find_map(|line| {
            let (name, value) = line.split_once(':')?;
            (name.trim() == key).then_some(value.trim())
        })
    };
    let integer = |key: &str| {
        let text = get(key).unwrap_or("");
        text.parse::<u64>().map_err(|_| Refusal::damaged(format!("its header's {key:?} is {text:?}, not a number")))
    };
    let size = checked_size([integer("Number of columns")?, integer("Number of rows")?], config.max_samples)?;
    if size.contains(&0) {
        return Err(Refusal::damaged("its header gives no size"));
    }
    let kind = match get("Image Data Type").unwrap_or("short") {
        "short" | "integer" => SampleKind::I16,
        "float" => SampleKind::F32,
        "double" => SampleKind::F64,
        other => return Err(Refusal::damaged(format!("its samples are of the type {other:?}, which is not known"))),
    };
    let needed = u64::from(size[0]) * u64::from(size[1]) * kind.bytes() as u64;
    let data_at = usize::try_from(integer("Image header size")?).ok().filter(|&at| at >= end + END.len());
    let data_at = data_at.ok_or_else(|| Refusal::damaged("its samples begin within its header"))?;
    if (bytes.len() as u64) < needed + data_at as u64 {
        return Err(Refusal::damaged(format!(
            "{} x {} samples need {needed} bytes after its header",
            size[0], size[1]
        )));
    }
    let mut stored = Stored::of(size, kind, Binary::little(bytes).samples(data_at, size, kind)?);
    stored.flip_rows();
    stored.flip_columns();
    let (numbers, unit_nm) = match heights(get("Z Amplitude"), &stored) {
        Ok((line, unit)) => (line, Ok(unit)),
        Err(reason) => (Line::IDENTITY, Err(reason)),
    };
    Ok(RawScan {
        channel: get("Acquisition channel").map(str::to_owned),
        numbers,
        unit_nm,
        pitch_nm: pitch(get("X Amplitude"), get("Y Amplitude"), size),
        angle_deg: get("Rotation").and_then(|text| amount(text).ok()).map(|(angle, _)| angle),
        ..RawScan::of("WSxM", stored)
    })
}

/// `512.0 nm` in two.
fn amount(text: &str) -> Result<(f64, &str), String> {
    let (number, unit) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    let number = number.parse().ok().filter(|number: &f64| number.is_finite());
    number
        .map(|number| (number, unit.trim()))
        .ok_or_else(|| format!("its header says {text:?}, not a number with a unit"))
}

fn length(unit: &str) -> Found<f64> {
    match LengthUnit::parse(unit) {
        Some(unit) => Ok(Sourced::new(unit.to_nm(), "WSxM header")),
        None => Err(format!("its header measures in {unit:?}, not a length")),
    }
}

/// Floating-point samples are in the unit of the amplitude; integers span it from the smallest to the largest there is.
fn heights(amplitude: Option<&str>, stored: &Stored) -> Result<(Line, Sourced<f64>), String> {
    let (amplitude, unit) = amount(amplitude.ok_or("its header has no Z Amplitude")?)?;
    let unit = length(unit)?;
    if stored.kind.range().is_none() {
        return Ok((Line::IDENTITY, unit));
    }
    let low = stored.values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = stored.values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let scale = if high > low && amplitude != 0.0 { amplitude / (high - low) } else { 1.0 };
    Ok((Line { scale, offset: 0.0 }, unit))
}

/// A missing Y amplitude is that of X.
fn pitch(x: Option<&str>, y: Option<&str>, size: [u32; 2]) -> Found<[f64; 2]> {
    let x = x.ok_or("its header has no X Amplitude")?;
    let mut pitch = [0.0; 2];
    for (axis, text) in [x, y.unwrap_or(x)].into_iter().enumerate() {
        let (extent, unit) = amount(text)?;
        pitch[axis] = extent * length(unit)?.value / f64::from(size[axis]);
    }
    Ok(Sourced::new(pitch, "WSxM header"))
}
