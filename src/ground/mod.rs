//! Ground floor: errors, directions, spectra and colour, transforms, metrics. Uses nothing above it.

pub mod chebyshev;
pub mod cie_data;
pub mod colour;
pub mod csv;
pub mod direction;
pub mod error;
pub mod exr_foreign;
pub mod exr_header;
pub mod exr_image;
pub mod fft;
pub mod files;
pub mod json;
pub mod metrics;
pub mod png_image;
pub mod sampling;
pub mod spectrum;
