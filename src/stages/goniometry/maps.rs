//! Maps of the radiance factor over all viewing directions, for some directions of the light.

use std::path::Path;

use ndarray::{Array3, Axis};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::instrument::Instrument;
use diffraction_brdf::Footprint;
use diffraction_brdf::direction::from_angles_deg;
use diffraction_brdf::error::Result;
use diffraction_build::ground::colour::{auto_exposure, to_srgb8};
use diffraction_render::render::png_image::write_png;

/// Polar angles of the light in degrees; it lies towards +x.
const LIGHTS_DEG: [f64; 2] = [0.0, 45.0];

/// Pixels along a map's side: odd, so that one stands for the normal.
pub(super) const SIZE_PX: usize = 257;

/// The sun's angular diameter in degrees.
const SUN_DEG: f64 = 0.53;

/// A map and what its colours mean.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReflectionMap {
    /// Path of the PNG: direction cosines along x and y from -1 to 1, +y up, black outside the disc.
    pub png: String,
    /// Polar angle of the light in degrees; it lies in the x-z plane, on the side of +x.
    pub light_theta_deg: f64,
    /// Radiance factor that is shown as white.
    pub white_level: f64,
}

/// The maps with their values, XYZ of the radiance factor `[SIZE_PX, SIZE_PX, 3]`; their pictures go into the folder.
pub(super) fn maps(instrument: &Instrument, folder: &Path, name: &str) -> Result<Vec<(ReflectionMap, Array3<f32>)>> {
    LIGHTS_DEG
        .into_iter()
        .map(|light_theta_deg| {
            let image = map(instrument, light_theta_deg)?;
            let exposure = auto_exposure(&image);
            let file = format!("reflection_{light_theta_deg:02}deg.png");
            write_png(&folder.join(&file), &to_srgb8(&image, exposure))?;
            let white_level = 1.0 / f64::from(exposure);
            Ok((ReflectionMap { png: format!("{name}/{file}"), light_theta_deg, white_level }, image))
        })
        .collect()
}

/// Direction cosine at the middle of a pixel.
pub(super) fn cosine_at(pixel: usize) -> f64 {
    (2.0 * pixel as f64 + 1.0) / SIZE_PX as f64 - 1.0
}

/// Each pixel averaged over itself and over the sun.
fn map(instrument: &Instrument, light_theta_deg: f64) -> Result<Array3<f32>> {
    let wi = from_angles_deg(light_theta_deg, 0.0);
    let variance = (2.0 / SIZE_PX as f64).powi(2) / 12.0;
    let footprint = Footprint::of_light(wi, SUN_DEG)? + Footprint::new(variance, 0.0, variance)?;
    let mut image = Array3::zeros((SIZE_PX, SIZE_PX, 3));
    image.axis_iter_mut(Axis(0)).into_par_iter().enumerate().for_each(|(row, mut pixels)| {
        let y = -cosine_at(row);
        for (column, mut pixel) in pixels.outer_iter_mut().enumerate() {
            let x = cosine_at(column);
            let cos_squared = 1.0 - x * x - y * y;
            if cos_squared > 0.0 {
                let xyz = instrument.averaged(wi, [x, y, cos_squared.sqrt()], footprint);
                pixel.iter_mut().zip(xyz).for_each(|(channel, value)| *channel = value as f32);
            }
        }
    });
    Ok(image)
}
