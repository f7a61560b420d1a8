//! Gwyddion simple field: a text header, NUL padding, 32-bit floats from the top row down.

use super::binary::Binary;
use super::config::ReadConfig;
use super::refusal::{Parsed, Refusal};
use super::stored::{Found, RawScan, SampleKind, Sourced, Stored};
use super::text;
use super::tiff_pixels::checked_size;
use super::unit::LengthUnit;

/// The first line.
pub(super) const MAGIC: &[u8] = b"Gwyddion Simple Field 1.0\n";
/// Longest header that is looked through.
const HEADER_MAX: usize = 1 << 20;

/// Reads a simple field.
pub(super) fn read(bytes: &[u8], config: &ReadConfig) -> Parsed<RawScan> {
    if let Some(page) = config.page.filter(|&page| page > 0) {
        return Err(Refusal::new(format!("a Gwyddion simple field has no page {page}"), "leave the page out"));
    }
    let end = bytes
        .iter()
        .take(HEADER_MAX)
        .position(|&byte| byte == 0)
        .ok_or_else(|| Refusal::damaged("its header has no end"))?;
    // One to four NULs pad the header to a multiple of four bytes.
    let data_at = (end / 4 + 1) * 4;
    if bytes.get(end..data_at).is_none_or(|pad| pad.iter().any(|&byte| byte != 0)) {
        return Err(Refusal::damaged("its header is not padded with NULs"));
    }
    // UTF-8 by its definition; older programs write Latin-1.
    let header = text::decode(&bytes[MAGIC.len()..end]);
    let field = |name: &str| {
        header.lines().find_map(|line| {
            let (key, value) = line.split_once('=')?;
            (key.trim() == name).then_some(value.trim())
        })
    };
    let side = |name: &str| {
        let text = field(name).unwrap_or("");
        text.parse::<u64>()
            .ok()
            .filter(|&side| side > 0)
            .ok_or_else(|| Refusal::damaged(format!("{name} is {text:?}, not a number of samples")))
    };
    let size = checked_size([side("XRes")?, side("YRes")?], config.max_samples)?;
    let [nx, ny] = size;
    // No overflow: the number of samples has been checked, and sides are 32-bit.
    let (needed, held) = (u64::from(nx) * u64::from(ny) * 4, bytes.len() - data_at);
    if held as u64 != needed {
        return Err(Refusal::damaged(format!("{nx} x {ny} samples need {needed} bytes; the file has {held}")));
    }
    let values = Binary::little(bytes).samples(data_at, size, SampleKind::F32)?;
    Ok(RawScan {
        channel: field("Title").map(str::to_owned),
        unit_nm: unit(field("ZUnits"), "ZUnits").map(|nm| Sourced::new(nm, "gsf header")),
        pitch_nm: pitch(size, &field),
        ..RawScan::of("GSF", Stored::of(size, SampleKind::F32, values))
    })
}

fn unit(text: Option<&str>, name: &str) -> Result<f64, String> {
    let text = text.unwrap_or("");
    LengthUnit::parse(text)
        .map(LengthUnit::to_nm)
        .ok_or_else(|| format!("its header's {name} is {text:?}, not a length"))
}

/// Real sizes are of the whole field.
fn pitch<'h>(size: [u32; 2], field: &impl Fn(&str) -> Option<&'h str>) -> Found<[f64; 2]> {
    let unit_nm = unit(field("XYUnits"), "XYUnits")?;
    let side = |name: &str, samples: u32| {
        let text = field(name).ok_or_else(|| format!("its header has no {name}"))?;
        let extent: f64 = text.parse().map_err(|_| format!("its header's {name} is {text:?}, not a number"))?;
        Ok::<f64, String>(extent * unit_nm / f64::from(samples))
    };
    let pitch = [side("XReal", size[0])?, side("YReal", size[1])?];
    Ok(Sourced::new(pitch, "gsf header"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn field(header: &str, values: &[f32]) -> Vec<u8> {
        let mut bytes = [MAGIC, header.as_bytes()].concat();
        let padding = 4 - bytes.len() % 4;
        bytes.extend(std::iter::repeat_n(0, padding));
        bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
        bytes
    }

    fn read(bytes: &[u8], max_samples: usize) -> Parsed<RawScan> {
        super::read(bytes, &ReadConfig { max_samples, ..ReadConfig::default() })
    }

    #[test]
    fn headers_of_old_programs_are_latin_1() {
        let mut bytes = field("XRes = 1\nYRes = 1\nXReal = 2\nYReal = 2\nXYUnits = um\nZUnits = nm\n", &[1.0]);
        let at = bytes.windows(4).position(|window| window == b"= um").unwrap();
        bytes[at + 2] = 0xB5;
        assert_eq!(read(&bytes, 4).unwrap().pitch_nm.unwrap().value, [2000.0; 2]);
    }

    #[test]
    fn every_header_length_is_padded_right() {
        for title in ["", "a", "ab", "abc", "abcd"] {
            let header =
                format!("XRes = 2\nYRes = 1\nXReal = 2e-6\nYReal=3e-6\nXYUnits = m\nZUnits = nm\nTitle = {title}\n");
            let scan = read(&field(&header, &[1.5, -2.0]), 10).unwrap();
            assert_eq!(scan.stored.values, [1.5, -2.0]);
            assert_eq!(scan.channel.as_deref(), Some(title));
            assert_eq!(scan.unit_nm.unwrap().value, 1.0);
            let [x, y] = scan.pitch_nm.unwrap().value;
            assert!((x - 1000.0).abs() < 1e-9 && (y - 3000.0).abs() < 1e-9);
        }
    }

    #[test]
    fn absurd_sizes_are_refused_before_allocating() {
        for (size, words) in [
            ("XRes = 4000000000\nYRes = 4000000000\n", "limit"),
            ("XRes = 18446744073709551615\nYRes = 2\n", "limit"),
            ("XRes = 99999999999999999999\nYRes = 2\n", "number of samples"),
            ("XRes = -1\nYRes = 2\n", "number of samples"),
            ("XRes = 0\nYRes = 2\n", "number of samples"),
            ("YRes = 2\n", "XRes"),
            ("XRes = 3\nYRes = 3\n", "36 bytes"),
        ] {
            let refusal = read(&field(size, &[0.0; 4]), 1 << 24).unwrap_err();
            assert!(refusal.what.contains(words), "{size}: {}", refusal.what);
        }
        assert!(read(&field("XRes = 2\nYRes = 2\n", &[0.0; 4]), 4).is_ok());
        assert!(read(&field("XRes = 2\nYRes = 2\n", &[0.0; 4]), 3).unwrap_err().limit);
    }

    #[test]
    fn units_that_are_no_lengths_are_named() {
        let header = "XRes = 1\nYRes = 1\nXReal = 1\nYReal = 1\nXYUnits = V\nZUnits = deg\n";
        let scan = read(&field(header, &[0.0]), 4).unwrap();
        assert!(scan.unit_nm.unwrap_err().contains("deg"));
        assert!(scan.pitch_nm.unwrap_err().contains('V'));
    }

    #[test]
    fn damaged_headers() {
        assert!(read(MAGIC, 4).is_err());
        let mut bytes = field("XRes = 1\nYRes = 1\n\n\n", &[0.0]);
        let nul = bytes.iter().position(|&byte| byte == 0).unwrap();
        bytes[nul + 1] = b'x';
        assert!(read(&bytes, 4).unwrap_err().what.contains("padded"));
    }
}
