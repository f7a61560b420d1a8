//! The hemisphere of viewing directions: a map of the BRDF for one direction of light.

use super::light::LightSample;
use super::row::{RowSamples, push};

/// Samples of the pixel centred at `(x, y)`, which stands for the viewing direction with those direction
/// cosines; none outside the unit disc. The value is `f` itself in 1/sr, averaged over the
/// light's disc and the pixel: weights sum to 1, without cosine or irradiance.
pub(crate) fn gather_pixel(lights: &[LightSample], pixel_width: f64, [x, y]: [f64; 2], out: &mut RowSamples) {
    let weight = 1.0 / lights.len() as f64;
    for light in lights {
        let [dx, dy] = light.pixel_offset;
        let (u, v) = (x + dx * pixel_width, y + dy * pixel_width);
        let cos_squared = 1.0 - u * u - v * v;
        if cos_squared > 0.0 {
            push(out, light.direction, [u, v, cos_squared.sqrt()], weight);
        }
    }
}
