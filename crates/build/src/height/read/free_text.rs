//! Calibration of plain TIFFs: `key=value` lines of the description, and the resolution tags.

use super::directory::Directory;
use super::refusal::Parsed;
use super::stored::{Found, RawScan, Sourced};
use super::unit::LengthUnit;

/// Coarsest pitch in nm that resolution tags are believed for. Screens, printers and scanners up to
/// 2400 dots per inch lie above.
const COARSEST_NM: f64 = 10_000.0;

/// Fills in what description and resolution tags say.
pub(super) fn apply(scan: &mut RawScan, description: &str, directory: &Directory) -> Parsed<()> {
    scan.unit_nm =
        height_unit(description, "description").unwrap_or_else(|| Err("no tag gives a height unit".to_owned()));
    if scan.unit_nm.is_ok() && !scan.stored.kind.unit_is_enough() {
        scan.unit_nm = Err(format!(
            "its description names a height unit, but {} samples are usually stretched to their \
             range, and the range is not given",
            scan.stored.kind.name()
        ));
    }
    let by_tags = pitch_from_resolution(directory)?;
    scan.pitch_nm = match pitch_from_text(description) {
        Some(by_text) => {
            if let (Ok(text), Ok(tags)) = (&by_text, &by_tags) {
                let differs = |axis: usize| (text.value[axis] / tags.value[axis] - 1.0).abs() > 0.01;
                if differs(0) || differs(1) {
                    scan.warnings.push(format!(
                        "the description's pixel size ({:?} nm) and the resolution tags' ({:?} nm) \
                         differ; the description's is used",
                        text.value, tags.value
                    ));
                }
            }
            by_text
        }
        None => by_tags,
    };
    Ok(())
}

/// The value of the first line whose key is one of `keys`, compared without case, blanks and
/// underscores; `=` or `:` stands between.
fn value_of<'t>(text: &'t str, keys: &[&str]) -> Option<&'t str> {
    text.lines().find_map(|line| {
        let (key, value) = line.split_once(['=', ':'])?;
        let key: String = key
            .chars()
            .filter(|character| !matches!(character, ' ' | '\t' | '_'))
            .flat_map(char::to_lowercase)
            .collect();
        keys.contains(&key.as_str()).then_some(value.trim())
    })
}

/// A height unit named in free text, with `place` for messages; `None` where none is named.
pub(super) fn height_unit(text: &str, place: &str) -> Option<Found<f64>> {
    let value = value_of(text, &["zunit", "zunits", "heightunit", "heightunits"])?;
    Some(match LengthUnit::parse(value) {
        Some(unit) => Ok(Sourced::new(unit.to_nm(), place)),
        None => Err(format!("its {place} names the height unit {value:?}, not a length")),
    })
}

/// `pixel_width_nm` and `pixel_height_nm` (square if only the first is there).
fn pitch_from_text(text: &str) -> Option<Found<[f64; 2]>> {
    let width = value_of(text, &["pixelwidthnm"])?;
    let height = value_of(text, &["pixelheightnm"]).unwrap_or(width);
    Some(match (width.parse(), height.parse()) {
        (Ok(width), Ok(height)) => Ok(Sourced::new([width, height], "description")),
        _ => Err(format!("its description gives the pixel size {width:?} x {height:?}, not numbers")),
    })
}

/// The resolution tags, where they can be a scan's: an explicit unit, and finer than any screen.
pub(super) fn pitch_from_resolution(directory: &Directory) -> Parsed<Found<[f64; 2]>> {
    let unit = match directory.unsigned(296)? {
        Some(2) => LengthUnit::Inch,
        Some(3) => LengthUnit::Cm,
        _ => return Ok(Err("no tag gives a pixel size with a unit".to_owned())),
    };
    let pitch = [282, 283].map(|tag| directory.number(tag));
    let [Some(per_unit_x), Some(per_unit_y)] = [pitch[0].clone()?, pitch[1].clone()?] else {
        return Ok(Err("no tag gives a pixel size".to_owned()));
    };
    let pitch = [per_unit_x, per_unit_y].map(|per_unit| unit.to_nm() / per_unit);
    let name = match unit {
        LengthUnit::Inch => "inch",
        _ => "cm",
    };
    Ok(if pitch.iter().all(|pitch| *pitch > 0.0 && *pitch < COARSEST_NM) {
        Ok(Sourced::new(pitch, "resolution tags"))
    } else {
        Err(format!(
            "its resolution of {per_unit_x} x {per_unit_y} per {name} is that of a screen or a \
             printer, not of a scan"
        ))
    })
}
