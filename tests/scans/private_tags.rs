//! Microscope makers' private tags: Park Systems and JPK files built by hand, from their formulas.

use std::path::Path;

use crate::scan_files::{BYTE, Order, PageParts, SHORT, UNDEFINED, tiff_file};
use diffraction_brdf::error::Result;
use diffraction_build::height::read::{ReadConfig, Scan, scan_from_bytes};

fn read(bytes: &[u8], config: &ReadConfig) -> Result<Scan> {
    scan_from_bytes(Path::new("scan.tif"), bytes, config)
}

fn message(bytes: &[u8], config: &ReadConfig) -> String {
    read(bytes, config).unwrap_err().to_string()
}

fn heights(scan: &Scan) -> Vec<f64> {
    scan.field.heights_nm.iter().copied().collect()
}

/// A Park file of version 1: 16-bit data, 2 x 2, behind a palette preview.
fn park(source: &str, unit: &str, z_scale: f64) -> Vec<u8> {
    let order = Order::Little;
    let mut header = vec![0u8; 360];
    let mut text = |at: usize, text: &str| {
        for (index, unit) in text.encode_utf16().enumerate() {
            header[at + 2 * index..at + 2 * index + 2].copy_from_slice(&unit.to_le_bytes());
        }
    };
    text(4, source);
    text(244, unit);
    for at in [100, 104] {
        header[at..at + 4].copy_from_slice(&2u32.to_le_bytes());
    }
    let floats = [(140, 0.25), (148, 0.5), (220, -2.0), (228, z_scale), (236, 0.125)];
    for (at, value) in floats {
        header[at..at + 8].copy_from_slice(&f64::to_le_bytes(value));
    }
    // Beyond version 1's fields stands whatever the program left there.
    header[348..352].copy_from_slice(&2u32.to_le_bytes());
    let mut page = PageParts::grey(order, [1, 1], 8, 1, vec![7]);
    page.short(order, 262, 3);
    page.long(order, 50432, 0x0E03_1301);
    page.long(order, 50433, 0x0100_0001);
    let data: Vec<u8> = [1i16, -2, 3, 4].iter().flat_map(|v| v.to_le_bytes()).collect();
    page.raw(50434, BYTE, &data);
    page.raw(50435, UNDEFINED, &header);
    tiff_file(order, &[page])
}

/// height = gain (scale raw + offset), rows from the bottom; scale 0 stands for 1.
#[test]
fn park_version_one() {
    let plain = ReadConfig::default();
    let scan = read(&park("Topography", "um", 0.0), &plain).unwrap();
    let expected = [3.0, 4.0, 1.0, -2.0].map(|raw| -2.0 * (raw + 0.125) * 1e3);
    assert_eq!(heights(&scan), expected);
    assert_eq!(scan.field.pitch_nm, [125.0, 250.0]);
    assert_eq!(scan.provenance.sample_format, "i16");
    let scan = read(&park("Z Height", "nm", 0.5), &plain).unwrap();
    assert_eq!(heights(&scan), [3.0, 4.0, 1.0, -2.0].map(|raw| -2.0 * (0.5 * raw + 0.125)));
    assert!(message(&park("NCM Phase", "deg", 1.0), &plain).contains("not a height"));
    assert!(message(&park("Z Height", "V", 1.0), &plain).contains("`height ="));
    assert!(message(&park("Z Height", "um", f64::NAN), &plain).contains("gain"));
}

/// A page of a JPK file: signed 32-bit, slots "base" (volts) and "nominal" (metres).
fn jpk_page(order: Order, channel: &str, retrace: u16, raw: [i32; 4], scale: f64) -> PageParts {
    let data = raw.iter().flat_map(|&v| order.bytes(u64::from(v as u32), 4)).collect();
    let mut page = PageParts::grey(order, [2, 2], 32, 2, data);
    page.text(0x8050, channel);
    page.short(order, 0x8051, retrace);
    page.short(order, 0x8080, 2);
    page.text(0x8081, "nominal");
    for (slot, name, unit, scale, offset) in [(0, "base", "V", 7.0, 1.0), (1, "nominal", "m", scale, 2e-9)] {
        let at = 0x30 * slot;
        page.text(0x8090 + at, name);
        page.text(0x80A2 + at, unit);
        page.text(0x80A3 + at, "LinearScaling");
        page.double(order, 0x80A4 + at, scale);
        page.double(order, 0x80A5 + at, offset);
    }
    page
}

fn jpk(reflect: u16, pages: &[PageParts]) -> Vec<u8> {
    jpk_turned(reflect, None, pages)
}

fn jpk_turned(reflect: u16, angle_rad: Option<f64>, pages: &[PageParts]) -> Vec<u8> {
    let order = Order::Little;
    let mut thumbnail = PageParts::grey(order, [1, 1], 8, 1, vec![0]);
    if let Some(angle_rad) = angle_rad {
        thumbnail.double(order, 0x8044, angle_rad);
    }
    thumbnail.short(order, 262, 3);
    thumbnail.double(order, 0x8042, 1e-6);
    thumbnail.double(order, 0x8043, 3e-6);
    thumbnail.tags.push((0x8045, SHORT, 1, order.bytes(u64::from(reflect), 2)));
    thumbnail.text(0x8050, "thumbnail");
    let mut all = vec![thumbnail];
    all.extend_from_slice(pages);
    tiff_file(order, &all)
}

#[test]
fn jpk_default_slot_of_the_best_height_channel() {
    let order = Order::Little;
    let plain = ReadConfig::default();
    let error = jpk_page(order, "vDeflection", 0, [9; 4], 1.0);
    let height = jpk_page(order, "height", 0, [1, 2, 3, 4], 1e-9);
    let back = jpk_page(order, "measuredHeight", 1, [5, 6, 7, 8], -1e-9);
    let measured = jpk_page(order, "measuredHeight", 0, [-5, 6, 7, 8], -1e-9);
    let near = |scan: &Scan, expected: [f64; 4]| heights(scan).iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12);
    // height = multiplier raw + offset, rows from the bottom; forward before backward.
    let all = [error.clone(), height.clone(), back, measured];
    let scan = read(&jpk(0, &all), &plain).unwrap();
    assert_eq!((&*scan.provenance.format, scan.provenance.page), ("JPK TIFF", 4));
    assert_eq!(scan.provenance.channel.as_deref(), Some("measuredHeight (trace)"));
    assert!(near(&scan, [-5.0, -6.0, 7.0, -4.0]), "{:?}", heights(&scan));
    for axis in 0..2 {
        let pitch = [500.0, 1500.0][axis];
        assert!((scan.field.pitch_nm[axis] - pitch).abs() < 1e-9);
    }
    assert_eq!(scan.provenance.angle_deg, None);
    // Reflected scans stand upright.
    let scan = read(&jpk(1, &all), &plain).unwrap();
    assert!(near(&scan, [7.0, -4.0, -5.0, -6.0]), "{:?}", heights(&scan));
    let scan = read(&jpk_turned(1, Some(std::f64::consts::FRAC_PI_4), &all), &plain).unwrap();
    assert_eq!(scan.provenance.angle_deg, Some(45.0));
    // A height that a map of force curves derived is not the measured one.
    let mut at_force = jpk_page(order, "measuredHeight", 0, [9; 4], 1e-9);
    at_force.text(0x8053, "algorithm.object-name.fancy-name : Ref. Force Height at 40%");
    let scan = read(&jpk(0, &[at_force, all[3].clone()]), &plain).unwrap();
    assert_eq!((scan.provenance.page, scan.provenance.channel.as_deref()), (2, Some("measuredHeight (trace)")));
    // Another channel by its page, and only the lesser height where there is no better one.
    let chosen = ReadConfig { page: Some(2), ..plain.clone() };
    assert!(near(&read(&jpk(0, &all), &chosen).unwrap(), [5.0, 6.0, 3.0, 4.0]));
    let scan = read(&jpk(0, &[error.clone(), height.clone()]), &plain).unwrap();
    assert_eq!(scan.provenance.page, 2);

    let none = message(&jpk(0, &[error]), &plain);
    assert!(none.contains("no channel") && none.contains("vDeflection"), "{none}");
    let mut volts = height.clone();
    volts.text(0x8081, "base");
    assert!(message(&jpk(0, &[volts]), &plain).contains("\"V\""));
    let mut lost = height;
    lost.text(0x8081, "calibrated");
    assert!(message(&jpk(0, &[lost]), &plain).contains("calibrated"));
}
