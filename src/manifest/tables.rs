//! The `[tables]` table.

use super::defaults;
use super::keys;
use super::reader::Item;
use crate::error::Result;
use crate::stages::config::{Cover, Hold, SpecimenConfig};
use diffraction_build::tables::model::{Basis, Prefilter, Storage, TablesConfig};

/// Tolerances lie above the first, at which double precision is spent, and up to the second.
const TOLERANCE: [f64; 2] = [1e-8, 0.5];

/// Texels along u and v: three make a grid; at the upper end one float table has 3 GiB.
const SIZE: [usize; 2] = [3, 16_385];

/// Largest number of tables; the published basis may need 80.
const COUNT_MAX: usize = 256;

/// Wavelength steps in nm: the finest takes 40000 wavelengths over what the eye sees, far more than any structure needs.
const STEP_NM: [f64; 2] = [0.01, 100.0];

/// Working memory in MiB.
const MEMORY_MIB: [usize; 2] = [64, 16 << 20];

/// Reads `[tables]`.
pub fn read(item: &Item) -> Result<TablesConfig> {
    let section = item.section(&keys::TABLES, "[tables]")?;
    let mut tables = defaults::tables();
    if let Some(item) = section.get("basis") {
        tables.basis = item.choice(&[("chebyshev", Basis::Chebyshev), ("taylor", Basis::Taylor)])?;
    }
    if let Some(item) = section.get("tolerance") {
        tables.tolerance = tolerance(&item)?;
    }
    if let Some(item) = section.get("size") {
        tables.size = Some(size(&item)?);
    }
    if let Some(item) = section.get("count") {
        tables.count = Some(item.integer_within(1, COUNT_MAX, "")?);
    }
    if let Some(item) = section.get("wavelength_step_nm") {
        tables.wavelength_step_nm = Some(item.number_within(STEP_NM[0], STEP_NM[1], "nm")?);
    }
    if let Some(item) = section.get("storage") {
        tables.storage =
            item.choice(&[("auto", None), ("half", Some(Storage::Half)), ("float", Some(Storage::Float))])?;
    }
    if let Some(item) = section.get("prefilter") {
        tables.prefilter = prefilter(&item)?;
    }
    if let Some(item) = section.get("memory_mib") {
        tables.memory_mib = item.integer_within(MEMORY_MIB[0], MEMORY_MIB[1], "MiB")?;
    }
    Ok(tables)
}

/// Refuses the published basis for specimens under a source of fixed size, which it knows nothing of.
pub(crate) fn refuse_sources(item: &Item, specimens: &[SpecimenConfig]) -> Result<()> {
    let Some(specimen) = specimens.iter().find(|specimen| specimen.optics.source_deg.is_some()) else { return Ok(()) };
    let message = format!(
        "knows one coherence for all wavelengths, and specimen \"{}\" has `coherence.source_deg`; use \"chebyshev\", or give \
         `coherence.sigma_um`",
        specimen.name
    );
    let section = item.section(&keys::TABLES, "[tables]")?;
    Err(section.get("basis").unwrap_or_else(|| item.clone()).error(message))
}

/// Reads a tolerance.
pub fn tolerance(item: &Item) -> Result<f64> {
    item.number_above(TOLERANCE[0], TOLERANCE[1], "")
}

/// Reads `serve`: which directions the tables answer for; `scenes` are the names of the manifest's scenes.
pub(crate) fn read_cover(item: &Item, scenes: &[&str]) -> Result<Cover> {
    let section = item.section(&keys::TABLES, "[tables]")?;
    let Some(item) = section.get("serve") else {
        return Ok(Cover::All);
    };
    if item.is_list() && scenes.is_empty() {
        return Err(item.error("names scenes, but there is no [[scene]]"));
    }
    let cover = if item.is_list() {
        let options: Vec<(&str, &str)> = scenes.iter().map(|name| (*name, *name)).collect();
        let named = item.list()?.iter().map(|item| item.choice(&options).map(str::to_owned)).collect::<Result<_>>()?;
        Cover::Named(named)
    } else if item.as_text().is_some() {
        if item.choice(&[("all", true), ("scenes", false)])? { Cover::All } else { Cover::Scenes }
    } else {
        return Err(item.error("must be \"all\", \"scenes\", or a list of scenes as [\"sphere\"]"));
    };
    if cover == Cover::All {
        return Ok(cover);
    }
    if scenes.is_empty() || cover == Cover::Named(Vec::new()) {
        return Err(item.error("covers no direction at all: there must be a [[scene]] to cover"));
    }
    let taylor = section.get("basis").is_some_and(|basis| basis.as_text() == Some("taylor"));
    if taylor {
        return Err(
            item.error("goes with basis = \"chebyshev\": powers of w cannot be restricted to the |w| of a scene")
        );
    }
    Ok(cover)
}

/// Reads `hold`: which kinds of tables are stored. Where nothing is said both are, unless tables are made for scenes or by the
/// published method, which know no single wavelengths.
pub(crate) fn read_hold(item: &Item, cover: &Cover) -> Result<Hold> {
    let section = item.section(&keys::TABLES, "[tables]")?;
    let taylor = section.get("basis").is_some_and(|basis| basis.as_text() == Some("taylor"));
    let Some(item) = section.get("hold") else {
        return Ok(Hold { xyz: true, spectral: cover.is_all() && !taylor });
    };
    let names = if item.is_list() { item.list()? } else { Vec::new() };
    let held =
        names.iter().map(|name| name.choice(&[("spectral", true), ("xyz", false)])).collect::<Result<Vec<_>>>()?;
    if held.is_empty() {
        return Err(item.error("must be [\"xyz\"], [\"spectral\"] or [\"spectral\", \"xyz\"]"));
    }
    let spectral = held.contains(&true);
    if spectral && taylor {
        return Err(item
            .error("\"spectral\" goes with basis = \"chebyshev\": the published method's tables hold X, Y, Z alone"));
    }
    if spectral && !cover.is_all() {
        return Err(item.error(
            "\"spectral\" goes with serve = \"all\": one wavelength of a scene looks up what another scene's may not need",
        ));
    }
    Ok(Hold { xyz: held.contains(&false), spectral })
}

fn size(item: &Item) -> Result<usize> {
    let size = item.integer_within(SIZE[0], SIZE[1], "texels")?;
    if size % 2 == 0 {
        return Err(item.error(format!(
            "must be odd, so that one texel lies at u = v = 0; found {size}, try {} or {}",
            size - 1,
            size + 1
        )));
    }
    Ok(size)
}

fn prefilter(item: &Item) -> Result<Prefilter> {
    if !item.is_table() {
        let options = [("auto", Prefilter::Auto), ("none", Prefilter::None)];
        return item.as_text().map_or_else(
            || Err(item.error("must be \"auto\", \"none\", or { width = 0.0093 }")),
            |_| item.choice(&options),
        );
    }
    let section = item.section(&keys::PREFILTER, "{ width = 0.0093 }")?;
    let width = section.require("width", "{ width = 0.0093 }")?;
    Ok(Prefilter::Width(width.number_above(0.0, 1.0, "in u and v")?))
}
