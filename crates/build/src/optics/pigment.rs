//! A pigment below the structure: a matt body whose light passes the transparent surface twice, on its way in and out.
//!
//! `f = (1 - R(θi)) (1 - R(θo)) ρ / π`, with the Fresnel reflectance `R` of the flat surface and the albedo `ρ`. What the
//! structure reflects never reaches the pigment, so no light is counted twice: where the structure returns `R(θi)` in all, as
//! a lossless relief does, both together return at most the light that comes in. Left out are the relief's slopes, which
//! bend light on its way through, and light that the surface throws back to the pigment from below.

use crate::ground::colour::xyz_to_linear_srgb;
use diffraction_brdf::direction::{Vec3, Xyz, dot};
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_brdf::spectrum::{Illuminant, uniform_wavelengths};

use super::config::{Material, OpticsConfig};
use diffraction_brdf::material::reflectance;
use diffraction_brdf::table_set::TableSet;

/// A pigment under one illuminant.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Pigment {
    /// Share of the light that it reflects, as linear sRGB under daylight D65.
    pub albedo: [f64; 3],
    /// Refractive index of the transparent surface.
    pub n: f64,
    /// Its BRDF without the surface, in 1/sr: the XYZ of the albedo under the tables' illuminant, over π.
    pub xyz_per_sr: Xyz,
}

/// Where the reflectance spectrum that stands for an albedo changes, in nm.
///
/// It is constant in three bands: their colours span all of sRGB under D65 with nothing below 0 or above 1, and white is 1
/// throughout (MacAdam's optimal colours have edges near these wavelengths).
const BANDS_NM: [f64; 2] = [490.0, 590.0];

/// Step of the integrals over the bands in nm: that of the observer's table.
const STEP_NM: f64 = 1.0;

/// A pigment of this albedo, linear sRGB, each component in [0, 1], below the surface of these optics.
///
/// # Errors
/// `Error::Call` for a material that lets no light through, or an albedo out of range.
pub fn pigment(albedo: [f64; 3], optics: &OpticsConfig) -> Result<Pigment> {
    let Material::Dielectric { n } = optics.material else {
        return Err(Error::Call(
            "a pigment shows through a transparent material only: give material = { n = 1.56 }".into(),
        ));
    };
    if !albedo.iter().all(|share| (0.0..=1.0).contains(share)) {
        return Err(Error::Call(format!("albedo = {albedo:?} must lie between 0 and 1")));
    }
    let shares = band_shares(albedo)?;
    let bands = band_colours(&optics.illuminant, optics.wavelength_nm)?;
    let xyz = |c: usize| (0..3).map(|band| shares[band] * bands[band][c]).sum::<f64>();
    Ok(Pigment { albedo, n, xyz_per_sr: std::array::from_fn(|c| xyz(c) * std::f64::consts::FRAC_1_PI) })
}

/// XYZ of its BRDF in 1/sr; 0 for directions not above the surface.
pub fn pigment_xyz(pigment: &Pigment, wi: Vec3, wo: Vec3) -> Xyz {
    if !(wi[2] > 0.0 && wo[2] > 0.0) {
        return [0.0; 3];
    }
    let passed = [wi, wo].map(|direction| 1.0 - reflectance(Material::Dielectric { n: pigment.n }, direction[2]));
    pigment.xyz_per_sr.map(|c| passed[0] * passed[1] * c)
}

/// What pictures show of a specimen: its tables and, where there is one, the pigment below the structure.
#[derive(Debug, Clone, Copy)]
pub struct Surface<'a> {
    /// The structure's tables.
    pub tables: &'a TableSet,
    /// The pigment; the tables do not contain it, nor does the BRDF.
    pub pigment: Option<&'a Pigment>,
}

impl<'a> Surface<'a> {
    /// The structure alone.
    pub fn without_pigment(tables: &'a TableSet) -> Self {
        Self { tables, pigment: None }
    }

    /// Its XYZ in 1/sr, as [`brdf_xyz`] otherwise.
    pub fn xyz(&self, interpolation: Interpolation, wi: Vec3, wo: Vec3) -> Xyz {
        let brdf = brdf_xyz(self.tables, interpolation, wi, wo);
        match self.pigment {
            None => brdf,
            Some(pigment) => {
                let below = pigment_xyz(pigment, wi, wo);
                std::array::from_fn(|c| brdf[c] + below[c])
            }
        }
    }
}

/// XYZ of each band under an illuminant; together they are its white.
fn band_colours(illuminant: &Illuminant, range_nm: [f64; 2]) -> Result<[Xyz; 3]> {
    let quadrature = uniform_wavelengths(illuminant, range_nm, STEP_NM)?;
    let mut bands = [[0.0; 3]; 3];
    for (&nm, weight) in quadrature.wavelengths_nm.iter().zip(&quadrature.weights) {
        let band = BANDS_NM.iter().filter(|&&edge| nm >= edge).count();
        bands[band].iter_mut().zip(weight).for_each(|(sum, c)| *sum += c);
    }
    Ok(bands)
}

/// Reflectance in each band of a surface that shows this linear sRGB under D65.
fn band_shares(rgb: [f64; 3]) -> Result<[f64; 3]> {
    let colours = band_colours(&Illuminant::D65, [380.0, 780.0])?.map(xyz_to_linear_srgb);
    let cross = |a: Vec3, b: Vec3| [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let volume = dot(colours[0], cross(colours[1], colours[2]));
    // White is 1 to the four digits that the primaries are given in.
    Ok(std::array::from_fn(|band| {
        (dot(rgb, cross(colours[(band + 1) % 3], colours[(band + 2) % 3])) / volume).min(1.0)
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::config::{Edge, Windows};
    use std::f64::consts::PI;

    fn optics(illuminant: Illuminant, material: Material) -> OpticsConfig {
        OpticsConfig { material, ..OpticsConfig::ideal(illuminant, 4000.0, Edge::Tile, Windows::Grid) }
    }

    const KERATIN: Material = Material::Dielectric { n: 1.56 };

    #[test]
    fn under_daylight_an_albedo_is_its_colour() {
        for albedo in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.45, 0.16, 0.05], [0.2; 3]] {
            assert!(band_shares(albedo).unwrap().iter().all(|share| (0.0..=1.0).contains(share)), "{albedo:?}");
            let found = pigment(albedo, &optics(Illuminant::D65, KERATIN)).unwrap();
            let rgb = xyz_to_linear_srgb(found.xyz_per_sr.map(|c| PI * c));
            // The primaries' matrix has white right to 2e-4.
            assert!(rgb.iter().zip(albedo).all(|(a, b)| (a - b).abs() < 3e-4), "{albedo:?}: {rgb:?}");
        }
    }

    #[test]
    fn under_one_wavelength_an_albedo_is_one_number() {
        let line =
            |wavelength_nm| Illuminant::Lines(vec![diffraction_brdf::spectrum::Line { wavelength_nm, power: 1.0 }]);
        let orange = [0.5, 0.2, 0.04];
        let luminance = |nm| PI * pigment(orange, &optics(line(nm), KERATIN)).unwrap().xyz_per_sr[1];
        // A red laser has Y = 1 of its own, whatever its colour: the band's reflectance remains.
        let shares = band_shares(orange).unwrap();
        for (nm, share) in [(450.0, shares[0]), (532.0, shares[1]), (633.0, shares[2])] {
            assert!((luminance(nm) - share).abs() < 1e-12);
        }
        assert!(shares[2] > shares[1] && shares[1] > shares[0]);
    }

    #[test]
    fn what_comes_back_is_what_passes_the_surface_twice() {
        let n: f64 = 1.5;
        let white = pigment([1.0; 3], &optics(Illuminant::E, Material::Dielectric { n })).unwrap();
        let full = white.xyz_per_sr[1];
        assert!((PI * full - 1.0).abs() < 3e-4, "white to the primaries' digits: {full}");
        let up = [0.0, 0.0, 1.0];
        let straight = pigment_xyz(&white, up, up)[1] / full;
        assert!((straight - 0.96 * 0.96).abs() < 1e-12, "{straight}");
        // Into the hemisphere goes 0.96 times what a surface passes of diffuse light, 1 - 0.0918 (Walsh 1926):
        let n2 = n * n;
        let walsh = 0.5
            + (n - 1.0) * (3.0 * n + 1.0) / (6.0 * (n + 1.0).powi(2))
            + n2 * (n2 - 1.0).powi(2) / (n2 + 1.0).powi(3) * ((n - 1.0) / (n + 1.0)).ln()
            - 2.0 * n.powi(3) * (n2 + 2.0 * n - 1.0) / ((n2 + 1.0) * (n2 * n2 - 1.0))
            + 8.0 * n2 * n2 * (n2 * n2 + 1.0) / ((n2 + 1.0) * (n2 * n2 - 1.0).powi(2)) * n.ln();
        assert!((walsh - 0.0918).abs() < 5e-5, "{walsh}");
        let steps = 20_000;
        let power: f64 = (0..steps)
            .map(|k| {
                let cos2 = (f64::from(k) + 0.5) / f64::from(steps);
                pigment_xyz(&white, up, [(1.0 - cos2).sqrt(), 0.0, cos2.sqrt()])[1] / full / f64::from(steps)
            })
            .sum();
        assert!((power / (0.96 * (1.0 - walsh)) - 1.0).abs() < 1e-5, "{power}");
        assert_eq!(pigment_xyz(&white, up, [1.0, 0.0, 0.0]), [0.0; 3]);
    }

    #[test]
    fn what_lets_no_light_through_has_no_pigment() {
        for material in [Material::Ideal, Material::Conductor { n: 0.2, k: 3.4 }] {
            let error = pigment([0.5; 3], &optics(Illuminant::D65, material)).unwrap_err().to_string();
            assert!(error.contains("transparent"), "{error}");
        }
        assert!(pigment([0.5, 0.5, f64::NAN], &optics(Illuminant::D65, KERATIN)).is_err());
        assert!(pigment([0.5, 1.1, 0.5], &optics(Illuminant::D65, KERATIN)).is_err());
    }
}
