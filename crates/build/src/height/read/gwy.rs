//! Gwyddion's own files (.gwy): named components in objects, of which the data fields at the top are channels.

use super::binary::Binary;
use super::channels::{self, Channel};
use super::config::ReadConfig;
use super::refusal::{Parsed, Refusal};
use super::stored::{Found, RawScan, SampleKind, Sourced, Stored};
use super::tiff_pixels::checked_size;
use super::unit::LengthUnit;

/// The first bytes.
pub(super) const MAGIC: &[u8] = b"GWYP";

/// Reads the height channel, or the one asked for.
pub(super) fn read(bytes: &[u8], config: &ReadConfig) -> Parsed<RawScan> {
    let top = Components { rest: object(&bytes[MAGIC.len()..], "GwyContainer")? };
    let (mut fields, mut titles, mut masks) = (Vec::new(), Vec::new(), Vec::new());
    for component in top {
        let component = component?;
        let Some((number, key)) = channel_key(component.name) else { continue };
        match (key, component.value) {
            ("data", Value::Object(content)) if content.starts_with(b"GwyDataField\0") => {
                fields.push((number, Field::new(object(content, "GwyDataField")?)?));
            }
            ("data/title", Value::Text(title)) => titles.push((number, title)),
            ("mask", Value::Object(_)) => masks.push(number),
            _ => {}
        }
    }
    fields.sort_by_key(|(number, _)| *number);
    let title = |number| titles.iter().find(|title| title.0 == number).map_or("", |title| title.1).trim();
    let channels: Vec<_> = fields
        .iter()
        .map(|(number, field)| Channel {
            page: *number,
            name: title(*number).to_owned(),
            is_length: Some(LengthUnit::parse(field.unit_z).is_some()),
        })
        .collect();
    if fields.is_empty() {
        return Err(Refusal::new("this Gwyddion file holds no image", "save the height image in it"));
    }
    let (place, remark) = channels::choose(&channels, config)?;
    let (number, field) = &fields[place];
    let mut warnings: Vec<_> = remark.into_iter().collect();
    if masks.contains(number) {
        warnings
            .push("the channel has a mask, which is not applied: samples below it are taken as they are".to_owned());
    }
    let size = checked_size(field.size, config.max_samples)?;
    if field.data.len() as u64 != u64::from(size[0]) * u64::from(size[1]) * 8 {
        return Err(Refusal::damaged(format!(
            "{} x {} samples need more or less than {} bytes",
            size[0],
            size[1],
            field.data.len()
        )));
    }
    let values = Binary::little(field.data).samples(0, size, SampleKind::F64)?;
    Ok(RawScan {
        page: *number,
        channel: Some(channels[place].name.clone()).filter(|name| !name.is_empty()),
        unit_nm: length(field.unit_z, "height"),
        pitch_nm: field.pitch(size),
        warnings,
        ..RawScan::of("Gwyddion", Stored::of(size, SampleKind::F64, values))
    })
}

/// `/7/data/title` in two: the channel's number, and what of it.
fn channel_key(name: &str) -> Option<(usize, &str)> {
    let (number, key) = name.strip_prefix('/')?.split_once('/')?;
    Some((number.parse().ok()?, key))
}

/// The components of an object of type `kind`: its name, a NUL, 32 bits of size, then they.
fn object<'a>(bytes: &'a [u8], kind: &str) -> Parsed<&'a [u8]> {
    let (name, rest) = split_text(bytes)?;
    if name != kind {
        return Err(Refusal::damaged(format!("an object is {name:?}, not {kind}")));
    }
    let size = Binary::little(rest).u32(0)? as usize;
    Binary::little(rest).range(4, size)
}

/// Text up to a NUL, and what follows that.
fn split_text(bytes: &[u8]) -> Parsed<(&str, &[u8])> {
    let end = bytes.iter().position(|&byte| byte == 0).ok_or_else(|| Refusal::damaged("a name in it has no end"))?;
    let text = std::str::from_utf8(&bytes[..end]).map_err(|_| Refusal::damaged("a name in it is not UTF-8"))?;
    Ok((text, &bytes[end + 1..]))
}

/// One component: its name and those kinds of value that are used.
struct Component<'a> {
    name: &'a str,
    value: Value<'a>,
}

enum Value<'a> {
    Integer(i32),
    Number(f64),
    Text(&'a str),
    /// Type name, size and components.
    Object(&'a [u8]),
    /// 64-bit floats.
    Numbers(&'a [u8]),
    Other,
}

/// Components one after another; ends at the first that is broken.
struct Components<'a> {
    rest: &'a [u8],
}

impl<'a> Iterator for Components<'a> {
    type Item = Parsed<Component<'a>>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.rest.is_empty() {
            return None;
        }
        let component = self.component();
        if component.is_err() {
            self.rest = &[];
        }
        Some(component)
    }
}

impl<'a> Components<'a> {
    fn component(&mut self) -> Parsed<Component<'a>> {
        let (name, rest) = split_text(self.rest)?;
        let (&kind, rest) = rest.split_first().ok_or_else(|| Refusal::damaged("a component in it has no type"))?;
        let binary = Binary::little(rest);
        // An array: 32 bits of count, then its elements.
        let array = |element: usize| {
            let count = binary.u32(0)? as usize;
            let length = count.checked_mul(element).ok_or_else(|| Refusal::damaged("an array in it is too long"))?;
            binary.range(4, length).map(|content| (Value::Other, content, 4 + length))
        };
        let (value, length) = match kind {
            b'b' | b'c' => (Value::Other, 1),
            b'i' => (Value::Integer(binary.i32(0)?), 4),
            b'q' => (Value::Other, 8),
            b'd' => (Value::Number(binary.f64(0)?), 8),
            b's' => {
                let (text, after) = split_text(rest)?;
                (Value::Text(text), rest.len() - after.len())
            }
            b'o' => {
                let length = object_length(rest)?;
                (Value::Object(&rest[..length]), length)
            }
            b'C' => array(1).map(|(value, _, length)| (value, length))?,
            b'I' => array(4).map(|(value, _, length)| (value, length))?,
            b'Q' => array(8).map(|(value, _, length)| (value, length))?,
            b'D' => array(8).map(|(_, content, length)| (Value::Numbers(content), length))?,
            b'S' | b'O' => (Value::Other, list_length(rest, kind == b'O')?),
            _ => {
                return Err(Refusal::damaged(format!(
                    "component {name:?} is of the unknown type {:?}",
                    char::from(kind)
                )));
            }
        };
        self.rest = rest.get(length..).ok_or_else(|| Refusal::damaged(format!("component {name:?} is cut short")))?;
        Ok(Component { name, value })
    }
}

/// Bytes of an object with its name and size.
fn object_length(bytes: &[u8]) -> Parsed<usize> {
    let (_, rest) = split_text(bytes)?;
    let size = Binary::little(rest).u32(0)? as usize;
    Binary::little(rest).range(4, size)?;
    Ok(bytes.len() - rest.len() + 4 + size)
}

/// Bytes of a list of texts or objects with its count.
fn list_length(bytes: &[u8], of_objects: bool) -> Parsed<usize> {
    let count = Binary::little(bytes).u32(0)?;
    let mut at = 4;
    for _ in 0..count {
        let rest = &bytes[at..];
        // Each element takes a byte at least, so this ends with the file.
        at += if of_objects { object_length(rest)? } else { rest.len() - split_text(rest)?.1.len() };
    }
    Ok(at)
}

/// What is used of a data field.
struct Field<'a> {
    size: [u64; 2],
    /// Of the whole field, in `unit_xy`.
    extent: [f64; 2],
    unit_xy: &'a str,
    unit_z: &'a str,
    data: &'a [u8],
}

impl<'a> Field<'a> {
    fn new(content: &'a [u8]) -> Parsed<Self> {
        let mut field = Self { size: [0; 2], extent: [f64::NAN; 2], unit_xy: "", unit_z: "", data: &[] };
        for component in (Components { rest: content }) {
            let Component { name, value } = component?;
            match (name, value) {
                ("xres", Value::Integer(side)) => field.size[0] = side.try_into().unwrap_or(0),
                ("yres", Value::Integer(side)) => field.size[1] = side.try_into().unwrap_or(0),
                ("xreal", Value::Number(extent)) => field.extent[0] = extent,
                ("yreal", Value::Number(extent)) => field.extent[1] = extent,
                ("si_unit_xy", Value::Object(unit)) => field.unit_xy = unit_text(unit)?,
                ("si_unit_z", Value::Object(unit)) => field.unit_z = unit_text(unit)?,
                ("data", Value::Numbers(data)) => field.data = data,
                _ => {}
            }
        }
        if field.size.contains(&0) {
            return Err(Refusal::damaged("an image in it has no size"));
        }
        Ok(field)
    }

    fn pitch(&self, size: [u32; 2]) -> Found<[f64; 2]> {
        let unit = length(self.unit_xy, "lateral")?.value;
        Ok(Sourced::new([0, 1].map(|axis| self.extent[axis] * unit / f64::from(size[axis])), "Gwyddion data field"))
    }
}

fn unit_text(unit: &[u8]) -> Parsed<&str> {
    for component in (Components { rest: object(unit, "GwySIUnit")? }) {
        if let Component { name: "unitstr", value: Value::Text(text) } = component? {
            return Ok(text);
        }
    }
    Ok("")
}

fn length(unit: &str, what: &str) -> Found<f64> {
    match LengthUnit::parse(unit) {
        Some(unit) => Ok(Sourced::new(unit.to_nm(), "Gwyddion data field")),
        None => Err(format!("the data field's {what} unit is {unit:?}, not a length")),
    }
}
