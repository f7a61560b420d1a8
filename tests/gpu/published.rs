//! The stage as a run has it: everything from published files, against the CPU's pictures and the reference's.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use diffraction_atlas::manifest::{self, convert::run_config};
use diffraction_atlas::stages::archive::specimen_file;
use diffraction_atlas::stages::config::RunConfig;
use diffraction_atlas::stages::gpu::device::GpuDevice;
use diffraction_atlas::stages::gpu::published::check_files;
use diffraction_atlas::stages::gpu::results::GpuRow;
use diffraction_atlas::stages::pictures::shading::Shading;
use diffraction_brdf::exr_image::{Precision, read_rgb, write_rgb};
use diffraction_build::height::HeightField;
use diffraction_build::height::synthesize::{Structure, synthesize};
use diffraction_build::height::write::write_scan_tiff;
use diffraction_build::optics::pigment::Surface;
use diffraction_render::render::gpu::Gpu;
use diffraction_render::scene::model::Scene;
use serde_json::json;

use crate::sets::gpu;

/// Laser lines take little time; 251 texels resolve lobes of a coherence of 1.5 µm.
const MANIFEST: &str = r#"schema = 1
[atlas]
name = "small"
out = "out"
[optics]
illuminant = { lines_nm = [633, 532, 450] }
coherence = { sigma_um = 1.5, edge = "tile" }
[tables]
size = 251
[gpu]
check = "off"
[[specimen]]
name = "wave"
scans = ["wave.tif"]
level = "none"
material = { n = 1.5 }
[[scene]]
name = "hemisphere"
shape = "hemisphere"
light = { direction = [0.2, 0, 1] }
size_px = 150
[[scene]]
name = "sphere"
shape = "sphere"
light = { direction = [0.3, 0.2, 1.0] }
size_px = 150
"#;

fn wave() -> HeightField {
    let wave = Structure::Sinusoid { period_nm: 1_600.0, amplitude_nm: 60.0, direction_deg: 0.0 };
    synthesize(&wave, [128, 32], [100.0, 100.0]).unwrap()
}

/// A published version, made once.
pub struct Published {
    _place: tempfile::TempDir,
    pub config: RunConfig,
    pub version: PathBuf,
}

pub fn published() -> &'static Published {
    static PUBLISHED: OnceLock<Published> = OnceLock::new();
    PUBLISHED.get_or_init(|| {
        let place = tempfile::tempdir().unwrap();
        let wave = Structure::Sinusoid { period_nm: 1_600.0, amplitude_nm: 60.0, direction_deg: 0.0 };
        write_scan_tiff(&place.path().join("wave.tif"), &synthesize(&wave, [128, 32], [100.0, 100.0]).unwrap())
            .unwrap();
        let path = place.path().join("small.toml");
        std::fs::write(&path, MANIFEST).unwrap();
        let run = Command::new(env!("CARGO_BIN_EXE_diffraction-atlas")).arg("run").arg(&path).output().unwrap();
        assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
        let (manifest, text) = manifest::load(&path).unwrap();
        let config = run_config(manifest, text);
        let version = config.atlas_root.join("v0001");
        Published { _place: place, config, version }
    })
}

/// The rows of a copy of the specimen's folder after something was done to it, and the folder.
fn rows_after(test: &str, tamper: impl FnOnce(&Path)) -> Option<(Vec<GpuRow>, tempfile::TempDir)> {
    gpu(test)?;
    let stage = GpuDevice::new(Gpu::open().unwrap().unwrap());
    let published = published();
    let copy = tempfile::tempdir().unwrap();
    std::fs::create_dir(copy.path().join("scenes")).unwrap();
    for entry in ["", "scenes"] {
        for file in std::fs::read_dir(published.version.join("wave").join(entry)).unwrap().map(Result::unwrap) {
            if file.file_type().unwrap().is_file() {
                std::fs::copy(file.path(), copy.path().join(entry).join(file.file_name())).unwrap();
            }
        }
    }
    tamper(copy.path());
    let scenes: Vec<&Scene> = published.config.scenes.iter().collect();
    let rows = check_files(&stage, copy.path(), "wave", &scenes, &published.config.tables, true).unwrap();
    for row in &rows {
        let reference = row.reference.as_ref().unwrap();
        println!(
            "{test}, {}: share {:.3}, picture {:.1e}, of the reference {:.3}; mean {:.1e}, look-up {:.1e}, left {:.1e} of {:.1e}; {:?}",
            row.cpu.scene,
            row.cpu.worst_of_tolerance,
            row.picture.as_ref().unwrap().relative_l2,
            reference.worst_of_tolerance,
            reference.mean,
            reference.look_up_mean,
            reference.unexplained,
            reference.limit,
            row.complaint()
        );
    }
    Some((rows, copy))
}

/// Does something to every value of a stored table.
fn change_table(folder: &Path, number: usize, change: impl Fn(f32) -> f32) {
    let path = folder.join(format!("table.{number:03}.exr"));
    let (image, attributes) = read_rgb(&path).unwrap();
    write_rgb(&path, &image.mapv(change), Precision::Half, &attributes).unwrap();
}

/// Draws the CPU's pictures anew, as if the tables had always been like that.
fn draw_again(folder: &Path) {
    let (_, set) = specimen_file::load(folder).unwrap();
    let shading = Shading::new(Surface::without_pigment(&set), published().config.tables.tolerance);
    for scene in &published().config.scenes {
        let image = shading.render(scene).unwrap();
        write_rgb(&folder.join(format!("scenes/{}.exr", scene.name)), &image, Precision::Float, &json!({})).unwrap();
    }
}

#[test]
fn what_was_published_passes() {
    let Some((rows, _)) = rows_after("untouched", |_| ()) else { return };
    assert_eq!(rows.len(), 2);
    for row in &rows {
        assert!(row.promised && row.passed() && row.complaint().is_none() && row.difference_png.is_none(), "{row:?}");
        let picture = row.picture.as_ref().unwrap();
        assert!(picture.pixels >= 75 * 75 && picture.relative_l2 > 0.0 && picture.relative_l2 < 1e-2, "{row:?}");
        let reference = row.reference.as_ref().unwrap();
        assert!(reference.accurate && reference.mean > 0.0, "{row:?}");
        assert!(row.cpu.pixels >= 75 * 75 && reference.pixels > 1000, "{row:?}");
    }
}

#[test]
fn a_damaged_file_is_noticed_and_shown() {
    for (what, number, change) in [
        ("sign of a table", 1, (|v| -v) as fn(f32) -> f32),
        ("scale of a table", 0, |v| 1.02 * v),
        ("a table without light", 0, |_| 0.0),
    ] {
        let Some((rows, folder)) = rows_after(what, |folder| change_table(folder, number, change)) else { return };
        for row in &rows {
            assert!(row.cpu.passed, "CPU and GPU look the same tables up: {row:?}");
            let picture = row.picture.as_ref().unwrap();
            let said = row.complaint().unwrap();
            if number == 0 && change(1.0) != 0.0 {
                assert!(picture.passed && said.contains("the tables are wrong"), "{what}: {row:?}");
                continue;
            }
            assert!(!picture.passed && said.contains("published picture"), "{what}: {row:?}");
            let shown = row.difference_png.as_ref().unwrap().strip_prefix("wave/").unwrap();
            assert!(std::fs::read(folder.path().join(shown)).unwrap().starts_with(b"\x89PNG"));
        }
    }
}

/// Tables that were wrong before the CPU drew its pictures: only the reference can tell.
#[test]
fn tables_that_were_always_wrong_are_told_by_the_reference() {
    let tamper = |folder: &Path| {
        change_table(folder, 0, |v| 1.02 * v);
        draw_again(folder);
    };
    let Some((rows, _)) = rows_after("wrong from the start", tamper) else { return };
    assert!(
        rows.iter().all(|row| row.cpu.passed && row.reference.as_ref().is_some_and(|reference| reference.passed)),
        "{rows:?}"
    );
    let told: Vec<String> = rows.iter().filter_map(GpuRow::complaint).collect();
    assert!(!told.is_empty() && told.iter().all(|text| text.contains("the tables are wrong")), "{told:?}");
}

#[test]
fn a_picture_of_another_size_is_refused() {
    if gpu("other size").is_none() {
        return;
    }
    let published = published();
    let larger = Scene { size_px: 151, ..published.config.scenes[0].clone() };
    let stage = GpuDevice::new(Gpu::require().unwrap());
    let checked =
        check_files(&stage, &published.version.join("wave"), "wave", &[&larger], &published.config.tables, true);
    let error = checked.unwrap_err().to_string();
    assert!(error.contains("hemisphere.exr") && error.contains("150 by 150") && error.contains("151"), "{error}");
}

#[test]
fn a_lost_device_is_an_error_of_the_stage() {
    if gpu("lost device in the stage").is_none() {
        return;
    }
    let lost = Gpu::require().unwrap();
    lost.lose();
    let published = published();
    let scenes: Vec<&Scene> = published.config.scenes.iter().collect();
    let folder = published.version.join("wave");
    let error =
        check_files(&GpuDevice::new(lost), &folder, "wave", &scenes, &published.config.tables, true).unwrap_err();
    assert!(error.to_string().contains("lost"), "{error}");
}

/// A run that finds no driver, as on a machine without one; and whether it went well.
#[cfg(target_os = "linux")]
fn run_without_driver(check: &str) -> (String, bool, tempfile::TempDir) {
    let place = tempfile::tempdir().unwrap();
    write_scan_tiff(&place.path().join("wave.tif"), &wave()).unwrap();
    let path = place.path().join("small.toml");
    let small = MANIFEST.replace("size = 251", "size = 51").replace("check = \"off\"", &format!("check = \"{check}\""));
    std::fs::write(&path, small).unwrap();
    let run = Command::new(env!("CARGO_BIN_EXE_diffraction-atlas"))
        .arg("run")
        .arg(&path)
        .env("VK_DRIVER_FILES", "/nowhere")
        .env("VK_ICD_FILENAMES", "/nowhere")
        .output()
        .unwrap();
    (String::from_utf8_lossy(&run.stderr).into_owned(), run.status.success(), place)
}

#[test]
#[cfg(target_os = "linux")]
fn a_machine_without_adapter_skips_or_fails_as_the_manifest_says() {
    let (said, went_well, place) = run_without_driver("auto");
    assert!(went_well && said.contains("GPU check skipped: no adapter"), "{said}");
    let report = std::fs::read_to_string(place.path().join("out/small/v0001/report.html")).unwrap();
    assert!(report.contains("skipped: no adapter"));
    let (said, went_well, place) = run_without_driver("required");
    assert!(!went_well && said.contains("no adapter") && said.contains("mesa-vulkan-drivers"), "{said}");
    assert!(!place.path().join("out/small/v0001").exists());
}

#[test]
fn more_tables_than_a_texture_has_layers_are_skipped_unless_a_check_is_required() {
    if gpu("more_tables_than_a_texture_has_layers").is_none() {
        return;
    }
    let place = tempfile::tempdir().unwrap();
    write_scan_tiff(&place.path().join("wave.tif"), &wave()).unwrap();
    let run = |check: &str| {
        // The range of what is covered takes a layer of its own.
        let tables = "size = 65\ncount = 256\nserve = [\"sphere\"]";
        let text = MANIFEST.replace("size = 251", tables).replace("size_px = 150", "size_px = 16");
        std::fs::write(place.path().join("small.toml"), text.replace("\"off\"", check)).unwrap();
        Command::new(env!("CARGO_BIN_EXE_diffraction-atlas"))
            .args(["--quiet", "run", "small.toml"])
            .current_dir(place.path())
            .output()
            .unwrap()
    };
    let done = run("\"auto\"");
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let report = std::fs::read_to_string(place.path().join("out/small/v0001/report.json")).unwrap();
    assert!(report.contains("not checked on the GPU: its 256 tables are more than the 255 layers"), "{report}");
    let failed = run("\"required\"");
    let stderr = String::from_utf8_lossy(&failed.stderr);
    assert_eq!(failed.status.code(), Some(1), "{stderr}");
    assert!(
        stderr.contains("256 tables for a texture of 1 to 255 layers") && !stderr.contains("gpu.check"),
        "{stderr}"
    );
}
