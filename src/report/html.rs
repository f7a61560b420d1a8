//! The report page: results and pictures in, one self-contained HTML file out.

use std::collections::HashMap;

use minijinja::{Environment, UndefinedBehavior, Value, context, escape_formatter};

use crate::report::colour_maps::{INFERNO, css_ramp};
use crate::report::embed::{Album, EMBEDDED_MAX_BYTES};
use crate::report::prose::prose;
use crate::report::scene_view::shared_view;
use crate::report::specimen_view::{anchor, by_stage, specimen_section};
use crate::report::style::{OVERVIEW_SCRIPT, STYLE};
use crate::report::svg::printable;
use crate::report::{gpu_facts, numbers, overview, plots};
use crate::stages::cache::store::CacheUse;
use crate::stages::results::{RunResults, SpecimenResult, StageTime};
use crate::stages::viewer::page::REPORT_WITHOUT;
use diffraction_brdf::atlas::page_path;
use diffraction_brdf::error::{Error, Result};

/// The pages and their parts, by name.
const TEMPLATES: [(&str, &str); 4] = [
    (REPORT, include_str!("templates/report.html")),
    (PAGE, include_str!("templates/page.html")),
    ("specimen.html", include_str!("templates/specimen.html")),
    ("reading.html", include_str!("templates/reading.html")),
];
const REPORT: &str = "report.html";
const PAGE: &str = "page.html";

/// Bytes of previews inside an overview.
const PREVIEWS_MAX_BYTES: usize = 3 << 20;

/// The report of a run as one HTML file that requests nothing but linked pictures; a small script sorts its overview.
///
/// `pictures` gives the bytes of the PNG at a path named in the results, or `None`; a missing
/// picture leaves a visible note. Past 96 MiB of pictures they are linked by their paths
/// (said at the top), so the page belongs into the folder that the paths start from. Of many specimens it is an overview, which links
/// to [`render_page`] of each.
/// The same results and pictures give the same bytes. Fails on a picture that is no PNG.
pub fn render_html(results: &RunResults, pictures: &dyn Fn(&str) -> Option<Vec<u8>>) -> Result<String> {
    render_within(results, pictures, EMBEDDED_MAX_BYTES)
}

/// The page of one specimen among many, for the file of [`page_path`]; `stages` are its own.
///
/// # Errors
/// As [`render_html`].
pub fn render_page(
    atlas_name: &str,
    specimen: &SpecimenResult,
    stages: &[&StageTime],
    pictures: &dyn Fn(&str) -> Option<Vec<u8>>,
) -> Result<String> {
    let section = specimen_section(1, specimen, stages, &mut Album::of_page_below(pictures))?;
    fill_in(
        PAGE,
        context! {
            style => safe(STYLE.to_owned()),
            ramp => safe(css_ramp(&INFERNO)),
            atlas => atlas_name,
            s => section,
        },
    )
}

/// Times of every specimen's own stages.
pub(crate) fn stages_by_specimen(results: &RunResults) -> HashMap<&str, Vec<&StageTime>> {
    let mut found: HashMap<&str, Vec<&StageTime>> = HashMap::new();
    for stage in &results.stages {
        if let Some(specimen) = &stage.specimen {
            found.entry(specimen).or_default().push(stage);
        }
    }
    found
}

/// [`render_html`] with room for `room_bytes` of pictures.
fn render_within(
    results: &RunResults,
    pictures: &dyn Fn(&str) -> Option<Vec<u8>>,
    room_bytes: usize,
) -> Result<String> {
    let mut previews = Album::new(pictures, PREVIEWS_MAX_BYTES);
    let mut album = Album::new(pictures, room_bytes);
    let mut order: Vec<usize> = (0..results.specimens.len()).collect();
    order.sort_by_key(|&index| overview::state(&results.specimens[index]));
    let (mut summary, mut specimens) = (Vec::new(), Vec::new());
    let stages = stages_by_specimen(results);
    for index in order {
        let specimen = &results.specimens[index];
        let preview = specimen.preview_png.as_ref();
        let preview = preview.map(|path| previews.img(path, &format!("Preview of {}", specimen.name))).transpose()?;
        let own = stages.get(specimen.name.as_str()).map_or(&[][..], Vec::as_slice);
        let href = match results.is_of_many() {
            true => format!("./{}", page_path(&specimen.name)),
            false => format!("#{}", anchor(index + 1)),
        };
        summary.push(overview::row(&href, specimen, preview, own));
        if !results.is_of_many() {
            specimens.push(specimen_section(index + 1, specimen, own, &mut album)?);
        }
    }
    let has_scenes = results.specimens.iter().any(|specimen| !specimen.scenes.is_empty());
    let gpu = gpu_facts::section(&results.gpu, has_scenes, &mut album)?;
    let shared =
        results.shared_scenes.iter().map(|scene| shared_view(scene, &mut album)).collect::<Result<Vec<_>>>()?;
    let all: Vec<&StageTime> = results.stages.iter().collect();
    let cpu_s: Option<f64> = all.iter().map(|stage| stage.cpu_s).sum();
    let page = context! {
        style => safe(STYLE.to_owned()),
        script => safe(OVERVIEW_SCRIPT.to_owned()),
        ramp => safe(css_ramp(&INFERNO)),
        counted => overview::counted(&results.specimens),
        atlas => &results.atlas_name,
        version => results.version.clone().unwrap_or_default(),
        started => results.started.replace('T', " ").replace('Z', " UTC"),
        program_version => &results.program_version,
        viewer => safe(REPORT_WITHOUT.to_owned()),
        total_time => numbers::seconds(results.total_wall_s),
        threads => plural(results.threads, "thread"),
        cpus => plural(results.cpu_count, "processor"),
        peak_memory => results.peak_memory_mib.map(|size| numbers::bytes((size * 1048576.0) as u64)),
        gpu => gpu,
        failures_title => format!("{} on the way to this atlas", plural(results.failures.len(), "failure")),
        failures => failures(results),
        left_out => &results.left_out,
        cache => results.cache.as_ref().map(cache_line),
        unembedded => unembedded(album.linked + previews.linked),
        summary => summary,
        specimens => specimens,
        shared => shared,
        times => safe(plots::time_plot(&by_stage(&all))),
        times_cpu => cpu_s.map(numbers::seconds),
        manifest => &results.manifest_text,
    };
    fill_in(REPORT, page)
}

/// The template of this name with its blanks filled.
fn fill_in(name: &str, page: Value) -> Result<String> {
    let bug = |error: minijinja::Error| {
        Error::limit(
            format!("the report page could not be put together: {error:#}"),
            "this is a bug of the program; please report it with this message",
        )
    };
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    environment.set_formatter(|out, state, value| match value.as_str() {
        // Names and messages come from files: control characters would break the page.
        Some(text) if text.chars().any(|character| printable(character) != character) => {
            let clean: String = text.chars().map(printable).collect();
            escape_formatter(out, state, &Value::from(clean))
        }
        _ => escape_formatter(out, state, value),
    });
    for (name, template) in TEMPLATES {
        environment.add_template(name, template).map_err(bug)?;
    }
    let template = environment.get_template(name).map_err(bug)?;
    template.render(page).map_err(bug)
}

fn failures(results: &RunResults) -> Vec<Value> {
    results
        .failures
        .iter()
        .map(|failure| {
            let place = match &failure.specimen {
                Some(specimen) => format!("{specimen}, {}", failure.stage),
                None => failure.stage.to_string(),
            };
            context! { place => place, message => safe(prose(&failure.message)) }
        })
        .collect()
}

/// What was kept from earlier runs.
fn cache_line(used: &CacheUse) -> String {
    format!(
        "From earlier runs: tables of {} of {}, {} of {} values of the reference ({} read, {} written).",
        used.tables_found,
        plural((used.tables_found + used.tables_built) as usize, "specimen"),
        numbers::count(used.pairs_found),
        numbers::count(used.pairs_found + used.pairs_computed),
        numbers::bytes(used.bytes_read),
        numbers::bytes(used.bytes_written)
    )
}

fn unembedded(linked: usize) -> String {
    if linked == 0 {
        return String::new();
    }
    format!(
        "{} did not fit into this page and {} read from the files beside it: keep them together.",
        plural(linked, "picture"),
        if linked == 1 { "is" } else { "are" }
    )
}

fn plural(count: usize, noun: &str) -> String {
    let ending = if count == 1 { "" } else { "s" };
    format!("{} {noun}{ending}", numbers::count(count as u64))
}

/// Markup made here, not to be escaped again.
fn safe(markup: String) -> Value {
    Value::from_safe_string(markup)
}

#[cfg(test)]
mod tests {
    use super::*;
    use diffraction_render::render::png_image::encode_png;

    fn png() -> Vec<u8> {
        encode_png(&ndarray::Array3::zeros((4, 6, 3))).unwrap()
    }

    /// A run with one specimen and two pictures.
    fn small_run() -> RunResults {
        serde_json::from_value(serde_json::json!({
            "schema": crate::stages::results::RESULTS_SCHEMA, "atlas_name": "small", "version": null, "program_version": "0",
            "started": "2025-01-01T00:00:00Z", "threads": 1, "cpu_count": 1,
            "manifest_text": "", "stages": [], "gpu": { "state": "skipped", "why": "no adapter" },
            "failures": [], "peak_memory_mib": null, "total_wall_s": 1.0,
            "specimens": [{
                "name": "a", "species": null, "generated": false, "scans": [], "size": [4, 4],
                "pitch_nm": [50.0, 50.0], "extent_um": [0.2, 0.2], "statistics": null,
                "optics": null, "build": null, "lobe": null, "errors": [], "power_sums": [],
                "scenes": [], "preview_png": "a/preview.png", "warnings": [], "failed": null,
                "height_map": {
                    "png": "a/heights.png", "scale_bar_um": 0.05, "low_nm": 0.0, "high_nm": 1.0
                },
                "spectrum": null
            }]
        }))
        .unwrap()
    }

    #[test]
    fn a_full_page_links_the_rest_and_says_so() {
        let source = |_: &str| Some(png());
        let roomy = render_within(&small_run(), &source, 2 * png().len()).unwrap();
        assert!(!roomy.contains("did not fit") && !roomy.contains("./a/heights.png"));
        let full = render_within(&small_run(), &source, 0).unwrap();
        assert!(full.contains("1 picture did not fit into this page and is read"));
        assert!(full.contains("./a/heights.png") && full.contains("data:image/png"));
    }

    #[test]
    fn a_picture_that_is_none_is_an_error_that_names_it() {
        let error = render_html(&small_run(), &|_| Some(b"GIF89a".to_vec())).unwrap_err();
        assert!(error.to_string().starts_with("a/preview.png: "), "{error}");
    }

    #[test]
    fn a_blank_that_nobody_fills_is_an_error() {
        assert!(fill_in(REPORT, context! { atlas => "a" }).is_err());
    }
}
