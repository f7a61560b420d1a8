//! The study of methods and the suite that tries to break them.

#[path = "../common/mod.rs"]
mod common;

mod stability;
mod study_page;
