//! RGB images in OpenEXR files of other programs, read within bounds.

use std::fs::File;
use std::io::{Cursor, Read};
use std::path::Path;

use exr::meta::MetaData;
use exr::meta::attribute::Chromaticities;
use exr::meta::header::Header;
use exr::prelude::{ReadChannels, ReadLayers, Vec2};
use ndarray::Array2;

use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::files;

/// Largest file that is read.
const BYTES_MAX: u64 = 512 << 20;

/// Most pixels of one layer: 8192 x 4096.
const PIXELS_MAX: usize = 1 << 25;

/// Most channels of all layers together, and most layers.
const CHANNELS_MAX: usize = 16;

/// How many times its stored bytes an image may take: deflate cannot expand by more than 1032.
const RATIO_MAX: usize = 1032;

/// Luminance of the first layer with channels R, G and B, by the file's own primaries (those of Rec. 709 and sRGB where it names
/// none), over its display window: black where no data are, and without data beyond. Shape `[rows, columns]`, row 0 on top; and the file's SHA-256.
///
/// # Errors
/// A file that is none, is too large, keeps its colours otherwise, or has luminances that are negative or not finite.
pub(crate) fn read_luminance(path: &Path) -> Result<(Array2<f32>, String)> {
    let bytes = bounded(path)?;
    let sha256 = files::sha256_hex(&bytes);
    let bad = |what: String| Error::bad_file(path, what, "Save it as an OpenEXR image with channels R, G and B.");
    let Frame { size: [rows, columns], first: [top, left], weights } = frame(&bytes).map_err(bad)?;
    let image = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(
            move |_, _| Array2::<f32>::zeros((rows, columns)),
            move |image, Vec2(x, y), (r, g, b): (f32, f32, f32)| {
                let place = [top + y as i64, left + x as i64].map(|at| usize::try_from(at).unwrap_or(usize::MAX));
                if let Some(texel) = image.get_mut(place) {
                    *texel = weights[0] * r + weights[1] * g + weights[2] * b;
                }
            },
        )
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        .from_buffered(Cursor::new(&bytes))
        .map_err(|e| bad(format!("its pixels cannot be decoded: {e}")))?;
    let luminance = image.layer_data.channel_data.pixels;
    let infinite = luminance.iter().filter(|value| !value.is_finite()).count();
    let negative = luminance.iter().filter(|value| **value < 0.0).count();
    if infinite + negative > 0 {
        return Err(Error::bad_file(
            path,
            format!(
                "of its {} pixels {infinite} have a luminance that is infinite or no number, and {negative} a negative one",
                luminance.len()
            ),
            "Limit its values to finite ones of at least 0 in an image editor.",
        ));
    }
    Ok((luminance, sha256))
}

fn bounded(path: &Path) -> Result<Vec<u8>> {
    files::check_plain(path)?;
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(|e| Error::disk(path, "read", e))?;
    file.take(BYTES_MAX + 1).read_to_end(&mut bytes).map_err(|e| Error::disk(path, "read", e))?;
    if bytes.len() as u64 > BYTES_MAX {
        let what = format!("an image may have {} MiB, this one is larger", BYTES_MAX >> 20);
        return Err(Error::bad_file(path, what, "Scale it down: a light needs no fine detail."));
    }
    Ok(bytes)
}

/// Where the pixels go, and what they add to the luminance.
struct Frame {
    /// Rows and columns of the display window.
    size: [usize; 2],
    /// Row and column of the display window at which the data begin.
    first: [i64; 2],
    /// Of R, G and B.
    weights: [f32; 3],
}

/// What the header states of the first layer with R, G and B, its sizes held against the bytes that are there: the decoder allocates what it is told.
fn frame(bytes: &[u8]) -> std::result::Result<Frame, String> {
    let meta =
        MetaData::read_from_buffered(Cursor::new(bytes), true).map_err(|e| format!("is no OpenEXR image: {e}"))?;
    let channels: usize = meta.headers.iter().map(|header| header.channels.list.len()).sum();
    if channels > CHANNELS_MAX {
        return Err(format!("it has {channels} channels; at most {CHANNELS_MAX} are read"));
    }
    for header in &meta.headers {
        let pixels = bounded_pixels(header.layer_size)?;
        let stored = pixels.saturating_mul(header.channels.bytes_per_pixel);
        if stored > bytes.len().saturating_mul(RATIO_MAX) {
            let (width, height) = (header.layer_size.width(), header.layer_size.height());
            return Err(format!("it claims {width} x {height} pixels, more than its {} bytes can hold", bytes.len()));
        }
    }
    let header = meta.headers.iter().find(|header| ["R", "G", "B"].iter().all(|name| has(header, name)));
    let header = header.ok_or_else(|| what_else(&meta.headers))?;
    if header.deep {
        return Err("it holds deep pixels, several depths to each, which are not read".into());
    }
    if let Some(channel) = header.channels.list.iter().find(|channel| channel.sampling != Vec2(1, 1)) {
        let Vec2(x, y) = channel.sampling;
        return Err(format!(
            "its channel {} is subsampled, one value to {x} x {y} pixels, which is not read",
            channel.name
        ));
    }
    let window = header.shared_attributes.display_window;
    bounded_pixels(window.size)?;
    let Vec2(x, y) = header.own_attributes.layer_position;
    let first = [i64::from(y) - i64::from(window.position.y()), i64::from(x) - i64::from(window.position.x())];
    let weights = match header.shared_attributes.chromaticities {
        None => REC_709,
        Some(primaries) => luminance_weights(primaries)
            .ok_or("its attribute `chromaticities` names no primaries and white that colours can be mixed from")?,
    };
    Ok(Frame { size: [window.size.height(), window.size.width()], first, weights })
}

fn bounded_pixels(size: Vec2<usize>) -> std::result::Result<usize, String> {
    let (width, height) = (size.width(), size.height());
    let pixels = width.saturating_mul(height);
    if pixels > PIXELS_MAX {
        return Err(format!("it has {width} x {height} pixels; at most {PIXELS_MAX} are read: scale it down"));
    }
    Ok(pixels)
}

fn has(header: &Header, name: &str) -> bool {
    header.channels.list.iter().any(|channel| channel.name == *name)
}

/// Why there is no layer with R, G and B, by the names of what there is.
fn what_else(headers: &[Header]) -> String {
    if headers.iter().any(|header| has(header, "RY") || has(header, "BY")) {
        return "it holds luminance and subsampled chroma (Y, RY, BY), which are not read".into();
    }
    let names: Vec<String> =
        headers.iter().flat_map(|header| &header.channels.list).map(|channel| channel.name.to_string()).collect();
    format!("none of its {} parts has channels R, G and B; it has {}", headers.len(), names.join(", "))
}

/// Luminances of the primaries of Rec. 709 and sRGB.
const REC_709: [f32; 3] = [0.2126, 0.7152, 0.0722];

/// Luminances of primaries that add up to a white of luminance 1 (SMPTE RP 177); `None` where they cannot.
fn luminance_weights(Chromaticities { red, green, blue, white }: Chromaticities) -> Option<[f32; 3]> {
    let [r, g, b, w] = [red, green, blue, white].map(|Vec2(x, y)| {
        let [x, y] = [x, y].map(f64::from);
        [x, y, 1.0 - x - y]
    });
    if w[1] == 0.0 {
        return None;
    }
    let determinant = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| {
        a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) + c[0] * (a[1] * b[2] - a[2] * b[1])
    };
    let all = determinant(r, g, b);
    let amounts = [determinant(w, g, b), determinant(r, w, b), determinant(r, g, w)];
    let weights = [0, 1, 2].map(|k| (amounts[k] / all / w[1] * [r, g, b][k][1]) as f32);
    weights.iter().all(|weight| weight.is_finite()).then_some(weights)
}

#[cfg(test)]
mod tests {
    use super::*;
    use diffraction_brdf::exr_image::{Precision, write_rgb};
    use exr::prelude::{
        AnyChannel, AnyChannels, Blocks, Encoding, FlatSamples, Image, ImageAttributes, IntegerBounds, Layer,
        LayerAttributes, SpecificChannels, WritableImage,
    };
    use ndarray::Array3;

    fn written(image: &Array3<f32>) -> (tempfile::TempDir, std::path::PathBuf) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("sky.exr");
        write_rgb(&path, image, Precision::Float, &serde_json::json!({})).unwrap();
        (folder, path)
    }

    fn image() -> Array3<f32> {
        Array3::from_shape_fn((6, 12, 3), |(row, column, channel)| (100 * row + 3 * column + channel) as f32)
    }

    #[test]
    fn luminance_is_read_where_it_stands() {
        let (_folder, path) = written(&image());
        let (luminance, sha256) = read_luminance(&path).unwrap();
        assert_eq!(luminance.dim(), (6, 12));
        for ((row, column), value) in luminance.indexed_iter() {
            let red = (100 * row + 3 * column) as f32;
            // Two roundings of a sum of three.
            assert!((value - (red + 0.7152 + 0.1444)).abs() <= 2e-7 * red + 1e-6, "{row} {column}: {value}");
        }
        assert_eq!(sha256, files::sha256_hex(&std::fs::read(&path).unwrap()));
    }

    #[test]
    fn damaged_files_are_refused_and_never_panic() {
        let (_folder, path) = written(&image());
        let good = std::fs::read(&path).unwrap();
        for length in (0..good.len()).step_by(7) {
            std::fs::write(&path, &good[..length]).unwrap();
            assert!(read_luminance(&path).is_err(), "cut to {length}");
        }
        for (index, value) in
            (0..good.len()).step_by(3).flat_map(|index| [0x00, 0x7f, 0xff].map(|value| (index, value)))
        {
            let mut bytes = good.clone();
            bytes[index] = value;
            std::fs::write(&path, &bytes).unwrap();
            // Some bytes are comments or pixels: what counts is that it ends, within its memory.
            let _ = read_luminance(&path);
        }
    }

    #[test]
    fn claims_beyond_the_bytes_and_impossible_light_are_refused() {
        let (_folder, path) = written(&image());
        let mut bytes = std::fs::read(&path).unwrap();
        // Both windows claim 8000 x 4000, in blocks of 16 lines.
        let mut claim = |name: &[u8], skipped: usize, value: i32| {
            let at = bytes.windows(name.len()).position(|window| window == name).unwrap() + name.len() + 4 + skipped;
            bytes[at..at + 4].copy_from_slice(&value.to_le_bytes());
        };
        for name in [&b"dataWindow\0box2i\0"[..], &b"displayWindow\0box2i\0"[..]] {
            claim(name, 8, 7999);
            claim(name, 12, 3999);
        }
        claim(b"chunkCount\0int\0", 0, 250);
        std::fs::write(&path, &bytes).unwrap();
        let message = read_luminance(&path).unwrap_err().to_string();
        assert!(message.contains("8000 x 4000") && message.contains("more than its"), "{message}");
        let mut dark = image();
        dark[[0, 0, 1]] = -1.0;
        let (_folder, path) = written(&dark);
        assert!(read_luminance(&path).unwrap_err().to_string().contains("of its 72 pixels 0 have"));
        let channels =
            SpecificChannels::rgb(|Vec2(x, _): Vec2<usize>| (0.0f32, [f32::INFINITY, f32::NAN, 1.0][x], 0.0f32));
        let layer = Layer::new((3, 2), LayerAttributes::named("sky"), Encoding::UNCOMPRESSED, channels);
        Image::from_layer(layer).write().to_file(&path).unwrap();
        assert!(read_luminance(&path).unwrap_err().to_string().contains("of its 6 pixels 4 have"));
    }

    /// Two rows of four pixels of green, as other programs may write them.
    fn foreign(change: impl Fn(&mut ImageAttributes, &mut LayerAttributes)) -> (tempfile::TempDir, std::path::PathBuf) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("foreign.exr");
        let channels = SpecificChannels::rgb(|_: Vec2<usize>| (0.0f32, 1.0f32, 0.0f32));
        let mut layer = Layer::new((4, 2), LayerAttributes::named("sky"), Encoding::UNCOMPRESSED, channels);
        let mut attributes = ImageAttributes::new(IntegerBounds::from_dimensions((4, 2)));
        change(&mut attributes, &mut layer.attributes);
        let image = Image { attributes, ..Image::from_layer(layer) };
        image.write().to_file(&path).unwrap();
        (folder, path)
    }

    #[test]
    fn the_display_window_is_the_picture() {
        let (_folder, path) = foreign(|image, layer| {
            image.display_window = IntegerBounds::new((1, -1), (8, 4));
            layer.layer_position = Vec2(7, 1);
        });
        let (luminance, _) = read_luminance(&path).unwrap();
        assert_eq!(luminance.dim(), (4, 8));
        for ((row, column), value) in luminance.indexed_iter() {
            // From column 6 on, of whose four columns two lie within; rows 2 and 3.
            let wanted = if row >= 2 && column >= 6 { 0.7152 } else { 0.0 };
            assert_eq!(*value, wanted, "{row} {column}");
        }
    }

    #[test]
    fn primaries_are_honoured() {
        let at = |x: f32, y: f32| Vec2(x, y);
        let of = |red, green, blue, white| {
            let primaries = Chromaticities { red, green, blue, white };
            let (_folder, path) = foreign(|image, _| image.chromaticities = Some(primaries));
            read_luminance(&path).map(|(luminance, _)| luminance[[1, 2]])
        };
        // XYZ, whose green is Y; ACES AP0 (SMPTE ST 2065-1); Rec. 709.
        let third = at(1.0 / 3.0, 1.0 / 3.0);
        assert_eq!(of(at(1.0, 0.0), at(0.0, 1.0), at(0.0, 0.0), third).unwrap(), 1.0);
        let aces = of(at(0.7347, 0.2653), at(0.0, 1.0), at(0.0001, -0.077), at(0.32168, 0.33767)).unwrap();
        assert!((aces - 0.728_166).abs() < 1e-5, "{aces}");
        let rec_709 = of(at(0.64, 0.33), at(0.3, 0.6), at(0.15, 0.06), at(0.3127, 0.329)).unwrap();
        assert!((rec_709 - 0.7152).abs() < 1e-4, "{rec_709}");
        let message = of(at(0.3, 0.3), at(0.3, 0.3), at(0.3, 0.3), third).unwrap_err().to_string();
        assert!(message.contains("chromaticities"), "{message}");
    }

    #[test]
    fn tiles_are_read_and_other_colours_refused_by_name() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("tiles.exr");
        let channels = SpecificChannels::rgb(|Vec2(x, _): Vec2<usize>| (0.0f32, x as f32, 0.0f32));
        let tiled = Encoding { blocks: Blocks::Tiles(Vec2(16, 16)), ..Encoding::UNCOMPRESSED };
        let layer = Layer::new((40, 20), LayerAttributes::named("sky"), tiled, channels);
        Image::from_layer(layer).write().to_file(&path).unwrap();
        assert_eq!(read_luminance(&path).unwrap().0[[19, 39]], 0.7152 * 39.0);
        let y = |name: &str| AnyChannel::new(name, FlatSamples::F32(vec![1.0; 8]));
        for (names, told) in [(["Y", "RY"], "luminance and subsampled chroma"), (["Y", "Z"], "it has Y, Z")] {
            let list = AnyChannels::sort(names.map(y).into_iter().collect());
            Image::from_channels((4, 2), list).write().to_file(&path).unwrap();
            let message = read_luminance(&path).unwrap_err().to_string();
            assert!(message.contains(told), "{message}");
        }
    }
}
