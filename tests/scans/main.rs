//! Scans of every format and dialect, hostile ones among them, and what the bundled ones hold.

#[macro_use]
#[path = "../common/skip.rs"]
mod skip;
#[path = "../common/scan_files.rs"]
mod scan_files;

mod bundled;
mod dialects;
mod formats;
mod hostile;
mod instruments;
mod private_tags;
mod statistics;
mod tiff_kinds;
