//! A specimen's tables as the bytes that the exported shaders read: a uniform block and textures, ready to upload.

use std::path::Path;

use serde_json::{Value, json};

use super::ktx2::{Format, Level, ktx2};
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
    fn format(self) -> Format {
        match self {
            Self::Half => Format::Rgba16f,
            Self::Float => Format::Rgba32f,
        }
    }
}

/// What textures are written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Container {
    /// Texels alone, and coarser levels in files of their own.
    Raw,
    /// One KTX 2.0 file per texture, with its levels.
    Ktx2,
}

/// How textures are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct TextureConfig {
    /// Number format of tables and cross terms.
    pub(crate) texels: Texels,
    /// Of all textures.
    pub(crate) container: Container,
}

/// Writes `params.bin` (the block `TableParams`, 2128 bytes, little-endian), the texels of the textures row by row and
/// layer by layer without padding, those of coarser levels level by level in files of their own, or both in a container, and [`INDEX`]
/// with their sizes and formats.
///
/// # Errors
/// `Error::Limit` for tables that do not fit every GPU; the disk's.
pub(crate) fn write_shader_data(folder: &Path, surface: Surface, config: TextureConfig) -> Result<()> {
    files::create_folder(folder)?;
    let image = promised_image(surface.tables, surface.pigment.map(|pigment| pigment.xyz_per_sr))?;
    let [rows, columns] = image.coherent_size;
    let (params, tables, cross) = match config.texels {
        Texels::Half => (image.params, levels_of_halves(&image.tables), levels_of_halves(&image.cross)),
        Texels::Float => {
            let ones = [[1.0; 4]; _];
            let params = TableParams { table_scales: ones, cross_scales: ones, ..image.params };
            let patches = surface.tables.lobe.as_ref().map_or(&[][..], |lobe| &lobe.cross);
            (params, levels_of_floats(&promised_floats(surface.tables)), levels_of_floats(&float_layers(patches)))
        }
    };
    files::replace(&folder.join("params.bin"), bytemuck::bytes_of(&params))?;
    let sampling = ShaderSampler::new(surface.tables).image();
    let fetched =
        |name, binding, format, texels| write_fetched(folder, name, binding, format, config.container, texels);
    let gaussians = level_of([rows, GAUSSIANS], &image.gaussians);
    let index = json!({
        "params": { "binding": 0, "file": "params.bin", "kind": "uniform buffer" },
        "tables": write_layers(folder, "tables", 1, config, &tables)?,
        "cross_terms": write_layers(folder, "cross_terms", 2, config, &cross)?,
        "lobe": fetched("lobe", 3, Format::Rgba32f, level_of([rows, columns], &image.coherent))?,
        "lobe_gaussians": fetched("lobe_gaussians", 5, Format::Rgba32f, gaussians)?,
        "sampling": fetched("sampling", 6, Format::R32f, level_of(sampling.size, &sampling.texels))?,
    });
    json::write(&folder.join(INDEX), &index)
}

/// Writes `spectral_params.bin` (the block `SpectralParams`, 2112 bytes, little-endian), the texels of the three textures, and
/// their sizes and formats.
///
/// # Errors
/// `Error::Limit` for tables that do not fit every GPU; the disk's.
pub(crate) fn write_spectral_data(folder: &Path, tables: &SpectralTables, config: TextureConfig) -> Result<()> {
    let image = promised_spectral_image(tables)?;
    let [rows, columns] = image.power_size;
    let (params, layers, cross) = match config.texels {
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
    let power = level_of([rows, columns], &image.power);
    let index = json!({
        "params": { "binding": 0, "file": "spectral_params.bin", "kind": "uniform buffer" },
        "tables": write_layers(folder, "spectral_tables", 1, config, &layers)?,
        "cross_terms": write_layers(folder, "spectral_cross_terms", 2, config, &cross)?,
        "lobe": write_fetched(folder, "spectral_lobe", 3, Format::R32f, config.container, power)?,
        "material": {
            "shortest_nm": tables.shortest_nm,
            "depends_on_wavelength": tables.dispersion.as_ref().map(|dispersion| dispersion.name()),
        },
    });
    json::write(&folder.join(SPECTRAL_INDEX), &index)
}

fn level_of<T: bytemuck::NoUninit>(size: [usize; 2], texels: &[T]) -> Level {
    Level { size, bytes: bytemuck::cast_slice(texels).to_vec() }
}

/// From the finest to the coarsest.
fn levels_of_halves(layers: &HalfLayers) -> Vec<Level> {
    let coarser = layers.coarser.iter().map(|level| level_of(level.size, &level.texels));
    std::iter::once(level_of(layers.size, &layers.texels)).chain(coarser).collect()
}

fn levels_of_floats(layers: &FloatLayers) -> Vec<Level> {
    layers.levels.iter().map(|level| level_of(level.size, &level.texels)).collect()
}

/// Writes an array texture that is filtered; what the index says of it.
fn write_layers(folder: &Path, name: &str, binding: u32, config: TextureConfig, levels: &[Level]) -> Result<Value> {
    let format = config.texels.format();
    let [rows, columns] = levels[0].size;
    let layers = levels[0].bytes.len() / (format.texel_bytes() * rows * columns);
    let mut about = json!({ "binding": binding, "kind": "2D array texture", "format": format.name(),
        "width_height_layers": [columns, rows, layers], "filter": "linear", "wrap": "clamp to edge" });
    let files = write_levels(folder, name, (format, Some(layers)), config.container, levels)?;
    extend(&mut about, files);
    Ok(about)
}

/// Writes a plain texture whose texels are fetched; what the index says of it.
fn write_fetched(
    folder: &Path,
    name: &str,
    binding: u32,
    format: Format,
    container: Container,
    texels: Level,
) -> Result<Value> {
    let [rows, columns] = texels.size;
    let mut about = json!({ "binding": binding, "kind": "2D texture", "format": format.name(),
        "width_height_layers": [columns, rows, 1], "filter": "none: texels are fetched" });
    extend(&mut about, write_levels(folder, name, (format, None), container, &[texels])?);
    Ok(about)
}

fn extend(about: &mut Value, files: Value) {
    if let (Value::Object(about), Value::Object(files)) = (about, files) {
        about.extend(files);
    }
}

/// Writes the levels of a texture: in one container, or the finest and those below it in a file of their own where there are any; what the
/// index says of the files.
fn write_levels(
    folder: &Path,
    name: &str,
    (format, layers): (Format, Option<usize>),
    container: Container,
    levels: &[Level],
) -> Result<Value> {
    let coarser = &levels[1..];
    let sizes: Vec<[usize; 2]> = coarser.iter().map(|level| [level.size[1], level.size[0]]).collect();
    if container == Container::Ktx2 {
        let file = format!("{name}.ktx2");
        files::replace(&folder.join(&file), &ktx2(format, layers, levels))?;
        let below = if coarser.is_empty() { Value::Null } else { json!({ "file": file, "width_height": sizes }) };
        return Ok(json!({ "file": file, "container": "KTX 2.0", "coarser": below }));
    }
    let extension = format.name().to_lowercase();
    let file = format!("{name}.{extension}");
    files::replace(&folder.join(&file), &levels[0].bytes)?;
    let mut below = Value::Null;
    if !coarser.is_empty() {
        let file = format!("{name}.coarser.{extension}");
        let bytes: Vec<u8> = coarser.iter().flat_map(|level| level.bytes.iter().copied()).collect();
        files::replace(&folder.join(&file), &bytes)?;
        below = json!({ "file": file, "width_height": sizes });
    }
    Ok(json!({ "file": file, "coarser": below }))
}
