//! Spectral tables on the GPU, and their values for uploaded directions and wavelengths.

use bytemuck::{Pod, Zeroable};

use super::gpu::Gpu;
use super::gpu_tables::{bind_tables, entry, half_texture, table_layout, texture, uniform, write_layer};
use super::wgsl;
use crate::error::Result;
use diffraction_brdf::shader_spectral::SpectralImage;

/// Spectral tables in the GPU's memory.
#[derive(Debug)]
pub struct GpuSpectral {
    pub(super) layout: wgpu::BindGroupLayout,
    pub(super) group: wgpu::BindGroup,
}

/// `SpectralQuery` of spectral_check.wgsl: what a value is asked for.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct SpectralQuery {
    /// Unit vector to the light.
    pub wi: [f32; 3],
    /// Wavelength in nm.
    pub wavelength_nm: f32,
    /// Unit vector to the viewer.
    pub wo: [f32; 3],
    /// 1 where `index` stands in for the uniform's.
    pub own_index: u32,
    /// n and k at the wavelength.
    pub index: [f32; 2],
    /// Fills the structure to its alignment.
    pub unused: [u32; 2],
}

/// Uploads spectral tables.
///
/// # Errors
/// `Error::Gpu`, out of memory above all.
pub fn upload_spectral(gpu: &Gpu, image: &SpectralImage) -> Result<GpuSpectral> {
    gpu.guarded("upload the spectral tables", || {
        let [rows, columns] = image.power_size;
        let power = texture(gpu, wgpu::TextureFormat::R32Float, [columns, rows, 1]);
        write_layer(gpu, &power, [columns, rows], 0, bytemuck::cast_slice(&image.power));
        let layout = table_layout(gpu, 0);
        let textures = [half_texture(gpu, &image.tables), half_texture(gpu, &image.cross), power];
        let group = bind_tables(gpu, &layout, &uniform(gpu, bytemuck::bytes_of(&image.params)), &textures, &[]);
        GpuSpectral { layout, group }
    })
}

/// The BRDF in 1/sr for each query, as `SpectralTables::eval` with bilinear look-ups; not a number where the tables have no
/// answer.
///
/// # Errors
/// `Error::Gpu`.
pub fn eval_spectral(gpu: &Gpu, tables: &GpuSpectral, queries: &[SpectralQuery]) -> Result<Vec<f32>> {
    let source = (wgsl::spectral_check(), wgsl::EVAL_SPECTRAL);
    let floats = answers(gpu, (&tables.layout, &tables.group), source, queries, 1)?;
    Ok(floats.into_iter().map(|value| if value == NO_ANSWER { f32::NAN } else { value }).collect())
}

/// What the shader gives where the tables have no answer.
const NO_ANSWER: f32 = -1.0;

/// So many numbers for each query from a shader's entry point, which has the queries and the values in group 1.
pub(super) fn answers<Query: Pod>(
    gpu: &Gpu,
    (layout, group): (&wgpu::BindGroupLayout, &wgpu::BindGroup),
    (source, entry_point): (String, &str),
    queries: &[Query],
    numbers: usize,
) -> Result<Vec<f32>> {
    if queries.is_empty() {
        return Ok(Vec::new());
    }
    let bytes = size_of_val(queries) as u64;
    let values_bytes = (numbers * queries.len() * size_of::<f32>()) as u64;
    let readback = gpu.guarded("evaluate queries", || {
        let pipeline = pipeline(gpu, layout, source, entry_point);
        let buffer = |bytes, usage| {
            let descriptor = wgpu::BufferDescriptor { label: None, size: bytes, usage, mapped_at_creation: false };
            gpu.device.create_buffer(&descriptor)
        };
        let asked = buffer(bytes, wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST);
        let values = buffer(values_bytes, wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC);
        let readback = buffer(values_bytes, wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ);
        gpu.queue.write_buffer(&asked, 0, bytemuck::cast_slice(queries));
        let of_queries = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("queries"),
            layout: &pipeline.get_bind_group_layout(1),
            entries: &[entry(0, asked.as_entire_binding()), entry(1, values.as_entire_binding())],
        });
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, group, &[]);
        pass.set_bind_group(1, &of_queries, &[]);
        pass.dispatch_workgroups(queries.len().div_ceil(64) as u32, 1, 1);
        drop(pass);
        encoder.copy_buffer_to_buffer(&values, 0, &readback, 0, values_bytes);
        gpu.queue.submit([encoder.finish()]);
        readback
    })?;
    let bytes = gpu.read(&readback, values_bytes, "read values")?;
    Ok(bytes.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect())
}

fn pipeline(gpu: &Gpu, layout: &wgpu::BindGroupLayout, source: String, entry_point: &str) -> wgpu::ComputePipeline {
    let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(entry_point),
        source: wgpu::ShaderSource::Wgsl(source.into()),
    });
    let storage = |binding, read_only| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::COMPUTE,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Storage { read_only },
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    };
    let group = gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("queries"),
        entries: &[storage(0, true), storage(1, false)],
    });
    let layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some(entry_point),
        bind_group_layouts: &[Some(layout), Some(&group)],
        immediate_size: 0,
    });
    gpu.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some(entry_point),
        layout: Some(&layout),
        module: &module,
        entry_point: Some(entry_point),
        compilation_options: Default::default(),
        cache: None,
    })
}
