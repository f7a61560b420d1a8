//! The shader that evaluates tables, and table sets in the byte layout that it reads.
//!
//! Bindings of group 0 of [`TABLES_WGSL`]:
//!
//! | binding | variable | what |
//! |---|---|---|
//! | 0 | `params` | uniform buffer: [`TableParams`], 2128 bytes, below |
//! | 1 | `tables` | 2D array texture, RGBA16F, with a mip chain: [`TableImage::tables`]; where tables are restricted to scenes, one layer more and no chain |
//! | 2 | `cross_terms` | 2D array texture, RGBA16F, with a mip chain: [`TableImage::cross`] |
//! | 3 | `lobe` | 2D texture, RGBA32F, not filtered: [`TableImage::coherent`] |
//! | 4 | `bilinear` | sampler: linear within a level, clamped to the edges |
//! | 5 | `lobe_gaussians` | 2D texture, RGBA32F, not filtered: [`TableImage::gaussians`]; of [`TABLES_FILTERED_WGSL`] alone |
//!
//! Look-ups at a point read the finest level alone; `brdf_xyz_filtered` reads one level of the chain, never between two.
//!
//! The uniform, little-endian, by the rules of WGSL for uniform buffers (std140 gives the same):
//!
//! | offset in bytes | type | field | values |
//! |---|---|---|---|
//! | 0 | u32 | `basis` | 0 Chebyshev, 1 powers of w |
//! | 4 | u32 | `table_count` | layers of `tables`, without the range |
//! | 8 | u32 | `cross_count` | layers of `cross_terms`; 0 where there is no cross term |
//! | 12 | u32 | `material` | 0 ideal, 1 dielectric, 2 conductor |
//! | 16 | u32 | `shadowing` | 1 with the V-cavity factor |
//! | 20 | f32 | `radius_max` | of the coherent lobe; 0 without one |
//! | 24, 28 | f32 | `index_n`, `index_k` | refractive index n + ik |
//! | 32 | u32 | `restricted` | 1 where tables are restricted to scenes |
//! | 36 | f32 | `grid_last` | texels along u of the whole grid, less one |
//! | 40, 44 | f32 | `first_column`, `first_row` | where in the whole grid the tables begin |
//! | 48 | u32 | `factor` | 0 scalar, 1 vector |
//! | 52 | u32 | `look_up` | 0 linear; 1 splines, whose coefficients the finest level of `tables` holds |
//! | 56 | vec2 f32 | `permittivity` | `(n + ik)²` |
//! | 64 | vec4 f32 | `pigment` | X, Y, Z in 1/sr, and 1; zeros for the BRDF alone |
//! | 80 | 64 x vec4 f32 | `table_scales` | value = texel times scale, four layers to a vector |
//! | 1104 | 64 x vec4 f32 | `cross_scales` | likewise |

use bytemuck::{Pod, Zeroable};
use half::f16;
use ndarray::{Array3, ArrayView1, ArrayView3};

use crate::error::{Error, Result};
use crate::evaluate::Interpolation;
use crate::front_factor::Factor;
use crate::lobe_gaussians;
pub use crate::lobe_gaussians::GAUSSIANS;
use crate::material::Material;
use crate::mips;
use crate::splines::Splines;
use crate::storage::half_scale;
use crate::table_set::{Basis, Restriction, TableSet};

/// WGSL that evaluates tables; declares the bindings of group 0. Entry points are put behind it.
pub const TABLES_WGSL: &str = concat!(
    include_str!("shaders/optics.wgsl"),
    "\n",
    include_str!("shaders/tables.wgsl"),
    "\n",
    include_str!("shaders/splines.wgsl")
);

/// [`TABLES_WGSL`] with filtered look-ups: `brdf_xyz_filtered(wi, wo, footprint)` is the mean over a footprint, which
/// `footprint_of_light` and `footprint_of_normals` make, and which add. Has one binding more.
pub const TABLES_FILTERED_WGSL: &str = concat!(
    include_str!("shaders/optics.wgsl"),
    "\n",
    include_str!("shaders/tables.wgsl"),
    "\n",
    include_str!("shaders/splines.wgsl"),
    "\n",
    include_str!("shaders/filtered.wgsl"),
    "\n",
    include_str!("shaders/tables_filtered.wgsl")
);

/// Most layers of a texture: WebGPU's default limit, and the length of the shader's list of scales.
pub const LAYERS_MAX: usize = 256;
/// Largest side of a texture: WebGPU's default limit.
pub const SIDE_MAX: usize = 8192;
/// `TableParams` of tables.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct TableParams {
    /// 0 for `Basis::Chebyshev`, 1 for `Basis::Taylor`.
    pub basis: u32,
    /// Tables.
    pub table_count: u32,
    /// Patches of the cross term.
    pub cross_count: u32,
    /// 0 ideal, 1 dielectric, 2 conductor.
    pub material: u32,
    /// 1 with the V-cavity factor.
    pub shadowing: u32,
    /// Outer radius of the coherent lobe; 0 without one.
    pub radius_max: f32,
    /// Real part of the refractive index.
    pub index_n: f32,
    /// Imaginary part.
    pub index_k: f32,
    /// 1 where the tables are restricted to scenes.
    pub restricted: u32,
    /// Texels along u and v of the whole grid, less one.
    pub grid_last: f32,
    /// Where in the whole grid the tables' window begins.
    pub first_column: f32,
    /// Likewise.
    pub first_row: f32,
    /// 0 for the scalar factor, 1 for the vector one.
    pub factor: u32,
    /// 0 for linear look-ups, 1 for splines.
    pub look_up: u32,
    /// Permittivity `(n + ik)²`, real and imaginary part.
    pub permittivity: [f32; 2],
    /// XYZ of the pigment below in 1/sr, and 1 where there is one.
    pub pigment: [f32; 4],
    /// Scale of each table, four to a vector.
    pub table_scales: [[f32; 4]; LAYERS_MAX / 4],
    /// Scale of each patch.
    pub cross_scales: [[f32; 4]; LAYERS_MAX / 4],
}

/// Layers of half floats, `[layer][row][column]`, the fourth channel unused but by spectral tables, four to a layer.
#[derive(Debug, Clone, PartialEq)]
pub struct HalfLayers {
    /// Number of rows and columns.
    pub size: [usize; 2],
    /// All layers' texels; the range of what is covered, where there is one, comes behind the tables.
    pub texels: Vec<[f16; 4]>,
    /// Value = texel times scale on every level; one per layer, for spectral tables one per table.
    pub scales: Vec<f32>,
    /// The levels of the mip chain below, from the finer to the coarser; none where ranges are layers, which have no means.
    pub coarser: Vec<HalfLevel>,
}

/// A level of a mip chain, `[layer][row][column]` as the finest one.
#[derive(Debug, Clone, PartialEq)]
pub struct HalfLevel {
    /// Number of rows and columns: half of the finer level's, rounded down.
    pub size: [usize; 2],
    /// All layers' texels.
    pub texels: Vec<[f16; 4]>,
}

/// A table set as it is uploaded.
#[derive(Debug, Clone, PartialEq)]
pub struct TableImage {
    /// The uniform.
    pub params: TableParams,
    /// The tables.
    pub tables: HalfLayers,
    /// The patches of the cross term; one black texel where there are none.
    pub cross: HalfLayers,
    /// Rows (t) and columns (radius) of the coherent lobe.
    pub coherent_size: [usize; 2],
    /// The coherent lobe, row by row; one black texel where there is none.
    pub coherent: Vec<[f32; 4]>,
    /// Factors of the [`GAUSSIANS`] whose sum is the lobe's profile, row by row of it.
    pub gaussians: Vec<[f32; 4]>,
}

/// Largest magnitude of a table.
pub fn peak(table: &Array3<f32>) -> f32 {
    table.iter().fold(0.0, |peak, value| value.abs().max(peak))
}

/// Converts a table set for linear look-ups; `pigment_xyz_per_sr` is what pictures show below the structure, none for the BRDF alone.
///
/// # Errors
/// `Error::Limit` for more layers or larger tables than every GPU takes, or if a number is not finite.
pub fn table_image(set: &TableSet, pigment_xyz_per_sr: Option<[f64; 3]>) -> Result<TableImage> {
    image_of(set, pigment_xyz_per_sr, None)
}

/// [`table_image`] for the look-ups that such tables are promised for ([`TableSet::look_up`]): where these are splines, the finest level
/// holds their coefficients, of which the shader makes four linear fetches a table.
///
/// # Errors
/// As [`table_image`].
pub fn promised_image(set: &TableSet, pigment_xyz_per_sr: Option<[f64; 3]>) -> Result<TableImage> {
    let splines = (set.look_up() == Interpolation::Spline).then(|| Splines::new(&set.tables));
    image_of(set, pigment_xyz_per_sr, splines.as_ref())
}

fn image_of(set: &TableSet, pigment_xyz_per_sr: Option<[f64; 3]>, splines: Option<&Splines>) -> Result<TableImage> {
    let MaterialFields { material, index, permittivity } = material_fields(set.front_factor.material);
    let mut tables =
        half_layers(&set.tables, splines.map(Splines::coefficients), "tables", usize::from(set.restriction.is_some()))?;
    let first = set.restriction.as_ref().map_or([0; 2], |restriction| restriction.first);
    if let Some(Restriction { range, .. }) = &set.restriction {
        check_finite(range, "ranges")?;
        // Half floats already, read as they are.
        let texel = |range: ArrayView1<f32>| [range[0], range[1], range[2], 0.0].map(f16::from_f32);
        tables.texels.extend(range.rows().into_iter().map(texel));
    }
    let texels_of = |table: &Array3<f32>| -> Vec<[f32; 4]> {
        table.rows().into_iter().map(|xyz| [xyz[0], xyz[1], xyz[2], 0.0]).collect()
    };
    let mut gaussians = vec![[0.0; 4]; GAUSSIANS];
    let (cross, coherent_size, coherent, radius_max, cross_count) = match &set.lobe {
        None => (black_layer(), [1, 1], vec![[0.0; 4]], 0.0, 0),
        Some(lobe) => {
            let cross =
                if lobe.cross.is_empty() { black_layer() } else { half_layers(&lobe.cross, None, "cross terms", 0)? };
            let (rows, columns, _) = lobe.coherent.dim();
            check_side(rows.max(columns), "the coherent lobe")?;
            check_finite(&lobe.coherent, "the coherent lobe")?;
            gaussians = texels_of(&lobe_gaussians::factors(lobe));
            (cross, [rows, columns], texels_of(&lobe.coherent), lobe.radius_max as f32, lobe.cross.len() as u32)
        }
    };
    let params = TableParams {
        basis: match set.basis {
            Basis::Chebyshev => 0,
            Basis::Taylor => 1,
        },
        table_count: set.tables.len() as u32,
        cross_count,
        material,
        shadowing: u32::from(set.front_factor.shadowing),
        radius_max,
        index_n: index[0],
        index_k: index[1],
        restricted: u32::from(set.restriction.is_some()),
        grid_last: (set.size() - 1) as f32,
        first_column: first[1] as f32,
        first_row: first[0] as f32,
        factor: factor_field(set.front_factor.factor),
        look_up: u32::from(splines.is_some()),
        permittivity,
        pigment: pigment_xyz_per_sr.map_or([0.0; 4], |xyz_per_sr| {
            let [x, y, z] = xyz_per_sr.map(|c| c as f32);
            [x, y, z, 1.0]
        }),
        table_scales: packed(&tables.scales),
        cross_scales: packed(&cross.scales),
    };
    Ok(TableImage { params, tables, cross, coherent_size, coherent, gaussians })
}

/// What a uniform says of a material.
pub(crate) struct MaterialFields {
    /// 0 ideal, 1 dielectric, 2 conductor.
    pub(crate) material: u32,
    /// n and k.
    pub(crate) index: [f32; 2],
    /// Permittivity, real and imaginary part.
    pub(crate) permittivity: [f32; 2],
}

pub(crate) fn material_fields(material: Material) -> MaterialFields {
    let (material, [n, k]) = match material {
        Material::Ideal => (0, [1.0, 0.0]),
        // Thinner than air, its roots are complex: the conductor's formulas.
        Material::Dielectric { n } if n < 1.0 => (2, [n, 0.0]),
        Material::Dielectric { n } => (1, [n, 0.0]),
        Material::Conductor { n, k } => (2, [n, k]),
    };
    let permittivity = [n * n - k * k, 2.0 * n * k].map(|x| x as f32);
    MaterialFields { material, index: [n, k].map(|x| x as f32), permittivity }
}

pub(crate) fn factor_field(factor: Factor) -> u32 {
    match factor {
        Factor::Scalar => 0,
        Factor::Vector => 1,
    }
}

pub(crate) fn packed(scales: &[f32]) -> [[f32; 4]; LAYERS_MAX / 4] {
    let mut out = [[0.0; 4]; LAYERS_MAX / 4];
    for (n, scale) in scales.iter().enumerate() {
        out[n / 4][n % 4] = *scale;
    }
    out
}

pub(crate) fn black_layer() -> HalfLayers {
    HalfLayers { size: [1, 1], texels: vec![[f16::ZERO; 4]], scales: vec![1.0], coarser: Vec::new() }
}

/// Layers with their means on coarser levels; `coefficients` stand for them on the finest. `spare` layers more will follow.
fn half_layers(
    layers: &[Array3<f32>],
    coefficients: Option<&[Array3<f32>]>,
    what: &str,
    spare: usize,
) -> Result<HalfLayers> {
    let (rows, columns, _) = layers.first().map_or((0, 0, 3), Array3::dim);
    check_side(rows.max(columns), what)?;
    if layers.is_empty() || layers.len() + spare > LAYERS_MAX {
        return Err(Error::limit(
            format!("{} {what} for a texture of 1 to {} layers", layers.len(), LAYERS_MAX - spare),
            "Raise tables.tolerance or lower tables.count, and make the tables anew.",
        ));
    }
    let texels = Vec::with_capacity((layers.len() + spare) * rows * columns);
    let mut out = HalfLayers { size: [rows, columns], texels, scales: Vec::new(), coarser: Vec::new() };
    for (n, layer) in layers.iter().enumerate() {
        if layer.dim() != (rows, columns, 3) {
            return Err(Error::limit(
                format!("{what} of the shapes {:?} and {:?} in one set", (rows, columns, 3), layer.dim()),
                "All must have one size and three channels: build the specimen again.",
            ));
        }
        check_finite(layer, what)?;
        let finest = coefficients.map_or(layer, |coefficients| &coefficients[n]);
        let scale = half_scale(peak(layer).max(peak(finest)));
        let halves = |level: ArrayView3<f32>| -> Vec<[f16; 4]> {
            let half = |value: f32| f16::from_f32(value / scale);
            level.rows().into_iter().map(|xyz| [half(xyz[0]), half(xyz[1]), half(xyz[2]), f16::ZERO]).collect()
        };
        out.texels.extend(halves(finest.view()));
        out.scales.push(scale);
        if spare > 0 {
            continue;
        }
        for (index, level) in mips::coarser(layer.view()).iter().enumerate() {
            if n == 0 {
                let (rows, columns, _) = level.dim();
                out.coarser.push(HalfLevel { size: [rows, columns], texels: Vec::new() });
            }
            out.coarser[index].texels.extend(halves(level.view()));
        }
    }
    Ok(out)
}

pub(crate) fn check_side(side: usize, what: &str) -> Result<()> {
    if side == 0 || side > SIDE_MAX {
        return Err(Error::limit(
            format!("{what} of {side} texels a side for textures of 1 to {SIDE_MAX}"),
            "Lower tables.size, and make the tables anew.",
        ));
    }
    Ok(())
}

pub(crate) fn check_finite(values: &Array3<f32>, what: &str) -> Result<()> {
    if values.iter().all(|value| value.is_finite()) {
        return Ok(());
    }
    Err(Error::limit(
        format!("{what} hold a number that is not finite"),
        "Build the specimen again; with basis = \"taylor\", lower the heights or use \"chebyshev\".",
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stored_halves_pass_unchanged() {
        // Numbers as they come from a stored half table: halves times the power of two.
        let scale = 2f32.powi(-9);
        let table = Array3::from_shape_fn((3, 3, 3), |(r, c, k)| {
            f16::from_f32(4001.0 / (1.0 + (r * 9 + c * 3 + k) as f32)).to_f32() * scale
        });
        assert_eq!(half_scale(peak(&table)), scale);
        let layers = half_layers(std::slice::from_ref(&table), None, "tables", 0).unwrap();
        for (texel, value) in layers.texels.iter().zip(table.rows()) {
            for c in 0..3 {
                assert_eq!(texel[c].to_f32() * scale, value[c]);
            }
        }
        assert_eq!(half_scale(4096.0), 1.0);
        assert_eq!(half_scale(4097.0), 2.0);
        assert_eq!(half_scale(0.0), 1.0);
    }

    #[test]
    fn the_uniform_lies_as_its_table_says() {
        use std::mem::{offset_of, size_of};
        macro_rules! offsets {
            ($($field:ident)*) => { [$((stringify!($field), offset_of!(TableParams, $field))),*] };
        }
        let fields = offsets!(basis table_count cross_count material shadowing radius_max index_n index_k restricted grid_last
            first_column first_row factor look_up permittivity pigment table_scales cross_scales);
        let cells = |line: &'static str| Some(line.strip_prefix("//! | ")?.split(" | ").collect::<Vec<_>>());
        let rows = include_str!("shader.rs").lines().filter_map(cells).filter(|cells| cells.len() == 4);
        let stated = rows.skip(1).flat_map(|cells| {
            let names = cells[2].split(", ").map(|name| name.trim_matches('`'));
            names.zip(cells[0].split(", ").map(|offset| offset.parse().unwrap())).collect::<Vec<_>>()
        });
        assert_eq!(stated.collect::<Vec<_>>(), fields);
        assert_eq!(size_of::<TableParams>(), 2128);
    }

    #[test]
    fn what_no_gpu_takes_is_refused() {
        let layer = Array3::<f32>::zeros((1, 1, 3));
        assert!(half_layers(&vec![layer.clone(); 256], None, "tables", 0).is_ok());
        assert!(half_layers(&vec![layer.clone(); 257], None, "tables", 0).is_err());
        assert!(half_layers(&vec![layer.clone(); 256], None, "tables", 1).is_err());
        assert!(half_layers(&[], None, "tables", 0).is_err());
        assert!(half_layers(&[layer.clone(), Array3::zeros((2, 2, 3))], None, "tables", 0).is_err());
        assert!(half_layers(&[layer + f32::NAN], None, "tables", 0).is_err());
    }
}
