//! RGB images in OpenEXR files of other programs, read within bounds.

use std::fs::File;
use std::io::{Cursor, Read};
use std::path::Path;

use exr::meta::MetaData;
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

/// Luminance of the first layer with channels R, G and B (with the weights of Rec. 709 and sRGB), shape
/// `[rows, columns]`, row 0 on top; and the file's SHA-256.
///
/// # Errors
/// A file that is none, too large, or has luminances that are negative or not finite.
pub(crate) fn read_luminance(path: &Path) -> Result<(Array2<f32>, String)> {
    let bytes = bounded(path)?;
    let sha256 = files::sha256_hex(&bytes);
    let bad = |what: String| Error::bad_file(path, what, "Save it as an OpenEXR image with channels R, G and B.");
    check(&bytes).map_err(bad)?;
    let image = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(
            |size, _| Array2::<f32>::zeros((size.height(), size.width())),
            |image, Vec2(x, y), (r, g, b): (f32, f32, f32)| image[[y, x]] = 0.2126 * r + 0.7152 * g + 0.0722 * b,
        )
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        .from_buffered(Cursor::new(&bytes))
        .map_err(|e| bad(format!("its pixels cannot be decoded: {e}")))?;
    let luminance = image.layer_data.channel_data.pixels;
    let wrong = luminance.iter().filter(|&&value| !(value.is_finite() && value >= 0.0)).count();
    if wrong > 0 {
        return Err(Error::bad_file(
            path,
            format!("{wrong} of its {} pixels have a luminance that is negative or not finite", luminance.len()),
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

/// Sizes that the header states, against the bytes that are there: the decoder allocates what it is told.
fn check(bytes: &[u8]) -> std::result::Result<(), String> {
    let meta =
        MetaData::read_from_buffered(Cursor::new(bytes), true).map_err(|e| format!("is no OpenEXR image: {e}"))?;
    let channels: usize = meta.headers.iter().map(|header| header.channels.list.len()).sum();
    if channels > CHANNELS_MAX {
        return Err(format!("it has {channels} channels; at most {CHANNELS_MAX} are read"));
    }
    for header in &meta.headers {
        let (width, height) = (header.layer_size.width(), header.layer_size.height());
        let pixels = width.saturating_mul(height);
        if pixels > PIXELS_MAX {
            return Err(format!("it has {width} x {height} pixels; at most {PIXELS_MAX} are read: scale it down"));
        }
        let stored = pixels.saturating_mul(header.channels.bytes_per_pixel);
        if stored > bytes.len().saturating_mul(RATIO_MAX) {
            return Err(format!("it claims {width} x {height} pixels, more than its {} bytes can hold", bytes.len()));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use diffraction_brdf::exr_image::{Precision, write_rgb};
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
        assert!(read_luminance(&path).unwrap_err().to_string().contains("1 of its 72 pixels"));
    }
}
