//! An engine that knows nothing but exported files draws what the CPU computes.

use diffraction_build::optics::pigment::Surface;
use std::path::PathBuf;
use std::process::Command;

use diffraction_atlas::stages::archive::shader_export::{ShaderLanguage, ShaderSource, shader};
use diffraction_atlas::stages::archive::specimen_file;
use diffraction_brdf::direction::{Vec3, dot};
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_brdf::shader_sampling::ShaderSampler;
use diffraction_brdf::shader_spectral::promised_spectral_image;
use diffraction_brdf::{Atlas, Splines};
use diffraction_build::ground::colour::xyz_to_linear_srgb;
use diffraction_render::render::cpu;
use diffraction_render::render::gpu_bound::bound_image;
use diffraction_render::scene::samples::ShadingSamples;

use crate::published::published;
use crate::sets::gpu;

#[allow(dead_code)]
#[path = "../../examples/engine.rs"]
mod engine;

const SIDE: usize = 64;

/// Directions at every pixel's centre, weighed with the cosine of the light.
fn samples() -> ShadingSamples {
    let unit = |v: Vec3| v.map(|c| (c / dot(v, v).sqrt()) as f32);
    let place = |index: usize| 2.0 * (index as f64 + 0.5) / SIDE as f64 - 1.0;
    let mut samples = ShadingSamples { rows: SIDE, columns: SIDE, first: vec![0], ..Default::default() };
    for row in 0..SIDE {
        for column in 0..SIDE {
            let at = [place(column), -place(row)].map(|x| x * f64::from(engine::HALF_SIDE));
            let towards = |p: [f32; 3]| unit([f64::from(p[0]) - at[0], f64::from(p[1]) - at[1], f64::from(p[2])]);
            let wi = towards(engine::LIGHT);
            samples.wi.push(wi);
            samples.wo.push(towards(engine::EYE));
            samples.weight.push(wi[2]);
            samples.first.push(samples.wi.len() as u32);
        }
    }
    samples
}

/// The shaders and bytes of the published version, in a folder that lives as long as the first value.
fn export() -> (tempfile::TempDir, PathBuf) {
    exported(&["--form", "shaders"])
}

pub fn exported(words: &[&str]) -> (tempfile::TempDir, PathBuf) {
    let out = tempfile::tempdir().unwrap();
    let exported = out.path().join("exported");
    let run = Command::new(env!("CARGO_BIN_EXE_diffraction-atlas"))
        .arg("export")
        .args(words)
        .arg("--out")
        .args([&exported, &published().config.atlas_root])
        .output()
        .unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    (out, exported)
}

/// Spectral tables go out with their shader in every language, as bytes whose sizes the index tells.
#[test]
fn spectral_tables_are_exported_with_their_shader() {
    let (_place, exported) = export();
    for language in ShaderLanguage::ALL {
        let bytes = std::fs::read(exported.join(ShaderSource::Spectral.file_name(language))).unwrap();
        assert!(bytes == shader(ShaderSource::Spectral, language).unwrap(), "{}", language.name());
    }
    let specimen = exported.join("wave");
    let read = |name: &str| std::fs::read(specimen.join(name)).unwrap();
    let index: serde_json::Value = serde_json::from_slice(&read("spectral_textures.json")).unwrap();
    for (name, texel_bytes) in [("tables", 8), ("cross_terms", 8), ("lobe", 4)] {
        let texels: u64 = (0..3).map(|axis| index[name]["width_height_layers"][axis].as_u64().unwrap()).product();
        assert_eq!(read(index[name]["file"].as_str().unwrap()).len() as u64, texels * texel_bytes, "{name}");
    }
    for source in ShaderSource::ALL {
        assert!(exported.join(source.file_name(ShaderLanguage::GlslEs300)).is_file(), "{source:?}");
    }
    for index in [&index, &serde_json::from_slice(&read("textures.json")).unwrap()] {
        let about = &index["tables"];
        let sizes: Vec<[u64; 2]> = serde_json::from_value(about["coarser"]["width_height"].clone()).unwrap();
        let mut side = [0, 1].map(|axis| about["width_height_layers"][axis].as_u64().unwrap());
        assert!(sizes.len() > 1, "{sizes:?}");
        for size in &sizes {
            side = side.map(|side| side / 2);
            assert_eq!(size, &side);
        }
        let layers = about["width_height_layers"][2].as_u64().unwrap();
        let texels: u64 = sizes.iter().map(|[width, height]| layers * width * height).sum();
        assert_eq!(read(about["coarser"]["file"].as_str().unwrap()).len() as u64, 8 * texels);
    }
    let atlas = Atlas::open(&published().config.atlas_root).unwrap();
    let brdf = atlas.brdf("wave").unwrap();
    let sampling = ShaderSampler::new(brdf.tables()).image();
    let index: serde_json::Value = serde_json::from_slice(&read("textures.json")).unwrap();
    assert_eq!(index["sampling"]["width_height_layers"], serde_json::json!([sampling.size[1], sampling.size[0], 1]));
    assert_eq!(read("sampling.r32f"), bytemuck::cast_slice::<_, u8>(&sampling.texels));
    let image = promised_spectral_image(brdf.spectral().unwrap()).unwrap();
    assert_eq!(read("spectral_params.bin"), bytemuck::bytes_of(&image.params));
    assert_eq!(read("spectral_tables.rgba16f"), bytemuck::cast_slice::<_, u8>(&image.tables.texels));
}

/// Textures of 32-bit floats hold the tables as they are, and the files to include lie beside the shaders.
#[test]
fn float_texels_are_the_tables_themselves() {
    let (_place, exported) = exported(&["--form", "shaders", "--float-texels", "--prefix", "snake_"]);
    let atlas = Atlas::open(&published().config.atlas_root).unwrap();
    let set = atlas.brdf("wave").unwrap().tables().clone();
    let read = |name: &str| std::fs::read(exported.join("wave").join(name)).unwrap();
    let texels = read("tables.rgba32f");
    let texels: &[[f32; 4]] = bytemuck::cast_slice(&texels);
    let (rows, columns, _) = set.tables[0].dim();
    assert_eq!(texels.len(), set.tables.len() * rows * columns);
    // Of the look-ups that such tables are promised for: coefficients of splines.
    let splines = Splines::new(&set.tables);
    for ((row, column, channel), value) in splines.coefficients()[1].indexed_iter() {
        assert_eq!(texels[(rows + row) * columns + column][channel], *value);
    }
    let params = read("params.bin");
    assert_eq!(
        (&params[52..56], &params[80..84]),
        (&1u32.to_le_bytes()[..], &1f32.to_le_bytes()[..]),
        "splines; scales are 1"
    );
    let index: serde_json::Value = serde_json::from_slice(&read("textures.json")).unwrap();
    assert_eq!(index["tables"]["format"], "RGBA32F");
    let include = std::fs::read_to_string(exported.join("include/tables_filtered.450.glsl")).unwrap();
    assert!(include.contains("vec3 snake_brdf_xyz_filtered(") && exported.join("include/spectral_params.h").is_file());
    for (name, needed) in [
        ("snake_defs.mtlx", "function=\"mx_snake_bsdf\""),
        ("snake_bsdf.glsl", "void mx_snake_bsdf("),
        ("snake_materials.mtlx", "snake_folder=\"../wave\""),
        ("snake_materials.usda", "@../wave/textures.json@"),
        ("README.md", "snake_tables"),
    ] {
        let text = std::fs::read_to_string(exported.join("materialx").join(name)).unwrap();
        assert!(text.contains(needed) && !text.contains("PREFIX"), "{name}");
    }
}

/// OSL finds a texture by a literal alone, so shaders name the place of their export.
#[test]
fn osl_shaders_name_their_images_by_where_they_lie() {
    let (_place, exported) = exported(&["--form", "osl"]);
    let folder = exported.join("wave");
    for shader in ["diffraction_emission", "diffraction_closure"] {
        let text = std::fs::read_to_string(folder.join(format!("{shader}.osl"))).unwrap();
        assert!(text.contains(&format!("shader {shader}(")) && text.matches('{').count() == text.matches('}').count());
        let named: Vec<&str> = text.split('"').filter(|piece| piece.ends_with(".exr")).collect();
        assert!(named.len() > 4, "{named:?}");
        for image in named {
            assert!(std::path::Path::new(image).is_file(), "{image}");
        }
    }
    assert!(exported.join("README.md").is_file());
}

/// Allowed are the check's bound in the output's primaries (the magnitudes of a row sum to 5.3 at most) and what the
/// interpolated directions are off: about 16 u of the triangle's extent, 4e-6, over which `f` changes by at most its own
/// size over 1 % of a lobe's width 0.03: 1.3e-2 of the largest value.
#[test]
fn exported_files_are_all_that_an_engine_needs() {
    if gpu("engine").is_none() {
        return;
    }
    let (_place, exported) = export();
    let drawn = engine::draw(&exported, "wave", SIDE as u32).unwrap();
    let (_, set) = specimen_file::load(&published().version.join("wave")).unwrap();
    let samples = samples();
    let expected = cpu::shade(&samples, &|wi, wo| brdf_xyz(&set, Interpolation::Spline, wi, wo));
    let bound = bound_image(Surface::without_pigment(&set), &samples);
    // The largest share of what is allowed, for a CPU that is off by a factor.
    let worst = |factor: f64| {
        let mut worst = 0.0f64;
        for row in 0..SIDE {
            for column in 0..SIDE {
                let xyz = [0, 1, 2].map(|c| factor * f64::from(expected[[row, column, c]]));
                let allowed: f64 = (0..3).map(|c| f64::from(bound[[row, column, c]])).sum();
                let largest = xyz.iter().fold(0.0f64, |m, v| m.max(v.abs()));
                for (c, value) in xyz_to_linear_srgb(xyz).into_iter().enumerate() {
                    let difference = (f64::from(drawn[[row, column, c]]) - value).abs();
                    worst = worst.max(difference / (5.3 * allowed + 1.3e-2 * largest + 1e-9));
                }
            }
        }
        worst
    };
    let lit = expected.iter().filter(|v| **v > 1e-3).count();
    println!("engine: {:.3} of what is allowed, {lit} lit values", worst(1.0));
    assert!(lit > 1000 && worst(1.0) < 1.0, "{} {lit}", worst(1.0));
    assert!(worst(1.05) > 1.0, "5 % of brightness must show");
}
