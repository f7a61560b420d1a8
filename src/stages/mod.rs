//! Stages floor: the order of a run, what it found out, and the atlas on disk.
//!
//! Each folder is a room: [`run`] the chain from scans to a version, [`pictures`] the scenes, [`gpu`] the check on a GPU,
//! [`measured`] the comparison with measured reflectance, [`archive`] the files of an atlas. The files beside them are what
//! the rooms share: what a run is told ([`config`]), its scans ([`ingest`]), what it found out ([`results`]), how it goes on
//! ([`log`], [`stage`], [`usage`]).

pub mod archive;
pub mod cache;
pub mod config;
pub mod forecast_run;
pub mod gpu;
pub mod ingest;
pub mod known;
pub(crate) mod log;
pub mod measured;
pub mod pictures;
pub mod reached;
pub mod results;
pub mod run;
pub mod serve;
pub mod stage;
#[cfg(feature = "study")]
pub mod study;
pub mod usage;
