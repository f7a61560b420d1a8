//! Tables floor: bases, building, storage, evaluation.

pub mod model;
pub mod storage;
