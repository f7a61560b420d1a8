//! The program from outside: manifests and scans in a folder of their own, commands, and what they leave on the disk.

mod cache;
mod damage;
mod evaluation;
mod extremes;
mod faults;
mod interruption;
mod measured;
mod meshes;
mod moving;
mod place;
mod real_scans;
mod scans;
mod served;
mod settings;
mod versions;

#[path = "../scan_support/mod.rs"]
mod scan_support;
