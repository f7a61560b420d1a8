//! Spectral tables under a light: XYZ for any illuminant, integrated when asked for.

use std::f64::consts::SQRT_2;

use crate::direction::{Vec3, Xyz, max_abs_w};
use crate::error::Result;
use crate::evaluate::{Interpolation, LookUp};
use crate::spectral::{Pair, SpectralTables};
use crate::spectrum::{Illuminant, Lags, SpectralQuadrature, uniform_wavenumbers};

/// Relative error to which 95 % of an order's pulses in `1/λ` are integrated: a tenth of the tolerance that tables have where nothing
/// is said. Errors add as squares, so that the sum adds half a percent to theirs. Wavelengths grow by a sixth for it (see
/// [`Lags`]).
const TOLERANCE: f64 = 1e-4;

/// Below this radius in (u, v) pulses are as wide as there: the relief sets how many wavelengths are needed.
const RADIUS_MIN: f64 = 0.02;

/// Spectral tables with a light: what wavelengths to sum, for directions at each distance from the mirror direction.
#[derive(Debug, Clone)]
pub struct UnderLight<'a> {
    tables: &'a SpectralTables,
    look_up: LookUp<'a>,
    /// From the outside in: inner radius in (u, v), and the wavelengths from there on outwards.
    rings: Vec<(f64, SpectralQuadrature)>,
}

impl SpectralTables {
    /// The tables under a light, whose spectrum counts from the tables' shortest wavelength to their longest; Y = 1/π for a
    /// white Lambertian surface under that light.
    ///
    /// # Errors
    /// [`Error::Call`](crate::Error::Call) for laser lines shorter than the tables' wavelengths, and a light that the eye
    /// does not see.
    pub fn under(&self, interpolation: Interpolation, illuminant: &Illuminant) -> Result<UnderLight<'_>> {
        self.under_by(LookUp::Values(interpolation), illuminant)
    }

    pub(crate) fn under_by<'a>(&'a self, look_up: LookUp<'a>, illuminant: &Illuminant) -> Result<UnderLight<'a>> {
        if let Illuminant::Lines(lines) = illuminant {
            self.check_wavelengths(&lines.iter().map(|line| line.wavelength_nm).collect::<Vec<_>>())?;
        }
        let range_nm = [self.shortest_nm, self.longest_nm];
        let with_weights = |(inner, count)| Ok((inner, uniform_wavenumbers(illuminant, range_nm, count)?));
        let rings = self.ring_counts(illuminant, range_nm).into_iter().map(with_weights).collect::<Result<_>>()?;
        Ok(UnderLight { tables: self, look_up, rings })
    }

    /// From the outside in: inner radius in (u, v) of an annulus, and how many wavelengths resolve the pulses of its directions.
    pub(crate) fn ring_counts(&self, illuminant: &Illuminant, range_nm: [f64; 2]) -> Vec<(f64, usize)> {
        let lags = Lags { sigma_nm: self.sigma_nm, half_height_range_nm: self.half_height_range_nm };
        let mut rings = Vec::new();
        let (mut outer, is_line) = (2.0, matches!(illuminant, Illuminant::Lines(_)));
        loop {
            let inner = if outer < RADIUS_MIN || is_line { 0.0 } else { outer / SQRT_2 };
            rings.push((inner, lags.wavelengths(illuminant, range_nm, [outer, max_abs_w(inner)], TOLERANCE)));
            if inner == 0.0 {
                return rings;
            }
            outer = inner;
        }
    }
}

impl UnderLight<'_> {
    /// XYZ of the BRDF in 1/sr; zero for directions that are not above the surface.
    pub fn eval(&self, wi: Vec3, wo: Vec3) -> Xyz {
        let mut xyz = [0.0; 3];
        if !(wi[2] > 0.0 && wo[2] > 0.0) {
            return xyz;
        }
        let pair = Pair::of(self.tables.front_factor, wi, wo);
        let radius = pair.radius();
        let ring = self.rings.iter().find(|(inner, _)| radius >= *inner);
        let Some((_, SpectralQuadrature { wavelengths_nm, weights })) = ring else { return [f64::NAN; 3] };
        for (nm, weight) in wavelengths_nm.iter().zip(weights) {
            let value = self.tables.eval_pair(self.look_up, &pair, *nm);
            xyz.iter_mut().zip(weight).for_each(|(sum, weight)| *sum += weight * value);
        }
        xyz
    }
}
