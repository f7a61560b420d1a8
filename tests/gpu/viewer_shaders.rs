//! The GLSL that the viewer's page is built from: what naga makes of the one WGSL source, stored in `viewer/src/generated`.
//!
//! After a change in the WGSL: `WRITE_GENERATED=1 cargo test --release --test gpu viewer_shaders`, then build the page anew.

use std::path::{Path, PathBuf};

use crate::shader_export::accepted;
use diffraction_atlas::stages::archive::shader_export::{ShaderSource, glsl_functions};

const SOURCES: [ShaderSource; 2] = [ShaderSource::Tables, ShaderSource::Spectral];

fn stored(source: ShaderSource) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("viewer/src/generated");
    folder.join(format!("{}.glsl", source.name()))
}

#[test]
fn the_stored_glsl_is_what_the_wgsl_gives() {
    for source in SOURCES {
        let (path, fresh) = (stored(source), glsl_functions(source).unwrap());
        if std::env::var_os("WRITE_GENERATED").is_some() {
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(&path, &fresh).unwrap();
        }
        let found = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(found == fresh, "{}: not what the WGSL gives; see the head of this test's file", path.display());
    }
}

#[test]
fn the_glsl_compiles_behind_a_main_of_ones_own() {
    let head = "#version 300 es\nprecision highp float;\nprecision highp int;\n";
    let mains = [
        "in vec3 wi; in vec3 wo; out vec4 shown; void main() { shown = vec4(xyz_to_linear_srgb(surface_xyz(wi, wo)), \
         has_answer(brdf_xyz(wi, wo)) ? 1.0 : 0.0); }",
        "in vec3 wi; in vec3 wo; out vec4 shown; void main() { shown = vec4(brdf_spectral(wi, wo, 550.0), \
         brdf_spectral_with(front_of_index(vec2(1.5, 0.0)), wi, wo, 500.0), 0.0, 1.0); }",
    ];
    for (source, main) in SOURCES.into_iter().zip(mains) {
        let functions = glsl_functions(source).unwrap();
        assert!(!functions.contains("void main") && !functions.contains(" in vec3 _vs2fs"), "{functions}");
        let whole = [head, &functions, main].concat();
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("page.frag");
        std::fs::write(&file, &whole).unwrap();
        let arguments = ["-S", "frag"];
        if let Some(fine) = accepted("glslangValidator", &arguments, &file) {
            assert!(fine, "{source:?}");
            std::fs::write(&file, whole.replacen("vec2 permittivity", "vec2 misspelt", 1)).unwrap();
            assert_eq!(accepted("glslangValidator", &arguments, &file), Some(false), "anything is accepted");
        }
    }
}
