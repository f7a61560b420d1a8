//! Stages floor: order, timing, cache, publishing.

pub mod progress;
pub mod study;
