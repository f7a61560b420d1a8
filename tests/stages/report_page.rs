//! The report page on a sample run: well-formed, self-contained, escaped, and without NaN.
//!
//! The page is left at `target/tmp/report.html` to be looked at.

use crate::report_sample::{Sample, sample};
use diffraction_atlas::report::{render_html, render_page};
use diffraction_atlas::stages::results::{GpuResult, RunResults, SpecimenResult, from_json, to_json};
use diffraction_build::accuracy::directions::Group;

/// Names and messages with everything that markup and terminals trip over.
const HOSTILE: &str = "<b>&\"'\u{7}\u{1b}[31m{{ 1 }}]]>--><script>";

fn render(sample: &Sample) -> String {
    render_html(&sample.results, &|path| sample.pictures.get(path).cloned()).unwrap()
}

fn parse(html: &str) -> roxmltree::Document<'_> {
    let options = roxmltree::ParsingOptions { allow_dtd: true, ..Default::default() };
    roxmltree::Document::parse_with_options(html, options)
        .unwrap_or_else(|error| panic!("{error}: {}", excerpt(html, error.pos())))
}

fn excerpt(html: &str, place: roxmltree::TextPos) -> String {
    let line = html.lines().nth(place.row as usize - 1).unwrap_or("");
    line.chars().skip((place.col as usize).saturating_sub(60)).take(120).collect()
}

/// What a reader sees: the text outside of style sheet and script, pictures' bytes not included.
fn visible_text(document: &roxmltree::Document) -> String {
    document
        .descendants()
        .filter(|node| node.is_text() && !["style", "script"].contains(&node.parent().unwrap().tag_name().name()))
        .filter_map(|node| node.text())
        .collect::<Vec<_>>()
        .join("\n")
}

/// Sets every text of the results to something hostile.
fn make_hostile(results: &mut RunResults) {
    results.atlas_name = HOSTILE.into();
    results.version = Some(HOSTILE.into());
    results.started = HOSTILE.into();
    results.program_version = HOSTILE.into();
    results.manifest_text = HOSTILE.into();
    for failure in &mut results.failures {
        failure.specimen = Some(HOSTILE.into());
        failure.message = HOSTILE.into();
    }
    if let GpuResult::Checked { gpu, rows, spectral, frames } = &mut results.gpu {
        for text in [&mut gpu.adapter, &mut gpu.backend, &mut gpu.driver, &mut gpu.kind] {
            *text = HOSTILE.into();
        }
        gpu.features = vec![HOSTILE.into()];
        for row in rows {
            row.specimen = HOSTILE.into();
            row.cpu.scene = HOSTILE.into();
            row.difference_png = Some(HOSTILE.into());
        }
        for row in spectral {
            row.specimen = HOSTILE.into();
        }
        let frames = frames.as_mut().unwrap();
        frames.specimen = HOSTILE.into();
        frames.refused = Some(HOSTILE.into());
    }
    for specimen in &mut results.specimens {
        specimen.name = HOSTILE.into();
        specimen.species = Some(HOSTILE.into());
        specimen.scans = vec![serde_json::json!({ HOSTILE: HOSTILE }), HOSTILE.into()];
        specimen.warnings = vec![HOSTILE.into()];
        specimen.failed = Some(HOSTILE.into());
        for row in &mut specimen.errors {
            row.group = Group::Scene(HOSTILE.into());
        }
        for scene in &mut specimen.scenes {
            scene.name = HOSTILE.into();
            scene.shape = HOSTILE.into();
            scene.difference_scale = Some(HOSTILE.into());
            scene.difference_png = Some(HOSTILE.into());
        }
    }
}

#[test]
fn the_page_is_well_formed_and_says_what_was_found() {
    let sample = sample();
    let html = render(&sample);
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    std::fs::write(folder.join("report.html"), &html).unwrap();
    let document = parse(&html);
    let text = visible_text(&document).replace(['\u{a0}', '\u{202f}'], " ");
    for expected in [
        "corn_snake_like",
        "Pantherophis guttatus",
        "1.14 µm",
        "6 Chebyshev, half",
        "9.20 MiB",
        "All 2 things to know",
        "with care",
        "the unit was spelt \"nM\", read as nm",
        "the file ends after 31 of 512 rows",
        "tolerance = 1e-3",
    ] {
        assert!(text.contains(expected), "the page does not say {expected:?}");
    }
    let labels = document.descendants().filter_map(|node| node.text());
    assert!(labels.into_iter().any(|label| label == "5 µm"), "the scale bar's length");
    // Failures come before everything else that is about specimens.
    let place = |what: &str| text.find(what).unwrap();
    assert!(place("the file ends after") < place("How to read this"));
}

#[test]
fn warnings_of_several_scans_are_named_by_their_files() {
    let mut sample = sample();
    let grating = sample.results.specimens.iter_mut().find(|specimen| specimen.name.starts_with("grating")).unwrap();
    let mut second = grating.scans[0].clone();
    second["file_name"] = "second.tif".into();
    grating.scans.push(second);
    grating.statistics.as_mut().unwrap().warnings = vec!["steep".into()];
    let html = render(&sample);
    let text = visible_text(&parse(&html));
    for expected in ["grating_nanosurf_314nm.tif: steep", "second.tif: the unit was", " of the first of 2 scans"] {
        assert!(text.contains(expected), "the page does not say {expected:?}");
    }
    // Of one scan, its specimen's name says enough.
    assert!(!text.contains("corn_snake_like.tif: "));
}

#[test]
fn nothing_is_fetched_and_one_script_runs() {
    let sample = sample();
    let html = render(&sample);
    assert!(!html.contains("http"), "no address of any kind");
    let document = parse(&html);
    for node in document.descendants().filter(|node| node.is_element()) {
        let tag = node.tag_name().name();
        assert!(!["link", "iframe", "object", "base"].contains(&tag), "{tag}");
        for attribute in node.attributes() {
            let (name, value) = (attribute.name(), attribute.value());
            assert!(!name.starts_with("on"), "{name}");
            if name == "href" || name == "src" {
                // A picture is a link to its own file, which lies beside the page.
                let is_own_file =
                    name == "href" && node.has_tag_name("a") && value.starts_with("./") && !value.contains("..");
                let is_inside = value.starts_with('#') || value.starts_with("data:image/png;base64,");
                assert!(is_inside || is_own_file, "{value:.60}");
            }
        }
    }
    let scripts: Vec<_> = document.descendants().filter(|node| node.has_tag_name("script")).collect();
    assert_eq!(scripts.len(), 1);
    assert_eq!(scripts[0].attributes().len(), 0);
    assert_eq!(scripts[0].text(), Some(include_str!("../../src/report/templates/overview.js")));
    let css = document.descendants().find(|node| node.has_tag_name("style")).and_then(|node| node.text()).unwrap();
    assert!(!css.contains("url(") && !css.contains("@import"));
}

#[test]
fn references_within_the_page_lead_somewhere() {
    let sample = sample();
    let html = render(&sample);
    let document = parse(&html);
    let mut ids: Vec<&str> = document.descendants().filter_map(|node| node.attribute("id")).collect();
    let count = ids.len();
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), count, "ids are unique");
    let mut followed = 0;
    for node in document.descendants() {
        if let Some(target) = node.attribute("href").and_then(|href| href.strip_prefix('#')) {
            assert!(ids.contains(&target), "#{target}");
            followed += 1;
        }
    }
    assert!(followed >= 2 * sample.results.specimens.len());
}

#[test]
fn hostile_names_stay_text() {
    let mut sample = sample();
    make_hostile(&mut sample.results);
    let html = render(&sample);
    let document = parse(&html);
    let scripts = document.descendants().filter(|node| node.has_tag_name("script"));
    assert_eq!(scripts.count(), 1, "the page's own");
    assert!(html.chars().all(|c| !c.is_control() || c == '\n'));
    let clean = HOSTILE.replace(['\u{7}', '\u{1b}'], "\u{fffd}");
    assert!(visible_text(&document).matches(&clean).count() > 20);
}

#[test]
fn missing_numbers_are_dashes() {
    let mut sample = sample();
    let complete = render(&sample);
    let dashes = |html: &str| html.matches('–').count();
    for specimen in &mut sample.results.specimens {
        specimen.extent_um = [f64::NAN, f64::INFINITY];
        if let Some(found) = &mut specimen.statistics {
            found.rms_slope = f64::NAN;
            found.steep_share = f64::NEG_INFINITY;
            found.dominant_periods[0].period_nm = f64::NAN;
            found.dominant_periods[0].direction_deg = f64::NAN;
        }
        for row in &mut specimen.errors {
            (row.relative_l2, row.p50, row.p95) = (f64::NAN, f64::INFINITY, f64::NAN);
        }
        for sum in &mut specimen.power_sums {
            sum.sum = f64::NAN;
        }
        if let Some(map) = &mut specimen.height_map {
            (map.low_nm, map.high_nm) = (f64::NAN, f64::NAN);
        }
        for scene in &mut specimen.scenes {
            scene.exposure = f64::NAN;
            scene.error.as_mut().unwrap().ciede2000_p95 = f64::NAN;
        }
    }
    let html = render(&sample);
    let document = parse(&html);
    let everything = visible_text(&document);
    assert!(!everything.contains("NaN") && !everything.contains("inf "));
    for node in document.descendants() {
        for attribute in node.attributes() {
            let value = attribute.value();
            assert!(value.starts_with("data:") || !value.contains("NaN"), "{value:.80}");
        }
    }
    assert!(dashes(&html) > dashes(&complete) + 20);
}

#[test]
fn missing_pictures_leave_a_note() {
    let sample = sample();
    let html = render_html(&sample.results, &|_| None).unwrap();
    parse(&html);
    assert!(html.contains("picture missing: corn_snake_like/preview.png"));
    // The bars of colour are drawn from numbers, not from files.
    assert_eq!(html.matches("data:image").count(), html.matches("image-rendering:pixelated").count());
}

#[test]
fn the_same_results_give_the_same_bytes() {
    let sample = sample();
    assert!(render(&sample) == render(&sample));
    let mut other = sample.results.clone();
    other.specimens[0].errors[0].p95 *= 1.5;
    let changed = render_html(&other, &|path| sample.pictures.get(path).cloned()).unwrap();
    assert!(render(&sample) != changed);
}

#[test]
fn an_empty_run_has_a_page() {
    let mut results = sample().results;
    results.specimens.clear();
    results.stages.clear();
    results.failures.clear();
    results.version = None;
    results.gpu = GpuResult::Off;
    let html = render_html(&results, &|_| None).unwrap();
    parse(&html);
    assert!(html.contains("published no new version"));
}

#[test]
fn json_comes_back_as_it_was() {
    let results = sample().results;
    let text = to_json(&results);
    let back = from_json(&text, "report.json").unwrap();
    // Not assert_eq: the two would fill the screen.
    assert!(back == results);
    assert!(to_json(&back) == text);

    let mut missing = results;
    missing.specimens[0].errors[0].worst = f64::NAN;
    let text = to_json(&missing);
    assert!(!text.contains("NaN"));
    let back = from_json(&text, "report.json").unwrap();
    assert!(back.specimens[0].errors[0].worst.is_nan());
    assert!(to_json(&back) == text);
}

/// Text of the elements of a class, in the page's order.
fn texts_of(document: &roxmltree::Document, class: &str) -> Vec<String> {
    let of_class = document.descendants().filter(|node| node.attribute("class") == Some(class));
    of_class.map(|node| node.descendants().filter_map(|node| node.text()).collect::<Vec<_>>().join(" ")).collect()
}

#[test]
fn what_one_wants_to_know_comes_first() {
    let sample = sample();
    let html = render(&sample);
    let document = parse(&html);
    let found = texts_of(&document, "glance");
    assert_eq!(found.len(), 3, "all but the one that failed");
    for text in &found {
        for question in
            ["Which colours, from which angles?", "Is it good?", "What does it cost?", "Does it match a measurement?"]
        {
            assert!(text.contains(question), "{text}");
        }
        assert!(text.contains("FORMAT.md") && text.contains("ΔE₀₀"), "{text}");
    }
    for section in html.split("<section class=\"specimen\"").skip(1).filter(|section| !section.contains("<b>Failed")) {
        assert!(section.find("class=\"glance\"").unwrap() < 700, "nothing comes before it but the name");
    }
}

#[test]
fn what_failed_comes_first_in_the_overview_and_on_the_page() {
    let mut sample = sample();
    // Without a verdict it is judged by its warnings, of which it has none.
    sample.results.specimens[2].verdict = None;
    let html = render(&sample);
    let document = parse(&html);
    let overview = document.descendants().find(|node| node.attribute("id") == Some("overview")).unwrap();
    let states: Vec<&str> = overview.descendants().filter_map(|node| node.attribute("data-state")).collect();
    assert_eq!(states, ["0", "2", "2", "3"]);
    let sections = document.descendants().filter(|node| node.attribute("class") == Some("specimen"));
    let first = sections.into_iter().next().unwrap();
    assert!(first.descendants().any(|node| node.text() == Some("torn_scan")));
}

#[test]
fn raw_words_of_the_program_do_not_show() {
    let mut sample = sample();
    let specimen = &mut sample.results.specimens[0];
    specimen
        .warnings
        .push("shifts by 2.1e-3 where 0.0e0 is allowed: `tables.storage = \"auto\"`, 48.798798798798806 nm".into());
    let html = render(&sample);
    let text = visible_text(&parse(&html));
    for raw in ["e-3", "0.0e0", "798798", "sample_format", "sample format", "f32", "shader_float32", "0 × 0 samples"] {
        let shown = text.lines().filter(|line| !line.contains("tolerance = 1e-3"));
        assert!(!shown.into_iter().any(|line| line.contains(raw)), "{raw}");
    }
    assert!(!text.contains('`'));
}

#[test]
fn of_many_specimens_each_has_a_page_and_the_overview_stays_small() {
    let mut sample = sample();
    let snake = sample.results.specimens[0].clone();
    let many = 200;
    for number in 0..many {
        sample.results.specimens.push(SpecimenResult { name: format!("snake_{number}"), ..snake.clone() }.in_short());
    }
    let html = render(&sample);
    let document = parse(&html);
    let links = document.descendants().filter_map(|node| node.attribute("href"));
    assert_eq!(links.filter(|link| link.starts_with("./report.pages/snake_")).count(), many);
    assert!(!html.contains("class=\"specimen\""));
    // Two thousand of them stay below 10 MB; previews are bounded apart.
    let text = visible_text(&document);
    assert!(text.len() / many < 1000, "{}", text.len() / many);

    let picture = |path: &str| sample.pictures.get(path).cloned();
    let stages: Vec<_> = sample.results.stages.iter().collect();
    let page = render_page("squamates", &snake, &stages, &picture).unwrap();
    let own = parse(&page);
    let said = visible_text(&own).replace(['\u{a0}', '\u{202f}'], " ");
    for expected in ["corn_snake_like", "Pantherophis guttatus", "1.14 µm", "6 Chebyshev, half", "How to read this"] {
        assert!(said.contains(expected), "the page does not say {expected:?}");
    }
    assert!(page.contains("\"../corn_snake_like/heights.png\"") && page.contains("\"../report.html\""));
    // The overview says of a specimen in short what it says of the whole one.
    let row = |specimen: SpecimenResult| {
        let mut results = sample.results.clone();
        results.specimens = vec![specimen];
        let html = render_html(&results, &picture).unwrap();
        html.split("id=\"overview\"").nth(1).unwrap().split("</table>").next().unwrap().to_owned()
    };
    assert_eq!(row(snake.clone().in_short()), row(snake));
}
