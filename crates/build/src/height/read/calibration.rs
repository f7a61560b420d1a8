//! From stored samples to heights in nm: what the caller says, else what the file says, else a refusal.

use ndarray::Array2;

use super::config::{HeightScale, ReadConfig};
use super::missing;
use super::refusal::{Parsed, Refusal};
use super::scan::{Provenance, Scan};
use super::stored::{Line, RawScan, SampleKind, Sourced};
use crate::height::{HeightField, PITCH_NM};

/// Largest believable height in nm: one metre.
const HEIGHT_MAX_NM: f64 = 1e9;
/// Relief in nm from which on integers in a unit of length are likelier counts.
const COUNTS_NM: f64 = 1e4;
/// Sides of a sample from whose ratio on a decimal comma, or two numbers in each other's place, are likelier than the scan.
const ELONGATED: f64 = 4.0;

/// Calibrates, fills and checks a scan. File name and digest are left empty.
pub(super) fn calibrate(mut raw: RawScan, config: &ReadConfig) -> Parsed<Scan> {
    let (pitch, line) = both(&mut raw, config)?;
    if let Some(part) = config.crop {
        crop(&mut raw, part)?;
    }
    let [nx, ny] = raw.stored.size;
    let missing_samples = mask(&mut raw, config.missing_value);
    let mut heights = std::mem::take(&mut raw.stored.values);
    for height in &mut heights {
        *height = line.value.scale * *height + line.value.offset;
    }
    check_range(&heights, &line, config)?;
    raw.warnings.extend(doubtful_unit(&heights, raw.stored.kind, config));
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
            angle_deg: raw.angle_deg.filter(|angle| angle.is_finite()),
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
    let words = &config.words;
    let by_file = std::mem::replace(&mut raw.pitch_nm, Err(String::new()));
    let pitch = match (config.pitch_nm, by_file) {
        (Some(pitch), by_file) => {
            if let Ok(stated) = by_file {
                let differs = |axis: usize| (stated.value[axis] / pitch[axis] - 1.0).abs() > 1e-3;
                if differs(0) || differs(1) {
                    raw.warnings.push(format!(
                        "{} = {pitch:?} overrules the file's {:?} ({})",
                        words.pitch, stated.value, stated.from
                    ));
                }
            }
            Sourced::new(pitch, format!("{}: {}", words.source, words.pitch))
        }
        (None, Ok(stated)) => Sourced::new(stated.value, format!("file: {}", stated.from)),
        (None, Err(reason)) => {
            return Err(Refusal::new(format!("the distance between samples is not known: {reason}"), words.add_pitch));
        }
    };
    let [low, high] = PITCH_NM;
    if pitch.value.iter().all(|side| (low..=high).contains(side)) {
        let [x, y] = pitch.value;
        let ratio = (x / y).max(y / x);
        if ratio > ELONGATED {
            raw.warnings.push(format!(
                "its samples are {ratio:.1} times as long as wide ({x} x {y} nm, {}): is that meant? A decimal comma would do that",
                pitch.from
            ));
        }
        Ok(pitch)
    } else {
        Err(Refusal::new(
            format!("a pitch of {:?} nm ({}) is not between {low} nm and 1 mm", pitch.value, pitch.from),
            format!("set `{}` to the distance between neighbouring samples in nm", words.pitch),
        ))
    }
}

/// The straight line from stored samples to nm.
fn line(raw: &mut RawScan, config: &ReadConfig) -> Parsed<Sourced<Line>> {
    let (kind, words) = (raw.stored.kind, &config.words);
    let in_unit = |nm: f64| Line { scale: raw.numbers.scale * nm, offset: raw.numbers.offset * nm };
    let Some(scale) = config.height else {
        return match &raw.unit_nm {
            Ok(unit) => Ok(Sourced::new(in_unit(unit.value), format!("file: {}", unit.from))),
            Err(reason) => {
                let fix = if kind.range().is_some() { words.add_integer_height } else { words.add_float_height };
                Err(Refusal::new(format!("what its {} samples mean in nm is not known: {reason}", kind.name()), fix))
            }
        };
    };
    let line = match scale {
        HeightScale::Unit(unit) => in_unit(unit.to_nm()),
        HeightScale::Linear { nm_per_count, offset_nm } => Line { scale: nm_per_count, offset: offset_nm },
        HeightScale::FullScaleNm(full_scale) => {
            let Some([low, high]) = kind.range() else {
                return Err(Refusal::new(
                    format!("a full scale is for integer samples; these are {}", kind.name()),
                    words.add_float_height,
                ));
            };
            let scale = full_scale / (high - low);
            Line { scale, offset: -low * scale }
        }
    };
    if !(line.scale.is_finite() && line.scale != 0.0 && line.offset.is_finite()) {
        return Err(Refusal::new(
            format!("the `{}` given is not a finite scale other than 0", words.height),
            format!("correct `{}`", words.height),
        ));
    }
    if let Ok(unit) = &raw.unit_nm {
        let by_file = in_unit(unit.value);
        if (by_file.scale / line.scale - 1.0).abs() > 1e-3 {
            raw.warnings.push(format!(
                "`{}` ({} nm per count) overrules the file's scale ({} nm per count, {})",
                words.height, line.scale, by_file.scale, unit.from
            ));
        }
    }
    Ok(Sourced::new(line, format!("{}: {}", words.source, words.height)))
}

/// Keeps a part of the samples: first column, first row, width, height.
fn crop(raw: &mut RawScan, part: [usize; 4]) -> Parsed<()> {
    let [x, y, width, height] = part;
    let [nx, ny] = raw.stored.size;
    let is_within = |first: usize, length: usize, count: usize| {
        length > 0 && first.checked_add(length).is_some_and(|end| end <= count)
    };
    if !is_within(x, width, nx) || !is_within(y, height, ny) {
        return Err(Refusal::new(
            format!("`crop` = {part:?} is no part of this scan of {nx} x {ny} samples"),
            "set `crop` to [first column, first row, width, height] within the scan",
        ));
    }
    let rows = raw.stored.values.chunks_exact(nx).skip(y).take(height);
    raw.stored.values = rows.flat_map(|row| row[x..x + width].iter().copied()).collect();
    raw.stored.size = [width, height];
    Ok(())
}

/// Turns everything that means "no data" into NaN and counts it.
fn mask(raw: &mut RawScan, by_caller: Option<f64>) -> usize {
    let kind = raw.stored.kind;
    let no_data = [raw.no_data, by_caller].map(|value| value.map(|value| kind.rounded(value)));
    let mut count = 0;
    for value in &mut raw.stored.values {
        // The largest single-precision number is the customary mark where no tag names one.
        let is_mark = kind.range().is_none() && value.abs() == f64::from(f32::MAX);
        if !value.is_finite() || is_mark || no_data.contains(&Some(*value)) {
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
        format!("crop the scan to its measured part{}", config.words.or_accept_missing),
    ))
}

/// Asks about a unit that makes counts of an instrument into heights: integers in a unit of length that the caller gave, over more than any
/// relief that diffracts.
fn doubtful_unit(heights: &[f64], kind: SampleKind, config: &ReadConfig) -> Option<String> {
    let Some(HeightScale::Unit(_)) = config.height else { return None };
    kind.range()?;
    let known = heights.iter().filter(|height| height.is_finite());
    let (low, high) =
        known.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), height| (low.min(*height), high.max(*height)));
    (high - low > COUNTS_NM).then(|| {
        format!(
            "its {} samples span {:.0} nm in the unit that `{}` gives: is the unit right? Counts of an instrument need their scale: {}",
            kind.name(),
            high - low,
            config.words.height,
            config.words.add_integer_height
        )
    })
}

fn check_range(heights: &[f64], line: &Sourced<Line>, config: &ReadConfig) -> Parsed<()> {
    let largest = heights.iter().fold(0.0, |largest: f64, height| {
        // Comparisons ignore NaN, the mark of missing samples.
        if height.abs() > largest.abs() { *height } else { largest }
    });
    if largest.abs() <= HEIGHT_MAX_NM {
        return Ok(());
    }
    // The number in the file, as far as it can be told after scaling.
    let stored = ((largest - line.value.offset) / line.value.scale) as f32;
    Err(Refusal::new(
        format!("its heights reach {largest:.3e} nm, more than a metre ({})", line.from),
        format!(
            "where {stored:e} marks missing samples, set `missing_value = {stored:e}`; otherwise the unit is probably wrong: \
             correct it, or {}",
            config.words.add_float_height
        ),
    ))
}
