//! The light and the eye: spectral power of illuminants, and the CIE 1931 2° observer.

use serde::{Deserialize, Serialize};

use crate::cie_data;
use crate::direction::Xyz;

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

impl Illuminant {
    /// Relative spectral power at a wavelength; zero outside a table, and for lines, which have no
    /// density.
    pub fn power(&self, wavelength_nm: f64) -> f64 {
        match self {
            Self::D65 => table_at(&cie_data::D65, cie_data::D65_FIRST_NM, wavelength_nm),
            Self::A => incandescent(wavelength_nm),
            Self::E => 1.0,
            Self::F(number) => table_at(
                &cie_data::FLUORESCENT[usize::from(*number).clamp(1, 12) - 1],
                cie_data::FLUORESCENT_FIRST_NM,
                wavelength_nm,
            ),
            Self::Tabulated { wavelength_nm: at, power } => linear(at, power, wavelength_nm),
            Self::Lines(_) => 0.0,
        }
    }

    /// The wavelengths that carry light within `range_nm`: its own ends, or the outermost lines.
    pub fn reach_nm(&self, range_nm: [f64; 2]) -> [f64; 2] {
        let Self::Lines(lines) = self else {
            return range_nm;
        };
        lines
            .iter()
            .fold([f64::MAX, 0.0], |[low, high], line| [low.min(line.wavelength_nm), high.max(line.wavelength_nm)])
    }
}

/// CIE illuminant A by its defining formula (ISO 11664-2): Planck's law at 2848 K, c2 = 1.435e-2 m K.
fn incandescent(wavelength_nm: f64) -> f64 {
    let exponential = |nm: f64| (1.435e7 / (2848.0 * nm)).exp_m1();
    100.0 * (560.0 / wavelength_nm).powi(5) * exponential(560.0) / exponential(wavelength_nm)
}

/// CIE 1931 2° colour-matching functions at a wavelength; zero outside 360 to 830 nm.
pub fn observer_2deg(wavelength_nm: f64) -> Xyz {
    let position = wavelength_nm - cie_data::OBSERVER_FIRST_NM;
    let last = cie_data::OBSERVER_2DEG.len() - 1;
    if !(0.0..=last as f64).contains(&position) {
        return [0.0; 3];
    }
    let index = (position as usize).min(last - 1);
    let share = position - index as f64;
    let (low, high) = (cie_data::OBSERVER_2DEG[index], cie_data::OBSERVER_2DEG[index + 1]);
    std::array::from_fn(|c| low[c] + share * (high[c] - low[c]))
}

fn table_at(table: &[f64], first_nm: f64, wavelength_nm: f64) -> f64 {
    let position = (wavelength_nm - first_nm) / cie_data::ILLUMINANT_STEP_NM;
    if !(0.0..=(table.len() - 1) as f64).contains(&position) {
        return 0.0;
    }
    let index = (position as usize).min(table.len() - 2);
    table[index] + (position - index as f64) * (table[index + 1] - table[index])
}

fn linear(at: &[f64], values: &[f64], x: f64) -> f64 {
    let above = at.partition_point(|&a| a < x);
    if at.get(above) == Some(&x) {
        return values[above];
    }
    if above == 0 || above == at.len() {
        return 0.0;
    }
    let share = (x - at[above - 1]) / (at[above] - at[above - 1]);
    values[above - 1] + share * (values[above] - values[above - 1])
}
