//! Made-up specimens for tests of files: random tables of every shape that the format knows.

use std::path::Path;

use diffraction_atlas::stages::archive::specimen_file::{self, SpecimenFile};
use diffraction_atlas::stages::archive::worked;
use diffraction_brdf::atlas::{AtlasIndex, InputRecord, SpecimenEntry};
use diffraction_brdf::direction::from_angles_deg;
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_brdf::specimen::{CheckValue, SCHEMA};
use diffraction_brdf::spectrum::Illuminant;
use diffraction_brdf::storage;
use diffraction_build::optics::config::{Edge, Material, OpticsConfig, Windows};
use diffraction_build::tables::model::{Basis, BuildRecord, Lobe, Storage, TableSet};
use ndarray::Array3;
use serde_json::json;

fn optics(shadowing: bool) -> OpticsConfig {
    OpticsConfig {
        material: Material::Dielectric { n: 1.56 },
        shadowing,
        ..OpticsConfig::ideal(Illuminant::D65, 16_250.0, Edge::Tile, Windows::Grid)
    }
}

/// Values over nine decades, the first table positive and the others signed.
fn random_array(random: &mut fastrand::Rng, shape: (usize, usize, usize), signed: bool) -> Array3<f32> {
    Array3::from_shape_fn(shape, |_| {
        let value = (0.1 + 0.9 * random.f32()) * 10f32.powi(random.i32(-6..3));
        if signed && random.bool() { -value } else { value }
    })
}

pub fn random_tables(seed: u64, basis: Basis, size: usize) -> TableSet {
    let mut random = fastrand::Rng::with_seed(seed);
    let tables = (0..4).map(|n| random_array(&mut random, (size, size, 3), n > 0)).collect();
    let lobe = (basis == Basis::Chebyshev).then(|| Lobe {
        coherent: random_array(&mut random, (9, 17, 3), false),
        radius_max: 0.046_875_1,
        cross: (0..3).map(|_| random_array(&mut random, (7, 7, 3), true)).collect(),
    });
    TableSet {
        basis,
        tables,
        lobe,
        prefilter_width: 0.008,
        front_factor: optics(true).front_factor(),
        restriction: None,
        usable_radius: 1.71,
    }
}

/// Directions all over the hemisphere, every fourth near the mirror direction, where the lobe is.
fn check_values(tables: &TableSet, seed: u64) -> Vec<CheckValue> {
    let mut random = fastrand::Rng::with_seed(seed);
    let check = |n: usize| {
        let (theta_i_deg, phi_i_deg) = (80.0 * random.f64(), 360.0 * random.f64());
        let (theta_r_deg, phi_r_deg) = if n.is_multiple_of(4) {
            (theta_i_deg + random.f64() - 0.5, phi_i_deg + 180.0 + random.f64() - 0.5)
        } else {
            (80.0 * random.f64(), 360.0 * random.f64())
        };
        let angles = [theta_i_deg, phi_i_deg, theta_r_deg.abs(), phi_r_deg];
        let worked = worked::work_number(tables, angles);
        let [wi, wo] = [from_angles_deg(angles[0], angles[1]), from_angles_deg(angles[2], angles[3])];
        CheckValue {
            theta_i_deg,
            phi_i_deg,
            theta_r_deg: angles[2],
            phi_r_deg,
            wi,
            wo,
            xyz: worked.xyz,
            xyz_spline: (tables.look_up() == Interpolation::Spline)
                .then(|| brdf_xyz(tables, Interpolation::Spline, wi, wo)),
        }
    };
    (0..20).map(check).collect()
}

/// Writes a specimen's folder as a run would.
pub fn write_specimen(version: &Path, name: &str, set: &TableSet, storage: Storage) -> SpecimenFile {
    let folder = version.join(name);
    std::fs::create_dir_all(&folder).unwrap();
    let stored = storage::write_tables(&folder, set, storage).unwrap();
    let rounded = storage::read_tables(&folder, &stored, set.front_factor).unwrap();
    let file = SpecimenFile {
        schema: SCHEMA,
        name: name.to_owned(),
        species: "Exempli gratia".to_owned(),
        provenance: json!({"scans": [{"path": "a.tif", "sha256": "00"}]}),
        preparation: json!({"level": "plane"}),
        statistics: json!({"rms_nm": 26.4}),
        optics: optics(true),
        pigment: None,
        build: BuildRecord { transforms: 12, windows: 1, ..BuildRecord::default() },
        spectral: None,
        tables: stored,
        errors: json!({"basis": {"p95": 1.2e-4}}),
        albedo: Vec::new(),
        energy_limit: None,
        check_values: check_values(&rounded, 3),
        warnings: vec!["Made up.".to_owned()],
    };
    specimen_file::write(&folder, &file).unwrap();
    file
}

/// An index for these specimens, with one input of this digest.
pub fn index(input_sha256: &str, names: &[&str]) -> AtlasIndex {
    let inputs = vec![InputRecord { path: "a.tif".into(), sha256: input_sha256.into() }];
    let entry = |name: &&str| SpecimenEntry { name: (*name).to_owned(), species: "Exempli gratia".into(), stale: None };
    AtlasIndex::new("test", "11", inputs, names.iter().map(entry).collect())
}
