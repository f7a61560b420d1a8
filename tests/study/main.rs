//! The study of methods and the suite that tries to break them.

#[macro_use]
#[path = "../common/skip.rs"]
mod skip;
#[path = "../common/mod.rs"]
mod common;

mod stability;
mod study_page;
