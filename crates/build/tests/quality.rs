//! Quality of scans that lie beside the checkout and in `specimens/`: faults under their names, none in good ones, and their periods.

#[macro_use]
#[path = "../../../tests/common/skip.rs"]
mod skip;

use std::f64::consts::TAU;
use std::path::{Path, PathBuf};

use diffraction_brdf::direction::{Vec3, from_angles_deg};
use diffraction_brdf::spectrum::{Illuminant, Line};
use diffraction_build::height::HeightField;
use diffraction_build::height::prepare::{Level, PrepareConfig, prepare};
use diffraction_build::height::quality::{Advice, Fault, Remedy, advise};
use diffraction_build::height::read::{HeightScale, LengthUnit, ReadConfig, read_scan};
use diffraction_build::height::statistics::{Period, statistics};
use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
use diffraction_build::optics::spectra::SpectraConfig;
use diffraction_build::optics::spectral::brdf_xyz_batch;
use ndarray::Array2;

fn root(folder: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(folder)
}

/// A folder beside the checkout, or a loud word that it is missing.
fn shared(folder: &str) -> Option<PathBuf> {
    // An absolute path stands for itself.
    skip::shared(root("../shared").join(folder).to_str()?)
}

fn read(path: &Path) -> HeightField {
    let name = path.file_stem().unwrap().to_string_lossy();
    let mut config = ReadConfig::default();
    // What these files do not say themselves.
    if name == "elaphe_guttata" {
        config.pitch_nm = Some([48.8; 2]);
        config.height = Some(HeightScale::FullScaleNm(375.0));
    } else if path.parent().is_some_and(|folder| folder.ends_with("real"))
        || ["xenopeltis_unicolor", "grating_nanosurf_314nm"].contains(&name.as_ref())
    {
        config.height = Some(HeightScale::Unit(LengthUnit::Nm));
    } else if ["blazed_2500nm", "sinusoid_1600nm", "nd_notag_-9999"].contains(&name.as_ref()) {
        config.pitch_nm = Some([50.0; 2]);
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
    let config = || ReadConfig {
        pitch_nm: Some([50.0; 2]),
        height: Some(HeightScale::Unit(LengthUnit::Nm)),
        ..ReadConfig::default()
    };
    let far = read_scan(&folder.join("nd_1e38.tif"), &config()).unwrap_err().to_string();
    assert!(far.contains("`missing_value = 1e38`"), "{far}");
    let declared = ReadConfig { missing_value: Some(1e38), ..config() };
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
fn what_repeats_nothing_has_no_period() {
    let Some(folder) = shared("cases/scans") else { return };
    for name in ["per_bump", "per_low_10", "per_step", "per_rows", "per_walk"] {
        let found = periods(&folder.join(name).with_extension("tif"));
        assert!(found.is_empty(), "{name}: {found:?}");
    }
}

/// BRDF at the directions of `d.csv` at three wavelengths, of an ideal reflector under sigma = 3 µm, repeated.
fn brdf(field: &HeightField, folder: &Path) -> Vec<f64> {
    let text = std::fs::read_to_string(folder.join("d.csv")).unwrap();
    let pairs: Vec<(Vec3, Vec3)> = text
        .lines()
        .skip(1)
        .map(|line| {
            let deg: Vec<f64> = line.split(',').map(|number| number.trim().parse().unwrap()).collect();
            (from_angles_deg(deg[0], deg[1]), from_angles_deg(deg[2], deg[3]))
        })
        .collect();
    [450.0, 550.0, 650.0]
        .into_iter()
        .flat_map(|wavelength_nm| {
            let light = Illuminant::Lines(vec![Line { wavelength_nm, power: 1.0 }]);
            let optics = OpticsConfig::ideal(light, 3000.0, Edge::Tile, Windows::Grid);
            let config = SpectraConfig {
                phase_scale_per_nm: [0.0, 2.0 * TAU / wavelength_nm],
                frequency: [[-2.0 / wavelength_nm, 2.0 / wavelength_nm]; 2],
                tolerance: 1e-5,
                memory_bytes: 1 << 31,
            };
            brdf_xyz_batch(std::slice::from_ref(field), &optics, &config, &pairs).unwrap()
        })
        .map(|[_, y, _]| y)
        .collect()
}

/// Median and 90th percentile of the relative differences.
fn differences(found: &[f64], clean: &[f64]) -> [f64; 2] {
    let mut off: Vec<f64> = found.iter().zip(clean).map(|(found, clean)| (found / clean - 1.0).abs()).collect();
    off.sort_by(f64::total_cmp);
    [off[off.len() / 2], off[9 * off.len() / 10]]
}

/// The table of `docs/scans.md`. A part of a scan is another sample of the same surface, so what is cropped is held against the same part of
/// the clean scan.
#[test]
fn settings_bring_the_light_of_a_faulty_scan_back() {
    let Some(folder) = shared("cases/artefacts") else { return };
    let clean = read(&folder.join("clean.tif"));
    let plane = |field: &HeightField| {
        prepare(field, &PrepareConfig { level: Level::Plane, despike: None, blend_nm: None }).unwrap().0
    };
    let of_clean = brdf(&plane(&clean), &folder);
    // What is cropped is exactly that part of the clean scan; the others come closer to it, as far as what was masked or taken away lets them.
    let names = [
        "half_zero",
        "lost_line_1",
        "nodata_-9999_16px",
        "dust_1um_16px",
        "bow_300nm",
        "line_noise_20nm",
        "scars_12",
        "stitch_step_50nm",
    ];
    for name in names {
        let faulty = read(&folder.join(name).with_extension("tif"));
        let advice = advise(&faulty).unwrap();
        let before = differences(&brdf(&plane(&faulty), &folder), &of_clean);
        let after = match advice.settings[..] {
            [Remedy::Crop([x, y, width, height])] => {
                let part = Array2::from_shape_fn((height, width), |(j, i)| clean.heights_nm[[y + j, x + i]]);
                let part = HeightField { heights_nm: part, pitch_nm: clean.pitch_nm };
                differences(&brdf(&advice.prepared, &folder), &brdf(&plane(&part), &folder))
            }
            _ => differences(&brdf(&advice.prepared, &folder), &of_clean),
        };
        let is_cropped = matches!(advice.settings[..], [Remedy::Crop(_)]);
        println!("| {name} | {:.3} / {:.3} | {:.3} / {:.3} |", before[0], before[1], after[0], after[1]);
        let most = if is_cropped { [1e-9; 2] } else { before };
        assert!(after[0] < most[0] && after[1] < most[1], "{name}: {before:?} {after:?}");
    }
}

#[test]
fn periods_of_good_scans_are_still_found() {
    let first = |path: PathBuf| periods(&path).first().map(|period| period.period_nm);
    let bundled = [
        ("corn_snake_like", 1140.0),
        ("sunbeam_snake_like", 1550.0),
        ("cd_track_like", 1600.0),
        ("blazed_2500nm", 2500.0),
        ("sinusoid_1600nm", 1600.0),
        ("grating_nanosurf_314nm", 314.3),
    ];
    for (name, period_nm) in bundled {
        let found = first(root("specimens").join(name).with_extension("tif"));
        assert!(found.is_some_and(|found| (found / period_nm - 1.0).abs() < 0.05), "{name}: {found:?}");
    }
    let Some(folder) = shared("specimens/real") else { return };
    let real = [
        ("butterfly-vcardui-10x3", Some(1681.0)),
        ("grating-silicon-3um", Some(3000.0)),
        ("polymer-sbs-pmma-25um", None),
        ("rough-film-dimension-10um", None),
    ];
    for (name, expected) in real {
        let found = first(folder.join(name).with_extension("tif"));
        let agrees = match (found, expected) {
            (Some(found), Some(expected)) => f64::abs(found / expected - 1.0) < 0.1,
            (found, expected) => found == expected,
        };
        assert!(agrees, "{name}: {found:?}");
    }
}
