//! Measured reflectance: a "measurement" written from closed forms is met, and a wrong surface is not.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;
use std::path::Path;

use crate::common::optics_forms::{front, gaussian};
use crate::common::surfaces::{PLACEMENTS, flat, laser, lobe_deviation, random, sampled, tables_config};
use diffraction_atlas::stages::measured::{self, CurveResult, MeasuredConfig, MeasuredResult};
use diffraction_brdf::SpectralTables;
use diffraction_brdf::direction::{from_angles_deg, wave_vector_change};
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, Material, OpticsConfig, Windows};
use diffraction_build::optics::reference::brdf_spectrum;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::spectral::{SpectralInput, build_spectral};

const PERIOD_NM: f64 = 1_600.0;
const AMPLITUDE_NM: f64 = 60.0;
const SIGMA_NM: f64 = 4_000.0;
const MEMORY_BYTES: u64 = 1 << 30;

/// 16 periods along x; the pitch scales with the period.
fn sinusoid(period_nm: f64) -> HeightField {
    let pitch = period_nm / 32.0;
    sampled([512, 8], [pitch, 200.0], |x, _| AMPLITUDE_NM * (TAU * x / period_nm).cos())
}

fn optics() -> OpticsConfig {
    laser(&[550.0], SIGMA_NM, Edge::Tile, Windows::Grid)
}

/// The BRDF of the sinusoid in 1/sr by the grating equation: order m at `u = m λ / d` with `J_m²(k w a)`.
fn closed_form([theta_i, phi_i, theta_r, phi_r]: [f64; 4], nm: f64) -> f64 {
    let (wi, wo) = (from_angles_deg(theta_i, phi_i), from_angles_deg(theta_r, phi_r));
    let q = wave_vector_change(wi, wo);
    let deviation = lobe_deviation(SIGMA_NM, nm);
    let order = |m: i32| {
        let weight = libm::jn(m, TAU / nm * q[2] * AMPLITUDE_NM).powi(2);
        weight * gaussian(q[0] - f64::from(m) * nm / PERIOD_NM, q[1], deviation)
    };
    front(Material::Ideal, wi, wo) * (-6..=6).map(order).sum::<f64>()
}

/// Angles and wavelengths: spectra at three viewing angles, and a scan over the first orders at 532 nm.
fn geometry() -> Vec<([f64; 4], f64)> {
    let mut rows = Vec::new();
    for theta_r in [17.0, 20.0, 24.0] {
        rows.extend((0..=80).map(|i| ([0.0, 0.0, theta_r, 0.0], 380.0 + 5.0 * f64::from(i))));
    }
    rows.extend((0..=80).map(|i| ([10.0, 0.0, -40.0 + f64::from(i), 0.0], 532.0)));
    rows
}

fn file(folder: &Path, kind: &str, value: impl Fn([f64; 4], f64) -> f64) -> MeasuredConfig {
    let mut text = format!("theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,wavelength_nm,{kind}\n");
    for (angles, nm) in geometry() {
        let [a, b, c, d] = angles;
        writeln!(text, "{a},{b},{c},{d},{nm},{:e}", value(angles, nm)).unwrap();
    }
    let file = folder.join("r.csv");
    std::fs::write(&file, text).unwrap();
    MeasuredConfig { file, acceptance_deg: 0.0, bandwidth_nm: 0.0, export: None }
}

fn compared(field: &HeightField, optics: &OpticsConfig, config: &MeasuredConfig) -> MeasuredResult {
    let measurement = measured::read(config).unwrap();
    measured::compare(std::slice::from_ref(field), optics, None, &measurement, "r.csv".into(), MEMORY_BYTES).unwrap()
}

fn along<'a>(result: &'a MeasuredResult, coordinate: &str) -> Vec<&'a CurveResult> {
    result.columns[0].curves.iter().filter(|curve| curve.along == coordinate).collect()
}

/// What the transforms may be off by: their depth interpolation errs by 1e-7 of the window's whole amplitude,
/// against amplitudes of J_1 = 0.5 and more where there is any light to speak of; they are stored in f32 (6e-8).
const TRANSFORM: f64 = 1e-6;

#[test]
fn the_bundled_file_is_the_closed_form() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("specimens/sinusoid_1600nm.closed_form.csv");
    let bundled =
        measured::read(&MeasuredConfig { file, acceptance_deg: 0.0, bandwidth_nm: 0.0, export: None }).unwrap();
    assert!(bundled.notes.is_empty() && bundled.columns.len() == 1);
    for (row, value) in bundled.columns[0].values.iter().enumerate() {
        let expected = closed_form(bundled.angles_deg[row], bundled.wavelength_nm[row]);
        // Seven digits are written.
        assert!((value / expected - 1.0).abs() < 6e-7, "row {row}: {value} {expected}");
    }
}

/// Spectral tables of a sinusoid, fine enough for a tenth of a percent.
fn spectral_tables(period_nm: f64, shortest_nm: f64) -> SpectralTables {
    let optics = OpticsConfig {
        illuminant: Illuminant::E,
        wavelength_nm: [shortest_nm, 780.0],
        ..OpticsConfig::ideal(Illuminant::E, SIGMA_NM, Edge::Tile, Windows::Grid)
    };
    let tables = tables_config(1e-3, None);
    let fields = [sinusoid(period_nm)];
    let settings = SpectralInput::new(&optics, &tables);
    build_spectral(&BuildInput::new(&fields, &optics, &tables), &settings, &|_| ()).unwrap().tables
}

#[test]
fn spectral_tables_meet_the_closed_form_where_they_answer() {
    let folder = tempfile::tempdir().unwrap();
    let (field, optics) = (sinusoid(PERIOD_NM), optics());
    let config = file(folder.path(), "brdf_per_sr", closed_form);
    let measurement = measured::read(&config).unwrap();
    let compared = |tables: Option<&SpectralTables>| {
        let fields = std::slice::from_ref(&field);
        measured::compare(fields, &optics, tables, &measurement, "r.csv".into(), MEMORY_BYTES).unwrap()
    };
    let by_scan = compared(None);
    let by_tables = compared(Some(&spectral_tables(PERIOD_NM, 380.0)));
    assert!(
        by_tables.notes.is_empty() && by_tables.columns[0].relative_l2 < 1e-3,
        "{:?}",
        by_tables.columns[0].relative_l2
    );
    // They are another way, and it is theirs that is taken: tables of another surface are seen.
    assert!(by_tables.columns[0].relative_l2 > 10.0 * by_scan.columns[0].relative_l2);
    assert!(compared(Some(&spectral_tables(1.05 * PERIOD_NM, 380.0))).columns[0].relative_l2 > 0.5);
    // Where they begin too late the scan answers, and the figures say so.
    let late = compared(Some(&spectral_tables(PERIOD_NM, 420.0)));
    assert_eq!(late.columns, by_scan.columns);
    assert!(late.notes[0].contains("from the scan") && late.notes[0].contains("begin at 420 nm"), "{:?}", late.notes);
}

#[test]
fn every_kind_meets_the_closed_form() {
    let folder = tempfile::tempdir().unwrap();
    let field = sinusoid(PERIOD_NM);
    let cosine = |angles: [f64; 4]| angles[2].to_radians().cos();
    type Value = fn(f64, f64) -> f64;
    let kinds: [(&str, Value, f64); 6] = [
        ("brdf_per_sr", |f, _| f, 1.0),
        ("scatter_per_sr", |f, cos| f * cos, 1.0),
        ("radiance_factor", |f, _| PI * f, 1.0),
        ("reflectance_factor_percent", |f, _| 100.0 * PI * f, 1.0),
        ("relative_radiance", |f, _| 7.5 * f, 7.5),
        ("relative_power", |f, cos| 0.02 * f * cos, 0.02),
    ];
    for (kind, value, scale) in kinds {
        let config = file(folder.path(), kind, |angles, nm| value(closed_form(angles, nm), cosine(angles)));
        let result = compared(&field, &optics(), &config);
        let column = &result.columns[0];
        println!("{kind}: {:.1e}, 1 - r = {:.1e}", column.relative_l2, 1.0 - column.correlation);
        assert!(column.relative_l2 < TRANSFORM, "{kind}: {}", column.relative_l2);
        assert!(1.0 - column.correlation < TRANSFORM);
        assert!((column.scale / scale - 1.0).abs() < TRANSFORM, "{kind}: {}", column.scale);
        assert_eq!(column.values, geometry().len());
    }
    // Taken for another kind, the same numbers are off: cosines of 0.93, and the factor π.
    let config = file(folder.path(), "scatter_per_sr", closed_form);
    assert!(compared(&field, &optics(), &config).columns[0].relative_l2 > 0.03);
    let config = file(folder.path(), "radiance_factor", closed_form);
    let column = &compared(&field, &optics(), &config).columns[0];
    assert!(column.relative_l2 > 2.0 && (column.best_scale * PI - 1.0).abs() < TRANSFORM);
}

#[test]
fn a_rough_surface_meets_the_direct_sum_under_every_window() {
    let fields = [1, 2].map(|seed| random([96, 80], [100.0, 120.0], 400.0, 60.0, seed));
    let folder = tempfile::tempdir().unwrap();
    for (edge, windows) in PLACEMENTS {
        let material = Material::Conductor { n: 0.9, k: 6.2 };
        let optics = OpticsConfig { material, shadowing: true, ..laser(&[550.0], 1_000.0, edge, windows) };
        let rows =
            [([0.0, 0.0, 3.0, 40.0], 400.0), ([30.0, 20.0, 55.0, 170.0], 633.0), ([60.0, 0.0, -10.0, 300.0], 500.0)];
        let exact = rows.map(|([theta_i, phi_i, theta_r, phi_r], nm)| {
            let (wi, wo) = (from_angles_deg(theta_i, phi_i), from_angles_deg(theta_r, phi_r));
            brdf_spectrum(&fields, &optics, wi, wo, &[nm]).unwrap()[0]
        });
        let mut text = "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,wavelength_nm,brdf_per_sr\n".to_owned();
        for (([a, b, c, d], nm), value) in rows.iter().zip(exact) {
            writeln!(text, "{a},{b},{c},{d},{nm},{value:e}").unwrap();
        }
        let file = folder.path().join("rough.csv");
        std::fs::write(&file, text).unwrap();
        let config = MeasuredConfig { file, acceptance_deg: 0.0, bandwidth_nm: 0.0, export: None };
        let measurement = measured::read(&config).unwrap();
        let against = |optics: &OpticsConfig| {
            let result = measured::compare(&fields, optics, None, &measurement, String::new(), MEMORY_BYTES).unwrap();
            result.columns[0].relative_l2
        };
        let found = against(&optics);
        println!("{edge:?} {windows:?}: {found:.1e}");
        // Single precision of the transforms, and 1e-6 of the amplitude by the kernel between their lines.
        assert!(found < 1e-5, "{edge:?} {windows:?}: {found}");
        assert!(against(&OpticsConfig { material: Material::Ideal, ..optics.clone() }) > 1e-2);
        assert!(against(&OpticsConfig { sigma_nm: 1_010.0, ..optics.clone() }) > 1e-3);
    }
}

#[test]
fn a_wrong_pitch_moves_the_peaks_as_the_grating_equation_says() {
    const STRETCH: f64 = 1.01;
    let folder = tempfile::tempdir().unwrap();
    let config = file(folder.path(), "brdf_per_sr", closed_form);
    let right = compared(&sinusoid(PERIOD_NM), &optics(), &config);
    let wrong = compared(&sinusoid(STRETCH * PERIOD_NM), &optics(), &config);
    assert!(wrong.columns[0].relative_l2 > 1e3 * right.columns[0].relative_l2);

    let (spectra, scans) = (along(&wrong, "wavelength_nm"), along(&wrong, "theta_r_deg"));
    assert_eq!((spectra.len(), scans.len()), (3, 1));
    for curve in along(&right, "wavelength_nm").into_iter().chain(along(&right, "theta_r_deg")) {
        assert!(curve.peak_counts[0] == curve.peak_counts[1] && curve.peaks.len() == curve.peak_counts[0]);
        assert!(curve.peaks.iter().all(|peak| (peak.measured - peak.model).abs() < 1e-4), "{:?}", curve.peaks);
    }
    // Straight down, order 1 is seen at λ = d sin θ: its wavelength grows by 1 %. The envelope pulls both peaks
    // down, by less than 1 % of λ (a lobe of 0.013 / 0.29 = 4.5 %, squared, times a logarithmic slope of 4 or
    // less: J_1² and the lobe's peak both fall like 1/λ²). The lobe being 1 % wider, the pull differs by 2 % of
    // itself, and by as much again with the slope.
    for curve in spectra {
        let [peak] = curve.peaks[..] else { panic!("{:?}", curve.peaks) };
        let grating_nm = PERIOD_NM * curve.angles_deg[2].to_radians().sin();
        assert!((peak.measured / grating_nm - 1.0).abs() < 1e-2, "{peak:?} {grating_nm}");
        let shift = (peak.model - peak.measured) / peak.measured;
        assert!((shift - (STRETCH - 1.0)).abs() < 4e-4, "{shift}");
    }
    // sin θ_r = -sin 10° - m λ / d.
    let [scan] = scans[..] else { panic!() };
    let angle = |m: f64, period: f64| (-(10f64.to_radians().sin() + m * 532.0 / period)).asin().to_degrees();
    let orders = [1.0, 0.0, -1.0, -2.0];
    assert_eq!(scan.peaks.len(), orders.len(), "{:?}", scan.peaks);
    for (peak, m) in scan.peaks.iter().zip(orders) {
        let expected = angle(m, STRETCH * PERIOD_NM) - angle(m, PERIOD_NM);
        // Lobes of 0.9° sampled every h = 1°: the logarithm of a Gaussian in sin θ has a cubic term in θ, tan θ
        // times the square one, which displaces the vertex by up to tan θ h² / 2 = 0.005° at 30°.
        let shift = peak.model - peak.measured;
        println!("order {m}: {:.3} deg, shift {shift:.4}, expected {expected:.4}", peak.measured);
        assert!((shift - expected).abs() < 5e-3, "order {m}: {shift} against {expected}");
    }
}

#[test]
fn a_mirrors_cone_catches_the_gaussian_share() {
    // Straight down, ∫ f cosθ dω over a cone of half angle a is 1 - exp(-sin²a / 2s²) but for G/w² = 1/cosθ and
    // what lies between: below 1 + a². The sunflower is a midpoint rule in sin²: 1/(24 N²) of second derivatives.
    let folder = tempfile::tempdir().unwrap();
    let mirror = flat([64, 64], [100.0, 100.0]);
    let path = folder.path().join("m.csv");
    std::fs::write(
        &path,
        "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,wavelength_nm,cone_reflectance\n0,0,0,0,550,1\n",
    )
    .unwrap();
    let caught = |acceptance_deg: f64| {
        let config = MeasuredConfig { file: path.clone(), acceptance_deg, bandwidth_nm: 0.0, export: None };
        let measurement = measured::read(&config).unwrap();
        let model =
            measured::model::modelled(std::slice::from_ref(&mirror), &optics(), None, &measurement, MEMORY_BYTES)
                .unwrap();
        model.cone_sr * model.scatter_per_sr[0]
    };
    let s = lobe_deviation(SIGMA_NM, 550.0);
    for acceptance_deg in [0.5, 1.0, 2.0, 4.0, 10.0] {
        let half = f64::to_radians(0.5 * acceptance_deg);
        let expected = 1.0 - (-half.sin().powi(2) / (2.0 * s * s)).exp();
        let found = caught(acceptance_deg);
        println!("{acceptance_deg} deg: {found:.6}, expected {expected:.6}");
        assert!((found / expected - 1.0).abs() < 4.0 * s * s + 1e-3, "{acceptance_deg}: {found} against {expected}");
        // Taken for the half angle it would be up to four times as much.
        assert!(acceptance_deg > 2.0 || caught(2.0 * acceptance_deg) > 1.1 * found);
    }
}

#[test]
fn cone_and_slit_average_as_a_fine_sum_of_the_closed_form_does() {
    let (acceptance_deg, bandwidth_nm) = (1.5, 12.0);
    // 16 radii by 24 angles by 33 wavelengths: midpoints and trapezoids of widths of six steps and more.
    let averaged = |angles: [f64; 4], nm: f64| {
        let axis = from_angles_deg(angles[2], angles[3]);
        let [tx, ty] = [[axis[2], 0.0, -axis[0]], [0.0, 1.0, 0.0]];
        let mut sum = 0.0;
        for i in 0..16 * 24 {
            let half = f64::to_radians(0.5 * acceptance_deg);
            let versine = (f64::from(i / 24) + 0.5) / 16.0 * (1.0 - half.cos());
            let (radius, turn) = ((versine * (2.0 - versine)).sqrt(), TAU * f64::from(i % 24) / 24.0);
            let [a, b, c] = [radius * turn.cos(), radius * turn.sin(), 1.0 - versine];
            let wo = [0, 1, 2].map(|k| a * tx[k] + b * ty[k] + c * axis[k]);
            let (theta, phi) = (wo[2].acos().to_degrees(), wo[1].atan2(wo[0]).to_degrees());
            for j in -16i32..=16 {
                let weight = (1.0 - f64::from(j.abs()) / 16.0) / 16.0;
                let at = nm + f64::from(j) / 16.0 * bandwidth_nm;
                sum += weight * wo[2] * closed_form([angles[0], angles[1], theta, phi], at);
            }
        }
        sum / f64::from(16 * 24) / angles[2].to_radians().cos()
    };
    let folder = tempfile::tempdir().unwrap();
    let plain = file(folder.path(), "brdf_per_sr", averaged);
    let instrument = MeasuredConfig { acceptance_deg, bandwidth_nm, ..plain.clone() };
    let [seen, sharp, cone] =
        [instrument.clone(), plain, MeasuredConfig { bandwidth_nm: 0.0, ..instrument }].map(|config| {
            let result = compared(&sinusoid(PERIOD_NM), &optics(), &config);
            println!("{:?} {:?}: {:.2e}", config.acceptance_deg, result.samples, result.columns[0].relative_l2);
            result.columns[0].relative_l2
        });
    // Half a lobe between samples aliases exp(-2π² 4) of a Gaussian; what is left is the cone's edge, where n
    // points err by n^(-3/4) of the step in value across a cell, some 3 % of it for 16 points.
    assert!(seen < 3e-3, "{seen}");
    // Leaving either out shows.
    assert!(sharp > 10.0 * seen && cone > 3.0 * seen, "{sharp} {cone} {seen}");
}
