//! TIFF dialects built by hand: layouts, pages, ImageJ and OME descriptions, missing samples.

use std::path::Path;

use crate::scan_files::{ASCII, BYTE, LONG, Order, PageParts, f32_bytes, tiff_file};
use diffraction_brdf::error::Result;
use diffraction_build::height::read::{HeightScale, LengthUnit, ReadConfig, Scan, scan_from_bytes};

const ORDERS: [Order; 2] = [Order::Little, Order::Big];

fn read(bytes: &[u8], config: &ReadConfig) -> Result<Scan> {
    scan_from_bytes(Path::new("scan.tif"), bytes, config)
}

fn message(bytes: &[u8], config: &ReadConfig) -> String {
    read(bytes, config).unwrap_err().to_string()
}

/// Pitch 10 nm, numbers in nm.
fn in_nm() -> ReadConfig {
    ReadConfig {
        pitch_nm: Some([10.0, 10.0]),
        height: Some(HeightScale::Unit(LengthUnit::Nm)),
        ..ReadConfig::default()
    }
}

fn heights(scan: &Scan) -> Vec<f64> {
    scan.field.heights_nm.iter().copied().collect()
}

/// 0, 1, 2, ... in 32-bit floats.
fn ramp(order: Order, size: [u32; 2]) -> PageParts {
    let values: Vec<f32> = (0..size[0] * size[1]).map(|i| i as f32).collect();
    PageParts::grey(order, size, 32, 3, f32_bytes(order, &values))
}

fn is_ramp(scan: &Scan) -> bool {
    let mut expected = 0..;
    heights(scan).iter().all(|&height| Some(height) == expected.next().map(f64::from))
}

#[test]
fn edge_tiles_are_cut_to_the_page() {
    for order in ORDERS {
        let (nx, ny) = (20u32, 18u32);
        let mut page = PageParts::grey(order, [nx, ny], 32, 3, Vec::new());
        page.tags.retain(|tag| tag.0 != 278);
        page.byte_count = None;
        for (tile_x, tile_y) in [(0, 0), (16, 0), (0, 16), (16, 16)] {
            for y in tile_y..tile_y + 16 {
                for x in tile_x..tile_x + 16 {
                    let inside = x < nx && y < ny;
                    let value = if inside { (y * nx + x) as f32 } else { -1.0 };
                    page.data.extend(f32_bytes(order, &[value]));
                }
            }
        }
        page.long(order, 322, 16);
        page.long(order, 323, 16);
        let counts: Vec<u8> = (0..4).flat_map(|_| order.bytes(1024, 4)).collect();
        page.tags.push((325, LONG, 4, counts));
        // The page's data start after header, directory and the two lists of four.
        let data_at = 8 + 2 + (page.tags.len() as u64 + 1) * 12 + 4 + 32;
        let offsets = (0..4).flat_map(|i| order.bytes(data_at + i * 1024, 4)).collect();
        page.tags.push((324, LONG, 4, offsets));
        let scan = read(&tiff_file(order, &[page]), &in_nm()).unwrap();
        assert_eq!(scan.provenance.size, [20, 18]);
        assert!(is_ramp(&scan));
    }
}

/// The floating-point predictor of TIFF Technical Note 3: per row, bytes by significance, differenced.
#[test]
fn floating_point_predictor() {
    for order in ORDERS {
        let size = [5usize, 3];
        let mut data = Vec::new();
        for row in 0..size[1] {
            let words: Vec<[u8; 4]> = (0..size[0]).map(|x| ((row * size[0] + x) as f32).to_be_bytes()).collect();
            let planes: Vec<u8> = (0..4).flat_map(|b| words.iter().map(move |w| w[b])).collect();
            let mut previous = 0u8;
            for byte in planes {
                data.push(byte.wrapping_sub(previous));
                previous = byte;
            }
        }
        let mut page = PageParts::grey(order, [5, 3], 32, 3, data);
        page.short(order, 317, 3);
        assert!(is_ramp(&read(&tiff_file(order, &[page.clone()]), &in_nm()).unwrap()));
        // Integers have no such predictor.
        page.short(order, 339, 1);
        assert!(message(&tiff_file(order, &[page]), &in_nm()).contains("predictor 3"));
    }
}

#[test]
fn byte_counts_may_be_missing_or_too_large() {
    let order = Order::Little;
    let mut page = ramp(order, [6, 5]);
    page.byte_count = None;
    assert!(is_ramp(&read(&tiff_file(order, &[page.clone()]), &in_nm()).unwrap()));
    page.byte_count = Some(6 * 5 * 4 * 8);
    assert!(is_ramp(&read(&tiff_file(order, &[page.clone()]), &in_nm()).unwrap()));
    page.byte_count = Some(6 * 5 * 4 - 1);
    assert!(message(&tiff_file(order, &[page]), &in_nm()).contains("too few"));
}

/// Numbers of a measurement are not greys: WhiteIsZero leaves them alone, and is mentioned.
#[test]
fn white_is_zero_does_not_invert() {
    let order = Order::Big;
    let mut page = ramp(order, [4, 4]);
    page.short(order, 262, 0);
    let scan = read(&tiff_file(order, &[page]), &in_nm()).unwrap();
    assert!(is_ramp(&scan));
    assert!(scan.provenance.warnings[0].contains("WhiteIsZero"));
}

#[test]
fn orientation_mirrors() {
    let order = Order::Little;
    for (orientation, expected) in
        [(1, [0., 1., 2., 3.]), (2, [1., 0., 3., 2.]), (3, [3., 2., 1., 0.]), (4, [2., 3., 0., 1.])]
    {
        let mut page = ramp(order, [2, 2]);
        page.short(order, 274, orientation);
        let scan = read(&tiff_file(order, &[page]), &in_nm()).unwrap();
        assert_eq!(heights(&scan), expected, "orientation {orientation}");
    }
    let mut page = ramp(order, [2, 2]);
    page.short(order, 274, 6);
    assert!(message(&tiff_file(order, &[page]), &in_nm()).contains("turned"));
}

#[test]
fn several_pages_need_a_choice_unless_the_others_are_previews() {
    let order = Order::Little;
    let scan_page = ramp(order, [8, 8]);
    let thumbnail = ramp(order, [3, 3]);
    let mut flagged = ramp(order, [8, 8]);
    flagged.long(order, 254, 1);
    let mut colour = ramp(order, [8, 8]);
    colour.short(order, 262, 2);

    let file = tiff_file(order, &[thumbnail, flagged.clone(), colour.clone(), scan_page.clone()]);
    let scan = read(&file, &in_nm()).unwrap();
    assert_eq!((scan.provenance.page, scan.provenance.size), (3, [8, 8]));

    let file = tiff_file(order, &[scan_page.clone(), colour, scan_page]);
    let text = message(&file, &in_nm());
    assert!(text.contains("page 0: 8 x 8 f32; page 1: 8 x 8 colour picture; page 2"), "{text}");
    assert!(text.contains("`page = 0`"), "{text}");
    let chosen = |page| ReadConfig { page: Some(page), ..in_nm() };
    assert_eq!(read(&file, &chosen(2)).unwrap().provenance.page, 2);
    assert!(message(&file, &chosen(1)).contains("colour picture"));
    assert!(message(&file, &chosen(3)).contains("no page 3"));
}

#[test]
fn pictures_and_odd_samples_are_refused() {
    let order = Order::Little;
    for (tag, value, words) in [
        (262, 3, "palette"),
        (262, 2, "colour picture"),
        (277, 3, "three or more numbers"),
        (258, 12, "12-bit"),
        (339, 6, "sample format 6"),
        (259, 7, "JPEG"),
        (259, 50000, "Zstandard"),
        (266, 2, "FillOrder"),
    ] {
        let mut page = ramp(order, [4, 4]);
        page.short(order, tag, value);
        let text = message(&tiff_file(order, &[page]), &in_nm());
        assert!(text.contains(words), "tag {tag} = {value}: {text}");
    }
}

/// An ImageJ page with 1000 pixels per unit in x and 500 in y.
fn imagej(order: Order, bits: u16, format: u16, data: Vec<u8>, keys: &str) -> PageParts {
    let mut page = PageParts::grey(order, [2, 2], bits, format, data);
    page.text(270, &format!("ImageJ=1.53t\n{keys}"));
    page.rational(order, 282, [1000, 1]);
    page.rational(order, 283, [500, 1]);
    page.short(order, 296, 1);
    page
}

#[test]
fn imagej_units() {
    let order = Order::Big;
    let data = f32_bytes(order, &[1.0, 2.0, 3.0, 4.0]);
    for (keys, resolution_unit, pitch) in [
        ("unit=um\nvunit=nm\n", 1, [1.0, 2.0]),
        ("unit=micron\nvunit=nm\n", 1, [1.0, 2.0]),
        ("unit=\\u00B5m\nvunit=nm\n", 1, [1.0, 2.0]),
        ("unit=um\nyunit=nm\nvunit=nm\n", 1, [1.0, 0.002]),
        ("unit=um\nvunit=nm\n", 3, [1e4, 2e4]),
        ("unit=nm\nvunit=nm\n", 3, [0.001, 0.002]),
        ("unit=cm\nvunit=nm\n", 3, [1e4, 2e4]),
        ("unit=inch\nvunit=nm\n", 2, [25400.0, 50800.0]),
    ] {
        let mut page = imagej(order, 32, 3, data.clone(), keys);
        page.short(order, 296, resolution_unit);
        let scan = read(&tiff_file(order, &[page]), &ReadConfig::default()).unwrap();
        for (found, expected) in scan.field.pitch_nm.iter().zip(pitch) {
            let relative = found / expected - 1.0;
            assert!(relative.abs() < 1e-14, "{keys}: {:?}", scan.field.pitch_nm);
        }
        assert_eq!(heights(&scan), [1.0, 2.0, 3.0, 4.0]);
    }
    // Older programs write Latin-1.
    let mut page = imagej(order, 32, 3, data.clone(), "");
    page.raw(270, ASCII, b"ImageJ=1.53t\nunit=\xb5m\nvunit=nm\n\0");
    let scan = read(&tiff_file(order, &[page]), &ReadConfig::default()).unwrap();
    assert_eq!(scan.field.pitch_nm, [1.0, 2.0]);
    for (keys, words) in [
        ("unit=pixel\nvunit=nm\n", "`pitch_nm ="),
        ("vunit=nm\n", "`pitch_nm ="),
        ("unit=um\n", "`height ="),
        ("unit=um\nvunit=V\n", "`height ="),
        ("unit=um\nmin=0\nmax=100\nzunit=nm\n", "`height ="),
        ("images=5\nunit=um\nvunit=nm\n", "5 images"),
    ] {
        let page = imagej(order, 32, 3, data.clone(), keys);
        let text = message(&tiff_file(order, &[page]), &ReadConfig::default());
        assert!(text.contains(words), "{keys}: {text}");
    }
}

/// ImageJ's own metadata: a header block "IJIJ", (type, count) pairs, then the blocks, text as UTF-16.
#[test]
fn imagej_info_text() {
    for order in ORDERS {
        let four = |name: &[u8; 4]| order.bytes(u64::from(u32::from_be_bytes(*name)), 4);
        let utf16 =
            |text: &str| -> Vec<u8> { text.encode_utf16().flat_map(|unit| order.bytes(u64::from(unit), 2)).collect() };
        let file = |info: &str, magic: &[u8; 4]| {
            let one = order.bytes(1, 4);
            let header = [four(magic), four(b"labl"), one.clone(), four(b"info"), one].concat();
            let blocks = [header, utf16("slice 1"), utf16(info)];
            let sizes = blocks.iter().flat_map(|block| order.bytes(block.len() as u64, 4));
            let data = f32_bytes(order, &[1.0, 2.0, 3.0, 4.0]);
            let mut page = imagej(order, 32, 3, data, "unit=um\n");
            page.tags.push((50838, LONG, 3, sizes.collect()));
            page.raw(50839, BYTE, &blocks.concat());
            tiff_file(order, &[page])
        };
        let plain = ReadConfig::default();
        for info in ["height unit: um", "Title = x\nZ unit = \u{b5}m\n"] {
            let scan = read(&file(info, b"IJIJ"), &plain).unwrap();
            assert_eq!(heights(&scan), [1e3, 2e3, 3e3, 4e3]);
            assert_eq!(scan.provenance.height_from, "file: ImageJ info text");
        }
        assert!(message(&file("height unit: V", b"IJIJ"), &plain).contains("\"V\""));
        assert!(message(&file("nothing", b"IJIJ"), &plain).contains("vunit"));
        assert!(message(&file("height unit: um", b"IJIX"), &plain).contains("metadata"));
    }
}

#[test]
fn imagej_calibration_lines() {
    let order = Order::Big;
    let data: Vec<u8> = [0u64, 1, 32768, 65535].iter().flat_map(|&v| order.bytes(v, 2)).collect();
    let file = |keys: &str| tiff_file(order, &[imagej(order, 16, 1, data.clone(), keys)]);
    let plain = ReadConfig::default();

    let scan = read(&file("unit=um\ncf=0\nc0=-2\nc1=0.5\nvunit=um\n"), &plain).unwrap();
    assert_eq!(heights(&scan), [-2e3, -1.5e3, 16382e3, 32765.5e3]);
    // Without a unit the line is there, but not what it counts; the caller's unit comes after it.
    let no_unit = file("unit=um\ncf=0\nc0=-2\nc1=0.5\n");
    assert!(message(&no_unit, &plain).contains("`height ="));
    assert_eq!(heights(&read(&no_unit, &in_nm()).unwrap())[..2], [-2.0, -1.5]);
    // ImageJ's mark of signed samples is a type, not a calibration.
    let signed = file("unit=um\ncf=0\nc0=-32768\nc1=1\n");
    assert!(message(&signed, &plain).contains("i16"));
    let scan = read(&signed, &in_nm()).unwrap();
    assert_eq!(heights(&scan), [-32768.0, -32767.0, 0.0, 32767.0]);
    assert_eq!(scan.provenance.sample_format, "i16");
    // Curved calibrations and display limits are no lines; a line without numbers is damage.
    assert!(message(&file("unit=um\ncf=3\nc0=0\nc1=1\nvunit=nm\n"), &plain).contains("straight"));
    assert!(message(&file("unit=um\nmin=0\nmax=9\nvunit=nm\n"), &plain).contains("display limits"));
    assert!(message(&file("unit=um\ncf=0\nc0=x\nc1=1\nvunit=nm\n"), &plain).contains("c0"));
    // The manifest overrules, of the stored counts, and the contradiction is mentioned.
    let config = ReadConfig { height: Some(HeightScale::FullScaleNm(131070.0)), ..plain };
    let scan = read(&file("unit=um\ncf=0\nc0=-2\nc1=0.5\nvunit=um\n"), &config).unwrap();
    assert_eq!(heights(&scan), [0.0, 2.0, 65536.0, 131070.0]);
    assert!(scan.provenance.warnings[0].contains("overrules"));
}

#[test]
fn resolution_tags_count_only_where_they_can_be_a_scans() {
    let order = Order::Little;
    let config = ReadConfig { pitch_nm: None, ..in_nm() };
    for dpi in [72, 96, 150, 300, 600, 1200, 2400] {
        let mut page = ramp(order, [2, 2]);
        page.rational(order, 282, [dpi, 1]);
        page.rational(order, 283, [dpi, 1]);
        page.short(order, 296, 2);
        let text = message(&tiff_file(order, &[page]), &config);
        assert!(text.contains("screen") && text.contains("`pitch_nm ="), "{dpi}: {text}");
    }
    let mut page = ramp(order, [2, 2]);
    page.rational(order, 282, [1_000_000, 1]);
    page.rational(order, 283, [500_000, 1]);
    // Without a stated unit nothing follows.
    assert!(read(&tiff_file(order, &[page.clone()]), &config).is_err());
    page.short(order, 296, 3);
    let scan = read(&tiff_file(order, &[page.clone()]), &config).unwrap();
    assert_eq!(scan.field.pitch_nm, [10.0, 20.0]);
    page.rational(order, 283, [0, 0]);
    assert!(read(&tiff_file(order, &[page]), &config).is_err());
}

#[test]
fn ome_units_and_images() {
    let order = Order::Little;
    let config = ReadConfig { pitch_nm: None, ..in_nm() };
    let with = |xml: &str| {
        let mut page = ramp(order, [2, 2]);
        page.text(270, xml);
        tiff_file(order, &[page])
    };
    let one = |attributes: &str| {
        with(&format!(
            "<?xml version=\"1.0\"?><OME xmlns=\"http://x\"><Image><Pixels {attributes}>\
             <Channel Name=\"Height\"/><TiffData/></Pixels></Image></OME>"
        ))
    };
    let scan = read(&one("PhysicalSizeX=\"0.5\" PhysicalSizeY=\"2\""), &config).unwrap();
    assert_eq!(scan.field.pitch_nm, [500.0, 2000.0]);
    assert_eq!(scan.provenance.channel.as_deref(), Some("Height"));
    let in_nm = "PhysicalSizeX=\"5\" PhysicalSizeXUnit=\"nm\" PhysicalSizeY=\"3\" PhysicalSizeYUnit=\"\u{c5}\"";
    let pitch = read(&one(in_nm), &config).unwrap().field.pitch_nm;
    assert!((pitch[0] - 5.0).abs() < 1e-12 && (pitch[1] - 0.3).abs() < 1e-12);
    for (attributes, words) in [
        ("PhysicalSizeX=\"1\"", "no PhysicalSizeY"),
        ("PhysicalSizeX=\"1\" PhysicalSizeXUnit=\"pixel\" PhysicalSizeY=\"1\"", "pixel"),
        ("PhysicalSizeX=\"x\" PhysicalSizeY=\"1\"", "not a number"),
    ] {
        assert!(message(&one(attributes), &config).contains(words), "{attributes}");
    }
    let two = "<OME><Image><Pixels PhysicalSizeX=\"1\" PhysicalSizeY=\"1\"><TiffData IFD=\"1\"/></Pixels></Image>\
               <Image><Pixels PhysicalSizeX=\"2\" PhysicalSizeY=\"2\"><TiffData IFD=\"0\"/></Pixels></Image></OME>";
    assert_eq!(read(&with(two), &config).unwrap().field.pitch_nm, [2000.0, 2000.0]);
    assert!(message(&with("<OME><Image>"), &config).contains("not XML"));
    // A parser compares each attribute with all others of its element: so many would take it minutes.
    let attributes: String = (0..100_000).map(|n| format!(" a{n}=\"\"")).collect();
    let flooded = format!("<OME><Image{attributes}/></OME>");
    assert!(message(&with(&flooded), &config).contains("more than 4096 attributes"));
}

#[test]
fn missing_samples_are_counted_filled_and_bounded() {
    let order = Order::Little;
    let size = [20u32, 20];
    let mut values: Vec<f32> = (0..400).map(|i| (i % 20) as f32 * 2.0 + (i / 20) as f32).collect();
    let truth: Vec<f64> = values.iter().map(|&value| f64::from(value)).collect();
    let marks = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -9999.0, -f32::MAX];
    for (index, &mark) in marks.iter().enumerate() {
        values[105 + 21 * index] = mark;
    }
    let mut page = PageParts::grey(order, size, 32, 3, f32_bytes(order, &values));
    page.text(42113, "-9999");
    let file = tiff_file(order, &[page.clone()]);
    let scan = read(&file, &in_nm()).unwrap();
    assert_eq!(scan.provenance.missing_samples, marks.len());
    assert!(scan.provenance.warnings[0].contains("5 missing samples"));
    // A plane is harmonic, so it is restored; the solver leaves 1e-9 of the relief (rms 13 nm).
    let worst = heights(&scan).iter().zip(&truth).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(worst < 1e-6, "{worst}");
    let strict = ReadConfig { max_missing_share: 0.01, ..in_nm() };
    assert!(message(&file, &strict).contains("5 of 400 samples are missing"));
    page.text(42113, "none at all");
    let broken = read(&tiff_file(order, &[page]), &ReadConfig { max_missing_share: 0.5, ..in_nm() }).unwrap();
    assert!(broken.provenance.warnings[0].contains("no-data"), "{:?}", broken.provenance.warnings);

    let all_missing = f32_bytes(order, &[f32::NAN; 4]);
    let page = PageParts::grey(order, [2, 2], 32, 3, all_missing);
    let generous = ReadConfig { max_missing_share: 1.0, ..in_nm() };
    assert!(message(&tiff_file(order, &[page]), &generous).contains("4 of 4"));
}

/// The smallest value of the type is 0 nm and the largest the full scale, signed or not.
#[test]
fn full_scale_spans_the_integer_type() {
    let order = Order::Big;
    for (bits, format, ends) in [
        (8, 1, [0, 255]),
        (8, 2, [-128, 127]),
        (16, 1, [0, 65535]),
        (16, 2, [-32768, 32767]),
        (32, 1, [0, 0xFFFF_FFFF]),
        (32, 2, [i64::from(i32::MIN), i64::from(i32::MAX)]),
    ] {
        let size = usize::from(bits) / 8;
        let data = ends.iter().flat_map(|&end| order.bytes((end as u64) << (64 - bits) >> (64 - bits), size));
        let page = PageParts::grey(order, [2, 1], bits, format, data.collect());
        let config = ReadConfig { height: Some(HeightScale::FullScaleNm(300.0)), ..in_nm() };
        let found = heights(&read(&tiff_file(order, &[page]), &config).unwrap());
        // Two roundings of 300.
        assert!(found[0].abs() < 1e-13 && (found[1] - 300.0).abs() < 2e-13, "{bits} {format}: {found:?}");
    }
}

#[test]
fn heights_and_pitches_out_of_reason_are_refused() {
    let order = Order::Little;
    let file = tiff_file(order, &[ramp(order, [4, 4])]);
    let metres = ReadConfig { height: Some(HeightScale::Unit(LengthUnit::M)), ..in_nm() };
    assert!(message(&file, &metres).contains("more than a metre"));
    for pitch in [0.0, -1.0, f64::NAN, f64::INFINITY, 1.000001e6] {
        let config = ReadConfig { pitch_nm: Some([10.0, pitch]), ..in_nm() };
        assert!(message(&file, &config).contains("pitch"), "{pitch}");
    }
    for scale in [0.0, f64::NAN, f64::INFINITY] {
        let height = HeightScale::Linear { nm_per_count: scale, offset_nm: 0.0 };
        let config = ReadConfig { height: Some(height), ..in_nm() };
        assert!(message(&file, &config).contains("`height`"), "{scale}");
    }
}
