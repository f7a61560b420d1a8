//! JPK (Bruker NanoWizard) TIFF: one channel per page, each with several calibrations ("slots").

use super::channels::{self, Channel};
use super::config::ReadConfig;
use super::directory::Directory;
use super::refusal::{Parsed, Refusal};
use super::stored::{Found, Line, RawScan, Sourced};
use super::tiff_pixels;
use super::unit::LengthUnit;

const SCAN_SIZE: [u16; 2] = [0x8042, 0x8043];
/// Angle of the fast axis in rad.
const ANGLE: u16 = 0x8044;
const REFLECT: u16 = 0x8045;
const CHANNEL: u16 = 0x8050;
const RETRACE: u16 = 0x8051;
const ALGORITHM: u16 = 0x8053;
const SLOTS: u16 = 0x8080;
const DEFAULT_SLOT: u16 = 0x8081;
/// Tags of the first slot; those of slot n lie n strides further.
const SLOT_NAME: u16 = 0x8090;
const SLOT_UNIT: u16 = 0x80A2;
const SLOT_SCALING: u16 = 0x80A3;
const SLOT_MULTIPLIER: u16 = 0x80A4;
const SLOT_OFFSET: u16 = 0x80A5;
const SLOT_STRIDE: u16 = 0x30;
/// Slots whose tags fit below 65536.
const SLOTS_MAX: u64 = 600;

/// Whether the file carries JPK's private tags.
pub(super) fn is_jpk(directories: &[Directory]) -> bool {
    SCAN_SIZE.iter().all(|&tag| directories[0].has(tag))
        && directories.iter().any(|directory| directory.has(DEFAULT_SLOT))
}

/// Reads the best height channel, or the one asked for.
pub(super) fn read(directories: &[Directory], config: &ReadConfig) -> Parsed<RawScan> {
    let channels = channels(directories)?;
    let (place, remark) = channels::choose(&channels, config)?;
    let page = channels[place].page;
    let directory = &directories[page];
    let mut stored = tiff_pixels::decode(directory, config.max_samples)?;
    // The bottom row comes first, unless the scan was mirrored.
    let reflected = number(&directories[0], REFLECT).unwrap_or(0.0) != 0.0;
    if !reflected {
        stored.flip_rows();
    }
    let pitch_nm = pitch(&directories[0], stored.size);
    let mut scan = RawScan {
        page,
        channel: Some(channels[place].name.clone()),
        pitch_nm,
        angle_deg: number(&directories[0], ANGLE).map(f64::to_degrees),
        warnings: remark.into_iter().collect(),
        ..RawScan::of("JPK TIFF", stored)
    };
    match default_slot(directory) {
        Ok((numbers, unit_nm)) => (scan.numbers, scan.unit_nm) = (numbers, unit_nm),
        Err(refusal) => scan.unit_nm = Err(refusal.what),
    }
    Ok(scan)
}

/// A number of a tag that may be left out or broken.
fn number(directory: &Directory, tag: u16) -> Option<f64> {
    directory.number(tag).ok().flatten()
}

/// The pages with a channel's name. Page 0 is the thumbnail.
fn channels(directories: &[Directory]) -> Parsed<Vec<Channel>> {
    let mut channels = Vec::new();
    for (page, directory) in directories.iter().enumerate().skip(1) {
        if let Some(name) = directory.text(CHANNEL)? {
            let direction = if number(directory, RETRACE).unwrap_or(0.0) != 0.0 { "retrace" } else { "trace" };
            let name = match derived(directory) {
                Some(made) => format!("{}, {made} ({direction})", name.trim()),
                None => format!("{} ({direction})", name.trim()),
            };
            channels.push(Channel { page, name, is_length: None });
        }
    }
    Ok(channels)
}

/// What a map of force curves made of a channel, such as its height at another force: the page then has the channel's own name too.
fn derived(directory: &Directory) -> Option<String> {
    let text = directory.text(ALGORITHM).ok()??;
    let name = text.lines().find_map(|line| line.trim().strip_prefix("algorithm.object-name.fancy-name"))?;
    Some(name.trim_start_matches([' ', ':', '=']).trim().to_owned()).filter(|name| !name.is_empty())
}

/// The line and unit of the slot that the page names as its default. Every slot leads from the stored
/// numbers straight to its unit: slots are not chained.
fn default_slot(directory: &Directory) -> Parsed<(Line, Found<f64>)> {
    let Some(wanted) = directory.text(DEFAULT_SLOT)? else {
        let reason = "its JPK page names no default calibration".to_owned();
        return Ok((Line::IDENTITY, Err(reason)));
    };
    let count = directory.unsigned(SLOTS)?.unwrap_or(0).min(SLOTS_MAX);
    for slot in 0..count as u16 {
        let tag = |first: u16| first + slot * SLOT_STRIDE;
        if directory.text(tag(SLOT_NAME))?.as_deref() != Some(wanted.as_str()) {
            continue;
        }
        let numbers = scaling(directory, tag)?;
        let unit = directory.text(tag(SLOT_UNIT))?.unwrap_or_default();
        let unit_nm = LengthUnit::parse(&unit)
            .map(|unit| Sourced::new(unit.to_nm(), format!("JPK slot {wanted:?}")))
            .ok_or_else(|| format!("its JPK slot {wanted:?} is in {unit:?}, not a length"));
        return Ok((numbers, unit_nm));
    }
    Err(Refusal::damaged(format!("its default calibration {wanted:?} is not among the page's {count} slots")))
}

fn scaling(directory: &Directory, tag: impl Fn(u16) -> u16) -> Parsed<Line> {
    let name = directory.text(tag(SLOT_SCALING))?.unwrap_or_default();
    match name.as_str() {
        "NullScaling" => Ok(Line::IDENTITY),
        "LinearScaling" => {
            let scale = directory.number(tag(SLOT_MULTIPLIER))?;
            let offset = directory.number(tag(SLOT_OFFSET))?;
            match (scale, offset) {
                (Some(scale), Some(offset)) if scale.is_finite() && scale != 0.0 && offset.is_finite() => {
                    Ok(Line { scale, offset })
                }
                _ => Err(Refusal::damaged("its JPK slot has no usable multiplier and offset")),
            }
        }
        _ => Err(Refusal::new(
            format!("its JPK slot is scaled by {name:?}, which is not known"),
            "export the channel as Gwyddion simple field (.gsf)",
        )),
    }
}

/// Scan size over samples; the tags hold the whole scan's size in metres.
fn pitch(first: &Directory, size: [usize; 2]) -> Found<[f64; 2]> {
    let mut pitch = [0.0; 2];
    for axis in 0..2 {
        let extent_m = first.number(SCAN_SIZE[axis]).map_err(|refusal| refusal.what)?.unwrap_or(f64::NAN);
        pitch[axis] = extent_m * 1e9 / size[axis] as f64;
    }
    Ok(Sourced::new(pitch, "JPK scan size"))
}
