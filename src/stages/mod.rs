//! Stages floor: the order of a run, what it found out, and the atlas on disk.
//!
//! Each folder is a room: [`run`] the chain from scans to a version, [`pictures`] the scenes, [`gpu`] the check on a GPU,
//! [`measured`] the comparison with measured reflectance, [`goniometry`] which colours are seen
//! from which angles, [`coverage`] what restricts tables to scenes, `cache` what is kept
//! from run to run, [`archive`] the files of an atlas, `study` what the study is lent, `viewer` the page in the browser. The
//! files beside them are what the rooms
//! share: what a run is told ([`config`]), its scans ([`ingest`]), its tables ([`built`]), what it found out ([`results`]), how
//! it goes on (`log`, [`stage`], [`usage`]), which program it is (`program`), digests of files (`digest`).

pub mod archive;
pub mod built;
pub(crate) mod cache;
pub mod config;
pub mod coverage;
pub(crate) mod digest;
pub mod goniometry;
pub mod gpu;
pub mod ingest;
pub(crate) mod log;
pub mod measured;
pub mod pictures;
pub(crate) mod program;
pub mod results;
pub mod run;
pub mod stage;
#[cfg(feature = "study")]
pub mod study;
pub mod usage;
pub(crate) mod viewer;
