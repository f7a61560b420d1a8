//! Diffraction atlas: BRDF tables of structural colour from height scans.

pub mod cli;
pub mod ground;
pub mod height;
pub mod manifest;
pub mod optics;
pub mod render;
pub mod report;
pub mod scene;
pub mod stages;
pub mod tables;
