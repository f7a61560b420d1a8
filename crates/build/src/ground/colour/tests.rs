//! Checks of display colour against `palette` and against what the mapping promises.

use palette::{Lch, LinSrgb, Oklab, Srgb, convert::FromColorUnclamped, white_point::D65};
use proptest::prelude::*;

use super::*;

/// Colour matching functions of the CIE 1931 observer at a few wavelengths: spectral colours, all
/// outside sRGB.
const SPECTRAL: [(f64, Xyz); 9] = [
    (400.0, [0.01431, 0.000396, 0.06785]),
    (440.0, [0.34828, 0.023, 1.74706]),
    (470.0, [0.19536, 0.09098, 1.28764]),
    (490.0, [0.03201, 0.20802, 0.46518]),
    (520.0, [0.06327, 0.71, 0.07825]),
    (550.0, [0.43345, 0.99495, 0.00875]),
    (580.0, [0.9163, 0.87, 0.00165]),
    (610.0, [1.0026, 0.503, 0.00034]),
    (680.0, [0.04677, 0.017, 0.0]),
];

/// Oklab by the other implementation.
fn oklab(rgb: LinearRgb) -> [f64; 3] {
    let lab: Oklab<f64> = Oklab::from_color_unclamped(LinSrgb::new(rgb[0], rgb[1], rgb[2]));
    [lab.l, lab.a, lab.b]
}

/// Angle between the Oklab hues of two colours in degrees.
fn hue_change_deg(before: LinearRgb, after: LinearRgb) -> f64 {
    let (p, q) = (oklab(before), oklab(after));
    let sine = p[1] * q[2] - p[2] * q[1];
    let cosine = p[1] * q[1] + p[2] * q[2];
    sine.atan2(cosine).abs().to_degrees()
}

fn chroma(rgb: LinearRgb) -> f64 {
    let [_, a, b] = oklab(rgb);
    a.hypot(b)
}

#[test]
fn matrices_agree_with_palette() {
    for (_, xyz) in SPECTRAL {
        let theirs: LinSrgb<f64> = LinSrgb::from_color_unclamped(palette::Xyz::<D65, f64>::new(xyz[0], xyz[1], xyz[2]));
        let ours = xyz_to_linear_srgb(xyz);
        // Both derive the matrix from primaries published to four digits; entries are below 4.
        for (a, b) in ours.iter().zip([theirs.red, theirs.green, theirs.blue]) {
            assert!((a - b).abs() < 2e-3 * xyz[1].max(xyz[2]).max(xyz[0]), "{a} {b}");
        }
        for (back, given) in apply(&XYZ_FROM_RGB, ours).iter().zip(xyz) {
            assert!((back - given).abs() < 1e-6);
        }
    }
}

#[test]
fn transfer_function_agrees_with_palette() {
    for step in 0..=1000 {
        let linear = f64::from(step) / 1000.0;
        let theirs: Srgb<f64> = Srgb::from_linear(LinSrgb::new(linear, linear, linear));
        // The standard's two pieces meet only to 1e-7 or so, depending on the rounding of constants.
        assert!((srgb_encode(linear) - theirs.red).abs() < 1e-6);
        assert!((srgb_decode(srgb_encode(linear)) - linear).abs() < 1e-6);
    }
}

#[test]
fn every_8_bit_grey_survives_the_round_trip() {
    for code in 0..=255u8 {
        let linear = srgb_decode(f64::from(code) / 255.0);
        let white = apply(&XYZ_FROM_RGB, [linear; 3]).map(|c| c as f32);
        if linear > HIGHLIGHT_START {
            continue;
        }
        assert_eq!(pixel_to_srgb8(white, 1.0), [code; 3]);
        assert_eq!(pixel_to_srgb8(white.map(|c| c * 0.25), 4.0), [code; 3]);
    }
}

#[test]
fn spectral_colours_keep_luminance_and_hue() {
    for (wavelength_nm, xyz) in SPECTRAL {
        let rgb = xyz_to_linear_srgb(xyz);
        assert!(rgb.iter().any(|&c| c < 0.0), "{wavelength_nm} nm lies in gamut");
        let mapped = desaturate_into_gamut(rgb);
        assert!(mapped.iter().all(|&c| c >= 0.0));
        assert!((luminance(mapped) / luminance(rgb) - 1.0).abs() < 1e-9);
        // palette's Oklab constants carry ten digits; the cube roots of small cone responses
        // amplify that to some 1e-6 of the chroma.
        let hue = hue_change_deg(rgb, mapped);
        assert!(hue < 0.01, "{wavelength_nm} nm turned by {hue} degrees");
        // On the gamut's surface: the smallest channel is zero, so saturation was not wasted.
        let smallest = mapped.iter().copied().fold(f64::INFINITY, f64::min);
        assert!(smallest < 1e-9 * luminance(rgb));
    }
}

#[test]
fn clipping_channels_would_fail_the_hue_bound() {
    let worst = SPECTRAL
        .iter()
        .map(|(_, xyz)| {
            let rgb = xyz_to_linear_srgb(*xyz);
            hue_change_deg(rgb, rgb.map(|c| c.max(0.0)))
        })
        .fold(0.0, f64::max);
    assert!(worst > 5.0, "clipping turned the hue by {worst} degrees only");
}

#[test]
fn a_bright_blue_pales_without_turning() {
    let blue = desaturate_into_gamut(xyz_to_linear_srgb(SPECTRAL[1].1));
    let bright = blue.map(|c| 20.0 * c);
    let shown = compress_highlights(bright);
    assert!(hue_change_deg(bright, shown) < 0.01);
    let saturation = |rgb| chroma(rgb) / oklab(rgb)[0];
    assert!(saturation(shown) < 0.9 * saturation(compress_highlights(blue)));
}

#[test]
fn brighter_light_never_looks_darker() {
    for (_, xyz) in SPECTRAL {
        let mut last = 0.0;
        for step in 0..200 {
            let exposure = 1e-2 * 1.08f64.powi(step);
            let shown = luminance(display_rgb(xyz, exposure));
            assert!(shown >= last - 1e-12, "at exposure {exposure}");
            last = shown;
        }
    }
}

#[test]
fn broken_pixels_are_marked() {
    assert_eq!(pixel_to_srgb8([f32::NAN, 0.0, 0.0], 1.0), NOT_FINITE_RGB8);
    assert_eq!(pixel_to_srgb8([0.0, f32::INFINITY, 0.0], 1.0), NOT_FINITE_RGB8);
    assert_eq!(pixel_to_srgb8([0.0; 3], 1.0), [0; 3]);
    assert_eq!(pixel_to_srgb8([-1.0, -1.0, 3.0], 1.0), [0; 3]);
    let largest = pixel_to_srgb8([f32::MAX; 3], f32::MAX);
    assert_ne!(largest, NOT_FINITE_RGB8);
}

#[test]
fn automatic_exposure_is_the_reciprocal_quantile_of_lit_pixels() {
    let mut image = Array3::zeros((50, 40, 3));
    // 1000 lit pixels with Y = 1 .. 1000 among 2000: the 99.5th percentile is 995.
    for (index, value) in (0..1000).zip((1..=1000).rev()) {
        image[[index / 40, index % 40, 1]] = value as f32;
    }
    assert_eq!(auto_exposure(&image), 1.0 / 995.0);
    assert_eq!(auto_exposure(&Array3::zeros((3, 3, 3))), 1.0);
    assert!(auto_exposure(&Array3::from_elem((2, 2, 3), 1e-42)).is_finite());
}

#[test]
fn pale_colour_is_less_saturated_in_cielab_too() {
    let lab =
        |rgb: LinearRgb| -> f64 { Lch::<D65, f64>::from_color_unclamped(LinSrgb::new(rgb[0], rgb[1], rgb[2])).chroma };
    let rgb = xyz_to_linear_srgb(SPECTRAL[4].1);
    assert!(lab(desaturate_into_gamut(rgb)) < lab(rgb));
}

proptest! {
    #[test]
    fn colours_in_gamut_are_unchanged(r in 0.0..0.8f64, g in 0.0..0.8f64, b in 0.0..0.8f64) {
        let rgb = [r, g, b];
        prop_assert_eq!(compress_highlights(desaturate_into_gamut(rgb)), rgb);
    }

    #[test]
    fn display_is_always_inside(x in -1.0..50.0f64, y in -1.0..50.0f64, z in -1.0..50.0f64) {
        let rgb = display_rgb([x, y, z], 1.0);
        prop_assert!(rgb.iter().all(|c| (0.0..=1.0).contains(c)), "{:?}", rgb);
    }

    /// Any light is a positive mixture of spectral colours.
    #[test]
    fn mixtures_keep_luminance_and_hue(parts in proptest::array::uniform9(0.0..1.0f64)) {
        let mut xyz = [0.0; 3];
        for ((_, colour), part) in SPECTRAL.iter().zip(parts) {
            for (sum, c) in xyz.iter_mut().zip(colour) {
                *sum += part.powi(6) * c;
            }
        }
        let rgb = xyz_to_linear_srgb(xyz);
        let mapped = desaturate_into_gamut(rgb);
        prop_assert!((luminance(mapped) - luminance(rgb)).abs() <= 1e-9 * luminance(rgb));
        let shown = compress_highlights(mapped);
        // Close to grey the hue is not defined; 1e-4 of chroma is invisible.
        if chroma(shown) > 1e-4 {
            prop_assert!(hue_change_deg(rgb, mapped) < 0.01);
            prop_assert!(hue_change_deg(mapped, shown) < 0.01);
        }
        // The brightest channel never rises and stays displayable. Luminance itself may rise a little just
        // above the shoulder, where paling mixes in white faster than the roll-off dims.
        let peak = |rgb: LinearRgb| rgb[0].max(rgb[1]).max(rgb[2]);
        prop_assert!(peak(shown) <= peak(mapped) * (1.0 + 1e-12) && peak(shown) < 1.0);
    }
}
