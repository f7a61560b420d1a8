//! What fuzzing calls: every reader, with bytes that anybody may have made. A panic, a hang, memory without bound, or a value that a reader
//! must not let through is a finding.
//!
//! Part of the fuzz targets, which run for as long as they are let, and of an ordinary test, which replays the corpus and some mutations.

use std::cell::OnceCell;
use std::fs;
use std::path::{Path, PathBuf};

use diffraction_atlas::manifest;
use diffraction_atlas::stages::archive::lock::Lock;
use diffraction_atlas::stages::archive::result_file::SpecimenRecord;
use diffraction_atlas::stages::archive::specimen_file;
use diffraction_atlas::stages::measured::kind::Kind;
use diffraction_atlas::stages::measured::{ExportConfig, MeasuredConfig, read};
use diffraction_brdf::{atlas, exr_image};
use diffraction_build::height::read::{HeightScale, ReadConfig, scan_from_bytes};
use diffraction_render::scene::{environment, mesh_file};

/// A reader by the name of its corpus.
pub type Reader = fn(&[u8]);

/// All of them.
#[allow(dead_code, reason = "each fuzz target takes one")]
pub const READERS: [(&str, Reader); 6] = [
    ("scan", scan),
    ("manifest", manifest),
    ("table", table),
    ("mesh", mesh),
    ("picture", picture),
    ("atlas", atlas_files),
];

/// Scans of every format: they are told apart by their first bytes.
pub fn scan(bytes: &[u8]) {
    let given = ReadConfig {
        pitch_nm: Some([50.0, 60.0]),
        height: Some(HeightScale::Linear { nm_per_count: 0.125, offset_nm: 1.0 }),
        max_missing_share: 0.5,
        max_samples: 1 << 20,
        ..ReadConfig::default()
    };
    let as_the_file_says = ReadConfig { max_samples: 1 << 20, ..ReadConfig::default() };
    for config in [as_the_file_says, given] {
        if let Ok(scan) = scan_from_bytes(Path::new("scan"), bytes, &config) {
            let [nx, ny] = scan.provenance.size;
            assert_eq!(scan.field.heights_nm.dim(), (ny, nx));
            assert!(nx * ny <= config.max_samples && scan.field.heights_nm.iter().all(|height| height.is_finite()));
            assert!(scan.field.pitch_nm.iter().all(|pitch| pitch.is_finite() && *pitch > 0.0));
        }
    }
}

/// Manifests, those left out whose patterns would wander over the disk.
pub fn manifest(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    if text.contains('/') || text.contains("..") {
        return;
    }
    let place = with_files(&[("scan.tif", b"scan"), ("n.csv", b"wavelength_nm,n,k\n300,1.5,0\n900,1.5,0\n")]);
    let _ = manifest::parse(&text, &place.join("m.toml").display().to_string());
}

/// Tables of numbers and of specimens: whatever reads CSV.
pub fn table(bytes: &[u8]) {
    // Cells of a table of specimens are patterns, too.
    let wanders = bytes.contains(&b'/') || bytes.windows(2).any(|pair| pair == b"..");
    let place = with_files(&[("t.csv", bytes), ("scan.tif", b"scan")]);
    let file = place.join("t.csv");
    let export = ExportConfig {
        angles_deg: [0.0, 0.0, 30.0, 0.0],
        kind: Kind::RadianceFactor,
        percent: true,
        white_reflectance: 0.98,
        column: None,
    };
    for export in [None, Some(export)] {
        let config = MeasuredConfig { file: file.clone(), acceptance_deg: 1.0, bandwidth_nm: 2.0, export };
        let _ = read::read(&config);
    }
    let optics = |key: &str| {
        format!(
            "schema = 1\n[atlas]\nname = \"a\"\n[optics]\n{key}\n[[specimen]]\nname = \"s\"\nscans = \"scan.tif\"\n"
        )
    };
    let rows = "schema = 1\nspecimens = \"t.csv\"\n[atlas]\nname = \"a\"\n".to_owned();
    let texts = [optics("illuminant = \"t.csv\""), optics("material = { file = \"t.csv\" }"), rows];
    for text in &texts[..if wanders { 2 } else { 3 }] {
        let _ = manifest::parse(text, &place.join("m.toml").display().to_string());
    }
}

/// Meshes; the first byte chooses the kind.
pub fn mesh(bytes: &[u8]) {
    let Some((kind, content)) = bytes.split_first() else { return };
    let name = ["m.obj", "m.gltf", "m.glb"][usize::from(*kind) % 3];
    let place = with_files(&[(name, content), ("ok.bin", &[0; 64])]);
    if let Ok(model) = mesh_file::read(&place.join(name)) {
        assert!(!model.mesh.triangles.is_empty());
    }
}

/// OpenEXR images: tables of an atlas, and environments.
pub fn picture(bytes: &[u8]) {
    let place = with_files(&[("p.exr", bytes)]);
    let path = place.join("p.exr");
    let _ = exr_image::check_file(&path);
    if let Ok((image, _)) = exr_image::read_rgb(&path) {
        assert_eq!(image.dim().2, 3);
    }
    if let Ok(sky) = environment::load(&path, 10.0, 1.0) {
        assert!(environment::scalar_irradiance(&sky).is_finite());
    }
}

/// Files of an atlas; the first byte chooses which.
pub fn atlas_files(bytes: &[u8]) {
    let Some((kind, content)) = bytes.split_first() else { return };
    let name = ["atlas.json", "specimen.json", "result.json", "m.lock"][usize::from(*kind) % 4];
    let place = with_files(&[(name, content)]);
    let _ = atlas::read_index(&place);
    let _ = specimen_file::load(&place);
    let _ = SpecimenRecord::read(&place).map(|record| record.checked_files(&place));
    let _ = Lock::read(&place.join("m.lock"));
}

thread_local! {
    static FOLDER: OnceCell<tempfile::TempDir> = const { OnceCell::new() };
}

/// This thread's folder with these files and no others.
fn with_files(files: &[(&str, &[u8])]) -> PathBuf {
    FOLDER.with(|folder| {
        let folder = folder.get_or_init(|| tempfile::tempdir().expect("a folder can be made")).path();
        for entry in fs::read_dir(folder).expect("it is there").flatten() {
            let _ = fs::remove_file(entry.path());
        }
        for (name, bytes) in files {
            fs::write(folder.join(name), bytes).expect("it can be written to");
        }
        folder.to_owned()
    })
}
