//! Tables floor: planning, building, restricting to scenes, storage.

pub mod accumulate;
pub mod build;
mod coefficients;
pub mod coverage;
pub mod forecast;
pub mod grid;
pub mod input;
mod lobe;
pub mod look_ups;
pub mod model;
mod nodes;
mod order;
pub mod plan;
pub mod resolution;
pub mod rings;
pub mod rounding;
pub mod spectral;
mod sums;
pub mod taylor;
pub mod texels;
mod work;
