//! A material whose index depends on the wavelength, beside the one wavelength that stands for all.

use diffraction_brdf::dispersion::Dispersion;
use diffraction_brdf::material::{Material, reflectance};
use serde::{Deserialize, Serialize};

/// A table of an index, with the wavelength at which front factors of tables have it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Dispersive {
    /// Wavelength in nm of the optics' constant material.
    pub reference_nm: f64,
    /// The index.
    pub table: Dispersion,
}

impl Dispersive {
    /// The material at a wavelength in nm within the light's, which `OpticsConfig::set_dispersion` has compared with the table.
    pub fn material_at(&self, wavelength_nm: f64) -> Material {
        let material = self.table.material_at(wavelength_nm);
        material.unwrap_or_else(|| {
            panic!("{} is not known at {wavelength_nm} nm, which is checked before", self.table.name())
        })
    }

    /// Reflectance at normal incidence at a wavelength in nm, relative to that at the reference wavelength.
    pub fn relative_reflectance(&self, wavelength_nm: f64) -> f64 {
        let [here, there] = [wavelength_nm, self.reference_nm].map(|nm| reflectance(self.material_at(nm), 1.0));
        here / there
    }
}
