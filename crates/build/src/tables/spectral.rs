//! Spectral tables: those of one wavelength, the shortest, hold every longer one.
//!
//! No sum over wavelengths, no light and no observer is in them. They are built as the tables of a light of that one
//! wavelength are, in one channel.

use super::build::{Summed, summed};
use super::input::BuildInput;
use super::lobe::power_over_t;
use super::look_ups::tried_first;
use super::model::{Advance, Basis, BuildRecord, TablesConfig};
use super::plan::{BuildPlan, automatic_size, plan};
use super::resolution::lobe_radius;
use super::rounding::{Chosen, choose};
use crate::optics::config::{OpticsConfig, TILE_SIGMAS};
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::spectral::{SpectralCross, SpectralLobe, SpectralTables, packed};
use diffraction_brdf::spectral_storage::{StoredSpectral, write_spectral};
use diffraction_brdf::spectrum::{Illuminant, Line, VISIBLE_NM};
use std::path::Path;

/// Share of the tolerance that each of the grid's axes may take at the worst place between texels: at one wavelength no sum
/// averages its errors out. What the basis with a half and storage with 0.7 of the tolerance leave, errors adding as squares, is
/// `sqrt(1 - 0.25 - 0.49)` = 0.51, and over two axes 0.36 each.
const GRID_SHARE: f64 = 1.0 / 3.0;

/// What spectral tables are made with: the optics with a light of the shortest wavelength, and the tables' settings.
#[derive(Debug, Clone)]
pub struct SpectralInput {
    optics: OpticsConfig,
    /// The optics at every wavelength.
    at_each: OpticsConfig,
    tables: TablesConfig,
    longest_nm: f64,
}

/// What keeps spectral tables of a specimen from being made, in words; `None` where nothing does.
///
/// They hold every wavelength only where one window blurs them all alike. Under a source of fixed size the light's coherence grows
/// with the wavelength: the lobe is then known in closed form, and what else there is where a scan resolves less than the light
/// tells at the shortest wavelength already.
pub fn obstacle(optics: &OpticsConfig) -> Option<String> {
    let body = optics.body_coherence();
    let [shortest_nm, longest_nm] = range_nm(optics);
    let [least_nm, most_nm] = [shortest_nm, longest_nm].map(|nm| body.sigma_nm_at(nm));
    (least_nm < most_nm).then(|| {
        format!(
            "coherence.source_deg blurs {shortest_nm:.0} and {longest_nm:.0} nm by windows of {:.1} and {:.1} um, and the scan \
             is large enough to tell them apart; coherence.sigma_um, or a scan of less than {:.0} um with edge = \"auto\", has one",
            1e-3 * least_nm,
            1e-3 * most_nm,
            1e-3 * least_nm * TILE_SIGMAS
        )
    })
}

/// Spectral tables as they were built, all digits kept.
#[derive(Debug, Clone)]
pub struct SpectralBuilt {
    /// The tables.
    pub tables: SpectralTables,
    /// What was chosen while building.
    pub record: BuildRecord,
}

impl SpectralInput {
    /// The same on fewer texels, which suffice where lines lie side by side ([`tried_first`]); `None` where the size is given, or would
    /// not be less.
    pub fn on_fewer_texels(&self, tables: &TablesConfig) -> Option<Self> {
        let size = Some(tried_first(&self.optics, tables)?);
        Some(Self { tables: TablesConfig { size, ..self.tables.clone() }, ..self.clone() })
    }

    /// The same on so many texels a side, or its own number where that is less.
    pub fn on(&self, size: usize) -> Self {
        let size = self.tables.size.map(|most| most.min(size));
        Self { tables: TablesConfig { size, ..self.tables.clone() }, ..self.clone() }
    }

    /// From the optics and settings of the tables of XYZ.
    pub fn new(optics: &OpticsConfig, tables: &TablesConfig) -> Self {
        let [shortest_nm, longest_nm] = range_nm(optics);
        let line = Line { wavelength_nm: shortest_nm, power: 1.0 };
        let at_each = OpticsConfig {
            illuminant: Illuminant::Lines(vec![line]),
            wavelength_nm: [shortest_nm, longest_nm],
            ..optics.clone()
        };
        // At one wavelength a source is a window.
        let optics = match at_each.source_deg {
            None => at_each.clone(),
            Some(_) => OpticsConfig {
                sigma_nm: at_each.body_coherence().sigma_nm_at(shortest_nm),
                lobe_sigma_nm: Some(at_each.lobe_coherence().sigma_nm_at(shortest_nm)),
                source_deg: None,
                ..at_each.clone()
            },
        };
        let size = Some(tables.size.unwrap_or_else(|| automatic_size(&optics, GRID_SHARE * tables.tolerance)));
        Self { optics, at_each, tables: TablesConfig { basis: Basis::Chebyshev, size, ..tables.clone() }, longest_nm }
    }

    /// The same scans with this light.
    pub fn of<'a>(&'a self, input: &BuildInput<'a>) -> BuildInput<'a> {
        BuildInput { is_grey: true, ..input.with(&self.optics, &self.tables) }
    }

    /// The optics at every wavelength, for the reference: the light's coherence is what it is at each.
    pub fn optics_at_each(&self) -> &OpticsConfig {
        &self.at_each
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
        // Laser lines alone shall not make tables for nothing else.
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
    build_spectral_planned(&input, &plan(&input)?, spectral, advance)
}

/// Builds what was planned; input and plan are those of [`SpectralInput::of`].
///
/// # Errors
/// As [`build_spectral`].
pub fn build_spectral_planned(
    input: &BuildInput,
    plan: &BuildPlan,
    spectral: &SpectralInput,
    advance: Advance,
) -> Result<SpectralBuilt> {
    if let Some(why) = obstacle(&spectral.at_each) {
        return Err(Error::Call(format!("one stack of tables cannot hold every wavelength: {why}")));
    }
    let Summed { sums, phasors, record } = summed(input, plan, advance)?;
    let Some(phasors) = phasors else {
        return Err(Error::Call("spectral tables are for every direction, the mirror's too".into()));
    };
    let (tables, cross) = (sums.tables(plan), sums.cross_tables());
    let lobe = SpectralLobe {
        power: power_over_t(&phasors, input),
        sigma_nm: input.optics.lobe_sigma_nm(),
        is_of_source: spectral.at_each.source_deg.is_some(),
        cross: (!cross.is_empty()).then(|| SpectralCross {
            count: cross.len(),
            images: packed(&cross),
            radius_max: plan.lobe_radius,
        }),
    };
    let tables = SpectralTables {
        shortest_nm: spectral.shortest_nm(),
        longest_nm: spectral.longest_nm,
        count: tables.len(),
        images: packed(&tables),
        lobe: Some(lobe),
        prefilter_width: plan.filter.width,
        front_factor: input.optics.front_factor(),
        dispersion: input.optics.dispersion.as_ref().map(|dispersive| dispersive.table.clone()),
        usable_radius: input.usable_radius(),
        sigma_nm: input.optics.sigma_nm,
        half_height_range_nm: input.half_height_range_nm,
    };
    Ok(SpectralBuilt { tables, record })
}

impl SpectralBuilt {
    /// Rounds to the tolerance, as for tables of XYZ.
    pub fn rounded(&self, spectral: &SpectralInput) -> Chosen<SpectralTables> {
        choose(&self.tables, spectral.tables.storage, spectral.tables.tolerance, lobe_radius(&spectral.optics))
    }

    /// Rounds and writes them into an existing folder.
    ///
    /// # Errors
    /// As [`write_spectral`].
    pub fn write(&self, folder: &Path, spectral: &SpectralInput) -> Result<StoredSpectral> {
        let Chosen { set, storage, rounding } = self.rounded(spectral);
        let stored = write_spectral(folder, &set, storage)?;
        Ok(StoredSpectral { rounding: Some(rounding), ..stored })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::height::HeightField;
    use crate::optics::config::{Edge, Windows};
    use crate::tables::model::Prefilter;
    use ndarray::Array2;

    /// One channel holds, bit for bit, what three equal ones do, cross term and all.
    #[test]
    fn one_channel_is_any_of_three_equal_ones() {
        let height = |(row, column): (usize, usize)| ((row * 37 + column * 101 + row * column * 13) % 64) as f64 * 4.0;
        let fields = [HeightField { heights_nm: Array2::from_shape_fn((120, 110), height), pitch_nm: [150.0; 2] }];
        let tables = TablesConfig {
            basis: Basis::Chebyshev,
            tolerance: 1e-2,
            size: Some(41),
            count: None,
            wavelength_step_nm: None,
            storage: None,
            prefilter: Prefilter::Auto,
            memory_mib: 256,
        };
        for windows in [Windows::Grid, Windows::Centre] {
            let optics = OpticsConfig::ideal(Illuminant::E, 1_000.0, Edge::Tile, windows);
            let spectral = SpectralInput::new(&optics, &tables);
            let input = BuildInput::new(&fields, &optics, &tables);
            let input = spectral.of(&input);
            let plan = plan(&input).unwrap();
            let one = summed(&input, &plan, &|_| ()).unwrap().sums;
            let three = summed(&input, &BuildPlan { channels: 3, ..plan.clone() }, &|_| ()).unwrap().sums;
            let both = [one.tables(&plan), three.tables(&plan)];
            let crosses = [one.cross_tables(), three.cross_tables()];
            assert_eq!(crosses[0].is_empty(), windows == Windows::Grid);
            for [one, three] in [both, crosses] {
                assert_eq!(one.len(), three.len());
                for (one, three) in one.iter().zip(&three) {
                    assert_eq!(one.dim().2, 1);
                    for channel in 0..3 {
                        assert_eq!(one.index_axis(ndarray::Axis(2), 0), three.index_axis(ndarray::Axis(2), channel));
                    }
                }
            }
            assert!(both_differ(&fields, &spectral, &plan));
        }
    }

    /// Whether another surface gives other sums: the comparison can fail.
    fn both_differ(fields: &[HeightField], spectral: &SpectralInput, plan: &BuildPlan) -> bool {
        let other = [HeightField { heights_nm: fields[0].heights_nm.mapv(|h| 0.9 * h), ..fields[0].clone() }];
        let of = |fields: &[HeightField]| {
            let input = BuildInput::new(fields, &spectral.optics, &spectral.tables);
            let input = spectral.of(&input);
            summed(&input, plan, &|_| ()).unwrap().sums.tables(plan)
        };
        of(fields) != of(&other)
    }
}
