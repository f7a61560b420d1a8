//! Accuracy floor: the directions on which errors of tables are counted, the reference there, and what differs.

pub mod directions;
pub mod measure;
pub mod rows;
