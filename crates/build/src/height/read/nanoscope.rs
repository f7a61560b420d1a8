//! Bruker, Veeco and Digital Instruments Nanoscope files (.spm, .001 and on): a text header of lists, then integers.
//!
//! A channel's `@2:Z scale` gives the volts of its whole integer range and names the sensitivity that makes lengths of
//! volts. From version 9.2 on samples have 32 bits whatever `Bytes/pixel` says, which then tells their range alone.

use super::binary::Binary;
use super::channels::{self, Channel};
use super::config::ReadConfig;
use super::refusal::{Parsed, Refusal};
use super::stored::{Found, Line, RawScan, SampleKind, Sourced, Stored};
use super::text;
use super::tiff_pixels::checked_size;
use super::unit::LengthUnit;

/// Version from which on samples are 32 bits wide.
const WIDE_SINCE: u32 = 0x0920_0000;
/// Longest header that is looked through.
const HEADER_MAX: usize = 1 << 22;

/// Whether a file begins like one; `?*` begins those whose samples are text.
pub(super) fn is_nanoscope(bytes: &[u8]) -> bool {
    let lists: [&[u8]; 6] = [
        b"\\*File list",
        b"\\*EC File list",
        b"\\*Force file list",
        b"?*File list",
        b"?*EC File list",
        b"?*Force file list",
    ];
    lists.iter().any(|list| bytes.len() >= list.len() && bytes[..list.len()].eq_ignore_ascii_case(list))
}

/// Reads the height channel, or the one asked for.
pub(super) fn read(bytes: &[u8], config: &ReadConfig) -> Parsed<RawScan> {
    const EXPORT: &str = "save the height image itself as .spm, or export it as a Gwyddion simple field (.gsf)";
    if bytes[0] == b'?' {
        return Err(Refusal::new("this Nanoscope file holds its samples as text, which is not read", EXPORT));
    }
    let header = header_text(bytes)?;
    let lists = lists(&header);
    let mode = lists.iter().find_map(|list| list.get("operating mode")).unwrap_or("");
    let is_image = |list: &&List| list.name.ends_with("image list") && !list.name.contains("force");
    let images: Vec<&List> = lists.iter().filter(is_image).collect();
    if mode == "Force" || (images.is_empty() && lists[0].name.starts_with("force")) {
        return Err(Refusal::new("this Nanoscope file holds force curves, not an image", EXPORT));
    }
    if images.is_empty() {
        return Err(Refusal::new("this Nanoscope file holds no image", EXPORT));
    }
    let channels: Vec<_> = images
        .iter()
        .enumerate()
        .map(|(page, image)| Channel {
            page,
            name: label(image),
            is_length: Some(z_scale(image, &lists, 2).is_ok_and(|(_, unit)| unit.is_ok())),
        })
        .collect();
    let (place, remark) = channels::choose(&channels, config)?;
    let image = images[place];
    let version = lists[0].get("version").and_then(|text| u32::from_str_radix(text.trim_start_matches("0x"), 16).ok());
    let block = Block::new(image, &lists, version.unwrap_or(0))?;
    let size = checked_size(block.size, config.max_samples)?;
    let kind = if block.sample_bytes == 4 { SampleKind::I32 } else { SampleKind::I16 };
    let values = Binary::little(bytes).samples(block.at, size, kind)?;
    let mut stored = Stored::of(size, kind, values);
    // The bottom row comes first.
    stored.flip_rows();
    let (numbers, unit_nm) = match z_scale(image, &lists, block.range_bytes) {
        Ok(found) => found,
        Err(reason) => (Line::IDENTITY, Err(reason)),
    };
    Ok(RawScan {
        page: place,
        channel: Some(channels[place].name.clone()),
        numbers,
        unit_nm,
        pitch_nm: block.pitch_nm,
        angle_deg: lists
            .iter()
            .find_map(|list| list.get("rotate ang."))
            .and_then(number_and_unit)
            .map(|(angle_rad, _)| angle_rad.to_degrees()),
        warnings: remark.into_iter().collect(),
        ..RawScan::of("Nanoscope", stored)
    })
}

/// The header up to Ctrl-Z or its end mark.
fn header_text(bytes: &[u8]) -> Parsed<String> {
    let header = &bytes[..bytes.len().min(HEADER_MAX)];
    let mark: &[u8] = b"\\*File list end";
    let end = header
        .iter()
        .position(|&byte| byte == 0x1A || byte == 0)
        .or_else(|| header.windows(mark.len()).position(|window| window.eq_ignore_ascii_case(mark)))
        .ok_or_else(|| Refusal::damaged("its header has no end"))?;
    Ok(text::decode(&header[..end]))
}

/// A list of the header: `\*Name` and the lines below.
struct List<'h> {
    /// In small letters.
    name: String,
    entries: Vec<(&'h str, &'h str)>,
}

impl<'h> List<'h> {
    /// The value of a key given in small letters.
    fn get(&self, key: &str) -> Option<&'h str> {
        self.entries.iter().find(|(name, _)| name.eq_ignore_ascii_case(key)).map(|(_, value)| *value)
    }
}

/// The header's lists; there is one at least, since the file begins with one.
fn lists(header: &str) -> Vec<List<'_>> {
    let mut lists: Vec<List> = Vec::new();
    for line in header.lines().filter_map(|line| line.trim().strip_prefix('\\')) {
        if let Some(name) = line.strip_prefix('*') {
            lists.push(List { name: name.trim().to_lowercase(), entries: Vec::new() });
        } else if let (Some(list), Some((key, value))) = (lists.last_mut(), split_entry(line)) {
            list.entries.push((key, value));
        }
    }
    lists
}

/// `@2:Z scale: V [...]` in key and value: the colon of `@2:` belongs to the key.
fn split_entry(line: &str) -> Option<(&str, &str)> {
    let at = line.find(": ").or_else(|| line.strip_suffix(':').map(str::len))?;
    Some((line[..at].trim(), line[at + 1..].trim()))
}

/// `S [Height] "Height Sensor"` by the name in quotes, else that in brackets, and the scanner's direction.
fn label(image: &List) -> String {
    let data = ["@2:image data", "@3:image data", "@4:image data", "image data"]
        .iter()
        .find_map(|key| image.get(key))
        .unwrap_or("");
    let between = |open: char, close: char| {
        let (_, rest) = data.split_once(open)?;
        rest.split_once(close).map(|(name, _)| name.trim()).filter(|name| !name.is_empty())
    };
    let name = between('"', '"').or_else(|| between('[', ']')).unwrap_or(data);
    match image.get("line direction") {
        Some(direction) if !direction.is_empty() => format!("{name} ({})", direction.to_lowercase()),
        _ => name.to_owned(),
    }
}

/// A number and what follows it: `440.0 V`, `10 nm/V`.
fn number_and_unit(text: &str) -> Option<(f64, &str)> {
    let (number, unit) = text.trim().split_once(char::is_whitespace).unwrap_or((text.trim(), ""));
    Some((number.parse().ok()?, unit.trim()))
}

/// The line from samples to the channel's unit, and nm per unit. `range_bytes` is the width of the integers that the scale spans.
fn z_scale(image: &List, lists: &[List], range_bytes: u32) -> Result<(Line, Found<f64>), String> {
    let text = ["@4:z scale", "@2:z scale", "@z scale"].iter().find_map(|key| image.get(key));
    let text = text.ok_or("its header has no `@2:Z scale`")?;
    let unclear = || format!("its header's Z scale is {text:?}");
    // V [Sens. Zsens] (0.006713867 V/LSB) 440.0000 V
    let soft = text.split_once('[').and_then(|(_, rest)| rest.split_once(']')).map(|(name, _)| name.trim());
    let after = text.rsplit_once(')').or_else(|| text.rsplit_once(']')).map_or(text, |(_, rest)| rest);
    let after = after.trim().trim_start_matches("V ").trim();
    let (hard, hard_unit) = number_and_unit(after).filter(|(number, _)| number.is_finite()).ok_or_else(unclear)?;
    let counts = 256f64.powi(range_bytes as i32);
    let Some(name) = soft.filter(|name| !name.is_empty()) else {
        return Ok((Line { scale: hard / counts, offset: 0.0 }, length(hard_unit)));
    };
    let key = format!("@{name}");
    let sensitivity = lists
        .iter()
        .filter(|list| !list.name.ends_with("image list"))
        .find_map(|list| list.get(&key))
        .ok_or_else(|| format!("its header has no sensitivity {name:?}"))?;
    // V 21.5 nm/V
    let (factor, unit) = number_and_unit(sensitivity.trim().trim_start_matches("V "))
        .ok_or_else(|| format!("its header's sensitivity {name:?} is {sensitivity:?}"))?;
    let (unit, per) = unit.split_once('/').unwrap_or((unit, hard_unit));
    let prefix = volts(hard_unit).zip(volts(per)).map(|(hard, per)| hard / per).or((hard_unit == per).then_some(1.0));
    let prefix =
        prefix.ok_or_else(|| format!("its header measures in {hard_unit:?}, its sensitivity {name:?} in {per:?}"))?;
    Ok((Line { scale: hard / counts * factor * prefix, offset: 0.0 }, length(unit)))
}

/// Volts per unit of voltage.
fn volts(unit: &str) -> Option<f64> {
    match unit.trim() {
        "V" => Some(1.0),
        "mV" => Some(1e-3),
        "uV" | "\u{b5}V" => Some(1e-6),
        _ => None,
    }
}

fn length(unit: &str) -> Found<f64> {
    // `~m` is the micrometre of old code pages.
    match LengthUnit::parse(if unit == "~m" { "um" } else { unit }) {
        Some(unit) => Ok(Sourced::new(unit.to_nm(), "Nanoscope Z scale")),
        None => Err(format!("its channel is in {unit:?}, not a length")),
    }
}

/// Where an image's samples lie, and how far apart they are.
struct Block {
    size: [u64; 2],
    at: usize,
    sample_bytes: usize,
    range_bytes: u32,
    pitch_nm: Found<[f64; 2]>,
}

impl Block {
    fn new(image: &List, lists: &[List], version: u32) -> Parsed<Self> {
        let integer = |key: &str| {
            let text = image.get(key).unwrap_or("");
            text.parse::<u64>().map_err(|_| Refusal::damaged(format!("its header's {key:?} is {text:?}, not a number")))
        };
        let own = [integer("samps/line")?, integer("number of lines")?];
        let (at, length) = (integer("data offset")?, integer("data length")?);
        let range_bytes = match image.get("bytes/pixel").unwrap_or("2") {
            "2" => 2,
            "4" => 4,
            other => {
                return Err(Refusal::new(
                    format!("its samples have {other:?} bytes, which is not known"),
                    "export it as .gsf",
                ));
            }
        };
        let bytes_of = |size: [u64; 2], width: u64| size[0].saturating_mul(size[1]).saturating_mul(width);
        let is_wide = range_bytes == 4 || (version >= WIDE_SINCE && length >= bytes_of(own, 4));
        let width = if is_wide { 4 } else { 2 };
        // An image's own size may be that of another zoom; the scan's then fits its block.
        let scan = lists.iter().find(|list| list.name.contains("scan list"));
        let of_scan =
            scan.and_then(|scan| Some([scan.get("samps/line")?.parse().ok()?, scan.get("lines")?.parse().ok()?]));
        let size = match of_scan {
            Some(of_scan) if bytes_of(own, width) != length && bytes_of(of_scan, width) == length => of_scan,
            _ => own,
        };
        if size.contains(&0) || bytes_of(size, width) > length {
            return Err(Refusal::damaged(format!(
                "{} x {} samples do not fit into its block of {length} bytes",
                size[0], size[1]
            )));
        }
        Ok(Self {
            size,
            at: usize::try_from(at).map_err(|_| Refusal::damaged("its samples lie outside the file"))?,
            sample_bytes: width as usize,
            range_bytes,
            pitch_nm: pitch(image, scan, own, size),
        })
    }
}

/// Scan size over samples. The size is one number or two with a unit; `Slow axis Size` of the scan overrules the second.
fn pitch(image: &List, scan: Option<&List>, own: [u64; 2], size: [u64; 2]) -> Found<[f64; 2]> {
    let text = image.get("scan size").or_else(|| scan?.get("scan size")).ok_or("its header has no scan size")?;
    let unclear = || format!("its header's scan size is {text:?}");
    let (fast, rest) = number_and_unit(text).ok_or_else(unclear)?;
    let (slow, unit) = number_and_unit(rest).unwrap_or((fast, rest));
    let nm = |unit: &str| length(unit).map(|unit| unit.value).map_err(|_| unclear());
    let of_scan = |key: &str| number_and_unit(scan?.get(key)?);
    if let Some(((fast, fast_unit), (slow, slow_unit))) = of_scan("scan size").zip(of_scan("slow axis size")) {
        let stated = [fast * nm(fast_unit)?, slow * nm(slow_unit)?];
        let lines = scan.and_then(|scan| scan.get("lines")?.parse::<u64>().ok());
        // Stopped before its last line: the scan's size is that of all lines. An aspect ratio of its own tells that it was.
        let is_cut = image.get("aspect ratio").is_some_and(|ratio| ratio != "1:1");
        let all = lines.filter(|&lines| is_cut && size[1] < lines).unwrap_or(size[1]);
        let share = size[1] as f64 / all as f64;
        return Ok(Sourced::new(
            [stated[0] / size[0] as f64, stated[1] * share / size[1] as f64],
            "Nanoscope scan size",
        ));
    }
    // The image's size belongs to the image's own samples.
    let pitch = [fast * nm(unit)? / own[0] as f64, slow * nm(unit)? / own[1] as f64];
    Ok(Sourced::new(pitch, "Nanoscope scan size"))
}
