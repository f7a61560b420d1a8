//! Igor binary waves (.ibw), as Asylum Research's microscopes write them: a stack of images, named by dimension labels.
//!
//! Sizes and offsets are those of WaveMetrics' Technical Note 3: versions 2 and 5, either byte order.

use super::binary::Binary;
use super::channels::{self, Channel};
use super::config::ReadConfig;
use super::refusal::{Parsed, Refusal};
use super::stored::{Found, RawScan, SampleKind, Sourced, Stored};
use super::text;
use super::tiff_pixels::checked_size;
use super::unit::LengthUnit;

/// Bytes of one dimension label with its NULs.
const LABEL: usize = 32;
/// Longest note that is looked at.
const NOTE_MAX: usize = 1 << 22;

/// Byte order by the version number, which is small; `None` for no wave.
pub(super) fn byte_order(bytes: &[u8]) -> Option<bool> {
    match *bytes {
        [1 | 2 | 3 | 5, 0, ..] if bytes.len() >= 64 => Some(true),
        [0, 1 | 2 | 3 | 5, ..] if bytes.len() >= 64 => Some(false),
        _ => None,
    }
    .filter(|&little_endian| is_consistent(Binary { bytes, little_endian }))
}

/// Two bytes are not enough to know a format by: the 16-bit words of the headers add up to 0, or, where a program got that sum wrong,
/// the number of points is the product of the sides, or fits the size of all.
fn is_consistent(binary: Binary) -> bool {
    let product = || {
        let sides = [68, 72, 76, 80].map(|at| binary.u32(64 + at).unwrap_or(0));
        sides.into_iter().take_while(|&side| side > 0).try_fold(1u32, |product, side| product.checked_mul(side))
    };
    if binary.u16(0) == Ok(5) && binary.u32(64 + 12).is_ok_and(|points| points > 0 && product() == Some(points)) {
        return true;
    }
    let fits = |points: u32, kind: u16| {
        let bytes = sample_kind(kind).map_or(0, SampleKind::bytes) as u64 * u64::from(points);
        binary.u32(2).is_ok_and(|all| bytes > 0 && u64::from(all) == 110 + bytes + 16)
    };
    if binary.u16(0) == Ok(2)
        && binary.u32(16 + 42).is_ok_and(|points| binary.u16(16).is_ok_and(|kind| fits(points, kind)))
    {
        return true;
    }
    let length = match binary.u16(0) {
        Ok(1) => 8 + 110,
        Ok(2) => 16 + 110,
        Ok(3) => 20 + 110,
        _ => 64 + 320,
    };
    let sum = (0..length / 2).try_fold(0u16, |sum, word| binary.u16(2 * word).map(|word| sum.wrapping_add(word)));
    sum == Ok(0)
}

/// Reads the height channel, or the one asked for.
pub(super) fn read(bytes: &[u8], little_endian: bool, config: &ReadConfig) -> Parsed<RawScan> {
    let binary = Binary { bytes, little_endian };
    let wave = match binary.u16(0)? {
        2 => Wave::version_2(binary)?,
        5 => Wave::version_5(binary)?,
        version => {
            return Err(Refusal::new(
                format!("Igor binary waves of version {version} are not read"),
                "open and save it with Igor Pro 6 or newer, or save the image from Gwyddion as .gsf",
            ));
        }
    };
    let kind = sample_kind(wave.sample_type).ok_or_else(|| {
        Refusal::new(
            format!(
                "Igor waves of number type {:#x} (text, complex or unknown) are not read as heights",
                wave.sample_type
            ),
            "export the height channel",
        )
    })?;
    let [nx, ny, layers] = wave.size;
    if nx == 0 || ny == 0 {
        return Err(Refusal::new("this Igor wave holds a curve, not an image", "export the height image"));
    }
    let size = checked_size([nx.into(), ny.into()], config.max_samples)?;
    // No overflow: the samples of one layer have been counted, and layers are 32-bit.
    let layer_bytes = u64::from(nx) * u64::from(ny) * kind.bytes() as u64;
    if u128::from(layer_bytes) * u128::from(layers) > bytes.len() as u128 {
        return Err(Refusal::damaged(format!("{layers} layers of {nx} x {ny} samples do not fit into the file")));
    }
    let layer_at = |page: usize| wave.data_at + layer_bytes as usize * page;
    let channels: Vec<_> = (0..layers.max(1) as usize)
        .map(|page| {
            let name = wave.labels.get(page).cloned().unwrap_or_default();
            let in_metres = wave.unit(&name).and_then(|unit| LengthUnit::parse(&unit)).map(|unit| unit.to_nm() * 1e-9);
            let is_length = in_metres.is_some_and(|metres| is_believable(binary, layer_at(page), size, kind, metres));
            Channel { page, name, is_length: Some(is_length) }
        })
        .collect();
    let (place, remark) = channels::choose(&channels, config)?;
    let mut stored = Stored::of(size, kind, binary.samples(layer_at(place), size, kind)?);
    // The bottom row comes first.
    stored.flip_rows();
    let name = &channels[place].name;
    Ok(RawScan {
        page: place,
        channel: Some(name.clone()).filter(|name| !name.is_empty()),
        unit_nm: length(&wave.unit(name).unwrap_or_default(), "values"),
        pitch_nm: wave.pitch(),
        angle_deg: wave.note("ScanAngle").and_then(|text| text.parse().ok()),
        warnings: remark.into_iter().collect(),
        ..RawScan::of("Igor binary wave", stored)
    })
}

/// Whether a layer's numbers can be heights under a microscope: sensors that were never calibrated stand there in volts, which nothing
/// in the file says.
fn is_believable(binary: Binary, at: usize, size: [u32; 2], kind: SampleKind, metres: f64) -> bool {
    const LARGEST_M: f64 = 1e-3;
    let values = binary.samples(at, size, kind).unwrap_or_default();
    values.iter().filter(|value| value.is_finite()).all(|value| value.abs() * metres <= LARGEST_M)
}

/// A number type of Igor's.
fn sample_kind(number_type: u16) -> Option<SampleKind> {
    Some(match number_type {
        0x02 => SampleKind::F32,
        0x04 => SampleKind::F64,
        0x08 => SampleKind::I8,
        0x10 => SampleKind::I16,
        0x20 => SampleKind::I32,
        0x48 => SampleKind::U8,
        0x50 => SampleKind::U16,
        0x60 => SampleKind::U32,
        _ => return None,
    })
}

/// What is used of a wave.
struct Wave {
    sample_type: u16,
    /// Samples along x and y, and layers; 0 for dimensions that there are not.
    size: [u32; 3],
    /// Distances along x and y.
    step: [f64; 2],
    step_units: [String; 2],
    unit: String,
    /// Names of the layers.
    labels: Vec<String>,
    note: String,
    data_at: usize,
}

impl Wave {
    /// A header of 16 bytes, then that of the wave with 126 in all; one dimension as a rule, with another program's rows in the note.
    fn version_2(binary: Binary) -> Parsed<Self> {
        let points = binary.u32(16 + 42)?;
        let note_at = (binary.u32(2)? as usize).checked_add(16);
        let note_bytes = binary.u32(6)? as usize;
        let note = note_at
            .and_then(|at| binary.range(at, note_bytes.min(NOTE_MAX)).ok())
            .map(text::decode)
            .unwrap_or_default();
        let mut wave = Self {
            sample_type: binary.u16(16)?,
            size: [points, 0, 0],
            step: [binary.f64(16 + 48)?; 2],
            step_units: [binary.text(16 + 38, 4)?, binary.text(16 + 38, 4)?],
            unit: binary.text(16 + 34, 4)?,
            labels: Vec::new(),
            note: note.replace('\r', "\n"),
            data_at: 16 + 110,
        };
        // Old Asylum images lie in one dimension; the note says how many points a line has.
        let side = |key: &str| wave.note(key).and_then(|text| text.parse::<u32>().ok()).filter(|&side| side > 0);
        if let Some((nx, ny)) =
            side("ScanPoints").zip(side("ScanLines")).filter(|(nx, ny)| nx.checked_mul(*ny) == Some(points))
        {
            wave.size = [nx, ny, 0];
            let extent = |key: &str| wave.note(key).and_then(|text| text.parse::<f64>().ok());
            if let Some((x, y)) = extent("FastScanSize").zip(extent("SlowScanSize")) {
                wave.step = [x / f64::from(nx), y / f64::from(ny)];
                wave.step_units = ["m".to_owned(), "m".to_owned()];
            }
        }
        Ok(wave)
    }

    /// A header of 64 bytes, that of the wave with 320, the samples, and then formula, note, units and labels.
    fn version_5(binary: Binary) -> Parsed<Self> {
        const WAVE: usize = 64;
        const DATA: usize = 64 + 320;
        let part = |at: usize| binary.u32(at).map(|length| length as usize);
        // Bytes of wave header with samples, formula, note, data units, then of units and labels of four dimensions each.
        let samples = part(4)?;
        let mut at = WAVE + samples;
        let mut next = |length: usize| {
            let start = at;
            at = at.saturating_add(length);
            binary.range(start, length)
        };
        next(part(8)?)?;
        let note = next(part(12)?)?;
        let long_unit = next(part(16)?)?;
        for dimension in 0..4 {
            next(part(20 + 4 * dimension)?)?;
        }
        for dimension in 0..2 {
            next(part(36 + 4 * dimension)?)?;
        }
        let labels = next(part(44)?)?;
        let short_unit = binary.text(WAVE + 148, 4)?;
        let unit = if long_unit.is_empty() { short_unit } else { text::decode(long_unit) };
        Ok(Self {
            sample_type: binary.u16(WAVE + 16)?,
            size: [binary.u32(WAVE + 68)?, binary.u32(WAVE + 72)?, binary.u32(WAVE + 76)?],
            step: [binary.f64(WAVE + 84)?, binary.f64(WAVE + 92)?],
            step_units: [binary.text(WAVE + 152, 4)?, binary.text(WAVE + 156, 4)?],
            unit,
            // The first label names the dimension itself.
            labels: labels.chunks_exact(LABEL).skip(1).map(|label| text::decode(label).trim().to_owned()).collect(),
            note: text::decode(&note[..note.len().min(NOTE_MAX)]).replace('\r', "\n"),
            data_at: DATA,
        })
    }

    /// The value of a line `key: value` of the note.
    fn note(&self, key: &str) -> Option<&str> {
        self.note.lines().find_map(|line| {
            let (name, value) = line.split_once(':')?;
            (name.trim() == key).then_some(value.trim())
        })
    }

    /// The unit of a channel. Asylum's header gives one for all, so there its name counts, as the note's keys do: `HeightUnit`, or by
    /// what the channel measures. A name that is not known has no unit then.
    fn unit(&self, name: &str) -> Option<String> {
        let is_asylum = !self.labels.is_empty() && !self.note.is_empty();
        if !is_asylum {
            return Some(self.unit.clone());
        }
        let base = name.trim_end_matches(|character: char| character.is_ascii_digit());
        let base = base.strip_suffix("Mod").unwrap_or(name);
        let base = base.strip_suffix("Retrace").or_else(|| base.strip_suffix("Trace")).unwrap_or(base);
        if let Some(unit) = self.note(&format!("{base}Unit")) {
            return Some(unit.to_owned());
        }
        let plain = base.strip_prefix("Nap").or_else(|| base.strip_prefix("DAC")).unwrap_or(base);
        let is_length = ["Deflection", "Amplitude"].iter().any(|length| plain.starts_with(length))
            || ["Height", "ZSensor"].iter().any(|length| plain.contains(length));
        is_length.then(|| "m".to_owned())
    }

    fn pitch(&self) -> Found<[f64; 2]> {
        // A scanner may run against its axis.
        let side =
            |axis: usize| length(&self.step_units[axis], "pixels").map(|unit| self.step[axis].abs() * unit.value);
        let pitch = [side(0)?, side(1)?];
        Ok(Sourced::new(pitch, "Igor wave header"))
    }
}

fn length(unit: &str, what: &str) -> Found<f64> {
    match LengthUnit::parse(unit) {
        Some(unit) => Ok(Sourced::new(unit.to_nm(), "Igor wave header")),
        None => Err(format!("its wave measures {what} in {unit:?}, not a length")),
    }
}
