//! Which colours a specimen shows from which angles, as part of its section of the report.

use minijinja::{Value, context};
use ndarray::Array3;

use crate::report::axes::{Axis, level_lines, marks_below, polyline, ticks_in_powers, title_below};
use crate::report::embed::{Album, missing};
use crate::report::map_frames::map_frame;
use crate::report::numbers;
use crate::report::strip_plots::{plane_text, set_up_text, strip_plot};
use crate::report::svg::{at, escape};
use crate::stages::goniometry::{BrightDirection, Goniometry, SetUp, Strip};
use crate::stages::results::Period;
use diffraction_brdf::error::Result;
use diffraction_build::ground::colour::to_srgb8;

/// Luminance that patches of colour are shown at, white being 1: spectral colours keep their hue there.
const PATCH_LUMINANCE: f64 = 0.35;

/// What the template needs.
pub(crate) fn view(found: &Goniometry, periods: &[Period], album: &mut Album) -> Result<Value> {
    let maps = found.maps.iter().map(|map| {
        let frame = match album.picture(&map.png)? {
            Some(picture) => map_frame(&picture.href, map, periods),
            None => missing(&map.png),
        };
        Ok(context! {
            frame => Value::from_safe_string(frame),
            light => match map.light_theta_deg {
                0.0 => "from straight above".to_string(),
                angle => format!("{angle}° from the normal, towards +x"),
            },
            white => numbers::number(map.white_level, 2),
        })
    });
    let maps = maps.collect::<Result<Vec<_>>>()?;
    let of = |strips: Vec<&Strip>| strips.into_iter().map(strip_view).collect::<Result<Vec<_>>>();
    let (normal, others): (Vec<&Strip>, Vec<&Strip>) =
        found.strips.iter().partition(|strip| strip.set_up == SetUp::NormalIncidence);
    Ok(context! {
        sentence => &found.sentence,
        acceptance => numbers::round_number(found.acceptance_deg, 2),
        maps => maps,
        strips => of(normal)?,
        others => of(others)?,
        bright => found.brightest.iter().enumerate().map(|(index, direction)| bright_view(index, direction)).collect::<Vec<_>>(),
    })
}

fn strip_view(strip: &Strip) -> Result<Value> {
    Ok(context! {
        plot => Value::from_safe_string(strip_plot(strip)?),
        plane => plane_text(strip.plane),
        set_up => set_up_text(strip.set_up),
    })
}

fn bright_view(index: usize, direction: &BrightDirection) -> Value {
    let hue = direction.hue.as_ref();
    let dash = || numbers::MISSING.to_string();
    context! {
        place => place(index, direction),
        patch => patch(direction.xyz),
        factor => numbers::number(direction.xyz[1], 3),
        name => hue.map_or_else(dash, |hue| hue.name()),
        xy => hue.map_or_else(dash, |hue| format!("{:.3}, {:.3}", hue.xy[0], hue.xy[1])),
        dominant => hue.and_then(|hue| hue.dominant_nm).map_or_else(dash, |nm| match nm < 0.0 {
            true => format!("opposite {:.0}\u{a0}nm", -nm),
            false => format!("{nm:.0}\u{a0}nm"),
        }),
        purity => hue.map_or_else(dash, |hue| numbers::percent(hue.purity)),
        spectrum => (!direction.wavelength_nm.is_empty()).then(|| Value::from_safe_string(spectrum(direction))),
    }
}

fn place(index: usize, direction: &BrightDirection) -> String {
    match index {
        0 => "mirror direction".into(),
        // Adding zero turns a rounded −0 into 0.
        _ => format!("θ {:.1}°, φ {:.0}°", direction.theta_deg, direction.phi_deg.round() + 0.0),
    }
}

/// CSS colour of a patch with this colour's hue.
fn patch(xyz: [f64; 3]) -> String {
    let factor = if xyz[1] > 0.0 { PATCH_LUMINANCE / xyz[1] } else { 0.0 };
    let pixel = to_srgb8(&Array3::from_shape_fn((1, 1, 3), |(_, _, c)| (xyz[c] * factor) as f32), 1.0);
    format!("#{:02x}{:02x}{:02x}", pixel[[0, 0, 0]], pixel[[0, 0, 1]], pixel[[0, 0, 2]])
}

/// The radiance factor over the wavelength, drawn for a quarter of the page's width.
fn spectrum(direction: &BrightDirection) -> String {
    let nm = &direction.wavelength_nm;
    let (across, [top, bottom]) = ([44.0, 250.0], [8.0, 128.0]);
    let x = Axis::linear([nm[0], nm[nm.len() - 1]], across);
    let high = direction.radiance_factor.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    let y = Axis::linear([0.0, 1.05 * high], [bottom, top]);
    let (ticks, factor) = ticks_in_powers([0.0, 1.05 * high], 3);
    let mut body = level_lines(&y, &ticks, across, "grid");
    body += &marks_below(&x, &x.ticks(4), bottom);
    body += &title_below(&format!("wavelength in nm{factor}"), across, bottom);
    let points = nm.iter().copied().zip(direction.radiance_factor.iter().copied());
    body += &polyline(points, &x, &y, "stroke:currentColor;stroke-width:1.6");
    let label = format!("Spectrum at {:.1} degrees, azimuth {:.0}", direction.theta_deg, direction.phi_deg);
    format!(
        r#"<svg class="plot" viewBox="0 0 256 {}" role="img" aria-label="{}">{body}</svg>"#,
        at(bottom + 40.0),
        escape(&label)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_patch_has_the_hue_at_one_brightness() {
        let red = |scale: f64| patch([0.4125 * scale, 0.2127 * scale, 0.0193 * scale]);
        assert_eq!(red(1e-4), red(1e4));
        assert!(red(1.0).starts_with("#f") && patch([0.0; 3]) == "#000000", "{}", red(1.0));
    }
}
