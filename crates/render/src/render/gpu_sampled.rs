//! Directions drawn on the GPU and their densities, for uploaded viewers.

use bytemuck::{Pod, Zeroable};

use super::gpu::Gpu;
use super::gpu_spectral::answers;
use super::gpu_tables::{GpuTables, texture, upload_with, write_layer};
use super::wgsl;
use crate::error::Result;
use diffraction_brdf::shader::TableImage;
use diffraction_brdf::shader_sampling::SamplingImage;

/// `SampledQuery` of sampled_check.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct SampledQuery {
    /// Unit vector to the viewer.
    pub wo: [f32; 3],
    /// Fills what follows to its alignment.
    pub unused: f32,
    /// Three random numbers in [0, 1), or the unit vector to the light.
    pub more: [f32; 3],
    /// Fills the structure to its alignment.
    pub unused_too: f32,
}

/// Uploads a table set with what samples of it are drawn by.
///
/// # Errors
/// `Error::Gpu`, out of memory above all.
pub fn upload_sampled(gpu: &Gpu, image: &TableImage, sampling: &SamplingImage) -> Result<GpuTables> {
    gpu.guarded("upload the tables and their sampling", || {
        let [rows, columns] = sampling.size;
        let numbers = texture(gpu, wgpu::TextureFormat::R32Float, [columns, rows, 1]);
        write_layer(gpu, &numbers, [columns, rows], 0, bytemuck::cast_slice(&sampling.texels));
        upload_with(gpu, image, &[numbers])
    })
}

/// For each viewer and its random numbers, the direction to the light that is drawn, and its density in 1/sr; zeros where none is.
///
/// # Errors
/// `Error::Gpu`.
pub fn draw_samples(gpu: &Gpu, tables: &GpuTables, queries: &[SampledQuery]) -> Result<Vec<[f32; 4]>> {
    let source = (wgsl::sampled_check(), wgsl::DRAW_SAMPLES);
    let floats = answers(gpu, (&tables.layout, &tables.group), source, queries, 4)?;
    Ok(floats.chunks_exact(4).map(|v| [v[0], v[1], v[2], v[3]]).collect())
}

/// Densities in 1/sr of the directions to the light, for each viewer.
///
/// # Errors
/// `Error::Gpu`.
pub fn eval_densities(gpu: &Gpu, tables: &GpuTables, queries: &[SampledQuery]) -> Result<Vec<f32>> {
    let source = (wgsl::sampled_check(), wgsl::EVAL_DENSITIES);
    let floats = answers(gpu, (&tables.layout, &tables.group), source, queries, 4)?;
    Ok(floats.chunks_exact(4).map(|v| v[0]).collect())
}
