//! What look-ups between texels err by, before there are tables; and how many texels would keep a tolerance.
//!
//! What a surface does is blurred by the coherence window: the sharpest thing in tables is a line of the window's own width, a
//! Gaussian of the deviation `w` in (u, v). Between texels `Δ` apart a linear look-up errs at its peak by `Δ²/8` times the second
//! derivative, `1/w²`, a cubic through four texels by `3/128 Δ⁴` times the fourth, `3/w⁴`, a cubic B-spline through all of them by
//! `Δ⁴/384` times it, and by `-Δ⁶/1536` times the sixth, `-15/w⁶`, which counts on the coarse grids that splines need; the two
//! axes add. At the wavelength that the eye sees best that is what 95 % of lit directions keep, by a factor of about two:
//! `docs/accuracy.md` has it measured.

use serde::Serialize;

use super::model::{Basis, TablesConfig};
use super::plan::automatic_size;
use super::resolution::{lobe_width, narrowest_blur};
use crate::optics::config::OpticsConfig;

/// What the eye sees best, in nm.
const BRIGHTEST_NM: f64 = 555.0;

/// Most texels a side that are ever named.
const SIZE_MAX: f64 = 1e6;

/// A kind of look-up between texels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum LookUp {
    /// Between two texels a side, as graphics hardware makes it.
    Linear,
    /// Through four texels a side.
    Cubic,
    /// By the cubic B-spline through all texels.
    Spline,
}

/// What a kind of look-up errs by.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LookUpForecast {
    /// The kind.
    pub look_up: LookUp,
    /// Relative error at the peak of a line, along one axis.
    pub error: f64,
    /// Texels a side at which that is the tolerance.
    pub size_needed: usize,
}

impl LookUp {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Spline, Self::Linear, Self::Cubic];

    /// Relative error at the peak of a line, given the distance of texels over the line's deviation.
    fn error_at(self, ratio: f64) -> f64 {
        let squared = ratio * ratio;
        match self {
            Self::Linear => squared / 8.0,
            Self::Cubic => squared.powi(2) * 9.0 / 128.0,
            Self::Spline => squared.powi(2) * (1.0 + 1.25 * squared) / 128.0,
        }
    }

    /// The distance of texels over the line's deviation at which that is the error.
    fn ratio_for(self, error: f64) -> f64 {
        match self {
            Self::Linear => (8.0 * error).sqrt(),
            Self::Cubic => (error * 128.0 / 9.0).powf(0.25),
            Self::Spline => {
                // x² (1 + 5/4 x) = c, of x the ratio's square: Newton's rule from above, where the left side is convex.
                let c = 128.0 * error;
                let step = |x: f64| x - (x * x * (1.0 + 1.25 * x) - c) / (x * (2.0 + 3.75 * x)).max(f64::MIN_POSITIVE);
                (0..20).fold(c.sqrt(), |x, _| step(x)).max(0.0).sqrt()
            }
        }
    }

    /// Texels a side that keep a tolerance, given how far tables of another size are off.
    pub fn size_for(self, tolerance: f64, size: usize, error: f64) -> usize {
        let texels = (size - 1) as f64 * self.ratio_for(error) / self.ratio_for(tolerance);
        2 * (0.5 * texels).ceil().min(SIZE_MAX) as usize + 1
    }
}

/// Standard deviation in (u, v) of what blurs a line at the wavelength that the eye sees best.
fn brightest_blur(optics: &OpticsConfig) -> f64 {
    let [low_nm, high_nm] = optics.illuminant.reach_nm(optics.wavelength_nm);
    let nm = BRIGHTEST_NM.clamp(low_nm, high_nm);
    lobe_width(optics.body_coherence().sigma_nm_at(nm), nm)
}

/// Room that the law is given where it chooses a size: lines of different heights side by side err by up to twice as much.
const ROOM: f64 = 2.0;

/// Texels a side at which tables for every direction are tried before the grid that the tolerance asks for at worst: enough
/// for splines through lines that lie side by side, as those of a snake's skin; orders that stand alone, as a grating's, need more.
/// `None` where the size is given, or would not be less.
pub fn tried_first(optics: &OpticsConfig, tables: &TablesConfig) -> Option<usize> {
    if tables.size.is_some() || tables.basis != Basis::Chebyshev {
        return None;
    }
    let texel = brightest_blur(optics) * LookUp::Spline.ratio_for(tables.tolerance / ROOM);
    // Wider texels would hold means.
    let size = 2 * (2.0 / texel.min(narrowest_blur(optics))).ceil().min(SIZE_MAX) as usize + 1;
    (size < automatic_size(optics, tables.tolerance)).then_some(size)
}

/// What look-ups in tables of this size err by.
pub(super) fn look_up_forecasts(optics: &OpticsConfig, size: usize, tolerance: f64) -> [LookUpForecast; 3] {
    let ratio = 4.0 / (size - 1) as f64 / brightest_blur(optics);
    LookUp::ALL.map(|look_up| {
        let error = look_up.error_at(ratio);
        // Where texels miss the line, all of it.
        LookUpForecast { look_up, error: error.min(1.0), size_needed: look_up.size_for(tolerance, size, error) }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::config::{Edge, Windows};
    use diffraction_brdf::evaluate::{Interpolation, stencil};
    use diffraction_brdf::spectrum::Illuminant;

    /// Largest error of look-ups on a line of the deviation `w`, relative to its peak, with the line anywhere between texels.
    fn measured(look_up: LookUp, size: usize, w: f64) -> f64 {
        let texel = 4.0 / (size - 1) as f64;
        let line = |x: f64| (-0.5 * (x / w).powi(2)).exp();
        let mut worst = 0.0f64;
        for shift in 0..16 {
            let centre = f64::from(shift) / 16.0 * texel;
            for place in 0..40 {
                let at = (size / 2) as f64 + f64::from(place) / 20.0 - 1.0;
                let value = |index: usize| line(-2.0 + index as f64 * texel - centre);
                let found = match look_up {
                    LookUp::Spline => by_spline(at, value),
                    LookUp::Linear => by_stencil(stencil(Interpolation::Bilinear, at, size), size, value),
                    LookUp::Cubic => by_stencil(stencil(Interpolation::Cubic, at, size), size, value),
                };
                worst = worst.max((found - line(-2.0 + at * texel - centre)).abs());
            }
        }
        worst
    }

    fn by_stencil((first, weights): (usize, [f64; 4]), size: usize, value: impl Fn(usize) -> f64) -> f64 {
        weights.iter().enumerate().map(|(i, weight)| weight * value((first + i).min(size - 1))).sum()
    }

    /// The spline through values around a place: coefficients are `√3 Σ z^|k| value_k`.
    fn by_spline(at: f64, value: impl Fn(usize) -> f64) -> f64 {
        let (whole, f) = (at.floor() as usize, at - at.floor());
        let z = 3f64.sqrt() - 2.0;
        let cubed = |x: f64| x.max(0.0).powi(3);
        let spline = |x: f64| (cubed(2.0 - x.abs()) - 4.0 * cubed(1.0 - x.abs())) / 6.0;
        let coefficient = |k: usize| -> f64 {
            3f64.sqrt() * (k - 20..=k + 20).map(|j| z.powi(j.abs_diff(k) as i32) * value(j)).sum::<f64>()
        };
        (whole - 1..=whole + 2).map(|k| coefficient(k) * spline(whole as f64 + f - k as f64)).sum()
    }

    #[test]
    fn a_line_errs_as_the_law_says() {
        let optics = OpticsConfig::ideal(Illuminant::D65, 4_000.0, Edge::Tile, Windows::Grid);
        let w = lobe_width(4_000.0, BRIGHTEST_NM);
        for size in [1601, 3201] {
            for found in look_up_forecasts(&optics, size, 1e-3) {
                let measured = measured(found.look_up, size, w);
                assert!((measured / found.error - 1.0).abs() < 0.1, "{size} {found:?} {measured:e}");
                // Tables of the size that is named keep the tolerance, those a tenth smaller do not.
                let [enough, less] = [1.02, 0.9]
                    .map(|share| self::measured(found.look_up, (share * found.size_needed as f64) as usize | 1, w));
                assert!(enough <= 1e-3 && less > 1e-3, "{size} {found:?}: {enough:e} {less:e}");
            }
        }
    }

    #[test]
    fn ratios_and_errors_are_inverse() {
        for look_up in LookUp::ALL {
            for error in [1e-9, 1e-4, 1e-3, 0.05, 0.9] {
                let found = look_up.error_at(look_up.ratio_for(error));
                assert!((found / error - 1.0).abs() < 1e-9, "{look_up:?} {error:e}: {found:e}");
            }
            assert_eq!(look_up.ratio_for(0.0), 0.0);
        }
    }
}
