//! Ground floor: errors, directions, spectra and colour, transforms, metrics. Uses nothing above it.

pub mod chebyshev;
pub mod cie_data;
pub mod direction;
pub mod error;
pub mod exr_header;
pub mod exr_image;
pub mod files;
pub mod json;
pub mod sampling;
pub mod spectrum;
