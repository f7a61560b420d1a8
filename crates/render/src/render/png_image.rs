//! PNG pictures: encoding, pictures side by side, error heat maps.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use ndarray::{Array2, Array3};

use diffraction_brdf::error::{Error, Result};
use diffraction_build::ground::colour::NOT_FINITE_RGB8;

/// Colour of heat-map pixels beyond the scale's end; occurs nowhere on the scale.
pub const BEYOND_SCALE_RGB8: [u8; 3] = [0, 255, 255];

/// Nine equidistant colours of matplotlib's "inferno" (lightness rises steadily; public domain).
const INFERNO: [[u8; 3]; 9] = [
    [0, 0, 4],
    [31, 12, 72],
    [85, 15, 109],
    [136, 34, 106],
    [186, 54, 85],
    [227, 89, 51],
    [249, 140, 10],
    [249, 201, 50],
    [252, 255, 164],
];

/// Bytes of an 8-bit sRGB PNG of an image `[rows, columns, 3]`, with a palette where its colours are no more than 256. No time stamp, so the same image
/// gives the same bytes. Fails on an image without pixels or wider than the format allows.
pub fn encode_png(image: &Array3<u8>) -> Result<Vec<u8>> {
    let (rows, columns, channels) = image.dim();
    assert_eq!(channels, 3, "an RGB image has three channels");
    let refuse = |why: String| {
        Error::limit(
            format!("a picture of {columns} x {rows} pixels cannot be a PNG: {why}"),
            "choose another size_px for the scene",
        )
    };
    let (Ok(width), Ok(height)) = (u32::try_from(columns), u32::try_from(rows)) else {
        return Err(refuse("its sides exceed 32 bits".into()));
    };
    let standard = image.as_standard_layout();
    let pixels = standard.as_slice().expect("standard layout is contiguous");
    let encoded = |kind: Kind, pixels: &[u8]| {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, width, height);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        match kind {
            Kind::Rgb => encoder.set_color(png::ColorType::Rgb),
            Kind::Indexed(palette) => {
                encoder.set_color(png::ColorType::Indexed);
                encoder.set_palette(palette.as_flattened());
                encoder.set_compression(png::Compression::High);
                // Neighbouring colours of a map have neighbouring numbers.
                encoder.set_filter(png::Filter::Paeth);
            }
        }
        let mut writer = encoder.write_header()?;
        writer.write_image_data(pixels)?;
        writer.finish()?;
        Ok(bytes)
    };
    let bytes = match indexed(pixels.as_chunks().0) {
        Some((palette, places)) => encoded(Kind::Indexed(&palette), &places),
        None => encoded(Kind::Rgb, pixels),
    };
    bytes.map_err(|error: png::EncodingError| refuse(error.to_string()))
}

/// How pixels are told.
enum Kind<'a> {
    /// By three bytes each.
    Rgb,
    /// By a byte each: the place of its colour among these.
    Indexed(&'a [[u8; 3]]),
}

/// Most colours of a palette.
const PALETTE_MAX: usize = 256;

/// The colours of an image from dark to bright, and the place of each pixel's; `None` where they are too many for a palette.
fn indexed(pixels: &[[u8; 3]]) -> Option<(Vec<[u8; 3]>, Vec<u8>)> {
    let mut colours = BTreeSet::new();
    for pixel in pixels {
        if colours.insert(*pixel) && colours.len() > PALETTE_MAX {
            return None;
        }
    }
    let mut palette: Vec<[u8; 3]> = colours.into_iter().collect();
    // Rec. 709's luma, in tenths of a per cent.
    palette.sort_by_key(|[r, g, b]| 213 * u32::from(*r) + 715 * u32::from(*g) + 72 * u32::from(*b));
    let places: BTreeMap<[u8; 3], u8> = palette.iter().copied().zip(0..=u8::MAX).collect();
    Some((palette, pixels.iter().map(|pixel| places[pixel]).collect()))
}

/// Bytes of an animated PNG of `frames` images `[rows, columns, 3]` of one size, shown for ever at `fps` frames per
/// second; programs that know no animation show the first. `image` gives each in turn, so that one is held at a time.
///
/// # Errors
/// Those of `image`, and images the format has no room for.
pub fn encode_animation(
    frames: usize,
    fps: u16,
    mut image: impl FnMut(usize) -> Result<Array3<u8>>,
) -> Result<Vec<u8>> {
    let first = image(0)?;
    let (rows, columns, _) = first.dim();
    let refuse = |why: String| {
        Error::limit(
            format!("{frames} frames of {columns} x {rows} pixels cannot be an animated PNG: {why}"),
            "choose another size_px or number of frames",
        )
    };
    let (Ok(width), Ok(height), Ok(count)) = (u32::try_from(columns), u32::try_from(rows), u32::try_from(frames))
    else {
        return Err(refuse("its numbers exceed 32 bits".into()));
    };
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let failed = |error: png::EncodingError| refuse(error.to_string());
    encoder.set_animated(count, 0).map_err(failed)?;
    encoder.set_frame_delay(1, fps).map_err(failed)?;
    let mut writer = encoder.write_header().map_err(failed)?;
    let mut next = Some(first);
    for frame in 0..frames {
        let picture = next.take().map_or_else(|| image(frame), Ok)?;
        assert_eq!(picture.dim(), (rows, columns, 3), "all frames have one size");
        let standard = picture.as_standard_layout();
        writer.write_image_data(standard.as_slice().expect("standard layout is contiguous")).map_err(failed)?;
    }
    writer.finish().map_err(failed)?;
    Ok(bytes)
}

/// Writes an image `[rows, columns, 3]` as PNG.
pub fn write_png(path: &Path, image: &Array3<u8>) -> Result<()> {
    let bytes = encode_png(image)?;
    std::fs::write(path, bytes).map_err(|source| Error::disk(path, "write the picture", source))
}

/// Images in one row, top edges aligned, with a separator of the given width and colour between
/// them; the colour also fills below shorter images.
pub fn side_by_side(images: &[&Array3<u8>], separator_px: usize, separator_rgb: [u8; 3]) -> Array3<u8> {
    let rows = images.iter().map(|image| image.dim().0).max().unwrap_or(0);
    let columns: usize =
        images.iter().map(|image| image.dim().1).sum::<usize>() + separator_px * images.len().saturating_sub(1);
    let mut sheet = Array3::from_shape_fn((rows, columns, 3), |(_, _, c)| separator_rgb[c]);
    let mut left = 0;
    for image in images {
        for ((row, column, channel), &value) in image.indexed_iter() {
            sheet[[row, left + column, channel]] = value;
        }
        left += image.dim().1 + separator_px;
    }
    sheet
}

/// Picture of per-pixel errors: 0 is nearly black and `full_scale` pale yellow, linear in
/// between; larger errors are [`BEYOND_SCALE_RGB8`], and what is not a number [`NOT_FINITE_RGB8`].
///
/// What an error of 1 means is up to the map: see `metrics::difference_to_white_map` (shares of
/// the reference white) and `metrics::ciede2000_map`. Say the scale in the caption.
pub fn heat_map(errors: &Array2<f32>, full_scale: f32) -> Array3<u8> {
    assert!(full_scale > 0.0, "the scale's end must be positive");
    let (rows, columns) = errors.dim();
    let mut picture = Array3::zeros((rows, columns, 3));
    for ((row, column), error) in errors.indexed_iter() {
        let rgb = heat_colour(error / full_scale);
        for (channel, value) in rgb.into_iter().enumerate() {
            picture[[row, column, channel]] = value;
        }
    }
    picture
}

/// The scale's colour at a share of full scale.
fn heat_colour(share: f32) -> [u8; 3] {
    if share.is_nan() {
        return NOT_FINITE_RGB8;
    }
    if share > 1.0 {
        return BEYOND_SCALE_RGB8;
    }
    let position = share.max(0.0) * (INFERNO.len() - 1) as f32;
    let below = (position as usize).min(INFERNO.len() - 2);
    let weight = position - below as f32;
    [0, 1, 2].map(|c| {
        let (low, high) = (f32::from(INFERNO[below][c]), f32::from(INFERNO[below + 1][c]));
        (low + weight * (high - low)).round() as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gradient(rows: usize, columns: usize) -> Array3<u8> {
        Array3::from_shape_fn((rows, columns, 3), |(r, c, k)| (40 * r + 7 * c + 90 * k) as u8)
    }

    fn decode(bytes: &[u8]) -> Array3<u8> {
        let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
        decoder.set_transformations(png::Transformations::EXPAND);
        let mut reader = decoder.read_info().unwrap();
        assert_eq!(reader.info().srgb, Some(png::SrgbRenderingIntent::Perceptual));
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let frame = reader.next_frame(&mut pixels).unwrap();
        assert_eq!(frame.color_type, png::ColorType::Rgb);
        Array3::from_shape_vec((frame.height as usize, frame.width as usize, 3), pixels).unwrap()
    }

    #[test]
    fn png_decodes_to_the_same_pixels() {
        let image = gradient(5, 9);
        let bytes = encode_png(&image).unwrap();
        assert_eq!(decode(&bytes), image);
        assert_eq!(encode_png(&image).unwrap(), bytes);
    }

    #[test]
    fn few_colours_make_a_palette_and_one_more_does_not() {
        let of = |colours: usize| {
            Array3::from_shape_fn((16, 32, 3), |(r, c, k)| {
                let place = (32 * r + c) % colours;
                [place as u8, 255 - (place / 2) as u8, (place >> 8) as u8][k]
            })
        };
        for (colours, kind) in
            [(1, png::ColorType::Indexed), (256, png::ColorType::Indexed), (257, png::ColorType::Rgb)]
        {
            let bytes = encode_png(&of(colours)).unwrap();
            assert_eq!(decode(&bytes), of(colours));
            let reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().unwrap();
            assert_eq!(reader.info().color_type, kind, "{colours} colours");
        }
    }

    #[test]
    fn a_transposed_view_is_written_as_it_is_indexed() {
        let mut image = gradient(5, 9);
        image.swap_axes(0, 1);
        assert_eq!(decode(&encode_png(&image).unwrap()), image);
    }

    #[test]
    fn an_animation_decodes_frame_by_frame() {
        let image = |frame: usize| gradient(5, 9).mapv(|value| value.wrapping_mul(frame as u8 + 1));
        let bytes = encode_animation(3, 25, |frame| Ok(image(frame))).unwrap();
        assert_eq!(encode_animation(3, 25, |frame| Ok(image(frame))).unwrap(), bytes);
        assert_eq!(decode(&bytes), image(0), "what programs without animation show");
        let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().unwrap();
        assert_eq!(reader.info().animation_control().unwrap().num_frames, 3);
        for frame in 0..3 {
            let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
            reader.next_frame(&mut pixels).unwrap();
            assert_eq!(Array3::from_shape_vec((5, 9, 3), pixels).unwrap(), image(frame));
            let control = reader.info().frame_control().unwrap();
            assert_eq!((control.delay_num, control.delay_den), (1, 25));
        }
        assert!(encode_animation(3, 25, |_| Ok(Array3::zeros((0, 4, 3)))).is_err());
    }

    #[test]
    fn an_empty_picture_is_refused() {
        let error = encode_png(&Array3::zeros((0, 4, 3))).unwrap_err().to_string();
        assert!(error.contains("4 x 0 pixels"), "{error}");
    }

    #[test]
    fn an_unwritable_path_is_named() {
        let path = Path::new("/nonexistent-folder/picture.png");
        let error = write_png(path, &gradient(2, 2)).unwrap_err().to_string();
        assert!(error.contains("/nonexistent-folder/picture.png"), "{error}");
    }

    #[test]
    fn side_by_side_places_images_and_separators() {
        let (a, b) = (gradient(4, 3), gradient(2, 5));
        let grey = [9, 8, 7];
        let sheet = side_by_side(&[&a, &b], 2, grey);
        assert_eq!(sheet.dim(), (4, 10, 3));
        for ((row, column, channel), &value) in sheet.indexed_iter() {
            let expected = match column {
                0..3 => a[[row, column, channel]],
                5.. if row < 2 => b[[row, column - 5, channel]],
                _ => grey[channel],
            };
            assert_eq!(value, expected, "at {row}, {column}");
        }
        assert_eq!(side_by_side(&[], 2, grey).dim(), (0, 0, 3));
    }

    #[test]
    fn heat_map_marks_what_is_off_the_scale() {
        let errors = ndarray::arr2(&[[0.0, 0.5, 1.0, 1.01, f32::NAN, f32::INFINITY]]);
        let picture = heat_map(&errors.mapv(|e| e * 0.02), 0.02);
        let pixel = |column: usize| [0, 1, 2].map(|channel| picture[[0, column, channel]]);
        assert_eq!(pixel(0), INFERNO[0]);
        assert_eq!(pixel(1), INFERNO[4]);
        assert_eq!(pixel(2), INFERNO[8]);
        assert_eq!(pixel(3), BEYOND_SCALE_RGB8);
        assert_eq!(pixel(4), NOT_FINITE_RGB8);
        assert_eq!(pixel(5), BEYOND_SCALE_RGB8);
    }

    #[test]
    fn heat_scale_rises_in_luminance() {
        let bar = heat_map(&Array2::from_shape_fn((1, 257), |(_, column)| column as f32 / 256.0), 1.0);
        let luminance = |column: usize| {
            let [r, g, b] = [0, 1, 2]
                .map(|c| diffraction_build::ground::colour::srgb_decode(f64::from(bar[[0, column, c]]) / 255.0));
            diffraction_build::ground::colour::luminance([r, g, b])
        };
        for column in 8..257 {
            assert!(luminance(column) > luminance(column - 8), "at column {column}");
        }
    }
}
