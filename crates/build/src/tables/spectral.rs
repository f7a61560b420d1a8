//! Spectral tables: those of one wavelength, the shortest, hold every longer one.
//!
//! No sum over wavelengths, no light and no observer is in them. They are built as the tables of a light of that one
//! wavelength are, whose three channels are then equal.

use super::build::{Summed, summed};
use super::input::BuildInput;
use super::lobe::{coherent, power_over_t};
use super::model::{Advance, Basis, BuildRecord, Lobe, TableSet, TablesConfig};
use super::plan::{AUTOMATIC_SIZE_MAX, BuildPlan, plan};
use super::resolution::{lobe_radius, resolving_size};
use super::rounding::{Chosen, choose};
use crate::optics::config::OpticsConfig;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::spectral::{SpectralCross, SpectralLobe, SpectralTables, packed};
use diffraction_brdf::spectral_storage::{StoredSpectral, write_spectral};
use diffraction_brdf::spectrum::{Illuminant, Line};
use std::path::Path;

/// Share of the tolerance that the grid is chosen for: at one wavelength no sum averages its errors out.
const GRID_SHARE: f64 = 1.0 / 3.0;

/// What is seen of light, in nm: laser lines alone shall not make tables for nothing else.
const VISIBLE_NM: [f64; 2] = [380.0, 780.0];

/// What spectral tables are made with: the optics with a light of the shortest wavelength, and the tables' settings.
#[derive(Debug, Clone)]
pub struct SpectralInput {
    optics: OpticsConfig,
    tables: TablesConfig,
    longest_nm: f64,
}

/// Spectral tables that are not packed yet.
#[derive(Debug, Clone)]
pub struct SpectralBuilt {
    /// The tables of the shortest wavelength in three equal channels.
    pub grey: TableSet,
    /// The lobe's power over `|w'|/2`.
    power: Vec<f32>,
    /// What was chosen while building.
    pub record: BuildRecord,
}

impl SpectralInput {
    /// From the optics and settings of the tables of XYZ.
    pub fn new(optics: &OpticsConfig, tables: &TablesConfig) -> Self {
        let [shortest_nm, longest_nm] = range_nm(optics);
        let line = Line { wavelength_nm: shortest_nm, power: 1.0 };
        let optics = OpticsConfig {
            illuminant: Illuminant::Lines(vec![line]),
            wavelength_nm: [shortest_nm, longest_nm],
            ..optics.clone()
        };
        let resolving = resolving_size(&optics, GRID_SHARE * tables.tolerance).min(AUTOMATIC_SIZE_MAX);
        let size = Some(tables.size.unwrap_or(resolving));
        Self { optics, tables: TablesConfig { basis: Basis::Chebyshev, size, ..tables.clone() }, longest_nm }
    }

    /// The same scans with this light.
    pub fn of<'a>(&'a self, input: &BuildInput<'a>) -> BuildInput<'a> {
        BuildInput { is_grey: true, ..input.with(&self.optics, &self.tables) }
    }

    /// Shortest wavelength that the tables answer for, in nm.
    pub fn shortest_nm(&self) -> f64 {
        self.optics.wavelength_nm[0]
    }
}

/// The wavelengths in nm that spectral tables answer for: those of the light, of laser lines all that the eye
/// sees besides, as far as the material is known.
fn range_nm(optics: &OpticsConfig) -> [f64; 2] {
    let [first, last] = optics.wavelength_nm;
    let all = match optics.illuminant {
        Illuminant::Lines(_) => [first.min(VISIBLE_NM[0]), last.max(VISIBLE_NM[1])],
        _ => [first, last],
    };
    // The light's own wavelengths are known of every material.
    let known = optics.dispersion.as_ref().map_or(all, |dispersive| dispersive.table.range_nm());
    [all[0].max(known[0]), all[1].min(known[1])]
}

/// Plans and builds the spectral tables of one specimen for every direction; `input` is that of the tables of XYZ.
///
/// # Errors
/// Those of [`plan()`], and transforms beyond the allowed memory.
pub fn build_spectral(input: &BuildInput, spectral: &SpectralInput, advance: Advance) -> Result<SpectralBuilt> {
    let input = spectral.of(input);
    build_spectral_planned(&input, &plan(&input)?, advance)
}

/// Builds what was planned; input and plan are those of [`SpectralInput::of`].
///
/// # Errors
/// As [`build_spectral`].
pub fn build_spectral_planned(input: &BuildInput, plan: &BuildPlan, advance: Advance) -> Result<SpectralBuilt> {
    let Summed { sums, phasors, record } = summed(input, plan, advance)?;
    let Some(phasors) = phasors else {
        return Err(Error::Call("spectral tables are for every direction, the mirror's too".into()));
    };
    let grey = TableSet {
        basis: Basis::Chebyshev,
        tables: sums.tables(plan),
        lobe: Some(Lobe {
            coherent: coherent(&phasors, input, plan.lobe_radius, plan.t_in_lobe())?,
            radius_max: plan.lobe_radius,
            cross: sums.cross_tables(),
        }),
        prefilter_width: plan.filter.width,
        front_factor: input.optics.front_factor(),
        restriction: None,
        usable_radius: input.usable_radius(),
    };
    Ok(SpectralBuilt { grey, power: power_over_t(&phasors, input), record })
}

impl SpectralBuilt {
    /// Rounds to the tolerance, as for tables of XYZ.
    pub fn rounded(&self, spectral: &SpectralInput) -> Chosen {
        choose(&self.grey, spectral.tables.storage, spectral.tables.tolerance, lobe_radius(&spectral.optics))
    }

    /// The tables as files and readers have them, given their numbers: those that were built, or those rounded.
    pub fn packed(&self, grey: &TableSet, input: &BuildInput, spectral: &SpectralInput) -> SpectralTables {
        let cross = grey.lobe.as_ref().filter(|lobe| !lobe.cross.is_empty());
        SpectralTables {
            shortest_nm: spectral.shortest_nm(),
            longest_nm: spectral.longest_nm,
            count: grey.tables.len(),
            images: packed(&grey.tables),
            lobe: Some(SpectralLobe {
                power: self.power.clone(),
                sigma_nm: spectral.optics.lobe_sigma_nm(),
                cross: cross.map(|lobe| SpectralCross {
                    count: lobe.cross.len(),
                    images: packed(&lobe.cross),
                    radius_max: lobe.radius_max,
                }),
            }),
            prefilter_width: grey.prefilter_width,
            front_factor: grey.front_factor,
            dispersion: spectral.optics.dispersion.as_ref().map(|dispersive| dispersive.table.clone()),
            usable_radius: grey.usable_radius,
            sigma_nm: spectral.optics.sigma_nm,
            half_height_range_nm: input.half_height_range_nm,
        }
    }

    /// Rounds and writes them into an existing folder.
    ///
    /// # Errors
    /// As [`write_spectral`].
    pub fn write(&self, folder: &Path, input: &BuildInput, spectral: &SpectralInput) -> Result<StoredSpectral> {
        let Chosen { set, storage, rounding } = self.rounded(spectral);
        let stored = write_spectral(folder, &self.packed(&set, input, spectral), storage)?;
        Ok(StoredSpectral { rounding: Some(rounding), ..stored })
    }
}
