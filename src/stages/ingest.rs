//! From a specimen's scan files to prepared height fields with their statistics.

use std::path::Path;

use ndarray::Array2;

use super::config::SpecimenConfig;
use diffraction_brdf::error::{Error, Result};
use diffraction_build::height::HeightField;
use diffraction_build::height::prepare::{PrepareConfig, PrepareRecord, prepare, replaced};
use diffraction_build::height::quality::{Finding, findings};
use diffraction_build::height::read::{Provenance, read_scan};
use diffraction_build::height::statistics::{Statistics, statistics};
use diffraction_build::optics::config::OpticsConfig;

/// A specimen's scans, ready for the optics.
#[derive(Debug, Clone)]
pub struct Scans {
    /// Prepared heights, one per scan.
    pub fields: Vec<HeightField>,
    /// The specimen's optics with as much coherence as these scans resolve.
    pub optics: OpticsConfig,
    /// Where each comes from.
    pub provenance: Vec<Provenance>,
    /// What preparing did to each.
    pub preparation: Vec<PrepareRecord>,
    /// Samples of the first that `despike` replaced; `None` where it did not act.
    pub replaced: Option<Array2<bool>>,
    /// Statistics of each prepared field.
    pub statistics: Vec<Statistics>,
    /// What is wrong with each, as it was read and after preparing.
    pub findings: Vec<Vec<Finding>>,
}

/// Reads and prepares every scan of a specimen.
///
/// # Errors
/// The first scan that cannot be read or prepared, or whose scan axis was turned against that of the scans before it: each scan's
/// heights are in its own axes, so the average of two such would show every structure twice.
pub fn ingest(specimen: &SpecimenConfig) -> Result<Scans> {
    let mut scans = Scans {
        fields: Vec::new(),
        optics: specimen.optics.clone(),
        provenance: Vec::new(),
        preparation: Vec::new(),
        replaced: None,
        statistics: Vec::new(),
        findings: Vec::new(),
    };
    let shortest_nm = specimen.optics.illuminant.reach_nm(specimen.optics.wavelength_nm)[0];
    for path in &specimen.scans {
        let scan = read_scan(path, &specimen.read)?;
        refuse_other_angle(path, &scan.provenance, &scans.provenance)?;
        let (field, record) = prepare(&scan.field, &specimen.prepare)?;
        if scans.fields.is_empty() {
            scans.replaced = replaced(&scan.field, &specimen.prepare)?;
        }
        // Blended edges are no part of the scan: what was joined there looks like scars and steps.
        let unblended = PrepareConfig { blend_nm: None, ..specimen.prepare };
        let checked = match specimen.prepare.blend_nm {
            None => findings(&scan.field, &field),
            Some(_) => findings(&scan.field, &prepare(&scan.field, &unblended)?.0),
        };
        scans.findings.push(checked);
        scans.statistics.push(statistics(&field, shortest_nm));
        scans.fields.push(field);
        scans.provenance.push(scan.provenance);
        scans.preparation.push(record);
    }
    scans.optics = specimen.optics.for_scans(&scans.fields);
    Ok(scans)
}

/// Angle in degrees up to which two scans count as parallel: instruments round.
const PARALLEL_DEG: f64 = 0.5;

fn refuse_other_angle(path: &Path, scan: &Provenance, before: &[Provenance]) -> Result<()> {
    let Some(angle) = scan.angle_deg else { return Ok(()) };
    let apart = |other: f64| {
        let turn = (angle - other).rem_euclid(360.0);
        turn.min(360.0 - turn)
    };
    let turned = before
        .iter()
        .find_map(|other| Some((other, other.angle_deg?)))
        .filter(|(_, other)| apart(*other) > PARALLEL_DEG);
    let Some((other, other_deg)) = turned else { return Ok(()) };
    Err(Error::bad_file(
        path,
        format!(
            "its scan axis is turned by {angle:.1} deg, that of {} by {other_deg:.1} deg: averaged as they are, they show every structure twice",
            other.file_name
        ),
        "make each angle a specimen of its own, or turn the scans in an image program to one angle first",
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_parallel_scans_are_averaged() {
        let at = |angle_deg: Option<f64>| Provenance {
            file_name: "a.spm".into(),
            sha256: String::new(),
            format: String::new(),
            page: 0,
            sample_format: String::new(),
            size: [1, 1],
            pitch_nm: [1.0; 2],
            pitch_from: String::new(),
            height_from: String::new(),
            missing_samples: 0,
            channel: None,
            angle_deg,
            warnings: Vec::new(),
        };
        let refused =
            |first, second| refuse_other_angle(Path::new("b.spm"), &at(second), &[at(None), at(first)]).is_err();
        assert!(!refused(Some(0.0), Some(0.4)) && !refused(Some(-0.2), Some(359.9)) && !refused(Some(90.0), None));
        assert!(!refused(None, Some(90.0)));
        assert!(refused(Some(0.0), Some(90.0)) && refused(Some(45.0), Some(-45.0)) && refused(Some(10.0), Some(10.6)));
    }
}
