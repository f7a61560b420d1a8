//! Plots of a study as SVG: error against cost, against the number of tables, and against each knob.

use plotters::coord::Shift;
use plotters::prelude::*;

use diffraction_brdf::error::{Error, Result};
use diffraction_build::ground::sampling::Region;
use diffraction_study::stability::{DepthRow, GrazingRow, SeriesRow, Stability};
use diffraction_study::study::{MethodRow, SpecimenStudy};

/// Pixels of one panel, and of the column that names the lines.
const PANEL_PX: (u32, u32) = (470, 400);
const LEGEND_PX: u32 = 250;

/// Factor kept free around the data on logarithmic axes.
const MARGIN: f64 = 1.2;

/// Colours that stay apart for colour-blind readers (Okabe and Ito 2008).
const COLOURS: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 0, 0),
    RGBColor(140, 140, 140),
];

/// A line of points with a name.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Name in the legend.
    pub name: String,
    /// Points in the order they are joined.
    pub points: Vec<(f64, f64)>,
}

/// One pair of axes, both logarithmic.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// What the horizontal axis holds, with its unit.
    pub x_label: String,
    /// What the vertical axis holds, with its unit.
    pub y_label: String,
    /// The lines; panels of one figure name equal things equally.
    pub series: Vec<Series>,
}

/// Panels side by side under one title, with one legend.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// The title.
    pub title: String,
    /// The panels.
    pub panels: Vec<Panel>,
}

/// Error over the hemisphere against build time, evaluation time and bytes.
pub fn cost_figure(study: &SpecimenStudy) -> Figure {
    let error = |row: &MethodRow| {
        let found = row.errors.iter().find(|e| e.region == Region::Hemisphere);
        found.map_or(f64::NAN, |e| e.quantiles.p95)
    };
    costs(study, "error against cost, whole hemisphere, cubic look-ups", &error)
}

/// The same where (u, v) lies on texels: what is left without the grid.
pub fn cost_figure_on_texels(study: &SpecimenStudy) -> Figure {
    costs(study, "error against cost without the grid's share", &|row| row.on_texels.p95)
}

fn costs(study: &SpecimenStudy, title: &str, error: &dyn Fn(&MethodRow) -> f64) -> Figure {
    let panel = |x_label: &str, cost: &dyn Fn(&MethodRow) -> f64| Panel {
        x_label: x_label.into(),
        y_label: "95th percentile of |ΔY| / Y".into(),
        series: by_method(study, &|row| (cost(row), error(row))),
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
pub fn tables_figure(study: &SpecimenStudy) -> Figure {
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
pub fn knob_figure(study: &SpecimenStudy, knobs: &[&str], axis: &str) -> Option<Figure> {
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
pub fn tolerance_figure(study: &SpecimenStudy) -> Option<Figure> {
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

/// Relief, the published series in each number format, and grazing directions.
pub fn stability_figures(stability: &Stability) -> Vec<(&'static str, Figure)> {
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
///
/// # Errors
/// `Error::Call` if the drawing library fails.
pub fn svg(figure: &Figure) -> Result<String> {
    let mut names: Vec<&str> = Vec::new();
    for series in figure.panels.iter().flat_map(|panel| &panel.series) {
        if series.points.iter().any(drawable) && !names.contains(&series.name.as_str()) {
            names.push(&series.name);
        }
    }
    let size = (PANEL_PX.0 * figure.panels.len() as u32 + LEGEND_PX, PANEL_PX.1);
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        draw(&area, figure, &names).map_err(|error| Error::Call(format!("drawing a plot failed: {error}")))?;
    }
    Ok(svg)
}

type Drawn<'a> = std::result::Result<(), DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>>;

fn draw<'a>(area: &DrawingArea<SVGBackend<'a>, Shift>, figure: &Figure, names: &[&str]) -> Drawn<'a> {
    area.fill(&WHITE)?;
    let body = area.titled(&figure.title, ("sans-serif", 17))?;
    let (charts, legend) = body.split_horizontally(PANEL_PX.0 * figure.panels.len() as u32);
    let parts = charts.split_evenly((1, figure.panels.len()));
    for (panel, part) in figure.panels.iter().zip(&parts) {
        draw_panel(part, panel, names)?;
    }
    for (index, name) in names.iter().enumerate() {
        let y = 30 + 22 * index as i32;
        legend.draw(&mark((14, y), style(name, names)))?;
        legend.draw(&Text::new((*name).to_owned(), (28, y - 7), ("sans-serif", 13)))?;
    }
    area.present()
}

fn draw_panel<'a>(area: &DrawingArea<SVGBackend<'a>, Shift>, panel: &Panel, names: &[&str]) -> Drawn<'a> {
    let points = || panel.series.iter().flat_map(|s| s.points.iter().copied()).filter(drawable);
    // Whole decades: every axis then has at least two labels.
    let range = |of: fn((f64, f64)) -> f64| {
        let (low, high) = points().map(of).fold((f64::MAX, 0.0f64), |(low, high), v| (low.min(v), high.max(v)));
        let decade = |value: f64, round: fn(f64) -> f64| 10f64.powf(round(value.log10()));
        if low <= high { decade(low / MARGIN, f64::floor)..decade(high * MARGIN, f64::ceil) } else { 0.1..10.0 }
    };
    let mut chart = ChartBuilder::on(area)
        .margin(8)
        .margin_right(18)
        .x_label_area_size(42)
        .y_label_area_size(70)
        .build_cartesian_2d(range(|p| p.0).log_scale(), range(|p| p.1).log_scale())?;
    chart
        .configure_mesh()
        .x_desc(panel.x_label.as_str())
        .y_desc(panel.y_label.as_str())
        .x_labels(6)
        .x_label_formatter(&|value| tick(*value))
        .y_label_formatter(&|value| tick(*value))
        .light_line_style(RGBColor(240, 240, 240))
        .bold_line_style(RGBColor(215, 215, 215))
        .label_style(("sans-serif", 12))
        .axis_desc_style(("sans-serif", 13))
        .draw()?;
    for line in &panel.series {
        let index = style(&line.name, names);
        let points: Vec<(f64, f64)> = line.points.iter().copied().filter(drawable).collect();
        chart.draw_series(LineSeries::new(points.iter().copied(), COLOURS[index % COLOURS.len()].stroke_width(2)))?;
        chart.draw_series(points.iter().map(|&point| EmptyElement::at(point) + mark((0, 0), index)))?;
    }
    Ok(())
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
fn mark(at: (i32, i32), index: usize) -> Polygon<(i32, i32)> {
    const CORNERS: [&[(i32, i32)]; 4] = [
        &[(4, 0), (3, 3), (0, 4), (-3, 3), (-4, 0), (-3, -3), (0, -4), (3, -3)],
        &[(-4, -4), (4, -4), (4, 4), (-4, 4)],
        &[(0, -5), (5, 4), (-5, 4)],
        &[(0, -6), (5, 0), (0, 6), (-5, 0)],
    ];
    let corners = CORNERS[(index + index / COLOURS.len()) % CORNERS.len()].iter();
    let points: Vec<(i32, i32)> = corners.map(|(x, y)| (at.0 + x, at.1 + y)).collect();
    Polygon::new(points, COLOURS[index % COLOURS.len()].filled())
}

fn tick(value: f64) -> String {
    if (1e-2..1e4).contains(&value) {
        return format!("{}", (value * 1e6).round() / 1e6);
    }
    format!("{value:.0e}")
}
