//! A prepared scan, with what several checks need of it.

use crate::height::HeightField;
use crate::height::statistics::spectrum::Spectrum;

/// What the checks share of a prepared scan, worked out once.
pub(super) struct Prepared<'a> {
    /// The heights as they were prepared.
    pub(super) field: &'a HeightField,
    /// The same about their best plane.
    pub(super) levelled: HeightField,
    /// Root mean square in nm of the latter, above 0.
    pub(super) rms_nm: f64,
    /// Their power spectrum under a Hann window.
    pub(super) spectrum: Spectrum,
}
