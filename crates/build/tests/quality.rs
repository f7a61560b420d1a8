//! Quality of scans that lie beside the checkout and in `specimens/`: faults under their names, none in good ones, and their periods.

#[macro_use]
#[path = "../../../tests/common/skip.rs"]
mod skip;

use std::path::{Path, PathBuf};

use diffraction_build::height::HeightField;
use diffraction_build::height::prepare::{Level, PrepareConfig, prepare};
use diffraction_build::height::quality::{Advice, Fault, Remedy, advise};
use diffraction_build::height::read::{HeightScale, LengthUnit, ReadConfig, read_scan};
use diffraction_build::height::statistics::{Period, statistics};

fn root(folder: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(folder)
}

/// A folder beside the checkout, or a loud word that it is missing.
fn shared(folder: &str) -> Option<PathBuf> {
    // An absolute path stands for itself.
    skip::shared(root("../shared").join(folder).to_str()?)
}

fn read(path: &Path) -> HeightField {
    let mut config = ReadConfig::default();
    if path.file_stem().is_some_and(|name| name == "elaphe_guttata") {
        config.pitch_nm = Some([48.8; 2]);
        config.height = Some(HeightScale::FullScaleNm(375.0));
    } else if path.parent().is_some_and(|folder| folder.ends_with("real")) || path.ends_with("xenopeltis_unicolor.tif")
    {
        config.height = Some(HeightScale::Unit(LengthUnit::Nm));
    }
    read_scan(path, &config).unwrap_or_else(|error| panic!("{error}")).field
}

fn scans_in(folder: &Path) -> Vec<PathBuf> {
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut scans: Vec<PathBuf> = files.filter(|path| path.extension().is_some_and(|end| end == "tif")).collect();
    scans.sort();
    scans
}

fn told(advice: &Advice) -> String {
    advice.findings.iter().map(|finding| format!("{:?}: {}\n", finding.fault, finding.sentence)).collect()
}

#[test]
fn bundled_scans_are_good() {
    for path in scans_in(&root("specimens")) {
        let advice = advise(&read(&path)).unwrap();
        assert!(advice.findings.is_empty(), "{}: {}", path.display(), told(&advice));
    }
}

#[test]
fn scans_beside_the_checkout_are_good() {
    let Some(folder) = shared("specimens") else { return };
    let mut scans = scans_in(&folder);
    scans.extend(scans_in(&folder.join("real")));
    scans.push(folder.join("../cases/artefacts/clean.tif"));
    for path in scans.iter().filter(|path| path.is_file()) {
        let advice = advise(&read(path)).unwrap();
        assert!(advice.findings.is_empty(), "{}: {}", path.display(), told(&advice));
    }
}

#[test]
fn each_artefact_is_told_under_its_name_with_what_mends_it() {
    let Some(folder) = shared("cases/artefacts") else { return };
    let table: [(&str, Fault, &[Remedy], bool); 13] = [
        ("half_zero", Fault::LostLines, &[Remedy::Crop([0, 0, 256, 128])], true),
        ("half_min", Fault::LostLines, &[Remedy::Crop([0, 0, 256, 128])], true),
        ("lost_line_1", Fault::LostLines, &[Remedy::Despike], true),
        ("nodata_-9999_16px", Fault::NoData, &[Remedy::MissingValue(-9999.0)], true),
        ("saturated_40pct", Fault::Saturation, &[], false),
        ("dust_1um_16px", Fault::Blobs, &[Remedy::Despike], true),
        ("spike_100um_1px", Fault::Blobs, &[Remedy::Despike], true),
        ("tilt_3um", Fault::Tilt, &[], true),
        ("bow_300nm", Fault::Bow, &[Remedy::Quadratic], true),
        ("line_noise_20nm", Fault::LineOffsets, &[Remedy::Rows], true),
        ("scars_12", Fault::Scars, &[Remedy::Despike], true),
        ("stitch_step_50nm", Fault::Step, &[Remedy::Crop([0, 0, 128, 256])], true),
        ("hum_20nm", Fault::Hum, &[], false),
    ];
    for (name, fault, settings, is_mended) in table {
        let advice = advise(&read(&folder.join(name).with_extension("tif"))).unwrap();
        let faults: Vec<Fault> = advice.findings.iter().map(|finding| finding.fault).collect();
        assert_eq!(faults, [fault], "{name}: {}", told(&advice));
        assert_eq!(advice.settings, settings, "{name}: {}", told(&advice));
        assert_eq!(advice.left.is_empty(), is_mended, "{name}: {}", told(&advice));
    }
}

#[test]
fn undeclared_marks_are_told() {
    let Some(folder) = shared("cases/scans") else { return };
    let advice = advise(&read(&folder.join("nd_notag_-9999.tif"))).unwrap();
    assert_eq!(advice.settings, [Remedy::MissingValue(-9999.0)], "{}", told(&advice));
    let far = read_scan(&folder.join("nd_1e38.tif"), &ReadConfig::default()).unwrap_err().to_string();
    assert!(far.contains("`missing_value = 1e38`"), "{far}");
    let declared = ReadConfig { missing_value: Some(1e38), ..ReadConfig::default() };
    let scan = read_scan(&folder.join("nd_1e38.tif"), &declared).unwrap();
    assert!(scan.provenance.missing_samples > 0);
}

fn periods(path: &Path) -> Vec<Period> {
    let plane = PrepareConfig { level: Level::Plane, despike: None, blend_nm: None };
    statistics(&prepare(&read(path), &plane).unwrap().0, 380.0).dominant_periods
}

#[test]
fn the_track_of_a_stamper_is_found_between_the_lines() {
    let Some(folder) = shared("cases/scans") else { return };
    let found = periods(&folder.join("per_track.tif"));
    // 1514 nm are 6.6 lines of 10 µm.
    assert!((found[0].period_nm / 1514.0 - 1.0).abs() < 0.02, "{found:?}");
    assert!(found[1..].iter().all(|period| period.relative_power < 0.2), "{found:?}");
}

#[test]
fn surfaces_that_repeat_nothing_have_no_period() {
    let Some(folder) = shared("cases/scans") else { return };
    for name in ["per_bump", "per_step", "per_walk", "per_low_10", "per_rows"] {
        let found = periods(&folder.join(name).with_extension("tif"));
        assert!(found.is_empty(), "{name}: {found:?}");
    }
}
