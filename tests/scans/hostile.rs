//! Damaged and malicious scan files: a clear refusal within bounded memory, never a panic or a hang.

use std::io::Cursor;
use std::path::Path;

use crate::scan_files::{DOUBLE, LONG, Order, PageParts, f32_bytes, tiff_file};
use crate::skip::shared;
use diffraction_brdf::error::{Error, Result};
use diffraction_build::height::read::{HeightScale, LengthUnit, ReadConfig, Scan, read_scan, scan_from_bytes};
use proptest::prelude::*;
use tiff::encoder::{Compression, DeflateLevel, Predictor, TiffEncoder, colortype};

fn read(bytes: &[u8], config: &ReadConfig) -> Result<Scan> {
    scan_from_bytes(Path::new("scan.tif"), bytes, config)
}

/// Calibration for whatever a file does not say.
fn counts() -> ReadConfig {
    ReadConfig {
        pitch_nm: Some([10.0, 10.0]),
        height: Some(HeightScale::Linear {
            // A power of two: scaling is exact.
            nm_per_count: 0.125,
            offset_nm: 0.0,
        }),
        max_missing_share: 0.5,
        max_samples: 1 << 20,
        ..ReadConfig::default()
    }
}

fn message(bytes: &[u8]) -> String {
    read(bytes, &counts()).unwrap_err().to_string()
}

fn page(size: [u32; 2], data_bytes: usize) -> PageParts {
    PageParts::grey(Order::Little, size, 32, 3, vec![0; data_bytes])
}

fn little(page: PageParts) -> Vec<u8> {
    tiff_file(Order::Little, &[page])
}

/// Encodes samples; `$colour` is the encoder's type for them.
macro_rules! encode {
    ($colour:ty, $values:expr, $size:expr, $setting:expr) => {{
        let setting: Setting = $setting;
        let mut file = Cursor::new(Vec::new());
        let [nx, ny]: [u32; 2] = $size;
        if setting.big {
            let encoder = TiffEncoder::new_big(&mut file).unwrap();
            encode!(@page encoder, $colour, $values, [nx, ny], setting);
        } else {
            let encoder = TiffEncoder::new(&mut file).unwrap();
            encode!(@page encoder, $colour, $values, [nx, ny], setting);
        }
        file.into_inner()
    }};
    (@page $encoder:expr, $colour:ty, $values:expr, [$nx:expr, $ny:expr], $setting:expr) => {{
        let mut encoder = $encoder
            .with_compression(COMPRESSIONS[$setting.compression])
            .with_predictor($setting.predictor);
        let mut image = encoder.new_image::<$colour>($nx, $ny).unwrap();
        image.rows_per_strip($setting.rows_per_strip).unwrap();
        image.write_data($values).unwrap();
    }};
}

const COMPRESSIONS: [Compression; 4] =
    [Compression::Uncompressed, Compression::Lzw, Compression::Deflate(DeflateLevel::Balanced), Compression::Packbits];

#[derive(Debug, Clone, Copy)]
struct Setting {
    big: bool,
    /// Place in [`COMPRESSIONS`].
    compression: usize,
    predictor: Predictor,
    rows_per_strip: u32,
}

/// Small files of every compression, and one of each hand-made kind.
fn small_files() -> Vec<Vec<u8>> {
    let values: Vec<u16> = (0..24 * 20).map(|i| (i * i % 5000) as u16).collect();
    let mut files = Vec::new();
    for compression in 0..COMPRESSIONS.len() {
        for big in [false, true] {
            let setting = Setting { big, compression, predictor: Predictor::Horizontal, rows_per_strip: 7 };
            files.push(encode!(colortype::Gray16, &values, [24, 20], setting));
        }
    }
    files
}

#[test]
fn a_file_cut_anywhere_is_refused() {
    let mut files = small_files();
    if let Some(folder) = shared("specimens/real") {
        files.push(std::fs::read(folder.join("butterfly-vcardui-10x3.tif")).unwrap());
        files.push(std::fs::read(folder.join("butterfly-vcardui-41pct.tif")).unwrap());
    }
    if let Some(folder) = shared("tiff-variants") {
        files.push(std::fs::read(folder.join("grid_imagej153t_ij8_uncal.tif")).unwrap());
    }
    for file in files {
        let whole = read(&file, &counts()).unwrap();
        let every_64th = (0..file.len()).step_by(64);
        for length in every_64th.chain(0..300.min(file.len())) {
            // A calibration that is cut off is not needed here, which a warning says.
            let is_told = |scan: &Scan| scan.field == whole.field && !scan.provenance.warnings.is_empty();
            let cut = read(&file[..length], &counts());
            assert!(cut.is_err() || cut.is_ok_and(|scan| is_told(&scan)), "cut to {length} of {} bytes", file.len());
        }
    }
}

#[test]
fn flipped_bytes_give_a_scan_or_a_refusal() {
    let mut files = small_files();
    if let Some(folder) = shared("tiff-variants") {
        for name in ["grid_lzw_pred3_tiled_nm.tif", "grid_ome_nm.ome.tif", "grid_imagej153t_ij16_cal.tif"] {
            files.push(std::fs::read(folder.join(name)).unwrap());
        }
        files.push(std::fs::read(folder.join("park_smartscan_512.tiff")).unwrap());
        files.push(std::fs::read(folder.join("grid.gsf")).unwrap());
    }
    let mut random = fastrand::Rng::with_seed(20140704);
    for original in files {
        // Directories are at the ends of these files; small ones are flipped everywhere.
        let rounds = if original.len() < 5000 { 1500 } else { 60 };
        let mut refused = 0;
        for _ in 0..rounds {
            let mut file = original.clone();
            for _ in 0..random.usize(1..4) {
                let near_an_end = random.usize(0..600.min(file.len()));
                let at = match random.bool() {
                    true => near_an_end,
                    false => file.len() - 1 - near_an_end,
                };
                file[at] = random.u8(..);
            }
            match read(&file, &counts()) {
                Ok(scan) => {
                    let [nx, ny] = scan.provenance.size;
                    assert_eq!(scan.field.heights_nm.dim(), (ny, nx));
                    assert!(nx * ny <= counts().max_samples);
                    assert!(scan.field.heights_nm.iter().all(|height| height.is_finite()));
                }
                Err(Error::BadFile { what, fix, .. } | Error::Limit { what, fix }) => {
                    assert!(!what.is_empty() && !fix.is_empty());
                    refused += 1;
                }
                Err(other) => panic!("a wrong kind of error: {other}"),
            }
        }
        assert!(refused > 0, "no flip was noticed in {rounds}");
    }
}

#[test]
fn claimed_sizes_are_checked_before_memory_is_taken() {
    for size in [[u32::MAX, u32::MAX], [1 << 20, 2], [1025, 1024]] {
        let error = read(&little(page(size, 64)), &counts()).unwrap_err();
        assert!(matches!(error, Error::Limit { .. }), "{error}");
        assert!(error.to_string().contains("the limit is 1048576"), "{error}");
    }
    assert!(message(&little(page([1000, 1000], 64))).contains("too few"));
    // No compression turns 64 bytes into four million.
    for compression in [5, 8, 32946, 32773] {
        let mut packed = page([1000, 1000], 64);
        packed.short(Order::Little, 259, compression);
        assert!(message(&little(packed)).contains("too few"), "{compression}");
    }
    assert!(message(&little(page([0, 5], 64))).contains("width"));
    let mut tiled = page([8, 8], 1024);
    tiled.long(Order::Little, 322, 1 << 30);
    tiled.long(Order::Little, 323, 16);
    tiled.long(Order::Little, 324, 8);
    tiled.long(Order::Little, 325, 1024);
    assert!(message(&little(tiled.clone())).contains("tiles are"));
    tiled.long(Order::Little, 322, 0);
    assert!(message(&little(tiled)).contains("empty"));
    let mut no_rows = page([4, 4], 64);
    no_rows.long(Order::Little, 278, 0);
    assert!(message(&little(no_rows)).contains("empty"));
    let mut many_strips = page([4, 4], 64);
    many_strips.long(Order::Little, 278, 1);
    assert!(message(&little(many_strips)).contains("lists fewer"));
}

/// One strip's bytes named a thousand times would be decoded a thousand times.
#[test]
fn overlapping_strips_are_refused() {
    let mut overlapping = page([1, 1000], 4);
    overlapping.byte_count = None;
    overlapping.long(Order::Little, 278, 1);
    let same: Vec<u8> = (0..1000).flat_map(|_| Order::Little.bytes(8, 4)).collect();
    let ample: Vec<u8> = (0..1000).flat_map(|_| Order::Little.bytes(4000, 4)).collect();
    overlapping.short(Order::Little, 259, 8);
    overlapping.tags.push((279, LONG, 1000, ample));
    let mut file = little(overlapping.clone());
    // The support code writes one strip's offset; a list needs the same tag with a longer value.
    let list_at = file.len() as u64;
    file.extend(same);
    let entry = (10..file.len()).step_by(12).find(|&at| file[at..at + 2] == [0x11, 0x01]).unwrap();
    file[entry + 4..entry + 8].copy_from_slice(&1000u32.to_le_bytes());
    file[entry + 8..entry + 12].copy_from_slice(&Order::Little.bytes(list_at, 4));
    assert!(message(&file).contains("overlap"), "{}", message(&file));
}

#[test]
fn directories_that_loop_or_lead_astray() {
    let good = little(page([4, 4], 64));
    let directory_at = 8;
    let count = usize::from(good[directory_at]);
    let link_at = directory_at + 2 + 12 * count;
    let mut looped = good.clone();
    looped[link_at..link_at + 4].copy_from_slice(&(directory_at as u32).to_le_bytes());
    assert!(message(&looped).contains("loop"));
    let mut astray = good.clone();
    astray[link_at..link_at + 4].copy_from_slice(&u32::MAX.to_le_bytes());
    assert!(message(&astray).contains("no complete directory"));
    let mut crowded = good.clone();
    crowded[directory_at..directory_at + 2].copy_from_slice(&u16::MAX.to_le_bytes());
    assert!(message(&crowded).contains("no complete directory"));
    let mut none = good.clone();
    none[4..8].fill(0);
    assert!(message(&none).contains("no directory"));

    // A value that claims 32 GiB.
    let mut vast = page([4, 4], 64);
    vast.tags.push((282, DOUBLE, u32::MAX, vec![8, 0, 0, 0]));
    vast.short(Order::Little, 296, 3);
    let config = ReadConfig { pitch_nm: None, ..counts() };
    let error = read(&little(vast), &config).unwrap_err().to_string();
    assert!(error.contains("tag 282 lies outside"), "{error}");

    // A BigTIFF with 2^63 tags, and one whose first directory is at the end of the number range.
    let mut big = b"II\x2b\0\x08\0\0\0".to_vec();
    big.extend(16u64.to_le_bytes());
    big.extend((1u64 << 63).to_le_bytes());
    big.extend([0; 64]);
    assert!(message(&big).contains("no complete directory"));
    big[8..16].copy_from_slice(&u64::MAX.to_le_bytes());
    assert!(message(&big).contains("no complete directory"));
    big[4] = 4;
    assert!(message(&big).contains("BigTIFF"));
}

#[test]
fn what_is_no_scan_at_all() {
    for (bytes, words) in [
        (&b""[..], "empty"),
        (b"II", "no format"),
        (b"II*\0", "ends before"),
        (b"\x89PNG\r\n", "picture"),
        (b"GWYP....", "no end"),
        (b"hello", "no format"),
    ] {
        assert!(message(bytes).contains(words), "{}", message(bytes));
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let error = read_scan(folder, &counts()).unwrap_err().to_string();
    assert!(error.contains("not a regular file"), "{error}");
    let absent = read_scan(&folder.join("no such scan.tif"), &counts()).unwrap_err();
    assert!(matches!(absent, Error::Disk { .. }), "{absent}");
    if cfg!(unix) {
        let endless = read_scan(Path::new("/dev/zero"), &counts()).unwrap_err();
        assert!(endless.to_string().contains("not a regular file"));
    }
}

#[test]
fn hostile_xml_calibrates_nothing() {
    let with = |xml: &str| {
        let mut described = page([4, 4], 64);
        described.text(270, xml);
        little(described)
    };
    let laughs = "<!DOCTYPE l [<!ENTITY a \"ha\"><!ENTITY b \"&a;&a;&a;&a;\">]><OME><Image>&b;</Image></OME>";
    let deep = format!("<OME>{}", "<a>".repeat(100_000));
    let wide = format!("<OME>{}</OME>", "<a/>".repeat(300_000));
    for xml in [laughs, &deep, &wide] {
        let text = read(&with(xml), &ReadConfig::default()).unwrap_err().to_string();
        assert!(text.contains("not XML"), "{text}");
        let warnings = read(&with(xml), &counts()).unwrap().provenance.warnings;
        assert!(warnings[0].contains("not XML"), "{warnings:?}");
    }
    // Well-formed and deep: parsed, and then lacks a pixel size.
    let nested = format!("<OME>{}{}</OME>", "<a>".repeat(20_000), "</a>".repeat(20_000));
    assert!(read(&with(&nested), &counts()).is_ok());
}

fn setting() -> impl Strategy<Value = Setting> {
    (any::<bool>(), 0..COMPRESSIONS.len(), any::<bool>(), 1u32..9).prop_map(|(big, compression, predict, rows)| {
        Setting {
            big,
            compression,
            predictor: if predict { Predictor::Horizontal } else { Predictor::None },
            rows_per_strip: rows,
        }
    })
}

/// Size and as many bit patterns.
fn field() -> impl Strategy<Value = ([u32; 2], Vec<u32>)> {
    (1u32..13, 1u32..13).prop_flat_map(|(nx, ny)| {
        let samples = (nx * ny) as usize;
        (Just([nx, ny]), proptest::collection::vec(any::<u32>(), samples))
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    /// What an independent encoder writes comes back exactly, in every integer and float type.
    #[test]
    fn random_fields_survive((size, bits) in field(), setting in setting()) {
        macro_rules! check {
            ($colour:ty, $type:ty, $name:literal, $setting:expr, $of_bits:expr) => {{
                let of_bits: fn(u32) -> $type = $of_bits;
                let values: Vec<$type> = bits.iter().map(|&bits| of_bits(bits)).collect();
                let file = encode!($colour, &values, size, $setting);
                let scan = read(&file, &counts()).unwrap();
                prop_assert_eq!(&scan.provenance.sample_format, $name);
                prop_assert_eq!(scan.provenance.size, size.map(|side| side as usize));
                let expected: Vec<f64> = values.iter().map(|&v| f64::from(v) * 0.125).collect();
                let found: Vec<f64> = scan.field.heights_nm.iter().copied().collect();
                prop_assert_eq!(found, expected);
            }};
        }
        check!(colortype::Gray8, u8, "u8", setting, |bits| bits as u8);
        check!(colortype::Gray16, u16, "u16", setting, |bits| bits as u16);
        check!(colortype::Gray32, u32, "u32", setting, |bits| bits);
        check!(colortype::GrayI8, i8, "i8", setting, |bits| bits as i8);
        check!(colortype::GrayI16, i16, "i16", setting, |bits| bits as i16);
        check!(colortype::GrayI32, i32, "i32", setting, |bits| bits as i32);
        // Floats have no horizontal predictor.
        let plain = Setting { predictor: Predictor::None, ..setting };
        check!(colortype::Gray32Float, f32, "f32", plain, |bits| bits as f32 / 3.0);
        check!(colortype::Gray64Float, f64, "f64", plain, |bits| f64::from(bits) / 7.0);
    }

    /// The comparison above can fail: one changed byte of the samples changes a height.
    #[test]
    fn a_changed_sample_is_seen(size in (1u32..13, 1u32..13), seed in any::<u64>()) {
        let size = [size.0, size.1];
        let samples = (size[0] * size[1]) as usize;
        let values: Vec<f32> = (0..samples).map(|i| i as f32).collect();
        let data = f32_bytes(Order::Little, &values);
        let file = little(PageParts::grey(Order::Little, size, 32, 3, data));
        let config = ReadConfig { height: Some(HeightScale::Unit(LengthUnit::Nm)), ..counts() };
        let before = read(&file, &config).unwrap();
        let mut changed = file.clone();
        let sample = fastrand::Rng::with_seed(seed).usize(0..samples);
        let at = file.len() - 4 * (samples - sample);
        changed[at + 1] ^= 1;
        let after = read(&changed, &config).unwrap();
        let differing = before.field.heights_nm.iter().zip(&after.field.heights_nm).filter(|(a, b)| a != b);
        prop_assert_eq!(differing.count(), 1);
        prop_assert_ne!(before.provenance.sha256, after.provenance.sha256);
    }
}
