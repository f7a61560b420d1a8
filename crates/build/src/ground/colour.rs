//! Display colour: XYZ to sRGB, spectral colours brought into gamut, highlights compressed.
//!
//! The chain of [`to_srgb8`], all of it per pixel and in the order given:
//!
//! 1. XYZ times the exposure, then linear sRGB (Rec. 709 primaries, D65 white; no chromatic
//!    adaptation, so a scene lit by illuminant A looks as orange as it is).
//! 2. Desaturation into the gamut: diffraction makes colours no display can show. Those get the
//!    largest saturation that fits at the same Oklab hue and the same luminance.
//! 3. Compression of highlights: channels above `HIGHLIGHT_START`, 0.8, are rolled off towards 1, again
//!    at constant hue; very bright colours turn pale as they do on film.
//! 4. The sRGB transfer function and rounding to 8 bits, without dither.
//!
//! Colours whose channels all lie in `[0, HIGHLIGHT_START]` pass unchanged through 2 and 3.

use ndarray::{Array3, Axis};
use rayon::prelude::*;

use diffraction_brdf::direction::Xyz;

/// Linear sRGB, 1 being the display's white; may lie outside [0, 1] before gamut mapping.
pub(crate) type LinearRgb = [f64; 3];

/// Linear channel value from which highlights are compressed; below it display is exact.
pub(crate) const HIGHLIGHT_START: f64 = 0.8;

/// How fast compressed highlights pale: the value of the Khronos PBR Neutral tone mapper.
const HIGHLIGHT_PALING: f64 = 0.15;

/// Share of the lit pixels that the automatic exposure keeps at or below white.
const AUTO_EXPOSURE_QUANTILE: f64 = 0.995;

/// Marks pixels whose value is not finite, so that a broken evaluation cannot pass for black.
pub const NOT_FINITE_RGB8: [u8; 3] = [255, 0, 255];

type Matrix = [[f64; 3]; 3];

/// IEC 61966-2-1 primaries and white.
const RGB_FROM_XYZ: Matrix = [
    [3.240_454_2, -1.537_138_5, -0.498_531_4],
    [-0.969_266_0, 1.876_010_8, 0.041_556_0],
    [0.055_643_4, -0.204_025_9, 1.057_225_2],
];

const XYZ_FROM_RGB: Matrix = [
    [0.412_456_4, 0.357_576_1, 0.180_437_5],
    [0.212_672_9, 0.715_152_2, 0.072_175_0],
    [0.019_333_9, 0.119_192_0, 0.950_304_1],
];

/// Oklab's cone responses of linear sRGB (B. Ottosson, "A perceptual color space for image
/// processing", 2020, constants of 2021).
const LMS_FROM_RGB: Matrix = [
    [0.412_221_470_8, 0.536_332_536_3, 0.051_445_992_9],
    [0.211_903_498_2, 0.680_699_545_1, 0.107_396_956_6],
    [0.088_302_461_9, 0.281_718_837_6, 0.629_978_700_5],
];

const RGB_FROM_LMS: Matrix = [
    [4.076_741_662_1, -3.307_711_591_3, 0.230_969_929_2],
    [-1.268_438_004_6, 2.609_757_401_1, -0.341_319_396_5],
    [-0.004_196_086_3, -0.703_418_614_7, 1.707_614_701_0],
];

/// Rows give L, a, b from the cube roots of the cone responses.
const LAB_FROM_ROOTS: Matrix = [
    [0.210_454_255_3, 0.793_617_785_0, -0.004_072_046_8],
    [1.977_998_495_1, -2.428_592_205_0, 0.450_593_709_9],
    [0.025_904_037_1, 0.782_771_766_2, -0.808_675_766_0],
];

/// The a and b columns of the inverse; its L column is 1 throughout.
const ROOTS_FROM_AB: [[f64; 2]; 3] =
    [[0.396_337_777_4, 0.215_803_757_3], [-0.105_561_345_8, -0.063_854_172_8], [-0.089_484_177_5, -1.291_485_548_0]];

fn apply(matrix: &Matrix, v: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

/// Linear sRGB of a colour relative to a white of Y = 1.
pub fn xyz_to_linear_srgb(xyz: Xyz) -> LinearRgb {
    apply(&RGB_FROM_XYZ, xyz)
}

/// Relative luminance of linear sRGB.
pub fn luminance(rgb: LinearRgb) -> f64 {
    let row = XYZ_FROM_RGB[1];
    row[0] * rgb[0] + row[1] * rgb[1] + row[2] * rgb[2]
}

/// sRGB transfer function, linear to encoded, for [0, 1].
pub fn srgb_encode(linear: f64) -> f64 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055 }
}

/// Inverse of sRGB's transfer function.
pub fn srgb_decode(encoded: f64) -> f64 {
    if encoded <= 0.040_45 { encoded / 12.92 } else { libm::pow((encoded + 0.055) / 1.055, 2.4) }
}

/// A colour as a point on a ray of constant Oklab hue. With the saturation `s = C / L` (Oklab chroma over
/// lightness) the roots of the cone responses are `L (1 + s k)`, so the colours of one hue
/// and one luminance are a cubic in `s` divided by its own luminance: no search for L is needed.
struct HueRay {
    /// `k`: change of each root with the saturation.
    slope: [f64; 3],
    saturation: f64,
}

/// `None` for a grey and for colours outside Oklab's domain (lightness not positive).
fn hue_ray(rgb: LinearRgb) -> Option<HueRay> {
    let roots = apply(&LMS_FROM_RGB, rgb).map(libm::cbrt);
    let [lightness, a, b] = apply(&LAB_FROM_ROOTS, roots);
    let chroma = libm::hypot(a, b);
    if lightness <= 0.0 || chroma <= 0.0 {
        return None;
    }
    Some(HueRay {
        slope: ROOTS_FROM_AB.map(|[from_a, from_b]| (from_a * a + from_b * b) / chroma),
        saturation: chroma / lightness,
    })
}

/// The ray's colour at a saturation, at Oklab lightness 1.
fn on_ray(ray: &HueRay, saturation: f64) -> LinearRgb {
    let cubes = ray.slope.map(|k| {
        let root = 1.0 + saturation * k;
        root * root * root
    });
    apply(&RGB_FROM_LMS, cubes)
}

/// A colour with no negative channel: the given one, or else the most saturated one of the same
/// Oklab hue and the same luminance. Without luminance it is black.
pub(crate) fn desaturate_into_gamut(rgb: LinearRgb) -> LinearRgb {
    if rgb.iter().all(|&c| c >= 0.0) {
        return rgb;
    }
    let target = luminance(rgb);
    if target <= 0.0 {
        return [0.0; 3];
    }
    let Some(ray) = hue_ray(rgb) else {
        return [target; 3];
    };
    // Grey (saturation 0) is inside and the colour is outside, so a bisection that keeps its lower
    // end inside ends on the gamut's surface; 50 halvings exhaust the precision.
    let (mut inside, mut outside) = (0.0, ray.saturation);
    for _ in 0..50 {
        let middle = 0.5 * (inside + outside);
        if on_ray(&ray, middle).iter().all(|&c| c >= 0.0) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    with_luminance(on_ray(&ray, inside), target)
}

fn with_luminance(rgb: LinearRgb, target: f64) -> LinearRgb {
    let scale = target / luminance(rgb);
    rgb.map(|c| c * scale)
}

/// Rolls channels above [`HIGHLIGHT_START`] off towards 1 at constant Oklab hue.
///
/// The shoulder and the paling are those of the Khronos PBR Neutral tone mapper (2024): the
/// largest channel `p` becomes `p' = 1 - d² / (p + d - start)` with `d = 1 - start`, and the
/// saturation shrinks by `1 / (1 + 0.15 (p - p'))`. There the paling mixes white in linear RGB,
/// which turns blues purple; here it moves along constant hue. Expects channels >= 0.
pub(crate) fn compress_highlights(rgb: LinearRgb) -> LinearRgb {
    let peak = rgb[0].max(rgb[1]).max(rgb[2]);
    if peak <= HIGHLIGHT_START {
        return rgb;
    }
    let d = 1.0 - HIGHLIGHT_START;
    let new_peak = 1.0 - d * d / (peak + d - HIGHLIGHT_START);
    let kept = 1.0 / (1.0 + HIGHLIGHT_PALING * (peak - new_peak));
    let paled = match hue_ray(rgb) {
        Some(ray) => on_ray(&ray, ray.saturation * kept),
        None => rgb,
    };
    let scale = new_peak / paled[0].max(paled[1]).max(paled[2]);
    paled.map(|c| (c * scale).clamp(0.0, 1.0))
}

/// What a display shows of an XYZ value: linear sRGB in [0, 1]. The input must be finite.
pub(crate) fn display_rgb(xyz: Xyz, exposure: f64) -> LinearRgb {
    let exposed = xyz.map(|c| c * exposure);
    compress_highlights(desaturate_into_gamut(xyz_to_linear_srgb(exposed)))
}

/// 8-bit sRGB of an XYZ image `[rows, columns, 3]`; a white of luminance `1 / exposure` comes out
/// near white. Pixels that are not finite are [`NOT_FINITE_RGB8`].
pub fn to_srgb8(image: &Array3<f32>, exposure: f32) -> Array3<u8> {
    let (rows, columns, channels) = image.dim();
    assert_eq!(channels, 3, "an XYZ image has three channels");
    let mut out = Array3::zeros((rows, columns, 3));
    out.axis_iter_mut(Axis(0)).into_par_iter().zip(image.axis_iter(Axis(0))).for_each(|(mut out_row, row)| {
        for (mut pixel, xyz) in out_row.outer_iter_mut().zip(row.outer_iter()) {
            let rgb8 = pixel_to_srgb8([xyz[0], xyz[1], xyz[2]], exposure);
            for (channel, value) in pixel.iter_mut().zip(rgb8) {
                *channel = value;
            }
        }
    });
    out
}

fn pixel_to_srgb8(xyz: [f32; 3], exposure: f32) -> [u8; 3] {
    if !xyz.iter().all(|c| c.is_finite()) || !exposure.is_finite() {
        return NOT_FINITE_RGB8;
    }
    let rgb = display_rgb(xyz.map(f64::from), f64::from(exposure));
    rgb.map(|c| (255.0 * srgb_encode(c)).round() as u8)
}

/// The exposure that brings the 99.5th percentile of the luminance to 1, over the pixels whose
/// luminance is positive; 1 for an image without any.
pub fn auto_exposure(image: &Array3<f32>) -> f32 {
    let mut lit: Vec<f32> =
        image.index_axis(Axis(2), 1).iter().copied().filter(|y| y.is_finite() && *y > 0.0).collect();
    if lit.is_empty() {
        return 1.0;
    }
    let rank = (AUTO_EXPOSURE_QUANTILE * lit.len() as f64).ceil() as usize - 1;
    let (_, &mut quantile, _) = lit.select_nth_unstable_by(rank, f32::total_cmp);
    // The reciprocal of a subnormal luminance would overflow.
    (1.0 / quantile).min(f32::MAX)
}

#[cfg(test)]
mod tests;
