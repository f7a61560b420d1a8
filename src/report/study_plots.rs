//! Plots of a study as SVG: error against cost, and the share of each knob.

use plotters::coord::Shift;
use plotters::prelude::*;

use crate::ground::error::{Error, Result};
use crate::ground::sampling::Region;
use crate::stages::study::{MethodRow, SpecimenStudy};

/// Pixels of one plot.
const SIZE_PX: (u32, u32) = (760, 460);

/// Decades kept free around the data.
const MARGIN: f64 = 1.6;

/// Colours that stay apart for colour-blind readers (Okabe and Ito 2008).
const COLOURS: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(86, 180, 233),
    RGBColor(213, 94, 0),
    RGBColor(230, 159, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(0, 0, 0),
    RGBColor(140, 140, 140),
];

/// A line of points with a name.
struct Series {
    name: String,
    points: Vec<(f64, f64)>,
}

/// What the horizontal axis of a cost plot holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cost {
    /// Seconds to build.
    Build,
    /// Seconds per direction.
    Evaluate,
    /// Bytes to hold.
    Bytes,
}

impl Cost {
    /// All costs.
    pub const ALL: [Self; 3] = [Self::Build, Self::Evaluate, Self::Bytes];

    /// Name for files.
    pub fn key(self) -> &'static str {
        match self {
            Self::Build => "build",
            Self::Evaluate => "evaluate",
            Self::Bytes => "bytes",
        }
    }

    fn label(self) -> &'static str {
        match self {
            Self::Build => "build time (s)",
            Self::Evaluate => "evaluation time per direction (s)",
            Self::Bytes => "stored size (bytes)",
        }
    }

    fn of(self, row: &MethodRow) -> f64 {
        match self {
            Self::Build => row.build_s,
            Self::Evaluate => row.evaluate_s,
            Self::Bytes => row.stored_bytes as f64,
        }
    }
}

/// Median error over the hemisphere against a cost, one line per method; both axes logarithmic. Methods of
/// zero cost or error cannot be drawn and are left to the table.
///
/// # Errors
/// `Error::Call` if the drawing library fails.
pub fn cost_plot(study: &SpecimenStudy, cost: Cost) -> Result<String> {
    let mut series: Vec<Series> = Vec::new();
    for row in &study.methods {
        let errors = row.errors.iter().find(|e| e.region == Region::Hemisphere);
        let Some(error) = errors.map(|e| e.quantiles.p50) else { continue };
        let point = (cost.of(row), error);
        match series.iter_mut().find(|s| s.name == row.method) {
            Some(series) => series.points.push(point),
            None => series.push(Series { name: row.method.clone(), points: vec![point] }),
        }
    }
    let title = format!("{}: error against {}", study.name, cost.label());
    log_log(&title, cost.label(), "median relative error of Y", &series)
}

/// Median and 95th percentile against the setting of one knob; `None` where fewer than two settings have a
/// number.
///
/// # Errors
/// As [`cost_plot`].
pub fn knob_plot(study: &SpecimenStudy, knobs: &[&str], axis: &str) -> Result<Option<String>> {
    let mut series = Vec::new();
    for &knob in knobs {
        let rows: Vec<_> = study.knobs.iter().filter(|row| row.knob == knob && row.value > 0.0).collect();
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
    if series.is_empty() {
        return Ok(None);
    }
    let title = format!("{}: share of the {}", study.name, knobs[0].split(',').next().unwrap_or(knobs[0]));
    log_log(&title, axis, "relative error of Y", &series).map(Some)
}

fn log_log(title: &str, x_label: &str, y_label: &str, series: &[Series]) -> Result<String> {
    let drawable = |&(x, y): &(f64, f64)| x > 0.0 && y > 0.0 && x.is_finite() && y.is_finite();
    let points = || series.iter().flat_map(|s| s.points.iter().copied()).filter(drawable);
    let range = |of: fn((f64, f64)) -> f64| {
        let (low, high) = points().map(of).fold((f64::MAX, 0.0f64), |(low, high), v| (low.min(v), high.max(v)));
        if low <= high { low / MARGIN..high * MARGIN } else { 0.1..10.0 }
    };
    let (x, y) = (range(|p| p.0), range(|p| p.1));
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, SIZE_PX).into_drawing_area();
        draw(&area, [title, x_label, y_label], x, y, series, &drawable)
            .map_err(|error| Error::Call(format!("drawing a plot failed: {error}")))?;
    }
    Ok(svg)
}

fn draw<'a>(
    area: &DrawingArea<SVGBackend<'a>, Shift>,
    [title, x_label, y_label]: [&str; 3],
    x: std::ops::Range<f64>,
    y: std::ops::Range<f64>,
    series: &[Series],
    drawable: &dyn Fn(&(f64, f64)) -> bool,
) -> std::result::Result<(), DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>> {
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(area)
        .caption(title, ("sans-serif", 17))
        .margin(12)
        .margin_right(20)
        .x_label_area_size(44)
        .y_label_area_size(66)
        .build_cartesian_2d(x.log_scale(), y.log_scale())?;
    let plain = |value: &f64| if (1e-2..1e4).contains(value) { format!("{value}") } else { format!("{value:.0e}") };
    chart
        .configure_mesh()
        .x_desc(x_label)
        .y_desc(y_label)
        .x_label_formatter(&plain)
        .y_label_formatter(&plain)
        .light_line_style(RGBColor(240, 240, 240))
        .bold_line_style(RGBColor(215, 215, 215))
        .label_style(("sans-serif", 13))
        .draw()?;
    for (index, line) in series.iter().enumerate() {
        let colour = COLOURS[index % COLOURS.len()];
        let points: Vec<(f64, f64)> = line.points.iter().copied().filter(drawable).collect();
        if points.is_empty() {
            continue;
        }
        chart
            .draw_series(LineSeries::new(points.iter().copied(), colour.stroke_width(2)))?
            .label(line.name.clone())
            .legend(move |(x, y)| Circle::new((x + 8, y), 4, colour.filled()));
        chart.draw_series(points.iter().map(|&p| Circle::new(p, 4, colour.filled())))?;
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .background_style(WHITE.mix(0.85))
        .border_style(RGBColor(200, 200, 200))
        .label_font(("sans-serif", 13))
        .draw()?;
    area.present()
}
