//! Illuminants and the CIE 1931 2° observer: what turns a spectral BRDF into XYZ.

use serde::{Deserialize, Serialize};

/// One line of a line spectrum.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Line {
    /// Wavelength in nm.
    pub wavelength_nm: f64,
    /// Relative power.
    pub power: f64,
}

/// The relative spectral power of the light.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Illuminant {
    /// CIE daylight, 6504 K.
    D65,
    /// CIE incandescent light, 2856 K.
    A,
    /// Equal energy.
    E,
    /// CIE fluorescent lamp F1 to F12.
    F(u8),
    /// Samples, linear in between and zero outside.
    Tabulated {
        /// Strictly increasing wavelengths in nm.
        wavelength_nm: Vec<f64>,
        /// Relative power at each.
        power: Vec<f64>,
    },
    /// Laser lines; no integration, a plain sum.
    Lines(Vec<Line>),
}
