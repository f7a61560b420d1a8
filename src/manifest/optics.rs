//! The `[optics]` table, and the parts of it that a specimen may set for itself.

use std::path::Path;

use super::defaults;
use super::illuminant::{self, VISIBLE_NM, WAVELENGTH_NM};
use super::keys;
use super::material;
use super::reader::{Item, Section};
use crate::error::Result;
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::optics::config::{Edge, Factor, OpticsConfig, Windows};
use diffraction_build::tables::model::Basis;

/// Smallest and largest sigma: from well below a wavelength to far beyond any scan.
const SIGMA_UM: [f64; 2] = [0.1, 10_000.0];

/// Reads `[optics]`; paths start at `base`.
pub fn read(item: &Item, base: &Path) -> Result<OpticsConfig> {
    let section = item.section(&keys::OPTICS, "[optics]")?;
    let mut optics = defaults::optics();
    if let Some(item) = section.get("wavelength_nm") {
        optics.wavelength_nm = wavelength_range(&item)?;
    }
    if let Some(item) = section.get("illuminant") {
        optics.illuminant = illuminant::read(&item, base)?;
    }
    if let Illuminant::Lines(lines) = &optics.illuminant {
        let [first, last] = optics.wavelength_nm;
        let outside = lines.iter().find(|line| line.wavelength_nm < first || line.wavelength_nm > last);
        // A range that was written down is a promise; one that was not gives way to the lines.
        if let (Some(line), Some(item)) = (outside, section.get("wavelength_nm")) {
            let line_nm = line.wavelength_nm;
            return Err(item.error(format!("leaves out the laser line at {line_nm} nm")));
        }
        let wavelengths = || lines.iter().map(|line| line.wavelength_nm);
        optics.wavelength_nm = [wavelengths().fold(f64::INFINITY, f64::min), wavelengths().fold(0.0, f64::max)];
    }
    if !illuminant::is_visible(&optics.illuminant, optics.wavelength_nm) {
        let message = format!(
            "no light falls between {} and {} nm, so that colour and luminance would be 0 / 0",
            VISIBLE_NM[0], VISIBLE_NM[1]
        );
        let key = if section.has("wavelength_nm") { "wavelength_nm" } else { "illuminant" };
        return Err(section.error_at_key(key, message));
    }
    if let Some(item) = section.get("shadowing") {
        optics.shadowing = item.boolean()?;
    }
    read_overrides(&section, base, &mut optics)?;
    Ok(optics)
}

/// Reads `factor` of `[optics]`, whose default hangs on the basis: the published tables hold the lobe and the rest as one, and
/// go with the published factor alone.
pub fn factor(optics: Option<&Item>, basis: Basis) -> Result<Factor> {
    let given = optics.map(|item| item.section(&keys::OPTICS, "[optics]")).transpose()?;
    let given = given.as_ref().and_then(|section| section.get("factor"));
    let Some(item) = given else {
        return Ok(if basis == Basis::Taylor { Factor::Scalar } else { Factor::Vector });
    };
    let factor = item.choice(&[("vector", Factor::Vector), ("scalar", Factor::Scalar)])?;
    if basis == Basis::Taylor && factor == Factor::Vector {
        return Err(item.error(
            "must be \"scalar\" with tables.basis = \"taylor\": those tables hold the lobe and the rest as one",
        ));
    }
    Ok(factor)
}

/// Reads `coherence`, `windows`, and `material`, which `[optics]` and `[[specimen]]` share; paths start at `base`.
pub(crate) fn read_overrides(section: &Section, base: &Path, optics: &mut OpticsConfig) -> Result<()> {
    if let Some(item) = section.get("coherence") {
        let section = item.section(&keys::COHERENCE, "{ sigma_um = 16.25, edge = \"auto\" }")?;
        if let Some(item) = section.get("sigma_um") {
            optics.sigma_nm = item.number_within(SIGMA_UM[0], SIGMA_UM[1], "µm")? * 1000.0;
        }
        if let Some(item) = section.get("edge") {
            optics.edge = item.choice(&[("auto", Edge::Auto), ("tile", Edge::Tile), ("fade", Edge::Fade)])?;
        }
    }
    if let Some(item) = section.get("windows") {
        optics.windows = item.choice(&[("grid", Windows::Grid), ("centre", Windows::Centre)])?;
    }
    if let Some(item) = section.get("material") {
        material::read(&item, base, optics)?;
    }
    Ok(())
}

fn wavelength_range(item: &Item) -> Result<[f64; 2]> {
    let [first, last] = item.list_of::<2>("two wavelengths such as [380, 780]")?;
    let [low, high] = WAVELENGTH_NM;
    let range = [first.number_within(low, high, "nm")?, last.number_within(low, high, "nm")?];
    if range[0] >= range[1] {
        return Err(item
            .error(format!("must increase; found [{}, {}], write [{}, {}]", range[0], range[1], range[1], range[0])));
    }
    Ok(range)
}
