//! Every translation of the table shader, compiled or validated by tools that know nothing of naga.

use std::path::Path;
use std::process::Command;

use crate::skip::skipped;
use diffraction_atlas::stages::archive::shader_export::{
    README, SPECTRAL_README, ShaderLanguage, ShaderSource, shader,
};

/// Runs a compiler over a shader; `None` with a loud line where the compiler is not installed.
fn accepted(tool: &str, arguments: &[&str], file: &Path) -> Option<bool> {
    let output = match Command::new(tool).args(arguments).arg(file).output() {
        Ok(output) => output,
        Err(_) => {
            skipped(format_args!("{} by {tool}: not installed (glslang-tools, spirv-tools)", file.display()));
            return None;
        }
    };
    if !output.status.success() {
        println!("{tool}: {}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    }
    Some(output.status.success())
}

const SOURCES: [ShaderSource; 5] = ShaderSource::ALL;

/// Name of a source's entry point, and a field of its uniform.
fn names(source: ShaderSource) -> [&'static str; 2] {
    match source {
        ShaderSource::Tables => ["shade_material", "radius_max"],
        ShaderSource::TablesFiltered => ["shade_material_filtered", "radius_max"],
        ShaderSource::TablesSampled => ["shade_material_sampled", "radius_max"],
        ShaderSource::Spectral => ["shade_spectral", "cross_radius"],
        ShaderSource::SpectralFiltered => ["shade_spectral_filtered", "cross_radius"],
    }
}

/// Writes a shader, also spoilt, and asks the compiler about both.
fn check(source: ShaderSource, language: ShaderLanguage, tool: &str, arguments: &[&str], spoil: impl Fn(&mut Vec<u8>)) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join(source.file_name(language));
    let mut bytes = shader(source, language).unwrap();
    std::fs::write(&file, &bytes).unwrap();
    if let Some(accepted) = accepted(tool, arguments, &file) {
        assert!(accepted, "{source:?} in {} was refused by {tool}", language.name());
    }
    spoil(&mut bytes);
    std::fs::write(&file, &bytes).unwrap();
    assert_ne!(accepted(tool, arguments, &file), Some(true), "{tool} accepts anything as {}", language.name());
}

/// Renames a field's declaration but not its uses.
fn misspell(source: ShaderSource) -> impl Fn(&mut Vec<u8>) {
    move |bytes| {
        let text = String::from_utf8(bytes.clone()).unwrap();
        *bytes = text.replacen(names(source)[1], "misspelt", 1).into_bytes();
    }
}

#[test]
fn glsl_es_300_compiles() {
    for source in SOURCES {
        check(source, ShaderLanguage::GlslEs300, "glslangValidator", &["-S", "frag"], misspell(source));
    }
}

#[test]
fn glsl_450_compiles() {
    for source in SOURCES {
        check(source, ShaderLanguage::Glsl450, "glslangValidator", &["-S", "frag"], misspell(source));
    }
}

#[test]
fn hlsl_compiles() {
    for source in SOURCES {
        let arguments = ["-D", "-V", "-S", "frag", "-e", names(source)[0], "-o", "/dev/null"];
        check(source, ShaderLanguage::Hlsl, "glslangValidator", &arguments, misspell(source));
    }
}

#[test]
fn spirv_validates() {
    for source in SOURCES {
        check(source, ShaderLanguage::Spirv, "spirv-val", &[], |bytes| bytes.truncate(bytes.len() - 8));
    }
}

/// No free compiler reads Metal's language here: what is in it is looked at instead.
#[test]
fn msl_holds_the_functions_and_the_bindings() {
    for (source, signatures) in [
        (ShaderSource::Tables, ["fragment shade_materialOutput shade_material(", "metal::float3 brdf_xyz("]),
        (
            ShaderSource::TablesFiltered,
            ["fragment shade_material_filteredOutput shade_material_filtered(", "metal::float3 brdf_xyz_filtered("],
        ),
        (
            ShaderSource::TablesSampled,
            ["fragment shade_material_sampledOutput shade_material_sampled(", "metal::float4 brdf_sample("],
        ),
        (ShaderSource::Spectral, ["fragment shade_spectralOutput shade_spectral(", "float brdf_spectral("]),
        (
            ShaderSource::SpectralFiltered,
            ["fragment shade_spectral_filteredOutput shade_spectral_filtered(", "float brdf_spectral_filtered("],
        ),
    ] {
        let text = String::from_utf8(shader(source, ShaderLanguage::Msl).unwrap()).unwrap();
        let slots = ["[[buffer(0)]]", "[[texture(0)]]", "[[texture(1)]]", "[[texture(2)]]", "[[sampler(0)]]"];
        for needed in signatures.into_iter().chain(slots) {
            assert!(text.contains(needed), "{needed} is missing in\n{text}");
        }
        assert_eq!(text.matches('{').count(), text.matches('}').count());
        assert!(!text.contains("fake"), "a binding is missing");
    }
}

#[test]
fn every_text_holds_the_evaluation_under_its_own_names() {
    let shared = ["diffuse_factor(", "coherent_factor(", "geometry_factor("];
    for (source, own) in [
        (ShaderSource::Tables, ["brdf_xyz(", "lobe_at("]),
        (ShaderSource::TablesFiltered, ["brdf_xyz_filtered(", "gaussian_mean("]),
        (ShaderSource::TablesSampled, ["brdf_sample(", "brdf_pdf("]),
        (ShaderSource::Spectral, ["brdf_spectral(", "power_at("]),
        (ShaderSource::SpectralFiltered, ["brdf_spectral_filtered(", "gaussian_mean("]),
    ] {
        for language in ShaderLanguage::ALL.into_iter().filter(|language| *language != ShaderLanguage::Spirv) {
            let text = String::from_utf8(shader(source, language).unwrap()).unwrap();
            for name in own.into_iter().chain(shared) {
                assert!(text.contains(name), "{name} is missing in {}", language.name());
            }
        }
    }
}

/// The READMEs that go with exported shaders name what is in them.
#[test]
fn bindings_are_where_the_readmes_say() {
    for (source, readme) in [
        (ShaderSource::Tables, README),
        (ShaderSource::TablesFiltered, README),
        (ShaderSource::TablesSampled, README),
        (ShaderSource::Spectral, SPECTRAL_README),
        (ShaderSource::SpectralFiltered, SPECTRAL_README),
    ] {
        let text = |language| String::from_utf8(shader(source, language).unwrap()).unwrap();
        let columns = [ShaderLanguage::Glsl450, ShaderLanguage::GlslEs300, ShaderLanguage::Hlsl, ShaderLanguage::Msl];
        let mut rows = 0;
        for line in readme.lines().filter(|line| line.starts_with("| `") || line.starts_with("| sampler")) {
            rows += 1;
            let cells: Vec<&str> = line.split('|').map(str::trim).skip(3).collect();
            for (language, cell) in columns.into_iter().zip(cells) {
                binding_is_stated(&text(language), language, cell);
            }
        }
        assert_eq!(rows, 5);
        if source == ShaderSource::TablesFiltered {
            binding_is_stated(&text(ShaderLanguage::Glsl450), ShaderLanguage::Glsl450, "binding 5");
            binding_is_stated(&text(ShaderLanguage::GlslEs300), ShaderLanguage::GlslEs300, "`_group_0_binding_5_fs`");
            binding_is_stated(&text(ShaderLanguage::Hlsl), ShaderLanguage::Hlsl, "`t5`");
            binding_is_stated(&text(ShaderLanguage::Msl), ShaderLanguage::Msl, "`texture(3)`");
        }
        if source == ShaderSource::TablesSampled {
            binding_is_stated(&text(ShaderLanguage::Glsl450), ShaderLanguage::Glsl450, "binding 6");
            binding_is_stated(&text(ShaderLanguage::GlslEs300), ShaderLanguage::GlslEs300, "`_group_0_binding_6_fs`");
            binding_is_stated(&text(ShaderLanguage::Hlsl), ShaderLanguage::Hlsl, "`t6`");
            binding_is_stated(&text(ShaderLanguage::Msl), ShaderLanguage::Msl, "`texture(4)`");
        }
        let hlsl = text(ShaderLanguage::Hlsl);
        assert!(!hlsl.contains("nagaSampler") && hlsl.contains("SamplerState bilinear : register(s4);"));
        for language in ShaderLanguage::ALL.into_iter().filter(|language| *language != ShaderLanguage::Spirv) {
            let entry = if language.name().starts_with("glsl") { "void main()" } else { names(source)[0] };
            assert!(text(language).contains(entry), "{entry} in {}", language.name());
        }
    }
}

/// A cell of a README's table of bindings against the shader's text.
fn binding_is_stated(text: &str, language: ShaderLanguage, cell: &str) {
    for name in cell.split('`').skip(1).step_by(2) {
        let in_code = match language {
            ShaderLanguage::Hlsl => format!("register({name})"),
            ShaderLanguage::Msl => format!("[[{name}]]"),
            _ => format!(" {name}"),
        };
        assert!(text.contains(&in_code), "{in_code} is missing in {}", language.name());
    }
    if let Some(number) = cell.strip_prefix("binding ") {
        assert!(text.contains(&format!("binding = {number})")), "{number} in {}", language.name());
    }
}
