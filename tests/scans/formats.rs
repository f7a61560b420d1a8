//! Scan files of many programs, read to the truth that other software found in them.

use std::path::Path;

use crate::skip::{shared, test_data};
use diffraction_brdf::error::Error;
use diffraction_brdf::files::sha256_hex;
use diffraction_build::height::read::{HeightScale, LengthUnit, ReadConfig, Scan, read_scan};

/// Who gives a calibration: the file, at this place, or the manifest because the file is silent.
enum By {
    File(&'static str),
    Manifest,
}
use By::{File, Manifest};

/// A file, its format and sample type, who gives pitch and height, and its pitch in nm.
type Row = (&'static str, &'static str, &'static str, By, By, [f64; 2]);

const SQUARE: [f64; 2] = [11.71875, 11.71875];

#[rustfmt::skip]
const TABLE: &[Row] = &[
    ("grid_bigtiff_nm.tif",                     "TIFF",        "f32", Manifest,                    Manifest,                    SQUARE),
    ("grid_deflate_pred3_nm.tif",               "TIFF",        "f32", File("resolution tags"),     Manifest,                    SQUARE),
    ("grid_float64_m.tif",                      "TIFF",        "f64", Manifest,                    Manifest,                    SQUARE),
    ("grid_gwyddion262_grey16.tiff",            "TIFF",        "u16", Manifest,                    Manifest,                    SQUARE),
    ("grid_ij_description_um_but_resunit_cm.tif", "ImageJ TIFF", "f32", File("ImageJ description"), File("ImageJ description"), SQUARE),
    ("grid_imagej153t_ij16_cal.tif",            "ImageJ TIFF", "u16", File("ImageJ description"),  File("ImageJ description"),  SQUARE),
    ("grid_imagej153t_ij32_aniso.tif",          "ImageJ TIFF", "f32", File("ImageJ description"),  Manifest,                    [11.71875, 23.4375]),
    ("grid_imagej153t_ij32_cm.tif",             "ImageJ TIFF", "f32", File("ImageJ description"),  Manifest,                    SQUARE),
    ("grid_imagej153t_ij32_mu_vunit_nm.tif",    "ImageJ TIFF", "f32", File("ImageJ description"),  File("ImageJ description"),  SQUARE),
    ("grid_imagej153t_ij32_nm.tif",             "ImageJ TIFF", "f32", File("ImageJ description"),  Manifest,                    SQUARE),
    ("grid_imagej153t_ij32_um.tif",             "ImageJ TIFF", "f32", File("ImageJ description"),  Manifest,                    SQUARE),
    ("grid_imagej153t_ij8_uncal.tif",           "ImageJ TIFF", "u8",  File("ImageJ description"),  Manifest,                    SQUARE),
    ("grid_int32_pm_bigendian.tif",             "TIFF",        "i32", Manifest,                    File("description"),         SQUARE),
    ("grid_lzw_pred3_tiled_nm.tif",             "TIFF",        "f32", File("resolution tags"),     Manifest,                    SQUARE),
    ("grid_ome_nm.ome.tif",                     "OME-TIFF",    "f32", File("OME-XML"),             Manifest,                    SQUARE),
    ("grid_tifffile_imagej_nm.tif",             "ImageJ TIFF", "f32", File("ImageJ description"),  Manifest,                    SQUARE),
    ("grid_tifffile_shaped_m.tif",              "TIFF",        "f32", Manifest,                    Manifest,                    SQUARE),
    ("grid_u16_lzw_pred2.tif",                  "TIFF",        "u16", Manifest,                    Manifest,                    SQUARE),
    ("squares_gwyddion262_grey16.tiff",         "TIFF",        "u16", Manifest,                    Manifest,                    [195.3125, 195.3125]),
];
const REFUSED: &str = "grid_gwyddion262_rgb8_figure.tiff";

/// The heights in nm of a simple field, by the plainest reading of its last bytes.
fn truth_nm(path: &Path) -> Vec<f64> {
    let bytes = std::fs::read(path).unwrap();
    let header: Vec<u8> = bytes.iter().copied().take_while(|&byte| byte != 0).collect();
    let header = String::from_utf8(header).unwrap();
    let side = |key: &str| -> usize {
        let line = header.lines().find(|line| line.starts_with(key)).unwrap();
        line.split('=').nth(1).unwrap().trim().parse().unwrap()
    };
    let size = side("XRes") * side("YRes") * 4;
    bytes[bytes.len() - size..]
        .chunks_exact(4)
        .map(|word| f64::from(f32::from_le_bytes(word.try_into().unwrap())) * 1e9)
        .collect()
}

fn largest_difference(scan: &Scan, truth: &[f64]) -> f64 {
    assert_eq!(scan.field.heights_nm.len(), truth.len());
    let pairs = scan.field.heights_nm.iter().zip(truth);
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// A few rows of some, as their programs wrote them but for three numbers: `tests/data/cut_rows.py`.
#[test]
fn variants_are_read_to_their_truth() {
    let folder = test_data("foreign");
    let here: Vec<&Row> = TABLE.iter().filter(|row| folder.join(row.0).is_file()).collect();
    assert!(!here.is_empty());
    check_variants(&folder, &here, 8);
}

#[test]
#[ignore = "slow: every variant, whole"]
fn every_variant_is_read_to_its_truth() {
    let Some(folder) = shared("tiff-variants") else { return };
    check_variants(&folder, &TABLE.iter().collect::<Vec<_>>(), 256);
}

/// Read as the file is, each row must be accepted or name exactly the keys it lacks; with these keys
/// given, heights must meet the truth within the residual of the file's own number format, plus half
/// a unit in the last place of the truth's 32-bit metres (2^-44 m = 5.7e-5 nm at 1 µm, 8 times that for
/// the 8 µm of the squares).
fn check_variants(folder: &Path, table: &[&Row], rows: usize) {
    let expected = std::fs::read_to_string(folder.join("expected.json")).unwrap();
    let expected: serde_json::Value = serde_json::from_str(&expected).unwrap();
    for (name, format, sample, pitch_by, height_by, pitch) in table {
        let facts = &expected[name];
        let number = |key: &str| facts[key].as_f64().unwrap();
        let path = folder.join(name);
        let as_it_is = read_scan(&path, &ReadConfig::default());
        let lacking = [(pitch_by, "`pitch_nm ="), (height_by, "`height =")];
        match &as_it_is {
            Ok(_) => assert!(lacking.iter().all(|(by, _)| matches!(by, File(_))), "{name}"),
            Err(error) => {
                for (by, key) in lacking {
                    let named = error.to_string().contains(key);
                    assert_eq!(named, matches!(by, Manifest), "{name}: {error}");
                }
            }
        }
        let config = ReadConfig {
            pitch_nm: matches!(pitch_by, Manifest).then_some(*pitch),
            height: matches!(height_by, Manifest).then(|| HeightScale::Linear {
                nm_per_count: number("to_nm_scale"),
                offset_nm: number("to_nm_offset"),
            }),
            ..ReadConfig::default()
        };
        let scan = read_scan(&path, &config).unwrap();
        let facts = &scan.provenance;
        assert_eq!((&*facts.format, &*facts.sample_format), (*format, *sample), "{name}");
        assert_eq!((facts.size, facts.page, facts.missing_samples), ([256, rows], 0, 0), "{name}");
        assert_eq!(facts.sha256, sha256_hex(&std::fs::read(&path).unwrap()));
        assert_eq!(&facts.file_name, name);
        for (by, from, key) in
            [(pitch_by, &facts.pitch_from, "manifest: pitch_nm"), (height_by, &facts.height_from, "manifest: height")]
        {
            match by {
                File(place) => assert_eq!(from, &format!("file: {place}"), "{name}"),
                Manifest => assert_eq!(from, key, "{name}"),
            }
        }
        for (found, expected) in scan.field.pitch_nm.iter().zip(pitch) {
            // ImageJ's fractions of a million are good to 4e-6 where the unit is the nanometre.
            let relative = found / expected - 1.0;
            assert!(relative.abs() < 4.1e-6, "{name}: {:?}", scan.field.pitch_nm);
        }
        let truth = truth_nm(&folder.join(format!("{}.gsf", name.split('_').next().unwrap())));
        let largest = truth.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let tolerance = number("max_abs_residual_nm") + largest * f64::from(f32::EPSILON);
        let difference = largest_difference(&scan, &truth);
        assert!(difference <= tolerance, "{name}: {difference} > {tolerance}");

        // The comparison can fail: upside down, mirrored, or with a scale off by 1 % it does.
        let [nx, ny] = facts.size;
        let flipped: Vec<f64> = (0..nx * ny).map(|i| truth[(ny - 1 - i / nx) * nx + i % nx]).collect();
        let mirrored: Vec<f64> = (0..nx * ny).map(|i| truth[i / nx * nx + nx - 1 - i % nx]).collect();
        let scaled: Vec<f64> = truth.iter().map(|height| height * 1.01).collect();
        for wrong in [flipped, mirrored, scaled] {
            assert!(largest_difference(&scan, &wrong) > 3.0 * tolerance, "{name}");
        }
    }
    check_table_is_complete(folder);
}

/// No sample file may be forgotten.
fn check_table_is_complete(folder: &Path) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let known = TABLE.iter().any(|row| row.0 == name) || name == REFUSED || name == "park_smartscan_512.tiff";
        assert!(known || !name.contains(".tif"), "{name} is in no test");
    }
}

fn check_simple_field(path: &Path, pitch_nm: f64) {
    let scan = read_scan(path, &ReadConfig::default()).unwrap();
    assert_eq!(largest_difference(&scan, &truth_nm(path)), 0.0);
    assert!((scan.field.pitch_nm[1] - pitch_nm).abs() < 1e-9, "{}", path.display());
    assert_eq!(scan.provenance.format, "GSF");
}

#[test]
fn simple_fields_are_read_bit_for_bit() {
    check_simple_field(&test_data("foreign").join("grid.gsf"), 11.71875);
    let Some(folder) = shared("tiff-variants") else { return };
    for (name, pitch_nm) in [("grid.gsf", 11.71875), ("squares.gsf", 195.3125)] {
        check_simple_field(&folder.join(name), pitch_nm);
    }
}

#[test]
fn park_heights_come_from_the_private_tag() {
    let Some(folder) = shared("tiff-variants") else { return };
    let scan = read_scan(&folder.join("park_smartscan_512.tiff"), &ReadConfig::default()).unwrap();
    let truth = truth_nm(&folder.join("park_smartscan_512_truth.gsf"));
    let facts = &scan.provenance;
    assert_eq!((&*facts.format, facts.size), ("Park TIFF", [512, 512]));
    assert_eq!(facts.channel.as_deref(), Some("Z Height"));
    assert!((scan.field.pitch_nm[0] - 1000.0 / 512.0).abs() < 1e-9);
    // Half a unit in the last place of the truth's 32-bit metres.
    let largest = truth.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
    let tolerance = largest * f64::from(f32::EPSILON) / 2.0;
    assert!(largest_difference(&scan, &truth) <= tolerance);
    let inverted: Vec<f64> = truth.iter().map(|height| -height).collect();
    assert!(largest_difference(&scan, &inverted) > 1e3 * tolerance);
}

#[test]
fn a_rendered_figure_is_refused_as_a_picture() {
    let folder = test_data("foreign");
    let config = ReadConfig {
        pitch_nm: Some([10.0, 10.0]),
        height: Some(HeightScale::FullScaleNm(100.0)),
        ..ReadConfig::default()
    };
    let error = read_scan(&folder.join(REFUSED), &config).unwrap_err();
    assert!(matches!(error, Error::BadFile { .. }));
    assert!(error.to_string().contains("colour picture"), "{error}");
}

/// The real scans state everything; their sidecar files say what must come out.
#[test]
fn real_scans_state_their_own_calibration() {
    let Some(folder) = shared("specimens/real") else {
        return;
    };
    let mut read = 0;
    for entry in std::fs::read_dir(&folder).unwrap() {
        let sidecar = entry.unwrap().path();
        if sidecar.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let facts: toml::Table = std::fs::read_to_string(&sidecar).unwrap().parse().unwrap();
        let number = |key: &str| {
            let value = &facts[key];
            value.as_float().or(value.as_integer().map(|n| n as f64)).unwrap()
        };
        let scan = read_scan(&sidecar.with_extension("tif"), &ReadConfig::default()).unwrap();
        let name = sidecar.display();
        let size = [number("width_px") as usize, number("height_px") as usize];
        assert_eq!(scan.provenance.size, size, "{name}");
        let pitch = [number("pixel_width_nm"), number("pixel_height_nm")];
        assert_eq!(scan.field.pitch_nm, pitch, "{name}");
        assert_eq!(scan.provenance.height_from, "file: description", "{name}");
        assert_eq!(scan.provenance.warnings, [""; 0], "{name}");
        let low = scan.field.heights_nm.iter().copied().fold(f64::MAX, f64::min);
        let high = scan.field.heights_nm.iter().copied().fold(f64::MIN, f64::max);
        // The sidecar rounds to six digits.
        for (found, key) in [(low, "z_min_nm"), (high, "z_max_nm")] {
            let stated = number(key);
            assert!((found - stated).abs() <= 5e-6 * stated.abs() + 1e-9, "{name}: {found} {stated}");
        }
        read += 1;
    }
    assert!(read >= 6, "only {read} sidecar files found");
}

/// ImageJ's info text gives the height unit where the description does not.
#[test]
fn published_scans() {
    let Some(folder) = shared("specimens") else {
        return;
    };
    let scan = read_scan(&folder.join("xenopeltis_unicolor.tif"), &ReadConfig::default()).unwrap();
    assert_eq!(scan.provenance.size, [1332, 1332]);
    assert_eq!(scan.provenance.height_from, "file: ImageJ info text");
    assert!((scan.field.pitch_nm[0] - 65e3 / 1332.0).abs() < 1e-9);

    // The other one is silent: both keys are needed, and the whole integer range is the height given.
    let elaphe = folder.join("elaphe_guttata.tif");
    let message = read_scan(&elaphe, &ReadConfig::default()).unwrap_err().to_string();
    assert!(message.contains("`pitch_nm =") && message.contains("full_scale_nm"), "{message}");
    let mut config = ReadConfig {
        pitch_nm: Some([48.8, 48.8]),
        height: Some(HeightScale::FullScaleNm(375.0)),
        ..ReadConfig::default()
    };
    let scan = read_scan(&elaphe, &config).unwrap();
    let in_range = |height: &f64| (0.0..=375.0).contains(height);
    assert!(scan.field.heights_nm.iter().all(in_range));
    config.height = Some(HeightScale::Linear { nm_per_count: 375.0 / 65535.0, offset_nm: 0.0 });
    assert_eq!(read_scan(&elaphe, &config).unwrap().field, scan.field);

    // A full scale makes no sense for floats.
    config.height = Some(HeightScale::FullScaleNm(375.0));
    let error = read_scan(&folder.join("blazed_2500nm.tif"), &config).unwrap_err();
    assert!(error.to_string().contains("a full scale is for integer samples"), "{error}");
    config.height = Some(HeightScale::Unit(LengthUnit::Nm));
    assert!(read_scan(&folder.join("blazed_2500nm.tif"), &config).is_ok());
}
