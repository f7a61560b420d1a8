//! Every translation of the table shader, compiled or validated by tools that know nothing of naga.

use std::path::Path;
use std::process::Command;

use crate::skip::skipped;
use diffraction_atlas::stages::archive::shader_export::{README, ShaderLanguage, shader};

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

/// Writes a shader, also spoilt, and asks the compiler about both.
fn check(language: ShaderLanguage, tool: &str, arguments: &[&str], spoil: impl Fn(&mut Vec<u8>)) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join(format!("material.{}", language.extension()));
    let mut bytes = shader(language).unwrap();
    std::fs::write(&file, &bytes).unwrap();
    if let Some(accepted) = accepted(tool, arguments, &file) {
        assert!(accepted, "{} was refused by {tool}", language.name());
    }
    spoil(&mut bytes);
    std::fs::write(&file, &bytes).unwrap();
    assert_ne!(accepted(tool, arguments, &file), Some(true), "{tool} accepts anything as {}", language.name());
}

/// Renames the texture's declaration but not its uses, or the like.
fn misspell(bytes: &mut Vec<u8>) {
    let text = String::from_utf8(bytes.clone()).unwrap();
    *bytes = text.replacen("radius_max", "radius_mix", 1).into_bytes();
}

#[test]
fn glsl_es_300_compiles() {
    check(ShaderLanguage::GlslEs300, "glslangValidator", &["-S", "frag"], misspell);
}

#[test]
fn glsl_450_compiles() {
    check(ShaderLanguage::Glsl450, "glslangValidator", &["-S", "frag"], misspell);
}

#[test]
fn hlsl_compiles() {
    let arguments = ["-D", "-V", "-S", "frag", "-e", "shade_material", "-o", "/dev/null"];
    check(ShaderLanguage::Hlsl, "glslangValidator", &arguments, misspell);
}

#[test]
fn spirv_validates() {
    check(ShaderLanguage::Spirv, "spirv-val", &[], |bytes| bytes.truncate(bytes.len() - 8));
}

/// No free compiler reads Metal's language here: what is in it is looked at instead.
#[test]
fn msl_holds_the_functions_and_the_bindings() {
    let text = String::from_utf8(shader(ShaderLanguage::Msl).unwrap()).unwrap();
    for needed in [
        "fragment shade_materialOutput shade_material(",
        "metal::float3 brdf_xyz(",
        "[[buffer(0)]]",
        "[[texture(0)]]",
        "[[texture(1)]]",
        "[[texture(2)]]",
        "[[sampler(0)]]",
    ] {
        assert!(text.contains(needed), "{needed} is missing in\n{text}");
    }
    assert_eq!(text.matches('{').count(), text.matches('}').count());
    assert!(!text.contains("fake"), "a binding is missing");
}

#[test]
fn every_text_holds_the_evaluation_under_its_own_names() {
    for language in ShaderLanguage::ALL {
        if language != ShaderLanguage::Spirv {
            let text = String::from_utf8(shader(language).unwrap()).unwrap();
            for name in ["brdf_xyz(", "diffuse_factor(", "coherent_factor(", "geometry_factor(", "lobe_at("] {
                assert!(text.contains(name), "{name} is missing in {}", language.name());
            }
        }
    }
}

/// The README that goes with exported shaders names what is in them.
#[test]
fn bindings_are_where_the_readme_says() {
    let text = |language| String::from_utf8(shader(language).unwrap()).unwrap();
    let columns = [ShaderLanguage::Glsl450, ShaderLanguage::GlslEs300, ShaderLanguage::Hlsl, ShaderLanguage::Msl];
    let mut rows = 0;
    for line in README.lines().filter(|line| line.starts_with("| `") || line.starts_with("| sampler")) {
        rows += 1;
        let cells: Vec<&str> = line.split('|').map(str::trim).skip(3).collect();
        for (language, cell) in columns.into_iter().zip(cells) {
            let text = text(language);
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
    }
    assert_eq!(rows, 5);
    let hlsl = text(ShaderLanguage::Hlsl);
    assert!(!hlsl.contains("nagaSampler") && hlsl.contains("SamplerState bilinear : register(s4);"));
    for language in ShaderLanguage::ALL {
        let entry = if language.name().starts_with("glsl") { "void main()" } else { "shade_material" };
        if language != ShaderLanguage::Spirv {
            assert!(text(language).contains(entry), "{entry} in {}", language.name());
        }
    }
}
