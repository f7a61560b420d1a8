//! Ground floor: colour, transforms, metrics. Uses nothing above it.

pub mod colour;
pub mod csv;
pub mod fft;
pub mod hue;
pub mod memory;
pub mod metrics;
pub mod null_for_nan;
pub mod progress;
pub mod sampling;
pub mod speed;
