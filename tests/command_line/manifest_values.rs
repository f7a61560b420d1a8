//! What a manifest's text means: values, defaults, resolved paths, and that the documentation says the same.

use std::path::{Path, PathBuf};

use crate::manifest_fixture::{GOOD, folder, good_with, parse_in};
use diffraction_atlas::manifest;
use diffraction_atlas::stages::config::{FrameTiming, GpuCheck};
use diffraction_atlas::stages::measured::MeasuredConfig;
use diffraction_brdf::spectrum::{Illuminant, Line};
use diffraction_build::height::prepare::Level;
use diffraction_build::height::read::{HeightScale, LengthUnit};
use diffraction_build::optics::config::{Edge, Factor, Material, Windows};
use diffraction_build::optics::dispersive::Dispersive;
use diffraction_build::tables::model::{Basis, Prefilter, Storage};
use diffraction_render::scene::camera::{Camera, Field};
use diffraction_render::scene::environment;
use diffraction_render::scene::model::{Exposure, Moving, Shape};
use diffraction_render::scene::turn::Axis;

#[test]
fn what_is_written_is_what_is_read() {
    let folder = folder();
    let good = parse_in(folder.path(), GOOD).unwrap();
    assert_eq!((good.schema, good.atlas.name.as_str(), good.gpu.check), (1, "squamates", GpuCheck::Auto));
    assert_eq!(good.atlas.out, folder.path().join("out"));
    assert_eq!(good.optics.sigma_nm, 16_250.0);
    assert_eq!((good.tables.tolerance, good.tables.size), (1e-3, Some(501)));
    let [elaphe, xenopeltis] = &good.specimens[..] else { panic!("two specimens") };
    assert_eq!(elaphe.read.pitch_nm, Some([48.8, 48.8]));
    assert_eq!(elaphe.read.height, Some(HeightScale::FullScaleNm(375.0)));
    assert_eq!(elaphe.optics.material, Material::Dielectric { n: 1.56 });
    assert_eq!(xenopeltis.optics, good.optics);
    assert_eq!(good.scenes[0].lights[0].direction, [0.3, 0.2, 1.0]);
}

/// The TOML blocks of docs/manifest.md.
fn documented() -> Vec<String> {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("docs/manifest.md");
    let text = std::fs::read_to_string(path).unwrap();
    text.split("```toml\n").skip(1).map(|block| block.split("```").next().unwrap().to_owned()).collect()
}

#[test]
fn documented_defaults_are_the_defaults() {
    let folder = folder();
    let full = parse_in(folder.path(), &documented()[0]).unwrap();
    let short = "schema = 1\n[atlas]\nname = \"squamates\"\n[[specimen]]\nname = \"snake\"\nscans = [\"snake.tif\"]\n";
    let mut assumed = parse_in(folder.path(), short).unwrap();
    // A material that is written down is not warned of.
    assert!(!assumed.specimens[0].is_material_given && full.specimens[0].is_material_given);
    assumed.specimens[0].is_material_given = true;
    // Nor are scenes that are asked for told as assumed.
    assert!(!assumed.scenes_are_given && full.scenes_are_given);
    assumed.scenes_are_given = true;
    assert_eq!(assumed, full);

    let none = parse_in(folder.path(), &short.replacen('\n', "\nscene = []\n", 1)).unwrap();
    assert!(none.scenes_are_given && none.scenes.is_empty(), "none is what was asked for");

    let scenes = |text: &str| parse_in(folder.path(), &format!("{short}{text}")).unwrap().scenes;
    let light = "light = { direction = [0.3, 0.2, 1.0], angular_diameter_deg = 0.53, irradiance = 1 }";
    let common = "size_px = 512\nexposure = \"auto\"\nlight_samples = 16\npixel_samples = 1";
    for (shape, own) in [
        ("hemisphere", light.to_owned()),
        ("sphere", light.to_owned()),
        ("patch", format!("{light}\nwidth_mm = 20\ndistance_mm = 60\ntilt_deg = 0\nturn_deg = 0")),
        (
            "screen",
            "width_mm = 200\ndistance_mm = 100\nbeam_diameter_mm = 1\nbeam_divergence_deg = 0\nincidence_deg = 0"
                .to_owned(),
        ),
    ] {
        let start = format!("[[scene]]\nname = \"s\"\nshape = \"{shape}\"\n");
        assert_eq!(scenes(&start), scenes(&format!("{start}{own}\n{common}\n")), "{shape}");
    }
}

#[test]
fn every_key_is_documented_and_in_the_example() {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("docs/manifest.md");
    let text = std::fs::read_to_string(path).unwrap();
    let example = &documented()[1];
    let words: Vec<&str> = example.split(|c: char| !(c.is_alphanumeric() || c == '_')).collect();
    for keys in manifest::keys::ALL {
        for name in keys.names {
            assert!(text.contains(&format!("| `{name}`")), "{name} of {} is not documented", keys.table);
            assert!(words.contains(name), "{name} of {} is not in the example", keys.table);
        }
    }
}

#[test]
fn every_key_of_the_example_arrives() {
    let folder = folder();
    let all = parse_in(folder.path(), &documented()[1]).unwrap();
    let line = |wavelength_nm, power| Line { wavelength_nm, power };
    assert_eq!(all.atlas.out, folder.path().join("../atlases"));
    assert_eq!(all.optics.illuminant, Illuminant::Lines(vec![line(532.0, 0.5), line(633.0, 1.0)]));
    assert_eq!(all.optics.wavelength_nm, [532.0, 633.0]);
    assert_eq!((all.optics.sigma_nm, all.optics.edge, all.optics.windows), (6500.0, Edge::Fade, Windows::Centre));
    assert_eq!(all.optics.material, Material::Conductor { n: 0.2, k: 3.4 });
    assert!(all.optics.shadowing && all.optics.factor == Factor::Scalar);

    assert_eq!((all.tables.basis, all.tables.storage), (Basis::Taylor, Some(Storage::Float)));
    assert_eq!((all.tables.tolerance, all.tables.size, all.tables.count), (0.01, Some(501), Some(40)));
    assert_eq!((all.tables.wavelength_step_nm, all.tables.memory_mib), (Some(2.5), 512));
    assert_eq!(all.tables.prefilter, Prefilter::Width(0.0093));

    let [integers, floats, counts, gilt, worn, row] = &all.specimens[..] else { panic!("six specimens") };
    assert_eq!((row.name.as_str(), row.read.pitch_nm), ("row", Some([50.0; 2])));
    assert_eq!(row.optics.material, Material::Dielectric { n: 1.4 });
    assert_eq!(integers.species.as_deref(), Some("Elaphe guttata"));
    assert_eq!(integers.scans, [folder.path().join("snake.tif")]);
    assert_eq!((integers.read.page, integers.read.pitch_nm), (Some(0), Some([48.8; 2])));
    assert_eq!((integers.prepare.level, integers.prepare.blend_nm), (Level::Quadratic, Some(500.0)));
    assert_eq!(integers.prepare.despike.map(|despike| despike.threshold_rms), Some(8.0));
    assert_eq!(integers.read.max_missing_share, 0.01);
    assert_eq!((integers.read.missing_value, integers.read.crop), (Some(-9999.0), Some([0, 0, 512, 400])));
    let file = folder.path().join("measured.csv");
    assert_eq!(integers.measured, Some(MeasuredConfig { file, acceptance_deg: 1.5, bandwidth_nm: 2.0, export: None }));
    let export = floats.measured.as_ref().and_then(|measured| measured.export.as_ref()).unwrap();
    assert_eq!((export.angles_deg, export.percent), ([0.0, 0.0, 30.0, 0.0], true));
    assert_eq!((export.white_reflectance, export.column.as_deref()), (0.98, Some("2")));
    // Its own sigma and windows, but the edge of `[optics]`.
    let optics = &integers.optics;
    assert_eq!((optics.sigma_nm, optics.edge, optics.windows), (3000.0, Edge::Fade, Windows::Grid));
    assert_eq!(optics.material, Material::Dielectric { n: 1.56 });
    assert_eq!((integers.albedo, floats.albedo), (Some([0.45, 0.16, 0.05]), None));
    assert_eq!(floats.read.pitch_nm, Some([84.04, 74.56]));
    assert_eq!((floats.read.height, floats.prepare.level), (Some(HeightScale::Unit(LengthUnit::Nm)), Level::Rows));
    assert_eq!(counts.scans, ["snake.tif", "snake2.tif"].map(|name| folder.path().join(name)));
    assert_eq!(counts.read.height, Some(HeightScale::Linear { nm_per_count: 0.01, offset_nm: -20.0 }));
    assert_eq!((counts.prepare.level, counts.optics.material), (Level::None, Material::Ideal));

    for (specimen, name) in [(floats, "beta_keratin"), (gilt, "gold"), (worn, "nk.csv")] {
        let Dispersive { reference_nm, table } = specimen.optics.dispersion.as_ref().unwrap();
        assert_eq!((table.name(), table.material_at(*reference_nm)), (name, Some(specimen.optics.material)));
        // Green, half as bright in lamps' power, outweighs red.
        assert!((532.0..580.0).contains(reference_nm), "{name}: {reference_nm}");
    }
    assert!(counts.optics.dispersion.is_none() && integers.optics.dispersion.is_none());

    let [map, ball, tile, wall, statue] = &all.scenes[..] else { panic!("five scenes") };
    assert_eq!((&map.shape, map.size_px, map.exposure), (&Shape::Hemisphere, 256, Exposure::Auto));
    let animation = ball.animation.unwrap();
    assert_eq!((animation.kind, animation.axis), (Moving::Light, Axis::Viewing));
    assert_eq!((animation.frames, animation.degrees, animation.fps, animation.size_px), (16, 90.0, 10, 128));
    let sky = ball.environment.as_ref().unwrap();
    assert_eq!(sky.file, folder.path().join("sky.exr"));
    // 4π of luminance 0.5, halved.
    let irradiance = environment::scalar_irradiance(sky);
    assert!((irradiance - std::f64::consts::PI).abs() < 1e-6, "{irradiance}");
    assert_eq!((ball.lights.len(), ball.light_samples, ball.pixel_samples), (2, 64, 4));
    assert_eq!((ball.lights[1].angular_diameter_deg, ball.lights[1].irradiance), (10.0, 0.1));
    assert_eq!((tile.exposure, tile.specimen.as_deref()), (Exposure::Ev(-1.5), Some("integers")));
    let patch = Shape::Patch { width_mm: 30.0, distance_mm: 90.0, tilt_deg: 40.0, turn_deg: 90.0 };
    assert_eq!(tile.shape, patch);
    let screen = Shape::Screen {
        width_mm: 300.0,
        distance_mm: 150.0,
        beam_diameter_mm: 2.0,
        hole_diameter_mm: Some(5.0),
        incidence_deg: 10.0,
    };
    assert_eq!(wall.shape, screen);
    assert_eq!(wall.lights[0].angular_diameter_deg, 0.1);
    let Shape::Mesh(mesh) = &statue.shape else { panic!("a mesh") };
    assert_eq!(mesh.path, folder.path().join("body.obj"));
    assert_eq!(mesh.model.mesh.triangles.len(), 2);
    let camera =
        Camera { position: [0.5, 0.5, 4.0], target: [0.5, 0.5, 0.0], up: [0.0, 1.0, 0.1], field: Field::FovDeg(30.0) };
    assert_eq!(mesh.camera, Some(camera));
    // In the order of the specimens, whatever that of the materials.
    assert_eq!(mesh.specimens, ["integers", "floats"]);
    assert_eq!(mesh.specimen_of_material, [1, 0]);
    assert_eq!((all.gpu.check, all.gpu.frame_time), (GpuCheck::Off, FrameTiming::Off));
}

#[test]
fn a_mesh_needs_no_more_than_its_name() {
    let folder = folder();
    let scene = |more: &str| {
        let text = good_with("tilt_deg = 20", more).replace("shape = \"patch\"", "shape = \"body.obj\"");
        parse_in(folder.path(), &text).unwrap().scenes.swap_remove(1)
    };
    let plain = scene("");
    let Shape::Mesh(mesh) = &plain.shape else { panic!("a mesh") };
    assert!(mesh.camera.is_none() && mesh.specimens.is_empty());
    let spelled = scene("camera = { position = [0, 0, 5], target = [0, 0, 0], up = [0, 1, 0], fov_deg = 25 }");
    assert_eq!(spelled, scene("camera = { position = [0, 0, 5], target = [0, 0, 0] }"));
    let Shape::Mesh(mesh) = scene("camera = { position = [0, 0, 5], target = [0, 0, 0], width = 3 }").shape else {
        panic!("a mesh")
    };
    assert_eq!(mesh.camera.unwrap().field, Field::Width(3.0));
}

#[test]
fn illuminants_and_patterns_are_resolved() {
    let folder = folder();
    let lamp = good_with("illuminant = \"D65\"", "illuminant = \"lamp.csv\"");
    let expected = Illuminant::Tabulated { wavelength_nm: vec![400.0, 700.0], power: vec![1.0, 2.0] };
    assert_eq!(parse_in(folder.path(), &lamp).unwrap().optics.illuminant, expected);
    let f11 = good_with("illuminant = \"D65\"", "illuminant = \"F11\"");
    assert_eq!(parse_in(folder.path(), &f11).unwrap().optics.illuminant, Illuminant::F(11));
    // Overlapping patterns in any order: sorted, and none twice.
    let find = "scans = [\"snake.tif\"]\npitch";
    let both = good_with(find, "scans = [\"snake2.tif\", \"s*.tif\", \"snake.tif\"]\npitch");
    let scans = &parse_in(folder.path(), &both).unwrap().specimens[0].scans;
    assert_eq!(*scans, ["snake.tif", "snake2.tif"].map(|name| folder.path().join(name)));
    // A light that is low for a level square but lights a tilted one, and the other way round.
    let tilted = |tilt: i32| {
        let scene = format!("tilt_deg = {tilt}\nlight = {{ direction = [0, 1, -0.1] }}");
        parse_in(folder.path(), &good_with("tilt_deg = 20", &scene)).is_ok()
    };
    assert!(tilted(20) && !tilted(0) && !tilted(-20));
}

#[test]
fn each_file_of_a_collection_can_be_a_specimen() {
    let folder = folder();
    for name in ["Boa 1 (left).tif", "Boa 2.tif"] {
        std::fs::write(folder.path().join(name), "").unwrap();
    }
    let each = |pattern: &str, scans: &str| {
        let names = format!("name = {pattern:?}\nscans = {scans:?}\nlevel = \"rows\"\n");
        parse_in(folder.path(), &good_with("name = \"xenopeltis\"\nscans = [\"snake.tif\"]\n", &names))
    };
    let made = each("scan-{file}", "Boa*.tif").unwrap().specimens;
    let found: Vec<_> = made[1..].iter().map(|one| (one.name.as_str(), one.scans.clone(), one.prepare.level)).collect();
    let scans = |name: &str| vec![folder.path().join(name)];
    let rows = Level::Rows;
    let expected = [("scan-Boa_1_left_", scans("Boa 1 (left).tif"), rows), ("scan-Boa_2", scans("Boa 2.tif"), rows)];
    assert_eq!(found, expected);
    // Names that come out the same, or are none.
    std::fs::write(folder.path().join("Boa_2.gsf"), "").unwrap();
    for (pattern, scans, fault) in [
        ("{file}", "Boa?2.*", "repeats the name \"Boa_2\" (of "),
        ("{file}", "Boa?2.*", "Boa 2.tif and "),
        ("elaphe", "Boa*", "repeats the name"),
        ("-{file}", "Boa 2.tif", "begin with a letter or digit"),
        ("{files}", "Boa 2.tif", "begin with a letter or digit"),
        ("{file}", "none*.tif", "matches no file"),
    ] {
        let error = each(pattern, scans).unwrap_err().to_string();
        assert!(error.contains(fault), "{pattern} of {scans}: {error}");
    }
}

#[test]
fn files_in_folders_of_their_own_and_all_but_some() {
    let folder = folder();
    for name in ["left/height.tif", "right/height.tif", "left/raw.tif", "Schlange Nr. 3 (Kopf).tif", "蛇.tif"] {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, "").unwrap();
    }
    let each = |name: &str, scans: &str| {
        let text = format!("name = {name:?}\nscans = {scans}\n");
        let read = parse_in(folder.path(), &good_with("name = \"xenopeltis\"\nscans = [\"snake.tif\"]\n", &text));
        read.map(|manifest| manifest.specimens[1..].iter().map(|one| one.name.clone()).collect::<Vec<_>>())
    };
    assert_eq!(each("{folder}", "\"*/height.tif\"").unwrap(), ["left", "right"]);
    assert_eq!(each("{folder}-{file}", "[\"*/*.tif\", \"!*/raw.tif\"]").unwrap(), ["left-height", "right-height"]);
    let error = each("{file}", "[\"left/*.tif\", \"!left/*\"]").unwrap_err().to_string();
    assert!(error.contains("leaves out every file that it names"), "{error}");
    // A name of another script: what can be read of it, and digits that are always the same.
    assert_eq!(each("{file}", "\"Schlange*\"").unwrap(), ["Schlange_Nr_3_Kopf_"]);
    let [snake] = &each("{file}", "\"蛇.tif\"").unwrap()[..] else { panic!("one file") };
    assert!(snake.starts_with("scan_") && snake.len() == 13, "{snake}");
}

#[test]
fn the_bundled_manifest_is_good() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(root.join("pipeline.toml")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    // The names count here, not the scans: empty files stand for them.
    std::fs::create_dir(folder.path().join("specimens")).unwrap();
    let names_file = |line: &&str| line.starts_with("scans = ") || line.starts_with("measured = ");
    for line in text.lines().filter(names_file) {
        let name = line.split('"').nth(1).unwrap();
        std::fs::write(folder.path().join(name), "").unwrap();
    }
    let manifest = parse_in(folder.path(), &text).unwrap();
    assert_eq!((manifest.specimens.len(), manifest.scenes.len()), (6, 5));
}

#[test]
fn the_manifest_of_real_scans_is_good() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/real_scans.toml");
    if crate::skip::shared("specimens/real").is_none() {
        return;
    }
    let (manifest, text) = manifest::load(&path).unwrap();
    assert_eq!(manifest.specimens.len(), 8);
    assert!(text.contains("real_scans"));
}
