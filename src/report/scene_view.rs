//! Scenes in the report: pictures from the tables and from the reference, their difference, numbers.

use minijinja::{Value, context};

use crate::report::embed::Album;
use crate::report::numbers;
use crate::stages::results::{SceneResult, SharedSceneResult};
use diffraction_brdf::error::Result;

/// What the template needs of a scene.
pub(crate) fn scene_view(scene: &SceneResult, album: &mut Album) -> Result<Value> {
    let mut optional = |path: &Option<String>, alt: &str| -> Result<Option<Value>> {
        path.as_ref().map(|path| Ok(Value::from_safe_string(album.linked_img(path, alt)?))).transpose()
    };
    let side_by_side = optional(&scene.side_by_side_png, "Tables and reference side by side")?;
    let animation = optional(&scene.animation_png, "Animation")?;
    let difference = optional(&scene.difference_png, "Difference from the reference")?;
    let table = Value::from_safe_string(album.linked_img(&scene.table_png, &format!("Scene {}", scene.name))?);
    let error = scene.error.as_ref();
    let cell = |value: Option<f64>, show: &dyn Fn(f64) -> String| value.map_or_else(|| numbers::MISSING.into(), show);
    let delta = |value: f64| numbers::number(value, 2);
    let pixels = error.map_or_else(|| numbers::MISSING.into(), |error| numbers::count(error.pixels as u64));
    Ok(context! {
        name => &scene.name,
        about => format!(
            "{}, {}{}{} × {} pixels, exposure {} stops",
            scene.shape,
            scene.light,
            if scene.light.is_empty() { "" } else { ", " },
            scene.size_px[0],
            scene.size_px[1],
            stops(scene.exposure)
        ),
        table => table,
        side_by_side => side_by_side,
        difference => difference,
        animation => animation,
        animation_text => scene.animation.clone().unwrap_or_default(),
        difference_scale => scene.difference_scale.clone().unwrap_or_default(),
        pixels => pixels.clone(),
        agreement => error.map_or_else(String::new, |error| {
            format!("95 of 100 are within ΔE₀₀ {}, the worst is {}.", delta(error.ciede2000_p95), delta(error.ciede2000_max))
        }),
        cells => vec![
            cell(error.map(|error| error.relative_l2), &numbers::percent),
            cell(error.map(|error| error.ciede2000_mean), &delta),
            cell(error.map(|error| error.ciede2000_p95), &delta),
            cell(error.map(|error| error.ciede2000_max), &delta),
            pixels,
            numbers::seconds(scene.seconds),
        ],
    })
}

/// An exposure in stops: 0 shows a white diffuser that faces a light of unit irradiance as white.
fn stops(exposure: f64) -> String {
    let stops = (exposure / std::f64::consts::PI).log2();
    if !stops.is_finite() {
        return numbers::MISSING.into();
    }
    let sign = if stops < 0.0 { "−" } else { "+" };
    format!("{sign}{:.1}", stops.abs())
}

/// What it needs of a scene that several specimens share.
pub(crate) fn shared_view(shared: &SharedSceneResult, album: &mut Album) -> Result<Value> {
    Ok(context! { specimens => shared.specimens.join(", "), scene => scene_view(&shared.picture, album)? })
}
