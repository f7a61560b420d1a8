//! Which colours a specimen shows from which angles: what a goniometer would see, looked up in the tables.
//!
//! [`Goniometry`] has maps over all viewing directions, strips over the angle of the classical set-ups, the brightest
//! directions with their spectra, and a sentence that says what they show. All values are radiance factors: the radiance
//! relative to that of a white diffuser in the same light, `π f`.

mod brightest;
mod instrument;
mod maps;
mod strips;
mod words;

use serde::{Deserialize, Serialize};

pub use brightest::BrightDirection;
pub use maps::ReflectionMap;
pub use strips::{Plane, SetUp, Strip};

use std::path::Path;

use diffraction_brdf::SpectralTables;
use diffraction_brdf::error::Result;
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::optics::pigment::Surface;
use instrument::Instrument;

/// What a goniometer sees of a specimen.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Goniometry {
    /// Angular diameter in degrees over which strips and spectra are averaged.
    pub acceptance_deg: f64,
    /// In words, where the colours are.
    pub sentence: String,
    /// Over all viewing directions, for each direction of the light.
    pub maps: Vec<ReflectionMap>,
    /// Over the angle of each set-up, in each plane.
    pub strips: Vec<Strip>,
    /// The mirror's direction and the brightest ones beside it, in light from straight above.
    pub brightest: Vec<BrightDirection>,
}

/// Evaluates them, and writes the maps' pictures into the specimen's folder.
///
/// `None` for tables restricted to scenes, which have no answer for most directions.
///
/// # Errors
/// The disk's, and a light without power in the range of wavelengths.
pub(crate) fn goniometry(
    surface: Surface,
    spectral: Option<&SpectralTables>,
    optics: &OpticsConfig,
    folder: &Path,
    name: &str,
) -> Result<Option<Goniometry>> {
    if surface.tables.restriction.is_some() {
        return Ok(None);
    }
    let instrument = Instrument::new(surface, optics)?;
    let maps = maps::maps(&instrument, folder, name)?;
    let strips = strips::strips(&instrument)?;
    let brightest = brightest::brightest(&instrument, &maps[0].1, spectral)?;
    let sentence = words::sentence(&strips, instrument.white());
    let maps = maps.into_iter().map(|(map, _)| map).collect();
    Ok(Some(Goniometry { acceptance_deg: instrument::ACCEPTANCE_DEG, sentence, maps, strips, brightest }))
}
