//! Filtered look-ups on the GPU, for uploaded directions, lights and normals.

use bytemuck::{Pod, Zeroable};
use ndarray::Array3;

use super::gpu::Gpu;
use super::gpu_spectral::{GpuSpectral, answers};
use super::gpu_tables::GpuTables;
use super::wgsl;
use crate::error::Result;
use crate::scene::filtered::FilteredSamples;
use crate::scene::samples::pixel_range;

/// `FilteredQuery` of filtered_check.wgsl: what a mean is asked for.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct FilteredQuery {
    /// Unit vector to the light.
    pub wi: [f32; 3],
    /// Wavelength in nm, for spectral tables.
    pub wavelength_nm: f32,
    /// Unit vector to the viewer.
    pub wo: [f32; 3],
    /// Angular radius of the light in radians.
    pub angular_radius: f32,
    /// Covariance `[aa, ab, bb]` of the normals' tilt over the pixel, in squared radians.
    pub normals: [f32; 3],
    /// Fills what follows to its alignment.
    pub unused: u32,
    /// Covariance `[uu, uv, vv]` that comes to the footprint besides.
    pub more: [f32; 3],
    /// Fills the structure to its alignment.
    pub unused_too: u32,
}

/// The mean of what the surface shows over each query's footprint, XYZ in 1/sr, as `Brdf::eval_filtered`; not a number where the
/// tables have no answer.
///
/// # Errors
/// `Error::Gpu`.
pub fn eval_filtered(gpu: &Gpu, tables: &GpuTables, queries: &[FilteredQuery]) -> Result<Vec<[f32; 3]>> {
    let source = (wgsl::filtered_check(), wgsl::EVAL_FILTERED);
    let floats = answers(gpu, (&tables.layout, &tables.group), source, queries, 4)?;
    Ok(floats.chunks_exact(4).map(|v| if v[3] == 1.0 { [v[0], v[1], v[2]] } else { [f32::NAN; 3] }).collect())
}

/// The same from spectral tables at each query's wavelength, with the uniform's refractive index.
///
/// # Errors
/// `Error::Gpu`.
pub fn eval_spectral_filtered(gpu: &Gpu, tables: &GpuSpectral, queries: &[FilteredQuery]) -> Result<Vec<f32>> {
    let source = (wgsl::filtered_spectral_check(), wgsl::EVAL_FILTERED);
    let floats = answers(gpu, (&tables.layout, &tables.group), source, queries, 4)?;
    Ok(floats.chunks_exact(4).map(|v| if v[3] == 1.0 { v[0] } else { f32::NAN }).collect())
}

/// XYZ image `[rows, columns, 3]` of samples that stand for pieces of lights and pixels: as `render::cpu::shade_filtered` with
/// the GPU's means. The samples of a pixel are added in 64 bits.
///
/// # Errors
/// `Error::Gpu`.
pub fn shade_filtered(gpu: &Gpu, tables: &GpuTables, filtered: &FilteredSamples) -> Result<Array3<f32>> {
    let samples = &filtered.samples;
    let mut values = Vec::with_capacity(filtered.footprints.len());
    let indices: Vec<usize> = (0..filtered.footprints.len()).collect();
    for part in indices.chunks(QUERIES_MAX) {
        let query = |&index: &usize| FilteredQuery {
            wi: samples.wi[index],
            wo: samples.wo[index],
            more: filtered.footprints[index].covariance().map(|c| c as f32),
            ..FilteredQuery::zeroed()
        };
        values.extend(eval_filtered(gpu, tables, &part.iter().map(query).collect::<Vec<_>>())?);
    }
    let shape = (samples.rows, samples.columns, 3);
    Ok(Array3::from_shape_fn(shape, |(row, column, c)| {
        let range = pixel_range(samples, row, column);
        range.map(|index| f64::from(samples.weight[index]) * f64::from(values[index][c])).sum::<f64>() as f32
    }))
}

/// Most queries of one dispatch: 5 MB, short enough for any driver's watchdog.
const QUERIES_MAX: usize = 1 << 16;
