//! Files to include: two under different prefixes fit one program, as reference compilers read it.

use std::process::Command;

use crate::skip::skipped;
use diffraction_atlas::stages::archive::shader_export::{ShaderLanguage, ShaderSource};
use diffraction_atlas::stages::archive::shader_include::{IncludeConfig, LANGUAGES, block, include};

const FIRST: &str = "sunbeam_";
const SECOND: &str = "corn_";

fn config(prefix: &str, first_binding: u32) -> IncludeConfig {
    IncludeConfig { prefix: prefix.into(), first_binding }
}

/// Two materials of one source in a language.
fn both(source: ShaderSource, language: ShaderLanguage) -> [String; 2] {
    [(FIRST, 0), (SECOND, 8)].map(|(prefix, first)| include(source, language, &config(prefix, first)).unwrap())
}

/// The call of a source's own function.
fn call(source: ShaderSource, prefix: &str, vector: &str) -> String {
    let arguments = format!("{vector}(0.0, 0.0, 1.0), {vector}(0.6, 0.0, 0.8)");
    match source {
        ShaderSource::Tables => format!("{prefix}brdf_xyz({arguments}).y"),
        ShaderSource::TablesFiltered => format!("{prefix}brdf_xyz_filtered({arguments}, {vector}(1e-4, 0.0, 1e-4)).y"),
        ShaderSource::TablesSampled => {
            format!(
                "{prefix}brdf_sample({arguments}).w + {prefix}brdf_pdf({arguments}) + {prefix}brdf_xyz({arguments}).y"
            )
        }
        ShaderSource::Spectral => format!("{prefix}brdf_spectral({arguments}, 550.0)"),
        ShaderSource::SpectralFiltered => {
            format!("{prefix}brdf_spectral_filtered({arguments}, 550.0, {vector}(1e-4, 0.0, 1e-4))")
        }
    }
}

/// Whether a compiler takes a text; `None` with a loud line where it is not installed.
fn accepted(tool: &str, arguments: &[&str], name: &str, text: &str) -> Option<bool> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join(name);
    std::fs::write(&file, text).unwrap();
    let Ok(output) = Command::new(tool).args(arguments).arg(&file).output() else {
        skipped(format_args!("includes by {tool}: not installed (glslang-tools, gcc)"));
        return None;
    };
    if !output.status.success() {
        println!("{tool}: {}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    }
    Some(output.status.success())
}

/// The program is taken, and refused where both materials have one prefix.
fn check(source: ShaderSource, language: ShaderLanguage, arguments: &[&str], program: impl Fn([String; 2]) -> String) {
    let texts = both(source, language);
    let good = program(texts.clone());
    let Some(taken) = accepted("glslangValidator", arguments, "a.frag", &good) else { return };
    assert!(taken, "{source:?} in {} is refused", language.name());
    let same = program([texts[0].clone(), texts[0].clone()]);
    assert_eq!(accepted("glslangValidator", arguments, "a.frag", &same), Some(false), "one prefix for both is taken");
}

#[test]
fn two_materials_fit_one_glsl_program() {
    for source in ShaderSource::ALL {
        for (language, head) in
            [(ShaderLanguage::Glsl450, "#version 450\n"), (ShaderLanguage::GlslEs300, "#version 300 es\n")]
        {
            let [a, b] = [FIRST, SECOND].map(|prefix| call(source, prefix, "vec3"));
            check(source, language, &["-S", "frag"], |[first, second]| {
                format!(
                    "{head}{first}{second}\nlayout(location = 0) out vec4 shown;\nvoid main() {{ shown = vec4({a}, {b}, 0.0, 1.0); }}\n"
                )
            });
        }
    }
}

#[test]
fn two_materials_fit_one_hlsl_program() {
    for source in ShaderSource::ALL {
        let [a, b] = [FIRST, SECOND].map(|prefix| call(source, prefix, "float3"));
        let arguments = ["-D", "-V", "-S", "frag", "-e", "main", "-o", "/dev/null"];
        check(source, ShaderLanguage::Hlsl, &arguments, |[first, second]| {
            format!("{first}{second}\nfloat4 main() : SV_Target0 {{ return float4({a}, {b}, 0.0, 1.0); }}\n")
        });
    }
}

#[test]
fn two_materials_fit_one_wgsl_program() {
    for source in ShaderSource::ALL {
        let [a, b] = [FIRST, SECOND].map(|prefix| call(source, prefix, "vec3<f32>"));
        let texts = both(source, ShaderLanguage::Wgsl);
        let program = |[first, second]: [&str; 2]| {
            format!(
                "{first}\n{second}\n@fragment fn shown() -> @location(0) vec4<f32> {{ return vec4<f32>({a}, {b}, 0.0, 1.0); }}\n"
            )
        };
        let good = program([&texts[0], &texts[1]]);
        naga::front::wgsl::parse_str(&good).unwrap_or_else(|error| panic!("{}", error.emit_to_string(&good)));
        assert!(naga::front::wgsl::parse_str(&program([&texts[0], &texts[0]])).is_err());
    }
}

/// No free compiler reads Metal's language here: every global is looked at instead.
#[test]
fn no_include_has_an_entry_point_or_a_global_without_its_prefix() {
    for source in ShaderSource::ALL {
        for language in LANGUAGES {
            let text = include(source, language, &config(FIRST, 0)).unwrap();
            for entry in ["@fragment", "void main", "SV_Target", "[[stage_in]]", "fragment "] {
                assert!(!text.contains(entry), "{entry} in {source:?}, {}", language.name());
            }
            assert_eq!(text.matches('{').count(), text.matches('}').count());
            for name in ["reflectance(", "Front ", "complex_root("] {
                let all = text.match_indices(name);
                // A field is called `front.shadowing`, a constructor `ConstructFront`; neither is among these.
                let bare = all.filter(|(at, _)| !text[..*at].ends_with(FIRST) && !text[..*at].ends_with("// ")).count();
                assert_eq!(bare, 0, "{name} without its prefix in {source:?}, {}", language.name());
            }
        }
    }
}

#[test]
fn prefixes_that_are_no_names_are_refused() {
    for bad in ["", "1a", "a__b", "gl_x", "naga_", "a-b", "é"] {
        let refused = include(ShaderSource::Tables, ShaderLanguage::Wgsl, &config(bad, 0)).unwrap_err();
        assert!(refused.exit_status() == 2 && refused.to_string().contains("letters, digits"), "{refused}");
    }
    for good in ["a", "Tables2_", "snake"] {
        include(ShaderSource::Tables, ShaderLanguage::Hlsl, &config(good, 3)).unwrap();
    }
}

#[test]
fn the_block_in_c_lies_as_the_shader_has_it() {
    for (source, bytes, field, offset) in
        [(ShaderSource::Tables, 2128, "pigment", 64), (ShaderSource::Spectral, 2112, "table_scales", 64)]
    {
        let (json, c) = block(source, &config(FIRST, 0)).unwrap();
        assert_eq!(json["bytes"], bytes);
        let found = json["fields"].as_array().unwrap().iter().find(|found| found["name"] == field).unwrap();
        assert_eq!(found["offset"], offset);
        let compiled = |text: &str| accepted("cc", &["-std=c11", "-fsyntax-only", "-x", "c"], "block.h", text);
        let Some(taken) = compiled(&c) else { return };
        assert!(taken, "{c}");
        let moved = c.replacen("    uint32_t ", "    uint32_t added;\n    uint32_t ", 1);
        assert_eq!(compiled(&moved), Some(false), "a field that moved goes unseen");
    }
}

#[test]
fn bindings_begin_where_they_are_told() {
    let text = |language, first| include(ShaderSource::TablesFiltered, language, &config(FIRST, first)).unwrap();
    assert!(
        text(ShaderLanguage::Wgsl, 8).contains("@binding(13)")
            && !text(ShaderLanguage::Wgsl, 8).contains("@binding(5)")
    );
    assert!(text(ShaderLanguage::Glsl450, 8).contains("binding = 13"));
    let sampled = include(ShaderSource::TablesSampled, ShaderLanguage::Glsl450, &config(FIRST, 8)).unwrap();
    assert!(sampled.contains("binding = 14") && sampled.contains("uniform sampler2D sunbeam_sampling;"));
    assert!(text(ShaderLanguage::Hlsl, 8).contains("SamplerState sunbeam_bilinear : register(s12);"));
    let es = text(ShaderLanguage::GlslEs300, 0);
    assert!(es.contains("uniform highp sampler2DArray sunbeam_tables;") && !es.contains("_group_0_"), "{es}");
}
