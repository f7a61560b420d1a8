//! A specimen's tables as the bytes that the exported shaders read: a uniform block and three textures, ready to upload.

use std::path::Path;

use serde_json::json;

use diffraction_brdf::error::Result;
use diffraction_brdf::files;
use diffraction_brdf::json;
use diffraction_brdf::shader::{HalfLayers, table_image};
use diffraction_build::optics::pigment::Surface;

/// Name of the file that describes the others.
pub(crate) const INDEX: &str = "textures.json";

/// Writes `params.bin` (the block `TableParams`, 2112 bytes, little-endian), the texels of the three textures row by row and
/// layer by layer without padding, and [`INDEX`] with their sizes and formats.
///
/// # Errors
/// `Error::Limit` for tables that do not fit every GPU; the disk's.
pub(crate) fn write_shader_data(folder: &Path, surface: Surface) -> Result<()> {
    files::create_folder(folder)?;
    let image = table_image(surface.tables, surface.pigment.map(|pigment| pigment.xyz_per_sr))?;
    let [rows, columns] = image.coherent_size;
    files::replace(&folder.join("params.bin"), bytemuck::bytes_of(&image.params))?;
    files::replace(&folder.join("tables.rgba16f"), bytemuck::cast_slice(&image.tables.texels))?;
    files::replace(&folder.join("cross_terms.rgba16f"), bytemuck::cast_slice(&image.cross.texels))?;
    files::replace(&folder.join("lobe.rgba32f"), bytemuck::cast_slice(&image.coherent))?;
    let layers = |layers: &HalfLayers| {
        let [rows, columns] = layers.size;
        json!([columns, rows, layers.texels.len() / (rows * columns)])
    };
    let index = json!({
        "params": { "binding": 0, "file": "params.bin", "kind": "uniform buffer" },
        "tables": { "binding": 1, "file": "tables.rgba16f", "kind": "2D array texture", "format": "RGBA16F",
            "width_height_layers": layers(&image.tables), "filter": "linear", "wrap": "clamp to edge" },
        "cross_terms": { "binding": 2, "file": "cross_terms.rgba16f", "kind": "2D array texture", "format": "RGBA16F",
            "width_height_layers": layers(&image.cross), "filter": "linear", "wrap": "clamp to edge" },
        "lobe": { "binding": 3, "file": "lobe.rgba32f", "kind": "2D texture", "format": "RGBA32F",
            "width_height_layers": [columns, rows, 1], "filter": "none: texels are fetched" },
    });
    json::write(&folder.join(INDEX), &index)
}
