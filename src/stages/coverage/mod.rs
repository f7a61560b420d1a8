//! Tables restricted to a manifest's scenes: which scenes a specimen's tables answer for, what those look up, and what
//! leaving out the rest saves.

pub(crate) mod asked;
pub mod savings;
