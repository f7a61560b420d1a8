//! From height scans to BRDF tables: reading and preparing scans, the optics, and building table sets.

pub mod ground;
pub mod height;
pub mod optics;
pub mod tables;
