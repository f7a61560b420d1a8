//! The study as files: a self-contained page, the numbers as JSON, and each plot as SVG.

use std::collections::BTreeMap;
use std::path::Path;

use minijinja::{Environment, Value, context};

use super::embed::data_uri;
use super::study_captions;
use super::study_plots::{
    Figure, cost_figure, cost_figure_on_texels, knob_figure, lights_figure, stability_figures, svg, tables_figure,
    tolerance_figure,
};
use super::style::STYLE;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::files::{create_folder, replace};
use diffraction_render::render::png_image::encode_png;
use diffraction_study::stability::{Stability, StabilityCase, Verdict};
use diffraction_study::study::{DIAMETERS_DEG, PURPOSES, SpecimenStudy, Study};

/// Knobs whose settings are numbers: file key, rows drawn together, axis.
const KNOB_PLOTS: [(&str, &[&str], &str); 5] = [
    ("basis", &["basis"], "number of tables"),
    ("wavelength-step", &["wavelength step"], "largest wavelength step (nm)"),
    ("grid", &["grid, bilinear", "grid, cubic"], "texels along u and v"),
    ("storage", &["storage"], "significant bits of stored numbers"),
    ("windows", &["windows"], "windows averaged"),
];

/// Methods whose pictures are shown beside the reference, each by its last setting.
const SHOWN: [&str; 6] =
    ["FFT", "chebyshev, half", "taylor, float", "Stam, random", "Stam, regular", "spherical harmonics"];

/// Name of the page in a study's folder, as in a version of an atlas.
pub(crate) const PAGE: &str = "report.html";

/// A file's name and its bytes.
pub type File = (String, Vec<u8>);

/// All files of a study: `report.html`, `study.json`, `stability.json`, and the SVG pictures, which the page contains as
/// well.
///
/// # Errors
/// `Error::Call` if the page cannot be made: a defect of the program.
pub fn study_files(study: &Study, stability: &Stability) -> Result<Vec<File>> {
    let mut pictures: Vec<File> = Vec::new();
    let (mut of_specimens, mut strips) = (Vec::new(), Vec::new());
    for specimen in &study.specimens {
        let name = file_name(&specimen.name);
        let mut own = Vec::new();
        for (key, figure) in figures(specimen) {
            let picture = svg(&figure);
            pictures.push((format!("{name}.{key}.svg"), picture.clone().into_bytes()));
            own.push(shown(picture, study_captions::of_specimen(key, specimen)));
        }
        of_specimens.push(own);
        strips.push(strip(specimen)?);
    }
    let mut of_stability = BTreeMap::new();
    for (key, figure) in stability_figures(stability) {
        let picture = svg(&figure);
        of_stability.insert(key, shown(picture.clone(), study_captions::of_stability(key).into()));
        pictures.push((format!("stability.{key}.svg"), picture.into_bytes()));
    }
    let failed = |what: &str, error: &dyn std::fmt::Display| Error::Call(format!("writing {what} failed: {error}"));
    let json = serde_json::to_vec_pretty(study).map_err(|e| failed("study.json", &e))?;
    let data = serde_json::to_value(study).map_err(|e| failed("study.json", &e))?;
    let strips = serde_json::to_value(&strips).map_err(|e| failed(PAGE, &e))?;
    let stability_json = serde_json::to_vec_pretty(stability).map_err(|e| failed("stability.json", &e))?;
    let stability_data = serde_json::to_value(stability).map_err(|e| failed("stability.json", &e))?;
    let cases = case_rows(stability);
    let cases = serde_json::to_value(&cases).map_err(|e| failed(PAGE, &e))?;
    let parts = Parts {
        study: &data,
        pictures: of_specimens,
        strips: &strips,
        stability: &stability_data,
        cases: &cases,
        of_stability,
    };
    let html = page(parts).map_err(|e| failed(PAGE, &e))?;
    let mut files = vec![(PAGE.to_owned(), html.into_bytes()), ("study.json".to_owned(), json)];
    files.push(("stability.json".to_owned(), stability_json));
    files.extend(pictures);
    Ok(files)
}

/// A plot as the page shows it.
fn shown(svg: String, caption: String) -> Value {
    context! { svg => Value::from_safe_string(svg), caption }
}

/// The figures of one specimen by key.
fn figures(specimen: &SpecimenStudy) -> Vec<(&'static str, Figure)> {
    let mut figures = vec![
        ("cost", cost_figure(specimen)),
        ("cost-on-texels", cost_figure_on_texels(specimen)),
        ("tables", tables_figure(specimen)),
    ];
    figures.extend(tolerance_figure(specimen).map(|figure| ("tolerance", figure)));
    let (narrow, wide) = DIAMETERS_DEG.split_at(2);
    for (key, diameters_deg) in [("lights", narrow), ("wide-lights", wide)] {
        figures.extend(lights_figure(specimen, diameters_deg).map(|figure| (key, figure)));
    }
    figures
        .extend(KNOB_PLOTS.iter().filter_map(|(key, knobs, axis)| Some((*key, knob_figure(specimen, knobs, axis)?))));
    figures
}

/// One small picture: what it shows, and its address.
#[derive(serde::Serialize)]
struct Shown {
    caption: String,
    scene: String,
    href: String,
}

/// Pictures of the scenes by the methods worth a look.
fn strip(specimen: &SpecimenStudy) -> Result<Vec<Shown>> {
    let mut shown = Vec::new();
    for method in SHOWN {
        let Some(row) = specimen.methods.iter().rfind(|row| row.method == method) else { continue };
        for picture in &row.pictures {
            let colour = row.colours.iter().find(|colour| colour.scene == picture.scene);
            let caption = match colour {
                Some(colour) if method != "FFT" => {
                    format!("{method}, {}: ΔE {}", row.setting, number(Some(colour.p95)))
                }
                _ => "reference".into(),
            };
            let href = data_uri(&encode_png(&picture.rgb)?);
            shown.push(Shown { caption, scene: picture.scene.clone(), href });
        }
    }
    Ok(shown)
}

/// Writes all files into a folder, which is made if need be.
///
/// # Errors
/// Those of [`study_files`], and `Error::Disk`.
pub(crate) fn write_study(folder: &Path, study: &Study, stability: &Stability) -> Result<()> {
    let files = study_files(study, stability)?;
    create_folder(folder)?;
    files.iter().try_for_each(|(name, bytes)| replace(&folder.join(name), bytes))
}

/// One line of the table of stability cases.
#[derive(serde::Serialize)]
struct CaseRow<'a> {
    name: &'a str,
    note: &'a str,
    measured: f64,
    bound: f64,
    guard: &'a str,
    without: String,
    half: Option<f64>,
    verdict: Verdict,
}

fn case_rows(stability: &Stability) -> Vec<CaseRow<'_>> {
    fn row(case: &StabilityCase) -> CaseRow<'_> {
        let StabilityCase { name, note, measured, bound, guard, half } = case;
        CaseRow {
            name,
            note,
            measured: *measured,
            bound: *bound,
            guard: &guard.what,
            // JSON has no infinity.
            without: number(Some(guard.without)),
            half: *half,
            verdict: case.verdict(),
        }
    }
    stability.cases.iter().map(row).collect()
}

/// What the page is made of.
struct Parts<'a> {
    study: &'a serde_json::Value,
    pictures: Vec<Vec<Value>>,
    strips: &'a serde_json::Value,
    stability: &'a serde_json::Value,
    cases: &'a serde_json::Value,
    of_stability: BTreeMap<&'static str, Value>,
}

fn page(parts: Parts) -> std::result::Result<String, minijinja::Error> {
    let mut environment = Environment::new();
    environment.add_filter("number", number);
    environment.add_filter("bytes", |value: Option<u64>| value.map_or("–".to_owned(), bytes));
    environment.add_filter("kept", kept);
    environment.add_filter("measure", measure);
    environment.add_template("study.html", include_str!("templates/study.html"))?;
    environment.get_template("study.html")?.render(context! {
        study => template_value(parts.study),
        style => Value::from_safe_string(STYLE.to_owned()),
        pictures => parts.pictures,
        strips => template_value(parts.strips),
        stability => template_value(parts.stability),
        cases => template_value(parts.cases),
        of_stability => Value::from_pairs(parts.of_stability),
        purposes => PURPOSES.map(|(method, purpose)| vec![method, purpose]).to_vec(),
    })
}

/// JSON as the template engine sees it.
fn template_value(value: &serde_json::Value) -> Value {
    use serde_json::Value as Json;
    match value {
        Json::Null => Value::from(()),
        Json::Bool(b) => Value::from(*b),
        Json::Number(n) => n.as_u64().map_or_else(|| Value::from(n.as_f64()), Value::from),
        Json::String(s) => Value::from(s.as_str()),
        Json::Array(items) => items.iter().map(template_value).collect(),
        Json::Object(map) => Value::from_pairs(map.iter().map(|(key, item)| (key.as_str(), template_value(item)))),
    }
}

/// Three significant digits, powers of ten where they are shorter.
fn number(value: Option<f64>) -> String {
    match value {
        None => "–".into(),
        Some(0.0) => "0".into(),
        Some(v) if v.is_infinite() => "∞".into(),
        Some(v) if v.is_nan() => "no number".into(),
        Some(v) if (0.01..10_000.0).contains(&v.abs()) => {
            let decimals = (2 - v.abs().log10().floor() as i32).max(0) as usize;
            format!("{v:.decimals$}")
        }
        Some(v) => format!("{v:.1e}"),
    }
}

/// Which error is made equal.
fn measure(key: &str) -> &'static str {
    match key {
        "p95" => "95 %, hemisphere",
        "steep" => "95 %, within 30°",
        _ => "worst, hemisphere",
    }
}

/// What a tolerance's verdict says.
fn kept(verdict: &str) -> &'static str {
    match verdict {
        "everywhere" => "kept in every direction",
        "on-texels" => "kept on texels; the grid adds more",
        "texel-means" => "kept for means over a texel",
        _ => "missed",
    }
}

fn bytes(value: u64) -> String {
    let v = value as f64;
    match value {
        0..10_000 => format!("{value} B"),
        10_000..10_000_000 => format!("{:.0} kB", v / 1e3),
        _ => format!("{:.0} MB", v / 1e6),
    }
}

/// A specimen's name with everything but letters, digits, `-` and `_` replaced.
fn file_name(name: &str) -> String {
    name.chars().map(|c| if c.is_alphanumeric() || c == '-' || c == '_' { c } else { '_' }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let cases = [
            (0.0, "0"),
            (0.012345, "0.0123"),
            (12.345, "12.3"),
            (1_137.4, "1137"),
            (1.0e-5, "1.0e-5"),
            (f64::NAN, "no number"),
        ];
        for (value, text) in cases {
            assert_eq!(number(Some(value)), text);
        }
        assert_eq!(number(None), "–");
        assert_eq!([bytes(999), bytes(1_230_000), bytes(45_600_000)], ["999 B", "1230 kB", "46 MB"]);
        assert_eq!(file_name("a/b c.d"), "a_b_c_d");
    }
}
