//! What tables of diffraction cost and how far they are off, beside the published method and older models.
//!
//! - [`study`]: every method over its settings on the same scans and directions: error, run time, memory, bytes;
//! - [`stability`]: stiff and extreme cases, each with a derived bound and shown to need what keeps it;
//! - `baselines`: the older models, fitted to the same scans.
//!
//! Lengths are in nm, the BRDF in 1/sr, times in seconds; errors are relative, of the luminance Y, against the direct sum.
//!
//! Pictures and a GPU's clock are lent by whoever can draw: see [`study::SceneSamples`] and [`study::GpuClock`].

pub(crate) mod baselines;
pub mod error;
pub mod stability;
pub mod study;
