//! The report: a self-contained page about a run, its plots, and pictures of the data.

pub mod colour_maps;
pub mod pictures;

mod frames;
mod numbers;
mod plots;
mod spectrum_picture;
mod svg;
