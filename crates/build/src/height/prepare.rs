//! Preparing of a scan: removal of what is no surface, levelling, blending of the edges, centring.

mod blend;
pub(crate) mod blobs;
mod despike;
pub(crate) mod level;
pub(crate) mod lost_lines;
pub(crate) mod repair;
pub(crate) mod robust;
pub(crate) mod scars;

use ndarray::{Array2, Zip};
use serde::{Deserialize, Serialize};

use crate::height::HeightField;
use diffraction_brdf::error::{Error, Result};

pub use self::repair::Repaired;

/// What levelling subtracts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Level {
    /// Nothing.
    None,
    /// The best plane.
    Plane,
    /// The best second-order surface.
    Quadratic,
    /// The best plane, then each scan line's own offset, as an AFM needs whose lines jump against each other. This also removes what of
    /// the structure is constant along the lines.
    Rows,
}

/// Removal of what is no surface: lines without a measurement, dust, scars, and single outliers.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Despike {
    /// How far from the median of its surroundings a sample may lie, in robust standard deviations
    /// of all samples from the medians of their surroundings; above 0.
    pub threshold_rms: f64,
}

/// What is done with a scan before its heights are used.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PrepareConfig {
    /// What is subtracted.
    pub level: Level,
    /// Removal of lost lines, dust, scars and single outliers; `None` for none.
    pub despike: Option<Despike>,
    /// Distance in nm from the edges within which opposite edges are made to fit each other, for
    /// surfaces that repeat; `None` leaves them as they are.
    pub blend_nm: Option<f64>,
}

/// What was done with a scan.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PrepareRecord {
    /// What was subtracted.
    pub level: Level,
    /// Slope (rise over run) of the subtracted plane along +x and +y, at the middle of the scan.
    pub removed_slope: [f64; 2],
    /// Second derivatives in 1/nm of the subtracted surface: xx, xy, yy.
    pub removed_curvature_per_nm: [f64; 3],
    /// Root mean square in nm of what was subtracted from single scan lines.
    pub removed_lines_rms_nm: f64,
    /// Number of outliers replaced by the median of their surroundings.
    pub spikes: usize,
    /// What was masked and filled in smoothly after that.
    #[serde(default)]
    pub repaired: Repaired,
    /// Distance in nm from the edges within which heights were changed to make opposite ones fit; 0 for none.
    pub blended_nm: f64,
    /// Height in nm added to all samples at last, which puts 0 midway between the highest and lowest.
    pub centring_nm: f64,
}

/// Prepares a height field: what is no surface is filled in, then level, edges, and at last 0 midway between highest and lowest.
///
/// Size and pitch stay. Levelling what is levelled changes nothing; outliers and edges may be treated anew.
///
/// # Errors
/// [`Error::Limit`] if the field is empty or not finite, or a setting does not suit its size.
pub fn prepare(field: &HeightField, config: &PrepareConfig) -> Result<(HeightField, PrepareRecord)> {
    check(field, config)?;
    let (mut prepared, spikes, repaired) = cleaned(field, config);
    let removed = match config.level {
        Level::None => level::Surface::default(),
        Level::Plane | Level::Rows => level::subtract_surface(&mut prepared, level::Order::Plane),
        Level::Quadratic => level::subtract_surface(&mut prepared, level::Order::Quadratic),
    };
    let removed_lines_rms_nm = match config.level {
        Level::Rows => level::subtract_lines(&mut prepared),
        _ => 0.0,
    };
    if let Some(blend_nm) = config.blend_nm {
        blend::blend(&mut prepared, blend_nm);
    }
    let centring_nm = centre(&mut prepared);
    let record = PrepareRecord {
        level: config.level,
        removed_slope: removed.slope,
        removed_curvature_per_nm: removed.curvature_per_nm,
        removed_lines_rms_nm,
        spikes,
        repaired,
        blended_nm: config.blend_nm.unwrap_or(0.0),
        centring_nm,
    };
    Ok((prepared, record))
}

/// Samples that `despike` replaces in a field, `[rows, columns]`; `None` where it does not act.
///
/// # Errors
/// As [`prepare`].
pub fn replaced(field: &HeightField, config: &PrepareConfig) -> Result<Option<Array2<bool>>> {
    check(field, config)?;
    if config.despike.is_none() {
        return Ok(None);
    }
    let (after, ..) = cleaned(field, config);
    Ok(Some(Zip::from(&after.heights_nm).and(&field.heights_nm).map_collect(|after, before| after != before)))
}

/// The field without what is no surface, the number of outliers, and what else was filled in.
fn cleaned(field: &HeightField, config: &PrepareConfig) -> (HeightField, usize, Repaired) {
    let mut cleaned = field.clone();
    let Some(Despike { threshold_rms }) = config.despike else { return (cleaned, 0, Repaired::default()) };
    let spikes = despike::despike(&mut cleaned.heights_nm, threshold_rms);
    let repaired = repair::repair(&mut cleaned);
    (cleaned, spikes, repaired)
}

/// Puts 0 midway between the highest and the lowest sample; returns what was added.
fn centre(field: &mut HeightField) -> f64 {
    let (low, high) = range_nm(field);
    // Halved before adding, so that no finite range overflows.
    let middle = 0.5 * low + 0.5 * high;
    field.heights_nm -= middle;
    -middle
}

/// Lowest and highest height in nm.
pub(crate) fn range_nm(field: &HeightField) -> (f64, f64) {
    field
        .heights_nm
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &height| (low.min(height), high.max(height)))
}

fn check(field: &HeightField, config: &PrepareConfig) -> Result<()> {
    let [nx, ny] = field.size();
    if nx == 0 || ny == 0 {
        return Err(Error::limit(
            format!("a height field of {nx} x {ny} samples cannot be prepared"),
            "use another scan",
        ));
    }
    if !field.pitch_nm.iter().all(|pitch| pitch.is_finite() && *pitch > 0.0) {
        let [x, y] = field.pitch_nm;
        return Err(Error::limit(format!("the pitch is {x} x {y} nm"), "set `pitch_nm` to two positive lengths"));
    }
    // Squares of heights are summed: these bounds keep the sums of any scan finite.
    if let Some(height) = field.heights_nm.iter().find(|height| !height.is_finite() || height.abs() > 1e100) {
        return Err(Error::limit(
            format!("a height is {height} nm, which is no height"),
            "set `height` to what the file's numbers mean, or use another scan",
        ));
    }
    if config.level == Level::Rows && nx < level::LINE_SAMPLES_MIN {
        return Err(Error::limit(
            format!(
                "level = \"rows\" needs at least {} samples in each line to tell its offset from the structure; \
                 this scan has {nx}",
                level::LINE_SAMPLES_MIN
            ),
            "use level = \"plane\"",
        ));
    }
    if let Some(Despike { threshold_rms }) = config.despike
        && !(threshold_rms.is_finite() && threshold_rms > 0.0)
    {
        return Err(Error::limit(
            format!("despike.threshold_rms is {threshold_rms}"),
            "set it to a positive number such as 8, or leave `despike` out",
        ));
    }
    config.blend_nm.map_or(Ok(()), |blend_nm| blend::check(field, blend_nm))
}

#[cfg(test)]
mod tests;
