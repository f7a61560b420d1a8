//! The limits of the model against rigorous diffraction orders, and what is said of them.

use std::f64::consts::TAU;
use std::path::Path;

use ndarray::Array2;

use super::*;
use crate::height::statistics::statistics;

const WAVELENGTH_NM: f64 = 400.0;

/// The default pairs of material and factor, by the material's name in the file.
const PAIRS: [(&str, Material, Factor); 3] = [
    ("aluminium", Material::Conductor { n: 0.96, k: 6.70 }, Factor::Vector),
    ("conductor", Material::Ideal, Factor::Scalar),
    ("dielectric", Material::Dielectric { n: 1.56 }, Factor::Vector),
];

/// A case of `tests/rigorous/cases.csv`.
struct Case {
    profile: String,
    material: String,
    period: f64,
    depth: f64,
    theta_i_deg: f64,
    /// By factor: whether every order is within 10 %, and whether some is off by two or more.
    verdicts: [(bool, bool); 2],
}

fn cases() -> Vec<Case> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/rigorous/cases.csv");
    let text = std::fs::read_to_string(path).unwrap();
    text.lines().skip(1).map(case).collect()
}

fn case(line: &str) -> Case {
    let fields: Vec<&str> = line.split(',').collect();
    let number = |index: usize| fields[index].parse::<f64>().unwrap();
    let orders = |index: usize| fields[index].split(' ').map(|v| v.parse::<f64>().unwrap()).collect::<Vec<_>>();
    let (reflectance, rigorous) = (number(5), orders(7));
    let verdict = |model: Vec<f64>| {
        assert_eq!(model.len(), rigorous.len());
        // Orders count above 3 % of the flat surface's reflectance.
        let counted = rigorous.iter().zip(&model).filter(|(exact, _)| **exact > 0.03 * reflectance);
        let ratios: Vec<f64> = counted.map(|(exact, model)| model / exact).collect();
        let good = ratios.iter().all(|ratio| (ratio - 1.0).abs() <= 0.1);
        (good, ratios.iter().any(|ratio| *ratio >= 2.0 || *ratio <= 0.5))
    };
    Case {
        profile: fields[0].into(),
        material: fields[1].into(),
        period: number(2),
        depth: number(3),
        theta_i_deg: number(4),
        verdicts: [verdict(orders(8)), verdict(orders(9))],
    }
}

/// Height of the profiles of `tests/rigorous/profiles.py` at a share of the period, in units of the depth.
fn height(profile: &str, t: f64) -> f64 {
    match profile {
        "sinusoid" => 0.5 * (TAU * t).cos(),
        "blaze" => (if t < 0.9 { t / 0.9 } else { (1.0 - t) / 0.1 }) - 0.5,
        "lamellar" => {
            if t < 0.5 {
                -0.5
            } else {
                0.5
            }
        }
        other => panic!("{other}"),
    }
}

/// A line of samples over whole periods; a quarter wavelength more, so that pairs so far apart are whole periods.
fn scan(case: &Case, per_wavelength: f64) -> HeightField {
    let count = (case.period * per_wavelength).round();
    let (samples, more) = (count as usize, (per_wavelength / 4.0).ceil() as usize);
    let heights_nm = Array2::from_shape_fn((1, 3 * samples + more), |(_, column)| {
        case.depth * WAVELENGTH_NM * height(&case.profile, ((column % samples) as f64 + 0.5) / count)
    });
    HeightField { heights_nm, pitch_nm: [case.period * WAVELENGTH_NM / count; 2] }
}

/// Of the cases of a pair: [found, off by two, named, good].
fn confusion(
    cases: &[Case],
    (name, material, factor): (&str, Material, Factor),
    per_wavelength: f64,
    warns: impl Fn(&HeightField, &Case) -> bool,
) -> [usize; 4] {
    let _ = material;
    let mut counts = [0; 4];
    for case in cases.iter().filter(|case| case.material == name) {
        let warned = usize::from(warns(&scan(case, per_wavelength), case));
        match case.verdicts[usize::from(factor == Factor::Vector)] {
            (_, true) => (counts[0], counts[1]) = (counts[0] + warned, counts[1] + 1),
            (true, _) => (counts[2], counts[3]) = (counts[2] + warned, counts[3] + 1),
            _ => {}
        }
    }
    counts
}

/// At least 95 % of what is off by two is found, and at most 10 % of what is good is named.
fn holds([found, bad, named, good]: [usize; 4]) -> bool {
    assert!(bad > 40 && good > 150, "{bad} {good}");
    found as f64 >= 0.95 * bad as f64 && named as f64 <= 0.10 * good as f64
}

#[test]
fn the_rule_finds_what_is_off_by_two_and_names_little_that_is_good() {
    let cases = cases();
    assert_eq!(cases.len(), 1152);
    let mut old_fails = 0;
    for pair in PAIRS {
        let (_, material, factor) = pair;
        for per_wavelength in [40.0, 20.0, 10.0] {
            let warns = |field: &HeightField, case: &Case| {
                let oblique = case.theta_i_deg > 45.0;
                is_steep(field, WAVELENGTH_NM, material, factor) || oblique && is_walled(field, WAVELENGTH_NM, material)
            };
            let found = confusion(&cases, pair, per_wavelength, warns);
            println!("{} at {per_wavelength} samples per wavelength: {found:?}", pair.0);
            assert!(holds(found), "{pair:?} at {per_wavelength} samples per wavelength: {found:?}");
            // Slopes between neighbours know no wavelength, and see a wall at one sample however long it is.
            let old = |field: &HeightField, _: &Case| statistics(field, WAVELENGTH_NM).steep_share > 0.01;
            let found = confusion(&cases, pair, per_wavelength, old);
            println!("  share of steep slopes between neighbours: {found:?}");
            old_fails += usize::from(!holds(found));
        }
    }
    assert_eq!(old_fails, 9, "the share of steep slopes between neighbours would do as well");
}

#[test]
fn a_finer_scan_of_the_same_wall_says_the_same() {
    let lamellar = &cases()[0];
    let lamellar =
        Case { profile: "lamellar".into(), period: 4.1, depth: 0.2, material: lamellar.material.clone(), ..*lamellar };
    for per_wavelength in [10.0, 20.0, 40.0, 160.0] {
        let field = scan(&lamellar, per_wavelength);
        let (slope, walls) = (wave_slope(&field, WAVELENGTH_NM), wall_share(&field, WAVELENGTH_NM));
        // Two walls of 0.2 wavelengths in 4.1: D over L is 2 (0.2)^2 / 4.1 per length.
        let expected = (2.0 * 0.2f64.powi(2) / 4.1 / 0.25).sqrt();
        assert!((slope / expected - 1.0).abs() < 0.03, "{per_wavelength}: {slope} {expected}");
        assert!((walls / (2.0 * 0.1 / 4.1 * 0.1 / 0.1) - 1.0).abs() < 0.05, "{per_wavelength}: {walls}");
    }
}

#[test]
fn doubts_name_the_wavelength_and_what_to_doubt() {
    let dielectric = Material::Dielectric { n: 1.5 };
    // Period 2 µm: the slope over a quarter wavelength nearly is that of the sine, whatever the wavelength.
    let wave = |amplitude_nm: f64, period_nm: f64, pitch_nm: f64| HeightField {
        heights_nm: Array2::from_shape_fn((4, 400), |(_, x)| {
            amplitude_nm * (TAU * x as f64 * pitch_nm / period_nm).sin()
        }),
        pitch_nm: [pitch_nm; 2],
    };
    let said = |field: &HeightField, material, factor| doubts(field, [380.0, 780.0], material, factor).join(" ");
    let steep = wave(250.0, 2000.0, 20.0);
    let text = said(&steep, dielectric, Factor::Vector);
    assert!(text.contains("(rms slope 0.5") && text.contains("0.40") && text.contains("every wavelength"), "{text}");
    assert!(text.contains("beyond 60 degrees") && text.contains("towards the light"), "{text}");
    // Gentle for a dielectric with the vector factor, less so with the scalar one, and steep for a metal.
    let middle = wave(112.0, 2000.0, 20.0);
    assert_eq!(said(&middle, dielectric, Factor::Vector), "");
    assert_eq!(said(&middle, dielectric, Factor::Scalar), "");
    let metal = Material::Conductor { n: 1.0, k: 6.0 };
    // The limit of 0.25 lies where a chord over a quarter wavelength is short of the slope of 0.249.
    assert_eq!(said(&middle, metal, Factor::Vector), "");
    // A short wave: over longer chords the slope falls below the limit.
    let text = said(&wave(25.0, 300.0, 10.0), metal, Factor::Vector);
    assert!(text.contains("up to about ") && text.contains("the vector factor"), "{text}");
    // Too coarse to tell, unless the heights are too small to be steep.
    let text = said(&wave(60.0, 2000.0, 100.0), dielectric, Factor::Vector);
    assert!(text.contains("100.0 nm apart") && text.contains("below 500 nm"), "{text}");
    assert_eq!(said(&wave(10.0, 2000.0, 100.0), dielectric, Factor::Vector), "");
    // Walls count for conductors, in oblique light.
    let step = HeightField {
        heights_nm: Array2::from_shape_fn((4, 400), |(_, x)| if x % 200 < 100 { 0.0 } else { 60.0 }),
        pitch_nm: [10.0; 2],
    };
    assert!(said(&step, metal, Factor::Vector).contains("walls"), "{}", said(&step, metal, Factor::Vector));
    assert!(!said(&step, dielectric, Factor::Vector).contains("walls"));
}
