//! Diffraction atlas: BRDF tables of structural colour from height scans.

pub mod ground;
pub mod height;
pub mod optics;
pub mod report;
pub mod stages;
pub mod tables;
