//! Kinds of TIFF that laboratories have and few encoders write: odd tag types, predictors, masks, encodings of text, named pages,
//! broken metadata.

use std::path::Path;

use crate::scan_files::{ASCII, Order, PageParts, SHORT, f32_bytes, tiff_file};
use crate::skip::shared;
use diffraction_brdf::error::Result;
use diffraction_build::height::read::{HeightScale, LengthUnit, ReadConfig, Scan, read_scan, scan_from_bytes};

const ORDERS: [Order; 2] = [Order::Little, Order::Big];
/// Signed types.
const SBYTE: u16 = 6;
const SSHORT: u16 = 8;
const SLONG: u16 = 9;
const IFD: u16 = 13;

fn read(bytes: &[u8], config: &ReadConfig) -> Result<Scan> {
    scan_from_bytes(Path::new("scan.tif"), bytes, config)
}

fn message(bytes: &[u8], config: &ReadConfig) -> String {
    read(bytes, config).unwrap_err().to_string()
}

fn given() -> ReadConfig {
    ReadConfig {
        pitch_nm: Some([10.0, 10.0]),
        height: Some(HeightScale::Unit(LengthUnit::Nm)),
        max_missing_share: 0.5,
        ..ReadConfig::default()
    }
}

fn heights(scan: &Scan) -> Vec<f64> {
    scan.field.heights_nm.iter().copied().collect()
}

const VALUES: [f32; 6] = [1.0, -2.5, 3.25, 1e6, -0.125, 7.0];

fn expected() -> Vec<f64> {
    VALUES.iter().map(|&value| f64::from(value)).collect()
}

fn page(order: Order) -> PageParts {
    PageParts::grey(order, [3, 2], 32, 3, f32_bytes(order, &VALUES))
}

#[test]
fn integers_of_every_type_that_can_hold_them() {
    for order in ORDERS {
        for (kind, size) in [(SBYTE, 1), (SSHORT, 2), (SLONG, 4), (IFD, 4)] {
            let mut page = page(order);
            for tag in &mut page.tags {
                let value = match order {
                    Order::Little => tag.3[0],
                    Order::Big => tag.3[tag.3.len() - 1],
                };
                (tag.1, tag.3) = (kind, order.bytes(u64::from(value), size));
            }
            assert_eq!(heights(&read(&tiff_file(order, &[page]), &given()).unwrap()), expected(), "type {kind}");
        }
        let mut negative = page(order);
        negative.tags.retain(|tag| tag.0 != 256);
        negative.tags.push((256, SSHORT, 1, order.bytes(0xFFFD, 2)));
        assert!(message(&tiff_file(order, &[negative]), &given()).contains("tag 256 is negative"));
    }
}

/// Differences of the bits as integers along each row, as libtiff takes them.
#[test]
fn horizontal_predictor_on_floats_of_every_width() {
    for order in ORDERS {
        let differences = |bits: &dyn Fn(f32) -> u64, size: usize| -> Vec<u8> {
            let rows = VALUES.chunks(3).flat_map(|row| {
                let bits: Vec<u64> = row.iter().map(|&value| bits(value)).collect();
                (0..3).map(move |x| if x == 0 { bits[0] } else { bits[x].wrapping_sub(bits[x - 1]) })
            });
            let mask = if size == 8 { u64::MAX } else { (1 << (8 * size)) - 1 };
            rows.flat_map(|difference| order.bytes(difference & mask, size)).collect()
        };
        let single = differences(&|value| u64::from(value.to_bits()), 4);
        let double = differences(&|value| f64::from(value).to_bits(), 8);
        for (bits, data) in [(32, single), (64, double)] {
            let mut page = PageParts::grey(order, [3, 2], bits, 3, data);
            page.short(order, 317, 2);
            assert_eq!(heights(&read(&tiff_file(order, &[page]), &given()).unwrap()), expected(), "{bits} bits");
        }
    }
}

/// A frame of one raw block: magic, single segment with one byte of size, last block of type 0.
fn zstandard(content: &[u8]) -> Vec<u8> {
    let header = (((content.len() as u32) << 3) | 1).to_le_bytes();
    [&[0x28, 0xB5, 0x2F, 0xFD, 0x20, content.len() as u8][..], &header[..3], content].concat()
}

#[test]
fn zstandard_is_decoded_to_the_size_it_must_have() {
    let order = Order::Little;
    let of = |data: Vec<u8>| {
        let mut page = PageParts::grey(order, [3, 2], 32, 3, data);
        page.short(order, 259, 50000);
        tiff_file(order, &[page])
    };
    let content = f32_bytes(order, &VALUES);
    assert_eq!(heights(&read(&of(zstandard(&content)), &given()).unwrap()), expected());
    for broken in [zstandard(&content[..20]), zstandard(&content)[..20].to_vec(), vec![7; 40]] {
        assert!(message(&of(broken), &given()).contains("Zstandard"));
    }
}

/// Planes and compressed pairs: `tests/data/formats/mask*.tif`.
#[test]
fn a_second_number_per_pixel_is_a_mask_or_a_channel() {
    for order in ORDERS {
        let opacity = [1.0f32, 1.0, 0.0, 1.0, 0.5, 1.0];
        let pairs: Vec<f32> = VALUES.iter().zip(opacity).flat_map(|(&value, opacity)| [value, opacity]).collect();
        let mut page = PageParts::grey(order, [3, 2], 32, 3, f32_bytes(order, &pairs));
        let twice = |value: u64| order.bytes(value, 2).repeat(2);
        page.tags.retain(|tag| !matches!(tag.0, 258 | 339));
        page.tags.extend([(258, SHORT, 2, twice(32)), (339, SHORT, 2, twice(3))]);
        page.short(order, 277, 2);
        page.short(order, 338, 2);
        let scan = read(&tiff_file(order, &[page.clone()]), &given()).unwrap();
        assert_eq!(scan.provenance.missing_samples, 1);
        let known: Vec<f64> = [0, 1, 3, 4, 5].iter().map(|&index| heights(&scan)[index]).collect();
        assert_eq!(known, [0, 1, 3, 4, 5].map(|index| expected()[index]));
        // Unspecified: another channel, which hides nothing.
        page.short(order, 338, 0);
        let scan = read(&tiff_file(order, &[page.clone()]), &given()).unwrap();
        assert_eq!(heights(&scan), expected());
        assert!(scan.provenance.warnings[0].contains("two numbers"), "{:?}", scan.provenance.warnings);
        page.short(order, 277, 3);
        assert!(message(&tiff_file(order, &[page]), &given()).contains("three or more numbers"));
    }
}

#[test]
fn a_mask_that_hides_everything_hides_nothing() {
    let order = Order::Little;
    let pairs: Vec<f32> = VALUES.iter().flat_map(|&value| [value, 0.0]).collect();
    let mut page = PageParts::grey(order, [3, 2], 32, 3, f32_bytes(order, &pairs));
    page.short(order, 277, 2);
    page.short(order, 338, 2);
    assert_eq!(heights(&read(&tiff_file(order, &[page]), &given()).unwrap()), expected());
}

/// A description's bytes with or without a mark, in an encoding of one or two bytes.
fn described(order: Order, bytes: Vec<u8>) -> Vec<u8> {
    let mut page = page(order);
    page.tags.push((270, ASCII, bytes.len() as u32, bytes));
    page.rational(order, 282, [1, 50]);
    page.rational(order, 283, [1, 50]);
    page.short(order, 296, 1);
    tiff_file(order, &[page])
}

#[test]
fn descriptions_in_every_encoding() {
    let texts = [
        ("ImageJ TIFF", "ImageJ=1.53t\nunit=nm\nvunit=nm\n"),
        (
            "OME-TIFF",
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?><OME><Image><Pixels PhysicalSizeX=\"0.05\" PhysicalSizeY=\"0.05\"/></Image></OME>",
        ),
    ];
    let config = ReadConfig { pitch_nm: None, ..given() };
    for (format, text) in texts {
        let little: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
        for bytes in [
            text.as_bytes().to_vec(),
            [b"\xEF\xBB\xBF", text.as_bytes()].concat(),
            [&b"\xFF\xFE"[..], &little].concat(),
            [&b"\xFE\xFF"[..], &big].concat(),
            little.clone(),
            big.clone(),
        ] {
            let scan = read(&described(Order::Little, [bytes, vec![0, 0]].concat()), &config).unwrap();
            assert_eq!(scan.provenance.format, format);
            assert!((scan.field.pitch_nm[0] - 50.0).abs() < 1e-9, "{:?}", scan.field.pitch_nm);
        }
    }
}

#[test]
fn named_pages_are_listed_and_the_one_height_is_read() {
    let order = Order::Little;
    let named = |name: &str, tag: u16| {
        let mut page = page(order);
        page.text(tag, name);
        page
    };
    let file = tiff_file(order, &[named("Amplitude", 285), named("Topography", 270), named("Phase", 285)]);
    let scan = read(&file, &given()).unwrap();
    assert_eq!((scan.provenance.page, scan.provenance.channel.as_deref()), (1, Some("Topography")));
    // A page without a name may be anything.
    let file = tiff_file(order, &[named("Intensity", 285), page(order), named("Height", 285)]);
    let text = message(&file, &given());
    assert!(text.contains("page 0: Intensity, 3 x 2 f32; page 1: 3 x 2 f32; page 2: Height"), "{text}");
    assert!(text.contains("`channel = \"Height\"`"), "{text}");
    let by_name = ReadConfig { channel: Some("height".into()), ..given() };
    assert_eq!(read(&file, &by_name).unwrap().provenance.page, 2);
    // OME names the pages of its channels.
    let xml = "<OME><Image><Pixels PhysicalSizeX=\"1\" PhysicalSizeY=\"1\"><Channel Name=\"Laser intensity\"/>\
               <Channel Name=\"Height\"/></Pixels></Image></OME>";
    let file = tiff_file(order, &[named(xml, 270), page(order)]);
    assert_eq!(read(&file, &given()).unwrap().provenance.page, 1);
    // The only page may be no height either.
    let alone = tiff_file(order, &[named("Deflection", 285)]);
    let plain = ReadConfig { height: None, ..given() };
    let text = message(&alone, &plain);
    assert!(text.contains("\"Deflection\", not a height") || text.contains("not known"), "{text}");
    let asked = ReadConfig { page: Some(0), ..given() };
    assert!(read(&alone, &asked).is_ok());
}

#[test]
fn broken_metadata_are_a_warning_where_the_caller_knows_better() {
    let order = Order::Little;
    let with = |tag: u16, text: &str| {
        let mut page = page(order);
        page.text(tag, text);
        tiff_file(order, &[page])
    };
    let mut outside = page(order);
    outside.tags.push((42113, ASCII, 900_000, vec![0xFF; 5]));
    for (bytes, words) in [
        (with(270, "<?xml version=\"1.0\"?><OME><Image>"), "not XML"),
        (with(42113, "none at all"), "no-data value"),
        (tiff_file(order, &[outside]), "tag 42113"),
    ] {
        let scan = read(&bytes, &given()).unwrap();
        assert_eq!(heights(&scan), expected());
        assert!(scan.provenance.warnings[0].contains(words), "{:?}", scan.provenance.warnings);
    }
    // Without the caller's word it is the reason why nothing is known; an empty no-data value is none.
    let text = message(&with(270, "<?xml version=\"1.0\"?><OME><Image>"), &ReadConfig::default());
    assert!(text.contains("not XML") && text.contains("`pitch_nm ="), "{text}");
    assert!(read(&with(42113, ""), &given()).unwrap().provenance.warnings.is_empty());
}

/// Files that failed for one reason each.
#[test]
fn cases_that_laboratories_sent() {
    let Some(folder) = shared("cases/scans") else { return };
    let plain = ReadConfig::default();
    let jpk = read_scan(&folder.join("jpk_min_long_be.jpk"), &plain).unwrap();
    assert_eq!(jpk.provenance.channel.as_deref(), Some("measuredHeight (trace)"));
    assert_eq!(jpk.provenance.size, [16, 8]);
    for axis in 0..2 {
        assert!((jpk.field.pitch_nm[axis] - 50.0).abs() < 1e-9);
    }
    assert!(read_scan(&folder.join("ij_desc_bom.tif"), &plain).is_ok());
    let in_nm = ReadConfig { height: Some(HeightScale::Unit(LengthUnit::Nm)), ..ReadConfig::default() };
    assert_eq!(read_scan(&folder.join("ome_bom.tif"), &in_nm).unwrap().provenance.format, "OME-TIFF");
    for name in ["grey_alpha.tif", "nd_gdal_empty.tif"] {
        assert!(read_scan(&folder.join(name), &given()).is_ok(), "{name}");
    }
}
