//! What the optics needs to know: illumination, coherence, averaging, material.

pub use diffraction_brdf::front_factor::Factor;
use diffraction_brdf::front_factor::FrontFactor;
pub use diffraction_brdf::material::Material;

use super::coherence::{Coherence, source_sigma_nm};
use super::dispersive::Dispersive;
use crate::height::HeightField;
use crate::height::statistics::is_whole_grating;
use diffraction_brdf::spectrum::Illuminant;

/// What lies beyond the scan's edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Edge {
    /// The scan repeats, and the diffuse part is blurred by as much as the scan's size asks for, so that the repetition does
    /// not show; the coherent lobe, whose form is known, keeps the light's own width.
    Auto,
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
    /// Standard deviation of the coherence window's amplitude in nm: of the light's, or with `Edge::Auto` of as much of it as
    /// the scan resolves. Under a source of fixed size the largest over the light's wavelengths.
    pub sigma_nm: f64,
    /// That of the light, where the scan resolves less: it shapes the coherent lobe alone. Under a source of fixed size the
    /// largest over the light's wavelengths.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lobe_sigma_nm: Option<f64>,
    /// Angular diameter of the light's source in degrees, where that sets the coherence: its window then grows with the
    /// wavelength ([`source_sigma_nm`]), and only the mean over all positions of a repeated scan takes it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub source_deg: Option<f64>,
    /// Whether `sigma_nm` is as much as the scans tell, whatever the light's may be: [`OpticsConfig::for_scans`] then sets it.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub sigma_follows_scan: bool,
    /// What lies beyond the scan's edge.
    pub edge: Edge,
    /// Which window positions are averaged.
    pub windows: Windows,
    /// Sets the Fresnel reflectance; where the index depends on the wavelength, that at one of them.
    pub material: Material,
    /// How the material's index depends on the wavelength; `None` where it does not. Set by `OpticsConfig::set_dispersion`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dispersion: Option<Dispersive>,
    /// Whether the V-cavity shadowing factor is applied.
    pub shadowing: bool,
    /// Which model of reflection stands in front of the tables; scalar where an older atlas does not say.
    #[serde(default)]
    pub factor: Factor,
}

/// Sides of a repeated scan in standard deviations of the window, from which on its repetition does not show.
///
/// The mean power of a scan of side `L` that repeats is lines `1/L` apart, each a Gaussian of the deviation `1/(2√2 πσ)`. The
/// first harmonic of their sum is [`ripple`]: 3.7 % at four deviations.
pub const TILE_SIGMAS: f64 = 4.0;

/// The same for a repetition that is not warned of: the [`ripple`] is 2 %.
pub const QUIET_TILE_SIGMAS: f64 = 4.3;

/// Sides of a scan in standard deviations of a window that stays inside it.
pub const FADE_SIGMAS: f64 = 8.0;

/// Amplitude of the ripple between the lines of a repeated scan, relative to their mean power: `2 exp(-L²/4σ²)`, by Poisson's
/// sum over the Gaussians of [`TILE_SIGMAS`].
pub fn ripple(side_nm: f64, sigma_nm: f64) -> f64 {
    2.0 * (-0.25 * (side_nm / sigma_nm).powi(2)).exp()
}

/// The shorter side of a scan in nm, not counting an axis of one sample, along which a surface has no structure.
pub fn smallest_side_nm(field: &HeightField) -> f64 {
    let sampled = field.size().into_iter().zip(field.extent_nm()).filter(|(count, _)| *count > 1);
    sampled.map(|(_, side_nm)| side_nm).fold(f64::INFINITY, f64::min)
}

impl OpticsConfig {
    /// An ideal reflector under the scalar factor, seen at 380 to 780 nm: whatever else it is can be set by struct update,
    /// `OpticsConfig { material, ..OpticsConfig::ideal(illuminant, sigma_nm, edge, windows) }`.
    pub fn ideal(illuminant: Illuminant, sigma_nm: f64, edge: Edge, windows: Windows) -> Self {
        Self {
            illuminant,
            wavelength_nm: [380.0, 780.0],
            sigma_nm,
            lobe_sigma_nm: None,
            source_deg: None,
            sigma_follows_scan: false,
            edge,
            windows,
            material: Material::Ideal,
            dispersion: None,
            shadowing: false,
            factor: Factor::Scalar,
        }
    }

    /// Standard deviation in nm of the light's coherence window; under a source of fixed size the largest over its
    /// wavelengths.
    pub fn lobe_sigma_nm(&self) -> f64 {
        self.lobe_sigma_nm.unwrap_or(self.sigma_nm)
    }

    /// The light's coherence, which shapes the lobe.
    pub fn lobe_coherence(&self) -> Coherence {
        self.source_deg.map_or(Coherence::constant(self.lobe_sigma_nm()), Coherence::of_source)
    }

    /// As much of it as the scan resolves, which shapes everything else.
    pub fn body_coherence(&self) -> Coherence {
        match (self.source_deg, self.lobe_sigma_nm) {
            (None, _) => Coherence::constant(self.sigma_nm),
            (Some(source_deg), None) => Coherence::of_source(source_deg),
            (Some(source_deg), Some(_)) => Coherence::of_source(source_deg).at_most(self.sigma_nm),
        }
    }

    /// Smallest standard deviation in nm of the body's window over the light's wavelengths.
    pub fn least_sigma_nm(&self) -> f64 {
        self.body_coherence().sigma_nm_at(self.illuminant.reach_nm(self.wavelength_nm)[0])
    }

    /// The same under a source of this angular diameter in degrees.
    pub fn with_source(&self, source_deg: f64) -> Self {
        let longest_nm = self.illuminant.reach_nm(self.wavelength_nm)[1];
        let sigma_nm = source_sigma_nm(source_deg, longest_nm);
        Self { sigma_nm, lobe_sigma_nm: None, source_deg: Some(source_deg), sigma_follows_scan: false, ..self.clone() }
    }

    /// The same with a sigma that follows the scans; `unlimited_nm` holds for those that resolve any.
    pub fn with_sigma_of_scans(&self, unlimited_nm: f64) -> Self {
        Self { sigma_nm: unlimited_nm, lobe_sigma_nm: None, source_deg: None, sigma_follows_scan: true, ..self.clone() }
    }

    /// Sides of a scan in sigmas, where sigma follows it: as small as the edge lets a side be.
    pub fn sides_in_sigmas(&self) -> f64 {
        match self.edge {
            Edge::Auto => TILE_SIGMAS,
            Edge::Tile => QUIET_TILE_SIGMAS,
            Edge::Fade => FADE_SIGMAS,
        }
    }

    /// The same for these scans: with `Edge::Auto` the diffuse part takes no more of the coherence than the smallest of them
    /// resolves, [`TILE_SIGMAS`] standard deviations a side; a whole number of a grating's periods resolves any, for its
    /// repetition is the grating. Every line of the repeated scan is then blurred into its neighbours, and
    /// what is left of the gaps between lines is [`ripple`].
    pub fn for_scans(&self, fields: &[HeightField]) -> Self {
        let mut optics = self.source_deg.map_or_else(|| self.clone(), |source_deg| self.with_source(source_deg));
        if self.sigma_follows_scan {
            let sides_nm = fields.iter().filter(|field| self.edge == Edge::Fade || !is_whole_grating(field));
            let told_nm = sides_nm.map(smallest_side_nm).filter(|side_nm| side_nm.is_finite());
            let smallest_nm = told_nm.fold(f64::INFINITY, f64::min);
            if smallest_nm.is_finite() {
                optics.sigma_nm = smallest_nm / self.sides_in_sigmas();
            }
        } else if self.edge == Edge::Auto {
            let light_nm = optics.lobe_sigma_nm();
            let told_nm = fields.iter().filter(|field| !is_whole_grating(field)).map(smallest_side_nm);
            optics.sigma_nm = told_nm.map(|side_nm| side_nm / TILE_SIGMAS).fold(light_nm, f64::min);
            optics.lobe_sigma_nm = (optics.sigma_nm < light_nm).then_some(light_nm);
        }
        optics
    }

    /// What stands in front of the window's power for a pair of directions.
    pub fn front_factor(&self) -> FrontFactor {
        FrontFactor { material: self.material, shadowing: self.shadowing, factor: self.factor }
    }
}
