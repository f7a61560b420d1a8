//! Nanosurf files (.nid, .ezd): an INI text of data sets, then their integers one after another.

use super::binary::Binary;
use super::channels::{self, Channel};
use super::config::ReadConfig;
use super::refusal::{Parsed, Refusal};
use super::stored::{Found, Line, RawScan, SampleKind, Sourced, Stored};
use super::text;
use super::tiff_pixels::checked_size;
use super::unit::LengthUnit;

/// The first bytes.
pub(super) const MAGIC: &[u8] = b"[DataSet]";
/// Longest header that is looked through.
const HEADER_MAX: usize = 1 << 22;

/// Reads the height channel, or the one asked for.
pub(super) fn read(bytes: &[u8], config: &ReadConfig) -> Parsed<RawScan> {
    let head = &bytes[..bytes.len().min(HEADER_MAX)];
    let end = head
        .windows(3)
        .position(|window| window == b"\n#!")
        .ok_or_else(|| Refusal::damaged("its header has no end, or its samples are missing"))?;
    let header = text::decode(&head[..end]);
    let sections = sections(&header);
    let sets = data_sets(&sections, end + 3)?;
    let channels: Vec<_> = sets
        .iter()
        .enumerate()
        .map(|(page, set)| Channel {
            page,
            name: set.label(),
            is_length: Some(set.is_image() && LengthUnit::parse(set.section.get("Dim2Unit").unwrap_or("")).is_some()),
        })
        .collect();
    let (place, remark) = channels::choose(&channels, config)?;
    let set = &sets[place];
    let size = checked_size(set.size, config.max_samples)?;
    let binary = Binary { bytes, little_endian: set.little_endian };
    let mut stored = Stored::of(size, set.kind, binary.samples(set.at, size, set.kind)?);
    // The bottom row comes first.
    stored.flip_rows();
    let info = sections.iter().find(|section| section.name == "DataSet-Info");
    let angle =
        info.and_then(|info| info.get("Rotation")).and_then(|text| text.split_whitespace().next()?.parse().ok());
    let (numbers, unit_nm) = match set.scale() {
        Ok((line, unit)) => (line, Ok(unit)),
        Err(reason) => (Line::IDENTITY, Err(reason)),
    };
    Ok(RawScan {
        page: place,
        channel: Some(channels[place].name.clone()),
        numbers,
        unit_nm,
        pitch_nm: set.pitch(),
        angle_deg: angle,
        warnings: remark.into_iter().collect(),
        ..RawScan::of("Nanosurf", stored)
    })
}

/// A section of the header.
struct Section<'h> {
    name: &'h str,
    entries: Vec<(&'h str, &'h str)>,
}

impl<'h> Section<'h> {
    fn get(&self, key: &str) -> Option<&'h str> {
        self.entries.iter().find(|(name, _)| *name == key).map(|(_, value)| value.trim())
    }
}

fn sections(header: &str) -> Vec<Section<'_>> {
    let mut sections: Vec<Section> = Vec::new();
    for line in header.lines().map(str::trim) {
        if let Some(name) = line.strip_prefix('[').and_then(|line| line.strip_suffix(']')) {
            sections.push(Section { name, entries: Vec::new() });
        } else if let (Some(section), Some(entry)) = (sections.last_mut(), line.split_once('=')) {
            section.entries.push(entry);
        }
    }
    sections
}

/// One data set and where its samples begin.
struct DataSet<'s, 'h> {
    section: &'s Section<'h>,
    size: [u64; 2],
    kind: SampleKind,
    little_endian: bool,
    at: usize,
}

/// The data sets in the order of groups and channels, which is that of their samples.
fn data_sets<'s, 'h>(sections: &'s [Section<'h>], mut at: usize) -> Parsed<Vec<DataSet<'s, 'h>>> {
    /// More groups or channels than any microscope has.
    const COUNT_MAX: usize = 1000;
    let named = |name: &str| sections.iter().find(|section| section.name == name);
    let top = named("DataSet").ok_or_else(|| Refusal::damaged("its header has no list of data sets"))?;
    let count = |key: &str| top.get(key).and_then(|text| text.parse().ok()).unwrap_or(0).min(COUNT_MAX);
    let mut sets = Vec::new();
    for group in 0..count("GroupCount") {
        for channel in 0..count(&format!("Gr{group}-Count")) {
            let Some(section) = top.get(&format!("Gr{group}-Ch{channel}")).and_then(named) else { continue };
            let set = DataSet::new(section, at)?;
            let bytes = set.size[0].saturating_mul(set.size[1]).saturating_mul(set.kind.bytes() as u64);
            at = usize::try_from(bytes)
                .ok()
                .and_then(|bytes| at.checked_add(bytes))
                .ok_or_else(|| Refusal::damaged(format!("{} claims more samples than any file holds", section.name)))?;
            sets.push(set);
        }
    }
    Ok(sets)
}

impl<'s, 'h> DataSet<'s, 'h> {
    fn new(section: &'s Section<'h>, at: usize) -> Parsed<Self> {
        let get = |key: &str| section.get(key).unwrap_or("");
        let side = |key: &str| {
            get(key)
                .parse::<u64>()
                .map_err(|_| Refusal::damaged(format!("{} in {} is {:?}", key, section.name, get(key))))
        };
        let kind = match (get("SaveMode"), get("SaveBits"), get("SaveSign")) {
            ("Binary", "8", "Signed") => SampleKind::I8,
            ("Binary", "16", "Signed") => SampleKind::I16,
            ("Binary", "32", "Signed") => SampleKind::I32,
            ("Binary", "8", _) => SampleKind::U8,
            ("Binary", "16", _) => SampleKind::U16,
            ("Binary", "32", _) => SampleKind::U32,
            (mode, bits, _) => {
                return Err(Refusal::new(
                    format!("its samples are stored as {mode:?} with {bits:?} bits, which is not known"),
                    "export the height channel from Nanosurf's software or from Gwyddion as .gsf",
                ));
            }
        };
        let size = [side("Points")?, side("Lines")?];
        Ok(Self { section, size, kind, little_endian: get("SaveOrder") != "Motorola", at })
    }

    /// Whether it is of a scan, not of spectra, whose frames are called otherwise.
    fn is_image(&self) -> bool {
        self.size[1] > 1 && self.section.get("Frame").unwrap_or("").to_lowercase().contains("scan")
    }

    /// `Z-Axis (forward)`.
    fn label(&self) -> String {
        let (name, frame) = (self.section.get("Dim2Name").unwrap_or(""), self.section.get("Frame").unwrap_or(""));
        let frame = frame.replace("Scan ", "").replace("scan ", "");
        if frame.is_empty() { name.to_owned() } else { format!("{name} ({frame})") }
    }

    fn number(&self, key: &str) -> Result<f64, String> {
        let text = self.section.get(key).unwrap_or("");
        text.parse().map_err(|_| format!("{key} of {} is {text:?}, not a number", self.section.name))
    }

    fn length(&self, key: &str) -> Found<f64> {
        let unit = self.section.get(key).unwrap_or("");
        match LengthUnit::parse(unit) {
            Some(unit) => Ok(Sourced::new(unit.to_nm(), "Nanosurf data set")),
            None => Err(format!("{key} of {} is {unit:?}, not a length", self.section.name)),
        }
    }

    /// The whole range of the integer type spans `Dim2Range` from `Dim2Min` on.
    fn scale(&self) -> Result<(Line, Sourced<f64>), String> {
        let (span, least) = (self.number("Dim2Range")?, self.number("Dim2Min")?);
        let [low, _] = self.kind.range().unwrap_or([0.0, 0.0]);
        let scale = span / 256f64.powi(self.kind.bytes() as i32);
        if !(scale.is_finite() && scale != 0.0 && least.is_finite()) {
            return Err(format!("the range of {} is {span}", self.section.name));
        }
        Ok((Line { scale, offset: least - low * scale }, self.length("Dim2Unit")?))
    }

    fn pitch(&self) -> Found<[f64; 2]> {
        let side = |axis: usize| {
            let extent = self.number(&format!("Dim{axis}Range"))? * self.length(&format!("Dim{axis}Unit"))?.value;
            Ok::<f64, String>(extent / self.size[axis] as f64)
        };
        Ok(Sourced::new([side(0)?, side(1)?], "Nanosurf data set"))
    }
}
