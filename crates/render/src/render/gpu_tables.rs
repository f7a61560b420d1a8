//! Tables on the GPU, and shading the CPU's own samples with them.

use ndarray::Array3;

use super::gpu::Gpu;
use super::gpu_layout::{CHUNK_SAMPLES_MAX, Chunk, RUN_SAMPLES_MAX, Run, ShadingSample, chunks, packed_samples};
use super::wgsl;
use crate::error::Result;
use crate::scene::samples::ShadingSamples;
use diffraction_brdf::shader::{GAUSSIANS, HalfLayers, TableImage};

/// A table set in the GPU's memory.
#[derive(Debug)]
pub struct GpuTables {
    pub(super) layout: wgpu::BindGroupLayout,
    pub(super) group: wgpu::BindGroup,
    /// Tables fetched for every evaluation.
    pub(super) table_count: usize,
}

/// Uploads a table set.
///
/// # Errors
/// `Error::Gpu`, out of memory above all.
pub fn upload(gpu: &Gpu, image: &TableImage) -> Result<GpuTables> {
    gpu.guarded("upload the tables", || upload_with(gpu, image, &[]))
}

/// A table set with textures that are bound after the lobe's Gaussians.
pub(super) fn upload_with(gpu: &Gpu, image: &TableImage, more: &[wgpu::Texture]) -> GpuTables {
    let tables = half_texture(gpu, &image.tables);
    let cross = half_texture(gpu, &image.cross);
    let [rows, columns] = image.coherent_size;
    let coherent = texture(gpu, wgpu::TextureFormat::Rgba32Float, [columns, rows, 1]);
    write_layer(gpu, &coherent, [columns, rows], 0, bytemuck::cast_slice(&image.coherent));
    let rows = image.gaussians.len() / GAUSSIANS;
    let gaussians = texture(gpu, wgpu::TextureFormat::Rgba32Float, [GAUSSIANS, rows, 1]);
    write_layer(gpu, &gaussians, [GAUSSIANS, rows], 0, bytemuck::cast_slice(&image.gaussians));
    let more: Vec<&wgpu::Texture> = std::iter::once(&gaussians).chain(more).collect();
    let layout = table_layout(gpu, more.len());
    let params = uniform(gpu, bytemuck::bytes_of(&image.params));
    let group = bind_tables(gpu, &layout, &params, &[tables, cross, coherent], &more);
    GpuTables { layout, group, table_count: image.tables.scales.len() }
}

/// A uniform buffer with these bytes.
pub(super) fn uniform(gpu: &Gpu, bytes: &[u8]) -> wgpu::Buffer {
    let params = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("table params"),
        size: bytes.len() as u64,
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    gpu.queue.write_buffer(&params, 0, bytes);
    params
}

/// Group 0 of a table shader: uniform, tables, cross terms and lobe; then what only some have, the lobe's Gaussians and what samples are
/// drawn by.
pub(super) fn bind_tables(
    gpu: &Gpu,
    layout: &wgpu::BindGroupLayout,
    params: &wgpu::Buffer,
    [tables, cross, lobe]: &[wgpu::Texture; 3],
    more: &[&wgpu::Texture],
) -> wgpu::BindGroup {
    let sampler = gpu.device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("bilinear"),
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        ..Default::default()
    });
    let layers =
        wgpu::TextureViewDescriptor { dimension: Some(wgpu::TextureViewDimension::D2Array), ..Default::default() };
    let views = [tables.create_view(&layers), cross.create_view(&layers), lobe.create_view(&Default::default())];
    let more: Vec<_> = more.iter().map(|texture| texture.create_view(&Default::default())).collect();
    let mut entries = vec![entry(0, params.as_entire_binding())];
    entries.extend((1..).zip(&views).map(|(binding, view)| entry(binding, wgpu::BindingResource::TextureView(view))));
    entries.push(entry(4, wgpu::BindingResource::Sampler(&sampler)));
    entries.extend((5..).zip(&more).map(|(binding, view)| entry(binding, wgpu::BindingResource::TextureView(view))));
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor { label: Some("tables"), layout, entries: &entries })
}

pub(super) fn entry(binding: u32, resource: wgpu::BindingResource<'_>) -> wgpu::BindGroupEntry<'_> {
    wgpu::BindGroupEntry { binding, resource }
}

/// Bindings of tables.wgsl and spectral.wgsl, for both kinds of pipeline; with so many textures more that are not filtered.
pub(super) fn table_layout(gpu: &Gpu, more: usize) -> wgpu::BindGroupLayout {
    let image = |filterable, view_dimension| wgpu::BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Float { filterable },
        view_dimension,
        multisampled: false,
    };
    let types = [
        wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        image(true, wgpu::TextureViewDimension::D2Array),
        image(true, wgpu::TextureViewDimension::D2Array),
        image(false, wgpu::TextureViewDimension::D2),
        wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
    ];
    let types = types.into_iter().chain(std::iter::repeat_n(image(false, wgpu::TextureViewDimension::D2), more));
    let visibility = wgpu::ShaderStages::COMPUTE | wgpu::ShaderStages::FRAGMENT;
    let entries: Vec<wgpu::BindGroupLayoutEntry> = (0u32..)
        .zip(types)
        .map(|(binding, ty)| wgpu::BindGroupLayoutEntry { binding, visibility, ty, count: None })
        .collect();
    gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some("tables"), entries: &entries })
}

pub(super) fn texture(gpu: &Gpu, format: wgpu::TextureFormat, size: [usize; 3]) -> wgpu::Texture {
    gpu.device.create_texture(&texture_descriptor(format, size))
}

/// A texture of `[width, height, layers]` with one level.
fn texture_descriptor(
    format: wgpu::TextureFormat,
    [width, height, layers]: [usize; 3],
) -> wgpu::TextureDescriptor<'static> {
    wgpu::TextureDescriptor {
        label: Some("texels"),
        size: wgpu::Extent3d { width: width as u32, height: height as u32, depth_or_array_layers: layers as u32 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    }
}

/// The texture of layers of halves with its mip chain.
pub(super) fn half_texture(gpu: &Gpu, layers: &HalfLayers) -> wgpu::Texture {
    let [rows, columns] = layers.size;
    let count = layers.texels.len() / (rows * columns);
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        mip_level_count: 1 + layers.coarser.len() as u32,
        ..texture_descriptor(wgpu::TextureFormat::Rgba16Float, [columns, rows, count])
    });
    let coarser = layers.coarser.iter().map(|level| (level.size, level.texels.as_slice()));
    for (level, ([rows, columns], texels)) in
        std::iter::once((layers.size, layers.texels.as_slice())).chain(coarser).enumerate()
    {
        for (layer, texels) in texels.chunks_exact(rows * columns).enumerate() {
            write_level(gpu, &texture, [columns, rows], [layer, level], bytemuck::cast_slice(texels));
        }
    }
    texture
}

pub(super) fn write_layer(gpu: &Gpu, texture: &wgpu::Texture, size: [usize; 2], layer: usize, bytes: &[u8]) {
    write_level(gpu, texture, size, [layer, 0], bytes);
}

/// Writes a layer of a level.
fn write_level(
    gpu: &Gpu,
    texture: &wgpu::Texture,
    [width, height]: [usize; 2],
    [layer, level]: [usize; 2],
    bytes: &[u8],
) {
    let to = wgpu::TexelCopyTextureInfo {
        texture,
        mip_level: level as u32,
        origin: wgpu::Origin3d { x: 0, y: 0, z: layer as u32 },
        aspect: wgpu::TextureAspect::All,
    };
    let layout = wgpu::TexelCopyBufferLayout {
        offset: 0,
        bytes_per_row: Some((bytes.len() / height) as u32),
        rows_per_image: Some(height as u32),
    };
    let size = wgpu::Extent3d { width: width as u32, height: height as u32, depth_or_array_layers: 1 };
    gpu.queue.write_texture(to, bytes, layout, size);
}

/// XYZ image `[rows, columns, 3]` of gathered samples, as `render::cpu::shade` but with the GPU's tables. Runs of
/// samples are summed in 32-bit floats on the GPU, the runs of a pixel in 64 bits here.
///
/// # Errors
/// `Error::Gpu`.
pub fn shade(gpu: &Gpu, tables: &GpuTables, samples: &ShadingSamples) -> Result<Array3<f32>> {
    let mut sums = vec![[0.0f64; 3]; samples.rows * samples.columns];
    let parts = chunks(samples, RUN_SAMPLES_MAX, CHUNK_SAMPLES_MAX);
    let runs_max = parts.iter().map(|chunk| chunk.runs.len()).max().unwrap_or(0);
    if runs_max > 0 {
        let samples_max = parts.iter().map(|chunk| chunk.samples.len()).max().unwrap_or(0);
        let pass = gpu.guarded("prepare the check", || RunPass::new(gpu, tables, samples_max, runs_max))?;
        for chunk in &parts {
            let totals = pass.shade(gpu, tables, &packed_samples(samples, chunk), chunk)?;
            for (pixel, total) in chunk.pixels.iter().zip(totals) {
                for (sum, value) in sums[*pixel as usize].iter_mut().zip(total) {
                    *sum += f64::from(value);
                }
            }
        }
    }
    let shape = (samples.rows, samples.columns, 3);
    Ok(Array3::from_shape_fn(shape, |(row, column, c)| sums[row * samples.columns + column][c] as f32))
}

/// Pipeline and buffers that all chunks share.
struct RunPass {
    pipeline: wgpu::ComputePipeline,
    samples: wgpu::Buffer,
    runs: wgpu::Buffer,
    sums: wgpu::Buffer,
    readback: wgpu::Buffer,
}

/// Bytes of one run's sum: `vec4<f32>`.
const SUM_BYTES: u64 = 16;

impl RunPass {
    fn new(gpu: &Gpu, tables: &GpuTables, samples_max: usize, runs_max: usize) -> Self {
        let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("check"),
            source: wgpu::ShaderSource::Wgsl(wgsl::check().into()),
        });
        let group = run_layout(gpu);
        let layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("check"),
            bind_group_layouts: &[Some(&tables.layout), Some(&group)],
            immediate_size: 0,
        });
        let pipeline = gpu.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some("check"),
            layout: Some(&layout),
            module: &module,
            entry_point: Some(wgsl::SHADE_RUNS),
            compilation_options: Default::default(),
            cache: None,
        });
        let buffer = |label, bytes: u64, usage| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: bytes,
                usage,
                mapped_at_creation: false,
            })
        };
        let upload = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST;
        let sums_bytes = runs_max as u64 * SUM_BYTES;
        Self {
            pipeline,
            samples: buffer("samples", (samples_max * size_of::<ShadingSample>()) as u64, upload),
            runs: buffer("runs", (runs_max * size_of::<Run>()) as u64, upload),
            sums: buffer("sums", sums_bytes, wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC),
            readback: buffer("sums read", sums_bytes, wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ),
        }
    }

    /// XYZ of each run of a chunk.
    fn shade(&self, gpu: &Gpu, tables: &GpuTables, packed: &[ShadingSample], chunk: &Chunk) -> Result<Vec<[f32; 3]>> {
        let sums_bytes = chunk.runs.len() as u64 * SUM_BYTES;
        gpu.guarded("shade samples", || {
            gpu.queue.write_buffer(&self.samples, 0, bytemuck::cast_slice(packed));
            gpu.queue.write_buffer(&self.runs, 0, bytemuck::cast_slice(&chunk.runs));
            // Bound to its exact length: the shader asks for it.
            let runs_bytes = wgpu::BufferSize::new(size_of_val(chunk.runs.as_slice()) as u64);
            let runs = wgpu::BufferBinding { buffer: &self.runs, offset: 0, size: runs_bytes };
            let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("runs"),
                layout: &self.pipeline.get_bind_group_layout(1),
                entries: &[
                    entry(0, self.samples.as_entire_binding()),
                    entry(1, wgpu::BindingResource::Buffer(runs)),
                    entry(2, self.sums.as_entire_binding()),
                ],
            });
            let mut encoder = gpu.device.create_command_encoder(&Default::default());
            let mut pass = encoder.begin_compute_pass(&Default::default());
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &tables.group, &[]);
            pass.set_bind_group(1, &group, &[]);
            pass.dispatch_workgroups(chunk.runs.len().div_ceil(64) as u32, 1, 1);
            drop(pass);
            encoder.copy_buffer_to_buffer(&self.sums, 0, &self.readback, 0, sums_bytes);
            gpu.queue.submit([encoder.finish()]);
        })?;
        let bytes = gpu.read(&self.readback, sums_bytes, "read shaded samples")?;
        let floats = bytes.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]]));
        let floats: Vec<f32> = floats.collect();
        // The fourth number counts samples without an answer in the tables: their sum is none, as on the CPU.
        let total = |sum: &[f32]| if sum[3] == 0.0 { [sum[0], sum[1], sum[2]] } else { [f32::NAN; 3] };
        Ok(floats.chunks_exact(4).map(total).collect())
    }
}

fn run_layout(gpu: &Gpu) -> wgpu::BindGroupLayout {
    let entries = [true, true, false].map(|read_only| wgpu::BindingType::Buffer {
        ty: wgpu::BufferBindingType::Storage { read_only },
        has_dynamic_offset: false,
        min_binding_size: None,
    });
    let visibility = wgpu::ShaderStages::COMPUTE;
    let entries: Vec<wgpu::BindGroupLayoutEntry> = (0u32..)
        .zip(entries)
        .map(|(binding, ty)| wgpu::BindGroupLayoutEntry { binding, visibility, ty, count: None })
        .collect();
    gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some("runs"), entries: &entries })
}
