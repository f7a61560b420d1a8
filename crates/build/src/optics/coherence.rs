//! The light's spatial coherence: a width of its own, or what a source of a given size leaves of it at each wavelength.

use std::f64::consts::{PI, SQRT_2};

/// Standard deviation of a coherence window's amplitude, wavelength by wavelength.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coherence {
    light: Light,
    /// Most of it in nm: what a scan resolves.
    most_nm: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Light {
    Constant { sigma_nm: f64 },
    Source { diameter_deg: f64 },
}

impl Coherence {
    /// The same at every wavelength, in nm.
    pub fn constant(sigma_nm: f64) -> Self {
        Self { light: Light::Constant { sigma_nm }, most_nm: f64::INFINITY }
    }

    /// That of a source of this angular diameter in degrees: see [`source_sigma_nm`].
    pub fn of_source(diameter_deg: f64) -> Self {
        Self { light: Light::Source { diameter_deg }, most_nm: f64::INFINITY }
    }

    /// No more of it than so many nm, at any wavelength.
    pub fn at_most(self, most_nm: f64) -> Self {
        Self { most_nm, ..self }
    }

    /// The standard deviation in nm at a wavelength.
    pub fn sigma_nm_at(&self, wavelength_nm: f64) -> f64 {
        let light_nm = match self.light {
            Light::Constant { sigma_nm } => sigma_nm,
            Light::Source { diameter_deg } => source_sigma_nm(diameter_deg, wavelength_nm),
        };
        light_nm.min(self.most_nm)
    }
}

/// Standard deviation in nm of the coherence window's amplitude under an incoherent source, a uniform disc of this angular
/// diameter in degrees: `√2 λ / (π D)`, `D` in radians.
///
/// Such a source blurs what one direction of light shows over (u, v) by its own disc, whose deviation along either axis is
/// `D/4`, at every wavelength. A window of deviation `σ` blurs by a Gaussian of the deviation `λ/(2√2 πσ)`; the two are equal
/// for this `σ`. Its second moments are the disc's, its edge is not: where the disc ends sharply, the Gaussian fades.
pub fn source_sigma_nm(diameter_deg: f64, wavelength_nm: f64) -> f64 {
    SQRT_2 * wavelength_nm / (PI * diameter_deg.to_radians())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The deviation of a uniform disc along an axis, summed over it, is that of what the window of the source blurs by.
    #[test]
    fn a_source_blurs_as_its_disc_does() {
        let (diameter_deg, count) = (0.53f64, 2_000);
        let radius = 0.5 * diameter_deg.to_radians();
        let (mut second, mut area) = (0.0, 0.0);
        for i in 0..count {
            let x = ((f64::from(i) + 0.5) / f64::from(count) * 2.0 - 1.0) * radius;
            let chord = (radius * radius - x * x).sqrt();
            (second, area) = (second + x * x * chord, area + chord);
        }
        let disc = (second / area).sqrt();
        for wavelength_nm in [380.0, 550.0, 780.0] {
            let blur = |diameter_deg: f64| {
                let sigma_nm = Coherence::of_source(diameter_deg).sigma_nm_at(wavelength_nm);
                wavelength_nm / (2.0 * SQRT_2 * PI * sigma_nm)
            };
            assert!((blur(diameter_deg) / disc - 1.0).abs() < 1e-4, "{wavelength_nm}");
            // Half of the diameter where a quarter belongs, and a width that knows no wavelength.
            assert!((blur(2.0 * diameter_deg) / disc - 1.0).abs() > 0.9);
            let constant = Coherence::constant(source_sigma_nm(diameter_deg, 550.0)).sigma_nm_at(wavelength_nm);
            let by_constant = wavelength_nm / (2.0 * SQRT_2 * PI * constant);
            assert_eq!((by_constant / disc - 1.0).abs() < 1e-4, wavelength_nm == 550.0);
        }
    }

    #[test]
    fn a_scan_that_resolves_less_has_the_last_word() {
        let sun = Coherence::of_source(0.53);
        let capped = sun.at_most(sun.sigma_nm_at(550.0));
        assert_eq!(capped.sigma_nm_at(450.0), sun.sigma_nm_at(450.0));
        assert_eq!(capped.sigma_nm_at(650.0), sun.sigma_nm_at(550.0));
        assert_eq!(Coherence::constant(4_000.0).sigma_nm_at(650.0), 4_000.0);
    }
}
