//! SVG plots of a run's numbers: error ranges, power sums, stage times.

use crate::report::axes::{Axis, level_lines, marks_below, polyline, title_below, upright_lines};
use crate::report::numbers;
use crate::report::svg::{at, escape};
use diffraction_build::accuracy::power_sums::PowerSum;
use diffraction_build::accuracy::rows::ErrorRow;

/// Width of every plot in SVG units; text is 12 units high.
const WIDTH: f64 = 620.0;
/// Height of one row of a plot of rows.
const ROW: f64 = 19.0;

/// Median to 95th percentile as a bar, on to the 99th percentile as a line, and the worst as a
/// cross, one row per [`ErrorRow`], on a logarithmic axis; the tolerance as a dashed line.
///
/// Errors of zero and missing ones are not drawn: a logarithm has no place for them.
pub(crate) fn error_plot(rows: &[ErrorRow], tolerance: Option<f64>) -> String {
    const LEFT: f64 = 318.0;
    const TOP: f64 = 20.0;
    // The last label, "10000 %", reaches so far beyond its line.
    let span = WIDTH - LEFT - 30.0;
    let values: Vec<f64> = rows
        .iter()
        .flat_map(|row| [row.p50, row.p95, row.p99, row.worst])
        .chain(tolerance)
        .filter(|&value| drawable(value))
        .collect();
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(0.0, f64::max);
    if high == 0.0 {
        return String::new();
    }
    let axis = Axis::logarithmic([low, high], 12, [LEFT, LEFT + span]);
    let x = |value: f64| axis.at(value);
    let bottom = TOP + ROW * rows.len() as f64;
    let mut body = upright_lines(&axis, &axis.decades(6, decade_percent), [TOP, bottom], "grid");
    if let Some(limit) = tolerance.filter(|&value| drawable(value)) {
        body += &format!(
            r#"<path class="limit" d="M{0} {1}V{2}"/><text class="small" x="{0}" y="{3}" text-anchor="middle">tolerance</text>"#,
            at(x(limit)),
            at(TOP - 4.0),
            at(bottom),
            at(TOP - 7.0)
        );
    }
    let mut previous = None;
    for (index, row) in rows.iter().enumerate() {
        let y = TOP + ROW * (index as f64 + 0.5);
        if previous != Some(row.cause) {
            if index > 0 {
                body += &format!(r#"<path class="grid" d="M0 {}H{WIDTH}"/>"#, at(y - ROW / 2.0));
            }
            body += &format!(r#"<text class="strong" x="0" y="{}">{}</text>"#, at(y + 4.0), escape(row.cause.name()));
            previous = Some(row.cause);
        }
        body += &format!(
            r#"<text x="{}" y="{}" text-anchor="end">{}</text>"#,
            at(LEFT - 8.0),
            at(y + 4.0),
            escape(&row.group.to_string())
        );
        body += &error_range(row, y, &x);
    }
    svg("Measured relative errors per cause and region", bottom + 22.0, &body)
}

fn drawable(value: f64) -> bool {
    value.is_finite() && value > 0.0
}

/// `10^power` in per cent without trailing zeros.
fn decade_percent(power: i32) -> String {
    let power = power + 2;
    if (-3..=4).contains(&power) {
        let decimals = (-power).max(0) as usize;
        format!("{:.decimals$} %", 10f64.powi(power))
    } else {
        format!("10{} %", numbers::superscript(power))
    }
}

fn error_range(row: &ErrorRow, y: f64, x: &dyn Fn(f64) -> f64) -> String {
    let mut body = String::new();
    let line = |class: &str, from: f64, to: f64| {
        if drawable(from) && drawable(to) {
            format!(r#"<path class="{class}" d="M{} {}H{}"/>"#, at(x(from)), at(y), at(x(to)))
        } else {
            String::new()
        }
    };
    body += &line("whisker", row.p95, row.p99);
    body += &line("span", row.p50, row.p95);
    if drawable(row.p50) {
        body += &format!(r#"<circle class="dot" cx="{}" cy="{}" r="3.5"/>"#, at(x(row.p50)), at(y));
    }
    if drawable(row.worst) {
        body += &format!(r#"<path class="cross" d="M{} {}l6 6m0 -6l-6 6"/>"#, at(x(row.worst) - 3.0), at(y - 3.0));
    }
    body
}

/// Power sums against the angle of incidence, one line per wavelength and one for the luminous sum.
/// 1 is what goes in.
pub(crate) fn power_plot(sums: &[PowerSum]) -> String {
    const LEFT: f64 = 46.0;
    const TOP: f64 = 12.0;
    const HEIGHT: f64 = 190.0;
    let span = WIDTH - LEFT - 120.0;
    let usable: Vec<&PowerSum> =
        sums.iter().filter(|sum| sum.sum.is_finite() && (0.0..=90.0).contains(&sum.theta_i_deg)).collect();
    if usable.is_empty() {
        return String::new();
    }
    // The scalar model can run away towards grazing; the part that matters stays readable.
    let top_sum = usable.iter().map(|sum| sum.sum).fold(1.0, f64::max).min(3.0) * 1.08;
    let (across, bottom) = ([LEFT, LEFT + span], TOP + HEIGHT);
    let x = Axis::linear([0.0, 90.0], across);
    let y = Axis::linear([0.0, top_sum], [bottom, TOP]);
    let mut body = level_lines(&y, &[(1.0, String::new())], across, "limit");
    body += &level_lines(&y, &y.ticks(5), across, "grid");
    body += &marks_below(&x, &[0, 15, 30, 45, 60, 75, 90].map(|deg| (f64::from(deg), format!("{deg}°"))), bottom);
    body += &title_below("angle of incidence", across, bottom);
    for (index, Series { name, colour, points }) in series(&usable).iter().enumerate() {
        body += &curve(points, colour, &x, &y);
        let place = TOP + 8.0 + 18.0 * index as f64;
        body += &format!(
            r#"<path style="stroke:{colour};stroke-width:2.5" d="M{0} {1}h16"/><text x="{2}" y="{3}">{4}</text>"#,
            at(LEFT + span + 14.0),
            at(place),
            at(LEFT + span + 36.0),
            at(place + 4.0),
            escape(name)
        );
    }
    svg("Power sums against the angle of incidence", TOP + HEIGHT + 40.0, &body)
}

fn curve(points: &[(f64, f64)], colour: &str, x: &Axis, y: &Axis) -> String {
    let dots: String = points
        .iter()
        .map(|&(theta_deg, sum)| {
            format!(r#"<circle style="fill:{colour}" cx="{}" cy="{}" r="2.5"/>"#, at(x.at(theta_deg)), at(y.at(sum)))
        })
        .collect();
    polyline(points.iter().copied(), x, y, &format!("stroke:{colour};stroke-width:1.6")) + &dots
}

/// One line of a plot.
struct Series {
    name: String,
    colour: String,
    /// `(theta_i_deg, sum)` by rising angle.
    points: Vec<(f64, f64)>,
}

/// The lines: luminous first, then by wavelength.
fn series(sums: &[&PowerSum]) -> Vec<Series> {
    let mut kinds: Vec<Option<f64>> = sums.iter().map(|sum| sum.wavelength_nm).collect();
    kinds.sort_by(|a, b| a.unwrap_or(0.0).total_cmp(&b.unwrap_or(0.0)));
    kinds.dedup();
    kinds
        .into_iter()
        .map(|kind| {
            let mut points: Vec<(f64, f64)> =
                sums.iter().filter(|sum| sum.wavelength_nm == kind).map(|sum| (sum.theta_i_deg, sum.sum)).collect();
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            match kind {
                None => Series { name: "luminous".into(), colour: "currentColor".into(), points },
                Some(wavelength_nm) => Series {
                    name: format!("{} nm", numbers::round_number(wavelength_nm, 4)),
                    colour: wavelength_colour(wavelength_nm),
                    points,
                },
            }
        })
        .collect()
}

/// A colour that recalls the wavelength and is readable on black and on white.
fn wavelength_colour(wavelength_nm: f64) -> String {
    const HUES: [(f64, f64); 7] =
        [(400.0, 275.0), (450.0, 228.0), (490.0, 190.0), (530.0, 130.0), (580.0, 45.0), (610.0, 20.0), (660.0, 0.0)];
    let above = HUES.iter().position(|&(edge, _)| wavelength_nm < edge);
    let hue = match above {
        Some(0) => HUES[0].1,
        Some(index) => {
            let ((w0, h0), (w1, h1)) = (HUES[index - 1], HUES[index]);
            h0 + (h1 - h0) * (wavelength_nm - w0) / (w1 - w0)
        }
        None => HUES[HUES.len() - 1].1,
    };
    format!("hsl({}, 65%, 48%)", at(hue))
}

/// Named durations in seconds as bars.
pub(crate) fn time_plot(times: &[(String, f64)]) -> String {
    const LEFT: f64 = 232.0;
    let longest = times.iter().map(|time| time.1).filter(|&time| drawable(time)).fold(0.0, f64::max);
    if longest == 0.0 {
        return String::new();
    }
    let span = WIDTH - LEFT - 84.0;
    let mut body = String::new();
    for (index, (name, time)) in times.iter().enumerate() {
        let top = ROW * index as f64;
        let length = if drawable(*time) { span * time / longest } else { 0.0 };
        body += &format!(
            r#"<text x="{0}" y="{1}" text-anchor="end">{2}</text><rect class="bar" x="{LEFT}" y="{3}" width="{4}" height="11"/><text x="{5}" y="{1}">{6}</text>"#,
            at(LEFT - 8.0),
            at(top + 13.5),
            escape(name),
            at(top + 4.0),
            at(length.max(1.0)),
            at(LEFT + length + 7.0),
            escape(&numbers::seconds(*time))
        );
    }
    svg("Time per stage", ROW * times.len() as f64 + 2.0, &body)
}

fn svg(label: &str, height: f64, body: &str) -> String {
    format!(
        r#"<svg class="plot wide" viewBox="0 0 {WIDTH} {}" role="img" aria-label="{}">{body}</svg>"#,
        at(height),
        escape(label)
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use diffraction_build::accuracy::directions::Group;
    use diffraction_build::accuracy::rows::Cause;
    use diffraction_build::ground::sampling::Region;

    fn row(cause: Cause, errors: [f64; 4]) -> ErrorRow {
        ErrorRow {
            cause,
            group: Group::Region(Region::Grazing),
            directions: 100,
            floor_per_sr: 1.5e-4,
            share_above: 1.0,
            directions_below: 32,
            missed_directions: 0,
            left_out_per_sr: None,
            relative_l2: errors[0],
            p50: errors[0],
            p95: errors[1],
            p99: errors[2],
            worst: errors[3],
        }
    }

    fn check(svg: &str) {
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        if !svg.is_empty() {
            roxmltree::Document::parse(svg).unwrap();
        }
    }

    #[test]
    fn labels_stay_within_the_picture() {
        for worst in [9.0, 10.0, 99.0, 100.0] {
            let plot = error_plot(&[row(Cause::Total, [1e-6, 1e-3, 1.0, worst])], Some(worst));
            let document = roxmltree::Document::parse(&plot).unwrap();
            let centred = document.descendants().filter(|node| node.attribute("text-anchor") == Some("middle"));
            let ends = centred.map(|text| {
                let x: f64 = text.attribute("x").unwrap().parse().unwrap();
                // A digit is 0.64 of its height wide at most, a letter of a word 0.6 in the mean.
                let letter = if text.attribute("class") == Some("small") { 0.6 * 10.5 } else { 0.64 * 12.0 };
                x + 0.5 * letter * text.text().unwrap().chars().count() as f64
            });
            let widest = ends.fold(0.0, f64::max);
            assert!(widest > 590.0 && widest < WIDTH, "{worst}: {widest}");
        }
    }

    /// The x of every mark of a class.
    fn places(svg: &str, class: &str) -> Vec<f64> {
        let document = roxmltree::Document::parse(svg).unwrap();
        document
            .descendants()
            .filter(|node| node.attribute("class") == Some(class))
            .map(|node| node.attribute("cx").unwrap().parse().unwrap())
            .collect()
    }

    #[test]
    fn a_decade_is_a_decade() {
        let rows = [
            row(Cause::Total, [1e-4, 1e-3, 1e-2, 1e-1]),
            row(Cause::Basis, [1e-3, 1e-2, 1e-2, 1e-1]),
            row(Cause::Grid, [1e-2, 1e-2, 1e-2, 1e-1]),
        ];
        let svg = error_plot(&rows, Some(1e-3));
        check(&svg);
        let x = places(&svg, "dot");
        assert_eq!(x.len(), 3);
        assert!(x[1] > x[0] + 50.0);
        assert!(((x[2] - x[1]) - (x[1] - x[0])).abs() < 0.02, "{x:?}");
    }

    #[test]
    fn missing_and_zero_errors_are_left_out_of_the_plot() {
        let nan = f64::NAN;
        let odd = row(Cause::Total, [nan, 0.0, f64::INFINITY, 1e-300]);
        check(&error_plot(&[ErrorRow { group: Group::Scene("a<&".into()), ..odd }], Some(nan)));
        assert_eq!(error_plot(&[row(Cause::Total, [0.0; 4])], None), "");
        assert_eq!(error_plot(&[], None), "");
    }

    #[test]
    fn power_sums_are_grouped_by_wavelength_whatever_their_order() {
        let sum = |theta_i_deg, wavelength_nm, sum| PowerSum { theta_i_deg, wavelength_nm, sum };
        let sums = [
            sum(60.0, Some(550.0), 0.9),
            sum(0.0, None, 1.0),
            sum(0.0, Some(550.0), 1.01),
            sum(30.0, None, f64::NAN),
            sum(120.0, None, 1.0),
        ];
        let usable: Vec<&PowerSum> = sums.iter().take(3).collect();
        let lines = series(&usable);
        assert_eq!(lines.len(), 2);
        assert_eq!(lines[0].name, "luminous");
        assert_eq!(lines[1].points, [(0.0, 1.01), (60.0, 0.9)]);
        check(&power_plot(&sums));
        assert_eq!(power_plot(&[]), "");
    }

    #[test]
    fn bars_are_as_long_as_their_times() {
        let svg = time_plot(&[("read".into(), 1.0), ("build".into(), 4.0), ("x".into(), f64::NAN)]);
        check(&svg);
        let document = roxmltree::Document::parse(&svg).unwrap();
        let widths: Vec<f64> = document
            .descendants()
            .filter(|node| node.attribute("class") == Some("bar"))
            .map(|node| node.attribute("width").unwrap().parse().unwrap())
            .collect();
        assert!((widths[1] / widths[0] - 4.0).abs() < 1e-3, "{widths:?}");
    }

    #[test]
    fn decades_read_as_per_cent() {
        assert_eq!(decade_percent(0), "100 %");
        assert_eq!(decade_percent(-3), "0.1 %");
        assert_eq!(decade_percent(-5), "0.001 %");
        assert_eq!(decade_percent(-9), "10⁻⁷ %");
    }
}
