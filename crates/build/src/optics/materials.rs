//! Materials of optics: the same at every wavelength, or as tables and the reference take one that is not.
//!
//! The reference has the front factor of every wavelength. Tables of X, Y, Z, read with one front factor, have it at one
//! wavelength, the material's *reference wavelength*. Of the diffuse part and the cross term they hold how the reflectance at
//! normal incidence differs from the one there, `D(λ, wi, wo) ≈ D(λ0, wi, wo) R(λ, 1) / R(λ0, 1)`; of the coherent lobe, whose
//! texels know the angle `θd` at which it is reflected, `R(λ, cos θd) / R(λ0, cos θd)`, which is exact.

use diffraction_brdf::dispersion::Dispersion;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::material::{Material, reflectance};
use diffraction_brdf::spectrum::{SpectralQuadrature, filtered_wavenumbers, uniform_wavelengths, uniform_wavenumbers};

use super::config::OpticsConfig;
use super::dispersive::Dispersive;

/// Step in nm of the mean over wavelengths that gives the reference wavelength.
const STEP_NM: f64 = 1.0;

impl OpticsConfig {
    /// Takes a material from a table: `material` becomes its index at the reference wavelength.
    ///
    /// That is the mean wavelength of the light that the material reflects at normal incidence, as bright as it is seen. Where the
    /// front factor's share in a wavelength is a straight line, its mean over the light is its value there; for one laser line
    /// nothing is approximated.
    ///
    /// # Errors
    /// [`Error::Call`] for a table that does not hold the light's wavelengths, or reflects nothing of it; an invisible light.
    pub fn set_dispersion(&mut self, table: Dispersion) -> Result<()> {
        let light_nm = self.illuminant.reach_nm(self.wavelength_nm);
        check_range(&table, light_nm)?;
        let SpectralQuadrature { wavelengths_nm, weights } =
            uniform_wavelengths(&self.illuminant, self.wavelength_nm, STEP_NM)?;
        let (mut sum, mut moment) = (0.0, 0.0);
        for (&nm, weight) in wavelengths_nm.iter().zip(&weights) {
            let reflected = table.material_at(nm).map_or(0.0, |material| weight[1] * reflectance(material, 1.0));
            sum += reflected;
            moment += nm * reflected;
        }
        let reference_nm = (moment / sum).clamp(light_nm[0], light_nm[1]);
        let material = table.material_at(reference_nm).filter(|material| reflectance(*material, 1.0) > 0.0);
        let Some(material) = material else {
            return Err(Error::Call(format!("{} reflects nothing of the light", table.name())));
        };
        self.material = material;
        self.dispersion = Some(Dispersive { reference_nm, table });
        Ok(())
    }

    /// Takes a material that is the same at every wavelength.
    pub fn set_material(&mut self, material: Material) {
        self.material = material;
        self.dispersion = None;
    }

    /// Refuses wavelengths in nm at which the material is not known.
    ///
    /// # Errors
    /// [`Error::Call`] with the wavelengths at which it is.
    pub fn check_material_at(&self, wavelengths_nm: &[f64]) -> Result<()> {
        let Some(Dispersive { table, .. }) = &self.dispersion else { return Ok(()) };
        let ends = wavelengths_nm.iter().fold([f64::INFINITY, 0.0f64], |[low, high], &nm| [low.min(nm), high.max(nm)]);
        if wavelengths_nm.is_empty() { Ok(()) } else { check_range(table, ends) }
    }

    /// So many uniform wavenumbers with the XYZ weights of the light.
    ///
    /// # Errors
    /// `Error::Call` for an invisible light.
    pub fn quadrature(&self, count: usize) -> Result<SpectralQuadrature> {
        uniform_wavenumbers(&self.illuminant, self.wavelength_nm, count)
    }

    /// So many uniform wavenumbers with the XYZ weights of tables: under a material of its own colour they hold it as
    /// [`Dispersive::relative_reflectance`].
    ///
    /// # Errors
    /// `Error::Call` for an invisible light.
    pub fn tables_quadrature(&self, count: usize) -> Result<SpectralQuadrature> {
        match &self.dispersion {
            None => self.quadrature(count),
            Some(dispersive) => filtered_wavenumbers(&self.illuminant, self.wavelength_nm, count, |nm| {
                dispersive.relative_reflectance(nm)
            }),
        }
    }
}

fn check_range(table: &Dispersion, [low_nm, high_nm]: [f64; 2]) -> Result<()> {
    let [first, last] = table.range_nm();
    if low_nm >= first && high_nm <= last {
        return Ok(());
    }
    let asked = if low_nm == high_nm { format!("at {low_nm} nm") } else { format!("from {low_nm} to {high_nm} nm") };
    Err(Error::Call(format!("{} is known from {first} to {last} nm, and asked for {asked}", table.name())))
}
