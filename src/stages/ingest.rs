//! From a specimen's scan files to prepared height fields with their statistics.

use super::config::SpecimenConfig;
use diffraction_brdf::error::Result;
use diffraction_build::height::HeightField;
use diffraction_build::height::prepare::{PrepareRecord, prepare};
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
    /// Statistics of each prepared field.
    pub statistics: Vec<Statistics>,
    /// What is wrong with each, as it was read and after preparing.
    pub findings: Vec<Vec<Finding>>,
}

/// Reads and prepares every scan of a specimen.
///
/// # Errors
/// The first scan that cannot be read or prepared.
pub fn ingest(specimen: &SpecimenConfig) -> Result<Scans> {
    let mut scans = Scans {
        fields: Vec::new(),
        optics: specimen.optics.clone(),
        provenance: Vec::new(),
        preparation: Vec::new(),
        statistics: Vec::new(),
        findings: Vec::new(),
    };
    let shortest_nm = specimen.optics.illuminant.reach_nm(specimen.optics.wavelength_nm)[0];
    for path in &specimen.scans {
        let scan = read_scan(path, &specimen.read)?;
        let (field, record) = prepare(&scan.field, &specimen.prepare)?;
        scans.findings.push(findings(&scan.field, &field));
        scans.statistics.push(statistics(&field, shortest_nm));
        scans.fields.push(field);
        scans.provenance.push(scan.provenance);
        scans.preparation.push(record);
    }
    scans.optics = specimen.optics.for_scans(&scans.fields);
    Ok(scans)
}
