//! Perceptually even colour maps for pictures of data.

/// Sixteen even steps of a colour map, sRGB; linear in between.
pub(crate) type ColourMap = [[u8; 3]; 16];

/// Viridis (van der Walt and Smith, 2015, public domain): for heights.
pub(crate) const VIRIDIS: ColourMap = [
    [0x44, 0x01, 0x54],
    [0x48, 0x1a, 0x6c],
    [0x47, 0x2f, 0x7d],
    [0x41, 0x44, 0x87],
    [0x39, 0x56, 0x8c],
    [0x31, 0x68, 0x8e],
    [0x2a, 0x78, 0x8e],
    [0x23, 0x88, 0x8e],
    [0x1f, 0x98, 0x8b],
    [0x22, 0xa8, 0x84],
    [0x35, 0xb7, 0x79],
    [0x54, 0xc5, 0x68],
    [0x7a, 0xd1, 0x51],
    [0xa5, 0xdb, 0x36],
    [0xd2, 0xe2, 0x1b],
    [0xfd, 0xe7, 0x25],
];

/// Inferno (van der Walt and Smith, 2015, public domain): for power.
pub(crate) const INFERNO: ColourMap = [
    [0x00, 0x00, 0x04],
    [0x0c, 0x08, 0x26],
    [0x24, 0x0c, 0x4f],
    [0x42, 0x0a, 0x68],
    [0x5d, 0x12, 0x6e],
    [0x78, 0x1c, 0x6d],
    [0x93, 0x26, 0x67],
    [0xae, 0x30, 0x5c],
    [0xc7, 0x3e, 0x4c],
    [0xdd, 0x51, 0x3a],
    [0xed, 0x69, 0x25],
    [0xf8, 0x85, 0x0f],
    [0xfc, 0xa5, 0x0a],
    [0xfa, 0xc6, 0x2d],
    [0xf2, 0xe6, 0x61],
    [0xfc, 0xff, 0xa4],
];

/// Colours that pictures take of a map: with grey and the colours of marks few enough for a PNG with a palette, a third of one without.
const SHADES: usize = 240;

/// The nearest of [`SHADES`] even steps to `position`, 0 for the first colour and 1 for the last; held at the ends. NaN gives grey,
/// which neither map contains.
pub fn colour(map: &ColourMap, position: f64) -> [u8; 3] {
    if position.is_nan() {
        return [128, 128, 128];
    }
    let last = (SHADES - 1) as f64;
    let step = (position.clamp(0.0, 1.0) * last).round() / last;
    let place = step * (map.len() - 1) as f64;
    let below = (place as usize).min(map.len() - 2);
    let share = place - below as f64;
    std::array::from_fn(|channel| {
        let (low, high) = (f64::from(map[below][channel]), f64::from(map[below + 1][channel]));
        (low + share * (high - low)).round() as u8
    })
}

/// A bar of a map's colours from its first on the left to its last, as HTML.
pub(crate) fn css_ramp(map: &ColourMap) -> String {
    let stops: Vec<String> = map.iter().map(|[r, g, b]| format!("#{r:02x}{g:02x}{b:02x}")).collect();
    format!(r#"<span class="ramp" style="background:linear-gradient(to right,{})"></span>"#, stops.join(","))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn luminance(rgb: [u8; 3]) -> f64 {
        let linear = |value: u8| (f64::from(value) / 255.0).powf(2.2);
        0.2126 * linear(rgb[0]) + 0.7152 * linear(rgb[1]) + 0.0722 * linear(rgb[2])
    }

    #[test]
    fn brightness_rises_all_along() {
        for map in [&VIRIDIS, &INFERNO] {
            let steps: Vec<f64> = (0..=60).map(|i| luminance(colour(map, f64::from(i) / 60.0))).collect();
            assert!(steps.windows(2).all(|pair| pair[1] > pair[0]), "{steps:?}");
        }
    }

    #[test]
    fn ends_and_outside() {
        assert_eq!(colour(&VIRIDIS, 0.0), VIRIDIS[0]);
        assert_eq!(colour(&VIRIDIS, -3.0), VIRIDIS[0]);
        assert_eq!(colour(&VIRIDIS, 1.0), VIRIDIS[15]);
        assert_eq!(colour(&VIRIDIS, f64::INFINITY), VIRIDIS[15]);
        assert_eq!(colour(&VIRIDIS, f64::NAN), [128, 128, 128]);
    }
}
