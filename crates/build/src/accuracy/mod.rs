//! Accuracy floor: the directions on which errors of tables are counted, the reference there, and what differs.

pub mod directions;
pub mod energy;
mod luminance;
pub mod power_sums;
pub mod reference;
pub mod rows;
pub mod spectral;
pub mod texels;
pub mod thinned;
