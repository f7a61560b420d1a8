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

/// Smallest and largest diameter of a source: a star's spot in a telescope, and what is still small beside the hemisphere.
const SOURCE_DEG: [f64; 2] = [1e-3, 20.0];

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
    // A range that was written down is a promise; one that was not gives way to the lines.
    if let (Some(nm), Some(item)) = (line_outside(&optics), section.get("wavelength_nm")) {
        return Err(item.error(format!("leaves out the laser line at {nm} nm")));
    }
    narrow_to_lines(&mut optics);
    if !illuminant::is_visible(&optics.illuminant, optics.wavelength_nm) {
        let message = invisible();
        let key = if section.has("wavelength_nm") { "wavelength_nm" } else { "illuminant" };
        return Err(section.error_at_key(key, message));
    }
    if let Some(item) = section.get("shadowing") {
        optics.shadowing = item.boolean()?;
    }
    read_overrides(&section, base, &mut optics)?;
    Ok(optics)
}

/// Reads a specimen's own `illuminant`, within the range of wavelengths that `[optics]` writes down.
pub(crate) fn read_illuminant(
    item: &Item,
    written_nm: Option<[f64; 2]>,
    base: &Path,
    optics: &mut OpticsConfig,
) -> Result<()> {
    optics.illuminant = illuminant::read(item, base)?;
    optics.wavelength_nm = written_nm.unwrap_or(defaults::optics().wavelength_nm);
    if let (Some(nm), Some([first, last])) = (line_outside(optics), written_nm) {
        return Err(item.error(format!(
            "has a laser line at {nm} nm, outside of `optics.wavelength_nm` = [{first}, {last}]; widen that, or leave it out"
        )));
    }
    narrow_to_lines(optics);
    if !illuminant::is_visible(&optics.illuminant, optics.wavelength_nm) {
        return Err(item.error(format!("gives nothing to see: {}", invisible())));
    }
    // A material that changes with the wavelength stands for this light at another one.
    match optics.dispersion.take() {
        None => Ok(()),
        Some(dispersive) => optics.set_dispersion(dispersive.table).map_err(|error| {
            item.error(format!(
                "does not go with the material of `[optics]`: {error}; give the specimen a `material` too"
            ))
        }),
    }
}

/// The range of wavelengths that `[optics]` writes down, if it does.
pub(crate) fn written_range(optics: Option<&Item>) -> Result<Option<[f64; 2]>> {
    let section = optics.map(|item| item.section(&keys::OPTICS, "[optics]")).transpose()?;
    section.and_then(|section| section.get("wavelength_nm")).map(|item| wavelength_range(&item)).transpose()
}

/// The first laser line outside of the range of wavelengths.
fn line_outside(optics: &OpticsConfig) -> Option<f64> {
    let [first, last] = optics.wavelength_nm;
    let Illuminant::Lines(lines) = &optics.illuminant else { return None };
    lines.iter().map(|line| line.wavelength_nm).find(|nm| !(first..=last).contains(nm))
}

fn narrow_to_lines(optics: &mut OpticsConfig) {
    if let Illuminant::Lines(lines) = &optics.illuminant {
        let wavelengths = || lines.iter().map(|line| line.wavelength_nm);
        optics.wavelength_nm = [wavelengths().fold(f64::INFINITY, f64::min), wavelengths().fold(0.0, f64::max)];
    }
}

fn invisible() -> String {
    let [low, high] = VISIBLE_NM;
    format!("no light falls between {low} and {high} nm, so that colour and luminance would be 0 / 0")
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
            *optics = sigma(&item, optics)?;
        }
        if let Some(item) = section.get("source_deg") {
            let source_deg = item.number_within(SOURCE_DEG[0], SOURCE_DEG[1], "degrees")?;
            if section.has("sigma_um") {
                return Err(item.error(
                    "goes without `sigma_um`: both say how far the light is coherent; keep `source_deg` for a source of this \
                     diameter, or `sigma_um` for one width at every wavelength",
                ));
            }
            optics.source_deg = Some(source_deg);
            optics.sigma_follows_scan = false;
        }
        if let Some(item) = section.get("edge") {
            optics.edge = item.choice(&[("auto", Edge::Auto), ("tile", Edge::Tile), ("fade", Edge::Fade)])?;
        }
    }
    if let Some(item) = section.get("windows") {
        optics.windows = item.choice(&[("grid", Windows::Grid), ("centre", Windows::Centre)])?;
    }
    if let Some(source_deg) = optics.source_deg {
        refuse_single_windows(section, optics)?;
        *optics = optics.with_source(source_deg);
    }
    if let Some(item) = section.get("material") {
        material::read(&item, base, optics)?;
    }
    Ok(())
}

/// The optics with the sigma that an item gives: a number, or as much as the scan tells.
fn sigma(item: &Item, optics: &OpticsConfig) -> Result<OpticsConfig> {
    if let Some(word) = item.as_text() {
        if word != "auto" {
            return Err(item.error(format!("must be a number of µm, or \"auto\" to follow the scan; found \"{word}\"")));
        }
        return Ok(optics.with_sigma_of_scans(defaults::optics().sigma_nm));
    }
    let sigma_nm = item.number_within(SIGMA_UM[0], SIGMA_UM[1], "µm")? * 1000.0;
    Ok(OpticsConfig { sigma_nm, source_deg: None, sigma_follows_scan: false, ..optics.clone() })
}

/// Refuses a source of fixed size with windows whose samples would be others at every wavelength; points at what of it the
/// section says.
fn refuse_single_windows(section: &Section, optics: &OpticsConfig) -> Result<()> {
    let message = match (optics.edge, optics.windows) {
        (Edge::Fade, _) => {
            "needs `edge = \"auto\"` or `\"tile\"`: with \"fade\" the window stands on the scan's own samples"
        }
        (_, Windows::Centre) => {
            "needs `windows = \"grid\"`: with \"centre\" the window stands on the scan's own samples"
        }
        _ => return Ok(()),
    };
    let message = format!(
        "`coherence.source_deg` {message}, and under a source of fixed size it has another width at every wavelength; change that, \
         or give `sigma_um`"
    );
    let key = if optics.edge != Edge::Fade && section.has("windows") { "windows" } else { "coherence" };
    Err(section.error_at_key(key, message))
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
