//! Plots of a study as SVG: error against cost, against the number of tables, and against each knob.

use crate::report::axes::{Axis, Tick, level_lines, polyline, title_below, upright_lines};
use crate::report::numbers;
use crate::report::svg::{at, escape};
use diffraction_build::ground::sampling::Region;
use diffraction_study::stability::{DepthRow, GrazingRow, SeriesRow, Stability};
use diffraction_study::study::{MethodRow, SpecimenStudy};

/// Size of one panel in SVG units, of the column that names the lines, and of the line with the title.
const PANEL: [f64; 2] = [470.0, 370.0];
const LEGEND: f64 = 250.0;
const TITLE: f64 = 30.0;

/// Room in a panel for what stands left, above and below its axes, and right of them.
const LEFT: f64 = 74.0;
const TOP: f64 = 8.0;
const BELOW: f64 = 48.0;
const RIGHT: f64 = 18.0;

/// Factor kept free around the data on logarithmic axes.
const MARGIN: f64 = 1.2;

/// A figure is a file of its own too, so it brings its style along.
const STYLE: &str = ".figure{background:#fff;color:#1b1b1b}.figure .paper{fill:#fff}.figure text{font:12px sans-serif;fill:#1b1b1b}\
                     .figure .head{font-size:17px}.figure .grid{fill:none;stroke:#d7d7d7}\
                     .figure .fine{fill:none;stroke:#f2f2f2}.figure .box{fill:none;stroke:#666}";

/// Colours that stay apart for colour-blind readers (Okabe and Ito 2008).
const COLOURS: [&str; 8] =
    ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "currentColor", "#8c8c8c"];

/// A line of points with a name.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Series {
    /// Name in the legend.
    pub name: String,
    /// Points in the order they are joined.
    pub points: Vec<(f64, f64)>,
}

/// One pair of axes, both logarithmic.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Panel {
    /// What the horizontal axis holds, with its unit.
    pub x_label: String,
    /// What the vertical axis holds, with its unit.
    pub y_label: String,
    /// The lines; panels of one figure name equal things equally.
    pub series: Vec<Series>,
}

/// Panels side by side under one title, with one legend.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Figure {
    /// The title.
    pub title: String,
    /// The panels.
    pub panels: Vec<Panel>,
}

/// Error over the hemisphere against build time, evaluation time and bytes.
pub(crate) fn cost_figure(study: &SpecimenStudy) -> Figure {
    let error = |row: &MethodRow| {
        let found = row.errors.iter().find(|e| e.region == Region::Hemisphere);
        found.map_or(f64::NAN, |e| e.quantiles.p95)
    };
    costs(study, "error against cost, whole hemisphere, cubic look-ups", &error)
}

/// The same where (u, v) lies on texels: what is left without the grid.
pub(crate) fn cost_figure_on_texels(study: &SpecimenStudy) -> Figure {
    costs(study, "error against cost without the grid's share", &|row| row.on_texels.p95)
}

fn costs(study: &SpecimenStudy, title: &str, error: &dyn Fn(&MethodRow) -> f64) -> Figure {
    let panel = |x_label: &str, cost: &dyn Fn(&MethodRow) -> f64| {
        let mut series = by_method(study, &|row| (cost(row), error(row)));
        // Times have noise: joined in the order of settings, a line would fold back on itself.
        series.iter_mut().for_each(|line| line.points.sort_by(|a, b| a.0.total_cmp(&b.0)));
        Panel { x_label: x_label.into(), y_label: "95th percentile of |ΔY| / Y".into(), series }
    };
    Figure {
        title: format!("{}: {title}", study.name),
        panels: vec![
            panel("build time (s)", &|row| row.build_s),
            panel("evaluation, one thread (s / direction)", &|row| row.evaluate_s),
            panel("size (bytes)", &|row| row.stored_bytes as f64),
        ],
    }
}

/// Error of the tables against their number, and colour difference against bytes.
pub(crate) fn tables_figure(study: &SpecimenStudy) -> Figure {
    let mut tables = by_method(study, &|row| {
        let count: f64 = row.setting.split(' ').next().and_then(|n| n.parse().ok()).unwrap_or(0.0);
        (if row.basis.is_some() { count } else { 0.0 }, row.on_texels.p95)
    });
    tables.iter_mut().for_each(|series| series.points.retain(drawable));
    let colour = by_method(study, &|row| {
        let worst = row.colours.iter().map(|colour| colour.p95).fold(f64::NAN, f64::max);
        (row.stored_bytes as f64, worst)
    });
    Figure {
        title: format!("{}: number of tables, and colours of the scenes", study.name),
        panels: vec![
            panel("number of tables", &format!("{ERROR} on texels"), tables),
            panel("size (bytes)", "CIEDE2000, 95th percentile, worst scene", colour),
        ],
    }
}

/// One line per method, in the order of their first rows.
fn by_method(study: &SpecimenStudy, point: &dyn Fn(&MethodRow) -> (f64, f64)) -> Vec<Series> {
    let mut series: Vec<Series> = Vec::new();
    for row in &study.methods {
        match series.iter_mut().find(|s| s.name == row.method) {
            Some(series) => series.points.push(point(row)),
            None => series.push(Series { name: row.method.clone(), points: vec![point(row)] }),
        }
    }
    series
}

/// Median and 95th percentile against the setting of one knob; `None` where fewer than two settings were tried.
pub(crate) fn knob_figure(study: &SpecimenStudy, knobs: &[&str], axis: &str) -> Option<Figure> {
    let mut series = Vec::new();
    for &knob in knobs {
        let rows: Vec<_> = study.knobs.iter().filter(|row| row.knob == knob).collect();
        if rows.len() >= 2 {
            series.push(Series {
                name: format!("{knob}, median"),
                points: rows.iter().map(|row| (row.value, row.quantiles.p50)).collect(),
            });
            series.push(Series {
                name: format!("{knob}, 95 %"),
                points: rows.iter().map(|row| (row.value, row.quantiles.p95)).collect(),
            });
        }
    }
    let name = knobs[0].split(',').next().unwrap_or(knobs[0]);
    (!series.is_empty()).then(|| Figure {
        title: format!("{}: share of the {name}", study.name),
        panels: vec![Panel { x_label: axis.into(), y_label: "|ΔY| / Y".into(), series }],
    })
}

/// Measured against asked for, and what it costs.
pub(crate) fn tolerance_figure(study: &SpecimenStudy) -> Option<Figure> {
    let rows = &study.tolerances;
    if rows.is_empty() {
        return None;
    }
    let line = |name: &str, y: &dyn Fn(usize) -> f64| Series {
        name: name.into(),
        points: rows.iter().enumerate().map(|(i, row)| (row.tolerance, y(i))).collect(),
    };
    let panel =
        |y_label: &str, series| Panel { x_label: "tolerance asked for".into(), y_label: y_label.into(), series };
    let errors = vec![
        line("on texels", &|i| rows[i].on_texels.p95),
        line("cubic look-up", &|i| rows[i].cubic.p95),
        line("linear look-up", &|i| rows[i].bilinear.p95),
        line("asked for", &|i| rows[i].tolerance),
    ];
    Some(Figure {
        title: format!("{}: tolerance kept, and its cost", study.name),
        panels: vec![
            panel("95th percentile of |ΔY| / Y", errors),
            panel("build time (s)", vec![line("automatic settings", &|i| rows[i].build_s)]),
            panel("size (bytes)", vec![line("automatic settings", &|i| rows[i].stored_bytes as f64)]),
        ],
    })
}

/// Error of pictures against look-ups of a light, under lights of these diameters; `None` where none were measured.
pub(crate) fn lights_figure(study: &SpecimenStudy, diameters_deg: &[f64]) -> Option<Figure> {
    let panel = |diameter_deg: f64| {
        let mut series: Vec<Series> = Vec::new();
        for row in study.lights.rows.iter().filter(|row| row.diameter_deg == diameter_deg) {
            let name = format!("{}, {}", row.shape, if row.is_filtered { "filtered" } else { "points" });
            let point = (row.look_ups as f64, row.errors[1]);
            match series.iter_mut().find(|line| line.name == name) {
                Some(line) => line.points.push(point),
                None => series.push(Series { name, points: vec![point] }),
            }
        }
        Panel {
            x_label: format!("look-ups of a light {diameter_deg}° wide, per pixel"),
            y_label: "95th percentile of |ΔY| / Y".into(),
            series,
        }
    };
    (!study.lights.rows.is_empty()).then(|| Figure {
        title: format!("{}: lights with a size", study.name),
        panels: diameters_deg.iter().copied().map(panel).collect(),
    })
}

/// Relief, the published series in each number format, and grazing directions.
pub(crate) fn stability_figures(stability: &Stability) -> Vec<(&'static str, Figure)> {
    vec![
        ("depth", depth_figure(&stability.depths)),
        ("series", series_figure(&stability.series)),
        ("grazing", grazing_figure(&stability.grazing)),
    ]
}

const ERROR: &str = "95th percentile of |ΔY| / Y";
const PEAK_TO_VALLEY: &str = "peak to valley (nm)";

fn panel(x_label: &str, y_label: &str, series: Vec<Series>) -> Panel {
    Panel { x_label: x_label.into(), y_label: y_label.into(), series }
}

fn line<R>(name: &str, rows: &[R], point: impl Fn(&R) -> (f64, f64)) -> Series {
    Series { name: name.into(), points: rows.iter().map(point).collect() }
}

/// What is beyond 1e3 is beyond any use: it would only flatten the rest.
fn cap(y: f64) -> f64 {
    if y.is_nan() { 1e3 } else { y.min(1e3) }
}

fn depth_figure(rows: &[DepthRow]) -> Figure {
    let of = |name: &str, y: &dyn Fn(&DepthRow) -> f64| line(name, rows, |row| (row.depth_nm, y(row)));
    let counts = vec![of("tables", &|r| r.tables as f64), of("transforms", &|r| r.transforms as f64)];
    let errors = vec![
        of("as many tables as the depth asks for", &|r| r.error),
        of("four tables", &|r| r.four_tables),
        of("tolerance", &|_| 1e-2),
    ];
    Figure {
        title: "Depth, one laser line at 400 nm".into(),
        panels: vec![panel(PEAK_TO_VALLEY, "number", counts), panel(PEAK_TO_VALLEY, ERROR, errors)],
    }
}

fn series_figure(rows: &[SeriesRow]) -> Figure {
    let formats = || ["half", "float", "double"].into_iter().enumerate();
    let found = formats().map(|(i, name)| line(name, rows, |row| (row.depth_nm, cap(row.errors[i]))));
    let forecast = formats()
        .map(|(i, name)| line(&format!("{name}, forecast"), rows, |row| (row.depth_nm, cap(row.predicted[i]))));
    let terms = line("terms", rows, |row| (row.depth_nm, row.terms as f64));
    Figure {
        title: "The published power series: where each number format fails (400 nm, errors above 1e3 drawn there)"
            .into(),
        panels: vec![
            panel(PEAK_TO_VALLEY, ERROR, found.chain(forecast).collect()),
            panel(PEAK_TO_VALLEY, "terms", vec![terms]),
        ],
    }
}

fn grazing_figure(rows: &[GrazingRow]) -> Figure {
    let of = |name: &str, y: &dyn Fn(&GrazingRow) -> f64| line(name, rows, |row| (row.normalised_w, y(row)));
    let lines = vec![of("divided by w², as stored", &|r| r.divided), of("undivided", &|r| cap(r.whole))];
    Figure {
        title: "Towards grazing: no pole shows".into(),
        panels: vec![panel("|w| / sqrt(4 - u² - v²)", ERROR, lines)],
    }
}

fn drawable(&(x, y): &(f64, f64)) -> bool {
    x > 0.0 && y > 0.0 && x.is_finite() && y.is_finite()
}

/// Draws a figure as SVG. Points that are not positive numbers cannot stand on logarithmic axes and are left to the
/// tables.
pub fn svg(figure: &Figure) -> String {
    let mut names: Vec<&str> = Vec::new();
    for series in figure.panels.iter().flat_map(|panel| &panel.series) {
        if series.points.iter().any(drawable) && !names.contains(&series.name.as_str()) {
            names.push(&series.name);
        }
    }
    let panels = PANEL[0] * figure.panels.len() as f64;
    let (width, height) = (at(panels + LEGEND), at(TITLE + PANEL[1]));
    let title = escape(&figure.title);
    let mut body = format!(r#"<text class="head" x="{}" y="21" text-anchor="middle">{title}</text>"#, at(0.5 * panels));
    for (index, panel) in figure.panels.iter().enumerate() {
        let x = at(PANEL[0] * index as f64);
        body += &format!(r#"<g transform="translate({x} {TITLE})">{}</g>"#, draw_panel(panel, &names));
    }
    for (index, name) in names.iter().enumerate() {
        let y = TITLE + TOP + 8.0 + 22.0 * index as f64;
        body += &mark([panels + 14.0, y], style(name, &names));
        body += &format!(r#"<text x="{}" y="{}">{}</text>"#, at(panels + 28.0), at(y + 4.0), escape(name));
    }
    format!(
        r##"<svg xmlns="http://www.w3.org/2000/svg" class="figure" width="{width}" height="{height}" viewBox="0 0 {width} {height}" role="img" aria-label="{title}"><style>{STYLE}</style><rect class="paper" width="{width}" height="{height}"/>{body}</svg>"##
    )
}

fn draw_panel(panel: &Panel, names: &[&str]) -> String {
    let (across, upright) = ([LEFT, PANEL[0] - RIGHT], [TOP, PANEL[1] - BELOW]);
    let points = || panel.series.iter().flat_map(|s| s.points.iter().copied()).filter(drawable);
    let axis = |of: fn((f64, f64)) -> f64, ends| {
        let (low, high) = points().map(of).fold((f64::MAX, 0.0f64), |(low, high), v| (low.min(v), high.max(v)));
        let range = if low <= high { [low / MARGIN, high * MARGIN] } else { [0.1, 10.0] };
        Axis::logarithmic(range, usize::MAX, ends)
    };
    let x = axis(|point| point.0, across);
    let y = axis(|point| point.1, [upright[1], upright[0]]);
    let (decades_x, decades_y) = (x.decades(7, decade), y.decades(14, decade));
    let mut body = upright_lines(&x, &between(&decades_x), upright, "fine");
    body += &level_lines(&y, &between(&decades_y), across, "fine");
    body += &upright_lines(&x, &decades_x, upright, "grid");
    body += &level_lines(&y, &decades_y, across, "grid");
    body += &format!(r#"<path class="box" d="M{} {}V{}H{}"/>"#, at(LEFT), at(TOP), at(upright[1]), at(across[1]));
    body += &title_below(&panel.x_label, across, upright[1]);
    body += &title_beside(&panel.y_label, 16.0, upright);
    for series in &panel.series {
        let index = style(&series.name, names);
        let points = || series.points.iter().copied().filter(drawable);
        let stroke = format!("stroke:{};stroke-width:2;stroke-linejoin:round", COLOURS[index % COLOURS.len()]);
        body += &polyline(points(), &x, &y, &stroke);
        body += &points().map(|(a, b)| mark([x.at(a), y.at(b)], index)).collect::<String>();
    }
    body
}

/// The lines between decades: 2 to 9 times each.
fn between(decades: &[Tick]) -> Vec<Tick> {
    let below = &decades[..decades.len() - 1];
    below.iter().flat_map(|(value, _)| (2..10).map(move |digit| (f64::from(digit) * value, String::new()))).collect()
}

/// What a decade is called: plain where that is short, else a power of ten.
fn decade(power: i32) -> String {
    match power {
        -2..0 => format!("{:.*}", power.unsigned_abs() as usize, 10f64.powi(power)),
        0..4 => format!("{}", 10f64.powi(power)),
        _ => format!("10{}", numbers::superscript(power)),
    }
}

/// What an axis holds, upright at `x`.
fn title_beside(text: &str, x: f64, [top, bottom]: [f64; 2]) -> String {
    let (x, y) = (at(x), at(0.5 * (top + bottom)));
    format!(r#"<text transform="translate({x} {y}) rotate(-90)" text-anchor="middle">{}</text>"#, escape(text))
}

/// Methods keep their colour from figure to figure; other lines take them in turn.
fn style(name: &str, names: &[&str]) -> usize {
    const METHODS: [&str; 11] = [
        "chebyshev, half",
        "taylor, float",
        "chebyshev, float",
        "taylor, half",
        "Stam, random",
        "Stam, regular",
        "spherical harmonics",
        "FFT",
        "optical paths",
        "WBSDF",
        "light field",
    ];
    let known = METHODS.iter().position(|method| *method == name);
    known.or_else(|| names.iter().position(|other| *other == name)).unwrap_or(0)
}

/// The mark of a line: colour and shape tell lines apart.
fn mark([x, y]: [f64; 2], index: usize) -> String {
    const SHAPES: [&str; 4] =
        ["m4 0l-1 3l-3 1l-3 -1l-1 -3l1 -3l3 -1l3 1z", "m-4 -4h8v8h-8z", "m0 -5l5 9h-10z", "m0 -6l5 6l-5 6l-5 -6z"];
    let shape = SHAPES[(index + index / COLOURS.len()) % SHAPES.len()];
    format!(r#"<path fill="{}" d="M{} {}{shape}"/>"#, COLOURS[index % COLOURS.len()], at(x), at(y))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decades_have_short_names() {
        let names: Vec<String> = [-3, -2, -1, 0, 3, 4].into_iter().map(decade).collect();
        assert_eq!(names, ["10⁻³", "0.01", "0.1", "1", "1000", "10⁴"]);
    }

    #[test]
    fn what_logarithms_have_no_place_for_is_left_out() {
        let series = |points| Series { name: "<a>".into(), points };
        let panel = |points| Panel { x_label: "x".into(), y_label: "y & z".into(), series: vec![series(points)] };
        let good = panel(vec![(1.0, 2.0), (10.0, 0.5), (100.0, 3.0)]);
        let none = panel(vec![(0.0, 1.0), (f64::NAN, 1.0), (1.0, f64::INFINITY), (-1.0, 1.0)]);
        let svg = svg(&Figure { title: "t".into(), panels: vec![good, none] });
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        let document = roxmltree::Document::parse(&svg).unwrap();
        let count = |paint: &str| {
            document
                .descendants()
                .filter(|node| node.attribute("fill") == Some(paint) && node.has_tag_name("path"))
                .count()
        };
        assert_eq!(count(COLOURS[0]), 3 + 1, "three marks and the legend's");
    }
}
