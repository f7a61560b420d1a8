//! The report: a self-contained page about a run, its plots, and pictures of the data.

pub mod colour_maps;
pub mod html;
pub mod pictures;

mod embed;
mod facts;
mod frames;
mod numbers;
mod plots;
mod spectrum_picture;
mod svg;

pub use html::render_html;
