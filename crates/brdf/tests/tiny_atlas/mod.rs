// A tiny atlas for tests and examples of the documentation, which include this file: a made-up surface with a coherent lobe,
// and a structure of orders along x.

use diffraction_brdf::atlas::{self, AtlasIndex, SpecimenEntry};
use diffraction_brdf::front_factor::Factor;
use diffraction_brdf::specimen::{CheckValue, SCHEMA};
use diffraction_brdf::table_set::Storage;
use diffraction_brdf::{Basis, Brdf, FrontFactor, Interpolation, Lobe, Material, TableSet, files, json, storage};
use ndarray::Array3;
use serde_json::json;
use std::path::Path;

/// Two tables of 65 x 65 texels, a lobe of radius 0.3 and its cross term.
pub fn tiny_tables() -> TableSet {
    let gauss = |x: f64, width: f64| (-0.5 * (x / width).powi(2)).exp();
    let order = |u: f64, v: f64| gauss(v, 0.2) * (gauss(u - 0.5, 0.1) + gauss(u + 0.5, 0.1));
    let table = |scale: f64| {
        Array3::from_shape_fn((65, 65, 3), |(row, column, channel)| {
            let (u, v) = (-2.0 + column as f64 / 16.0, 2.0 - row as f64 / 16.0);
            (scale * (0.05 + order(u * (1.0 + 0.1 * channel as f64), v))) as f32
        })
    };
    let coherent = Array3::from_shape_fn((9, 25, 3), |(row, column, _)| {
        let (t, radius) = (row as f64 / 8.0, 0.3 * column as f64 / 24.0);
        ((1.5 - t) * 8.0 * gauss(radius, 0.06)) as f32
    });
    let cross = Array3::from_shape_fn((9, 9, 3), |(row, column, _)| {
        (0.01 * gauss((row as f64 - 4.0) / 4.0, 0.4) * (column as f64 - 4.0)) as f32
    });
    TableSet {
        basis: Basis::Chebyshev,
        tables: vec![table(0.3), table(-0.1)],
        lobe: Some(Lobe { coherent, radius_max: 0.3, cross: vec![cross] }),
        prefilter_width: 0.0,
        front_factor: FrontFactor {
            material: Material::Dielectric { n: 1.56 },
            shadowing: true,
            factor: Factor::Scalar,
        },
        restriction: None,
        usable_radius: 2.0,
    }
}

/// Writes an atlas of one version with the specimen `grating`.
#[allow(dead_code)]
pub fn write_tiny_atlas(root: &Path) {
    let set = tiny_tables();
    let version = root.join("v0001");
    let folder = version.join("grating");
    files::create_folder(&folder).unwrap();
    let stored = storage::write_tables(&folder, &set, Storage::Half).unwrap();
    let brdf = Brdf::new(storage::read_tables(&folder, &stored, set.front_factor).unwrap()).unwrap();
    let check = |angles: [f64; 4]| {
        let [wi, wo] = [[angles[0], angles[1]], [angles[2], angles[3]]]
            .map(|[theta, phi]| diffraction_brdf::direction::from_angles_deg(theta, phi));
        CheckValue {
            theta_i_deg: angles[0],
            phi_i_deg: angles[1],
            theta_r_deg: angles[2],
            phi_r_deg: angles[3],
            wi,
            wo,
            xyz: brdf.eval(wi, wo),
            xyz_spline: Some(brdf.clone().with_interpolation(Interpolation::Spline).eval(wi, wo)),
        }
    };
    let record = json!({
        "schema": SCHEMA, "name": "grating", "species": "made up", "optics": set.front_factor, "tables": stored,
        "check_values": [check([0.0, 0.0, 30.0, 0.0]), check([40.0, 10.0, 41.0, 185.0])], "warnings": [],
    });
    files::replace(&folder.join("specimen.json"), json::pretty(&record).unwrap().as_bytes()).unwrap();
    let specimens = vec![SpecimenEntry { name: "grating".into(), species: "made up".into(), stale: None }];
    publish(&version, AtlasIndex::new("tiny", "", vec![], specimens));
    files::replace(&root.join("latest"), b"v0001\n").unwrap();
}

/// Writes the index of whatever files stand in the version.
#[allow(dead_code)]
pub fn publish(version: &Path, mut index: AtlasIndex) {
    index.files = atlas::record_files(version).unwrap();
    atlas::write_index(version, &mut index).unwrap();
}
