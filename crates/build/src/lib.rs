//! From height scans to BRDF tables: reading and preparing scans, the optics, building table sets, and how accurate they
//! are.

pub mod accuracy;
pub mod ground;
pub mod height;
pub mod optics;
pub mod tables;
