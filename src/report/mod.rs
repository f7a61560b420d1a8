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

pub use html::{render_html, render_page};

use std::path::Path;

use rayon::prelude::*;

use crate::stages::archive::result_file::SpecimenRecord;
use crate::stages::results::{RunResults, SpecimenResult, to_json};
use diffraction_brdf::atlas::{PAGES_FOLDER, page_path};
use diffraction_brdf::error::Result;
use diffraction_brdf::files;

/// Writes `report.html` and `report.json` into a version's folder, whose pictures the page embeds; of many specimens a page each
/// besides, but for those whose page is there.
///
/// # Errors
/// The disk's, or a picture that is no PNG.
pub fn write(results: &RunResults, folder: &Path) -> Result<()> {
    let page = render_html(results, &|path| std::fs::read(folder.join(path)).ok())?;
    files::replace(&folder.join("report.html"), page.as_bytes())?;
    if results.is_of_many() {
        write_pages(results, folder)?;
    }
    files::replace(&folder.join("report.json"), to_json(results).as_bytes())
}

/// One after the other on every thread, so that no more specimens are in memory than there are threads.
fn write_pages(results: &RunResults, folder: &Path) -> Result<()> {
    files::create_folder(&folder.join(PAGES_FOLDER))?;
    let stages = html::stages_by_specimen(results);
    results.specimens.par_iter().try_for_each(|in_short| {
        let path = folder.join(page_path(&in_short.name));
        if path.exists() {
            return Ok(());
        }
        let specimen = whole(in_short, folder);
        let own = stages.get(in_short.name.as_str()).map_or(&[][..], Vec::as_slice);
        let picture = |path: &str| std::fs::read(folder.join(path)).ok();
        let page = html::render_page(&results.atlas_name, &specimen, own, &picture)?;
        files::replace(&path, page.as_bytes())
    })
}

/// Everything of a specimen, as it lies in its folder; what is known of one that has none.
fn whole(in_short: &SpecimenResult, folder: &Path) -> SpecimenResult {
    match SpecimenRecord::read(&folder.join(&in_short.name)) {
        Some(record) => SpecimenResult { stale: in_short.stale.clone(), ..record.result },
        None => in_short.clone(),
    }
}
