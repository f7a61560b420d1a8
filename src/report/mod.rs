//! The report: a self-contained page about a run, its plots, and pictures of the data.

mod axes;
mod budget_facts;
mod colour_maps;
pub(crate) mod html;
pub mod pictures;
#[cfg(feature = "study")]
mod study_captions;
#[cfg(feature = "study")]
pub mod study_page;
#[cfg(feature = "study")]
mod study_plots;

mod embed;
mod error_facts;
pub(crate) mod facts;
mod frames;
mod glance;
mod goniometry;
mod gpu_facts;
mod look_up_facts;
mod map_frames;
mod measured;
mod numbers;
mod optics_facts;
mod overview;
mod plots;
mod prose;
mod provenance;
mod scene_view;
mod specimen_view;
pub mod spectrum_picture;
mod strip_plots;
mod style;
mod svg;
mod table_facts;

pub use html::render_html;

use std::path::Path;

use crate::stages::results::{RunResults, to_json};
use diffraction_brdf::error::Result;
use diffraction_brdf::files;

/// Writes `report.html` and `report.json` into a version's folder, whose pictures the page embeds.
///
/// # Errors
/// The disk's, or a picture that is no PNG.
pub fn write(results: &RunResults, folder: &Path) -> Result<()> {
    let page = render_html(results, &|path| std::fs::read(folder.join(path)).ok())?;
    files::replace(&folder.join("report.html"), page.as_bytes())?;
    files::replace(&folder.join("report.json"), to_json(results).as_bytes())
}
