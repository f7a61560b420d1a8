//! Illuminants and the CIE 1931 2° observer: what turns a spectral BRDF into XYZ.

mod pulses;
mod wavenumbers;

pub use pulses::wavenumbers_for_pulses;
pub use wavenumbers::uniform_wavenumbers;

use serde::{Deserialize, Serialize};

use super::cie_data;
use diffraction_brdf::direction::Xyz;
use diffraction_brdf::error::{Error, Result};

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

/// A quadrature for XYZ: `XYZ = Σ weights[j] f(wavelengths_nm[j])`, normalised so that `f = 1` has
/// `Y = 1`.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectralQuadrature {
    /// Wavelengths in nm.
    pub wavelengths_nm: Vec<f64>,
    /// Weights for X, Y, Z at each wavelength.
    pub weights: Vec<Xyz>,
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

/// Trapezoid rule on a uniform wavelength grid: plain, for the reference. Lines stay themselves.
///
/// # Errors
/// `Error::Call` if the light has no luminous power within the range.
pub fn uniform_wavelengths(illuminant: &Illuminant, range_nm: [f64; 2], step_nm: f64) -> Result<SpectralQuadrature> {
    if let Illuminant::Lines(lines) = illuminant {
        return lines_quadrature(lines);
    }
    let [first, last] = range_nm;
    let intervals = ((last - first) / step_nm).ceil().max(1.0) as usize;
    let step = (last - first) / intervals as f64;
    let wavelengths_nm: Vec<f64> = (0..=intervals).map(|i| first + i as f64 * step).collect();
    let weights = wavelengths_nm
        .iter()
        .enumerate()
        .map(|(i, &nm)| {
            let end = if i == 0 || i == intervals { 0.5 } else { 1.0 };
            observer_2deg(nm).map(|c| end * step * illuminant.power(nm) * c)
        })
        .collect();
    normalised(wavelengths_nm, weights)
}

fn lines_quadrature(lines: &[Line]) -> Result<SpectralQuadrature> {
    let weights = lines.iter().map(|l| observer_2deg(l.wavelength_nm).map(|c| c * l.power)).collect();
    normalised(lines.iter().map(|l| l.wavelength_nm).collect(), weights)
}

fn normalised(wavelengths_nm: Vec<f64>, mut weights: Vec<Xyz>) -> Result<SpectralQuadrature> {
    let luminous: f64 = weights.iter().map(|w| w[1]).sum();
    if !(luminous.is_finite() && luminous > 0.0) {
        return Err(Error::Call(
            "the illuminant has no luminous power within `wavelength_nm`: XYZ cannot be normalised \
             (the observer sees 360 to 830 nm)"
                .into(),
        ));
    }
    for weight in &mut weights {
        *weight = weight.map(|w| w / luminous);
    }
    Ok(SpectralQuadrature { wavelengths_nm, weights })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn integrate(q: &SpectralQuadrature, f: impl Fn(f64) -> f64) -> Xyz {
        let mut sum = [0.0; 3];
        for (nm, weight) in q.wavelengths_nm.iter().zip(&q.weights) {
            for c in 0..3 {
                sum[c] += weight[c] * f(*nm);
            }
        }
        sum
    }

    #[test]
    fn white_points_meet_the_published_ones() {
        // CIE 15:2018, table of XYZ of the illuminants (2° observer, 380 to 780 nm).
        let cases = [
            (Illuminant::D65, [0.95047, 1.08883]),
            (Illuminant::A, [1.09850, 0.35585]),
            (Illuminant::E, [1.00000, 1.00000]),
            (Illuminant::F(2), [0.99186, 0.67393]),
            (Illuminant::F(11), [1.00962, 0.64350]),
        ];
        for (illuminant, [x, z]) in cases {
            let white = integrate(&uniform_wavelengths(&illuminant, [380.0, 780.0], 5.0).unwrap(), |_| 1.0);
            // Published whites are plain sums over 5 nm from 360 to 830 nm: the ends left out here
            // (and halved at 380 and 780 nm) carry below 3e-4 of X and Z.
            assert!((white[0] - x).abs() < 3e-4 && (white[2] - z).abs() < 3e-4, "{illuminant:?} {white:?}");
            assert!((white[1] - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn lines_are_a_plain_sum_and_the_invisible_is_refused() {
        let line = |nm| Illuminant::Lines(vec![Line { wavelength_nm: nm, power: 2.0 }]);
        let q = uniform_wavenumbers(&line(555.0), [380.0, 780.0], 99).unwrap();
        assert_eq!(q.wavelengths_nm, [555.0]);
        assert!((q.weights[0][1] - 1.0).abs() < 1e-15);
        assert!(uniform_wavelengths(&line(1064.0), [200.0, 2500.0], 1.0).is_err());
    }
}
