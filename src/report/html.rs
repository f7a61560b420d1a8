//! The report page: results and pictures in, one self-contained HTML file out.

use minijinja::{Environment, UndefinedBehavior, Value, context, escape_formatter};

use crate::report::embed::{Album, EMBEDDED_MAX_BYTES, Picture, missing};
use crate::report::facts::{self, Fact};
use crate::report::svg::{escape, printable};
use crate::report::{budget_facts, frames, goniometry, gpu_facts, measured, numbers, plots};
use crate::stages::cache::store::CacheUse;
use crate::stages::results::{Grade, RunResults, SceneResult, SharedSceneResult, SpecimenResult, StageTime};
use crate::stages::viewer::page::REPORT_WITHOUT;
use diffraction_brdf::error::{Error, Result};
use diffraction_build::accuracy::directions::Group;
use diffraction_build::accuracy::rows::{ErrorRow, promised};
use diffraction_build::ground::sampling::Region;

const TEMPLATE: &str = include_str!("templates/report.html");

/// The report of a run as one HTML file without scripts and without requests.
///
/// `pictures` gives the bytes of the PNG at a path named in the results, or `None`; a missing
/// picture leaves a visible note. Past 96 MiB of pictures the rest are linked by their paths
/// (said at the top), so the page belongs into the folder that the paths start from.
/// The same results and pictures give the same bytes. Fails on a picture that is no PNG.
pub fn render_html(results: &RunResults, pictures: &dyn Fn(&str) -> Option<Vec<u8>>) -> Result<String> {
    render_within(results, pictures, EMBEDDED_MAX_BYTES)
}

/// [`render_html`] with room for `room_bytes` of pictures.
fn render_within(
    results: &RunResults,
    pictures: &dyn Fn(&str) -> Option<Vec<u8>>,
    room_bytes: usize,
) -> Result<String> {
    let mut album = Album::new(pictures, room_bytes);
    let mut stills = Stills::default();
    let mut summary = Vec::new();
    let mut specimens = Vec::new();
    for (index, specimen) in results.specimens.iter().enumerate() {
        let number = index + 1;
        let preview = match &specimen.preview_png {
            Some(path) => Some(stills.add(path, &mut album)?),
            None => None,
        };
        summary.push(summary_row(number, specimen, preview.as_ref(), &results.stages));
        specimens.push(specimen_section(number, specimen, preview.as_ref(), &results.stages, &mut album)?);
    }
    let has_scenes = results.specimens.iter().any(|specimen| !specimen.scenes.is_empty());
    let gpu = gpu_facts::section(&results.gpu, has_scenes, &mut album)?;
    let shared =
        results.shared_scenes.iter().map(|scene| shared_view(scene, &mut album)).collect::<Result<Vec<_>>>()?;
    let all: Vec<&StageTime> = results.stages.iter().collect();
    let cpu_s: Option<f64> = all.iter().map(|stage| stage.cpu_s).sum();
    let page = context! {
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
        unembedded => unembedded(album.linked),
        stills => safe(stills.definitions()),
        summary => summary,
        specimens => specimens,
        shared => shared,
        times => safe(plots::time_plot(&by_stage(&all))),
        times_cpu => cpu_s.map(numbers::seconds),
        manifest => &results.manifest_text,
    };
    fill_in(page)
}

/// The template with its blanks filled.
fn fill_in(page: Value) -> Result<String> {
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
    environment.add_template("report.html", TEMPLATE).map_err(bug)?;
    let template = environment.get_template("report.html").map_err(bug)?;
    template.render(page).map_err(bug)
}

/// Pictures shown more than once: defined once, used by name.
#[derive(Default)]
struct Stills {
    defined: String,
    count: usize,
}

/// A picture that can be shown any number of times.
enum Still {
    Defined { name: String, size_px: [u32; 2] },
    Missing { path: String },
}

impl Stills {
    fn add(&mut self, path: &str, album: &mut Album) -> Result<Still> {
        let Some(Picture { href, size_px }) = album.picture(path)? else {
            return Ok(Still::Missing { path: path.into() });
        };
        self.count += 1;
        let name = format!("still-{}", self.count);
        self.defined +=
            &format!(r#"<image id="{name}" width="{}" height="{}" href="{}"/>"#, size_px[0], size_px[1], escape(&href));
        Ok(Still::Defined { name, size_px })
    }

    fn definitions(&self) -> String {
        format!(
            r#"<svg width="0" height="0" style="position:absolute" aria-hidden="true"><defs>{}</defs></svg>"#,
            self.defined
        )
    }
}

impl Still {
    fn show(&self, class: &str, label: &str) -> Value {
        safe(match self {
            Self::Defined { name, size_px } => format!(
                r##"<svg class="{class}" viewBox="0 0 {} {}" role="img" aria-label="{}"><use href="#{name}"/></svg>"##,
                size_px[0],
                size_px[1],
                escape(label)
            ),
            Self::Missing { path } => missing(path),
        })
    }
}

fn summary_row(number: usize, specimen: &SpecimenResult, preview: Option<&Still>, stages: &[StageTime]) -> Value {
    let dash = || numbers::MISSING.to_string();
    let statistics = specimen.statistics.as_ref();
    let build = specimen.build.as_ref();
    let worst_scene = specimen
        .scenes
        .iter()
        .filter_map(|scene| scene.error.map(|error| error.ciede2000_p95))
        .fold(f64::NAN, f64::max);
    context! {
        id => anchor(number),
        name => &specimen.name,
        species => specimen.species.clone().unwrap_or_default(),
        generated => specimen.generated,
        failed => specimen.failed.is_some(),
        warnings => match facts::warnings(specimen).len() {
            0 => String::new(),
            count => plural(count, "warning"),
        },
        reason => facts::warnings(specimen).first().map(|warning| first_words(warning)).unwrap_or_default(),
        thumb => preview.map_or_else(|| Value::from(dash()), |still| match still {
            Still::Defined { .. } => still.show("thumb", &format!("Preview of {}", specimen.name)),
            Still::Missing { .. } => Value::from(dash()),
        }),
        period => statistics
            .and_then(|found| found.dominant_periods.first())
            .map_or_else(dash, |period| numbers::length_nm(period.period_nm)),
        rms => statistics.map_or_else(dash, |found| numbers::with_unit(found.rms_height_nm, 3, "nm")),
        tables => build.map_or_else(dash, facts::tables_short),
        grid => build.map_or_else(String::new, facts::grid_short),
        bytes => build.map_or_else(dash, |built| numbers::bytes(built.stored_bytes)),
        error => headline_error(&specimen.errors).map_or_else(dash, |row| numbers::percent(row.p95)),
        scenes => numbers::number(worst_scene, 2),
        time => match own_stages(stages, &specimen.name) {
            own if own.is_empty() => dash(),
            own => numbers::seconds(own.iter().map(|stage| stage.wall_s).sum()),
        },
    }
}

/// As much of a warning as an overview has room for: its first clause, or its first words.
fn first_words(warning: &str) -> String {
    const ROOM: usize = 90;
    let line = warning.lines().next().unwrap_or_default();
    let clause = line.split([';', ':']).next().filter(|clause| clause.len() > ROOM / 4).unwrap_or(line);
    if clause.chars().count() <= ROOM {
        return clause.into();
    }
    let cut: String = clause.chars().take(ROOM).collect();
    format!("{} …", cut.rsplit_once(' ').map_or(cut.as_str(), |(start, _)| start))
}

/// Class of the colour that goes with a verdict's words.
fn colour(grade: Grade) -> &'static str {
    match grade {
        Grade::Green => "green",
        Grade::Amber => "amber",
        Grade::Red => "red",
    }
}

fn specimen_section(
    number: usize,
    specimen: &SpecimenResult,
    preview: Option<&Still>,
    stages: &[StageTime],
    album: &mut Album,
) -> Result<Value> {
    let periods = specimen.statistics.as_ref().map_or(&[][..], |found| &found.dominant_periods);
    let height_map = match &specimen.height_map {
        Some(file) => Some(safe(match album.picture(&file.png)? {
            Some(picture) => {
                let id = format!("heights-{number}");
                frames::height_frame(&picture.href, &id, specimen.extent_um, file)
            }
            None => missing(&file.png),
        })),
        None => None,
    };
    let spectrum = match &specimen.spectrum {
        Some(file) => Some(safe(match album.picture(&file.png)? {
            Some(picture) => {
                let id = format!("spectrum-{number}");
                frames::spectrum_frame(&picture.href, &id, file, periods)
            }
            None => missing(&file.png),
        })),
        None => None,
    };
    let scenes = specimen.scenes.iter().map(|scene| scene_view(scene, album)).collect::<Result<Vec<Value>>>()?;
    let tolerance = specimen.build.as_ref().map(|built| built.tolerance);
    let rows = facts::by_cause(&specimen.errors);
    let errors: Vec<(&ErrorRow, bool)> =
        rows.iter().map(|row| (row, tolerance.is_some_and(|tolerance| row.is_over(tolerance)))).collect();
    let over = errors.iter().any(|(_, over)| *over);
    let goniometry = match &specimen.goniometry {
        Some(found) => Some(goniometry::view(found, periods, album)?),
        None => None,
    };
    Ok(context! {
        goniometry => goniometry,
        id => anchor(number),
        name => &specimen.name,
        species => specimen.species.clone().unwrap_or_default(),
        generated => specimen.generated,
        failed => specimen.failed.clone().unwrap_or_default(),
        grade => specimen.verdict.as_ref().map(|verdict| colour(verdict.grade)).unwrap_or_default(),
        verdict => specimen.verdict.as_ref().map(|verdict| verdict.sentence.clone()).unwrap_or_default(),
        warnings => facts::warnings(specimen),
        preview => preview.map(|still| still.show("still", &format!("Preview of {}", specimen.name))),
        facts => fact_values(&facts::of_specimen(specimen)),
        height_map => height_map,
        first_of => match specimen.scans.len() {
            0 | 1 => String::new(),
            count => format!(" of the first of {count} scans"),
        },
        spectrum => spectrum,
        marks => facts::period_marks(periods),
        scenes => scenes,
        budget => specimen.budget.as_ref().map(budget_facts::budget),
        reached => match &specimen.reached_png {
            Some(path) => Some(safe(album.img(path, "The part of the disc that is covered")?)),
            None => None,
        },
        errors => errors
            .iter()
            .enumerate()
            .map(|(index, &(row, over))| {
                let first = index == 0 || errors[index - 1].0.cause != row.cause;
                error_view(row, first, over)
            })
            .collect::<Vec<_>>(),
        error_plot => safe(plots::error_plot(&rows, tolerance)),
        counted => facts::counted_directions(&rows),
        over => if over {
            format!(
                "Highlighted: above the tolerance of {} that was asked for.",
                numbers::round_percent(tolerance.unwrap_or(f64::NAN))
            )
        } else {
            String::new()
        },
        spectral_errors => spectral_errors(specimen),
        measured => specimen.measured.as_ref().map(|found| safe(measured::section(found))),
        power_plot => safe(plots::power_plot(&specimen.power_sums)),
        times => safe(plots::time_plot(&by_stage(&own_stages(stages, &specimen.name)))),
        scans_title => plural(specimen.scans.len(), "scan"),
        scans => specimen
            .scans
            .iter()
            .map(|scan| fact_values(&facts::of_scan(scan)))
            .collect::<Vec<_>>(),
    })
}

/// Rows of the errors at single wavelengths; none where there are no spectral tables, or nothing was measured.
fn spectral_errors(specimen: &SpecimenResult) -> Vec<Value> {
    let rows = facts::by_cause(specimen.spectral.as_ref().map_or(&[], |spectral| &spectral.errors));
    let is_first = |index: usize| index == 0 || rows[index - 1].cause != rows[index].cause;
    rows.iter().enumerate().map(|(index, row)| error_view(row, is_first(index), false)).collect()
}

fn scene_view(scene: &SceneResult, album: &mut Album) -> Result<Value> {
    let mut optional = |path: &Option<String>, alt: &str| -> Result<Option<Value>> {
        path.as_ref().map(|path| Ok(safe(album.img(path, alt)?))).transpose()
    };
    let side_by_side = optional(&scene.side_by_side_png, "Tables and reference side by side")?;
    let animation = optional(&scene.animation_png, "Animation")?;
    let difference = optional(&scene.difference_png, "Difference from the reference")?;
    let table = safe(album.img(&scene.table_png, &format!("Scene {}", scene.name))?);
    let error = scene.error.as_ref();
    let cell = |value: Option<f64>, show: &dyn Fn(f64) -> String| value.map_or_else(|| numbers::MISSING.into(), show);
    let delta = |value: f64| numbers::number(value, 2);
    let pixels = error.map_or_else(|| numbers::MISSING.into(), |error| numbers::count(error.pixels as u64));
    Ok(context! {
        name => &scene.name,
        about => format!(
            "{}, {}{}{} × {} pixels, exposure {} stops",
            scene.shape,
            scene.light,
            if scene.light.is_empty() { "" } else { ", " },
            scene.size_px[0],
            scene.size_px[1],
            stops(scene.exposure)
        ),
        table => table,
        side_by_side => side_by_side,
        difference => difference,
        animation => animation,
        animation_text => scene.animation.clone().unwrap_or_default(),
        difference_scale => scene.difference_scale.clone().unwrap_or_default(),
        pixels => pixels.clone(),
        cells => vec![
            cell(error.map(|error| error.relative_l2), &numbers::percent),
            cell(error.map(|error| error.ciede2000_mean), &delta),
            cell(error.map(|error| error.ciede2000_p95), &delta),
            cell(error.map(|error| error.ciede2000_max), &delta),
            pixels,
            numbers::seconds(scene.seconds),
        ],
    })
}

/// An exposure in stops: 0 shows a white diffuser that faces a light of unit irradiance as white.
fn stops(exposure: f64) -> String {
    let stops = (exposure / std::f64::consts::PI).log2();
    if !stops.is_finite() {
        return numbers::MISSING.into();
    }
    let sign = if stops < 0.0 { "−" } else { "+" };
    format!("{sign}{:.1}", stops.abs())
}

fn shared_view(shared: &SharedSceneResult, album: &mut Album) -> Result<Value> {
    Ok(context! { specimens => shared.specimens.join(", "), scene => scene_view(&shared.picture, album)? })
}

/// A table row; only the first of a cause names it.
fn error_view(row: &ErrorRow, first: bool, over: bool) -> Value {
    context! {
        what => if first { row.cause.name() } else { "" },
        region => row.group.to_string(),
        directions => numbers::count(row.directions as u64),
        p50 => numbers::percent(row.p50),
        p95 => numbers::percent(row.p95),
        p99 => numbers::percent(row.p99),
        worst => numbers::percent(row.worst),
        l2 => numbers::percent(row.relative_l2),
        over => over,
    }
}

/// The row for the summary: everything together, over the whole hemisphere.
fn headline_error(rows: &[ErrorRow]) -> Option<&ErrorRow> {
    let total = promised(rows);
    let mut totals = rows.iter().filter(|row| row.cause == total);
    let first = totals.clone().next();
    totals.find(|row| row.group == Group::Region(Region::Hemisphere)).or(first)
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
            context! { place => place, message => &failure.message }
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

fn own_stages<'a>(stages: &'a [StageTime], specimen: &str) -> Vec<&'a StageTime> {
    stages.iter().filter(|stage| stage.specimen.as_deref() == Some(specimen)).collect()
}

/// Elapsed seconds per stage, in the order in which the stages first occur.
fn by_stage(stages: &[&StageTime]) -> Vec<(String, f64)> {
    let mut sums: Vec<(String, f64)> = Vec::new();
    for stage in stages {
        match sums.iter_mut().find(|sum| sum.0 == stage.name.as_str()) {
            Some(sum) => sum.1 += stage.wall_s,
            None => sums.push((stage.name.to_string(), stage.wall_s)),
        }
    }
    sums
}

fn fact_values(facts: &[Fact]) -> Vec<Value> {
    facts.iter().map(|fact| context! { name => &fact.name, text => &fact.text }).collect()
}

fn anchor(number: usize) -> String {
    format!("specimen-{number}")
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
    use diffraction_build::accuracy::rows::Cause;
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
        assert!(!roomy.contains("did not fit") && !roomy.contains("./a/"));
        let full = render_within(&small_run(), &source, png().len()).unwrap();
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
        assert!(fill_in(context! { atlas => "a" }).is_err());
    }

    #[test]
    fn the_headline_is_the_whole_hemisphere() {
        let row = |cause, region| facts::tests::error_row(cause, region, 0.0);
        let rows = [
            row(Cause::Basis, Region::Hemisphere),
            row(Cause::Total, Region::Grazing),
            row(Cause::Total, Region::Hemisphere),
        ];
        assert_eq!(headline_error(&rows), Some(&rows[2]));
        assert_eq!(headline_error(&rows[..2]), Some(&rows[1]));
        assert_eq!(headline_error(&rows[..1]), None);
    }
}
