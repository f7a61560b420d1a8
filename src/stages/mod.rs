//! Stages floor: the order of the work, its timing, and what it found out.

pub mod results;
