//! Statistics of real scans, against what other software and the literature found in them.

use std::path::Path;

use crate::skip::shared;
use diffraction_build::height::HeightField;
use diffraction_build::height::prepare::{Despike, Level, PrepareConfig, prepare};
use diffraction_build::height::read::{HeightScale, LengthUnit, ReadConfig, read_scan};
use diffraction_build::height::statistics::{Period, Statistics, statistics};

fn read(path: &Path, config: &ReadConfig) -> HeightField {
    read_scan(path, config).unwrap_or_else(|error| panic!("{error}")).field
}

fn of_plane_levelled(field: &HeightField) -> Statistics {
    let config = PrepareConfig { level: Level::Plane, despike: None, blend_nm: None };
    statistics(&prepare(field, &config).unwrap().0, 380.0)
}

/// Grating vector of a period in lines of the scan's spectrum, along +x and +y.
fn lines(period_nm: f64, direction_deg: f64, field: &HeightField) -> [f64; 2] {
    let (sin, cos) = direction_deg.to_radians().sin_cos();
    let extent = field.extent_nm();
    [extent[0] * cos / period_nm, extent[1] * sin / period_nm]
}

/// Distance of two grating vectors, whose signs mean nothing.
fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1]).min((a[0] + b[0]).hypot(a[1] + b[1]))
}

#[test]
fn real_scans_agree_with_their_notes() {
    let Some(folder) = shared("specimens") else { return };
    // The rms and the range in nm after a plane fit by NumPy's least squares (lstsq), and whether the surface
    // has periods, going by its description.
    let table = [
        ("butterfly-vcardui-10x3", 44.176190720117894, 371.8308191766197, true),
        ("butterfly-vcardui-41pct", 34.258516583324926, 209.18674559738577, true),
        ("grating-nanosurf-314nm", 17.288945652963932, 63.769468686297614, true),
        ("grating-silicon-3um", 204.46290365273927, 572.1299384455633, true),
        ("polymer-sbs-pmma-25um", 25.625798089576197, 239.9042076889159, false),
        ("rough-film-dimension-10um", 14.319335162920018, 112.13149741206182, false),
    ];
    for (name, rms_nm, range_nm, periodic) in table {
        let path = folder.join("real").join(name).with_extension("tif");
        let notes: toml::Table = std::fs::read_to_string(path.with_extension("toml")).unwrap().parse().unwrap();
        let field = read(&path, &ReadConfig::default());
        let found = of_plane_levelled(&field);
        // Heights up to 2300 nm in sums of 262144 terms, in two orders.
        assert!((found.rms_height_nm / rms_nm - 1.0).abs() < 1e-9, "{name}: {found:?}");
        assert!((found.peak_to_valley_nm / range_nm - 1.0).abs() < 1e-9, "{name}: {found:?}");
        assert_eq!(found.dominant_periods.is_empty(), !periodic, "{name}: {found:?}");
        if let Some(first) = found.dominant_periods.first() {
            let noted = |key: &str| notes[key][0].as_float().unwrap();
            // The notes have y downwards, and lines or half lines of the spectrum as they are.
            let expected = lines(noted("strongest_periods_nm"), -noted("period_directions_deg"), &field);
            let apart = distance(lines(first.period_nm, first.direction_deg, &field), expected);
            assert!(apart < 0.5, "{name}: {apart} lines, {first:?}");
        }
    }
}

#[test]
fn the_mirrored_direction_would_be_seen() {
    let Some(folder) = shared("specimens") else { return };
    let field = read(&folder.join("real/grating-nanosurf-314nm.tif"), &ReadConfig::default());
    let Period { period_nm, direction_deg, .. } = of_plane_levelled(&field).dominant_periods[0];
    let right = lines(period_nm, direction_deg, &field);
    assert!(distance(right, lines(314.3, -135.0, &field)) < 0.5);
    assert!(distance(right, lines(314.3, 135.0, &field)) > 5.0);
}

#[test]
fn published_scans_show_their_published_periods() {
    let Some(folder) = shared("specimens") else { return };
    let despike = Some(Despike { threshold_rms: 8.0 });
    let scan = |file: &str, height| {
        let config = ReadConfig { pitch_nm: Some([48.8; 2]), height: Some(height), ..ReadConfig::default() };
        let field = read(&folder.join(file), &config);
        let config = PrepareConfig { level: Level::Plane, despike, blend_nm: Some(2000.0) };
        let (prepared, record) = prepare(&field, &config).unwrap();
        // Dust there is, but little of it.
        assert!((1..field.heights_nm.len() / 100).contains(&record.spikes), "{record:?}");
        statistics(&prepared, 380.0)
    };
    let corn_snake = scan("elaphe_guttata.tif", HeightScale::FullScaleNm(375.0));
    let sunbeam_snake = scan("xenopeltis_unicolor.tif", HeightScale::Unit(LengthUnit::Nm));
    // Both gratings vary by some per cent over the scan. Rows of fingers run along y in the first, along x in the second.
    for (found, period_nm, direction_deg) in [(corn_snake, 1140.0, 180.0), (sunbeam_snake, 1550.0, 90.0)] {
        let first = found.dominant_periods[0];
        assert!((first.period_nm / period_nm - 1.0).abs() < 0.05, "{found:?}");
        assert!((first.direction_deg - direction_deg).abs() < 10.0, "{found:?}");
        assert_eq!(found.usable_uv_radius, 2.0);
    }
}
