//! Tables floor: bases, building, storage, evaluation.

pub mod accumulate;
pub mod build;
pub mod domain;
pub mod forecast;
pub mod lobe;
pub mod model;
pub mod pilot;
pub mod plan;
pub mod rounding;
pub mod sums;
pub mod taylor;
