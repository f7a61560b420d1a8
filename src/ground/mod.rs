//! Ground floor: errors, directions, spectra and colour, transforms, metrics. Uses nothing above it.

pub mod digest;
pub mod direction;
pub mod error;
pub mod spectrum;
