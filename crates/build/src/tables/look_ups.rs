//! What look-ups between texels err by, before there are tables; and how many texels would keep a tolerance.
//!
//! What a surface does is blurred by the coherence window: the sharpest thing in tables is a line of the window's own width, a
//! Gaussian of the deviation `w` in (u, v). Between texels `Δ` apart a linear look-up errs at its peak by `Δ²/8` times the second
//! derivative, `1/w²`, a cubic through four texels by `3/128 Δ⁴` times the fourth, `3/w⁴`; the two axes add. At the wavelength that
//! the eye sees best that is what 95 % of lit directions keep, by a factor of about two: `docs/accuracy.md` has it measured.

use serde::Serialize;

use super::resolution::lobe_width;
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
    /// Both.
    pub const ALL: [Self; 2] = [Self::Linear, Self::Cubic];

    /// Order of the error in the distance of texels over the line's deviation, and the error at a ratio of 1.
    fn law(self) -> (i32, f64) {
        match self {
            Self::Linear => (2, 1.0 / 8.0),
            Self::Cubic => (4, 9.0 / 128.0),
        }
    }

    /// Texels a side that keep a tolerance, given how far tables of another size are off.
    pub fn size_for(self, tolerance: f64, size: usize, error: f64) -> usize {
        let texels = (size - 1) as f64 * (error / tolerance).powf(1.0 / f64::from(self.law().0));
        2 * (0.5 * texels).ceil().min(SIZE_MAX) as usize + 1
    }
}

/// What look-ups in tables of this size err by.
pub(super) fn look_up_forecasts(optics: &OpticsConfig, size: usize, tolerance: f64) -> [LookUpForecast; 2] {
    let [low_nm, high_nm] = optics.illuminant.reach_nm(optics.wavelength_nm);
    let nm = BRIGHTEST_NM.clamp(low_nm, high_nm);
    let ratio = 4.0 / (size - 1) as f64 / lobe_width(optics.body_coherence().sigma_nm_at(nm), nm);
    LookUp::ALL.map(|look_up| {
        let (order, at_one) = look_up.law();
        let error = at_one * ratio.powi(order);
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
    fn measured(interpolation: Interpolation, size: usize, w: f64) -> f64 {
        let texel = 4.0 / (size - 1) as f64;
        let line = |x: f64| (-0.5 * (x / w).powi(2)).exp();
        let mut worst = 0.0f64;
        for shift in 0..16 {
            let centre = f64::from(shift) / 16.0 * texel;
            for place in 0..40 {
                let at = (size / 2) as f64 + f64::from(place) / 20.0 - 1.0;
                let (first, weights) = stencil(interpolation, at, size);
                let value = |index: usize| line(-2.0 + index as f64 * texel - centre);
                let found: f64 =
                    weights.iter().enumerate().map(|(i, weight)| weight * value((first + i).min(size - 1))).sum();
                worst = worst.max((found - line(-2.0 + at * texel - centre)).abs());
            }
        }
        worst
    }

    #[test]
    fn a_line_errs_as_the_law_says() {
        let optics = OpticsConfig::ideal(Illuminant::D65, 4_000.0, Edge::Tile, Windows::Grid);
        let w = lobe_width(4_000.0, BRIGHTEST_NM);
        for size in [801, 1601, 3201] {
            for found in look_up_forecasts(&optics, size, 1e-3) {
                let interpolation = match found.look_up {
                    LookUp::Linear => Interpolation::Bilinear,
                    LookUp::Cubic => Interpolation::Cubic,
                };
                let measured = measured(interpolation, size, w);
                assert!((measured / found.error - 1.0).abs() < 0.1, "{size} {found:?} {measured:e}");
                // Tables of the size that is named keep the tolerance, those a tenth smaller do not.
                let [enough, less] = [1.02, 0.9]
                    .map(|share| self::measured(interpolation, (share * found.size_needed as f64) as usize | 1, w));
                assert!(enough <= 1e-3 && less > 1e-3, "{size} {found:?}: {enough:e} {less:e}");
            }
        }
    }
}
