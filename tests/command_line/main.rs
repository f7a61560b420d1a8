//! The program from outside: manifests and scans in a folder of their own, commands, and what they leave on the disk.

#[macro_use]
#[path = "../common/skip.rs"]
mod skip;
#[path = "../common/mod.rs"]
mod common;
#[path = "../common/manifest_fixture.rs"]
mod manifest_fixture;
#[path = "../common/scan_files.rs"]
mod scan_files;

mod cache;
mod collection_table;
mod collections;
mod colours;
mod damage;
mod energy;
mod evaluation;
mod extremes;
mod faults;
mod forecast_reference;
mod general;
mod interruption;
mod lights;
mod locks;
mod manifest_errors;
mod manifest_values;
mod materials;
mod measured;
mod memory_account;
mod meshes;
mod messages;
mod moving;
mod outputs;
mod place;
mod real_scans;
mod restricted;
mod scans;
mod settings;
mod versions;
mod viewing;
