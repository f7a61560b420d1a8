//! Statistics of a height field: roughness, slopes, correlation, periods, and what the sampling allows.

mod autocorrelation;
mod periods;
mod repetition;
mod seams;
mod slopes;
pub(crate) mod spectrum;
mod surface;
mod wave_scale;

use serde::{Deserialize, Deserializer, Serialize};

use super::prepare::level::{Order, subtract_surface};
use super::prepare::range_nm;
use crate::ground::null_for_nan;
use crate::height::HeightField;

pub use periods::{Period, WAVES_MIN};
pub use repetition::is_whole_grating;
pub use seams::seam_warning;
pub use slopes::STEEP_SLOPE;
pub use surface::{PsdRing, SurfaceParameters, radial_psd};
pub use wave_scale::{wall_share, wave_slope};
pub(crate) use wave_scale::{wave_slope_max, wavelength_told_nm};

/// Share of surface that rises too much between samples from which on the reader is warned.
pub(crate) const AMBIGUOUS_SHARE_WARNED: f64 = 0.01;

/// Share to which ISO 25178-2 has the autocorrelation fall.
const SAL_SHARE: f64 = 0.2;

/// Full width at half maximum of an order in (u, v), in wavelengths over the standard deviation of the coherence window.
const ORDER_WIDTH: f64 = 0.265;

/// `|(u, v)|` from which on a scan tells one order from the next and from the mirror's light: a period of which its shorter side
/// holds [`WAVES_MIN`] diffracts there, and a window of this standard deviation (infinite for none) keeps it apart by an order's full
/// width at half maximum. Nearer to the mirror direction there is light, but no period to be read from it.
pub fn least_uv_radius(shorter_side_nm: f64, sigma_nm: f64, wavelength_nm: f64) -> f64 {
    (WAVES_MIN / shorter_side_nm).max(ORDER_WIDTH / sigma_nm) * wavelength_nm
}

/// Statistics of a height field.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Statistics {
    /// Root mean square height in nm about the mean plane.
    pub rms_height_nm: f64,
    /// Root mean square slope (rise over run) of the triangulated surface.
    pub rms_slope: f64,
    /// Highest minus lowest height in nm.
    pub peak_to_valley_nm: f64,
    /// Shortest distance in nm, over all directions, at which the autocorrelation of the heights about their
    /// mean plane falls to 1/e; NaN (`null` in JSON) where it does not within half of the scan.
    #[serde(deserialize_with = "null_as_nan")]
    pub autocorrelation_length_nm: f64,
    /// Periods that stand out of the power spectrum, strongest first, at most three.
    pub dominant_periods: Vec<Period>,
    /// `|(u, v)|` up to which the sampling resolves the gratings that diffract there, at the shortest
    /// wavelength; at most 2, which is all there is.
    pub usable_uv_radius: f64,
    /// Share of the triangulated surface's base with a slope above [`STEEP_SLOPE`], 0 to 1.
    pub steep_share: f64,
    /// Root mean square slope over a quarter of the shortest wavelength ([`wave_slope`]); NaN in files of older programs.
    #[serde(default = "unknown", with = "null_for_nan")]
    pub wave_slope: f64,
    /// Share of points at walls at the shortest wavelength ([`wall_share`]), 0 to 1; NaN in files of older programs.
    #[serde(default = "unknown", with = "null_for_nan")]
    pub wall_share: f64,
    /// Share of triangles of the surface whose height changes by more than a quarter of the shortest wavelength from one
    /// sample to the next, 0 to 1: the phase in between is a guess. NaN in files of older programs.
    #[serde(default = "unknown", with = "null_for_nan")]
    pub ambiguous_share: f64,
    /// Parameters of ISO 25178-2; `None` of a flat surface and in files of older programs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub surface: Option<SurfaceParameters>,
    /// Doubts in whole sentences.
    pub warnings: Vec<String>,
}

impl Statistics {
    /// Whether so much of the surface rises by more than a quarter wavelength between samples that the reader is warned.
    pub fn is_ambiguous(&self) -> bool {
        self.ambiguous_share > AMBIGUOUS_SHARE_WARNED
    }
}

/// Statistics of a height field that is not empty and whose heights are finite; `wavelength_min_nm` is
/// the shortest wavelength in use, positive.
///
/// Needs some 50 bytes of memory for each sample while it runs.
pub fn statistics(field: &HeightField, wavelength_min_nm: f64) -> Statistics {
    let (low, high) = range_nm(field);
    let mut levelled = field.clone();
    subtract_surface(&mut levelled, Order::Plane);
    let mean_square = mean_square(&levelled);
    let slopes = slopes::slopes(field, 0.25 * wavelength_min_nm);
    // Below 1e-12 of the heights' size there is rounding only.
    let flat = mean_square.sqrt() <= 1e-12 * low.abs().max(high.abs());
    let (length_nm, periods, surface) = if flat {
        (f64::NAN, Vec::new(), None)
    } else {
        let [to_one_in_e, to_a_fifth] = autocorrelation::decays(&levelled, [(-1.0f64).exp(), SAL_SHARE]);
        let surface = surface::parameters(&levelled, to_a_fifth);
        (to_one_in_e.shortest_nm, periods::dominant(&levelled), Some(surface))
    };
    let mut statistics = Statistics {
        rms_height_nm: if flat { 0.0 } else { mean_square.sqrt() },
        rms_slope: slopes.rms,
        peak_to_valley_nm: high - low,
        autocorrelation_length_nm: length_nm,
        dominant_periods: periods,
        usable_uv_radius: usable_uv_radius(field, wavelength_min_nm),
        steep_share: slopes.steep_share,
        wave_slope: wave_slope(field, wavelength_min_nm),
        wall_share: wall_share(field, wavelength_min_nm),
        ambiguous_share: slopes.ambiguous_share,
        surface,
        warnings: Vec::new(),
    };
    statistics.warnings = warnings(&statistics, flat, wavelength_min_nm);
    statistics
}

/// A grating of period `d` diffracts to `|(u, v)| = λ/d`, and none finer than two samples is resolved.
fn usable_uv_radius(field: &HeightField, wavelength_min_nm: f64) -> f64 {
    let [nx, ny] = field.size();
    // A field of one line is constant across it, which needs no resolving.
    let along = |count: usize, pitch_nm: f64| if count > 1 { wavelength_min_nm / (2.0 * pitch_nm) } else { 2.0 };
    along(nx, field.pitch_nm[0]).min(along(ny, field.pitch_nm[1])).min(2.0)
}

fn mean_square(field: &HeightField) -> f64 {
    field.heights_nm.iter().map(|height| height * height).sum::<f64>() / field.heights_nm.len() as f64
}

fn warnings(found: &Statistics, flat: bool, wavelength_min_nm: f64) -> Vec<String> {
    let mut warnings = Vec::new();
    if flat {
        warnings.push("The surface is flat: it reflects as a mirror and diffracts nothing.".to_owned());
    } else if found.autocorrelation_length_nm.is_nan() {
        warnings.push(
            "The heights stay correlated over half of the scan: it is smaller than the structure it should show."
                .to_owned(),
        );
    }
    if found.is_ambiguous() {
        warnings.push(format!(
            "{:.1} % of the surface rises by more than a quarter of {wavelength_min_nm} nm from one sample to the next: \
             the phase in between is a guess; a finer scan would tell.",
            100.0 * found.ambiguous_share
        ));
    }
    if found.usable_uv_radius < 2.0 {
        warnings.push(format!(
            "The samples are too coarse for |(u, v)| beyond {:.2} at {wavelength_min_nm} nm: gratings finer than two \
             samples, which would diffract there, are missing.",
            found.usable_uv_radius
        ));
    }
    warnings
}

fn unknown() -> f64 {
    f64::NAN
}

fn null_as_nan<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    Ok(Option::deserialize(deserializer)?.unwrap_or(f64::NAN))
}

#[cfg(test)]
mod tests;
