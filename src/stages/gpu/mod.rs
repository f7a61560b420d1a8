//! The GPU in a run: the published files drawn on it and compared with the CPU and the reference, and the time of a frame.

pub mod check;
pub mod device;
pub(crate) mod frame_time;
pub mod published;
pub mod results;
mod spectral;
pub(crate) mod stage;
