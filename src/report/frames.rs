//! SVG frames around pictures of data: axes, colour bars, labels.

use crate::report::colour_maps::{ColourMap, INFERNO, VIRIDIS};
use crate::report::numbers;
use crate::report::pictures::SCALE_BAR_MARGIN;
use crate::report::svg::{at, escape, ticks};
use crate::stages::results::{HeightMapFile, Period, SpectrumFile};

/// Width of every frame in SVG units; text is 12 units high.
const WIDTH: f64 = 480.0;
/// Left and top of the picture inside its frame.
const LEFT: f64 = 44.0;
const TOP: f64 = 20.0;
/// Longest side of a picture inside its frame.
const SIDE: f64 = 356.0;
/// Room below the picture for ticks and the axis's name.
const BELOW: f64 = 40.0;
/// Lowest picture; flatter ones are stretched to it, which the axes show.
const LEAST: f64 = 40.0;

/// Where a picture lies in its frame.
struct Area {
    width: f64,
    height: f64,
}

/// The frame of a height map: `href` is the picture's address, `extent_um` the scan's extent along
/// x and y, `id` a name for parts of this frame that no other frame on the page has.
pub(crate) fn height_frame(href: &str, id: &str, extent_um: [f64; 2], file: &HeightMapFile) -> String {
    let longer = extent_um[0].max(extent_um[1]);
    let [width, height] = extent_um.map(|extent| {
        let side = SIDE * extent / longer;
        if side.is_finite() { side.max(LEAST) } else { LEAST }
    });
    let area = Area { width, height };
    let mut body = image(href, &area);
    body += &axis_x(&area, 0.0, extent_um[0], "x (µm)");
    body += &axis_y(&area, 0.0, extent_um[1], "y (µm)");
    if file.scale_bar_um > 0.0 {
        let margin = SCALE_BAR_MARGIN * width.max(height);
        let length = file.scale_bar_um / extent_um[0] * width;
        body += &format!(
            r#"<text class="on" x="{}" y="{}" text-anchor="middle">{} µm</text>"#,
            at(LEFT + margin + length / 2.0),
            at(TOP + height - margin * 1.33 - 7.0),
            escape(&numbers::round_number(file.scale_bar_um, 3)),
        );
    }
    body += &colour_bar(&area, id, &VIRIDIS, [file.low_nm, file.high_nm], "nm");
    let label = format!(
        "Height map, {} by {} µm, colours from {} to {} nm",
        numbers::number(extent_um[0], 3),
        numbers::number(extent_um[1], 3),
        numbers::number(file.low_nm, 3),
        numbers::number(file.high_nm, 3),
    );
    frame(&label, area.height + TOP + BELOW, &body)
}

/// The frame of a power spectrum, with rings at round frequencies, named by their period, and the
/// given periods marked a, b, c, ...
pub(crate) fn spectrum_frame(href: &str, id: &str, file: &SpectrumFile, periods: &[Period]) -> String {
    let area = Area { width: SIDE, height: SIDE };
    let range = file.half_range_per_um;
    let clip = format!("{id}-clip");
    let mut body = image(href, &area);
    body += &format!(
        r#"<clipPath id="{clip}"><rect x="{LEFT}" y="{TOP}" width="{SIDE}" height="{SIDE}"/></clipPath><g clip-path="url(#{clip})">"#
    );
    body += &rings(range);
    for (index, period) in periods.iter().enumerate().take(26) {
        body += &period_mark(range, index, period);
    }
    body += "</g>";
    body += &axis_x(&area, -range, range, "frequency along x (1/µm)");
    body += &axis_y(&area, -range, range, "frequency along y (1/µm)");
    body += &colour_bar(&area, id, &INFERNO, [file.low_db, 0.0], "dB");
    let label = format!("Power spectrum of the heights up to {} cycles per µm", numbers::number(range, 3));
    frame(&label, area.height + TOP + BELOW, &body)
}

/// The letter that marks a period in the spectrum and in the list of periods.
pub(crate) fn period_letter(index: usize) -> char {
    char::from(b'a' + (index % 26) as u8)
}

fn rings(range: f64) -> String {
    let centre = [LEFT + SIDE / 2.0, TOP + SIDE / 2.0];
    let mut body = String::new();
    for (frequency, _) in ticks(0.0, range, 3).into_iter().skip(1) {
        let radius = frequency / range * SIDE / 2.0;
        if radius > SIDE / 2.0 - 4.0 {
            continue;
        }
        let diagonal = radius * std::f64::consts::FRAC_1_SQRT_2;
        body += &format!(
            r#"<circle class="ring" cx="{}" cy="{}" r="{}"/><text class="on small" x="{}" y="{}" text-anchor="middle">{}</text>"#,
            at(centre[0]),
            at(centre[1]),
            at(radius),
            at(centre[0] + diagonal),
            at(centre[1] + diagonal + 4.0),
            escape(&ring_label(1e3 / frequency)),
        );
    }
    body
}

/// A period in the unit that needs fewer digits.
fn ring_label(period_nm: f64) -> String {
    if period_nm >= 999.5 {
        format!("{} µm", numbers::round_number(period_nm * 1e-3, 2))
    } else {
        format!("{} nm", numbers::round_number(period_nm, 3))
    }
}

fn period_mark(range: f64, index: usize, period: &Period) -> String {
    let frequency = 1e3 / period.period_nm;
    // A frequency that is not a number lies in no range.
    let shown = (f64::MIN_POSITIVE..=range).contains(&frequency);
    if !shown || !period.direction_deg.is_finite() {
        return String::new();
    }
    let (sin, cos) = period.direction_deg.to_radians().sin_cos();
    let radius = frequency / range * SIDE / 2.0;
    let [dx, dy] = [radius * cos, -radius * sin];
    let centre = [LEFT + SIDE / 2.0, TOP + SIDE / 2.0];
    let (x, y) = (centre[0] + dx, centre[1] + dy);
    // The letter stands beside the line of its mark and the origin, where its overtones are not.
    let side = if cos < 0.0 { -15.0 } else { 15.0 };
    let (tx, ty) = (x - side * sin, y - side * cos + 4.0);
    let rings: String = [(x, y), (centre[0] - dx, centre[1] - dy)]
        .iter()
        .flat_map(|place| ["under", "mark"].map(|class| (place, class)))
        .map(|((x, y), class)| format!(r#"<circle class="{class}" cx="{}" cy="{}" r="7"/>"#, at(*x), at(*y)))
        .collect();
    format!(
        r#"{rings}<text class="on" x="{}" y="{}" text-anchor="middle">{}</text>"#,
        at(tx),
        at(ty),
        period_letter(index),
    )
}

fn frame(label: &str, height: f64, body: &str) -> String {
    format!(
        r#"<svg class="plot" viewBox="0 0 {WIDTH} {}" role="img" aria-label="{}">{body}</svg>"#,
        at(height),
        escape(label)
    )
}

fn image(href: &str, area: &Area) -> String {
    let (width, height) = (at(area.width), at(area.height));
    format!(
        r#"<image href="{}" x="{LEFT}" y="{TOP}" width="{width}" height="{height}" preserveAspectRatio="none"/><rect class="box" x="{LEFT}" y="{TOP}" width="{width}" height="{height}"/>"#,
        escape(href)
    )
}

fn axis_x(area: &Area, low: f64, high: f64, name: &str) -> String {
    let bottom = TOP + area.height;
    let mut body = String::new();
    for (value, text) in ticks(low, high, ((area.width / 50.0) as usize).max(2)) {
        let x = at(LEFT + (value - low) / (high - low) * area.width);
        body += &format!(
            r#"<path class="tick" d="M{x} {}v4"/><text x="{x}" y="{}" text-anchor="middle">{text}</text>"#,
            at(bottom),
            at(bottom + 17.0)
        );
    }
    body + &format!(
        r#"<text x="{}" y="{}" text-anchor="middle">{}</text>"#,
        at(LEFT + area.width / 2.0),
        at(bottom + 34.0),
        escape(name)
    )
}

fn axis_y(area: &Area, low: f64, high: f64, name: &str) -> String {
    let mut body = String::new();
    for (value, text) in ticks(low, high, ((area.height / 50.0) as usize).max(2)) {
        let y = TOP + (1.0 - (value - low) / (high - low)) * area.height;
        body += &format!(
            r#"<path class="tick" d="M{LEFT} {}h-4"/><text x="{}" y="{}" text-anchor="end">{text}</text>"#,
            at(y),
            at(LEFT - 6.0),
            at(y + 4.0)
        );
    }
    let middle = TOP + area.height / 2.0;
    body + &format!(
        r#"<text x="0" y="0" text-anchor="middle" transform="translate(11 {}) rotate(-90)">{}</text>"#,
        at(middle),
        escape(name)
    )
}

fn colour_bar(area: &Area, id: &str, map: &ColourMap, range: [f64; 2], unit: &str) -> String {
    let x = LEFT + area.width + 14.0;
    let width = 12.0;
    let gradient = format!("{id}-colours");
    let stops: String = map
        .iter()
        .enumerate()
        .map(|(index, [r, g, b])| {
            let offset = at(100.0 * index as f64 / (map.len() - 1) as f64);
            format!(r##"<stop offset="{offset}%" stop-color="#{r:02x}{g:02x}{b:02x}"/>"##)
        })
        .collect();
    let mut body = format!(
        r#"<linearGradient id="{gradient}" x1="0" x2="0" y1="1" y2="0">{stops}</linearGradient><rect class="box" x="{0}" y="{TOP}" width="{width}" height="{1}" style="fill:url(#{gradient})"/><text x="{0}" y="{2}">{unit}</text>"#,
        at(x),
        at(area.height),
        at(TOP - 7.0),
    );
    let [low, high] = range;
    for (value, text) in colour_ticks(range, area) {
        let y = TOP + (1.0 - (value - low) / (high - low)) * area.height;
        body += &format!(
            r#"<path class="tick" d="M{} {}h4"/><text x="{}" y="{}">{text}</text>"#,
            at(x + width),
            at(y),
            at(x + width + 7.0),
            at(y + 4.0)
        );
    }
    body
}

/// Round numbers beside a colour bar; its two ends where fewer than two are within, for one number alone is no scale.
fn colour_ticks([low, high]: [f64; 2], area: &Area) -> Vec<(f64, String)> {
    let round = ticks(low, high, ((area.height / 40.0) as usize).max(2));
    let spans = high > low && (high - low).is_finite();
    if round.len() < 2 && spans { [low, high].map(|end| (end, numbers::number(end, 2))).into() } else { round }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spectrum() -> SpectrumFile {
        SpectrumFile { png: "a/spectrum.png".into(), half_range_per_um: 4.0, low_db: -60.0 }
    }

    fn period(period_nm: f64, direction_deg: f64) -> Period {
        Period { period_nm, direction_deg, relative_power: 1.0 }
    }

    #[test]
    fn a_period_is_marked_where_its_frequency_lies() {
        // 500 nm along +y: 2 per µm, halfway from the centre to the upper edge.
        let svg = spectrum_frame("x", "s", &spectrum(), &[period(500.0, 90.0)]);
        let expected = format!(r#"<circle class="mark" cx="{}" cy="{}""#, at(LEFT + SIDE / 2.0), at(TOP + SIDE / 4.0));
        assert!(svg.contains(&expected), "{svg}");
    }

    #[test]
    fn a_colour_bar_has_at_least_two_labels() {
        for height in [LEAST, 100.0, SIDE] {
            let area = Area { width: SIDE, height };
            for range in
                [[-40.0, 45.0], [-0.3, 0.2], [-7.0, 140.0], [0.0, 1.0], [-60.0, 0.0], [51.0, 93.0], [99.0, 101.5]]
            {
                let found = colour_ticks(range, &area);
                assert!(found.len() >= 2, "{range:?} over {height}: {found:?}");
                let gap = (found[1].0 - found[0].0) / (range[1] - range[0]) * height;
                assert!(gap > 12.0, "{found:?} overlap");
            }
        }
        assert_eq!(colour_ticks([-40.0, 45.0], &Area { width: SIDE, height: LEAST })[0].1, "−40");
    }

    #[test]
    fn periods_out_of_range_or_undefined_are_not_marked() {
        for odd in [period(100.0, 0.0), period(f64::NAN, 0.0), period(0.0, 0.0), period(500.0, f64::NAN)] {
            let svg = spectrum_frame("x", "s", &spectrum(), &[odd]);
            assert!(!svg.contains("class=\"mark\""), "{odd:?}");
        }
    }

    #[test]
    fn frames_are_well_formed_and_without_nan_whatever_the_numbers() {
        for value in [0.0, -1.0, 1e-9, 1e12, f64::NAN, f64::INFINITY] {
            let heights = HeightMapFile {
                png: "h.png".into(),
                scale_bar_um: value,
                low_nm: value,
                high_nm: 3.0,
                replaced_samples: 0,
            };
            let mut file = spectrum();
            file.half_range_per_um = value;
            file.low_db = value;
            for svg in [
                height_frame("a\"<&", "h", [value, 20.0], &heights),
                spectrum_frame("x", "s", &file, &[period(value, value)]),
            ] {
                assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
                assert!(svg.len() < 100_000, "unbounded for {value}");
                roxmltree::Document::parse(&svg).unwrap();
            }
        }
    }
}
