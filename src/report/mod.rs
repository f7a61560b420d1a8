//! The report: a self-contained page about a run, its plots, and pictures of the data.

pub mod study_page;
pub mod study_plots;
