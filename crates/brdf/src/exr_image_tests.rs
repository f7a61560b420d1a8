//! Tests of the EXR files: exact round trips, reproducible bytes, damaged and hostile files.

use super::*;
use serde_json::json;

fn random_image(seed: u64, rows: usize, columns: usize) -> Array3<f32> {
    let mut random = fastrand::Rng::with_seed(seed);
    Array3::from_shape_fn((rows, columns, 3), |_| (random.f32() - 0.3) * 10f32.powi(random.i32(-6..4)))
}

/// More custom attributes than a hash map of random order would keep in place twice.
fn attributes() -> Value {
    json!({"scale": 0.25, "order": 3, "basis": "chebyshev", "species": "Xénopeltis 蛇", "big": 1u64 << 40,
           "nested": {"u": [-2, 2]}, "empty": "", "a_name_longer_than_the_thirty_one_bytes": 1, "flag": true})
}

fn encoded(image: &Array3<f32>, precision: Precision) -> Vec<u8> {
    encode(Path::new("test.exr"), image, Place::whole(image), precision, &attributes()).unwrap()
}

#[test]
fn float_images_come_back_exactly() {
    // Heights around the block of 16 lines, and one pixel.
    for (seed, rows, columns) in [(1, 1, 1), (2, 15, 7), (3, 16, 31), (4, 17, 3), (5, 64, 33)] {
        let image = random_image(seed, rows, columns);
        let (back, found) = decode(&encoded(&image, Precision::Float)).unwrap();
        assert_eq!(back, image);
        assert_eq!(found, attributes());
    }
}

#[test]
fn a_window_tells_where_it_lies_in_the_whole_image() {
    let image = random_image(13, 37, 12);
    let place = Place { first: [5, 70], whole: [50, 90] };
    let bytes = encode(Path::new("test.exr"), &image, place, Precision::Float, &attributes()).unwrap();
    let layout = exr_header::check(&bytes).unwrap();
    assert_eq!((layout.first, layout.height, layout.width), (place.first, 37, 12));
    let (found, _) = exr_header::attributes(&bytes).unwrap();
    let box_of = |name: &str| exr_header::find(&found, name, "box2i").unwrap().to_vec();
    // Left, top, right, bottom.
    assert_eq!(box_of("dataWindow"), [70i32, 5, 81, 41].map(i32::to_le_bytes).concat());
    assert_eq!(box_of("displayWindow"), [0i32, 0, 89, 49].map(i32::to_le_bytes).concat());
    assert_eq!(decode(&bytes).unwrap().0, image);
    // Outside of the whole image it would mean nothing.
    let at = bytes.windows(13).position(|w| w == b"displayWindow").unwrap() + 14 + 6 + 4;
    let mut narrow = bytes.clone();
    narrow[at + 8] = 80;
    assert!(decode(&narrow).unwrap_err().contains("beyond its display window"));
}

#[test]
fn half_images_come_back_rounded_to_the_nearest_half() {
    let image = random_image(6, 40, 21);
    let (back, _) = decode(&encoded(&image, Precision::Half)).unwrap();
    assert_eq!(back, image.mapv(|value| f16::from_f32(value).to_f32()));
    assert_ne!(back, image);
}

#[test]
fn bytes_are_reproducible() {
    // Each write makes new hash maps with new random keys, so an order that leaked through would differ here.
    let image = random_image(7, 33, 20);
    let first = encoded(&image, Precision::Float);
    for _ in 0..20 {
        assert_eq!(encoded(&image, Precision::Float), first);
    }
    let names: Vec<_> = exr_header::attributes(&first).unwrap().0.iter().map(|found| found.name.to_owned()).collect();
    assert!(names.is_sorted());
    assert!(!names.iter().any(|name| name == b"chromaticities" || name == b"whiteLuminance"));
}

#[test]
fn single_values_stand_in_the_header_by_type() {
    let bytes = encoded(&random_image(8, 2, 2), Precision::Half);
    let (found, _) = exr_header::attributes(&bytes).unwrap();
    let find = |name: &str, kind: &str| exr_header::find(&found, name, kind);
    assert_eq!(find("colorInteropID", "string").unwrap(), b"data");
    assert_eq!(find("atlas:order", "int").unwrap(), 3i32.to_le_bytes());
    assert_eq!(find("atlas:scale", "float").unwrap(), 0.25f32.to_le_bytes());
    assert_eq!(find("atlas:big", "float").unwrap(), ((1u64 << 40) as f32).to_le_bytes());
    assert_eq!(find("atlas:species", "string").unwrap(), "Xénopeltis 蛇".as_bytes());
    assert!(find("atlas:order", "float").unwrap_err().contains("not of type"));
    assert!(find("atlas:nested", "string").unwrap_err().contains("missing"));
}

#[test]
fn values_that_do_not_fit_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("image.exr");
    let mut image = random_image(9, 4, 4);
    image[[1, 2, 0]] = 1e6;
    let error = write_rgb(&path, &image, Precision::Half, &json!({})).unwrap_err();
    assert!(error.to_string().contains("1 values are not finite as 16-bit"), "{error}");
    write_rgb(&path, &image, Precision::Float, &json!({})).unwrap();
    image[[0, 0, 0]] = f32::NAN;
    assert!(write_rgb(&path, &image, Precision::Float, &json!({})).is_err());
}

#[test]
fn a_file_cut_off_anywhere_is_an_error() {
    let bytes = encoded(&random_image(10, 40, 9), Precision::Half);
    for length in 0..bytes.len() {
        assert!(decode(&bytes[..length]).is_err(), "cut at {length}");
    }
    let mut longer = bytes.clone();
    longer.push(0);
    assert!(decode(&longer).unwrap_err().contains("behind its last block"));
}

#[test]
fn no_changed_byte_can_panic_or_change_the_size() {
    // The lines repeat, so that blocks are deflated rather than stored as they are.
    let image = Array3::from_shape_fn((35, 6, 3), |(_, column, channel)| (column + 10 * channel) as f32);
    let bytes = encoded(&image, Precision::Float);
    let (_, header_end) = exr_header::attributes(&bytes).unwrap();
    let block_table = header_end..header_end + 3 * 8;
    for at in 0..bytes.len() {
        for change in [0x01, 0x80, 0xff] {
            let mut damaged = bytes.clone();
            damaged[at] ^= change;
            match decode(&damaged) {
                Ok((back, _)) => {
                    assert_eq!(back.dim(), image.dim());
                    assert!(at >= 8 && !block_table.contains(&at), "a change at byte {at} went unseen");
                }
                Err(what) => assert!(!what.is_empty()),
            }
        }
    }
}

#[test]
fn huge_claims_are_refused_before_any_memory_is_taken() {
    let bytes = encoded(&random_image(12, 4, 4), Precision::Float);
    let window = bytes.windows(16).position(|w| w == b"dataWindow\0box2i").unwrap() + 17 + 4;
    let display = bytes.windows(13).position(|w| w == b"displayWindow").unwrap() + 14 + 6 + 4;
    for (width, height) in [(i32::MAX, i32::MAX), (1 << 20, 1 << 20), (-7, 3), (1 << 20, 4)] {
        let mut hostile = bytes.clone();
        for at in [window, display] {
            hostile[at + 8..at + 12].copy_from_slice(&(width - 1).to_le_bytes());
            hostile[at + 12..at + 16].copy_from_slice(&(height - 1).to_le_bytes());
        }
        let what = decode(&hostile).unwrap_err();
        assert!(what.contains("it claims") || what.contains("window is empty"), "{what}");
    }
}
