//! Which settings mend a scan, found by trying them.

use super::checks::findings;
use super::finding::{Fault, Finding, Remedy};
use super::marks;
use crate::height::HeightField;
use crate::height::prepare::repair::fill_marked;
use crate::height::prepare::{Despike, Level, PrepareConfig, prepare};
use diffraction_brdf::error::Result;

/// Outliers that `despike` is advised to remove.
const THRESHOLD_RMS: f64 = 8.0;

/// What a scan has, and what helps.
#[derive(Debug, Clone, PartialEq)]
pub struct Advice {
    /// Everything found, also what came to light once something else was mended.
    pub findings: Vec<Finding>,
    /// Settings beyond the defaults that mend what can be mended, in the order in which they act.
    pub settings: Vec<Remedy>,
    /// What is still wrong with them.
    pub left: Vec<Finding>,
    /// The scan prepared with them.
    pub prepared: HeightField,
}

/// Tries settings until no finding names another; the heights are as they were read.
///
/// # Errors
/// As [`prepare`].
pub fn advise(read: &HeightField) -> Result<Advice> {
    let mut settings: Vec<Remedy> = Vec::new();
    let mut all: Vec<Finding> = Vec::new();
    loop {
        let source = sourced(read, &settings);
        let (prepared, _) = prepare(&source, &config(&settings))?;
        let found = findings(&source, &prepared);
        for finding in &found {
            if !all.iter().any(|known| known.fault == finding.fault) {
                all.push(finding.clone());
            }
        }
        // Each remedy is tried once, so this ends.
        match found.iter().filter_map(|finding| finding.remedy).find(|remedy| is_new(remedy, &settings)) {
            Some(remedy) => settings.push(remedy),
            None => {
                let left = found.into_iter().filter(|finding| !is_mended(finding, &settings)).collect();
                settings.sort_by_key(order);
                return Ok(Advice { findings: all, settings, left, prepared });
            }
        }
    }
}

/// Whether a remedy adds to those there are: a plane is the default, and there is one level and one part that is kept.
fn is_new(remedy: &Remedy, settings: &[Remedy]) -> bool {
    match remedy {
        Remedy::Plane => false,
        Remedy::Rows | Remedy::Quadratic => {
            !settings.iter().any(|setting| matches!(setting, Remedy::Rows | Remedy::Quadratic))
        }
        Remedy::Crop(_) => !settings.iter().any(|setting| matches!(setting, Remedy::Crop(_))),
        Remedy::MissingValue(_) => !settings.iter().any(|setting| matches!(setting, Remedy::MissingValue(_))),
        Remedy::Despike => !settings.contains(remedy),
    }
}

/// Whether a finding is told of the scan as it was read although what was made of it is mended.
fn is_mended(finding: &Finding, settings: &[Remedy]) -> bool {
    match finding.fault {
        Fault::Tilt | Fault::Pixels => true,
        Fault::LostLines => finding.remedy.is_some_and(|remedy| settings.contains(&remedy)),
        _ => false,
    }
}

/// Place in the order in which settings act.
fn order(remedy: &Remedy) -> usize {
    match remedy {
        Remedy::MissingValue(_) => 0,
        Remedy::Crop(_) => 1,
        Remedy::Despike => 2,
        Remedy::Plane | Remedy::Rows | Remedy::Quadratic => 3,
    }
}

/// The scan as it is read with these settings.
fn sourced(read: &HeightField, settings: &[Remedy]) -> HeightField {
    let mut field = read.clone();
    for setting in settings {
        if let Remedy::MissingValue(value) = setting {
            let marked = field.heights_nm.mapv(|height| marks::customary(height) == Some(*value));
            fill_marked(&mut field, &marked);
        }
    }
    for setting in settings {
        if let Remedy::Crop(part) = setting {
            field = field.cropped(*part);
        }
    }
    field
}

fn config(settings: &[Remedy]) -> PrepareConfig {
    let level = settings.iter().find_map(|setting| match setting {
        Remedy::Rows => Some(Level::Rows),
        Remedy::Quadratic => Some(Level::Quadratic),
        _ => None,
    });
    let despike = settings.contains(&Remedy::Despike).then_some(Despike { threshold_rms: THRESHOLD_RMS });
    PrepareConfig { level: level.unwrap_or(Level::Plane), despike, blend_nm: None }
}
