//! A specimen's tables as the bytes that the exported shaders read: a uniform block and textures, ready to upload.

use std::path::Path;

use serde_json::{Value, json};

use diffraction_brdf::SpectralTables;
use diffraction_brdf::error::Result;
use diffraction_brdf::files;
use diffraction_brdf::json;
use diffraction_brdf::shader::{GAUSSIANS, HalfLayers, TableParams, promised_image};
use diffraction_brdf::shader_floats::{
    FloatLayers, float_layers, float_layers_of_spectral, promised_floats, promised_spectral_floats,
};
use diffraction_brdf::shader_sampling::ShaderSampler;
use diffraction_brdf::shader_spectral::{SpectralParams, promised_spectral_image};
use diffraction_build::optics::pigment::Surface;

/// Name of the file that describes the others.
pub(crate) const INDEX: &str = "textures.json";

/// The same for spectral tables.
const SPECTRAL_INDEX: &str = "spectral_textures.json";

/// Number format of tables and cross terms in textures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Texels {
    /// 16-bit floats with a scale for each table, which every GPU filters.
    Half,
    /// 32-bit floats, as exact as the tables; filtering them is an option of WebGPU and WebGL 2.
    Float,
}

impl Texels {
    /// Ending of the files.
    fn extension(self) -> &'static str {
        match self {
            Self::Half => "rgba16f",
            Self::Float => "rgba32f",
        }
    }

    /// Name of the format.
    fn format(self) -> &'static str {
        match self {
            Self::Half => "RGBA16F",
            Self::Float => "RGBA32F",
        }
    }
}

/// Writes `params.bin` (the block `TableParams`, 2128 bytes, little-endian), the texels of the textures row by row and
/// layer by layer without padding, those of coarser levels level by level in files of their own, and [`INDEX`] with their sizes and
/// formats.
///
/// # Errors
/// `Error::Limit` for tables that do not fit every GPU; the disk's.
pub(crate) fn write_shader_data(folder: &Path, surface: Surface, texels: Texels) -> Result<()> {
    files::create_folder(folder)?;
    let image = promised_image(surface.tables, surface.pigment.map(|pigment| pigment.xyz_per_sr))?;
    let [rows, columns] = image.coherent_size;
    let (params, tables, cross) = match texels {
        Texels::Half => (image.params, levels_of_halves(&image.tables), levels_of_halves(&image.cross)),
        Texels::Float => {
            let ones = [[1.0; 4]; _];
            let params = TableParams { table_scales: ones, cross_scales: ones, ..image.params };
            let patches = surface.tables.lobe.as_ref().map_or(&[][..], |lobe| &lobe.cross);
            (params, levels_of_floats(&promised_floats(surface.tables)), levels_of_floats(&float_layers(patches)))
        }
    };
    files::replace(&folder.join("params.bin"), bytemuck::bytes_of(&params))?;
    files::replace(&folder.join("lobe.rgba32f"), bytemuck::cast_slice(&image.coherent))?;
    files::replace(&folder.join("lobe_gaussians.rgba32f"), bytemuck::cast_slice(&image.gaussians))?;
    let sampling = ShaderSampler::new(surface.tables).image();
    files::replace(&folder.join("sampling.r32f"), bytemuck::cast_slice(&sampling.texels))?;
    let index = json!({
        "params": { "binding": 0, "file": "params.bin", "kind": "uniform buffer" },
        "tables": write_levels(folder, "tables", 1, texels, &tables)?,
        "cross_terms": write_levels(folder, "cross_terms", 2, texels, &cross)?,
        "lobe": { "binding": 3, "file": "lobe.rgba32f", "kind": "2D texture", "format": "RGBA32F",
            "width_height_layers": [columns, rows, 1], "filter": "none: texels are fetched" },
        "lobe_gaussians": { "binding": 5, "file": "lobe_gaussians.rgba32f", "kind": "2D texture", "format": "RGBA32F",
            "width_height_layers": [GAUSSIANS, rows, 1], "filter": "none: texels are fetched" },
        "sampling": { "binding": 6, "file": "sampling.r32f", "kind": "2D texture", "format": "R32F",
            "width_height_layers": [sampling.size[1], sampling.size[0], 1], "filter": "none: texels are fetched" },
    });
    json::write(&folder.join(INDEX), &index)
}

/// Writes `spectral_params.bin` (the block `SpectralParams`, 2112 bytes, little-endian), the texels of the three textures, and
/// their sizes and formats.
///
/// # Errors
/// `Error::Limit` for tables that do not fit every GPU; the disk's.
pub(crate) fn write_spectral_data(folder: &Path, tables: &SpectralTables, texels: Texels) -> Result<()> {
    let image = promised_spectral_image(tables)?;
    let [rows, columns] = image.power_size;
    let (params, layers, cross) = match texels {
        Texels::Half => (image.params, levels_of_halves(&image.tables), levels_of_halves(&image.cross)),
        Texels::Float => {
            let ones = [[1.0; 4]; _];
            let params = SpectralParams { table_scales: ones, cross_scales: ones, ..image.params };
            let patches = tables.lobe.as_ref().and_then(|lobe| lobe.cross.as_ref());
            let (images, count) = patches.map_or((&[][..], 0), |patches| (&patches.images, patches.count));
            let layers = promised_spectral_floats(tables);
            (params, levels_of_floats(&layers), levels_of_floats(&float_layers_of_spectral(images, count)))
        }
    };
    files::replace(&folder.join("spectral_params.bin"), bytemuck::bytes_of(&params))?;
    files::replace(&folder.join("spectral_lobe.r32f"), bytemuck::cast_slice(&image.power))?;
    let index = json!({
        "params": { "binding": 0, "file": "spectral_params.bin", "kind": "uniform buffer" },
        "tables": write_levels(folder, "spectral_tables", 1, texels, &layers)?,
        "cross_terms": write_levels(folder, "spectral_cross_terms", 2, texels, &cross)?,
        "lobe": { "binding": 3, "file": "spectral_lobe.r32f", "kind": "2D texture", "format": "R32F",
            "width_height_layers": [columns, rows, 1], "filter": "none: texels are fetched" },
        "material": {
            "shortest_nm": tables.shortest_nm,
            "depends_on_wavelength": tables.dispersion.as_ref().map(|dispersion| dispersion.name()),
        },
    });
    json::write(&folder.join(SPECTRAL_INDEX), &index)
}

/// A level of a texture: rows and columns, and the bytes of all layers.
struct Level {
    size: [usize; 2],
    bytes: Vec<u8>,
}

impl Level {
    fn new<T: bytemuck::NoUninit>(size: [usize; 2], texels: &[T]) -> Self {
        Self { size, bytes: bytemuck::cast_slice(texels).to_vec() }
    }
}

/// From the finest to the coarsest.
fn levels_of_halves(layers: &HalfLayers) -> Vec<Level> {
    let coarser = layers.coarser.iter().map(|level| Level::new(level.size, &level.texels));
    std::iter::once(Level::new(layers.size, &layers.texels)).chain(coarser).collect()
}

fn levels_of_floats(layers: &FloatLayers) -> Vec<Level> {
    layers.levels.iter().map(|level| Level::new(level.size, &level.texels)).collect()
}

/// Writes the finest level of a texture, and those below it into a file of their own where there are any; what the index says of it.
fn write_levels(folder: &Path, name: &str, binding: u32, texels: Texels, levels: &[Level]) -> Result<Value> {
    let (finest, coarser) = (&levels[0], &levels[1..]);
    let file = format!("{name}.{}", texels.extension());
    files::replace(&folder.join(&file), &finest.bytes)?;
    let [rows, columns] = finest.size;
    let texel_bytes = if texels == Texels::Half { 8 } else { 16 };
    let layers = finest.bytes.len() / (texel_bytes * rows * columns);
    let mut below = Value::Null;
    if !coarser.is_empty() {
        let file = format!("{name}.coarser.{}", texels.extension());
        let bytes: Vec<u8> = coarser.iter().flat_map(|level| level.bytes.iter().copied()).collect();
        files::replace(&folder.join(&file), &bytes)?;
        let sizes: Vec<[usize; 2]> = coarser.iter().map(|level| [level.size[1], level.size[0]]).collect();
        below = json!({ "file": file, "width_height": sizes });
    }
    Ok(json!({ "binding": binding, "file": file, "kind": "2D array texture", "format": texels.format(),
        "width_height_layers": [columns, rows, layers], "filter": "linear", "wrap": "clamp to edge", "coarser": below }))
}
