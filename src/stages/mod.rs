//! Stages floor: order, timing, cache, publishing.

pub mod progress;
pub mod stability;
pub mod study;
