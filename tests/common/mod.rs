//! What several integration tests share: the shared scans, and the independent evaluator's figures.

#![allow(dead_code)] // each test file uses its own part

pub mod optics_forms;
pub mod surfaces;

use std::path::Path;

use diffraction_brdf::direction::{Vec3, Xyz, from_angles_deg};
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
use ndarray::Array2;
use tiff::decoder::{Decoder, DecodingResult};

/// A scan as plain numbers times a scale.
pub fn load(path: &Path, pitch_nm: [f64; 2], scale_nm: f64) -> HeightField {
    let mut decoder = Decoder::new(std::fs::File::open(path).unwrap()).unwrap();
    let (columns, rows) = decoder.dimensions().unwrap();
    let values: Vec<f64> = match decoder.read_image().unwrap() {
        DecodingResult::F32(v) => v.into_iter().map(f64::from).collect(),
        DecodingResult::U16(v) => v.into_iter().map(f64::from).collect(),
        _ => panic!("unexpected sample format in {}", path.display()),
    };
    let heights = Array2::from_shape_vec((rows as usize, columns as usize), values).unwrap();
    HeightField { heights_nm: heights * scale_nm, pitch_nm }
}

/// The settings of the independent evaluator.
pub fn reference_optics(sigma_nm: f64, edge: Edge) -> OpticsConfig {
    OpticsConfig::ideal(Illuminant::D65, sigma_nm, edge, Windows::Centre)
}

/// One scan with its settings and the independent evaluator's rows.
pub struct Case {
    pub name: &'static str,
    pub field: HeightField,
    pub optics: OpticsConfig,
    pub rows: Vec<Row>,
}

/// Directions and XYZ in 1/sr.
#[derive(Clone, Copy)]
pub struct Row {
    pub wi: Vec3,
    pub wo: Vec3,
    pub xyz: Xyz,
}

const SNAKE_PITCH_NM: f64 = 65_000.0 / 1332.0;

/// Name, scan, pitch, scale, σ in nm and edge of a case.
type Facts = (&'static str, &'static str, [f64; 2], f64, f64, Edge);

const SNAKE_PITCHES_NM: [f64; 2] = [SNAKE_PITCH_NM; 2];
/// The whole integer range of the corn snake's scan is this many nm.
const ELAPHE_NM_PER_COUNT: f64 = 375.0 / 65535.0;

/// What is in the repository: generated gratings with rows of an evaluator outside, and pieces of the published snake scans
/// with rows by `tests/data/reference/evaluate.py`, which meets the other evaluator to ten digits.
const BUNDLED: [Facts; 5] = [
    ("blazed_2500nm", "blazed_2500nm", [50.0, 50.0], 1.0, 5_000.0, Edge::Fade),
    ("sinusoid_1600nm", "sinusoid_1600nm", [40.0, 80.0], 1.0, 5_000.0, Edge::Fade),
    ("elaphe_guttata_fade", "elaphe_guttata_crop", SNAKE_PITCHES_NM, ELAPHE_NM_PER_COUNT, 1_100.0, Edge::Fade),
    ("elaphe_guttata_tile", "elaphe_guttata_crop", SNAKE_PITCHES_NM, ELAPHE_NM_PER_COUNT, 2_000.0, Edge::Tile),
    ("xenopeltis_unicolor_fade", "xenopeltis_unicolor_crop", SNAKE_PITCHES_NM, 1.0, 1_100.0, Edge::Fade),
];

/// Whole scans with all rows of the evaluator outside, too large for the repository.
const WHOLE: [Facts; 5] = [
    ("blazed_2500nm", "blazed_2500nm", [50.0, 50.0], 1.0, 5_000.0, Edge::Fade),
    ("sinusoid_1600nm", "sinusoid_1600nm", [40.0, 80.0], 1.0, 5_000.0, Edge::Fade),
    ("elaphe_guttata", "elaphe_guttata", SNAKE_PITCHES_NM, ELAPHE_NM_PER_COUNT, 8_125.0, Edge::Fade),
    ("xenopeltis_unicolor", "xenopeltis_unicolor", SNAKE_PITCHES_NM, 1.0, 8_125.0, Edge::Fade),
    ("elaphe_guttata_tile", "elaphe_guttata", SNAKE_PITCHES_NM, ELAPHE_NM_PER_COUNT, 16_250.0, Edge::Tile),
];

/// The cases in the repository.
pub fn bundled_cases() -> Vec<Case> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/reference");
    BUNDLED.iter().map(|facts| case(facts, &folder, &folder)).collect()
}

/// The cases of the shared folder, in which scans and figures have a folder each.
pub fn whole_cases(shared: &Path) -> Vec<Case> {
    WHOLE.iter().map(|facts| case(facts, &shared.join("specimens"), &shared.join("reference"))).collect()
}

fn case(&(name, scan, pitch_nm, scale, sigma_nm, edge): &Facts, scans: &Path, figures: &Path) -> Case {
    Case {
        name,
        field: load(&scans.join(format!("{scan}.tif")), pitch_nm, scale),
        optics: reference_optics(sigma_nm, edge),
        rows: rows(&figures.join(format!("{name}.csv"))),
    }
}

fn rows(path: &Path) -> Vec<Row> {
    let text = std::fs::read_to_string(path).unwrap();
    text.lines()
        .skip(1)
        .map(|line| {
            let n: Vec<f64> = line.split(',').map(|cell| cell.trim().parse().unwrap()).collect();
            Row { wi: from_angles_deg(n[0], n[1]), wo: from_angles_deg(n[2], n[3]), xyz: [n[4], n[5], n[6]] }
        })
        .collect()
}
