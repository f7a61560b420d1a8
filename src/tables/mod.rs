//! Tables floor: bases, building, storage, evaluation.

pub mod model;
