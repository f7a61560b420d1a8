//! Illuminants and the CIE 1931 2° observer: what turns a spectral BRDF into XYZ.

mod illuminant;
mod pulses;
mod quadrature;
mod wavenumbers;

pub use illuminant::{Illuminant, Line, observer_2deg};
pub use pulses::{Lags, VISIBLE_NM};
pub use quadrature::{SpectralQuadrature, uniform_wavelengths};
pub use wavenumbers::{filtered_wavenumbers, uniform_wavenumbers};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::direction::Xyz;

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
