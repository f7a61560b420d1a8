//! Measured reflectance in the report: figures per column, curves overlaid, places of the peaks.

use crate::report::axes::{Axis, level_lines, marks_below, polyline, ticks_in_powers, title_below};
use crate::report::numbers;
use crate::report::svg::{at, escape};
use crate::stages::measured::kind::Kind;
use crate::stages::measured::{CurveResult, MeasuredColumn, MeasuredResult, PeakPair};

/// Most curves that are drawn per column; figures of all stand in `report.json`.
const PLOTS_MAX: usize = 8;

/// Most rows of a table of peaks.
const PEAKS_MAX: usize = 24;

/// Size of a plot in SVG units.
const WIDTH: f64 = 400.0;
const HEIGHT: f64 = 190.0;

/// The section of one specimen, as HTML.
pub fn section(measured: &MeasuredResult) -> String {
    let mut html = format!("<h3>Measured reflectance</h3><p class=\"meta\">{}</p>", escape(&about(measured)));
    if !measured.notes.is_empty() {
        let notes: String = measured.notes.iter().map(|note| format!("<li>{}</li>", escape(note))).collect();
        html += &format!("<div class=\"note warn\"><ul>{notes}</ul></div>");
    }
    html += &figures(&measured.columns);
    for column in &measured.columns {
        html += &curves(column);
        html += &peaks(column);
    }
    html
}

/// How well the model meets the measurement, in a sentence or two.
pub(crate) fn in_short(measured: &MeasuredResult) -> String {
    let columns = measured.columns.iter().map(|column| {
        let shifts = [(true, "peaks of spectra"), (false, "peaks over the angle")]
            .map(|(spectra, what)| (shift(column, spectra), what))
            .into_iter()
            .filter(|(shift, _)| !shift.starts_with(numbers::MISSING))
            .map(|(shift, what)| format!(", {what} {shift} off"))
            .collect::<String>();
        format!("{}: correlation {}{shifts}", kind_text(column.kind), numbers::number(column.correlation, 3))
    });
    format!("Compared with {}. {}.", measured.file, columns.collect::<Vec<_>>().join("; "))
}

fn about(measured: &MeasuredResult) -> String {
    let [directions, wavelengths] = measured.samples;
    let mut text =
        format!("{} rows of {}, against the BRDF from the scan", numbers::count(measured.rows as u64), measured.file);
    if measured.acceptance_deg > 0.0 {
        let degrees = numbers::round_number(measured.acceptance_deg, 3);
        text += &format!(", averaged over a cone of {degrees}° ({directions} directions)");
    }
    if measured.bandwidth_nm > 0.0 {
        let nm = numbers::round_number(measured.bandwidth_nm, 3);
        text += &format!(", over a slit of {nm}\u{a0}nm ({wavelengths} wavelengths)");
    }
    text + "."
}

/// What a kind's values are, in words.
fn kind_text(kind: Kind) -> &'static str {
    match kind {
        Kind::Brdf => "BRDF, 1/sr",
        Kind::Scatter => "BRDF times cosine, 1/sr",
        Kind::RadianceFactor => "radiance relative to a white diffuser",
        Kind::ConeReflectance => "share of the power in the cone",
        Kind::RelativeRadiance => "radiance, arbitrary units",
        Kind::RelativePower => "power, arbitrary units",
    }
}

fn figures(columns: &[MeasuredColumn]) -> String {
    let rows: String = columns
        .iter()
        .map(|column| {
            let fitted = if column.kind.is_relative() { "fitted" } else { "not applied" };
            format!(
                "<tr><td class=\"l\">{}</td><td class=\"l\">{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>\
                 <td class=\"l\">{fitted}</td><td>{}</td><td>{}</td></tr>",
                escape(&column.name),
                kind_text(column.kind),
                numbers::count(column.values as u64),
                numbers::percent(column.relative_l2),
                numbers::number(column.correlation, 4),
                numbers::number(column.best_scale, 4),
                shift(column, true),
                shift(column, false),
            )
        })
        .collect();
    format!(
        "<div class=\"scroll\"><table><thead><tr><th class=\"l\">column</th><th class=\"l\">what it is</th><th>values</th>\
         <th>relative L2</th><th>correlation</th><th>best factor<br/>on the model</th><th class=\"l\"></th>\
         <th>peaks of spectra,<br/>median shift</th><th>of angular scans</th></tr></thead><tbody>{rows}</tbody></table></div>"
    )
}

/// Fewest pairs of peaks of which a median is told: of one or two it is chance.
const SHIFTS_MIN: usize = 3;

/// Median of model minus measured over the peaks of all spectra, or of all scans, with its unit.
fn shift(column: &MeasuredColumn, spectra: bool) -> String {
    let curves = column.curves.iter().filter(|curve| is_spectrum(curve) == spectra);
    let mut shifts: Vec<f64> = curves.flat_map(|curve| &curve.peaks).map(|peak| peak.model - peak.measured).collect();
    if shifts.len() < SHIFTS_MIN {
        return match shifts.len() {
            0 => numbers::MISSING.into(),
            count => format!("{} ({count} of {SHIFTS_MIN} pairs)", numbers::MISSING),
        };
    }
    shifts.sort_by(f64::total_cmp);
    let middle = 0.5 * (shifts[(shifts.len() - 1) / 2] + shifts[shifts.len() / 2]);
    if spectra { format!("{}\u{a0}nm", fixed(middle, 2)) } else { format!("{}°", fixed(middle, 3)) }
}

fn is_spectrum(curve: &CurveResult) -> bool {
    curve.along == "wavelength_nm"
}

/// A number with so many decimals, and a minus that is one; never a negative zero.
fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let unsigned = text.trim_start_matches('-');
    let is_zero = unsigned.chars().all(|character| matches!(character, '0' | '.'));
    if is_zero || unsigned.len() == text.len() { unsigned.into() } else { format!("−{unsigned}") }
}

/// Evenly chosen curves as plots, two in a row.
fn curves(column: &MeasuredColumn) -> String {
    let all = &column.curves;
    if all.is_empty() {
        return format!("<p>The rows of {} form neither spectra nor angular scans.</p>", escape(&column.name));
    }
    let shown = all.len().min(PLOTS_MAX);
    let chosen = (0..shown).map(|index| &all[index * (all.len() - 1) / shown.saturating_sub(1).max(1)]);
    let figures: String = chosen
        .map(|curve| {
            let caption = format!(
                "<b>{}</b>: {}. Relative L2 {}, correlation {}",
                escape(&place(curve)),
                kind_text(column.kind),
                numbers::percent(curve.relative_l2),
                numbers::number(curve.correlation, 4)
            );
            format!("<figure>{}<figcaption>{caption}</figcaption></figure>", plot(curve, column))
        })
        .collect();
    let of = if shown < all.len() { format!("{shown} of {} curves", all.len()) } else { String::new() };
    format!(
        "<p class=\"meta\"><b>{}</b>: circles measured, line model{}; dashed, upright: a measured peak that has one in the model. \
         {of}</p><div class=\"pair\">{figures}</div>",
        escape(&column.name),
        if column.kind.is_relative() { " with the fitted factor" } else { "" }
    )
}

/// The coordinates that do not vary.
fn place(curve: &CurveResult) -> String {
    let names = ["theta_i_deg", "phi_i_deg", "theta_r_deg", "phi_r_deg"];
    let signs = ["θi", "φi", "θr", "φr"];
    let angles = (0..4).filter(|&index| names[index] != curve.along);
    let mut parts: Vec<String> =
        angles.map(|index| format!("{} {}°", signs[index], degrees(curve.angles_deg[index]))).collect();
    if !is_spectrum(curve) {
        parts.push(format!("{}\u{a0}nm", numbers::round_number(curve.wavelength_nm, 5)));
    }
    parts.join(", ")
}

fn degrees(value: f64) -> String {
    numbers::round_number(value, 4)
}

fn axis_title(along: &str) -> &'static str {
    match along {
        "wavelength_nm" => "wavelength in nm",
        "theta_i_deg" => "θi in degrees",
        "phi_i_deg" => "φi in degrees",
        "theta_r_deg" => "θr in degrees",
        _ => "φr in degrees",
    }
}

/// Measured samples as circles over the model's line.
fn plot(curve: &CurveResult, column: &MeasuredColumn) -> String {
    const LEFT: f64 = 52.0;
    const TOP: f64 = 24.0;
    let span = WIDTH - LEFT - 18.0;
    let values = || curve.measured.iter().chain(&curve.model).copied();
    let high = values().fold(0.0, f64::max) * 1.05;
    let low = values().fold(0.0, f64::min);
    let high = if high > low { high } else { low + 1.0 };
    let (first, last) = (curve.at[0], curve.at[curve.at.len() - 1]);
    let (across, bottom) = ([LEFT, LEFT + span], TOP + HEIGHT);
    let x = Axis::linear([first, last], across);
    let y = Axis::linear([low, high], [bottom, TOP]);
    let (in_units, factor) = ticks_in_powers([low, high], 4);
    let title = axis_title(&curve.along);
    let mut body = level_lines(&y, &in_units, across, "grid");
    body += &marks_below(&x, &x.ticks(6), bottom);
    body += &title_below(title, across, bottom);
    let what = format!("{}{factor}", kind_text(column.kind));
    body += &format!(r#"<text x="0" y="12">{}</text>"#, escape(&what));
    for PeakPair { measured, .. } in &curve.peaks {
        body += &format!(r#"<path class="limit" d="M{} {}v{HEIGHT}"/>"#, at(x.at(*measured)), at(TOP));
    }
    let circles = curve.at.iter().zip(&curve.measured);
    let radius = at((0.35 * span / curve.at.len() as f64).clamp(1.0, 3.0));
    body += &circles
        .map(|(&place, &value)| {
            format!(r#"<circle class="dot" cx="{}" cy="{}" r="{radius}"/>"#, at(x.at(place)), at(y.at(value)))
        })
        .collect::<String>();
    let model = curve.at.iter().copied().zip(curve.model.iter().copied());
    body += &polyline(model, &x, &y, "stroke:currentColor;stroke-width:1.4");
    format!(
        r#"<svg class="plot" viewBox="0 0 {WIDTH} {}" role="img" aria-label="{}">{body}</svg>"#,
        at(TOP + HEIGHT + 40.0),
        escape(&format!("{}, measured and model, against {title}", column.name))
    )
}

/// The places of the peaks, curve after curve.
fn peaks(column: &MeasuredColumn) -> String {
    let all: Vec<(&CurveResult, &PeakPair)> =
        column.curves.iter().flat_map(|curve| curve.peaks.iter().map(move |peak| (curve, peak))).collect();
    if all.is_empty() {
        return String::new();
    }
    let row = |(curve, peak): &(&CurveResult, &PeakPair)| {
        let (decimals, unit) = if is_spectrum(curve) { (1, "\u{a0}nm") } else { (2, "°") };
        let text = |value: f64, decimals: usize| format!("{}{unit}", fixed(value, decimals));
        format!(
            "<tr><td class=\"l\">{}</td><td class=\"l\">{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
            escape(&place(curve)),
            axis_title(&curve.along),
            text(peak.measured, decimals),
            text(peak.model, decimals),
            text(peak.model - peak.measured, decimals + 1),
            peak.prominence.map(|share| fixed(100.0 * share, 0)).join(" / "),
        )
    };
    let rows: String = all.iter().take(PEAKS_MAX).map(row).collect();
    let counts = column.curves.iter().fold([0; 2], |sum, curve| [0, 1].map(|side| sum[side] + curve.peak_counts[side]));
    let rest = if all.len() > PEAKS_MAX { format!(" The first {PEAKS_MAX} are listed.") } else { String::new() };
    let widest = column.curves.iter().map(|curve| curve.smoothing).fold(0.0, f64::max);
    let smoothing = match widest > 0.0 {
        true => format!(
            "Both are smoothed alike for it, by the slit or the cone and as far as the noise asks for it: by up to {} nm or degrees at \
             half height.",
            numbers::round_number(widest, 3)
        ),
        false => String::new(),
    };
    format!(
        "<p>Peaks of {}: {} measured, {} in the model, {} belong together.{rest} {smoothing}</p>\
         <div class=\"scroll\"><table><thead><tr><th class=\"l\">geometry</th><th class=\"l\">peak in</th><th>measured</th>\
         <th>model</th><th>difference</th><th>stand out by,<br/>% of the range</th></tr></thead><tbody>{rows}</tbody></table></div>",
        escape(&column.name),
        counts[0],
        counts[1],
        all.len()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(along: &str, shift: f64) -> CurveResult {
        CurveResult {
            along: along.into(),
            angles_deg: [0.0, 0.0, 20.0, 0.0],
            wavelength_nm: 500.0,
            at: vec![500.0, 510.0, 520.0, 530.0, 540.0],
            measured: vec![0.0, 1.0, 3.0, 1.0, -0.1],
            model: vec![0.0, 1.5, 2.5, 1.0, 0.0],
            relative_l2: 0.2,
            correlation: f64::NAN,
            peak_counts: [3, 3],
            smoothing: 2.0,
            peaks: vec![PeakPair { measured: 520.0, model: 520.0 + shift, prominence: [1.0, 0.9] }; 3],
        }
    }

    fn result(curves: Vec<CurveResult>) -> MeasuredResult {
        MeasuredResult {
            file: "a<b>.csv".into(),
            rows: 5,
            acceptance_deg: 1.0,
            bandwidth_nm: 2.0,
            samples: [64, 16],
            notes: vec!["a & b".into()],
            columns: vec![MeasuredColumn {
                name: "brdf_per_sr:<x>".into(),
                kind: Kind::Brdf,
                values: 5,
                relative_l2: f64::INFINITY,
                correlation: 0.5,
                scale: 1.0,
                best_scale: f64::NAN,
                curves,
            }],
        }
    }

    #[test]
    fn names_are_escaped_and_missing_figures_are_dashes() {
        let html = section(&result(vec![curve("wavelength_nm", -1.5), curve("theta_r_deg", 0.25)]));
        roxmltree::Document::parse(&format!("<div>{html}</div>")).unwrap();
        assert!(!html.contains("NaN") && !html.contains("inf") && !html.contains("<x>") && !html.contains("<b>.csv"));
        assert!(html.contains("−1.50\u{a0}nm") && html.contains("0.250°"), "{html}");
    }

    #[test]
    fn a_median_of_two_is_none() {
        let mut single = curve("wavelength_nm", -1.5);
        single.peaks.truncate(2);
        let html = section(&result(vec![single]));
        assert!(html.contains("(2 of 3 pairs)") && html.contains("dashed, upright"), "{html}");
    }

    #[test]
    fn many_curves_are_thinned_out_evenly() {
        let html = section(&result((0..30).map(|i| curve("wavelength_nm", f64::from(i))).collect()));
        assert_eq!(html.matches("<svg").count(), PLOTS_MAX);
        assert!(html.contains("8 of 30 curves") && html.contains("The first 24 are listed"));
        let html = section(&result(Vec::new()));
        assert!(html.contains("neither spectra nor angular scans"));
    }

    #[test]
    fn a_rounded_minus_zero_is_zero() {
        assert_eq!((fixed(-0.001, 2), fixed(-0.25, 1), fixed(1.0, 1)), ("0.00".into(), "−0.2".into(), "1.0".into()));
    }
}
