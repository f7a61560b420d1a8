//! From stored samples to heights in nm: what the caller says, else what the file says, else a refusal.

use ndarray::Array2;

use super::stored::{Line, RawScan, Sourced};
use super::{HeightScale, Parsed, Provenance, ReadConfig, Refusal, Scan, missing};
use crate::height::HeightField;

/// Largest believable height in nm: one metre.
const HEIGHT_MAX_NM: f64 = 1e9;
/// Upper bound of a believable pitch in nm: one millimetre.
const PITCH_MAX_NM: f64 = 1e6;

/// Calibrates, fills and checks a scan. File name and digest are left empty.
pub(super) fn calibrate(mut raw: RawScan, config: &ReadConfig) -> Parsed<Scan> {
    let (pitch, line) = both(&mut raw, config)?;
    let [nx, ny] = raw.stored.size;
    let missing_samples = mask(&mut raw);
    let mut heights = std::mem::take(&mut raw.stored.values);
    for height in &mut heights {
        *height = line.value.scale * *height + line.value.offset;
    }
    check_range(&heights, &line.from)?;
    check_missing(missing_samples, heights.len(), config)?;
    if missing_samples > 0 {
        let converged = missing::fill(&mut heights, [nx, ny], pitch.value);
        let share = 100.0 * missing_samples as f64 / heights.len() as f64;
        raw.warnings.push(format!("{missing_samples} missing samples ({share:.3} %) were filled in smoothly"));
        if !converged {
            raw.warnings.push("the widest gap is filled only approximately".to_owned());
        }
    }
    let size = raw.stored.size;
    let heights_nm = Array2::from_shape_vec((ny, nx), heights)
        .map_err(|_| Refusal::damaged("it does not hold as many samples as it claims"))?;
    Ok(Scan {
        field: HeightField { heights_nm, pitch_nm: pitch.value },
        provenance: Provenance {
            file_name: String::new(),
            sha256: String::new(),
            format: raw.format.to_owned(),
            page: raw.page,
            sample_format: raw.stored.kind.name().to_owned(),
            size,
            pitch_nm: pitch.value,
            pitch_from: pitch.from,
            height_from: line.from,
            missing_samples,
            channel: raw.channel,
            warnings: raw.warnings,
        },
    })
}

/// Pitch and line; if both are unknown the refusal names both.
fn both(raw: &mut RawScan, config: &ReadConfig) -> Parsed<(Sourced<[f64; 2]>, Sourced<Line>)> {
    match (pitch(raw, config), line(raw, config)) {
        (Ok(pitch), Ok(line)) => Ok((pitch, line)),
        (Err(first), Err(second)) => Err(Refusal::new(
            format!("{}; and {}", first.what, second.what),
            format!("{}; and {}", first.fix, second.fix),
        )),
        (Err(refusal), _) | (_, Err(refusal)) => Err(refusal),
    }
}

fn pitch(raw: &mut RawScan, config: &ReadConfig) -> Parsed<Sourced<[f64; 2]>> {
    let by_file = std::mem::replace(&mut raw.pitch_nm, Err(String::new()));
    let pitch = match (config.pitch_nm, by_file) {
        (Some(pitch), by_file) => {
            if let Ok(stated) = by_file {
                let differs = |axis: usize| (stated.value[axis] / pitch[axis] - 1.0).abs() > 1e-3;
                if differs(0) || differs(1) {
                    raw.warnings.push(format!(
                        "pitch_nm = {pitch:?} overrules the file's {:?} ({})",
                        stated.value, stated.from
                    ));
                }
            }
            Sourced::new(pitch, "manifest: pitch_nm")
        }
        (None, Ok(stated)) => Sourced::new(stated.value, format!("file: {}", stated.from)),
        (None, Err(reason)) => {
            return Err(Refusal::new(
                format!("the distance between samples is not known: {reason}"),
                "add `pitch_nm = 48.8` (or `pitch_nm = [x, y]`, nm per sample) to the specimen",
            ));
        }
    };
    if pitch.value.iter().all(|side| *side > 0.0 && *side <= PITCH_MAX_NM) {
        Ok(pitch)
    } else {
        Err(Refusal::new(
            format!("a pitch of {:?} nm ({}) is not above 0 and at most 1 mm", pitch.value, pitch.from),
            "set `pitch_nm` to the distance between neighbouring samples in nm",
        ))
    }
}

/// The straight line from stored samples to nm.
fn line(raw: &mut RawScan, config: &ReadConfig) -> Parsed<Sourced<Line>> {
    let kind = raw.stored.kind;
    let in_unit = |nm: f64| Line { scale: raw.numbers.scale * nm, offset: raw.numbers.offset * nm };
    let Some(scale) = config.height else {
        return match &raw.unit_nm {
            Ok(unit) => Ok(Sourced::new(in_unit(unit.value), format!("file: {}", unit.from))),
            Err(reason) => {
                let example = if kind.range().is_some() {
                    "`height = { full_scale_nm = 375 }` (nm from the smallest to the largest value \
                     of the integer type) or `height = { nm_per_count = 0.01, offset_nm = 0 }`"
                } else {
                    "`height = { unit = \"nm\" }`"
                };
                Err(Refusal::new(
                    format!("what its {} samples mean in nm is not known: {reason}", kind.name()),
                    format!("add {example} to the specimen"),
                ))
            }
        };
    };
    let line = match scale {
        HeightScale::Unit(unit) => in_unit(unit.to_nm()),
        HeightScale::Linear { nm_per_count, offset_nm } => Line { scale: nm_per_count, offset: offset_nm },
        HeightScale::FullScaleNm(full_scale) => {
            let Some([low, high]) = kind.range() else {
                return Err(Refusal::new(
                    format!("full_scale_nm is for integer samples; these are {}", kind.name()),
                    "use `height = { unit = \"nm\" }` or `height = { nm_per_count, offset_nm }`",
                ));
            };
            let scale = full_scale / (high - low);
            Line { scale, offset: -low * scale }
        }
    };
    if !(line.scale.is_finite() && line.scale != 0.0 && line.offset.is_finite()) {
        return Err(Refusal::new(
            "the `height` given is not a finite scale other than 0",
            "correct `height` in the specimen",
        ));
    }
    if let Ok(unit) = &raw.unit_nm {
        let by_file = in_unit(unit.value);
        if (by_file.scale / line.scale - 1.0).abs() > 1e-3 {
            raw.warnings.push(format!(
                "`height` ({} nm per count) overrules the file's scale ({} nm per count, {})",
                line.scale, by_file.scale, unit.from
            ));
        }
    }
    Ok(Sourced::new(line, "manifest: height"))
}

/// Turns everything that means "no data" into NaN and counts it.
fn mask(raw: &mut RawScan) -> usize {
    let kind = raw.stored.kind;
    let no_data = raw.no_data.map(|value| kind.rounded(value));
    let mut count = 0;
    for value in &mut raw.stored.values {
        // The largest single-precision number is the customary mark where no tag names one.
        let is_mark = kind.range().is_none() && value.abs() == f64::from(f32::MAX);
        if !value.is_finite() || is_mark || no_data == Some(*value) {
            *value = f64::NAN;
            count += 1;
        }
    }
    count
}

fn check_missing(missing: usize, samples: usize, config: &ReadConfig) -> Parsed<()> {
    let share = missing as f64 / samples as f64;
    // Written so that a NaN limit refuses too.
    let accepted = missing == 0 || (missing < samples && share <= config.max_missing_share);
    if accepted {
        return Ok(());
    }
    Err(Refusal::new(
        format!(
            "{missing} of {samples} samples are missing ({:.2} %); up to {:.2} % are filled in",
            100.0 * share,
            100.0 * config.max_missing_share
        ),
        "crop the scan to its measured part, or raise the accepted share (max_missing_share)",
    ))
}

fn check_range(heights: &[f64], from: &str) -> Parsed<()> {
    let largest = heights.iter().fold(0.0, |largest: f64, height| {
        // `max` ignores NaN, the mark of missing samples.
        largest.max(height.abs())
    });
    if largest <= HEIGHT_MAX_NM {
        return Ok(());
    }
    Err(Refusal::new(
        format!("its heights reach {largest:.3e} nm, more than a metre ({from})"),
        "the unit is probably wrong: set `height` in the specimen, for instance \
         `height = { unit = \"nm\" }`",
    ))
}
