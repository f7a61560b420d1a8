//! Strips of colour over an angle, as seen and with the faint lifted, above the curve of their brightness.

use ndarray::Array3;

use crate::report::axes::{Axis, level_lines, marks_below, polyline, title_below};
use crate::report::embed::data_uri;
use crate::report::numbers;
use crate::report::svg::{at, escape};
use crate::stages::goniometry::{Plane, SetUp, Strip};
use diffraction_brdf::error::Result;
use diffraction_build::ground::colour::to_srgb8;
use diffraction_render::render::png_image::encode_png;

/// Sizes in SVG units: the plot, and the heights of a bar of colour and of the curve.
const WIDTH: f64 = 480.0;
const LEFT: f64 = 76.0;
const RIGHT: f64 = 12.0;
const BAR: f64 = 26.0;
const CURVE: f64 = 96.0;

/// Decades of brightness that the curve and the lifted bar show.
const DECADES: usize = 5;

/// Share of the angles that the bar of colours as seen keeps below white.
const EXPOSED: f64 = 0.97;

/// What the angle of a set-up is, for a caption.
pub(crate) fn set_up_text(set_up: SetUp) -> &'static str {
    match set_up {
        SetUp::NormalIncidence => "light from straight above, seen at the angle (0°/θ)",
        SetUp::Mirror => "light and view at the same angle on opposite sides, as in a mirror (θ/θ)",
        SetUp::FixedArms => "light and view 45° apart, the specimen tilted by the angle below them",
        SetUp::BackScattering => "light and view from the same side at the angle (back-scattering)",
    }
}

/// The plane, for a caption.
pub(crate) fn plane_text(plane: Plane) -> &'static str {
    match plane {
        Plane::Xz => "along x",
        Plane::Yz => "along y",
    }
}

/// A strip as a plot. Fails on what cannot be a picture, which no strip is.
pub(crate) fn strip_plot(strip: &Strip) -> Result<String> {
    let across = [LEFT, WIDTH - RIGHT];
    let angles: Vec<f64> = strip.angles_deg().collect();
    let ends = [angles[0] - 0.5, angles[angles.len() - 1] + 0.5];
    let x = Axis::linear(ends, across);
    let peak = luminance(strip).fold(f64::MIN_POSITIVE, f64::max);
    let curve = [2.0 * BAR + 14.0, 2.0 * BAR + 14.0 + CURVE];
    let y = Axis::logarithmic([peak * 1e-9, peak], DECADES, [curve[1], curve[0]]);
    let mut body = bar(0.0, "as seen", &seen(strip))?;
    body += &bar(BAR + 4.0, "faint lifted", &lifted(strip, peak))?;
    body += &level_lines(&y, &y.decades(3, decade), across, "grid");
    body += &marks_below(&x, &x.ticks(8), curve[1]);
    body += &title_below("angle in degrees", across, curve[1]);
    let lit = angles.iter().copied().zip(luminance(strip)).filter(|(_, value)| *value > 0.0);
    body += &polyline(lit, &x, &y, "stroke:currentColor;stroke-width:1.4");
    let label = format!("Colours {}: {}", plane_text(strip.plane), set_up_text(strip.set_up));
    Ok(format!(
        r#"<svg class="plot" viewBox="0 0 {WIDTH} {}" role="img" aria-label="{}">{body}</svg>"#,
        at(curve[1] + 40.0),
        escape(&label)
    ))
}

fn decade(power: i32) -> String {
    match power {
        -2..=3 => numbers::round_number(10f64.powi(power), 3),
        _ => format!("10{}", numbers::superscript(power)),
    }
}

fn luminance(strip: &Strip) -> impl Iterator<Item = f64> {
    strip.xyz.iter().map(|xyz| f64::from(xyz[1]))
}

/// One row of pixels, stretched.
fn bar(top: f64, name: &str, pixels: &Array3<u8>) -> Result<String> {
    Ok(format!(
        r#"<image href="{}" x="{LEFT}" y="{}" width="{}" height="{BAR}" preserveAspectRatio="none" style="image-rendering:pixelated"/><text class="small" x="{}" y="{}" text-anchor="end">{name}</text>"#,
        data_uri(&encode_png(pixels)?),
        at(top),
        at(WIDTH - RIGHT - LEFT),
        at(LEFT - 6.0),
        at(top + 0.5 * BAR + 4.0),
    ))
}

/// As the eye would see it at an exposure for all but the brightest angles.
fn seen(strip: &Strip) -> Array3<u8> {
    let mut sorted: Vec<f64> = luminance(strip).collect();
    sorted.sort_by(f64::total_cmp);
    let white = sorted[((sorted.len() - 1) as f64 * EXPOSED) as usize].max(f64::from(f32::MIN_POSITIVE));
    to_srgb8(&row(strip, |_| 1.0), (1.0 / white) as f32)
}

/// Hues as they are; brightness by its logarithm.
fn lifted(strip: &Strip, peak: f64) -> Array3<u8> {
    let lift = |luminance: f64| {
        let share = (1.0 + (luminance / peak).log10() / DECADES as f64).clamp(0.0, 1.0);
        // Evenly for the eye, whose lightness grows about as the square root.
        if luminance > 0.0 { share * share / luminance } else { 0.0 }
    };
    to_srgb8(&row(strip, lift), 1.0)
}

fn row(strip: &Strip, factor: impl Fn(f64) -> f64) -> Array3<f32> {
    Array3::from_shape_fn((1, strip.xyz.len(), 3), |(_, column, c)| {
        let xyz = strip.xyz[column];
        (f64::from(xyz[c]) * factor(f64::from(xyz[1]))) as f32
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn strip(values: &[[f32; 3]]) -> Strip {
        Strip { set_up: SetUp::NormalIncidence, plane: Plane::Xz, first_deg: -1, xyz: values.to_vec() }
    }

    #[test]
    fn a_bar_shows_what_is_faint_and_keeps_its_hue() {
        let dim_red = [0.4125e-3, 0.2127e-3, 0.0193e-3];
        let white = [0.95, 1.0, 1.09];
        let strip = strip(&[[0.0; 3], white, dim_red, white]);
        let lifted = lifted(&strip, 1.0);
        let pixel = |column: usize| [0, 1, 2].map(|c| lifted[[0, column, c]]);
        assert_eq!(pixel(0), [0; 3]);
        assert!(pixel(2)[0] > 100 && pixel(2)[1] < 5 && pixel(2)[2] < 5, "{:?}", pixel(2));
        assert!(seen(&strip)[[0, 2, 0]] < pixel(2)[0]);
    }

    #[test]
    fn dark_strips_are_drawn_too() {
        let svg = strip_plot(&strip(&[[0.0; 3]; 3])).unwrap();
        assert!(svg.starts_with("<svg") && !svg.contains("NaN"), "{svg}");
    }
}
