//! The shader that evaluates spectral tables, and these in the byte layout that it reads.
//!
//! Bindings of group 0 of [`SPECTRAL_WGSL`]; their kinds are those of the tables of XYZ:
//!
//! | binding | variable | what |
//! |---|---|---|
//! | 0 | `params` | uniform buffer: [`SpectralParams`], 2112 bytes, below |
//! | 1 | `tables` | 2D array texture, RGBA16F, with a mip chain: [`SpectralImage::tables`], four tables to a layer |
//! | 2 | `cross_terms` | 2D array texture, RGBA16F, with a mip chain: [`SpectralImage::cross`], likewise |
//! | 3 | `lobe` | 2D texture, R32F, not filtered: [`SpectralImage::power`] |
//! | 4 | `bilinear` | sampler: linear within a level, clamped to the edges |
//!
//! The uniform, little-endian, by the rules of WGSL for uniform buffers (std140 gives the same):
//!
//! | offset in bytes | type | field | values |
//! |---|---|---|---|
//! | 0 | u32 | `table_layers` | layers of `tables` |
//! | 4 | u32 | `cross_layers` | layers of `cross_terms`; 0 where there is no cross term |
//! | 8 | u32 | `lobe_count` | texels of `lobe`, row by row; 0 where tables contain the lobe |
//! | 12 | u32 | `material` | 0 ideal, 1 dielectric, 2 conductor |
//! | 16 | u32 | `factor` | 0 scalar, 1 vector |
//! | 20 | u32 | `shadowing` | 1 with the V-cavity factor |
//! | 24, 28 | f32 | `index_n`, `index_k` | refractive index n + ik at the wavelength that is asked for |
//! | 32 | vec2 f32 | `permittivity` | `(n + ik)²` |
//! | 40 | f32 | `shortest_nm` | wavelength of the tables |
//! | 44 | f32 | `lobe_sigma_nm` | coherence of the light at the shortest wavelength; 0 without a lobe |
//! | 48 | f32 | `cross_radius` | half the side of the patches; 0 without any |
//! | 52 | u32 | `of_source` | 1 where that coherence grows in proportion to the wavelength |
//! | 56 | u32 | `look_up` | 0 linear; 1 splines, whose coefficients the finest level of `tables` holds |
//! | 60 | u32 | `unused` | 0 |
//! | 64 | 64 x vec4 f32 | `table_scales` | value = texel times scale, a layer's four tables to a vector |
//! | 1088 | 64 x vec4 f32 | `cross_scales` | likewise |
//!
//! A material's index depends on the wavelength: it is looked up outside of the shader, by [`SpectralParams::at`] for a
//! uniform of each wavelength, or by [`Dispersion::index_at`](crate::Dispersion::index_at) for the shader's `front_of_index`.

use bytemuck::{Pod, Zeroable};
use half::f16;
use ndarray::{Array3, ArrayView3, Axis};

use crate::error::{Error, Result};
use crate::material::Material;
use crate::mips;
use crate::shader::{
    HalfLayers, HalfLevel, LAYERS_MAX, MaterialFields, black_layer, check_finite, check_side, factor_field,
    material_fields, packed,
};
use crate::spectral::{SpectralTables, TABLES_PER_IMAGE};
use crate::splines::Splines;
use crate::storage::half_scale;

/// WGSL that evaluates spectral tables: `brdf_spectral(wi, wo, wavelength_nm)`; declares the bindings of group 0. Entry points
/// are put behind it. It has names in common with [`TABLES_WGSL`](crate::shader::TABLES_WGSL), so a module takes one of them.
pub const SPECTRAL_WGSL: &str = concat!(
    include_str!("shaders/optics.wgsl"),
    "\n",
    include_str!("shaders/spectral.wgsl"),
    "\n",
    include_str!("shaders/splines.wgsl")
);

/// [`SPECTRAL_WGSL`] with filtered look-ups: `brdf_spectral_filtered(wi, wo, wavelength_nm, footprint)` is the mean over a
/// footprint, which `footprint_of_light` and `footprint_of_normals` make, and which add.
pub const SPECTRAL_FILTERED_WGSL: &str = concat!(
    include_str!("shaders/optics.wgsl"),
    "\n",
    include_str!("shaders/spectral.wgsl"),
    "\n",
    include_str!("shaders/splines.wgsl"),
    "\n",
    include_str!("shaders/filtered.wgsl"),
    "\n",
    include_str!("shaders/spectral_filtered.wgsl")
);

/// Tables in one layer of a texture: its channels.
pub const TABLES_PER_LAYER: usize = 4;
/// Most texels in a row of the lobe's power.
const LOBE_COLUMNS_MAX: usize = 4096;

/// `SpectralParams` of spectral.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct SpectralParams {
    /// Layers of tables.
    pub table_layers: u32,
    /// Layers of patches; 0 where there are none.
    pub cross_layers: u32,
    /// Values of the lobe's power; 0 without a lobe.
    pub lobe_count: u32,
    /// 0 ideal, 1 dielectric, 2 conductor.
    pub material: u32,
    /// 0 for the scalar factor, 1 for the vector one.
    pub factor: u32,
    /// 1 with the V-cavity factor.
    pub shadowing: u32,
    /// Real part of the refractive index.
    pub index_n: f32,
    /// Imaginary part.
    pub index_k: f32,
    /// Permittivity `(n + ik)²`, real and imaginary part.
    pub permittivity: [f32; 2],
    /// Shortest wavelength in nm.
    pub shortest_nm: f32,
    /// Standard deviation in nm of the light's coherence window at the shortest wavelength.
    pub lobe_sigma_nm: f32,
    /// Half the side of the patches in (u', v').
    pub cross_radius: f32,
    /// 1 where `lobe_sigma_nm` grows in proportion to the wavelength, as under a source of fixed size.
    pub of_source: u32,
    /// 0 for linear look-ups, 1 for splines.
    pub look_up: u32,
    /// Fills what follows to its alignment.
    pub unused: u32,
    /// Scale of each table, a layer's four to a vector.
    pub table_scales: [[f32; 4]; LAYERS_MAX / 4],
    /// Scale of each patch.
    pub cross_scales: [[f32; 4]; LAYERS_MAX / 4],
}

impl SpectralParams {
    /// The same with another material: that of the wavelength that is asked for.
    pub fn at(self, material: Material) -> Self {
        let MaterialFields { material, index: [index_n, index_k], permittivity } = material_fields(material);
        Self { material, index_n, index_k, permittivity, ..self }
    }
}

/// Spectral tables as they are uploaded.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectralImage {
    /// The uniform, its index that of `shortest_nm` where the material has a dispersion.
    pub params: SpectralParams,
    /// The tables, four to a layer.
    pub tables: HalfLayers,
    /// The patches of the cross term; one black texel where there are none.
    pub cross: HalfLayers,
    /// Rows and columns of the lobe's power.
    pub power_size: [usize; 2],
    /// The lobe's power, row by row, zeros behind its end; one black texel where there is none.
    pub power: Vec<f32>,
}

/// Converts spectral tables for upload: four tables to a layer of halves, each table with a scale of its own.
///
/// # Errors
/// [`Error::Limit`] for more than 256 tables or larger ones than every GPU takes, for a lobe's power of more than 33 million
/// values, or if a number is not finite.
pub fn spectral_image(tables: &SpectralTables) -> Result<SpectralImage> {
    image_of(tables, None)
}

/// [`spectral_image`] for look-ups by splines, which `FORMAT.md` describes: the finest level holds their coefficients.
///
/// # Errors
/// As [`spectral_image`].
pub fn promised_spectral_image(tables: &SpectralTables) -> Result<SpectralImage> {
    image_of(tables, Some(&Splines::new(&tables.images)))
}

fn image_of(tables: &SpectralTables, splines: Option<&Splines>) -> Result<SpectralImage> {
    let coefficients = splines.map(Splines::coefficients);
    let images = four_to_a_layer(&tables.images, coefficients, tables.count, "spectral tables")?;
    let lobe = tables.lobe.as_ref();
    let cross = lobe.and_then(|lobe| lobe.cross.as_ref());
    let patches = match cross {
        None => black_layer(),
        Some(cross) => four_to_a_layer(&cross.images, None, cross.count, "patches of the spectral cross term")?,
    };
    let (power_size, power) = lobe.map_or(Ok(([1, 1], vec![0.0])), |lobe| rows_of_power(&lobe.power))?;
    let params = SpectralParams {
        table_layers: tables.count.div_ceil(TABLES_PER_LAYER) as u32,
        cross_layers: cross.map_or(0, |cross| cross.count.div_ceil(TABLES_PER_LAYER) as u32),
        lobe_count: lobe.map_or(0, |lobe| lobe.power.len() as u32),
        factor: factor_field(tables.front_factor.factor),
        shadowing: u32::from(tables.front_factor.shadowing),
        shortest_nm: tables.shortest_nm as f32,
        lobe_sigma_nm: lobe.map_or(0.0, |lobe| lobe.sigma_nm as f32),
        of_source: u32::from(lobe.is_some_and(|lobe| lobe.is_of_source)),
        cross_radius: cross.map_or(0.0, |cross| cross.radius_max as f32),
        look_up: u32::from(splines.is_some()),
        table_scales: packed(&images.scales),
        cross_scales: packed(&patches.scales),
        ..SpectralParams::zeroed()
    };
    let material = match &tables.dispersion {
        None => tables.front_factor.material,
        Some(dispersion) => dispersion.material_at(tables.shortest_nm).ok_or_else(|| {
            Error::Call(format!("the index of {} is not known at {} nm", dispersion.name(), tables.shortest_nm))
        })?,
    };
    Ok(SpectralImage { params: params.at(material), tables: images, cross: patches, power_size, power })
}

/// Repacks `count` tables of images with three to an image; `coefficients`, packed alike, stand for them on the finest level.
fn four_to_a_layer(
    images: &[Array3<f32>],
    coefficients: Option<&[Array3<f32>]>,
    count: usize,
    what: &str,
) -> Result<HalfLayers> {
    let (rows, columns, _) = images.first().map_or((0, 0, TABLES_PER_IMAGE), Array3::dim);
    check_side(rows.max(columns), what)?;
    if count == 0 || count > LAYERS_MAX {
        return Err(Error::limit(
            format!("{count} {what} for a shader of 1 to {LAYERS_MAX}"),
            "Raise tables.tolerance or lower tables.count, and make the tables anew.",
        ));
    }
    let whole = images.iter().all(|image| image.dim() == (rows, columns, TABLES_PER_IMAGE));
    if !whole || images.len() * TABLES_PER_IMAGE < count {
        return Err(Error::limit(
            format!("{count} {what} in {} images, or images that differ in shape", images.len()),
            "All must have one size and three channels: build the specimen again.",
        ));
    }
    for image in images {
        check_finite(image, what)?;
    }
    let layers = count.div_ceil(TABLES_PER_LAYER);
    let black = |[rows, columns]: [usize; 2]| vec![[f16::ZERO; 4]; layers * rows * columns];
    let mut out =
        HalfLayers { size: [rows, columns], texels: black([rows, columns]), scales: Vec::new(), coarser: Vec::new() };
    for n in 0..count {
        let [table, finest] = [images, coefficients.unwrap_or(images)]
            .map(|images| images[n / TABLES_PER_IMAGE].index_axis(Axis(2), n % TABLES_PER_IMAGE).insert_axis(Axis(2)));
        let scale = half_scale(table.iter().chain(finest).fold(0.0, |peak, value| value.abs().max(peak)));
        put(&mut out.texels, n, finest, scale);
        for (index, level) in mips::coarser(table).iter().enumerate() {
            if n == 0 {
                let (rows, columns, _) = level.dim();
                out.coarser.push(HalfLevel { size: [rows, columns], texels: black([rows, columns]) });
            }
            put(&mut out.coarser[index].texels, n, level.view(), scale);
        }
        out.scales.push(scale);
    }
    Ok(out)
}

/// Puts a table of one channel where it belongs among layers of four.
fn put(layers: &mut [[f16; 4]], n: usize, table: ArrayView3<f32>, scale: f32) {
    let layer = &mut layers[n / TABLES_PER_LAYER * table.len()..][..table.len()];
    for (texel, value) in layer.iter_mut().zip(table) {
        texel[n % TABLES_PER_LAYER] = f16::from_f32(value / scale);
    }
}

/// The lobe's power in rows that a texture takes.
fn rows_of_power(power: &[f32]) -> Result<([usize; 2], Vec<f32>)> {
    if power.len() < 2 || power.iter().any(|value| !value.is_finite()) {
        return Err(Error::limit(
            format!("a lobe's power of {} values, or some that are not finite", power.len()),
            "Build the specimen again.",
        ));
    }
    let columns = power.len().min(LOBE_COLUMNS_MAX);
    let rows = power.len().div_ceil(columns);
    check_side(rows, "the lobe's power")?;
    let mut texels = power.to_vec();
    texels.resize(rows * columns, 0.0);
    Ok(([rows, columns], texels))
}

#[cfg(test)]
#[path = "shader_spectral_tests.rs"]
mod tests;
