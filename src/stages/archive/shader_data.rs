//! A specimen's tables as the bytes that the exported shaders read: a uniform block and three textures, ready to upload.

use std::path::Path;

use serde_json::json;

use diffraction_brdf::SpectralTables;
use diffraction_brdf::error::Result;
use diffraction_brdf::files;
use diffraction_brdf::json;
use diffraction_brdf::shader::{GAUSSIANS, HalfLayers, promised_image};
use diffraction_brdf::shader_spectral::promised_spectral_image;
use diffraction_build::optics::pigment::Surface;

/// Name of the file that describes the others.
pub(crate) const INDEX: &str = "textures.json";

/// The same for spectral tables.
const SPECTRAL_INDEX: &str = "spectral_textures.json";

/// Writes `params.bin` (the block `TableParams`, 2128 bytes, little-endian), the texels of the textures row by row and
/// layer by layer without padding, those of coarser levels level by level in files of their own, and [`INDEX`] with their sizes and
/// formats.
///
/// # Errors
/// `Error::Limit` for tables that do not fit every GPU; the disk's.
pub(crate) fn write_shader_data(folder: &Path, surface: Surface) -> Result<()> {
    files::create_folder(folder)?;
    let image = promised_image(surface.tables, surface.pigment.map(|pigment| pigment.xyz_per_sr))?;
    let [rows, columns] = image.coherent_size;
    files::replace(&folder.join("params.bin"), bytemuck::bytes_of(&image.params))?;
    write_levels(folder, "tables", &image.tables)?;
    write_levels(folder, "cross_terms", &image.cross)?;
    files::replace(&folder.join("lobe.rgba32f"), bytemuck::cast_slice(&image.coherent))?;
    files::replace(&folder.join("lobe_gaussians.rgba32f"), bytemuck::cast_slice(&image.gaussians))?;
    let index = json!({
        "params": { "binding": 0, "file": "params.bin", "kind": "uniform buffer" },
        "tables": { "binding": 1, "file": "tables.rgba16f", "kind": "2D array texture",
            "format": "RGBA16F", "width_height_layers": layers(&image.tables), "filter": "linear",
            "wrap": "clamp to edge", "coarser": coarser("tables", &image.tables) },
        "cross_terms": { "binding": 2, "file": "cross_terms.rgba16f", "kind": "2D array texture",
            "format": "RGBA16F", "width_height_layers": layers(&image.cross), "filter": "linear",
            "wrap": "clamp to edge", "coarser": coarser("cross_terms", &image.cross) },
        "lobe": { "binding": 3, "file": "lobe.rgba32f", "kind": "2D texture", "format": "RGBA32F",
            "width_height_layers": [columns, rows, 1], "filter": "none: texels are fetched" },
        "lobe_gaussians": { "binding": 5, "file": "lobe_gaussians.rgba32f", "kind": "2D texture", "format": "RGBA32F",
            "width_height_layers": [GAUSSIANS, rows, 1], "filter": "none: texels are fetched" },
    });
    json::write(&folder.join(INDEX), &index)
}

/// Writes `spectral_params.bin` (the block `SpectralParams`, 2112 bytes, little-endian), the texels of the three textures, and
/// their sizes and formats.
///
/// # Errors
/// `Error::Limit` for tables that do not fit every GPU; the disk's.
pub(crate) fn write_spectral_data(folder: &Path, tables: &SpectralTables) -> Result<()> {
    let image = promised_spectral_image(tables)?;
    let [rows, columns] = image.power_size;
    files::replace(&folder.join("spectral_params.bin"), bytemuck::bytes_of(&image.params))?;
    write_levels(folder, "spectral_tables", &image.tables)?;
    write_levels(folder, "spectral_cross_terms", &image.cross)?;
    files::replace(&folder.join("spectral_lobe.r32f"), bytemuck::cast_slice(&image.power))?;
    let index = json!({
        "params": { "binding": 0, "file": "spectral_params.bin", "kind": "uniform buffer" },
        "tables": { "binding": 1, "file": "spectral_tables.rgba16f", "kind": "2D array texture",
            "format": "RGBA16F", "width_height_layers": layers(&image.tables), "filter": "linear",
            "wrap": "clamp to edge", "coarser": coarser("spectral_tables", &image.tables) },
        "cross_terms": { "binding": 2, "file": "spectral_cross_terms.rgba16f", "kind": "2D array texture",
            "format": "RGBA16F", "width_height_layers": layers(&image.cross), "filter": "linear",
            "wrap": "clamp to edge", "coarser": coarser("spectral_cross_terms", &image.cross) },
        "lobe": { "binding": 3, "file": "spectral_lobe.r32f", "kind": "2D texture", "format": "R32F",
            "width_height_layers": [columns, rows, 1], "filter": "none: texels are fetched" },
        "material": {
            "shortest_nm": tables.shortest_nm,
            "depends_on_wavelength": tables.dispersion.as_ref().map(|dispersion| dispersion.name()),
        },
    });
    json::write(&folder.join(SPECTRAL_INDEX), &index)
}

/// Width, height and layers of a texture.
fn layers(layers: &HalfLayers) -> serde_json::Value {
    let [rows, columns] = layers.size;
    json!([columns, rows, layers.texels.len() / (rows * columns)])
}

/// Name of the file with the levels below a texture's finest one.
fn coarser_name(name: &str) -> String {
    format!("{name}.coarser.rgba16f")
}

/// Writes the finest level of a texture, and those below it into a file of their own where there are any.
fn write_levels(folder: &Path, name: &str, layers: &HalfLayers) -> Result<()> {
    files::replace(&folder.join(format!("{name}.rgba16f")), bytemuck::cast_slice(&layers.texels))?;
    if layers.coarser.is_empty() {
        return Ok(());
    }
    let texels: Vec<_> = layers.coarser.iter().flat_map(|level| level.texels.iter().copied()).collect();
    files::replace(&folder.join(coarser_name(name)), bytemuck::cast_slice(&texels))
}

/// Where the coarser levels are, and their widths and heights in the file's order; null where there are none.
fn coarser(name: &str, layers: &HalfLayers) -> serde_json::Value {
    if layers.coarser.is_empty() {
        return serde_json::Value::Null;
    }
    let sizes: Vec<[usize; 2]> = layers.coarser.iter().map(|level| [level.size[1], level.size[0]]).collect();
    json!({ "file": coarser_name(name), "width_height": sizes })
}
