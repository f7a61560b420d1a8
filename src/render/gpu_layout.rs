//! Table sets and samples in the byte layouts that the shaders read.

use bytemuck::{Pod, Zeroable};
use half::f16;
use ndarray::{Array3, ArrayView1};

use crate::ground::error::{Error, Result};
use crate::optics::config::Material;
use crate::scene::samples::ShadingSamples;
use crate::tables::model::{Basis, Served, TableSet};
use crate::tables::storage::half_scale;

/// Most layers of a texture: WebGPU's default limit, and the length of the shader's list of scales.
pub const LAYERS_MAX: usize = 256;
/// Largest side of a texture: WebGPU's default limit.
pub const SIDE_MAX: usize = 8192;
/// Most samples that one invocation sums in 32-bit floats; the sums of these are added in 64 bits.
pub const RUN_SAMPLES_MAX: usize = 64;
/// Most samples uploaded at once: 8 MiB, and a dispatch short enough for any driver's watchdog.
pub const CHUNK_SAMPLES_MAX: usize = 1 << 18;

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
    /// 1 where the tables serve certain scenes alone.
    pub served: u32,
    /// Texels along u and v of the whole grid, less one.
    pub grid_last: f32,
    /// Where in the whole grid the tables' window begins.
    pub first_column: f32,
    /// Likewise.
    pub first_row: f32,
    /// XYZ of the pigment below in 1/sr, and 1 where there is one.
    pub pigment: [f32; 4],
    /// Scale of each table, four to a vector.
    pub table_scales: [[f32; 4]; LAYERS_MAX / 4],
    /// Scale of each patch.
    pub cross_scales: [[f32; 4]; LAYERS_MAX / 4],
}

/// `ShadingSample` of check.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct ShadingSample {
    /// To the light.
    pub wi: [f32; 3],
    /// Factor on the BRDF.
    pub weight: f32,
    /// To the viewer.
    pub wo: [f32; 3],
    /// Fills the stride of 32 bytes.
    pub unused: f32,
}

/// `Run` of check.wgsl: neighbouring samples of one pixel.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Pod, Zeroable)]
pub struct Run {
    /// First sample, counted from the chunk's start.
    pub first: u32,
    /// Number of samples.
    pub count: u32,
}

/// `FrameParams` of frame.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct FrameParams {
    /// Pixels along each side.
    pub size_px: u32,
    /// Entries of the list of lights.
    pub light_count: u32,
    /// Words that hold a pixel's shadows.
    pub lit_words: u32,
    /// Factor that brings XYZ to display values.
    pub exposure: f32,
}

/// `FrameLight` of frame.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct FrameLight {
    /// Unit vector in the world.
    pub direction: [f32; 3],
    /// Irradiance on a surface that faces it.
    pub irradiance: f32,
    /// Layer of the surfaces that it is shaded on.
    pub layer: u32,
    /// Fills the stride of 32 bytes.
    pub unused: [u32; 3],
}

/// Layers of half floats, `[layer][row][column]`, the fourth channel unused.
#[derive(Debug, Clone, PartialEq)]
pub struct HalfLayers {
    /// Number of rows and columns.
    pub size: [usize; 2],
    /// All layers' texels; the range of what is served, where there is one, comes behind the tables.
    pub texels: Vec<[f16; 4]>,
    /// Value = texel times scale; one per layer.
    pub scales: Vec<f32>,
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
}

/// Largest magnitude of a table.
pub fn peak(table: &Array3<f32>) -> f32 {
    table.iter().fold(0.0, |peak, value| value.abs().max(peak))
}

/// Converts a table set for upload.
///
/// # Errors
/// `Error::Limit` for more layers or larger tables than every GPU takes, or if a number is not finite.
pub fn table_image(set: &TableSet) -> Result<TableImage> {
    let (material, index) = match set.optics.material {
        Material::Ideal => (0, [1.0, 0.0]),
        Material::Dielectric { n } => (1, [n, 0.0]),
        Material::Conductor { n, k } => (2, [n, k]),
    };
    let mut tables = half_layers(&set.tables, "tables", usize::from(set.served.is_some()))?;
    let first = set.served.as_ref().map_or([0; 2], |served| served.first);
    if let Some(Served { range, .. }) = &set.served {
        check_finite(range, "ranges")?;
        // Half floats already, read as they are.
        let texel = |range: ArrayView1<f32>| [range[0], range[1], range[2], 0.0].map(f16::from_f32);
        tables.texels.extend(range.rows().into_iter().map(texel));
    }
    let (cross, coherent_size, coherent, radius_max, cross_count) = match &set.lobe {
        None => (black_layer(), [1, 1], vec![[0.0; 4]], 0.0, 0),
        Some(lobe) => {
            let cross = if lobe.cross.is_empty() { black_layer() } else { half_layers(&lobe.cross, "cross terms", 0)? };
            let (rows, columns, _) = lobe.coherent.dim();
            check_side(rows.max(columns), "the coherent lobe")?;
            check_finite(&lobe.coherent, "the coherent lobe")?;
            let texels = lobe.coherent.rows().into_iter().map(|xyz| [xyz[0], xyz[1], xyz[2], 0.0]).collect();
            (cross, [rows, columns], texels, lobe.radius_max as f32, lobe.cross.len() as u32)
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
        shadowing: u32::from(set.optics.shadowing),
        radius_max,
        index_n: index[0] as f32,
        index_k: index[1] as f32,
        served: u32::from(set.served.is_some()),
        grid_last: (set.size() - 1) as f32,
        first_column: first[1] as f32,
        first_row: first[0] as f32,
        pigment: set.pigment.map_or([0.0; 4], |pigment| {
            let [x, y, z] = pigment.xyz_per_sr.map(|c| c as f32);
            [x, y, z, 1.0]
        }),
        table_scales: packed(&tables.scales),
        cross_scales: packed(&cross.scales),
    };
    Ok(TableImage { params, tables, cross, coherent_size, coherent })
}

fn packed(scales: &[f32]) -> [[f32; 4]; LAYERS_MAX / 4] {
    let mut out = [[0.0; 4]; LAYERS_MAX / 4];
    for (n, scale) in scales.iter().enumerate() {
        out[n / 4][n % 4] = *scale;
    }
    out
}

fn black_layer() -> HalfLayers {
    HalfLayers { size: [1, 1], texels: vec![[f16::ZERO; 4]], scales: vec![1.0] }
}

/// `spare` layers more will follow.
fn half_layers(layers: &[Array3<f32>], what: &str, spare: usize) -> Result<HalfLayers> {
    let (rows, columns, _) = layers.first().map_or((0, 0, 3), Array3::dim);
    check_side(rows.max(columns), what)?;
    if layers.is_empty() || layers.len() + spare > LAYERS_MAX {
        return Err(Error::limit(
            format!("{} {what} for a texture of 1 to {} layers", layers.len(), LAYERS_MAX - spare),
            "Raise tables.tolerance or lower tables.count, and make the tables anew.",
        ));
    }
    let texels = Vec::with_capacity((layers.len() + spare) * rows * columns);
    let mut out = HalfLayers { size: [rows, columns], texels, scales: Vec::new() };
    for layer in layers {
        if layer.dim() != (rows, columns, 3) {
            return Err(Error::limit(
                format!("{what} of the shapes {:?} and {:?} in one set", (rows, columns, 3), layer.dim()),
                "All must have one size and three channels: build the specimen again.",
            ));
        }
        check_finite(layer, what)?;
        let scale = half_scale(peak(layer));
        let half = |value: f32| f16::from_f32(value / scale);
        out.texels.extend(layer.rows().into_iter().map(|xyz| [half(xyz[0]), half(xyz[1]), half(xyz[2]), f16::ZERO]));
        out.scales.push(scale);
    }
    Ok(out)
}

fn check_side(side: usize, what: &str) -> Result<()> {
    if side == 0 || side > SIDE_MAX {
        return Err(Error::limit(
            format!("{what} of {side} texels a side for textures of 1 to {SIDE_MAX}"),
            "Lower tables.size, and make the tables anew.",
        ));
    }
    Ok(())
}

fn check_finite(values: &Array3<f32>, what: &str) -> Result<()> {
    if values.iter().all(|value| value.is_finite()) {
        return Ok(());
    }
    Err(Error::limit(
        format!("{what} hold a number that is not finite"),
        "Build the specimen again; with basis = \"taylor\", lower the heights or use \"chebyshev\".",
    ))
}

/// Part of the samples that is shaded by one dispatch.
#[derive(Debug, Clone, PartialEq)]
pub struct Chunk {
    /// First sample and one past the last.
    pub samples: std::ops::Range<usize>,
    /// The runs, in order.
    pub runs: Vec<Run>,
    /// The pixel of each run: `row * columns + column`.
    pub pixels: Vec<u32>,
}

/// Cuts samples into runs of at most `run_max` within a pixel and chunks of at most `chunk_max >= run_max`.
pub fn chunks(samples: &ShadingSamples, run_max: usize, chunk_max: usize) -> Vec<Chunk> {
    let mut out: Vec<Chunk> = Vec::new();
    let pixels = samples.first.windows(2).enumerate();
    for (pixel, range) in pixels {
        let (mut first, end) = (range[0] as usize, range[1] as usize);
        while first < end {
            let count = (end - first).min(run_max);
            if out.last().is_none_or(|chunk| first + count - chunk.samples.start > chunk_max) {
                out.push(Chunk { samples: first..first, runs: Vec::new(), pixels: Vec::new() });
            }
            let last = out.len() - 1;
            let chunk = &mut out[last];
            chunk.runs.push(Run { first: (first - chunk.samples.start) as u32, count: count as u32 });
            chunk.pixels.push(pixel as u32);
            first += count;
            chunk.samples.end = first;
        }
    }
    out
}

/// Samples of a chunk as the shader reads them.
pub fn packed_samples(samples: &ShadingSamples, chunk: &Chunk) -> Vec<ShadingSample> {
    let range = chunk.samples.clone();
    range
        .map(|i| ShadingSample { wi: samples.wi[i], weight: samples.weight[i], wo: samples.wo[i], unused: 0.0 })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn samples(counts: &[u32]) -> ShadingSamples {
        let mut first = vec![0];
        for count in counts {
            first.push(first[first.len() - 1] + count);
        }
        let total = first[counts.len()] as usize;
        ShadingSamples {
            rows: 1,
            columns: counts.len(),
            first,
            wi: (0..total).map(|i| [i as f32, 0.0, 1.0]).collect(),
            wo: vec![[0.0, 0.0, 1.0]; total],
            weight: vec![1.0; total],
        }
    }

    #[test]
    fn every_sample_lies_in_one_run_of_its_pixel() {
        let samples = samples(&[0, 3, 9, 1, 0, 4, 5]);
        for (run_max, chunk_max) in [(1, 1), (2, 5), (4, 4), (100, 100)] {
            let mut next = 0;
            for chunk in chunks(&samples, run_max, chunk_max) {
                assert_eq!(chunk.samples.start, next);
                assert!(chunk.samples.len() <= chunk_max);
                let packed = packed_samples(&samples, &chunk);
                for (run, pixel) in chunk.runs.iter().zip(&chunk.pixels) {
                    assert!(run.count as usize <= run_max);
                    assert_eq!(packed[run.first as usize].wi[0], next as f32);
                    let pixel = *pixel as usize;
                    assert!((samples.first[pixel] as usize) <= next);
                    next += run.count as usize;
                    assert!(next <= samples.first[pixel + 1] as usize);
                }
                assert_eq!(chunk.samples.end, next);
            }
            assert_eq!(next, 22);
        }
    }

    #[test]
    fn stored_halves_pass_unchanged() {
        // Numbers as they come from a stored half table: halves times the power of two.
        let scale = 2f32.powi(-9);
        let table = Array3::from_shape_fn((3, 3, 3), |(r, c, k)| {
            f16::from_f32(4001.0 / (1.0 + (r * 9 + c * 3 + k) as f32)).to_f32() * scale
        });
        assert_eq!(half_scale(peak(&table)), scale);
        let layers = half_layers(std::slice::from_ref(&table), "tables", 0).unwrap();
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
    fn what_no_gpu_takes_is_refused() {
        let layer = Array3::<f32>::zeros((1, 1, 3));
        assert!(half_layers(&vec![layer.clone(); 256], "tables", 0).is_ok());
        assert!(half_layers(&vec![layer.clone(); 257], "tables", 0).is_err());
        assert!(half_layers(&vec![layer.clone(); 256], "tables", 1).is_err());
        assert!(half_layers(&[], "tables", 0).is_err());
        assert!(half_layers(&[layer.clone(), Array3::zeros((2, 2, 3))], "tables", 0).is_err());
        assert!(half_layers(&[layer + f32::NAN], "tables", 0).is_err());
    }
}
