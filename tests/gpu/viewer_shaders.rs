//! The GLSL that the viewer's page is built from: what naga makes of the one WGSL source, stored in `viewer/src/generated`.
//!
//! After a change in the WGSL: `WRITE_GENERATED=1 cargo test --release --test gpu viewer_shaders`, then build the page anew.

use std::path::Path;

use diffraction_atlas::stages::archive::shader_export::{ShaderLanguage, ShaderSource, shader};

#[test]
fn the_stored_glsl_is_what_the_wgsl_gives() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("viewer/src/generated");
    // The page draws no samples.
    for source in ShaderSource::ALL.into_iter().filter(|source| *source != ShaderSource::TablesSampled) {
        let path = folder.join(format!("{}.glsl", source.name()));
        let fresh = shader(source, ShaderLanguage::GlslEs300).unwrap();
        if std::env::var_os("WRITE_GENERATED").is_some() {
            std::fs::create_dir_all(&folder).unwrap();
            std::fs::write(&path, &fresh).unwrap();
        }
        let found = std::fs::read(&path).unwrap_or_default();
        assert!(found == fresh, "{}: not what the WGSL gives; see the head of this test's file", path.display());
    }
}
