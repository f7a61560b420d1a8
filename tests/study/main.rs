//! The page of a study and the tolerances it tries; the study itself is tested in its own crate.

#[macro_use]
#[path = "../common/skip.rs"]
mod skip;
#[path = "../common/mod.rs"]
mod common;
#[path = "../../crates/study/tests/waves/mod.rs"]
mod waves;

mod study_page;
mod tolerance;
