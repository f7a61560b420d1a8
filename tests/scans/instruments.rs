//! Instruments' own formats: one surface in each, written and read by other programs too (`tests/data/formats/make.py`), comes out the
//! same; damaged and malicious ones are refused within bounded memory.

use std::path::{Path, PathBuf};

use crate::skip::test_data;
use diffraction_brdf::error::{Error, Result};
use diffraction_build::height::read::{HeightScale, LengthUnit, ReadConfig, Scan, read_scan, scan_from_bytes};
use proptest::prelude::*;

fn folder() -> PathBuf {
    test_data("formats")
}

fn truth() -> serde_json::Value {
    serde_json::from_str(&std::fs::read_to_string(folder().join("truth.json")).unwrap()).unwrap()
}

/// Every file of the folder with its bytes.
fn files() -> Vec<(String, Vec<u8>)> {
    let rows = truth()["files"].as_array().unwrap().clone();
    let names = rows.iter().map(|row| row["file"].as_str().unwrap().to_owned());
    names.map(|name| (name.clone(), std::fs::read(folder().join(&name)).unwrap())).collect()
}

/// A limit on samples that no file here reaches, and pitch and height for files that lost theirs.
fn given() -> ReadConfig {
    ReadConfig {
        pitch_nm: Some([10.0, 10.0]),
        height: Some(HeightScale::Unit(LengthUnit::Nm)),
        max_missing_share: 0.5,
        max_samples: 1 << 16,
        ..ReadConfig::default()
    }
}

fn read(name: &str, bytes: &[u8], config: &ReadConfig) -> Result<Scan> {
    scan_from_bytes(Path::new(name), bytes, config)
}

#[test]
fn one_surface_in_every_format() {
    let truth = truth();
    let rows: Vec<Vec<f64>> = serde_json::from_value(truth["heights_nm"].clone()).unwrap();
    let missing: Vec<[usize; 2]> = serde_json::from_value(truth["missing"].clone()).unwrap();
    let pitch: [f64; 2] = serde_json::from_value(truth["pitch_nm"].clone()).unwrap();
    let (ny, nx) = (rows.len(), rows[0].len());
    for row in truth["files"].as_array().unwrap() {
        let name = row["file"].as_str().unwrap();
        let scan = read_scan(&folder().join(name), &ReadConfig::default()).unwrap();
        let facts = &scan.provenance;
        assert_eq!((facts.size, facts.format.as_str()), ([nx, ny], row["format"].as_str().unwrap()), "{name}");
        assert_eq!(facts.page as u64, row["page"].as_u64().unwrap(), "{name}");
        assert_eq!(facts.channel.as_deref(), row["channel"].as_str(), "{name}");
        assert_eq!(facts.missing_samples as u64, row["missing"].as_u64().unwrap(), "{name}");
        let turned = row["angle_deg"].as_f64().map(|deg| (deg * 1e6).round());
        assert_eq!(facts.angle_deg.map(|deg| (deg * 1e6).round()), turned, "{name}");
        assert!(facts.pitch_from.starts_with("file: ") && facts.height_from.starts_with("file: "), "{name}: {facts:?}");
        for (found, expected) in scan.field.pitch_nm.into_iter().zip(pitch) {
            assert!((found / expected - 1.0).abs() < 1e-6, "{name}: {:?}", scan.field.pitch_nm);
        }
        let told = facts.warnings.iter().any(|warning| warning.contains("would be a height too"));
        assert_eq!(told, name.contains("32.001") || name.contains("in_32"), "{name}: {:?}", facts.warnings);
        assert_eq!(facts.warnings.len(), usize::from(told) + usize::from(facts.missing_samples > 0), "{name}");

        // Formats round heights to their integers; the constant of a file's zero is that of its program.
        let tolerance = row["tolerance_nm"].as_f64().unwrap() + 1e-5;
        let is_known = |y: usize, x: usize| facts.missing_samples == 0 || !missing.contains(&[y, x]);
        let far = |expected: &dyn Fn(usize, usize) -> f64| {
            let differences: Vec<f64> = (0..nx * ny)
                .map(|index| (index / nx, index % nx))
                .filter(|&(y, x)| is_known(y, x))
                .map(|(y, x)| scan.field.heights_nm[[y, x]] - expected(y, x))
                .collect();
            let mean = differences.iter().sum::<f64>() / differences.len() as f64;
            differences.iter().map(|difference| (difference - mean).abs()).fold(0.0, f64::max)
        };
        assert!(far(&|y, x| rows[y][x]) <= tolerance, "{name}: {}", far(&|y, x| rows[y][x]));
        // The comparison can fail: mirrored either way, upside down in height, or with a scale off by 1 %.
        assert!(far(&|y, x| rows[ny - 1 - y][x]) > 1.0, "{name}");
        assert!(far(&|y, x| rows[y][nx - 1 - x]) > 1.0, "{name}");
        assert!(far(&|y, x| -rows[y][x]) > 1.0, "{name}");
        assert!(far(&|y, x| 1.01 * rows[y][x]) > 2.0 * tolerance, "{name}");
    }
}

#[test]
fn no_file_of_the_folder_is_forgotten() {
    let known: Vec<String> = files().into_iter().map(|(name, _)| name).collect();
    for entry in std::fs::read_dir(folder()).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let is_tool = matches!(name.as_str(), "make.py" | "truth.json");
        assert!(is_tool || known.contains(&name), "{name} is in no test");
    }
}

#[test]
fn other_channels_are_read_when_they_are_asked_for() {
    let of = |name: &str, channel: &str, config: ReadConfig| {
        let config = ReadConfig { channel: Some(channel.to_owned()), ..config };
        read_scan(&folder().join(name), &config)
    };
    let plain = ReadConfig::default;
    // The piezo's height beside the sensor's.
    let scan = of("nanoscope_32.001", "Height (retrace)", plain()).unwrap();
    assert_eq!(scan.provenance.page, 1);
    let by_page = read_scan(&folder().join("nanoscope_32.001"), &ReadConfig { page: Some(1), ..plain() }).unwrap();
    assert_eq!(by_page.field, scan.field);
    assert_eq!(of("nanosurf_32.nid", "backward", plain()).unwrap().provenance.page, 2);
    // What is no length needs to be told what it is.
    for (name, channel) in [("gwyfile.gwy", "phase"), ("asylum_big.ibw", "Phase")] {
        let message = of(name, channel, plain()).unwrap_err().to_string();
        assert!(message.contains("`height ="), "{message}");
        let scan = of(name, channel, given()).unwrap();
        assert!(scan.provenance.channel.unwrap().to_lowercase().contains("phase"));
    }
    let message = of("gwyfile.gwy", "Adhesion", plain()).unwrap_err().to_string();
    assert!(message.contains("page 0: Phase; page 1: Height; page 2: Amplitude"), "{message}");
}

#[test]
fn a_file_cut_anywhere_is_refused_or_whole() {
    for (name, bytes) in files() {
        let whole = read(&name, &bytes, &ReadConfig::default()).unwrap();
        for length in (0..bytes.len()).step_by(64).chain(0..64) {
            let cut = read(&name, &bytes[..length], &ReadConfig::default());
            // Labels, notes and further channels may follow what is read; rows of text may end early.
            let is_whole = cut.as_ref().is_ok_and(|scan| scan.field == whole.field);
            let is_text = name.ends_with(".txt");
            assert!(cut.is_err() || is_whole || is_text, "{name} cut to {length} of {} bytes", bytes.len());
        }
    }
}

/// Places that hold sizes, in bytes of each format: sizes that lie are found before memory is taken.
#[test]
fn sizes_that_lie_are_refused() {
    let at = |name: &str, place: usize, value: &[u8]| {
        let mut bytes = std::fs::read(folder().join(name)).unwrap();
        bytes[place..place + value.len()].copy_from_slice(value);
        read(name, &bytes, &given()).unwrap_err()
    };
    let huge = 0x7FFF_FFF0u32.to_le_bytes();
    for place in [108, 112] {
        assert!(matches!(at("surfalize.sur", place, &huge), Error::Limit { .. }));
        assert!(matches!(
            at("surfalize.sur", place, &1000u32.to_le_bytes()),
            Error::Limit { .. } | Error::BadFile { .. }
        ));
    }
    for place in [64 + 68, 64 + 72] {
        assert!(matches!(at("asylum_little.ibw", place, &huge), Error::Limit { .. } | Error::BadFile { .. }));
    }
    assert!(matches!(at("asylum_little.ibw", 64 + 76, &huge), Error::BadFile { .. }));
    // In every channel: one that is not read may lie as it likes.
    let replaced = |name: &str, from: &str, to: &str| {
        let latin: String = std::fs::read(folder().join(name)).unwrap().into_iter().map(char::from).collect();
        assert!(latin.contains(from), "{name} has no {from:?}");
        let bytes: Vec<u8> = latin.replace(from, to).chars().map(|character| character as u8).collect();
        read(name, &bytes, &given()).unwrap_err().to_string()
    };
    for (name, from, to) in [
        ("nanoscope_16.spm", "\\Samps/line: 12", "\\Samps/line: 18446744073709551615"),
        ("nanoscope_16.spm", "\\Data offset: 4", "\\Data offset: 9999999994"),
        ("nanosurf_32.nid", "Points=12", "Points=4000000000"),
        ("nanosurf_32.nid", "Lines=9", "Lines=-9"),
        ("wsxm_16.stp", "Number of rows: 9", "Number of rows: 9000000000"),
        ("wsxm_16.stp", "Image header size: ", "Image header size: 1"),
    ] {
        let message = replaced(name, from, to);
        assert!(!message.is_empty(), "{name} with {to}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    /// Flipped bytes give a scan or a refusal, never a panic or more memory than the limit.
    #[test]
    fn flipped_bytes_give_a_scan_or_a_refusal(flips in proptest::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6)) {
        for (name, bytes) in files() {
            // Headers alone matter here: samples may be anything.
            let mut bytes = bytes;
            let header = bytes.len().min(2048);
            for (place, value) in &flips {
                bytes[place.index(header)] = *value;
            }
            for config in [ReadConfig { max_samples: 1 << 16, ..ReadConfig::default() }, given()] {
                if let Ok(scan) = read(&name, &bytes, &config) {
                    prop_assert!(scan.field.heights_nm.iter().all(|height| height.is_finite()));
                    prop_assert!(scan.field.pitch_nm.iter().all(|pitch| *pitch > 0.0 && pitch.is_finite()));
                }
            }
        }
    }
}
