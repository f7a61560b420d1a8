//! Stages floor: order, timing, cache, publishing.

pub mod gpu_check;
pub mod progress;
pub mod shader_export;
