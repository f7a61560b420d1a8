//! What the optics needs to know: illumination, coherence, averaging, material.

pub use diffraction_brdf::front_factor::Factor;
use diffraction_brdf::front_factor::FrontFactor;
pub use diffraction_brdf::material::Material;

use crate::ground::spectrum::Illuminant;

/// What lies beyond the scan's edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Edge {
    /// The scan repeats periodically.
    Tile,
    /// The coherence window lives inside one scan, which must be at least 8 sigma wide.
    Fade,
}

/// Which positions of the coherence window are averaged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Windows {
    /// As many as the scan holds: for `Edge::Tile` the exact mean over every position.
    Grid,
    /// One, in the middle of the scan: keeps the speckle a small coherent spot shows.
    Centre,
}

/// Everything the optics of one specimen depends on, apart from its heights.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct OpticsConfig {
    /// The light's spectrum.
    pub illuminant: Illuminant,
    /// First and last wavelength in nm; ignored for laser lines.
    pub wavelength_nm: [f64; 2],
    /// Standard deviation of the coherence window's amplitude in nm.
    pub sigma_nm: f64,
    /// What lies beyond the scan's edge.
    pub edge: Edge,
    /// Which window positions are averaged.
    pub windows: Windows,
    /// Sets the Fresnel reflectance.
    pub material: Material,
    /// Whether the V-cavity shadowing factor is applied.
    pub shadowing: bool,
    /// Which model of reflection stands in front of the tables; scalar where an older atlas does not say.
    #[serde(default)]
    pub factor: Factor,
}

impl OpticsConfig {
    /// What stands in front of the window's power for a pair of directions.
    pub fn front_factor(&self) -> FrontFactor {
        FrontFactor { material: self.material, shadowing: self.shadowing, factor: self.factor }
    }
}
