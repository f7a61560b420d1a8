//! The exported GLSL as a node of MaterialX, with a material for each specimen, and the same materials in USD.

use std::fmt::Write;
use std::path::Path;

use diffraction_brdf::error::Result;
use diffraction_brdf::files;

/// The node and its implementation, with `PREFIX` for what begins every global name.
const DEFS: &str = include_str!("materialx/defs.mtlx");
/// What the implementation calls.
const BSDF: &str = include_str!("materialx/bsdf.glsl");
/// What a renderer binds.
const README: &str = include_str!("materialx/README.md");

/// Writes the folder's files: definitions, code, materials of the named specimens, whose folders lie beside `folder`, and what to do with them.
///
/// # Errors
/// The disk's.
pub(crate) fn write_materialx(folder: &Path, prefix: &str, specimens: &[&str]) -> Result<()> {
    files::create_folder(folder)?;
    let write = |name: &str, text: &str| files::replace(&folder.join(name), text.replace("PREFIX", prefix).as_bytes());
    write(&format!("{prefix}defs.mtlx"), DEFS)?;
    write(&format!("{prefix}bsdf.glsl"), BSDF)?;
    write("README.md", README)?;
    write(&format!("{prefix}materials.mtlx"), &materials(specimens))?;
    write(&format!("{prefix}materials.usda"), &stage(specimens))
}

/// A specimen's name as both languages take names: letters, digits and underscores; anything else by its number.
fn identifier(specimen: &str) -> String {
    specimen.chars().fold(String::from("M_"), |mut name, c| {
        if c.is_ascii_alphanumeric() || c == '_' {
            name.push(c);
        } else {
            let _ = write!(name, "_x{:x}_", u32::from(c));
        }
        name
    })
}

/// Text between quotes in XML.
fn quoted(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

fn materials(specimens: &[&str]) -> String {
    let mut text = String::from(
        "<?xml version=\"1.0\"?>\n<materialx version=\"1.39\" colorspace=\"lin_rec709\" xmlns:xi=\"http://www.w3.org/2001/XInclude\">\n  <xi:include href=\"PREFIXdefs.mtlx\" />\n",
    );
    for specimen in specimens {
        let name = identifier(specimen);
        let folder = quoted(&format!("../{specimen}"));
        let _ = write!(
            text,
            "\n  <PREFIXbsdf name=\"{name}_bsdf\" type=\"BSDF\" PREFIXfolder=\"{folder}\">\n    <input name=\"light_diameter\" type=\"float\" value=\"0.53\" />\n  </PREFIXbsdf>\n  <surface name=\"{name}_surface\" type=\"surfaceshader\">\n    <input name=\"bsdf\" type=\"BSDF\" nodename=\"{name}_bsdf\" />\n  </surface>\n  <surfacematerial name=\"{name}\" type=\"material\">\n    <input name=\"surfaceshader\" type=\"surfaceshader\" nodename=\"{name}_surface\" />\n  </surfacematerial>\n"
        );
    }
    text + "\n</materialx>\n"
}

/// Balls in a row, each of one material, under a light like the sun.
fn stage(specimens: &[&str]) -> String {
    let mut text = String::from(
        "#usda 1.0\n(\n    defaultPrim = \"Materials\"\n    metersPerUnit = 0.01\n    upAxis = \"Y\"\n)\n\ndef Scope \"Materials\"\n{\n",
    );
    for specimen in specimens {
        let _ = write!(text, "{}", material(specimen));
    }
    text += "}\n\ndef Xform \"Balls\"\n{\n";
    for (n, specimen) in specimens.iter().enumerate() {
        let (name, x) = (identifier(specimen), 3 * n);
        let _ = write!(
            text,
            "    def Sphere \"{name}\" (\n        prepend apiSchemas = [\"MaterialBindingAPI\"]\n    )\n    {{\n        rel material:binding = </Materials/{name}>\n        double3 xformOp:translate = ({x}, 0, 0)\n        uniform token[] xformOpOrder = [\"xformOp:translate\"]\n    }}\n"
        );
    }
    text + "}\n\ndef DistantLight \"Sun\"\n{\n    float inputs:angle = 0.53\n    float inputs:intensity = 30\n}\n"
}

fn material(specimen: &str) -> String {
    let name = identifier(specimen);
    format!(
        "    def Material \"{name}\"\n    {{\n        custom asset PREFIXtextures = @../{specimen}/textures.json@\n        token outputs:mtlx:surface.connect = </Materials/{name}/Surface.outputs:out>\n\n        def Shader \"Surface\"\n        {{\n            uniform token info:id = \"ND_surface\"\n            token inputs:bsdf.connect = </Materials/{name}/Diffraction.outputs:out>\n            token outputs:out\n        }}\n\n        def Shader \"Diffraction\"\n        {{\n            uniform token info:implementationSource = \"sourceAsset\"\n            uniform asset info:mtlx:sourceAsset = @./PREFIXdefs.mtlx@\n            uniform token info:mtlx:sourceAsset:subIdentifier = \"ND_PREFIXbsdf\"\n            float inputs:light_diameter = 0.53\n            float inputs:turn = 0\n            float inputs:weight = 1\n            token outputs:out\n        }}\n    }}\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stay_apart_and_are_names() {
        assert_eq!(identifier("corn_snake"), "M_corn_snake");
        assert_eq!(identifier("a-b"), "M_a_x2d_b");
        assert_ne!(identifier("a-b"), identifier("a_b"));
        assert_eq!(quoted("a\"b&<"), "a&quot;b&amp;&lt;");
    }
}
