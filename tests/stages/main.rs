//! What a run does between scans and a published atlas, called from the library.

#[macro_use]
#[path = "../common/skip.rs"]
mod skip;
#[path = "../common/atlas_example.rs"]
mod atlas_example;
#[path = "../common/mod.rs"]
mod common;
#[path = "../../fuzz/readers.rs"]
mod readers;
#[path = "../common/report_sample.rs"]
mod report_sample;

mod atlas_files;
mod error_directions;
mod fuzzed;
mod measured;
mod publishing;
mod report_page;
mod restricted;
